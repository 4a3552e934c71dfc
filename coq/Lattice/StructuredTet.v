(** * Structured tetrahedra

    The tetrahedra of the BCC lattice, twelve for each even reference point.
    [v1 v2] is the long edge between even points, [v3 v4] the long edge between
    odd points; the other four edges are short.  Each tetrahedron knows its
    four face neighbours, the i-th being the one across from the i-th vertex,
    and for each of them the order that lines its vertices up with its own.
    Section 3.1 of the paper. *)

From Coq Require Import ZArith.
From Certet Require Import Lattice.Coord3.
Open Scope Z_scope.

Inductive StructuredTetCase :=
  Tet_I1 | Tet_I2 | Tet_I3 | Tet_I4 |
  Tet_J1 | Tet_J2 | Tet_J3 | Tet_J4 |
  Tet_K1 | Tet_K2 | Tet_K3 | Tet_K4.

(** The reference point of the lattice cube, and one of the twelve cases. *)
Inductive StructuredTetId :=
  STId : Coord3 -> StructuredTetCase -> StructuredTetId.

Definition VertexOrder : Type :=
  Coord3 -> Coord3 -> Coord3 -> Coord3 ->
  (Coord3 * Coord3 * Coord3 * Coord3).

Inductive StructuredTet :=
  ST : Coord3 -> Coord3 -> Coord3 -> Coord3 ->
       StructuredTetId * VertexOrder ->
       StructuredTetId * VertexOrder ->
       StructuredTetId * VertexOrder ->
       StructuredTetId * VertexOrder ->
       StructuredTet.

(** The two orders that the lattice needs. *)
Definition Order1234 : VertexOrder := fun a b c d => (a, b, c, d).
Definition Order2143 : VertexOrder := fun a b c d => (b, a, d, c).

(** A solver wants every tetrahedron right-handed (positive volume); half of
    the cases are, the others are mirrored. *)
Inductive Handedness := RightHanded | LeftHanded.

Definition CaseHandedness (case : StructuredTetCase) : Handedness :=
  match case with
  | Tet_I1 | Tet_I4 | Tet_J2 | Tet_J3 | Tet_K1 | Tet_K4 => RightHanded
  | Tet_I2 | Tet_I3 | Tet_J1 | Tet_J4 | Tet_K2 | Tet_K3 => LeftHanded
  end.

Definition GetStructuredTet (tid : StructuredTetId) : StructuredTet :=
  let '(STId anchor case) := tid in
  let v x y z := Translate anchor (C3 x y z) in
  let nei x y z c := STId (v x y z) c in
  match case with
  | Tet_I1 =>
      ST (v 0 2 2) (v 2 2 2) (v 1 3 1) (v 1 3 3)
        (nei 0 2 0 Tet_J4, Order2143)
        (nei (-2) 2 0 Tet_J1, Order1234)
        (nei 0 0 0 Tet_I3, Order1234)
        (nei 0 0 0 Tet_I2, Order1234)
  | Tet_I2 =>
      ST (v 0 2 2) (v 2 2 2) (v 1 3 1) (v 1 1 1)
        (nei 0 0 0 Tet_K4, Order1234)
        (nei (-2) 0 0 Tet_K1, Order2143)
        (nei 0 0 0 Tet_I4, Order1234)
        (nei 0 0 0 Tet_I1, Order1234)
  | Tet_I3 =>
      ST (v 0 2 2) (v 2 2 2) (v 1 1 3) (v 1 3 3)
        (nei 0 0 2 Tet_K4, Order2143)
        (nei (-2) 0 2 Tet_K1, Order1234)
        (nei 0 0 0 Tet_I1, Order1234)
        (nei 0 0 0 Tet_I4, Order1234)
  | Tet_I4 =>
      ST (v 0 2 2) (v 2 2 2) (v 1 1 3) (v 1 1 1)
        (nei 0 0 0 Tet_J4, Order1234)
        (nei (-2) 0 0 Tet_J1, Order2143)
        (nei 0 0 0 Tet_I2, Order1234)
        (nei 0 0 0 Tet_I3, Order1234)
  | Tet_J1 =>
      ST (v 2 0 2) (v 2 2 2) (v 3 1 1) (v 3 1 3)
        (nei 2 0 0 Tet_I4, Order2143)
        (nei 2 (-2) 0 Tet_I1, Order1234)
        (nei 0 0 0 Tet_J3, Order1234)
        (nei 0 0 0 Tet_J2, Order1234)
  | Tet_J2 =>
      ST (v 2 0 2) (v 2 2 2) (v 3 1 1) (v 1 1 1)
        (nei 0 0 0 Tet_K2, Order1234)
        (nei 0 (-2) 0 Tet_K3, Order2143)
        (nei 0 0 0 Tet_J4, Order1234)
        (nei 0 0 0 Tet_J1, Order1234)
  | Tet_J3 =>
      ST (v 2 0 2) (v 2 2 2) (v 1 1 3) (v 3 1 3)
        (nei 0 0 2 Tet_K2, Order2143)
        (nei 0 (-2) 2 Tet_K3, Order1234)
        (nei 0 0 0 Tet_J1, Order1234)
        (nei 0 0 0 Tet_J4, Order1234)
  | Tet_J4 =>
      ST (v 2 0 2) (v 2 2 2) (v 1 1 3) (v 1 1 1)
        (nei 0 0 0 Tet_I4, Order1234)
        (nei 0 (-2) 0 Tet_I1, Order2143)
        (nei 0 0 0 Tet_J2, Order1234)
        (nei 0 0 0 Tet_J3, Order1234)
  | Tet_K1 =>
      ST (v 2 2 0) (v 2 2 2) (v 3 1 1) (v 3 3 1)
        (nei 2 0 0 Tet_I2, Order2143)
        (nei 2 0 (-2) Tet_I3, Order1234)
        (nei 0 0 0 Tet_K3, Order1234)
        (nei 0 0 0 Tet_K2, Order1234)
  | Tet_K2 =>
      ST (v 2 2 0) (v 2 2 2) (v 3 1 1) (v 1 1 1)
        (nei 0 0 0 Tet_J2, Order1234)
        (nei 0 0 (-2) Tet_J3, Order2143)
        (nei 0 0 0 Tet_K4, Order1234)
        (nei 0 0 0 Tet_K1, Order1234)
  | Tet_K3 =>
      ST (v 2 2 0) (v 2 2 2) (v 1 3 1) (v 3 3 1)
        (nei 0 2 0 Tet_J2, Order2143)
        (nei 0 2 (-2) Tet_J3, Order1234)
        (nei 0 0 0 Tet_K1, Order1234)
        (nei 0 0 0 Tet_K4, Order1234)
  | Tet_K4 =>
      ST (v 2 2 0) (v 2 2 2) (v 1 3 1) (v 1 1 1)
        (nei 0 0 0 Tet_I2, Order1234)
        (nei 0 0 (-2) Tet_I3, Order2143)
        (nei 0 0 0 Tet_K2, Order1234)
        (nei 0 0 0 Tet_K3, Order1234)
  end.

Definition AllCases : list StructuredTetCase :=
  (Tet_I1 :: Tet_I2 :: Tet_I3 :: Tet_I4 ::
   Tet_J1 :: Tet_J2 :: Tet_J3 :: Tet_J4 ::
   Tet_K1 :: Tet_K2 :: Tet_K3 :: Tet_K4 :: nil)%list.
