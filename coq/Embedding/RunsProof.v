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
