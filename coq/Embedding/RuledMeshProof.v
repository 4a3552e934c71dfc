(** * The mesh of a rule: it embeds if no short edge is crossed *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.Cases.Isometry Angles.AngleTheorems
  Embedding.MeshEmbedsProof Embedding.LevelProof Embedding.WarpOrClampProof.
Open Scope Z_scope.

Section Mesh.
  Variables (sign : SignField) (cut : CutField).
  Variables (stays : Coord3 -> bool) (limit : Coord3 -> Z).
  Hypothesis OnEdges : CutsOnEdges sign cut.

  Let warping := RuledWarping AngleThresholds sign cut stays limit.
  Let clamped := ClampedCut AngleThresholds cut.

  Theorem RuledBounds tid t :
    In t (WarpOrClamp AngleThresholds sign cut stays limit tid) ->
    WellShaped WidestAngles t.
  Proof.
    apply DihedralBounds.
    apply AnySubsetStays; [exact AngleThresholdsAtMostHalf|exact OnEdges].
  Qed.

  Lemma RuledInside : CutsInside sign warping clamped.
  Proof.
    apply ClampedInside; [exact AngleThresholdsAtMostHalf|].
    intros []; reflexivity.
  Qed.

  Theorem RuledMeshEmbeds tid tid' t t' : Uncrossed warping ->
    InLattice tid -> InLattice tid' ->
    In t (PlacedNames sign warping tid) -> In t' (PlacedNames sign warping tid') ->
    MeetInSharedVertices (PlacedPosition warping clamped) t t'.
  Proof.
    intros U. apply (PlacedEmbeds sign); [apply RuledMovesAtMost, OnEdges|exact U|].
    exact RuledInside.
  Qed.

  Theorem RuledInteriorsApart tid tid' t t' : UncrossedOrLevel warping ->
    InLattice tid -> InLattice tid' ->
    In t (PlacedNames sign warping tid) -> In t' (PlacedNames sign warping tid') ->
    Overlap (MapTet (PlacedPosition warping clamped) t)
            (MapTet (PlacedPosition warping clamped) t') ->
    tid = tid' /\ t = t'.
  Proof.
    intros U E E' I I'. apply (LevelInteriorsApart sign warping clamped);
      try assumption; [apply RuledMovesAtMost, OnEdges|exact RuledInside|].
    apply (WellShapedPositive WidestAngles), (RuledBounds tid').
    unfold WarpOrClamp. rewrite PlacedByName. apply in_map, I'.
  Qed.
End Mesh.

(** ** Limits under which nothing is crossed *)

Section Stop.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Hypothesis OnEdges : CutsOnEdges sign cut.

  Lemma CrossedMeans v d e e' t t' :
    DirectionKind d = Short -> DirectionKind e = Long ->
    Translate (Offset e) (Offset e') = C3 0 0 0 ->
    0 < Dot (Offset d) (Offset e) ->
    WarpVertex th sign cut v = Moves e t ->
    WarpVertex th sign cut (Translate v (Offset d)) = Moves e' t' ->
    Steps <= 2 * (t + t') -> CrossedAt th sign cut v = true.
  Proof.
    intros D E O P W W' L. unfold CrossedAt. rewrite W. apply existsb_exists.
    exists d. split; [apply InAllDirections|].
    unfold Crosses. rewrite D, E, W', O. cbn [Coord3Equal Z.eqb andb].
    apply andb_true_intro. split; [apply Z.ltb_lt, P|apply Z.leb_le, L].
  Qed.

  Variables (stays : Coord3 -> bool) (stop : Z).
  Hypothesis NotBack : 0 <= stop.

  Let warping := RuledWarping th sign cut stays (StopIfCrossed th sign cut stop).

  Lemma StopMeans v d t :
    warping v = Moves d t -> CrossedAt th sign cut v = true -> t <= stop.
  Proof.
    unfold warping, RuledWarping, StopIfCrossed. intros E C. rewrite C in E.
    destruct (WarpVertex th sign cut v) as [|e s]; [discriminate E|].
    destruct (stays v); [discriminate E|]. injection E as -> <-. lia.
  Qed.

  Theorem StoppedApproach limit : Steps / 2 - 1 <= limit -> 2 * stop <= limit ->
    ApproachAtMost limit warping.
  Proof.
    intros A B v d e e' t t' D E O P W W'.
    set (u := Translate v (Offset d)) in *.
    destruct (RuledMeans th sign cut stays _ OnEdges v e t W) as (s & S & L).
    destruct (RuledMeans th sign cut stays _ OnEdges u e' t' W') as (s' & S' & L').
    destruct (Z.ltb_spec (2 * (s + s')) Steps) as [Apart|Cross].
    { change Steps with 65536 in *. change (65536 / 2) with 32768 in *. lia. }
    assert (C : CrossedAt th sign cut v = true)
      by (apply (CrossedMeans v d e e' s s'); assumption).
    assert (exists d', DirectionKind d' = Short /\ Translate u (Offset d') = v /\
      forall e, Translate (Offset e) (Offset e') = C3 0 0 0 ->
        Dot (Offset d) (Offset e) = Dot (Offset d') (Offset e'))
      as (d' & D' & Back & Dots).
    { assert (exists d', Translate (Offset d) (Offset d') = C3 0 0 0
        /\ DirectionKind d' = Short) as (d' & Z0 & K).
      { destruct d; try discriminate D;
          [exists Dir_mmm|exists Dir_ppp|exists Dir_mmp|exists Dir_ppm
          |exists Dir_mpm|exists Dir_pmp|exists Dir_pmm|exists Dir_mpp];
          split; reflexivity. }
      exists d'. split; [exact K|]. unfold u.
      destruct v as [x y z], (Offset d) as [a b c], (Offset d') as [a' b' c'].
      cbn [Translate] in *. injection Z0 as Za Zb Zc. split; [f_equal; lia|].
      intros f. destruct (Offset f) as [p q r], (Offset e') as [p' q' r'].
      cbn [Translate Dot]. intros F. injection F as Fp Fq Fr.
      replace a' with (- a) by lia. replace b' with (- b) by lia.
      replace c' with (- c) by lia. replace p' with (- p) by lia.
      replace q' with (- q) by lia. replace r' with (- r) by lia. ring. }
    assert (C' : CrossedAt th sign cut u = true).
    { apply (CrossedMeans u d' e' e s' s); try assumption.
      - destruct e; try discriminate E; destruct e'; try discriminate O; reflexivity.
      - rewrite <- O. destruct (Offset e), (Offset e'). cbn [Translate].
        f_equal; ring.
      - rewrite <- (Dots e O). exact P.
      - rewrite Back. exact S.
      - lia. }
    pose proof (StopMeans v e t W C). pose proof (StopMeans u e' t' W' C'). lia.
  Qed.
End Stop.

Theorem BeforeQuarterUncrossed th sign cut stays : CutsOnEdges sign cut ->
  Uncrossed (RuledWarping th sign cut stays
    (StopIfCrossed th sign cut (Quarter - 1))).
Proof. intros C. apply StoppedApproach; [exact C|discriminate ..]. Qed.

Theorem AtQuarterUncrossedOrLevel th sign cut stays : CutsOnEdges sign cut ->
  UncrossedOrLevel (RuledWarping th sign cut stays
    (StopIfCrossed th sign cut Quarter)).
Proof. intros C. apply StoppedApproach; [exact C|discriminate ..]. Qed.
