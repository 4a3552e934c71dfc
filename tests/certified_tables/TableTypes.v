(** * What a row of the C++ lattice table says *)

From Coq Require Import ZArith List.
From Certet Require Import Lattice.Coord3 Lattice.StructuredTet.

(** The four vertices, the four face neighbours each with its order as a
    permutation of 0 1 2 3, and the handedness; all for the anchor 0. *)
Definition LatticeRow : Type :=
  list Coord3 * list (StructuredTetId * list Z) * Handedness.
