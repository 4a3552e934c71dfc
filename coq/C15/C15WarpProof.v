(** * What warping leaves behind in C15 is admissible: proof *)

From Certet Require Import Key.Definitions.
From Certet Require Import C15.Sites C15.C15Tet C15.C15Spec C15.C15TilingProof
  C15.C15Stuffing C15.C15MeshProof C15.C15AnglesSpec C15.C15WarpSpec.
Open Scope Z_scope.

Section Warp.
  Variables (th : C15Thresholds) (sign : SignField) (cut : CutField).

  Lemma NearestOf v l : forall best,
    match fold_left (C15NearerOf th sign cut v) l best with
    | Unmoved => best = Unmoved /\ forall o, In o l -> C15Violates th sign cut v o = false
    | Moved o t =>
        best = Moved o t \/
        In o l /\ t = C15CutFrom sign cut v o /\ C15Violates th sign cut v o = true
    end.
  Proof.
    induction l as [|e l IH]; intros best; cbn [fold_left].
    - destruct best; [split; [reflexivity|intros o []]|left; reflexivity].
    - specialize (IH (C15NearerOf th sign cut v best e)). revert IH.
      destruct (fold_left _ l _) as [|o t]; unfold C15NearerOf;
        destruct (C15Violates th sign cut v e) eqn:V.
      + intros [B _]. destruct best as [|b s]; [discriminate B|].
        destruct (_ <? _) in B; discriminate B.
      + intros [B none]. split; [exact B|]. intros o [<-|I]; [exact V|exact (none o I)].
      + intros [B|(I & T)]; [|right; split; [right; exact I|exact T]].
        assert (New : Moved e (C15CutFrom sign cut v e) = Moved o t ->
          In o (e :: l) /\ t = C15CutFrom sign cut v o /\ C15Violates th sign cut v o = true).
        { intros E. injection E as <- <-. split; [left; reflexivity|]. auto. }
        destruct best as [|b s]; [right; apply New, B|].
        destruct (_ <? _) in B; [right; apply New, B|left; exact B].
      + intros [B|(I & T)]; [left; exact B|right; split; [right; exact I|exact T]].
  Qed.

  Lemma WarpMoves v o t : C15WarpVertex th sign cut v = Moved o t ->
    In o (OffsetsAround v) /\ t = C15CutFrom sign cut v o /\
    Opposite (sign v) (sign (Translate v o)) = true /\
    t < EdgeThreshold th v (Translate v o).
  Proof.
    intros E. pose proof (NearestOf v (OffsetsAround v) Unmoved) as N.
    unfold C15WarpVertex in E. rewrite E in N.
    destruct N as [N|(I & T & V)]; [discriminate N|].
    unfold C15Violates in V. cbv zeta in V. apply andb_prop in V.
    destruct V as [O L]. apply Z.ltb_lt in L. subst t. auto.
  Qed.

  Lemma WarpStays v o : C15WarpVertex th sign cut v = Unmoved -> In o (OffsetsAround v) ->
    Opposite (sign v) (sign (Translate v o)) = true ->
    EdgeThreshold th v (Translate v o) <= C15CutFrom sign cut v o.
  Proof.
    intros E I O. pose proof (NearestOf v (OffsetsAround v) Unmoved) as N.
    unfold C15WarpVertex in E. rewrite E in N. destruct N as [_ N]. specialize (N o I).
    unfold C15Violates in N. cbv zeta in N. rewrite O in N. apply Z.ltb_ge in N. exact N.
  Qed.

  Hypothesis Hhalf : C15AtMostHalf th.
  Hypothesis Hcut : CutsOnEdges sign cut.

  Lemma ThresholdsWithin a b : EdgeThreshold th a b + EdgeThreshold th b a <= Steps.
  Proof.
    unfold EdgeThreshold. change (Steps / 256) with 256. change Steps with 65536.
    specialize (Hhalf (MetalOf a) (MetalOf b)). lia.
  Qed.

  Lemma FromWithin v o : Opposite (sign v) (sign (Translate v o)) = true ->
    0 <= C15CutFrom sign cut v o <= Steps.
  Proof.
    unfold C15CutFrom. cbv zeta. intros O.
    destruct (sign v) eqn:E, (sign (Translate v o)) eqn:F; try discriminate O.
    - apply Hcut; assumption.
    - pose proof (Hcut _ _ F E). lia.
  Qed.

  (** The cut of an edge from both ends. *)
  Lemma FromBothEnds v o e : Translate (Translate v o) e = v ->
    Opposite (sign v) (sign (Translate v o)) = true ->
    C15CutFrom sign cut (Translate v o) e = Steps - C15CutFrom sign cut v o.
  Proof.
    unfold C15CutFrom. cbv zeta. intros -> O.
    destruct (sign v), (sign (Translate v o)); try discriminate O; lia.
  Qed.

  Lemma ThereFrom (a b : Coord3) : Translate a (Difference a b) = b.
  Proof. destruct a, b. cbn [Translate Difference]. f_equal; ring. Qed.

  Lemma OppositeBack a b : Opposite a b = Opposite b a.
  Proof. destruct a, b; reflexivity. Qed.

  Theorem C15WarpIsAdmissible tid :
    C15Admissible sign (C15WarpVertex th sign cut) cut th (C15Corners tid).
  Proof.
    split.
    - intros v o t _ E. destruct (WarpMoves v o t E) as (I & -> & O & L). cbv zeta.
      pose proof (FromWithin v o O). split; [exact I|]. split; [lia|]. intros _.
      split; [exact O|]. intros e s F B.
      destruct (WarpMoves _ _ _ F) as (_ & -> & _ & L').
      rewrite (FromBothEnds v o e B O), B in L'.
      pose proof (ThresholdsWithin v (Translate v o)). lia.
    - intros v u A B. unfold C15After.
      destruct (C15WarpVertex th sign cut v) eqn:Ev; [|discriminate].
      destruct (C15WarpVertex th sign cut u) eqn:Eu; [|discriminate].
      intros Sv Su.
      assert (N : v <> u) by congruence.
      apply InC15Corners in A, B. destruct A as (i & A), B as (j & B).
      assert (I : In (Difference v u) (OffsetsAround v))
        by (rewrite A, B; apply C15VerticesJoined; congruence).
      assert (J : In (Difference u v) (OffsetsAround u))
        by (rewrite A, B; apply C15VerticesJoined; congruence).
      assert (O : Opposite (sign v) (sign u) = true) by (rewrite Sv, Su; reflexivity).
      pose proof (WarpStays v _ Ev I) as L. rewrite ThereFrom in L. specialize (L O).
      pose proof (WarpStays u _ Eu J) as L'. rewrite ThereFrom, OppositeBack in L'.
      specialize (L' O).
      unfold C15CutFrom in L, L'. rewrite ThereFrom, Sv in L. rewrite ThereFrom, Su in L'.
      lia.
  Qed.
End Warp.
