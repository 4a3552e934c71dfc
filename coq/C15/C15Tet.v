(** * The tetrahedra of C15

    Thirty-four for each primitive cell: every four vertices that are joined, each
    to each.  They are of three kinds, A with two vertices of magnesium and two of
    copper, B with one and three, and C with four of copper, which is regular.

    Each is told by its vertices, in a right-handed order with magnesium first, and
    by its four face neighbours: the i-th is across from the i-th vertex, in a cell
    so far away, and its vertices are lined up with the tetrahedron's own by the
    four places at which they stand in it. *)

From Certet Require Import Lattice.Definitions Lattice.Tiling C15.Sites.
Open Scope Z_scope.

Inductive C15Case :=
  Tet_A01 | Tet_A02 | Tet_A03 | Tet_A04 | Tet_A05 | Tet_A06 | Tet_A07 | Tet_A08 |
  Tet_A09 | Tet_A10 | Tet_A11 | Tet_A12 | Tet_A13 | Tet_A14 | Tet_A15 | Tet_A16 |
  Tet_A17 | Tet_A18 | Tet_A19 | Tet_A20 | Tet_A21 | Tet_A22 | Tet_A23 | Tet_A24 |
  Tet_B1 | Tet_B2 | Tet_B3 | Tet_B4 | Tet_B5 | Tet_B6 | Tet_B7 | Tet_B8 | Tet_C1 |
  Tet_C2.

Definition AllC15Cases : list C15Case :=
  [Tet_A01; Tet_A02; Tet_A03; Tet_A04; Tet_A05; Tet_A06; Tet_A07; Tet_A08; Tet_A09;
   Tet_A10; Tet_A11; Tet_A12; Tet_A13; Tet_A14; Tet_A15; Tet_A16; Tet_A17; Tet_A18;
   Tet_A19; Tet_A20; Tet_A21; Tet_A22; Tet_A23; Tet_A24; Tet_B1; Tet_B2; Tet_B3;
   Tet_B4; Tet_B5; Tet_B6; Tet_B7; Tet_B8; Tet_C1; Tet_C2].

(** The primitive cell, and one of the cases. *)
Inductive C15TetId := C15Id : Coord3 -> C15Case -> C15TetId.

(** A neighbour: the cell that it is in from that of the tetrahedron, its case, and
    the places of its vertices in the tetrahedron's order. *)
Inductive C15Neighbor :=
  Nei : Coord3 -> C15Case -> Place -> Place -> Place -> Place -> C15Neighbor.

(** Vertices as in the first cell, and neighbours. *)
Inductive C15Row :=
  Row : Coord3 -> Coord3 -> Coord3 -> Coord3 ->
        C15Neighbor -> C15Neighbor -> C15Neighbor -> C15Neighbor -> C15Row.

Definition C15RowOf (case : C15Case) : C15Row :=
  match case with
  | Tet_A01 =>
      Row (C3 0 0 0) (C3 (-2) (-2) 2) (C3 (-3) 1 1) (C3 (-3) (-1) (-1))
        (Nei (C3 0 0 (-1)) Tet_B5 Fourth First Second Third)
        (Nei (C3 0 0 0) Tet_A07 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A09 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A14 First Second Fourth Third)
  | Tet_A02 =>
      Row (C3 0 0 0) (C3 (-2) (-2) 2) (C3 1 (-3) 1) (C3 1 (-1) 3)
        (Nei (C3 0 1 (-1)) Tet_A08 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_B3 First Third Second Fourth)
        (Nei (C3 0 0 0) Tet_A10 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A13 First Second Fourth Third)
  | Tet_A03 =>
      Row (C3 0 0 0) (C3 2 (-2) (-2)) (C3 1 (-3) 1) (C3 (-1) (-3) (-1))
        (Nei (C3 (-1) 0 0) Tet_B6 Fourth First Second Third)
        (Nei (C3 0 0 0) Tet_A13 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A17 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A20 First Second Fourth Third)
  | Tet_A04 =>
      Row (C3 0 0 0) (C3 2 (-2) (-2)) (C3 1 1 (-3)) (C3 3 1 (-1))
        (Nei (C3 (-1) 0 1) Tet_A14 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_B1 First Third Second Fourth)
        (Nei (C3 0 0 0) Tet_A18 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A19 First Second Fourth Third)
  | Tet_A05 =>
      Row (C3 0 0 0) (C3 (-2) 2 (-2)) (C3 (-3) 1 1) (C3 (-1) 3 1)
        (Nei (C3 1 (-1) 0) Tet_A20 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_B2 First Third Second Fourth)
        (Nei (C3 0 0 0) Tet_A22 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A07 First Second Fourth Third)
  | Tet_A06 =>
      Row (C3 0 0 0) (C3 (-2) 2 (-2)) (C3 1 1 (-3)) (C3 (-1) (-1) (-3))
        (Nei (C3 0 (-1) 0) Tet_B7 Fourth First Second Third)
        (Nei (C3 0 0 0) Tet_A19 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A21 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A08 First Second Fourth Third)
  | Tet_A07 =>
      Row (C3 0 0 0) (C3 (-2) 2 (-2)) (C3 (-3) (-1) (-1)) (C3 (-3) 1 1)
        (Nei (C3 0 (-1) 0) Tet_B6 Third First Fourth Second)
        (Nei (C3 0 0 0) Tet_A01 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A05 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A21 First Second Fourth Third)
  | Tet_A08 =>
      Row (C3 0 0 0) (C3 (-2) 2 (-2)) (C3 1 3 (-1)) (C3 1 1 (-3))
        (Nei (C3 0 (-1) 1) Tet_A02 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_B1 First Fourth Third Second)
        (Nei (C3 0 0 0) Tet_A06 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A22 First Second Fourth Third)
  | Tet_A09 =>
      Row (C3 0 0 0) (C3 (-2) (-2) 2) (C3 (-3) (-1) (-1)) (C3 (-1) (-3) (-1))
        (Nei (C3 0 0 (-1)) Tet_A16 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_B4 First Third Second Fourth)
        (Nei (C3 0 0 0) Tet_A13 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A01 First Second Fourth Third)
  | Tet_A10 =>
      Row (C3 0 0 0) (C3 (-2) (-2) 2) (C3 1 (-1) 3) (C3 (-1) 1 3)
        (Nei (C3 0 0 (-1)) Tet_B8 Fourth First Second Third)
        (Nei (C3 0 0 0) Tet_A15 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A14 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A02 First Second Fourth Third)
  | Tet_A11 =>
      Row (C3 0 0 0) (C3 2 2 2) (C3 1 (-1) 3) (C3 3 (-1) 1)
        (Nei (C3 0 1 0) Tet_A21 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_B3 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A24 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A15 First Second Fourth Third)
  | Tet_A12 =>
      Row (C3 0 0 0) (C3 2 2 2) (C3 1 3 (-1)) (C3 (-1) 3 1)
        (Nei (C3 0 0 0) Tet_B5 Second First Third Fourth)
        (Nei (C3 0 0 0) Tet_A22 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A23 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A16 First Second Fourth Third)
  | Tet_A13 =>
      Row (C3 0 0 0) (C3 (-2) (-2) 2) (C3 (-1) (-3) (-1)) (C3 1 (-3) 1)
        (Nei (C3 0 0 (-1)) Tet_B7 Third First Fourth Second)
        (Nei (C3 0 0 0) Tet_A03 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A02 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A09 First Second Fourth Third)
  | Tet_A14 =>
      Row (C3 0 0 0) (C3 (-2) (-2) 2) (C3 (-1) 1 3) (C3 (-3) 1 1)
        (Nei (C3 1 0 (-1)) Tet_A04 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_B2 First Fourth Third Second)
        (Nei (C3 0 0 0) Tet_A01 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A10 First Second Fourth Third)
  | Tet_A15 =>
      Row (C3 0 0 0) (C3 2 2 2) (C3 (-1) 1 3) (C3 1 (-1) 3)
        (Nei (C3 0 0 0) Tet_B6 Second First Third Fourth)
        (Nei (C3 0 0 0) Tet_A10 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A11 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A23 First Second Fourth Third)
  | Tet_A16 =>
      Row (C3 0 0 0) (C3 2 2 2) (C3 3 1 (-1)) (C3 1 3 (-1))
        (Nei (C3 0 0 1) Tet_A09 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_B1 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A12 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A24 First Second Fourth Third)
  | Tet_A17 =>
      Row (C3 0 0 0) (C3 2 (-2) (-2)) (C3 (-1) (-3) (-1)) (C3 (-1) (-1) (-3))
        (Nei (C3 (-1) 0 0) Tet_A23 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_B4 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A19 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A03 First Second Fourth Third)
  | Tet_A18 =>
      Row (C3 0 0 0) (C3 2 (-2) (-2)) (C3 3 1 (-1)) (C3 3 (-1) 1)
        (Nei (C3 (-1) 0 0) Tet_B8 Second First Third Fourth)
        (Nei (C3 0 0 0) Tet_A24 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A20 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A04 First Second Fourth Third)
  | Tet_A19 =>
      Row (C3 0 0 0) (C3 2 (-2) (-2)) (C3 (-1) (-1) (-3)) (C3 1 1 (-3))
        (Nei (C3 (-1) 0 0) Tet_B5 Third First Fourth Second)
        (Nei (C3 0 0 0) Tet_A06 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A04 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A17 First Second Fourth Third)
  | Tet_A20 =>
      Row (C3 0 0 0) (C3 2 (-2) (-2)) (C3 3 (-1) 1) (C3 1 (-3) 1)
        (Nei (C3 (-1) 1 0) Tet_A05 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_B3 First Fourth Third Second)
        (Nei (C3 0 0 0) Tet_A03 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A18 First Second Fourth Third)
  | Tet_A21 =>
      Row (C3 0 0 0) (C3 (-2) 2 (-2)) (C3 (-1) (-1) (-3)) (C3 (-3) (-1) (-1))
        (Nei (C3 0 (-1) 0) Tet_A11 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_B4 First Fourth Third Second)
        (Nei (C3 0 0 0) Tet_A07 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A06 First Second Fourth Third)
  | Tet_A22 =>
      Row (C3 0 0 0) (C3 (-2) 2 (-2)) (C3 (-1) 3 1) (C3 1 3 (-1))
        (Nei (C3 0 (-1) 0) Tet_B8 Third First Fourth Second)
        (Nei (C3 0 0 0) Tet_A12 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A08 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A05 First Second Fourth Third)
  | Tet_A23 =>
      Row (C3 0 0 0) (C3 2 2 2) (C3 (-1) 3 1) (C3 (-1) 1 3)
        (Nei (C3 1 0 0) Tet_A17 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_B2 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A15 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A12 First Second Fourth Third)
  | Tet_A24 =>
      Row (C3 0 0 0) (C3 2 2 2) (C3 3 (-1) 1) (C3 3 1 (-1))
        (Nei (C3 0 0 0) Tet_B7 Second First Third Fourth)
        (Nei (C3 0 0 0) Tet_A18 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A16 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A11 First Second Fourth Third)
  | Tet_B1 =>
      Row (C3 0 0 0) (C3 1 1 (-3)) (C3 1 3 (-1)) (C3 3 1 (-1))
        (Nei (C3 (-1) (-1) 0) Tet_C1 Fourth First Second Third)
        (Nei (C3 0 0 0) Tet_A16 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A04 First Third Second Fourth)
        (Nei (C3 0 0 0) Tet_A08 First Fourth Third Second)
  | Tet_B2 =>
      Row (C3 0 0 0) (C3 (-3) 1 1) (C3 (-1) 1 3) (C3 (-1) 3 1)
        (Nei (C3 0 (-1) (-1)) Tet_C1 Second First Third Fourth)
        (Nei (C3 0 0 0) Tet_A23 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A05 First Third Second Fourth)
        (Nei (C3 0 0 0) Tet_A14 First Fourth Third Second)
  | Tet_B3 =>
      Row (C3 0 0 0) (C3 1 (-3) 1) (C3 3 (-1) 1) (C3 1 (-1) 3)
        (Nei (C3 (-1) 0 (-1)) Tet_C1 Third First Fourth Second)
        (Nei (C3 0 0 0) Tet_A11 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A02 First Third Second Fourth)
        (Nei (C3 0 0 0) Tet_A20 First Fourth Third Second)
  | Tet_B4 =>
      Row (C3 0 0 0) (C3 (-3) (-1) (-1)) (C3 (-1) (-1) (-3)) (C3 (-1) (-3) (-1))
        (Nei (C3 (-1) (-1) (-1)) Tet_C1 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A17 First Second Fourth Third)
        (Nei (C3 0 0 0) Tet_A09 First Third Second Fourth)
        (Nei (C3 0 0 0) Tet_A21 First Fourth Third Second)
  | Tet_B5 =>
      Row (C3 2 2 2) (C3 1 5 1) (C3 1 3 (-1)) (C3 (-1) 3 1)
        (Nei (C3 0 (-1) 0) Tet_C2 Fourth First Second Third)
        (Nei (C3 0 0 0) Tet_A12 Second First Third Fourth)
        (Nei (C3 1 0 0) Tet_A19 Second Fourth First Third)
        (Nei (C3 0 0 1) Tet_A01 Second Third Fourth First)
  | Tet_B6 =>
      Row (C3 2 2 2) (C3 1 1 5) (C3 (-1) 1 3) (C3 1 (-1) 3)
        (Nei (C3 0 0 (-1)) Tet_C2 Third First Fourth Second)
        (Nei (C3 0 0 0) Tet_A15 Second First Third Fourth)
        (Nei (C3 0 1 0) Tet_A07 Second Fourth First Third)
        (Nei (C3 1 0 0) Tet_A03 Second Third Fourth First)
  | Tet_B7 =>
      Row (C3 2 2 2) (C3 5 1 1) (C3 3 (-1) 1) (C3 3 1 (-1))
        (Nei (C3 (-1) 0 0) Tet_C2 Second First Third Fourth)
        (Nei (C3 0 0 0) Tet_A24 Second First Third Fourth)
        (Nei (C3 0 0 1) Tet_A13 Second Fourth First Third)
        (Nei (C3 0 1 0) Tet_A06 Second Third Fourth First)
  | Tet_B8 =>
      Row (C3 2 2 2) (C3 5 3 3) (C3 3 5 3) (C3 3 3 5)
        (Nei (C3 0 0 0) Tet_C2 First Second Fourth Third)
        (Nei (C3 1 0 0) Tet_A18 Second First Third Fourth)
        (Nei (C3 0 1 0) Tet_A22 Second Fourth First Third)
        (Nei (C3 0 0 1) Tet_A10 Second Third Fourth First)
  | Tet_C1 =>
      Row (C3 5 5 5) (C3 5 7 7) (C3 7 5 7) (C3 7 7 5)
        (Nei (C3 1 1 1) Tet_B4 First Second Fourth Third)
        (Nei (C3 0 1 1) Tet_B2 Second First Third Fourth)
        (Nei (C3 1 0 1) Tet_B3 Second Fourth First Third)
        (Nei (C3 1 1 0) Tet_B1 Second Third Fourth First)
  | Tet_C2 =>
      Row (C3 5 5 5) (C3 5 3 3) (C3 3 3 5) (C3 3 5 3)
        (Nei (C3 0 0 0) Tet_B8 First Second Fourth Third)
        (Nei (C3 1 0 0) Tet_B7 Second First Third Fourth)
        (Nei (C3 0 0 1) Tet_B6 Second Fourth First Third)
        (Nei (C3 0 1 0) Tet_B5 Second Third Fourth First)
  end.

(** ** The tiling *)

Definition C15Corner (case : C15Case) (i : Place) : Coord3 :=
  match C15RowOf case with Row a b c d _ _ _ _ => Pick (a, b, c, d) i end.

Definition C15NeighborOf (case : C15Case) (i : Place) : C15Neighbor :=
  match C15RowOf case with Row _ _ _ _ a b c d => Pick (a, b, c, d) i end.

(** Vertices in the order of places. *)
Definition OrderOfPlaces (i j k l : Place) : VertexOrder :=
  fun a b c d =>
    let of := Pick (a, b, c, d) in (of i, of j, of k, of l).

Definition C15Vertex (tid : C15TetId) (i : Place) : Coord3 :=
  match tid with C15Id cell case => Translate (CellPosition cell) (C15Corner case i) end.

Definition C15Across (tid : C15TetId) (i : Place) : C15TetId * VertexOrder :=
  match tid with
    C15Id cell case =>
      match C15NeighborOf case i with
        Nei away other p q r s =>
          (C15Id (Translate cell away) other, OrderOfPlaces p q r s)
      end
  end.

(** All are right-handed. *)
Definition C15Tiling : Tiling :=
  MakeTiling C15TetId
    (fun '(C15Id cell _) => CellPosition cell)
    C15Vertex C15Across (fun _ => RightHanded).

(** The corners of one, in a list. *)
Definition C15Corners (tid : C15TetId) : list Coord3 := VerticesOf C15Tiling tid.
