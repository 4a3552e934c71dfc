(** * The angle bounds of diagonals by key, in degrees *)

From Coq Require Import Reals Lra.
From Certet Require Import Key.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.Degrees.DegreesProof
  Key.KeyBoundsProof.
Open Scope R_scope.

Lemma Cotangent11_18 : Cotangent (CotSq 179 7) (1118 / 100).
Proof. by_cosine (98102 / 100000). Qed.
Lemma Cotangent22_87 : Cotangent (CotSq 73 13) (2287 / 100).
Proof. by_cosine (92138 / 100000). Qed.

Lemma KeyInDegrees t : WellShaped KeyAngles t ->
  WithinDegrees (1118 / 100) (15713 / 100) t.
Proof.
  apply (DegreesBounds _ _ _ (2287 / 100) _ _ Cotangent11_18 Cotangent22_87). lra.
Qed.

Theorem KeyDihedralBoundsInDegrees tid before warping cut t :
  Admissible before warping cut KeyThresholds (Corners tid) ->
  In t (KeyTets before warping cut tid) ->
  WithinDegrees (1118 / 100) (15713 / 100) t.
Proof. intros A I. exact (KeyInDegrees t (KeyDihedralBounds tid _ _ _ A t I)). Qed.

Theorem KeyBoundsInDegrees sign cut tid t : CutsOnEdges sign cut ->
  In t (KeyStuffedTets KeyThresholds sign cut tid) ->
  WithinDegrees (1118 / 100) (15713 / 100) t.
Proof. intros C I. exact (KeyInDegrees t (KeyBounds sign cut tid t C I)). Qed.

Theorem KeyRuledBoundsInDegrees sign cut stays limit tid t : CutsOnEdges sign cut ->
  In t (KeyWarpOrClamp KeyThresholds sign cut stays limit tid) ->
  WithinDegrees (1118 / 100) (15713 / 100) t.
Proof. intros C I. exact (KeyInDegrees t (KeyRuledBounds sign cut stays limit tid t C I)). Qed.
