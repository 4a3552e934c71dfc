(** * The tetrahedra of an octree

    Each is made of one, two or four flags.  There are five kinds, and a table
    tells the kind, by what exists beside a flag:

      cell across   middle of the   middle of the
      the face      face is used    edge is used
        yes             no              no          [BccTet]
        yes             no              yes         [EdgeHalfTet]
        yes             yes             no          [FaceHalfTet]
        yes             yes             yes         [QuarterTet]
        no                                          [PyramidTet]

    Those of the first kind are the lattice's own, at each level; of the last
    kind are two on each face without a cell across, the halves of a pyramid on
    it. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Grading.Octree Grading.Flag.
Open Scope Z_scope.

Inductive GradedKind :=
  BccTet | EdgeHalfTet | FaceHalfTet | QuarterTet | PyramidTet.

(** A tetrahedron is named by its kind and one of its flags. *)
Inductive GradedTetId :=
  GTId : GradedKind -> Flag -> GradedTetId.

(** ** Which tetrahedron has a flag *)

Section Cells.
  Variable cells : CellSet.

  (** Its cell exists, and the cell's child in the flag's place does not. *)
  Definition IsPresent (x : Flag) : bool :=
    cells (LevelOf x) (CellOf x)
    && negb (HasChild cells (LevelOf x) (ChildSeen x 1 1 1)).

  (** The table. *)
  Definition KindAt (x : Flag) : GradedKind :=
    if cells (LevelOf x) (CellSeen x 1 0 0) then
      match IsUsed cells (LevelOf x) (PointInHalfSides x 1 0 0),
            IsUsed cells (LevelOf x) (PointInHalfSides x 1 1 0) with
      | false, false => BccTet
      | false, true => EdgeHalfTet
      | true, false => FaceHalfTet
      | true, true => QuarterTet
      end
    else PyramidTet.
End Cells.

(** Of the flags of a tetrahedron the name has the one in the lower cell and at
    the upper corner.  The face of a pyramid is cut from the corner that is
    nearest the centre of the cell's parent to the opposite one; the name has one
    of the other two corners, and the edge there that leads to the former. *)
Definition WithLowerCell (x : Flag) : Flag :=
  match x with MakeFlag _ _ _ s _ _ => if s then x else OtherCell x end.

Definition WithUpperCorner (x : Flag) : Flag :=
  match x with MakeFlag _ _ _ _ _ u => if u then x else OtherCorner x end.

Definition IsOffDiagonal (x : Flag) : bool :=
  xorb (AheadAtEdge x) (AheadAtCorner x).

Definition WithCornerOffDiagonal (x : Flag) : Flag :=
  let y := if IsOffDiagonal x then x else OtherCorner x in
  if AheadAtEdge y then OtherEdge y else y.

Definition NamingFlag (kind : GradedKind) (x : Flag) : Flag :=
  match kind with
  | BccTet => WithUpperCorner (WithLowerCell x)
  | EdgeHalfTet => WithLowerCell x
  | FaceHalfTet => WithUpperCorner x
  | QuarterTet => x
  | PyramidTet => WithCornerOffDiagonal x
  end.

Definition TetOfFlag (cells : CellSet) (x : Flag) : GradedTetId :=
  GTId (KindAt cells x) (NamingFlag (KindAt cells x) x).

(** The tetrahedra of an octree are those of its flags, by these names. *)
Definition InGradedMesh (cells : CellSet) (tid : GradedTetId) : Prop :=
  match tid with
    GTId _ x => IsPresent cells x = true /\ TetOfFlag cells x = tid
  end.

(** The flags of a tetrahedron. *)
Definition FlagsOf (tid : GradedTetId) : list Flag :=
  match tid with
  | GTId BccTet x => [x; OtherCorner x; OtherCell x; OtherCorner (OtherCell x)]
  | GTId EdgeHalfTet x => [x; OtherCell x]
  | GTId FaceHalfTet x => [x; OtherCorner x]
  | GTId QuarterTet x => [x]
  | GTId PyramidTet x => [x; OtherCorner x; OtherEdge x; OtherCorner (OtherEdge x)]
  end.

(** ** Vertices *)

Definition IsUpperEdge (x : Flag) : bool :=
  match x with MakeFlag _ _ _ _ t _ => t end.

(** As a structured tetrahedron has them, those of the first kind: the even
    ends of the edge first. *)
Definition GradedVertices (tid : GradedTetId) : Coord3 * Coord3 * Coord3 * Coord3 :=
  match tid with
    GTId kind x =>
      let p := PointSeen x in
      match kind with
      | BccTet =>
          if IsUpperEdge x then (p 1 1 (-1), p 1 1 1, p 2 0 0, p 0 0 0)
          else (p 1 1 (-1), p 1 1 1, p 0 0 0, p 2 0 0)
      | EdgeHalfTet => (p 1 1 1, p 1 1 0, p 2 0 0, p 0 0 0)
      | FaceHalfTet => (p 1 1 1, p 1 1 (-1), p 1 0 0, p 0 0 0)
      | QuarterTet => (p 1 1 1, p 1 1 0, p 1 0 0, p 0 0 0)
      | PyramidTet => (p 1 1 1, p 1 1 (-1), p 1 (-1) 1, p 0 0 0)
      end
  end.

Definition GradedVertexAt (tid : GradedTetId) (i : Place) : Coord3 :=
  Pick (GradedVertices tid) i.

(** The face across from the vertex at place [i]. *)
Definition GradedFace (tid : GradedTetId) (i : Place) : list Coord3 :=
  let '(j, k, l) := Others i in
  [GradedVertexAt tid j; GradedVertexAt tid k; GradedVertexAt tid l].

Definition IsEvenOrder (o : AxisOrder) : bool :=
  match o with XYZ | YZX | ZXY => true | _ => false end.

Definition GradedHandedness (tid : GradedTetId) : Handedness :=
  match tid with
    GTId kind (MakeFlag _ _ o s t u) =>
      let right :=
        match kind with
        | BccTet => negb (Bool.eqb (IsEvenOrder o) (Bool.eqb s u))
        | _ => Bool.eqb (IsEvenOrder o) (Bool.eqb s (Bool.eqb t u))
        end in
      if right then RightHanded else LeftHanded
  end.

(** The tetrahedron, in lattice units; oriented as [Orient] does. *)
Definition GetGradedTet (tid : GradedTetId) : UnstructuredTet Coord3 :=
  let '(v1, v2, v3, v4) := GradedVertices tid in
  match GradedHandedness tid with
  | RightHanded => UT _ v1 v2 v3 v4
  | LeftHanded => UT _ v1 v2 v4 v3
  end.

(** ** Neighbours *)

(** A flag of the tetrahedron at its face across from place [i], and which of the
    flag's own four points is across from it: its corner, its edge's middle, its
    face's, or its cell's centre. *)
Definition FlagAtFace (tid : GradedTetId) (i : Place) : Flag * Place :=
  match tid with
  | GTId BccTet x =>
      match i with
      | First => (x, Second)
      | Second => (OtherCorner x, Second)
      | Third => (if IsUpperEdge x then x else OtherCell x, Third)
      | Fourth => (if IsUpperEdge x then OtherCell x else x, Third)
      end
  | GTId EdgeHalfTet x =>
      match i with
      | First => (x, First)
      | Second => (x, Second)
      | Third => (x, Third)
      | Fourth => (OtherCell x, Third)
      end
  | GTId FaceHalfTet x =>
      match i with
      | First => (OtherCorner x, Second)
      | Second => (x, Second)
      | Third => (x, Third)
      | Fourth => (x, Fourth)
      end
  | GTId QuarterTet x => (x, i)
  | GTId PyramidTet x =>
      match i with
      | First => (OtherCorner x, Second)
      | Second => (OtherEdge x, Third)
      | Third => (x, Third)
      | Fourth => (x, Fourth)
      end
  end.

Section Neighbors.
  Variable cells : CellSet.

  (** The flag across, or one of those across. *)
  Definition FlagAcross (x : Flag) (i : Place) : Flag :=
    match i with
    | First =>
        if IsPresent cells (OtherCorner x) then OtherCorner x else FinerInCell x
    | Second => OtherEdge x
    | Third => OtherFace x
    | Fourth =>
        if cells (LevelOf x) (CellSeen x 1 0 0) then
          if IsPresent cells (OtherCell x) then OtherCell x else FinerInOther x
        else Coarser (WithCornerOffDiagonal x)
    end.

  (** The neighbour across from place [i]. *)
  Definition GradedNeighbor (tid : GradedTetId) (i : Place) : GradedTetId :=
    let '(x, j) := FlagAtFace tid i in TetOfFlag cells (FlagAcross x j).
End Neighbors.
