(** * Stencils in any order of the cuts follow the rule of that order: proof *)

From Certet Require Import Key.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.TriangleChecker Stencil.TriangleCheckerProof Stuffing.NameProof
  Embedding.EdgeRank Embedding.MeshApartProof
  Key.Orders Key.OrderProof Key.KeyChecker Key.FaceRuleProof.
Open Scope Z_scope.

(** ** On symbols *)

Section Checker.
  Variables (sign : Label -> Sign) (order : list (Label * Label)).

  Local Notation rank := (RankKey order).

  Definition CheckMayJoinBy (s r : Symbol) : bool :=
    match s, r with
    | Base a, CutOf b m =>
        negb (IsSign (sign a) Plus) || (rank b m <=? rank a m)
    | CutOf a m, CutOf b n =>
        SameLabel a b || SameLabel m n ||
        ((rank a m <=? rank b m) || (rank b n <=? rank a n)) &&
        (negb (rank a m <=? rank b m) || negb (rank a n <=? rank b n)
         || (rank a n <=? rank a m))
    | _, _ => true
    end.

  Definition CheckFollowsBy (t : SymbolicTet) : bool :=
    forallb (CheckBelongs sign) (TetCorners t) &&
    forallb (fun s => forallb (CheckMayJoinBy s) (TetCorners t)) (TetCorners t).
End Checker.

Lemma OrdersFollow : ForAllCornerSigns (fun sign =>
  forallb (fun order =>
    forallb (CheckFollowsBy sign order) (RankedTets sign order) &&
    CheckApart (RankedTets sign order)) (Orders (CutsOf sign))) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

(** ** By names *)

Section Named.
  Variables f1 f2 f3 p q : Coord3.
  Hypothesis distinct : NoDup [f1; f2; f3; p; q].
  Variables (key : Coord3 -> Coord3 -> Z) (before : SignField) (warping : Coord3 -> Warping).
  Hypothesis apart : KeysApart key [f1; f2; f3; p].
  Variable h : Handedness.

  Local Notation at_ := (LocateFive f1 f2 f3 p q).
  Local Notation name := (Name f1 f2 f3 p q).
  Local Notation sign := (NamedSign f1 f2 f3 p before warping).
  Local Notation order := (NamedOrder f1 f2 f3 p q key before warping).
  Let after c := PlacedSign before warping (Corner c).
  Let made := map (fun s => Orient h (MapTet name s)) (RankedTets sign order).

  Lemma NamedFollowChecked :
    (forall t, In t (RankedTets sign order) -> CheckFollowsBy sign order t = true) /\
    CheckApart (RankedTets sign order) = true.
  Proof.
    pose proof (ForAllCornerSignsSound _ OrdersFollow (after f1) (after f2) (after f3)
      (after p)) as C. cbv beta in C.
    rewrite forallb_forall in C. specialize (C order (NamedOrderListed _ _ _ _ _ _ _ _)).
    apply andb_true_iff in C. destruct C as [C A]. rewrite forallb_forall in C. auto.
  Qed.

  Lemma IsLabel l : SameLabel l Q = false -> In l TetLabels.
  Proof. destruct l; cbn; tauto || discriminate. Qed.

  Lemma NamedBelongs s : CheckBelongs sign s = true -> Belongs after [f1; f2; f3; p] (name s).
  Proof.
    destruct s as [a|a m]; rewrite ?NameBase, ?NameCut; cbn [CheckBelongs Belongs];
      rewrite !andb_true_iff, ?negb_true_iff, ?IsSignEqual.
    - intros [L N]. apply IsLabel in L. split; [apply AtCorner, L|].
      unfold after. rewrite <- (NamedSignCorner f1 f2 f3 p q before warping a L).
      intros M. rewrite M in N. discriminate N.
    - intros [[[La Lm] Sa] Sm]. apply IsLabel in La, Lm. unfold after.
      rewrite <- !(NamedSignCorner f1 f2 f3 p q before warping) by assumption.
      auto using AtCorner.
  Qed.

  (** Ranks and keys of cuts that share an end. *)
  Lemma RankKeyLe a e b f :
    In a TetLabels -> In e TetLabels -> In b TetLabels -> In f TetLabels ->
    sign a = Plus -> sign e = Minus -> sign b = Plus -> sign f = Minus ->
    a = b \/ e = f ->
    RankKey order a e <= RankKey order b f <-> key (at_ a) (at_ e) <= key (at_ b) (at_ f).
  Proof.
    intros A E B F Sa Se Sb Sf shared.
    pose proof (RanksCompare f1 f2 f3 p q distinct key before warping apart b f a e
      B F A E Sb Sf Sa Se ltac:(intuition congruence)) as C.
    unfold LabelKey in C.
    destruct (Z.ltb_spec (key (at_ b) (at_ f)) (key (at_ a) (at_ e))),
      (Z.ltb_spec (RankKey order b f) (RankKey order a e)); discriminate C || lia.
  Qed.

  Lemma NamedMayJoin s r : CheckBelongs sign s = true -> CheckBelongs sign r = true ->
    CheckMayJoinBy sign order s r = true -> MayJoinBy key after (name s) (name r).
  Proof.
    destruct s as [a|a m], r as [b|b n]; rewrite ?NameBase, ?NameCut;
      cbn [CheckBelongs CheckMayJoinBy MayJoinBy]; try exact (fun _ _ _ => I);
      rewrite !andb_true_iff, ?orb_true_iff, ?negb_true_iff, ?IsSignEqual.
    - intros [La _] [[[Lb Ln] Sb] Sn] C. apply IsLabel in La, Lb, Ln. unfold after.
      rewrite <- (NamedSignCorner f1 f2 f3 p q before warping a La). intros Sa.
      destruct C as [C|C]; [rewrite Sa in C; discriminate C|].
      apply Z.leb_le, RankKeyLe in C; auto.
    - intros [[[La Lm] Sa] Sm] [[[Lb Ln] Sb] Sn] C ab mn.
      apply IsLabel in La, Lm, Lb, Ln.
      assert (D : forall l k, at_ l <> at_ k -> SameLabel l k = false).
      { intros l k N. apply not_true_iff_false. intros S. apply SameLabelEqual in S.
        congruence. }
      rewrite (D _ _ ab), (D _ _ mn) in C.
      destruct C as [[C|C]|C]; try discriminate C.
      apply andb_true_iff in C. destruct C as [across beside].
      rewrite orb_true_iff, !Z.leb_le, !RankKeyLe in across by auto.
      split; [exact across|].
      rewrite <- !RankKeyLe by auto. intros L1 L2.
      apply Z.leb_le in L1, L2. rewrite L1, L2 in beside. cbn [negb orb] in beside.
      apply Z.leb_le, beside.
  Qed.

  Lemma NamedFollows t : In t made -> FollowsBy key after [f1; f2; f3; p] t.
  Proof.
    unfold made. intros I. apply in_map_iff in I. destruct I as (s & <- & I).
    pose proof (proj1 NamedFollowChecked s I) as C.
    unfold CheckFollowsBy in C. rewrite andb_true_iff, !forallb_forall in C.
    destruct C as [B J].
    assert (N : forall v, In v (TetCorners (Orient h (MapTet name s))) ->
      exists x, v = name x /\ In x (TetCorners s)).
    { intros v V. apply OrientCorners in V. rewrite MapTetCorners in V.
      apply in_map_iff in V. destruct V as (x & <- & V). eauto. }
    split.
    - intros v V. destruct (N v V) as (x & -> & X). apply NamedBelongs, B, X.
    - intros u v U V. destruct (N u U) as (x & -> & X), (N v V) as (y & -> & Y).
      specialize (J x X). rewrite forallb_forall in J.
      apply NamedMayJoin; auto.
  Qed.

  Lemma NamedReaches t : In t made ->
    forall c, In c [f1; f2; f3; p] -> exists v, In v (TetCorners t) /\ In c (Ends v).
  Proof.
    exact (CheckedReaches h f1 f2 f3 p q _ (proj2 NamedFollowChecked) t).
  Qed.

  Lemma NamedKnown t t' : In t made -> In t' made ->
    incl (TetCorners t) (TetCorners t') -> t = t'.
  Proof.
    exact (CheckedKnown h f1 f2 f3 p q _ (proj2 NamedFollowChecked) t t' distinct).
  Qed.
End Named.

(** ** In the lattice *)

Section Lattice.
  Variables (key : Coord3 -> Coord3 -> Z) (before : SignField).
  Variables (warping : Coord3 -> Warping) (tid : StructuredTetId).
  Hypothesis apart : KeysApart key (Corners tid).

  Theorem OrderedFollows t : In t (OrderedNames key before warping tid) ->
    FollowsBy key (fun c => PlacedSign before warping (Corner c)) (Corners tid) t.
  Proof.
    destruct (OrderedViewed key before warping tid apart)
      as (h & f1 & f2 & f3 & p & q & D & _ & C & ->).
    rewrite C in *. exact (NamedFollows f1 f2 f3 p q D key before warping apart h t).
  Qed.

  Lemma OrderedReaches t : In t (OrderedNames key before warping tid) ->
    forall c, In c (Corners tid) -> exists v, In v (TetCorners t) /\ In c (Ends v).
  Proof.
    destruct (OrderedViewed key before warping tid apart)
      as (h & f1 & f2 & f3 & p & q & _ & _ & -> & ->).
    exact (NamedReaches f1 f2 f3 p q key before warping h t).
  Qed.

  Lemma OrderedKnown t t' : In t (OrderedNames key before warping tid) ->
    In t' (OrderedNames key before warping tid) ->
    incl (TetCorners t) (TetCorners t') -> t = t'.
  Proof.
    destruct (OrderedViewed key before warping tid apart)
      as (h & f1 & f2 & f3 & p & q & D & _ & _ & ->).
    exact (NamedKnown f1 f2 f3 p q D key before warping h t t').
  Qed.
End Lattice.
