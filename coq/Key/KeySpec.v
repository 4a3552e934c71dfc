(** * What is said of stencils whose diagonals follow an order of the cuts *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Key.KeyStuffing Key.FaceRule.
Open Scope Z_scope.

(** The order of the Parity Rule: opposite edges are alike, and the long ones
    come first, then [v1 v4] and [v2 v3], then [v1 v3] and [v2 v4]. *)
Definition KeepsParity {Vertex : Type} (GetKey : Vertex -> Vertex -> Z)
    (v1 v2 v3 v4 : Vertex) : Prop :=
  exists long first second, long < first < second /\
    (forall a b, In (a, b) [(v1, v2); (v2, v1); (v3, v4); (v4, v3)] ->
       GetKey a b = long) /\
    (forall a b, In (a, b) [(v1, v4); (v4, v1); (v2, v3); (v3, v2)] ->
       GetKey a b = first) /\
    (forall a b, In (a, b) [(v1, v3); (v3, v1); (v2, v4); (v4, v2)] ->
       GetKey a b = second).

(** What lies on the face with these corners, by the face alone. *)
Definition OnFace (key : Coord3 -> Coord3 -> Z) (before : SignField)
  (warping : Coord3 -> Warping) (f1 f2 f3 : Coord3) : MeshVertex -> MeshVertex ->
  MeshVertex -> Prop :=
  AmongFaceTriangles
    (FaceTriangles MeshVertex (PlacedSign before warping) MeshIntersection
       (MeshKey key) (Corner f1) (Corner f2) (Corner f3)).

(** Whatever the domain, wherever the cuts: with the diagonals by key the
    thresholds guarantee bounds. *)
Definition KeyGuarantees (th : Thresholds) (bounds : AngleBounds) : Prop :=
  forall tid before warping cut,
    Admissible before warping cut th (Corners tid) ->
    forall t, In t (KeyTets before warping cut tid) -> WellShaped bounds t.

(** The mesh of the paper's warp, in steps. *)
Definition KeyStuffedTets (th : Thresholds) (sign : SignField) (cut : CutField)
  (tid : StructuredTetId) : list (UnstructuredTet Coord3) :=
  map (MapTet (MeshPosition th sign cut)) (KeyStuffTet th sign cut tid).

(** The mesh of a rule of who stays and how far the others move, in steps: the
    keys are those of the cuts that are kept away from both ends. *)
Definition KeyWarpOrClamp (th : Thresholds) (sign : SignField) (cut : CutField)
  (stays : Coord3 -> bool) (limit : Coord3 -> Z) (tid : StructuredTetId)
  : list (UnstructuredTet Coord3) :=
  KeyTets sign (RuledWarping th sign cut stays limit) (ClampedCut th cut) tid.
