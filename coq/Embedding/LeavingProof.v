(** * Whoever leaves so, no piece is lost, cut or joined to another: proof *)

From Certet Require Import Embedding.Definitions.

Section Joined.
  Variables (V : Type) (inside : V -> Prop) (next : V -> V -> Prop).

  Lemma JoinedInside u v : Joined inside next u v -> inside u /\ inside v.
  Proof. induction 1; tauto. Qed.

  Lemma JoinedThen u v w :
    Joined inside next u v -> Joined inside next v w -> Joined inside next u w.
  Proof.
    intros A. induction 1 as [v I|v x w J IH N I]; [exact A|].
    exact (Joined_step _ _ u x w (IH A) N I).
  Qed.

  Lemma JoinedNext u v : inside u -> next u v -> inside v ->
    Joined inside next u v.
  Proof. intros U N W. exact (Joined_step _ _ u u v (Joined_here _ _ u U) N W). Qed.

  Hypothesis Mutual : forall u v, next u v -> next v u.

  Lemma JoinedBack u v : Joined inside next u v -> Joined inside next v u.
  Proof.
    induction 1 as [v I|u v w A IH N I]; [constructor; exact I|].
    apply (JoinedThen w v u); [|exact IH].
    apply JoinedNext; [exact I|apply Mutual, N|]. apply JoinedInside in A. tauto.
  Qed.
End Joined.

Lemma JoinedWider {V} (inside inside' : V -> Prop) next u v :
  (forall x, inside x -> inside' x) ->
  Joined inside next u v -> Joined inside' next u v.
Proof.
  intros W. induction 1 as [v I|u x w J IH N I]; [constructor; auto|].
  exact (Joined_step _ _ u x w IH N (W w I)).
Qed.

Section Leaving.
  Variables (V : Type) (next : V -> V -> Prop).
  Variable Same : forall u v : V, {u = v} + {u <> v}.
  Hypothesis Mutual : forall u v, next u v -> next v u.

  Section One.
    Variables (v : V) (inside now : V -> Prop).
    Hypothesis L : Leaves next v inside now.

    Lemma NowInside u : now u -> inside u.
    Proof.
      destruct L as (_ & N & E & _). intros H.
      apply E; [|exact H]. intros ->. exact (N H).
    Qed.

    (** What was joined to some point is so now, or [v] is the point; then all
        its neighbours are joined. *)
    Lemma StillJoined u w : now u -> Joined inside next u w ->
      (w <> v -> Joined now next u w) /\
      (w = v -> forall x, next v x -> now x -> Joined now next u x).
    Proof.
      destruct L as (_ & N & E & _ & Around). intros U.
      induction 1 as [w I|u x w J IH S I].
      - split; [constructor; exact U|]. intros ->. contradiction.
      - destruct (IH U) as [Far Near]. destruct (Same x v) as [->|D].
        + split; [|congruence || (intros ->; intros y Y Ny; exact (Near eq_refl y Y Ny))].
          intros W. apply (Near eq_refl); [exact S|apply E; assumption].
        + specialize (Far D). split.
          * intros W. apply (Joined_step _ _ u x w Far S). apply E; assumption.
          * intros -> y Y Ny. apply (JoinedThen _ _ _ u x y Far).
            apply (JoinedWider (fun x => now x /\ next v x) now); [tauto|].
            apply Around; auto. apply JoinedInside in Far. tauto.
    Qed.

    Lemma LeavingKeepsPieces u w : now u -> now w ->
      Joined inside next u w <-> Joined now next u w.
    Proof.
      intros U W. split.
      - intros J. apply (proj1 (StillJoined u w U J)). destruct L as (_ & N & _).
        intros ->. exact (N W).
      - apply JoinedWider. exact NowInside.
    Qed.

    Lemma LeavingLosesNoPiece u : inside u ->
      exists w, now w /\ Joined inside next u w.
    Proof.
      destruct L as (I & _ & E & (x & S & X) & _). intros U.
      destruct (Same u v) as [->|D].
      - exists x. split; [exact X|]. apply JoinedNext; auto using NowInside.
      - exists u. split; [apply E; assumption|constructor; exact U].
    Qed.
  End One.

  Theorem KeepsPieces inside now : AllLeave next inside now ->
    forall u w, now u -> now w ->
      Joined inside next u w <-> Joined now next u w.
  Proof.
    induction 1 as [inside now E|v inside then_ now _ IH L]; intros u w U W.
    - split; apply JoinedWider; apply E.
    - rewrite IH by (eapply NowInside; eauto).
      apply (LeavingKeepsPieces v); assumption.
  Qed.

  Theorem LosesNoPiece inside now : AllLeave next inside now ->
    forall u, inside u -> exists w, now w /\ Joined inside next u w.
  Proof.
    induction 1 as [inside now E|v inside then_ now A IH L]; intros u U.
    - exists u. split; [apply E, U|constructor; exact U].
    - destruct (IH u U) as (x & X & J).
      destruct (LeavingLosesNoPiece v then_ now L x X) as (w & W & K).
      exists w. split; [exact W|]. apply (JoinedThen _ _ _ u x w J).
      apply (KeepsPieces inside then_ A); [exact X| |exact K].
      exact (NowInside v then_ now L w W).
  Qed.
End Leaving.

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
