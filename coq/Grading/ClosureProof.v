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
  forall asked levels, IsOctree (OctreeAround asked levels).
Proof.
  intros asked levels. split.
  - intros level c step W E. unfold OctreeAround in *. apply orb_prop in E.
    apply orb_true_iff. destruct E as [E | E].
    + left. apply Nat.leb_le in E. apply Nat.leb_le. lia.
    + right. cbn [ClosedCells]. apply orb_true_iff. right. apply existsb_exists.
      exists (Difference (Scale 2 (ParentCell (Translate c step))) c).
      destruct c as [x y z], step as [dx dy dz].
      cbn [Translate ParentCell Scale Difference WithinFaceOrEdge] in *.
      destruct W as (X & Y & Z & D). apply OneOfZero in D. split.
      * apply InAround; euclid.
      * rewrite <- E. do 2 f_equal; ring.
  - exists levels. intros c. unfold OctreeAround. now rewrite Nat.leb_refl.
Qed.

Theorem OctreeAroundHasAsked :
  forall asked levels level c,
    asked level c = true -> OctreeAround asked levels level c = true.
Proof.
  intros asked levels level c E. unfold OctreeAround. apply orb_true_iff. right.
  destruct level; cbn [ClosedCells]; rewrite E; reflexivity.
Qed.

(** The step from around a cell's children into the cell. *)
Definition Inward (n : Z) : Z := if n =? -1 then 1 else if n =? 2 then -1 else 0.

Lemma InwardTells n : In n [-1; 0; 1; 2] -> -1 <= Inward n <= 1 /\
  (forall c, (2 * c + n + Inward n) / 2 = c) /\ (0 <= n <= 1 -> Inward n = 0).
Proof.
  intros [<- | [<- | [<- | [<- | []]]]]; (split; [|split]);
    try (vm_compute; intuition discriminate);
    try (intros c; change (Inward (-1)) with 1 || change (Inward 0) with 0
           || change (Inward 1) with 0 || change (Inward 2) with (-1); euclid);
    try reflexivity; lia.
Qed.

Theorem OctreeAroundIsLeast :
  forall asked levels cells,
    IsBalanced cells ->
    (forall level c, (levels <= level)%nat -> cells level c = true) ->
    (forall level c, asked level c = true -> cells level c = true) ->
    forall level c, OctreeAround asked levels level c = true -> cells level c = true.
Proof.
  intros asked levels cells balance top has level c E. unfold OctreeAround in E.
  apply orb_prop in E. destruct E as [E | E]; [now apply top, Nat.leb_le|].
  revert c E. induction level as [|l IH]; intros c E; cbn [ClosedCells] in E; [now apply has|].
  apply orb_prop in E. destruct E as [E | E]; [now apply has|].
  apply existsb_exists in E. destruct E as (d & I & E). apply IH in E.
  apply filter_In in I. destruct I as [I W].
  apply in_flat_map in I. destruct I as (x & X & I).
  apply in_flat_map in I. destruct I as (y & Y & I).
  apply in_map_iff in I. destruct I as (z & <- & Z).
  destruct (InwardTells x X) as (Bx & Px & Zx), (InwardTells y Y) as (By & Py & Zy),
    (InwardTells z Z) as (Bz & Pz & Zz).
  cbv zeta in W. rewrite !orb_true_iff, !andb_true_iff, !Z.leb_le in W.
  assert (O : Inward x * Inward y * Inward z = 0)
    by (destruct W as [[W | W] | W]; [rewrite (Zx W) | rewrite (Zy W) | rewrite (Zz W)]; ring).
  pose proof (balance l _ (C3 (Inward x) (Inward y) (Inward z))
    (conj Bx (conj By (conj Bz O))) E) as P.
  destruct c as [a b e]. cbn [Translate Scale ParentCell] in P.
  rewrite Px, Py, Pz in P. exact P.
Qed.

Theorem GradedOctreeIsOctree :
  forall sign levels, IsOctree (GradedOctree sign levels).
Proof. intros. apply OctreeAroundIsOctree. Qed.

Theorem GradedOctreeKeepsSurface :
  forall sign levels, KeepsSurface sign (GradedOctree sign levels).
Proof.
  intros sign levels c N. unfold GradedOctree. apply OctreeAroundHasAsked, N.
Qed.
