(** * What [Warp] leaves behind is admissible: proof *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.DirectionProof Warp.WarpProof.
Open Scope Z_scope.

Lemma OppositeDirection v d e :
  Translate (Translate v (Offset d)) (Offset e) = v ->
  DirectionKind e = DirectionKind d.
Proof.
  intros E.
  assert (Z0 : Translate (Offset d) (Offset e) = C3 0 0 0).
  { destruct v as [x y z], (Offset d), (Offset e).
    cbn [Translate] in *. injection E as E1 E2 E3. f_equal; lia. }
  clear E. destruct d, e; try reflexivity; discriminate Z0.
Qed.

(** Checking a proof needs [Warp]'s name, never its steps. *)
Local Strategy 1000 [Warp].

Section Warped.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Hypothesis Hhalf : AtMostHalf th.
  Hypothesis Hcut : CutsOnEdges sign cut.

  Local Notation neighbor_sign v d := (sign (Translate v (Offset d))).

  Lemma VertexWarpCorrect v :
    match WarpVertex th sign cut v with
    | Stays => forall d,
        Violates th (sign v) (fun d => neighbor_sign v d) (CutFrom sign cut v) d
        = false
    | Moves d t =>
        t = CutFrom sign cut v d /\
        Violates th (sign v) (fun d => neighbor_sign v d) (CutFrom sign cut v) d
        = true
    end.
  Proof.
    pose proof (WarpIsCorrect th (sign v) (fun d => neighbor_sign v d)
                  (CutFrom sign cut v)) as C.
    unfold WarpVertex.
    destruct (Warp _ _ _ _); [exact C|].
    destruct C as (T & V & _). split; assumption.
  Qed.

  Lemma WarpedMeans v d t : WarpVertex th sign cut v = Moves d t ->
    t = CutFrom sign cut v d /\
    Opposite (sign v) (neighbor_sign v d) = true /\
    t < ThresholdSteps th (DirectionKind d).
  Proof.
    intros E. pose proof (VertexWarpCorrect v) as C. rewrite E in C.
    destruct C as [-> V]. unfold Violates in V.
    apply andb_prop in V. destruct V as [O L]. apply Z.ltb_lt in L. auto.
  Qed.

  Lemma KeptMeans v d : WarpVertex th sign cut v = Stays ->
    Opposite (sign v) (neighbor_sign v d) = true ->
    ThresholdSteps th (DirectionKind d) <= CutFrom sign cut v d.
  Proof.
    intros E O. pose proof (VertexWarpCorrect v) as C. rewrite E in C.
    specialize (C d).
    unfold Violates in C. rewrite O in C. apply Z.ltb_ge in C. exact C.
  Qed.

  Lemma CutFromInRange v d : Opposite (sign v) (neighbor_sign v d) = true ->
    0 <= CutFrom sign cut v d <= Steps.
  Proof.
    unfold CutFrom. intros O.
    destruct (sign v) eqn:E, (sign (Translate v (Offset d))) eqn:F;
      try discriminate O.
    - apply Hcut; assumption.
    - pose proof (Hcut _ _ F E). lia.
  Qed.

  (** The cut of an edge as seen from its two ends. *)
  Lemma CutFromBothEnds v d e :
    Translate (Translate v (Offset d)) (Offset e) = v ->
    Opposite (sign v) (neighbor_sign v d) = true ->
    CutFrom sign cut (Translate v (Offset d)) e
    = Steps - CutFrom sign cut v d.
  Proof.
    unfold CutFrom. intros E O. cbv zeta. rewrite E.
    destruct (sign v), (sign (Translate v (Offset d))); try discriminate O; lia.
  Qed.

  Theorem WarpLeavesAdmissible (corners : list Coord3) :
    Admissible sign (WarpVertex th sign cut) cut th corners.
  Proof.
    split.
    - intros v d t _ E.
      destruct (WarpedMeans v d t E) as (-> & O & L).
      pose proof (CutFromInRange v d O) as R.
      split; [lia|]. intros _. split; [exact O|].
      intros e s F B.
      destruct (WarpedMeans _ _ _ F) as (-> & _ & L').
      rewrite (CutFromBothEnds v d e B O) in L'.
      rewrite (OppositeDirection v d e B) in L'.
      specialize (Hhalf (DirectionKind d)). lia.
    - intros v d _ _. cbn [PlacedSign]. set (u := Translate v (Offset d)).
      destruct (WarpVertex th sign cut v) eqn:Ev; [|discriminate].
      destruct (WarpVertex th sign cut u) eqn:Eu; [|discriminate].
      cbn [WarpedSign]. intros Sv Su.
      assert (exists e, Translate u (Offset e) = v) as (e & B)
        by (exists (Backward d); apply ThereAndBack).
      assert (O : Opposite (sign v) (neighbor_sign v d) = true)
        by (fold u; rewrite Sv, Su; reflexivity).
      pose proof (KeptMeans v d Ev O) as L.
      assert (O' : Opposite (sign u) (neighbor_sign u e) = true)
        by (rewrite B, Sv, Su; reflexivity).
      pose proof (KeptMeans u e Eu O') as L'.
      unfold u in L' at 1. rewrite (CutFromBothEnds v d e B O) in L'.
      rewrite (OppositeDirection v d e B) in L'.
      unfold CutFrom in L, L'. rewrite Sv in L, L'. fold u in L, L'. lia.
  Qed.

  (** The product's tetrahedra are those of its placement. *)
  Lemma StuffedArePlaced tid :
    StuffedTets th sign cut tid
    = PlacedTets sign (WarpVertex th sign cut) cut tid.
  Proof.
    unfold StuffedTets, StuffTet, PlacedTets. destruct tid as [anchor case].
    destruct (GetStructuredTet (STId anchor case)). reflexivity.
  Qed.
End Warped.
