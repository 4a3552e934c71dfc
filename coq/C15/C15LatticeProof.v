(** * The warped lattice C15 keeps its volume: proof

    Six volumes are affine in each corner, so that it is enough to look at the ends of
    the corners' ranges: all are positive there. *)

From Certet Require Import Key.Definitions.
From Certet Require Import Angles.Forms.Checker Angles.Forms.BoxFormProof
  Angles.Forms.EdgeProof Angles.Forms.CheckerProof Angles.Cases.Configurations
  Angles.Cases.Isometry Angles.Cases.ReductionProof Angles.Cases.SymmetryProof
  Angles.LatticeProof.
From Certet Require Import C15.Sites C15.C15Tet C15.C15TilingProof C15.C15Stuffing
  C15.C15AnglesSpec C15.C15WarpSpec C15.C15Configurations C15.C15FramesProof C15.C15ReductionProof
  C15.C15WarpProof C15.Jobs.C15LatticeKeepsVolume.
Open Scope Z_scope.

(** [x] lies between the first of two points and the second, both of a list. *)
Definition Between (places : list Coord3) (x : Coord3) : Prop :=
  exists w u a b, 0 <= w /\ 0 <= u /\ 0 < w + u /\ In a places /\ In b places /\
    Scale (w + u) x = Translate (Scale w (Scale 256 a)) (Scale u (Scale 256 b)).

Lemma BetweenPositive places x g : Between places x -> Affine g ->
  (forall p, In p places -> 0 < g (Scale 256 p)) -> 0 < g x.
Proof.
  intros (w & u & a & b & Pw & Pu & P & A & B & E) Hg G.
  pose proof (Hg _ _ _ _ _ E) as L. pose proof (G a A) as Ga. pose proof (G b B) as Gb.
  assert (0 <= w * g (Scale 256 a)) by (apply Z.mul_nonneg_nonneg; lia).
  assert (0 <= u * g (Scale 256 b)) by (apply Z.mul_nonneg_nonneg; lia).
  apply (Z.mul_pos_cancel_l (w + u)); [exact P|]. rewrite L.
  destruct (Z.eq_dec w 0) as [->|]; [assert (0 < u * g (Scale 256 b)) by
    (apply Z.mul_pos_pos; lia)|assert (0 < w * g (Scale 256 a)) by
    (apply Z.mul_pos_pos; lia)]; lia.
Qed.

Lemma SegmentBetweenReaches case th moves l x :
  (forall o, Of moves l = Some o -> In o (OffsetsAround (Of (CaseCorners case) l))) ->
  OnSegment 256 (C15Segment case th moves [] (CornerOf l)) x ->
  Between (Reaches case th l) x.
Proof.
  intros M ([w u] & H). cbn [C15Segment] in H. unfold Reaches.
  set (p := Of (CaseCorners case) l) in *.
  set (places := Scale 256 p :: _).
  assert (start : In (Scale 256 p) places) by (left; reflexivity).
  assert (fixed : On 256 (Fixed (Scale 256 p)) (w, u) x -> Between places x).
  { cbn [On]. intros (Pw & Pu & P & E & ->).
    exists w, u, (Scale 256 p), (Scale 256 p). repeat (split; [assumption|]).
    destruct p. cbn [Scale Translate]. f_equal; ring. }
  destruct (Of moves l) as [o|]; [|exact (fixed H)].
  specialize (M o eq_refl). unfold SegmentBetween in H.
  assert (zero : Along p o 0 = Scale 256 p)
    by (unfold Along; destruct p, o; cbn [Scale Translate]; f_equal; ring).
  rewrite zero in H. destruct (Coord3Equal _ _); [exact (fixed H)|].
  cbn [On] in H. destruct H as (Pw & Pu & P & E).
  exists w, u, (Scale 256 p), (Along p o (th (MetalOf p) (MetalOf (Translate p o)))).
  repeat (split; [assumption|]). split; [|exact E]. right.
  apply (in_map (fun o => Along p o (th (MetalOf p) (MetalOf (Translate p o))))), M.
Qed.

Section Volume.
  Variables (case : C15Case) (th : C15Thresholds).
  Hypothesis Never : C15NeverTurnedOver case th = true.

  Lemma ReachesPositive a b c d :
    In a (Reaches case th V1) -> In b (Reaches case th V2) ->
    In c (Reaches case th V3) -> In d (Reaches case th V4) ->
    0 < SixVolume (Scale 256 a) (Scale 256 b) (Scale 256 c) (Scale 256 d).
  Proof.
    intros Ia Ib Ic Id. rewrite (proj1 (ScaledQuantities 256 a b c d)).
    apply Z.mul_pos_pos; [lia|].
    unfold C15NeverTurnedOver in Never. cbv zeta in Never.
    rewrite forallb_forall in Never. specialize (Never a Ia).
    rewrite forallb_forall in Never. specialize (Never b Ib).
    rewrite forallb_forall in Never. specialize (Never c Ic).
    rewrite forallb_forall in Never. specialize (Never d Id).
    apply Z.ltb_lt in Never. exact Never.
  Qed.

  Lemma BetweenVolume a b c d :
    Between (Reaches case th V1) a -> Between (Reaches case th V2) b ->
    Between (Reaches case th V3) c -> Between (Reaches case th V4) d ->
    0 < SixVolume a b c d.
  Proof.
    intros Ha Hb Hc Hd.
    refine (BetweenPositive _ a _ Ha (Affine1 _ _ _) _). intros p Ip.
    refine (BetweenPositive _ b _ Hb (Affine2 _ _ _) _). intros q Iq.
    refine (BetweenPositive _ c _ Hc (Affine3 _ _ _) _). intros r Ir.
    refine (BetweenPositive _ d _ Hd (Affine4 _ _ _) _). intros s Is.
    apply ReachesPositive; assumption.
  Qed.
End Volume.

(** In whatever order a volume is taken. *)
Lemma VolumeInOrder (x : Label -> Coord3) g : In g LabelOrders ->
  OrderDeterminant g * SixVolume (x (Of g V1)) (x (Of g V2)) (x (Of g V3)) (x (Of g V4))
  = SixVolume (x V1) (x V2) (x V3) (x V4).
Proof.
  intros G. destruct (x V1) as [a1 a2 a3] eqn:E1, (x V2) as [b1 b2 b3] eqn:E2,
    (x V3) as [c1 c2 c3] eqn:E3, (x V4) as [d1 d2 d3] eqn:E4.
  cbv [LabelOrders Product4 filter AllLabels flat_map map app AllDifferent forallb
    implb LabelEqual Of andb] in G. cbn [In] in G.
  repeat (destruct G as [<-|G]; [cbn [Of]; rewrite E1, E2, E3, E4;
    cbv [OrderDeterminant Inversions Z.even Z.add Z.ltb Z.compare Pos.compare
      Pos.compare_cont Pos.add Pos.succ];
    unfold SixVolume, Normal; cbn [Difference Cross Dot]; ring|]).
  destruct G.
Qed.

Lemma StandardCases case : In (StandardOf case) [Tet_A01; Tet_B1; Tet_C1].
Proof.
  unfold StandardOf.
  destruct (MetalOf (C15Corner case First)), (MetalOf (C15Corner case Second));
    cbn; tauto.
Qed.

Lemma ThresholdsNonNegative a b : 0 <= C15KeyThresholds a b.
Proof. destruct a, b; cbn; lia. Qed.

(** Wherever the corners have moved. *)
Theorem C15LatticePositive before warping cut tid :
  C15AdmissibleMoves before warping C15KeyThresholds (C15Corners tid) ->
  Positive (C15WarpedTet warping cut tid).
Proof.
  destruct tid as [cell case]. intros FM.
  destruct (FrameExists case) as (f & Hf).
  set (moves := MovesIn f (LatticeMoves before warping cell case)).
  assert (A : forall l, Between (Reaches (StandardOf case) C15KeyThresholds l)
    (Move (MapOf f) (FrameShift cell case f)
      (C15Position warping cut (Corner (LatticeCorner cell case (Of (OrderIn f) l)))))).
  { intros l. apply (SegmentBetweenReaches _ _ moves).
    - intros o E. unfold moves in E. rewrite OfMovesIn in E.
      destruct (OffsetCarried before warping C15KeyThresholds cell case FM (Of (OrderIn f) l))
        as (e & Ee & I & _). rewrite Ee in E.
      destruct (C15After before warping _); try discriminate E.
      injection E as <-.
      exact (proj1 (proj2 (EdgesCarried cell case f Hf l) e I)).
    - pose proof (CornerOnItsSegment before warping cut C15KeyThresholds
        ThresholdsNonNegative cell case FM f Hf [] l) as S.
      cbn [SymbolIn Stands] in S. unfold LatticeCorners in S. rewrite OfQuadOf in S.
      exact S. }
  pose proof C15LatticeKeepsVolume as T. rewrite forallb_forall in T.
  pose proof (BetweenVolume _ _ (T _ (StandardCases case)) _ _ _ _
    (A V1) (A V2) (A V3) (A V4)) as V. clear A T moves.
  rewrite MoveVolume in V.
  rewrite (FrameDeterminant _ _ f Hf) in V.
  pose proof (proj1 (FrameListed _ _ f Hf)) as G.
  cbn [C15WarpedTet Positive].
  set (x l := C15Position warping cut (Corner (LatticeCorner cell case l))) in *.
  change (0 < OrderDeterminant (OrderIn f) *
    SixVolume (x (Of (OrderIn f) V1)) (x (Of (OrderIn f) V2))
      (x (Of (OrderIn f) V3)) (x (Of (OrderIn f) V4))) in V.
  change (0 < SixVolume (x V1) (x V2) (x V3) (x V4)).
  rewrite <- (VolumeInOrder x (OrderIn f) G). exact V.
Qed.

Lemma C15KeyAtMostHalf : C15AtMostHalf C15KeyThresholds.
Proof. intros [] []; cbn; lia. Qed.

Theorem C15WarpedLatticePositive sign cut tid : CutsOnEdges sign cut ->
  Positive (C15WarpedTet (C15WarpVertex C15KeyThresholds sign cut) cut tid).
Proof.
  intros C. apply (C15LatticePositive sign).
  exact (proj1 (C15WarpIsAdmissible C15KeyThresholds sign cut C15KeyAtMostHalf C tid)).
Qed.
