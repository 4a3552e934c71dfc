(** * Any subset stays: the angles *)

From Coq Require Import ZArith Reals List Lra.
From Certet Require Import Lattice.Definitions Stencil.Definitions
  Warp.Definitions Stuffing.Definitions Angles.Definitions
  Embedding.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.Degrees.DegreesProof
  Embedding.RuledMeshProof Embedding.SettledMeshProof.

Theorem RuledBoundsInDegrees sign cut stays limit tid t : CutsOnEdges sign cut ->
  In t (WarpOrClamp AngleThresholds sign cut stays limit tid) ->
  WithinDegrees (1077 / 100) (16476 / 100) t.
Proof.
  intros C I. replace (16476 / 100)%R with (180 - 1524 / 100)%R by lra.
  exact (DegreesBounds _ _ _ _ _ Cotangent10_77 Cotangent15_24
           (RuledBounds sign cut stays limit C tid t I)).
Qed.

Theorem SettledBoundsInDegrees sample cut vs tids t : CutsOnEdges sample cut ->
  In t (SettledMesh AngleThresholds (OpenSigns sample) (OpenCuts sample cut)
          LevelGap vs tids) ->
  WithinDegrees (1077 / 100) (16476 / 100) t.
Proof.
  intros C I. replace (16476 / 100)%R with (180 - 1524 / 100)%R by lra.
  exact (DegreesBounds _ _ _ _ _ Cotangent10_77 Cotangent15_24
           (proj1 (SettledMeshHasItAll sample cut vs C) tids t I)).
Qed.
