(** * Meshes of several materials

    As in [Stuffing], but with the material of every lattice vertex in the place
    of its sign: what becomes of a vertex, the tetrahedra that fill one
    structured tetrahedron, and their positions. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Material.MaterialTet.
Open Scope Z_scope.

(** The material of each lattice vertex; None: it lies on an interface. *)
Definition MaterialField : Type := Coord3 -> option Material.

(** ** The tetrahedra *)

Section Names.
  (** The materials after warping, and those of structured tetrahedra with all
      four corners on an interface. *)
  Variable material : MaterialField.
  Variable shared : StructuredTetId -> Material.

  Definition VertexMaterial (v : MeshVertex) : option Material :=
    match v with Corner c => material c | Cut _ _ => None end.

  Definition OrientMaterialTet (h : Handedness)
    (t : Material * UnstructuredTet MeshVertex)
    : Material * UnstructuredTet MeshVertex := (fst t, Orient h (snd t)).

  (** A cut is named by its ends, that of the higher material first. *)
  Definition MaterialNames (tid : StructuredTetId)
    : list (Material * UnstructuredTet MeshVertex) :=
    match tid, GetStructuredTet tid with
    | STId _ case, ST v1 v2 v3 v4 _ _ _ _ =>
        map (OrientMaterialTet (CaseHandedness case))
          (GetMaterialTets MeshVertex VertexMaterial MeshIntersection
             (Corner v1) (Corner v2) (Corner v3) (Corner v4) (shared tid))
    end.
End Names.

(** ** Warping *)

Section Warping.
  Variable th : Thresholds.
  (** The material of each vertex before warping, and for an edge from a higher
      to a lower material the cut in steps from the former. *)
  Variable material : MaterialField.
  Variable cut : CutField.

  (** Steps from [v] to the cut of its edge in direction [d]. *)
  Definition MaterialCutFrom (v : Coord3) (d : Direction) : Z :=
    let u := Translate v (Offset d) in
    match material v, material u with
    | Some m, Some n => if m <? n then Steps - cut u v else cut v u
    | _, _ => cut v u
    end.

  (** A vertex is violated by the cut of an edge to any other material, and
      moves to the nearest such cut. *)
  Definition WarpMaterialVertex (v : Coord3) : Warping :=
    match material v with
    | None => Stays
    | Some m =>
        Warp th Plus
          (fun d => SignAmongMaterials Coord3 material m (Translate v (Offset d)))
          (MaterialCutFrom v)
    end.

  (** Any of those that are violated may stay, and any that moves may stop
      short; cuts are kept alpha away from both ends, by [ClampedCut]. *)
  Variables (stays : Coord3 -> bool) (limit : Coord3 -> Z).

  Definition RuledMaterialWarping (v : Coord3) : Warping :=
    match WarpMaterialVertex v with
    | Stays => Stays
    | Moves d t =>
        if stays v then Stays else Moves d (Z.max 0 (Z.min t (limit v)))
    end.
End Warping.

(** ** A placement: where everything is after warping *)

Section Placement.
  Variable before : MaterialField.
  Variable warping : Coord3 -> Warping.
  Variable cut : CutField.

  Definition PlacedMaterial (c : Coord3) : option Material :=
    match warping c with Stays => before c | Moves _ _ => None end.

  (** In steps. *)
  Definition PlacedMaterialTets (shared : StructuredTetId -> Material)
    (tid : StructuredTetId) : list (Material * UnstructuredTet Coord3) :=
    map (fun t => (fst t, MapTet (PlacedPosition warping cut) (snd t)))
      (MaterialNames PlacedMaterial shared tid).

  (** The structured tetrahedron itself, where its corners are now. *)
  Definition PlacedWhole (tid : StructuredTetId) : UnstructuredTet Coord3 :=
    match tid, GetStructuredTet tid with
    | STId _ case, ST v1 v2 v3 v4 _ _ _ _ =>
        MapTet (PlacedPosition warping cut)
          (Orient (CaseHandedness case)
             (UT _ (Corner v1) (Corner v2) (Corner v3) (Corner v4)))
    end.
End Placement.
