(** * Weights spread over vertices

    Two weighted tetrahedra are the same when each vertex weighs the same in
    both; and where a quantity balances, a vertex that is heavier on one side is
    made good by another that is lighter. *)

From Certet Require Import Embedding.Definitions.
Open Scope Z_scope.

Section Measure.
  Variable V : Type.
  Variable Same : forall u v : V, {u = v} + {u <> v}.

  (** One at [v], nothing elsewhere. *)
  Definition At (v u : V) : Z := if Same v u then 1 else 0.

  (** What [v] weighs. *)
  Definition WeightOf (w : Weights) (t : UnstructuredTet V) (v : V) : Z :=
    Weigh (At v) w t.

  Lemma WeightNonNegative w t v : NonNegative w -> 0 <= WeightOf w t v.
  Proof.
    destruct w as [a b c d], t as [p q r s]. unfold WeightOf, At.
    cbn [NonNegative Weigh].
    destruct (Same v p), (Same v q), (Same v r), (Same v s); lia.
  Qed.

  Lemma WeightyCorner w t v : 0 < WeightOf w t v -> In v (TetCorners t).
  Proof.
    destruct w as [a b c d], t as [p q r s]. unfold WeightOf, At.
    cbn [TetCorners In Weigh].
    destruct (Same v p), (Same v q), (Same v r), (Same v s); subst; auto; lia.
  Qed.

  (** ** Sums over lists *)

  Fixpoint SumOver (vs : list V) (f : V -> Z) : Z :=
    match vs with [] => 0 | v :: vs => f v + SumOver vs f end.

  Lemma SumZero vs f : (forall v, In v vs -> f v = 0) -> SumOver vs f = 0.
  Proof.
    induction vs as [|v vs IH]; cbn [SumOver In]; intros H; [reflexivity|].
    rewrite IH, H; auto.
  Qed.

  Lemma SumLe vs f h :
    (forall v, In v vs -> f v <= h v) -> SumOver vs f <= SumOver vs h.
  Proof.
    induction vs as [|v vs IH]; cbn [SumOver In]; intros H; [lia|].
    apply Z.add_le_mono; auto.
  Qed.

  Lemma SumLess vs f h u : In u vs -> f u < h u ->
    (forall v, In v vs -> f v <= h v) -> SumOver vs f < SumOver vs h.
  Proof.
    induction vs as [|v vs IH]; cbn [SumOver In]; [intros []|]. intros [->|I] L H.
    - apply Z.add_lt_le_mono; [exact L|apply SumLe; auto].
    - apply Z.add_le_lt_mono; auto.
  Qed.

  Lemma SumAt vs g k u : NoDup vs -> In u vs ->
    SumOver vs (fun v => g v * (k * At v u)) = k * g u.
  Proof.
    induction 1 as [|v vs N _ IH]; [intros []|]. cbn [SumOver In]. intros [->|I].
    - rewrite SumZero.
      + unfold At. destruct (Same u u); [ring|congruence].
      + intros v I. unfold At. destruct (Same v u); [congruence|ring].
    - rewrite IH by exact I.
      unfold At. destruct (Same v u); [congruence|ring].
  Qed.

  Lemma SumAdd vs f h :
    SumOver vs (fun v => f v + h v) = SumOver vs f + SumOver vs h.
  Proof. induction vs as [|v vs IH]; cbn [SumOver]; [|rewrite IH]; lia. Qed.

  Lemma SumExt vs f h : (forall v, f v = h v) -> SumOver vs f = SumOver vs h.
  Proof.
    intros E. induction vs as [|v vs IH]; cbn [SumOver]; [|rewrite IH, E]; auto.
  Qed.

  (** A quantity by the vertices that are there. *)
  Lemma Expand vs g w t : NoDup vs -> incl (TetCorners t) vs ->
    Weigh g w t = SumOver vs (fun v => g v * WeightOf w t v).
  Proof.
    intros N I. destruct w as [a b c d], t as [p q r s].
    assert (E : forall v, g v * WeightOf (UT _ a b c d) (UT _ p q r s) v
      = g v * (a * At v p) + g v * (b * At v q) + g v * (c * At v r)
        + g v * (d * At v s))
      by (intros v; unfold WeightOf; cbn [Weigh]; ring).
    transitivity (SumOver vs (fun v => g v * (a * At v p) + g v * (b * At v q)
      + g v * (c * At v r) + g v * (d * At v s))).
    - rewrite !SumAdd, !SumAt; [reflexivity|assumption|..];
        first [assumption | apply I; cbn; tauto].
    - apply SumExt. intros v. symmetry. apply E.
  Qed.

  (** ** Two weighted tetrahedra *)

  Section Two.
    Variables (w : Weights) (t : UnstructuredTet V).
    Variables (w' : Weights) (t' : UnstructuredTet V).

    Let all := nodup Same (TetCorners t ++ TetCorners t').

    Lemma ExpandBoth g :
      Weigh g w t = SumOver all (fun v => g v * WeightOf w t v) /\
      Weigh g w' t' = SumOver all (fun v => g v * WeightOf w' t' v).
    Proof.
      split; apply Expand; try apply NoDup_nodup;
        intros v I; apply nodup_In, in_or_app; auto.
    Qed.

    Lemma EqualWeights :
      (forall v, WeightOf w t v = WeightOf w' t' v) -> SameWeights w t w' t'.
    Proof.
      intros E g. destruct (ExpandBoth g) as [-> ->].
      apply SumExt. intros v. rewrite E. reflexivity.
    Qed.

    Lemma Balance g u : NonNegative w ->
      Weigh g w t = Weigh g w' t' ->
      (forall v, In v (TetCorners t) \/ In v (TetCorners t') -> 0 <= g v) ->
      0 < g u -> WeightOf w t u < WeightOf w' t' u ->
      exists v, 0 < g v /\ WeightOf w' t' v < WeightOf w t v.
    Proof.
      intros W E P U L. destruct (ExpandBoth g) as [A B]. rewrite A, B in E.
      destruct (existsb (fun v =>
        (0 <? g v) && (WeightOf w' t' v <? WeightOf w t v)) all) eqn:X.
      - apply existsb_exists in X. destruct X as (v & _ & X).
        apply andb_prop in X. destruct X as [X Y].
        apply Z.ltb_lt in X. apply Z.ltb_lt in Y. eauto.
      - exfalso. revert E. apply Z.lt_neq, SumLess with u.
        + apply nodup_In, in_or_app. right. apply (WeightyCorner w').
          pose proof (WeightNonNegative w t u W). lia.
        + apply Z.mul_lt_mono_pos_l; assumption.
        + intros v I. unfold all in I.
          assert (G : 0 <= g v) by (apply P, in_app_or, (nodup_In Same); exact I).
          destruct (Z.ltb_spec (WeightOf w' t' v) (WeightOf w t v)) as [H|H];
            [|apply Z.mul_le_mono_nonneg_l; assumption].
          destruct (Z.ltb_spec 0 (g v)) as [H'|H'];
            [|replace (g v) with 0 by lia; lia].
          exfalso. enough (true = false) by discriminate. rewrite <- X.
          symmetry. apply existsb_exists. exists v. split; [exact I|].
          apply andb_true_intro. split; apply Z.ltb_lt; assumption.
    Qed.
  End Two.
End Measure.

Arguments At {V}.
Arguments WeightOf {V}.
