(** * One edge of a sliding tetrahedron: proofs

    What the tables of [Checker.v] compute, and that [CheckRanges] and
    [CheckFull] are right about the vertices' every position. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Forms.BoxForm Angles.Forms.BoxFormProof
  Angles.Forms.Checker.
Open Scope Z_scope.

(** ** Points on segments *)

(** [x] is [scale] times the point of the segment with these weights. *)
Definition On (scale : Z) (s : Segment) (weights : Z * Z) (x : Coord3)
  : Prop :=
  let '(w, u) := weights in
  0 <= w /\ 0 <= u /\ 0 < w + u /\
  match s with
  | Fixed p => w + u = 1 /\ x = Scale scale p
  | Sliding p q =>
      Scale (w + u) x
      = Translate (Scale w (Scale scale p)) (Scale u (Scale scale q))
  end.

Definition OnSegment (scale : Z) (s : Segment) (x : Coord3) : Prop :=
  exists weights, On scale s weights x.

(** ** Affine functions *)

Definition Affine (g : Coord3 -> Z) : Prop :=
  forall w u x y z, Scale (w + u) x = Translate (Scale w y) (Scale u z) ->
    (w + u) * g x = w * g y + u * g z.

Definition Constant (g : Coord3 -> Z) : Prop := forall x y, g x = g y.

Definition Suits (used : bool) (g : Coord3 -> Z) : Prop :=
  if used then Affine g else Constant g.

Lemma AffineBy (g : Coord3 -> Z) (k kx ky kz : Z) :
  (forall x y z, g (C3 x y z) = k + kx * x + ky * y + kz * z) -> Affine g.
Proof.
  intros H w u [x1 x2 x3] [y1 y2 y3] [z1 z2 z3] E.
  cbn -[Z.mul Z.add] in E. injection E as E1 E2 E3.
  rewrite !H.
  transitivity ((w + u) * k + kx * ((w + u) * x1) + ky * ((w + u) * x2)
                + kz * ((w + u) * x3)); [ring|].
  rewrite E1, E2, E3. ring.
Qed.

(** A polynomial that is affine in its coordinates, as unfolded, is affine. *)
Ltac by_coefficients g :=
  let k := constr:(g (C3 0 0 0)) in
  refine (AffineBy g k (g (C3 1 0 0) - k) (g (C3 0 1 0) - k)
            (g (C3 0 0 1) - k) _).

(** ** Tables *)

Section Ends.
  Variables (scale w u : Z) (used : bool) (s : Segment) (x : Coord3).
  Hypothesis Hx : On scale s (w, u) x.

  Lemma FormValueEnds {T} (value : T -> Z) (f : Coord3 -> T) g (k m : Z) :
    Suits used g ->
    (forall p, value (f p) * k = m * g (Scale scale p)) ->
    FormValue value w u (Degree used s) (Ends used s f) * k
    = (w + u) ^ Z.of_nat (Degree used s) * m * g x.
  Proof.
    intros Hg H. destruct Hx as (Hw & Hu & Hs & E).
    destruct used, s as [p|p q]; cbn [Degree Ends FormValue fst snd Suits] in *.
    - destruct E as [E ->]. rewrite H. change (Z.of_nat 0) with 0.
      rewrite Z.pow_0_r. ring.
    - change (Z.of_nat 1) with 1. rewrite !Z.pow_1_r.
      pose proof (Hg _ _ _ _ _ E) as A.
      transitivity (w * (value (f p) * k) + u * (value (f q) * k)); [ring|].
      rewrite !H.
      transitivity (m * ((w + u) * g x)); [rewrite A; ring | ring].
    - rewrite H. change (Z.of_nat 0) with 0. rewrite Z.pow_0_r.
      rewrite (Hg (Scale scale p) x). ring.
    - rewrite H. change (Z.of_nat 0) with 0. rewrite Z.pow_0_r.
      rewrite (Hg (Scale scale p) x). ring.
  Qed.
End Ends.

Section Quadruple.
  Variable scale : Z.
  Variables a b c d : Segment.
  Variables xa xb xc xd : Coord3.
  Variables wa ua wb ub wc uc wd ud : Z.
  Hypothesis Ha : On scale a (wa, ua) xa.
  Hypothesis Hb : On scale b (wb, ub) xb.
  Hypothesis Hc : On scale c (wc, uc) xc.
  Hypothesis Hd : On scale d (wd, ud) xd.

  Let weights := [(wa, ua); (wb, ub); (wc, uc); (wd, ud)].

  Lemma WeightsNonNegative : NonNegative weights.
  Proof.
    destruct Ha as (? & ? & _), Hb as (? & ? & _), Hc as (? & ? & _),
      Hd as (? & ? & _).
    repeat constructor; assumption.
  Qed.

  Lemma MassPositive m : 0 < Mass (Degrees m a b c d) weights.
  Proof.
    destruct Ha as (_ & _ & ? & _), Hb as (_ & _ & ? & _),
      Hc as (_ & _ & ? & _), Hd as (_ & _ & ? & _).
    destruct m. cbn [Degrees Mass weights].
    repeat (apply Z.mul_pos_pos; [apply Z.pow_pos_nonneg; lia|]). lia.
  Qed.

  Lemma ValueTable ma mb mc md f g (k : Z) :
    (forall y z t, Suits ma (fun x => g x y z t)) ->
    (forall y z t, Suits mb (fun x => g y x z t)) ->
    (forall y z t, Suits mc (fun x => g y z x t)) ->
    (forall y z t, Suits md (fun x => g y z t x)) ->
    (forall p q r s, f p q r s * k
       = g (Scale scale p) (Scale scale q) (Scale scale r) (Scale scale s)) ->
    let m := Use ma mb mc md in
    Value (Degrees m a b c d) weights (Table m a b c d f) * k
    = Mass (Degrees m a b c d) weights * g xa xb xc xd.
  Proof.
    intros Sa Sb Sc Sd H m.
    cbn [Degrees Mass weights Value Table m].
    rewrite (FormValueEnds scale wa ua ma a xa Ha _ _
               (fun x => g x xb xc xd) k
               (Mass [Degree mb b; Degree mc c; Degree md d]
                  [(wb, ub); (wc, uc); (wd, ud)])).
    - cbn [Mass]. ring.
    - apply Sa.
    - intros p.
      rewrite (FormValueEnds scale wb ub mb b xb Hb _ _
                 (fun x => g (Scale scale p) x xc xd) k
                 (Mass [Degree mc c; Degree md d] [(wc, uc); (wd, ud)])).
      + cbn [Mass]. ring.
      + apply Sb.
      + intros q.
        rewrite (FormValueEnds scale wc uc mc c xc Hc _ _
                   (fun x => g (Scale scale p) (Scale scale q) x xd) k
                   (Mass [Degree md d] [(wd, ud)])).
        * cbn [Mass]. ring.
        * apply Sc.
        * intros r.
          rewrite (FormValueEnds scale wd ud md d xd Hd _ _
                     (fun x => g (Scale scale p) (Scale scale q)
                                 (Scale scale r) x) k 1).
          -- cbn [Mass]. ring.
          -- apply Sd.
          -- intros s. rewrite H. cbn [Value]. ring.
  Qed.

  (** ** The three quantities *)

  Ltac unfolded :=
    cbn [Suits Affine Constant X Y W SixVolume Normal Difference Dot Cross
         Scale Translate].
  Ltac prove_suits :=
    intros [?y1 ?y2 ?y3] [?z1 ?z2 ?z3] [?t1 ?t2 ?t3];
    cbn [Suits];
    match goal with
    | |- Affine ?g => by_coefficients g; intros; unfolded; ring
    | |- Constant _ => intros [? ? ?] [? ? ?]; reflexivity
    end.
  Ltac prove_homogeneous :=
    intros [? ? ?] [? ? ?] [? ? ?] [? ? ?]; unfolded; ring.

  Lemma VolumeValue :
    Value (VolumeDegrees a b c d) weights (VolumeForm a b c d) * scale ^ 3
    = Mass (VolumeDegrees a b c d) weights * SixVolume xa xb xc xd.
  Proof.
    apply ValueTable; try prove_suits; prove_homogeneous.
  Qed.

  Lemma FaceCValue (k : Coord3 -> Z) : In k [X; Y; W] ->
    Value (Degrees OfFaceC a b c d) weights
      (Table OfFaceC a b c d (fun p q r _ => k (Normal p q r))) * scale ^ 2
    = Mass (Degrees OfFaceC a b c d) weights * k (Normal xa xb xc).
  Proof.
    intros [<-|[<-|[<-|[]]]];
      apply (ValueTable true true true false _
               (fun p q r _ => _ (Normal p q r)));
      try prove_suits; prove_homogeneous.
  Qed.

  Lemma FaceDValue (k : Coord3 -> Z) : In k [X; Y; W] ->
    Value (Degrees OfFaceD a b c d) weights
      (Table OfFaceD a b c d (fun p q _ s => k (Normal p q s))) * scale ^ 2
    = Mass (Degrees OfFaceD a b c d) weights * k (Normal xa xb xd).
  Proof.
    intros [<-|[<-|[<-|[]]]];
      apply (ValueTable true true false true _
               (fun p q _ s => _ (Normal p q s)));
      try prove_suits; prove_homogeneous.
  Qed.

  Lemma OfEdgeValue (k : Coord3 -> Z) : In k [X; Y; W] ->
    Value (Degrees OfEdge a b c d) weights
      (Table OfEdge a b c d (fun p q _ _ => k (Difference p q))) * scale
    = Mass (Degrees OfEdge a b c d) weights * k (Difference xa xb).
  Proof.
    intros [<-|[<-|[<-|[]]]];
      apply (ValueTable true true false false _
               (fun p q _ _ => _ (Difference p q)));
      try prove_suits; prove_homogeneous.
  Qed.

  Lemma DegreesLength m : length (Degrees m a b c d) = 4%nat.
  Proof. destruct m. reflexivity. Qed.

  Lemma DotValue m n f g (u v : Coord3) (k l : Z) :
    (forall i, In i [X; Y; W] ->
       Value (Degrees m a b c d) weights
         (Table m a b c d (fun p q r s => i (f p q r s))) * k
       = Mass (Degrees m a b c d) weights * i u) ->
    (forall i, In i [X; Y; W] ->
       Value (Degrees n a b c d) weights
         (Table n a b c d (fun p q r s => i (g p q r s))) * l
       = Mass (Degrees n a b c d) weights * i v) ->
    Value (SumDegrees (Degrees m a b c d) (Degrees n a b c d)) weights
      (DotForm a b c d m n f g) * (k * l)
    = Mass (Degrees m a b c d) weights * Mass (Degrees n a b c d) weights
      * Dot u v.
  Proof.
    intros Hf Hg. unfold DotForm.
    rewrite !ValueAdd, !ValueMul
      by (rewrite ?SumDegreesLength, ?DegreesLength; cbn; rewrite ?DegreesLength; lia).
    assert (E : forall i, In i [X; Y; W] ->
      Value (Degrees m a b c d) weights
        (Table m a b c d (fun p q r s => i (f p q r s)))
      * Value (Degrees n a b c d) weights
        (Table n a b c d (fun p q r s => i (g p q r s))) * (k * l)
      = Mass (Degrees m a b c d) weights * Mass (Degrees n a b c d) weights
        * (i u * i v)).
    { intros i Hi. specialize (Hf i Hi). specialize (Hg i Hi).
      match type of Hf with ?x * _ = _ => match type of Hg with ?y * _ = _ =>
        transitivity ((x * k) * (y * l)); [ring|] end end.
      rewrite Hf, Hg. ring. }
    pose proof (E X ltac:(cbn; tauto)) as EX.
    pose proof (E Y ltac:(cbn; tauto)) as EY.
    pose proof (E W ltac:(cbn; tauto)) as EW.
    clear E Hf Hg. destruct u as [u1 u2 u3], v as [v1 v2 v3].
    cbn [X Y W Dot] in *.
    rewrite !Z.mul_add_distr_r, EX, EY, EW. ring.
  Qed.

  Let MC := Mass (Degrees OfFaceC a b c d) weights.
  Let MD := Mass (Degrees OfFaceD a b c d) weights.
  Let ME := Mass (Degrees OfEdge a b c d) weights.
  Let MV := Mass (VolumeDegrees a b c d) weights.

  Lemma NormalsValue :
    Value (NormalsDegrees a b c d) weights (NormalsForm a b c d)
      * (scale ^ 2 * scale ^ 2)
    = MC * MD * NormalsProduct xa xb xc xd.
  Proof.
    apply DotValue; intros i Hi; [apply FaceCValue | apply FaceDValue];
      assumption.
  Qed.

  Lemma EdgeValue :
    Value (EdgeDegrees a b c d) weights (EdgeForm a b c d) * (scale * scale)
    = ME * ME * EdgeSquared xa xb.
  Proof. apply DotValue; intros i Hi; apply OfEdgeValue; assumption. Qed.

  (** The masses of both sides of the inequality agree. *)
  Lemma MassesAgree : (MC * MD) ^ 2 = MV ^ 2 * (ME * ME).
  Proof.
    unfold MC, MD, ME, MV, VolumeDegrees, OfFaceC, OfFaceD, OfEdge, OfVolume,
      weights.
    cbn [Degrees Mass].
    set (A := (wa + ua) ^ _). set (B := (wb + ub) ^ _).
    set (C := (wc + uc) ^ _). set (D := (wd + ud) ^ _).
    cbn [Degree Z.of_nat]. rewrite !Z.pow_0_r. ring.
  Qed.

  Lemma MassSum m n :
    Mass (SumDegrees (Degrees m a b c d) (Degrees n a b c d)) weights
    = Mass (Degrees m a b c d) weights * Mass (Degrees n a b c d) weights.
  Proof.
    destruct m as [m1 m2 m3 m4], n as [n1 n2 n3 n4].
    cbn [Degrees SumDegrees Mass weights].
    rewrite !Nat2Z.inj_add, !Z.pow_add_r by lia. ring.
  Qed.

  (** ** The checks *)

  Hypothesis Hscale : 0 < scale.

  Let Lengths : forall m, (length (Degrees m a b c d) <= length weights)%nat.
  Proof. intros m. rewrite DegreesLength. cbn. lia. Qed.

  Let SumLengths : forall m n,
    (length (SumDegrees (Degrees m a b c d) (Degrees n a b c d))
     <= length weights)%nat.
  Proof.
    intros m n. rewrite SumDegreesLength; rewrite ?DegreesLength; cbn; lia.
  Qed.

  Lemma Cancel (k m n : Z) : 0 < k -> k * m <= k * n -> m <= n.
  Proof. intros P. apply Z.mul_le_mono_pos_l, P. Qed.

  Lemma VolumeAtLeast :
    scale ^ 3 * Lower (VolumeDegrees a b c d) (VolumeForm a b c d)
    <= SixVolume xa xb xc xd.
  Proof.
    pose proof (LowerBound (VolumeDegrees a b c d) weights
      (VolumeForm a b c d) WeightsNonNegative (Lengths _)) as L.
    pose proof VolumeValue as E.
    pose proof (MassPositive OfVolume) as P.
    change (Degrees OfVolume a b c d) with (VolumeDegrees a b c d) in P.
    apply (ScaleLe (scale ^ 3)) in L; [|apply Z.pow_nonneg; lia].
    apply (Cancel _ _ _ P). lia.
  Qed.

  Lemma EdgeAtLeast :
    scale ^ 2 * Lower (EdgeDegrees a b c d) (EdgeForm a b c d)
    <= EdgeSquared xa xb.
  Proof.
    pose proof (LowerBound (EdgeDegrees a b c d) weights
      (EdgeForm a b c d) WeightsNonNegative (SumLengths _ _)) as L.
    pose proof EdgeValue as E.
    pose proof (MassPositive OfEdge) as P.
    unfold EdgeDegrees in L at 2. rewrite MassSum in L.
    apply (ScaleLe (scale ^ 2)) in L; [|apply Z.pow_nonneg; lia].
    fold ME in L, P.
    assert (Q : 0 < ME * ME) by (apply Z.mul_pos_pos; assumption).
    apply (Cancel _ _ _ Q). lia.
  Qed.

  Lemma NormalsAtMost :
    NormalsProduct xa xb xc xd
    <= scale ^ 4 * Upper (NormalsDegrees a b c d) (NormalsForm a b c d).
  Proof.
    pose proof (UpperBound (NormalsDegrees a b c d) weights
      (NormalsForm a b c d) WeightsNonNegative (SumLengths _ _)) as L.
    pose proof NormalsValue as E.
    pose proof (MassPositive OfFaceC) as P.
    pose proof (MassPositive OfFaceD) as P'.
    unfold NormalsDegrees in L at 3. rewrite MassSum in L.
    apply (ScaleLe (scale ^ 4)) in L; [|apply Z.pow_nonneg; lia].
    fold MC in L, P. fold MD in L, P'.
    assert (Q : 0 < MC * MD) by (apply Z.mul_pos_pos; assumption).
    apply (Cancel _ _ _ Q). lia.
  Qed.

  Lemma NormalsAtLeast :
    scale ^ 4 * Lower (NormalsDegrees a b c d) (NormalsForm a b c d)
    <= NormalsProduct xa xb xc xd.
  Proof.
    pose proof (LowerBound (NormalsDegrees a b c d) weights
      (NormalsForm a b c d) WeightsNonNegative (SumLengths _ _)) as L.
    pose proof NormalsValue as E.
    pose proof (MassPositive OfFaceC) as P.
    pose proof (MassPositive OfFaceD) as P'.
    unfold NormalsDegrees in L at 2. rewrite MassSum in L.
    apply (ScaleLe (scale ^ 4)) in L; [|apply Z.pow_nonneg; lia].
    fold MC in L, P. fold MD in L, P'.
    assert (Q : 0 < MC * MD) by (apply Z.mul_pos_pos; assumption).
    apply (Cancel _ _ _ Q). lia.
  Qed.

  Lemma FullSound num den :
    CheckFull (CotSq num den) a b c d = true ->
    den * NormalsProduct xa xb xc xd ^ 2
    <= num * (SixVolume xa xb xc xd ^ 2 * EdgeSquared xa xb).
  Proof.
    intros K. unfold CheckFull in K.
    apply (ValueAtMost den num _ _ weights) in K;
      [ | apply WeightsNonNegative
        | repeat rewrite SumDegreesLength; rewrite ?SumDegreesLength,
            ?DegreesLength; cbn; lia
        | repeat rewrite SumDegreesLength; rewrite ?SumDegreesLength,
            ?DegreesLength; try reflexivity; cbn; lia ].
    rewrite !ValueMul in K
      by (repeat rewrite SumDegreesLength; rewrite ?SumDegreesLength,
            ?DegreesLength; cbn; lia).
    pose proof VolumeValue as EV. pose proof EdgeValue as EE.
    pose proof NormalsValue as EN. pose proof MassesAgree as EM.
    pose proof (MassPositive OfFaceC) as P. fold MC in P.
    pose proof (MassPositive OfFaceD) as P'. fold MD in P'.
    fold MV in EV.
    set (n := Value (NormalsDegrees a b c d) weights _) in *.
    set (v := Value (VolumeDegrees a b c d) weights _) in *.
    set (l := Value (EdgeDegrees a b c d) weights _) in *.
    set (N := NormalsProduct xa xb xc xd) in *.
    set (V := SixVolume xa xb xc xd) in *.
    set (L := EdgeSquared xa xb) in *.
    assert (Q : 0 < (MC * MD) ^ 2)
      by (apply Z.pow_pos_nonneg; [apply Z.mul_pos_pos; assumption | lia]).
    apply (Cancel _ _ _ Q).
    assert (EN2 : (MC * MD) ^ 2 * N ^ 2 = n * n * scale ^ 8)
      by (transitivity ((MC * MD * N) ^ 2); [ring | rewrite <- EN; ring]).
    assert (EV2 : MV ^ 2 * (ME * ME) * (V ^ 2 * L) = v * v * l * scale ^ 8).
    { transitivity ((MV * V) ^ 2 * (ME * ME * L)); [ring|].
      rewrite <- EV, <- EE. ring. }
    rewrite <- EM in EV2.
    transitivity (den * ((MC * MD) ^ 2 * N ^ 2)); [apply Z.eq_le_incl; ring|].
    transitivity (num * ((MC * MD) ^ 2 * (V ^ 2 * L)));
      [|apply Z.eq_le_incl; ring].
    rewrite EN2, EV2.
    apply (ScaleLe (scale ^ 8)) in K; [|apply Z.pow_nonneg; lia].
    lia.
  Qed.

  Lemma RangesSound num den volume extreme edge :
    CheckRanges (CotSq num den) volume extreme edge = true ->
    0 <= num -> 0 <= den -> 0 <= volume ->
    scale ^ 3 * volume <= SixVolume xa xb xc xd ->
    scale ^ 2 * edge <= EdgeSquared xa xb ->
    Z.abs (NormalsProduct xa xb xc xd) <= Z.abs (scale ^ 4 * extreme) ->
    den * NormalsProduct xa xb xc xd ^ 2
    <= num * (SixVolume xa xb xc xd ^ 2 * EdgeSquared xa xb).
  Proof.
    intros K Pn Pd Pv HV HE HN. unfold CheckRanges in K.
    destruct (Z.leb_spec 0 edge) as [Ke|]; [|discriminate K].
    apply Z.leb_le in K.
    set (N := NormalsProduct xa xb xc xd) in *.
    set (V := SixVolume xa xb xc xd) in *.
    set (L := EdgeSquared xa xb) in *.
    assert (N2 : N ^ 2 <= (scale ^ 4 * extreme) ^ 2)
      by (rewrite (Z.pow_even_abs N 2), (Z.pow_even_abs (scale ^ 4 * extreme) 2)
            by (exists 1; reflexivity);
          apply Z.pow_le_mono_l; lia).
    assert (P3 : 0 <= scale ^ 3 * volume)
      by (apply Z.mul_nonneg_nonneg; [apply Z.pow_nonneg|]; lia).
    assert (P2 : 0 <= scale ^ 2 * edge)
      by (apply Z.mul_nonneg_nonneg; [apply Z.pow_nonneg|]; lia).
    assert (V2 : (scale ^ 3 * volume) ^ 2 <= V ^ 2)
      by (apply Z.pow_le_mono_l; lia).
    assert (VL : (scale ^ 3 * volume) ^ 2 * (scale ^ 2 * edge) <= V ^ 2 * L)
      by (apply Z.mul_le_mono_nonneg; try assumption; apply Z.pow_nonneg; lia).
    apply (ScaleLe den) in N2; [|assumption].
    apply (ScaleLe num) in VL; [|assumption].
    apply (ScaleLe (scale ^ 8)) in K; [|apply Z.pow_nonneg; lia].
    apply (Z.le_trans _ _ _ N2). refine (Z.le_trans _ _ _ _ VL).
    replace (den * (scale ^ 4 * extreme) ^ 2)
      with (scale ^ 8 * (den * (extreme * extreme))) by ring.
    replace (num * ((scale ^ 3 * volume) ^ 2 * (scale ^ 2 * edge)))
      with (scale ^ 8 * (num * (volume * volume * edge))) by ring.
    assumption.
  Qed.
End Quadruple.
