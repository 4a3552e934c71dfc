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
