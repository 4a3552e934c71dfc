(** * Flags: a corner, an edge, a face and a cell

    A cell's centre, the middle of one of its faces, the middle of one of that
    face's edges, and one of that edge's ends are the corners of a small
    tetrahedron, a flag.  A cell has 48, six in each of its eight places for a
    child.  They say where tetrahedra lie and who is whose neighbour, and
    tetrahedra are put together from them. *)

From Certet Require Import Lattice.Definitions Grading.Octree.
Open Scope Z_scope.

(** The axes of the face, of the edge's place in the face, and of the edge. *)
Inductive AxisOrder := XYZ | XZY | YXZ | YZX | ZXY | ZYX.

(** The vector with these coordinates along the first, second and third axis. *)
Definition Arrange (o : AxisOrder) (a b c : Z) : Coord3 :=
  match o with
  | XYZ => C3 a b c | XZY => C3 a c b | YXZ => C3 b a c
  | YZX => C3 c a b | ZXY => C3 b c a | ZYX => C3 c b a
  end.

Definition AlongFirst (o : AxisOrder) (v : Coord3) : Z :=
  match o, v with
  | (XYZ | XZY), C3 x _ _ => x
  | (YXZ | YZX), C3 _ y _ => y
  | (ZXY | ZYX), C3 _ _ z => z
  end.

Definition SwapLast (o : AxisOrder) : AxisOrder :=
  match o with
  | XYZ => XZY | XZY => XYZ | YXZ => YZX
  | YZX => YXZ | ZXY => ZYX | ZYX => ZXY
  end.

Definition SwapFirst (o : AxisOrder) : AxisOrder :=
  match o with
  | XYZ => YXZ | XZY => ZXY | YXZ => XYZ
  | YZX => ZYX | ZXY => XZY | ZYX => YZX
  end.

(** The third axis first, and back. *)
Definition RotateIn (o : AxisOrder) : AxisOrder := SwapFirst (SwapLast o).
Definition RotateOut (o : AxisOrder) : AxisOrder := SwapLast (SwapFirst o).

(** The level and index of the cell, the axes, and along each of them whether the
    face, the edge and the corner are on the upper side. *)
Inductive Flag :=
  MakeFlag : nat -> Coord3 -> AxisOrder -> bool -> bool -> bool -> Flag.

Definition LevelOf (x : Flag) : nat :=
  match x with MakeFlag level _ _ _ _ _ => level end.

Definition CellOf (x : Flag) : Coord3 :=
  match x with MakeFlag _ c _ _ _ _ => c end.

(** ** What a flag sees

    Seen from a flag, three coordinates count from its cell's centre towards its
    face, its edge and its corner. *)

Definition Signed (up : bool) (n : Z) : Z := if up then n else - n.

Definition StepFrom (x : Flag) (i j k : Z) : Coord3 :=
  match x with
    MakeFlag _ _ o s t u => Arrange o (Signed s i) (Signed t j) (Signed u k)
  end.

(** A point, in half sides of the cell, and in lattice units: the cell's centre
    is 0 0 0, the middle of the face 1 0 0, that of the edge 1 1 0, the corner
    1 1 1. *)
Definition PointInHalfSides (x : Flag) (i j k : Z) : Coord3 :=
  Translate (CentreInHalfSides (CellOf x)) (StepFrom x i j k).

Definition PointSeen (x : Flag) (i j k : Z) : Coord3 :=
  Scale (HalfSide (LevelOf x)) (PointInHalfSides x i j k).

(** A cell of the flag's level: its own is 0 0 0, the one across its face
    1 0 0. *)
Definition CellSeen (x : Flag) (i j k : Z) : Coord3 :=
  Translate (CellOf x) (StepFrom x i j k).

(** A cell one level down: the one in the flag's place is 1 1 1, the others in
    its cell have 0 for 1. *)
Definition ChildAlong (up : bool) (n : Z) : Z := if up then n else 1 - n.

Definition ChildSeen (x : Flag) (i j k : Z) : Coord3 :=
  match x with
    MakeFlag _ c o s t u =>
      Translate (Scale 2 c) (Arrange o (ChildAlong s i) (ChildAlong t j) (ChildAlong u k))
  end.

(** Whether the centre of the parent lies ahead, in the direction of the face, of
    the edge, and of the corner. *)
Definition IsAhead (up : bool) (n : Z) : bool := Bool.eqb up (Z.even n).

Definition AheadAtFace (x : Flag) : bool :=
  match x with MakeFlag _ c o s _ _ => IsAhead s (AlongFirst o c) end.

Definition AheadAtEdge (x : Flag) : bool :=
  match x with MakeFlag _ c o _ t _ => IsAhead t (AlongFirst (SwapFirst o) c) end.

Definition AheadAtCorner (x : Flag) : bool :=
  match x with MakeFlag _ c o _ _ u => IsAhead u (AlongFirst (RotateIn o) c) end.

(** ** The flags beside a flag

    They share all but one of its four points; each way leads back as well. *)

(** The other end of the edge, *)
Definition OtherCorner (x : Flag) : Flag :=
  match x with MakeFlag level c o s t u => MakeFlag level c o s t (negb u) end.

(** the other edge of the face at the corner, *)
Definition OtherEdge (x : Flag) : Flag :=
  match x with MakeFlag level c o s t u => MakeFlag level c (SwapLast o) s u t end.

(** the other face of the cell at the edge, *)
Definition OtherFace (x : Flag) : Flag :=
  match x with MakeFlag level c o s t u => MakeFlag level c (SwapFirst o) t s u end.

(** the other cell at the face. *)
Definition OtherCell (x : Flag) : Flag :=
  match x with
    MakeFlag level _ o s t u =>
      MakeFlag level (CellSeen x 1 0 0) o (negb s) t u
  end.

(** ** The flags across from a flag, one level down or up *)

(** In the cell's child beside the flag, across from the flag's side on which the
    corner is not; *)
Definition FinerInCell (x : Flag) : Flag :=
  match x with
  | MakeFlag (S level) _ o s t u =>
      MakeFlag level (ChildSeen x 1 1 0) (RotateIn o) u s (negb t)
  | _ => x
  end.

(** in the child of the cell across the face; *)
Definition FinerInOther (x : Flag) : Flag :=
  match x with
  | MakeFlag (S level) _ o s t u =>
      MakeFlag level (ChildSeen x 2 1 1) o (negb s) t (negb u)
  | _ => x
  end.

(** and back from these: from a child in the first way if the parent's centre is
    ahead across the face, and else in the second. *)
Definition Coarser (x : Flag) : Flag :=
  match x with
    MakeFlag level c o s t u =>
      if AheadAtFace x
      then MakeFlag (S level) (ParentCell c) (RotateOut o) t (negb u) s
      else MakeFlag (S level) (ParentCell (CellSeen x 1 0 0)) o (negb s) t (negb u)
  end.
