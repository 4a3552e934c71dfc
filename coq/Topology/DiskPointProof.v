(** * The strict disk, said of points

    [StrictDisk] computes in directions from one vertex.  Here it is said without
    them, so that the same edge can be seen from both its ends. *)

From Coq Require Import Arith.
From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.Cases.Isometry Embedding.LeavingProof
  Embedding.LinkProof Topology.CliqueProof Topology.RingProof
  Topology.SeparationProof.
Open Scope bool_scope.

(** ** What [OnePiece] does not reach is not joined *)

Section Flood.
  Variable part : Direction -> bool.

  Definition FloodStep (reached : list Direction) : list Direction :=
    filter (fun d => part d &&
      existsb (fun e => SameDirection e d || NextInLink e d) reached) AllDirections.

  Lemma InFloodStep reached d : In d (FloodStep reached) <->
    part d = true /\ exists e, In e reached /\ (e = d \/ NextInLink e d = true).
  Proof.
    unfold FloodStep. rewrite filter_In, andb_true_iff, existsb_exists.
    pose proof (InAllDirections d).
    assert (E : forall e, SameDirection e d || NextInLink e d = true <->
      e = d \/ NextInLink e d = true).
    { intros e. rewrite orb_true_iff. split; (intros [S|N]; [left|right; exact N]).
      - apply SameDirectionMeans, S.
      - subst e. apply SameDirectionRefl. }
    split.
    - intros (_ & P & e & I & S). split; [exact P|]. exists e. rewrite <- E. auto.
    - intros (P & e & I & S). repeat split; auto. exists e. rewrite E. auto.
  Qed.

  Lemma FloodMore steps reached :
    Flood (S steps) part reached = Flood steps part (FloodStep reached).
  Proof. reflexivity. Qed.

  Definition Closed (l : list Direction) : Prop :=
    forall d e, In d l -> part e = true -> NextInLink d e = true -> In e l.

  Lemma FloodStays l : Closed l -> forall steps r, incl r l ->
    incl (Flood steps part r) l.
  Proof.
    intros C steps. induction steps as [|steps IH]; intros r I; [exact I|].
    rewrite FloodMore. apply IH. intros d D. apply InFloodStep in D.
    destruct D as (P & e & E & [->|N]).
    - exact (I d E).
    - exact (C e d (I e E) P N).
  Qed.

  Lemma AllOnce : NoDup AllDirections.
  Proof. unfold AllDirections. repeat constructor; cbn [In]; intuition discriminate. Qed.

  Lemma FloodEnds steps : forall r, NoDup r -> (forall d, In d r -> part d = true) ->
    let l := Flood steps part r in
    incl r l /\ NoDup l /\ (length r + steps <= length l \/ Closed l)%nat.
  Proof.
    induction steps as [|steps IH]; intros r N P.
    - cbn [Flood]. split; [apply incl_refl|]. split; [exact N|]. left. lia.
    - cbv zeta. rewrite FloodMore.
      assert (Up : incl r (FloodStep r)).
      { intros d D. apply InFloodStep. split; [exact (P d D)|]. exists d. auto. }
      assert (N' : NoDup (FloodStep r)) by (apply NoDup_filter, AllOnce).
      assert (P' : forall d, In d (FloodStep r) -> part d = true)
        by (intros d D; apply InFloodStep in D; apply D).
      destruct (IH (FloodStep r) N' P') as (I & M & L).
      split; [intros d D; apply I, Up, D|]. split; [exact M|].
      destruct (forallb (fun d => existsb (SameDirection d) r) (FloodStep r)) eqn:F.
      + right.
        assert (In_ : incl (FloodStep r) r).
        { intros d D. rewrite forallb_forall in F. apply InSame, F, D. }
        assert (C : Closed r).
        { intros d e D E T. apply In_, InFloodStep. split; [exact E|]. exists d. auto. }
        pose proof (FloodStays r C steps (FloodStep r) In_) as Down.
        intros d e D E T. apply I, Up. exact (C d e (Down d D) E T).
      + destruct L as [L|L]; [left|right; exact L].
        assert (exists d, In d (FloodStep r) /\ ~ In d r) as (d & D & Out).
        { clear -F. induction (FloodStep r) as [|d ds IH]; [discriminate F|].
          cbn [forallb] in F. destruct (existsb (SameDirection d) r) eqn:E.
          - destruct (IH F) as (x & X & O). exists x. cbn. auto.
          - exists d. split; [left; reflexivity|]. rewrite <- InSame, E. discriminate. }
        assert (length (d :: r) <= length (FloodStep r))%nat.
        { apply NoDup_incl_length; [constructor; assumption|].
          intros x [<-|X]; [exact D|exact (Up x X)]. }
        cbn [length] in *. lia.
  Qed.

  Theorem OnePieceIff v : OnePiece part = true <->
    (exists x, InPart v part x) /\
    forall x y, InPart v part x -> InPart v part y ->
      Joined (InPart v part) Adjacent x y.
  Proof.
    split; [apply OnePieceMeans|]. intros [(x0 & d0 & _ & P0) J]. unfold OnePiece.
    destruct (filter part AllDirections) as [|first rest] eqn:F.
    - exfalso. enough (In d0 []) as [] by assumption. rewrite <- F. apply filter_In.
      split; [apply InAllDirections|exact P0].
    - assert (Pf : part first = true).
      { apply (filter_In part first AllDirections). rewrite F. left. reflexivity. }
      destruct (FloodEnds 13 [first]) as (I & N & L).
      + repeat constructor. intros [].
      + intros d [<-|[]]. exact Pf.
      + cbv zeta in *. set (l := Flood 13 part [first]) in *.
        assert (C : Closed l).
        { destruct L as [L|L]; [|exact L]. intros d e _ _ _.
          apply (NoDup_length_incl N (l' := AllDirections)); [exact L|
            intros f _; apply InAllDirections|apply InAllDirections]. }
        apply forallb_forall. intros d _. destruct (part d) eqn:P; [|reflexivity].
        cbn [negb orb]. apply InSame.
        assert (W : forall x y, Joined (InPart v part) Adjacent x y ->
          x = Translate v (Offset first) -> forall e, y = Translate v (Offset e) ->
          In e l).
        { induction 1 as [x X|x y w K IH T [g [-> G]]]; intros -> e E.
          - apply OffsetsDiffer in E. subst e. apply I. left. reflexivity.
          - apply OffsetsDiffer in E. subst g. pose proof K as K'.
            apply JoinedInside in K'. destruct K' as [_ [h [-> H]]].
            apply (C h e); [apply (IH eq_refl h eq_refl)|exact G|].
            apply (NextInLinkMeans v), T. }
        apply (W _ _ (J (Translate v (Offset first)) (Translate v (Offset d))
          (ex_intro _ first (conj eq_refl Pf)) (ex_intro _ d (conj eq_refl P)))
          eq_refl d eq_refl).
  Qed.
End Flood.

(** ** A good ring *)

Fixpoint ForAllInnerOn (ds : list Direction) (test : (Direction -> Sign) -> bool)
  : bool :=
  match ds with
  | [] => test (fun _ => Minus)
  | d :: rest =>
      ForAllInnerOn rest (fun now => test (Put d Plus now)) &&
      ForAllInnerOn rest (fun now => test (Put d Minus now))
  end.

Lemma ForAllInnerOnSound now ds : forall test, ForAllInnerOn ds test = true ->
  exists now', (forall e, In e ds -> IsInner now' e = IsInner now e) /\
    test now' = true.
Proof.
  induction ds as [|d rest IH]; cbn [ForAllInnerOn]; intros test C.
  - exists (fun _ => Minus). split; [intros e []|exact C].
  - apply andb_prop in C. destruct C as [C C'].
    assert (G : forall s, (IsInner now d = match s with Plus => true | _ => false end) ->
      ForAllInnerOn rest (fun now => test (Put d s now)) = true ->
      exists now', (forall e, In e (d :: rest) -> IsInner now' e = IsInner now e) /\
        test now' = true).
    { intros s S F. destruct (IH _ F) as (now' & A & T). exists (Put d s now').
      split; [|exact T]. intros e I. unfold Put, IsInner at 1.
      destruct (SameDirection d e) eqn:Q.
      - apply SameDirectionMeans in Q. subst e. symmetry. exact S.
      - destruct I as [<-|I]; [rewrite SameDirectionRefl in Q; discriminate Q|].
        exact (A e I). }
    destruct (IsInner now d) eqn:I; [apply (G Plus)|apply (G Minus)]; auto.
Qed.

Definition RunOf (now : Direction -> Sign) (d e : Direction) : bool :=
  IsInner now e && NextInLink d e.

(** The + on a ring is one run exactly if it is in one piece. *)
Lemma RingsRun : forallb (fun d => let ring := Ring d in let pairs := RingPairs d in
  ForAllInnerOn ring (fun now =>
    if forallb (IsInner now) ring || forallb (fun e => negb (IsInner now e)) ring
    then true
    else Bool.eqb (length (Crossings now pairs) <=? 2)%nat (OnePiece (RunOf now d))))
  AllDirections = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma GoodRingIs now d : GoodRing now d =
  existsb (fun e => negb (IsInner now e)) (Ring d) &&
  (length (Crossings now (RingPairs d)) <=? 2)%nat.
Proof.
  unfold GoodRing, Crossings, RingPairs, Ring. cbv zeta. rewrite FilterTwice.
  f_equal. f_equal. f_equal. apply filter_ext.
  intros [e f]. cbn [Crosses]. rewrite andb_assoc. reflexivity.
Qed.

Lemma CrossingsByInner now now' d :
  (forall e, In e (Ring d) -> IsInner now' e = IsInner now e) ->
  Crossings now' (RingPairs d) = Crossings now (RingPairs d).
Proof.
  intros A. apply filter_ext_in. intros [e f] I. apply InRingPairs in I.
  destruct I as (E & F & _). unfold Crosses.
  rewrite !A by (apply InRing; assumption). reflexivity.
Qed.

(** The points next to both ends of an edge: not all are +, and those that are hang
    together. *)
Definition GoodEdge (s : SignField) (a b : Coord3) : Prop :=
  (exists x, Adjacent a x /\ Adjacent b x /\ s x <> Plus) /\
  forall x y, Adjacent a x -> Adjacent b x -> s x = Plus ->
    Adjacent a y -> Adjacent b y -> s y = Plus ->
    Joined (fun w => Adjacent a w /\ Adjacent b w /\ s w = Plus) Adjacent x y.

Lemma JoinedSame {V} (inside inside' : V -> Prop) next u v :
  (forall x, inside x <-> inside' x) ->
  Joined inside next u v <-> Joined inside' next u v.
Proof. intros E. split; apply JoinedWider; intros x; apply E. Qed.

Section Vertex.
  Variables (s : SignField) (z : Coord3).
  Local Notation at_ e := (Translate z (Offset e)).
  Let now (e : Direction) : Sign := s (at_ e).

  Lemma InnerAt e : IsInner now e = true <-> s (at_ e) = Plus.
  Proof. unfold IsInner, now. destruct (s (at_ e)); intuition congruence. Qed.

  Lemma RunPart d x : InPart z (RunOf now d) x <->
    Adjacent z x /\ Adjacent (at_ d) x /\ s x = Plus.
  Proof.
    unfold InPart, RunOf. split.
    - intros (e & -> & E). apply andb_prop in E. rewrite InnerAt in E.
      rewrite (NextInLinkMeans z) in E. split; [exists e; reflexivity|tauto].
    - intros ([e ->] & N & P). exists e. split; [reflexivity|].
      apply andb_true_intro. split; [apply InnerAt, P|apply (NextInLinkMeans z), N].
  Qed.

  Lemma GoodRingIff d : GoodRing now d = true <-> GoodEdge s z (at_ d).
  Proof.
    rewrite GoodRingIs. unfold GoodEdge.
    assert (Some_ : existsb (fun e => negb (IsInner now e)) (Ring d) = true <->
      exists x, Adjacent z x /\ Adjacent (at_ d) x /\ s x <> Plus).
    { rewrite existsb_exists. split.
      - intros (e & I & N). exists (at_ e). apply InRing, (NextInLinkMeans z) in I.
        split; [exists e; reflexivity|]. split; [exact I|]. rewrite <- InnerAt.
        destruct (IsInner now e); [discriminate N|discriminate].
      - intros (x & [e ->] & I & N). exists e.
        split; [apply InRing, (NextInLinkMeans z), I|].
        rewrite <- InnerAt in N. destruct (IsInner now e); [congruence|reflexivity]. }
    rewrite andb_true_iff, Some_.
    enough (E : (exists x, Adjacent z x /\ Adjacent (at_ d) x /\ s x <> Plus) ->
      (length (Crossings now (RingPairs d)) <=? 2)%nat = true <->
      forall x y, Adjacent z x -> Adjacent (at_ d) x -> s x = Plus ->
        Adjacent z y -> Adjacent (at_ d) y -> s y = Plus ->
        Joined (fun w => Adjacent z w /\ Adjacent (at_ d) w /\ s w = Plus) Adjacent x y)
      by tauto.
    intros Out. pose proof RingsRun as R. rewrite forallb_forall in R.
    specialize (R d (InAllDirections d)). cbv zeta in R.
    destruct (ForAllInnerOnSound now _ _ R) as (now' & A & T).
    rewrite (CrossingsByInner now now' d A) in T.
    assert (Same : forall x, InPart z (RunOf now' d) x <-> InPart z (RunOf now d) x).
    { intros x. unfold InPart, RunOf.
      assert (Q : forall e, IsInner now' e && NextInLink d e = IsInner now e && NextInLink d e).
      { intros e. destruct (NextInLink d e) eqn:N; [|rewrite !andb_false_r; reflexivity].
        rewrite A by (apply InRing, N). reflexivity. }
      split; intros (e & -> & E); exists e; rewrite Q in *; auto. }
    apply Some_ in Out. apply existsb_exists in Out. destruct Out as (o & Io & No).
    assert (F1 : forallb (IsInner now') (Ring d) = false).
    { apply not_true_iff_false. rewrite forallb_forall. intros H.
      specialize (H o Io). rewrite (A o Io) in H. rewrite H in No. discriminate No. }
    rewrite F1 in T. cbn [orb] in T.
    destruct (forallb (fun e => negb (IsInner now' e)) (Ring d)) eqn:F2.
    - rewrite forallb_forall in F2.
      assert (None : forall e, In e (Ring d) -> IsInner now e = false).
      { intros e I. specialize (F2 e I). rewrite (A e I) in F2.
        apply negb_true_iff, F2. }
      split.
      + intros _ x y [e ->] N P. exfalso.
        apply InnerAt in P. rewrite None in P; [discriminate P|].
        apply InRing, (NextInLinkMeans z), N.
      + intros _. apply Nat.leb_le.
        assert (Z : Crossings now (RingPairs d) = []).
        { unfold Crossings. apply incl_l_nil. intros [e f] I. apply filter_In in I.
          destruct I as [I C]. apply InRingPairs in I. destruct I as (E & _).
          cbn [Crosses] in C. rewrite (None e) in C by (apply InRing, E). discriminate C. }
        rewrite Z. cbn. lia.
    - apply eqb_prop in T. rewrite T, (OnePieceIff _ z).
      assert (exists e, In e (Ring d) /\ IsInner now' e = true) as (e0 & I0 & P0).
      { clear -F2. induction (Ring d) as [|e es IH]; [discriminate F2|].
        cbn [forallb] in F2. destruct (IsInner now' e) eqn:E.
        - exists e. cbn. auto.
        - destruct (IH F2) as (x & X & Y). exists x. cbn. auto. }
      split.
      + intros [_ J] x y Zx Dx Px Zy Dy Py.
        apply (JoinedSame _ (InPart z (RunOf now' d)));
          [intros w; rewrite Same, RunPart; tauto|].
        apply J; rewrite Same, RunPart; auto.
      + intros J. split.
        * exists (at_ e0). exists e0. split; [reflexivity|]. unfold RunOf.
          rewrite P0. exact (proj1 (InRing d e0) I0).
        * intros x y X Y. rewrite Same, RunPart in X, Y.
          apply (JoinedSame _ (fun w => Adjacent z w /\ Adjacent (at_ d) w /\ s w = Plus));
            [intros w; rewrite Same, RunPart; tauto|].
          apply J; tauto.
  Qed.

  (** ** The disk *)

  Definition Whole (here : Coord3 -> Prop) : Prop :=
    (exists x, Adjacent z x /\ here x) /\
    forall x y, Adjacent z x -> here x -> Adjacent z y -> here y ->
      Joined (fun w => Adjacent z w /\ here w) Adjacent x y.

  Definition PointDisk : Prop :=
    Whole (fun x => s x = Plus) /\ Whole (fun x => s x <> Plus) /\
    (forall y, Adjacent z y -> s y = OnSurface -> GoodEdge s z y) /\
    forall y y' p q, Adjacent z y -> Adjacent z y' -> Adjacent y y' ->
      s y = OnSurface -> s y' = OnSurface ->
      Adjacent z p -> Adjacent y p -> Adjacent y' p -> s p = Plus ->
      Adjacent z q -> Adjacent y q -> Adjacent y' q -> s q = Plus -> p = q.

  Lemma WholeIff part (here : Coord3 -> Prop) :
    (forall e, part e = true <-> here (at_ e)) -> OnePiece part = true <-> Whole here.
  Proof.
    intros H. rewrite (OnePieceIff part z). unfold Whole.
    assert (P : forall x, InPart z part x <-> Adjacent z x /\ here x).
    { intros x. unfold InPart. split.
      - intros (e & -> & E). apply H in E. split; [exists e; reflexivity|exact E].
      - intros ([e ->] & E). exists e. split; [reflexivity|apply H, E]. }
    split.
    - intros [(x & X) J]. split; [exists x; apply P, X|].
      intros u w Zu Hu Zw Hw. apply (JoinedSame _ (InPart z part));
        [intros y; symmetry; apply P|]. apply J; apply P; auto.
    - intros [(x & X) J]. split; [exists x; apply P, X|].
      intros u w U W. apply (JoinedSame _ (fun w => Adjacent z w /\ here w)); [exact P|].
      apply P in U, W. apply J; tauto.
  Qed.

  Theorem PointDiskIff : StrictDisk now = true <-> PointDisk.
  Proof.
    unfold StrictDisk, PointDisk. rewrite !andb_true_iff.
    rewrite (WholeIff (IsInner now) (fun x => s x = Plus)) by apply InnerAt.
    assert (Outer : forall e, negb (IsInner now e) = true <-> s (at_ e) <> Plus).
    { intros e. rewrite negb_true_iff, <- InnerAt.
      destruct (IsInner now e); intuition congruence. }
    rewrite (WholeIff (fun d => negb (IsInner now d)) (fun x => s x <> Plus)) by exact Outer.
    assert (Zero : forall e, IsZero now e = true <-> s (at_ e) = OnSurface).
    { intros e. unfold IsZero, now. destruct (s (at_ e)); intuition congruence. }
    rewrite forallb_forall. split.
    - intros [[P N] R]. split; [exact P|]. split; [exact N|].
      assert (R' : forall d, s (at_ d) = OnSurface -> GoodRing now d = true /\
        forall e, s (at_ e) = OnSurface -> NextInLink d e = true ->
          NoWallBetween now d e = true).
      { intros d D. specialize (R d (InAllDirections d)). apply Zero in D.
        rewrite D in R. cbn [negb orb] in R. apply andb_prop in R. destruct R as [G W].
        split; [exact G|]. intros e E T. rewrite forallb_forall in W.
        specialize (W e (InAllDirections e)). apply Zero in E.
        rewrite E, T in W. exact W. }
      split.
      + intros y [d ->] D. apply GoodRingIff, R', D.
      + intros y y' p q [d ->] [e ->] T D E [f ->] Df Ef Pf [g ->] Dg Eg Pg.
        apply (NextInLinkMeans z) in T, Df, Ef, Dg, Eg. apply InnerAt in Pf, Pg.
        pose proof (proj2 (R' d D) e E T) as W. unfold NoWallBetween in W.
        rewrite forallb_forall in W. specialize (W f (InAllDirections f)).
        rewrite forallb_forall in W. specialize (W g (InAllDirections g)).
        rewrite Pf, Pg, Df, Ef, Dg, Eg in W. cbn [negb orb andb] in W.
        apply SameDirectionMeans in W. congruence.
    - intros (P & N & G & W). split; [auto|]. intros d _.
      destruct (IsZero now d) eqn:D; [|reflexivity]. cbn [negb orb].
      apply Zero in D. apply andb_true_intro. split.
      + apply GoodRingIff, G; [exists d; reflexivity|exact D].
      + apply forallb_forall. intros e _.
        destruct (IsZero now e) eqn:E; [|reflexivity].
        destruct (NextInLink d e) eqn:T; [|reflexivity]. cbn [negb orb andb].
        apply Zero in E. unfold NoWallBetween.
        apply forallb_forall. intros f _. apply forallb_forall. intros g _.
        destruct (IsInner now f && NextInLink d f && NextInLink e f &&
          IsInner now g && NextInLink d g && NextInLink e g) eqn:B; [|reflexivity].
        rewrite !andb_true_iff in B. destruct B as (((((Pf & Df) & Ef) & Pg) & Dg) & Eg).
        apply InnerAt in Pf, Pg. apply (NextInLinkMeans z) in T, Df, Ef, Dg, Eg.
        assert (Q : at_ f = at_ g).
        { apply (W (at_ d) (at_ e)); try assumption; eexists; reflexivity. }
        apply OffsetsDiffer in Q. subst g. apply SameDirectionRefl.
  Qed.
End Vertex.
