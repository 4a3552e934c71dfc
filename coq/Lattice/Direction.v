(** * The fourteen edges of a lattice vertex

    Six long edges join a vertex to its own grid (length 2), eight short ones
    to the other grid (length sqrt 3).  Opposite directions stand side by side
    in [AllDirections]; that order is also the one by which ties are broken. *)

From Coq Require Import ZArith List.
From Certet Require Import Lattice.Coord3.
Import ListNotations.
Open Scope Z_scope.

(** [Dir_pmp] goes up in x, down in y, up in z; [0] is no step. *)
Inductive Direction :=
  Dir_p00 | Dir_m00 | Dir_0p0 | Dir_0m0 | Dir_00p | Dir_00m |
  Dir_ppp | Dir_mmm | Dir_ppm | Dir_mmp |
  Dir_pmp | Dir_mpm | Dir_mpp | Dir_pmm.

Definition AllDirections : list Direction :=
  [Dir_p00; Dir_m00; Dir_0p0; Dir_0m0; Dir_00p; Dir_00m;
   Dir_ppp; Dir_mmm; Dir_ppm; Dir_mmp;
   Dir_pmp; Dir_mpm; Dir_mpp; Dir_pmm].

Definition Offset (d : Direction) : Coord3 :=
  match d with
  | Dir_p00 => C3 2 0 0 | Dir_m00 => C3 (-2) 0 0
  | Dir_0p0 => C3 0 2 0 | Dir_0m0 => C3 0 (-2) 0
  | Dir_00p => C3 0 0 2 | Dir_00m => C3 0 0 (-2)
  | Dir_ppp => C3 1 1 1 | Dir_mmm => C3 (-1) (-1) (-1)
  | Dir_ppm => C3 1 1 (-1) | Dir_mmp => C3 (-1) (-1) 1
  | Dir_pmp => C3 1 (-1) 1 | Dir_mpm => C3 (-1) 1 (-1)
  | Dir_mpp => C3 (-1) 1 1 | Dir_pmm => C3 1 (-1) (-1)
  end.

Inductive EdgeKind := Long | Short.

Definition DirectionKind (d : Direction) : EdgeKind :=
  match d with
  | Dir_p00 | Dir_m00 | Dir_0p0 | Dir_0m0 | Dir_00p | Dir_00m => Long
  | _ => Short
  end.

(** The square of an edge's length. *)
Definition LengthSquared (k : EdgeKind) : Z :=
  match k with Long => 4 | Short => 3 end.
