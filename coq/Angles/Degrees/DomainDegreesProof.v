(** * Bounds in degrees for the product's own cuts, and how sharp they are *)

From Coq Require Import ZArith Reals List Bool Lra Lia.
From Certet Require Import Lattice.Definitions Stencil.Definitions
  Warp.Definitions Stuffing.Definitions Angles.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.Forms.CheckerProof
  Angles.AngleTheorems Angles.Degrees.DegreesProof Angles.Degrees.Witnesses
  Angles.Degrees.SharpnessProof Angles.DomainProof.
Open Scope R_scope.

Theorem BisectedBoundsInDegrees sign domain tid t :
  In t (StuffedTets AngleThresholds sign (BisectedCuts domain) tid) ->
  WithinDegrees (1077 / 100) (16476 / 100) t.
Proof. exact (DihedralBoundsInDegrees _ _ tid t (BisectedOnEdges _ _)). Qed.

Theorem BisectedBoundsEmbeddingInDegrees sign domain tid t :
  In t (StuffedTets EmbeddingThresholds sign (BisectedCuts domain) tid) ->
  WithinDegrees (927 / 100) (16146 / 100) t.
Proof. exact (DihedralBoundsEmbeddingInDegrees _ _ tid t (BisectedOnEdges _ _)). Qed.

(** ** Exhibits *)

Section Exhibited.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Variables (bounds : AngleBounds) (n d : Z) (degrees : R).
  Hypothesis Shaped : forall t,
    In t (StuffedTets th sign cut WitnessTet) -> WellShaped bounds t.
  Hypothesis Over : CotangentOver (CotSq n d) degrees.

  Lemma ExhibitsLeast : Exhibits th sign cut (Sharper (CotSq n d)) = true ->
    exists t p q r s, In t (StuffedTets th sign cut WitnessTet) /\
      In (p, q, r, s) (DihedralEdges t) /\ DihedralDegrees p q r s <= degrees.
  Proof.
    intros E. apply ExhibitsMeans in E as (t & p & q & r & s & I & J & T).
    exists t, p, q, r, s. repeat (split; [assumption|]).
    apply (SharperDegrees _ _ _ _ _ _ _ Over); [|exact T].
    exact (EdgeVolume _ t _ _ _ _ (Shaped t I) J).
  Qed.

  Lemma ExhibitsGreatest : Exhibits th sign cut (Blunter (CotSq n d)) = true ->
    exists t p q r s, In t (StuffedTets th sign cut WitnessTet) /\
      In (p, q, r, s) (DihedralEdges t) /\ 180 - degrees <= DihedralDegrees p q r s.
  Proof.
    intros E. apply ExhibitsMeans in E as (t & p & q & r & s & I & J & T).
    exists t, p, q, r, s. repeat (split; [assumption|]).
    apply (BlunterDegrees _ _ _ _ _ _ _ Over); [|exact T].
    exact (EdgeVolume _ t _ _ _ _ (Shaped t I) J).
  Qed.
End Exhibited.

(** ** Bisected domains *)

Theorem BisectedBoundsAreSharp :
  (exists domain tid t p q r s,
     In t (StuffedTets AngleThresholds (SampledSigns domain) (BisectedCuts domain) tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     DihedralDegrees p q r s <= 1079 / 100) /\
  (exists domain tid t p q r s,
     In t (StuffedTets AngleThresholds (SampledSigns domain) (BisectedCuts domain) tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     16474 / 100 <= DihedralDegrees p q r s) /\
  (exists domain tid t p q r s,
     In t (StuffedTets EmbeddingThresholds (SampledSigns domain) (BisectedCuts domain) tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     DihedralDegrees p q r s <= 929 / 100) /\
  (exists domain tid t p q r s,
     In t (StuffedTets EmbeddingThresholds (SampledSigns domain) (BisectedCuts domain) tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     16144 / 100 <= DihedralDegrees p q r s).
Proof.
  repeat split.
  - exists (SmallAngleDomain 26111 46848 26112), WitnessTet.
    apply (ExhibitsLeast _ _ _ WidestAngles 27572 1000);
      [exact (BisectedBounds _ _ _) | | vm_compute; reflexivity].
    by_fraction (98233274 / 100000000).
  - exists LargeAngleDomain_73_102, WitnessTet.
    replace (16474 / 100) with (180 - 1526 / 100) by lra.
    apply (ExhibitsGreatest _ _ _ WidestAngles 13442 1000);
      [exact (BisectedBounds _ _ _) | | vm_compute; reflexivity].
    by_fraction (96475061 / 100000000).
  - exists (SmallAngleDomain 26879 49152 26880), WitnessTet.
    apply (ExhibitsLeast _ _ _ EmbeddingAngles 37442 1000);
      [exact (BisectedBoundsEmbedding _ _ _) | | vm_compute; reflexivity].
    by_fraction (98689618 / 100000000).
  - exists LargeAngleDomain_64_105, WitnessTet.
    replace (16144 / 100) with (180 - 1856 / 100) by lra.
    apply (ExhibitsGreatest _ _ _ EmbeddingAngles 8877 1000);
      [exact (BisectedBoundsEmbedding _ _ _) | | vm_compute; reflexivity].
    by_fraction (94801031 / 100000000).
Qed.

(** ** Cuts in the middle: exactly 30 and 135 degrees *)

Lemma CotangentOver30 : CotangentOver (CotSq 3 1) 30.
Proof.
  unfold CotangentOver. rewrite CosineSquared30. change (3 + 1)%Z with 4%Z.
  repeat split; lra || lia.
Qed.

Lemma CotangentOver45 : CotangentOver (CotSq 1 1) 45.
Proof.
  unfold CotangentOver. rewrite CosineSquared45. change (1 + 1)%Z with 2%Z.
  repeat split; lra || lia.
Qed.

(** As integers tell it: no axiom is needed. *)
Theorem MidpointBoundsAttained :
  (exists sign tid t p q r s,
     In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     (0 < NormalsProduct p q r s /\
      NormalsProduct p q r s ^ 2 = 3 * (SixVolume p q r s ^ 2 * EdgeSquared p q))%Z) /\
  (exists sign tid t p q r s,
     In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) /\
     In (p, q, r, s) (DihedralEdges t) /\
     (NormalsProduct p q r s < 0 /\
      NormalsProduct p q r s ^ 2 = SixVolume p q r s ^ 2 * EdgeSquared p q)%Z).
Proof.
  split.
  - destruct (ExhibitsMeans NoWarpThresholds (Decided MidpointSigns) MidpointCuts
      (fun '(p, q, r, s) => (0 <? NormalsProduct p q r s)%Z &&
        (NormalsProduct p q r s ^ 2
           =? 3 * (SixVolume p q r s ^ 2 * EdgeSquared p q))%Z)
      ltac:(vm_compute; reflexivity)) as (t & p & q & r & s & I & J & T).
    exists MidpointSigns, WitnessTet, t, p, q, r, s. repeat (split; [assumption|]).
    apply andb_prop in T. rewrite Z.ltb_lt, Z.eqb_eq in T. exact T.
  - destruct (ExhibitsMeans NoWarpThresholds (Decided MidpointSigns) MidpointCuts
      (fun '(p, q, r, s) => (NormalsProduct p q r s <? 0)%Z &&
        (NormalsProduct p q r s ^ 2 =? SixVolume p q r s ^ 2 * EdgeSquared p q)%Z)
      ltac:(vm_compute; reflexivity)) as (t & p & q & r & s & I & J & T).
    exists MidpointSigns, WitnessTet, t, p, q, r, s. repeat (split; [assumption|]).
    apply andb_prop in T. rewrite Z.ltb_lt, Z.eqb_eq in T. exact T.
Qed.

Lemma MidpointAngle sign t p q r s :
  In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts WitnessTet) ->
  In (p, q, r, s) (DihedralEdges t) -> 30 <= DihedralDegrees p q r s <= 135.
Proof.
  intros I J. pose proof (MidpointBoundsInDegrees sign WitnessTet t I) as W.
  destruct t as [a b c d]. apply W, J.
Qed.

Theorem MidpointBoundsAreSharp :
  (exists sign tid t p q r s,
     In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) /\
     In (p, q, r, s) (DihedralEdges t) /\ DihedralDegrees p q r s = 30) /\
  (exists sign tid t p q r s,
     In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) /\
     In (p, q, r, s) (DihedralEdges t) /\ DihedralDegrees p q r s = 135).
Proof.
  split.
  - destruct (ExhibitsLeast NoWarpThresholds (Decided MidpointSigns) MidpointCuts
      MidpointAngles 3 1 30 (MidpointBounds _ _) CotangentOver30
      ltac:(vm_compute; reflexivity)) as (t & p & q & r & s & I & J & L).
    exists MidpointSigns, WitnessTet, t, p, q, r, s. repeat (split; [assumption|]).
    apply Rle_antisym; [exact L | exact (proj1 (MidpointAngle _ _ _ _ _ _ I J))].
  - destruct (ExhibitsGreatest NoWarpThresholds (Decided MidpointSigns) MidpointCuts
      MidpointAngles 1 1 45 (MidpointBounds _ _) CotangentOver45
      ltac:(vm_compute; reflexivity)) as (t & p & q & r & s & I & J & L).
    exists MidpointSigns, WitnessTet, t, p, q, r, s. repeat (split; [assumption|]).
    apply Rle_antisym; [exact (proj2 (MidpointAngle _ _ _ _ _ _ I J)) | lra].
Qed.
