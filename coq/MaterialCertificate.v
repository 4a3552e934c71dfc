(** * The certificate, for any number of materials

    Where an image has many regions, each of them is a material, and the mesh has
    the surfaces between them.  [GetMaterialTets] gives the tetrahedra of one
    structured tetrahedron with the material of each.  It is what
    [GetUnstructuredTets] gives, once for each material that is there, and where
    three or four materials meet a fill between them: read
    [Material/MaterialTet.v] first, then [Material/MaterialMesh.v], where it is
    run on the lattice, and [Material/MaterialSpec.v].

    [Certificate.v] exports this page, and [make audit] checks it as that one. *)

From Coq Require Import ZArith Reals List.

(** What is extracted. *)
From Certet Require Export Lattice.Coord3 Lattice.StructuredTet.
From Certet Require Export Stencil.UnstructuredTet Stencil.StencilSet.
From Certet Require Export Warp.Cut Warp.Warp.
From Certet Require Export Stuffing.Stuffing Stuffing.Domain.
From Certet Require Export Embedding.WarpOrClamp Embedding.Settle.
From Certet Require Export Material.MaterialTet Material.MaterialMesh.
From Certet Require Export Material.MaterialShape Material.SettleMaterials.
From Certet Require Export Material.Demotion.

(** What is meant. *)
From Certet Require Export Lattice.NeighborSpec Stencil.TriangleSpec.
From Certet Require Export Stuffing.MeshSpec Angles.Geometry Angles.AnglesSpec.
From Certet Require Export Angles.DegreesSpec Embedding.EmbeddingSpec.
From Certet Require Export Material.MaterialSpec Material.MaterialPatterns.
From Certet Require Export Material.OtherMaterials.

(** Why it holds. *)
From Certet Require Material.MaterialChecker Material.MaterialConfigurations.
From Certet Require Material.MaterialReducesProof Material.MaterialMeshProof.
From Certet Require Material.MaterialPatternsProof.
From Certet Require Material.MaterialTwiceProof Material.MaterialFillProof.
From Certet Require Material.MaterialBoundsProof Material.MaterialWarpProof.
From Certet Require Material.SettleMaterialsProof Material.SettleReducesProof.
From Certet Require Material.MaterialDegreesProof.

Open Scope Z_scope.

(** ** The angles

    What runs is [SettleMaterials]: violated vertices have their turns one after
    the other, and one stays where it would change the shape of a material or
    spoil a tetrahedron between interfaces; read [Material/SettleMaterials.v].
    [SettledMaterialTets] is the mesh that it leaves. *)

(** Every tetrahedron of every material, however many there are, has positive
    volume and dihedral angles between 10.77 and 164.76 degrees, as integers tell
    it: cot^2 10.77 > 221/8 and cot^2 164.76 > 1751/130; in whatever order the
    vertices have their turns, *)
Theorem SettledMaterialBounds :
  forall material cut turns tid m t,
    MaterialCutsOnEdges (fun v => Some (material v)) cut -> InLattice tid ->
    m <> Outside ->
    In (m, t)
      (SettledMaterialTets AngleThresholds material cut
         (SettleMaterials (AB (CotSq 221 8) (CotSq 1751 130)) AngleThresholds
            material cut turns) tid) ->
    WellShaped (AB (CotSq 221 8) (CotSq 1751 130)) t.
Proof. exact SettleMaterialsProof.SettledMaterialBounds. Qed.

(** and in degrees. *)
Theorem SettledMaterialBoundsInDegrees :
  forall material cut turns tid m t,
    MaterialCutsOnEdges (fun v => Some (material v)) cut -> InLattice tid ->
    m <> Outside ->
    In (m, t)
      (SettledMaterialTets AngleThresholds material cut
         (SettleMaterials (AB (CotSq 221 8) (CotSq 1751 130)) AngleThresholds
            material cut turns) tid) ->
    WithinDegrees (1077 / 100) (16476 / 100) t.
Proof. exact MaterialDegreesProof.SettledMaterialBoundsInDegrees. Qed.

(** It is one of the rules of [RuledMaterialWarping], *)
Theorem SettledMaterialsAreRuled :
  forall bounds th material cut, AtMostHalf th ->
    MaterialCutsOnEdges (fun v => Some (material v)) cut ->
    forall turns, exists stays limit, forall v,
      RuledMaterialWarping th (fun u => Some (material u)) cut stays limit v
      = PlaceIn (SettleMaterials bounds th material cut turns) v.
Proof. exact SettleMaterialsProof.SettledMaterialsAreRuled. Qed.

(** and of all of these, whichever violated vertices stay, and however the moves
    of the others are shortened, what is left is admissible; *)
Theorem AnyMaterialSubsetStays :
  forall th material cut stays limit tid,
    AtMostHalf th -> MaterialCutsOnEdges material cut ->
    AdmissibleMaterials material
      (RuledMaterialWarping th material cut stays limit)
      (ClampedCut th cut) th (Corners tid).
Proof. exact MaterialWarpProof.AnyMaterialSubsetStays. Qed.

(** and of every admissible placement every tetrahedron is within the bounds,
    if those between interfaces, which are kept whole, are. *)
Theorem MaterialDihedralBounds :
  forall before warping cut shared tid,
    AdmissibleMaterials before warping cut AngleThresholds (Corners tid) ->
    (InterfacesAlone before warping tid ->
       WellShaped (AB (CotSq 221 8) (CotSq 1751 130))
         (PlacedWhole warping cut tid)) ->
    forall m t, In (m, t) (PlacedMaterialTets before warping cut shared tid) ->
      WellShaped (AB (CotSq 221 8) (CotSq 1751 130)) t.
Proof. exact MaterialBoundsProof.MaterialDihedralBounds. Qed.

Theorem MaterialDihedralBoundsInDegrees :
  forall before warping cut shared tid m t,
    AdmissibleMaterials before warping cut AngleThresholds (Corners tid) ->
    (InterfacesAlone before warping tid ->
       WellShaped (AB (CotSq 221 8) (CotSq 1751 130))
         (PlacedWhole warping cut tid)) ->
    In (m, t) (PlacedMaterialTets before warping cut shared tid) ->
    WithinDegrees (1077 / 100) (16476 / 100) t.
Proof. exact MaterialDegreesProof.MaterialDihedralBoundsInDegrees. Qed.

(** A rule that looks after the angles alone has them too: of the corners of a
    tetrahedron between interfaces that would be spoiled the one that moves
    farthest stays, all at once ([Material/Demotion.v]).  It runs in no program. *)
Theorem DemotedBounds :
  forall material cut shared tid m t,
    MaterialCutsOnEdges material cut -> InLattice tid -> m <> Outside ->
    In (m, t)
      (DemotedTets (AB (CotSq 221 8) (CotSq 1751 130)) AngleThresholds
         material cut shared tid) ->
    WellShaped (AB (CotSq 221 8) (CotSq 1751 130)) t.
Proof. exact MaterialWarpProof.DemotedBounds. Qed.

(** and in degrees. *)
Theorem DemotedBoundsInDegrees :
  forall material cut shared tid m t,
    MaterialCutsOnEdges material cut -> InLattice tid -> m <> Outside ->
    In (m, t)
      (DemotedTets (AB (CotSq 221 8) (CotSq 1751 130)) AngleThresholds
         material cut shared tid) ->
    WithinDegrees (1077 / 100) (16476 / 100) t.
Proof. exact MaterialDegreesProof.DemotedBoundsInDegrees. Qed.

(** At the thresholds that embed one material, 64/256 and 105/256, its bounds
    hold of several too: 9.27 and 161.46 degrees. *)
Theorem MaterialDihedralBoundsEmbedding :
  forall before warping cut shared tid,
    AdmissibleMaterials before warping cut EmbeddingThresholds (Corners tid) ->
    (InterfacesAlone before warping tid ->
       WellShaped (AB (CotSq 563 15) (CotSq 80 9))
         (PlacedWhole warping cut tid)) ->
    forall m t, In (m, t) (PlacedMaterialTets before warping cut shared tid) ->
      WellShaped (AB (CotSq 563 15) (CotSq 80 9)) t.
Proof. exact MaterialBoundsProof.MaterialDihedralBoundsEmbedding. Qed.

(** Where every vertex has a material, and edges are cut in the middle, they are
    between 30 and 135 degrees: the squares of the cotangents are at most 3
    and 1, *)
Theorem MaterialMidpointBounds :
  forall (material : Coord3 -> Material) shared tid m t,
    In (m, t)
      (PlacedMaterialTets (fun v => Some (material v)) (fun _ => Stays)
         MidpointCuts shared tid) ->
    WellShaped (AB (CotSq 3 1) (CotSq 1 1)) t.
Proof. exact MaterialBoundsProof.MaterialMidpointBounds. Qed.

(** and in degrees. *)
Theorem MaterialMidpointBoundsInDegrees :
  forall (material : Coord3 -> Material) shared tid m t,
    In (m, t)
      (PlacedMaterialTets (fun v => Some (material v)) (fun _ => Stays)
         MidpointCuts shared tid) ->
    WithinDegrees 30 135 t.
Proof. exact MaterialDegreesProof.MaterialMidpointBoundsInDegrees. Qed.

(** To the 14,717 configurations of one material come eight, of three corners
    that move around towards each other, and 63 of the fill, with 432 dihedral
    angles. *)
Theorem MaterialConfigurationsCounted :
  MaterialConfigurations.CountThirdMoves = 8 /\
  MaterialConfigurations.CountFill = 63 /\
  MaterialConfigurations.CountFillAngles = 432.
Proof. exact MaterialBoundsProof.MaterialConfigurationsCounted. Qed.

(** ** One material and the outside

    Nothing changes: a material whose corners know but it, the outside, and
    interfaces has the tetrahedra that [GetUnstructuredTets] gives, in their
    order, *)
Theorem MaterialReduces :
  forall Vertex GetMaterial GetIntersection v1 v2 v3 v4 m,
    Outside < m ->
    (forall v, In v (v1 :: v2 :: v3 :: v4 :: nil)%list ->
       GetMaterial v = Some m \/ GetMaterial v = None \/
       GetMaterial v = Some Outside) ->
    OfMaterial m
      (GetMaterialTets Vertex GetMaterial GetIntersection v1 v2 v3 v4 Outside)
    = GetUnstructuredTets Vertex (SignAmongMaterials Vertex GetMaterial m)
        GetIntersection v1 v2 v3 v4.
Proof. exact MaterialReducesProof.MaterialReduces. Qed.

(** and so has the mesh, whatever the domain and the thresholds; warping, too, is
    what it was. *)
Theorem MaterialMeshReduces :
  forall th sign cut tid m, Outside < m ->
    OfMaterial m
      (MaterialNames
         (fun c => OneMaterial m (MeshVertexSign th sign cut (Corner c)))
         (fun _ => Outside) tid)
    = StuffTet th sign cut tid.
Proof. exact MaterialReducesProof.MaterialMeshReduces. Qed.

Theorem MaterialWarpReduces :
  forall th sign cut m v, Outside < m ->
    WarpMaterialVertex th (fun c => OneMaterial m (sign c)) cut v
    = WarpVertex th sign cut v.
Proof. exact MaterialReducesProof.MaterialWarpReduces. Qed.

Theorem MaterialStuffingReduces :
  forall th sign cut tid m, Outside < m ->
    let material c := OneMaterial m (sign c) in
    OfMaterial m
      (PlacedMaterialTets material (WarpMaterialVertex th material cut) cut
         (fun _ => Outside) tid)
    = StuffedTets th sign cut tid.
Proof. exact MaterialReducesProof.MaterialStuffingReduces. Qed.

(** With the rule of who stays as well: there is nobody who would have to. *)
Theorem DemotedReduces :
  forall bounds th sign cut tid m,
    Outside < m -> AtMostHalf th -> CutsOnEdges sign cut -> InLattice tid ->
    OfMaterial m
      (DemotedTets bounds th (fun c => OneMaterial m (sign c)) cut
         (fun _ => Outside) tid)
    = StuffedTets th sign cut tid.
Proof. exact MaterialWarpProof.DemotedReduces. Qed.

(** And so has the rule that runs, of samples of which none is 0: turns come in the
    same order, the same vertices move, equally far, and the mesh is the same. *)
Theorem MaterialsInTurnReduce :
  forall th sign cut m, Outside < m -> (forall v, sign v <> OnSurface) ->
    let material v := match sign v with Plus => m | _ => Outside end in
    forall vs, MaterialsInTurn th material cut vs = InTurn th sign cut vs.
Proof. exact SettleReducesProof.MaterialsInTurnReduce. Qed.

Theorem SettleReduces :
  forall bounds th sign cut m, Outside < m -> (forall v, sign v <> OnSurface) ->
    let material v := match sign v with Plus => m | _ => Outside end in
    forall vs,
      SettleMaterials bounds th material cut vs = Settle th sign cut LevelGap vs.
Proof. exact SettleReducesProof.SettleReduces. Qed.

Theorem SettledTetsReduce :
  forall bounds th sign cut m, Outside < m -> (forall v, sign v <> OnSurface) ->
    let material v := match sign v with Plus => m | _ => Outside end in
    forall vs tid,
      OfMaterial m
        (SettledMaterialTets th material cut
           (SettleMaterials bounds th material cut vs) tid)
      = SettledTets th sign cut (Settle th sign cut LevelGap vs) tid.
Proof. exact SettleReducesProof.SettledTetsReduce. Qed.

(** ** Three materials or four

    The 11 patterns in which three or four meet are printed in full in
    [Material/MaterialPatterns.v]: eight tetrahedra, seven, or four. *)
Theorem ThreeOrFourMaterials :
  forall Vertex GetMaterial GetIntersection v1 v2 v3 v4 shared tets,
    ThreeOrFourInFull Vertex GetMaterial
      (MaterialCut Vertex GetMaterial GetIntersection) v1 v2 v3 v4 = Some tets ->
    GetMaterialTets Vertex GetMaterial GetIntersection v1 v2 v3 v4 shared = tets.
Proof. exact MaterialPatternsProof.ThreeOrFourMaterials. Qed.

(** ** The meshes of all materials fit together *)

(** Whatever the materials of the vertices: both sides of a lattice face divide
    it into the same triangles; and if a corner of the face has a material, each
    triangle is of the same material on both sides.  (A face with all corners on
    interfaces may itself be part of one.) *)
Theorem MaterialFacesAgree :
  forall material shared tid i a b c,
    let face := FaceOf tid i in
    let here := MaterialNames material shared tid in
    let there := MaterialNames material shared (NeighborOf tid i) in
    LiesIn face a -> LiesIn face b -> LiesIn face c ->
    (AmongTriangles (map snd here) a b c <->
     AmongTriangles (map snd there) a b c) /\
    ((exists f, In f face /\ material f <> None) -> forall m,
       AmongTriangles (OfMaterial m here) a b c <->
       AmongTriangles (OfMaterial m there) a b c).
Proof. exact MaterialMeshProof.MaterialFacesAgree. Qed.

(** The checker behind it refuses a fill that is of another of the three
    materials, in one of the 11 patterns; *)
Theorem MislabelledMaterialsRejected :
  MaterialChecker.CheckMaterialFaces MislabelledMaterials = false.
Proof. exact MaterialReducesProof.MislabelledMaterialsRejected. Qed.

(** Inside a structured tetrahedron, every triangle belongs to two tetrahedra, or
    lies on a face and belongs to one; so that in the whole lattice, by the
    theorem above, each belongs to two. *)
Theorem MaterialTriangleTwice :
  forall material shared tid t a b c,
    let here := MaterialNames material shared tid in
    In t here -> HasTriangle (snd t) a b c ->
    ((exists i, LiesIn (FaceOf tid i) a /\ LiesIn (FaceOf tid i) b /\
        LiesIn (FaceOf tid i) c) /\
     forall u, In u here -> HasTriangle (snd u) a b c -> u = t) \/
    (exists u, In u here /\ snd u <> snd t /\ HasTriangle (snd u) a b c /\
       forall w, In w here -> HasTriangle (snd w) a b c -> w = t \/ w = u).
Proof. exact MaterialTwiceProof.MaterialTriangleTwice. Qed.

(** Without the fill it is not so, and the checker says that there are holes; *)
Theorem UnfilledMaterialsRejected :
  MaterialChecker.CheckMaterialInside UnfilledMaterials = false.
Proof. exact MaterialReducesProof.UnfilledMaterialsRejected. Qed.

(** nor with the fill divided along the other diagonal, in one pattern. *)
Theorem TwistedMaterialsRejected :
  MaterialChecker.CheckMaterialInside TwistedMaterials = false.
Proof. exact MaterialReducesProof.TwistedMaterialsRejected. Qed.

(** Their volumes add up to that of the structured tetrahedron: nothing is lost,
    and nothing is there twice, wherever the cuts and the moved corners are. *)
Theorem MaterialsFill :
  forall before warping cut shared tid,
    TotalSixVolume (PlacedMaterialTets before warping cut shared tid)
    = SixVolumeOf (PlacedWhole warping cut tid).
Proof. exact MaterialFillProof.MaterialsFill. Qed.
