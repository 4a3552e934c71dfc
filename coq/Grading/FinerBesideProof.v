(** * A quarter, and the pyramid of a child beside it: proofs *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Mesh.Method.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet
  Grading.Surface Grading.GradingSpec.
From Certet Require Import Grading.FlagProof Grading.BalanceProof
  Grading.PartitionProof Grading.GradedVolumeProof
  Grading.FaceSeenProof.
Open Scope Z_scope.

Section Beside.
  Variable cells : CellSet.
  Hypothesis Balance : IsBalanced cells.

  Local Notation across := (FlagAcross cells).
  Local Notation present := (IsPresent cells).
  Local Notation kind := (KindAt cells).

  Lemma QuarterOf x : AcrossExists cells x = true -> FaceIsUsed cells x = true ->
    EdgeIsUsed cells x = true -> kind x = QuarterTet.
  Proof.
    unfold AcrossExists, FaceIsUsed, EdgeIsUsed, KindAt. now intros -> -> ->.
  Qed.

  Lemma PyramidOf x : AcrossExists cells x = false -> kind x = PyramidTet.
  Proof. unfold AcrossExists, KindAt. now intros ->. Qed.

  Lemma QuarterLevel x : kind x = QuarterTet -> exists l, LevelOf x = S l.
  Proof.
    intros K. pose proof (KindTells cells x) as T. rewrite K in T.
    destruct T as (_ & T & _). unfold FaceIsUsed in T.
    destruct (LevelOf x) as [|l]; [discriminate T | now exists l].
  Qed.

  (** A quarter, and the pyramid of a child beside it. *)
  Lemma FinerInCellThere x l : LevelOf x = S l ->
    (present (FinerInCell x) = true /\ kind (FinerInCell x) = PyramidTet) <->
    (present x = true /\ kind x = QuarterTet /\ present (OtherCorner x) = false).
  Proof.
    intros L. set (y := FinerInCell x).
    assert (Ly : LevelOf y = l) by now apply FinerInCellLevel.
    assert (Cy : forall i j k, CellSeen y i j k = ChildSeen x (1 + j) (1 - k) i)
      by (intros; now apply (CellByFinerInCell x l)).
    assert (H : forall i j k, HasChild cells (LevelOf x) (ChildSeen x i j k)
                = cells l (ChildSeen x i j k)) by (intros; now rewrite L).
    split.
    - intros [P K]. apply PresentTells in P. destruct P as [E _].
      pose proof (KindTells cells y) as A. rewrite K in A. unfold AcrossExists in A.
      rewrite Ly, Cy in E, A. change (1 + 0) with 1 in E, A. change (1 - 0) with 1 in E, A.
      rewrite <- H in E, A.
      destruct (FaceChild cells Balance x _ _ _ E ltac:(lia) ltac:(lia) ltac:(lia)) as [E0 E1].
      split; [|split].
      + now apply PresentTells.
      + apply QuarterOf; [exact E1 | |]; apply (Used _ _ _ _ _ _ _ _ E); lia.
      + apply not_true_is_false. intros Q. apply PresentCorner in Q. destruct Q. congruence.
    - intros (P & K & Q). pose proof (KindTells cells x) as T. rewrite K in T.
      apply PresentTells in P. destruct P as [E0 E].
      assert (F : HasChild cells (LevelOf x) (ChildSeen x 1 1 0) = true).
      { apply not_false_is_true. intros F. apply not_true_iff_false in Q. apply Q.
        now apply PresentCorner. }
      rewrite H in E, F.
      assert (A : AcrossExists cells y = false) by (unfold AcrossExists; now rewrite Ly, Cy).
      split; [|now apply PyramidOf]. apply PresentTells. rewrite Ly, Cy. split; [exact F|].
      apply not_true_is_false. intros G. rewrite <- Ly in G.
      apply (FaceChild cells Balance) in G; [|lia ..]. unfold AcrossExists in A.
      destruct G. congruence.
  Qed.

  Lemma FinerInOtherThere x l : LevelOf x = S l ->
    (present (FinerInOther x) = true /\ kind (FinerInOther x) = PyramidTet) <->
    (present x = true /\ kind x = QuarterTet /\ present (OtherCell x) = false).
  Proof.
    intros L. set (y := FinerInOther x).
    assert (Ly : LevelOf y = l) by now apply FinerInOtherLevel.
    assert (Cy : forall i j k, CellSeen y i j k = ChildSeen x (2 - i) (1 + j) (1 - k))
      by (intros; now apply (CellByFinerInOther x l)).
    assert (H : forall i j k, HasChild cells (LevelOf x) (ChildSeen x i j k)
                = cells l (ChildSeen x i j k)) by (intros; now rewrite L).
    split.
    - intros [P K]. apply PresentTells in P. destruct P as [E _].
      pose proof (KindTells cells y) as A. rewrite K in A. unfold AcrossExists in A.
      rewrite Ly, Cy in E, A. change (1 + 0) with 1 in E, A. change (1 - 0) with 1 in E, A.
      change (2 - 0) with 2 in E. change (2 - 1) with 1 in A.
      rewrite <- H in E, A.
      destruct (FaceChild cells Balance x _ _ _ E ltac:(lia) ltac:(lia) ltac:(lia)) as [E0 E1].
      split; [|split].
      + now apply PresentTells.
      + apply QuarterOf; [exact E1 | |]; apply (Used _ _ _ _ _ _ _ _ E); lia.
      + apply not_true_is_false. intros Q. apply PresentCell in Q. destruct Q. congruence.
    - intros (P & K & Q). pose proof (KindTells cells x) as T. rewrite K in T.
      destruct T as (E1 & _). unfold AcrossExists in E1.
      apply PresentTells in P. destruct P as [E0 E].
      assert (F : HasChild cells (LevelOf x) (ChildSeen x 2 1 1) = true).
      { apply not_false_is_true. intros F. apply not_true_iff_false in Q. apply Q.
        now apply PresentCell. }
      rewrite H in E, F.
      assert (A : AcrossExists cells y = false) by (unfold AcrossExists; now rewrite Ly, Cy).
      split; [|now apply PyramidOf]. apply PresentTells. rewrite Ly, Cy. split; [exact F|].
      apply not_true_is_false. intros G. rewrite <- Ly in G.
      apply (FaceChild cells Balance) in G; [|lia ..]. unfold AcrossExists in A.
      destruct G. congruence.
  Qed.

  (** The faces of the two. *)
  Lemma FinerInCellFace x l : LevelOf x = S l ->
    SameVertices (FaceSeen QuarterTet x First) (FaceSeen PyramidTet (FinerInCell x) Fourth).
  Proof.
    intros L. destruct (AheadInCell x l L) as (_ & E & C).
    cbn [FaceSeen]. unfold IsOffDiagonal. rewrite E, C. cbn [xorb].
    rewrite <- (SeenByFinerInCell x l 1 1 0 L), <- (SeenByFinerInCell x l 1 0 0 L),
      <- (SeenByFinerInCell x l 0 0 0 L).
    intros v; cbn; tauto.
  Qed.

  Lemma FinerInOtherFace x l : LevelOf x = S l ->
    SameVertices (FaceSeen QuarterTet x Fourth) (FaceSeen PyramidTet (FinerInOther x) Fourth).
  Proof.
    intros L. destruct (AheadInOther x l L) as (_ & E & C).
    cbn [FaceSeen]. unfold IsOffDiagonal. rewrite E, C. cbn [xorb].
    rewrite <- (SeenByFinerInOther x l 1 1 1 L), <- (SeenByFinerInOther x l 1 1 0 L),
      <- (SeenByFinerInOther x l 1 0 0 L).
    intros v; cbn; tauto.
  Qed.

  Lemma FinerInCellSides x l : LevelOf x = S l ->
    LiesBetween (FaceSeen QuarterTet x First) (ApexSeen QuarterTet x First)
      (ApexSeen PyramidTet (FinerInCell x) Fourth).
  Proof.
    intros L. cbn [FaceSeen ApexSeen].
    rewrite <- (SeenByFinerInCell x l 1 1 0 L), <- (SeenByFinerInCell x l 1 0 0 L),
      <- (SeenByFinerInCell x l 0 0 0 L), <- (SeenByFinerInCell x l 1 1 1 L).
    sides.
  Qed.

  Lemma FinerInOtherSides x l : LevelOf x = S l ->
    LiesBetween (FaceSeen QuarterTet x Fourth) (ApexSeen QuarterTet x Fourth)
      (ApexSeen PyramidTet (FinerInOther x) Fourth).
  Proof.
    intros L. cbn [FaceSeen ApexSeen].
    rewrite <- (SeenByFinerInOther x l 1 1 1 L), <- (SeenByFinerInOther x l 1 1 0 L),
      <- (SeenByFinerInOther x l 1 0 0 L), <- (SeenByFinerInOther x l 0 0 0 L).
    sides.
  Qed.

  Lemma NameApex x : PointSeen (WithCornerOffDiagonal x) 0 0 0 = PointSeen x 0 0 0.
  Proof.
    unfold WithCornerOffDiagonal. cbv zeta.
    destruct (IsOffDiagonal x); destruct (AheadAtEdge _); apex.
  Qed.

  Lemma NameFace x :
    SameVertices (FaceSeen PyramidTet x Fourth)
      (FaceSeen PyramidTet (WithCornerOffDiagonal x) Fourth).
  Proof.
    destruct (PyramidNameTells x) as [E C]. cbn [FaceSeen].
    assert (IsOffDiagonal (WithCornerOffDiagonal x) = true) as ->
      by (unfold IsOffDiagonal; now rewrite E, C).
    clear E C. unfold WithCornerOffDiagonal. cbv zeta.
    destruct (IsOffDiagonal x); destruct (AheadAtEdge _); shared.
  Qed.
End Beside.
