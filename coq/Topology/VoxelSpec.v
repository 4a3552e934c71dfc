(** * The samples of a label image

    A lattice point is inside if the voxel that it lies in is.  Of voxels that
    touch by an edge or a corner alone, an odd point may be a neighbour of both;
    there it is taken as outside, so that the samples do not join what no faces
    join. *)

From Certet Require Import Embedding.Definitions.
Open Scope Z_scope.

(** ** Voxels *)

(** Half a long edge of the lattice, the spacings of the voxels, and where the
    lattice's origin lies in the image; in one unit, as integers. *)
Inductive VoxelGrid :=
  Grid : Z -> Coord3 -> Coord3 -> VoxelGrid.

(** The voxel that a point lies in; a voxel has its lower faces. *)
Definition Owner (grid : VoxelGrid) (v : Coord3) : Coord3 :=
  match grid, v with
    Grid half (C3 sx sy sz) (C3 ox oy oz), C3 x y z =>
      C3 ((ox + half * x) / sx) ((oy + half * y) / sy) ((oz + half * z) / sz)
  end.

(** A long edge is no longer than the smallest spacing. *)
Definition FineEnough (grid : VoxelGrid) : Prop :=
  match grid with
    Grid half (C3 sx sy sz) _ =>
      0 < half /\ 2 * half <= sx /\ 2 * half <= sy /\ 2 * half <= sz
  end.

(** They share a face. *)
Definition Beside (u v : Coord3) : Prop :=
  In (Difference u v)
    [C3 1 0 0; C3 (-1) 0 0; C3 0 1 0; C3 0 (-1) 0; C3 0 0 1; C3 0 0 (-1)].

(** Three even coordinates, or three odd ones. *)
Definition OfLattice (v : Coord3) : Prop :=
  IsEven v \/ IsEven (Translate v (C3 1 1 1)).

(** ** Samples *)

Section Samples.
  Variables (grid : VoxelGrid) (image : Coord3 -> bool).

  Definition InImage (v : Coord3) : bool := image (Owner grid v).

  (** The neighbour in a short direction is in the image: of an odd point one of
      its eight even neighbours, which are the corners of a cube. *)
  Definition CubeInner (v : Coord3) (d : Direction) : bool :=
    match DirectionKind d with
    | Short => InImage (Translate v (Offset d))
    | Long => false
    end.

  (** These are in two or more groups, joined by edges of the cube. *)
  Definition CubeParted (v : Coord3) : bool :=
    existsb (CubeInner v) AllDirections && negb (OnePiece (CubeInner v)).

  Definition VoxelSigns : SignField := fun v =>
    match v with
      C3 x _ _ =>
        if InImage v && (Z.even x || negb (CubeParted v)) then Plus else Minus
    end.
End Samples.
