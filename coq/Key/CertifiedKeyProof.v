(** * Every mesh with diagonals by key is certified: proof

    As [PlacedMeshProof] has it of the paper's stencils. *)

From Coq Require Import Reals.
From Certet Require Import Key.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.AngleTheorems Angles.DomainProof
  Embedding.EdgeRank
  Embedding.WarpOrClampProof Range.RangeSpec Range.RangeProof Mesh.Method
  Mesh.CertifiedSpec Mesh.PlacedMeshProof Key.KeysApartProof Key.FaceRuleProof
  Key.KeyFollowsProof Key.KeyMeshProof Key.KeyBoundsProof Key.KeyDegreesProof.
Open Scope Z_scope.

Local Strategy 1000 [WarpVertex Bisect].

Section Placed.
  Variables (before : SignField) (warping : Coord3 -> Warping) (cut : CutField).
  Local Notation mesh := (KeyMesh before warping cut).

  Theorem KeyFacesConform : FacesConform mesh.
  Proof.
    intros tid i a b c face here there in_a in_b in_c. split.
    - intros plus. exact (KeyFacesAgree before warping cut tid i plus a b c in_a in_b in_c).
    - intros t u in_t in_u has_t has_u.
      exact (OrderedTriangleOnce (CutKey cut) before warping tid (CutKeysApart cut tid)
        i t u a b c in_t in_u has_t has_u in_a in_b in_c).
  Qed.

  Theorem KeyBoundary : BoundaryIsSurface mesh.
  Proof.
    intros tid t a b c inside has.
    exact (OrderedBoundary (CutKey cut) before warping (CutKeysApart cut) tid t a b c
      inside has).
  Qed.

  Hypothesis Sane : forall tid, Moderate before warping cut (Corners tid).

  Lemma KeyComparisonsFit : ComparisonsFit KeyThresholds.
  Proof.
    intros k t T. cbn [KeyThresholds].
    assert (S : - (65536 * 65536) <= t * t <= 65536 * 65536)
      by (apply ProductBound; rewrite StepsIs in T; lia).
    unfold ThresholdFormula, OtherEndFormula, DistanceFormula;
      destruct k; cbn [LengthSquared KeyThresholds]; reckon;
      unfold KeyThresholds, ThresholdSteps; rewrite ?StepsIs;
      change (65536 / 256) with 256; lia.
  Qed.

  Theorem KeyNothingOverflows : NothingOverflows mesh KeyThresholds.
  Proof.
    apply (OfCornersNothingOverflows before warping cut Sane); [|exact KeyComparisonsFit].
    intros tid u m I J.
    pose proof (proj1 (OrderedFollows (CutKey cut) before warping tid
      (CutKeysApart cut tid) u I) m J) as B.
    destruct m; cbn [Belongs OfCorners] in *; tauto.
  Qed.

  (** Keys fit 32 bits. *)
  Theorem KeysFit a m : 0 <= cut a m <= Steps -> 0 <= CutKey cut a m <= 196610.
  Proof.
    unfold CutKey. rewrite StepsIs. pose proof (KeysApartProof.RankInRange a m). lia.
  Qed.
End Placed.

Lemma KeyCertified before warping cut :
  (forall tid t, In t (KeyTets before warping cut tid) ->
     WithinDegrees (1118 / 100) (15713 / 100) t) ->
  (forall tid, Moderate before warping cut (Corners tid)) ->
  Certified (KeyMesh before warping cut) 1118 15713 KeyThresholds.
Proof.
  intros within sane.
  split; [exact (DegreesPositive (KeyMesh before warping cut) _ _ within)|].
  split; [exact (DegreesBetween (KeyMesh before warping cut) 1118 15713 within)|].
  split; [apply KeyFacesConform|].
  split; [apply KeyBoundary|].
  apply KeyNothingOverflows, sane.
Qed.

Theorem CertifiedKeyMesh sign domain :
  let cut := BisectedCuts domain in
  Certified (KeyMesh sign (WarpVertex KeyThresholds sign cut) cut)
    1118 15713 KeyThresholds.
Proof.
  intros cut. assert (on : CutsOnEdges sign cut) by apply BisectedOnEdges.
  apply KeyCertified.
  - intros tid t I. apply (KeyBoundsInDegrees sign cut tid t on).
    rewrite KeyStuffedArePlaced. exact I.
  - intros tid. apply StuffedModerate; [exact KeyThresholdsAtMostHalf|exact on].
Qed.

Lemma KeyClampedOnEdge cut p q : 0 <= ClampedCut KeyThresholds cut p q <= Steps.
Proof.
  apply ClampedOnEdge; [exact KeyThresholdsAtMostHalf|intros []; discriminate].
Qed.

Theorem CertifiedKeyRuledMesh sign cut stays limit : CutsOnEdges sign cut ->
  Certified
    (KeyMesh sign (RuledWarping KeyThresholds sign cut stays limit)
       (ClampedCut KeyThresholds cut))
    1118 15713 KeyThresholds.
Proof.
  intros on. apply KeyCertified.
  - intros tid t I. exact (KeyRuledBoundsInDegrees sign cut stays limit tid t on I).
  - intros tid. split.
    + intros v d t _ W.
      pose proof (RuledMovesAtMost KeyThresholds sign cut stays limit on v d t W).
      pose proof (KeyThresholdsAtMostHalf (DirectionKind d)). lia.
    + intros p q _. apply KeyClampedOnEdge.
Qed.
