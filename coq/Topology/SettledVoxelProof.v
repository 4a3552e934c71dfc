(** * The pieces of a label image and of the mesh that keeps the shape: proof *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Embedding.LeavingProof Embedding.SettledMeshProof
  Topology.VoxelProof Topology.VoxelMeshProof.
Open Scope Z_scope.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpVertex Settle].

(** Samples of an image are + or -, so that opening changes none. *)
Lemma OpenPlus sample v : PlusBefore (OpenSigns sample) v <-> sample v = Plus.
Proof.
  unfold PlusBefore, OpenSigns. destruct (sample v); split; congruence.
Qed.

Lemma OpenJoined sample p q :
  Joined (PlusBefore (OpenSigns sample)) Adjacent p q <->
  Joined (fun v => sample v = Plus) Adjacent p q.
Proof. split; apply JoinedWider; intros v; apply OpenPlus. Qed.

Lemma PlusWasPlus before warping p :
  PlusAfter before warping p -> PlusBefore before p.
Proof.
  unfold PlusAfter, PlusBefore. cbn [PlacedSign].
  destruct (warping p); [tauto|discriminate].
Qed.

Lemma MadeOfLattice before warping p t : MadeAt before warping p t -> OfLattice p.
Proof. intros (tid & E & C & _). exact (CornerOfLattice tid p E C). Qed.

Theorem SettledVoxelPieces grid image th cut gap vs p q t u :
  let sign := OpenSigns (VoxelSigns grid image) in
  let warping := PlaceIn (Settle th sign cut gap vs) in
  FineEnough grid -> SameAsImage grid image sign warping p q t u.
Proof.
  intros sign warping F P Q T U.
  etransitivity;
    [exact (SettledPiecesKept th sign cut gap vs (OpenDecided _) p q t u P Q T U)|].
  etransitivity; [apply OpenJoined|].
  apply (VoxelPiecesKept grid image p q F);
    [exact (MadeOfLattice _ _ p t T)|exact (MadeOfLattice _ _ q u U)| |];
    apply OpenPlus, (PlusWasPlus sign warping); assumption.
Qed.

Theorem SettledVoxelNoPieceLost grid image th cut gap vs x :
  let sign := OpenSigns (VoxelSigns grid image) in
  let warping := PlaceIn (Settle th sign cut gap vs) in
  FineEnough grid -> image x = true -> HasPieceOf grid image sign warping x.
Proof.
  intros sign warping F X.
  destruct grid as [half [sx sy sz] [ox oy oz]]. pose proof F as (H & Fx & Fy & Fz).
  destruct (VoxelFound half sx sy sz ox oy oz H Fx Fy Fz x) as (a & b & c & O).
  assert (P : PlusBefore sign (EvenPoint a b c)).
  { apply OpenPlus, (EvenPlus half sx sy sz ox oy oz image a).
    rewrite <- O in X. exact X. }
  destruct (SettledNoPieceLost th sign cut gap vs (EvenPoint a b c) P
    (EvenInLattice a b c)) as (q & t & Q & T & J).
  exists q, t. split; [exact Q|]. split; [exact T|].
  rewrite <- O. apply (proj1 (OpenJoined _ _ _)) in J.
  exact (SamplesThenVoxels half sx sy sz ox oy oz image H Fx Fy Fz _ _ J).
Qed.
