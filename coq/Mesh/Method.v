(** * The methods of the product

    A method says what of a domain counts as inside, where edges are cut and
    which vertices are warped; what it promises are the angles.  Another method
    is another case of each definition here. *)

From Certet Require Import Key.Definitions.
Open Scope Z_scope.

(** Cuts found by bisection, and the widest angles; cuts found by bisection, and
    a mesh that embeds; cuts in the middle, and nothing warped; cuts found by
    bisection, and the shape kept, where vertices have their turns in the order of
    a list; or so with diagonals that follow the cuts. *)
Inductive Method :=
| AngleMethod | EmbeddingMethod | MidpointMethod
| SettledMethod : list Coord3 -> Method
| KeyMethod : list Coord3 -> Method.

(** Alpha of long and of short edges, in 256ths. *)
Definition MethodThresholds (m : Method) : Thresholds :=
  match m with
  | AngleMethod => AngleThresholds
  | EmbeddingMethod => EmbeddingThresholds
  | MidpointMethod => NoWarpThresholds
  | SettledMethod _ => AngleThresholds
  | KeyMethod _ => KeyThresholds
  end.

(** The least and the greatest dihedral angle, in hundredths of a degree. *)
Definition LeastAngle (m : Method) : Z :=
  match m with
  | AngleMethod => 1077 | EmbeddingMethod => 927 | MidpointMethod => 3000
  | SettledMethod _ => 1077
  | KeyMethod _ => 1118
  end.

Definition GreatestAngle (m : Method) : Z :=
  match m with
  | AngleMethod => 16476 | EmbeddingMethod => 16146 | MidpointMethod => 13500
  | SettledMethod _ => 16476
  | KeyMethod _ => 15713
  end.

(** A mesh: the tetrahedra that are made within each structured tetrahedron, by
    the names of their vertices; and what sign a vertex has and where it lies, in
    steps. *)
Record Mesh := MakeMesh {
  TetsWithin : StructuredTetId -> list (UnstructuredTet MeshVertex);
  SignIn : MeshVertex -> Sign;
  PositionIn : MeshVertex -> Coord3
}.

(** The mesh that [StuffTet] makes; *)
Definition StuffedMesh (th : Thresholds) (sign : SignField) (cut : CutField)
  : Mesh :=
  MakeMesh (StuffTet th sign cut) (MeshVertexSign th sign cut)
           (MeshPosition th sign cut).

(** that of any warp and any cuts; *)
Definition PlacedMesh (before : SignField) (warping : Coord3 -> Warping)
  (cut : CutField) : Mesh :=
  MakeMesh (PlacedNames before warping) (PlacedSign before warping)
           (PlacedPosition warping cut).

(** that of a rule of who stays and how far the others move; that of one sweep in
    the order of a list, which is such a rule; *)
Definition RuledMesh (th : Thresholds) (sign : SignField) (cut : CutField)
  (stays : Coord3 -> bool) (limit : Coord3 -> Z) : Mesh :=
  PlacedMesh sign (RuledWarping th sign cut stays limit) (ClampedCut th cut).

Definition SweptMesh (sign : SignField) (cut : CutField) (turns : list Coord3)
  : Mesh :=
  PlacedMesh sign (PlaceIn (Settle AngleThresholds sign cut LevelGap turns))
             (ClampedCut AngleThresholds cut).

(** that of any warp and any cuts with diagonals by key; that of one sweep, the
    product's rule of who stays, at the thresholds of this order; *)
Definition KeyMesh (before : SignField) (warping : Coord3 -> Warping)
  (cut : CutField) : Mesh :=
  MakeMesh (KeyNames before warping cut) (PlacedSign before warping)
           (PlacedPosition warping cut).

Definition KeySweptMesh (sign : SignField) (cut : CutField) (turns : list Coord3)
  : Mesh :=
  KeyMesh sign (PlaceIn (Settle KeyThresholds sign cut LevelGap turns))
          (ClampedCut KeyThresholds cut).

(** and so that of a method.  Which lattice points count as inside is told
    beside the domain: the mesher takes the outermost points of its lattice as
    outside, whatever the domain says. *)
Definition MeshOf (m : Method) (sign : SignField) (domain : PositionSigns)
  : Mesh :=
  match m with
  | MidpointMethod => StuffedMesh NoWarpThresholds (Decided sign) MidpointCuts
  | SettledMethod turns =>
      SweptMesh (OpenSigns sign) (OpenCuts sign (BisectedCuts domain)) turns
  | KeyMethod turns =>
      KeySweptMesh (OpenSigns sign) (OpenCuts sign (BisectedCuts domain)) turns
  | _ => StuffedMesh (MethodThresholds m) sign (BisectedCuts domain)
  end.
