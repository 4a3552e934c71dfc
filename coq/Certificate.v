(** * The certificate

    Everything that is proved about the mesher, here or on four pages that this
    one exports.  The first theorem is the one to read: what is certified of every
    mesh that the product makes.  What follows it is the rest, each theorem
    spelled out in full over the functions that are extracted and run; the
    definitions that they speak of are in the files exported here, which hold no
    proofs.  Proof files are only required for the [exact] of each theorem, which
    has the same name there.

    [make audit] checks these statements against the committed ones, and that
    none of them rests on an axiom; but for those in degrees, [CertifiedMesh]
    among them, which rest on the axioms of Coq's real numbers.

    The paper's own list of statements is in [PaperCertificate.v].  That a whole
    mesh embeds, is a manifold and keeps the pieces is in [WholeMeshCertificate.v]:
    no two tetrahedra of it share a point but in the hull of the vertices that they
    share.  What is proved of meshes of several materials is in
    [MaterialCertificate.v], of meshes whose interior is graded in
    [GradingCertificate.v], and of diagonals that follow the cuts in
    [KeyCertificate.v]. *)

(** Read [Mesh/Method.v], the product's methods and the mesh that each makes of a
    domain, and [Mesh/CertifiedSpec.v], a definition for each line below. *)
From Certet Require Export Stuffing.Stuffing Stuffing.Domain.
From Certet Require Export Mesh.Method Mesh.CertifiedSpec.
From Certet Require Mesh.CertifiedMeshProof.

(** Whatever the method, diagonals by key among them, whatever the domain, and
    whichever lattice points are taken as inside: every tetrahedron has positive
    volume; every dihedral angle is within the method's bounds; both sides of a face
    have the same triangles; a triangle that only one tetrahedron has lies on the
    surface; and no integer overflows. *)
Theorem CertifiedMesh :
  forall (method : Method) (sign : SignField) (domain : PositionSigns),
    let mesh := MeshOf method sign domain in
    TetsPositive mesh /\
    AnglesBetween mesh (LeastAngle method) (GreatestAngle method) /\
    FacesConform mesh /\
    BoundaryIsSurface mesh /\
    NothingOverflows mesh (MethodThresholds method).
Proof. exact CertifiedMeshProof.CertifiedMesh. Qed.

(** ** The rest *)

From Coq Require Import ZArith Reals List Permutation.

(** The paper's own statements, those on whole meshes, on several materials, on
    graded interiors, and on diagonals by key. *)
From Certet Require Export PaperCertificate WholeMeshCertificate.
From Certet Require Export MaterialCertificate GradingCertificate.
From Certet Require Export KeyCertificate.

(** What runs, besides [Stuffing]. *)
From Certet Require Export Lattice.Direction.
From Certet Require Export Warp.Cut Warp.Warp.

(** What is meant. *)
From Certet Require Export Lattice.NeighborSpec Lattice.Tiling.
From Certet Require Export Stencil.StencilSet Stencil.TilingSpec.
From Certet Require Export Stencil.OtherStencils.
From Certet Require Export Stencil.TriangleSpec Stuffing.MeshSpec.
From Certet Require Export Warp.WarpSpec.
From Certet Require Export Angles.Geometry Angles.AnglesSpec Angles.DegreesSpec.
From Certet Require Export Range.RangeSpec.

(** Why it holds. *)
From Certet Require Lattice.TilingProof Lattice.NeighborProof.
From Certet Require Lattice.FaceProof.
From Certet Require Stencil.LatticeCompatibilityProof.
From Certet Require Stencil.CompatibilityCheckerProof.
From Certet Require Stencil.OtherStencilsProof.
From Certet Require Stuffing.GappedStencilsProof.
From Certet Require Stuffing.MeshProof Stuffing.OnceProof.
From Certet Require Warp.WarpProof Warp.CutProof.
From Certet Require Angles.ApexProof.
From Certet Require Angles.AngleTheorems Angles.LatticeProof.
From Certet Require Angles.Degrees.DegreesProof Angles.Degrees.SharpnessProof.
From Certet Require Angles.DomainProof Angles.Degrees.DomainDegreesProof.
From Certet Require Range.RangeProof.

Open Scope Z_scope.

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

(** ** Beyond the paper: nor to this lattice

    Read [Lattice/Tiling.v]: tetrahedra, their vertices and their neighbours as
    data. *)

(** Compatible stencils fit any tiling whose neighbours share their faces, and
    are lined up as the lattice's are. *)
Theorem StencilsFitTiling :
  forall (S : StencilSet) (T : Tiling),
    CompatibleStencils S -> TilingFacesCorrect T -> OrdersKnown T ->
    CompatibleInTiling S T.
Proof. exact LatticeCompatibilityProof.StencilsFitTiling. Qed.

(** The lattice is such a tiling, *)
Theorem LatticeFacesCorrect : TilingFacesCorrect LatticeTiling.
Proof. exact TilingProof.LatticeFacesCorrect. Qed.

Theorem LatticeOrdersKnown : OrdersKnown LatticeTiling.
Proof. exact TilingProof.LatticeOrdersKnown. Qed.

(** of tetrahedra with four vertices each, *)
Theorem LatticeVerticesApart : VerticesApart LatticeTiling.
Proof. exact TilingProof.LatticeVerticesApart. Qed.

(** whose neighbours are mutual. *)
Theorem LatticeInvolution : TilingInvolution LatticeTiling.
Proof. exact TilingProof.LatticeInvolution. Qed.

(** ** What compatible edges do not tell

    [TwoEdgesCompatible] is the paper's definition.  It is about two edges that
    are there, and says that they do not cross: not that they are the same, and
    not that there are any.  What closes this gap is [FaceTriangulationsAgree],
    further down: both sides of a face have the same triangles. *)

(** Edges that overlap count as compatible: from a vertex to the cut on an edge,
    and that edge as a whole. *)
Theorem OverlapCompatible :
  forall Vertex GetIntersection (f1 f2 f3 p q : Vertex),
    TwoEdgesCompatible Vertex GetIntersection f1 f2 f3 p q
      f1 (GetIntersection f1 f2) f1 f2.
Proof. exact GappedStencilsProof.OverlapCompatible. Qed.

(** Whatever is left out of compatible stencils, the rest is compatible; no
    tetrahedra at all are. *)
Theorem FewerStencilsCompatible :
  forall T T' : StencilSet,
    CompatibleStencils T ->
    (forall Vertex GetSign GetIntersection v1 v2 v3 v4 t,
       In t (T' Vertex GetSign GetIntersection v1 v2 v3 v4) ->
       In t (T Vertex GetSign GetIntersection v1 v2 v3 v4)) ->
    CompatibleStencils T'.
Proof. exact GappedStencilsProof.FewerStencilsCompatible. Qed.

(** So the paper's stencils less one tetrahedron, in one of the 81 patterns, are
    compatible, *)
Theorem GappedStencilsCompatible : CompatibleStencils GappedStencils.
Proof. exact GappedStencilsProof.GappedStencilsCompatible. Qed.

(** although they leave a hole: of a face with three + corners one side has the
    triangle and the other has not. *)
Theorem GappedStencilsLeaveHole :
  exists (GetSign : MeshVertex -> Sign) (f1 f2 f3 p q : MeshVertex),
    let T := GappedStencils MeshVertex GetSign MeshIntersection in
    GetSign f1 = Plus /\ GetSign f2 = Plus /\ GetSign f3 = Plus /\
    AmongTriangles (T f1 f2 f3 q) f1 f2 f3 /\
    ~ AmongTriangles (T f1 f2 f3 p) f1 f2 f3.
Proof. exact GappedStencilsProof.GappedStencilsLeaveHole. Qed.

(** The checker of triangles, which the paper's stencils pass, says so. *)
Theorem GappedStencilsRejected :
  TriangleChecker.CheckSharedFaces GappedStencils = false.
Proof. exact GappedStencilsProof.GappedStencilsRejected. Qed.

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

(** A face of the lattice belongs to exactly two structured tetrahedra: whoever
    has its three vertices is the one or its neighbour there. *)
Theorem FaceOfTwo :
  forall (tid : StructuredTetId) (i : Place) (other : StructuredTetId),
    InLattice tid -> InLattice other ->
    (forall v, In v (FaceOf tid i) ->
       exists j, v = VertexAt (GetStructuredTet other) j) <->
    other = tid \/ other = NeighborOf tid i.
Proof. exact FaceProof.FaceOfTwo. Qed.

(** The two differ, *)
Theorem NeighborApart :
  forall (tid : StructuredTetId) (i : Place), NeighborOf tid i <> tid.
Proof. exact FaceProof.NeighborApart. Qed.

(** and lie on opposite sides of the face: with the vertices that they have off
    it, its triangle makes volumes of opposite signs. *)
Theorem FaceSides :
  forall (tid : StructuredTetId) (i : Place),
    let '(nei, order) := NeighborAcross (GetStructuredTet tid) i in
    match FaceOf tid i with
    | (a :: b :: c :: nil)%list =>
        SixVolume a b c (VertexAt (GetStructuredTet tid) i)
        * SixVolume a b c (LinedUpVertexAt order (GetStructuredTet nei) i) < 0
    | _ => False
    end.
Proof. exact ApexProof.FaceSides. Qed.

(** The neighbours of a tetrahedron in the lattice are in the lattice. *)
Theorem NeighborInLattice :
  forall (tid : StructuredTetId) (i : Place),
    InLattice tid -> InLattice (NeighborOf tid i).
Proof. exact FaceProof.NeighborInLattice. Qed.

(** A tetrahedron of the output has a corner inside the domain, and none
    outside. *)
Theorem TetrahedraInside :
  forall th sign cut tid t,
    In t (StuffTet th sign cut tid) ->
    (exists v, In v (TetCorners t) /\ MeshVertexSign th sign cut v = Plus) /\
    (forall v, In v (TetCorners t) -> MeshVertexSign th sign cut v <> Minus).
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

(** No tetrahedron is made twice within a structured one, *)
Theorem StuffTetNoDup :
  forall th sign cut tid, NoDup (StuffTet th sign cut tid).
Proof. exact OnceProof.StuffTetNoDup. Qed.

(** nor anywhere in the lattice: not even the same four corners in another
    order. *)
Theorem TetrahedraDiffer :
  forall th sign cut tid other t u,
    InLattice tid -> InLattice other ->
    In t (StuffTet th sign cut tid) -> In u (StuffTet th sign cut other) ->
    (forall v, In v (TetCorners t) -> In v (TetCorners u)) ->
    tid = other /\ t = u.
Proof. exact OnceProof.TetrahedraDiffer. Qed.

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

(** ** Beyond the paper: where edges are cut

    Read [Warp/Cut.v], and [Stuffing/Domain.v] for the two ways to cut. *)

(** Bisection, of any signs and with any number of rounds, ends on the surface,
    or between a point that is inside or the start, and one a step farther that
    is outside or the end. *)
Theorem BisectFromFinds :
  forall sign rounds lo,
    let t := BisectFrom sign rounds lo in
    let hi := lo + 2 ^ Z.of_nat rounds in
    lo <= t < hi /\
    (sign t = OnSurface \/
     (t = lo \/ sign t = Plus) /\ (t + 1 = hi \/ sign (t + 1) = Minus)).
Proof. exact CutProof.BisectFromFinds. Qed.

(** The cut of an edge lies on the edge, never at its - end; and at its + end
    only if all sixteen points that are looked at are outside.  Such a cut does
    not outlive warping: see [KeptCutsInside]. *)
Theorem BisectOnEdge :
  forall sign,
    0 <= Bisect sign < Steps /\
    (Bisect sign = 0 <->
     forall k, (k < StepBits)%nat -> sign (2 ^ Z.of_nat k) = Minus).
Proof. exact CutProof.BisectOnEdge. Qed.

(** A domain that is + at one end of an edge and - at the other is cut on its
    surface, or where it is + and is - one step farther. *)
Theorem BisectedCutsFind :
  forall domain a b,
    SampledSigns domain a = Plus -> SampledSigns domain b = Minus ->
    let t := BisectedCuts domain a b in
    let at_step s := domain (PointOnEdge a b s) in
    at_step t = OnSurface \/ at_step t = Plus /\ at_step (t + 1) = Minus.
Proof. exact DomainProof.BisectedCutsFind. Qed.

(** Whatever the signs, cuts found by bisection lie on their edges, which the
    theorems on angles ask for, *)
Theorem BisectedOnEdges :
  forall sign domain, CutsOnEdges sign (BisectedCuts domain).
Proof. exact DomainProof.BisectedOnEdges. Qed.

(** and so do cuts in the middle. *)
Theorem MidpointOnEdges : forall sign, CutsOnEdges sign MidpointCuts.
Proof. exact DomainProof.MidpointOnEdges. Qed.

(** A cut that is a vertex of the output lies strictly between a + end and a -
    end. *)
Theorem KeptCutsInside :
  forall th sign cut tid t p m,
    th = AngleThresholds \/ th = EmbeddingThresholds -> CutsOnEdges sign cut ->
    In t (StuffTet th sign cut tid) -> In (Cut p m) (TetCorners t) ->
    sign p = Plus /\ sign m = Minus /\ 0 < cut p m < Steps.
Proof. exact DomainProof.KeptCutsInside. Qed.

(** With cuts in the middle no vertex is warped. *)
Theorem MidpointNeverWarps :
  forall sign v,
    WarpVertex NoWarpThresholds (Decided sign) MidpointCuts v = Stays.
Proof. exact DomainProof.MidpointNeverWarps. Qed.

(** ** Beyond the paper: the bounds on the dihedral angles

    Read [Angles/Geometry.v] (volumes and angles in integers),
    [Angles/AnglesSpec.v] (what warping may leave behind) and
    [Angles/DegreesSpec.v] (angles in degrees). *)

(** A vertex stays only if nothing violates it, and moves only to the nearest
    violating cut. *)
Theorem WarpIsCorrect :
  forall th sign neighbor_sign cut,
    match Warp th sign neighbor_sign cut with
    | Stays => forall d, Violates th sign neighbor_sign cut d = false
    | Moves d t =>
        t = cut d /\ Violates th sign neighbor_sign cut d = true /\
        forall e, Violates th sign neighbor_sign cut e = true ->
          CutDistanceSquared cut d <= CutDistanceSquared cut e
    end.
Proof. exact WarpProof.WarpIsCorrect. Qed.

(** Of violating cuts that are equally near, the one whose direction comes first
    in [AllDirections] wins. *)
Theorem WarpNearest :
  forall th sign neighbor_sign cut,
    match Warp th sign neighbor_sign cut with
    | Stays => forall d, Violates th sign neighbor_sign cut d = false
    | Moves d t =>
        t = cut d /\ Violates th sign neighbor_sign cut d = true /\
        FirstNearest (Violates th sign neighbor_sign cut) cut AllDirections d
    end.
Proof. exact WarpProof.WarpNearest. Qed.

(** No two directions can win, so nothing is left open. *)
Theorem FirstNearestUnique :
  forall violates cut d e,
    violates d = true -> violates e = true ->
    FirstNearest violates cut AllDirections d ->
    FirstNearest violates cut AllDirections e -> d = e.
Proof. exact WarpProof.FirstNearestUnique. Qed.

(** What [Warp] leaves around any structured tetrahedron is admissible, for
    every domain. *)
Theorem WarpIsAdmissible :
  forall th sign cut tid,
    AtMostHalf th -> CutsOnEdges sign cut ->
    Admissible sign (WarpVertex th sign cut) cut th (Corners tid).
Proof. exact AngleTheorems.WarpIsAdmissible. Qed.

(** Whatever is admissible gives tetrahedra of positive volume, *)
Theorem PositiveVolume :
  forall th tid before warping cut t,
    th = AngleThresholds \/ th = EmbeddingThresholds ->
    Admissible before warping cut th (Corners tid) ->
    In t (PlacedTets before warping cut tid) -> Positive t.
Proof. exact AngleTheorems.PositiveVolume. Qed.

(** whose dihedral angles are between 10.77 and 164.76 degrees at the thresholds
    73/256 and 102/256, as integers tell it: cot^2 10.77 > 221/8 and
    cot^2 164.76 > 1751/130; *)
Theorem DihedralBounds :
  forall tid before warping cut,
    Admissible before warping cut AngleThresholds (Corners tid) ->
    forall t, In t (PlacedTets before warping cut tid) ->
      WellShaped (AB (CotSq 221 8) (CotSq 1751 130)) t.
Proof. exact AngleTheorems.DihedralBounds. Qed.

(** and between 9.27 and 161.46 degrees at 64/256 and 105/256. *)
Theorem DihedralBoundsEmbedding :
  forall tid before warping cut,
    Admissible before warping cut EmbeddingThresholds (Corners tid) ->
    forall t, In t (PlacedTets before warping cut tid) ->
      WellShaped (AB (CotSq 563 15) (CotSq 80 9)) t.
Proof. exact AngleTheorems.DihedralBoundsEmbedding. Qed.

(** A domain that is in or out, cut in the middle of its edges: the squares of
    the cotangents are at most 3 and 1. *)
Theorem MidpointBounds :
  forall sign tid t,
    let decided v := InOrOut (sign v) in
    let cut (_ _ : Coord3) := MidpointCut in
    In t (map (MapTet (MeshPosition NoWarpThresholds decided cut))
            (StuffTet NoWarpThresholds decided cut tid)) ->
    WellShaped (AB (CotSq 3 1) (CotSq 1 1)) t.
Proof. exact AngleTheorems.MidpointBounds. Qed.

(** The theorem that users read: every tetrahedron that the product makes, of
    any domain, has positive volume and dihedral angles between 10.77 and
    164.76 degrees, *)
Theorem DihedralBoundsInDegrees :
  forall sign cut tid t, CutsOnEdges sign cut ->
    In t (map (MapTet (MeshPosition AngleThresholds sign cut))
            (StuffTet AngleThresholds sign cut tid)) ->
    WithinDegrees (1077 / 100) (16476 / 100) t.
Proof. exact DegreesProof.DihedralBoundsInDegrees. Qed.

(** between 9.27 and 161.46 degrees with the thresholds that embed, *)
Theorem DihedralBoundsEmbeddingInDegrees :
  forall sign cut tid t, CutsOnEdges sign cut ->
    In t (map (MapTet (MeshPosition EmbeddingThresholds sign cut))
            (StuffTet EmbeddingThresholds sign cut tid)) ->
    WithinDegrees (927 / 100) (16146 / 100) t.
Proof. exact DegreesProof.DihedralBoundsEmbeddingInDegrees. Qed.

(** and between 30 and 135 degrees with cuts in the middle. *)
Theorem MidpointBoundsInDegrees :
  forall sign tid t,
    let decided v := InOrOut (sign v) in
    let cut (_ _ : Coord3) := MidpointCut in
    In t (map (MapTet (MeshPosition NoWarpThresholds decided cut))
            (StuffTet NoWarpThresholds decided cut tid)) ->
    WithinDegrees 30 135 t.
Proof. exact DegreesProof.MidpointBoundsInDegrees. Qed.

(** At 64/256 and 105/256 no structured tetrahedron, kept or dropped, is turned
    over by warping: what is dropped never covers what is kept. *)
Theorem WarpedLatticePositive :
  forall sign cut tid, CutsOnEdges sign cut ->
    Positive (WarpedTet EmbeddingThresholds sign cut tid).
Proof. exact LatticeProof.WarpedLatticePositive. Qed.

(** No bound can be improved by 0.02 degrees: there are domains of which the
    product itself makes such angles. *)
Theorem BoundsAreSharp :
  (exists sign cut tid t p q r s,
     CutsOnEdges sign cut /\ In t (StuffedTets AngleThresholds sign cut tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     (DihedralDegrees p q r s <= 1079 / 100)%R) /\
  (exists sign cut tid t p q r s,
     CutsOnEdges sign cut /\ In t (StuffedTets AngleThresholds sign cut tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     (16474 / 100 <= DihedralDegrees p q r s)%R) /\
  (exists sign cut tid t p q r s,
     CutsOnEdges sign cut /\
     In t (StuffedTets EmbeddingThresholds sign cut tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     (DihedralDegrees p q r s <= 929 / 100)%R) /\
  (exists sign cut tid t p q r s,
     CutsOnEdges sign cut /\
     In t (StuffedTets EmbeddingThresholds sign cut tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     (16144 / 100 <= DihedralDegrees p q r s)%R).
Proof. exact SharpnessProof.BoundsAreSharp. Qed.

(** The bounds for cuts in the middle are attained: the square of a cotangent is
    3 at an acute angle, and 1 at an obtuse one; *)
Theorem MidpointBoundsAttained :
  (exists sign tid t p q r s,
     In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     0 < NormalsProduct p q r s /\
     NormalsProduct p q r s ^ 2
       = 3 * (SixVolume p q r s ^ 2 * EdgeSquared p q)) /\
  (exists sign tid t p q r s,
     In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     NormalsProduct p q r s < 0 /\
     NormalsProduct p q r s ^ 2 = SixVolume p q r s ^ 2 * EdgeSquared p q).
Proof. exact DomainDegreesProof.MidpointBoundsAttained. Qed.

(** these are 30 and 135 degrees. *)
Theorem MidpointBoundsAreSharp :
  (exists sign tid t p q r s,
     In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) /\
     In (p, q, r, s) (DihedralEdges t) /\ (DihedralDegrees p q r s = 30)%R) /\
  (exists sign tid t p q r s,
     In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) /\
     In (p, q, r, s) (DihedralEdges t) /\ (DihedralDegrees p q r s = 135)%R).
Proof. exact DomainDegreesProof.MidpointBoundsAreSharp. Qed.

(** The case analysis behind the bounds: 14,717 configurations, 89,430 dihedral
    angles, enumerated from [GetUnstructuredTets]. *)
Theorem ConfigurationsCounted :
  AngleTheorems.CountConfigurations = 14717 /\
  AngleTheorems.CountAngles = 89430.
Proof. exact AngleTheorems.ConfigurationsCounted. Qed.

(** ** Beyond the paper: no overflow

    Read [Range/RangeSpec.v]: the formulas of the production library, and what
    it means that every intermediate value of a formula fits its type. *)

(** A lattice is checked once, at the door: if it begins and ends within
    [AnchorLimit], all its points, computed in 32 bits, are within
    [LatticeLimit]; and the check itself, in 64 bits, cannot overflow, *)
Theorem DoorSuffices :
  forall low cells, InType 32 low -> InType 32 cells ->
    Fits 64 (DoorFormula low cells) /\
    (- AnchorLimit <= low -> Value (DoorFormula low cells) <= AnchorLimit ->
     forall i shift grid,
       0 <= i < cells -> - 1 <= shift <= 1 -> 0 <= grid <= 1 ->
       Fits 32 (LatticePointFormula low i shift grid) /\
       - LatticeLimit <= Value (LatticePointFormula low i shift grid)
         <= LatticeLimit).
Proof. exact RangeProof.DoorSuffices. Qed.

(** and so are the vertices of whatever stands within [AnchorLimit], in a tiling
    that reaches no farther than the 8 units between the two limits. *)
Theorem TilingCornersInRange :
  forall (T : Tiling) reach (id : Identifier T) v,
    TilingReaches reach T -> reach <= LatticeLimit - AnchorLimit ->
    Bounded AnchorLimit (AnchorOf id) -> In v (VerticesOf T id) ->
    Bounded LatticeLimit v.
Proof. exact RangeProof.TilingCornersInRange. Qed.

(** The lattice reaches 3 units far, *)
Theorem LatticeReaches : TilingReaches 3 LatticeTiling.
Proof. exact RangeProof.LatticeReaches. Qed.

(** so that this goes for the corners of every structured tetrahedron with an
    anchor within [AnchorLimit]. *)
Theorem CornersInRange :
  forall anchor case v,
    Bounded AnchorLimit anchor -> In v (Corners (STId anchor case)) ->
    Bounded LatticeLimit v.
Proof. exact RangeProof.CornersInRange. Qed.

(** From such points, the position of a warped vertex is computed in 32 bits, *)
Theorem WarpedFits :
  forall v d t k, Bounded LatticeLimit v -> 0 <= t <= Steps ->
    Computes 32 (WarpedFormula (Along k v) t (Along k (Offset d)))
      (Along k (WarpedPosition v (Moves d t))).
Proof. exact RangeProof.WarpedFits. Qed.

(** that of a cut, *)
Theorem CutFits :
  forall v d t k, Bounded LatticeLimit v -> 0 <= t <= Steps ->
    let u := Translate v (Offset d) in
    Computes 32 (CutFormula (Along k v) (Along k u) t)
      (Along k (PointOnEdge v u t)).
Proof. exact RangeProof.CutFits. Qed.

(** and those that bisection looks at. *)
Theorem MiddleFits :
  forall v d low half k,
    Bounded LatticeLimit v -> 0 <= low -> 0 <= half -> low + half <= Steps ->
    let u := Translate v (Offset d) in
    Computes 32 (MiddleFormula (Along k v) (Along k u) low half)
      (Along k (PointOnEdge v u (low + half))).
Proof. exact RangeProof.MiddleFits. Qed.

(** Warping compares steps in 32 bits, and squares of distances in 64. *)
Theorem DecisionsFit :
  forall th k t,
    th = AngleThresholds \/ th = EmbeddingThresholds \/ th = NoWarpThresholds ->
    0 <= t <= Steps ->
    let 'TH long short := th in
    Computes 32
      (ThresholdFormula (match k with Long => long | Short => short end))
      (ThresholdSteps th k) /\
    Computes 32 (OtherEndFormula t) (Steps - t) /\
    Computes 64 (DistanceFormula (LengthSquared k) t)
      (LengthSquared k * (t * t)).
Proof. exact RangeProof.DecisionsFit. Qed.

(** Volumes are computed in 64 bits, whatever the tetrahedron, if its edges from
    the first vertex are no longer than [WidthLimit] along any axis; *)
Theorem VolumesFit :
  forall a b c d,
    (forall p, In p (a :: b :: c :: d :: nil)%list ->
       forall k, InType 32 (Along k p)) ->
    Bounded WidthLimit (Difference a b) ->
    Bounded WidthLimit (Difference a c) ->
    Bounded WidthLimit (Difference a d) ->
    Computes 64 (SixVolumeFormula a b c d) (SixVolume a b c d) /\
    Computes 64 (DeterminantFormula a b c d) (SixVolume a b c d).
Proof. exact RangeProof.VolumesFit. Qed.

(** Between vertices that are made of corners no farther apart than some width,
    they are two units longer at most; so that a tiling may be six units wide,
    which with two more are [WidthLimit]. *)
Theorem PlacedNarrow :
  forall before warping cut width corners,
    NoWider width corners -> Moderate before warping cut corners ->
    forall m n,
      OfCorners before warping corners m ->
      OfCorners before warping corners n ->
      Bounded ((width + 2) * Steps)
        (Difference (PlacedPosition warping cut m)
                    (PlacedPosition warping cut n)).
Proof. exact RangeProof.PlacedNarrow. Qed.

(** The lattice is two units wide, *)
Theorem LatticeNoWider : TilingNoWider 2 LatticeTiling.
Proof. exact RangeProof.LatticeNoWider. Qed.

(** so that edges of the output, and of the warped lattice, are half as long. *)
Theorem TetsNarrow :
  forall th sign cut, AtMostHalf th -> CutsOnEdges sign cut ->
    forall tid t,
      t = WarpedTet th sign cut tid \/ In t (StuffedTets th sign cut tid) ->
      match t with
        UT _ a b c d =>
          Bounded (4 * Steps) (Difference a b) /\
          Bounded (4 * Steps) (Difference a c) /\
          Bounded (4 * Steps) (Difference a d)
      end.
Proof. exact RangeProof.TetsNarrow. Qed.

(** ** Beyond the paper: the product's own cuts

    The theorems above that ask for cuts on edges, without asking: whatever the
    domain, and whichever lattice points are taken as inside and outside. *)

(** What warping leaves is admissible; *)
Corollary BisectedWarpIsAdmissible :
  forall th sign domain tid, AtMostHalf th ->
    Admissible sign (WarpVertex th sign (BisectedCuts domain))
      (BisectedCuts domain) th (Corners tid).
Proof. exact DomainProof.BisectedWarpIsAdmissible. Qed.

(** every tetrahedron has positive volume, *)
Corollary BisectedPositiveVolume :
  forall th sign domain tid t,
    th = AngleThresholds \/ th = EmbeddingThresholds ->
    In t (StuffedTets th sign (BisectedCuts domain) tid) -> Positive t.
Proof. exact DomainProof.BisectedPositiveVolume. Qed.

(** and dihedral angles within the bounds, as integers tell it, *)
Corollary BisectedBounds :
  forall sign domain tid t,
    In t (StuffedTets AngleThresholds sign (BisectedCuts domain) tid) ->
    WellShaped (AB (CotSq 221 8) (CotSq 1751 130)) t.
Proof. exact DomainProof.BisectedBounds. Qed.

Corollary BisectedBoundsEmbedding :
  forall sign domain tid t,
    In t (StuffedTets EmbeddingThresholds sign (BisectedCuts domain) tid) ->
    WellShaped (AB (CotSq 563 15) (CotSq 80 9)) t.
Proof. exact DomainProof.BisectedBoundsEmbedding. Qed.

(** and in degrees; *)
Corollary BisectedBoundsInDegrees :
  forall sign domain tid t,
    In t (StuffedTets AngleThresholds sign (BisectedCuts domain) tid) ->
    WithinDegrees (1077 / 100) (16476 / 100) t.
Proof. exact DomainDegreesProof.BisectedBoundsInDegrees. Qed.

Corollary BisectedBoundsEmbeddingInDegrees :
  forall sign domain tid t,
    In t (StuffedTets EmbeddingThresholds sign (BisectedCuts domain) tid) ->
    WithinDegrees (927 / 100) (16146 / 100) t.
Proof. exact DomainDegreesProof.BisectedBoundsEmbeddingInDegrees. Qed.

(** which bisected domains come as near to as [BoundsAreSharp] says, with the
    signs of their own. *)
Corollary BisectedBoundsAreSharp :
  (exists domain tid t p q r s,
     In t (StuffedTets AngleThresholds (SampledSigns domain)
             (BisectedCuts domain) tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     (DihedralDegrees p q r s <= 1079 / 100)%R) /\
  (exists domain tid t p q r s,
     In t (StuffedTets AngleThresholds (SampledSigns domain)
             (BisectedCuts domain) tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     (16474 / 100 <= DihedralDegrees p q r s)%R) /\
  (exists domain tid t p q r s,
     In t (StuffedTets EmbeddingThresholds (SampledSigns domain)
             (BisectedCuts domain) tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     (DihedralDegrees p q r s <= 929 / 100)%R) /\
  (exists domain tid t p q r s,
     In t (StuffedTets EmbeddingThresholds (SampledSigns domain)
             (BisectedCuts domain) tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     (16144 / 100 <= DihedralDegrees p q r s)%R).
Proof. exact DomainDegreesProof.BisectedBoundsAreSharp. Qed.

(** With the thresholds that embed, warping turns no structured tetrahedron
    over. *)
Corollary BisectedLatticePositive :
  forall sign domain tid,
    Positive (WarpedTet EmbeddingThresholds sign (BisectedCuts domain) tid).
Proof. exact DomainProof.BisectedLatticePositive. Qed.

(** All tetrahedra are narrow enough for [VolumesFit]. *)
Corollary BisectedTetsNarrow :
  forall th sign domain, AtMostHalf th ->
    forall tid t,
      t = WarpedTet th sign (BisectedCuts domain) tid \/
      In t (StuffedTets th sign (BisectedCuts domain) tid) ->
      match t with
        UT _ a b c d =>
          Bounded (4 * Steps) (Difference a b) /\
          Bounded (4 * Steps) (Difference a c) /\
          Bounded (4 * Steps) (Difference a d)
      end.
Proof. exact RangeProof.BisectedTetsNarrow. Qed.

(** Cut in the middle, they have positive volume too, *)
Corollary MidpointPositiveVolume :
  forall sign tid t,
    In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) ->
    Positive t.
Proof. exact DomainProof.MidpointPositiveVolume. Qed.

(** and are as narrow. *)
Corollary MidpointTetsNarrow :
  forall sign tid t,
    t = WarpedTet NoWarpThresholds (Decided sign) MidpointCuts tid \/
    In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) ->
    match t with
      UT _ a b c d =>
        Bounded (4 * Steps) (Difference a b) /\
        Bounded (4 * Steps) (Difference a c) /\
        Bounded (4 * Steps) (Difference a d)
    end.
Proof. exact RangeProof.MidpointTetsNarrow. Qed.
