(** Thresholds (64/256, 105/256), sign patterns with three or four corners on
    the surface. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Cases.Configurations.
Open Scope Z_scope.

Lemma EmbeddingManySurface :
  CheckRepresentatives GetUnstructuredTets EmbeddingAngles (RangesOf EmbeddingThresholds)
    (fun n => 3 <=? n) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
