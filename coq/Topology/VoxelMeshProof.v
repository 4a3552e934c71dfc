(** * The pieces of a label image and of its mesh: proof *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Embedding.DiskPiecesProof Topology.VoxelProof.
Open Scope Z_scope.

Local Strategy 1000 [WarpVertex Settled StrictDisk].

(** ** An image with finitely many voxels has finitely many samples *)

(** The points along an axis that voxel [i] may have. *)
Definition Candidates (half s o i : Z) : list Z :=
  map (fun k => (i * s - o) / half + Z.of_nat k) (seq 0 (Z.to_nat (s / half + 3))).

Lemma InCandidates half s o x : 0 < half -> 0 < s ->
  In x (Candidates half s o ((o + half * x) / s)).
Proof.
  intros H S. set (i := (o + half * x) / s). unfold Candidates.
  pose proof (Z.div_mod (o + half * x) s ltac:(lia)) as D. fold i in D.
  pose proof (Z.mod_pos_bound (o + half * x) s ltac:(lia)) as M.
  pose proof (Z.div_mod (i * s - o) half ltac:(lia)) as E.
  pose proof (Z.mod_pos_bound (i * s - o) half ltac:(lia)) as N.
  set (lo := (i * s - o) / half) in *.
  pose proof (Z.div_mod s half ltac:(lia)) as F.
  pose proof (Z.mod_pos_bound s half ltac:(lia)) as G.
  set (n := s / half) in *.
  assert (L : lo <= x) by nia. assert (U : x < lo + n + 3) by nia.
  apply in_map_iff. exists (Z.to_nat (x - lo)). split; [lia|].
  apply in_seq. lia.
Qed.

Lemma FiniteSamples grid image voxels : FineEnough grid ->
  (forall x, image x = true -> In x voxels) ->
  exists all, forall v, VoxelSigns grid image v = Plus -> In v all.
Proof.
  destruct grid as [half [sx sy sz] [ox oy oz]]. intros (H & X & Y & Z') F.
  exists (flat_map (fun voxel => match voxel with
    C3 i j k =>
      map (fun xyz => C3 (fst (fst xyz)) (snd (fst xyz)) (snd xyz))
        (list_prod (list_prod (Candidates half sx ox i) (Candidates half sy oy j))
           (Candidates half sz oz k)) end) voxels).
  intros v P. apply in_flat_map. exists (Owner (Grid half (C3 sx sy sz) (C3 ox oy oz)) v).
  split; [apply F; exact (PlusInside half sx sy sz ox oy oz image v P)|].
  destruct v as [x y z]. cbn [Owner]. apply in_map_iff. exists ((x, y), z).
  split; [reflexivity|]. rewrite !in_prod_iff.
  repeat split; apply InCandidates; lia.
Qed.

(** ** Lattice points *)

Lemma CornerOfLattice tid p : InLattice tid -> In p (Corners tid) -> OfLattice p.
Proof.
  destruct tid as [[x y z] case]. intros ([a ->] & [b ->] & [c ->]) I.
  assert (E : forall t n, Z.Even (2 * t + 2 * n)) by (intros t n; exists (t + n); ring).
  assert (O : forall t n, Z.Even (2 * t + (2 * n + 1) + 1))
    by (intros t n; exists (t + n + 1); ring).
  assert (Even : forall l m n,
    OfLattice (Translate (C3 (2 * a) (2 * b) (2 * c)) (C3 (2 * l) (2 * m) (2 * n))))
    by (intros; left; repeat split; apply E).
  assert (Odd : forall l m n, OfLattice (Translate (C3 (2 * a) (2 * b) (2 * c))
    (C3 (2 * l + 1) (2 * m + 1) (2 * n + 1))))
    by (intros; right; repeat split; apply O).
  destruct case; cbn [Corners GetStructuredTet In] in I;
    destruct I as [<-|[<-|[<-|[<-|[]]]]];
    first [exact (Even 0 1 1) | exact (Even 1 1 1) | exact (Even 1 0 1) | exact (Even 1 1 0)
          |exact (Odd 0 1 0) | exact (Odd 0 1 1) | exact (Odd 0 0 0) | exact (Odd 0 0 1)
          |exact (Odd 1 0 0) | exact (Odd 1 0 1) | exact (Odd 1 1 0)].
Qed.

Lemma EvenInLattice a b c :
  exists tid, InLattice tid /\ In (EvenPoint a b c) (Corners tid).
Proof.
  exists (STId (C3 (2 * (a - 1)) (2 * (b - 1)) (2 * (c - 1))) Tet_I1).
  split; [repeat split; eexists; reflexivity|].
  cbn [Corners GetStructuredTet In]. right; left. unfold EvenPoint.
  cbn [Translate]. f_equal; lia.
Qed.

Lemma Decided grid image v : VoxelSigns grid image v <> OnSurface.
Proof.
  destruct v. unfold VoxelSigns. destruct (_ && _); discriminate.
Qed.

(** ** The mesh *)

(** The pieces of a mesh by faces are those of the image by faces, of the pieces at
    two points; *)
Definition SameAsImage grid image sign warping p q t u : Prop :=
  PlusAfter sign warping p -> PlusAfter sign warping q ->
  MadeAt sign warping p t -> MadeAt sign warping q u ->
  Joined (InMesh sign warping) ShareFace t u <->
  Joined (fun x => image x = true) Beside (Owner grid p) (Owner grid q).

(** and the mesh has the piece of a voxel. *)
Definition HasPieceOf grid image sign warping x : Prop :=
  exists q t, PlusAfter sign warping q /\ MadeAt sign warping q t /\
    Joined (fun y => image y = true) Beside x (Owner grid q).

Theorem VoxelMeshPieces grid image voxels th cut limit p q t u :
  let sign := VoxelSigns grid image in
  let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
  FineEnough grid -> (forall x, image x = true -> In x voxels) ->
  SameAsImage grid image sign warping p q t u.
Proof.
  intros sign warping F I P Q T U.
  destruct (FiniteSamples grid image voxels F I) as [all A].
  etransitivity;
    [exact (DiskPiecesKept th sign cut limit all p q t u (Decided grid image) A P Q T U)|].
  assert (L : forall p t, MadeAt sign warping p t -> OfLattice p).
  { intros x y (tid & E & C & _). exact (CornerOfLattice tid x E C). }
  assert (S : forall p, PlusAfter sign warping p -> sign p = Plus).
  { intros x X. unfold PlusAfter in X. cbn [PlacedSign] in X.
    destruct (warping x); [exact X|discriminate X]. }
  apply (VoxelPiecesKept grid image p q F);
    [exact (L p t T)|exact (L q u U)|exact (S p P)|exact (S q Q)].
Qed.

Theorem VoxelNoPieceLost grid image voxels th cut limit x :
  let sign := VoxelSigns grid image in
  let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
  FineEnough grid -> (forall y, image y = true -> In y voxels) -> image x = true ->
  HasPieceOf grid image sign warping x.
Proof.
  intros sign warping F I X.
  destruct (FiniteSamples grid image voxels F I) as [all A].
  destruct grid as [half [sx sy sz] [ox oy oz]]. pose proof F as (H & Fx & Fy & Fz).
  destruct (VoxelFound half sx sy sz ox oy oz H Fx Fy Fz x) as (a & b & c & O).
  assert (P : sign (EvenPoint a b c) = Plus).
  { apply (EvenPlus half sx sy sz ox oy oz image a). rewrite <- O in X. exact X. }
  destruct (DiskNoPieceLost th sign cut limit all (EvenPoint a b c) A P
    (EvenInLattice a b c)) as (q & t & Q & T & J).
  exists q, t. split; [exact Q|]. split; [exact T|].
  rewrite <- O.
  exact (SamplesThenVoxels half sx sy sz ox oy oz image H Fx Fy Fz _ _ J).
Qed.
