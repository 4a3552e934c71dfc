(** * Any subset stays: proof *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Stencil.SymbolProof Angles.Cases.AdmissibleProof
  Embedding.EdgeRank.
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

  Lemma RuledIsAdmissible corners : Admissible sign warping clamped th corners.
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

Theorem AnySubsetStays th sign cut stays limit tid :
  AtMostHalf th -> CutsOnEdges sign cut ->
  Admissible sign (RuledWarping th sign cut stays limit)
    (ClampedCut th cut) th (Corners tid).
Proof. intros H C. apply RuledIsAdmissible; assumption. Qed.

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
  AtMostHalf th -> CutsOnEdges sign cut -> InLattice tid ->
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
