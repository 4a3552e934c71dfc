(** * What goes wrong otherwise: proofs *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Lattice.FaceProof Mesh.Method.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet
  Grading.Surface Grading.GradingSpec.
From Certet Require Import Grading.FlagProof Grading.PartitionProof
  Grading.GradedVolumeProof Grading.GradedNeighborProof.
Open Scope Z_scope.

(** ** Balance across faces alone *)

Lemma FaceBalancedIsBalanced : IsFaceBalanced FaceBalancedCells.
Proof.
  intros [|level] c step W E; [|reflexivity].
  cbn [FaceBalancedCells] in E. apply SamePoint in E. subst c.
  destruct step as [x y z]. cbn [WithinFace] in W.
  assert (x = 0 \/ x = 1 \/ x = -1) as [-> | [-> | ->]] by lia;
    assert (y = 0 \/ y = 1 \/ y = -1) as [-> | [-> | ->]] by lia;
    assert (z = 0 \/ z = 1 \/ z = -1) as [-> | [-> | ->]] by lia;
    try (exfalso; lia); reflexivity.
Qed.

Theorem FaceBalanceFails :
  IsFaceBalanced FaceBalancedCells /\ HasTop FaceBalancedCells /\
  exists tid i, InGradedMesh FaceBalancedCells tid /\
    forall j, ~ SameVertices (GradedFace tid i)
                  (GradedFace (GradedNeighbor FaceBalancedCells tid i) j).
Proof.
  split; [exact FaceBalancedIsBalanced|]. split; [now exists 2%nat|].
  exists (GTId PyramidTet (MakeFlag 1 (C3 (-1) 0 0) YXZ false true true)), Third.
  split; [split; vm_compute; reflexivity|].
  set (tid := GTId _ _).
  assert (I : In (GradedVertexAt tid Second) (GradedFace tid Third)) by (cbn; tauto).
  intros j S. apply S in I. revert I. destruct j; vm_compute; intuition discriminate.
Qed.

(** ** The other diagonal *)

Theorem FlippedPyramidFails :
  forall cells tid j,
    IsOctree cells -> InGradedMesh cells tid -> KindOfName tid = PyramidTet ->
    ~ SameVertices (GradedFace (FlippedPyramid tid) Fourth)
        (GradedFace (GradedNeighbor cells tid Fourth) j).
Proof.
  intros cells [kind x] j octree M K S. cbn [KindOfName] in K. subst kind.
  destruct (NeighborMeets cells _ Fourth octree M) as (_ & j' & F & D & _).
  set (n := GradedNeighbor _ _ _) in *.
  assert (I : In (PointSeen x 1 (-1) (-1)) (GradedFace n j)).
  { apply S. unfold GradedFace, GradedVertexAt. cbn [FlippedPyramid GradedVertices Others Pick].
    rewrite !SeenByCorner. cbn; tauto. }
  assert (J : In (PointSeen x 1 (-1) (-1)) (GradedFace n j') \/
              PointSeen x 1 (-1) (-1) = GradedVertexAt n j').
  { revert I. unfold GradedFace. destruct j, j'; cbn; intuition auto. }
  assert (face : forall v, In v (GradedFace (GTId PyramidTet x) Fourth) <->
    In v [PointSeen x 1 1 1; PointSeen x 1 1 (-1); PointSeen x 1 (-1) 1])
    by (intros v; reflexivity).
  destruct J as [J | J].
  - apply F, face in J. cbn [In] in J.
    destruct J as [J | [J | [J | []]]]; apply SeenInjective in J; lia.
  - rewrite <- J in D.
    pose proof (D (PointSeen x 1 1 1) (PointSeen x 1 1 (-1)) (PointSeen x 1 (-1) 1)) as V.
    rewrite (VolumeSeen x 1 1 1 1 1 (-1) 1 (-1) 1 1 (-1) (-1)) in V.
    change (SixVolume (C3 1 1 1) (C3 1 1 (-1)) (C3 1 (-1) 1) (C3 1 (-1) (-1))) with 0 in V.
    rewrite Z.mul_0_r, Z.mul_0_r in V. enough (0 < 0) by lia.
    apply V; try (apply face; cbn [In]; tauto);
      intros E; apply SeenInjective in E; lia.
Qed.
