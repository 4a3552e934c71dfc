(** * The check of ranged cuts is sound: proof *)

From Certet Require Import Key.Definitions.
From Certet Require Import Angles.Forms.BoxForm Angles.Forms.Checker Angles.Forms.EdgeProof
  Angles.Forms.CheckerProof Angles.Cases.Configurations
  Angles.Cases.ReductionProof Key.Orders Key.OrderProof Key.KeyConfigurations.
Open Scope Z_scope.

Lemma LabelEqualTrue a b : LabelEqual a b = true <-> a = b.
Proof. destruct a, b; cbn; intuition congruence. Qed.

Lemma SamePairEqual x y : SamePair x y = true <-> x = y.
Proof.
  destruct x, y. unfold SamePair. cbn [fst snd].
  rewrite andb_true_iff, !LabelEqualTrue. intuition congruence.
Qed.

(** ** What the quicker check accepts, the check accepts *)

Lemma QuickBoundChecks k volume extreme edge a b c d :
  QuickBound k volume extreme edge a b c d = true ->
  CheckBound k volume extreme edge a b c d = true.
Proof.
  unfold QuickBound, CheckBound. destruct (CheckRanges k volume extreme edge); [trivial|].
  intros ->. reflexivity.
Qed.

Lemma QuickEdgeChecks bounds volume a b c d :
  QuickEdge bounds volume (a, b, c, d) = true ->
  CheckEdge bounds volume a b c d = true.
Proof.
  destruct bounds as [acute obtuse]. unfold QuickEdge, CheckEdge. cbv zeta.
  generalize (Upper (NormalsDegrees a b c d) (NormalsForm a b c d)).
  generalize (Lower (NormalsDegrees a b c d) (NormalsForm a b c d)).
  generalize (Lower (EdgeDegrees a b c d) (EdgeForm a b c d)).
  intros edge least most.
  destruct (if most <=? 0 then true else QuickBound acute volume most edge a b c d)
    eqn:A; [|discriminate].
  replace (if most <=? 0 then true else CheckBound acute volume most edge a b c d)
    with true
    by (destruct (most <=? 0); [reflexivity|symmetry; apply QuickBoundChecks, A]).
  destruct (0 <=? least); [trivial|]. apply QuickBoundChecks.
Qed.

Lemma QuickTetChecks bounds t : QuickTet bounds t = true -> CheckTet bounds t = true.
Proof.
  destruct t as [a b c d]. cbn beta iota zeta delta [QuickTet CheckTet].
  generalize (Lower (VolumeDegrees a b c d) (VolumeForm a b c d)). intros volume.
  destruct (0 <? volume); [|discriminate].
  generalize (DihedralEdges (UT Segment a b c d)). intros es Q. apply forallb_forall.
  induction es as [|e rest IH]; [intros e []|]. cbn [QuickEdges] in Q.
  destruct (QuickEdge bounds volume e) eqn:E; [|discriminate Q].
  intros x [<-|I]; [|exact (IH Q x I)].
  destruct e as [[[p q] r] s]. apply QuickEdgeChecks, E.
Qed.

(** ** What becomes of ranges, their cuts stay *)

Lemma CutsRaised ranges least : map CutIn (RaiseStarts least ranges) = map CutIn ranges.
Proof.
  revert least. induction ranges as [|[c lo hi] rest IH]; intros least; cbn;
    [reflexivity|]. f_equal. apply IH.
Qed.

Lemma CutsLowered ranges : map CutIn (LowerEnds ranges) = map CutIn ranges.
Proof.
  induction ranges as [|[c lo hi] rest IH]; [reflexivity|].
  cbn [LowerEnds map CutIn]. rewrite <- IH.
  destruct (LowerEnds rest) as [|[c' lo' hi'] rest']; reflexivity.
Qed.

Lemma CutsTightened ranges : map CutIn (Tightened ranges) = map CutIn ranges.
Proof.
  unfold Tightened. rewrite CutsLowered. destruct ranges as [|[c lo hi] rest];
    [reflexivity|apply CutsRaised].
Qed.

Lemma CutsNarrowed c narrow ranges : map CutIn (Narrowed c narrow ranges) = map CutIn ranges.
Proof.
  unfold Narrowed. rewrite map_map. apply map_ext. intros [d lo hi].
  destruct (SamePair c d); [|reflexivity]. destruct (narrow lo hi). reflexivity.
Qed.

(** ** Cuts in their ranges *)

Section Fitting.
  (** Where the cuts are, in steps. *)
  Variable at_ : Label * Label -> Z.

  Definition InRange (x : CutRange) : Prop :=
    match x with CR c lo hi => 256 * lo <= at_ c <= 256 * hi end.

  (** Every cut is in its range, and they are in order. *)
  Fixpoint Fitting (ranges : list CutRange) : Prop :=
    match ranges with
    | [] => True
    | x :: rest =>
        InRange x /\ (forall y, In y rest -> at_ (CutIn x) <= at_ (CutIn y)) /\
        Fitting rest
    end.

  Lemma FittingIn ranges x : Fitting ranges -> In x ranges -> InRange x.
  Proof.
    induction ranges as [|y rest IH]; cbn [In Fitting]; [tauto|].
    intros (here & _ & there) [<-|I]; auto.
  Qed.

  (** Changed ranges of the same cuts. *)
  Lemma SameCuts ranges ranges' : map CutIn ranges = map CutIn ranges' ->
    Fitting ranges -> (forall x, In x ranges' -> InRange x) -> Fitting ranges'.
  Proof.
    revert ranges'. induction ranges as [|x rest IH]; intros [|y rest'];
      cbn [map Fitting]; try discriminate; [auto|].
    intros [= same sames] (_ & first & others) all. repeat split.
    - apply all. left. reflexivity.
    - intros z I. rewrite <- same.
      assert (J : In (CutIn z) (map CutIn rest)) by (rewrite sames; apply in_map, I).
      apply in_map_iff in J. destruct J as (z' & <- & J). apply first, J.
    - apply IH; try assumption. intros z I. apply all. right. exact I.
  Qed.

  Lemma RaisedFit ranges least : Fitting ranges ->
    (forall x, In x ranges -> 256 * least <= at_ (CutIn x)) ->
    Fitting (RaiseStarts least ranges).
  Proof.
    intros F L. apply (SameCuts ranges); [|exact F|].
    - symmetry. apply CutsRaised.
    - revert least L F. induction ranges as [|[c lo hi] rest IH]; cbn [RaiseStarts In Fitting];
        [intros ? ? ? ? []|]. intros least L (here & first & others) x [<-|I].
      + specialize (L (CR c lo hi) (or_introl eq_refl)). cbn [InRange CutIn] in *. lia.
      + refine (IH (Z.max least lo) _ others x I). intros y J.
        pose proof (L y (or_intror J)). specialize (first y J).
        cbn [InRange CutIn] in *. lia.
  Qed.

  Lemma LoweredFit ranges : Fitting ranges -> Fitting (LowerEnds ranges).
  Proof.
    intros F. apply (SameCuts ranges); [symmetry; apply CutsLowered|exact F|].
    induction ranges as [|[c lo hi] rest IH]; cbn [LowerEnds Fitting] in *; [intros x []|].
    destruct F as (here & first & others). specialize (IH others).
    pose proof (CutsLowered rest) as cuts.
    destruct (LowerEnds rest) as [|[c' lo' hi'] rest'].
    - intros x [<-|[]]. exact here.
    - intros x [<-|I]; [|apply IH, I].
      pose proof (IH (CR c' lo' hi') (or_introl eq_refl)) as next.
      cbn [map CutIn] in cuts.
      assert (J : In c' (map CutIn rest)) by (rewrite <- cuts; left; reflexivity).
      apply in_map_iff in J. destruct J as (y & E & J). specialize (first y J).
      rewrite E in first. cbn [InRange CutIn] in *. lia.
  Qed.

  Lemma TightenedFit ranges : Fitting ranges -> Fitting (Tightened ranges).
  Proof.
    intros F. apply LoweredFit. destruct ranges as [|[c lo hi] rest]; [exact F|].
    apply RaisedFit; [exact F|]. destruct F as (here & first & _).
    intros x [<-|I]; [|specialize (first x I)]; cbn [InRange CutIn] in *; lia.
  Qed.

  Lemma NotEmpty ranges : Fitting ranges -> IsEmpty ranges = false.
  Proof.
    intros F. apply not_true_iff_false. intros E.
    apply existsb_exists in E. destruct E as ([c lo hi] & I & E).
    apply Z.ltb_lt in E. pose proof (FittingIn _ _ F I). cbn [InRange] in *. lia.
  Qed.

  Lemma NarrowedFit c narrow ranges : Fitting ranges ->
    (forall lo hi, In (CR c lo hi) ranges ->
       InRange (CR c (fst (narrow lo hi)) (snd (narrow lo hi)))) ->
    Fitting (Narrowed c narrow ranges).
  Proof.
    intros F N. apply (SameCuts ranges); [|exact F|].
    - symmetry. apply CutsNarrowed.
    - intros x I. apply in_map_iff in I. destruct I as ([d lo hi] & <- & I).
      destruct (SamePair c d) eqn:S; [|exact (FittingIn _ _ F I)].
      apply SamePairEqual in S. subst d. specialize (N lo hi I).
      destruct (narrow lo hi). exact N.
  Qed.

  Lemma RangeOfIn c ranges lo hi : RangeOf c ranges = Some (lo, hi) ->
    In (CR c lo hi) ranges.
  Proof.
    unfold RangeOf. destruct (find _ ranges) as [[d lo' hi']|] eqn:E; [|discriminate].
    intros [= <- <-]. apply find_some in E. destruct E as [I E].
    apply SamePairEqual in E. cbn [CutIn] in E. subst d. exact I.
  Qed.

  (** *** The check *)

  Variables (bounds : AngleBounds) (segment : list CutRange -> Symbol -> Segment).
  Variables (t : UnstructuredTet Symbol) (place : Symbol -> Coord3).
  Hypothesis Hbounds : Sensible bounds.

  (** Wherever the ranges are, what they say is so. *)
  Variable cuts : list (Label * Label).
  Hypothesis Segments : forall ranges v, map CutIn ranges = cuts -> Fitting ranges ->
    In v (TetCorners t) -> OnSegment 256 (segment ranges v) (place v).

  Theorem CheckRangedSound halvings ranges :
    map CutIn ranges = cuts -> Fitting ranges ->
    CheckRanged bounds segment t halvings ranges = true ->
    WellShaped bounds (MapTet place t).
  Proof.
    assert (whole : forall ranges, map CutIn ranges = cuts -> Fitting ranges ->
      CheckTet bounds (MapTet (segment ranges) t) = true ->
      WellShaped bounds (MapTet place t)).
    { clear ranges. intros ranges E F T.
      pose proof (fun v => Segments ranges v E F) as S.
      destruct t as [a b c d]. cbn [MapTet TetCorners In] in *.
      apply (CheckTetSound 256 ltac:(lia)
        bounds (segment ranges a) (segment ranges b)
        (segment ranges c) (segment ranges d));
        auto 6. }
    revert ranges. induction halvings as [|n IH]; intros ranges E F C;
      cbn [CheckRanged] in C; rewrite (NotEmpty ranges F) in C;
      [exact (whole ranges E F C)|].
    destruct (Widest ranges t) as [[[c lo] hi]|]; [|exact (whole ranges E F C)].
    destruct (QuickTet bounds (MapTet (segment ranges) t)) eqn:T.
    - exact (whole ranges E F (QuickTetChecks _ _ T)).
    - set (middle := (lo + hi) / 2) in C.
      destruct (CheckRanged bounds segment t n (Tightened (Narrowed c
        (fun lo _ => (lo, middle)) ranges))) eqn:First; [|discriminate C].
      destruct (Z.le_ge_cases (at_ c) (256 * middle)) as [L|L];
        [apply (IH _) in First; [exact First|..]|apply (IH _) in C; [exact C|..]];
        try (rewrite CutsTightened, CutsNarrowed; exact E);
        apply TightenedFit, NarrowedFit; try exact F;
        intros lo' hi' I; pose proof (FittingIn _ _ F I); cbn [InRange fst snd] in *; lia.
  Qed.
End Fitting.
