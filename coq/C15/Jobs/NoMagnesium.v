(** Kind C. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import C15.C15Tet C15.C15Stuffing C15.C15AnglesSpec
  C15.C15Configurations.
Open Scope Z_scope.

Lemma NoMagnesium :
  CheckC15Case Tet_C1 C15KeyAngles C15KeyThresholds (fun _ => true) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
