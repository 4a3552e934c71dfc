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

Section Settle.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField) (gap : Gap).

  Local Notation one := (SettleOne th sign cut gap).
  Local Notation short := (Shortened sign gap).
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
    destruct (StrictDisk (LinkOf (now zeros) v)); [right|auto].
    exists e, t. auto.
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

  Lemma ShortOfMeans zeros v e t d : ShortOf sign gap zeros v e t d <= t /\
    (ShortOf sign gap zeros v e t d = t \/
     exists e' t', PlaceIn zeros (Translate v (Offset d)) = Moves e' t' /\
       Translate (Offset e) (Offset e') = C3 0 0 0 /\
       ShortOf sign gap zeros v e t d
       = Z.min t (Steps / 2 - t' - gap (sign v) (sign (Translate v (Offset d))))).
  Proof.
    unfold ShortOf. cbv zeta. destruct (DirectionKind d); [split; [lia|auto]|].
    destruct (PlaceIn zeros _) as [|e' t']; [split; [lia|auto]|].
    destruct (Coord3Equal _ _) eqn:O;
      [|rewrite andb_false_r; split; [lia|auto]].
    apply Coord3EqualTrue in O.
    destruct (0 <? _); cbn [andb]; [|split; [lia|auto]].
    split; [lia|right]. exists e', t'. auto.
  Qed.

  Lemma ShortOfBound zeros v e t d e' t' :
    let w := Translate v (Offset d) in
    DirectionKind d = Short -> 0 < Dot (Offset d) (Offset e) ->
    Translate (Offset e) (Offset e') = C3 0 0 0 -> PlaceIn zeros w = Moves e' t' ->
    ShortOf sign gap zeros v e t d + t' <= Steps / 2 - gap (sign v) (sign w).
  Proof.
    intros w D P O W. unfold ShortOf. cbv zeta. fold w. rewrite D, W, O.
    apply Z.ltb_lt in P. rewrite P. cbn [Coord3Equal Z.eqb andb]. lia.
  Qed.

  (** Shortened by all of some directions. *)
  Lemma FoldShort zeros v e ds : forall t,
    let t' := fold_left (ShortOf sign gap zeros v e) ds t in
    t' <= t /\ (forall d, In d ds -> exists s, t' <= ShortOf sign gap zeros v e s d).
  Proof.
    induction ds as [|d ds IH]; intros t; cbn [fold_left].
    - split; [lia|intros d []].
    - destruct (IH (ShortOf sign gap zeros v e t d)) as [L A].
      pose proof (ShortOfMeans zeros v e t d) as [M _].
      split; [lia|]. intros f [<-|I]; [exists t; exact L|apply A, I].
  Qed.

  Lemma ShortenedLess zeros v e t : short zeros v e t <= t.
  Proof.
    unfold Shortened. destruct (DirectionKind e); [|lia].
    apply (FoldShort zeros v e AllDirections t).
  Qed.

  Lemma ShortenedBound zeros v e t d e' t' :
    let w := Translate v (Offset d) in
    DirectionKind e = Long ->
    DirectionKind d = Short -> 0 < Dot (Offset d) (Offset e) ->
    Translate (Offset e) (Offset e') = C3 0 0 0 -> PlaceIn zeros w = Moves e' t' ->
    short zeros v e t + t' <= Steps / 2 - gap (sign v) (sign w).
  Proof.
    intros w L D P O W. unfold Shortened. rewrite L.
    destruct (proj2 (FoldShort zeros v e AllDirections t) d (InAllDirections d))
      as [s S].
    pose proof (ShortOfBound zeros v e s d e' t' D P O W) as B. cbv zeta in B.
    fold w in B. lia.
  Qed.

  Section Within.
    Hypothesis Half : AtMostHalf th.
    Hypothesis OnEdges : CutsOnEdges sign cut.
    Hypothesis GapSmall : forall s s', gap s s' <= 1.

    (** Who is 0 was violated, and lies between where it was and its target. *)
    Definition TowardTargets (zeros : Zeros) : Prop :=
      forall v e t, PlaceIn zeros v = Moves e t ->
        exists t', WarpVertex th sign cut v = Moves e t' /\ 0 <= t <= t'.

    Lemma ShortOfNotBack zeros v e t d : TowardTargets zeros ->
      DirectionKind e = Long -> 0 <= t -> 0 <= ShortOf sign gap zeros v e t d.
    Proof.
      intros T L B. destruct (ShortOfMeans zeros v e t d) as [_ [->|(e' & t' & W & O & ->)]];
        [exact B|].
      destruct (T _ _ _ W) as (s & V & R). apply WarpedMeans in V.
      destruct V as (_ & _ & V). specialize (Half (DirectionKind e')).
      specialize (GapSmall (sign v) (sign (Translate v (Offset d)))).
      change Steps with 65536 in *. change (65536 / 2) with 32768. lia.
    Qed.

    Lemma ShortenedNotBack zeros v e t : TowardTargets zeros ->
      0 <= t -> 0 <= short zeros v e t.
    Proof.
      intros T. unfold Shortened. destruct (DirectionKind e) eqn:L; [|tauto].
      revert t. induction AllDirections as [|d ds IH]; intros t B; [exact B|].
      cbn [fold_left]. apply IH, ShortOfNotBack; assumption.
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
          split; [apply ShortenedNotBack; [exact T|lia]|apply ShortenedLess].
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
        pose proof (ShortenedBound zeros v e s d e' t' E D P O W) as B.
        cbv zeta in B. fold w in B. specialize (G (sign v) (sign w)). lia.
      + rewrite Ew, PlacedHere in W. injection W as -> <-.
        rewrite PlacedElsewhere in U by exact Nu.
        destruct (Turned d) as (d' & D' & Back).
        assert (Eu : Translate v (Offset d') = u)
          by (rewrite <- Ew; apply ThereAndBack, Back).
        assert (E' : DirectionKind e' = Long)
          by (destruct e; try discriminate E; destruct e'; try discriminate O;
              reflexivity).
        pose proof (ShortenedBound zeros v e' s d' e t) as B. cbv zeta in B.
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
