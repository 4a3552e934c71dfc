(** * The certificate, for the whole mesh

    No two of its tetrahedra overlap, and they fill what they should; its pieces
    are those of the samples, and of an image's voxels; its surface is a closed
    manifold.  Of the warp that runs, [Settle], and of others with which it shares
    why: read [Embedding/Settle.v] first, which has the rule in full.

    [Certificate.v] exports this page, and [make audit] checks it as that one. *)

From Coq Require Import ZArith Reals List Permutation.

(** What runs. *)
From Certet Require Export Lattice.Coord3 Lattice.Direction.
From Certet Require Export Lattice.StructuredTet.
From Certet Require Export Stencil.UnstructuredTet Stencil.StencilSet.
From Certet Require Export Warp.Cut Warp.Warp.
From Certet Require Export Stuffing.Stuffing Stuffing.Domain.
From Certet Require Export Mesh.Method Mesh.CertifiedSpec.

(** A warp with a rule of who stays: by turns, as no program runs it, and as one
    sweep over a list, which is what runs. *)
From Certet Require Export Embedding.WarpOrClamp Embedding.DiskRule.
From Certet Require Export Embedding.DiskTables Embedding.Settle.

(** What is meant. *)
From Certet Require Export Lattice.NeighborSpec Stencil.TriangleSpec.
From Certet Require Export Stuffing.MeshSpec Warp.WarpSpec.
From Certet Require Export Angles.Geometry Angles.AnglesSpec Angles.DegreesSpec.
From Certet Require Export Embedding.EmbeddingSpec Embedding.PiecesSpec.
From Certet Require Export Embedding.SettleSpec.
From Certet Require Export Topology.SurfaceSpec Topology.TwoSidesSpec.
From Certet Require Export Topology.VoxelSpec.

(** Why it holds. *)
From Certet Require Mesh.CertifiedMeshProof Embedding.WarpedLatticeProof.
From Certet Require Embedding.MeshEmbedsProof Embedding.LatticeVolumeProof.
From Certet Require Embedding.LatticeCoversProof Embedding.MeshApartProof.
From Certet Require Embedding.FoldWitness Embedding.WarpOrClampProof.
From Certet Require Embedding.RuledMeshProof Embedding.RuledDegreesProof.
From Certet Require Embedding.PiecesProof Embedding.DiskPiecesProof.
From Certet Require Embedding.DiskTablesProof Embedding.SettleProof.
From Certet Require Embedding.SettledMeshProof Embedding.SettleOrderProof.
From Certet Require Topology.DiskKeptProof Topology.DiskManifoldProof.
From Certet Require Topology.SettledSurfaceProof Topology.TwoSidesFillProof.
From Certet Require Topology.TwoSidesMeetProof Topology.SettledTwoSidesProof.
From Certet Require Topology.VoxelProof Topology.VoxelMeshProof.
From Certet Require Topology.SettledVoxelProof Angles.Forms.EdgeProof.

Open Scope Z_scope.

(** ** The whole mesh

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

(** ** Any violated vertex may stay

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

(** ** No piece is lost, cut or joined to another

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

(** ** The warp that keeps the shape, as it runs

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

(** ** The surface is a manifold

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
Proof. exact DiskManifoldProof.BoundaryClosed. Qed.

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

(** ** Inside and outside fill space

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

(** ** The pieces of a label image

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
