(** Thresholds (64/256, 105/256), sign patterns with three or four corners on
    the surface. *)

From Coq Require Import ZArith.
From Certet Require Import Stencil.UnstructuredTet.
From Certet Require Import Warp.Warp Angles.AnglesSpec Angles.Cases.Configurations.
Open Scope Z_scope.

Lemma EmbeddingManySurface :
  CheckRepresentatives GetUnstructuredTets EmbeddingAngles (RangesOf EmbeddingThresholds)
    (fun n => 3 <=? n) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
