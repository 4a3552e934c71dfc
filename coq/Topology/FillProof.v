(** * One structured tetrahedron is filled from both sides, on symbols

    A point of it is a mean of its corners.  Along the edges from + to -, one after
    the other in the order of [EdgeRank], move weight from both ends to the cut, as
    much as there is.  Then no + and - corner both keep something, and what carries
    weight fits one tetrahedron of the stencils, or of those for the other side. *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stencil.TriangleChecker Embedding.Measure
  Embedding.EdgeRank Topology.StencilSurface Topology.CornersProof.
Open Scope Z_scope.

Lemma SameSym (s r : Symbol) : {s = r} + {s <> r}.
Proof. decide equality; decide equality. Qed.

Lemma SymbolsOnce : NoDup AllSymbols.
Proof.
  unfold AllSymbols. cbn. repeat constructor; cbn [In]; intuition discriminate.
Qed.

(** ** What may carry weight in the end *)

Definition Without (s : Symbol) (symbols : list Symbol) : list Symbol :=
  filter (fun r => negb (SameSymbol s r)) symbols.

Fixpoint Outcomes (edges : list (Label * Label)) (carriers : list Symbol)
  : list (list Symbol) :=
  match edges with
  | [] => [carriers]
  | (p, m) :: rest =>
      if Member (Base p) carriers && Member (Base m) carriers then
        Outcomes rest (CutOf p m :: Without (Base p) carriers) ++
        Outcomes rest (CutOf p m :: Without (Base m) carriers)
      else Outcomes rest carriers
  end.

Definition RankedEdges : list (Label * Label) :=
  [(F1, F2); (F2, F1); (F3, P); (P, F3);
   (F1, P); (P, F1); (F2, F3); (F3, F2);
   (F1, F3); (F3, F1); (F2, P); (P, F2)].

Definition SwapCut (s : Symbol) : Symbol :=
  match s with Base l => Base l | CutOf a m => CutOf m a end.

Section Signs.
  Variable sign : Label -> Sign.

  Definition CutEdges : list (Label * Label) :=
    filter (fun '(p, m) => Is sign Plus p && Is sign Minus m) RankedEdges.

  Definition Inner : list SymbolicTet :=
    SymbolicTets GetUnstructuredTets sign F1 F2 F3 P.
  Definition Outer : list SymbolicTet :=
    map (MapTet SwapCut)
      (SymbolicTets GetUnstructuredTets (fun l => Negate (sign l)) F1 F2 F3 P).
  Definition Dropped : list SymbolicTet :=
    if forallb (Is sign OnSurface) Four
    then [UT _ (Base F1) (Base F2) (Base F3) (Base P)] else [].

  Definition Proper (t : SymbolicTet) : bool :=
    match t with
      UT _ a b c d =>
        negb (SameSymbol a b || SameSymbol a c || SameSymbol a d ||
              SameSymbol b c || SameSymbol b d || SameSymbol c d) &&
        forallb (fun s => Member s AllSymbols) [a; b; c; d]
    end.

  Definition CheckFills : bool :=
    forallb (fun carriers => existsb (fun t =>
      Proper t && forallb (fun s => Member s (TetCorners t)) carriers)
      (Inner ++ Outer ++ Dropped)) (Outcomes CutEdges (map Base Four)).
End Signs.

Lemma FillsChecked : ForAllSignAssignments CheckFills = true.
Proof. vm_compute. reflexivity. Qed.

(** ** Moving weight *)

Section Fill.
  Variable sign : Label -> Sign.
  Variables (steps : Z) (cut : Label -> Label -> Z).

  Definition IsEdge (p m : Label) : Prop :=
    In p Four /\ In m Four /\ sign p = Plus /\ sign m = Minus.

  Hypothesis Inside : forall p m, IsEdge p m -> 0 < cut p m < steps.

  (** A quantity that is straight along the edges. *)
  Definition StraightOn (value : Symbol -> Z) : Prop :=
    forall p m, IsEdge p m ->
      steps * value (CutOf p m)
      = (steps - cut p m) * value (Base p) + cut p m * value (Base m).

  Local Notation sum := (SumOver Symbol AllSymbols).
  Local Notation at_ := (At SameSym).

  Definition Weighed (value weight : Symbol -> Z) : Z :=
    sum (fun s => value s * weight s).

  (** [weight'] is [weight], moved, many times over. *)
  Definition Moved (weight weight' : Symbol -> Z) : Prop :=
    (forall s, 0 <= weight' s) /\
    exists times, 0 < times /\ forall value, StraightOn value ->
      Weighed value weight' = times * Weighed value weight.

  Definition Carried (carriers : list Symbol) (weight : Symbol -> Z) : Prop :=
    forall s, ~ In s carriers -> weight s = 0.

  Lemma SumTimes k f : sum (fun s => k * f s) = k * sum f.
  Proof.
    induction AllSymbols as [|s ss IH]; cbn [SumOver]; [ring|]. rewrite IH. ring.
  Qed.

  Lemma InWithout s r carriers : In r (Without s carriers) <-> In r carriers /\ r <> s.
  Proof.
    unfold Without. rewrite filter_In, negb_true_iff, <- not_true_iff_false,
      SameSymbolEqual. intuition congruence.
  Qed.

  Lemma FillEdge weight carriers p m : IsEdge p m ->
    (forall s, 0 <= weight s) -> Carried carriers weight ->
    exists weight', Moved weight weight' /\
      (Carried (CutOf p m :: Without (Base p) carriers) weight' \/
       Carried (CutOf p m :: Without (Base m) carriers) weight').
  Proof.
    intros Edge N C. pose proof (Inside p m Edge) as B.
    pose proof Edge as (Ip & Im & Sp & Sm). assert (Npm : p <> m) by congruence.
    set (o := cut p m) in *. set (x := weight (Base p)). set (y := weight (Base m)).
    set (j := Z.min (o * x) ((steps - o) * y)).
    pose proof (N (Base p)) as X. pose proof (N (Base m)) as Y. fold x in X. fold y in Y.
    assert (J : 0 <= j) by (unfold j; nia).
    set (weight' s := (steps - o) * o * weight s
      + (- ((steps - o) * j)) * at_ s (Base p)
      + (- (o * j)) * at_ s (Base m) + (steps * j) * at_ s (CutOf p m)).
    exists weight'.
    assert (V : forall s, s <> Base p -> s <> Base m -> s <> CutOf p m ->
      at_ s (Base p) = 0 /\ at_ s (Base m) = 0 /\ at_ s (CutOf p m) = 0).
    { intros s A A' A''. unfold At. destruct (SameSym s (Base p)), (SameSym s (Base m)),
        (SameSym s (CutOf p m)); try congruence. auto. }
    assert (Vp : at_ (Base p) (Base p) = 1 /\ at_ (Base p) (Base m) = 0 /\
      at_ (Base p) (CutOf p m) = 0).
    { unfold At. destruct (SameSym (Base p) (Base p)), (SameSym (Base p) (Base m)),
        (SameSym (Base p) (CutOf p m)); try congruence. auto. }
    assert (Vm : at_ (Base m) (Base p) = 0 /\ at_ (Base m) (Base m) = 1 /\
      at_ (Base m) (CutOf p m) = 0).
    { unfold At. destruct (SameSym (Base m) (Base p)), (SameSym (Base m) (Base m)),
        (SameSym (Base m) (CutOf p m)); try congruence. auto. }
    assert (Vc : at_ (CutOf p m) (Base p) = 0 /\ at_ (CutOf p m) (Base m) = 0 /\
      at_ (CutOf p m) (CutOf p m) = 1).
    { unfold At. destruct (SameSym (CutOf p m) (Base p)), (SameSym (CutOf p m) (Base m)),
        (SameSym (CutOf p m) (CutOf p m)); try congruence. auto. }
    split; [split|].
    - intros s. unfold weight'.
      assert (Ns : 0 <= (steps - o) * o * weight s).
      { apply Z.mul_nonneg_nonneg; [|apply N]. apply Z.mul_nonneg_nonneg; lia. }
      destruct (SameSym s (Base p)) as [->|Np].
      { destruct Vp as (-> & -> & ->). fold x. clear Ns. unfold j in *. nia. }
      destruct (SameSym s (Base m)) as [->|Nm].
      { destruct Vm as (-> & -> & ->). fold y. clear Ns. unfold j in *. nia. }
      destruct (SameSym s (CutOf p m)) as [->|Nc].
      { destruct Vc as (-> & -> & ->).
        assert (0 <= steps * j) by (apply Z.mul_nonneg_nonneg; lia). lia. }
      destruct (V s Np Nm Nc) as (-> & -> & ->). lia.
    - exists ((steps - o) * o). split; [nia|]. intros value St.
      assert (In_ : In (Base p) AllSymbols /\ In (Base m) AllSymbols /\
        In (CutOf p m) AllSymbols).
      { unfold AllSymbols. rewrite !in_app_iff. split; [left; apply in_map, Ip|].
        split; [left; apply in_map, Im|]. right. apply in_map_iff. exists (p, m).
        split; [reflexivity|apply in_prod; assumption]. }
      destruct In_ as (Bp & Bm & Bc). unfold Weighed, weight'.
      transitivity (sum (fun s => (steps - o) * o * (value s * weight s)
        + value s * ((- ((steps - o) * j)) * at_ s (Base p))
        + value s * ((- (o * j)) * at_ s (Base m))
        + value s * ((steps * j) * at_ s (CutOf p m)))).
      { apply SumExt. intros s. ring. }
      rewrite !SumAdd, SumTimes, !SumAt by (assumption || apply SymbolsOnce).
      pose proof (St p m Edge) as E. fold o in E.
      replace (steps * j * value (CutOf p m)) with (j * (steps * value (CutOf p m))) by ring.
      rewrite E. ring.
    - assert (Gone : forall e, weight' e = 0 ->
        Carried (CutOf p m :: Without e carriers) weight').
      { intros e E s O. cbn [In] in O. rewrite InWithout in O.
        destruct (SameSym s e) as [->|Ne]; [exact E|].
        assert (Z0 : weight s = 0) by (apply C; tauto).
        destruct (SameSym s (CutOf p m)) as [->|Nc]; [tauto|].
        unfold weight'. rewrite Z0.
        destruct (SameSym s (Base p)) as [->|Np].
        { destruct Vp as (-> & -> & ->). fold x in Z0. assert (j = 0) by (unfold j; nia). nia. }
        destruct (SameSym s (Base m)) as [->|Nm].
        { destruct Vm as (-> & -> & ->). fold y in Z0. assert (j = 0) by (unfold j; nia). nia. }
        destruct (V s Np Nm Nc) as (-> & -> & ->). ring. }
      destruct (Z.le_ge_cases (o * x) ((steps - o) * y)) as [L|L]; [left|right];
        apply Gone; unfold weight'.
      + destruct Vp as (-> & -> & ->). fold x.
        assert (j = o * x) as -> by (unfold j; lia). ring.
      + destruct Vm as (-> & -> & ->). fold y.
        assert (j = (steps - o) * y) as -> by (unfold j; lia). ring.
  Qed.

  Lemma MovedThen a b c : Moved a b -> Moved b c -> Moved a c.
  Proof.
    intros [_ (k & K & E)] [N (l & L & F)]. split; [exact N|].
    exists (l * k). split; [lia|]. intros value S.
    rewrite (F value S), (E value S). ring.
  Qed.

  Lemma FillAll edges : forall weight carriers,
    (forall p m, In (p, m) edges -> IsEdge p m) ->
    (forall s, 0 <= weight s) -> Carried carriers weight ->
    exists weight' carriers', Moved weight weight' /\ Carried carriers' weight' /\
      In carriers' (Outcomes edges carriers).
  Proof.
    induction edges as [|[p m] edges IH]; intros weight carriers E N C; cbn [Outcomes].
    - exists weight, carriers. split; [|split; [exact C|left; reflexivity]].
      split; [exact N|]. exists 1. split; [lia|]. intros. ring.
    - assert (E' : forall q n, In (q, n) edges -> IsEdge q n)
        by (intros q n I; apply E; right; exact I).
      destruct (Member (Base p) carriers && Member (Base m) carriers).
      + destruct (FillEdge weight carriers p m (E p m (or_introl eq_refl)) N C)
          as (weight1 & M & [C1|C1]);
          destruct (IH weight1 _ E' (proj1 M) C1) as (weight2 & carriers2 & M2 & C2 & I2);
          exists weight2, carriers2; split; try exact (MovedThen _ _ _ M M2);
          (split; [exact C2|apply in_or_app; auto]).
      + exact (IH weight carriers E' N C).
  Qed.

  (** ** One tetrahedron *)

  Definition CornerWeights (weight : Symbol -> Z) (t : SymbolicTet) : Weights :=
    match t with UT _ a b c d => UT _ (weight a) (weight b) (weight c) (weight d) end.

  Lemma ProperMeans t : Proper t = true ->
    NoDup (TetCorners t) /\ incl (TetCorners t) AllSymbols.
  Proof.
    destruct t as [a b c d]. unfold Proper.
    rewrite andb_true_iff, negb_true_iff, !orb_false_iff, forallb_forall.
    intros [D M].
    assert (Ne : forall s r, SameSymbol s r = false -> s <> r)
      by (intros s r F; rewrite <- SameSymbolEqual, F; discriminate).
    destruct D as (((((Ab & Ac) & Ad) & Bc) & Bd) & Cd).
    apply Ne in Ab, Ac, Ad, Bc, Bd, Cd. split.
    - apply FourApart. auto 8.
    - intros s I. apply MemberIn, M, I.
  Qed.

  Lemma WeighedByTet value weight t : Proper t = true ->
    Carried (TetCorners t) weight ->
    Weigh value (CornerWeights weight t) t = Weighed value weight.
  Proof.
    intros R C. destruct (ProperMeans t R) as [N I].
    rewrite (Expand Symbol SameSym AllSymbols value _ t SymbolsOnce I).
    unfold Weighed. apply SumExt. intros s. f_equal.
    destruct t as [a b c d]. unfold WeightOf, At. cbn [CornerWeights Weigh TetCorners] in *.
    apply FourApart in N. destruct N as (Ab & Ac & Ad & Bc & Bd & Cd).
    destruct (in_dec SameSym s [a; b; c; d]) as [Is_|Out].
    - cbn [In] in Is_. destruct Is_ as [<-|[<-|[<-|[<-|[]]]]];
        repeat match goal with |- context [SameSym ?x ?y] =>
          destruct (SameSym x y); try congruence end; ring.
    - rewrite (C s Out). cbn [In] in Out.
      repeat match goal with |- context [SameSym ?x ?y] =>
        destruct (SameSym x y); [destruct Out; subst; tauto|] end; ring.
  Qed.

  Hypothesis Fits : CheckFills sign = true.

  (** Weights of the corners make weights of one tetrahedron, inside or outside. *)
  Theorem Fills w : NonNegative w ->
    let whole := UT _ (Base F1) (Base F2) (Base F3) (Base P) in
    exists t w' times, In t (Inner sign ++ Outer sign ++ Dropped sign) /\
      NonNegative w' /\ 0 < times /\
      forall value, StraightOn value -> Weigh value w' t = times * Weigh value w whole.
  Proof.
    intros W whole. destruct w as [a b c d].
    set (weight := WeightOf SameSym (UT _ a b c d) whole).
    assert (N : forall s, 0 <= weight s)
      by (intros s; apply (WeightNonNegative Symbol SameSym), W).
    assert (C : Carried (map Base Four) weight).
    { intros s O. unfold weight, WeightOf, At. cbn [Weigh whole].
      destruct (SameSym s (Base F1)), (SameSym s (Base F2)), (SameSym s (Base F3)),
        (SameSym s (Base P)); subst; try ring; destruct O; cbn; tauto. }
    destruct (FillAll (CutEdges sign) weight (map Base Four)) as (weight' & carriers & M & C' & I);
      try assumption.
    { intros p m I. unfold CutEdges in I. apply filter_In in I. destruct I as [I S].
      apply andb_prop in S. destruct S as [Sp Sm]. unfold Is in Sp, Sm.
      apply IsSignEqual in Sp, Sm.
      assert (In p Four /\ In m Four) as [Fp Fm].
      { clear -I. cbn in I.
        repeat (destruct I as [I|I]; [injection I as <- <-; cbn; tauto|]). destruct I. }
      repeat split; assumption. }
    pose proof Fits as F. unfold CheckFills in F. rewrite forallb_forall in F.
    specialize (F carriers I). apply existsb_exists in F. destruct F as (t & J & F).
    apply andb_prop in F. destruct F as [R F]. rewrite forallb_forall in F.
    destruct M as [N' (times & T & E)].
    exists t, (CornerWeights weight' t), times. split; [exact J|].
    split; [destruct t; cbn [CornerWeights NonNegative]; auto|]. split; [exact T|].
    intros value S.
    rewrite WeighedByTet; [|exact R|].
    - rewrite (E value S). f_equal. unfold Weighed.
      rewrite (Expand Symbol SameSym AllSymbols value (UT _ a b c d) whole SymbolsOnce);
        [reflexivity|].
      intros s. unfold whole, AllSymbols. cbn [TetCorners In]. rewrite in_app_iff.
      intros K. left. apply in_map_iff.
      destruct K as [<-|[<-|[<-|[<-|[]]]]]; eexists; (split; [reflexivity|]); cbn; tauto.
    - intros s O. apply C'. intros K. apply O, MemberIn, F, K.
  Qed.
End Fill.
