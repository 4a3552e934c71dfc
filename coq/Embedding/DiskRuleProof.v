(** * The rule of the strict disk, turn by turn *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Embedding.GreedyProof Embedding.LeavingProof
  Embedding.LinkProof Embedding.DiskStepProof.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpVertex Settled StrictDisk].

(** No two neighbours that are violated have the same turn. *)
Definition TakeTurns (th : Thresholds) (sign : SignField) (cut : CutField)
  (turn : Coord3 -> nat) : Prop :=
  forall v d, let u := Translate v (Offset d) in
    Violated th sign cut v = true -> Violated th sign cut u = true ->
    turn v <> turn u.

Section Rule.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Variable turn : Coord3 -> nat.

  Hypothesis Decided : forall v, sign v <> OnSurface.
  Hypothesis Turns : TakeTurns th sign cut turn.

  Local Notation settled := (Settled th sign cut turn).
  Local Notation now := (SignNow th sign cut turn).

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

  (** Who changes becomes 0 in that turn. *)
  Lemma NowStep n v : now (S n) v = now n v \/
    now (S n) v = OnSurface /\ now n v <> OnSurface /\
    settled (S n) v = true /\ settled n v = false.
  Proof.
    destruct (settled n v) eqn:N; [left|destruct (settled (S n) v) eqn:S'; [right|left]].
    - unfold SignNow. rewrite (SettledStays n v N), N. reflexivity.
    - split; [apply NowZero, S'|]. split; [rewrite NowZero; congruence|auto].
    - unfold SignNow. rewrite S', N. reflexivity.
  Qed.

  Lemma ChangesApart n u v : now (S n) u <> now n u -> now (S n) v <> now n v ->
    ~ Adjacent u v.
  Proof.
    intros U V. destruct (NowStep n u) as [|(_ & _ & U' & Nu)]; [contradiction|].
    destruct (NowStep n v) as [|(_ & _ & V' & Nv)]; [contradiction|].
    exact (NotAdjacent n u v U' Nu V' Nv).
  Qed.

  (** ** No walls *)

  Lemma NoWallByTurns n : NoWallIn (now n).
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
        apply (DiskSees (now n) c D a b p q); try apply NowZero; auto using AdjacentMutual.
      + destruct (SettledMeans n b B B') as (_ & _ & D).
        apply (DiskSees (now n) b D a c p q); try apply NowZero; auto using AdjacentMutual.
      + destruct (NotAdjacent n b c B B' C C' Bc).
      + destruct (SettledMeans n a A A') as (_ & _ & D).
        apply (DiskSees (now n) a D b c p q); try apply NowZero; auto.
      + destruct (NotAdjacent n a c A A' C C' Ac).
      + destruct (NotAdjacent n a b A A' B B' Ab).
      + destruct (NotAdjacent n a b A A' B B' Ab).
  Qed.

  (** ** Nobody is lost *)

  Variable all : list Coord3.
  Hypothesis Bounded : forall v, sign v = Plus -> In v all.

  Lemma NowMayLeave n v : settled (S n) v = true -> settled n v = false ->
    sign v = Plus -> MayLeave Coord3 Adjacent (fun x => now n x = Plus) v.
  Proof.
    intros S S' P. destruct (SettledMeans n v S S') as (_ & _ & D).
    split; [apply NowPlus; auto|]. split; [apply NeverAdjacent|].
    exact (InsideAround (now n) v D).
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
    intros S S'. destruct (SettledMeans n v S S') as (_ & _ & D).
    split; [unfold outside; rewrite NowPlus, S; intros [H _]; discriminate H|].
    split; [apply NeverAdjacent|].
    apply (PieceAround v (fun d => negb (IsInner (LinkOf (now n) v) d))).
    - unfold StrictDisk in D. rewrite !andb_true_iff in D. apply D.
    - intros d. set (u := Translate v (Offset d)).
      assert (E : outside n u <-> outside (Datatypes.S n) u).
      { split; [apply NowOutsideLater|]. intros O P. apply O, NowPlus.
        apply NowPlus in P. split; [|tauto].
        destruct (settled (Datatypes.S n) u) eqn:R; [|reflexivity].
        exfalso. apply (NotAdjacent n v u); try tauto. exists d. reflexivity. }
      rewrite <- E. unfold outside, IsInner, LinkOf. fold u.
      destruct (now n u); split; cbn; congruence.
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
    apply NoWallInMesh. intros a b c p q. rewrite !AfterDisk.
    apply NoWallByTurns.
  Qed.
End Rule.
