(** * The octree of a mesh is one: proof *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Mesh.Method.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet
  Grading.Surface Grading.GradingSpec.
From Certet Require Import Grading.FlagProof.
Open Scope Z_scope.

Lemma FourOf n : -1 <= n <= 2 -> In n [-1; 0; 1; 2].
Proof.
  intros B. assert (n = -1 \/ n = 0 \/ n = 1 \/ n = 2) as [-> | [-> | [-> | ->]]] by lia;
    cbn; tauto.
Qed.

Lemma InAround x y z :
  -1 <= x <= 2 -> -1 <= y <= 2 -> -1 <= z <= 2 ->
  0 <= x <= 1 \/ 0 <= y <= 1 \/ 0 <= z <= 1 ->
  In (C3 x y z) AroundChildren.
Proof.
  intros X Y Z W. apply filter_In. split.
  - apply in_flat_map. exists x. split; [now apply FourOf|].
    apply in_flat_map. exists y. split; [now apply FourOf|].
    apply in_map, FourOf, Z.
  - cbv zeta. rewrite !orb_true_iff, !andb_true_iff, !Z.leb_le. tauto.
Qed.

Lemma OneOfZero x y z : x * y * z = 0 -> x = 0 \/ y = 0 \/ z = 0.
Proof. intros H. apply Z.mul_eq_0 in H as [H | H]; [apply Z.mul_eq_0 in H|]; tauto. Qed.

Theorem OctreeAroundIsOctree :
  forall first levels, IsOctree (OctreeAround first levels).
Proof.
  intros first levels. split.
  - intros level c step W E. unfold OctreeAround in *. apply orb_prop in E.
    apply orb_true_iff. destruct E as [E | E].
    + left. apply Nat.leb_le in E. apply Nat.leb_le. lia.
    + right. cbn [ClosedCells]. apply existsb_exists.
      exists (Difference (Scale 2 (ParentCell (Translate c step))) c).
      destruct c as [x y z], step as [dx dy dz].
      cbn [Translate ParentCell Scale Difference WithinFaceOrEdge] in *.
      destruct W as (X & Y & Z & D). apply OneOfZero in D. split.
      * apply InAround; euclid.
      * rewrite <- E. do 2 f_equal; ring.
  - exists levels. intros c. unfold OctreeAround. now rewrite Nat.leb_refl.
Qed.

Theorem GradedOctreeIsOctree :
  forall sign levels, IsOctree (GradedOctree sign levels).
Proof. intros. apply OctreeAroundIsOctree. Qed.

Theorem GradedOctreeKeepsSurface :
  forall sign levels, KeepsSurface sign (GradedOctree sign levels).
Proof.
  intros sign levels c N. unfold GradedOctree, OctreeAround. cbn [ClosedCells].
  rewrite N. apply orb_true_r.
Qed.
