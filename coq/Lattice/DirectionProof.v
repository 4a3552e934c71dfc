(** * The way back along an edge *)

From Certet Require Import Lattice.Definitions.
Open Scope Z_scope.

Definition Backward (d : Direction) : Direction :=
  match d with
  | Dir_p00 => Dir_m00 | Dir_m00 => Dir_p00
  | Dir_0p0 => Dir_0m0 | Dir_0m0 => Dir_0p0
  | Dir_00p => Dir_00m | Dir_00m => Dir_00p
  | Dir_ppp => Dir_mmm | Dir_mmm => Dir_ppp
  | Dir_ppm => Dir_mmp | Dir_mmp => Dir_ppm
  | Dir_pmp => Dir_mpm | Dir_mpm => Dir_pmp
  | Dir_mpp => Dir_pmm | Dir_pmm => Dir_mpp
  end.

Lemma ThereAndBack v d :
  Translate (Translate v (Offset d)) (Offset (Backward d)) = v.
Proof. destruct v, d; cbn [Backward Translate Offset]; f_equal; ring. Qed.
