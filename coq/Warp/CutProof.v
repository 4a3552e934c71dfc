(** * Bisection finds the surface: proofs *)

From Certet Require Import Warp.Definitions.
Open Scope Z_scope.

Lemma HalfTwice r : 2 ^ Z.of_nat (S r) = 2 * 2 ^ Z.of_nat r.
Proof. rewrite Nat2Z.inj_succ, Z.pow_succ_r; lia. Qed.

Lemma HalfPositive r : 0 < 2 ^ Z.of_nat r.
Proof. apply Z.pow_pos_nonneg; lia. Qed.

Theorem BisectFromFinds : forall sign rounds lo,
  let t := BisectFrom sign rounds lo in
  let hi := lo + 2 ^ Z.of_nat rounds in
  lo <= t < hi /\
  (sign t = OnSurface \/
   (t = lo \/ sign t = Plus) /\ (t + 1 = hi \/ sign (t + 1) = Minus)).
Proof.
  intros sign rounds; induction rounds as [|r IH]; intros lo.
  - cbn. lia.
  - cbn [BisectFrom]. cbv zeta in *. rewrite HalfTwice.
    pose proof (HalfPositive r).
    set (middle := lo + 2 ^ Z.of_nat r) in *.
    replace (lo + 2 * 2 ^ Z.of_nat r) with (middle + 2 ^ Z.of_nat r)
      by (unfold middle; lia).
    destruct (sign middle) eqn:S.
    + destruct (IH middle) as [B F]. split; [lia|].
      destruct F as [F | [[-> | F] G]]; auto.
    + split; [lia | auto].
    + destruct (IH lo) as [B F]. fold middle in B, F. split; [lia|].
      destruct F as [F | [F [-> | G]]]; auto.
Qed.

(** [StepBits] stays a name: sixteen rounds written out are 65,536 cases. *)
Theorem BisectFinds : forall sign,
  sign 0 = Plus -> sign Steps = Minus ->
  let t := Bisect sign in
  sign t = OnSurface \/ sign t = Plus /\ sign (t + 1) = Minus.
Proof.
  unfold Bisect, Steps. generalize StepBits. intros rounds sign inner outer.
  destruct (BisectFromFinds sign rounds 0) as [_ F].
  cbv zeta in *. rewrite Z.add_0_l in F.
  destruct F as [F | [[-> | F] [G | G]]]; rewrite ?G in *; auto.
Qed.

(** The start is the answer if everything looked at is outside. *)
Lemma BisectFromStart sign rounds lo :
  BisectFrom sign rounds lo = lo <->
  forall k, (k < rounds)%nat -> sign (lo + 2 ^ Z.of_nat k) = Minus.
Proof.
  induction rounds as [|r IH]; cbn [BisectFrom]; cbv zeta.
  - split; [lia | reflexivity].
  - pose proof (HalfPositive r).
    pose proof (BisectFromFinds sign r (lo + 2 ^ Z.of_nat r)) as [B _].
    destruct (sign (lo + 2 ^ Z.of_nat r)) eqn:S.
    + split; [lia|]. intros all. rewrite all in S by lia. discriminate S.
    + split; [lia|]. intros all. rewrite all in S by lia. discriminate S.
    + rewrite IH. split; intros all k K; [|apply all; lia].
      destruct (Nat.eq_dec k r) as [-> | N]; [exact S | apply all; lia].
Qed.

Theorem BisectOnEdge : forall sign,
  0 <= Bisect sign < Steps /\
  (Bisect sign = 0 <->
   forall k, (k < StepBits)%nat -> sign (2 ^ Z.of_nat k) = Minus).
Proof.
  unfold Bisect, Steps. generalize StepBits. intros rounds sign. split.
  - exact (proj1 (BisectFromFinds sign rounds 0)).
  - rewrite BisectFromStart.
    split; intros all k K; specialize (all k K); rewrite Z.add_0_l in *; exact all.
Qed.
