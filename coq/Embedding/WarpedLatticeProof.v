(** * Which warps keep the short edges: proof

    Looked at along one axis: a short edge is one unit long, and its ends move
    towards each other by less than that. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.Cases.AdmissibleProof
  Embedding.LatticeEmbedsProof.
Open Scope Z_scope.

Definition Axis (f : Coord3 -> Z) : Prop := f = XOf \/ f = YOf \/ f = ZOf.

Lemma SameOctantByAxis u v :
  (forall f, Axis f -> 0 < f u * f v) -> SameOctant u v.
Proof.
  intros H.   destruct u as [a b c], v as [x y z].
  exact (conj (H XOf (or_introl eq_refl))
          (conj (H YOf (or_intror (or_introl eq_refl)))
                (H ZOf (or_intror (or_intror eq_refl))))).
Qed.

(** How far a vertex moves along an axis. *)
Definition Shift (f : Coord3 -> Z) (w : Warping) : Z :=
  match w with Stays => 0 | Moves d t => t * f (Offset d) end.

Lemma ShiftOfPlace f v w : Axis f ->
  f (WarpedPosition v w) = Steps * f v + Shift f w.
Proof.
  destruct v as [x y z], w as [|d t]; [|destruct (Offset d) as [a b c] eqn:E];
    intros [->|[->| ->]]; cbn [WarpedPosition Scale Translate Shift];
    rewrite ?E; cbn [Scale Translate XOf YOf ZOf]; ring.
Qed.

Lemma ShortOffset f d : Axis f -> DirectionKind d = Short ->
  f (Offset d) = 1 \/ f (Offset d) = -1.
Proof. intros [->|[->| ->]]; destruct d; cbn; intros; lia || discriminate. Qed.

Section Keeps.
  Variable warping : Coord3 -> Warping.

  Lemma KeepsByAxis :
    (forall f v d, Axis f -> DirectionKind d = Short ->
       f (Offset d) * (Shift f (warping v)
         - Shift f (warping (Translate v (Offset d)))) < Steps) ->
    KeepsShortEdges (fun v => WarpedPosition v (warping v)).
  Proof.
    intros H v d K. apply SameOctantByAxis. intros f F.
    specialize (H f v d F K).
    assert (E : forall a b, f (Difference a b) = f b - f a)
      by (intros [] []; destruct F as [->|[->| ->]]; reflexivity).
    assert (E' : f (Translate v (Offset d)) = f v + f (Offset d))
      by (destruct v, (Offset d); destruct F as [->|[->| ->]]; reflexivity).
    rewrite E, !ShiftOfPlace, E' by exact F.
    change Steps with 65536 in *.
    destruct (ShortOffset f d F K) as [D|D]; rewrite D in *; lia.
  Qed.

  (** No vertex moves half a unit. *)
  Lemma LittleMoves :
    (forall v d t, warping v = Moves d t ->
       0 <= t /\ 2 * (match DirectionKind d with Long => 2 | Short => 1 end * t)
         < Steps) ->
    KeepsShortEdges (fun v => WarpedPosition v (warping v)).
  Proof.
    intros H. apply KeepsByAxis. intros f v d F K.
    assert (B : forall u, - Steps < 2 * Shift f (warping u) < Steps).
    { intros u. destruct (warping u) as [|e t] eqn:E; [cbn; lia|].
      apply H in E. destruct E as [P E]. cbn [Shift].
      destruct F as [->|[->| ->]], e; cbn [XOf YOf ZOf Offset DirectionKind] in *;
        lia. }
    pose proof (B v). pose proof (B (Translate v (Offset d))).
    destruct (ShortOffset f d F K) as [-> | ->]; lia.
  Qed.

  (** How far the ends of a short edge move towards each other along an axis. *)
  Lemma ApproachByAxis limit : 31744 <= limit ->
    MovesAtMost AngleThresholds warping -> ApproachAtMost limit warping ->
    forall f v d, Axis f -> DirectionKind d = Short ->
      f (Offset d) * (Shift f (warping v)
        - Shift f (warping (Translate v (Offset d)))) <= 2 * limit.
  Proof.
    intros Limit M U f v d F K.
    set (u := Translate v (Offset d)).
    assert (B : forall v, - 26112 <= Shift f (warping v) <= 26112 \/
      exists e t, warping v = Moves e t /\ DirectionKind e = Long /\
        0 <= t <= 18688 /\ (f (Offset e) = 2 \/ f (Offset e) = -2)).
    { clear v u. intros v. destruct (warping v) as [|e t] eqn:E; [cbn; lia|].
      apply M in E. cbn [Shift].
      change (ThresholdSteps AngleThresholds (DirectionKind e))
        with (match DirectionKind e with Long => 18688 | Short => 26112 end) in E.
      destruct F as [->|[->| ->]], e;
        cbn [XOf YOf ZOf Offset DirectionKind] in *;
        (left; lia) || (right; eexists _, t; repeat split; (reflexivity || cbn; lia)). }
    destruct (B v) as [Bv|(e & t & Ev & Ke & T & O)],
      (B u) as [Bu|(e' & t' & Eu & Ke' & T' & O')];
      destruct (ShortOffset f d F K) as [D|D]; rewrite D;
      rewrite ?Ev, ?Eu; cbn [Shift]; try lia.
    all: destruct O as [O|O], O' as [O'|O']; rewrite O, O'; try lia.
    all: assert (C : t + t' <= limit);
      [apply (U v d e e' t t' K Ke); auto|lia].
    all: destruct F as [->|[->| ->]], e; try discriminate O;
      destruct e'; try discriminate O'; try reflexivity.
    all: destruct d; try discriminate K; try discriminate D; reflexivity.
  Qed.

  Lemma UncrossedKeepsShortEdges : MovesAtMost AngleThresholds warping ->
    Uncrossed warping -> KeepsShortEdges (fun v => WarpedPosition v (warping v)).
  Proof.
    intros M U. apply KeepsByAxis. intros f v d F K.
    pose proof (ApproachByAxis (Steps / 2 - 1) ltac:(discriminate) M U f v d F K)
      as H.
    change Steps with 65536 in *. change (65536 / 2) with 32768 in *. lia.
  Qed.
End Keeps.

(** ** The product's warp *)

Lemma WarpKeepsShortEdges th sign cut :
  MovesLittle th -> CutsOnEdges sign cut ->
  KeepsShortEdges (fun c => WarpedPosition c (WarpVertex th sign cut c)).
Proof.
  intros L C. apply (LittleMoves (WarpVertex th sign cut)). intros v d t E.
  destruct (WarpedMeans th sign cut v d t E) as (-> & O & B).
  pose proof (CutFromInRange sign cut C v d O).
  destruct th as [long short], L as [Long Short].
  unfold ThresholdSteps in B. change (Steps / 256) with 256 in B.
  change Steps with 65536. destruct (DirectionKind d); lia.
Qed.

Theorem WarpedLatticeEmbeds long short sign cut tid tid' :
  long <= 64 -> short <= 128 -> CutsOnEdges sign cut ->
  InLattice tid -> InLattice tid' ->
  MeetInSharedVertices (WarpedPlace (TH long short) sign cut)
    (LatticeTet tid) (LatticeTet tid').
Proof.
  intros L S C. apply LatticeEmbeds. unfold WarpedPlace, MeshPosition.
  apply WarpKeepsShortEdges; [split|]; assumption.
Qed.
