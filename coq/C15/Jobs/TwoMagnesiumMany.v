(** Kind A, three or four corners on the surface. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import C15.C15Tet C15.C15Stuffing C15.C15AnglesSpec
  C15.C15Configurations.
Open Scope Z_scope.

Lemma TwoMagnesiumMany :
  CheckC15Case Tet_A01 C15KeyAngles C15KeyThresholds (fun n => 3 <=? n) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
