(** * The certificate, for any number of materials

    Where an image has many regions, each of them is a material, and the mesh has
    the surfaces between them.  [GetMaterialTets] gives the tetrahedra of one
    structured tetrahedron with the material of each.  It is what
    [GetUnstructuredTets] gives, once for each material that is there, and where
    three or four materials meet a fill between them: read
    [Material/MaterialTet.v] first, then [Material/MaterialMesh.v], where it is
    run on the lattice, and [Material/MaterialSpec.v].

    [Certificate.v] exports this page, and [make audit] checks it as that one. *)

From Coq Require Import ZArith List.

(** What runs. *)
From Certet Require Export Lattice.Coord3 Lattice.StructuredTet.
From Certet Require Export Stencil.UnstructuredTet Stencil.StencilSet.
From Certet Require Export Warp.Cut Warp.Warp Stuffing.Stuffing.
From Certet Require Export Material.MaterialTet Material.MaterialMesh.

(** What is meant. *)
From Certet Require Export Lattice.NeighborSpec Stencil.TriangleSpec.
From Certet Require Export Stuffing.MeshSpec Angles.Geometry Angles.AnglesSpec.
From Certet Require Export Material.MaterialSpec Material.OtherMaterials.

(** Why it holds. *)
From Certet Require Material.MaterialChecker.
From Certet Require Material.MaterialReducesProof Material.MaterialMeshProof.

Open Scope Z_scope.

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

(** and so has the mesh, whatever the domain and the thresholds. *)
Theorem MaterialMeshReduces :
  forall th sign cut tid m, Outside < m ->
    OfMaterial m
      (MaterialNames
         (fun c => OneMaterial m (MeshVertexSign th sign cut (Corner c)))
         (fun _ => Outside) tid)
    = StuffTet th sign cut tid.
Proof. exact MaterialReducesProof.MaterialMeshReduces. Qed.

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
