(** * What a vertex finds when its link is a strict disk *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.Cases.Isometry Embedding.LeavingProof
  Embedding.LinkProof Embedding.EdgeRank Embedding.GreedyProof.

(** No face of the lattice that is 0 has + on both sides. *)
Definition NoWallIn (now : SignField) : Prop :=
  forall a b c p q,
    Adjacent a b -> Adjacent a c -> Adjacent b c ->
    Adjacent a p -> Adjacent b p -> Adjacent c p ->
    Adjacent a q -> Adjacent b q -> Adjacent c q ->
    now a = OnSurface -> now b = OnSurface -> now c = OnSurface ->
    now p = Plus -> now q = Plus -> p = q.

Section Disk.
  Variables (now : SignField) (v : Coord3).
  Hypothesis Disk : StrictDisk (LinkOf now v) = true.

  (** It sees + on both sides of an edge that is 0. *)
  Lemma DiskSees b c p q :
    Adjacent v b -> Adjacent v c -> Adjacent b c ->
    Adjacent v p -> Adjacent b p -> Adjacent c p ->
    Adjacent v q -> Adjacent b q -> Adjacent c q ->
    now b = OnSurface -> now c = OnSurface ->
    now p = Plus -> now q = Plus -> p = q.
  Proof.
    intros [d ->] [e ->] Bc [f ->] Bp Cp [g ->] Bq Cq B C P Q.
    pose proof Disk as D.
    unfold StrictDisk in D. apply andb_prop in D. destruct D as [_ D].
    rewrite forallb_forall in D. specialize (D d (InAllDirections d)).
    unfold IsZero, LinkOf in D. rewrite B in D. cbn [negb orb] in D.
    apply andb_prop in D. destruct D as [_ D].
    rewrite forallb_forall in D. specialize (D e (InAllDirections e)).
    rewrite C, (proj2 (NextInLinkMeans v d e) Bc) in D. cbn [negb orb andb] in D.
    unfold NoWallBetween, IsInner in D.
    rewrite forallb_forall in D. specialize (D f (InAllDirections f)).
    rewrite forallb_forall in D. specialize (D g (InAllDirections g)).
    rewrite P, Q, (proj2 (NextInLinkMeans v d f) Bp),
      (proj2 (NextInLinkMeans v e f) Cp), (proj2 (NextInLinkMeans v d g) Bq),
      (proj2 (NextInLinkMeans v e g) Cq) in D.
    cbn [negb orb andb] in D. apply SameDirectionMeans in D. subst g. reflexivity.
  Qed.

  (** A part of the link in one piece: what it holds is joined within it. *)
  Lemma PieceAround (part : Direction -> bool) (inside : Coord3 -> Prop) :
    OnePiece part = true ->
    (forall d, part d = true <-> inside (Translate v (Offset d))) ->
    (exists u, Adjacent v u /\ inside u) /\
    forall u w, Adjacent v u -> Adjacent v w -> inside u -> inside w ->
      Joined (fun x => inside x /\ Adjacent v x) Adjacent u w.
  Proof.
    intros O E. destruct (OnePieceMeans v part O) as [(x & d & -> & X) J].
    split; [exists (Translate v (Offset d)); split; [exists d; reflexivity|apply E, X]|].
    intros u w [d1 ->] [d2 ->] U W.
    apply (JoinedWider (InPart v part)).
    - intros y (f & -> & F). split; [apply E, F|exists f; reflexivity].
    - apply J; eexists; (split; [reflexivity|apply E; assumption]).
  Qed.

  Lemma InsideAround : let inside u := now u = Plus in
    (exists u, Adjacent v u /\ inside u) /\
    forall u w, Adjacent v u -> Adjacent v w -> inside u -> inside w ->
      Joined (fun x => inside x /\ Adjacent v x) Adjacent u w.
  Proof.
    cbv zeta. apply (PieceAround (IsInner (LinkOf now v))).
    - unfold StrictDisk in Disk. rewrite !andb_true_iff in Disk. apply Disk.
    - intros d. unfold IsInner, LinkOf. destruct (now _); split; congruence.
  Qed.

  Lemma OutsideAround : let outside u := now u <> Plus in
    (exists u, Adjacent v u /\ outside u) /\
    forall u w, Adjacent v u -> Adjacent v w -> outside u -> outside w ->
      Joined (fun x => outside x /\ Adjacent v x) Adjacent u w.
  Proof.
    cbv zeta. apply (PieceAround (fun d => negb (IsInner (LinkOf now v) d))).
    - unfold StrictDisk in Disk. rewrite !andb_true_iff in Disk. apply Disk.
    - intros d. unfold IsInner, LinkOf. destruct (now _); split; cbn; congruence.
  Qed.
End Disk.

(** ** One after the other *)

Lemma PlusOrNot s : s <> Plus \/ s = Plus.
Proof. destruct s; auto; left; discriminate. Qed.

Section Steps.
  Variable sign : SignField.

  Lemma ByDisksPlus now : ByDisks sign now ->
    forall u, now u = Plus -> sign u = Plus.
  Proof.
    induction 1 as [now E|v before now B IH _ V E]; intros u U; [congruence|].
    apply IH. rewrite <- E; [exact U|]. intros ->. congruence.
  Qed.

  Theorem InsideLeaves now : ByDisks sign now ->
    AllLeave Adjacent (fun u => sign u = Plus) (fun u => now u = Plus).
  Proof.
    induction 1 as [now E|v before now _ IH D V E].
    - apply AllLeave_none. intros u. rewrite E. tauto.
    - assert (K : forall u, u <> v -> (now u = Plus <-> before u = Plus))
        by (intros u N; rewrite (E u N); tauto).
      destruct (PlusOrNot (before v)) as [W|W].
      + apply (AllLeaveSame Adjacent _ _ _ IH). intros u.
        destruct (SamePoint3 u v) as [->|N]; [|symmetry; apply K, N].
        rewrite V. split; [intros P; destruct (W P)|discriminate].
      + apply (AllLeave_one Adjacent v _ _ _ IH).
        destruct (InsideAround before v D) as [(x & X & I) J].
        assert (N : forall u, Adjacent v u -> u <> v)
          by (intros u A ->; exact (NeverAdjacent v A)).
        split; [exact W|]. split; [rewrite V; discriminate|]. split; [exact K|].
        split; [exists x; split; [exact X|apply K; auto]|].
        intros u w U W' Iu Iw.
        apply (JoinedWider (fun y => before y = Plus /\ Adjacent v y)).
        * intros y [Y A]. split; [apply K; auto|exact A].
        * apply J; try assumption; apply K; auto.
  Qed.

  (** Seen from outside, what became 0 leaves again. *)
  Theorem OutsideLeaves now : ByDisks sign now ->
    AllLeave Adjacent (fun u => now u <> Plus) (fun u => sign u <> Plus).
  Proof.
    induction 1 as [now E|v before now _ IH D V E].
    - apply AllLeave_none. intros u. rewrite E. tauto.
    - assert (K : forall u, u <> v -> (before u <> Plus <-> now u <> Plus))
        by (intros u N; rewrite (E u N); tauto).
      apply (AllLeaveThen Adjacent _ (fun u => before u <> Plus)); [|exact IH].
      destruct (PlusOrNot (before v)) as [W|W].
      + apply AllLeave_none. intros u.
        destruct (SamePoint3 u v) as [->|N]; [|apply K, N].
        rewrite V. split; [discriminate|intros _; exact W].
      + apply (AllLeave_one Adjacent v _ (fun u => now u <> Plus));
          [apply AllLeave_none; tauto|].
        destruct (OutsideAround before v D) as [O J].
        split; [rewrite V; discriminate|]. split; [intros N; exact (N W)|].
        split; [exact K|]. split; [exact O|exact J].
  Qed.

  Hypothesis Decided : forall v, sign v <> OnSurface.

  Theorem NoWallEver now : ByDisks sign now -> NoWallIn now.
  Proof.
    induction 1 as [now S|v before now _ IH D V E].
    - intros a b c p q _ _ _ _ _ _ _ _ _ A. rewrite S in A. destruct (Decided a A).
    - intros a b c p q Ab Ac Bc Ap Bp Cp Aq Bq Cq A B C P Q.
      assert (W : forall x, now x = Plus -> before x = Plus).
      { intros x X. rewrite <- E; [exact X|]. intros ->. congruence. }
      apply W in P, Q. clear W.
      assert (Z : forall x, now x = OnSurface -> x <> v -> before x = OnSurface).
      { intros x X N. rewrite <- (E x N). exact X. }
      assert (N : forall x y, Adjacent x y -> x = v -> y <> v).
      { intros x y X -> ->. exact (NeverAdjacent v X). }
      destruct (SamePoint3 a v) as [->|Na];
        [|destruct (SamePoint3 b v) as [->|Nb];
          [|destruct (SamePoint3 c v) as [->|Nc]]].
      + apply (DiskSees before v D b c p q); eauto.
      + apply (DiskSees before v D a c p q); auto using AdjacentMutual.
        apply Z; [exact C|]. eauto.
      + apply (DiskSees before v D a b p q); auto using AdjacentMutual.
      + apply (IH a b c p q); auto.
  Qed.
End Steps.

(** ** The mesh *)

Lemma NoWallInMesh before warping :
  NoWallIn (fun v => PlacedSign before warping (Corner v)) -> NoWall before warping.
Proof.
  intros N a b c p q Nab Nbc Nac Z P Q (tid & _ & I) (tid' & _ & J).
  assert (D : forall v x, In v [a; b; c] -> PlusAfter before warping x -> v <> x)
    by (intros v x V X ->; unfold PlusAfter in X; rewrite (Z x V) in X; discriminate X).
  assert (E : forall own u v, incl [a; b; c; own] (Corners tid) ->
    In u [a; b; c; own] -> In v [a; b; c; own] -> u <> v -> Adjacent u v).
  { intros own u v Sub U V X.
    destruct (EdgeBetween tid u v (Sub u U) (Sub v V) X) as [d Y]. exists d. exact Y. }
  assert (E' : forall own u v, incl [a; b; c; own] (Corners tid') ->
    In u [a; b; c; own] -> In v [a; b; c; own] -> u <> v -> Adjacent u v).
  { intros own u v Sub U V X.
    destruct (EdgeBetween tid' u v (Sub u U) (Sub v V) X) as [d Y]. exists d. exact Y. }
  cbn [In] in *.
  apply (N a b c p q); auto 6;
    solve [apply (E p); cbn [In]; auto 6 | apply (E' q); cbn [In]; auto 6].
Qed.
