(** * Sums over all ways to round

    A function [g] of four integers is extended to fractions of [n] by taking
    the mean over [n] ways to round, each integer by itself.  The mean is
    [Mix n g] over [n].  What [g] promises its mean keeps: if [g] does not see
    that one is added to all four, no more does [Mix n g]; if [g] rises in two
    of the four and falls in two, so does [Mix n g].  Three functions that rise
    in different pairs then tell all four integers, but for a common number. *)

From Coq Require Import ZArith Lia.
Open Scope Z_scope.

(** The sum over [j = 0 .. n - 1]. *)
Fixpoint Sum (n : nat) (f : Z -> Z) : Z :=
  match n with O => 0 | S k => Sum k f + f (Z.of_nat k) end.

Definition Mix (n : nat) (g : Z -> Z -> Z -> Z -> Z) (p q r s : Z) : Z :=
  Sum n (fun j =>
    let round y := (y + j) / Z.of_nat n in
    g (round p) (round q) (round r) (round s)).

(** ** Sums *)

Lemma SumExt n f h :
  (forall j, 0 <= j < Z.of_nat n -> f j = h j) -> Sum n f = Sum n h.
Proof.
  induction n as [|n IH]; intros E; cbn [Sum]; [reflexivity|].
  rewrite IH, E; [reflexivity|lia|]. intros j J. apply E. lia.
Qed.

Lemma SumLe n f h :
  (forall j, 0 <= j < Z.of_nat n -> f j <= h j) -> Sum n f <= Sum n h.
Proof.
  induction n as [|n IH]; intros L; cbn [Sum]; [lia|].
  apply Z.add_le_mono; [apply IH; intros j J|]; apply L; lia.
Qed.

Lemma SumPlus n f h : Sum n (fun j => f j + h j) = Sum n f + Sum n h.
Proof. induction n as [|n IH]; cbn [Sum]; [|rewrite IH]; lia. Qed.

Lemma SumMinus n f h : Sum n (fun j => f j - h j) = Sum n f - Sum n h.
Proof. induction n as [|n IH]; cbn [Sum]; [|rewrite IH]; lia. Qed.

Lemma SumShift n f :
  Sum n (fun j => f (j + 1)) = Sum n f + f (Z.of_nat n) - f 0.
Proof.
  induction n as [|n IH]; cbn [Sum]; [cbn; lia|].
  rewrite IH, Nat2Z.inj_succ, <- Z.add_1_r. lia.
Qed.

Lemma SumSplit m n f :
  Sum (n + m) f = Sum n f + Sum m (fun j => f (Z.of_nat n + j)).
Proof.
  induction m as [|m IH]; cbn [Sum].
  - rewrite Nat.add_0_r. lia.
  - rewrite Nat.add_succ_r. cbn [Sum]. rewrite IH, Nat2Z.inj_add. lia.
Qed.

Lemma SumConstant n f x :
  (forall j, 0 <= j < Z.of_nat n -> f j = x) -> Sum n f = Z.of_nat n * x.
Proof.
  intros E. rewrite (SumExt n f (fun _ => x) E). clear E.
  induction n as [|n IH]; cbn [Sum]; [lia|].
  rewrite IH, Nat2Z.inj_succ, Z.mul_succ_l. reflexivity.
Qed.

(** ** One added to all four *)

Lemma RoundNext n y : (0 < n)%nat ->
  (y + Z.of_nat n) / Z.of_nat n = (y + 0) / Z.of_nat n + 1.
Proof.
  intros N. rewrite Z.add_0_r.
  replace (y + Z.of_nat n) with (y + 1 * Z.of_nat n) by lia.
  rewrite Z.div_add; lia.
Qed.

Definition Turns (g : Z -> Z -> Z -> Z -> Z) : Prop :=
  forall p q r s, g (p + 1) (q + 1) (r + 1) (s + 1) = g p q r s.

Lemma Constant (f : Z -> Z) : (forall x, f (x + 1) = f x) -> forall c, f c = f 0.
Proof.
  intros F. apply Z.bi_induction; [intros x y ->; reflexivity|reflexivity|].
  intros c. rewrite <- Z.add_1_r, F. reflexivity.
Qed.

Lemma MixTurns n g c p q r s : Turns g ->
  Mix n g (p + c) (q + c) (r + c) (s + c) = Mix n g p q r s.
Proof.
  intros T. transitivity (Mix n g (p + 0) (q + 0) (r + 0) (s + 0));
    [|rewrite !Z.add_0_r; reflexivity].
  apply (Constant (fun c => Mix n g (p + c) (q + c) (r + c) (s + c))).
  clear c. intros c. unfold Mix. cbv zeta.
  destruct n as [|n]; [reflexivity|].
  pose proof (SumShift (S n) (fun j =>
    let round y := (y + j) / Z.of_nat (S n) in
    g (round (p + c)) (round (q + c)) (round (r + c)) (round (s + c)))) as H.
  cbv beta zeta in H. rewrite !RoundNext, T in H by lia.
  rewrite Z.add_simpl_r in H. rewrite <- H. apply SumExt. intros j _.
  rewrite !(Z.add_comm j 1), !Z.add_assoc. reflexivity.
Qed.

(** ** Two rise, two fall *)

Definition Rises (g : Z -> Z -> Z -> Z -> Z) : Prop :=
  forall p q r s,
    g p q r s < g (p + 1) q r s /\ g p q r s < g p (q + 1) r s /\
    g p q (r + 1) s < g p q r s /\ g p q r (s + 1) < g p q r s.

Lemma Grows (f : Z -> Z) : (forall x, f x < f (x + 1)) ->
  forall x y, x <= y -> f x + (y - x) <= f y.
Proof.
  intros F x y L. replace y with (x + (y - x)) by lia.
  set (d := y - x). assert (D : 0 <= d) by (unfold d; lia). clearbody d.
  revert d D. apply natlike_ind.
  - rewrite Z.add_0_r. lia.
  - intros d D IH. rewrite <- Z.add_1_r. specialize (F (x + d)).
    rewrite Z.add_assoc. lia.
Qed.

Lemma RisesFar g p q r s p' q' r' s' : Rises g ->
  p <= p' -> q <= q' -> r' <= r -> s' <= s ->
  g p q r s + ((p' - p) + (q' - q) + (r - r') + (s - s')) <= g p' q' r' s'.
Proof.
  intros G P Q R S.
  pose proof (Grows (fun x => g x q r s) (fun x => proj1 (G x q r s)) p p' P).
  pose proof (Grows (fun x => g p' x r s)
    (fun x => proj1 (proj2 (G p' x r s))) q q' Q).
  pose proof (Grows (fun x => - g p' q' x s)
    (fun x => proj1 (Z.opp_lt_mono _ _) (proj1 (proj2 (proj2 (G p' q' x s)))))
    r' r R).
  pose proof (Grows (fun x => - g p' q' r' x)
    (fun x => proj1 (Z.opp_lt_mono _ _) (proj2 (proj2 (proj2 (G p' q' r' x)))))
    s' s S).
  cbv beta in *. lia.
Qed.

(** Hermite's identity. *)
Lemma SumOfRounded n y : (0 < n)%nat -> Sum n (fun j => (y + j) / Z.of_nat n) = y.
Proof.
  intros N.
  enough (E : forall x, Sum n (fun j => (x + j) / Z.of_nat n) - x
    = Sum n (fun j => (0 + j) / Z.of_nat n) - 0).
  { specialize (E y).
    rewrite (SumConstant n (fun j => (0 + j) / Z.of_nat n) 0) in E; [lia|].
    intros j J. apply Z.div_small. lia. }
  apply (Constant (fun x => Sum n (fun j => (x + j) / Z.of_nat n) - x)).
  intros x. pose proof (SumShift n (fun j => (x + j) / Z.of_nat n)) as H.
  cbv beta in H. rewrite RoundNext in H by exact N.
  rewrite (SumExt n (fun j => (x + 1 + j) / Z.of_nat n)
    (fun j => (x + (j + 1)) / Z.of_nat n)); [lia|].
  intros j _. f_equal. lia.
Qed.

Lemma MixRises n g p q r s p' q' r' s' : (0 < n)%nat -> Rises g ->
  p <= p' -> q <= q' -> r' <= r -> s' <= s ->
  Mix n g p q r s + ((p' - p) + (q' - q) + (r - r') + (s - s'))
    <= Mix n g p' q' r' s'.
Proof.
  intros N G P Q R S. unfold Mix.
  set (round y j := (y + j) / Z.of_nat n).
  pose proof (SumLe n
    (fun j => g (round p j) (round q j) (round r j) (round s j)
      + ((round p' j - round p j) + (round q' j - round q j)
         + (round r j - round r' j) + (round s j - round s' j)))
    (fun j => g (round p' j) (round q' j) (round r' j) (round s' j))) as H.
  cbv beta in H. rewrite !SumPlus, !SumMinus in H.
  unfold round in H. rewrite !(SumOfRounded n _ N) in H. apply H.
  intros j _. apply RisesFar; [exact G|..]; apply Z.div_le_mono; lia.
Qed.

(** ** Three pairings tell the four integers *)

(** Of two ordered pairs one is above the other, or they interlock. *)
Lemma OrderedPairs a b c d : a <= b -> c <= d -> exists m,
  (m <= a /\ d <= m) \/ (b <= m /\ m <= c) \/
  (a <= m /\ c <= m /\ m <= b /\ m <= d).
Proof.
  intros L M. destruct (Z_le_gt_dec d a); [exists a; lia|].
  destruct (Z_le_gt_dec b c); [exists c; lia|]. exists (Z.max a c). lia.
Qed.

(** Of four numbers two are at least as great as the other two. *)
Lemma GreaterPair a b c d : exists m,
  (m <= a /\ m <= b /\ c <= m /\ d <= m) \/
  (a <= m /\ b <= m /\ m <= c /\ m <= d) \/
  (m <= a /\ m <= c /\ b <= m /\ d <= m) \/
  (a <= m /\ c <= m /\ m <= b /\ m <= d) \/
  (m <= a /\ m <= d /\ b <= m /\ c <= m) \/
  (a <= m /\ d <= m /\ m <= b /\ m <= c).
Proof.
  destruct (Z_le_gt_dec a b), (Z_le_gt_dec c d);
    [destruct (OrderedPairs a b c d) as (m & [H|[H|H]])
    |destruct (OrderedPairs a b d c) as (m & [H|[H|H]])
    |destruct (OrderedPairs b a c d) as (m & [H|[H|H]])
    |destruct (OrderedPairs b a d c) as (m & [H|[H|H]])]; try lia; exists m.
  all: first [left; lia | right; left; lia | right; right; left; lia
             |right; right; right; left; lia
             |right; right; right; right; left; lia
             |right; right; right; right; right; lia].
Qed.

Lemma MixInjective n gx gy gz p q r s p' q' r' s' : (0 < n)%nat ->
  Turns gx -> Turns gy -> Turns gz ->
  Rises gx ->
  Rises (fun p r q s => gy p q r s) -> Rises (fun p s q r => gz p q r s) ->
  Mix n gx p q r s = Mix n gx p' q' r' s' ->
  Mix n gy p q r s = Mix n gy p' q' r' s' ->
  Mix n gz p q r s = Mix n gz p' q' r' s' ->
  exists c, p' = p + c /\ q' = q + c /\ r' = r + c /\ s' = s + c.
Proof.
  intros N Tx Ty Tz Rx Ry Rz Ex Ey Ez.
  destruct (GreaterPair (p' - p) (q' - q) (r' - r) (s' - s)) as (c & C). exists c.
  rewrite <- (MixTurns n gx c) in Ex by exact Tx.
  rewrite <- (MixTurns n gy c) in Ey by exact Ty.
  rewrite <- (MixTurns n gz c) in Ez by exact Tz.
  destruct C as [C|[C|[C|[C|[C|C]]]]].
  - pose proof (MixRises n gx (p + c) (q + c) (r + c) (s + c) p' q' r' s' N Rx). lia.
  - pose proof (MixRises n gx p' q' r' s' (p + c) (q + c) (r + c) (s + c) N Rx). lia.
  - pose proof (MixRises n _ (p + c) (r + c) (q + c) (s + c) p' r' q' s' N Ry) as H.
    unfold Mix in *. lia.
  - pose proof (MixRises n _ p' r' q' s' (p + c) (r + c) (q + c) (s + c) N Ry) as H.
    unfold Mix in *. lia.
  - pose proof (MixRises n _ (p + c) (s + c) (q + c) (r + c) p' s' q' r' N Rz) as H.
    unfold Mix in *. lia.
  - pose proof (MixRises n _ p' s' q' r' (p + c) (s + c) (q + c) (r + c) N Rz) as H.
    unfold Mix in *. lia.
Qed.

(** ** A chain of four points *)

(** From one point to the next one of the first three integers rises by one. *)
Lemma MixChain (g : Z -> Z -> Z -> Z -> Z) (k0 k1 k2 k3 : nat) p q r s :
  let n := (k0 + k1 + k2 + k3)%nat in
  let N := Z.of_nat n in
  Mix n g (N * p + Z.of_nat (k1 + k2 + k3)) (N * q + Z.of_nat (k2 + k3))
    (N * r + Z.of_nat k3) (N * s)
  = Z.of_nat k0 * g p q r s
    + Z.of_nat k1 * g (p + 1) q r s
    + Z.of_nat k2 * g (p + 1) (q + 1) r s
    + Z.of_nat k3 * g (p + 1) (q + 1) (r + 1) s.
Proof.
  intros n N.
  assert (Stay : forall y a, 0 <= a < N -> (N * y + a) / N = y).
  { intros y a A. symmetry. apply Z.div_unique with a; lia. }
  assert (Rise : forall y a, N <= a < 2 * N -> (N * y + a) / N = y + 1).
  { intros y a A. symmetry. apply Z.div_unique with (a - N); lia. }
  unfold Mix. unfold n at 1. fold N. rewrite !SumSplit.
  f_equal; [f_equal; [f_equal|]|]; apply SumConstant; intros j J; cbv beta zeta;
    rewrite <- ?Z.add_assoc; f_equal;
    first [apply Stay | apply Rise]; unfold N, n; lia.
Qed.
