(** * Any subset stays: proof *)

From Coq Require Import ZArith List Bool Lia.
From Certet Require Import Lattice.Coord3 Lattice.Direction.
From Certet Require Import Lattice.StructuredTet.
From Certet Require Import Stencil.UnstructuredTet Stencil.StencilSet.
From Certet Require Import Stencil.SymbolProof Stencil.TriangleSpec.
From Certet Require Import Warp.Cut Warp.Warp Stuffing.Stuffing.
From Certet Require Import Angles.Geometry Angles.AnglesSpec.
From Certet Require Import Angles.AdmissibleProof Angles.Isometry.
From Certet Require Import Embedding.EmbeddingSpec Embedding.WarpOrClamp.
From Certet Require Import Embedding.EdgeRank Embedding.GreedyProof.
From Certet Require Import Embedding.MeshEmbedsProof.
Import ListNotations.
Open Scope Z_scope.

Lemma KindOfDirection v d : KindBetween v (Translate v (Offset d)) = DirectionKind d.
Proof.
  unfold KindBetween. destruct v as [x y z], d; cbn [Offset Translate Difference];
    match goal with |- context [Z.even ?e] => ring_simplify e end; reflexivity.
Qed.

Section Rule.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Variables (stays : Coord3 -> bool) (limit : Coord3 -> Z).
  Hypothesis Half : AtMostHalf th.
  Hypothesis OnEdges : CutsOnEdges sign cut.

  Let warping := RuledWarping th sign cut stays limit.
  Let clamped := ClampedCut th cut.

  (** It moves no farther than the paper's rule would, and to the same side. *)
  Lemma RuledMeans v d t : warping v = Moves d t -> exists t',
    WarpVertex th sign cut v = Moves d t' /\ 0 <= t <= t'.
  Proof.
    unfold warping, RuledWarping. intros E.
    destruct (WarpVertex th sign cut v) as [|e s] eqn:W; [discriminate E|].
    destruct (WarpedMeans th sign cut v e s W) as (Es & O & _).
    pose proof (CutFromInRange sign cut OnEdges v e O) as R. rewrite <- Es in R.
    destruct (stays v); [discriminate E|]. injection E as -> <-.
    exists s. split; [reflexivity|lia].
  Qed.

  Lemma RuledMovesAtMost : MovesAtMost th warping.
  Proof.
    intros v d t E. destruct (RuledMeans v d t E) as (s & W & L).
    destruct (WarpedMeans th sign cut v d s W) as (_ & _ & B). lia.
  Qed.

  Lemma ClampedInRange v d :
    let alpha := ThresholdSteps th (DirectionKind d) in
    alpha <= clamped v (Translate v (Offset d)) <= Steps - alpha.
  Proof.
    unfold clamped, ClampedCut. cbv zeta. rewrite KindOfDirection.
    specialize (Half (DirectionKind d)). lia.
  Qed.

  Theorem AnySubsetStays corners : Admissible sign warping clamped th corners.
  Proof.
    split.
    - intros v d t I E. split; [exact (RuledMovesAtMost v d t E)|].
      destruct (RuledMeans v d t E) as (s & W & _). intros J.
      destruct (WarpLeavesAdmissible th sign cut Half OnEdges corners) as [M _].
      destruct (M v d s I W) as [_ H]. destruct (H J) as [O A].
      split; [exact O|]. intros e r F.
      destruct (RuledMeans _ e r F) as (s' & W' & _). exact (A e s' W').
    - intros v d _ _ _ _. apply ClampedInRange.
  Qed.

  Lemma ClampedInside : (forall k, 0 < ThresholdSteps th k) ->
    CutsInside sign warping clamped.
  Proof.
    intros P v d u _ _. pose proof (ClampedInRange v d) as C.
    specialize (P (DirectionKind d)). fold u in C. cbv zeta in C. lia.
  Qed.
End Rule.

(** ** The paper's rule is the one where nobody stays *)

Lemma PlacedNamesExt before warping warping' tid :
  (forall c, warping c = warping' c) ->
  PlacedNames before warping tid = PlacedNames before warping' tid.
Proof.
  intros E. unfold PlacedNames. destruct tid as [anchor case].
  destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4]. f_equal.
  rewrite (GetUnstructuredTetsNatural MeshVertex MeshVertex (fun v => v)
    (PlacedSign before warping') (PlacedSign before warping)
    MeshIntersection MeshIntersection (Corner v1) (Corner v2) (Corner v3)
    (Corner v4)).
  - rewrite <- map_id. apply map_ext. intros []. reflexivity.
  - intros [c|a m] _; cbn [PlacedSign]; [rewrite E|]; reflexivity.
  - reflexivity.
Qed.

Lemma PlacedByName before warping cut tid :
  PlacedTets before warping cut tid
  = map (MapTet (PlacedPosition warping cut)) (PlacedNames before warping tid).
Proof.
  unfold PlacedTets, PlacedNames. destruct tid as [anchor case].
  destruct (GetStructuredTet (STId anchor case)). reflexivity.
Qed.

Theorem NobodyStays th sign cut tid :
  AtMostHalf th -> CutsOnEdges sign cut -> OfLattice tid ->
  WarpOrClamp th sign cut (fun _ => false) (fun _ => Steps) tid
  = StuffedTets th sign cut tid.
Proof.
  intros H C Even. rewrite StuffedArePlaced. unfold WarpOrClamp.
  assert (E : forall c, RuledWarping th sign cut (fun _ => false) (fun _ => Steps) c
    = WarpVertex th sign cut c).
  { intros c. unfold RuledWarping.
    destruct (WarpVertex th sign cut c) as [|d t] eqn:W; [reflexivity|].
    destruct (WarpedMeans th sign cut c d t W) as (Et & O & _).
    pose proof (CutFromInRange sign cut C c d O). f_equal. lia. }
  rewrite !PlacedByName, (PlacedNamesExt _ _ _ _ E). apply map_ext_in.
  intros t I. pose proof (proj1 (StuffedFollows _ _ _ _ Even I)) as B.
  assert (P : forall v, In v (TetCorners t) ->
    PlacedPosition (RuledWarping th sign cut (fun _ => false) (fun _ => Steps))
      (ClampedCut th cut) v
    = PlacedPosition (WarpVertex th sign cut) cut v).
  { intros v J. specialize (B v J). destruct v as [c|a m]; cbn [PlacedPosition].
    - rewrite E. reflexivity.
    - destruct B as (A & M & Pa & Pm). f_equal. unfold ClampedCut.
      assert (N : a <> m) by congruence.
      destruct (EdgeBetween tid a m A M N) as [d ->]. cbv zeta.
      rewrite KindOfDirection.
      destruct (WarpLeavesAdmissible th sign cut H C (Corners tid)) as [_ Q].
      specialize (Q a d A M Pa Pm). lia. }
  destruct t as [p q r s]. cbn [MapTet TetCorners In] in *.
  rewrite !P by tauto. reflexivity.
Qed.

(** ** The mesh embeds if the rule crosses no short edge *)

Theorem RuledMeshEmbeds sign cut stays limit tid tid' t t' :
  let warping := RuledWarping AngleThresholds sign cut stays limit in
  let clamped := ClampedCut AngleThresholds cut in
  CutsOnEdges sign cut -> Uncrossed warping ->
  OfLattice tid -> OfLattice tid' ->
  In t (PlacedNames sign warping tid) -> In t' (PlacedNames sign warping tid') ->
  MeetInSharedVertices (PlacedPosition warping clamped) t t'.
Proof.
  intros warping clamped C U. apply PlacedEmbeds; [|exact U|].
  - apply RuledMovesAtMost, C.
  - apply ClampedInside; intros []; vm_compute; discriminate || reflexivity.
Qed.

(** ** A limit under which nothing is crossed *)

Section Quarter.
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

  Lemma LimitMeans stays v d t :
    RuledWarping th sign cut stays (QuarterLimit th sign cut) v = Moves d t ->
    CrossedAt th sign cut v = true -> t <= Steps / 4 - 1.
  Proof.
    unfold RuledWarping, QuarterLimit. intros E C. rewrite C in E.
    destruct (WarpVertex th sign cut v) as [|e s]; [discriminate E|].
    destruct (stays v); [discriminate E|]. injection E as -> <-.
    change (Steps / 4 - 1) with 16383. lia.
  Qed.

  Theorem QuarterUncrossed stays :
    Uncrossed (RuledWarping th sign cut stays (QuarterLimit th sign cut)).
  Proof.
    intros v d e e' t t' D E O P W W'.
    set (u := Translate v (Offset d)) in *.
    destruct (RuledMeans th sign cut stays _ OnEdges v e t W) as (s & S & L).
    destruct (RuledMeans th sign cut stays _ OnEdges u e' t' W') as (s' & S' & L').
    destruct (Z.ltb_spec (2 * (s + s')) Steps) as [B|B].
    { change Steps with 65536 in *. change (65536 / 2) with 32768. lia. }
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
    pose proof (LimitMeans stays v e t W C) as Q.
    pose proof (LimitMeans stays u e' t' W' C') as Q'.
    change Steps with 65536 in *. change (65536 / 4) with 16384 in *.
    change (65536 / 2) with 32768. lia.
  Qed.
End Quarter.

(** Whoever stays. *)
Theorem QuarterMeshEmbeds sign cut stays tid tid' t t' :
  let warping := RuledWarping AngleThresholds sign cut stays
                   (QuarterLimit AngleThresholds sign cut) in
  CutsOnEdges sign cut -> OfLattice tid -> OfLattice tid' ->
  In t (PlacedNames sign warping tid) -> In t' (PlacedNames sign warping tid') ->
  MeetInSharedVertices
    (PlacedPosition warping (ClampedCut AngleThresholds cut)) t t'.
Proof.
  intros warping C. apply RuledMeshEmbeds; [exact C|].
  apply QuarterUncrossed, C.
Qed.
