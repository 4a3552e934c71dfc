(** * The angle bounds: theorems over the integers

    Closed under the global context. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Forms.CheckerProof Angles.Cases.Configurations
  Angles.Cases.SymmetryProof Angles.Cases.ReductionProof
  Angles.Cases.AdmissibleProof Angles.Jobs.AnglesFewSurface
  Angles.Jobs.AnglesManySurface Angles.Jobs.EmbeddingFewSurface
  Angles.Jobs.EmbeddingManySurface Angles.Jobs.MidpointFixed.
Open Scope Z_scope.

(** The product's stencils. *)
Local Notation SymbolTets := (Configurations.SymbolTets GetUnstructuredTets).
Local Notation AllConfigurations := (Configurations.AllConfigurations GetUnstructuredTets).
Local Notation CheckRepresentatives :=
  (Configurations.CheckRepresentatives GetUnstructuredTets).

(** ** The enumeration has the size that is known *)

Definition CountConfigurations : Z :=
  fold_left (fun n _ => n + 1) AllConfigurations 0.
Definition CountAngles : Z :=
  fold_left (fun n c => n + Z.of_nat (length
    (flat_map DihedralEdges (SymbolTets (fst c))))) AllConfigurations 0.

Theorem ConfigurationsCounted :
  CountConfigurations = 14717 /\ CountAngles = 89430.
Proof. vm_compute. split; reflexivity. Qed.

(** ** Admissible placements *)

Lemma AdmissibleFits th before warping cut corners :
  Admissible before warping cut th corners ->
  FittingMoves before warping (RangesOf th) corners /\
  FittingCuts before warping cut (RangesOf th) corners.
Proof.
  assert (E : forall k, ThresholdSteps th k = 256 * Alpha th k).
  { intros k. change (Steps / 256) with 256. destruct th as [long short].
    unfold ThresholdSteps, Alpha. change (Steps / 256) with 256.
    destruct k; ring. }
  intros [M C]. split.
  - intros v d t I W. destruct (M v d t I W) as [B H]. rewrite E in B.
    split; assumption.
  - intros v d I J P N. pose proof (C v d I J P N) as B.
    rewrite E in B. change Steps with 65536 in B.
    cbn [RangesOf Configurations.CutFrom CutTo]. lia.
Qed.

Lemma GuaranteeByJobs th bounds :
  Sensible bounds -> (forall k, 0 <= Alpha th k) ->
  CheckRepresentatives bounds (RangesOf th) (fun n => n <? 3) = true ->
  CheckRepresentatives bounds (RangesOf th) (fun n => 3 <=? n) = true ->
  Guarantees th bounds.
Proof.
  intros B L Few Many tid before warping cut A.
  destruct (AdmissibleFits _ _ _ _ _ A) as [M C].
  set (n := SurfaceCorners (QuadOf (fun l =>
    PlacedSign before warping (Corner (Of (CornersOf tid) l))))).
  destruct (n <? 3) eqn:E.
  - exact (AllPlacementsWithin bounds (RangesOf th) B L _ Few tid _ _ _ M C E).
  - assert (E' : 3 <=? n = true) by (rewrite Z.leb_antisym, E; reflexivity).
    exact (AllPlacementsWithin bounds (RangesOf th) B L _ Many tid _ _ _ M C E').
Qed.

Theorem DihedralBounds : Guarantees AngleThresholds WidestAngles.
Proof.
  apply GuaranteeByJobs.
  - cbn. lia.
  - intros []; cbn; lia.
  - exact AnglesFewSurface.
  - exact AnglesManySurface.
Qed.

Theorem DihedralBoundsEmbedding : Guarantees EmbeddingThresholds EmbeddingAngles.
Proof.
  apply GuaranteeByJobs.
  - cbn. lia.
  - intros []; cbn; lia.
  - exact EmbeddingFewSurface.
  - exact EmbeddingManySurface.
Qed.

Lemma WellShapedPositive bounds t : WellShaped bounds t -> Positive t.
Proof. destruct bounds, t. intros [V _]. exact V. Qed.

(** Right-handed as the product orients them, at both pairs of thresholds. *)
Theorem PositiveVolume th tid before warping cut t :
  th = AngleThresholds \/ th = EmbeddingThresholds ->
  Admissible before warping cut th (Corners tid) ->
  In t (PlacedTets before warping cut tid) -> Positive t.
Proof.
  intros [-> | ->] A I.
  - exact (WellShapedPositive _ _ (DihedralBounds tid _ _ _ A t I)).
  - exact (WellShapedPositive _ _ (DihedralBoundsEmbedding tid _ _ _ A t I)).
Qed.

Theorem WarpIsAdmissible th sign cut tid :
  AtMostHalf th -> CutsOnEdges sign cut ->
  Admissible sign (WarpVertex th sign cut) cut th (Corners tid).
Proof. intros H C. apply WarpLeavesAdmissible; assumption. Qed.

(** ** The product's tetrahedra *)

Lemma AngleThresholdsAtMostHalf : AtMostHalf AngleThresholds.
Proof. intros []; vm_compute; discriminate. Qed.

Lemma EmbeddingThresholdsAtMostHalf : AtMostHalf EmbeddingThresholds.
Proof. intros []; vm_compute; discriminate. Qed.

Lemma GuaranteeStuffed th bounds :
  AtMostHalf th -> Guarantees th bounds ->
  forall sign cut tid t, CutsOnEdges sign cut ->
    In t (StuffedTets th sign cut tid) -> WellShaped bounds t.
Proof.
  intros H G sign cut tid t C I. rewrite StuffedArePlaced in I.
  exact (G tid _ _ _ (WarpIsAdmissible th sign cut tid H C) t I).
Qed.

Theorem StuffedWidest sign cut tid t : CutsOnEdges sign cut ->
  In t (StuffedTets AngleThresholds sign cut tid) -> WellShaped WidestAngles t.
Proof.
  apply GuaranteeStuffed;
    [exact AngleThresholdsAtMostHalf | exact DihedralBounds].
Qed.

Theorem StuffedEmbedding sign cut tid t : CutsOnEdges sign cut ->
  In t (StuffedTets EmbeddingThresholds sign cut tid) ->
  WellShaped EmbeddingAngles t.
Proof.
  apply GuaranteeStuffed;
    [exact EmbeddingThresholdsAtMostHalf | exact DihedralBoundsEmbedding].
Qed.

(** ** Midpoint cuts, no warping *)

Lemma NeverWarped sign cut v : CutsOnEdges sign cut ->
  WarpVertex NoWarpThresholds sign cut v = Stays.
Proof.
  intros C. destruct (WarpVertex NoWarpThresholds sign cut v) as [|d t] eqn:E;
    [reflexivity|exfalso].
  destruct (WarpedMeans _ _ _ _ _ _ E) as (-> & O & L).
  pose proof (CutFromInRange _ _ C _ _ O) as R.
  change (ThresholdSteps NoWarpThresholds (DirectionKind d))
    with (match DirectionKind d with Long => 0 | Short => 0 end) in L.
  destruct (DirectionKind d); lia.
Qed.

Theorem StuffedMidpoint sign tid t : (forall v, sign v <> OnSurface) ->
  In t (StuffedTets NoWarpThresholds sign (fun _ _ => MidpointCut) tid) ->
  WellShaped MidpointAngles t.
Proof.
  intros N.
  assert (C : CutsOnEdges sign (fun _ _ => MidpointCut))
    by (intros a b _ _; vm_compute; split; discriminate).
  intros I. rewrite StuffedArePlaced in I. revert t I.
  apply (AllPlacementsWithin MidpointAngles MidpointRanges) with (take := fun n => n =? 0).
  - cbn. lia.
  - intros k. cbn. lia.
  - exact MidpointFixed.
  - intros v d t _ E. rewrite NeverWarped in E by exact C. discriminate E.
  - intros v d _ _ _ _. vm_compute. split; discriminate.
  - unfold QuadOf. cbn [PlacedSign Of].
    rewrite !NeverWarped by exact C. cbn [WarpedSign].
    pose proof (N (Of (CornersOf tid) V1)). pose proof (N (Of (CornersOf tid) V2)).
    pose proof (N (Of (CornersOf tid) V3)). pose proof (N (Of (CornersOf tid) V4)).
    destruct (sign (Of (CornersOf tid) V1)), (sign (Of (CornersOf tid) V2)),
      (sign (Of (CornersOf tid) V3)), (sign (Of (CornersOf tid) V4));
      reflexivity || congruence.
Qed.

Lemma InOrOutDecides s : InOrOut s <> OnSurface.
Proof. destruct s; discriminate. Qed.

Theorem MidpointBounds sign tid t :
  let decided v := InOrOut (sign v) in
  In t (StuffedTets NoWarpThresholds decided (fun _ _ => MidpointCut) tid) ->
  WellShaped MidpointAngles t.
Proof. apply StuffedMidpoint. intros v. apply InOrOutDecides. Qed.
