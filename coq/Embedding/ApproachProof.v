(** * Rounded counts come near every point

    One more count moves a rounded point along one placed short edge.  The eight
    such steps, forth and back along four diagonals, lead into the eight octants,
    so that one of them leads nearer to any point that is not near already. *)

From Coq Require Import Wf_nat.
From Certet Require Import Embedding.Definitions.
From Certet Require Import Embedding.Rounding Embedding.LatticeEmbedsProof.
Open Scope Z_scope.

(** ** One more count *)

Lemma SumButOne n f h i : 0 <= i < Z.of_nat n ->
  (forall j, 0 <= j < Z.of_nat n -> j <> i -> f j = h j) ->
  Sum n f = Sum n h + (f i - h i).
Proof.
  induction n as [|n IH]; intros I E; [cbn in I; lia|]. cbn [Sum].
  destruct (Z.eq_dec i (Z.of_nat n)) as [->|N].
  - rewrite (SumExt n f h); [lia|]. intros j J. apply E; lia.
  - rewrite IH; [rewrite (E (Z.of_nat n)); lia|lia|]. intros j J. apply E; lia.
Qed.

Lemma MixStep n p q r s : (0 < n)%nat -> exists a b c d, forall g,
  Mix n g (p + 1) q r s = Mix n g p q r s + (g (a + 1) b c d - g a b c d).
Proof.
  intros P. set (N := Z.of_nat n). set (i := N - 1 - p mod N).
  pose proof (Z.mod_pos_bound p N ltac:(unfold N; lia)) as B.
  pose proof (Z.div_mod p N ltac:(unfold N; lia)) as D.
  exists ((p + i) / N), ((q + i) / N), ((r + i) / N), ((s + i) / N). intros g.
  unfold Mix. fold N.
  rewrite (SumButOne n _ (fun j => g ((p + j) / N) ((q + j) / N) ((r + j) / N)
    ((s + j) / N)) i).
  - cbv beta zeta. replace ((p + 1 + i) / N) with ((p + i) / N + 1); [lia|].
    replace (p + 1 + i) with (p + i + 1) by ring.
    replace ((p + i) / N) with (p / N).
    + apply Z.div_unique with 0; unfold i; lia.
    + apply Z.div_unique with (N - 1); unfold i; lia.
  - fold N. unfold i. lia.
  - fold N. intros j J K. cbv beta zeta.
    replace ((p + 1 + j) / N) with ((p + j) / N); [reflexivity|].
    destruct (Z.lt_ge_cases j i) as [L|L].
    + transitivity (p / N); [symmetry|];
        [apply Z.div_unique with (p mod N + j)
        |apply Z.div_unique with (p mod N + 1 + j)]; unfold i in *; lia.
    + transitivity (p / N + 1); [symmetry|];
        [apply Z.div_unique with (p mod N + j - N)
        |apply Z.div_unique with (p mod N + 1 + j - N)]; unfold i in *; lia.
Qed.

(** ** Nearer *)

Section Approach.
  Variables (place : Coord3 -> Coord3) (D : Z).
  Hypothesis Keeps : KeepsShortEdges place.

  Definition NoLonger (v : Coord3) : Prop :=
    Z.abs (XOf v) <= D /\ Z.abs (YOf v) <= D /\ Z.abs (ZOf v) <= D.

  Hypothesis Bounded : forall v d, DirectionKind d = Short ->
    NoLonger (Difference (place v) (place (Translate v (Offset d)))).

  Variable n : nat.
  Hypothesis SomeParts : (0 < n)%nat.

  Definition Rounded (p q r s : Z) : Coord3 :=
    let at_ f := Mix n (fun p q r s => f (place (ToPoint p q r s))) p q r s in
    C3 (at_ XOf) (at_ YOf) (at_ ZOf).

  (** Two counts whose rounded points are one placed short edge apart. *)
  Definition StepBetween (d : Direction) (y y' : Coord3) : Prop :=
    exists v, Translate y v = y' /\ SameOctant (Offset d) v /\ NoLonger v.

  Lemma RoundedSteps p q r s :
    StepBetween Dir_ppp (Rounded p q r s) (Rounded (p + 1) q r s) /\
    StepBetween Dir_pmm (Rounded p q r s) (Rounded p (q + 1) r s) /\
    StepBetween Dir_mpm (Rounded p q r s) (Rounded p q (r + 1) s) /\
    StepBetween Dir_mmp (Rounded p q r s) (Rounded p q r (s + 1)).
  Proof.
    assert (G : forall d a b c e a' b' c' e' y,
      DirectionKind d = Short ->
      ToPoint a' b' c' e' = Translate (ToPoint a b c e) (Offset d) ->
      (forall g : Coord3 -> Z, Mix n (fun p q r s => g (ToPoint p q r s)) (fst (fst (fst y)))
          (snd (fst (fst y))) (snd (fst y)) (snd y)
        = Mix n (fun p q r s => g (ToPoint p q r s)) p q r s
          + (g (ToPoint a' b' c' e') - g (ToPoint a b c e))) ->
      StepBetween d (Rounded p q r s)
        (Rounded (fst (fst (fst y))) (snd (fst (fst y))) (snd (fst y)) (snd y))).
    { intros d a b c e a' b' c' e' y K T M.
      exists (Difference (place (ToPoint a b c e)) (place (ToPoint a' b' c' e'))).
      split; [|rewrite T; split; [apply Keeps|apply Bounded]; exact K].
      unfold Rounded. cbv zeta.
      rewrite (M (fun v => XOf (place v))), (M (fun v => YOf (place v))),
        (M (fun v => ZOf (place v))).
      destruct (place (ToPoint a b c e)), (place (ToPoint a' b' c' e')).
      cbn [Difference Translate XOf YOf ZOf]. reflexivity. }
    split; [|split; [|split]].
    - destruct (MixStep n p q r s SomeParts) as (a & b & c & e & M).
      apply (G Dir_ppp a b c e (a + 1) b c e (p + 1, q, r, s)); [reflexivity| |].
      + apply ToPointNext.
      + intros g. exact (M (fun p q r s => g (ToPoint p q r s))).
    - destruct (MixStep n q p r s SomeParts) as (b & a & c & e & M).
      apply (G Dir_pmm a b c e a (b + 1) c e (p, q + 1, r, s)); [reflexivity| |].
      + apply ToPointNext.
      + intros g. exact (M (fun q p r s => g (ToPoint p q r s))).
    - destruct (MixStep n r p q s SomeParts) as (c & a & b & e & M).
      apply (G Dir_mpm a b c e a b (c + 1) e (p, q, r + 1, s)); [reflexivity| |].
      + apply ToPointNext.
      + intros g. exact (M (fun r p q s => g (ToPoint p q r s))).
    - destruct (MixStep n s p q r SomeParts) as (e & a & b & c & M).
      apply (G Dir_mmp a b c e a b c (e + 1) (p, q, r, s + 1)); [reflexivity| |].
      + apply ToPointNext.
      + intros g. exact (M (fun s p q r => g (ToPoint p q r s))).
  Qed.

  Definition SquareOf (v : Coord3) : Z :=
    XOf v * XOf v + YOf v * YOf v + ZOf v * ZOf v.

  Definition Near (limit : Z) (v : Coord3) : Prop :=
    Z.abs (XOf v) <= limit /\ Z.abs (YOf v) <= limit /\ Z.abs (ZOf v) <= limit.

  (** A step into the octant of what is missing leaves less missing. *)
  Lemma StepShortens e v :
    0 <= XOf e * XOf v -> 0 <= YOf e * YOf v -> 0 <= ZOf e * ZOf v ->
    1 <= Z.abs (XOf v) -> 1 <= Z.abs (YOf v) -> 1 <= Z.abs (ZOf v) ->
    NoLonger v -> ~ Near (2 * D * D) e ->
    SquareOf (Difference v e) < SquareOf e.
  Proof.
    destruct e as [a b c], v as [x y z]. unfold NoLonger, Near, SquareOf.
    cbn [XOf YOf ZOf Difference]. intros A B C X Y Z (Dx & Dy & Dz) F.
    assert (Sq : forall x, x * x = Z.abs x * Z.abs x)
      by (intros; symmetry; apply Z.abs_square).
    assert (G : forall a x, 0 <= a * x -> Z.abs x <= D ->
      2 * (a * x) - x * x >= - (D * D)).
    { intros a' x' P U. rewrite (Sq x').
      pose proof (Z.mul_le_mono_nonneg _ _ _ _ (Z.abs_nonneg x') U
        (Z.abs_nonneg x') U). lia. }
    assert (H : forall a x, 0 <= a * x -> 1 <= Z.abs x -> Z.abs x <= D ->
      2 * D * D < Z.abs a -> 2 * (a * x) - x * x > 2 * (D * D)).
    { intros a' x' P L U W.
      replace (a' * x') with (Z.abs a' * Z.abs x') by (rewrite <- Z.abs_mul; lia).
      rewrite (Sq x'). set (u := Z.abs a') in *. set (v := Z.abs x') in *.
      clearbody u v.
      assert (0 <= (D - 1) * D) by (apply Z.mul_nonneg_nonneg; lia).
      assert (0 <= (v - 1) * (2 * u - v)) by (apply Z.mul_nonneg_nonneg; lia).
      lia. }
    assert (Q : 2 * (a * x) - x * x + (2 * (b * y) - y * y) + (2 * (c * z) - z * z) > 0).
    { destruct (Z.le_gt_cases (Z.abs a) (2 * D * D)) as [La|La];
        [destruct (Z.le_gt_cases (Z.abs b) (2 * D * D)) as [Lb|Lb];
          [destruct (Z.le_gt_cases (Z.abs c) (2 * D * D)) as [Lc|Lc]|]|].
      - tauto.
      - pose proof (G a x A Dx). pose proof (G b y B Dy). pose proof (H c z C Z Dz Lc). lia.
      - pose proof (G a x A Dx). pose proof (H b y B Y Dy Lb). pose proof (G c z C Dz). lia.
      - pose proof (H a x A X Dx La). pose proof (G b y B Dy). pose proof (G c z C Dz). lia. }
    lia.
  Qed.

  (** It lies in the octant of [e]. *)
  Definition Towards (e v : Coord3) : Prop :=
    (0 <= XOf e * XOf v /\ 0 <= YOf e * YOf v /\ 0 <= ZOf e * ZOf v) /\
    (1 <= Z.abs (XOf v) /\ 1 <= Z.abs (YOf v) /\ 1 <= Z.abs (ZOf v)) /\
    NoLonger v.

  Ltac by_signs :=
    lia || (repeat split;
      (apply Z.mul_nonneg_nonneg; lia) || (apply Z.mul_nonpos_nonpos; lia)).

  (** All coordinates of [e] have the signs of [d], or the opposite ones. *)
  Lemma ForthTowards d e y y' : StepBetween d y y' ->
    0 <= XOf (Offset d) * XOf e -> 0 <= YOf (Offset d) * YOf e ->
    0 <= ZOf (Offset d) * ZOf e ->
    exists v, y' = Translate y v /\ Towards e v.
  Proof.
    intros (v & <- & O & L) A B C. exists v. split; [reflexivity|].
    unfold Towards. split; [|split; [|exact L]];
      destruct d, v, e; cbn [Offset SameOctant XOf YOf ZOf] in *; by_signs.
  Qed.

  Lemma BackTowards d e y y' : StepBetween d y y' ->
    XOf (Offset d) * XOf e <= 0 -> YOf (Offset d) * YOf e <= 0 ->
    ZOf (Offset d) * ZOf e <= 0 ->
    exists v, y = Translate y' v /\ Towards e v.
  Proof.
    intros (v & <- & O & L) A B C. exists (Scale (-1) v). split.
    - destruct y, v. cbn [Translate Scale]. f_equal; ring.
    - unfold Towards, NoLonger in *. split; [|split];
        destruct d, v, e; cbn [Offset SameOctant XOf YOf ZOf Scale] in *; by_signs.
  Qed.

  Ltac found :=
    match goal with
    | |- ex _ => do 4 eexists; eexists; split; eassumption
    | _ => cbn [Offset XOf YOf ZOf]; lia
    end.

  Lemma StepTowards e p q r s : exists p' q' r' s' v,
    Rounded p' q' r' s' = Translate (Rounded p q r s) v /\ Towards e v.
  Proof.
    destruct (RoundedSteps p q r s) as (Fp & Fq & Fr & Fs).
    destruct (RoundedSteps (p - 1) q r s) as (Bp & _).
    destruct (RoundedSteps p (q - 1) r s) as (_ & Bq & _).
    destruct (RoundedSteps p q (r - 1) s) as (_ & _ & Br & _).
    destruct (RoundedSteps p q r (s - 1)) as (_ & _ & _ & Bs).
    rewrite Z.sub_add in Bp, Bq, Br, Bs.
    destruct (Z.le_ge_cases 0 (XOf e)), (Z.le_ge_cases 0 (YOf e)),
      (Z.le_ge_cases 0 (ZOf e)).
    - destruct (ForthTowards _ e _ _ Fp) as (v & E & T); found.
    - destruct (BackTowards _ e _ _ Bs) as (v & E & T); found.
    - destruct (BackTowards _ e _ _ Br) as (v & E & T); found.
    - destruct (ForthTowards _ e _ _ Fq) as (v & E & T); found.
    - destruct (BackTowards _ e _ _ Bq) as (v & E & T); found.
    - destruct (ForthTowards _ e _ _ Fr) as (v & E & T); found.
    - destruct (ForthTowards _ e _ _ Fs) as (v & E & T); found.
    - destruct (BackTowards _ e _ _ Bp) as (v & E & T); found.
  Qed.

  Theorem Approach x : exists p q r s,
    Near (2 * D * D) (Difference (Rounded p q r s) x).
  Proof.
    enough (A : forall k p q r s,
      (Z.to_nat (SquareOf (Difference (Rounded p q r s) x)) < k)%nat ->
      exists p q r s, Near (2 * D * D) (Difference (Rounded p q r s) x))
      by (eapply (A _ 0 0 0 0); apply le_n).
    induction k as [|k IH]; intros p q r s L; [inversion L|].
    set (e := Difference (Rounded p q r s) x) in *.
    destruct (Z.le_gt_cases (Z.abs (XOf e)) (2 * D * D)) as [Lx|Lx];
      [destruct (Z.le_gt_cases (Z.abs (YOf e)) (2 * D * D)) as [Ly|Ly];
        [destruct (Z.le_gt_cases (Z.abs (ZOf e)) (2 * D * D)) as [Lz|Lz]|]|].
    1: exists p, q, r, s; split; auto.
    all: destruct (StepTowards e p q r s)
      as (p' & q' & r' & s' & v & E & (A & B & C) & (X & Y & Z) & T);
      apply (IH p' q' r' s');
      pose proof (StepShortens e v A B C X Y Z T) as S;
      assert (S' : SquareOf (Difference v e) < SquareOf e)
        by (apply S; unfold Near; lia);
      replace (Difference (Rounded p' q' r' s') x) with (Difference v e)
        by (rewrite E; unfold e; destruct (Rounded p q r s), v, x;
            cbn [Difference Translate]; f_equal; ring);
      assert (0 <= SquareOf (Difference v e))
        by (unfold SquareOf; pose proof Z.square_nonneg as N;
            pose proof (N (XOf (Difference v e)));
            pose proof (N (YOf (Difference v e)));
            pose proof (N (ZOf (Difference v e))); lia);
      lia.
  Qed.
End Approach.
