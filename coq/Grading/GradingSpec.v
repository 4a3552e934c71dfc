(** * What the theorems on graded meshes speak of *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Mesh.Method.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet
  Grading.Surface.
Open Scope Z_scope.

(** The same points, in whatever order. *)
Definition SameVertices (a b : list Coord3) : Prop :=
  forall v, In v a <-> In v b.

(** A face lies between two points: with its vertices, in whatever order, they make
    volumes of opposite signs. *)
Definition LiesBetween (face : list Coord3) (a b : Coord3) : Prop :=
  forall p q r, In p face -> In q face -> In r face ->
    p <> q -> q <> r -> p <> r ->
    SixVolume p q r a * SixVolume p q r b < 0.

Definition KindOfName (tid : GradedTetId) : GradedKind :=
  match tid with GTId kind _ => kind end.

Definition FlagOfName (tid : GradedTetId) : Flag :=
  match tid with GTId _ x => x end.

(** Half the side of the cell that a tetrahedron belongs to. *)
Definition GradedSize (tid : GradedTetId) : Z :=
  HalfSide (LevelOf (FlagOfName tid)).

(** 45 and 120 degrees: the squares of the cotangents of 45 and of 180 - 120
    degrees are 1 and 1/3. *)
Definition TransitionBounds : AngleBounds := AB (CotSq 1 1) (CotSq 1 3).

(** ** What goes wrong otherwise *)

(** Cells balanced across faces only, and not across edges. *)
Definition WithinFace (step : Coord3) : Prop :=
  match step with C3 x y z => Z.abs x + Z.abs y + Z.abs z <= 1 end.

Definition IsFaceBalanced (cells : CellSet) : Prop :=
  forall level c step,
    WithinFace step -> cells level c = true ->
    cells (S level) (ParentCell (Translate c step)) = true.

(** The least such with one cell of level 0 and all of level 2. *)
Definition FaceBalancedCells : CellSet :=
  fun level c =>
    match level with
    | O => Coord3Equal c (C3 0 0 0)
    | S O => existsb (Coord3Equal c)
               [C3 0 0 0; C3 (-1) 0 0; C3 0 (-1) 0; C3 0 0 (-1)]
    | _ => true
    end.

(** The pyramid on a face that is cut along the other diagonal: the corner of its
    name is at the diagonal of the other cut. *)
Definition FlippedPyramid (tid : GradedTetId) : GradedTetId :=
  match tid with GTId kind x => GTId kind (OtherCorner x) end.
