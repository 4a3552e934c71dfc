(** * One sweep over a list of vertices: what it leaves *)

From Coq Require Import FMapPositive.
From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.Cases.Isometry Angles.Cases.AdmissibleProof
  Embedding.DiskTables Embedding.GreedyProof Embedding.LinkProof
  Embedding.DiskTablesProof.
Open Scope Z_scope.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpVertex StrictDisk IsDisk].

(** ** Keys *)

Lemma SpelledApart p : forall q r s, Spelled p r = Spelled q s -> p = q /\ r = s.
Proof.
  induction p as [p IH|p IH|]; intros [q|q|] r s E; cbn [Spelled] in E;
    try discriminate E; injection E as E.
  - destruct (IH q r s E) as [-> ->]. auto.
  - destruct (IH q r s E) as [-> ->]. auto.
  - auto.
Qed.

Lemma PositiveOfApart m n : PositiveOf m = PositiveOf n -> m = n.
Proof. destruct m, n; cbn; congruence. Qed.

Lemma PointKeyApart u v : PointKey u = PointKey v -> u = v.
Proof.
  destruct u as [x y z], v as [x' y' z']. cbn [PointKey]. intros E.
  apply SpelledApart in E. destruct E as [X E].
  apply SpelledApart in E. destruct E as [Y Z].
  apply PositiveOfApart in X, Y, Z. congruence.
Qed.

Lemma NoneIn v : PlaceIn NoZeros v = Stays.
Proof. unfold PlaceIn, NoZeros. rewrite PositiveMap.gempty. reflexivity. Qed.

Lemma PlacedHere zeros v w :
  PlaceIn (PositiveMap.add (PointKey v) w zeros) v = w.
Proof. unfold PlaceIn. rewrite PositiveMap.gss. reflexivity. Qed.

Lemma PlacedElsewhere zeros v w u : u <> v ->
  PlaceIn (PositiveMap.add (PointKey v) w zeros) u = PlaceIn zeros u.
Proof.
  intros N. unfold PlaceIn. rewrite PositiveMap.gso; [reflexivity|].
  intros E. exact (N (PointKeyApart _ _ E)).
Qed.

(** ** Opposite directions *)

Lemma Turned d : exists d', DirectionKind d' = DirectionKind d /\
  Translate (Offset d) (Offset d') = C3 0 0 0.
Proof.
  destruct d;
    [exists Dir_m00|exists Dir_p00|exists Dir_0m0|exists Dir_0p0|exists Dir_00m
    |exists Dir_00p|exists Dir_mmm|exists Dir_ppp|exists Dir_mmp|exists Dir_ppm
    |exists Dir_mpm|exists Dir_pmp|exists Dir_pmm|exists Dir_mpp];
    split; reflexivity.
Qed.

Lemma ThereAndBack v a b : Translate a b = C3 0 0 0 ->
  Translate (Translate v a) b = v.
Proof.
  destruct v, a, b. cbn [Translate]. intros E. injection E as X Y Z.
  f_equal; lia.
Qed.

Lemma DotTurned a b c d : Translate a b = C3 0 0 0 -> Translate c d = C3 0 0 0 ->
  Dot b d = Dot a c.
Proof.
  destruct a as [a1 a2 a3], b as [b1 b2 b3], c as [c1 c2 c3], d as [d1 d2 d3].
  cbn [Translate Dot]. intros E F. injection E as A B C. injection F as A' B' C'.
  replace b1 with (- a1) by lia. replace b2 with (- a2) by lia.
  replace b3 with (- a3) by lia. replace d1 with (- c1) by lia.
  replace d2 with (- c2) by lia. replace d3 with (- c3) by lia. ring.
Qed.

Lemma TranslateSwapped a b : Translate a b = Translate b a.
Proof. destruct a, b. cbn [Translate]. f_equal; ring. Qed.

(** ** One turn *)

Lemma FoldKeeps {A B} (P : A -> Prop) (f : A -> B -> A) :
  (forall a b, P a -> P (f a b)) -> forall l a, P a -> P (fold_left f l a).
Proof.
  intros K l. induction l as [|b l IH]; intros a H; [exact H|].
  cbn [fold_left]. apply IH, K, H.
Qed.

(** ** Room *)

Section Room.
  Variables (sign : SignField) (gap : Gap).
  Variables (target : Coord3 -> Warping) (turn : Coord3 -> nat).

  Local Notation room := (RoomBeside sign gap target turn).
  Local Notation short := (Shortened sign gap target turn).

  Lemma RoomMeans zeros v e t d : let w := Translate v (Offset d) in
    room zeros v e t d = t \/
    exists e' t',
      PlaceIn zeros w = Moves e' t' /\
        room zeros v e t d = Steps / 2 - gap (sign v) (sign w) - t' \/
      target w = Moves e' t' /\
        room zeros v e t d = (Steps / 2 - gap (sign v) (sign w) + t - t') / 2.
  Proof.
    cbv zeta. unfold RoomBeside, RoomFor. cbv zeta.
    destruct (DirectionKind d); [auto|]. destruct (0 <? _); [|auto].
    destruct (PlaceIn zeros _) as [|e' t'].
    - destruct (target _) as [|e' t']; [auto|].
      destruct (_ && _); [right; exists e', t'; auto|auto].
    - destruct (Towards e e'); [right; exists e', t'; auto|auto].
  Qed.

  Lemma RoomBound zeros v e t d e' t' :
    let w := Translate v (Offset d) in
    DirectionKind d = Short -> 0 < Dot (Offset d) (Offset e) ->
    Translate (Offset e) (Offset e') = C3 0 0 0 -> PlaceIn zeros w = Moves e' t' ->
    room zeros v e t d + t' = Steps / 2 - gap (sign v) (sign w).
  Proof.
    intros w D P O W. unfold RoomBeside, RoomFor, Towards. cbv zeta. fold w.
    apply Z.ltb_lt in P. rewrite D, P, W, O. cbn [Coord3Equal Z.eqb andb]. lia.
  Qed.

  (** All moves are by less than half an edge. *)
  Lemma RoomNotBack zeros v e t d :
    (forall u f s, PlaceIn zeros u = Moves f s -> 2 * s < Steps) ->
    (forall u f s, target u = Moves f s -> 2 * s < Steps) ->
    (forall s s', gap s s' <= 1) ->
    0 <= t -> 0 <= room zeros v e t d.
  Proof.
    intros P T G B. destruct (RoomMeans zeros v e t d) as [->|(e' & t' & [[W ->]|[W ->]])];
      [exact B|apply P in W|apply T in W; apply Z.div_pos; [|lia]];
      specialize (G (sign v) (sign (Translate v (Offset d))));
      change Steps with 65536 in *; change (65536 / 2) with 32768; lia.
  Qed.

  (** Shortened by all of some directions. *)
  Lemma FoldRoom zeros v e t ds : forall s,
    let s' := fold_left (fun r d => Z.min r (room zeros v e t d)) ds s in
    s' <= s /\ (forall d, In d ds -> s' <= room zeros v e t d) /\
    ((forall d, 0 <= room zeros v e t d) -> 0 <= s -> 0 <= s').
  Proof.
    induction ds as [|d ds IH]; intros s; cbn [fold_left].
    - split; [lia|split; [intros d []|auto]].
    - destruct (IH (Z.min s (room zeros v e t d))) as (L & A & N).
      split; [lia|split].
      + intros f [<-|I]; [lia|apply A, I].
      + intros R B. apply N; [exact R|]. specialize (R d). lia.
  Qed.

  Lemma ShortenedLess zeros v e t : short zeros v e t <= t.
  Proof.
    unfold Shortened. destruct (DirectionKind e); [|lia].
    apply (FoldRoom zeros v e t AllDirections t).
  Qed.

  Lemma ShortenedBound zeros v e t d e' t' :
    let w := Translate v (Offset d) in
    DirectionKind e = Long ->
    DirectionKind d = Short -> 0 < Dot (Offset d) (Offset e) ->
    Translate (Offset e) (Offset e') = C3 0 0 0 -> PlaceIn zeros w = Moves e' t' ->
    short zeros v e t + t' <= Steps / 2 - gap (sign v) (sign w).
  Proof.
    intros w L D P O W. unfold Shortened. rewrite L.
    pose proof (proj1 (proj2 (FoldRoom zeros v e t AllDirections t)) d
      (InAllDirections d)) as S.
    pose proof (RoomBound zeros v e t d e' t' D P O W) as B. cbv zeta in B.
    fold w in B. lia.
  Qed.

  Lemma ShortenedNotBack zeros v e t :
    (forall u f s, PlaceIn zeros u = Moves f s -> 2 * s < Steps) ->
    (forall u f s, target u = Moves f s -> 2 * s < Steps) ->
    (forall s s', gap s s' <= 1) ->
    0 <= t -> 0 <= short zeros v e t.
  Proof.
    intros P T G B. unfold Shortened. destruct (DirectionKind e); [|exact B].
    apply (proj2 (proj2 (FoldRoom zeros v e t AllDirections t))); [|exact B].
    intros d. apply RoomNotBack; assumption.
  Qed.
End Room.

Section Settle.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField) (gap : Gap).

  Local Notation one := (SettleOne th sign cut gap).
  Local Notation short :=
    (Shortened sign gap (WarpVertex th sign cut) (Turn th sign cut)).
  Local Notation now zeros := (SignAmong sign zeros).

  Lemma DiskAmong zeros v :
    IsDisk (LinkAmong sign zeros v) = StrictDisk (LinkOf (now zeros) v).
  Proof. exact (IsDiskCorrect (LinkOf (now zeros) v)). Qed.

  (** Nothing changes, or one vertex is placed. *)
  Lemma OneMeans zeros v :
    one zeros v = zeros \/
    exists e t, WarpVertex th sign cut v = Moves e t /\
      StrictDisk (LinkOf (now zeros) v) = true /\
      one zeros v = PositiveMap.add (PointKey v) (Moves e (short zeros v e t)) zeros.
  Proof.
    unfold SettleOne. rewrite DiskAmong.
    destruct (WarpVertex th sign cut v) as [|e t]; [auto|].
    destruct (StrictDisk (LinkOf (now zeros) v)); [|auto]. cbv zeta.
    destruct (StaysRather _ _ _ _ _); [auto|right]. exists e, t. auto.
  Qed.

  (** What every turn keeps holds at the end. *)
  Lemma SettleKeeps (P : Zeros -> Prop) :
    P NoZeros -> (forall zeros v, P zeros -> P (one zeros v)) ->
    forall vs, P (Settle th sign cut gap vs).
  Proof.
    intros B K vs. exact (FoldKeeps P _ K vs _ B).
  Qed.

  Theorem SettledByDisks vs : ByDisks sign (now (Settle th sign cut gap vs)).
  Proof.
    apply (SettleKeeps (fun zeros => ByDisks sign (now zeros))).
    - apply ByDisks_none. intros u. unfold SignAmong. rewrite NoneIn. reflexivity.
    - intros zeros v B. destruct (OneMeans zeros v) as [->|(e & t & _ & D & ->)];
        [exact B|].
      apply (ByDisks_one sign v (now zeros)); [exact B|exact D| |].
      + unfold SignAmong. rewrite PlacedHere. reflexivity.
      + intros u N. unfold SignAmong. rewrite PlacedElsewhere by exact N. reflexivity.
  Qed.

  (** ** How far *)

  Section Within.
    Hypothesis Half : AtMostHalf th.
    Hypothesis OnEdges : CutsOnEdges sign cut.
    Hypothesis GapSmall : forall s s', gap s s' <= 1.

    (** Who is 0 was violated, and lies between where it was and its target. *)
    Definition TowardTargets (zeros : Zeros) : Prop :=
      forall v e t, PlaceIn zeros v = Moves e t ->
        exists t', WarpVertex th sign cut v = Moves e t' /\ 0 <= t <= t'.

    Lemma TargetInHalf v e t : WarpVertex th sign cut v = Moves e t -> 2 * t < Steps.
    Proof.
      intros W. apply WarpedMeans in W. destruct W as (_ & _ & L).
      specialize (Half (DirectionKind e)). lia.
    Qed.

    Lemma TowardInHalf zeros v e t : TowardTargets zeros ->
      PlaceIn zeros v = Moves e t -> 2 * t < Steps.
    Proof.
      intros T P. destruct (T _ _ _ P) as (s & W & L). apply TargetInHalf in W. lia.
    Qed.

    Lemma SettledTowardTargets vs : TowardTargets (Settle th sign cut gap vs).
    Proof.
      apply SettleKeeps.
      - intros v e t E. rewrite NoneIn in E. discriminate E.
      - intros zeros v T. destruct (OneMeans zeros v) as [->|(e & t & W & _ & ->)];
          [exact T|].
        intros u f s E. destruct (SamePoint3 u v) as [->|N].
        + rewrite PlacedHere in E. injection E as <- <-.
          exists t. split; [exact W|].
          destruct (WarpedMeans th sign cut v e t W) as (Et & O & _).
          pose proof (CutFromInRange sign cut OnEdges v e O) as R. rewrite <- Et in R.
          split; [|apply ShortenedLess]. apply ShortenedNotBack; [|exact TargetInHalf
            |exact GapSmall|lia].
          intros w f s. apply TowardInHalf, T.
        + rewrite PlacedElsewhere in E by exact N. exact (T u f s E).
    Qed.

    Lemma SettledMovesAtMost vs :
      MovesAtMost th (PlaceIn (Settle th sign cut gap vs)).
    Proof.
      intros v d t E. destruct (SettledTowardTargets vs v d t E) as (s & W & L).
      destruct (WarpedMeans th sign cut v d s W) as (_ & _ & B). lia.
    Qed.

    (** It is one of the rules of [WarpOrClamp]. *)
    Theorem SettledIsRule vs : exists stays limit, forall v,
      PlaceIn (Settle th sign cut gap vs) v = RuledWarping th sign cut stays limit v.
    Proof.
      set (zeros := Settle th sign cut gap vs).
      exists (fun v => match PlaceIn zeros v with Stays => true | _ => false end),
             (fun v => match PlaceIn zeros v with Stays => 0 | Moves _ t => t end).
      intros v. unfold RuledWarping. destruct (PlaceIn zeros v) as [|e t] eqn:E.
      - destruct (WarpVertex th sign cut v); reflexivity.
      - destruct (SettledTowardTargets vs v e t E) as (s & -> & L). f_equal. lia.
    Qed.
  End Within.

  (** ** How near *)

  Theorem SettledApproach least vs : (forall s s', least <= gap s s') ->
    ApproachAtMost (Steps / 2 - least) (PlaceIn (Settle th sign cut gap vs)).
  Proof.
    intros G.
    apply (SettleKeeps (fun zeros => ApproachAtMost _ (PlaceIn zeros))).
    - intros v d e e' t t' _ _ _ _ W. rewrite NoneIn in W. discriminate W.
    - intros zeros v A.
      destruct (OneMeans zeros v) as [->|(f & s & _ & _ & ->)]; [exact A|].
      intros u d e e' t t' D E O P U W.
      set (w := Translate u (Offset d)) in *.
      assert (N : u <> w) by (intros H; apply (NeverAdjacent u); exists d; exact H).
      destruct (SamePoint3 u v) as [->|Nu]; [|destruct (SamePoint3 w v) as [Ew|Nw]].
      + rewrite PlacedHere in U. injection U as -> <-.
        rewrite PlacedElsewhere in W by congruence.
        pose proof (ShortenedBound sign gap (WarpVertex th sign cut) (Turn th sign cut)
          zeros v e s d e' t' E D P O W) as B.
        cbv zeta in B. fold w in B. specialize (G (sign v) (sign w)). lia.
      + rewrite Ew, PlacedHere in W. injection W as -> <-.
        rewrite PlacedElsewhere in U by exact Nu.
        destruct (Turned d) as (d' & D' & Back).
        assert (Eu : Translate v (Offset d') = u)
          by (rewrite <- Ew; apply ThereAndBack, Back).
        assert (E' : DirectionKind e' = Long)
          by (destruct e; try discriminate E; destruct e'; try discriminate O;
              reflexivity).
        pose proof (ShortenedBound sign gap (WarpVertex th sign cut) (Turn th sign cut)
          zeros v e' s d' e t) as B. cbv zeta in B.
        rewrite Eu in B. rewrite TranslateSwapped in O.
        specialize (B E'). rewrite D', D in B. specialize (B eq_refl).
        rewrite (DotTurned (Offset d) (Offset d') (Offset e) (Offset e')) in B;
          [|exact Back|rewrite TranslateSwapped; exact O].
        specialize (B P O U). specialize (G (sign v) (sign u)). lia.
      + rewrite PlacedElsewhere in U by exact Nu.
        rewrite PlacedElsewhere in W by exact Nw.
        exact (A u d e e' t t' D E O P U W).
  Qed.
End Settle.
