(** * Integer points of space

    A lattice point is three integers.  The body-centred cubic (BCC) lattice
    consists of the even points (three even coordinates) and the odd points
    (three odd coordinates); one unit is half of a long edge.  Section 3.1 of
    the paper. *)

From Coq Require Import ZArith.
Open Scope Z_scope.

Inductive Coord3 :=
  C3 : Z -> Z -> Z -> Coord3.

(** [Translate a b] is the vector sum. *)
Definition Translate (a b : Coord3) : Coord3 :=
  match a, b with
    C3 ax ay az, C3 bx by_ bz => C3 (ax + bx) (ay + by_) (az + bz)
  end.

(** [Scale n a] stretches a vector [n] times. *)
Definition Scale (n : Z) (a : Coord3) : Coord3 :=
  match a with C3 x y z => C3 (n * x) (n * y) (n * z) end.

(** [Difference a b] is the vector from [a] to [b]. *)
Definition Difference (a b : Coord3) : Coord3 :=
  match a, b with
    C3 ax ay az, C3 bx by_ bz => C3 (bx - ax) (by_ - ay) (bz - az)
  end.

Definition Coord3Equal (a b : Coord3) : bool :=
  match a, b with
    C3 ax ay az, C3 bx by_ bz => (ax =? bx) && (ay =? by_) && (az =? bz)
  end%bool.
