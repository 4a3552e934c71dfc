(** * The certificate

    Everything that is proved about the mesher, on one page.  The first theorem
    is the one to read: what is certified of every mesh that the product makes.
    What follows it is the rest, each theorem spelled out in full over the
    functions that are extracted and run; the definitions that they speak of are
    in the files exported here, which hold no proofs.  Proof files are only
    required for the [exact] of each theorem, which has the same name there.

    [make audit] checks these statements against the committed ones, and that
    none of them rests on an axiom; but for those in degrees, [CertifiedMesh]
    among them, which rest on the axioms of Coq's real numbers.

    The paper's own list of statements is in [PaperCertificate.v], and what is
    proved of meshes of several materials in [MaterialCertificate.v]. *)

(** Read [Mesh/Method.v], the product's methods and the mesh that each makes of a
    domain, and [Mesh/CertifiedSpec.v], a definition for each line below. *)
From Certet Require Export Stuffing.Stuffing Stuffing.Domain.
From Certet Require Export Mesh.Method Mesh.CertifiedSpec.
From Certet Require Mesh.CertifiedMeshProof.

(** Whatever the method, whatever the domain, and whichever lattice points are
    taken as inside: every tetrahedron has positive volume; every dihedral angle
    is within the method's bounds; both sides of a face have the same triangles;
    a triangle that only one tetrahedron has lies on the surface; and no integer
    overflows. *)
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

(** The paper's own statements, and those on several materials. *)
From Certet Require Export PaperCertificate MaterialCertificate.

(** What runs, besides [Stuffing]. *)
From Certet Require Export Lattice.Direction.
From Certet Require Export Warp.Cut Warp.Warp.

(** A warp with a rule of who stays: by turns, as no program runs it, and as one
    sweep over a list, which is what runs. *)
From Certet Require Export Embedding.WarpOrClamp Embedding.DiskRule.
From Certet Require Export Embedding.DiskTables Embedding.Settle.

(** What is meant. *)
From Certet Require Export Lattice.NeighborSpec Lattice.Tiling.
From Certet Require Export Stencil.StencilSet Stencil.TilingSpec.
From Certet Require Export Stencil.OtherStencils.
From Certet Require Export Stencil.TriangleSpec Stuffing.MeshSpec.
From Certet Require Export Warp.WarpSpec.
From Certet Require Export Angles.Geometry Angles.AnglesSpec Angles.DegreesSpec.
From Certet Require Export Embedding.EmbeddingSpec Embedding.PiecesSpec.
From Certet Require Export Embedding.SettleSpec.
From Certet Require Export Topology.SurfaceSpec Topology.TwoSidesSpec.
From Certet Require Export Topology.VoxelSpec.
From Certet Require Export Range.RangeSpec.

(** Why it holds. *)
From Certet Require Lattice.TilingProof Lattice.NeighborProof.
From Certet Require Lattice.FaceProof.
From Certet Require Stencil.LatticeCompatibilityProof.
From Certet Require Stencil.CompatibilityChecker.
From Certet Require Stencil.CompatibilityCheckerProof.
From Certet Require Stencil.OtherStencilsProof.
From Certet Require Stencil.TriangleChecker Stuffing.GappedStencilsProof.
From Certet Require Stuffing.MeshProof Stuffing.OnceProof.
From Certet Require Warp.WarpProof Warp.CutProof.
From Certet Require Angles.ApexProof.
From Certet Require Angles.AngleTheorems Angles.LatticeProof.
From Certet Require Angles.Degrees.DegreesProof Angles.Degrees.SharpnessProof.
From Certet Require Angles.DomainProof Angles.Degrees.DomainDegreesProof.
From Certet Require Embedding.WarpedLatticeProof Embedding.MeshEmbedsProof.
From Certet Require Embedding.LatticeVolumeProof.
From Certet Require Embedding.LatticeCoversProof.
From Certet Require Embedding.MeshApartProof Embedding.FoldWitness.
From Certet Require Embedding.WarpOrClampProof Embedding.RuledMeshProof.
From Certet Require Embedding.RuledDegreesProof.
From Certet Require Embedding.PiecesProof Embedding.DiskPiecesProof.
From Certet Require Embedding.DiskTablesProof Embedding.SettleProof.
From Certet Require Embedding.SettledMeshProof Embedding.SettleOrderProof.
From Certet Require Topology.EdgeProof Topology.DiskKeptProof.
From Certet Require Topology.DiskManifoldProof Topology.SettledSurfaceProof.
From Certet Require Topology.TwoSidesFillProof Topology.TwoSidesMeetProof.
From Certet Require Topology.SettledTwoSidesProof.
From Certet Require Topology.VoxelProof Topology.VoxelMeshProof.
From Certet Require Topology.SettledVoxelProof.
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

(** ** Beyond the paper: the whole mesh

    Read [Embedding/EmbeddingSpec.v] (points of tetrahedra by integer weights,
    and what it means that two of them meet in what they share) and
    [Embedding/WarpOrClamp.v] (the warp with a rule of who stays). *)

(** Wherever the lattice points are put, if no short edge is turned over along
    any axis, the structured tetrahedra meet in the vertices they share; and
    alpha at most 1/4 of a long edge and 1/2 of a short one turns none over. *)
Theorem WarpedLatticeEmbeds :
  forall long short sign cut tid tid',
    long <= 64 -> short <= 128 -> CutsOnEdges sign cut ->
    InLattice tid -> InLattice tid' ->
    MeetInSharedVertices (WarpedPlace (TH long short) sign cut)
      (LatticeTet tid) (LatticeTet tid').
Proof. exact WarpedLatticeProof.WarpedLatticeEmbeds. Qed.

(** Nor is any of them turned over, kept or dropped. *)
Theorem KeptVolume :
  forall place tid, KeepsShortEdges place -> KeepsHand place tid.
Proof. exact LatticeVolumeProof.KeptVolume. Qed.

(** And they leave no gaps: every rational point, [x] over [m], is in one. *)
Theorem WarpedLatticeCovers :
  forall long short sign cut m x,
    long <= 64 -> short <= 128 -> CutsOnEdges sign cut -> 0 < m ->
    exists tid w, InLattice tid /\ NonNegative w /\ 0 < Total w /\
      Scale m (PointOf w
        (MapTet (WarpedPlace (TH long short) sign cut) (LatticeTet tid)))
      = Scale (Total w) x.
Proof. exact LatticeCoversProof.WarpedLatticeCovers. Qed.

(** The mesh embeds: any two of its tetrahedra meet exactly in the hull of the
    vertices they share.  A point that they have in common is a weighted mean of
    vertices of both, with the same weights seen from either side. *)
Theorem MeshEmbeds :
  forall long short sign cut tid tid' t t',
    0 < long <= 64 -> 0 < short <= 128 -> CutsOnEdges sign cut ->
    InLattice tid -> InLattice tid' ->
    In t (StuffTet (TH long short) sign cut tid) ->
    In t' (StuffTet (TH long short) sign cut tid') ->
    forall w w', NonNegative w -> NonNegative w' -> Total w = Total w' ->
      PointOf w (MapTet (MeshPosition (TH long short) sign cut) t)
      = PointOf w' (MapTet (MeshPosition (TH long short) sign cut) t') ->
      forall g : MeshVertex -> Z, Weigh g w t = Weigh g w' t'.
Proof. exact MeshEmbedsProof.MeshEmbeds. Qed.

(** No point is inside two of them. *)
Theorem InteriorsApart :
  forall long short sign cut tid tid' t t',
    0 < long <= 64 -> 0 < short <= 128 -> CutsOnEdges sign cut ->
    InLattice tid -> InLattice tid' ->
    In t (StuffTet (TH long short) sign cut tid) ->
    In t' (StuffTet (TH long short) sign cut tid') ->
    Overlap (MapTet (MeshPosition (TH long short) sign cut) t)
            (MapTet (MeshPosition (TH long short) sign cut) t') ->
    tid = tid' /\ t = t'.
Proof. exact MeshApartProof.InteriorsApart. Qed.

(** The same mesh of a domain that is in or out, cut in the middle of its
    edges. *)
Theorem MidpointMeshEmbeds :
  forall sign tid tid' t t',
    let decided v := InOrOut (sign v) in
    let cut (_ _ : Coord3) := MidpointCut in
    InLattice tid -> InLattice tid' ->
    In t (StuffTet NoWarpThresholds decided cut tid) ->
    In t' (StuffTet NoWarpThresholds decided cut tid') ->
    MeetInSharedVertices (MeshPosition NoWarpThresholds decided cut) t t'.
Proof. exact MeshEmbedsProof.MidpointMeshEmbeds. Qed.

(** At 73/256 of a long edge there are domains of which two kept tetrahedra
    overlap, *)
Theorem AngleThresholdsFold : SomeMeshFolds AngleThresholds.
Proof. exact FoldWitness.AngleThresholdsFold. Qed.

(** and at 65/256 already: 64 is sharp for the paper's warp. *)
Theorem SixtyFiveFolds : SomeMeshFolds (TH 65 105).
Proof. exact FoldWitness.SixtyFiveFolds. Qed.

(** Moves of at most 73/256 and 102/256 keep the short edges if they cross
    none, *)
Theorem UncrossedKeepsShortEdges :
  forall warping,
    MovesAtMost AngleThresholds warping -> Uncrossed warping ->
    KeepsShortEdges (fun v => WarpedPosition v (warping v)).
Proof. exact WarpedLatticeProof.UncrossedKeepsShortEdges. Qed.

(** so that the structured tetrahedra leave no gaps either, *)
Theorem UncrossedLatticeCovers :
  forall warping m x,
    MovesAtMost AngleThresholds warping -> Uncrossed warping -> 0 < m ->
    exists tid w, InLattice tid /\ NonNegative w /\ 0 < Total w /\
      Scale m (PointOf w
        (MapTet (fun v => WarpedPosition v (warping v)) (LatticeTet tid)))
      = Scale (Total w) x.
Proof. exact LatticeCoversProof.UncrossedLatticeCovers. Qed.

(** and then the mesh embeds: if ends of a short edge that move towards each other
    along parallel long edges move by less than half a long edge together. *)
Theorem PlacedEmbeds :
  forall before warping cut tid tid' t t',
    MovesAtMost AngleThresholds warping -> Uncrossed warping ->
    CutsInside before warping cut -> InLattice tid -> InLattice tid' ->
    In t (PlacedNames before warping tid) ->
    In t' (PlacedNames before warping tid') ->
    MeetInSharedVertices (PlacedPosition warping cut) t t'.
Proof. exact MeshEmbedsProof.PlacedEmbeds. Qed.

(** ** Beyond the paper: any violated vertex may stay

    [stays] and [limit] are whatever a rule makes of the domain. *)

(** Whoever stays, and however the moves of the others are shortened: what is
    left is admissible when cuts are kept alpha away from the ends, *)
Theorem AnySubsetStays :
  forall th sign cut stays limit tid,
    AtMostHalf th -> CutsOnEdges sign cut ->
    Admissible sign (RuledWarping th sign cut stays limit)
      (ClampedCut th cut) th (Corners tid).
Proof. exact WarpOrClampProof.AnySubsetStays. Qed.

(** so that every tetrahedron has positive volume and dihedral angles between
    10.77 and 164.76 degrees, as integers tell it *)
Theorem RuledBounds :
  forall sign cut stays limit, CutsOnEdges sign cut ->
    forall tid t,
      In t (WarpOrClamp AngleThresholds sign cut stays limit tid) ->
      WellShaped (AB (CotSq 221 8) (CotSq 1751 130)) t.
Proof. exact RuledMeshProof.RuledBounds. Qed.

(** and in degrees. *)
Theorem RuledBoundsInDegrees :
  forall sign cut stays limit tid t, CutsOnEdges sign cut ->
    In t (WarpOrClamp AngleThresholds sign cut stays limit tid) ->
    WithinDegrees (1077 / 100) (16476 / 100) t.
Proof. exact RuledDegreesProof.RuledBoundsInDegrees. Qed.

(** The rest of [CertifiedMesh] holds as well. *)
Theorem CertifiedRuledMesh :
  forall sign cut stays limit, CutsOnEdges sign cut ->
    let mesh := RuledMesh AngleThresholds sign cut stays limit in
    TetsPositive mesh /\
    AnglesBetween mesh 1077 16476 /\
    FacesConform mesh /\
    BoundaryIsSurface mesh /\
    NothingOverflows mesh AngleThresholds.
Proof. exact CertifiedMeshProof.CertifiedRuledMesh. Qed.

(** The paper's rule is the one by which nobody stays. *)
Theorem NobodyStays :
  forall th sign cut tid,
    AtMostHalf th -> CutsOnEdges sign cut -> InLattice tid ->
    WarpOrClamp th sign cut (fun _ => false) (fun _ => Steps) tid
    = StuffedTets th sign cut tid.
Proof. exact WarpOrClampProof.NobodyStays. Qed.

(** A rule that crosses no short edge gives a mesh that embeds. *)
Theorem RuledMeshEmbeds :
  forall sign cut stays limit, CutsOnEdges sign cut ->
    forall tid tid' t t',
      let warping := RuledWarping AngleThresholds sign cut stays limit in
      Uncrossed warping -> InLattice tid -> InLattice tid' ->
      In t (PlacedNames sign warping tid) ->
      In t' (PlacedNames sign warping tid') ->
      MeetInSharedVertices
        (PlacedPosition warping (ClampedCut AngleThresholds cut)) t t'.
Proof. exact RuledMeshProof.RuledMeshEmbeds. Qed.

(** If it lets ends come level, which makes flat walls flat, still no point is
    inside two tetrahedra. *)
Theorem RuledInteriorsApart :
  forall sign cut stays limit, CutsOnEdges sign cut ->
    forall tid tid' t t',
      let warping := RuledWarping AngleThresholds sign cut stays limit in
      let place := PlacedPosition warping (ClampedCut AngleThresholds cut) in
      UncrossedOrLevel warping -> InLattice tid -> InLattice tid' ->
      In t (PlacedNames sign warping tid) ->
      In t' (PlacedNames sign warping tid') ->
      Overlap (MapTet place t) (MapTet place t') -> tid = tid' /\ t = t'.
Proof. exact RuledMeshProof.RuledInteriorsApart. Qed.

(** There are such rules, whoever stays: of two vertices that would cross or come
    level each stops a step short of a quarter of its edge, *)
Theorem BeforeQuarterUncrossed :
  forall th sign cut stays, CutsOnEdges sign cut ->
    Uncrossed (RuledWarping th sign cut stays
      (StopIfCrossed th sign cut (Quarter - 1))).
Proof. exact RuledMeshProof.BeforeQuarterUncrossed. Qed.

(** or right there. *)
Theorem AtQuarterUncrossedOrLevel :
  forall th sign cut stays, CutsOnEdges sign cut ->
    UncrossedOrLevel (RuledWarping th sign cut stays
      (StopIfCrossed th sign cut Quarter)).
Proof. exact RuledMeshProof.AtQuarterUncrossedOrLevel. Qed.

(** ** Beyond the paper: no piece is lost, cut or joined to another

    Read [Embedding/PiecesSpec.v] (pieces, and how a vertex leaves one) and
    [Embedding/DiskRule.v] (the rule of the strict disk).  A mesh that has
    angles, embeds and keeps its pieces is that of [WarpOrClamp] with who stays
    by [DiskRule] and the limit [StopIfCrossed]. *)

(** Whatever the warp: if no face of the lattice with all its corners on the
    surface has + on both sides, two tetrahedra of the mesh are joined by faces
    just as + corners of their structured tetrahedra are joined by edges. *)
Theorem MeshPieces :
  forall before warping p q t u,
    NoWall before warping ->
    PlusAfter before warping p -> PlusAfter before warping q ->
    MadeAt before warping p t -> MadeAt before warping q u ->
    Joined (InMesh before warping) ShareFace t u <->
    Joined (PlusAfter before warping) Adjacent p q.
Proof. exact PiecesProof.MeshPieces. Qed.

(** The warp of the strict disk makes no such face, *)
Theorem DiskMakesNoWall :
  forall th sign cut limit, (forall v, sign v <> OnSurface) ->
    NoWall sign (RuledWarping th sign cut (DiskRule th sign cut) limit).
Proof. exact DiskPiecesProof.DiskMakesNoWall. Qed.

(** and of a domain with finitely many + samples it keeps the pieces: those of
    the mesh by faces are those of the samples by edges, *)
Theorem DiskPiecesKept :
  forall th sign cut limit all p q t u,
    let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
    (forall v, sign v <> OnSurface) -> (forall v, sign v = Plus -> In v all) ->
    PlusAfter sign warping p -> PlusAfter sign warping q ->
    MadeAt sign warping p t -> MadeAt sign warping q u ->
    Joined (InMesh sign warping) ShareFace t u <->
    Joined (PlusBefore sign) Adjacent p q.
Proof. exact DiskPiecesProof.DiskPiecesKept. Qed.

(** none is lost, *)
Theorem DiskNoPieceLost :
  forall th sign cut limit all p,
    let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
    (forall v, sign v = Plus -> In v all) ->
    PlusBefore sign p -> (exists tid, InLattice tid /\ In p (Corners tid)) ->
    exists q t, PlusAfter sign warping q /\ MadeAt sign warping q t /\
      Joined (PlusBefore sign) Adjacent p q.
Proof. exact DiskPiecesProof.DiskNoPieceLost. Qed.

(** and the outside, with the surface, keeps its pieces too: none is joined to
    another, *)
Theorem DiskOutsideKept :
  forall th sign cut limit all p q,
    let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
    (forall v, sign v = Plus -> In v all) ->
    ~ PlusBefore sign p -> ~ PlusBefore sign q ->
    Joined (fun v => ~ PlusAfter sign warping v) Adjacent p q <->
    Joined (fun v => ~ PlusBefore sign v) Adjacent p q.
Proof. exact DiskPiecesProof.DiskOutsideKept. Qed.

(** and no cavity is made. *)
Theorem DiskMakesNoCavity :
  forall th sign cut limit all p,
    let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
    (forall v, sign v = Plus -> In v all) -> ~ PlusAfter sign warping p ->
    exists q, ~ PlusBefore sign q /\
      Joined (fun v => ~ PlusAfter sign warping v) Adjacent p q.
Proof. exact DiskPiecesProof.DiskMakesNoCavity. Qed.

(** All at once, of one mesh: who stays by the strict disk, who moves stops at a
    quarter where it would cross another, cuts are kept alpha away from the ends.
    For a domain with finitely many + samples, none of them on the surface: every
    dihedral angle is between 10.77 and 164.76 degrees (as integers tell it, see
    [RuledBoundsInDegrees]), no point is inside two tetrahedra, and the pieces by
    faces are the pieces of the samples by edges. *)
Theorem OneMeshHasItAll :
  forall sign cut all,
    CutsOnEdges sign cut -> (forall v, sign v <> OnSurface) ->
    (forall v, sign v = Plus -> In v all) ->
    let th := AngleThresholds in
    let stays := DiskRule th sign cut in
    let limit := StopIfCrossed th sign cut Quarter in
    let warping := RuledWarping th sign cut stays limit in
    let place := PlacedPosition warping (ClampedCut th cut) in
    (forall tid t, In t (WarpOrClamp th sign cut stays limit tid) ->
       WellShaped (AB (CotSq 221 8) (CotSq 1751 130)) t) /\
    (forall tid tid' t t', InLattice tid -> InLattice tid' ->
       In t (PlacedNames sign warping tid) ->
       In t' (PlacedNames sign warping tid') ->
       Overlap (MapTet place t) (MapTet place t') -> tid = tid' /\ t = t') /\
    (forall p q t u,
       PlusAfter sign warping p -> PlusAfter sign warping q ->
       MadeAt sign warping p t -> MadeAt sign warping q u ->
       Joined (InMesh sign warping) ShareFace t u <->
       Joined (PlusBefore sign) Adjacent p q).
Proof. exact DiskPiecesProof.OneMeshHasItAll. Qed.

(** ** Beyond the paper: the warp that keeps the shape, as it runs

    Read [Embedding/Settle.v], which begins with the rule in words, and
    [Embedding/DiskTables.v].  [Settle] is extracted and run, and the production
    library is compared with it.  Nothing below asks who is in the list of
    vertices, or in what order they have their turns. *)

(** The disks it looks for are those of [DiskRule]. *)
Theorem IsDiskCorrect : forall now, IsDisk (Gather now) = StrictDisk now.
Proof. exact DiskTablesProof.IsDiskCorrect. Qed.

(** And these are, in so many words: on the sphere of a vertex's neighbours the +
    are in one piece and the others too, around each 0 the + are one run or none,
    and no edge from 0 to 0 has + on both sides. *)
Theorem StrictDiskIff :
  forall now v, StrictDisk (LinkOf now v) = true <-> DiskAround now v.
Proof. exact SettledSurfaceProof.StrictDiskIff. Qed.

(** Signs change only as they may: one vertex after the other becomes 0, each when
    its link is a strict disk. *)
Theorem SettledByDisks :
  forall th sign cut gap vs,
    ByDisks sign (SignAmong sign (Settle th sign cut gap vs)).
Proof. exact SettleProof.SettledByDisks. Qed.

(** Who has become 0 keeps its disk, whatever its neighbours do later: at the end
    every 0 has a strict disk around it, or nothing inside. *)
Theorem SettledDisksAround :
  forall th sample cut gap vs,
    let sign := OpenSigns sample in
    DisksAround (SignAmong sign (Settle th sign cut gap vs)).
Proof. exact SettledSurfaceProof.SettledDisksAround. Qed.

(** In the product's order each vertex of a list that is violated has its turn, and
    nobody else. *)
Theorem EachHasATurn :
  forall th sign cut, CutsOnEdges sign cut -> forall vs v,
    In v (InTurn th sign cut vs) <-> In v vs /\ Violated th sign cut v = true.
Proof. exact SettleOrderProof.EachHasATurn. Qed.

(** Within a colour the order is free: those of one colour may have their turns at
    once. *)
Theorem ColourInAnyOrder :
  forall th sign cut gap first class class' last,
    Permutation class class' ->
    (forall u v, In u class -> In v class -> Colour u = Colour v) ->
    forall v, PlaceIn (Settle th sign cut gap (first ++ class ++ last)) v
            = PlaceIn (Settle th sign cut gap (first ++ class' ++ last)) v.
Proof. exact SettleOrderProof.ColourInAnyOrder. Qed.

(** It is one of the rules by which any violated vertex may stay, so that every
    tetrahedron is admissible. *)
Theorem SettledIsWarpOrClamp :
  forall th sign cut gap vs,
    AtMostHalf th -> CutsOnEdges sign cut -> (forall s s', gap s s' <= 1) ->
    exists stays limit, forall tid,
      SettledTets th sign cut (Settle th sign cut gap vs) tid
      = WarpOrClamp th sign cut stays limit tid.
Proof. exact SettledMeshProof.SettledIsWarpOrClamp. Qed.

(** Samples that lie on the surface are cut at that end of the edge, so that the
    cuts stay on their edges. *)
Theorem OpenCutsOnEdges :
  forall sample cut, CutsOnEdges sample cut ->
    CutsOnEdges (OpenSigns sample) (OpenCuts sample cut).
Proof. exact SettledMeshProof.OpenCutsOnEdges. Qed.

(** The mesh of the product: every tetrahedron has dihedral angles between 10.77
    and 164.76 degrees. *)
Theorem SettledBoundsInDegrees :
  forall sample cut vs tids t, CutsOnEdges sample cut ->
    In t (SettledMesh AngleThresholds (OpenSigns sample) (OpenCuts sample cut)
            LevelGap vs tids) ->
    WithinDegrees (1077 / 100) (16476 / 100) t.
Proof. exact RuledDegreesProof.SettledBoundsInDegrees. Qed.

(** And all at once, whatever the samples: the angles (as integers tell it); no
    point is inside two tetrahedra; the pieces of the mesh by faces are those of
    the samples by edges, and none is lost; the outside, with the surface, keeps
    its pieces too, and no cavity is made. *)
Theorem SettledMeshHasItAll :
  forall sample cut vs, CutsOnEdges sample cut ->
    let th := AngleThresholds in
    let sign := OpenSigns sample in
    let cuts := OpenCuts sample cut in
    let warping := PlaceIn (Settle th sign cuts LevelGap vs) in
    let place := PlacedPosition warping (ClampedCut th cuts) in
    (forall tids t, In t (SettledMesh th sign cuts LevelGap vs tids) ->
       WellShaped (AB (CotSq 221 8) (CotSq 1751 130)) t) /\
    (forall tid tid' t t', InLattice tid -> InLattice tid' ->
       In t (PlacedNames sign warping tid) ->
       In t' (PlacedNames sign warping tid') ->
       Overlap (MapTet place t) (MapTet place t') -> tid = tid' /\ t = t') /\
    (forall p q t u,
       PlusAfter sign warping p -> PlusAfter sign warping q ->
       MadeAt sign warping p t -> MadeAt sign warping q u ->
       Joined (InMesh sign warping) ShareFace t u <->
       Joined (PlusBefore sign) Adjacent p q) /\
    (forall p, PlusBefore sign p ->
       (exists tid, InLattice tid /\ In p (Corners tid)) ->
       exists q t, PlusAfter sign warping q /\ MadeAt sign warping q t /\
         Joined (PlusBefore sign) Adjacent p q) /\
    (forall p q, ~ PlusBefore sign p -> ~ PlusBefore sign q ->
       Joined (fun v => ~ PlusAfter sign warping v) Adjacent p q <->
       Joined (fun v => ~ PlusBefore sign v) Adjacent p q) /\
    (forall p, ~ PlusAfter sign warping p ->
       exists q, ~ PlusBefore sign q /\
         Joined (fun v => ~ PlusAfter sign warping v) Adjacent p q).
Proof. exact SettledMeshProof.SettledMeshHasItAll. Qed.

(** The product lets two vertices come level, so that flat walls are flat.  With a
    step left between any two, the mesh embeds as well. *)
Theorem SettledMeshEmbeds :
  forall sign cut vs tid tid' t t',
    let warping := PlaceIn (Settle AngleThresholds sign cut StrictGap vs) in
    CutsOnEdges sign cut -> InLattice tid -> InLattice tid' ->
    In t (PlacedNames sign warping tid) ->
    In t' (PlacedNames sign warping tid') ->
    MeetInSharedVertices
      (PlacedPosition warping (ClampedCut AngleThresholds cut)) t t'.
Proof. exact SettledMeshProof.SettledMeshEmbeds. Qed.

(** ** Beyond the paper: the surface is a manifold

    Read [Topology/SurfaceSpec.v]: the surface are the triangles that belong to
    exactly one tetrahedron.  Not proved is that tunnels are kept as pieces and
    cavities are: that a vertex with a strict disk takes away, or adds, a ball along
    a disk. *)

(** Whatever the domain and the warp, the surface is closed: every edge of it lies
    in an even number of its triangles. *)
Theorem BoundaryClosed :
  forall before warping a b c,
    SurfaceTriangle before warping a b c ->
    exists thirds : list MeshVertex, NoDup thirds /\
      (forall d, In d thirds <-> SurfaceTriangle before warping a b d) /\
      Nat.Even (length thirds).
Proof. exact EdgeProof.BoundaryClosed. Qed.

(** At a cut it is a manifold, whatever the domain and the warp: an edge there lies
    in exactly two triangles, and all triangles there are one fan.  So it may touch
    itself at 0 corners alone. *)
Theorem CutsManifold :
  forall before warping p m b c,
    SurfaceTriangle before warping (Cut p m) b c ->
    (exists d, d <> c /\ SurfaceTriangle before warping (Cut p m) b d /\
       forall e, SurfaceTriangle before warping (Cut p m) b e -> e = c \/ e = d) /\
    (forall x, InFan before warping (Cut p m) x ->
       JoinedInFan before warping (Cut p m) b x).
Proof. exact DiskManifoldProof.CutsManifold. Qed.

(** If every vertex on the surface that has an inner neighbour has a strict disk,
    whatever rule has seen to that, it is a manifold everywhere: every edge of it
    lies in exactly two of its triangles, and the triangles at every vertex are one
    fan, in which each has an edge in common with the next. *)
Theorem SurfaceManifold :
  forall before warping a b c,
    DisksAround (SignAfter before warping) ->
    SurfaceTriangle before warping a b c ->
    (exists d, d <> c /\ SurfaceTriangle before warping a b d /\
       forall e, SurfaceTriangle before warping a b e -> e = c \/ e = d) /\
    (forall x, InFan before warping a x -> JoinedInFan before warping a b x).
Proof. exact DiskManifoldProof.SurfaceManifold. Qed.

(** Vertices that become 0 because they have strict disks, no two of them adjacent,
    leave the others theirs, *)
Theorem DisksAroundKept :
  forall sign sign' : SignField,
    DisksAround sign ->
    (forall v, sign' v = sign v \/
       sign' v = OnSurface /\ sign v <> OnSurface /\
       StrictDisk (LinkOf sign v) = true) ->
    (forall u v, sign' u <> sign u -> sign' v <> sign v -> ~ Adjacent u v) ->
    DisksAround sign'.
Proof. exact DiskKeptProof.DisksAroundKept. Qed.

(** so that the rule of the strict disk gives a manifold; *)
Theorem DiskSurfaceManifold :
  forall th sign cut limit a b c,
    let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
    (forall v, sign v <> OnSurface) ->
    SurfaceTriangle sign warping a b c ->
    (exists d, d <> c /\ SurfaceTriangle sign warping a b d /\
       forall e, SurfaceTriangle sign warping a b e -> e = c \/ e = d) /\
    (forall x, InFan sign warping a x -> JoinedInFan sign warping a b x).
Proof. exact DiskManifoldProof.DiskSurfaceManifold. Qed.

(** so does the warp that keeps the shape, as it runs, whatever the samples, whoever
    is in the list and in what order; *)
Theorem SettledSurfaceManifold :
  forall th sample cut gap vs a b c,
    let sign := OpenSigns sample in
    let warping := PlaceIn (Settle th sign cut gap vs) in
    SurfaceTriangle sign warping a b c ->
    (exists d, d <> c /\ SurfaceTriangle sign warping a b d /\
       forall e, SurfaceTriangle sign warping a b e -> e = c \/ e = d) /\
    (forall x, InFan sign warping a x -> JoinedInFan sign warping a b x).
Proof. exact SettledSurfaceProof.SettledSurfaceManifold. Qed.

(** and so do cuts in the middle, which leave no 0 corners. *)
Theorem MidpointSurfaceManifold :
  forall sign a b c,
    let decided v := InOrOut (sign v) in
    let warping := WarpVertex NoWarpThresholds decided (fun _ _ => MidpointCut) in
    SurfaceTriangle decided warping a b c ->
    (exists d, d <> c /\ SurfaceTriangle decided warping a b d /\
       forall e, SurfaceTriangle decided warping a b e -> e = c \/ e = d) /\
    (forall x, InFan decided warping a x -> JoinedInFan decided warping a b x).
Proof. exact DiskManifoldProof.MidpointSurfaceManifold. Qed.

(** ** Beyond the paper: inside and outside fill space

    Read [Topology/TwoSidesSpec.v]: the mesh of the other side.  For a warp that
    lets ends of short edges come level, as [UncrossedOrLevel] does, this is not
    proved. *)

(** Every rational point, [x] over [n], is in a tetrahedron of the mesh, in one of
    the mesh of the other side, or in a structured tetrahedron that both drop because
    all its corners are on the surface. *)
Theorem TwoSidesFill :
  forall before warping cut,
    CutsInside before warping cut ->
    forall n x,
      MovesAtMost AngleThresholds warping -> Uncrossed warping -> 0 < n ->
      exists tid t w, InLattice tid /\
        (In t (PlacedNames before warping tid) \/
         In t (OtherNames before warping tid) \/
         t = MapTet Corner (LatticeTet tid) /\
           forall c, In c (Corners tid) -> SignAfter before warping c = OnSurface) /\
        NonNegative w /\ 0 < Total w /\
        Scale n (PointOf w (MapTet (PlacedPosition warping cut) t))
        = Scale (Total w) x.
Proof. exact TwoSidesFillProof.TwoSidesFill. Qed.

(** A point of both meshes is a mean of vertices that they share, with the same
    weights seen from either side; *)
Theorem TwoSidesMeet :
  forall before warping cut,
    CutsInside before warping cut ->
    forall tid tid' t t',
      MovesAtMost AngleThresholds warping -> Uncrossed warping ->
      InLattice tid -> InLattice tid' ->
      In t (PlacedNames before warping tid) ->
      In t' (OtherNames before warping tid') ->
      MeetInSharedVertices (PlacedPosition warping cut) t t'.
Proof. exact TwoSidesMeetProof.TwoSidesMeet. Qed.

(** these are on the surface. *)
Theorem TwoSidesShare :
  forall before warping tid tid' t t' v,
    InLattice tid -> InLattice tid' ->
    In t (PlacedNames before warping tid) ->
    In t' (OtherNames before warping tid') ->
    In v (TetCorners t) -> In v (TetCorners t') ->
    PlacedSign before warping v = OnSurface.
Proof. exact TwoSidesMeetProof.TwoSidesShare. Qed.

(** The same of the paper's warp, with thresholds that embed: its mesh and
    that of the other side fill space, *)
Theorem WarpedTwoSidesFill :
  forall long short sign cut n x,
    0 < long <= 64 -> 0 < short <= 128 -> CutsOnEdges sign cut -> 0 < n ->
    let warping := WarpVertex (TH long short) sign cut in
    exists tid t w, InLattice tid /\
      (In t (PlacedNames sign warping tid) \/
       In t (OtherNames sign warping tid) \/
       t = MapTet Corner (LatticeTet tid) /\
         forall c, In c (Corners tid) -> SignAfter sign warping c = OnSurface) /\
      NonNegative w /\ 0 < Total w /\
      Scale n (PointOf w (MapTet (PlacedPosition warping cut) t))
      = Scale (Total w) x.
Proof. exact TwoSidesFillProof.WarpedTwoSidesFill. Qed.

(** and meet in what they share. *)
Theorem WarpedTwoSidesMeet :
  forall long short sign cut tid tid' t t',
    0 < long <= 64 -> 0 < short <= 128 -> CutsOnEdges sign cut ->
    let warping := WarpVertex (TH long short) sign cut in
    InLattice tid -> InLattice tid' ->
    In t (PlacedNames sign warping tid) ->
    In t' (OtherNames sign warping tid') ->
    MeetInSharedVertices (PlacedPosition warping cut) t t'.
Proof. exact TwoSidesMeetProof.WarpedTwoSidesMeet. Qed.

(** The warp that keeps the shape fills space and meets so if a step is left between
    any two vertices, as in [SettledMeshEmbeds]. *)
Theorem SettledTwoSidesFill :
  forall sign cut vs, CutsOnEdges sign cut ->
    let warping := PlaceIn (Settle AngleThresholds sign cut StrictGap vs) in
    let place := PlacedPosition warping (ClampedCut AngleThresholds cut) in
    forall n x, 0 < n ->
      exists tid t w, InLattice tid /\
        (In t (PlacedNames sign warping tid) \/
         In t (OtherNames sign warping tid) \/
         t = MapTet Corner (LatticeTet tid) /\
           forall c, In c (Corners tid) -> SignAfter sign warping c = OnSurface) /\
        NonNegative w /\ 0 < Total w /\
        Scale n (PointOf w (MapTet place t)) = Scale (Total w) x.
Proof. exact SettledTwoSidesProof.SettledTwoSidesFill. Qed.

Theorem SettledTwoSidesMeet :
  forall sign cut vs, CutsOnEdges sign cut ->
    let warping := PlaceIn (Settle AngleThresholds sign cut StrictGap vs) in
    let place := PlacedPosition warping (ClampedCut AngleThresholds cut) in
    forall tid tid' t t', InLattice tid -> InLattice tid' ->
      In t (PlacedNames sign warping tid) ->
      In t' (OtherNames sign warping tid') ->
      MeetInSharedVertices place t t'.
Proof. exact SettledTwoSidesProof.SettledTwoSidesMeet. Qed.

(** By the names it has when it is made, the mesh of the other side lies where it
    does by these. *)
Theorem OtherSidePlaced :
  forall warping cut t,
    MapTet (PlacedPosition warping cut) (MapTet NameHere t)
    = MapTet (PlacedPosition warping (OtherCuts cut)) t.
Proof. exact TwoSidesFillProof.OtherSidePlaced. Qed.

(** ** Beyond the paper: the pieces of a label image

    Read [Topology/VoxelSpec.v]: which voxel a lattice point lies in, and how it is
    sampled.  [VoxelSigns] is extracted, and by default the library takes the same
    samples of one label, at sizes up to the spacing.  Where all points in the image
    are inside, odd ones too, as of several labels and with the other methods, this
    is not proved. *)

(** If no voxel is narrower than the lattice's long edge, wherever the lattice lies,
    the pieces of the samples by edges are the pieces of the image by faces, *)
Theorem VoxelPiecesKept :
  forall grid image p q,
    let sign := VoxelSigns grid image in
    FineEnough grid -> OfLattice p -> OfLattice q ->
    sign p = Plus -> sign q = Plus ->
    Joined (fun v => sign v = Plus) Adjacent p q <->
    Joined (fun x => image x = true) Beside (Owner grid p) (Owner grid q).
Proof. exact VoxelProof.VoxelPiecesKept. Qed.

(** every voxel of the image has a sample, *)
Theorem VoxelsSampled :
  forall grid image x,
    FineEnough grid -> image x = true ->
    exists p, OfLattice p /\ VoxelSigns grid image p = Plus /\ Owner grid p = x.
Proof. exact VoxelProof.VoxelsSampled. Qed.

(** and so the pieces of the mesh of the strict disk by faces are the pieces of the
    image by faces: none is cut or joined to another, *)
Theorem VoxelMeshPieces :
  forall grid image voxels th cut limit p q t u,
    let sign := VoxelSigns grid image in
    let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
    FineEnough grid -> (forall x, image x = true -> In x voxels) ->
    PlusAfter sign warping p -> PlusAfter sign warping q ->
    MadeAt sign warping p t -> MadeAt sign warping q u ->
    Joined (InMesh sign warping) ShareFace t u <->
    Joined (fun x => image x = true) Beside (Owner grid p) (Owner grid q).
Proof. exact VoxelMeshProof.VoxelMeshPieces. Qed.

(** and none is lost. *)
Theorem VoxelNoPieceLost :
  forall grid image voxels th cut limit x,
    let sign := VoxelSigns grid image in
    let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
    FineEnough grid -> (forall y, image y = true -> In y voxels) ->
    image x = true ->
    exists q t, PlusAfter sign warping q /\ MadeAt sign warping q t /\
      Joined (fun y => image y = true) Beside x (Owner grid q).
Proof. exact VoxelMeshProof.VoxelNoPieceLost. Qed.

(** The same of the warp that keeps the shape, as it runs, given these samples of
    any image: the pieces of the mesh by faces are the pieces of the image by
    faces, *)
Theorem SettledVoxelPieces :
  forall grid image th cut gap vs p q t u,
    let sign := OpenSigns (VoxelSigns grid image) in
    let warping := PlaceIn (Settle th sign cut gap vs) in
    FineEnough grid ->
    PlusAfter sign warping p -> PlusAfter sign warping q ->
    MadeAt sign warping p t -> MadeAt sign warping q u ->
    Joined (InMesh sign warping) ShareFace t u <->
    Joined (fun x => image x = true) Beside (Owner grid p) (Owner grid q).
Proof. exact SettledVoxelProof.SettledVoxelPieces. Qed.

(** and none is lost. *)
Theorem SettledVoxelNoPieceLost :
  forall grid image th cut gap vs x,
    let sign := OpenSigns (VoxelSigns grid image) in
    let warping := PlaceIn (Settle th sign cut gap vs) in
    FineEnough grid -> image x = true ->
    exists q t, PlusAfter sign warping q /\ MadeAt sign warping q t /\
      Joined (fun y => image y = true) Beside x (Owner grid q).
Proof. exact SettledVoxelProof.SettledVoxelNoPieceLost. Qed.

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
