(** * The rule of the strict disk keeps pieces: proof *)

From Coq Require Import ZArith List Bool Lia.
From Certet Require Import Lattice.Coord3 Lattice.Direction.
From Certet Require Import Lattice.StructuredTet.
From Certet Require Import Stencil.UnstructuredTet.
From Certet Require Import Warp.Cut Warp.Warp Stuffing.Stuffing.
From Certet Require Import Angles.AnglesSpec Angles.Isometry.
From Certet Require Import Embedding.EmbeddingSpec Embedding.PiecesSpec.
From Certet Require Import Embedding.WarpOrClamp Embedding.DiskRule.
From Certet Require Import Embedding.EdgeRank Embedding.GreedyProof.
From Certet Require Import Embedding.LeavingProof Embedding.PiecesProof.
Import ListNotations.

(** ** The link *)

Lemma SameDirectionMeans d e : SameDirection d e = true -> d = e.
Proof. destruct d, e; intros H; reflexivity || discriminate H. Qed.

Lemma NextInLinkMeans v d e : NextInLink d e = true <->
  Adjacent (Translate v (Offset d)) (Translate v (Offset e)).
Proof.
  unfold NextInLink. rewrite existsb_exists. unfold Adjacent. split.
  - intros (f & _ & E). exists f. apply Coord3EqualTrue in E. rewrite E.
    destruct v, (Offset d), (Offset e). cbn [Difference Translate]. f_equal; ring.
  - intros [f E]. exists f. split; [apply InAllDirections|].
    replace (Difference (Offset d) (Offset e)) with (Offset f);
      [apply Coord3EqualRefl|].
    destruct v, (Offset d), (Offset e), (Offset f). cbn [Difference Translate] in *.
    injection E as X Y Z. f_equal; lia.
Qed.

Section Flood.
  Variables (v : Coord3) (part : Direction -> bool).

  (** The neighbours of [v] in that part. *)
  Definition InPart (x : Coord3) : Prop :=
    exists d, x = Translate v (Offset d) /\ part d = true.

  Notation at_ d := (Translate v (Offset d)).

  Lemma FloodJoined first steps : forall reached,
    (forall d, In d reached -> Joined InPart Adjacent (at_ first) (at_ d)) ->
    forall d, In d (Flood steps part reached) ->
      Joined InPart Adjacent (at_ first) (at_ d).
  Proof.
    induction steps as [|fewer IH]; intros reached R d I; [exact (R d I)|].
    cbn [Flood] in I. revert d I. apply IH. intros d I.
    apply filter_In in I. destruct I as [_ I]. apply andb_prop in I.
    destruct I as [P I]. apply existsb_exists in I. destruct I as (e & J & I).
    apply orb_prop in I. destruct I as [I|I].
    - apply SameDirectionMeans in I. subst e. exact (R d J).
    - apply (Joined_step _ _ _ (at_ e)); [exact (R e J)| |exists d; auto].
      apply NextInLinkMeans, I.
  Qed.

  Lemma OnePieceMeans : OnePiece part = true ->
    (exists x, InPart x) /\
    forall x y, InPart x -> InPart y -> Joined InPart Adjacent x y.
  Proof.
    unfold OnePiece. destruct (filter part AllDirections) as [|first rest] eqn:F;
      [discriminate|].
    assert (P : part first = true).
    { apply (proj1 (filter_In part first AllDirections)). rewrite F. left. reflexivity. }
    intros C. rewrite forallb_forall in C.
    assert (R : forall x, InPart x -> Joined InPart Adjacent (at_ first) x).
    { intros x (d & -> & D). specialize (C d (InAllDirections d)).
      rewrite D in C. apply existsb_exists in C. destruct C as (e & I & E).
      apply SameDirectionMeans in E. subst e. revert I. apply FloodJoined.
      intros e [<-|[]]. constructor. exists first. auto. }
    split; [exists (at_ first), first; auto|]. intros x y X Y.
    apply (JoinedThen _ _ _ x (at_ first) y); [|exact (R y Y)].
    apply JoinedBack; [exact AdjacentMutual|exact (R x X)].
  Qed.
End Flood.

(** ** Many leave at once *)

Lemma AllLeaveSame {V} (next : V -> V -> Prop) inside now now' :
  AllLeave next inside now -> (forall u, now u <-> now' u) ->
  AllLeave next inside now'.
Proof.
  intros A E. destruct A as [inside now S|v inside then_ now A L].
  - apply AllLeave_none. intros u. rewrite <- E. apply S.
  - apply (AllLeave_one _ v inside then_ now' A).
    destruct L as (I & N & O & (u & X & U) & J).
    split; [exact I|]. split; [rewrite <- E; exact N|].
    split; [intros w W; rewrite <- E; apply O, W|].
    split; [exists u; rewrite <- E; auto|].
    intros x w Nx Nw X' W'. rewrite <- E in X', W'.
    apply (JoinedWider (fun y => now y /\ next v y));
      [intros y; rewrite E; tauto|auto].
Qed.

Lemma AllLeaveThen {V} (next : V -> V -> Prop) inside then_ now :
  AllLeave next inside then_ -> AllLeave next then_ now -> AllLeave next inside now.
Proof.
  intros A. induction 1 as [then_ now E|v then_ mid now _ IH L].
  - apply (AllLeaveSame next inside then_ now A). intros u. symmetry. apply E.
  - exact (AllLeave_one next v inside mid now (IH A) L).
Qed.

Section Many.
  Variables (V : Type) (next : V -> V -> Prop).
  Variable Same : forall u v : V, {u = v} + {u <> v}.
  Variables (first inside : V -> Prop).

  (** What [v] must find among its neighbours. *)
  Definition MayLeave (v : V) : Prop :=
    inside v /\ ~ next v v /\ (exists u, next v u /\ inside u) /\
    forall u w, next v u -> next v w -> inside u -> inside w ->
      Joined (fun x => inside x /\ next v x) next u w.

  Lemma ManyLeave vs : AllLeave next first inside ->
    (forall v, In v vs -> MayLeave v) ->
    (forall u v, In u vs -> In v vs -> ~ next u v) ->
    AllLeave next first (fun x => inside x /\ ~ In x vs).
  Proof.
    intros A. induction vs as [|v vs IH]; intros M N.
    - apply (AllLeaveSame next first inside _ A). cbn. tauto.
    - assert (T : AllLeave next first (fun x => inside x /\ ~ In x vs))
        by (apply IH; intros; [apply M|apply N]; right; assumption).
      destruct (in_dec Same v vs) as [I|I].
      + apply (AllLeaveSame next first _ _ T). intros u. cbn [In].
        split; [|tauto]. intros [U W]. split; [exact U|].
        intros [<-|K]; contradiction.
      + destruct (M v (or_introl eq_refl)) as (P & S & (u & X & U) & J).
        assert (Free : forall x, next v x -> inside x ->
          inside x /\ ~ In x (v :: vs)).
        { intros x Nx Ix. split; [exact Ix|]. intros [<-|K]; [exact (S Nx)|].
          exact (N v x (or_introl eq_refl) (or_intror K) Nx). }
        apply (AllLeave_one next v first _ _ T).
        split; [auto|]. split; [cbn [In]; tauto|].
        split; [intros w W; cbn [In]; split; [tauto|]|].
        { intros [Iw Nw]. split; [exact Iw|]. intros [E|K]; [congruence|contradiction]. }
        split; [exists u; auto|].
        intros x w Nx Nw [Ix _] [Iw _].
        apply (JoinedWider (fun x => inside x /\ next v x)); [|auto].
        intros y [Iy Ny]. split; [apply Free; assumption|exact Ny].
  Qed.
End Many.

(** ** The rule *)

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpVertex Settled StrictDisk].

Section Rule.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Variable turn : Coord3 -> nat.

  Hypothesis Decided : forall v, sign v <> OnSurface.
  Hypothesis Turns : forall v d, let u := Translate v (Offset d) in
    Violated th sign cut v = true -> Violated th sign cut u = true ->
    turn v <> turn u.

  Notation settled := (Settled th sign cut turn).
  Notation now := (SignNow th sign cut turn).

  Lemma SettledMeans n v : settled (S n) v = true -> settled n v = false ->
    turn v = n /\ Violated th sign cut v = true /\
    StrictDisk (fun d => now n (Translate v (Offset d))) = true.
  Proof.
    cbn [Settled]. intros E N. rewrite N in E. cbn [orb] in E.
    apply andb_prop in E. destruct E as [E D]. apply andb_prop in E.
    destruct E as [T V]. apply Nat.eqb_eq in T. auto.
  Qed.

  Lemma SettledViolated n v : settled n v = true -> Violated th sign cut v = true.
  Proof.
    induction n as [|n IH]; [discriminate|]. intros E.
    destruct (settled n v) eqn:N; [auto|]. apply (SettledMeans n v E N).
  Qed.

  Lemma SettledStays n v : settled n v = true -> settled (S n) v = true.
  Proof. intros E. cbn [Settled]. rewrite E. reflexivity. Qed.

  Lemma NowZero n v : now n v = OnSurface <-> settled n v = true.
  Proof.
    unfold SignNow. destruct (settled n v); [tauto|].
    split; [intros E; destruct (Decided v E)|discriminate].
  Qed.

  Lemma NowPlus n v : now n v = Plus <-> settled n v = false /\ sign v = Plus.
  Proof.
    unfold SignNow. destruct (settled n v); [|tauto].
    split; [discriminate|intros [E _]; discriminate E].
  Qed.

  (** Who become 0 in one turn are not adjacent. *)
  Lemma NotAdjacent n u v : settled (S n) u = true -> settled n u = false ->
    settled (S n) v = true -> settled n v = false -> ~ Adjacent u v.
  Proof.
    intros U U' V V' [d ->].
    destruct (SettledMeans n u U U') as (Tu & Vu & _).
    destruct (SettledMeans n _ V V') as (Tv & Vv & _).
    apply (Turns u d Vu Vv). congruence.
  Qed.

  (** ** No walls *)

  Definition NoWallNow (n : nat) : Prop :=
    forall a b c p q,
      Adjacent a b -> Adjacent a c -> Adjacent b c ->
      Adjacent a p -> Adjacent b p -> Adjacent c p ->
      Adjacent a q -> Adjacent b q -> Adjacent c q ->
      now n a = OnSurface -> now n b = OnSurface -> now n c = OnSurface ->
      now n p = Plus -> now n q = Plus -> p = q.

  (** The link of [a] sees it when [a] is the last. *)
  Lemma SeenFrom n a b c p q :
    Adjacent a b -> Adjacent a c -> Adjacent b c ->
    Adjacent a p -> Adjacent b p -> Adjacent c p ->
    Adjacent a q -> Adjacent b q -> Adjacent c q ->
    StrictDisk (fun d => now n (Translate a (Offset d))) = true ->
    now n b = OnSurface -> now n c = OnSurface ->
    now n p = Plus -> now n q = Plus -> p = q.
  Proof.
    intros [d ->] [e ->] Bc [f ->] Bp Cp [g ->] Bq Cq D B C P Q.
    unfold StrictDisk in D. apply andb_prop in D. destruct D as [_ D].
    rewrite forallb_forall in D. specialize (D d (InAllDirections d)).
    unfold IsZero in D. rewrite B in D. cbn [negb orb] in D.
    apply andb_prop in D. destruct D as [_ D].
    rewrite forallb_forall in D. specialize (D e (InAllDirections e)).
    rewrite C, (proj2 (NextInLinkMeans a d e) Bc) in D. cbn [negb orb andb] in D.
    unfold NoWallBetween, IsInner in D.
    rewrite forallb_forall in D. specialize (D f (InAllDirections f)).
    rewrite forallb_forall in D. specialize (D g (InAllDirections g)).
    rewrite P, Q, (proj2 (NextInLinkMeans a d f) Bp),
      (proj2 (NextInLinkMeans a e f) Cp), (proj2 (NextInLinkMeans a d g) Bq),
      (proj2 (NextInLinkMeans a e g) Cq) in D.
    cbn [negb orb andb] in D. apply SameDirectionMeans in D. subst g. reflexivity.
  Qed.

  Lemma NoWallEver n : NoWallNow n.
  Proof.
    induction n as [|n IH].
    - intros a b c p q _ _ _ _ _ _ _ _ _ A. apply NowZero in A. discriminate A.
    - intros a b c p q Ab Ac Bc Ap Bp Cp Aq Bq Cq A B C P Q.
      apply NowZero in A, B, C.
      assert (Before : forall x, now (S n) x = Plus -> now n x = Plus).
      { intros x X. apply NowPlus in X. apply NowPlus. split; [|tauto].
        destruct (settled n x) eqn:E; [|reflexivity].
        destruct X as [X _]. rewrite (SettledStays n x E) in X. discriminate X. }
      apply Before in P, Q.
      destruct (settled n a) eqn:A', (settled n b) eqn:B', (settled n c) eqn:C'.
      + apply (IH a b c); try assumption; apply NowZero; assumption.
      + destruct (SettledMeans n c C C') as (_ & _ & D).
        apply (SeenFrom n c a b p q); try apply NowZero; auto using AdjacentMutual.
      + destruct (SettledMeans n b B B') as (_ & _ & D).
        apply (SeenFrom n b a c p q); try apply NowZero; auto using AdjacentMutual.
      + destruct (NotAdjacent n b c B B' C C' Bc).
      + destruct (SettledMeans n a A A') as (_ & _ & D).
        apply (SeenFrom n a b c p q); try apply NowZero; auto.
      + destruct (NotAdjacent n a c A A' C C' Ac).
      + destruct (NotAdjacent n a b A A' B B' Ab).
      + destruct (NotAdjacent n a b A A' B B' Ab).
  Qed.

  (** ** Nobody is lost *)

  Variable all : list Coord3.
  Hypothesis Bounded : forall v, sign v = Plus -> In v all.

  Lemma NeverNext v : ~ Adjacent v v.
  Proof.
    intros [d E]. destruct v as [x y z], d; cbn [Translate Offset] in E;
      injection E; lia.
  Qed.

  Lemma NowMayLeave n v : settled (S n) v = true -> settled n v = false ->
    sign v = Plus -> MayLeave Coord3 Adjacent (fun x => now n x = Plus) v.
  Proof.
    intros S S' P. destruct (SettledMeans n v S S') as (_ & _ & D).
    unfold StrictDisk in D. apply andb_prop in D. destruct D as [D _].
    apply andb_prop in D. destruct D as [D _].
    destruct (OnePieceMeans v _ D) as [(x & X) J].
    assert (E : forall y, InPart v (IsInner (fun d => now n (Translate v (Offset d)))) y
      <-> now n y = Plus /\ Adjacent v y).
    { intros y. unfold InPart, IsInner, Adjacent. split.
      - intros (d & -> & I). split; [|eauto].
        destruct (now n (Translate v (Offset d))); congruence.
      - intros (I & d & ->). exists d. rewrite I. auto. }
    split; [apply NowPlus; auto|]. split; [apply NeverNext|].
    split; [exists x; apply E in X; tauto|].
    intros u w U W Iu Iw.
    apply (JoinedWider (InPart v (IsInner (fun d => now n (Translate v (Offset d))))));
      [intros y Y; apply E, Y|]. apply J; apply E; auto.
  Qed.

  (** The + vertices that become 0 in one turn. *)
  Definition Leaving (n : nat) : list Coord3 :=
    filter (fun v => settled (S n) v && negb (settled n v) &&
      match sign v with Plus => true | _ => false end) all.

  Lemma LeavingMeans n v : In v (Leaving n) <->
    settled (S n) v = true /\ settled n v = false /\ sign v = Plus.
  Proof.
    unfold Leaving. rewrite filter_In, !andb_true_iff, negb_true_iff. split.
    - intros (_ & (A & B) & C). repeat split; try assumption.
      destruct (sign v); congruence.
    - intros (A & B & C). rewrite C. auto.
  Qed.

  Lemma AllLeaveByTurns n :
    AllLeave Adjacent (PlusBefore sign) (fun v => now n v = Plus).
  Proof.
    induction n as [|n IH].
    - apply AllLeave_none. intros v. rewrite NowPlus. unfold PlusBefore. cbn [Settled].
      tauto.
    - apply (AllLeaveSame Adjacent _ (fun v => now n v = Plus /\ ~ In v (Leaving n))).
      + apply (ManyLeave Coord3 Adjacent SamePoint3); [exact IH| |].
        * intros v I. apply LeavingMeans in I. apply NowMayLeave; tauto.
        * intros u v I J. apply LeavingMeans in I, J. apply (NotAdjacent n); tauto.
      + intros v. rewrite LeavingMeans, !NowPlus. pose proof (SettledStays n v).
        destruct (settled (S n) v), (settled n v), (sign v); intuition congruence.
  Qed.

  (** ** Nor is anybody outside *)

  Let outside n v := now n v <> Plus.

  Lemma NowOutsideLater n v : outside n v -> outside (S n) v.
  Proof.
    unfold outside. intros O P. apply O. apply NowPlus in P. apply NowPlus.
    split; [|tauto]. destruct (settled n v) eqn:E; [|reflexivity].
    rewrite (SettledStays n v E) in P. tauto.
  Qed.

  Lemma OutsideMayLeave n v : settled (S n) v = true -> settled n v = false ->
    MayLeave Coord3 Adjacent (outside (S n)) v.
  Proof.
    intros S S' . destruct (SettledMeans n v S S') as (_ & _ & D).
    unfold StrictDisk in D. apply andb_prop in D. destruct D as [D _].
    apply andb_prop in D. destruct D as [_ D].
    destruct (OnePieceMeans v _ D) as [(x & X) J].
    set (part := fun d => negb (IsInner (fun d => now n (Translate v (Offset d))) d))
      in *.
    assert (E : forall y, InPart v part y <-> outside (Datatypes.S n) y /\ Adjacent v y).
    { intros y. unfold InPart, part, IsInner, Adjacent. split.
      - intros (d & -> & I). split; [|eauto]. apply NowOutsideLater. unfold outside.
        destruct (now n (Translate v (Offset d))); discriminate.
      - intros (I & d & ->). exists d. split; [reflexivity|].
        destruct (now n (Translate v (Offset d))) eqn:P; try reflexivity.
        exfalso. apply NowPlus in P. destruct P as [P Q].
        apply I, NowPlus. split; [|exact Q].
        destruct (settled (Datatypes.S n) (Translate v (Offset d))) eqn:R;
          [|reflexivity].
        exfalso. apply (NotAdjacent n v (Translate v (Offset d))); auto. exists d.
        reflexivity. }
    split; [unfold outside; rewrite NowPlus, S; intros [H _]; discriminate H|].
    split; [apply NeverNext|].
    split; [exists x; apply E in X; tauto|].
    intros u w U W Iu Iw.
    apply (JoinedWider (InPart v part)); [intros y Y; apply E, Y|].
    apply J; apply E; auto.
  Qed.

  Lemma OutsideByTurns n : AllLeave Adjacent (outside n) (fun v => sign v <> Plus).
  Proof.
    induction n as [|n IH].
    - apply AllLeave_none. intros v. unfold outside. rewrite NowPlus. cbn [Settled].
      tauto.
    - apply (AllLeaveThen Adjacent _ (outside n)); [|exact IH].
      apply (AllLeaveSame Adjacent _
        (fun v => outside (S n) v /\ ~ In v (Leaving n))).
      + apply (ManyLeave Coord3 Adjacent SamePoint3).
        * apply AllLeave_none. tauto.
        * intros v I. apply LeavingMeans in I. apply OutsideMayLeave; tauto.
        * intros u v I J. apply LeavingMeans in I, J. apply (NotAdjacent n); tauto.
      + intros v. unfold outside. rewrite LeavingMeans, !NowPlus.
        pose proof (SettledStays n v).
        destruct (settled (S n) v), (settled n v), (sign v); intuition congruence.
  Qed.

  (** ** The mesh *)

  Variables (turns : nat) (limit : Coord3 -> Z).

  Let warping := RuledWarping th sign cut (DiskStays th sign cut turn turns) limit.

  Lemma AfterDisk v : PlacedSign sign warping (Corner v) = now turns v.
  Proof.
    unfold warping, SignNow. cbn [PlacedSign]. unfold RuledWarping, DiskStays.
    destruct (WarpVertex th sign cut v) as [|d t] eqn:W.
    - destruct (settled turns v) eqn:S; [|reflexivity].
      apply SettledViolated in S. unfold Violated in S. rewrite W in S. discriminate S.
    - destruct (settled turns v); reflexivity.
  Qed.

  Theorem DiskAllLeave : AllLeave Adjacent (PlusBefore sign) (PlusAfter sign warping).
  Proof.
    apply (AllLeaveSame _ _ _ _ (AllLeaveByTurns turns)).
    intros v. unfold PlusAfter. rewrite AfterDisk. tauto.
  Qed.

  Theorem DiskOutsideLeave : AllLeave Adjacent
    (fun v => ~ PlusAfter sign warping v) (fun v => ~ PlusBefore sign v).
  Proof.
    apply (AllLeaveThen Adjacent _ (outside turns)).
    - apply AllLeave_none. intros v. unfold PlusAfter, outside.
      rewrite AfterDisk. tauto.
    - apply (AllLeaveSame _ _ _ _ (OutsideByTurns turns)).
      intros v. unfold PlusBefore. tauto.
  Qed.

  Theorem DiskNoWall : NoWall sign warping.
  Proof.
    intros a b c p q Nab Nbc Nac Z P Q (tid & _ & I) (tid' & _ & J).
    unfold PlusAfter in P, Q. rewrite AfterDisk in P, Q.
    assert (Z' : forall v, In v [a; b; c] -> now turns v = OnSurface)
      by (intros v V; rewrite <- AfterDisk; auto).
    assert (N : forall v x, In v [a; b; c] -> now turns x = Plus -> v <> x)
      by (intros v x V X ->; rewrite (Z' x V) in X; discriminate X).
    assert (E : forall own u v, incl [a; b; c; own] (Corners tid) ->
      In u [a; b; c; own] -> In v [a; b; c; own] -> u <> v -> Adjacent u v).
    { intros own u v Sub U V D.
      destruct (EdgeBetween tid u v (Sub u U) (Sub v V) D) as [d X]. exists d. exact X. }
    assert (E' : forall own u v, incl [a; b; c; own] (Corners tid') ->
      In u [a; b; c; own] -> In v [a; b; c; own] -> u <> v -> Adjacent u v).
    { intros own u v Sub U V D.
      destruct (EdgeBetween tid' u v (Sub u U) (Sub v V) D) as [d X]. exists d. exact X. }
    cbn [In] in *.
    apply (NoWallEver turns a b c p q); auto 6.
    1-3: apply (E p); cbn [In]; auto.
    1-3: apply (E p); cbn [In]; auto 6.
    1-3: apply (E' q); cbn [In]; auto 6.
  Qed.
End Rule.

(** ** The product's order *)

Lemma ColoursDiffer v d : Colour v <> Colour (Translate v (Offset d)).
Proof.
  destruct v as [x y z], d; cbn [Offset Translate Colour].
  all: repeat match goal with |- context [Z.even ?n] =>
    pose proof (Zmod_even n); destruct (Z.even n) end; try discriminate.
  all: intros _; Z.div_mod_to_equations; lia.
Qed.

Lemma TurnsDiffer th sign cut v d :
  Violated th sign cut v = true ->
  Violated th sign cut (Translate v (Offset d)) = true ->
  Turn th sign cut v <> Turn th sign cut (Translate v (Offset d)).
Proof.
  unfold Violated, Turn. set (u := Translate v (Offset d)).
  destruct (WarpVertex th sign cut v) as [|e t]; [discriminate|].
  destruct (WarpVertex th sign cut u) as [|e' t']; [discriminate|]. intros _ _ E.
  apply (ColoursDiffer v d). fold u.
  assert (B : forall w, (Colour w < 4)%nat)
    by (intros [x y z]; cbn [Colour]; destruct (Z.even x), (Z.even _); cbn; lia).
  pose proof (B v). pose proof (B u). clear B.
  generalize dependent (Z.to_nat (4 * t / ThresholdSteps th (DirectionKind e))).
  generalize dependent (Z.to_nat (4 * t' / ThresholdSteps th (DirectionKind e'))).
  destruct (sign v), (sign u); intros; lia.
Qed.

Theorem DiskMakesNoWall th sign cut limit : (forall v, sign v <> OnSurface) ->
  NoWall sign (RuledWarping th sign cut (DiskRule th sign cut) limit).
Proof. intros D. apply DiskNoWall; [exact D|apply TurnsDiffer]. Qed.

(** The pieces of the mesh by faces are the pieces of the samples by edges, *)
Theorem DiskPiecesKept th sign cut limit all p q t u :
  let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
  (forall v, sign v <> OnSurface) -> (forall v, sign v = Plus -> In v all) ->
  PlusAfter sign warping p -> PlusAfter sign warping q ->
  MadeAt sign warping p t -> MadeAt sign warping q u ->
  Joined (InMesh sign warping) ShareFace t u <->
  Joined (PlusBefore sign) Adjacent p q.
Proof.
  intros warping D B. apply PiecesKept.
  - apply (DiskAllLeave th sign cut _ (TurnsDiffer th sign cut) all B).
  - apply DiskMakesNoWall, D.
Qed.

(** none is lost, *)
Theorem DiskNoPieceLost th sign cut limit all p :
  let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
  (forall v, sign v = Plus -> In v all) ->
  PlusBefore sign p -> (exists tid, OfLattice tid /\ In p (Corners tid)) ->
  exists q t, PlusAfter sign warping q /\ MadeAt sign warping q t /\
    Joined (PlusBefore sign) Adjacent p q.
Proof.
  intros warping B. apply NoPieceLost.
  apply (DiskAllLeave th sign cut _ (TurnsDiffer th sign cut) all B).
Qed.

(** and the same holds of the outside. *)
Theorem DiskOutsideKept th sign cut limit all p q :
  let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
  (forall v, sign v = Plus -> In v all) ->
  ~ PlusBefore sign p -> ~ PlusBefore sign q ->
  Joined (fun v => ~ PlusAfter sign warping v) Adjacent p q <->
  Joined (fun v => ~ PlusBefore sign v) Adjacent p q.
Proof.
  intros warping B P Q.
  refine (KeepsPieces _ _ SamePoint3 AdjacentMutual _ _ _ p q P Q).
  apply (DiskOutsideLeave th sign cut _ (TurnsDiffer th sign cut) all B).
Qed.

Theorem DiskMakesNoCavity th sign cut limit all p :
  let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
  (forall v, sign v = Plus -> In v all) -> ~ PlusAfter sign warping p ->
  exists q, ~ PlusBefore sign q /\
    Joined (fun v => ~ PlusAfter sign warping v) Adjacent p q.
Proof.
  intros warping B P.
  refine (LosesNoPiece _ _ SamePoint3 AdjacentMutual _ _ _ p P).
  apply (DiskOutsideLeave th sign cut _ (TurnsDiffer th sign cut) all B).
Qed.
