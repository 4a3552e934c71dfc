(** * The angle bounds hold for any number of materials

    Of one material against the rest they were proved already; what is new are
    eight configurations, of three corners that move around towards each other,
    and the fill. *)

From Certet Require Import Material.Definitions.
From Certet Require Import Lattice.DirectionProof Angles.Forms.CheckerProof
  Angles.Cases.Configurations Angles.Cases.SymmetryProof
  Angles.Cases.ReductionProof Angles.Cases.AdmissibleProof Angles.LatticeProof
  Angles.Jobs.AnglesFewSurface Angles.Jobs.AnglesManySurface
  Angles.Jobs.EmbeddingFewSurface Angles.Jobs.EmbeddingManySurface
  Angles.Jobs.MidpointFixed Material.MaterialConfigurations
  Material.MaterialReductionProof Material.MaterialWithinProof.
Open Scope Z_scope.

Local Notation CheckSigns := (Configurations.CheckSigns GetUnstructuredTets).
Local Notation CheckRepresentatives :=
  (Configurations.CheckRepresentatives GetUnstructuredTets).

(** The proofs need the names of these lists, never what is in them. *)
Local Strategy 1000 [Representatives ThirdMoves FillMoves].

(** ** What the checker finds *)

Lemma AnglesThirdMoves : CheckThirdMoves WidestAngles (RangesOf AngleThresholds) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma AnglesFill : CheckFill WidestAngles (RangesOf AngleThresholds) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma EmbeddingThirdMoves :
  CheckThirdMoves EmbeddingAngles (RangesOf EmbeddingThresholds) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma EmbeddingFill : CheckFill EmbeddingAngles (RangesOf EmbeddingThresholds) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma MidpointFill : CheckFill MidpointAngles MidpointRanges = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem MaterialConfigurationsCounted :
  CountThirdMoves = 8 /\ CountFill = 63 /\ CountFillAngles = 432.
Proof. vm_compute. repeat split. Qed.

(** ** Admissible placements *)

Lemma SomeWayBack v d : exists e,
  Translate (Translate v (Offset d)) (Offset e) = v /\
  DirectionKind e = DirectionKind d.
Proof.
  exists (Backward d). pose proof (ThereAndBack v d) as B.
  split; [exact B|]. exact (OppositeDirection v d _ B).
Qed.

Section Admissible.
  Variables (th : Thresholds) (before : MaterialField).
  Variables (warping : Coord3 -> Warping) (cut : CutField) (corners : list Coord3).
  Hypothesis Placed : AdmissibleMaterials before warping cut th corners.

  Lemma AdmissibleWithin : MovesWithin warping (RangesOf th) corners.
  Proof.
    intros v d t I E. destruct Placed as [M _]. destruct (M v d t I E) as [B _].
    rewrite ThresholdIsAlpha in B. exact B.
  Qed.

  Lemma AdmissibleNeverMutual v d t e s :
    In v corners -> In (Translate v (Offset d)) corners ->
    warping v = Moves d t -> warping (Translate v (Offset d)) = Moves e s ->
    Translate (Translate v (Offset d)) (Offset e) <> v.
  Proof.
    intros I J E F. destruct Placed as [M _]. destruct (M v d t I E) as [_ N].
    exact (N J e s F).
  Qed.

  Lemma AdmissibleEitherCut v d m n :
    In v corners -> In (Translate v (Offset d)) corners ->
    PlacedMaterial before warping v = Some m ->
    PlacedMaterial before warping (Translate v (Offset d)) = Some n -> m <> n ->
    256 * CutFrom (RangesOf th) (DirectionKind d)
      <= EitherCut before warping cut v (Translate v (Offset d))
      <= 256 * CutTo (RangesOf th) (DirectionKind d).
  Proof.
    intros I J E F D. destruct Placed as [_ C].
    cbn [RangesOf Configurations.CutFrom CutTo].
    assert (S : Steps = 65536) by reflexivity.
    unfold EitherCut. rewrite E, F. destruct (Z.ltb_spec m n) as [L|L].
    - destruct (SomeWayBack v d) as (e & B & K).
      pose proof (C (Translate v (Offset d)) e n m J) as H. rewrite B in H.
      specialize (H I F E L). rewrite ThresholdIsAlpha, K in H. lia.
    - pose proof (C v d m n I J E F ltac:(lia)) as H.
      rewrite ThresholdIsAlpha in H. lia.
  Qed.
End Admissible.

Lemma BothJobs bounds r signs :
  CheckRepresentatives bounds r (fun n => n <? 3) = true ->
  CheckRepresentatives bounds r (fun n => 3 <=? n) = true ->
  In signs Representatives -> CheckSigns bounds r signs = true.
Proof.
  intros Few Many R. destruct (SurfaceCorners signs <? 3) eqn:E.
  - unfold Configurations.CheckRepresentatives in Few. rewrite forallb_forall in Few.
    apply Few, filter_In. split; assumption.
  - unfold Configurations.CheckRepresentatives in Many. rewrite forallb_forall in Many.
    apply Many, filter_In. split; [exact R|]. rewrite Z.leb_antisym, E. reflexivity.
Qed.

Lemma ThirdMovesChecked bounds r signs moves : CheckThirdMoves bounds r = true ->
  In signs Representatives -> In moves (ThirdMoves signs) ->
  CheckMoves bounds r signs moves = true.
Proof.
  intros Third R I. unfold CheckThirdMoves in Third.
  rewrite forallb_forall in Third. specialize (Third signs R). unfold CheckMoves.
  destruct (SymbolTets GetUnstructuredTets signs) as [|u us]; [reflexivity|].
  rewrite forallb_forall in Third. exact (Third moves I).
Qed.

Lemma GuaranteeByMaterialJobs th bounds :
  Sensible bounds -> (forall k, 0 <= Alpha th k) ->
  CheckRepresentatives bounds (RangesOf th) (fun n => n <? 3) = true ->
  CheckRepresentatives bounds (RangesOf th) (fun n => 3 <=? n) = true ->
  CheckThirdMoves bounds (RangesOf th) = true ->
  CheckFill bounds (RangesOf th) = true ->
  GuaranteesMaterials th bounds.
Proof.
  intros B L Few Many Third Fill before warping cut shared [anchor case] A Whole m t.
  exact (MaterialTetWithin bounds (RangesOf th) B L (fun _ => true)
    (fun _ _ => eq_refl)
    (fun signs R _ => BothJobs bounds (RangesOf th) signs Few Many R)
    (fun signs moves R _ I => ThirdMovesChecked bounds (RangesOf th) signs moves Third R I)
    Fill before warping cut shared anchor case
    (AdmissibleWithin th before warping cut _ A)
    (AdmissibleNeverMutual th before warping cut _ A)
    (AdmissibleEitherCut th before warping cut _ A)
    (fun _ => eq_refl) Whole m t).
Qed.

Theorem MaterialDihedralBounds : GuaranteesMaterials AngleThresholds WidestAngles.
Proof.
  apply GuaranteeByMaterialJobs.
  - cbn. lia.
  - intros []; cbn; lia.
  - exact AnglesFewSurface.
  - exact AnglesManySurface.
  - exact AnglesThirdMoves.
  - exact AnglesFill.
Qed.

Theorem MaterialDihedralBoundsEmbedding :
  GuaranteesMaterials EmbeddingThresholds EmbeddingAngles.
Proof.
  apply GuaranteeByMaterialJobs.
  - cbn. lia.
  - intros []; cbn; lia.
  - exact EmbeddingFewSurface.
  - exact EmbeddingManySurface.
  - exact EmbeddingThirdMoves.
  - exact EmbeddingFill.
Qed.

(** ** Cuts in the middle *)

(** Without a corner on an interface nothing moves. *)
Lemma NoThirdMoves : forallb (fun signs =>
  if SurfaceCorners signs =? 0
  then match ThirdMoves signs with [] => true | _ => false end else true)
  Representatives = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem MaterialMidpointBounds : forall (material : Coord3 -> Material) shared tid m t,
  In (m, t) (PlacedMaterialTets (fun v => Some (material v)) (fun _ => Stays)
               MidpointCuts shared tid) ->
  WellShaped MidpointAngles t.
Proof.
  intros material shared [anchor case] m t.
  assert (Turned : forall g signs,
    (SurfaceCorners (TurnQuad g signs) =? 0) = (SurfaceCorners signs =? 0))
    by (intros g signs; now rewrite SurfaceCornersTurned).
  apply (MaterialTetWithin MidpointAngles MidpointRanges)
    with (take := fun signs => SurfaceCorners signs =? 0).
  - cbn. lia.
  - intros k. cbn. lia.
  - exact Turned.
  - intros signs R E. pose proof MidpointFixed as F.
    unfold Configurations.CheckRepresentatives in F. rewrite forallb_forall in F.
    apply F, filter_In. split; assumption.
  - intros signs moves R E I. pose proof NoThirdMoves as N.
    rewrite forallb_forall in N. specialize (N signs R). rewrite E in N.
    destruct (ThirdMoves signs); [destruct I|discriminate N].
  - exact MidpointFill.
  - intros v d s _ E. discriminate E.
  - intros v d s e s' _ _ E. discriminate E.
  - intros v d a b _ _ E F D. unfold EitherCut. cbn [PlacedMaterial] in *.
    injection E as ->. injection F as ->.
    cbn [MidpointRanges Configurations.CutFrom CutTo].
    assert (S : Steps = 65536) by reflexivity.
    assert (M : forall a b, MidpointCuts a b = 32768) by reflexivity.
    rewrite !M, S. destruct (a <? b); lia.
  - intros k. unfold QuadOf.
    assert (N : forall c, PlacedSign (BeforeAmong (fun v => Some (material v)) k)
      (fun _ => Stays) (Corner c) <> OnSurface).
    { intros c. cbn. unfold BeforeAmong, SignAmongMaterials. destruct (_ =? _); discriminate. }
    set (s := PlacedSign _ _) in *.
    pose proof (N (Of (CornersOf (STId anchor case)) V1)).
    pose proof (N (Of (CornersOf (STId anchor case)) V2)).
    pose proof (N (Of (CornersOf (STId anchor case)) V3)).
    pose proof (N (Of (CornersOf (STId anchor case)) V4)).
    destruct (s (Corner (Of (CornersOf (STId anchor case)) V1))),
      (s (Corner (Of (CornersOf (STId anchor case)) V2))),
      (s (Corner (Of (CornersOf (STId anchor case)) V3))),
      (s (Corner (Of (CornersOf (STId anchor case)) V4))); reflexivity || congruence.
  - intros Alone. exfalso.
    assert (I : exists c, In c (Corners (STId anchor case))).
    { unfold Corners. destruct (GetStructuredTet _) as [c ? ? ?]. exists c.
      left. reflexivity. }
    destruct I as [c I]. specialize (Alone c I). discriminate Alone.
Qed.
