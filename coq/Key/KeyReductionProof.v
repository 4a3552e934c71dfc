(** * From all placements to the enumerated ones, in every order of the cuts

    As in [ReductionProof]: a placement goes with its corners into the canonical
    frame, and its cuts, sorted by key, are one of the orders that were checked. *)

From Certet Require Import Key.Definitions.
From Certet Require Import Angles.Forms.Checker Angles.Forms.EdgeProof
  Angles.Forms.CheckerProof Angles.Cases.Configurations Angles.Cases.Isometry
  Angles.Cases.SymmetryProof Angles.Cases.ReductionProof
  Key.Orders Key.OrderProof Key.KeysApartProof Key.KeyConfigurations Key.RangedProof.
Open Scope Z_scope.

(** ** Half turns respect the stencils and the orders *)

Definition TurnPair (g : Turn) (x : Label * Label) : Label * Label :=
  (TurnLabel g (fst x), TurnLabel g (snd x)).

Fixpoint SameOrder (o o' : list (Label * Label)) : bool :=
  match o, o' with
  | [], [] => true
  | x :: r, y :: r' => if SamePair x y then SameOrder r r' else false
  | _, _ => false
  end.

Lemma SameOrderEqual o o' : SameOrder o o' = true -> o = o'.
Proof.
  revert o'. induction o as [|x r IH]; intros [|y r']; cbn [SameOrder];
    try discriminate; [reflexivity|].
  destruct (SamePair x y) eqn:S; [|discriminate].
  apply SamePairEqual in S. intros E. f_equal; auto.
Qed.

Lemma OrderedRepresentative signs : exists g,
  In (TurnQuad g signs) Representatives /\
  forall o, In o (Orders (CutsBetween signs)) ->
    In (map (TurnPair g) o) (Orders (CutsBetween (TurnQuad g signs))) /\
    forall t, In t (OrderedTets signs o) -> exists t',
      In t' (OrderedTets (TurnQuad g signs) (map (TurnPair g) o)) /\
      In (MapTet (TurnSymbol g) t) (EvenPermutations t').
Proof.
  assert (T : forallb (fun signs => existsb (fun g =>
    FirstOfOrbit (TurnQuad g signs) &&
    forallb (fun o =>
      existsb (SameOrder (map (TurnPair g) o))
        (Orders (CutsBetween (TurnQuad g signs))) &&
      forallb (fun t => TurnsInto g t
          (OrderedTets (TurnQuad g signs) (map (TurnPair g) o)))
        (OrderedTets signs o)) (Orders (CutsBetween signs))) AllTurns) AllSigns = true)
    by (vm_cast_no_check (eq_refl true)).
  rewrite forallb_forall in T. specialize (T signs (InAllSigns signs)).
  apply existsb_exists in T. destruct T as (g & _ & T).
  apply andb_prop in T. destruct T as [F T]. exists g. split.
  { apply filter_In. split; [apply InAllSigns | exact F]. }
  intros o O. rewrite forallb_forall in T. specialize (T o O).
  apply andb_prop in T. destruct T as [L T]. split.
  - apply existsb_exists in L. destruct L as (o' & L & E).
    apply SameOrderEqual in E. rewrite E. exact L.
  - intros t I. rewrite forallb_forall in T. specialize (T t I).
    apply existsb_exists in T. destruct T as (t' & I' & T).
    apply existsb_exists in T. destruct T as (t'' & I'' & T).
    apply TetEqualTrue in T. subst t''. exists t'. split; assumption.
Qed.

(** Cuts are those of the order, from + to -. *)
Definition IsCutOf (o : list (Label * Label)) (v : Symbol) : bool :=
  match v with CornerOf _ => true | CutOf a e => existsb (SamePair (a, e)) o end.

Lemma OrderedCuts signs o t : In o (Orders (CutsBetween signs)) ->
  In t (OrderedTets signs o) -> AllOfTet (IsCutOf o) t = true.
Proof.
  assert (T : forallb (fun signs => forallb (fun o =>
    forallb (AllOfTet (IsCutOf o)) (OrderedTets signs o))
      (Orders (CutsBetween signs))) AllSigns = true)
    by (vm_cast_no_check (eq_refl true)).
  rewrite forallb_forall in T. specialize (T signs (InAllSigns signs)).
  intros O. rewrite forallb_forall in T. specialize (T o O).
  rewrite forallb_forall in T. exact (T t).
Qed.

Lemma InCutsBetween signs a e : In (a, e) (CutsBetween signs) <->
  Of signs a = Plus /\ Of signs e = Minus.
Proof.
  unfold CutsBetween. rewrite filter_In, in_prod_iff. split.
  - intros [_ C]. destruct (Of signs a), (Of signs e); try discriminate C. auto.
  - intros [-> ->]. auto using InAllLabels.
Qed.

(** ** Sorted by key *)

Lemma KeyedAreOrdered signs (k : Label -> Label -> Z) :
  (forall a b m, a <> b -> a <> m -> b <> m -> k a m <> k b m /\ k m a <> k m b) ->
  KeyedTets signs k
  = OrderedTets signs (SortByKey (fun '(a, e) => k a e) (CutsBetween signs)).
Proof.
  intros apart. apply KeyTetsAlike.
  assert (corner : forall v, In v [CornerOf V1; CornerOf V2; CornerOf V3; CornerOf V4] ->
    exists l, v = CornerOf l).
  { intros v [<-|[<-|[<-|[<-|[]]]]]; eauto. }
  intros a e b f Ia Ie Ib If.
  destruct (corner a Ia) as [la ->], (corner e Ie) as [le ->],
    (corner b Ib) as [lb ->], (corner f If) as [lf ->].
  cbn [SymbolSign SymbolKey]. intros Sa Se Sb Sf shared.
  destruct (SamePair (la, le) (lb, lf)) eqn:S.
  { apply SamePairEqual in S. injection S as -> ->. rewrite !Z.ltb_irrefl. reflexivity. }
  assert (N : (la, le) <> (lb, lf)).
  { intros E. rewrite E, (proj2 (SamePairEqual _ _) eq_refl) in S. discriminate S. }
  symmetry.
  apply (RankCompares SamePair SamePairEqual (fun '(a, e) => k a e));
    try (apply InCutsBetween; split; assumption).
  destruct shared as [[= <-] | [= <-]].
  - refine (proj2 (apart le lf la _ _ _)); congruence.
  - refine (proj1 (apart la lb le _ _ _)); congruence.
Qed.

(** ** Placements *)

Section Placement.
  Variables (before : SignField) (warping : Coord3 -> Warping) (cut : CutField).
  Variables (r : Ranges) (bounds : AngleBounds).
  Hypothesis Hbounds : Sensible bounds.
  Hypothesis Limits : forall k, 0 <= MoveLimit r k.
  Variables (anchor : Coord3) (case : StructuredTetCase).
  Let tid := STId anchor case.
  Hypothesis FM : FittingMoves before warping r (Corners tid).
  Hypothesis FC : FittingCuts before warping cut r (Corners tid).

  Let corners := CornersOf tid.
  Let signs := QuadOf (fun l => PlacedSign before warping (Corner (Of corners l))).

  Definition CornerKey (a e : Label) : Z := CutKey cut (Of corners a) (Of corners e).


  (** Its cuts in the order of their keys. *)
  Definition PlacementOrder : list (Label * Label) :=
    SortByKey (fun '(a, e) => CornerKey a e) (CutsBetween signs).

  Section Turned.
    Variables (g : Turn) (m : Linear).
    Hypothesis Hm : In m AllIsometries.
    Let w := TurnQuad g corners.
    Hypothesis Hw : forall l, Apply m (Difference (Of w V1) (Of w l))
      = Difference (Of Canonical V1) (Of Canonical l).

    Let at_ (x : Label * Label) : Z := cut (Of w (fst x)) (Of w (snd x)).
    Let moves := QuadOf (MoveAt before warping anchor case g m).
    Let place v := Move m (Shift anchor case g m) (PlacedPosition warping cut (Stands w v)).

    Lemma EdgeOf a b : a <> b -> exists d,
      Of w b = Translate (Of w a) (Offset d) /\ DirectionKind d = LabelKind a b.
    Proof.
      intros N.
      assert (N' : LabelEqual a b = false) by (destruct a, b; reflexivity || congruence).
      destruct (CanonicalEdge a b N') as (e & Ee & Ke).
      destruct (OriginOfDirection m e Hm) as (d & Ed & Kd).
      exists d. split; [|congruence].
      assert (D : Offset d = Difference (Of w a) (Of w b)).
      { apply (ApplyInjective m); [exact (IsometryOrthonormal m Hm)|].
        unfold w. rewrite (WDifference anchor case g m Hw), Ed, Ee. reflexivity. }
      rewrite D. destruct (Of w a), (Of w b).
      cbn [Difference Translate]. f_equal; ring.
    Qed.

    Lemma InitialFit o : (forall a e, In (a, e) o -> In (a, e) (CutsBetween signs)) ->
      InOrder (fun '(a, e) => CornerKey a e) o ->
      Fitting at_ (InitialRanges r (map (TurnPair g) o)).
    Proof.
      induction o as [|[a e] rest IH]; [intros; exact I|].
      intros inside [first others]. cbn [map InitialRanges]. unfold TurnPair at 1.
      cbn [fst snd].
      assert (back : forall l, Of w (TurnLabel g l) = Of corners l)
        by (intros l; unfold w; rewrite OfTurned, TurnTwice; reflexivity).
      split; [|split].
      - cbn [InRange]. unfold at_. cbn [fst snd].
        destruct (proj1 (InCutsBetween signs a e) (inside a e (or_introl eq_refl)))
          as [Sa Se].
        assert (N : TurnLabel g a <> TurnLabel g e).
        { intros E. assert (a = e) by (rewrite <- (TurnTwice g a), E; apply TurnTwice).
          congruence. }
        destruct (EdgeOf _ _ N) as (d & E & K). rewrite <- K. rewrite !back in *.
        unfold signs in Sa, Se. rewrite OfQuadOf in Sa, Se. rewrite E in Se |- *.
        apply FC; try assumption; [|rewrite <- E]; apply InCorners; eauto.
      - intros y I. apply in_map_iff in I. destruct I as (x & <- & I).
        apply in_map_iff in I. destruct I as ([b f] & <- & I).
        specialize (first _ I). cbn beta iota in first.
        unfold TurnPair, at_. cbn [CutIn fst snd]. rewrite !back.
        unfold CornerKey, CutKey in first.
        pose proof (RankInRange (Of corners a) (Of corners e)).
        pose proof (RankInRange (Of corners b) (Of corners f)). lia.
      - apply IH; [|exact others]. intros b f I. apply inside. right. exact I.
    Qed.

    Lemma RangedOnSegment ranges v : Fitting at_ ranges ->
      (forall a e, In (a, e) (map CutIn ranges) -> a <> e) ->
      IsCutOf (map CutIn ranges) v = true ->
      OnSegment 256 (RangedSegment r moves ranges v) (place v).
    Proof.
      intros F N C. destruct v as [l|a e]; cbn [RangedSegment].
      - apply CornerOnSegment; try assumption.
        intros v d t I E. exact (proj1 (FM v d t I E)).
      - destruct (RangeOf (a, e) ranges) as [[lo hi]|] eqn:R.
        + pose proof (FittingIn at_ ranges _ F (RangeOfIn _ _ _ _ R)) as B.
          cbn [InRange] in B. unfold at_ in B. cbn [fst snd] in B.
          apply (CutInRangeOnSegment before warping cut
            {| MoveLimit := fun _ => 0; CutFrom := fun _ => lo; CutTo := fun _ => hi |}
            anchor case g m Hm Hw a e).
          * assert (D : a <> e).
            { apply N. apply RangeOfIn in R. apply (in_map CutIn) in R. exact R. }
            destruct a, e; reflexivity || congruence.
          * intros d _. exact B.
        + exfalso. cbn [IsCutOf] in C. apply existsb_exists in C.
          destruct C as (x & I & S). apply SamePairEqual in S. subst x.
          apply in_map_iff in I. destruct I as (x & E & I).
          unfold RangeOf in R. destruct (find _ ranges) as [[? ? ?]|] eqn:F'; [discriminate R|].
          pose proof (find_none _ _ F' x I) as G. cbv beta in G.
          rewrite E, (proj2 (SamePairEqual _ _) eq_refl) in G. discriminate G.
    Qed.

    (** So that the check speaks of them. *)
    Lemma OrderChecked o t : In o (Orders (CutsBetween (TurnQuad g signs))) ->
      Fitting at_ (InitialRanges r o) ->
      (forall a e, In (a, e) o -> a <> e) ->
      In t (OrderedTets (TurnQuad g signs) o) ->
      CheckRanged bounds (RangedSegment r moves) t Halvings (Tightened (InitialRanges r o)) = true ->
      WellShaped bounds (MapTet place t).
    Proof.
      intros O F N I C.
      assert (cuts : map CutIn (InitialRanges r o) = o).
      { unfold InitialRanges. rewrite map_map. rewrite <- (map_id o) at 2.
        apply map_ext. intros []. reflexivity. }
      apply (CheckRangedSound at_ bounds (RangedSegment r moves) t place Hbounds o) with
        (halvings := Halvings) (ranges := Tightened (InitialRanges r o));
        [|rewrite CutsTightened; exact cuts|apply TightenedFit, F|exact C].
      intros ranges v E F' J. rewrite <- E in N.
      apply RangedOnSegment; [exact F'|exact N|]. rewrite E.
      pose proof (OrderedCuts _ o t O I) as A. destruct t as [p q s u].
      cbn [AllOfTet TetCorners In] in A, J. rewrite !andb_true_iff in A.
      destruct A as [[[Ap Aq] As] Au].
      destruct J as [<-|[<-|[<-|[<-|[]]]]]; assumption.
    Qed.
  End Turned.

  Lemma CornerKeysApart a b m : a <> b -> a <> m -> b <> m ->
    CornerKey a m <> CornerKey b m /\ CornerKey m a <> CornerKey m b.
  Proof.
    intros ab am bm.
    destruct (IsometryOf anchor case Turn1234) as (i & Hi & _ & Hw). fold tid in Hw.
    assert (D : forall l k, l <> k -> Of corners l <> Of corners k).
    { intros l k N E. destruct (EdgeOf Turn1234 i Hi Hw l k N) as (d & E' & _).
      rewrite !OfTurned in E'. cbn [TurnLabel] in E'.
      rewrite <- E in E'. destruct (Of corners l) as [x y z].
      destruct d; cbn [Offset Translate] in E'; injection E'; lia. }
    apply CutKeysApart with (tid := tid); try (apply D; assumption);
      apply InCorners; eauto.
  Qed.

  Lemma PlacementTets t : In t (KeyTets before warping cut tid) ->
    exists u, In u (OrderedTets signs PlacementOrder) /\
      t = MapTet (PlacedPosition warping cut)
            (Orient (CaseHandedness case) (MapTet (Stands corners) u)).
  Proof.
    intros I. unfold KeyTets in I. apply in_map_iff in I. destruct I as (t1 & <- & I).
    unfold PlacementOrder. rewrite <- (KeyedAreOrdered signs CornerKey CornerKeysApart).
    assert (E : KeyNames before warping cut tid
      = map (Orient (CaseHandedness case))
          (map (MapTet (Stands corners)) (KeyedTets signs CornerKey))).
    { unfold KeyedTets.
      rewrite <- (KeyTetsNatural (Stands corners) (SymbolSign signs)
        (PlacedSign before warping) SymbolIntersection MeshIntersection
        (SymbolKey CornerKey) (MeshKey (CutKey cut))).
      - unfold KeyNames, OrderedNames, corners, CornersOf, tid.
        destruct (GetStructuredTet (STId anchor case)). reflexivity.
      - intros v [<-|[<-|[<-|[<-|[]]]]]; reflexivity.
      - intros v u [<-|[<-|[<-|[<-|[]]]]] [<-|[<-|[<-|[<-|[]]]]]; reflexivity.
      - intros v u [<-|[<-|[<-|[<-|[]]]]] [<-|[<-|[<-|[<-|[]]]]]; reflexivity. }
    rewrite E in I. apply in_map_iff in I. destruct I as (t2 & <- & I).
    apply in_map_iff in I. destruct I as (t3 & <- & I). eauto.
  Qed.

  Variable take : Z -> bool.
  Hypothesis Checked : CheckOrderedRepresentatives bounds r take = true.
  Hypothesis Taken : take (SurfaceCorners signs) = true.

  Theorem PlacementWithin t : In t (KeyTets before warping cut tid) ->
    WellShaped bounds t.
  Proof.
    intros I. destruct (PlacementTets t I) as (t3 & I3 & ->). clear I.
    destruct (OrderedRepresentative signs) as (g & R & T).
    set (o := PlacementOrder) in *.
    assert (O : In o (Orders (CutsBetween signs))) by apply SortListed.
    destruct (T o O) as (O' & T'). clear T.
    destruct (T' t3 I3) as (t4 & I4 & E). clear T' I3.
    destruct (IsometryOf anchor case g) as (m & Hm & D & Hw). fold tid in Hw.
    set (o' := map (TurnPair g) o) in *.
    assert (Q : TurnQuad g signs = QuadOf (SignAt before warping anchor case g)).
    { unfold SignAt, QuadOf, signs. rewrite !OfTurned.
      unfold TurnQuad. rewrite !OfQuadOf. reflexivity. }
    assert (inside : forall a e, In (a, e) o -> In (a, e) (CutsBetween signs))
      by (intros a e; apply InSorted).
    assert (apart : forall a e, In (a, e) o' -> a <> e).
    { intros a e J. apply in_map_iff in J. destruct J as ([b f] & E' & J).
      injection E' as <- <-. apply inside, InCutsBetween in J. destruct J as [Sb Sf].
      intros same. assert (b = f) by (rewrite <- (TurnTwice g b), same; apply TurnTwice).
      congruence. }
    pose proof (InitialFit g m Hm Hw o inside (SortInOrder _ _)) as F. fold o' in F.
    assert (C : CheckRanged bounds
      (RangedSegment r (QuadOf (MoveAt before warping anchor case g m))) t4 Halvings
      (Tightened (InitialRanges r o')) = true).
    { unfold CheckOrderedRepresentatives in Checked. rewrite forallb_forall in Checked.
      specialize (Checked (TurnQuad g signs)). rewrite filter_In in Checked.
      rewrite SurfaceCornersTurned in Checked. specialize (Checked (conj R Taken)).
      unfold CheckOrders in Checked.
      destruct (match TurnQuad g signs with
        | Q4 Plus _ _ _ | Q4 _ Plus _ _ | Q4 _ _ Plus _ | Q4 _ _ _ Plus => true
        | _ => false end) eqn:some.
      - rewrite forallb_forall in Checked. specialize (Checked o' O').
        cbv zeta in Checked. rewrite forallb_forall in Checked.
        specialize (Checked (QuadOf (MoveAt before warping anchor case g m))).
        rewrite Q in Checked at 1.
        specialize (Checked (ConfigurationEnumerated before warping r anchor case g m
          Hm Hw FM)).
        rewrite forallb_forall in Checked. exact (Checked t4 I4).
      - exfalso. clear - some I4. unfold OrderedTets, KeyedTets in I4.
        destruct (TurnQuad g signs) as [[] [] [] []]; try discriminate some;
          destruct I4. }
    pose proof (OrderChecked g m Hm Hw o' t4 O' F apart I4 C) as W.
    exact (WellShapedTurnedBack bounds _ g _ m _ _ t3 t4 Hm D E W).
  Qed.
End Placement.
