(** * The order: each violated vertex has a turn, and those of a colour are free *)

From Coq Require Import Permutation.
From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.Cases.AdmissibleProof Embedding.DiskTables
  Embedding.GreedyProof Embedding.DiskPiecesProof Embedding.SettleProof.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpVertex IsDisk PlaceIn].

(** ** Any fold *)

Section Fold.
  Variables (S B : Type) (f : S -> B -> S) (Same : S -> S -> Prop).
  Hypothesis Itself : forall s, Same s s.
  Hypothesis Onward : forall s s' s'', Same s s' -> Same s' s'' -> Same s s''.
  Hypothesis Kept : forall s s' b, Same s s' -> Same (f s b) (f s' b).

  Lemma FoldsSame l : forall s s', Same s s' ->
    Same (fold_left f l s) (fold_left f l s').
  Proof.
    induction l as [|b l IH]; intros s s' E; [exact E|].
    cbn [fold_left]. apply IH, Kept, E.
  Qed.

  Lemma FoldPermuted l l' : Permutation l l' ->
    (forall u v, In u l -> In v l -> forall s, Same (f (f s u) v) (f (f s v) u)) ->
    forall s, Same (fold_left f l s) (fold_left f l' s).
  Proof.
    induction 1 as [|x l l' P IH|x y l|l l' l'' P IH Q IH']; intros C s.
    - apply Itself.
    - cbn [fold_left]. apply IH. intros u v I J. apply C; right; assumption.
    - cbn [fold_left]. apply FoldsSame, C; cbn [In]; auto.
    - apply (Onward _ _ _ (IH C s)), IH'. intros u w I J.
      apply C; apply (Permutation_in _ (Permutation_sym P)); assumption.
  Qed.
End Fold.

(** ** Two turns *)

Section Order.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField) (gap : Gap).

  Local Notation one := (SettleOne th sign cut gap).

  (** [v] sees the same around it. *)
  Definition SameAround (zeros zeros' : Zeros) (v : Coord3) : Prop :=
    forall d, PlaceIn zeros (Translate v (Offset d))
              = PlaceIn zeros' (Translate v (Offset d)).

  Definition SamePlaces (zeros zeros' : Zeros) : Prop :=
    forall v, PlaceIn zeros v = PlaceIn zeros' v.

  Section Room.
    Variables (target : Coord3 -> Warping) (turn : Coord3 -> nat).

    Lemma RoomSame zeros zeros' v e t d : SameAround zeros zeros' v ->
      RoomBeside sign gap target turn zeros v e t d
      = RoomBeside sign gap target turn zeros' v e t d.
    Proof. intros A. unfold RoomBeside. cbv zeta. rewrite (A d). reflexivity. Qed.

    Lemma FoldSame {A B} (f g : A -> B -> A) l : (forall a b, f a b = g a b) ->
      forall a, fold_left f l a = fold_left g l a.
    Proof.
      intros E. induction l as [|b l IH]; intros a; [reflexivity|].
      cbn [fold_left]. rewrite E. apply IH.
    Qed.

    Lemma ShortenedSame zeros zeros' v e t : SameAround zeros zeros' v ->
      Shortened sign gap target turn zeros v e t
      = Shortened sign gap target turn zeros' v e t.
    Proof.
      intros A. unfold Shortened. destruct (DirectionKind e); [|reflexivity].
      apply FoldSame. intros s d. rewrite (RoomSame zeros zeros' v e t d A). reflexivity.
    Qed.
  End Room.

  Lemma LinkSame zeros zeros' v : SameAround zeros zeros' v ->
    LinkAmong sign zeros v = LinkAmong sign zeros' v.
  Proof.
    intros A. unfold LinkAmong, Gather, SignAmong. rewrite !(A _). reflexivity.
  Qed.

  (** What a turn does, by what its vertex sees. *)
  Lemma OneElsewhere zeros v u : u <> v -> PlaceIn (one zeros v) u = PlaceIn zeros u.
  Proof.
    intros N. unfold SettleOne. destruct (WarpVertex th sign cut v) as [|e t]; [reflexivity|].
    destruct (IsDisk _); [cbv zeta|reflexivity].
    destruct (StaysRather _ _ _ _ _); [reflexivity|apply PlacedElsewhere, N].
  Qed.

  Lemma OneHere zeros zeros' v : SameAround zeros zeros' v ->
    PlaceIn zeros v = PlaceIn zeros' v ->
    PlaceIn (one zeros v) v = PlaceIn (one zeros' v) v.
  Proof.
    intros A E. unfold SettleOne. rewrite (LinkSame zeros zeros' v A).
    destruct (WarpVertex th sign cut v) as [|e t]; [exact E|].
    cbv zeta. rewrite (ShortenedSame _ _ zeros zeros' v e t A).
    destruct (IsDisk _); [|exact E].
    destruct (StaysRather _ _ _ _ _); [exact E|rewrite !PlacedHere; reflexivity].
  Qed.

  Lemma OneSame zeros zeros' v : SamePlaces zeros zeros' ->
    SamePlaces (one zeros v) (one zeros' v).
  Proof.
    intros S u. destruct (SamePoint3 u v) as [->|N].
    - apply OneHere; [intros d; apply S|apply S].
    - rewrite !OneElsewhere by exact N. apply S.
  Qed.

  Lemma NotSeen zeros u v : ~ Adjacent v u -> SameAround (one zeros u) zeros v.
  Proof. intros N d. apply OneElsewhere. intros E. apply N. exists d. congruence. Qed.

  Lemma TwoSwapped zeros u v : ~ Adjacent u v -> ~ Adjacent v u ->
    SamePlaces (one (one zeros u) v) (one (one zeros v) u).
  Proof.
    intros Nu Nv. destruct (SamePoint3 u v) as [->|N]; [intros x; reflexivity|].
    assert (N' : v <> u) by congruence.
    intros x. destruct (SamePoint3 x u) as [->|Xu]; [|destruct (SamePoint3 x v) as [->|Xv]].
    - rewrite OneElsewhere by exact N. symmetry. apply OneHere.
      + apply NotSeen, Nu.
      + apply OneElsewhere, N.
    - rewrite (OneElsewhere _ u v N'). apply OneHere.
      + apply NotSeen, Nv.
      + apply OneElsewhere, N'.
    - rewrite !OneElsewhere; auto.
  Qed.
End Order.

Theorem ColourInAnyOrder th sign cut gap first class class' last :
  Permutation class class' ->
  (forall u v, In u class -> In v class -> Colour u = Colour v) ->
  forall v, PlaceIn (Settle th sign cut gap (first ++ class ++ last)) v
          = PlaceIn (Settle th sign cut gap (first ++ class' ++ last)) v.
Proof.
  intros P C. unfold Settle. rewrite !fold_left_app.
  assert (Itself : forall zeros, SamePlaces zeros zeros)
    by (intros zeros v; reflexivity).
  assert (Onward : forall z z' z'', SamePlaces z z' -> SamePlaces z' z'' ->
    SamePlaces z z'') by (intros z z' z'' E F v; rewrite (E v); apply F).
  pose proof (OneSame th sign cut gap) as Kept.
  apply (FoldsSame _ _ _ SamePlaces Kept).
  apply (FoldPermuted _ _ _ SamePlaces Itself Onward Kept _ _ P).
  intros u v I J zeros. pose proof (C u v I J) as E.
  apply TwoSwapped; intros [d ->]; [apply (ColoursDiffer u d)|apply (ColoursDiffer v d)];
    congruence.
Qed.

(** ** The order of the product *)

Section Turns.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Hypothesis OnEdges : CutsOnEdges sign cut.

  Lemma TurnInTime v : Violated th sign cut v = true ->
    (Turn th sign cut v < Turns)%nat.
  Proof.
    unfold Violated, Turn. destruct (WarpVertex th sign cut v) as [|d t] eqn:W;
      [discriminate|]. intros _.
    destruct (WarpedMeans th sign cut v d t W) as (E & O & L).
    pose proof (CutFromInRange sign cut OnEdges v d O) as R. rewrite <- E in R.
    assert (B : (4 * t / ThresholdSteps th (DirectionKind d) < 4)%Z)
      by (apply Z.div_lt_upper_bound; lia).
    assert (C : (Colour v < 4)%nat)
      by (destruct v as [x y z]; cbn [Colour];
          destruct (Z.even x), (Z.even _); cbn; lia).
    unfold Turns. generalize dependent (4 * t / ThresholdSteps th (DirectionKind d))%Z.
    intros q Q. destruct (sign v); lia.
  Qed.

  Theorem EachHasATurn vs v : In v (InTurn th sign cut vs) <->
    In v vs /\ Violated th sign cut v = true.
  Proof.
    unfold InTurn. cbv zeta. rewrite in_flat_map. split.
    - intros (n & _ & I). apply in_map_iff in I. destruct I as ((m & u) & <- & I).
      apply filter_In in I. destruct I as [I _]. apply in_map_iff in I.
      destruct I as (w & E & I). injection E as _ ->. apply filter_In, I.
    - intros [I V]. exists (Turn th sign cut v). split.
      + apply in_seq. pose proof (TurnInTime v V). lia.
      + apply in_map_iff. exists (Turn th sign cut v, v). split; [reflexivity|].
        apply filter_In. split; [|apply Nat.eqb_refl].
        apply in_map_iff. exists v. split; [reflexivity|]. apply filter_In. auto.
  Qed.
End Turns.
