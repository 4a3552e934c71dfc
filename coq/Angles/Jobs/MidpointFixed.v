(** No warping, no corner on the surface, and every cut at its edge's middle:
    nothing slides. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Cases.Configurations.
Open Scope Z_scope.

Definition MidpointRanges : Ranges := {|
  MoveLimit := fun _ => 0; CutFrom := fun _ => 128; CutTo := fun _ => 128
|}.

Lemma MidpointFixed :
  CheckRepresentatives GetUnstructuredTets MidpointAngles MidpointRanges (fun n => n =? 0) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
