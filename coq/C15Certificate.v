(** * The certificate, for the lattice C15

    Another tiling of space, of the Laves phase MgCu2: its tetrahedra are nearer to
    regular than those of the body-centred cubic lattice, with dihedral angles from
    60 to 74.3 degrees.

    Read [C15/Sites.v], the vertices and the edges, and [C15/C15Tet.v], the
    tetrahedra as data.  [make audit] checks this page as the others. *)

From Coq Require Import ZArith List.

(** What is meant to run. *)
From Certet Require Export Lattice.Coord3 Lattice.StructuredTet Lattice.Tiling.
From Certet Require Export C15.Sites C15.C15Tet.

(** What is meant. *)
From Certet Require Export Lattice.NeighborSpec Angles.Geometry C15.C15Spec.

(** Why it holds. *)
From Certet Require C15.C15TilingProof.

Open Scope Z_scope.

(** ** The tiling *)

(** Every tetrahedron knows its four face neighbours and how their vertices line
    up: they are its own, except the one across. *)
Theorem C15FacesCorrect :
  forall (tid : C15TetId) (i j : Place),
    LinedUp C15Tiling tid i j = C15Vertex tid j <-> j <> i.
Proof. exact C15TilingProof.C15FacesCorrect. Qed.

(** The neighbour's neighbour across the same face is the tetrahedron itself. *)
Theorem C15NeighborInvolution :
  forall (tid : C15TetId) (i : Place),
    let '(nei, order) := C15Across tid i in
    exists (j : Place) (back_order : VertexOrder),
      C15Vertex nei j = LinedUp C15Tiling tid i i /\
      C15Across nei j = (tid, back_order) /\
      Undoes back_order order /\ Undoes order back_order.
Proof. exact C15TilingProof.C15NeighborInvolution. Qed.

(** The four vertices are four, *)
Theorem C15VerticesApart :
  forall (tid : C15TetId) (i j : Place), C15Vertex tid i = C15Vertex tid j -> i = j.
Proof. exact C15TilingProof.C15VerticesApart. Qed.

(** they are vertices of the lattice, and every two of them are joined. *)
Theorem C15VerticesInLattice :
  forall (tid : C15TetId) (i : Place), IsC15Vertex (C15Vertex tid i).
Proof. exact C15TilingProof.C15VerticesInLattice. Qed.

Theorem C15VerticesJoined :
  forall (tid : C15TetId) (i j : Place), i <> j ->
    C15Edge (C15Vertex tid i) (C15Vertex tid j).
Proof. exact C15TilingProof.C15VerticesJoined. Qed.

(** The edges in the tables are all those between vertices of the lattice at the
    distance of their metals. *)
Theorem C15EdgesAreThese :
  forall a b, IsC15Vertex a -> IsC15Vertex b ->
    C15Edge a b <-> EdgeSquared a b = JoinedSquared (MetalOf a) (MetalOf b).
Proof. exact C15TilingProof.C15EdgesAreThese. Qed.

(** All tetrahedra are right-handed, and those of a primitive cell fill as much of
    space as it does. *)
Theorem C15VolumesPositive : forall case, 0 < C15SixVolume case.
Proof. exact C15TilingProof.C15VolumesPositive. Qed.

Theorem C15VolumesFill : C15SixVolumes = CellSixVolume.
Proof. exact C15TilingProof.C15VolumesFill. Qed.
