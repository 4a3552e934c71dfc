(** * Who is 0 keeps a strict disk

    When a vertex becomes 0, the disks around its neighbours that are 0 stay
    disks: no one has to look at them again. *)

From Coq Require Import ZArith List Bool.
From Certet Require Import Lattice.Coord3 Lattice.Direction.
From Certet Require Import Stencil.UnstructuredTet.
From Certet Require Import Stuffing.Stuffing.
From Certet Require Import Angles.Cases.Isometry.
From Certet Require Import Embedding.PiecesSpec Embedding.DiskRule.
From Certet Require Import Embedding.Settle Embedding.SettleSpec.
From Certet Require Import Embedding.GreedyProof.
From Certet Require Import Embedding.LeavingProof Embedding.LinkProof.
From Certet Require Import Embedding.DiskTablesProof Embedding.DiskStepProof.
From Certet Require Import Embedding.DiskMeaningProof.
From Certet Require Import Embedding.SettleProof Embedding.SettledMeshProof.
Import ListNotations.

Local Strategy 1000 [StrictDisk].

(** ** The strict disk in so many words *)

Lemma HangsSame inside inside' : (forall x, inside x <-> inside' x) ->
  Hangs inside -> Hangs inside'.
Proof.
  intros E H u w U W. apply (JoinedWider inside); [apply E|].
  apply H; apply E; assumption.
Qed.

Section Means.
  Variables (now : SignField) (v : Coord3).
  Local Notation at_ d := (Translate v (Offset d)).

  Lemma PieceIff (part : Direction -> bool) (inside : Coord3 -> Prop) :
    (forall d, part d = true <-> inside (at_ d)) ->
    OnePiece part = true <->
    (exists x, inside x /\ Adjacent v x) /\ Hangs (fun x => inside x /\ Adjacent v x).
  Proof.
    intros E. rewrite (OnePieceIff v part).
    assert (S : forall x, InPart v part x <-> inside x /\ Adjacent v x).
    { intros x. unfold InPart. split.
      - intros (d & -> & D). split; [apply E, D|exists d; reflexivity].
      - intros (I & d & ->). exists d. split; [reflexivity|apply E, I]. }
    split; intros [(x & X) H]; (split; [exists x; apply S, X|]).
    - exact (HangsSame _ _ S H).
    - refine (HangsSame _ _ _ H). intros y. symmetry. apply S.
  Qed.

  Lemma ZeroMeans d : IsZero (LinkOf now v) d = true <-> now (at_ d) = OnSurface.
  Proof. unfold IsZero, LinkOf. destruct (now _); split; congruence. Qed.

  Lemma NoWallIff d e : NoWallBetween (LinkOf now v) d e = true <->
    forall p q, now p = Plus -> now q = Plus ->
      Adjacent v p -> Adjacent (at_ d) p -> Adjacent (at_ e) p ->
      Adjacent v q -> Adjacent (at_ d) q -> Adjacent (at_ e) q -> p = q.
  Proof.
    unfold NoWallBetween. rewrite forallb_forall. split.
    - intros W p q P Q [f ->] Dp Ep [g ->] Dq Eq.
      specialize (W f (InAllDirections f)). rewrite forallb_forall in W.
      specialize (W g (InAllDirections g)).
      apply (InnerMeans now v) in P, Q. rewrite P, Q in W.
      rewrite (proj2 (NextInLinkMeans v d f) Dp), (proj2 (NextInLinkMeans v e f) Ep),
        (proj2 (NextInLinkMeans v d g) Dq), (proj2 (NextInLinkMeans v e g) Eq) in W.
      cbn [negb andb orb] in W. apply SameDirectionMeans in W. congruence.
    - intros W f _. apply forallb_forall. intros g _. apply orb_true_iff.
      destruct (IsInner (LinkOf now v) f && NextInLink d f && NextInLink e f
        && IsInner (LinkOf now v) g && NextInLink d g && NextInLink e g) eqn:A;
        [right|left; reflexivity].
      rewrite !andb_true_iff, !(InnerMeans now v), !(NextInLinkMeans v) in A.
      destruct A as (((((P & Dp) & Ep) & Q) & Dq) & Eq).
      assert (S : at_ f = at_ g)
        by (apply W; try assumption; eexists; reflexivity).
      apply DirectionsApart in S. subst g. apply SameDirectionRefl.
  Qed.

  Theorem StrictDiskIff : StrictDisk (LinkOf now v) = true <-> DiskAround now v.
  Proof.
    unfold StrictDisk. rewrite !andb_true_iff.
    rewrite (PieceIff (IsInner (LinkOf now v)) (fun x => now x = Plus))
      by apply InnerMeans.
    rewrite (PieceIff (fun d => negb (IsInner (LinkOf now v) d))
      (fun x => now x <> Plus))
      by (intros d; rewrite negb_true_iff, <- not_true_iff_false, InnerMeans; tauto).
    rewrite forallb_forall. unfold DiskAround. split.
    - intros ((P & N) & Z).
      assert (Zero : forall d, now (at_ d) = OnSurface ->
        GoodRing (LinkOf now v) d = true /\ forall e, now (at_ e) = OnSurface ->
          NextInLink d e = true -> NoWallBetween (LinkOf now v) d e = true).
      { intros d D. specialize (Z d (InAllDirections d)). apply ZeroMeans in D.
        rewrite D in Z. cbn [negb orb] in Z. apply andb_true_iff in Z.
        destruct Z as [G W]. split; [exact G|]. intros e E X.
        rewrite forallb_forall in W. specialize (W e (InAllDirections e)).
        apply ZeroMeans in E. rewrite E, X in W. exact W. }
      split; [exact (proj1 P)|]. split; [exact (proj2 P)|].
      split; [exact (proj1 N)|]. split; [exact (proj2 N)|]. split.
      + intros z D [d ->]. apply GoodRingIff, Zero, D.
      + intros y z p q Y Z' P' Q' [d ->] [e ->] X Vp Yp Zp Vq Yq Zq.
        apply (NoWallIff d e); try assumption. apply (Zero d Y); [exact Z'|].
        apply (NextInLinkMeans v), X.
    - intros (P & P' & N & N' & R & W). split; [tauto|]. intros d _.
      destruct (IsZero (LinkOf now v) d) eqn:D; [|reflexivity].
      apply ZeroMeans in D. cbn [negb orb]. apply andb_true_iff. split.
      + apply GoodRingIff, R; [exact D|exists d; reflexivity].
      + apply forallb_forall. intros e _. apply orb_true_iff.
        destruct (IsZero (LinkOf now v) e && NextInLink d e) eqn:E;
          [right|left; reflexivity].
        apply andb_true_iff in E. destruct E as [E X].
        apply ZeroMeans in E. apply (NextInLinkMeans v) in X.
        apply NoWallIff. intros p q. intros.
        apply (W (at_ d) (at_ e) p q); try assumption; eexists; reflexivity.
  Qed.
End Means.

(** ** One point less *)

Lemma WithoutOne v (inside now : Coord3 -> Prop) :
  (forall u, now u <-> inside u /\ u <> v) ->
  (inside v -> forall u w, Adjacent v u -> Adjacent v w -> now u -> now w ->
     Joined now Adjacent u w) ->
  Hangs inside -> Hangs now.
Proof.
  intros E A H u w U W.
  assert (S : forall s t, Joined inside Adjacent s t -> now s ->
    (t <> v -> Joined now Adjacent s t) /\
    (t = v -> forall x, Adjacent v x -> now x -> Joined now Adjacent s x)).
  { induction 1 as [s I|s t r J IH N I]; intros Ns.
    - split; [intros _; constructor; exact Ns|]. intros ->. apply E in Ns. tauto.
    - destruct (IH Ns) as [Far Near]. destruct (SamePoint3 t v) as [->|D].
      + split.
        * intros Rv. apply (Near eq_refl); [exact N|apply E; auto].
        * intros -> x X Nx. exact (Near eq_refl x X Nx).
      + specialize (Far D). split.
        * intros Rv. apply (Joined_step _ _ s t r Far N). apply E. auto.
        * intros -> x X Nx. apply (JoinedThen _ _ _ s t x Far).
          apply (A I); [apply AdjacentMutual, N|exact X| |exact Nx].
          apply JoinedInside in Far. tauto. }
  apply E in U as U'. apply E in W as W'.
  apply (proj1 (S u w (H u w (proj1 U') (proj1 W')) U)). apply W'.
Qed.

(** ** One step *)

Section Step.
  Variables (before now : SignField) (v : Coord3).
  Hypothesis Disk : DiskAround before v.
  Hypothesis Zero : now v = OnSurface.
  Hypothesis Else : forall u, u <> v -> now u = before u.

  Lemma StillPlus x : now x = Plus <-> before x = Plus /\ x <> v.
  Proof.
    split.
    - intros P. assert (N : x <> v) by (intros ->; congruence).
      rewrite <- (Else x N). auto.
    - intros [P N]. rewrite (Else x N). exact P.
  Qed.

  Lemma NearOther x : Adjacent v x -> x <> v.
  Proof. intros A ->. exact (NeverNext v A). Qed.

  (** The runs around the edge to a neighbour that is 0, seen from the
      neighbour. *)
  Lemma RunFromOther z : Adjacent z v -> before z = OnSurface -> RunAround now z v.
  Proof.
    intros A Z. apply AdjacentMutual in A.
    destruct Disk as (_ & _ & _ & _ & R & _). destruct (R z Z A) as [(x & X & V & Y) H].
    split.
    - exists x. rewrite (Else x (NearOther x V)). auto.
    - apply (HangsSame (fun x => before x = Plus /\ Adjacent v x /\ Adjacent z x));
        [|exact H].
      intros y. rewrite StillPlus. pose proof (NearOther y). tauto.
  Qed.

  Lemma DiskKept z : Adjacent z v -> before z = OnSurface ->
    (exists x, now x = Plus /\ Adjacent z x) ->
    DiskAround before z -> DiskAround now z.
  Proof.
    intros A Z Some (_ & P & _ & N & R & W). pose proof (AdjacentMutual _ _ A) as A'.
    pose proof (RunFromOther z A Z) as Run.
    pose proof Disk as (_ & _ & _ & _ & Rv & Wv).
    split; [exact Some|]. split; [|split; [|split; [|split]]].
    - apply (WithoutOne v (fun x => before x = Plus /\ Adjacent z x)); [| |exact P].
      + intros u. rewrite StillPlus. tauto.
      + intros _ u w U U' [Pu Au] [Pw Aw]. destruct Run as [_ H].
        apply (JoinedWider (fun x => now x = Plus /\ Adjacent z x /\ Adjacent v x));
          [tauto|]. apply H; auto.
    - exists v. split; [congruence|exact A].
    - destruct Run as [(x & X & Ax & Vx) _].
      assert (Hub : forall u, now u <> Plus /\ Adjacent z u ->
        Joined (fun x => now x <> Plus /\ Adjacent z x) Adjacent u x).
      { intros u [Nu Au]. destruct (SamePoint3 u v) as [->|D].
        - apply JoinedNext; auto.
        - apply (JoinedWider (fun x => before x <> Plus /\ Adjacent z x)).
          + intros y [Ny Ay]. split; [rewrite StillPlus; tauto|exact Ay].
          + apply N; (split; [|assumption]).
            * rewrite <- (Else u D). exact Nu.
            * rewrite <- (Else x (NearOther x Vx)). exact X. }
      intros u w U U'. apply (JoinedThen _ _ _ u x w (Hub u U)).
      apply JoinedBack; [exact AdjacentMutual|exact (Hub w U')].
    - intros y Y Ay. destruct (SamePoint3 y v) as [->|D]; [exact Run|].
      rewrite (Else y D) in Y. destruct (R y Y Ay) as [(x & X & Zx & Yx) H].
      split.
      + exists x. rewrite StillPlus. tauto.
      + apply (WithoutOne v (fun x => before x = Plus /\ Adjacent z x /\ Adjacent y x));
          [| |exact H].
        * intros u. rewrite StillPlus. tauto.
        * intros (_ & _ & Yv) u w U U' (Pu & Zu & Yu) (Pw & Zw & Yw).
          assert (S : u = w).
          { apply (Wv z y u w); auto using AdjacentMutual.
            - apply StillPlus, Pu.
            - apply StillPlus, Pw. }
          subst w. constructor. auto.
    - intros y y' p q Y Y' Pp Pq Zy Zy' Yy Zp Yp Yp' Zq Yq Yq'.
      apply StillPlus in Pp, Pq. destruct Pp as [Pp Np], Pq as [Pq Nq].
      destruct (SamePoint3 y v) as [->|D]; [|destruct (SamePoint3 y' v) as [->|D']].
      + rewrite (Else y' (NearOther y' Yy)) in Y'.
        apply (Wv z y' p q); auto using AdjacentMutual.
      + rewrite (Else y D) in Y.
        apply (Wv z y p q); auto using AdjacentMutual.
      + rewrite (Else y D) in Y. rewrite (Else y' D') in Y'.
        apply (W y y' p q); assumption.
  Qed.
End Step.

(** ** All steps *)

Theorem DisksStay sign now : (forall v, sign v <> OnSurface) ->
  ByDisks sign now -> DisksAround now.
Proof.
  intros Decided. induction 1 as [now S|v before now _ IH D V E].
  - intros z Z. rewrite S in Z. destruct (Decided z Z).
  - intros z Z (d & P).
    assert (Same : (forall e, now (Translate z (Offset e))
      = before (Translate z (Offset e))) -> StrictDisk (LinkOf before z) = true ->
      StrictDisk (LinkOf now z) = true).
    { intros S H. rewrite <- H. apply StrictDiskSame. exact S. }
    destruct (SamePoint3 z v) as [->|Nz].
    { apply Same; [|exact D]. intros e. apply E.
      apply NearOther. exists e. reflexivity. }
    rewrite (E z Nz) in Z.
    assert (Q : exists d, before (Translate z (Offset d)) = Plus).
    { exists d. rewrite <- E; [exact P|]. intros X. congruence. }
    specialize (IH z Z Q). clear Q.
    destruct (existsb (fun e => Coord3Equal (Translate z (Offset e)) v)
      AllDirections) eqn:X.
    + apply existsb_exists in X. destruct X as (e & _ & X).
      apply Coord3EqualTrue in X. apply StrictDiskIff in IH, D. apply StrictDiskIff.
      apply (DiskKept before now v D V E z); [exists e; congruence|exact Z| |exact IH].
      exists (Translate z (Offset d)). split; [exact P|exists d; reflexivity].
    + apply Same; [|exact IH]. intros e. apply E. intros Y.
      apply not_true_iff_false in X. apply X. apply existsb_exists. exists e.
      split; [apply InAllDirections|]. rewrite Y. apply Coord3EqualRefl.
Qed.

Theorem SettledDisksAround th sample cut gap vs :
  let sign := OpenSigns sample in
  DisksAround (SignAmong sign (Settle th sign cut gap vs)).
Proof.
  intros sign. apply (DisksStay sign); [exact (OpenDecided sample)|].
  apply SettledByDisks.
Qed.
