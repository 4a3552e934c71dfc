(** Thresholds (64/256, 95/256), sign patterns with at least two corners on the
    surface. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Cases.Configurations Key.KeyStuffing
  Key.KeyConfigurations.
Open Scope Z_scope.

Lemma KeyManySurface :
  CheckOrderedRepresentatives KeyAngles (RangesOf KeyThresholds)
    (fun n => 2 <=? n) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
