(** * Machine integers suffice: proof *)

From Coq Require Import ZArith List Lia.
From Certet Require Import Lattice.Coord3 Lattice.Direction.
From Certet Require Import Lattice.StructuredTet Stencil.UnstructuredTet.
From Certet Require Import Stencil.StencilSet Stencil.TriangleSpec.
From Certet Require Import Warp.Cut Warp.Warp Stuffing.Stuffing.
From Certet Require Import Stuffing.NameProof Stuffing.VerticesProof.
From Certet Require Import Stuffing.Domain.
From Certet Require Import Angles.Geometry Angles.AnglesSpec.
From Certet Require Import Angles.AdmissibleProof Angles.DomainProof.
From Certet Require Import Range.RangeSpec.
Import ListNotations.
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
  - WidthLimit <= e1 <= WidthLimit -> - WidthLimit <= e2 <= WidthLimit ->
  - WidthLimit <= e3 <= WidthLimit -> - WidthLimit <= e4 <= WidthLimit ->
  - WidthLimit <= e5 <= WidthLimit ->
  - 2 ^ 38 <= e2 * e3 <= 2 ^ 38 /\ - 2 ^ 38 <= e4 * e5 <= 2 ^ 38 /\
  - 2 ^ 58 <= e1 * (e2 * e3 - e4 * e5) <= 2 ^ 58.
Proof.
  unfold WidthLimit. intros F1 F2 F3 F4 F5.
  pose proof (ProductBound e2 e3 _ _ F2 F3) as P.
  pose proof (ProductBound e4 e5 _ _ F4 F5) as Q.
  replace (2 ^ 19 * 2 ^ 19) with (2 ^ 38) in * by reflexivity.
  split; [exact P|]. split; [exact Q|].
  replace (2 ^ 58) with (2 ^ 19 * 2 ^ 39) by reflexivity.
  apply ProductBound; [exact F1|].
  replace (2 ^ 39) with (2 ^ 38 + 2 ^ 38) by reflexivity. lia.
Qed.

Theorem VolumesFit a b c d :
  (forall p, In p [a; b; c; d] -> forall k, InType 32 (Along k p)) ->
  Bounded WidthLimit (Difference a b) -> Bounded WidthLimit (Difference a c) ->
  Bounded WidthLimit (Difference a d) ->
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
  change (2 ^ 38) with 274877906944 in *. change (2 ^ 58) with 288230376151711744 in *.
  generalize dependent (bx - ax); generalize dependent (by_ - ay);
    generalize dependent (bz - az); generalize dependent (cx - ax);
    generalize dependent (cy - ay); generalize dependent (cz - az);
    generalize dependent (dx - ax); generalize dependent (dy - ay);
    generalize dependent (dz - az).
  intros. split; (split; [repeat split; lia | ring]).
Qed.

(** ** The tetrahedra of the output are narrow *)

(** The least coordinates of a structured tetrahedron's corners. *)
Definition Least (tid : StructuredTetId) (k : Axis) : Z :=
  match GetStructuredTet tid with
    ST v1 v2 v3 v4 _ _ _ _ =>
      Z.min (Z.min (Along k v1) (Along k v2)) (Z.min (Along k v3) (Along k v4))
  end.

Lemma CornersNear tid v k :
  In v (Corners tid) -> Least tid k <= Along k v <= Least tid k + 2.
Proof.
  destruct tid as [[x y z] c]. unfold Corners, Least.
  destruct c; cbn [GetStructuredTet Translate In]; intros I;
    repeat (destruct I as [<- | I]; [destruct k; cbn [Along]; lia|]); destruct I.
Qed.

Section Narrow.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Hypothesis Hhalf : AtMostHalf th.
  Hypothesis Hcut : CutsOnEdges sign cut.
  Variable tid : StructuredTetId.

  (** Between one step of the lattice below the corners and one above. *)
  Let Near (p : Coord3) : Prop := forall k,
    Steps * (Least tid k - 1) <= Along k p <= Steps * (Least tid k + 3).

  Lemma CornerNear v :
    In v (Corners tid) -> Near (MeshPosition th sign cut (Corner v)).
  Proof.
    intros I k. pose proof (CornersNear tid v k I) as N.
    cbn [MeshPosition]. destruct (WarpVertex th sign cut v) as [|d t] eqn:W.
    - destruct v, k; cbn [WarpedPosition Scale Along] in *; rewrite StepsIs; lia.
    - destruct (WarpedMeans th sign cut v d t W) as (-> & O & L).
      pose proof (CutFromInRange sign cut Hcut v d O) as R.
      specialize (Hhalf (DirectionKind d)). revert L R.
      generalize (CutFrom sign cut v d). intros t L R.
      pose proof (ProductBound t (Along k (Offset d)) 32768 2 ltac:(rewrite StepsIs in *; lia)
                    (OffsetBound d k)) as P.
      rewrite AlongWarped, StepsIs in *. lia.
  Qed.

  Lemma CutNear p q :
    In p (Corners tid) -> In q (Corners tid) ->
    sign p = Plus -> sign q = Minus ->
    Near (MeshPosition th sign cut (Cut p q)).
  Proof.
    intros I J P Q k. pose proof (CornersNear tid p k I) as N.
    pose proof (CornersNear tid q k J) as M.
    pose proof (Hcut p q P Q) as T. cbn [MeshPosition]. rewrite AlongEdge.
    pose proof (ProductBound (cut p q) (Along k q - Along k p) 65536 2
                  ltac:(rewrite StepsIs in *; lia) ltac:(lia)).
    assert (0 <= (Steps - cut p q) * (Along k p - Least tid k)) by nia.
    assert (0 <= cut p q * (Along k q - Least tid k)) by nia.
    assert (0 <= (Steps - cut p q) * (Least tid k + 2 - Along k p)) by nia.
    assert (0 <= cut p q * (Least tid k + 2 - Along k q)) by nia.
    rewrite StepsIs in *. nia.
  Qed.

  Lemma StuffedNear t m :
    In t (StuffTet th sign cut tid) -> In m (TetCorners t) ->
    Near (MeshPosition th sign cut m).
  Proof.
    pose proof CornerNear as C. pose proof CutNear as D. revert C D.
    unfold StuffTet, Corners. destruct tid as [anchor c].
    destruct (GetStructuredTet (STId anchor c)) as [v1 v2 v3 v4 n1 n2 n3 n4].
    intros C D I J. apply in_map_iff in I. destruct I as (u & <- & I).
    apply OrientCorners in J.
    destruct (StencilVertices _ _ _ _ _ _ _ I J)
      as [(v & K & ->) | (p & q & P & Q & Sp & Sq & ->)].
    - apply C, K.
    - apply D; try assumption;
        (eapply SignBefore; [eassumption | discriminate]).
  Qed.

  Lemma NearNarrow p q : Near p -> Near q -> Bounded (4 * Steps) (Difference p q).
  Proof.
    intros P Q k. specialize (P k). specialize (Q k).
    replace (Along k (Difference p q)) with (Along k q - Along k p)
      by (destruct p, q, k; reflexivity).
    rewrite StepsIs in *. lia.
  Qed.

  Theorem TetsNarrow t :
    t = WarpedTet th sign cut tid \/ In t (StuffedTets th sign cut tid) ->
    match t with
      UT _ a b c d =>
        Bounded (4 * Steps) (Difference a b) /\
        Bounded (4 * Steps) (Difference a c) /\
        Bounded (4 * Steps) (Difference a d)
    end.
  Proof.
    intros [-> | I].
    - assert (C : forall p q, In p (Corners tid) -> In q (Corners tid) ->
        Bounded (4 * Steps)
          (Difference (MeshPosition th sign cut (Corner p))
             (MeshPosition th sign cut (Corner q))))
        by (intros; apply NearNarrow; apply CornerNear; assumption).
      revert C. unfold WarpedTet, Corners.
      destruct tid as [anchor c].
      destruct (GetStructuredTet (STId anchor c)) as [v1 v2 v3 v4 n1 n2 n3 n4].
      intros C. destruct (CaseHandedness c); cbn [Orient MapTet];
        repeat split; apply C; cbn [In]; tauto.
    - unfold StuffedTets in I. apply in_map_iff in I. destruct I as (u & <- & I).
      pose proof (StuffedNear u) as N. destruct u as [a b c d]. cbn [MapTet].
      repeat split; apply NearNarrow; apply (N _ I); cbn [In TetCorners]; tauto.
  Qed.
End Narrow.

Theorem BisectedTetsNarrow th sign domain : AtMostHalf th ->
  forall tid t,
    t = WarpedTet th sign (BisectedCuts domain) tid \/
    In t (StuffedTets th sign (BisectedCuts domain) tid) ->
    match t with
      UT _ a b c d =>
        Bounded (4 * Steps) (Difference a b) /\
        Bounded (4 * Steps) (Difference a c) /\
        Bounded (4 * Steps) (Difference a d)
    end.
Proof.
  intros half tid t. exact (TetsNarrow _ _ _ half (BisectedOnEdges _ _) tid t).
Qed.

Theorem MidpointTetsNarrow sign tid t :
  t = WarpedTet NoWarpThresholds (Decided sign) MidpointCuts tid \/
  In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) ->
  match t with
    UT _ a b c d =>
      Bounded (4 * Steps) (Difference a b) /\
      Bounded (4 * Steps) (Difference a c) /\
      Bounded (4 * Steps) (Difference a d)
  end.
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

Theorem CornersInRange anchor case v :
  Bounded AnchorLimit anchor -> In v (Corners (STId anchor case)) ->
  Bounded LatticeLimit v.
Proof.
  intros B I k. specialize (B k). destruct anchor as [x y z]. unfold Corners in I.
  destruct case; cbn [GetStructuredTet Translate In] in I;
    repeat (destruct I as [<- | I]; [destruct k; cbn [Along] in *; reckon; lia|]);
    destruct I.
Qed.
