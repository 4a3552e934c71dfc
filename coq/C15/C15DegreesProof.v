(** * The angle bounds of C15 with diagonals by key, in degrees *)

From Coq Require Import Reals Lra.
From Certet Require Import Key.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.Degrees.DegreesProof.
From Certet Require Import C15.C15Tet C15.C15Stuffing C15.C15AnglesSpec C15.C15WarpSpec
  C15.C15BoundsProof.
Open Scope R_scope.

Lemma Cotangent14_40 : Cotangent (CotSq 91 6) (1440 / 100).
Proof. by_cosine (96858 / 100000). Qed.
Lemma Cotangent30_68 : Cotangent (CotSq 71 25) (3068 / 100).
Proof. by_cosine (86001 / 100000). Qed.

Lemma C15InDegrees t : WellShaped C15KeyAngles t ->
  WithinDegrees (1440 / 100) (14932 / 100) t.
Proof.
  apply (DegreesBounds _ _ _ (3068 / 100) _ _ Cotangent14_40 Cotangent30_68). lra.
Qed.

Theorem C15DihedralBoundsInDegrees tid before warping cut t :
  C15Admissible before warping cut C15KeyThresholds (C15Corners tid) ->
  In t (C15Tets before warping cut tid) ->
  WithinDegrees (1440 / 100) (14932 / 100) t.
Proof. intros A I. exact (C15InDegrees t (C15DihedralBounds tid _ _ _ A t I)). Qed.

Theorem C15BoundsInDegrees sign cut tid t : CutsOnEdges sign cut ->
  In t (C15StuffedTets C15KeyThresholds sign cut tid) ->
  WithinDegrees (1440 / 100) (14932 / 100) t.
Proof. intros C I. exact (C15InDegrees t (C15Bounds sign cut tid t C I)). Qed.
