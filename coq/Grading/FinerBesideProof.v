(** * A quarter, and the pyramid of a child beside it: proofs *)

From Certet Require Import Grading.Definitions.
From Certet Require Import Grading.FlagProof Grading.BalanceProof
  Grading.PartitionProof Grading.GradedVolumeProof
  Grading.FaceSeenProof.
Open Scope Z_scope.

Section Beside.
  Variable cells : CellSet.
  Hypothesis Balance : IsBalanced cells.


  Lemma QuarterOf x : AcrossExists cells x = true -> FaceIsUsed cells x = true ->
    EdgeIsUsed cells x = true -> KindAt cells x = QuarterTet.
  Proof.
    unfold AcrossExists, FaceIsUsed, EdgeIsUsed, KindAt. now intros -> -> ->.
  Qed.

  Lemma PyramidOf x : AcrossExists cells x = false -> KindAt cells x = PyramidTet.
  Proof. unfold AcrossExists, KindAt. now intros ->. Qed.

  Lemma QuarterLevel x : KindAt cells x = QuarterTet -> exists l, LevelOf x = S l.
  Proof.
    intros K. pose proof (KindTells cells x) as T. rewrite K in T.
    destruct T as (_ & T & _). unfold FaceIsUsed in T.
    destruct (LevelOf x) as [|l]; [discriminate T | now exists l].
  Qed.

  (** A quarter, and the pyramid of a child that is in the way of the flag beside. *)
  Lemma FinerThere x y beside i k :
    LevelOf x = S (LevelOf y) -> 1 <= i <= 2 -> 0 <= k <= 1 ->
    CellSeen y 0 0 0 = ChildSeen x i 1 k -> CellSeen y 1 0 0 = ChildSeen x 1 1 1 ->
    (cells (LevelOf x) (CellSeen x 0 0 0) = true -> AcrossExists cells x = true ->
     IsPresent cells beside = true <->
     HasChild cells (LevelOf x) (ChildSeen x i 1 k) = false) ->
    (IsPresent cells y = true /\ KindAt cells y = PyramidTet) <->
    (IsPresent cells x = true /\ KindAt cells x = QuarterTet /\
     IsPresent cells beside = false).
  Proof.
    intros L Bi Bk C C' B.
    assert (H : forall c, HasChild cells (LevelOf x) c = cells (LevelOf y) c)
      by (intros; now rewrite L).
    split.
    - intros [P K]. apply PresentTells in P. destruct P as [E _].
      pose proof (KindTells cells y) as A. rewrite K in A. unfold AcrossExists in A.
      rewrite C, <- H in E. rewrite C', <- H in A.
      destruct (FaceChild cells Balance x _ _ _ E ltac:(lia) ltac:(lia) ltac:(lia)) as [E0 E1].
      split; [|split].
      + now apply PresentTells.
      + apply QuarterOf; [exact E1 | |]; apply (Used _ _ _ _ _ _ _ _ E); lia.
      + apply not_true_is_false. intros Q. apply (B E0 E1) in Q. congruence.
    - intros (P & K & Q). pose proof (KindTells cells x) as T. rewrite K in T.
      destruct T as (E1 & _). apply PresentTells in P. destruct P as [E0 E].
      assert (F : HasChild cells (LevelOf x) (ChildSeen x i 1 k) = true).
      { apply not_false_is_true. intros F. apply not_true_iff_false in Q. now apply Q, B. }
      rewrite H in E, F.
      assert (A : AcrossExists cells y = false) by (unfold AcrossExists; now rewrite C').
      split; [|now apply PyramidOf]. apply PresentTells. rewrite C. split; [exact F|].
      apply not_true_is_false. intros G.
      apply (FaceChild cells Balance) in G; [|lia ..]. unfold AcrossExists in A.
      destruct G. congruence.
  Qed.

  Lemma FinerInCellThere x l : LevelOf x = S l ->
    (IsPresent cells (FinerInCell x) = true /\ KindAt cells (FinerInCell x) = PyramidTet) <->
    (IsPresent cells x = true /\ KindAt cells x = QuarterTet /\
     IsPresent cells (OtherCorner x) = false).
  Proof.
    intros L. apply (FinerThere _ _ _ 1 0); try lia.
    - now rewrite (FinerInCellLevel x l).
    - apply (CellByFinerInCell x l 0 0 0 L).
    - apply (CellByFinerInCell x l 1 0 0 L).
    - intros E0 _. rewrite PresentCorner. tauto.
  Qed.

  Lemma FinerInOtherThere x l : LevelOf x = S l ->
    (IsPresent cells (FinerInOther x) = true /\ KindAt cells (FinerInOther x) = PyramidTet) <->
    (IsPresent cells x = true /\ KindAt cells x = QuarterTet /\
     IsPresent cells (OtherCell x) = false).
  Proof.
    intros L. apply (FinerThere _ _ _ 2 1); try lia.
    - now rewrite (FinerInOtherLevel x l).
    - apply (CellByFinerInOther x l 0 0 0 L).
    - apply (CellByFinerInOther x l 1 0 0 L).
    - intros _ E1. rewrite PresentCell. unfold AcrossExists in E1. tauto.
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
