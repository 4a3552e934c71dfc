(** * Stuffing by key in any tiling

    As in [KeyStuffing], of a tiling instead of the one lattice: what is put in place
    of a tetrahedron of it, by the signs of lattice points after warping and a key
    for each of their edges. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Key.KeyTet Key.KeyStuffing.

(** Signs after warping, of lattice points and of cuts. *)
Definition AfterSign (after : SignField) (v : MeshVertex) : Sign :=
  match v with Corner c => after c | Cut _ _ => OnSurface end.

Section Stuffing.
  Variable T : Tiling.

  (** By the names of their vertices. *)
  Definition TilingNames (key : Coord3 -> Coord3 -> Z) (after : SignField)
    (id : Identifier T) : list (UnstructuredTet MeshVertex) :=
    let at_ i := Corner (VertexOf id i) in
    map (Orient (HandOf id))
        (GetKeyTets MeshVertex (AfterSign after) MeshIntersection (MeshKey key)
           (at_ First) (at_ Second) (at_ Third) (at_ Fourth)).

  (** The face across from the vertex at place [i], and the neighbour there. *)
  Definition TilingFace (id : Identifier T) (i : Place) : list Coord3 :=
    let '(j, k, l) := Others i in [VertexOf id j; VertexOf id k; VertexOf id l].

  Definition TilingNeighbor (id : Identifier T) (i : Place) : Identifier T :=
    fst (NeighborAt id i).
End Stuffing.
