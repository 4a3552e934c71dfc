(** * The link of a vertex: what its checks tell *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Lattice.DirectionProof Angles.Cases.Isometry
  Embedding.LeavingProof.

Lemma NeverAdjacent v : ~ Adjacent v v.
Proof.
  intros [d E]. destruct v as [x y z], d; cbn [Translate Offset] in E;
    injection E; lia.
Qed.

Lemma SameDirectionRefl d : SameDirection d d = true.
Proof. destruct d; reflexivity. Qed.

Lemma AdjacentMutual u v : Adjacent u v -> Adjacent v u.
Proof.
  intros [d ->]. exists (Backward d). symmetry. apply ThereAndBack.
Qed.

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

  Local Notation at_ d := (Translate v (Offset d)).

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
