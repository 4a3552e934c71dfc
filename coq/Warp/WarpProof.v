(** * [Warp] keeps its promise: proof *)

From Certet Require Import Warp.Definitions.
Open Scope Z_scope.

Lemma DirectionListed d : In d AllDirections.
Proof. destruct d; cbn; tauto. Qed.

Section Proof.
  Variables (th : Thresholds) (sign : Sign) (neighbor_sign : Direction -> Sign).
  Variable cut : Direction -> Z.
  Let violates := Violates th sign neighbor_sign cut.

  (** [best] is right for the directions [seen]. *)
  Let Best (seen : list Direction) (best : Warping) : Prop :=
    match best with
    | Stays => forall d, In d seen -> violates d = false
    | Moves d t => t = cut d /\ violates d = true /\ FirstNearest violates cut seen d
    end.

  Lemma BestStep seen best d : Best seen best ->
    Best (seen ++ [d]) (NearerOf th sign neighbor_sign cut best d).
  Proof.
    intros B. unfold NearerOf. fold violates. fold (violates d).
    destruct best as [|b t]; destruct (violates d) eqn:V.
    - repeat (split; [reflexivity || assumption|]).
      exists seen, []. repeat split.
      + intros e J W. rewrite (B e J) in W. discriminate W.
      + intros e [].
    - intros e J. apply in_app_or in J.
      destruct J as [J | [<- | []]]; [exact (B e J) | exact V].
    - destruct B as (Bt & Bv & earlier & later & -> & Near & Far).
      assert (All : forall e, In e (earlier ++ b :: later) -> violates e = true ->
                CutDistanceSquared cut b <= CutDistanceSquared cut e).
      { intros e J W. apply in_app_or in J.
        destruct J as [J | [<- | J]]; [| lia | exact (Far e J W)].
        apply Z.lt_le_incl, Near; assumption. }
      destruct (Z.ltb_spec (CutDistanceSquared cut d) (CutDistanceSquared cut b))
        as [L|L]; repeat (split; [reflexivity || assumption|]).
      + exists (earlier ++ b :: later), []. repeat split.
        * intros e J W. specialize (All e J W). lia.
        * intros e [].
      + exists earlier, (later ++ [d]). repeat split.
        * rewrite <- app_assoc. reflexivity.
        * exact Near.
        * intros e J W. apply in_app_or in J.
          destruct J as [J | [<- | []]]; [exact (Far e J W) | exact L].
    - destruct B as (Bt & Bv & earlier & later & -> & Near & Far).
      repeat (split; [assumption|]). exists earlier, (later ++ [d]). repeat split.
      + rewrite <- app_assoc. reflexivity.
      + exact Near.
      + intros e J W. apply in_app_or in J.
        destruct J as [J | [<- | []]]; [exact (Far e J W)|].
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
End Proof.

(** Spelled out like the headline: to unfold a name would make Coq look into
    [Warp], which takes it half a minute. *)
Theorem WarpNearest th sign neighbor_sign cut :
  match Warp th sign neighbor_sign cut with
  | Stays => forall d, Violates th sign neighbor_sign cut d = false
  | Moves d t =>
      t = cut d /\ Violates th sign neighbor_sign cut d = true /\
      FirstNearest (Violates th sign neighbor_sign cut) cut AllDirections d
  end.
Proof.
  pose proof (BestFold th sign neighbor_sign cut AllDirections [] Stays
                (fun d H => match H with end)) as B.
  unfold Warp. cbn [app] in B. destruct (fold_left _ _ _) as [|d t].
  - intros d. apply B, DirectionListed.
  - exact B.
Qed.

Theorem WarpIsCorrect th sign neighbor_sign cut :
  match Warp th sign neighbor_sign cut with
  | Stays => forall d, Violates th sign neighbor_sign cut d = false
  | Moves d t =>
      t = cut d /\ Violates th sign neighbor_sign cut d = true /\
      forall e, Violates th sign neighbor_sign cut e = true ->
        CutDistanceSquared cut d <= CutDistanceSquared cut e
  end.
Proof.
  pose proof (WarpNearest th sign neighbor_sign cut) as N.
  destruct (Warp _ _ _ _) as [|d t]; [exact N|].
  destruct N as (T & V & earlier & later & S & Near & Far).
  repeat (split; [assumption|]). intros e W.
  pose proof (DirectionListed e) as J. rewrite S in J. apply in_app_or in J.
  destruct J as [J | [<- | J]]; [| lia | exact (Far e J W)].
  apply Z.lt_le_incl, Near; assumption.
Qed.

(** ** The rule leaves no choice *)

(** In a list without repetition not each of two elements follows the other. *)
Lemma NoneFirst {A} (d e : A) : forall l l1 r1 l2 r2, NoDup l ->
  l = l1 ++ d :: r1 -> l = l2 ++ e :: r2 -> In e r1 -> In d r2 -> False.
Proof.
  induction l as [|a l IH]; intros [|b l1] r1 [|c l2] r2 once E F I J;
    cbn [app] in E, F; try discriminate E; try discriminate F;
    injection E as -> E; injection F as F1 F; apply NoDup_cons_iff in once as [N D].
  - subst. apply N. exact I.
  - subst. apply N, in_or_app. right. right. exact J.
  - subst. apply N, in_or_app. right. right. exact I.
  - exact (IH l1 r1 l2 r2 D E F I J).
Qed.

Theorem FirstNearestUnique : forall violates cut d e,
  violates d = true -> violates e = true ->
  FirstNearest violates cut AllDirections d ->
  FirstNearest violates cut AllDirections e -> d = e.
Proof.
  intros violates cut d e Vd Ve (l1 & r1 & E & Near & Far) (l2 & r2 & F & Near' & Far').
  assert (once : NoDup AllDirections)
    by (repeat constructor; cbn; intuition discriminate).
  pose proof (DirectionListed e) as I. pose proof (DirectionListed d) as J.
  rewrite E in I. rewrite F in J. apply in_app_or in I, J.
  destruct I as [I | [I | I]]; [| exact I |];
    (destruct J as [J | [J | J]]; [| symmetry; exact J |]); exfalso.
  - specialize (Near e I Ve). specialize (Near' d J Vd). lia.
  - specialize (Near e I Ve). specialize (Far' d J Vd). lia.
  - specialize (Far e I Ve). specialize (Near' d J Vd). lia.
  - exact (NoneFirst d e _ _ _ _ _ once E F I J).
Qed.
