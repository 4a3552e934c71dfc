(** * The rank of an edge

    Long edges come first, then the short ones that lead along a diagonal from
    their even end, then the others.  In every structured tetrahedron opposite
    edges have the same rank, and the three edges at a corner have three.  The
    Parity Rule is the second rank before the third. *)

From Coq Require Import ZArith List.
From Certet Require Import Lattice.Coord3.
Open Scope Z_scope.

Definition EdgeRank (a b : Coord3) : Z :=
  match Difference a b, a with
    C3 dx dy dz, C3 x _ _ =>
      if Z.even dx then 0
      else if Bool.eqb (Z.even x) (dx * dy * dz =? 1) then 1 else 2
  end.

(** Of the cuts of the edges between these points those that share an end have
    different keys; ranks are such keys. *)
Definition KeysApart (key : Coord3 -> Coord3 -> Z) (corners : list Coord3) : Prop :=
  forall a b m, In a corners -> In b corners -> In m corners ->
    a <> b -> a <> m -> b <> m -> key a m <> key b m /\ key m a <> key m b.
