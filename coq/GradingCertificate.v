(** * The certificate, for graded interiors

    Away from its surface a mesh may have larger tetrahedra.  Cells of an octree
    say how large, cells of level 0 being those of the lattice, and each kind of
    tetrahedron is put together from flags: read [Grading/Octree.v] first, then
    [Grading/Flag.v] and [Grading/GradedTet.v], which has the table of the five
    kinds, and [Grading/Surface.v], where the octree of a mesh is made.

    [Certificate.v] exports this page, and [make audit] checks it as that one. *)

From Coq Require Import ZArith Reals List.

(** What runs, and what is graded. *)
From Certet Require Export Lattice.Coord3 Lattice.StructuredTet Lattice.Tiling.
From Certet Require Export Stencil.UnstructuredTet Stencil.StencilSet.
From Certet Require Export Stuffing.Stuffing Stuffing.Domain.
From Certet Require Export Mesh.Method Mesh.CertifiedSpec.
From Certet Require Export Grading.Octree Grading.Flag Grading.GradedTet.
From Certet Require Export Grading.Surface.

(** What is meant. *)
From Certet Require Export Lattice.NeighborSpec Stencil.TriangleSpec.
From Certet Require Export Stuffing.MeshSpec Angles.Geometry Angles.AnglesSpec.
From Certet Require Export Angles.DegreesSpec Range.RangeSpec.
From Certet Require Export Grading.GradingSpec.

(** Why it holds. *)
From Certet Require Grading.PartitionProof Grading.GradedVolumeProof.
From Certet Require Grading.GradedNeighborProof Grading.ClosureProof.
From Certet Require Grading.TouchedProof Grading.GradedMeshProof.
From Certet Require Grading.GradedConformProof Grading.GradedRangeProof.
From Certet Require Grading.OtherGradingProof.

Open Scope Z_scope.

(** ** The mesh

    A graded mesh has within each structured tetrahedron that it keeps what the
    method makes there, and its other tetrahedra whole. *)

(** Whatever the method and the domain, and whichever octree keeps the cells near
    the surface: every tetrahedron of the graded mesh has positive volume, and
    dihedral angles within the bounds of the method. *)
Theorem CertifiedGradedMesh :
  forall (method : Method) (sign : SignField) (domain : PositionSigns) cells,
    let mesh := MeshOf method sign domain in
    IsOctree cells -> KeepsSurface (CornerSigns mesh) cells ->
    forall tid t, InGradedMesh cells tid -> In t (GradedTetsWithin mesh tid) ->
      WithinDegrees (IZR (LeastAngle method) / 100) (IZR (GreatestAngle method) / 100)
        (MapTet (PositionIn mesh) t).
Proof. exact GradedMeshProof.CertifiedGradedMesh. Qed.

(** Both sides of a face of it with a vertex inside have the same triangles, each
    of which belongs to one tetrahedron of either side; *)
Theorem GradedFacesConform :
  forall (method : Method) (sign : SignField) (domain : PositionSigns) cells,
    let mesh := MeshOf method sign domain in
    IsOctree cells -> KeepsSurface (CornerSigns mesh) cells ->
    forall tid i a b c, InGradedMesh cells tid ->
      let face := GradedFace tid i in
      let here := GradedTetsWithin mesh tid in
      let there := GradedTetsWithin mesh (GradedNeighbor cells tid i) in
      LiesIn face a -> LiesIn face b -> LiesIn face c ->
      ((exists f, In f face /\ SignIn mesh (Corner f) = Plus) ->
       AmongTriangles here a b c <-> AmongTriangles there a b c) /\
      (forall t u, In t here -> In u here ->
         HasTriangle t a b c -> HasTriangle u a b c -> t = u).
Proof. exact GradedConformProof.GradedFacesConform. Qed.

(** and a triangle that no other tetrahedron has, there or across a face, has its
    three vertices on the surface. *)
Theorem GradedBoundaryOnSurface :
  forall (method : Method) (sign : SignField) (domain : PositionSigns) cells,
    let mesh := MeshOf method sign domain in
    IsOctree cells -> KeepsSurface (CornerSigns mesh) cells ->
    forall tid t a b c, InGradedMesh cells tid ->
      In t (GradedTetsWithin mesh tid) -> HasTriangle t a b c ->
      (SignIn mesh a = OnSurface /\ SignIn mesh b = OnSurface /\
       SignIn mesh c = OnSurface) \/
      (exists u, u <> t /\ HasTriangle u a b c /\
         (In u (GradedTetsWithin mesh tid) \/
          exists i, In u (GradedTetsWithin mesh (GradedNeighbor cells tid i)))).
Proof. exact GradedConformProof.GradedBoundaryOnSurface. Qed.

(** Up to level 3 no volume overflows: of what is kept structured [CertifiedMesh]
    says it, and here it is of what is kept whole. *)
Theorem GradedVolumesFit :
  forall (method : Method) (sign : SignField) (domain : PositionSigns) cells,
    let mesh := MeshOf method sign domain in
    IsOctree cells -> KeepsSurface (CornerSigns mesh) cells ->
    forall tid t, InGradedMesh cells tid -> StructuredName tid = None ->
      (LevelOf (FlagOfName tid) <= 3)%nat ->
      (forall i, Bounded LatticeLimit (GradedVertexAt tid i)) ->
      In t (GradedTetsWithin mesh tid) -> VolumeFits (MapTet (PositionIn mesh) t).
Proof. exact GradedRangeProof.GradedVolumesFit. Qed.

(** The least octree with the cells near the surface is one, however many levels
    it may have, *)
Theorem GradedOctreeIsOctree :
  forall sign levels, IsOctree (GradedOctree sign levels).
Proof. exact ClosureProof.GradedOctreeIsOctree. Qed.

(** and keeps them; *)
Theorem GradedOctreeKeepsSurface :
  forall sign levels, KeepsSurface sign (GradedOctree sign levels).
Proof. exact ClosureProof.GradedOctreeKeepsSurface. Qed.

(** so is that with any other cells, which a user's sizes may ask for: it has
    them, *)
Theorem OctreeAroundIsOctree :
  forall asked levels, IsOctree (OctreeAround asked levels).
Proof. exact ClosureProof.OctreeAroundIsOctree. Qed.

Theorem OctreeAroundHasAsked :
  forall asked levels level c,
    asked level c = true -> OctreeAround asked levels level c = true.
Proof. exact ClosureProof.OctreeAroundHasAsked. Qed.

(** and no cell that others could do without. *)
Theorem OctreeAroundIsLeast :
  forall asked levels cells,
    IsBalanced cells ->
    (forall level c, (levels <= level)%nat -> cells level c = true) ->
    (forall level c, asked level c = true -> cells level c = true) ->
    forall level c, OctreeAround asked levels level c = true -> cells level c = true.
Proof. exact ClosureProof.OctreeAroundIsLeast. Qed.

(** ** At the surface nothing changes *)

(** A tetrahedron with a vertex that is not inside is a structured one, *)
Theorem TouchedTetsPlain :
  forall sign cells tid i,
    IsOctree cells -> KeepsSurface sign cells -> InGradedMesh cells tid ->
    sign (GradedVertexAt tid i) <> Plus ->
    exists stid, StructuredName tid = Some stid.
Proof. exact TouchedProof.TouchedTetsPlain. Qed.

(** with its vertices, in its order, and its handedness; *)
Theorem StructuredNameCorrect :
  forall cells tid stid,
    InGradedMesh cells tid -> StructuredName tid = Some stid ->
    InLattice stid /\
    (forall i, GradedVertexAt tid i = VertexAt (GetStructuredTet stid) i) /\
    GradedHandedness tid
    = match stid with STId _ case => CaseHandedness case end.
Proof. exact TouchedProof.StructuredNameCorrect. Qed.

(** every structured tetrahedron with such a vertex is there, *)
Theorem SurfaceKept :
  forall sign cells stid i,
    IsOctree cells -> KeepsSurface sign cells -> InLattice stid ->
    sign (VertexAt (GetStructuredTet stid) i) <> Plus ->
    exists tid, InGradedMesh cells tid /\ StructuredName tid = Some stid.
Proof. exact TouchedProof.SurfaceKept. Qed.

(** and none is there twice. *)
Theorem StructuredNameUnique :
  forall cells tid other stid,
    InGradedMesh cells tid -> InGradedMesh cells other ->
    StructuredName tid = Some stid -> StructuredName other = Some stid ->
    other = tid.
Proof. exact TouchedProof.StructuredNameUnique. Qed.

(** ** Nothing is left out, and nothing is there twice *)

(** Every flag present is in one tetrahedron, and a tetrahedron has the flags
    present that name it, each once; *)
Theorem FlagsPartition :
  forall cells, IsOctree cells ->
    (forall x, IsPresent cells x = true ->
       InGradedMesh cells (TetOfFlag cells x)) /\
    (forall tid, InGradedMesh cells tid ->
       NoDup (FlagsOf tid) /\
       forall x, In x (FlagsOf tid) <->
         IsPresent cells x = true /\ TetOfFlag cells x = tid).
Proof. exact PartitionProof.FlagsPartition. Qed.

(** flags are present in every place once: of the cells in which a cell of
    level 0 lies, one fills the place where it does. *)
Theorem EachPlaceFilledOnce :
  forall cells, IsOctree cells ->
    forall c, exists level, FillsAt cells level c /\
      forall other, FillsAt cells other c -> other = level.
Proof. exact PartitionProof.EachPlaceFilledOnce. Qed.

(** The volume of a tetrahedron, right-handed, is that of its flags: a sixth of
    half the cell's side to the third power each. *)
Theorem GradedVolume :
  forall tid,
    match GetGradedTet tid with
      UT _ a b c d =>
        SixVolume a b c d = Z.of_nat (length (FlagsOf tid)) * GradedSize tid ^ 3
    end.
Proof. exact GradedVolumeProof.GradedVolume. Qed.

(** ** Neighbours *)

(** The neighbour across a face is in the mesh, has the face's three vertices, and
    lies on the other side of it; *)
Theorem GradedFacesCorrect :
  forall cells tid i, IsOctree cells -> InGradedMesh cells tid ->
    let nei := GradedNeighbor cells tid i in
    InGradedMesh cells nei /\
    exists j,
      SameVertices (GradedFace tid i) (GradedFace nei j) /\
      LiesBetween (GradedFace tid i) (GradedVertexAt tid i) (GradedVertexAt nei j).
Proof. exact GradedNeighborProof.GradedFacesCorrect. Qed.

(** its neighbour there is the tetrahedron itself. *)
Theorem GradedNeighborInvolution :
  forall cells tid i, IsOctree cells -> InGradedMesh cells tid ->
    let nei := GradedNeighbor cells tid i in
    exists j,
      SameVertices (GradedFace tid i) (GradedFace nei j) /\
      GradedNeighbor cells nei j = tid.
Proof. exact GradedNeighborProof.GradedNeighborInvolution. Qed.

(** ** Angles *)

(** The dihedral angles of all five kinds are between 45 and 120 degrees, as
    integers tell it, *)
Theorem TransitionAngles :
  forall tid, WellShaped (AB (CotSq 1 1) (CotSq 1 3)) (GetGradedTet tid).
Proof. exact GradedVolumeProof.TransitionAngles. Qed.

(** and in degrees. *)
Theorem TransitionAnglesInDegrees :
  forall tid, WithinDegrees 45 120 (GetGradedTet tid).
Proof. exact GradedMeshProof.TransitionAnglesInDegrees. Qed.

(** ** What goes wrong otherwise *)

(** If cells are balanced across faces alone, and not across edges, there are
    tetrahedra whose neighbour has not the face between them. *)
Theorem FaceBalanceFails :
  IsFaceBalanced FaceBalancedCells /\ HasTop FaceBalancedCells /\
  exists tid i, InGradedMesh FaceBalancedCells tid /\
    forall j, ~ SameVertices (GradedFace tid i)
                  (GradedFace (GradedNeighbor FaceBalancedCells tid i) j).
Proof. exact OtherGradingProof.FaceBalanceFails. Qed.

(** If the face of a pyramid is cut along its other diagonal, the tetrahedron
    across has not the half. *)
Theorem FlippedPyramidFails :
  forall cells tid j,
    IsOctree cells -> InGradedMesh cells tid -> KindOfName tid = PyramidTet ->
    ~ SameVertices (GradedFace (FlippedPyramid tid) Fourth)
        (GradedFace (GradedNeighbor cells tid Fourth) j).
Proof. exact OtherGradingProof.FlippedPyramidFails. Qed.
