(** * The rank of an edge

    Long edges come first, then the short ones that lead along a diagonal from
    their even end, then the others.  In every structured tetrahedron opposite
    edges have the same rank, and the three edges at a corner have three.  The
    Parity Rule is the second rank before the third. *)

From Coq Require Import ZArith.
From Certet Require Import Lattice.Coord3.
Open Scope Z_scope.

Definition EdgeRank (a b : Coord3) : Z :=
  match Difference a b, a with
    C3 dx dy dz, C3 x _ _ =>
      if Z.even dx then 0
      else if Bool.eqb (Z.even x) (dx * dy * dz =? 1) then 1 else 2
  end.
