(** * From all placements to the enumerated ones: proofs

    A placement goes with its corners into the canonical frame, where it is one
    of the enumerated configurations. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Forms.Checker Angles.Forms.EdgeProof
  Angles.Forms.CheckerProof Angles.Cases.Configurations Angles.Cases.Isometry
  Angles.Cases.SymmetryProof.
Open Scope Z_scope.

(** The product's stencils. *)
Local Notation SymbolTets := (Configurations.SymbolTets GetUnstructuredTets).
Local Notation CheckSigns := (Configurations.CheckSigns GetUnstructuredTets).
Local Notation CheckRepresentatives :=
  (Configurations.CheckRepresentatives GetUnstructuredTets).

(** All that becomes of one configuration stays within bounds. *)
Definition CheckMoves (bounds : AngleBounds) (r : Ranges) (signs : Quad Sign)
  (moves : Quad (option Direction)) : bool :=
  forallb (fun t => CheckTet bounds (MapTet (SymbolSegment r moves) t))
    (SymbolTets signs).

(** A move that carries one point of the lattice, and the differences to it, carries
    what lies about the others. *)
Lemma LatticeCarried m p p' q q' e :
  Apply m (Difference p q) = Difference p' q' ->
  Move m (Difference (Scale Steps (Apply m p)) (Scale Steps p'))
    (Translate (Scale Steps q) e) = Translate (Scale Steps q') (Apply m e).
Proof.
  intros E. rewrite ApplyDifference in E.
  unfold Move. rewrite ApplyTranslate, ApplyScale.
  destruct (Apply m p) as [a1 a2 a3], (Apply m q) as [b1 b2 b3],
    p' as [c1 c2 c3], q' as [d1 d2 d3], (Apply m e) as [e1 e2 e3].
  cbn [Difference Translate Scale] in *. injection E as E1 E2 E3.
  f_equal.
  - replace b1 with (d1 - c1 + a1) by lia. ring.
  - replace b2 with (d2 - c2 + a2) by lia. ring.
  - replace b3 with (d3 - c3 + a3) by lia. ring.
Qed.

Lemma MovesChecked bounds r signs moves :
  CheckSigns bounds r signs = true -> In moves (MovesFor signs) ->
  CheckMoves bounds r signs moves = true.
Proof.
  unfold Configurations.CheckSigns, CheckMoves. intros C I.
  destruct (SymbolTets signs) as [|t ts]; [reflexivity|].
  rewrite forallb_forall in C. exact (C moves I).
Qed.

(** ** Placements within ranges *)

Section Placement.
  Variable before : SignField.
  Variable warping : Coord3 -> Warping.
  Variable cut : CutField.

  (** No corner moves too far. *)
  Definition MovesWithin (r : Ranges) (corners : list Coord3) : Prop :=
    forall v d t, In v corners -> warping v = Moves d t ->
      0 <= t <= 256 * MoveLimit r (DirectionKind d).

  (** [AdmissibleMoves] and [AdmissibleCuts], for any ranges. *)
  Definition FittingMoves (r : Ranges) (corners : list Coord3) : Prop :=
    forall v d t, In v corners -> warping v = Moves d t ->
      0 <= t <= 256 * MoveLimit r (DirectionKind d) /\
      (In (Translate v (Offset d)) corners ->
         Opposite (before v) (before (Translate v (Offset d))) = true /\
         forall e s, warping (Translate v (Offset d)) = Moves e s ->
           Translate (Translate v (Offset d)) (Offset e) <> v).

  Definition FittingCuts (r : Ranges) (corners : list Coord3) : Prop :=
    forall v d, In v corners -> In (Translate v (Offset d)) corners ->
      PlacedSign before warping (Corner v) = Plus ->
      PlacedSign before warping (Corner (Translate v (Offset d))) = Minus ->
      256 * CutFrom r (DirectionKind d) <= cut v (Translate v (Offset d))
        <= 256 * CutTo r (DirectionKind d).

  Variable r : Ranges.
  Variables (anchor : Coord3) (case : StructuredTetCase) (g : Turn).
  Let tid := STId anchor case.
  Hypothesis Moves_fit : MovesWithin r (Corners tid).
  Hypothesis Cuts_fit : FittingCuts r (Corners tid).
  Hypothesis Limits : forall k, 0 <= MoveLimit r k.

  Variable m : Linear.
  Hypothesis Hm : In m AllIsometries.
  (** The corners in the order that the turn gives them. *)
  Let w := TurnQuad g (CornersOf tid).
  Hypothesis Hw : forall l, Apply m (Difference (Of w V1) (Of w l))
    = Difference (Of Canonical V1) (Of Canonical l).

  Let Hm1 : Orthonormal m := IsometryOrthonormal m Hm.

  Lemma InW l : In (Of w l) (Corners tid).
  Proof. apply InCorners. unfold w. rewrite OfTurned. eauto. Qed.

  Lemma WDifference i j : Apply m (Difference (Of w i) (Of w j))
    = Difference (Of Canonical i) (Of Canonical j).
  Proof.
    replace (Difference (Of w i) (Of w j)) with
      (Difference (Difference (Of w V1) (Of w i))
         (Difference (Of w V1) (Of w j))).
    - rewrite ApplyDifference, !Hw.
      destruct (Of Canonical V1), (Of Canonical i), (Of Canonical j).
      cbn [Difference]. f_equal; ring.
    - destruct (Of w V1), (Of w i), (Of w j). cbn [Difference]. f_equal; ring.
  Qed.

  (** Into the canonical frame, steps and all. *)
  Definition Shift : Coord3 :=
    Difference (Scale Steps (Apply m (Of w V1)))
      (Scale Steps (Of Canonical V1)).

  Lemma MoveLattice l e : Move m Shift (Translate (Scale Steps (Of w l)) e)
    = Translate (Scale Steps (Of Canonical l)) (Apply m e).
  Proof. exact (LatticeCarried m _ _ _ _ e (Hw l)). Qed.

  (** *** The configuration *)

  Definition SignAt (l : Label) : Sign :=
    PlacedSign before warping (Corner (Of w l)).

  Definition ImageDirection (d : Direction) : Direction :=
    match find (Carries m d) AllDirections with Some e => e | None => d end.

  Lemma ImageDirectionMeans d :
    Apply m (Offset d) = Offset (ImageDirection d) /\
    DirectionKind d = DirectionKind (ImageDirection d).
  Proof.
    unfold ImageDirection.
    destruct (find (Carries m d) AllDirections) as [e|] eqn:F.
    - apply find_some in F. apply CarriesMeans, F.
    - exfalso. destruct (ImageOfDirection m d Hm) as (e & E & K).
      pose proof (find_none _ _ F e (InAllDirections e)) as F'.
      unfold Carries in F'. rewrite E, K, Coord3EqualRefl in F'.
      destruct (DirectionKind e); discriminate F'.
  Qed.

  Definition MoveAt (l : Label) : option Direction :=
    match SignAt l with
    | OnSurface =>
        Some (match warping (Of w l) with
              | Moves d _ => ImageDirection d
              | Stays => Outward l
              end)
    | _ => None
    end.

  Definition QuadOf {T} (f : Label -> T) : Quad T :=
    Q4 (f V1) (f V2) (f V3) (f V4).

  Lemma OfQuadOf {T} (f : Label -> T) l : Of (QuadOf f) l = f l.
  Proof. destruct l; reflexivity. Qed.

  Let signs := QuadOf SignAt.
  Let moves := QuadOf MoveAt.

  Lemma MoveAtMeans i j : Targets i j (MoveAt i) = true -> exists d t,
    warping (Of w i) = Moves d t /\ Translate (Of w i) (Offset d) = Of w j.
  Proof.
    unfold MoveAt. destruct (SignAt i); try discriminate.
    destruct (warping (Of w i)) as [|d t].
    - rewrite OutwardTargetsNone. discriminate.
    - intros T. exists d, t. split; [reflexivity|].
      cbn [Targets] in T. apply Coord3EqualTrue in T.
      assert (E : Offset d = Difference (Of w i) (Of w j)).
      { apply (ApplyInjective m); [exact Hm1|].
        rewrite WDifference, (proj1 (ImageDirectionMeans d)), <- T.
        destruct (Of Canonical i), (Offset (ImageDirection d)).
        cbn [Difference Translate]. f_equal; ring. }
      rewrite E. destruct (Of w i), (Of w j).
      cbn [Difference Translate]. f_equal; ring.
  Qed.

  Lemma MoveAtListed l : In (Of moves l) (MovesOf (Of signs l)).
  Proof.
    unfold moves, signs. rewrite !OfQuadOf. unfold MoveAt, MovesOf.
    destruct (SignAt l); try (left; reflexivity).
    apply in_map, InAllDirections.
  Qed.

  Lemma ConfigurationEnumerated : FittingMoves r (Corners tid) ->
    In moves (MovesFor signs).
  Proof.
    intros Fit. apply (InMovesFor signs moves (QuadOf (fun l => before (Of w l)))).
    - exact MoveAtListed.
    - intros l. unfold signs. rewrite !OfQuadOf. unfold SignAt. cbn [PlacedSign].
      destruct (warping (Of w l)); cbn [WarpedSign];
        destruct (before (Of w l)); cbn; tauto.
    - unfold ConsistentWith. apply forallb_forall. intros i _.
      apply forallb_forall. intros j _.
      unfold moves. rewrite !OfQuadOf.
      destruct (Targets i j (MoveAt i)) eqn:T; [|reflexivity].
      destruct (MoveAtMeans i j T) as (d & t & Ed & Ej).
      destruct (Fit _ _ _ (InW i) Ed) as [_ C].
      rewrite Ej in C. destruct (C (InW j)) as [O N]. rewrite O.
      destruct (Targets j i (MoveAt j)) eqn:T'; [|reflexivity].
      destruct (MoveAtMeans j i T') as (e & s & Ee & Ei).
      exfalso. exact (N e s Ee Ei).
  Qed.

  (** *** Its vertices lie on the segments *)

  Lemma AlongOnSegment (p e : Coord3) (lo hi t : Z) :
    256 * lo <= t <= 256 * hi ->
    OnSegment 256 (SegmentBetween (Along p e lo) (Along p e hi))
      (Translate (Scale Steps p) (Scale t e)).
  Proof.
    intros B. change Steps with 65536. unfold SegmentBetween, Along.
    destruct p as [p1 p2 p3], e as [e1 e2 e3].
    cbn [Translate Scale Coord3Equal].
    destruct (_ && _ && _) eqn:E.
    - rewrite !andb_true_iff, !Z.eqb_eq in E. destruct E as [[E1 E2] E3].
      exists (1, 0). cbn [On]. repeat (split; [lia|]).
      cbn [Scale].
      assert (F : forall x, lo * x = hi * x -> t * x = 256 * (lo * x)).
      { intros x Ex. destruct (Z.eq_dec x 0) as [->|Nx]; [ring|].
        assert (lo = hi) by (apply (Z.mul_reg_r _ _ x); assumption).
        subst hi. assert (t = 256 * lo) by lia. subst t. ring. }
      f_equal; [rewrite (F e1) by lia|rewrite (F e2) by lia|rewrite (F e3) by lia];
        ring.
    - assert (lo <> hi).
      { intros ->. rewrite !Z.eqb_refl in E. discriminate E. }
      exists (256 * hi - t, t - 256 * lo). cbn [On].
      repeat (split; [lia|]). cbn [Scale Translate]. f_equal; ring.
  Qed.

  Lemma CornerOnSegment l :
    OnSegment 256 (SymbolSegment r moves (CornerOf l))
      (Move m Shift (PlacedPosition warping cut (Corner (Of w l)))).
  Proof.
    unfold moves. cbn [SymbolSegment PlacedPosition]. rewrite OfQuadOf.
    unfold MoveAt, SignAt. cbn [PlacedSign].
    assert (Still : Move m Shift (Scale Steps (Of w l))
      = Translate (Scale Steps (Of Canonical l)) (Scale 0 (C3 0 0 0))).
    { replace (Scale Steps (Of w l))
        with (Translate (Scale Steps (Of w l)) (Scale 0 (C3 0 0 0)))
        by (destruct (Of w l); cbn [Scale Translate]; f_equal; ring).
      rewrite MoveLattice, ApplyScale. f_equal.
      destruct (Apply m (C3 0 0 0)). reflexivity. }
    destruct (warping (Of w l)) as [|d t] eqn:E; cbn [WarpedSign WarpedPosition].
    - rewrite Still.
      assert (F : OnSegment 256 (Fixed (Scale 256 (Of Canonical l)))
        (Translate (Scale Steps (Of Canonical l)) (Scale 0 (C3 0 0 0)))).
      { exists (1, 0). cbn [On]. repeat (split; [lia|]).
        change Steps with 65536. destruct (Of Canonical l).
        cbn [Scale Translate]. f_equal; ring. }
      destruct (before (Of w l)); [exact F| |exact F].
      replace (Scale 0 (C3 0 0 0)) with (Scale 0 (Offset (Outward l)))
        by (destruct (Offset (Outward l)); reflexivity).
      apply AlongOnSegment.
      specialize (Limits (DirectionKind (Outward l))). lia.
    - rewrite MoveLattice, ApplyScale.
      destruct (ImageDirectionMeans d) as [-> K].
      apply AlongOnSegment. rewrite <- K.
      pose proof (Moves_fit _ _ _ (InW l) E). lia.
  Qed.

  (** Whatever the signs, of any cut that is in range. *)
  Lemma CutInRangeOnSegment a b : LabelEqual a b = false ->
    (forall d, Of w b = Translate (Of w a) (Offset d) ->
       256 * CutFrom r (DirectionKind d) <= cut (Of w a) (Of w b)
         <= 256 * CutTo r (DirectionKind d)) ->
    OnSegment 256 (SymbolSegment r moves (CutOf a b))
      (Move m Shift (PlacedPosition warping cut (Cut (Of w a) (Of w b)))).
  Proof.
    intros N Range. cbn [SymbolSegment PlacedPosition]. unfold PointOnEdge.
    rewrite MoveLattice, ApplyScale, WDifference.
    apply AlongOnSegment.
    destruct (CanonicalEdge a b N) as (e & Ee & Ke).
    destruct (OriginOfDirection m e Hm) as (d & Ed & Kd).
    assert (E : Of w b = Translate (Of w a) (Offset d)).
    { assert (D : Offset d = Difference (Of w a) (Of w b)).
      { apply (ApplyInjective m); [exact Hm1|].
        rewrite WDifference, Ed, Ee. reflexivity. }
      rewrite D. destruct (Of w a), (Of w b).
      cbn [Difference Translate]. f_equal; ring. }
    rewrite <- Ke, <- Kd. exact (Range d E).
  Qed.

  Lemma CutOnSegment a b : SignAt a = Plus -> SignAt b = Minus ->
    OnSegment 256 (SymbolSegment r moves (CutOf a b))
      (Move m Shift (PlacedPosition warping cut (Cut (Of w a) (Of w b)))).
  Proof.
    intros Sa Sb. apply CutInRangeOnSegment.
    - destruct a, b; try reflexivity; congruence.
    - intros d E. unfold SignAt in Sb. pose proof (InW b) as Ib.
      rewrite E in Sb, Ib |- *. exact (Cuts_fit (Of w a) d (InW a) Ib Sa Sb).
  Qed.

  Lemma SymbolOnSegment v : CutsFromPlusToMinus signs v = true ->
    OnSegment 256 (SymbolSegment r moves v)
      (Move m Shift (PlacedPosition warping cut (Stands w v))).
  Proof.
    destruct v as [l|a b]; intros H.
    - apply CornerOnSegment.
    - unfold signs in H. cbn [CutsFromPlusToMinus] in H.
      rewrite !OfQuadOf in H.
      apply CutOnSegment; destruct (SignAt a), (SignAt b);
        reflexivity || discriminate H.
  Qed.

  (** *** So that the check speaks of them *)

  Variable bounds : AngleBounds.
  Hypothesis Hbounds : Sensible bounds.

  Lemma CheckedTet t :
    CheckMoves bounds r signs moves = true -> In t (SymbolTets signs) ->
    WellShaped bounds (MapTet (fun v =>
      Move m Shift (PlacedPosition warping cut (Stands w v))) t).
  Proof.
    intros C I. pose proof (StencilCuts _ _ I) as S.
    unfold CheckMoves in C. rewrite forallb_forall in C. specialize (C t I).
    destruct t as [p q s u]. cbn [AllOfTet] in S.
    rewrite !andb_true_iff in S. destruct S as [[[Sp Sq] Ss] Su].
    cbn [MapTet] in *.
    apply (CheckTetSound 256 ltac:(lia) _ _ _ _ _ _ _ _ _ Hbounds
             (SymbolOnSegment p Sp) (SymbolOnSegment q Sq)
             (SymbolOnSegment s Ss) (SymbolOnSegment u Su) C).
  Qed.
End Placement.

(** ** The reduction *)

Section Reduction.
  Variables (bounds : AngleBounds) (r : Ranges).
  Hypothesis Hbounds : Sensible bounds.
  Hypothesis Limits : forall k, 0 <= MoveLimit r k.

  Lemma SurfaceCornersTurned g signs :
    SurfaceCorners (TurnQuad g signs) = SurfaceCorners signs.
  Proof. destruct signs, g; cbn -[Z.add]; ring. Qed.

  Lemma EvenPermutationsMap {A B} (f : A -> B) t t' :
    In t (EvenPermutations t') ->
    In (MapTet f t) (EvenPermutations (MapTet f t')).
  Proof.
    destruct t' as [a b c d]. cbn [EvenPermutations In MapTet]. intros I.
    repeat (destruct I as [<-|I]; [cbn [MapTet]; tauto|]). destruct I.
  Qed.

  Lemma StandsTurned g q v :
    Stands (TurnQuad g q) (TurnSymbol g v) = Stands q v.
  Proof.
    destruct v; cbn [Stands TurnSymbol]; rewrite !OfTurned, !TurnTwice;
      reflexivity.
  Qed.

  (** What a tetrahedron is where its symbols were turned, it is where they were not. *)
  Lemma WellShapedTurnedBack (place : MeshVertex -> Coord3) g q m s hand t t' :
    In m AllIsometries -> Determinant m = HandDeterminant hand ->
    In (MapTet (TurnSymbol g) t) (EvenPermutations t') ->
    WellShaped bounds
      (MapTet (fun v => Move m s (place (Stands (TurnQuad g q) v))) t') ->
    WellShaped bounds (MapTet place (Orient hand (MapTet (Stands q) t))).
  Proof.
    intros Hm D E W.
    apply (EvenPermutationsMap (fun v => Move m s (place (Stands (TurnQuad g q) v)))) in E.
    pose proof (WellShapedPermuted _ _ _ E W) as S. clear E W.
    destruct t as [a b c d]. cbn [MapTet] in S.
    rewrite !StandsTurned in S.
    pose proof (IsometryOrthonormal m Hm) as O.
    destruct hand; cbn [Orient MapTet HandDeterminant] in *.
    - exact (WellShapedMoved _ m _ _ _ _ _ O D S).
    - exact (WellShapedMirrored _ m _ _ _ _ _ O D S).
  Qed.

  (** It is enough that the configuration was checked that a placement has in
      the canonical frame. *)
  Theorem PlacementChecked anchor case before warping cut :
    let tid := STId anchor case in
    MovesWithin warping r (Corners tid) ->
    FittingCuts before warping cut r (Corners tid) ->
    (forall g m, In m AllIsometries ->
       (forall l, Apply m (Difference (Of (TurnQuad g (CornersOf tid)) V1)
                             (Of (TurnQuad g (CornersOf tid)) l))
          = Difference (Of Canonical V1) (Of Canonical l)) ->
       let signs := QuadOf (SignAt before warping anchor case g) in
       In signs Representatives ->
       CheckMoves bounds r signs
         (QuadOf (MoveAt before warping anchor case g m)) = true) ->
    forall t, In t (PlacedTets before warping cut tid) -> WellShaped bounds t.
  Proof.
    intros tid FM FC Checked t I.
    assert (I' : In t (map (MapTet (PlacedPosition warping cut))
      (map (Orient (CaseHandedness case))
        (map (MapTet (Stands (CornersOf tid)))
          (SymbolTets (QuadOf (fun l =>
             PlacedSign before warping (Corner (Of (CornersOf tid) l))))))))).
    { unfold QuadOf.
      pose proof (StencilsNatural (PlacedSign before warping) (CornersOf tid))
        as E. cbv zeta in E.
      rewrite <- E. clear E. revert I.
      unfold PlacedTets, tid, CornersOf.
      destruct (GetStructuredTet (STId anchor case)). exact (fun H => H). }
    clear I. apply in_map_iff in I'. destruct I' as (t1 & <- & I).
    apply in_map_iff in I. destruct I as (t2 & <- & I).
    apply in_map_iff in I. destruct I as (t3 & <- & I).
    set (signs := QuadOf _) in I.
    destruct (RepresentativeOf signs) as (g & R & T).
    destruct (T t3 I) as (t4 & I4 & E). clear T I.
    destruct (IsometryOf anchor case g) as (m & Hm & D & Hw). fold tid in Hw.
    assert (Q : TurnQuad g signs
      = QuadOf (SignAt before warping anchor case g)).
    { unfold SignAt, QuadOf, signs. rewrite !OfTurned.
      unfold TurnQuad. rewrite !OfQuadOf. reflexivity. }
    rewrite Q in R, I4. clear Q.
    pose proof (CheckedTet before warping cut r anchor case g FM FC Limits m Hm Hw
      bounds Hbounds t4 (Checked g m Hm Hw R) I4) as W.
    exact (WellShapedTurnedBack _ g _ m _ _ t3 t4 Hm D E W).
  Qed.
  Variable take : Z -> bool.
  Hypothesis Checked : CheckRepresentatives bounds r take = true.

  Lemma RepresentativesChecked signs :
    In signs Representatives -> take (SurfaceCorners signs) = true ->
    CheckSigns bounds r signs = true.
  Proof.
    intros I T. unfold Configurations.CheckRepresentatives in *.
    rewrite forallb_forall in Checked.
    apply Checked, filter_In. split; assumption.
  Qed.

  Theorem AllPlacementsWithin tid before warping cut :
    FittingMoves before warping r (Corners tid) ->
    FittingCuts before warping cut r (Corners tid) ->
    take (SurfaceCorners (QuadOf (fun l =>
      PlacedSign before warping (Corner (Of (CornersOf tid) l))))) = true ->
    forall t, In t (PlacedTets before warping cut tid) -> WellShaped bounds t.
  Proof.
    intros FM FC K. destruct tid as [anchor case].
    apply PlacementChecked; [|exact FC|].
    - intros v d t I E. exact (proj1 (FM v d t I E)).
    - intros g m Hm Hw signs R. apply MovesChecked.
      + apply RepresentativesChecked; [exact R|].
        replace signs with (TurnQuad g (QuadOf (fun l =>
          PlacedSign before warping (Corner (Of (CornersOf (STId anchor case)) l))))).
        * rewrite SurfaceCornersTurned. exact K.
        * unfold signs, SignAt, QuadOf. rewrite !OfTurned. unfold TurnQuad.
          cbn [Of]. destruct g; reflexivity.
      + apply (ConfigurationEnumerated before warping r anchor case g m Hm Hw FM).
  Qed.
End Reduction.
