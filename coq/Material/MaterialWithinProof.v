(** * Every tetrahedron of every material is within bounds, if the checker says so *)

From Certet Require Import Material.Definitions.
From Certet Require Import Angles.Forms.EdgeProof Angles.Forms.CheckerProof
  Angles.Cases.Configurations Angles.Cases.Isometry Angles.Cases.SymmetryProof
  Angles.Cases.ReductionProof Material.MaterialProof
  Material.MaterialConfigurations Material.MaterialReductionProof.
Open Scope Z_scope.

Local Notation CheckSigns := (Configurations.CheckSigns GetUnstructuredTets).

Section Within.
  Variables (bounds : AngleBounds) (r : Ranges).
  Hypothesis Hbounds : Sensible bounds.
  Hypothesis Limits : forall k, 0 <= MoveLimit r k.

  (** What was checked: sign patterns that [take] takes, moves towards third
      materials, and the fill. *)
  Variable take : Quad Sign -> bool.
  Hypothesis TakenTurned : forall g signs, take (TurnQuad g signs) = take signs.
  Hypothesis CheckedSigns : forall signs, In signs Representatives ->
    take signs = true -> CheckSigns bounds r signs = true.
  Hypothesis CheckedThird : forall signs moves, In signs Representatives ->
    take signs = true -> In moves (ThirdMoves signs) ->
    CheckMoves bounds r signs moves = true.
  Hypothesis CheckedFill : CheckFill bounds r = true.

  Variable before : MaterialField.
  Variable warping : Coord3 -> Warping.
  Variable cut : CutField.
  Variable shared : StructuredTetId -> Material.
  Variables (anchor : Coord3) (case : StructuredTetCase).
  Let tid := STId anchor case.

  Local Notation material := (PlacedMaterial before warping).

  Hypothesis Moves_fit : MovesWithin warping r (Corners tid).
  Hypothesis Never_mutual : forall v d t e s,
    In v (Corners tid) -> In (Translate v (Offset d)) (Corners tid) ->
    warping v = Moves d t -> warping (Translate v (Offset d)) = Moves e s ->
    Translate (Translate v (Offset d)) (Offset e) <> v.
  Hypothesis Cuts_fit : forall v d m n,
    In v (Corners tid) -> In (Translate v (Offset d)) (Corners tid) ->
    material v = Some m -> material (Translate v (Offset d)) = Some n -> m <> n ->
    256 * CutFrom r (DirectionKind d)
      <= EitherCut before warping cut v (Translate v (Offset d))
      <= 256 * CutTo r (DirectionKind d).
  Hypothesis Taken : forall m, take (QuadOf (fun l =>
    PlacedSign (BeforeAmong before m) warping (Corner (Of (CornersOf tid) l)))) = true.
  Hypothesis Whole : InterfacesAlone before warping tid ->
    WellShaped bounds (PlacedWhole warping cut tid).

  (** ** The stencils' *)

  Lemma CutsFitAmong m :
    FittingCuts (BeforeAmong before m) warping (EitherCut before warping cut) r
      (Corners tid).
  Proof.
    intros v d I J P N.
    pose proof (PlacedMeans before warping m v) as Mv. rewrite P in Mv.
    pose proof (PlacedMeans before warping m (Translate v (Offset d))) as Mu.
    rewrite N in Mu. destruct Mu as (n & Mu & D).
    exact (Cuts_fit v d m n I J Mv Mu (not_eq_sym D)).
  Qed.

  Lemma StencilTetWithin m t :
    In t (PlacedTets (BeforeAmong before m) warping (EitherCut before warping cut) tid) ->
    WellShaped bounds t.
  Proof.
    apply (PlacementChecked bounds r Hbounds Limits anchor case);
      [exact Moves_fit | apply CutsFitAmong |].
    intros g mm Hm Hw signs R.
    assert (K : take signs = true).
    { rewrite <- (Taken m), <- (TakenTurned g). f_equal.
      unfold signs, SignAt, QuadOf. rewrite !OfTurned. unfold TurnQuad.
      destruct g; reflexivity. }
    set (moves := QuadOf _).
    assert (Listed : forall l, In (Of moves l) (MovesOf (Of signs l)))
      by (apply MoveAtListed).
    destruct (Consistent signs moves) eqn:C.
    - apply MovesChecked; [apply CheckedSigns; assumption|].
      destruct signs as [s1 s2 s3 s4]. unfold MovesFor. apply filter_In.
      split; [|exact C]. destruct moves. apply InProduct4;
        [apply (Listed V1)|apply (Listed V2)|apply (Listed V3)|apply (Listed V4)].
    - apply CheckedThird; [exact R|exact K|].
      assert (N : NotMutual moves = true).
      { unfold NotMutual. apply forallb_forall. intros i _.
        apply forallb_forall. intros j _. apply negb_true_iff, not_true_iff_false.
        rewrite andb_true_iff. unfold moves. rewrite !OfQuadOf. intros [Ti Tj].
        destruct (MoveAtMeans (BeforeAmong before m) warping anchor case g mm Hm Hw i j Ti)
          as (d & t' & Ed & Ej).
        destruct (MoveAtMeans (BeforeAmong before m) warping anchor case g mm Hm Hw j i Tj)
          as (e & s & Ee & Ei).
        pose proof (InW anchor case g i) as Ii. pose proof (InW anchor case g j) as Ij.
        rewrite <- Ej in Ij, Ee, Ei. exact (Never_mutual _ d t' e s Ii Ij Ed Ee Ei). }
      unfold ThirdMoves. destruct signs as [s1 s2 s3 s4]. apply filter_In. split.
      + destruct moves. apply InProduct4;
          [apply (Listed V1)|apply (Listed V2)|apply (Listed V3)|apply (Listed V4)].
      + rewrite N, C. reflexivity.
  Qed.

  (** ** The fill's *)

  Lemma FillTetWithin m s : In (m, s) (FillOf (MaterialQuad before warping tid)) ->
    WellShaped bounds (OrientPoints (Hand tid) (MapTet (fun v =>
      PlacedPosition warping (EitherCut before warping cut)
        (Stands (CornersOf tid) v)) s)).
  Proof.
    intros I. destruct (FillListed _ _ _ I) as [(q & n & Iq & Same & J) Between].
    destruct (IsometryOf anchor case Turn1234) as (mm & Hm & D & Hw). fold tid in Hw.
    assert (T : TurnQuad Turn1234 (CornersOf tid) = CornersOf tid)
      by (destruct (CornersOf tid); reflexivity).
    set (signs := SignAt (BeforeAmong before 0) warping anchor case Turn1234).
    set (moves := QuadOf (MoveAt (BeforeAmong before 0) warping anchor case Turn1234 mm)).
    assert (L : In moves (FillMoves q)).
    { destruct q as [q1 q2 q3 q4] eqn:Q. unfold FillMoves. rewrite <- Q in Same.
      assert (M : forall l, In (Of moves l) (MovesOfMaterial (Of q l))).
      { intros l. unfold moves. rewrite OfQuadOf. unfold MoveAt.
        pose proof (PlacedMeans before warping 0 (Of (CornersOf tid) l)) as P.
        unfold SignAt. fold tid. rewrite T.
        specialize (Same l). unfold MaterialQuad in Same. rewrite OfQuadOf in Same.
        destruct (PlacedSign (BeforeAmong before 0) warping _).
        - destruct (Of q l); [left; reflexivity|].
          rewrite (proj2 Same eq_refl) in P. discriminate P.
        - rewrite (proj1 Same P). cbn [MovesOfMaterial]. apply in_map, InAllDirections.
        - destruct P as (k & P & _). destruct (Of q l); [left; reflexivity|].
          rewrite (proj2 Same eq_refl) in P. discriminate P. }
      rewrite Q in M. destruct moves. apply InProduct4;
        [apply (M V1)|apply (M V2)|apply (M V3)|apply (M V4)]. }
    pose proof CheckedFill as C. unfold CheckFill in C.
    rewrite forallb_forall in C. specialize (C q Iq).
    rewrite forallb_forall in C. specialize (C moves L).
    rewrite forallb_forall in C. specialize (C (n, s) J). cbn [snd] in C.
    assert (On : forall v, BetweenMaterials (MaterialQuad before warping tid) v ->
      OnSegment 256 (SymbolSegment r moves v)
        (Move mm (Shift anchor case Turn1234 mm)
          (PlacedPosition warping (EitherCut before warping cut)
            (Stands (CornersOf tid) v)))).
    { intros [l|a b] B.
      - pose proof (CornerOnSegment (BeforeAmong before 0) warping
          (EitherCut before warping cut) r anchor case Turn1234 Moves_fit Limits mm Hm Hw l)
          as O. fold tid in O. rewrite T in O. exact O.
      - destruct B as (Nab & ma & mb & Ea & Eb & Dab).
        unfold MaterialQuad in Ea, Eb. rewrite OfQuadOf in Ea, Eb.
        pose proof (CutInRangeOnSegment (BeforeAmong before 0) warping
          (EitherCut before warping cut) r anchor case Turn1234 mm Hm Hw a b Nab)
          as O. fold tid in O. rewrite T in O. apply O. intros d E.
        pose proof (InW anchor case Turn1234 a) as Ia.
        pose proof (InW anchor case Turn1234 b) as Ib.
        fold tid in Ia, Ib. rewrite T in Ia, Ib.
        rewrite E in Eb, Ib |- *. exact (Cuts_fit _ d ma mb Ia Ib Ea Eb Dab). }
    destruct s as [p q' u w]. cbn [MapTet] in *.
    destruct Between as (Bp & Bq & Bu & Bw).
    pose proof (CheckTetSound 256 ltac:(lia) _ _ _ _ _ _ _ _ _ Hbounds
      (On p Bp) (On q' Bq) (On u Bu) (On w Bw) C) as S.
    pose proof (IsometryOrthonormal mm Hm) as O.
    unfold Hand, tid.
    destruct (CaseHandedness case); cbn [OrientPoints HandDeterminant] in *.
    - exact (WellShapedMoved _ mm _ _ _ _ _ O D S).
    - exact (WellShapedMirrored _ mm _ _ _ _ _ O D S).
  Qed.

  Theorem MaterialTetWithin m t :
    In (m, t) (PlacedMaterialTets before warping cut shared tid) ->
    WellShaped bounds t.
  Proof.
    intros I. destruct (KindsOfTets before warping cut shared tid m t I)
      as [[A ->]|[S|(s & J & ->)]].
    - exact (Whole A).
    - exact (StencilTetWithin m t S).
    - exact (FillTetWithin m s J).
  Qed.
End Within.
