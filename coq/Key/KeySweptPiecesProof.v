(** * The product's rule of who stays, with diagonals by key: its pieces *)

From Certet Require Import Key.Definitions.
From Certet Require Import Embedding.GreedyProof Embedding.LeavingProof
  Embedding.SettleProof Embedding.SettledMeshProof Topology.VoxelSpec
  Topology.VoxelProof Topology.VoxelMeshProof Topology.SettledVoxelProof
  Embedding.PiecesSpec Embedding.AroundProof Mesh.Method Mesh.MeshPiecesSpec
  Key.KeyPiecesProof.
Open Scope Z_scope.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpVertex Settle].

Theorem KeyMeshPieces before warping cut : NoWall before warping ->
  let mesh := KeyMesh before warping cut in
  PiecesAreThoseOf mesh (InsideMesh mesh).
Proof.
  intros N mesh p q t u.
  exact (PiecesByEdges _ _ (KeyJoinsWithin before warping cut) N p q t u).
Qed.

Section Swept.
  Variables (sample : SignField) (cut : CutField) (turns : list Coord3).
  Let sign := OpenSigns sample.
  Let mesh := KeySweptMesh sign cut turns.

  Theorem KeyPiecesKept : PiecesAreThoseOf mesh (PlusBefore sign).
  Proof.
    intros p q t u.
    exact (PiecesOfSamples _ _ _ (KeyJoinsWithin _ _ _)
      (SettledLeaves KeyThresholds sign cut LevelGap turns) p q t u
      (SettledMakesNoWall KeyThresholds sign cut LevelGap turns (OpenDecided sample))).
  Qed.

  Theorem KeyNoPieceLost p : PlusBefore sign p ->
    (exists tid, InLattice tid /\ In p (Corners tid)) ->
    exists q t, InsideMesh mesh q /\ MadeAround mesh q t /\
      Joined (PlusBefore sign) Adjacent p q.
  Proof.
    exact (NoSampleLost _ _ _ (KeyJoinsWithin _ _ _)
      (SettledLeaves KeyThresholds sign cut LevelGap turns) p).
  Qed.

  Theorem KeyOutsideKept p q : ~ PlusBefore sign p -> ~ PlusBefore sign q ->
    Joined (fun v => ~ InsideMesh mesh v) Adjacent p q <->
    Joined (fun v => ~ PlusBefore sign v) Adjacent p q.
  Proof. exact (SettledOutsideKept KeyThresholds sign cut LevelGap turns p q). Qed.

  Theorem KeyMakesNoCavity p : ~ InsideMesh mesh p ->
    exists q, ~ PlusBefore sign q /\
      Joined (fun v => ~ InsideMesh mesh v) Adjacent p q.
  Proof. exact (SettledMakesNoCavity KeyThresholds sign cut LevelGap turns p). Qed.
End Swept.

(** ** Of a label image *)

Section Image.
  Variables (grid : VoxelGrid) (image : Coord3 -> bool).
  Variables (cut : CutField) (turns : list Coord3).
  Let sign := OpenSigns (VoxelSigns grid image).
  Let mesh := KeySweptMesh sign cut turns.
  Hypothesis Fine : FineEnough grid.

  Lemma AroundOfLattice p t : MadeAround mesh p t -> OfLattice p.
  Proof. intros (tid & E & C & _). exact (CornerOfLattice tid p E C). Qed.

  Lemma InsideSampled p : InsideMesh mesh p -> VoxelSigns grid image p = Plus.
  Proof.
    intros P. apply OpenPlus.
    exact (PlusWasPlus sign (PlaceIn (Settle KeyThresholds sign cut LevelGap turns)) p P).
  Qed.

  Theorem KeyVoxelPieces p q t u : InsideMesh mesh p -> InsideMesh mesh q ->
    MadeAround mesh p t -> MadeAround mesh q u ->
    Joined (TetOf mesh) ShareFace t u <->
    Joined (fun x => image x = true) Beside (Owner grid p) (Owner grid q).
  Proof.
    intros P Q T U.
    etransitivity; [exact (KeyPiecesKept _ cut turns p q t u P Q T U)|].
    etransitivity; [apply OpenJoined|].
    apply (VoxelPiecesKept grid image p q Fine);
      [exact (AroundOfLattice p t T)|exact (AroundOfLattice q u U)| |];
      apply InsideSampled; assumption.
  Qed.

  Theorem KeyVoxelNoPieceLost x : image x = true ->
    exists q t, InsideMesh mesh q /\ MadeAround mesh q t /\
      Joined (fun y => image y = true) Beside x (Owner grid q).
  Proof.
    intros X. destruct grid as [half [sx sy sz] [ox oy oz]].
    pose proof Fine as (H & Fx & Fy & Fz).
    destruct (VoxelFound half sx sy sz ox oy oz H Fx Fy Fz x) as (a & b & c & <-).
    destruct (KeyNoPieceLost (VoxelSigns (Grid half (C3 sx sy sz) (C3 ox oy oz)) image)
      cut turns (EvenPoint a b c)) as (q & t & Q & T & J).
    - apply OpenPlus, (EvenPlus half sx sy sz ox oy oz image a). exact X.
    - apply EvenInLattice.
    - exists q, t. split; [exact Q|]. split; [exact T|].
      apply (proj1 (OpenJoined _ _ _)) in J.
      exact (SamplesThenVoxels half sx sy sz ox oy oz image H Fx Fy Fz _ _ J).
  Qed.
End Image.
