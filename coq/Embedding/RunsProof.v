(** * Around an edge on the surface the + is one run: proof

    When an end of the edge becomes 0, its link says so.  Afterwards + vertices
    leave the ring; each of them has one neighbour at most among the + of the
    ring, or else there would be a wall, so that it stands at an end of the
    run. *)

From Coq Require Import ZArith List Bool Lia.
From Certet Require Import Lattice.Coord3 Lattice.Direction.
From Certet Require Import Stencil.UnstructuredTet.
From Certet Require Import Warp.Cut Warp.Warp Stuffing.Stuffing.
From Certet Require Import Angles.AnglesSpec Angles.Isometry.
From Certet Require Import Embedding.EmbeddingSpec Embedding.PiecesSpec.
From Certet Require Import Embedding.WarpOrClamp Embedding.DiskRule.
From Certet Require Import Embedding.LeavingProof Embedding.LinkProof.
From Certet Require Import Embedding.DiskRuleProof Embedding.DiskPiecesProof.
Import ListNotations.

(** ** What a good ring tells *)

Definition Ring (d : Direction) : list Direction :=
  filter (NextInLink d) AllDirections.

(** The value that stands beside [e]. *)
Fixpoint Beside (ds : list Direction) (bs : list bool) (e : Direction) : bool :=
  match ds, bs with
  | d :: ds, b :: bs => if SameDirection d e then b else Beside ds bs e
  | _, _ => false
  end.

Fixpoint ForAllBools (n : nat) (test : list bool -> bool) : bool :=
  match n with
  | O => test []
  | S m => ForAllBools m (fun bs => test (true :: bs)) &&
           ForAllBools m (fun bs => test (false :: bs))
  end.

Lemma ForAllBoolsSound n : forall test, ForAllBools n test = true ->
  forall bs, length bs = n -> test bs = true.
Proof.
  induction n as [|n IH]; intros test C [|b bs] L; try discriminate L; [exact C|].
  cbn [ForAllBools] in C. apply andb_prop in C. destruct C as [T F].
  injection L as L. destruct b;
    [exact (IH (fun bs => test (true :: bs)) T bs L)
    |exact (IH (fun bs => test (false :: bs)) F bs L)].
Qed.

Definition SignsOf (inner : Direction -> bool) (e : Direction) : Sign :=
  if inner e then Plus else Minus.

(** The + of the ring, and what can be reached in it. *)
Definition RingPart (inner : Direction -> bool) (d e : Direction) : bool :=
  NextInLink d e && inner e.

Definition CheckRuns : bool :=
  forallb (fun d => let ring := Ring d in
    ForAllBools (length ring) (fun bs =>
      let inner := Beside ring bs in
      negb (GoodRing (SignsOf inner) d) ||
      forallb (fun e => negb (inner e) ||
        let reached := Flood 5 (RingPart inner d) [e] in
        forallb (fun f => negb (inner f) || existsb (SameDirection f) reached) ring)
        ring)) AllDirections.

Lemma RunsChecked : CheckRuns = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma BesideMap inner ds e : In e ds -> Beside ds (map inner ds) e = inner e.
Proof.
  induction ds as [|d ds IH]; [intros []|]. intros I. cbn [map Beside].
  destruct (SameDirection d e) eqn:E.
  - apply SameDirectionMeans in E. subst d. reflexivity.
  - destruct I as [->|I]; [|auto]. exfalso.
    assert (T : SameDirection e e = true) by (destruct e; reflexivity). congruence.
Qed.

(** A ring sees its own points alone. *)
Lemma GoodRingSees now now' d :
  (forall e, In e (Ring d) -> IsInner now e = IsInner now' e) ->
  GoodRing now d = GoodRing now' d.
Proof.
  intros E. unfold GoodRing. fold (Ring d). f_equal.
  - induction (Ring d) as [|e ds IH]; [reflexivity|]. cbn [existsb].
    rewrite E by (left; reflexivity). f_equal. apply IH. intros f I.
    apply E. right. exact I.
  - do 2 f_equal. apply filter_ext_in. intros [e f] I. apply in_prod_iff in I.
    destruct I as [I J]. rewrite (E e I), (E f J). reflexivity.
Qed.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [Ring Flood GoodRing NextInLink ForAllBools].

Lemma GoodRingRuns a now d : GoodRing now d = true ->
  (exists e, NextInLink d e = true /\ IsInner now e = false) /\
  forall x y, InPart a (RingPart (IsInner now) d) x ->
    InPart a (RingPart (IsInner now) d) y ->
    Joined (InPart a (RingPart (IsInner now) d)) Adjacent x y.
Proof.
  intros G. split.
  - unfold GoodRing in G. apply andb_prop in G. destruct G as [G _].
    apply existsb_exists in G. destruct G as (e & I & G).
    apply filter_In in I. exists e. split; [tauto|]. apply negb_true_iff, G.
  - pose proof RunsChecked as C. unfold CheckRuns in C.
    rewrite forallb_forall in C. specialize (C d (InAllDirections d)).
    cbv zeta in C.
    pose proof (ForAllBoolsSound _ _ C (map (IsInner now) (Ring d))
      (map_length _ _)) as R. clear C. cbv beta in R.
    set (inner := Beside (Ring d) (map (IsInner now) (Ring d))) in *.
    assert (B : forall e, In e (Ring d) -> inner e = IsInner now e)
      by (intros e I; apply BesideMap, I).
    rewrite (GoodRingSees (SignsOf inner) now d) in R.
    2: { intros e I. rewrite <- (B e I). unfold IsInner at 1, SignsOf.
         destruct (inner e); reflexivity. }
    rewrite G in R. cbn [negb orb] in R. rewrite forallb_forall in R.
    intros x y (e & -> & E) (f & -> & F).
    unfold RingPart in E, F. apply andb_prop in E, F.
    destruct E as [Ne E], F as [Nf F].
    assert (Ie : In e (Ring d)) by (apply filter_In; auto using InAllDirections).
    assert (If : In f (Ring d)) by (apply filter_In; auto using InAllDirections).
    specialize (R e Ie). rewrite (B e Ie), E in R. cbn [negb orb] in R.
    rewrite forallb_forall in R. specialize (R f If).
    rewrite (B f If), F in R. cbn [negb orb] in R.
    apply existsb_exists in R. destruct R as (g & Ig & S).
    apply SameDirectionMeans in S. subst g.
    assert (Sub : forall z, InPart a (RingPart inner d) z ->
      InPart a (RingPart (IsInner now) d) z).
    { intros z (g & -> & H). exists g. split; [reflexivity|].
      unfold RingPart in *. apply andb_prop in H. destruct H as [N H].
      rewrite N, <- (B g); [exact H|]. apply filter_In; auto using InAllDirections. }
    apply (JoinedWider (InPart a (RingPart inner d))); [exact Sub|].
    apply (FloodJoined a (RingPart inner d) e 5 [e]); [|exact Ig].
    intros h [<-|[]]. constructor. exists e. split; [reflexivity|].
    unfold RingPart. rewrite Ne, (B e Ie), E. reflexivity.
Qed.

(** ** Turn by turn *)

Lemma OneRunTurned plus a b : OneRun plus a b -> OneRun plus b a.
Proof.
  intros [(x & A & B & N) J]. split; [exists x; auto|].
  intros u v Bu Au U Bv Av W.
  apply (JoinedWider (fun z => plus z /\ Adjacent a z /\ Adjacent b z)); [tauto|auto].
Qed.

Section Rule.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Variable turn : Coord3 -> nat.
  Hypothesis Decided : forall v, sign v <> OnSurface.
  Hypothesis Turns : forall v d, let u := Translate v (Offset d) in
    Violated th sign cut v = true -> Violated th sign cut u = true ->
    turn v <> turn u.

  Notation settled := (Settled th sign cut turn).
  Notation now := (SignNow th sign cut turn).
  Let plus n v := now n v = Plus.

  Lemma PlusBackwards n v : plus (S n) v -> plus n v.
  Proof.
    unfold plus. intros P. apply NowPlus in P. apply NowPlus.
    destruct P as [P Q]. split; [|exact Q]. destruct (settled n v) eqn:E; [|reflexivity].
    rewrite (SettledStays th sign cut turn n v E) in P. discriminate P.
  Qed.

  (** Next to one that becomes 0 nobody else changes. *)
  Lemma PlusKept n v x : settled (S n) v = true -> settled n v = false ->
    Adjacent v x -> plus n x -> plus (S n) x.
  Proof.
    unfold plus. intros V V' A P. apply NowPlus in P. apply NowPlus.
    destruct P as [P Q]. split; [|exact Q].
    destruct (settled (S n) x) eqn:E; [|reflexivity].
    destruct (NotAdjacent th sign cut turn Turns n v x V V' E P A).
  Qed.

  (** When [a] becomes 0. *)
  Lemma RunFromLink n a b : settled (S n) a = true -> settled n a = false ->
    Adjacent a b -> now n b = OnSurface -> OneRun (plus (S n)) a b.
  Proof.
    intros A A' [d ->] B.
    destruct (SettledMeans th sign cut turn n a A A') as (_ & _ & D).
    unfold StrictDisk in D. apply andb_prop in D. destruct D as [_ D].
    rewrite forallb_forall in D. specialize (D d (InAllDirections d)).
    unfold IsZero in D at 1. rewrite B in D. cbn [negb orb] in D.
    apply andb_prop in D. destruct D as [D _].
    destruct (GoodRingRuns a _ d D) as [(e & N & I) J].
    set (part := RingPart (IsInner (fun d => now n (Translate a (Offset d)))) d) in *.
    assert (E : forall x, InPart a part x <->
      plus n x /\ Adjacent a x /\ Adjacent (Translate a (Offset d)) x).
    { intros x. unfold InPart, part, RingPart, IsInner, plus. split.
      - intros (f & -> & F). apply andb_prop in F. destruct F as [F G].
        split; [destruct (now n (Translate a (Offset f))); congruence|].
        split; [exists f; reflexivity|apply NextInLinkMeans, F].
      - intros (P & [f ->] & Q). exists f. split; [reflexivity|].
        rewrite P, (proj2 (NextInLinkMeans a d f) Q). reflexivity. }
    split.
    - exists (Translate a (Offset e)). split; [exists e; reflexivity|].
      split; [apply NextInLinkMeans, N|]. intros P. apply PlusBackwards in P.
      unfold IsInner in I. unfold plus in P. rewrite P in I. discriminate I.
    - intros x y Ax Bx Px Ay By Py.
      apply (JoinedWider (InPart a part)).
      + intros z Z. apply E in Z. destruct Z as (P & Q & R).
        split; [exact (PlusKept n a z A A' Q P)|auto].
      + apply J; apply E; auto using PlusBackwards.
  Qed.

  (** Who leaves a ring stands at the end of its run. *)
  Lemma LeavesAtEnd n a b v u w :
    settled (S n) v = true -> settled n v = false ->
    now n a = OnSurface -> now n b = OnSurface -> Adjacent a b ->
    Adjacent a v -> Adjacent b v -> Adjacent v u -> Adjacent v w ->
    Adjacent a u -> Adjacent b u -> plus n u ->
    Adjacent a w -> Adjacent b w -> plus n w -> u = w.
  Proof.
    intros V V' A B Ab Av Bv Vu Vw Au Bu U Aw Bw W.
    destruct (SettledMeans th sign cut turn n v V V') as (_ & _ & D).
    apply (SeenFrom th sign cut turn n v a b u w); auto using AdjacentMutual.
  Qed.

  Lemma OneRunEver n a b : Adjacent a b ->
    now n a = OnSurface -> now n b = OnSurface -> OneRun (plus n) a b.
  Proof.
    revert a b. induction n as [|n IH]; intros a b Ab A B.
    { apply (NowZero th sign cut turn Decided) in A. discriminate A. }
    apply (NowZero th sign cut turn Decided) in A, B.
    assert (Z : forall x, settled n x = true -> now n x = OnSurface)
      by (intros; apply (NowZero th sign cut turn Decided); assumption).
    destruct (settled n a) eqn:A'.
    2: { destruct (settled n b) eqn:B'.
         - apply RunFromLink; auto.
         - destruct (NotAdjacent th sign cut turn Turns n a b A A' B B' Ab). }
    destruct (settled n b) eqn:B'.
    2: { apply OneRunTurned, RunFromLink; auto using AdjacentMutual. }
    destruct (IH a b Ab (Z a A') (Z b B')) as [(x & Ax & Bx & N) J].
    split; [exists x; split; [exact Ax|split; [exact Bx|]];
            intros P; exact (N (PlusBackwards n x P))|].
    set (ring := fun k z => plus k z /\ Adjacent a z /\ Adjacent b z) in *.
    assert (Kept : forall x y, Joined (ring n) Adjacent x y -> ring (S n) x ->
      (ring (S n) y -> Joined (ring (S n)) Adjacent x y) /\
      (~ plus (S n) y -> forall z, Adjacent y z -> ring (S n) z ->
         Joined (ring (S n)) Adjacent x z)).
    { clear x Ax Bx N J. intros x y J X.
      induction J as [x I|x u w J IHJ S I].
      - split; [intros _; constructor; exact X|]. intros Q. destruct X. contradiction.
      - destruct (IHJ X) as [Stay Gone].
        pose proof (JoinedInside _ _ _ _ _ J) as [_ U].
        assert (Leaving : forall v, ring n v -> ~ plus (Datatypes.S n) v ->
          settled (Datatypes.S n) v = true /\ settled n v = false).
        { intros v (P & _) Q. unfold plus in P, Q. rewrite NowPlus in P, Q.
          destruct (settled (Datatypes.S n) v); tauto. }
        assert (Decide : {plus (Datatypes.S n) u} + {~ plus (Datatypes.S n) u})
          by (unfold plus; destruct (now (Datatypes.S n) u); [left|right|right]; congruence).
        destruct Decide as [Pu|Pu].
        + assert (Ru : ring (Datatypes.S n) u) by (destruct U; split; tauto).
          split.
          * intros W. exact (Joined_step _ _ x u w (Stay Ru) S W).
          * intros Q z Wz Rz. destruct (Leaving w I Q) as [L L'].
            replace z with u; [exact (Stay Ru)|].
            destruct I as (_ & Aw & Bw), U as (Un & Au & Bu), Rz as (Pz & Az & Bz).
            apply (LeavesAtEnd n a b w u z L L' (Z a A') (Z b B') Ab);
              auto using AdjacentMutual, PlusBackwards.
        + split.
          * intros W. exact (Gone Pu w S W).
          * intros Q. destruct (Leaving u U Pu) as [L L'], (Leaving w I Q) as [M M'].
            destruct (NotAdjacent th sign cut turn Turns n u w L L' M M' S). }
    intros y z Ay By Py Az Bz Pz.
    assert (Y : ring (S n) y) by (split; auto).
    apply (proj1 (Kept y z (J y z Ay By (PlusBackwards n y Py) Az Bz
      (PlusBackwards n z Pz)) Y)). split; auto.
  Qed.
End Rule.

(** Around every edge of the lattice with both ends on the surface. *)
Theorem DiskOneRun th sign cut limit a b :
  let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
  (forall v, sign v <> OnSurface) -> Adjacent a b ->
  PlacedSign sign warping (Corner a) = OnSurface ->
  PlacedSign sign warping (Corner b) = OnSurface ->
  OneRun (PlusAfter sign warping) a b.
Proof.
  intros warping D Ab A B. unfold warping, PlusAfter in *.
  unfold DiskRule in *. rewrite AfterDisk in A, B.
  pose proof (OneRunEver th sign cut (Turn th sign cut) D
    (TurnsDiffer th sign cut) DiskRule.Turns a b Ab A B) as [(x & Ax & Bx & N) J].
  split.
  - exists x. rewrite AfterDisk. auto.
  - intros y z Ay By Py Az Bz Pz. rewrite AfterDisk in Py, Pz.
    apply (JoinedWider (fun z => SignNow th sign cut (Turn th sign cut) DiskRule.Turns z
      = Plus /\ Adjacent a z /\ Adjacent b z)); [|auto].
    intros u. rewrite AfterDisk. tauto.
Qed.
