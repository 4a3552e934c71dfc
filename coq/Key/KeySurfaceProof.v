(** * With diagonals by key the surface is a manifold: proof

    In any order of the cuts the triangles on the surface within a structured
    tetrahedron hang together as those of the paper's stencils do. *)

From Certet Require Import Key.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.TriangleChecker Stuffing.NameProof Embedding.EdgeRank
  Topology.SurfaceSpec Topology.StencilSurface Topology.LocalSurfaceProof
  Topology.EdgeProof Topology.FanProof Topology.DiskManifoldProof
  Topology.SettledSurfaceProof Topology.DiskKeptProof
  Key.Orders Key.OrderProof Key.KeyChecker Key.KeysApartProof Key.FaceRuleProof
  Key.KeyFollowsProof Key.KeyMeshProof
  Mesh.Method Mesh.MeshPiecesSpec Topology.MeshSurfaceSpec.
Open Scope Z_scope.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpVertex Settle StrictDisk].

Lemma OrdersSurface : InEveryOrder CheckSurface.
Proof. vm_cast_no_check (eq_refl true). Qed.

Section Mesh.
  Variables (before : SignField) (warping : Coord3 -> Warping) (cut : CutField).
  Let key := CutKey cut.
  Let apart tid : KeysApart key (Corners tid) := CutKeysApart cut tid.

  Lemma KeyViewed tid : exists h f1 f2 f3 p q sign ts,
    NoDup [f1; f2; f3; p; q] /\ Corners tid = [f1; f2; f3; p] /\
    (forall l, In l Four ->
       SignAfter before warping (LocateFive f1 f2 f3 p q l) = sign l) /\
    KeyNames before warping cut tid
    = map (fun s => Orient h (MapTet (Name f1 f2 f3 p q) s)) ts /\
    CheckSurface sign ts = true.
  Proof.
    destruct (OrderedViewed key before warping tid (apart tid))
      as (h & f1 & f2 & f3 & p & q & D & V & C & N).
    exists h, f1, f2, f3, p, q, (NamedSign f1 f2 f3 p before warping),
      (NamedRanked f1 f2 f3 p q key before warping).
    split; [exact D|]. split; [exact C|]. split.
    { intros l L. symmetry. exact (NamedSignCorner f1 f2 f3 p q before warping l L). }
    split; [exact N|].
    exact (RankedChecked CheckSurface f1 f2 f3 p q key before warping OrdersSurface).
  Qed.

  Definition KeySurface : SurfaceMesh := {|
    signs_before := before;
    warping_of := warping;
    made_within := KeyNames before warping cut;
    surface_belongs := fun tid t v _ I =>
      proj1 (OrderedFollows key before warping tid (apart tid) t I) v;
    surface_reaches := fun tid t c _ I =>
      OrderedReaches key before warping tid (apart tid) t I c;
    surface_boundary := OrderedBoundary key before warping apart;
    surface_viewed := KeyViewed
  |}.

  Let mesh := KeyMesh before warping cut.

  Theorem KeyBoundaryClosed a b c : SurfaceOf mesh a b c ->
    exists thirds : list MeshVertex, NoDup thirds /\
      (forall d, In d thirds <-> SurfaceOf mesh a b d) /\ Nat.Even (length thirds).
  Proof. exact (EdgesInEven KeySurface a b c). Qed.

  Theorem KeySurfaceManifold a b c : DisksAround (SignAfter before warping) ->
    SurfaceOf mesh a b c ->
    (exists d, d <> c /\ SurfaceOf mesh a b d /\
       forall e, SurfaceOf mesh a b e -> e = c \/ e = d) /\
    (forall x, FanOf mesh a x -> JoinedInFanOf mesh a b x).
  Proof.
    intros D T. split; [exact (EdgesInTwo KeySurface a b c D T)|].
    intros x X. apply (OneFan KeySurface); [exact D|exists c; exact T|exact X].
  Qed.
End Mesh.

Theorem KeySweptSurfaceManifold sample cut turns a b c :
  let mesh := KeySweptMesh (OpenSigns sample) cut turns in
  SurfaceOf mesh a b c ->
  (exists d, d <> c /\ SurfaceOf mesh a b d /\
     forall e, SurfaceOf mesh a b e -> e = c \/ e = d) /\
  (forall x, FanOf mesh a x -> JoinedInFanOf mesh a b x).
Proof.
  apply KeySurfaceManifold.
  apply (DisksAroundSame (SignAmong (OpenSigns sample)
    (Settle KeyThresholds (OpenSigns sample) cut LevelGap turns)));
    [reflexivity|apply SettledDisksAround].
Qed.
