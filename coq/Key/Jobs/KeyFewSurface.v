(** Thresholds (64/256, 95/256), sign patterns with at most one corner on the
    surface: all that have cuts to put in order. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Cases.Configurations Key.KeyStuffing
  Key.KeyConfigurations.
Open Scope Z_scope.

Lemma KeyFewSurface :
  CheckOrderedRepresentatives KeyAngles (RangesOf KeyThresholds)
    (fun n => n <? 2) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
