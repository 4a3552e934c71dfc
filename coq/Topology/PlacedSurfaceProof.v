(** * The paper's stencils, as the surface looks at them: proof *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stuffing.NameProof
  Stuffing.MeshProof Embedding.EdgeRank Embedding.MeshApartProof
  Embedding.AroundProof Embedding.WholeProof Topology.StencilSurface Topology.LocalSurfaceProof.

Section Placed.
  Variables (before : SignField) (warping : Coord3 -> Warping).

  Lemma PlacedBoundary tid t a b c :
    In t (PlacedNames before warping tid) -> HasTriangle t a b c ->
    let signed v := PlacedSign before warping v in
    (signed a = OnSurface /\ signed b = OnSurface /\ signed c = OnSurface) \/
    exists u, u <> t /\ HasTriangle u a b c /\
      (In u (PlacedNames before warping tid) \/
       exists i, In u (PlacedNames before warping (NeighborOf tid i))).
  Proof.
    intros I H signed. unfold signed. rewrite !(SignAsStuffed before warping).
    rewrite NamesAsStuffed in I.
    destruct (BoundaryOnSurface _ _ _ tid t a b c I H) as [Z|(u & N & K & J)];
      [left; exact Z|right]. exists u. split; [exact N|]. split; [exact K|].
    destruct J as [J|[i J]]; [left|right; exists i]; rewrite NamesAsStuffed; exact J.
  Qed.

  Lemma PlacedViewed tid : exists h f1 f2 f3 p q sign ts,
    NoDup [f1; f2; f3; p; q] /\ Corners tid = [f1; f2; f3; p] /\
    (forall l, In l Four ->
       SignAfter before warping (LocateFive f1 f2 f3 p q l) = sign l) /\
    PlacedNames before warping tid
    = map (fun s => Orient h (MapTet (Name f1 f2 f3 p q) s)) ts /\
    CheckSurface sign ts = true.
  Proof.
    destruct (Labelled before warping tid)
      as (h & f1 & f2 & f3 & p & q & s1 & s2 & s3 & sp & sq & D & C & _ & S & N).
    exists h, f1, f2, f3, p, q, (SignOf s1 s2 s3 sp sq),
      (SymbolicTets GetUnstructuredTets (SignOf s1 s2 s3 sp sq) F1 F2 F3 P).
    repeat (split; [assumption|]).
    exact (ForAllSignAssignmentsSound _ SurfaceChecked s1 s2 s3 sp sq).
  Qed.

  Definition PlacedSurface : SurfaceMesh := {|
    signs_before := before;
    warping_of := warping;
    made_within := PlacedNames before warping;
    surface_belongs := fun tid t v E I =>
      proj1 (StuffedFollows before warping tid t E I) v;
    surface_reaches := fun tid t c _ I => ReachesAllCorners before warping tid t I c;
    surface_boundary := PlacedBoundary;
    surface_viewed := PlacedViewed
  |}.
End Placed.
