(** * The angle bounds of C15 with diagonals by key, in degrees *)

From Coq Require Import Reals Lra.
From Certet Require Import Key.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.Degrees.DegreesProof.
From Certet Require Import C15.C15Tet C15.C15Stuffing C15.C15AnglesSpec C15.C15WarpSpec
  C15.C15BoundsProof.
Open Scope R_scope.

Lemma C15InDegrees t : WellShaped C15KeyAngles t ->
  WithinDegrees (1440 / 100) (14932 / 100) t.
Proof. by_cosines (3068 / 100) (96858 / 100000) (86001 / 100000). Qed.

Theorem C15DihedralBoundsInDegrees :
  EachC15Tet (WithinDegrees (1440 / 100) (14932 / 100)).
Proof. unfold EachC15Tet. in_degrees C15InDegrees C15DihedralBounds. Qed.

Theorem C15BoundsInDegrees : EachWarpedC15Tet (WithinDegrees (1440 / 100) (14932 / 100)).
Proof. exact (AfterWarping _ C15DihedralBoundsInDegrees). Qed.
