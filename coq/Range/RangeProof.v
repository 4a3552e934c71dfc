(** * Machine integers suffice: proof *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Lattice.Tiling Lattice.FaceProof Stuffing.NameProof
  Stuffing.VerticesProof Angles.Cases.AdmissibleProof Angles.DomainProof
  Embedding.MeshEmbedsProof Range.RangeSpec.
Open Scope Z_scope.

Local Strategy 1000 [Warp].

(** ** Unfolding *)

Lemma StepsIs : Steps = 65536.
Proof. reflexivity. Qed.

Ltac reckon :=
  unfold Computes, InType in *; cbn [Fits Value] in *; unfold InType in *;
  change (2 ^ (32 - 1)) with 2147483648 in *;
  change (2 ^ (64 - 1)) with 9223372036854775808 in *;
  rewrite ?StepsIs in *; unfold WidthLimit, AnchorLimit, LatticeLimit in *;
  change (2 ^ 19) with 524288 in *.

Lemma ProductBound x y m n :
  - m <= x <= m -> - n <= y <= n -> - (m * n) <= x * y <= m * n.
Proof.
  intros X Y. apply Z.abs_le. rewrite Z.abs_mul.
  apply Z.mul_le_mono_nonneg; lia.
Qed.

Lemma OffsetBound d k : - 2 <= Along k (Offset d) <= 2.
Proof. destruct d, k; cbn; lia. Qed.

(** ** Positions *)

Lemma WarpedFormulaFits v t e :
  - LatticeLimit <= v <= LatticeLimit -> 0 <= t <= Steps -> - 2 <= e <= 2 ->
  Computes 32 (WarpedFormula v t e) (Steps * v + t * e).
Proof.
  intros V T E. unfold WarpedFormula. reckon.
  pose proof (ProductBound t e 65536 2 ltac:(lia) E). lia.
Qed.

Lemma AlongWarped v d t k :
  Along k (WarpedPosition v (Moves d t))
  = Steps * Along k v + t * Along k (Offset d).
Proof. unfold WarpedPosition. destruct v, k, (Offset d); reflexivity. Qed.

Theorem WarpedFits v d t k :
  Bounded LatticeLimit v -> 0 <= t <= Steps ->
  Computes 32 (WarpedFormula (Along k v) t (Along k (Offset d)))
    (Along k (WarpedPosition v (Moves d t))).
Proof.
  intros B T. rewrite AlongWarped. apply WarpedFormulaFits; auto using OffsetBound.
Qed.

Lemma EdgeAlong v d k :
  Along k (Translate v (Offset d)) - Along k v = Along k (Offset d).
Proof. destruct v, k, (Offset d); cbn [Translate Along]; ring. Qed.

Lemma AlongEdge v u t k :
  Along k (PointOnEdge v u t)
  = Steps * Along k v + t * (Along k u - Along k v).
Proof. destruct v, u, k; reflexivity. Qed.

Theorem MiddleFits v d low half k :
  Bounded LatticeLimit v -> 0 <= low -> 0 <= half -> low + half <= Steps ->
  let u := Translate v (Offset d) in
  Computes 32 (MiddleFormula (Along k v) (Along k u) low half)
    (Along k (PointOnEdge v u (low + half))).
Proof.
  intros B L H T u. rewrite AlongEdge.
  pose proof (EdgeAlong v d k) as E. fold u in E.
  pose proof (OffsetBound d k) as O. specialize (B k).
  unfold MiddleFormula. reckon. rewrite E.
  pose proof (ProductBound (low + half) (Along k (Offset d)) 65536 2 ltac:(lia) O).
  lia.
Qed.

Theorem CutFits v d t k :
  Bounded LatticeLimit v -> 0 <= t <= Steps ->
  let u := Translate v (Offset d) in
  Computes 32 (CutFormula (Along k v) (Along k u) t)
    (Along k (PointOnEdge v u t)).
Proof.
  intros B T u.
  destruct (MiddleFits v d t 0 k B ltac:(lia) ltac:(lia) ltac:(lia)) as (F & V).
  fold u in F, V. rewrite Z.add_0_r in V. rewrite <- V.
  unfold CutFormula, MiddleFormula in *. reckon. rewrite Z.add_0_r in *. lia.
Qed.

(** ** Decisions *)

Theorem DecisionsFit th k t :
  th = AngleThresholds \/ th = EmbeddingThresholds \/ th = NoWarpThresholds ->
  0 <= t <= Steps ->
  let 'TH long short := th in
  Computes 32 (ThresholdFormula (match k with Long => long | Short => short end))
    (ThresholdSteps th k) /\
  Computes 32 (OtherEndFormula t) (Steps - t) /\
  Computes 64 (DistanceFormula (LengthSquared k) t)
    (LengthSquared k * (t * t)).
Proof.
  intros Th T.
  assert (S : - (65536 * 65536) <= t * t <= 65536 * 65536)
    by (apply ProductBound; rewrite StepsIs in T; lia).
  destruct Th as [-> | [-> | ->]]; unfold AngleThresholds, EmbeddingThresholds, NoWarpThresholds;
    unfold ThresholdFormula, OtherEndFormula, DistanceFormula;
    destruct k; cbn [LengthSquared]; reckon;
    unfold ThresholdSteps; rewrite ?StepsIs; change (65536 / 256) with 256; lia.
Qed.

(** ** Volumes *)

Lemma ThirdOrderFits e1 e2 e3 e4 e5 :
  - 2 ^ 20 <= e1 <= 2 ^ 20 -> - 2 ^ 20 <= e2 <= 2 ^ 20 -> - 2 ^ 20 <= e3 <= 2 ^ 20 ->
  - 2 ^ 20 <= e4 <= 2 ^ 20 -> - 2 ^ 20 <= e5 <= 2 ^ 20 ->
  - 2 ^ 40 <= e2 * e3 <= 2 ^ 40 /\ - 2 ^ 40 <= e4 * e5 <= 2 ^ 40 /\
  - 2 ^ 61 <= e1 * (e2 * e3 - e4 * e5) <= 2 ^ 61.
Proof.
  intros F1 F2 F3 F4 F5.
  pose proof (ProductBound e2 e3 _ _ F2 F3) as P.
  pose proof (ProductBound e4 e5 _ _ F4 F5) as Q.
  replace (2 ^ 20 * 2 ^ 20) with (2 ^ 40) in * by reflexivity.
  split; [exact P|]. split; [exact Q|].
  replace (2 ^ 61) with (2 ^ 20 * 2 ^ 41) by reflexivity.
  apply ProductBound; [exact F1|].
  replace (2 ^ 41) with (2 ^ 40 + 2 ^ 40) by reflexivity. lia.
Qed.

(** Edges twice as long as [WidthLimit]; graded meshes have them. *)
Lemma WideVolumesFit a b c d :
  (forall p, In p [a; b; c; d] -> forall k, InType 32 (Along k p)) ->
  Bounded (2 ^ 20) (Difference a b) -> Bounded (2 ^ 20) (Difference a c) ->
  Bounded (2 ^ 20) (Difference a d) ->
  Computes 64 (SixVolumeFormula a b c d) (SixVolume a b c d) /\
  Computes 64 (DeterminantFormula a b c d) (SixVolume a b c d).
Proof.
  intros I B C D.
  assert (Ia := I a (or_introl eq_refl)).
  assert (Ib := I b (or_intror (or_introl eq_refl))).
  assert (Ic := I c (or_intror (or_intror (or_introl eq_refl)))).
  assert (Id := I d (or_intror (or_intror (or_intror (or_introl eq_refl))))).
  clear I. destruct a as [ax ay az], b as [bx by_ bz], c as [cx cy cz], d as [dx dy dz].
  pose proof (B AxisX) as Bx; pose proof (B AxisY) as By; pose proof (B AxisZ) as Bz.
  pose proof (C AxisX) as Cx; pose proof (C AxisY) as Cy; pose proof (C AxisZ) as Cz.
  pose proof (D AxisX) as Dx; pose proof (D AxisY) as Dy; pose proof (D AxisZ) as Dz.
  pose proof (Ia AxisX); pose proof (Ia AxisY); pose proof (Ia AxisZ).
  pose proof (Ib AxisX); pose proof (Ib AxisY); pose proof (Ib AxisZ).
  pose proof (Ic AxisX); pose proof (Ic AxisY); pose proof (Ic AxisZ).
  pose proof (Id AxisX); pose proof (Id AxisY); pose proof (Id AxisZ).
  clear B C D Ia Ib Ic Id. cbn [Along Difference] in *.
  destruct (ThirdOrderFits _ _ _ _ _ Bx Cy Dz Cz Dy) as (? & ? & ?).
  destruct (ThirdOrderFits _ _ _ _ _ By Cx Dz Cz Dx) as (? & ? & ?).
  destruct (ThirdOrderFits _ _ _ _ _ By Cz Dx Cx Dz) as (? & ? & ?).
  destruct (ThirdOrderFits _ _ _ _ _ Bz Cx Dy Cy Dx) as (? & ? & ?).
  unfold SixVolumeFormula, DeterminantFormula, SixVolume, Normal.
  cbn [Along]. reckon. cbn [Dot Cross Difference].
  change (2 ^ 20) with 1048576 in *.
  change (2 ^ 40) with 1099511627776 in *. change (2 ^ 61) with 2305843009213693952 in *.
  generalize dependent (bx - ax); generalize dependent (by_ - ay);
    generalize dependent (bz - az); generalize dependent (cx - ax);
    generalize dependent (cy - ay); generalize dependent (cz - az);
    generalize dependent (dx - ax); generalize dependent (dy - ay);
    generalize dependent (dz - az).
  intros. split; (split; [repeat split; lia | ring]).
Qed.

Theorem VolumesFit a b c d :
  (forall p, In p [a; b; c; d] -> forall k, InType 32 (Along k p)) ->
  Bounded WidthLimit (Difference a b) -> Bounded WidthLimit (Difference a c) ->
  Bounded WidthLimit (Difference a d) ->
  Computes 64 (SixVolumeFormula a b c d) (SixVolume a b c d) /\
  Computes 64 (DeterminantFormula a b c d) (SixVolume a b c d).
Proof.
  assert (wider : forall v, Bounded WidthLimit v -> Bounded (2 ^ 20) v).
  { intros v B k. specialize (B k). unfold WidthLimit in B.
    change (2 ^ 19) with 524288 in B. change (2 ^ 20) with 1048576. lia. }
  intros I B C D. apply WideVolumesFit; auto.
Qed.

(** ** The tetrahedra of a mesh are narrow *)

(** A corner moves by half an edge at most, along an axis by one unit, and a cut
    lies between corners: so two vertices are no more than two units farther
    apart than the corners. *)
Section Placed.
  Variables (before : SignField) (warping : Coord3 -> Warping) (cut : CutField).
  Variable corners : list Coord3.
  Hypothesis Sane : Moderate before warping cut corners.

  Local Notation place := (PlacedPosition warping cut).
  Local Notation Made := (OfCorners before warping corners).

  Lemma BetweenCorners m k : Made m -> exists v w,
    In v corners /\ In w corners /\
    Steps * (Along k v - 1) <= Along k (place m) <= Steps * (Along k w + 1).
  Proof.
    destruct m as [v | p q]; intros M.
    - exists v, v. repeat (split; [exact M|]). cbn [PlacedPosition].
      destruct (warping v) as [|d t] eqn:W.
      + destruct v, k; cbn [WarpedPosition Scale Along]; rewrite StepsIs; lia.
      + pose proof (proj1 Sane v d t M W) as T.
        pose proof (ProductBound t (Along k (Offset d)) 32768 2
                      ltac:(rewrite StepsIs in T; lia) (OffsetBound d k)).
        rewrite AlongWarped, StepsIs. lia.
    - pose proof (proj2 Sane p q M) as T. destruct M as (I & J & _ & _).
      cbn [PlacedPosition]. rewrite AlongEdge.
      destruct (Z.le_ge_cases (Along k p) (Along k q)) as [L|L];
        [exists p, q | exists q, p]; repeat (split; [assumption|]).
      + assert (0 <= cut p q * (Along k q - Along k p)) by nia.
        assert (0 <= (Steps - cut p q) * (Along k q - Along k p)) by nia.
        rewrite StepsIs in *. nia.
      + assert (0 <= cut p q * (Along k p - Along k q)) by nia.
        assert (0 <= (Steps - cut p q) * (Along k p - Along k q)) by nia.
        rewrite StepsIs in *. nia.
  Qed.

  Lemma NarrowBetween width m n :
    NoWider width corners -> Made m -> Made n ->
    Bounded ((width + 2) * Steps) (Difference (place m) (place n)).
  Proof.
    intros W M N k.
    destruct (BetweenCorners m k M) as (v & w & V & U & Lm & Um).
    destruct (BetweenCorners n k N) as (v' & w' & V' & U' & Ln & Un).
    pose proof (W v w' V U' k) as A. pose proof (W w v' U V' k) as B.
    assert (E : forall p q, Along k (Difference p q) = Along k q - Along k p)
      by (intros p q; destruct p, q, k; reflexivity).
    rewrite E in *. rewrite StepsIs in *. lia.
  Qed.

  Lemma PlacedInType m k :
    (forall v, In v corners -> Bounded LatticeLimit v) -> Made m ->
    InType 32 (Along k (place m)).
  Proof.
    intros B M. destruct (BetweenCorners m k M) as (v & w & V & W & L & U).
    specialize (B v V k) as Bv. specialize (B w W k) as Bw. reckon. lia.
  Qed.
End Placed.

Theorem PlacedNarrow before warping cut width corners :
  NoWider width corners -> Moderate before warping cut corners ->
  forall m n,
    OfCorners before warping corners m -> OfCorners before warping corners n ->
    Bounded ((width + 2) * Steps)
      (Difference (PlacedPosition warping cut m) (PlacedPosition warping cut n)).
Proof. intros W S m n. apply NarrowBetween; assumption. Qed.

(** ** The lattice as a tiling *)

Theorem LatticeNoWider : TilingNoWider 2 LatticeTiling.
Proof.
  intros [a c] p q I J. unfold VerticesOf in I, J.
  apply in_map_iff in I as (i & <- & _), J as (j & <- & _).
  cbn [LatticeTiling VertexOf]. rewrite !VertexMoves.
  replace (Difference _ _) with (Difference (LocalVertex c i) (LocalVertex c j))
    by (destruct a, (LocalVertex c i), (LocalVertex c j); cbn; f_equal; ring).
  destruct c, i, j; intros []; split; discriminate.
Qed.

Theorem LatticeReaches : TilingReaches 3 LatticeTiling.
Proof.
  intros [[x y z] c] i k.
  destruct c, i; cbn; destruct k; cbn [Along]; lia.
Qed.

Lemma CornersAreVertices tid : Corners tid = VerticesOf LatticeTiling tid.
Proof.
  unfold Corners, VerticesOf. cbn [LatticeTiling VertexOf map].
  destruct (GetStructuredTet tid). reflexivity.
Qed.

Lemma CornersNoWider tid : NoWider 2 (Corners tid).
Proof. rewrite CornersAreVertices. apply LatticeNoWider. Qed.

(** ** The product's own tetrahedra *)

Lemma PlacedOfCorners before warping tid t m :
  In t (PlacedNames before warping tid) -> In m (TetCorners t) ->
  OfCorners before warping (Corners tid) m.
Proof.
  unfold PlacedNames, Corners. destruct tid as [anchor c].
  destruct (GetStructuredTet (STId anchor c)) as [v1 v2 v3 v4 n1 n2 n3 n4].
  intros I J. apply in_map_iff in I. destruct I as (u & <- & I).
  apply OrientCorners in J.
  destruct (StencilVertices _ _ _ _ _ _ _ I J)
    as [(v & K & ->) | (p & q & P & Q & Sp & Sq & ->)]; cbn [OfCorners]; auto.
Qed.

Lemma StuffedModerate th sign cut corners : AtMostHalf th -> CutsOnEdges sign cut ->
  Moderate sign (WarpVertex th sign cut) cut corners.
Proof.
  intros half on. split.
  - intros v d t _ W. destruct (WarpedMeans th sign cut v d t W) as (-> & O & L).
    pose proof (CutFromInRange sign cut on v d O) as R.
    specialize (half (DirectionKind d)). lia.
  - intros p q (_ & _ & P & Q).
    apply on; eapply (SignBefore th sign cut); eassumption || discriminate.
Qed.

(** What [VolumesFit] asks of a tetrahedron. *)
Definition IsNarrow (t : UnstructuredTet Coord3) : Prop :=
  match t with
    UT _ a b c d =>
      Bounded (4 * Steps) (Difference a b) /\
      Bounded (4 * Steps) (Difference a c) /\
      Bounded (4 * Steps) (Difference a d)
  end.

Theorem TetsNarrow th sign cut : AtMostHalf th -> CutsOnEdges sign cut ->
  forall tid t,
    t = WarpedTet th sign cut tid \/ In t (StuffedTets th sign cut tid) ->
    IsNarrow t.
Proof.
  intros half on tid t.
  pose proof (PlacedNarrow sign (WarpVertex th sign cut) cut 2 (Corners tid)
    (CornersNoWider tid) (StuffedModerate th sign cut (Corners tid) half on)) as N.
  intros [-> | I].
  - revert N. unfold WarpedTet, Corners. destruct tid as [anchor c].
    destruct (GetStructuredTet (STId anchor c)) as [v1 v2 v3 v4 n1 n2 n3 n4].
    intros N. destruct (CaseHandedness c); cbn [Orient MapTet IsNarrow];
      repeat split; apply (N (Corner _) (Corner _)); cbn [OfCorners In]; tauto.
  - unfold StuffedTets in I. apply in_map_iff in I. destruct I as (u & <- & I).
    rewrite StuffedByName in I.
    pose proof (fun m => PlacedOfCorners _ _ tid u m I) as M.
    destruct u as [a b c d]. cbn [MapTet IsNarrow].
    repeat split; apply N; apply M; cbn [In TetCorners]; tauto.
Qed.

Theorem BisectedTetsNarrow th sign domain : AtMostHalf th ->
  forall tid t,
    t = WarpedTet th sign (BisectedCuts domain) tid \/
    In t (StuffedTets th sign (BisectedCuts domain) tid) ->
    IsNarrow t.
Proof.
  intros half tid t. exact (TetsNarrow _ _ _ half (BisectedOnEdges _ _) tid t).
Qed.

Theorem MidpointTetsNarrow sign tid t :
  t = WarpedTet NoWarpThresholds (Decided sign) MidpointCuts tid \/
  In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) ->
  IsNarrow t.
Proof.
  assert (half : AtMostHalf NoWarpThresholds) by (intros []; vm_compute; discriminate).
  exact (TetsNarrow _ _ _ half (MidpointOnEdges _) tid t).
Qed.

(** ** The door *)

Theorem DoorSuffices low cells :
  InType 32 low -> InType 32 cells ->
  Fits 64 (DoorFormula low cells) /\
  (- AnchorLimit <= low -> Value (DoorFormula low cells) <= AnchorLimit ->
   forall i shift grid,
     0 <= i < cells -> - 1 <= shift <= 1 -> 0 <= grid <= 1 ->
     Fits 32 (LatticePointFormula low i shift grid) /\
     - LatticeLimit <= Value (LatticePointFormula low i shift grid)
       <= LatticeLimit).
Proof.
  unfold DoorFormula, LatticePointFormula. intros L C. split.
  - reckon. lia.
  - intros. reckon. lia.
Qed.

Theorem TilingCornersInRange (T : Tiling) reach (id : Identifier T) v :
  TilingReaches reach T -> reach <= LatticeLimit - AnchorLimit ->
  Bounded AnchorLimit (AnchorOf id) -> In v (VerticesOf T id) ->
  Bounded LatticeLimit v.
Proof.
  intros R L B I k. unfold VerticesOf in I. apply in_map_iff in I.
  destruct I as (i & <- & _). specialize (R id i k). specialize (B k).
  destruct (AnchorOf id), (VertexOf id i), k; cbn [Along Difference] in *; lia.
Qed.

Theorem CornersInRange anchor case v :
  Bounded AnchorLimit anchor -> In v (Corners (STId anchor case)) ->
  Bounded LatticeLimit v.
Proof.
  rewrite CornersAreVertices.
  apply (TilingCornersInRange LatticeTiling 3 (STId anchor case) v LatticeReaches).
  discriminate.
Qed.
