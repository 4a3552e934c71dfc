(** * The angle bounds of diagonals by key: proof over the integers *)

From Certet Require Import Key.Definitions.
From Certet Require Import Angles.Forms.CheckerProof Angles.Cases.Configurations
  Angles.Cases.SymmetryProof Angles.Cases.ReductionProof
  Angles.Cases.AdmissibleProof Angles.AngleTheorems Angles.LatticeProof Embedding.WarpOrClampProof
  Key.KeyConfigurations Key.KeyReductionProof Key.Jobs.KeyFewSurface
  Key.Jobs.KeyManySurface.
Open Scope Z_scope.

Theorem KeyDihedralBounds : KeyGuarantees KeyThresholds KeyAngles.
Proof.
  intros [anchor case] before warping cut A t I.
  destruct (AdmissibleFits _ _ _ _ _ A) as [M C].
  assert (B : Sensible KeyAngles) by (cbn; lia).
  assert (L : forall k, 0 <= MoveLimit (RangesOf KeyThresholds) k) by (intros []; cbn; lia).
  set (n := SurfaceCorners (QuadOf (fun l =>
    PlacedSign before warping (Corner (Of (CornersOf (STId anchor case)) l))))).
  destruct (n <? 2) eqn:E.
  - exact (PlacementWithin before warping cut _ _ B L anchor case M C _ KeyFewSurface E t I).
  - assert (E' : 2 <=? n = true) by (rewrite Z.leb_antisym, E; reflexivity).
    exact (PlacementWithin before warping cut _ _ B L anchor case M C _ KeyManySurface E' t I).
Qed.

Theorem KeyPositiveVolume tid before warping cut t :
  Admissible before warping cut KeyThresholds (Corners tid) ->
  In t (KeyTets before warping cut tid) -> Positive t.
Proof.
  intros A I. exact (WellShapedPositive _ _ (KeyDihedralBounds tid _ _ _ A t I)).
Qed.

Lemma KeyThresholdsAtMostHalf : AtMostHalf KeyThresholds.
Proof. intros []; vm_compute; discriminate. Qed.

(** ** After the paper's warp *)

Lemma KeyStuffedArePlaced th sign cut tid :
  KeyStuffedTets th sign cut tid = KeyTets sign (WarpVertex th sign cut) cut tid.
Proof. reflexivity. Qed.

Theorem KeyBounds sign cut tid t : CutsOnEdges sign cut ->
  In t (KeyStuffedTets KeyThresholds sign cut tid) -> WellShaped KeyAngles t.
Proof.
  intros C. rewrite KeyStuffedArePlaced. apply KeyDihedralBounds.
  exact (WarpIsAdmissible KeyThresholds sign cut tid KeyThresholdsAtMostHalf C).
Qed.

(** ** With a rule of who stays *)

Theorem KeyRuledBounds sign cut stays limit tid t : CutsOnEdges sign cut ->
  In t (KeyWarpOrClamp KeyThresholds sign cut stays limit tid) ->
  WellShaped KeyAngles t.
Proof.
  intros C. apply KeyDihedralBounds.
  apply AnySubsetStays; [exact KeyThresholdsAtMostHalf|exact C].
Qed.

(** ** The lattice itself *)

Theorem KeyLatticePositive sign cut tid : CutsOnEdges sign cut ->
  Positive (WarpedTet KeyThresholds sign cut tid).
Proof. apply LatticePositive. intros []; cbn; lia. Qed.
