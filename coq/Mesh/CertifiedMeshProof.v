(** * Every mesh of the product is certified: proof

    The angles are theorems of their own; the rest holds of any placement. *)

From Coq Require Import Reals Lra.
From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.AngleTheorems
  Angles.DomainProof Angles.Degrees.DegreesProof
  Angles.Degrees.DomainDegreesProof Embedding.WarpOrClampProof
  Embedding.RuledDegreesProof Embedding.SettleProof Embedding.SettledMeshProof
  Range.RangeSpec Range.RangeProof Mesh.Method Mesh.CertifiedSpec
  Mesh.PlacedMeshProof Key.KeySettledProof.
Open Scope Z_scope.

Local Strategy 1000 [WarpVertex Bisect Settle].

(** [StuffTet] makes the mesh of the placement that [Warp] leaves. *)
Lemma StuffedIsPlaced th sign cut :
  StuffedMesh th sign cut = PlacedMesh sign (WarpVertex th sign cut) cut.
Proof. reflexivity. Qed.

Lemma NoWarpThresholdsAtMostHalf : AtMostHalf NoWarpThresholds.
Proof. intros []; vm_compute; discriminate. Qed.

Lemma StuffedCertified th sign cut (least greatest : Z) :
  let mesh := StuffedMesh th sign cut in
  AtMostHalf th -> CutsOnEdges sign cut ->
  (forall tid t, In t (StuffedTets th sign cut tid) ->
     WithinDegrees (IZR least / 100) (IZR greatest / 100) t) ->
  th = AngleThresholds \/ th = EmbeddingThresholds \/ th = NoWarpThresholds ->
  Certified mesh least greatest th.
Proof.
  intros mesh half on within. unfold mesh. rewrite StuffedIsPlaced.
  apply PlacedCertified; [exact within|].
  intros tid. apply StuffedModerate; assumption.
Qed.

(** ** A warp with a rule of who stays *)

Lemma AngleClampedOnEdge cut p q : 0 <= ClampedCut AngleThresholds cut p q <= Steps.
Proof.
  apply ClampedOnEdge; [exact AngleThresholdsAtMostHalf|intros []; discriminate].
Qed.

Lemma RuledModerate sign cut stays limit corners : CutsOnEdges sign cut ->
  Moderate sign (RuledWarping AngleThresholds sign cut stays limit)
    (ClampedCut AngleThresholds cut) corners.
Proof.
  intros on. split; [intros v d t _ W | intros p q _; apply AngleClampedOnEdge].
  pose proof (RuledMovesAtMost AngleThresholds sign cut stays limit on v d t W).
  pose proof (AngleThresholdsAtMostHalf (DirectionKind d)). lia.
Qed.

Theorem CertifiedRuledMesh :
  forall sign cut stays limit, CutsOnEdges sign cut ->
    let mesh := RuledMesh AngleThresholds sign cut stays limit in
    Certified mesh 1077 16476 AngleThresholds.
Proof.
  intros sign cut stays limit on.
  apply PlacedCertified; [| intros tid; apply RuledModerate, on | tauto].
  intros tid t I. apply (RuledBoundsInDegrees sign cut stays limit tid t on).
  unfold WarpOrClamp. rewrite PlacedByName. exact I.
Qed.

(** ** One sweep that keeps the shape *)

Lemma SweptModerate sample cut vs corners : CutsOnEdges sample cut ->
  Moderate (OpenSigns sample)
    (PlaceIn (Settle AngleThresholds (OpenSigns sample) (OpenCuts sample cut)
                LevelGap vs))
    (ClampedCut AngleThresholds (OpenCuts sample cut)) corners.
Proof.
  intros on. split; [intros v d t _ W | intros p q _; apply AngleClampedOnEdge].
  pose proof (SettledMovesAtMost AngleThresholds (OpenSigns sample)
    (OpenCuts sample cut) LevelGap AngleThresholdsAtMostHalf
    (OpenCutsOnEdges sample cut on) LevelGapSmall vs v d t W).
  pose proof (AngleThresholdsAtMostHalf (DirectionKind d)). lia.
Qed.

Lemma SweptCertified sample cut turns : CutsOnEdges sample cut ->
  let mesh := SweptMesh (OpenSigns sample) (OpenCuts sample cut) turns in
  Certified mesh 1077 16476 AngleThresholds.
Proof.
  intros on. apply PlacedCertified; [| intros tid; apply SweptModerate, on | tauto].
  intros tid t I.
  apply (SettledBoundsInDegrees sample cut turns (tid :: nil)%list t on).
  unfold SettledMesh. cbn [flat_map]. rewrite app_nil_r.
  unfold SettledTets. rewrite PlacedByName. exact I.
Qed.

(** ** The product's methods *)

Theorem CertifiedMesh :
  forall (method : Method) (sign : SignField) (domain : PositionSigns),
    let mesh := MeshOf method sign domain in
    Certified mesh (LeastAngle method) (GreatestAngle method)
      (MethodThresholds method).
Proof.
  intros [| | | turns | turns] sign domain.
  - apply StuffedCertified; [apply AngleThresholdsAtMostHalf | apply BisectedOnEdges
      | apply BisectedBoundsInDegrees | tauto].
  - apply StuffedCertified; [apply EmbeddingThresholdsAtMostHalf | apply BisectedOnEdges
      | apply BisectedBoundsEmbeddingInDegrees | tauto].
  - apply StuffedCertified; [apply NoWarpThresholdsAtMostHalf | apply MidpointOnEdges
      | | tauto].
    intros tid t I. cbn [LeastAngle GreatestAngle].
    replace (IZR 3000 / 100)%R with 30%R by lra.
    replace (IZR 13500 / 100)%R with 135%R by lra.
    exact (MidpointBoundsInDegrees sign tid t I).
  - apply SweptCertified, BisectedOnEdges.
  - exact (CertifiedKeySweptMesh sign domain turns).
Qed.
