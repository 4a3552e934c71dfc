(** * [Warp] keeps its promise: proof *)

From Coq Require Import ZArith List Bool Lia.
From Certet Require Import Lattice.Direction Stencil.UnstructuredTet.
From Certet Require Import Warp.Warp Warp.WarpSpec.
Import ListNotations.
Open Scope Z_scope.

Section Proof.
  Variables (th : Thresholds) (sign : Sign) (neighbor_sign : Direction -> Sign).
  Variable cut : Direction -> Z.
  Let violates := Violates th sign neighbor_sign cut.

  (** [best] is right for the directions [seen]. *)
  Let Best (seen : list Direction) (best : Warping) : Prop :=
    match best with
    | Stays => forall d, In d seen -> violates d = false
    | Moves d t =>
        t = cut d /\ violates d = true /\
        forall e, In e seen -> violates e = true ->
          CutDistanceSquared cut d <= CutDistanceSquared cut e
    end.

  Lemma BestStep seen best d : Best seen best ->
    Best (seen ++ [d]) (NearerOf th sign neighbor_sign cut best d).
  Proof.
    intros B. unfold NearerOf. fold violates. fold (violates d).
    assert (I : forall e, In e (seen ++ [d]) -> In e seen \/ e = d).
    { intros e J. apply in_app_or in J. destruct J as [J|[->|[]]]; auto. }
    destruct (violates d) eqn:V.
    - destruct best as [|b t]; [|destruct (Z.ltb_spec (CutDistanceSquared cut d)
                                            (CutDistanceSquared cut b)) as [L|L]].
      + repeat (split; [reflexivity || assumption|]). intros e J W.
        destruct (I e J) as [K| ->]; [|lia]. rewrite (B e K) in W. discriminate W.
      + repeat (split; [reflexivity || assumption|]). intros e J W.
        destruct B as (_ & _ & B).
        destruct (I e J) as [K| ->]; [specialize (B e K W)|]; lia.
      + destruct B as (Bt & Bv & B).
        repeat (split; [assumption|]). intros e J W.
        destruct (I e J) as [K| ->]; [exact (B e K W)|lia].
    - destruct best as [|b t].
      + intros e J. destruct (I e J) as [K| ->]; [exact (B e K)|exact V].
      + destruct B as (Bt & Bv & B). repeat (split; [assumption|]).
        intros e J W. destruct (I e J) as [K| ->]; [exact (B e K W)|].
        rewrite V in W. discriminate W.
  Qed.

  Lemma BestFold ds : forall seen best, Best seen best ->
    Best (seen ++ ds)
      (fold_left (NearerOf th sign neighbor_sign cut) ds best).
  Proof.
    induction ds as [|d ds IH]; intros seen best B; cbn [fold_left].
    - rewrite app_nil_r. exact B.
    - replace (seen ++ d :: ds) with ((seen ++ [d]) ++ ds)
        by (rewrite <- app_assoc; reflexivity).
      apply IH, BestStep, B.
  Qed.

  Theorem WarpIsCorrect : WarpCorrect th sign neighbor_sign cut.
  Proof.
    pose proof (BestFold AllDirections [] Stays (fun d H => match H with end)) as B.
    assert (I : forall d, In d AllDirections) by (intros []; cbn; tauto).
    unfold WarpCorrect, Warp. cbn [app] in B. unfold Best in B.
    destruct (fold_left _ _ _) as [|d t].
    - intros d. apply B, I.
    - destruct B as (Bt & Bv & B). repeat (split; [assumption|]).
      intros e. apply B, I.
  Qed.
End Proof.
