(** * The mesh of the strict disk has the pieces of the samples: proof *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Embedding.GreedyProof Embedding.LeavingProof
  Embedding.LinkProof Embedding.DiskRuleProof Embedding.PiecesProof
  Embedding.RuledMeshProof.

(** Checking a proof needs its name, never what it is. *)
Local Strategy 1000 [WarpVertex].

(** ** The product's order *)

Lemma ColoursDiffer v d : Colour v <> Colour (Translate v (Offset d)).
Proof.
  destruct v as [x y z], d; cbn [Offset Translate Colour].
  all: repeat match goal with |- context [Z.even ?n] =>
    pose proof (Zmod_even n); destruct (Z.even n) end; try discriminate.
  all: intros _; Z.div_mod_to_equations; lia.
Qed.

Lemma TurnsDiffer th sign cut v d :
  Violated th sign cut v = true ->
  Violated th sign cut (Translate v (Offset d)) = true ->
  Turn th sign cut v <> Turn th sign cut (Translate v (Offset d)).
Proof.
  unfold Violated, Turn. set (u := Translate v (Offset d)).
  destruct (WarpVertex th sign cut v) as [|e t]; [discriminate|].
  destruct (WarpVertex th sign cut u) as [|e' t']; [discriminate|]. intros _ _ E.
  apply (ColoursDiffer v d). fold u.
  assert (B : forall w, (Colour w < 4)%nat)
    by (intros [x y z]; cbn [Colour]; destruct (Z.even x), (Z.even _); cbn; lia).
  pose proof (B v). pose proof (B u). clear B.
  generalize dependent (Z.to_nat (4 * t / ThresholdSteps th (DirectionKind e))).
  generalize dependent (Z.to_nat (4 * t' / ThresholdSteps th (DirectionKind e'))).
  destruct (sign v), (sign u); intros; lia.
Qed.

Theorem DiskMakesNoWall th sign cut limit : (forall v, sign v <> OnSurface) ->
  NoWall sign (RuledWarping th sign cut (DiskRule th sign cut) limit).
Proof. intros D. apply DiskNoWall; [exact D|exact (TurnsDiffer th sign cut)]. Qed.

(** The pieces of the mesh by faces are the pieces of the samples by edges, *)
Theorem DiskPiecesKept th sign cut limit all p q t u :
  let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
  (forall v, sign v <> OnSurface) -> (forall v, sign v = Plus -> In v all) ->
  PlusAfter sign warping p -> PlusAfter sign warping q ->
  MadeAt sign warping p t -> MadeAt sign warping q u ->
  Joined (InMesh sign warping) ShareFace t u <->
  Joined (PlusBefore sign) Adjacent p q.
Proof.
  intros warping D B. apply PiecesKept.
  - apply (DiskAllLeave th sign cut _ (TurnsDiffer th sign cut) all B).
  - apply DiskMakesNoWall, D.
Qed.

(** none is lost, *)
Theorem DiskNoPieceLost th sign cut limit all p :
  let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
  (forall v, sign v = Plus -> In v all) ->
  PlusBefore sign p -> (exists tid, InLattice tid /\ In p (Corners tid)) ->
  exists q t, PlusAfter sign warping q /\ MadeAt sign warping q t /\
    Joined (PlusBefore sign) Adjacent p q.
Proof.
  intros warping B. apply NoPieceLost.
  apply (DiskAllLeave th sign cut _ (TurnsDiffer th sign cut) all B).
Qed.

(** and the same holds of the outside. *)
Theorem DiskOutsideKept th sign cut limit all p q :
  let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
  (forall v, sign v = Plus -> In v all) ->
  ~ PlusBefore sign p -> ~ PlusBefore sign q ->
  Joined (fun v => ~ PlusAfter sign warping v) Adjacent p q <->
  Joined (fun v => ~ PlusBefore sign v) Adjacent p q.
Proof.
  intros warping B P Q.
  refine (KeepsPieces _ _ SamePoint3 AdjacentMutual _ _ _ p q P Q).
  apply (DiskOutsideLeave th sign cut _ (TurnsDiffer th sign cut) all B).
Qed.

Theorem DiskMakesNoCavity th sign cut limit all p :
  let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
  (forall v, sign v = Plus -> In v all) -> ~ PlusAfter sign warping p ->
  exists q, ~ PlusBefore sign q /\
    Joined (fun v => ~ PlusAfter sign warping v) Adjacent p q.
Proof.
  intros warping B P.
  refine (LosesNoPiece _ _ SamePoint3 AdjacentMutual _ _ _ p P).
  apply (DiskOutsideLeave th sign cut _ (TurnsDiffer th sign cut) all B).
Qed.

(** ** All at once *)

Theorem OneMeshHasItAll sign cut all :
  CutsOnEdges sign cut -> (forall v, sign v <> OnSurface) ->
  (forall v, sign v = Plus -> In v all) ->
  let th := AngleThresholds in
  let stays := DiskRule th sign cut in
  let limit := StopIfCrossed th sign cut Quarter in
  let warping := RuledWarping th sign cut stays limit in
  let place := PlacedPosition warping (ClampedCut th cut) in
  (forall tid t, In t (WarpOrClamp th sign cut stays limit tid) ->
     WellShaped WidestAngles t) /\
  NoneOverlap sign warping place /\ SamePieces sign warping.
Proof.
  intros C D B th stays limit warping place. split; [|split].
  - intros tid t. apply RuledBounds, C.
  - intros tid tid' t t'. apply RuledInteriorsApart; [exact C|].
    apply AtQuarterUncrossedOrLevel, C.
  - intros p q t u. exact (DiskPiecesKept th sign cut limit all p q t u D B).
Qed.
