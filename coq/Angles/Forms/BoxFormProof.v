(** * What forms over a box compute: proofs *)

From Coq Require Import ZArith List Bool Lia.
From Certet Require Import Angles.Forms.BoxForm.
Import ListNotations.
Open Scope Z_scope.

Lemma PowS (w : Z) (n : nat) : w ^ Z.of_nat (S n) = w * w ^ Z.of_nat n.
Proof. rewrite Nat2Z.inj_succ. apply Z.pow_succ_r. lia. Qed.

Lemma PowNonNegative (w : Z) (n : nat) : 0 <= w -> 0 <= w ^ Z.of_nat n.
Proof. intros. apply Z.pow_nonneg. assumption. Qed.

Lemma ScaleLe (p n m : Z) : 0 <= p -> n <= m -> p * n <= p * m.
Proof. intros. apply Z.mul_le_mono_nonneg_l; assumption. Qed.

(** ** Arithmetic of forms *)

Section Forms.
  Variables w u : Z.

  Lemma FormValueAdd {A} (value : A -> Z) add :
    (forall x y, value (add x y) = value x + value y) ->
    forall d p q, FormValue value w u d (FormAdd add d p q)
      = FormValue value w u d p + FormValue value w u d q.
  Proof.
    intros H d; induction d as [|d IH]; intros p q.
    - apply H.
    - cbn [FormValue FormAdd fst snd]. rewrite H, IH. ring.
  Qed.

  Lemma FormValueMap {A B} (va : A -> Z) (vb : B -> Z) (f : A -> B) (k : Z) :
    (forall x, vb (f x) = k * va x) ->
    forall d p, FormValue vb w u d (FormMap f d p) = k * FormValue va w u d p.
  Proof.
    intros H d; induction d as [|d IH]; intros p.
    - apply H.
    - cbn [FormValue FormMap fst snd]. rewrite H, IH. ring.
  Qed.

  Lemma FormValueAddLow {A} (value : A -> Z) add :
    (forall x y, value (add x y) = value x + value y) ->
    forall k d p q, (k <= d)%nat ->
      FormValue value w u d (FormAddLow add k d p q)
      = w ^ Z.of_nat (d - k) * FormValue value w u k p
        + FormValue value w u d q.
  Proof.
    intros H k; induction k as [|k IH]; intros [|d] p q L.
    - cbn [FormValue FormAddLow Nat.sub Z.of_nat]. rewrite H, Z.pow_0_r. ring.
    - cbn [FormValue FormAddLow fst snd]. rewrite H.
      replace (S d - 0)%nat with (S d) by lia. ring.
    - lia.
    - cbn [FormValue FormAddLow fst snd]. rewrite H, IH by lia.
      change (S d - S k)%nat with (d - k)%nat.
      replace (w ^ Z.of_nat (S d))
        with (w ^ Z.of_nat (d - k) * w ^ Z.of_nat (S k)).
      + ring.
      + rewrite <- Z.pow_add_r by lia. f_equal. lia.
  Qed.

  Lemma FormValueMul {A B C} (va : A -> Z) (vb : B -> Z) (vc : C -> Z) mul add :
    (forall x y, vc (mul x y) = va x * vb y) ->
    (forall x y, vc (add x y) = vc x + vc y) ->
    forall j k p q, FormValue vc w u (j + k) (FormMul mul add j k p q)
      = FormValue va w u j p * FormValue vb w u k q.
  Proof.
    intros Hm Ha j; induction j as [|j IH]; intros k p q.
    - apply FormValueMap. intros x. apply Hm.
    - destruct k as [|k].
      + cbn [FormMul FormValue fst snd Nat.add].
        rewrite (IH O (snd p) q), Hm. cbn [FormValue].
        replace (S (j + 0)) with (S j) by lia. ring.
      + cbn [FormMul Nat.add].
        change (FormValue vc w u (S (j + S k)) ?x)
          with (w ^ Z.of_nat (S (j + S k)) * vc (fst x)
                + u * FormValue vc w u (j + S k) (snd x)).
        cbn [fst snd].
        rewrite FormValueAddLow by (assumption || lia).
        rewrite (FormValueMap vb vc (mul (fst p)) (va (fst p)))
          by (intros; apply Hm).
        rewrite (IH (S k) (snd p) q), Hm.
        change (FormValue va w u (S j) p)
          with (w ^ Z.of_nat (S j) * va (fst p) + u * FormValue va w u j (snd p)).
        change (FormValue vb w u (S k) q)
          with (w ^ Z.of_nat (S k) * vb (fst q) + u * FormValue vb w u k (snd q)).
        replace (j + S k - k)%nat with (S j) by lia.
        replace (w ^ Z.of_nat (S (j + S k)))
          with (w ^ Z.of_nat (S j) * w ^ Z.of_nat (S k)).
        * ring.
        * rewrite <- Z.pow_add_r by lia. f_equal. lia.
  Qed.

  Lemma FormValueAtMost {A B} (va : A -> Z) (vb : B -> Z) ok m n :
    0 <= w -> 0 <= u ->
    (forall x y, ok x y = true -> m * va x <= n * vb y) ->
    forall d e p q, FormAtMost ok d e p q = true ->
      m * FormValue va w u d p <= n * FormValue vb w u e q.
  Proof.
    intros Hw Hu H d; induction d as [|d IH]; intros [|e] p q E;
      cbn [FormAtMost] in E; try discriminate E.
    - apply H, E.
    - destruct (ok (fst p) (fst q)) eqn:K; [|discriminate E].
      (* The recursion fails unless the degrees agree. *)
      assert (D : d = e).
      { clear - E. revert e p q E.
        induction d as [|d IHd]; intros [|e] p q E; cbn [FormAtMost] in E;
          try discriminate E; [reflexivity|].
        destruct (ok (fst (snd p)) (fst (snd q))); [|discriminate E].
        f_equal. exact (IHd e (snd p) (snd q) E). }
      subst e.
      apply H in K. apply IH in E. cbn [FormValue].
      pose proof (PowNonNegative w (S d) Hw) as P.
      pose proof (Zmult_le_compat_l _ _ _ K P).
      pose proof (Zmult_le_compat_l _ _ _ E Hu). lia.
  Qed.

  (** *** Upper bounds *)

  Section Upper.
    Hypotheses (Hw : 0 <= w) (Hu : 0 <= u).
    Variable A : Type.
    Variables value upper : A -> Z.
    Variable mass : Z.
    Hypothesis Hmass : 0 <= mass.
    Hypothesis H : forall x, value x <= upper x * mass.

    Lemma Raise x (bound : Z) : upper x <= bound -> value x <= bound * mass.
    Proof.
      intros L. apply (Z.le_trans _ _ _ (H x)).
      apply Zmult_le_compat_r; assumption.
    Qed.

    Lemma FormMaxBound (bound : Z) : 0 <= bound ->
      forall d p, FormMax upper d p <= bound ->
        FormValue value w u d p <= bound * ((w + u) ^ Z.of_nat d * mass).
    Proof.
      intros Hb d; induction d as [|d IH]; intros p L.
      - cbn [FormValue FormUpper Z.of_nat]. rewrite Z.pow_0_r, Z.mul_1_l. apply Raise, L.
      - cbn [FormMax] in L. cbn [FormValue].
        assert (L0 := Raise (fst p) bound ltac:(lia)).
        specialize (IH (snd p) ltac:(lia)).
        assert (P : w ^ Z.of_nat (S d) <= w * (w + u) ^ Z.of_nat d).
        { rewrite PowS. apply Zmult_le_compat_l; [|assumption].
          apply Z.pow_le_mono_l. lia. }
        pose proof (PowNonNegative w (S d) Hw) as P0.
        rewrite PowS with (w := w + u).
        set (s := (w + u) ^ Z.of_nat d) in *.
        apply (ScaleLe (w ^ Z.of_nat (S d))) in L0; [|assumption].
        apply (ScaleLe (u)) in IH; [|assumption].
        assert (Q : 0 <= bound * mass) by (apply Z.mul_nonneg_nonneg; assumption).
        apply (ScaleLe (bound * mass)) in P; [|assumption].
        lia.
    Qed.

    Lemma FormUpperBound d p :
      FormValue value w u d p
        <= FormUpper upper d p * ((w + u) ^ Z.of_nat d * mass).
    Proof.
      destruct d as [|[|[|d]]].
      - cbn [FormValue FormUpper Z.of_nat]. rewrite Z.pow_0_r, Z.mul_1_l. apply H.
      - destruct p as [p0 p1]. cbn [FormValue FormUpper fst snd].
        change (Z.of_nat 1) with 1. rewrite !Z.pow_1_r.
        set (b := Z.max _ _).
        assert (L0 := Raise p0 b ltac:(lia)).
        assert (L1 := Raise p1 b ltac:(lia)).
        apply (ScaleLe w) in L0; [|assumption].
        apply (ScaleLe u) in L1; [|assumption].
        lia.
      - destruct p as [p0 [p1 p2]]. cbn [FormValue FormUpper fst snd].
        change (Z.of_nat 2) with 2. change (Z.of_nat 1) with 1.
        rewrite !Z.pow_1_r, !Z.pow_2_r.
        set (b := Z.max _ _).
        assert (K : upper p1 <= 2 * b).
        { assert (HalfUp (upper p1) <= b) by lia.
          unfold HalfUp in *.
          pose proof (Z.div_mod (upper p1 + 1) 2 ltac:(lia)).
          pose proof (Z.mod_pos_bound (upper p1 + 1) 2 ltac:(lia)).
          lia. }
        assert (L0 := Raise p0 b ltac:(lia)).
        assert (L1 := Raise p1 (2 * b) K).
        assert (L2 := Raise p2 b ltac:(lia)).
        apply (ScaleLe (w * w)) in L0;
          [|apply Z.mul_nonneg_nonneg; assumption].
        apply (ScaleLe (u * w)) in L1;
          [|apply Z.mul_nonneg_nonneg; assumption].
        apply (ScaleLe (u * u)) in L2;
          [|apply Z.mul_nonneg_nonneg; assumption].
        lia.
      - set (d' := S (S (S d))) in *. change (FormUpper upper d' p)
          with (Z.max 0 (FormMax upper d' p)).
        apply FormMaxBound; lia.
    Qed.
  End Upper.
End Forms.

(** ** Box forms *)

Definition NonNegative (weights : list (Z * Z)) : Prop :=
  Forall (fun wu => 0 <= fst wu /\ 0 <= snd wu) weights.

Lemma ValueAdd ds : forall weights x y,
  (length ds <= length weights)%nat ->
  Value ds weights (BoxAdd ds x y) = Value ds weights x + Value ds weights y.
Proof.
  induction ds as [|d ds IH]; intros [|[w u] weights] x y L; cbn in L; try lia;
    try reflexivity.
  cbn [Value BoxAdd]. apply FormValueAdd. intros. apply IH. lia.
Qed.

Lemma ValueOpp ds : forall weights x,
  (length ds <= length weights)%nat ->
  Value ds weights (BoxOpp ds x) = - Value ds weights x.
Proof.
  induction ds as [|d ds IH]; intros [|[w u] weights] x L; cbn in L; try lia;
    try reflexivity.
  cbn [Value BoxOpp].
  rewrite (FormValueMap w u (Value ds weights) (Value ds weights) _ (-1)).
  - ring.
  - intros y. rewrite IH by lia. ring.
Qed.

Lemma SumDegreesLength ds : forall es, length ds = length es ->
  length (SumDegrees ds es) = length ds.
Proof.
  induction ds as [|d ds IH]; intros [|e es] L; cbn in *; try lia.
  rewrite IH; lia.
Qed.

Lemma ValueMul ds : forall es weights x y,
  length ds = length es -> (length ds <= length weights)%nat ->
  Value (SumDegrees ds es) weights (BoxMul ds es x y)
  = Value ds weights x * Value es weights y.
Proof.
  induction ds as [|d ds IH]; intros [|e es] [|[w u] weights] x y E L;
    cbn in E, L; try lia; try reflexivity.
  cbn [Value BoxMul SumDegrees]. apply FormValueMul; intros.
  - apply IH; lia.
  - apply ValueAdd. rewrite SumDegreesLength; lia.
Qed.

Lemma ValueAtMost m n ds : forall es weights x y,
  NonNegative weights ->
  (length ds <= length weights)%nat -> length ds = length es ->
  AtMost m n ds es x y = true ->
  m * Value ds weights x <= n * Value es weights y.
Proof.
  induction ds as [|d ds IH]; intros [|e es] [|[w u] weights] x y P L E K;
    cbn in L, E; try lia; try discriminate K.
  - cbn in *. lia.
  - cbn in *. lia.
  - inversion_clear P as [|? ? [Hw Hu] P']. cbn in Hw, Hu.
    cbn [Value].
    apply (FormValueAtMost w u _ _ (AtMost m n ds es)); try assumption.
    intros. apply IH; try assumption; lia.
Qed.

Lemma MassNonNegative ds : forall weights,
  NonNegative weights -> 0 <= Mass ds weights.
Proof.
  induction ds as [|d ds IH]; intros [|[w u] weights] P; cbn; try lia.
  inversion_clear P as [|? ? [Hw Hu] P']. cbn in Hw, Hu.
  apply Z.mul_nonneg_nonneg; [|apply IH, P'].
  apply PowNonNegative. lia.
Qed.

Lemma UpperBound ds : forall weights x,
  NonNegative weights -> (length ds <= length weights)%nat ->
  Value ds weights x <= Upper ds x * Mass ds weights.
Proof.
  induction ds as [|d ds IH]; intros [|[w u] weights] x P L; cbn in L; try lia;
    try (cbn; lia).
  inversion_clear P as [|? ? [Hw Hu] P']. cbn in Hw, Hu.
  cbn [Value Upper Mass].
  apply FormUpperBound; try assumption.
  - apply MassNonNegative, P'.
  - intros y. apply IH; [assumption|lia].
Qed.

Lemma LowerBound ds weights x :
  NonNegative weights -> (length ds <= length weights)%nat ->
  Lower ds x * Mass ds weights <= Value ds weights x.
Proof.
  intros P L. unfold Lower.
  pose proof (UpperBound ds weights (BoxOpp ds x) P L) as U.
  rewrite ValueOpp in U by assumption. lia.
Qed.
