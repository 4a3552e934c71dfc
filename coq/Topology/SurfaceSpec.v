(** * The surface of the mesh, and when it is a manifold

    The surface are the triangles that belong to exactly one tetrahedron.  It is
    a closed manifold if every edge of it lies in exactly two of them, and the
    triangles at a vertex are one fan: since each of their edges at the vertex
    lies in two, they are a single cycle as soon as they hang together. *)

From Coq Require Import Arith.
From Certet Require Import Embedding.Definitions.

(** ** The surface *)

Section Mesh.
  Variables (before : SignField) (warping : Coord3 -> Warping).

  Definition SurfaceTriangle (a b c : MeshVertex) : Prop :=
    exists t, InMesh before warping t /\ HasTriangle t a b c /\
      forall u, InMesh before warping u -> HasTriangle u a b c -> u = t.

  (** [x] is joined to [a] by an edge of the surface. *)
  Definition InFan (a x : MeshVertex) : Prop :=
    exists y, SurfaceTriangle a x y.

  (** From [x] to [y] by triangles at [a], each of which has an edge at [a] in
      common with the next. *)
  Definition JoinedInFan (a : MeshVertex) : MeshVertex -> MeshVertex -> Prop :=
    Joined (InFan a) (SurfaceTriangle a).

  (** The sign after warping. *)
  Definition SignAfter (c : Coord3) : Sign := PlacedSign before warping (Corner c).
End Mesh.
