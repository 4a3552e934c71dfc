(** * Bounds in degrees for the product's own cuts, and how sharp they are *)

From Coq Require Import Reals Lra.
From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.AngleTheorems
  Angles.Degrees.DegreesProof Angles.Degrees.Witnesses
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

(** ** Bisected domains *)

(** Some domain has such an angle. *)
Definition BisectedReaches (th : Thresholds) (P : R -> Prop) : Prop :=
  exists domain tid,
    HasAngle P (StuffedTets th (SampledSigns domain) (BisectedCuts domain) tid).

Theorem BisectedBoundsAreSharp : Sharply BisectedReaches.
Proof.
  apply SharplyBy.
  - exists (SmallAngleDomain 26111 46848 26112), WitnessTet.
    exhibit ExhibitsLeast WidestAngles 27572%Z BisectedBounds 98233274.
  - exists LargeAngleDomain_73_102, WitnessTet.
    exhibit ExhibitsGreatest WidestAngles 13442%Z BisectedBounds 96475061.
  - exists (SmallAngleDomain 26879 49152 26880), WitnessTet.
    exhibit ExhibitsLeast EmbeddingAngles 37442%Z BisectedBoundsEmbedding 98689618.
  - exists LargeAngleDomain_64_105, WitnessTet.
    exhibit ExhibitsGreatest EmbeddingAngles 8877%Z BisectedBoundsEmbedding 94801031.
Qed.

(** ** Cuts in the middle: exactly 30 and 135 degrees *)

Lemma CotangentOverExactly n d degrees :
  CotangentIs n d degrees -> CotangentOver (CotSq n d) degrees.
Proof. intros (B & N & D & E). repeat (split; [assumption|]). lra. Qed.

Lemma MidpointExhibits test (P : Coord3 -> Coord3 -> Coord3 -> Coord3 -> Prop) :
  (forall p q r s, test (p, q, r, s) = true -> P p q r s) ->
  Exhibits NoWarpThresholds (Decided MidpointSigns) MidpointCuts test = true ->
  exists sign tid t p q r s,
    In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) /\
    In (p, q, r, s) (DihedralEdges t) /\ P p q r s.
Proof.
  intros T E. destruct (ExhibitsMeans _ _ _ _ E) as (t & p & q & r & s & I & J & H).
  exists MidpointSigns, WitnessTet, t, p, q, r, s. auto.
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
  - refine (MidpointExhibits (fun '(p, q, r, s) => (0 <? NormalsProduct p q r s)%Z &&
        (NormalsProduct p q r s ^ 2
           =? 3 * (SixVolume p q r s ^ 2 * EdgeSquared p q))%Z) _ _ _);
      [|vm_compute; reflexivity].
    intros p q r s T. apply andb_prop in T. rewrite Z.ltb_lt, Z.eqb_eq in T. exact T.
  - refine (MidpointExhibits (fun '(p, q, r, s) => (NormalsProduct p q r s <? 0)%Z &&
        (NormalsProduct p q r s ^ 2 =? SixVolume p q r s ^ 2 * EdgeSquared p q)%Z) _ _ _);
      [|vm_compute; reflexivity].
    intros p q r s T. apply andb_prop in T. rewrite Z.ltb_lt, Z.eqb_eq in T. exact T.
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
      MidpointAngles 3 1 30 (MidpointBounds _ _)
      (CotangentOverExactly _ _ _ CotangentIs30)
      ltac:(vm_compute; reflexivity)) as (t & p & q & r & s & I & J & L).
    exists MidpointSigns, WitnessTet, t, p, q, r, s. repeat (split; [assumption|]).
    apply Rle_antisym; [exact L | exact (proj1 (MidpointAngle _ _ _ _ _ _ I J))].
  - destruct (ExhibitsGreatest NoWarpThresholds (Decided MidpointSigns) MidpointCuts
      MidpointAngles 1 1 45 (MidpointBounds _ _)
      (CotangentOverExactly _ _ _ CotangentIs45)
      ltac:(vm_compute; reflexivity)) as (t & p & q & r & s & I & J & L).
    exists MidpointSigns, WitnessTet, t, p, q, r, s. repeat (split; [assumption|]).
    apply Rle_antisym; [exact (proj2 (MidpointAngle _ _ _ _ _ _ I J)) | lra].
Qed.
