(** * What the checks of a strict disk mean

    Each of them is complete as well as sound: a flood of thirteen rounds reaches
    all that can be reached, and at most two changes around a ring are one run.
    Both are checked for all sets of neighbours. *)

From Coq Require Import ZArith List Bool Arith Lia.
From Certet Require Import Lattice.Coord3 Lattice.Direction.
From Certet Require Import Stencil.UnstructuredTet.
From Certet Require Import Stuffing.Stuffing.
From Certet Require Import Angles.Cases.Isometry.
From Certet Require Import Embedding.PiecesSpec Embedding.DiskRule.
From Certet Require Import Embedding.DiskTables Embedding.SettleSpec.
From Certet Require Import Embedding.LeavingProof Embedding.LinkProof.
From Certet Require Import Embedding.DiskTablesProof Embedding.DiskStepProof.
Import ListNotations.

(** ** All sets *)

(** What [P] says of all subsets, with what is chosen already. *)
Fixpoint AllSubsets (ds chosen : list Direction) (P : list Direction -> bool)
  : bool :=
  match ds with
  | [] => P chosen
  | d :: rest => AllSubsets rest chosen P && AllSubsets rest (d :: chosen) P
  end.

Lemma EachSubset f P ds : forall chosen, AllSubsets ds chosen P = true ->
  P (rev (filter f ds) ++ chosen) = true.
Proof.
  induction ds as [|d ds IH]; intros chosen A; [exact A|].
  cbn [AllSubsets] in A. apply andb_true_iff in A. destruct A as [N Y].
  cbn [filter]. destruct (f d); [|exact (IH chosen N)].
  cbn [rev]. rewrite <- app_assoc. exact (IH (d :: chosen) Y).
Qed.

Definition SetOf (chosen : list Direction) : Link bool :=
  Gather (fun d => existsb (SameDirection d) chosen).

Lemma AmongDirections d l : existsb (SameDirection d) l = true <-> In d l.
Proof.
  rewrite existsb_exists. split.
  - intros (e & I & E). apply SameDirectionMeans in E. congruence.
  - intros I. exists d. split; [exact I|apply SameDirectionRefl].
Qed.

Lemma AtSetOf f ds d :
  At (SetOf (rev (filter f ds) ++ [])) d = existsb (SameDirection d) ds && f d.
Proof.
  unfold SetOf. rewrite AtGather, app_nil_r. apply EqualIfBothWays.
  rewrite andb_true_iff, !AmongDirections, <- in_rev, filter_In. tauto.
Qed.

(** ** One piece *)

Definition Flooded (part : Link bool) (first : Direction) : Link bool :=
  SpreadFor 13 part (Gather (SameDirection first)).

(** The flood is over: it has its start, and one more round finds no more. *)
Definition NoMore (part reached : Link bool) (first : Direction) : bool :=
  At reached first &&
  forallb (fun d => At reached d || negb (At (Spread part reached) d))
    AllDirections.

Definition FloodOver (part : Link bool) : bool :=
  match filter (At part) AllDirections with
  | [] => true
  | first :: _ => NoMore part (Flooded part first) first
  end.

Lemma FloodsOver :
  AllSubsets AllDirections [] (fun chosen => FloodOver (SetOf chosen)) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [Flooded NoMore SpreadFor Spread].

Lemma FloodOverMeans part first rest : FloodOver part = true ->
  filter (At part) AllDirections = first :: rest ->
  NoMore part (Flooded part first) first = true.
Proof. unfold FloodOver. intros O E. rewrite E in O. exact O. Qed.

Lemma NoMoreMeans part reached first : NoMore part reached first = true ->
  At reached first = true /\
  forall d e, At part d = true -> NextInLink d e = true -> At reached e = true ->
    At reached d = true.
Proof.
  unfold NoMore. intros O. apply andb_true_iff in O. destruct O as [S C].
  split; [exact S|]. intros d e P N R. rewrite forallb_forall in C.
  specialize (C d (InAllDirections d)). apply orb_true_iff in C.
  destruct C as [C|C]; [exact C|]. exfalso.
  apply negb_true_iff, not_true_iff_false in C. apply C.
  unfold Spread. rewrite AtGather, P. cbn [andb]. apply orb_true_iff. right.
  apply existsb_exists. exists e. split; [apply InNeighborTable, N|exact R].
Qed.

Lemma InOnePieceMeans part first rest :
  filter (At part) AllDirections = first :: rest ->
  (forall d, At part d = true -> At (Flooded part first) d = true) ->
  InOnePiece part = true.
Proof.
  unfold InOnePiece. intros -> R. apply forallb_forall. intros d _.
  destruct (At part d) eqn:D; [exact (R d D)|reflexivity].
Qed.

Lemma DirectionsApart v d e :
  Translate v (Offset d) = Translate v (Offset e) -> d = e.
Proof.
  intros E. apply SameDirectionMeans. unfold SameDirection.
  destruct v as [x y z], (Offset d) as [a b c], (Offset e) as [a' b' c'].
  cbn [Translate] in E. injection E as X Y Z. cbn [Coord3Equal].
  rewrite !andb_true_iff, !Z.eqb_eq. lia.
Qed.

Section Pieces.
  Variables (v : Coord3) (part : Direction -> bool).
  Local Notation at_ d := (Translate v (Offset d)).

  Lemma OnePieceComplete : (exists x, InPart v part x) ->
    (forall x y, InPart v part x -> InPart v part y ->
       Joined (InPart v part) Adjacent x y) ->
    OnePiece part = true.
  Proof.
    intros (x & d0 & -> & D0) J.
    rewrite <- (InOnePieceCorrect (Gather part) part (AtGather part)).
    assert (T : SetOf (rev (filter part AllDirections) ++ []) = Gather part).
    { apply GatherSame. intros d. apply EqualIfBothWays.
      rewrite AmongDirections, app_nil_r, <- in_rev, filter_In.
      pose proof (InAllDirections d). tauto. }
    pose proof (EachSubset part _ _ [] FloodsOver) as O. cbv beta in O.
    rewrite T in O. clear T. pose proof (AtGather part) as E.
    generalize dependent (Gather part). intros table O E.
    assert (I : In d0 (filter (At table) AllDirections))
      by (apply filter_In; split; [apply InAllDirections|rewrite E; exact D0]).
    destruct (filter (At table) AllDirections) as [|first rest] eqn:F; [destruct I|].
    clear I.
    assert (P : part first = true).
    { assert (I : In first (filter (At table) AllDirections))
        by (rewrite F; left; reflexivity).
      apply filter_In in I. rewrite E in I. tauto. }
    apply (InOnePieceMeans table first rest F). intros d D. rewrite E in D.
    pose proof (FloodOverMeans table first rest O F) as G.
    apply NoMoreMeans in G. generalize dependent (Flooded table first).
    intros reached [Start Closed].
    assert (R : forall y, Joined (InPart v part) Adjacent (at_ first) y ->
      forall d, y = at_ d -> At reached d = true).
    { intros y K. remember (at_ first) as start eqn:Q0.
      induction K as [y _|y z w K IH N (f & -> & X)]; intros e Q.
      - rewrite Q0 in Q. apply DirectionsApart in Q. subst e. exact Start.
      - apply DirectionsApart in Q. subst e.
        apply JoinedInside in K. destruct K as [_ (e & -> & _)].
        apply (Closed f e); [rewrite E; exact X| |exact (IH Q0 e eq_refl)].
        rewrite NextMutual. apply (NextInLinkMeans v), N. }
    apply (R (at_ d)); [|reflexivity]. apply J; [exists first|exists d]; auto.
  Qed.

  Theorem OnePieceIff : OnePiece part = true <->
    (exists x, InPart v part x) /\
    (forall x y, InPart v part x -> InPart v part y ->
       Joined (InPart v part) Adjacent x y).
  Proof.
    split; [apply OnePieceMeans|]. intros [E J]. apply OnePieceComplete; assumption.
  Qed.
End Pieces.

(** ** One run *)

Definition RingAgrees (d : Direction) (chosen : list Direction) : bool :=
  let plus := SetOf chosen in
  Bool.eqb (negb (Pinched plus d))
    (existsb (fun e => negb (At plus e)) (At NeighborTable d) &&
     match chosen with [] => true | _ => InOnePiece plus end).

Lemma RingsAgree : forallb (fun d =>
  AllSubsets (At NeighborTable d) [] (RingAgrees d)) AllDirections = true.
Proof. vm_compute. reflexivity. Qed.

Lemma InRingTable d e f : In (e, f) (At RingTable d) ->
  In e (At NeighborTable d) /\ In f (At NeighborTable d).
Proof.
  unfold RingTable. rewrite AtGather, filter_In, in_prod_iff. tauto.
Qed.

(** Only the ring matters. *)
Lemma PinchedLocal p q d :
  (forall e, In e (At NeighborTable d) -> At p e = At q e) ->
  Pinched p d = Pinched q d.
Proof.
  intros E. unfold Pinched. f_equal. f_equal.
  - induction (At NeighborTable d) as [|e l IH]; [reflexivity|].
    cbn [existsb]. rewrite (E e (or_introl eq_refl)), IH; [reflexivity|].
    intros f I. apply E. right. exact I.
  - f_equal. f_equal. pose proof (InRingTable d) as R.
    induction (At RingTable d) as [|(e, f) l IH]; [reflexivity|].
    cbn [filter]. destruct (R e f (or_introl eq_refl)) as [I J].
    rewrite (E e I), (E f J), IH; [reflexivity|].
    intros g h K. apply R. right. exact K.
Qed.

Section Ring.
  Variables (now : SignField) (v : Coord3) (d : Direction).
  Local Notation at_ d := (Translate v (Offset d)).

  Lemma InnerMeans e : IsInner (LinkOf now v) e = true <-> now (at_ e) = Plus.
  Proof. unfold IsInner, LinkOf. destruct (now _); split; congruence. Qed.

  Let run (e : Direction) : bool := NextInLink d e && IsInner (LinkOf now v) e.

  Lemma InRun x : InPart v run x <-> now x = Plus /\ Adjacent v x /\ Adjacent (at_ d) x.
  Proof.
    unfold InPart, run. split.
    - intros (e & -> & E). apply andb_true_iff in E. destruct E as [N I].
      apply InnerMeans in I. apply (NextInLinkMeans v) in N.
      split; [exact I|]. split; [exists e; reflexivity|exact N].
    - intros (P & (e & ->) & N). exists e. split; [reflexivity|].
      apply andb_true_iff. split; [apply (NextInLinkMeans v), N|apply InnerMeans, P].
  Qed.

  Lemma GoodRingIff : GoodRing (LinkOf now v) d = true <-> RunAround now v (at_ d).
  Proof.
    pose proof RingsAgree as A. rewrite forallb_forall in A.
    specialize (A d (InAllDirections d)).
    apply (EachSubset (IsInner (LinkOf now v))) in A.
    set (chosen := rev (filter (IsInner (LinkOf now v)) (At NeighborTable d)) ++ [])
      in A.
    assert (S : forall e, At (SetOf chosen) e = run e).
    { intros e. unfold chosen. rewrite AtSetOf. unfold run. f_equal.
      apply EqualIfBothWays. rewrite AmongDirections. apply InNeighborTable. }
    unfold RingAgrees in A. cbv zeta in A. apply eqb_prop in A.
    assert (L : forall e, In e (At NeighborTable d) ->
      At (SetOf chosen) e = At (Gather (IsInner (LinkOf now v))) e).
    { intros e I. rewrite S, AtGather. unfold run. apply InNeighborTable in I.
      rewrite I. reflexivity. }
    rewrite (PinchedLocal _ _ d L) in A. clear L.
    rewrite PinchedCorrect, negb_involutive in A. rewrite A. clear A.
    rewrite andb_true_iff. unfold RunAround, Hangs.
    assert (E1 : existsb (fun e => negb (At (SetOf chosen) e)) (At NeighborTable d) = true
      <-> exists x, now x <> Plus /\ Adjacent v x /\ Adjacent (at_ d) x).
    { rewrite existsb_exists. split.
      - intros (e & I & N). apply InNeighborTable in I. rewrite S in N. unfold run in N.
        rewrite I in N. cbn [andb] in N. apply negb_true_iff, not_true_iff_false in N.
        exists (at_ e). split; [intros P; apply N, InnerMeans, P|].
        split; [exists e; reflexivity|apply NextInLinkMeans, I].
      - intros (x & P & (e & ->) & N). apply (NextInLinkMeans v) in N.
        exists e. split; [apply InNeighborTable, N|].
        apply negb_true_iff, not_true_iff_false. rewrite S. unfold run.
        intros H. apply andb_true_iff in H. destruct H as [_ H].
        apply P, InnerMeans, H. }
    rewrite E1. clear E1.
    assert (E2 : match chosen with [] => true | _ :: _ => InOnePiece (SetOf chosen) end
      = true <-> forall x y, InPart v run x -> InPart v run y ->
                   Joined (InPart v run) Adjacent x y).
    { destruct chosen as [|e l] eqn:C.
      - split; [|reflexivity]. intros _ x y (e & _ & E).
        rewrite <- S in E. unfold SetOf in E. rewrite AtGather in E. discriminate E.
      - rewrite (InOnePieceCorrect (SetOf (e :: l)) run S), (OnePieceIff v run).
        split; [tauto|]. intros J. split; [|exact J]. exists (at_ e), e.
        split; [reflexivity|]. rewrite <- S. unfold SetOf. rewrite AtGather.
        cbn [existsb]. rewrite SameDirectionRefl. reflexivity. }
    rewrite E2. clear E2 S. split.
    - intros [X J]. split; [exact X|]. intros u w U W.
      apply (JoinedWider (InPart v run)); [intros x; apply InRun|].
      apply J; apply InRun; assumption.
    - intros [X J]. split; [exact X|]. intros u w U W.
      apply (JoinedWider (fun x => now x = Plus /\ Adjacent v x /\ Adjacent (at_ d) x));
        [intros x; apply InRun|].
      apply J; apply InRun; assumption.
  Qed.
End Ring.
