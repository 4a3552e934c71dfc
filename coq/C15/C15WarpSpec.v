(** * What warping is asked for in C15, and what it makes *)

From Certet Require Import Angles.Definitions.
From Certet Require Import C15.Sites C15.C15Tet C15.C15Stuffing.
Open Scope Z_scope.

(** No edge is short of both its ends. *)
Definition C15AtMostHalf (th : C15Thresholds) : Prop :=
  forall a b, th a b + th b a <= 256.

(** The tetrahedra of the output after warping, in steps. *)
Definition C15StuffedTets (th : C15Thresholds) (sign : SignField) (cut : CutField)
  (tid : C15TetId) : list (UnstructuredTet Coord3) :=
  C15Tets sign (C15WarpVertex th sign cut) cut tid.
