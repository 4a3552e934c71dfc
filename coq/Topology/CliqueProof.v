(** * Simplices of the lattice are what is mutually adjacent

    Of the lattice points: four that are adjacent to each other are the corners
    of a structured tetrahedron; and to three of them exactly two points are
    adjacent. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Lattice.FaceProof Angles.Cases.Isometry
  Embedding.EdgeRank Embedding.LinkProof Embedding.StarProof.
Open Scope Z_scope.

Definition LatticePoint (v : Coord3) : Prop :=
  exists tid, InLattice tid /\ In v (Corners tid).

Lemma LatticePointNext v w : LatticePoint v -> Adjacent v w -> LatticePoint w.
Proof.
  intros (tid & E & I) [d ->]. destruct (EdgeInStar tid v d E I) as (o & O & _ & J).
  exists o. auto.
Qed.

(** ** Four *)

Definition Two : list Coord3 := [C3 0 0 0; C3 1 1 1].

(** Those with a corner at [p]. *)
Definition StarOf (p : Coord3) : list StructuredTetId :=
  filter HasEvenAnchor (flat_map (fun case => map (fun i => STId (Difference
    (VertexAt (GetStructuredTet (AtOrigin case)) i) p) case) AllPlaces) AllCases).

Definition CheckCliques : bool :=
  forallb (fun p => let star := StarOf p in
    forallb (fun d => forallb (fun e => negb (NextInLink d e) ||
      forallb (fun f => negb (NextInLink d f && NextInLink e f) ||
        existsb (fun tid => forallb (fun v => IsAmong v (Corners tid))
          [p; Translate p (Offset d); Translate p (Offset e); Translate p (Offset f)])
          star)
      AllDirections) AllDirections) AllDirections) Two.

Lemma CliquesChecked : CheckCliques = true.
Proof. vm_compute. reflexivity. Qed.

(** A lattice point is one of two, moved by an even vector. *)
Lemma PointOfTwo v : LatticePoint v -> exists a b c p, In p Two /\
  v = Translate (C3 (2 * a) (2 * b) (2 * c)) p.
Proof.
  intros (tid & E & I). destruct (FromOrigin tid v E I) as (a & b & c & case & i & _ & ->).
  cbv zeta. assert (exists a' b' c' p, In p Two /\
    VertexAt (GetStructuredTet (AtOrigin case)) i
    = Translate (C3 (2 * a') (2 * b') (2 * c')) p) as (a' & b' & c' & p & P & ->).
  { destruct (VertexAt (GetStructuredTet (AtOrigin case)) i) as [x y z] eqn:V.
    exists (x / 2), (y / 2), (z / 2), (C3 (x mod 2) (x mod 2) (x mod 2)).
    revert V. unfold Two. destruct case, i; cbn; intros V; injection V as <- <- <-;
      cbn; auto. }
  exists (a + a'), (b + b'), (c + c'), p. split; [exact P|].
  destruct p. cbn [Translate]. f_equal; ring.
Qed.

Lemma CliqueOfDirections v d e f : LatticePoint v ->
  NextInLink d e = true -> NextInLink d f = true -> NextInLink e f = true ->
  exists tid, InLattice tid /\
    incl [v; Translate v (Offset d); Translate v (Offset e); Translate v (Offset f)]
      (Corners tid).
Proof.
  intros V De Df Ef. destruct (PointOfTwo v V) as (a & b & c & p & P & ->).
  pose proof CliquesChecked as C. unfold CheckCliques in C.
  rewrite forallb_forall in C. specialize (C p P). cbv zeta in C.
  rewrite forallb_forall in C. specialize (C d (InAllDirections d)).
  rewrite forallb_forall in C. specialize (C e (InAllDirections e)).
  rewrite De in C. cbn [negb orb] in C.
  rewrite forallb_forall in C. specialize (C f (InAllDirections f)).
  rewrite Df, Ef in C. cbn [negb orb andb] in C.
  apply existsb_exists in C. destruct C as (tid & I & C).
  exists (MoveId (C3 (2 * a) (2 * b) (2 * c)) tid). split.
  - apply HasEvenAnchorMeans. unfold StarOf in I. apply filter_In in I. apply I.
  - rewrite CornersMoved. rewrite forallb_forall in C. rewrite !TranslateTwice.
    intros w W. cbn [In] in W.
    destruct W as [<-|[<-|[<-|[<-|[]]]]]; apply in_map, IsAmongMeans, C; cbn; tauto.
Qed.

Theorem CliqueIsTet a b c e : LatticePoint a ->
  Adjacent a b -> Adjacent a c -> Adjacent a e ->
  Adjacent b c -> Adjacent b e -> Adjacent c e ->
  exists tid, InLattice tid /\ incl [a; b; c; e] (Corners tid).
Proof.
  intros L [d ->] [f ->] [g ->] Bc Be Ce. apply CliqueOfDirections; try assumption;
    eapply NextInLinkMeans; eassumption.
Qed.

(** Conversely. *)
Lemma CornersAdjacent tid a b : In a (Corners tid) -> In b (Corners tid) ->
  a <> b -> Adjacent a b.
Proof. intros I J N. destruct (EdgeBetween tid a b I J N) as [d E]. exists d. exact E. Qed.

Lemma CornersAre tid vs : NoDup vs -> length vs = 4%nat -> incl vs (Corners tid) ->
  incl (Corners tid) vs.
Proof.
  intros N L I. apply NoDup_length_incl; [exact N| |exact I].
  rewrite L. unfold Corners. destruct (GetStructuredTet tid). cbn. auto.
Qed.

(** ** Two at a face *)

Lemma TwoApexes : forallb (fun d => forallb (fun e => negb (NextInLink d e) ||
  match filter (fun f => NextInLink d f && NextInLink e f) AllDirections with
  | [f; g] => negb (SameDirection f g) | _ => false end)
  AllDirections) AllDirections = true.
Proof. vm_compute. reflexivity. Qed.

Lemma OffsetsDiffer d e v : Translate v (Offset d) = Translate v (Offset e) -> d = e.
Proof.
  intros E. apply SameDirectionMeans. unfold SameDirection.
  replace (Offset d) with (Offset e); [apply Coord3EqualRefl|].
  destruct v, (Offset d), (Offset e). cbn [Translate] in E.
  injection E as X Y Z. f_equal; lia.
Qed.

Theorem ApexesOfFace a b c : Adjacent a b -> Adjacent a c -> Adjacent b c ->
  exists p q, p <> q /\
    (Adjacent a p /\ Adjacent b p /\ Adjacent c p) /\
    (Adjacent a q /\ Adjacent b q /\ Adjacent c q) /\
    forall x, Adjacent a x -> Adjacent b x -> Adjacent c x -> x = p \/ x = q.
Proof.
  intros [d ->] [e ->] Bc. apply NextInLinkMeans in Bc.
  pose proof TwoApexes as T. rewrite forallb_forall in T.
  specialize (T d (InAllDirections d)). rewrite forallb_forall in T.
  specialize (T e (InAllDirections e)). rewrite Bc in T. cbn [negb orb] in T.
  assert (M : forall f, In f (filter (fun f => NextInLink d f && NextInLink e f)
    AllDirections) <-> Adjacent (Translate a (Offset d)) (Translate a (Offset f)) /\
      Adjacent (Translate a (Offset e)) (Translate a (Offset f))).
  { intros f. rewrite filter_In, andb_true_iff, <- !NextInLinkMeans.
    pose proof (InAllDirections f). tauto. }
  destruct (filter _ AllDirections) as [|f [|g [|? ?]]]; try discriminate T.
  cbn [In] in M. exists (Translate a (Offset f)), (Translate a (Offset g)).
  split; [|split; [|split]].
  - intros E. apply OffsetsDiffer in E. subst g. unfold SameDirection in T.
    rewrite Coord3EqualRefl in T. discriminate T.
  - split; [exists f; reflexivity|]. apply M. auto.
  - split; [exists g; reflexivity|]. apply M. auto.
  - intros x [h ->] H K. destruct (proj2 (M h) (conj H K)) as [<-|[<-|[]]]; auto.
Qed.
