(** * The checker is sound: proofs *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Forms.BoxForm Angles.Forms.BoxFormProof
  Angles.Forms.Checker Angles.Forms.EdgeProof.
Open Scope Z_scope.

Lemma IfBoth (x y : bool) :
  (if x then y else false) = true -> x = true /\ y = true.
Proof. destruct x; intros E; [split; [reflexivity|exact E]|discriminate E]. Qed.

Lemma IfEither (x y : bool) :
  (if x then true else y) = true -> x = true \/ y = true.
Proof. destruct x; intros E; [left; reflexivity|right; exact E]. Qed.

(** ** Halving *)

Lemma ScaledQuantities (k : Z) a b c d :
  SixVolume (Scale k a) (Scale k b) (Scale k c) (Scale k d)
  = k ^ 3 * SixVolume a b c d /\
  NormalsProduct (Scale k a) (Scale k b) (Scale k c) (Scale k d)
  = k ^ 4 * NormalsProduct a b c d /\
  EdgeSquared (Scale k a) (Scale k b) = k ^ 2 * EdgeSquared a b.
Proof.
  destruct a, b, c, d. unfold SixVolume, NormalsProduct, EdgeSquared, Normal.
  cbn [Scale Difference Cross Dot]. repeat split; ring.
Qed.

Definition WithinCotangent (num den : Z) (a b c d : Coord3) : Prop :=
  den * NormalsProduct a b c d ^ 2
  <= num * (SixVolume a b c d ^ 2 * EdgeSquared a b).

Lemma Unscaled (k num den : Z) a b c d : 0 < k ->
  WithinCotangent num den (Scale k a) (Scale k b) (Scale k c) (Scale k d) ->
  WithinCotangent num den a b c d.
Proof.
  unfold WithinCotangent.
  destruct (ScaledQuantities k a b c d) as (-> & -> & ->). intros P K.
  apply (Cancel (k ^ 8)); [apply Z.pow_pos_nonneg; lia|].
  replace (k ^ 8 * (den * _)) with (den * (k ^ 4 * NormalsProduct a b c d) ^ 2)
    by ring.
  replace (k ^ 8 * (num * _))
    with (num * ((k ^ 3 * SixVolume a b c d) ^ 2 * (k ^ 2 * EdgeSquared a b)))
    by ring.
  assumption.
Qed.

Lemma OnDoubled scale s x :
  OnSegment scale s x -> OnSegment scale (Doubled s) (Scale 2 x).
Proof.
  intros [[w u] (Hw & Hu & Hs & E)]. exists (w, u).
  repeat (split; [assumption|]).
  destruct s as [p|p q]; cbn [Doubled].
  - destruct E as [E ->]. split; [assumption|].
    destruct p. cbn [Scale]. f_equal; ring.
  - destruct x as [x1 x2 x3], p as [p1 p2 p3], q as [q1 q2 q3].
    cbn [Scale Translate] in *. injection E as E1 E2 E3. f_equal; lia.
Qed.

Lemma OnHalf scale s x : OnSegment scale s x ->
  OnSegment scale (FirstHalf s) (Scale 2 x) \/
  OnSegment scale (SecondHalf s) (Scale 2 x).
Proof.
  intros [[w u] (Hw & Hu & Hs & E)].
  destruct s as [p|p q]; cbn [FirstHalf SecondHalf].
  - left. exists (w, u). repeat (split; [assumption|]).
    destruct E as [E ->]. split; [assumption|].
    destruct p. cbn [Scale]. f_equal; ring.
  - destruct x as [x1 x2 x3], p as [p1 p2 p3], q as [q1 q2 q3].
    cbn [Scale Translate] in *. injection E as E1 E2 E3.
    destruct (Z.le_ge_cases u w) as [L|L]; [left|right].
    + exists (w - u, 2 * u). repeat (split; [lia|]).
      cbn [Scale Translate]. f_equal; lia.
    + exists (2 * w, u - w). repeat (split; [lia|]).
      cbn [Scale Translate]. f_equal; lia.
Qed.

Section Tetrahedron.
  Variable scale : Z.
  Hypothesis Hscale : 0 < scale.

  (** What passes a check has its angles within the bound. *)
  Definition Suffices check : Prop :=
    forall num den a b c d xa xb xc xd,
      OnSegment scale a xa -> OnSegment scale b xb ->
      OnSegment scale c xc -> OnSegment scale d xd ->
      check (CotSq num den) a b c d = true ->
      WithinCotangent num den xa xb xc xd.

  Lemma FullWithin : Suffices CheckFull.
  Proof.
    intros num den a b c d xa xb xc xd [[? ?] Ha] [[? ?] Hb] [[? ?] Hc] [[? ?] Hd].
    exact (FullSound scale a b c d xa xb xc xd _ _ _ _ _ _ _ _
             Ha Hb Hc Hd Hscale num den).
  Qed.

  (** Of a segment in halves: the one that the vertex is on passes the check. *)
  Ltac half on := destruct (OnHalf _ _ _ on); eapply FullWithin; eassumption.

  Lemma HalvesWithin : Suffices CheckHalves.
  Proof.
    intros num den a b c d xa xb xc xd Ha Hb Hc Hd K. apply (Unscaled 2); [lia|].
    pose proof (OnDoubled _ _ _ Ha) as Da. pose proof (OnDoubled _ _ _ Hb) as Db.
    pose proof (OnDoubled _ _ _ Hc) as Dc. pose proof (OnDoubled _ _ _ Hd) as Dd.
    unfold CheckHalves in K.
    apply IfEither in K. destruct K as [K|K];
      [|apply IfEither in K; destruct K as [K|K];
        [|apply IfEither in K; destruct K as [K|K]]];
      apply IfBoth in K; destruct K as [K K'].
    - half Ha.
    - half Hb.
    - half Hc.
    - half Hd.
  Qed.

  Lemma BoundWithin num den volume extreme a b c d xa xb xc xd :
    OnSegment scale a xa -> OnSegment scale b xb ->
    OnSegment scale c xc -> OnSegment scale d xd ->
    0 <= num -> 0 <= den -> 0 <= volume ->
    scale ^ 3 * volume <= SixVolume xa xb xc xd ->
    Z.abs (NormalsProduct xa xb xc xd) <= Z.abs (scale ^ 4 * extreme) ->
    CheckBound (CotSq num den) volume extreme
      (Lower (EdgeDegrees a b c d) (EdgeForm a b c d)) a b c d = true ->
    WithinCotangent num den xa xb xc xd.
  Proof.
    intros Ha Hb Hc Hd Pn Pd Pv HV HN K. unfold CheckBound in K.
    destruct (CheckRanges _ _ _ _) eqn:R.
    - clear K. destruct Ha as [[? ?] Ha], Hb as [[? ?] Hb], Hc as [[? ?] Hc],
        Hd as [[? ?] Hd].
      eapply RangesSound; try eassumption.
      exact (EdgeAtLeast scale a b c d xa xb xc xd _ _ _ _ _ _ _ _
               Ha Hb Hc Hd Hscale).
    - destruct (CheckFull _ _ _ _ _) eqn:F.
      + exact (FullWithin _ _ _ _ _ _ _ _ _ _ Ha Hb Hc Hd F).
      + exact (HalvesWithin _ _ _ _ _ _ _ _ _ _ Ha Hb Hc Hd K).
  Qed.

  Definition Sensible (bounds : AngleBounds) : Prop :=
    match bounds with
      AB (CotSq n d) (CotSq n' d') => 0 <= n /\ 0 <= d /\ 0 <= n' /\ 0 <= d'
    end.

  Lemma EdgeSound acute obtuse volume a b c d xa xb xc xd :
    Sensible (AB acute obtuse) ->
    OnSegment scale a xa -> OnSegment scale b xb ->
    OnSegment scale c xc -> OnSegment scale d xd ->
    0 <= volume -> scale ^ 3 * volume <= SixVolume xa xb xc xd ->
    CheckEdge (AB acute obtuse) volume a b c d = true ->
    AngleAtLeast acute xa xb xc xd /\ AngleAtMost obtuse xa xb xc xd.
  Proof.
    intros Hs Ha Hb Hc Hd Pv HV K.
    assert (Hi : NormalsProduct xa xb xc xd
      <= scale ^ 4 * Upper (NormalsDegrees a b c d) (NormalsForm a b c d)).
    { destruct Ha as [[? ?] Ha], Hb as [[? ?] Hb], Hc as [[? ?] Hc],
        Hd as [[? ?] Hd].
      exact (NormalsAtMost scale a b c d xa xb xc xd _ _ _ _ _ _ _ _
               Ha Hb Hc Hd Hscale). }
    assert (Lo :
      scale ^ 4 * Lower (NormalsDegrees a b c d) (NormalsForm a b c d)
      <= NormalsProduct xa xb xc xd).
    { destruct Ha as [[? ?] Ha], Hb as [[? ?] Hb], Hc as [[? ?] Hc],
        Hd as [[? ?] Hd].
      exact (NormalsAtLeast scale a b c d xa xb xc xd _ _ _ _ _ _ _ _
               Ha Hb Hc Hd Hscale). }
    assert (P4 : 0 < scale ^ 4) by (apply Z.pow_pos_nonneg; lia).
    destruct acute as [n k], obtuse as [n' k']. cbn in Hs.
    cbn beta iota zeta delta [CheckEdge] in K.
    apply IfBoth in K. destruct K as [K K'].
    set (most := Upper _ _) in *. set (least := Lower (NormalsDegrees _ _ _ _) _) in *.
    split.
    - cbn [AngleAtLeast].
      destruct (Z.le_gt_cases (NormalsProduct xa xb xc xd) 0) as [|G];
        [left; assumption|right].
      apply IfEither in K. destruct K as [K|K].
      + apply Z.leb_le in K. apply (ScaleLe (scale ^ 4)) in K; lia.
      + apply (BoundWithin n k volume most a b c d); try assumption; lia.
    - cbn [AngleAtMost].
      destruct (Z.le_gt_cases 0 (NormalsProduct xa xb xc xd)) as [|G];
        [left; assumption|right].
      apply IfEither in K'. destruct K' as [K'|K'].
      + apply Z.leb_le in K'. apply (ScaleLe (scale ^ 4)) in K'; lia.
      + apply (BoundWithin n' k' volume least a b c d); try assumption; lia.
  Qed.

  Lemma EvenOrders a b c d p q r s :
    In (p, q, r, s) (DihedralEdges (UT _ a b c d)) ->
    SixVolume p q r s = SixVolume a b c d.
  Proof.
    cbn [DihedralEdges In].
    intros [E|[E|[E|[E|[E|[E|[]]]]]]]; injection E as <- <- <- <-;
      destruct a, b, c, d; cbn [SixVolume Normal Difference Dot Cross]; ring.
  Qed.

  Theorem CheckTetSound bounds a b c d xa xb xc xd :
    Sensible bounds ->
    OnSegment scale a xa -> OnSegment scale b xb ->
    OnSegment scale c xc -> OnSegment scale d xd ->
    CheckTet bounds (UT _ a b c d) = true ->
    WellShaped bounds (UT _ xa xb xc xd).
  Proof.
    intros Hs Ha Hb Hc Hd K. destruct bounds as [acute obtuse].
    cbn beta iota zeta delta [CheckTet] in K.
    apply IfBoth in K. destruct K as [Pv K]. apply Z.ltb_lt in Pv.
    set (volume := Lower _ _) in *.
    assert (HV : scale ^ 3 * volume <= SixVolume xa xb xc xd).
    { destruct Ha as [[? ?] Ha], Hb as [[? ?] Hb], Hc as [[? ?] Hc],
        Hd as [[? ?] Hd].
      exact (VolumeAtLeast scale a b c d xa xb xc xd _ _ _ _ _ _ _ _
               Ha Hb Hc Hd Hscale). }
    split.
    - assert (0 < scale ^ 3) by (apply Z.pow_pos_nonneg; lia).
      assert (0 < scale ^ 3 * volume) by (apply Z.mul_pos_pos; assumption). lia.
    - intros p q r s I.
      assert (HV' : scale ^ 3 * volume <= SixVolume p q r s)
        by (rewrite (EvenOrders _ _ _ _ _ _ _ _ I); exact HV).
      cbn [DihedralEdges forallb] in K. rewrite !andb_true_iff in K.
      destruct K as (K1 & K2 & K3 & K4 & K5 & K6 & _).
      cbn [DihedralEdges In] in I.
      destruct I as [E|[E|[E|[E|[E|[E|[]]]]]]]; injection E as <- <- <- <-;
        eapply EdgeSound; try eassumption; lia.
  Qed.
End Tetrahedron.
