(** * From all placements of C15 to the enumerated ones: proof

    As in [KeyReductionProof]: a placement goes with its corners into the frame in
    which its image comes first, and its cuts, sorted by key, are one of the orders
    that were checked. *)

From Certet Require Import Key.Definitions.
From Certet Require Import Angles.Forms.Checker Angles.Forms.EdgeProof
  Angles.Forms.CheckerProof Angles.Cases.Configurations Angles.Cases.Isometry
  Angles.Cases.SymmetryProof Angles.Cases.ReductionProof
  Key.Orders Key.OrderProof Key.KeyConfigurations Key.RangedProof
  Key.KeyReductionProof Lattice.Tiling.
From Certet Require Import C15.Sites C15.C15Tet C15.C15TilingProof C15.TilingStuffing
  C15.C15Stuffing C15.C15MeshProof C15.C15AnglesSpec C15.C15Configurations
  C15.C15FramesProof.
Open Scope Z_scope.

(** An edge that leads from a corner out of the tetrahedron. *)
Definition LeadsOut (case : C15Case) (l : Label) (o : Coord3) : bool :=
  forallb (fun k => negb (Coord3Equal (Translate (Of (CaseCorners case) l) o)
                            (Of (CaseCorners case) k))) AllLabels.

Definition OutwardOffset (case : C15Case) (l : Label) : Coord3 :=
  match find (LeadsOut case l) (OffsetsAround (Of (CaseCorners case) l)) with
  | Some o => o
  | None => C3 0 0 0
  end.

Lemma OutwardThere case l :
  In (OutwardOffset case l) (OffsetsAround (Of (CaseCorners case) l)) /\
  LeadsOut case l (OutwardOffset case l) = true.
Proof.
  unfold OutwardOffset.
  destruct (find (LeadsOut case l) (OffsetsAround (Of (CaseCorners case) l))) as [o|] eqn:F.
  - apply find_some in F. exact F.
  - exfalso.
    assert (T : forallb (fun case => forallb (fun l =>
      existsb (LeadsOut case l) (OffsetsAround (Of (CaseCorners case) l))) AllLabels)
      AllC15Cases = true) by (vm_compute; reflexivity).
    rewrite forallb_forall in T. specialize (T case (InAllC15Cases case)).
    rewrite forallb_forall in T. specialize (T l (InAllLabels l)).
    apply existsb_exists in T. destruct T as (o & I & T).
    pose proof (find_none _ _ F o I) as N. congruence.
Qed.

Lemma MapMapTet {A B C} (f : B -> C) (h : A -> B) t :
  MapTet f (MapTet h t) = MapTet (fun v => f (h v)) t.
Proof. destruct t. reflexivity. Qed.

Section Placement.
  Variables (before : SignField) (warping : Coord3 -> C15Warping) (cut : CutField).
  Variables (th : C15Thresholds) (bounds : AngleBounds).
  Hypothesis Hbounds : Sensible bounds.
  Hypothesis Limits : forall a b, 0 <= th a b.
  Variables (cell : Coord3) (case : C15Case).
  Let tid := C15Id cell case.
  Hypothesis FM : C15AdmissibleMoves before warping th (C15Corners tid).
  Hypothesis FC : C15AdmissibleCuts before warping cut th (C15Corners tid).

  Let p := CaseCorners case.
  Let standard := StandardOf case.
  Let q := CaseCorners standard.
  Let base := CellPosition cell.

  (** The corner with a label, in the lattice. *)
  Definition LatticeCorner (l : Label) : Coord3 := Translate base (Of p l).
  Local Notation corner := LatticeCorner.

  Definition LatticeCorners : Quad Coord3 := QuadOf corner.

  Lemma CornerIsVertex l : corner l = C15Vertex tid (PlaceOf l).
  Proof. destruct l; reflexivity. Qed.

  Lemma CornerListed l : In (corner l) (C15Corners tid).
  Proof. apply InC15Corners. exists (PlaceOf l). apply CornerIsVertex. Qed.

  Lemma ListedCorner v : In v (C15Corners tid) -> exists l, v = corner l.
  Proof.
    intros I. apply InC15Corners in I. destruct I as ([] & ->);
      [exists V1|exists V2|exists V3|exists V4]; reflexivity.
  Qed.

  Lemma CornersApart k l : corner k = corner l -> k = l.
  Proof.
    intros E. rewrite !CornerIsVertex in E. apply C15VerticesApart in E.
    destruct k, l; try reflexivity; discriminate E.
  Qed.

  Definition LatticeSigns : Quad Sign :=
    QuadOf (fun l => C15After before warping (corner l)).

  Definition LatticeMoves : OffsetMoves :=
    QuadOf (fun l =>
      match C15After before warping (corner l) with
      | OnSurface =>
          Some match warping (corner l) with
               | Moved o _ => o
               | Unmoved => OutwardOffset case l
               end
      | _ => None
      end).

  Definition LatticeKey (a e : Label) : Z := C15CutKey cut (corner a) (corner e).

  (** The cuts in the order of their keys. *)
  Definition LatticeOrder : list (Label * Label) :=
    SortByKey (fun '(a, e) => LatticeKey a e) (CutsBetween LatticeSigns).

  Section Framed.
    Variable f : Frame.
    Hypothesis Hf : In f (FramesOf case).
    Let g := OrderIn f.
    Let m := MapOf f.

    Lemma ListedOrder : In g LabelOrders.
    Proof. exact (proj1 (FrameListed p q f Hf)). Qed.

    Lemma MapOrthonormal : Orthonormal m.
    Proof. apply IsometryOrthonormal. exact (proj1 (proj2 (FrameListed p q f Hf))). Qed.

    Let signs := SignsIn g LatticeSigns.
    Let moves := MovesIn f LatticeMoves.
    Let at_ (x : Label * Label) : Z :=
      cut (corner (Of g (fst x))) (corner (Of g (snd x))).

    Lemma CornersCarried i j :
      Apply m (Difference (corner (Of g i)) (corner (Of g j)))
      = Difference (Of q i) (Of q j).
    Proof.
      assert (C : forall l, Apply m (Difference (corner (Of g V1)) (corner (Of g l)))
        = Difference (Of q V1) (Of q l)).
      { intros l. unfold LatticeCorner. rewrite DifferenceTranslated.
        exact (FrameCarries p q f Hf l). }
      replace (Difference (corner (Of g i)) (corner (Of g j))) with
        (Difference (Difference (corner (Of g V1)) (corner (Of g i)))
           (Difference (corner (Of g V1)) (corner (Of g j)))).
      - rewrite ApplyDifference, !C.
        destruct (Of q V1), (Of q i), (Of q j). cbn [Difference]. f_equal; ring.
      - destruct (corner (Of g V1)), (corner (Of g i)), (corner (Of g j)).
        cbn [Difference]. f_equal; ring.
    Qed.

    Lemma EdgesCarried l : MetalOf (corner (Of g l)) = MetalOf (Of q l) /\
      forall o, In o (OffsetsAround (corner (Of g l))) ->
        In (Apply m o) (OffsetsAround (Of q l)) /\
        MetalOf (Translate (corner (Of g l)) o)
        = MetalOf (Translate (Of q l) (Apply m o)).
    Proof.
      unfold LatticeCorner, base. rewrite MetalTranslated, OffsetsTranslated.
      setoid_rewrite TranslateAssociative. setoid_rewrite MetalTranslated.
      exact (FrameEdges p q f Hf l).
    Qed.

    Lemma OffsetCarried l : exists o : Coord3,
      Of LatticeMoves l =
        match C15After before warping (corner l) with OnSurface => Some o | _ => None end /\
      In o (OffsetsAround (corner l)) /\
      match warping (corner l) with
      | Moved e t => e = o
      | Unmoved => LeadsOut case l o = true
      end.
    Proof.
      unfold LatticeMoves. rewrite OfQuadOf.
      destruct (warping (corner l)) as [|o t] eqn:W.
      - exists (OutwardOffset case l). split; [reflexivity|].
        destruct (OutwardThere case l) as [I T]. split; [|exact T].
        unfold LatticeCorner, base. rewrite OffsetsTranslated. exact I.
      - exists o. split; [reflexivity|]. split; [|reflexivity].
        exact (proj1 (FM _ _ _ (CornerListed l) W)).
    Qed.

    (** *** It is one of those that are enumerated *)

    Lemma TargetMeans i j : TargetsCorner standard i j (Of moves i) = true ->
      exists o t, warping (corner (Of g i)) = Moved o t /\
        Translate (corner (Of g i)) o = corner (Of g j).
    Proof.
      unfold moves. rewrite OfMovesIn. fold g m.
      destruct (OffsetCarried (Of g i)) as (o & -> & I & W).
      destruct (C15After before warping (corner (Of g i))); try discriminate.
      cbn [option_map TargetsCorner]. fold q. intros T. apply Coord3EqualTrue in T.
      assert (E : o = Difference (corner (Of g i)) (corner (Of g j))).
      { apply (ApplyInjective m); [exact MapOrthonormal|].
        rewrite CornersCarried, <- T. destruct (Of q i), (Apply m o).
        cbn [Difference Translate]. f_equal; ring. }
      assert (R : Translate (corner (Of g i)) o = corner (Of g j)).
      { rewrite E. destruct (corner (Of g i)), (corner (Of g j)).
        cbn [Difference Translate]. f_equal; ring. }
      destruct (warping (corner (Of g i))) as [|e t].
      - exfalso. unfold LeadsOut in W. rewrite forallb_forall in W.
        specialize (W (Of g j) (InAllLabels _)). fold p in W.
        unfold LatticeCorner in R. rewrite TranslateAssociative in R.
        apply TranslateInjective in R. rewrite R, Coord3EqualRefl in W. discriminate W.
      - subst e. eauto.
    Qed.

    Lemma PlacementEnumerated :
      IsFirst (Symmetries standard) signs moves = true ->
      In moves (C15MovesFor standard (Symmetries standard) signs).
    Proof.
      intros first.
      assert (M : forall l, In (Of moves l) (OffsetMovesOf (Of signs l) (Of q l))).
      { intros l. unfold moves, signs. rewrite OfMovesIn, OfSignsIn. fold g m.
        destruct (OffsetCarried (Of g l)) as (o & -> & I & _).
        unfold LatticeSigns. rewrite OfQuadOf.
        destruct (C15After before warping (corner (Of g l))); cbn [option_map OffsetMovesOf];
          try (left; reflexivity).
        apply in_map. exact (proj1 (proj2 (EdgesCarried l) o I)). }
      assert (consistent : C15Consistent standard signs moves = true).
      { unfold C15Consistent. apply existsb_exists.
        exists (QuadOf (fun l => before (corner (Of g l)))). split.
        - assert (B : forall l, In (before (corner (Of g l))) (SignsBefore (Of signs l))).
          { intros l. unfold signs. rewrite OfSignsIn. unfold LatticeSigns.
            rewrite OfQuadOf. unfold C15After.
            destruct (warping (corner (Of g l))); destruct (before (corner (Of g l)));
              cbn; tauto. }
          destruct signs as [a b c d]. apply InProduct4;
            [exact (B V1)|exact (B V2)|exact (B V3)|exact (B V4)].
        - unfold C15ConsistentWith. apply forallb_forall. intros i _.
          apply forallb_forall. intros j _. rewrite !OfQuadOf.
          destruct (TargetsCorner standard i j (Of moves i)) eqn:T; [|reflexivity].
          destruct (TargetMeans i j T) as (o & t & W & E).
          destruct (FM _ _ _ (CornerListed _) W) as (_ & _ & C). cbv zeta in C.
          rewrite E in C. destruct (C (CornerListed _)) as [O N]. rewrite O.
          destruct (TargetsCorner standard j i (Of moves j)) eqn:T'; [|reflexivity].
          destruct (TargetMeans j i T') as (e & s & W' & E').
          exfalso. exact (N e s W' E'). }
      unfold C15MovesFor. fold q.
      destruct signs as [a b c d] eqn:Es, q as [r s u v] eqn:Eq.
      apply filter_In. rewrite first, consistent. split; [|reflexivity].
      destruct moves as [w x y z]. apply InProduct4;
        [exact (M V1)|exact (M V2)|exact (M V3)|exact (M V4)].
    Qed.

    (** *** Its vertices lie on the segments *)

    Definition FrameShift : Coord3 :=
      Difference (Scale Steps (Apply m (corner (Of g V1)))) (Scale Steps (Of q V1)).

    Let place v := Move m FrameShift
      (C15Position warping cut (Stands LatticeCorners (SymbolIn g v))).

    Lemma LatticeMoved l e : Move m FrameShift (Translate (Scale Steps (corner (Of g l))) e)
      = Translate (Scale Steps (Of q l)) (Apply m e).
    Proof. exact (LatticeCarried m _ _ _ _ e (CornersCarried V1 l)). Qed.

    Lemma StepsOfThreshold a b : EdgeThreshold th a b = 256 * th (MetalOf a) (MetalOf b).
    Proof. unfold EdgeThreshold. change (Steps / 256) with 256. ring. Qed.

    Lemma CornerOnItsSegment ranges l :
      OnSegment 256 (C15Segment standard th moves ranges (CornerOf l)) (place (CornerOf l)).
    Proof.
      unfold place. cbn [SymbolIn Stands]. unfold LatticeCorners. rewrite OfQuadOf.
      cbn [C15Segment C15Position]. fold q. unfold moves. rewrite OfMovesIn. fold g m.
      destruct (OffsetCarried (Of g l)) as (o & -> & I & W).
      destruct (EdgesCarried l) as [own others].
      destruct (others o I) as [_ other].
      assert (still : Move m FrameShift (Scale Steps (corner (Of g l)))
        = Translate (Scale Steps (Of q l)) (Scale 0 (C3 0 0 0))).
      { replace (Scale Steps (corner (Of g l)))
          with (Translate (Scale Steps (corner (Of g l))) (Scale 0 (C3 0 0 0)))
          by (destruct (corner (Of g l)); cbn [Scale Translate]; f_equal; ring).
        rewrite LatticeMoved, ApplyScale. f_equal.
        destruct (Apply m (C3 0 0 0)). reflexivity. }
      assert (fixed : OnSegment 256 (Fixed (Scale 256 (Of q l)))
        (Translate (Scale Steps (Of q l)) (Scale 0 (C3 0 0 0)))).
      { exists (1, 0). cbn [On]. repeat (split; [lia|]).
        change Steps with 65536. destruct (Of q l).
        cbn [Scale Translate]. f_equal; ring. }
      unfold C15After. destruct (warping (corner (Of g l))) as [|e t] eqn:Ew.
      - rewrite still.
        destruct (before (corner (Of g l))); cbn [option_map]; [exact fixed| |exact fixed].
        replace (Scale 0 (C3 0 0 0)) with (Scale 0 (Apply m o))
          by (destruct (Apply m o); reflexivity).
        apply AlongOnSegment. rewrite <- own, <- other.
        specialize (Limits (MetalOf (corner (Of g l)))
                      (MetalOf (Translate (corner (Of g l)) o))). lia.
      - subst e. cbn [option_map]. rewrite LatticeMoved, ApplyScale.
        apply AlongOnSegment. rewrite <- own, <- other.
        destruct (FM _ _ _ (CornerListed _) Ew) as (_ & B & _). cbv zeta in B.
        rewrite StepsOfThreshold in B. lia.
    Qed.

    Lemma CutOnItsSegment ranges a e : Fitting at_ ranges ->
      In (a, e) (map CutIn ranges) ->
      OnSegment 256 (C15Segment standard th moves ranges (CutOf a e)) (place (CutOf a e)).
    Proof.
      intros F I. unfold place. cbn [SymbolIn Stands]. unfold LatticeCorners.
      rewrite !OfQuadOf. cbn [C15Segment C15Position]. fold q.
      destruct (RangeOf (a, e) ranges) as [[lo hi]|] eqn:R.
      - pose proof (FittingIn at_ ranges _ F (RangeOfIn _ _ _ _ R)) as B.
        cbn [InRange] in B. unfold at_ in B. cbn [fst snd] in B.
        unfold PointOnEdge. rewrite LatticeMoved, ApplyScale, CornersCarried.
        apply AlongOnSegment, B.
      - exfalso. apply in_map_iff in I. destruct I as (x & E & I).
        unfold RangeOf in R. destruct (find _ ranges) as [[? ? ?]|] eqn:F'; [discriminate R|].
        pose proof (find_none _ _ F' x I) as G. cbv beta in G.
        rewrite E, (proj2 (SamePairEqual _ _) eq_refl) in G. discriminate G.
    Qed.

    (** *** Its cuts are in their ranges, in order *)

    Lemma KeysOrderCuts a e b h : In (a, e) (CutsBetween LatticeSigns) ->
      In (b, h) (CutsBetween LatticeSigns) -> LatticeKey a e <= LatticeKey b h ->
      cut (corner a) (corner e) <= cut (corner b) (corner h).
    Proof.
      intros A B. apply InCutsBetween in A, B. unfold LatticeKey, C15CutKey.
      assert (N : forall a e, Of LatticeSigns a = Plus /\ Of LatticeSigns e = Minus ->
        corner a <> corner e).
      { intros x y [P M] E. apply CornersApart in E. congruence. }
      pose proof (RankSmall _ (CornersSmall tid _ _ (CornerListed a) (CornerListed e) (N a e A))).
      pose proof (RankSmall _ (CornersSmall tid _ _ (CornerListed b) (CornerListed h) (N b h B))).
      lia.
    Qed.

    Lemma RangesFit o : (forall a e, In (a, e) o -> In (a, e) (CutsBetween LatticeSigns)) ->
      InOrder (fun '(a, e) => LatticeKey a e) o ->
      Fitting at_ (C15Ranges standard th (map (PairStanding g) o)).
    Proof.
      induction o as [|[a e] rest IH]; [intros; exact I|].
      intros inside [first others]. cbn [map C15Ranges]. unfold PairStanding at 1.
      cbn [fst snd]. split; [|split].
      - cbn [InRange]. unfold at_. cbn [fst snd]. rewrite !StandsThere by exact ListedOrder.
        destruct (proj1 (InCutsBetween LatticeSigns a e) (inside a e (or_introl eq_refl)))
          as [Sa Se].
        unfold LatticeSigns in Sa, Se. rewrite OfQuadOf in Sa, Se.
        pose proof (FC _ _ (CornerListed a) (CornerListed e) Sa Se) as B.
        rewrite !StepsOfThreshold in B. change Steps with 65536 in B.
        unfold LabelThreshold. fold q.
        rewrite <- !(proj1 (EdgesCarried _)), !StandsThere by exact ListedOrder. lia.
      - intros y I. apply in_map_iff in I. destruct I as (x & <- & I).
        apply in_map_iff in I. destruct I as ([b h] & <- & I).
        specialize (first _ I). cbn beta iota in first.
        unfold PairStanding, at_. cbn [CutIn fst snd].
        rewrite !StandsThere by exact ListedOrder.
        apply KeysOrderCuts; [apply inside; left; reflexivity|apply inside; right; exact I|].
        exact first.
      - apply IH; [|exact others]. intros b h I. apply inside. right. exact I.
    Qed.

    Lemma OrderWithin o t :
      In (map (PairStanding g) o) (Orders (CutsBetween signs)) ->
      (forall a e, In (a, e) o -> In (a, e) (CutsBetween LatticeSigns)) ->
      InOrder (fun '(a, e) => LatticeKey a e) o ->
      In t (OrderedTets signs (map (PairStanding g) o)) ->
      CheckRanged bounds (C15Segment standard th moves) t Halvings
        (Tightened (C15Ranges standard th (map (PairStanding g) o))) = true ->
      WellShaped bounds (MapTet place t).
    Proof.
      intros O inside ordered I C. set (o' := map (PairStanding g) o) in *.
      assert (cuts : map CutIn (C15Ranges standard th o') = o').
      { unfold C15Ranges. rewrite map_map. rewrite <- (map_id o') at 2.
        apply map_ext. intros []. reflexivity. }
      apply (CheckRangedSound at_ bounds (C15Segment standard th moves) t place Hbounds o')
        with (halvings := Halvings) (ranges := Tightened (C15Ranges standard th o'));
        [|rewrite CutsTightened; exact cuts
         |apply TightenedFit, RangesFit; assumption|exact C].
      intros ranges v E F J. destruct v as [l|a e]; [apply CornerOnItsSegment|].
      apply CutOnItsSegment; [exact F|]. rewrite E.
      pose proof (OrderedCuts _ o' t O I) as A. destruct t as [x y z w].
      cbn [AllOfTet TetCorners In] in A, J. rewrite !andb_true_iff in A.
      assert (B : IsCutOf o' (CutOf a e) = true).
      { destruct A as [[[Ax Ay] Az] Aw].
        destruct J as [<-|[<-|[<-|[<-|[]]]]]; assumption. }
      cbn [IsCutOf] in B. apply existsb_exists in B. destruct B as (x' & B & S).
      apply SamePairEqual in S. subst x'. exact B.
    Qed.
  End Framed.

  (** ** The stencils on symbols *)

  Lemma LatticeKeysApart a b l : a <> b -> a <> l -> b <> l ->
    LatticeKey a l <> LatticeKey b l /\ LatticeKey l a <> LatticeKey l b.
  Proof.
    intros ab al bl.
    apply (C15CutKeysApart cut tid); try apply CornerListed;
      intros E; apply CornersApart in E; contradiction.
  Qed.

  Lemma LatticeTets t : In t (C15Tets before warping cut tid) ->
    exists u, In u (OrderedTets LatticeSigns LatticeOrder) /\
      t = MapTet (C15Position warping cut) (MapTet (Stands LatticeCorners) u).
  Proof.
    intros I. unfold C15Tets in I. apply in_map_iff in I. destruct I as (t1 & <- & I).
    unfold LatticeOrder. rewrite <- (KeyedAreOrdered LatticeSigns LatticeKey LatticeKeysApart).
    assert (E : C15Names before warping cut tid
      = map (Orient RightHanded)
          (map (MapTet (Stands LatticeCorners)) (KeyedTets LatticeSigns LatticeKey))).
    { unfold KeyedTets.
      rewrite <- (KeyTetsNatural (Stands LatticeCorners) (SymbolSign LatticeSigns)
        (AfterSign (C15After before warping)) SymbolIntersection MeshIntersection
        (SymbolKey LatticeKey) (MeshKey (C15CutKey cut))).
      - reflexivity.
      - intros v [<-|[<-|[<-|[<-|[]]]]]; reflexivity.
      - intros v u [<-|[<-|[<-|[<-|[]]]]] [<-|[<-|[<-|[<-|[]]]]]; reflexivity.
      - intros v u [<-|[<-|[<-|[<-|[]]]]] [<-|[<-|[<-|[<-|[]]]]]; reflexivity. }
    rewrite E in I. apply in_map_iff in I. destruct I as (t2 & <- & I).
    apply in_map_iff in I. destruct I as (t3 & <- & I). exists t3. split; [exact I|].
    destruct t3. reflexivity.
  Qed.

  Lemma StandsIn g v : Stands (QuadOf (fun l => corner (Of g l))) v
    = Stands LatticeCorners (SymbolIn g v).
  Proof.
    destruct v; cbn [Stands SymbolIn]; unfold LatticeCorners; rewrite !OfQuadOf;
      reflexivity.
  Qed.

  Variable take : Z -> bool.
  Hypothesis Checked : CheckC15Case standard bounds th take = true.
  Hypothesis Taken : take (SurfaceCorners LatticeSigns) = true.

  Theorem C15PlacementWithin t : In t (C15Tets before warping cut tid) ->
    WellShaped bounds t.
  Proof.
    intros I. destruct (LatticeTets t I) as (u & Iu & ->). clear I.
    destruct (FirstFrame case LatticeSigns LatticeMoves) as (f & Hf & first).
    fold standard in first.
    pose proof (ListedOrder f Hf) as G.
    set (g := OrderIn f) in *. set (m := MapOf f).
    set (signs := SignsIn g LatticeSigns) in *.
    set (moves := MovesIn f LatticeMoves) in *.
    assert (O : In LatticeOrder (Orders (CutsBetween LatticeSigns))) by apply SortListed.
    destruct (OrderRespected g LatticeSigns LatticeOrder G O) as (O' & T).
    destruct (T u Iu) as (u' & Iu' & E). clear T. fold signs in O', Iu'.
    assert (inside : forall a e, In (a, e) LatticeOrder -> In (a, e) (CutsBetween LatticeSigns))
      by (intros a e; apply InSorted).
    assert (C : CheckRanged bounds (C15Segment standard th moves) u' Halvings
      (Tightened (C15Ranges standard th (map (PairStanding g) LatticeOrder))) = true).
    { unfold CheckC15Case in Checked. cbv zeta in Checked.
      rewrite forallb_forall in Checked. specialize (Checked signs).
      rewrite filter_In in Checked. unfold signs in Checked at 2.
      rewrite (SurfaceCornersIn g LatticeSigns G) in Checked.
      specialize (Checked (conj (InAllSigns signs) Taken)).
      unfold CheckC15Signs in Checked.
      rewrite (FirstHasFirstSigns _ _ _ first) in Checked.
      destruct (HasPlus signs) eqn:some.
      - cbv zeta in Checked. rewrite forallb_forall in Checked.
        specialize (Checked _ O'). cbv beta in Checked.
        rewrite forallb_forall in Checked.
        specialize (Checked moves (PlacementEnumerated f Hf first)). cbv beta in Checked.
        rewrite forallb_forall in Checked. exact (Checked u' Iu').
      - exfalso. clear - some Iu'. unfold OrderedTets, KeyedTets in Iu'.
        destruct signs as [[] [] [] []]; try discriminate some; destruct Iu'. }
    pose proof (OrderWithin f Hf LatticeOrder u' O' inside (SortInOrder _ _) Iu' C) as W.
    clear C Iu' O'. fold g m in W.
    apply (EvenPermutationsMap (fun v => C15Position warping cut (Stands LatticeCorners v)))
      in E.
    rewrite MapMapTet. refine (WellShapedPermuted _ _ _ E _). clear E u Iu.
    pose proof (MapOrthonormal f Hf) as On. fold m in On.
    pose proof (FrameDeterminant _ _ f Hf) as D. fold g m in D.
    destruct u' as [x y z w]. cbn [MapTet] in W. cbn [MapTet HandedBy].
    rewrite <- D. destruct (Determinant m =? 1) eqn:Dm.
    - apply Z.eqb_eq in Dm. exact (WellShapedMoved _ m _ _ _ _ _ On Dm W).
    - assert (Dm' : Determinant m = -1).
      { rewrite D in Dm |- *. unfold OrderDeterminant in *.
        destruct (Z.even (Inversions g)); [discriminate Dm|reflexivity]. }
      exact (WellShapedMirrored _ m _ _ _ _ _ On Dm' W).
  Qed.
End Placement.
