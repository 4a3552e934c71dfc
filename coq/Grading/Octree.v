(** * Octrees of cubic cells over the lattice

    A cell of level 0 is a cube of the lattice: its corners are even points, its
    centre is an odd one.  A cell of level L is 2^L times as large; the eight
    cells of level L - 1 within it are its children.  An octree says which cells
    exist.  A cell may have any of its children: where it has none, it fills the
    place itself. *)

From Certet Require Import Lattice.Definitions.
Open Scope Z_scope.

(** Which cells exist, by level and by index. *)
Definition CellSet : Type := nat -> Coord3 -> bool.

(** Half the side of a cell, in lattice units. *)
Definition HalfSide (level : nat) : Z := 2 ^ Z.of_nat level.

(** A cell's centre, in units of half its side. *)
Definition CentreInHalfSides (c : Coord3) : Coord3 :=
  Translate (Scale 2 c) (C3 1 1 1).

(** The cell one level up in which a cell lies, *)
Definition ParentCell (c : Coord3) : Coord3 :=
  match c with C3 x y z => C3 (x / 2) (y / 2) (z / 2) end.

(** and the one so many levels up. *)
Fixpoint AncestorCell (levels : nat) (c : Coord3) : Coord3 :=
  match levels with
  | O => c
  | S l => ParentCell (AncestorCell l c)
  end.

(** No step, or one across a face or an edge of a cell: to 18 others. *)
Definition WithinFaceOrEdge (step : Coord3) : Prop :=
  match step with
    C3 x y z =>
      -1 <= x <= 1 /\ -1 <= y <= 1 /\ -1 <= z <= 1 /\ x * y * z = 0
  end.

(** With a cell exist its parent, and the parents of its neighbours across faces
    and edges. *)
Definition IsBalanced (cells : CellSet) : Prop :=
  forall level c step,
    WithinFaceOrEdge step -> cells level c = true ->
    cells (S level) (ParentCell (Translate c step)) = true.

(** All cells of some level exist. *)
Definition HasTop (cells : CellSet) : Prop :=
  exists level, forall c, cells level c = true.

Definition IsOctree (cells : CellSet) : Prop :=
  IsBalanced cells /\ HasTop cells.

(** Whether there is such a child of a cell of this level. *)
Definition HasChild (cells : CellSet) (level : nat) (child : Coord3) : bool :=
  match level with
  | O => false
  | S l => cells l child
  end.

(** Whether a point is a corner of a cell one level down; it is given in half
    sides of a cell of this level, which are sides of that one. *)
Definition UnitCube : list Coord3 :=
  [C3 0 0 0; C3 1 0 0; C3 0 1 0; C3 1 1 0;
   C3 0 0 1; C3 1 0 1; C3 0 1 1; C3 1 1 1].

Definition IsUsed (cells : CellSet) (level : nat) (point : Coord3) : bool :=
  match level with
  | O => false
  | S l => existsb (fun corner => cells l (Difference corner point)) UnitCube
  end.

(** The level whose cell has a cell of level 0 in a place that it fills. *)
Definition FillsAt (cells : CellSet) (level : nat) (c : Coord3) : Prop :=
  cells level (AncestorCell level c) = true /\
  HasChild cells level (AncestorCell (pred level) c) = false.
