(** * Any subset stays: the angles *)

From Coq Require Import Reals.
From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.Degrees.DegreesProof
  Embedding.RuledMeshProof Embedding.SettledMeshProof.

Theorem RuledBoundsInDegrees sign cut stays limit tid t : CutsOnEdges sign cut ->
  In t (WarpOrClamp AngleThresholds sign cut stays limit tid) ->
  WithinDegrees (1077 / 100) (16476 / 100) t.
Proof.
  intros C I. apply WidestInDegrees.
  exact (RuledBounds sign cut stays limit C tid t I).
Qed.

Theorem SettledBoundsInDegrees sample cut vs tids t : CutsOnEdges sample cut ->
  In t (SettledMesh AngleThresholds (OpenSigns sample) (OpenCuts sample cut)
          LevelGap vs tids) ->
  WithinDegrees (1077 / 100) (16476 / 100) t.
Proof.
  intros C I. apply WidestInDegrees.
  exact (proj1 (SettledMeshHasItAll sample cut vs C) tids t I).
Qed.
