(** * Inside and outside of the warp that keeps the shape: proof *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Angles.AngleTheorems Embedding.SettleProof
  Embedding.SettledMeshProof Topology.TwoSidesFillProof
  Topology.TwoSidesMeetProof.
Open Scope Z_scope.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpVertex Settle].

Section Strict.
  Variables (sign : SignField) (cut : CutField) (vs : list Coord3).
  Hypothesis OnEdges : CutsOnEdges sign cut.

  Let warping := PlaceIn (Settle AngleThresholds sign cut StrictGap vs).
  Let place := PlacedPosition warping (ClampedCut AngleThresholds cut).

  Lemma StrictMoves : MovesAtMost AngleThresholds warping.
  Proof.
    apply SettledMovesAtMost;
      [exact AngleThresholdsAtMostHalf|exact OnEdges|intros s s'; discriminate].
  Qed.

  Lemma StrictUncrossed : Uncrossed warping.
  Proof.
    apply (SettledApproach AngleThresholds sign cut StrictGap 1 vs).
    intros s s'. discriminate.
  Qed.

  Theorem SettledTwoSidesFill n x : 0 < n ->
    exists tid t w, InLattice tid /\ OneOf sign warping tid t /\ NonNegative w /\ 0 < Total w /\
      Scale n (PointOf w (MapTet place t)) = Scale (Total w) x.
  Proof.
    exact (TwoSidesFill sign warping (ClampedCut AngleThresholds cut)
      (SettledInside sign cut StrictGap vs) n x StrictMoves StrictUncrossed).
  Qed.

  Theorem SettledTwoSidesMeet tid tid' t t' : InLattice tid -> InLattice tid' ->
    In t (PlacedNames sign warping tid) -> In t' (OtherNames sign warping tid') ->
    MeetInSharedVertices place t t'.
  Proof.
    exact (TwoSidesMeet sign warping (ClampedCut AngleThresholds cut)
      (SettledInside sign cut StrictGap vs) tid tid' t t'
      StrictMoves StrictUncrossed).
  Qed.
End Strict.
