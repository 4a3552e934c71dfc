(** * The product's rule of who stays, with diagonals by key: proof *)

From Coq Require Import Reals.
From Certet Require Import Key.Definitions.
From Certet Require Import Angles.DegreesSpec Embedding.SettleProof
  Embedding.SettledMeshProof Embedding.MeshEmbedsProof Angles.DomainProof
  Mesh.Method Mesh.CertifiedSpec Mesh.PlacedMeshProof Range.RangeSpec
  Range.RangeProof Embedding.WarpOrClampProof
  Key.OrderProof Key.KeysApartProof Key.KeyBoundsProof Key.KeyDegreesProof
  Key.KeyEmbedsProof Key.CertifiedKeyProof.
Open Scope Z_scope.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpVertex Settle Bisect].

Lemma KeyNamesExt before warping warping' cut tid :
  (forall c, warping c = warping' c) ->
  KeyNames before warping cut tid = KeyNames before warping' cut tid.
Proof.
  intros E. unfold KeyNames, OrderedNames. destruct tid as [anchor case].
  destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4]. f_equal.
  rewrite (KeyTetsNatural (fun v => v) (PlacedSign before warping')
    (PlacedSign before warping) MeshIntersection MeshIntersection
    (MeshKey (CutKey cut)) (MeshKey (CutKey cut)) (Corner v1) (Corner v2) (Corner v3)
    (Corner v4)).
  - rewrite <- map_id. apply map_ext. intros []. reflexivity.
  - intros [c|a m] _; cbn [PlacedSign]; [rewrite E|]; reflexivity.
  - reflexivity.
  - reflexivity.
Qed.

Lemma KeyTetsExt before warping warping' cut tid :
  (forall c, warping c = warping' c) ->
  KeyTets before warping cut tid = KeyTets before warping' cut tid.
Proof.
  intros E. unfold KeyTets. rewrite (KeyNamesExt _ _ _ _ _ E). apply map_ext.
  intros [a b c d]. cbn [MapTet].
  assert (P : forall v, PlacedPosition warping cut v = PlacedPosition warping' cut v)
    by (intros []; cbn [PlacedPosition]; [rewrite E|]; reflexivity).
  rewrite !P. reflexivity.
Qed.

Section Swept.
  Variables (sample : SignField) (cut : CutField) (turns : list Coord3).
  Hypothesis OnEdges : CutsOnEdges sample cut.

  Let sign := OpenSigns sample.
  Let cuts := OpenCuts sample cut.
  Let warping := PlaceIn (Settle KeyThresholds sign cuts LevelGap turns).
  Let clamped := ClampedCut KeyThresholds cuts.

  Lemma SweptByRule : CutsOnEdges sign cuts /\ exists stays limit, forall v,
    warping v = RuledWarping KeyThresholds sign cuts stays limit v.
  Proof.
    assert (on : CutsOnEdges sign cuts) by apply OpenCutsOnEdges, OnEdges.
    split; [exact on|].
    exact (SettledIsRule KeyThresholds sign cuts LevelGap KeyThresholdsAtMostHalf on
      LevelGapSmall turns).
  Qed.

  Theorem KeySweptBoundsInDegrees tid t :
    In t (PlacedWithin (KeySweptMesh sign cuts turns) tid) ->
    WithinDegrees (1118 / 100) (15713 / 100) t.
  Proof.
    destruct SweptByRule as (on & stays & limit & E). intros I.
    apply (KeyRuledBoundsInDegrees sign cuts stays limit tid t on).
    unfold KeyWarpOrClamp. rewrite <- (KeyTetsExt _ _ _ _ _ E). exact I.
  Qed.

  Theorem KeySweptCertified : Certified (KeySweptMesh sign cuts turns) 1118 15713 KeyThresholds.
  Proof.
    destruct SweptByRule as (on & stays & limit & E).
    apply KeyCertified.
    - exact KeySweptBoundsInDegrees.
    - intros tid. split.
      + intros v d t _ W. unfold warping in E. rewrite E in W.
        pose proof (RuledMovesAtMost KeyThresholds sign cuts stays limit on v d t W).
        pose proof (KeyThresholdsAtMostHalf (DirectionKind d)). lia.
      + intros p q _. apply KeyClampedOnEdge.
  Qed.

  Theorem KeySweptMeshEmbeds tid tid' t t' :
    InLattice tid -> InLattice tid' ->
    In t (TetsWithin (KeySweptMesh sign cuts turns) tid) ->
    In t' (TetsWithin (KeySweptMesh sign cuts turns) tid') ->
    MeetInSharedVertices (PositionIn (KeySweptMesh sign cuts turns)) t t'.
  Proof.
    destruct SweptByRule as (on & stays & limit & E).
    cbn [KeySweptMesh KeyMesh TetsWithin PositionIn]. intros L L' I I'.
    apply (OrderedMeshEmbeds (CutKey clamped) sign warping clamped tid tid' t t' L L'
      (CutKeysApart clamped tid) (CutKeysApart clamped tid') I I').
    - intros v d u. unfold u. cbn [PlacedSign]. rewrite !E.
      exact (KeyRuledInside sign cuts stays limit v d).
    - intros v d K. rewrite !E.
      exact (RuledKeepsShortEdges sign cuts stays limit on v d K).
  Qed.
End Swept.

Theorem CertifiedKeySweptMesh sample domain turns :
  Certified
    (KeySweptMesh (OpenSigns sample) (OpenCuts sample (BisectedCuts domain)) turns)
    1118 15713 KeyThresholds.
Proof. apply KeySweptCertified, BisectedOnEdges. Qed.
