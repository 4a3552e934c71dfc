(** * Where a mesh may be graded: away from its surface

    The surface is left to the structured tetrahedra.  Every cell of level 0 is
    kept that has a point near it that is not inside: signs are those after
    warping. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Mesh.Method.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet.
Open Scope Z_scope.

(** The centre of a cell of level 0 and its fourteen neighbours in the lattice:
    the cell's eight corners, and the centres across its six faces. *)
Definition PointsOfCell (c : Coord3) : list Coord3 :=
  let centre := CentreInHalfSides c in
  centre :: map (fun d => Translate centre (Offset d)) AllDirections.

Definition IsPlus (s : Sign) : bool :=
  match s with Plus => true | _ => false end.

(** Some of these points is not inside. *)
Definition IsNearSurface (sign : SignField) (c : Coord3) : bool :=
  negb (forallb (fun v => IsPlus (sign v)) (PointsOfCell c)).

Definition KeepsSurface (sign : SignField) (cells : CellSet) : Prop :=
  forall c, IsNearSurface sign c = true -> cells O c = true.

(** ** The least octree *)

(** A cell exists if a child of it does, or a neighbour of a child across a face
    or an edge: of four cells along each axis, all but the eight outermost. *)
Definition AroundChildren : list Coord3 :=
  filter (fun d =>
    match d with
      C3 x y z =>
        let within n := (0 <=? n) && (n <=? 1) in within x || within y || within z
    end)
    (flat_map (fun x => flat_map (fun y => map (fun z => C3 x y z)
       [-1; 0; 1; 2]) [-1; 0; 1; 2]) [-1; 0; 1; 2]).

Fixpoint ClosedCells (asked : CellSet) (level : nat) (c : Coord3) : bool :=
  match level with
  | O => asked O c
  | S l =>
      asked level c ||
      existsb (fun d => ClosedCells asked l (Translate (Scale 2 c) d)) AroundChildren
  end.

(** The cells asked for, what balance asks for with them, and all cells from some
    level on. *)
Definition OctreeAround (asked : CellSet) (levels : nat) : CellSet :=
  fun level c => (levels <=? level)%nat || ClosedCells asked level c.

(** That of a mesh with these signs. *)
Definition GradedOctree (sign : SignField) (levels : nat) : CellSet :=
  OctreeAround
    (fun level c => match level with O => IsNearSurface sign c | S _ => false end)
    levels.

(** ** The mesh *)

(** The structured tetrahedron that a tetrahedron of the first kind is, at
    level 0. *)
Definition StructuredOf (x : Flag) : StructuredTetId :=
  match x with
    MakeFlag _ c o _ t _ =>
      STId (Translate (Scale 2 c) (Arrange o 0 (if t then 0 else -2) 0))
        (match o, t with
         | ZYX, false => Tet_I1 | YZX, true => Tet_I2
         | YZX, false => Tet_I3 | ZYX, true => Tet_I4
         | ZXY, false => Tet_J1 | XZY, true => Tet_J2
         | XZY, false => Tet_J3 | ZXY, true => Tet_J4
         | YXZ, false => Tet_K1 | XYZ, true => Tet_K2
         | XYZ, false => Tet_K3 | YXZ, true => Tet_K4
         end)
  end.

Definition StructuredName (tid : GradedTetId) : option StructuredTetId :=
  match tid with
  | GTId BccTet (MakeFlag O _ _ _ _ _ as x) => Some (StructuredOf x)
  | _ => None
  end.

(** What a mesh has within a structured tetrahedron, it has when it is graded;
    the others are kept whole. *)
Definition GradedTetsWithin (mesh : Mesh) (tid : GradedTetId)
  : list (UnstructuredTet MeshVertex) :=
  match StructuredName tid with
  | Some stid => TetsWithin mesh stid
  | None => [MapTet Corner (GetGradedTet tid)]
  end.

(** The signs of its lattice points, by which it is graded. *)
Definition CornerSigns (mesh : Mesh) : SignField :=
  fun v => SignIn mesh (Corner v).
