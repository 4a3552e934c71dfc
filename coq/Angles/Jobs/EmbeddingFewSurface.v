(** Thresholds (64/256, 105/256), sign patterns with at most two corners on the
    surface. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Cases.Configurations.
Open Scope Z_scope.

Lemma EmbeddingFewSurface :
  CheckRepresentatives GetUnstructuredTets EmbeddingAngles (RangesOf EmbeddingThresholds)
    (fun n => n <? 3) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
