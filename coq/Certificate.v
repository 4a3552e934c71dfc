(** * The certificate

    Everything that is proved about the mesher, on one page.  Each theorem is
    spelled out in full over the functions that are extracted and run; the
    definitions it speaks of are in the files exported here, which hold no
    proofs.  Proof files are only required for the [exact] of each theorem.

    [make audit] checks these statements against the committed ones, and that
    none of them rests on an axiom. *)

From Coq Require Import ZArith List.

(** What runs. *)
From Certet Require Export Lattice.Coord3 Lattice.Direction.
From Certet Require Export Lattice.StructuredTet Stencil.UnstructuredTet.
From Certet Require Export Warp.Cut Warp.Warp Stuffing.Stuffing.

(** What is meant. *)
From Certet Require Export Lattice.StructuredTetSpec Lattice.NeighborSpec.
From Certet Require Export Stencil.CompatibilitySpec.
From Certet Require Export Stencil.StencilSet Stencil.OtherStencils.
From Certet Require Export Stencil.TriangleSpec Stuffing.MeshSpec.

(** Why it holds. *)
From Certet Require Lattice.StructuredTetProof Lattice.NeighborProof.
From Certet Require Stencil.CompatibilityChecker.
From Certet Require Stencil.CompatibilityCheckerProof.
From Certet Require Stencil.CompatibilityProof.
From Certet Require Stencil.LatticeCompatibilityProof.
From Certet Require Stencil.OtherStencilsProof.
From Certet Require Stuffing.MeshProof.

(** ** The paper's certificate *)

(** Every structured tetrahedron knows its four face neighbours: lined up by
    the order it gives, their vertices are its own except the one across
    (section 4.2). *)
Theorem FacesCorrect :
  forall tid : StructuredTetId,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 (tid1, o1) (tid2, o2) (tid3, o3) (tid4, o4) =>
        (Face1Correct v1 v2 v3 v4 tid1 o1) /\
        (Face2Correct v1 v2 v3 v4 tid2 o2) /\
        (Face3Correct v1 v2 v3 v4 tid3 o3) /\
        (Face4Correct v1 v2 v3 v4 tid4 o4)
    end.
Proof. exact StructuredTetProof.FacesCorrect. Qed.

(** Whatever the vertices, the signs and the cuts, no two edges of the stencils
    on the two sides of a shared face meet in their interiors, if the two
    tetrahedra stand in one of six arrangements (section 5.2). *)
Lemma CompatibilityOrders :
  forall Vertex GetSign GetIntersection f1 f2 f3 p q,
    let P := AllEdgesCompatible Vertex GetSign
               GetIntersection f1 f2 f3 p q in
    P p f1 f2 f3 q f1 f2 f3 /\
    P p f1 f2 f3 f1 q f3 f2 /\
    P f1 p f2 f3 q f1 f3 f2 /\
    P f1 p f2 f3 f1 q f2 f3 /\
    P f1 f2 p f3 f1 f2 q f3 /\
    P f1 f2 f3 p f1 f2 f3 q.
Proof. exact CompatibilityProof.CompatibilityOrders. Qed.

(** The lattice has no other arrangement, so its stencils are compatible across
    the first face of every structured tetrahedron (section 6), *)
Theorem Face1Compatible :
  forall GetSign GetIntersection tid,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 (tid1, order1) _ _ _ =>
        match GetStructuredTet tid1 with
          ST u1 u2 u3 u4 _ _ _ _ =>
            let '(w1, w2, w3, w4) :=
              order1 u1 u2 u3 u4 in
            AllEdgesCompatible Coord3 GetSign
              GetIntersection w2 w3 w4 v1 w1
              v1 v2 v3 v4 u1 u2 u3 u4
        end
    end.
Proof. exact LatticeCompatibilityProof.Face1Compatible. Qed.

(** across the second, *)
Theorem Face2Compatible :
  forall GetSign GetIntersection tid,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 _ (tid2, order2) _ _ =>
        match GetStructuredTet tid2 with
          ST u1 u2 u3 u4 _ _ _ _ =>
            let '(w1, w2, w3, w4) :=
              order2 u1 u2 u3 u4 in
            AllEdgesCompatible Coord3 GetSign
              GetIntersection w1 w3 w4 v2 w2
              v1 v2 v3 v4 u1 u2 u3 u4
        end
    end.
Proof. exact LatticeCompatibilityProof.Face2Compatible. Qed.

(** across the third, *)
Theorem Face3Compatible :
  forall GetSign GetIntersection tid,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 _ _ (tid3, order3) _ =>
        match GetStructuredTet tid3 with
          ST u1 u2 u3 u4 _ _ _ _ =>
            let '(w1, w2, w3, w4) :=
              order3 u1 u2 u3 u4 in
            AllEdgesCompatible Coord3 GetSign
              GetIntersection w1 w2 w4 v3 w3
              v1 v2 v3 v4 u1 u2 u3 u4
        end
    end.
Proof. exact LatticeCompatibilityProof.Face3Compatible. Qed.

(** and across the fourth. *)
Theorem Face4Compatible :
  forall GetSign GetIntersection tid,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 _ _ _ (tid4, order4) =>
        match GetStructuredTet tid4 with
          ST u1 u2 u3 u4 _ _ _ _ =>
            let '(w1, w2, w3, w4) :=
              order4 u1 u2 u3 u4 in
            AllEdgesCompatible Coord3 GetSign
              GetIntersection w1 w2 w3 v4 w4
              v1 v2 v3 v4 u1 u2 u3 u4
        end
    end.
Proof. exact LatticeCompatibilityProof.Face4Compatible. Qed.

(** ** Beyond the paper: the verification is not tied to these stencils *)

(** A stencil set that looks at its vertices through their signs alone, and that
    the checker accepts, is compatible in all six arrangements. *)
Theorem CheckCompatibilitySound :
  forall T : StencilSet,
    Natural T -> CompatibilityChecker.CheckCompatibility T = true ->
    CompatibleStencils T.
Proof. exact CompatibilityCheckerProof.CheckCompatibilitySound. Qed.

(** Another stencil set, with the Parity Rule mirrored, is compatible too. *)
Theorem MirroredStencilsCompatible : CompatibleStencils MirroredStencils.
Proof. exact OtherStencilsProof.MirroredStencilsCompatible. Qed.

(** With one diagonal swapped in one of the 81 patterns, the hole of the first
    marching cubes, the stencils are not compatible, *)
Theorem HoledStencilsIncompatible : ~ CompatibleStencils HoledStencils.
Proof. exact OtherStencilsProof.HoledStencilsIncompatible. Qed.

(** and the checker that certifies stencil sets says so. *)
Theorem HoledStencilsRejected :
  CompatibilityChecker.CheckCompatibility HoledStencils = false.
Proof. exact OtherStencilsProof.HoledStencilsRejected. Qed.

(** ** Beyond the paper: the output is one mesh *)

(** The neighbour's neighbour across the same face is the tetrahedron itself,
    and the two vertex orders undo each other. *)
Theorem NeighborInvolution :
  forall (tid : StructuredTetId) (i : Place),
    let '(nei, order) := NeighborAcross (GetStructuredTet tid) i in
    exists (j : Place) (back_order : VertexOrder),
      VertexAt (GetStructuredTet nei) j
      = LinedUpVertexAt order (GetStructuredTet nei) i /\
      NeighborAcross (GetStructuredTet nei) j = (tid, back_order) /\
      Undoes back_order order /\ Undoes order back_order.
Proof. exact NeighborProof.NeighborInvolution. Qed.

(** A tetrahedron of the output has a corner inside the domain, and none
    outside. *)
Theorem TetrahedraInside :
  forall th sign cut tid t,
    In t (StuffTet th sign cut tid) ->
    (exists v, In v (Corners t) /\ MeshVertexSign th sign cut v = Plus) /\
    (forall v, In v (Corners t) -> MeshVertexSign th sign cut v <> Minus).
Proof. exact MeshProof.TetrahedraInside. Qed.

(** If a face of the lattice has a + corner, both sides divide it into the same
    triangles, whatever the domain and the thresholds. *)
Theorem FaceTriangulationsAgree :
  forall th sign cut tid i,
    let face := FaceOf tid i in
    (exists f, In f face /\ MeshVertexSign th sign cut (Corner f) = Plus) ->
    forall a b c, LiesIn face a -> LiesIn face b -> LiesIn face c ->
      AmongTriangles (StuffTet th sign cut tid) a b c <->
      AmongTriangles (StuffTet th sign cut (NeighborOf tid i)) a b c.
Proof. exact MeshProof.FaceTriangulationsAgree. Qed.

(** Such a triangle belongs to no more than one tetrahedron of either side. *)
Theorem FaceTriangleOnce :
  forall th sign cut tid i t u a b c,
    In t (StuffTet th sign cut tid) -> In u (StuffTet th sign cut tid) ->
    HasTriangle t a b c -> HasTriangle u a b c ->
    LiesIn (FaceOf tid i) a -> LiesIn (FaceOf tid i) b ->
    LiesIn (FaceOf tid i) c ->
    t = u.
Proof. exact MeshProof.FaceTriangleOnce. Qed.

(** A triangle of the output either has its three vertices on the surface, or
    belongs to another tetrahedron of the output as well, in the same structured
    tetrahedron or a face neighbour of it. *)
Theorem BoundaryOnSurface :
  forall th sign cut tid t a b c,
    In t (StuffTet th sign cut tid) -> HasTriangle t a b c ->
    (MeshVertexSign th sign cut a = OnSurface /\
     MeshVertexSign th sign cut b = OnSurface /\
     MeshVertexSign th sign cut c = OnSurface) \/
    (exists u, u <> t /\ HasTriangle u a b c /\
       (In u (StuffTet th sign cut tid) \/
        exists i, In u (StuffTet th sign cut (NeighborOf tid i)))).
Proof. exact MeshProof.BoundaryOnSurface. Qed.

(** ** Beyond the paper: angle bounds

    The bounds on the dihedral angles of the output go here. *)
