(** * The angle bounds of diagonals by key, in degrees *)

From Coq Require Import Reals Lra.
From Certet Require Import Key.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.Degrees.DegreesProof
  Key.KeyBoundsProof.
Open Scope R_scope.

Lemma KeyInDegrees t : WellShaped KeyAngles t ->
  WithinDegrees (1118 / 100) (15713 / 100) t.
Proof. by_cosines (2287 / 100) (98102 / 100000) (92138 / 100000). Qed.

Theorem KeyDihedralBoundsInDegrees tid before warping cut t :
  Admissible before warping cut KeyThresholds (Corners tid) ->
  In t (KeyTets before warping cut tid) ->
  WithinDegrees (1118 / 100) (15713 / 100) t.
Proof. in_degrees KeyInDegrees KeyDihedralBounds. Qed.

Theorem KeyBoundsInDegrees sign cut tid t : CutsOnEdges sign cut ->
  In t (KeyStuffedTets KeyThresholds sign cut tid) ->
  WithinDegrees (1118 / 100) (15713 / 100) t.
Proof. in_degrees KeyInDegrees KeyBounds. Qed.

Theorem KeyRuledBoundsInDegrees sign cut stays limit tid t : CutsOnEdges sign cut ->
  In t (KeyWarpOrClamp KeyThresholds sign cut stays limit tid) ->
  WithinDegrees (1118 / 100) (15713 / 100) t.
Proof. in_degrees KeyInDegrees KeyRuledBounds. Qed.
