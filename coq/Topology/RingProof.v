(** * Around an edge of the lattice

    The points next to both ends of an edge are a ring of four or six.  Going
    around it, + begins as often as it ends. *)

From Coq Require Import Arith.
From Certet Require Import Embedding.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Angles.Cases.Isometry Embedding.LinkProof.
Open Scope bool_scope.

Definition Ring (d : Direction) : list Direction := filter (NextInLink d) AllDirections.

(** Neighbours on the ring, both ways. *)
Definition RingPairs (d : Direction) : list (Direction * Direction) :=
  filter (fun '(e, f) => NextInLink e f) (list_prod (Ring d) (Ring d)).

Section Signs.
  Variable now : Direction -> Sign.

  (** From + to what is not. *)
  Definition Crosses (pair : Direction * Direction) : bool :=
    let '(e, f) := pair in IsInner now e && negb (IsInner now f).

  (** A 0 with + on both sides crosses twice and bounds nothing. *)
  Definition Bounds (crossings : list (Direction * Direction))
    (pair : Direction * Direction) : bool :=
    let '(e, f) := pair in
    negb (IsZero now f) ||
    forallb (fun '(e', f') => negb (SameDirection f f') || SameDirection e e') crossings.

  Definition Crossings (pairs : list (Direction * Direction)) := filter Crosses pairs.
  Definition Boundary (pairs : list (Direction * Direction)) :=
    filter (Bounds (Crossings pairs)) (Crossings pairs).
End Signs.

(** ** All signs of a ring *)

Definition Put (d : Direction) (s : Sign) (now : Direction -> Sign) : Direction -> Sign :=
  fun e => if SameDirection d e then s else now e.

Fixpoint ForAllSignsOn (ds : list Direction) (test : (Direction -> Sign) -> bool)
  : bool :=
  match ds with
  | [] => test (fun _ => Minus)
  | d :: rest =>
      ForAllSigns (fun s => ForAllSignsOn rest (fun now => test (Put d s now)))
  end.

Lemma ForAllSignsOnSound now ds : forall test, ForAllSignsOn ds test = true ->
  exists now', (forall e, In e ds -> now' e = now e) /\ test now' = true.
Proof.
  induction ds as [|d rest IH]; cbn [ForAllSignsOn]; intros test C.
  - exists (fun _ => Minus). split; [intros e []|exact C].
  - pose proof (ForAllSignsSound _ C (now d)) as C'. cbv beta in C'.
    destruct (IH _ C') as (now' & A & T). exists (Put d (now d) now').
    split; [|exact T]. intros e I. unfold Put.
    destruct (SameDirection d e) eqn:S.
    + apply SameDirectionMeans in S. subst e. reflexivity.
    + destruct I as [<-|I]; [rewrite SameDirectionRefl in S; discriminate S|auto].
Qed.

Lemma RingsEven : forallb (fun d => let ring := Ring d in let pairs := RingPairs d in
  ForAllSignsOn ring (fun now =>
    Nat.even (length (Boundary now pairs)))) AllDirections = true.
Proof. vm_compute. reflexivity. Qed.

Lemma InRing d e : In e (Ring d) <-> NextInLink d e = true.
Proof.
  unfold Ring. rewrite filter_In. pose proof (InAllDirections e). tauto.
Qed.

Lemma InRingPairs d e f : In (e, f) (RingPairs d) <->
  NextInLink d e = true /\ NextInLink d f = true /\ NextInLink e f = true.
Proof. unfold RingPairs. rewrite filter_In, in_prod_iff, !InRing. tauto. Qed.

Lemma CrossingsSame now now' d : (forall e, In e (Ring d) -> now' e = now e) ->
  Crossings now' (RingPairs d) = Crossings now (RingPairs d).
Proof.
  intros A. apply filter_ext_in. intros [e f] I. apply InRingPairs in I.
  destruct I as (E & F & _). unfold Crosses, IsInner.
  rewrite !A by (apply InRing; assumption). reflexivity.
Qed.

Lemma BoundarySame now now' d : (forall e, In e (Ring d) -> now' e = now e) ->
  Boundary now' (RingPairs d) = Boundary now (RingPairs d).
Proof.
  intros A. unfold Boundary. rewrite (CrossingsSame now now' d A).
  apply filter_ext_in. intros [e f] I. unfold Crossings in I.
  apply filter_In in I. destruct I as [I _]. apply InRingPairs in I.
  destruct I as (E & F & _). unfold Bounds, IsZero.
  rewrite A by (apply InRing; assumption). reflexivity.
Qed.

Theorem BoundaryEven now d : Nat.Even (length (Boundary now (RingPairs d))).
Proof.
  pose proof RingsEven as R. rewrite forallb_forall in R.
  specialize (R d (InAllDirections d)). cbv zeta in R.
  destruct (ForAllSignsOnSound now _ _ R) as (now' & A & T).
  rewrite (BoundarySame now now' d A) in T. apply Nat.even_spec, T.
Qed.

Lemma RingPairsOnce d : NoDup (RingPairs d).
Proof.
  destruct d; vm_compute; repeat constructor; cbn [In]; intuition discriminate.
Qed.

Lemma FilterTwice {A} (f g : A -> bool) l :
  filter g (filter f l) = filter (fun x => f x && g x) l.
Proof.
  induction l as [|x l IH]; [reflexivity|]. cbn [filter].
  destruct (f x); cbn [filter andb]; [destruct (g x)|]; rewrite IH; reflexivity.
Qed.

Lemma FilterShorter {A} (f : A -> bool) l : (length (filter f l) <= length l)%nat.
Proof.
  induction l as [|x l IH]; [apply le_n|]. cbn [filter].
  destruct (f x); cbn [length]; lia.
Qed.

(** A good ring has one run, which begins once and ends once. *)
Theorem GoodRingBounds now d : GoodRing now d = true ->
  (length (Boundary now (RingPairs d)) <= 2)%nat.
Proof.
  unfold GoodRing. cbv zeta. rewrite andb_true_iff, Nat.leb_le. intros [_ L].
  unfold Boundary. etransitivity; [apply FilterShorter|].
  unfold Crossings, RingPairs. rewrite FilterTwice. fold (Ring d) in L.
  erewrite filter_ext; [exact L|]. intros [e f]. cbn [Crosses].
  rewrite andb_assoc. reflexivity.
Qed.
