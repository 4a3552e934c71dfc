(** * Where the vertices of the output belong

    A vertex of the output has a name: it is a lattice vertex, perhaps warped,
    or the cut of a lattice edge.  What is said of the mesh is said of names,
    so nothing depends on where exactly the cuts lie. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Stuffing.Stuffing.

(** The vertex belongs to the lattice face with these corners: it is one of
    them, or the cut of an edge between two of them. *)
Definition LiesIn (face : list Coord3) (v : MeshVertex) : Prop :=
  match v with
  | Corner c => In c face
  | Cut plus minus => In plus face /\ In minus face
  end.

(** The face of the structured tetrahedron across from its vertex [i], and the
    identifier of the neighbour there. *)
Definition FaceOf (tid : StructuredTetId) (i : Place) : list Coord3 :=
  FaceAcross (GetStructuredTet tid) i.

Definition NeighborOf (tid : StructuredTetId) (i : Place) : StructuredTetId :=
  fst (NeighborAcross (GetStructuredTet tid) i).
