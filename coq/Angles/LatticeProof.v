(** * The warped lattice keeps its volume: proof

    Six volumes are affine in each corner, so that it is enough to look at the
    ends of the corners' ranges; none is negative there, the unwarped
    tetrahedron's is positive, and no corner reaches the far end. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Forms.BoxFormProof Angles.Forms.EdgeProof
  Angles.Forms.CheckerProof Angles.Cases.SymmetryProof
  Angles.Cases.Configurations Angles.Cases.Isometry Angles.Cases.ReductionProof
  Angles.Cases.AdmissibleProof Angles.Jobs.LatticeKeepsVolume.
Open Scope Z_scope.

(** [x] lies between its start and a place, and is not at the place. *)
Definition Among (th : Thresholds) (l : Label) (x : Coord3) : Prop :=
  exists w u p, 0 < w /\ 0 <= u /\ In p (Places th l) /\
    Scale (w + u) x
    = Translate (Scale w (Scale 256 (Scale 256 (Of Canonical l))))
        (Scale u (Scale 256 p)).

Section Among.
  Variables (th : Thresholds) (l : Label) (x : Coord3) (g : Coord3 -> Z).
  Hypothesis Hx : Among th l x.
  Hypothesis Hg : Affine g.
  Hypothesis Places_ok : forall p, In p (Places th l) -> 0 <= g (Scale 256 p).

  Lemma StartIsPlace : In (Scale 256 (Of Canonical l)) (Places th l).
  Proof. left. reflexivity. Qed.

  Lemma AmongNonNegative : 0 <= g x.
  Proof.
    destruct Hx as (w & u & p & Pw & Pu & I & E).
    pose proof (Hg _ _ _ _ _ E) as A.
    pose proof (Places_ok _ StartIsPlace) as G1. pose proof (Places_ok p I) as G2.
    apply (ScaleLe w) in G1; [|lia]. apply (ScaleLe u) in G2; [|assumption].
    apply (Cancel (w + u)); lia.
  Qed.

  Lemma AmongPositive :
    0 < g (Scale 256 (Scale 256 (Of Canonical l))) -> 0 < g x.
  Proof.
    intros G. destruct Hx as (w & u & p & Pw & Pu & I & E).
    pose proof (Hg _ _ _ _ _ E) as A. pose proof (Places_ok p I) as G2.
    apply (ScaleLe u) in G2; [|assumption].
    assert (0 < w * g (Scale 256 (Scale 256 (Of Canonical l))))
      by (apply Z.mul_pos_pos; assumption).
    apply (Z.mul_pos_cancel_l (w + u)); lia.
  Qed.
End Among.

Section Volume.
  Variable th : Thresholds.
  Hypothesis Never : NeverTurnedOver th = true.

  Lemma PlacesNonNegative a b c d :
    In a (Places th V1) -> In b (Places th V2) -> In c (Places th V3) ->
    In d (Places th V4) ->
    0 <= SixVolume (Scale 256 a) (Scale 256 b) (Scale 256 c) (Scale 256 d).
  Proof.
    intros Ia Ib Ic Id. rewrite (proj1 (ScaledQuantities 256 a b c d)).
    apply Z.mul_nonneg_nonneg; [lia|].
    unfold NeverTurnedOver in Never.
    rewrite forallb_forall in Never. specialize (Never a Ia).
    rewrite forallb_forall in Never. specialize (Never b Ib).
    rewrite forallb_forall in Never. specialize (Never c Ic). cbv zeta in Never.
    rewrite forallb_forall in Never. specialize (Never d Id).
    apply Z.leb_le in Never. exact Never.
  Qed.

  Ltac affine :=
    repeat match goal with v : Coord3 |- _ => destruct v end;
    match goal with |- Affine ?g => by_coefficients g end;
    intros; unfold SixVolume, Normal; cbn [Difference Dot Cross]; ring.

  Lemma Affine1 b c d : Affine (fun a => SixVolume a b c d).
  Proof. affine. Qed.
  Lemma Affine2 a c d : Affine (fun b => SixVolume a b c d).
  Proof. affine. Qed.
  Lemma Affine3 a b d : Affine (fun c => SixVolume a b c d).
  Proof. affine. Qed.
  Lemma Affine4 a b c : Affine (fun d => SixVolume a b c d).
  Proof. affine. Qed.

  Lemma AmongVolume a b c d :
    Among th V1 a -> Among th V2 b -> Among th V3 c -> Among th V4 d ->
    0 < SixVolume a b c d.
  Proof.
    intros Ha Hb Hc Hd.
    set (at_ l := Scale 256 (Scale 256 (Of Canonical l))).
    assert (S1 : forall q r s, In q (Places th V2) -> In r (Places th V3) ->
      In s (Places th V4) ->
      0 <= SixVolume a (Scale 256 q) (Scale 256 r) (Scale 256 s)).
    { intros q r s Iq Ir Is. refine (AmongNonNegative th V1 a _ Ha (Affine1 _ _ _) _).
      intros p Ip. apply PlacesNonNegative; assumption. }
    assert (S2 : forall r s, In r (Places th V3) -> In s (Places th V4) ->
      0 <= SixVolume a b (Scale 256 r) (Scale 256 s)).
    { intros r s Ir Is. refine (AmongNonNegative th V2 b _ Hb (Affine2 _ _ _) _).
      intros q Iq. apply S1; assumption. }
    assert (S3 : forall s, In s (Places th V4) ->
      0 <= SixVolume a b c (Scale 256 s)).
    { intros s Is. refine (AmongNonNegative th V3 c _ Hc (Affine3 _ _ _) _).
      intros r Ir. apply S2; assumption. }
    assert (P1 : 0 < SixVolume a (at_ V2) (at_ V3) (at_ V4)).
    { refine (AmongPositive th V1 a _ Ha (Affine1 _ _ _) _ _).
      - intros p Ip. apply PlacesNonNegative; try assumption; left; reflexivity.
      - vm_compute. reflexivity. }
    assert (P2 : 0 < SixVolume a b (at_ V3) (at_ V4)).
    { refine (AmongPositive th V2 b _ Hb (Affine2 _ _ _) _ P1).
      intros q Iq. apply S1; try assumption; left; reflexivity. }
    assert (P3 : 0 < SixVolume a b c (at_ V4)).
    { refine (AmongPositive th V3 c _ Hc (Affine3 _ _ _) _ P2).
      intros r Ir. apply S2; try assumption; left; reflexivity. }
    exact (AmongPositive th V4 d _ Hd (Affine4 _ _ _) S3 P3).
  Qed.
End Volume.

Lemma ThresholdIsAlpha th k : ThresholdSteps th k = 256 * Alpha th k.
Proof.
  destruct th as [long short], k; unfold ThresholdSteps, Alpha;
    change (Steps / 256) with 256; ring.
Qed.

Section Lattice.
  (** The places are those of thresholds that are as wide at least. *)
  Variables (wide th : Thresholds) (sign : SignField) (cut : CutField).
  Hypothesis Hwide : forall k, Alpha th k <= Alpha wide k.
  Hypothesis Hcut : CutsOnEdges sign cut.
  Variables (anchor : Coord3) (case : StructuredTetCase) (m : Linear).
  Hypothesis Hm : In m AllIsometries.
  Let w := TurnQuad Turn1234 (CornersOf (STId anchor case)).
  Hypothesis Hw : forall l, Apply m (Difference (Of w V1) (Of w l))
    = Difference (Of Canonical V1) (Of Canonical l).

  Lemma WarpedAmong l :
    Among wide l (Move m (Shift anchor case Turn1234 m)
                  (MeshPosition th sign cut (Corner (Of w l)))).
  Proof.
    cbn [MeshPosition].
    destruct (WarpVertex th sign cut (Of w l)) as [|d t] eqn:E;
      cbn [WarpedPosition].
    - exists 1, 0, (Scale 256 (Of Canonical l)).
      split; [lia|]. split; [lia|]. split; [left; reflexivity|].
      replace (Scale Steps (Of w l))
        with (Translate (Scale Steps (Of w l)) (Scale 0 (C3 0 0 0)))
        by (destruct (Of w l); cbn [Scale Translate]; f_equal; ring).
      unfold w. rewrite (MoveLattice anchor case Turn1234 m Hw), ApplyScale.
      change Steps with 65536.
      destruct (Of Canonical l), (Apply m (C3 0 0 0)).
      cbn [Scale Translate]. f_equal; ring.
    - destruct (WarpedMeans th sign cut _ _ _ E) as (Et & O & L).
      pose proof (CutFromInRange sign cut Hcut _ _ O) as R. rewrite <- Et in R.
      destruct (ImageOfDirection m d Hm) as (e & Ee & Ke).
      rewrite ThresholdIsAlpha, Ke in L.
      specialize (Hwide (DirectionKind e)).
      exists (256 * Alpha wide (DirectionKind e) - t), t,
        (Along (Of Canonical l) (Offset e) (Alpha wide (DirectionKind e))).
      split; [lia|]. split; [lia|].
      split.
      { right. apply (in_map (fun d => Along (Of Canonical l) (Offset d)
          (Alpha wide (DirectionKind d)))). apply InAllDirections. }
      unfold w. rewrite (MoveLattice anchor case Turn1234 m Hw), ApplyScale, Ee.
      change Steps with 65536. unfold Along.
      destruct (Of Canonical l), (Offset e).
      cbn [Scale Translate]. f_equal; ring.
  Qed.
End Lattice.

Lemma LatticePositive th sign cut tid :
  (forall k, Alpha th k <= Alpha EmbeddingThresholds k) -> CutsOnEdges sign cut ->
  Positive (WarpedTet th sign cut tid).
Proof.
  intros L C. destruct tid as [anchor case].
  destruct (IsometryOf anchor case Turn1234) as (m & Hm & D & Hw).
  pose proof (WarpedAmong EmbeddingThresholds th sign cut L C anchor case m Hm Hw) as A.
  pose proof (AmongVolume _ LatticeKeepsVolume _ _ _ _ (A V1) (A V2) (A V3) (A V4))
    as V.
  rewrite MoveVolume, D in V. clear A Hw D Hm.
  set (f := MeshPosition th sign cut) in *.
  assert (E : WarpedTet th sign cut (STId anchor case)
    = MapTet f (Orient (CaseHandedness case)
        (UT _ (Corner (Of (CornersOf (STId anchor case)) V1))
              (Corner (Of (CornersOf (STId anchor case)) V2))
              (Corner (Of (CornersOf (STId anchor case)) V3))
              (Corner (Of (CornersOf (STId anchor case)) V4))))).
  { unfold WarpedTet, CornersOf.
    destruct (GetStructuredTet (STId anchor case)). reflexivity. }
  rewrite E. clear E. rewrite !OfTurned in V. cbn [TurnLabel] in V.
  destruct (CaseHandedness case); cbn [HandDeterminant Orient MapTet Positive] in *.
  - rewrite Z.mul_1_l in V. exact V.
  - match type of V with 0 < -1 * SixVolume ?a ?b ?c ?d =>
      replace (SixVolume a b d c) with (-1 * SixVolume a b c d); [exact V|];
      destruct a, b, c, d end.
    unfold SixVolume, Normal. cbn [Difference Dot Cross]. ring.
Qed.

Theorem WarpedLatticePositive sign cut tid : CutsOnEdges sign cut ->
  Positive (WarpedTet EmbeddingThresholds sign cut tid).
Proof. apply LatticePositive. intros k. apply Z.le_refl. Qed.
