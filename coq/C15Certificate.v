(** * The certificate, for the lattice C15

    Another tiling of space, of the Laves phase MgCu2: its tetrahedra are nearer to
    regular than those of the body-centred cubic lattice, with dihedral angles from
    60 to 74.3 degrees.

    Read [C15/Sites.v], the vertices and the edges, [C15/C15Tet.v], the tetrahedra as
    data, and [C15/C15Stuffing.v], what is put in their place.  [make audit] checks
    this page as the others. *)

From Coq Require Import ZArith Reals List.

(** What is meant to run. *)
From Certet Require Export Lattice.Coord3 Lattice.StructuredTet Lattice.Tiling.
From Certet Require Export Stencil.UnstructuredTet Warp.Cut Stuffing.Stuffing.
From Certet Require Export Key.KeyTet Key.KeyStuffing.
From Certet Require Export C15.Sites C15.C15Tet C15.TilingStuffing C15.C15Stuffing.

(** What is meant. *)
From Certet Require Export Lattice.NeighborSpec Stencil.TriangleSpec Stuffing.MeshSpec.
From Certet Require Export Angles.Geometry Angles.AnglesSpec Angles.DegreesSpec.
From Certet Require Export Key.FaceRule C15.C15Spec C15.C15AnglesSpec C15.C15WarpSpec.

(** Why it holds. *)
From Certet Require C15.C15TilingProof C15.TilingMeshProof C15.C15MeshProof.
From Certet Require C15.C15WarpProof C15.C15LatticeProof C15.C15BoundsProof.
From Certet Require C15.C15DegreesProof.

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

(** ** The mesh, with diagonals by key *)

(** In any tiling and any order of the cuts the triangles that a tetrahedron has on
    a face with a + corner are those that the face's own rule says, from the signs
    of its corners and the keys of its cuts alone. *)
Theorem TilingFaceRule :
  forall (T : Tiling), VerticesApart T ->
    forall key after (id : Identifier T) f1 f2 f3,
      let face := (f1 :: f2 :: f3 :: nil)%list in
      KeysApart key (VerticesOf T id) ->
      NoDup face -> incl face (VerticesOf T id) ->
      (exists f, In f face /\ after f = Plus) ->
      forall a b c, LiesIn face a -> LiesIn face b -> LiesIn face c ->
        AmongTriangles (TilingNames T key after id) a b c <->
        AmongFaceTriangles
          (FaceTriangles MeshVertex (AfterSign after) MeshIntersection (MeshKey key)
             (Corner f1) (Corner f2) (Corner f3)) a b c.
Proof. exact TilingMeshProof.TilingFaceRule. Qed.

(** Cuts that share an end never have the same key. *)
Theorem C15CutKeysApart :
  forall cut tid, KeysApart (C15CutKey cut) (C15Corners tid).
Proof. exact C15MeshProof.C15CutKeysApart. Qed.

(** Whatever the signs after warping and the cuts: a tetrahedron of the output has a
    corner inside and none outside; *)
Theorem C15TetrahedraInside :
  forall after cut (tid : C15TetId) t,
    In t (TilingNames C15Tiling (C15CutKey cut) after tid) ->
    (exists v, In v (TetCorners t) /\ AfterSign after v = Plus) /\
    (forall v, In v (TetCorners t) -> AfterSign after v <> Minus).
Proof. exact C15MeshProof.C15TetrahedraInside. Qed.

(** both sides of a face with a corner inside have the same triangles, each of one
    tetrahedron of either side; *)
Theorem C15FacesConform :
  forall after cut (tid : C15TetId) i a b c,
    let face := TilingFace C15Tiling tid i in
    let made := TilingNames C15Tiling (C15CutKey cut) after in
    LiesIn face a -> LiesIn face b -> LiesIn face c ->
    ((exists f, In f face /\ after f = Plus) ->
     AmongTriangles (made tid) a b c <->
     AmongTriangles (made (TilingNeighbor C15Tiling tid i)) a b c) /\
    (forall t u, In t (made tid) -> In u (made tid) ->
       HasTriangle t a b c -> HasTriangle u a b c -> t = u).
Proof. exact C15MeshProof.C15FacesConform. Qed.

(** and a triangle that no other tetrahedron has lies on the surface. *)
Theorem C15BoundaryOnSurface :
  forall after cut (tid : C15TetId) t a b c,
    let made := TilingNames C15Tiling (C15CutKey cut) after in
    let sign := AfterSign after in
    In t (made tid) -> HasTriangle t a b c ->
    (sign a = OnSurface /\ sign b = OnSurface /\ sign c = OnSurface) \/
    (exists u, u <> t /\ HasTriangle u a b c /\
       (In u (made tid) \/
        exists i, In u (made (TilingNeighbor C15Tiling tid i)))).
Proof. exact C15MeshProof.C15BoundaryOnSurface. Qed.

(** ** Angles *)

(** Where no edge is short of both its ends, what warping leaves around a
    tetrahedron is an admissible placement. *)
Theorem C15WarpIsAdmissible :
  forall th sign cut, C15AtMostHalf th -> CutsOnEdges sign cut ->
    forall tid,
      C15Admissible sign (C15WarpVertex th sign cut) cut th (C15Corners tid).
Proof. exact C15WarpProof.C15WarpIsAdmissible. Qed.

(** At 86/256 of an edge from magnesium to magnesium, 96 from magnesium to copper, 80
    from copper to magnesium and 99 from copper to copper: of every admissible
    placement every tetrahedron is right-handed, and its dihedral angles are between
    those whose cotangents' squares are 91/6 and 71/25, *)
Theorem C15DihedralBounds :
  forall tid before warping cut,
    C15Admissible before warping cut C15KeyThresholds (C15Corners tid) ->
    forall t, In t (C15Tets before warping cut tid) ->
      WellShaped (AB (CotSq 91 6) (CotSq 71 25)) t.
Proof. exact C15BoundsProof.C15DihedralBounds. Qed.

(** which is between 14.40 and 149.32 degrees. *)
Theorem C15DihedralBoundsInDegrees :
  forall tid before warping cut t,
    C15Admissible before warping cut C15KeyThresholds (C15Corners tid) ->
    In t (C15Tets before warping cut tid) ->
    WithinDegrees (1440 / 100) (14932 / 100) t.
Proof. exact C15DegreesProof.C15DihedralBoundsInDegrees. Qed.

Theorem C15PositiveVolume :
  forall tid before warping cut t,
    C15Admissible before warping cut C15KeyThresholds (C15Corners tid) ->
    In t (C15Tets before warping cut tid) -> Positive t.
Proof. exact C15BoundsProof.C15PositiveVolume. Qed.

(** So it is after warping, wherever the cuts are on their edges. *)
Theorem C15BoundsInDegrees :
  forall sign cut tid t, CutsOnEdges sign cut ->
    In t (C15StuffedTets C15KeyThresholds sign cut tid) ->
    WithinDegrees (1440 / 100) (14932 / 100) t.
Proof. exact C15DegreesProof.C15BoundsInDegrees. Qed.

(** No tetrahedron of the warped lattice is turned over, kept or dropped. *)
Theorem C15WarpedLatticePositive :
  forall sign cut tid, CutsOnEdges sign cut ->
    Positive (C15WarpedTet (C15WarpVertex C15KeyThresholds sign cut) cut tid).
Proof. exact C15LatticeProof.C15WarpedLatticePositive. Qed.
