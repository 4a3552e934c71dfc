(** * Stuffing by key: the diagonals follow the cuts

    The mesher of [Stuffing] but for its stencils, [GetKeyTets].  The key of a
    cut is how far it lies from its + end, in parts of its edge; of two cuts
    equally far the one on the long edge comes first, and where both edges are
    short the Parity Rule decides, as [EdgeRank] has it.  Cuts that share an end
    never have the same key.  With all cuts in the middle the mesh is therefore
    that of the paper's stencils. *)

From Certet Require Import Angles.Definitions.
From Certet Require Export Lattice.EdgeRank Key.KeyTet.
Open Scope Z_scope.

(** Ranks are less than 3. *)
Definition CutKey (cut : CutField) (plus minus : Coord3) : Z :=
  3 * cut plus minus + EdgeRank plus minus.

(** The key of a cut of the mesh, by a key for each edge. *)
Definition MeshKey (key : Coord3 -> Coord3 -> Z) (a b : MeshVertex) : Z :=
  match a, b with
  | Corner plus, Corner minus => key plus minus
  | _, _ => 0
  end.

(** The widest angles at which no short edge can be crossed. *)
Definition KeyThresholds : Thresholds := TH 64 95.

(** 11.18 and 157.13 degrees. *)
Definition KeyAngles : AngleBounds := AB (CotSq 179 7) (CotSq 73 13).

(** The tetrahedra put in place of one structured tetrahedron after any warp, by
    the names of their vertices, in any order of the cuts; *)
Definition OrderedNames (key : Coord3 -> Coord3 -> Z) (before : SignField)
  (warping : Coord3 -> Warping) (tid : StructuredTetId)
  : list (UnstructuredTet MeshVertex) :=
  match tid, GetStructuredTet tid with
  | STId _ case, ST v1 v2 v3 v4 _ _ _ _ =>
      map (Orient (CaseHandedness case))
          (GetKeyTets MeshVertex (PlacedSign before warping) MeshIntersection
             (MeshKey key) (Corner v1) (Corner v2) (Corner v3) (Corner v4))
  end.

(** in that of the cuts that the mesh has; *)
Definition KeyNames (before : SignField) (warping : Coord3 -> Warping)
  (cut : CutField) : StructuredTetId -> list (UnstructuredTet MeshVertex) :=
  OrderedNames (CutKey cut) before warping.

(** these at their positions, in steps; *)
Definition KeyTets (before : SignField) (warping : Coord3 -> Warping)
  (cut : CutField) (tid : StructuredTetId) : list (UnstructuredTet Coord3) :=
  map (MapTet (PlacedPosition warping cut)) (KeyNames before warping cut tid).

(** and after the paper's warp. *)
Definition KeyStuffTet (th : Thresholds) (sign : SignField) (cut : CutField)
  : StructuredTetId -> list (UnstructuredTet MeshVertex) :=
  KeyNames sign (WarpVertex th sign cut) cut.
