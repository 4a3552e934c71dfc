(** * The certificate, for diagonals by key

    The paper's diagonals follow the Parity Rule, whatever the domain.  Here they
    follow the cuts: in every quadrilateral on a face of the lattice the diagonal
    ends at the cut that lies nearer to its + end, in parts of its edge.  Both
    sides of a face still agree, as they see the same cuts, and the angles are
    better: 11.18 and 157.13 degrees at thresholds at which no short edge is turned
    over, so that the same mesh embeds too.

    Read [Key/KeyTet.v], the stencils in any order of the cuts, and
    [Key/KeyStuffing.v], the order.  [C15Certificate.v] has the same diagonals in
    another lattice.  [Certificate.v] exports this page and that, and [make audit]
    checks them as that one. *)

From Coq Require Import ZArith Reals List.

(** What is meant to run. *)
From Certet Require Export Lattice.Coord3 Lattice.StructuredTet Lattice.EdgeRank.
From Certet Require Export Stencil.UnstructuredTet Stencil.StencilSet.
From Certet Require Export Warp.Cut Warp.Warp.
From Certet Require Export Stuffing.Stuffing Stuffing.Domain.
From Certet Require Export Embedding.WarpOrClamp Embedding.Settle.
From Certet Require Export Key.KeyTet Key.KeyStuffing.

(** Another lattice. *)
From Certet Require Export C15Certificate.

(** What is meant. *)
From Certet Require Export Lattice.NeighborSpec Stencil.TriangleSpec Stuffing.MeshSpec.
From Certet Require Export Angles.Geometry Angles.AnglesSpec Angles.DegreesSpec.
From Certet Require Export Embedding.EmbeddingSpec.
From Certet Require Export Embedding.PiecesSpec Embedding.SettleSpec.
From Certet Require Export Topology.SurfaceSpec Topology.VoxelSpec.
From Certet Require Export Mesh.Method Mesh.CertifiedSpec Mesh.MeshPiecesSpec.
From Certet Require Export Topology.MeshSurfaceSpec.
From Certet Require Export Key.FaceRule Key.KeySpec.

(** Why it holds. *)
From Certet Require Key.ParityProof Key.KeysApartProof Key.FaceRuleProof.
From Certet Require Key.KeyBoundsProof Key.KeyDegreesProof Key.KeyEmbedsProof.
From Certet Require Key.KeySharpnessProof Key.CertifiedKeyProof Key.KeySettledProof.
From Certet Require Key.KeySweptPiecesProof Key.KeySurfaceProof.

Open Scope Z_scope.

(** Whatever the domain, and whichever lattice points are taken as inside, with
    the paper's warp and diagonals by key: every tetrahedron has positive volume;
    every dihedral angle is between 11.18 and 157.13 degrees; both sides of a face
    have the same triangles; a triangle that only one tetrahedron has lies on the
    surface; and no integer overflows. *)
Theorem CertifiedKeyMesh :
  forall (sign : SignField) (domain : PositionSigns),
    let cut := BisectedCuts domain in
    let mesh := KeyMesh sign (WarpVertex KeyThresholds sign cut) cut in
    TetsPositive mesh /\
    AnglesBetween mesh 1118 15713 /\
    FacesConform mesh /\
    BoundaryIsSurface mesh /\
    NothingOverflows mesh KeyThresholds.
Proof. exact CertifiedKeyProof.CertifiedKeyMesh. Qed.

(** And so for any rule of who stays and how far the others move, if cuts are kept
    alpha away from both ends; the keys are those of the cuts so kept. *)
Theorem CertifiedKeyRuledMesh :
  forall sign cut stays limit, CutsOnEdges sign cut ->
    let mesh := KeyMesh sign (RuledWarping KeyThresholds sign cut stays limit)
                  (ClampedCut KeyThresholds cut) in
    TetsPositive mesh /\
    AnglesBetween mesh 1118 15713 /\
    FacesConform mesh /\
    BoundaryIsSurface mesh /\
    NothingOverflows mesh KeyThresholds.
Proof. exact CertifiedKeyProof.CertifiedKeyRuledMesh. Qed.

(** By the rule that the product runs by default, one sweep over any list of
    vertices in any order, *)
Theorem CertifiedKeySweptMesh :
  forall (sample : SignField) (domain : PositionSigns) (turns : list Coord3),
    let mesh := KeySweptMesh (OpenSigns sample)
                  (OpenCuts sample (BisectedCuts domain)) turns in
    TetsPositive mesh /\
    AnglesBetween mesh 1118 15713 /\
    FacesConform mesh /\
    BoundaryIsSurface mesh /\
    NothingOverflows mesh KeyThresholds.
Proof. exact KeySettledProof.CertifiedKeySweptMesh. Qed.

(** and any two of its tetrahedra meet exactly in the vertices they share. *)
Theorem KeySweptMeshEmbeds :
  forall sample cut turns, CutsOnEdges sample cut ->
    let mesh := KeySweptMesh (OpenSigns sample) (OpenCuts sample cut) turns in
    forall tid tid' t t', InLattice tid -> InLattice tid' ->
      In t (TetsWithin mesh tid) -> In t' (TetsWithin mesh tid') ->
      MeetInSharedVertices (PositionIn mesh) t t'.
Proof. exact KeySettledProof.KeySweptMeshEmbeds. Qed.

(** A key fits an integer of 32 bits, and of 18 without a sign. *)
Theorem KeysFit :
  forall cut a m, 0 <= cut a m <= Steps -> 0 <= CutKey cut a m <= 196610.
Proof. exact CertifiedKeyProof.KeysFit. Qed.

(** ** The paper's stencils are those of one order *)

(** If the keys put long edges first, then [v1 v4] and [v2 v3], then the others,
    these are the paper's 81 stencils, vertex by vertex. *)
Theorem ParityIsAnOrder :
  forall Vertex GetSign GetIntersection GetKey (v1 v2 v3 v4 : Vertex),
    KeepsParity GetKey v1 v2 v3 v4 ->
    GetKeyTets Vertex GetSign GetIntersection GetKey v1 v2 v3 v4
    = GetUnstructuredTets Vertex GetSign GetIntersection v1 v2 v3 v4.
Proof. exact ParityProof.ParityIsAnOrder. Qed.

(** In the lattice so do the ranks of edges, *)
Theorem RanksKeepParity :
  forall before warping tid, InLattice tid ->
    OrderedNames EdgeRank before warping tid = PlacedNames before warping tid.
Proof. exact ParityProof.RanksKeepParity. Qed.

(** and the keys of cuts that are all equally far from their + ends: with cuts in
    the middle, nothing changes. *)
Theorem EqualCutsKeepParity :
  forall before warping cut t tid, InLattice tid ->
    (forall a m, In a (Corners tid) -> In m (Corners tid) -> cut a m = t) ->
    KeyNames before warping cut tid = PlacedNames before warping tid.
Proof. exact ParityProof.EqualCutsKeepParity. Qed.

(** ** The two sides of a face agree *)

(** Cuts that share an end never have the same key, so that there are no ties. *)
Theorem CutKeysApart : forall cut tid, KeysApart (CutKey cut) (Corners tid).
Proof. exact KeysApartProof.CutKeysApart. Qed.

(** In any order of the cuts the triangles that a structured tetrahedron has on a
    face with a + corner are those that the face's own rule says, from the signs of
    its corners and the keys of its cuts alone. *)
Theorem StencilFaceIsFaceRule :
  forall key before warping tid f1 f2 f3,
    let face := (f1 :: f2 :: f3 :: nil)%list in
    NoDup face -> incl face (Corners tid) -> KeysApart key (Corners tid) ->
    (exists f, In f face /\ PlacedSign before warping (Corner f) = Plus) ->
    forall a b c, LiesIn face a -> LiesIn face b -> LiesIn face c ->
      AmongTriangles (OrderedNames key before warping tid) a b c <->
      OnFace key before warping f1 f2 f3 a b c.
Proof. exact FaceRuleProof.StencilFaceIsFaceRule. Qed.

(** So both sides of a face have the same triangles, in any order of the cuts, *)
Theorem OrderedFacesAgree :
  forall key before warping tid i,
    KeysApart key (Corners tid) -> KeysApart key (Corners (NeighborOf tid i)) ->
    let face := FaceOf tid i in
    (exists f, In f face /\ PlacedSign before warping (Corner f) = Plus) ->
    forall a b c, LiesIn face a -> LiesIn face b -> LiesIn face c ->
      AmongTriangles (OrderedNames key before warping tid) a b c <->
      AmongTriangles (OrderedNames key before warping (NeighborOf tid i)) a b c.
Proof. exact FaceRuleProof.OrderedFacesAgree. Qed.

(** and by key, whatever the warp and the cuts. *)
Theorem KeyFacesAgree :
  forall before warping cut tid i,
    let face := FaceOf tid i in
    (exists f, In f face /\ PlacedSign before warping (Corner f) = Plus) ->
    forall a b c, LiesIn face a -> LiesIn face b -> LiesIn face c ->
      AmongTriangles (KeyNames before warping cut tid) a b c <->
      AmongTriangles (KeyNames before warping cut (NeighborOf tid i)) a b c.
Proof. exact FaceRuleProof.KeyFacesAgree. Qed.

(** ** Angles *)

(** At 64/256 and 95/256, of every admissible placement, every tetrahedron is
    right-handed and its dihedral angles are between those whose cotangents'
    squares are 179/7 and 73/13, *)
Theorem KeyDihedralBounds :
  forall tid before warping cut,
    Admissible before warping cut KeyThresholds (Corners tid) ->
    forall t, In t (KeyTets before warping cut tid) ->
      WellShaped (AB (CotSq 179 7) (CotSq 73 13)) t.
Proof. exact KeyBoundsProof.KeyDihedralBounds. Qed.

(** which is between 11.18 and 157.13 degrees. *)
Theorem KeyDihedralBoundsInDegrees :
  forall tid before warping cut t,
    Admissible before warping cut KeyThresholds (Corners tid) ->
    In t (KeyTets before warping cut tid) ->
    WithinDegrees (1118 / 100) (15713 / 100) t.
Proof. exact KeyDegreesProof.KeyDihedralBoundsInDegrees. Qed.

Theorem KeyPositiveVolume :
  forall tid before warping cut t,
    Admissible before warping cut KeyThresholds (Corners tid) ->
    In t (KeyTets before warping cut tid) -> Positive t.
Proof. exact KeyBoundsProof.KeyPositiveVolume. Qed.

(** So it is after the paper's warp, *)
Theorem KeyBoundsInDegrees :
  forall sign cut tid t, CutsOnEdges sign cut ->
    In t (KeyStuffedTets KeyThresholds sign cut tid) ->
    WithinDegrees (1118 / 100) (15713 / 100) t.
Proof. exact KeyDegreesProof.KeyBoundsInDegrees. Qed.

(** with any rule of who stays, *)
Theorem KeyRuledBoundsInDegrees :
  forall sign cut stays limit tid t, CutsOnEdges sign cut ->
    In t (KeyWarpOrClamp KeyThresholds sign cut stays limit tid) ->
    WithinDegrees (1118 / 100) (15713 / 100) t.
Proof. exact KeyDegreesProof.KeyRuledBoundsInDegrees. Qed.

(** and by the rule that the product runs by default, wherever the cuts are. *)
Theorem KeySweptBoundsInDegrees :
  forall sample cut turns, CutsOnEdges sample cut ->
    let mesh := KeySweptMesh (OpenSigns sample) (OpenCuts sample cut) turns in
    forall tid t, In t (PlacedWithin mesh tid) ->
      WithinDegrees (1118 / 100) (15713 / 100) t.
Proof. exact KeySettledProof.KeySweptBoundsInDegrees. Qed.

(** ** The whole mesh *)

(** No tetrahedron of the warped lattice is turned over, kept or dropped. *)
Theorem KeyLatticePositive :
  forall sign cut tid, CutsOnEdges sign cut ->
    Positive (WarpedTet KeyThresholds sign cut tid).
Proof. exact KeyBoundsProof.KeyLatticePositive. Qed.

(** In any order of the cuts: if no short edge is turned over and cuts lie inside
    their edges, any two tetrahedra meet exactly in the vertices they share. *)
Theorem OrderedMeshEmbeds :
  forall key before warping cut tid tid' t t',
    InLattice tid -> InLattice tid' ->
    KeysApart key (Corners tid) -> KeysApart key (Corners tid') ->
    In t (OrderedNames key before warping tid) ->
    In t' (OrderedNames key before warping tid') ->
    CutsInside before warping cut ->
    KeepsShortEdges (fun c => WarpedPosition c (warping c)) ->
    MeetInSharedVertices (PlacedPosition warping cut) t t'.
Proof. exact KeyEmbedsProof.OrderedMeshEmbeds. Qed.

(** The paper's warp turns none over at alpha of at most 1/4 of a long edge and 1/2
    of a short one: the mesh embeds, nobody stays for it, *)
Theorem KeyMeshEmbeds :
  forall long short sign cut tid tid' t t',
    let th := TH long short in
    0 < long <= 64 -> 0 < short <= 128 ->
    CutsOnEdges sign cut -> InLattice tid -> InLattice tid' ->
    In t (KeyStuffTet th sign cut tid) -> In t' (KeyStuffTet th sign cut tid') ->
    MeetInSharedVertices (MeshPosition th sign cut) t t'.
Proof. exact KeyEmbedsProof.KeyMeshEmbeds. Qed.

(** and no point is inside two tetrahedra. *)
Theorem KeyInteriorsApart :
  forall long short sign cut tid tid' t t',
    let th := TH long short in
    0 < long <= 64 -> 0 < short <= 128 ->
    CutsOnEdges sign cut -> InLattice tid -> InLattice tid' ->
    In t (KeyStuffTet th sign cut tid) -> In t' (KeyStuffTet th sign cut tid') ->
    Overlap (MapTet (MeshPosition th sign cut) t)
            (MapTet (MeshPosition th sign cut) t') ->
    tid = tid' /\ t = t'.
Proof. exact KeyEmbedsProof.KeyInteriorsApart. Qed.

(** With any rule of who stays the mesh embeds as it is: no move needs to be cut
    short for it. *)
Theorem KeyRuledMeshEmbeds :
  forall sign cut stays limit, CutsOnEdges sign cut ->
    let warping := RuledWarping KeyThresholds sign cut stays limit in
    let clamped := ClampedCut KeyThresholds cut in
    forall tid tid' t t', InLattice tid -> InLattice tid' ->
      In t (KeyNames sign warping clamped tid) ->
      In t' (KeyNames sign warping clamped tid') ->
      MeetInSharedVertices (PlacedPosition warping clamped) t t'.
Proof. exact KeyEmbedsProof.KeyRuledMeshEmbeds. Qed.

Theorem KeyRuledInteriorsApart :
  forall sign cut stays limit, CutsOnEdges sign cut ->
    let warping := RuledWarping KeyThresholds sign cut stays limit in
    let clamped := ClampedCut KeyThresholds cut in
    forall tid tid' t t', InLattice tid -> InLattice tid' ->
      In t (KeyNames sign warping clamped tid) ->
      In t' (KeyNames sign warping clamped tid') ->
      Overlap (MapTet (PlacedPosition warping clamped) t)
              (MapTet (PlacedPosition warping clamped) t') ->
      tid = tid' /\ t = t'.
Proof. exact KeyEmbedsProof.KeyRuledInteriorsApart. Qed.

(** ** No piece is lost, cut or joined to another

    Read [Mesh/MeshPiecesSpec.v]: the pieces of any mesh.  Where a diagonal lies
    matters to none of this. *)

(** Whatever the warp and the cuts: if no face of the lattice with all its corners on
    the surface has + on both sides, two tetrahedra are joined by faces just as +
    corners of their structured tetrahedra are joined by edges. *)
Theorem KeyMeshPieces :
  forall before warping cut, NoWall before warping ->
    let mesh := KeyMesh before warping cut in
    forall p q t u, InsideMesh mesh p -> InsideMesh mesh q ->
      MadeAround mesh p t -> MadeAround mesh q u ->
      Joined (TetOf mesh) ShareFace t u <->
      Joined (InsideMesh mesh) Adjacent p q.
Proof. exact KeySweptPiecesProof.KeyMeshPieces. Qed.

(** By the rule that the product runs by default, whatever the samples, whoever is in
    the list and in what order, the pieces of the mesh by faces are those of the
    samples by edges, *)
Theorem KeyPiecesKept :
  forall sample cut turns,
    let sign := OpenSigns sample in
    let mesh := KeySweptMesh sign cut turns in
    forall p q t u, InsideMesh mesh p -> InsideMesh mesh q ->
      MadeAround mesh p t -> MadeAround mesh q u ->
      Joined (TetOf mesh) ShareFace t u <->
      Joined (PlusBefore sign) Adjacent p q.
Proof. exact KeySweptPiecesProof.KeyPiecesKept. Qed.

(** none is lost, *)
Theorem KeyNoPieceLost :
  forall sample cut turns p,
    let sign := OpenSigns sample in
    let mesh := KeySweptMesh sign cut turns in
    PlusBefore sign p -> (exists tid, InLattice tid /\ In p (Corners tid)) ->
    exists q t, InsideMesh mesh q /\ MadeAround mesh q t /\
      Joined (PlusBefore sign) Adjacent p q.
Proof. exact KeySweptPiecesProof.KeyNoPieceLost. Qed.

(** the outside, with the surface, keeps its pieces too, *)
Theorem KeyOutsideKept :
  forall sample cut turns p q,
    let sign := OpenSigns sample in
    let mesh := KeySweptMesh sign cut turns in
    ~ PlusBefore sign p -> ~ PlusBefore sign q ->
    Joined (fun v => ~ InsideMesh mesh v) Adjacent p q <->
    Joined (fun v => ~ PlusBefore sign v) Adjacent p q.
Proof. exact KeySweptPiecesProof.KeyOutsideKept. Qed.

(** and no cavity is made. *)
Theorem KeyMakesNoCavity :
  forall sample cut turns p,
    let sign := OpenSigns sample in
    let mesh := KeySweptMesh sign cut turns in
    ~ InsideMesh mesh p ->
    exists q, ~ PlusBefore sign q /\
      Joined (fun v => ~ InsideMesh mesh v) Adjacent p q.
Proof. exact KeySweptPiecesProof.KeyMakesNoCavity. Qed.

(** Given the samples of [VoxelSigns] of any label image, the pieces of the mesh by
    faces are the pieces of the image by faces, *)
Theorem KeyVoxelPieces :
  forall grid image cut turns, FineEnough grid ->
    let mesh := KeySweptMesh (OpenSigns (VoxelSigns grid image)) cut turns in
    forall p q t u, InsideMesh mesh p -> InsideMesh mesh q ->
      MadeAround mesh p t -> MadeAround mesh q u ->
      Joined (TetOf mesh) ShareFace t u <->
      Joined (fun x => image x = true) Beside (Owner grid p) (Owner grid q).
Proof. exact KeySweptPiecesProof.KeyVoxelPieces. Qed.

(** and none is lost. *)
Theorem KeyVoxelNoPieceLost :
  forall grid image cut turns, FineEnough grid ->
    let mesh := KeySweptMesh (OpenSigns (VoxelSigns grid image)) cut turns in
    forall x, image x = true ->
      exists q t, InsideMesh mesh q /\ MadeAround mesh q t /\
        Joined (fun y => image y = true) Beside x (Owner grid q).
Proof. exact KeySweptPiecesProof.KeyVoxelNoPieceLost. Qed.

(** ** The surface is a manifold

    Read [Topology/MeshSurfaceSpec.v]: the surface of any mesh. *)

(** Whatever the warp and the cuts, every edge of the surface lies in an even number
    of its triangles. *)
Theorem KeyBoundaryClosed :
  forall before warping cut,
    let mesh := KeyMesh before warping cut in
    forall a b c, SurfaceOf mesh a b c ->
      exists thirds : list MeshVertex, NoDup thirds /\
        (forall d, In d thirds <-> SurfaceOf mesh a b d) /\
        Nat.Even (length thirds).
Proof. exact KeySurfaceProof.KeyBoundaryClosed. Qed.

(** If every vertex on the surface that has an inner neighbour has a strict disk, it
    is a manifold: every edge of it lies in exactly two of its triangles, and the
    triangles at every vertex are one fan. *)
Theorem KeySurfaceManifold :
  forall before warping cut,
    let mesh := KeyMesh before warping cut in
    forall a b c, DisksAround (SignAfter before warping) -> SurfaceOf mesh a b c ->
      (exists d, d <> c /\ SurfaceOf mesh a b d /\
         forall e, SurfaceOf mesh a b e -> e = c \/ e = d) /\
      (forall x, FanOf mesh a x -> JoinedInFanOf mesh a b x).
Proof. exact KeySurfaceProof.KeySurfaceManifold. Qed.

(** By the rule that the product runs by default it is, whatever the samples, whoever
    is in the list and in what order. *)
Theorem KeySweptSurfaceManifold :
  forall sample cut turns a b c,
    let mesh := KeySweptMesh (OpenSigns sample) cut turns in
    SurfaceOf mesh a b c ->
    (exists d, d <> c /\ SurfaceOf mesh a b d /\
       forall e, SurfaceOf mesh a b e -> e = c \/ e = d) /\
    (forall x, FanOf mesh a x -> JoinedInFanOf mesh a b x).
Proof. exact KeySurfaceProof.KeySweptSurfaceManifold. Qed.
