(** * A graded mesh keeps the angles of its method: proofs *)

From Coq Require Import Reals Lra.
From Certet Require Import Embedding.Definitions.
From Certet Require Import Lattice.Tiling Mesh.Method Mesh.CertifiedSpec
  Angles.DegreesSpec Angles.Degrees.DegreesProof Mesh.CertifiedMeshProof.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet
  Grading.Surface Grading.GradingSpec.
From Certet Require Import Grading.PartitionProof Grading.GradedVolumeProof
  Grading.TouchedProof.
Open Scope Z_scope.

Local Strategy 1000 [WarpVertex Bisect Settle].

(** ** Degrees *)

Lemma Cotangent45Exact : Cotangent (CotSq 1 1) 45.
Proof.
  unfold Cotangent, Radians. split; [lra|]. split; [lia|]. split; [lia|].
  replace (45 * PI / 180)%R with (PI / 4)%R by field.
  rewrite cos_PI4. change (1 + 1) with 2.
  pose proof (sqrt_sqrt 2 ltac:(lra)) as S. pose proof Rlt_sqrt2_0 as P.
  replace ((1 / sqrt 2) ^ 2)%R with (1 / (sqrt 2 * sqrt 2))%R by (field; lra).
  rewrite S. lra.
Qed.

Lemma Cotangent60Exact : Cotangent (CotSq 1 3) 60.
Proof.
  unfold Cotangent, Radians. split; [lra|]. split; [lia|]. split; [lia|].
  replace (60 * PI / 180)%R with (PI / 3)%R by field.
  rewrite cos_PI3. change (1 + 3) with 4. lra.
Qed.

Lemma TransitionDegrees t : WellShaped TransitionBounds t -> WithinDegrees 45 120 t.
Proof.
  apply (DegreesBounds _ _ 45 60 120 t Cotangent45Exact Cotangent60Exact). lra.
Qed.

Theorem TransitionAnglesInDegrees :
  forall tid, WithinDegrees 45 120 (GetGradedTet tid).
Proof. intros tid. apply TransitionDegrees, TransitionAngles. Qed.

(** ** The mesh *)

Lemma StepsPositive : 0 < Steps.
Proof. reflexivity. Qed.

Lemma GradedVertexIn tid v : In v (TetCorners (GetGradedTet tid)) ->
  exists i, v = GradedVertexAt tid i.
Proof.
  unfold GetGradedTet, GradedVertexAt.
  destruct (GradedVertices tid) as [[[v1 v2] v3] v4], (GradedHandedness tid);
    cbn [TetCorners In Pick]; intros [<- | [<- | [<- | [<- | []]]]];
    [exists First | exists Second | exists Third | exists Fourth
    |exists First | exists Second | exists Fourth | exists Third]; reflexivity.
Qed.

Lemma MapTetSame (f g : Coord3 -> Coord3) t :
  (forall v, In v (TetCorners t) -> f v = g v) -> MapTet f t = MapTet g t.
Proof.
  destruct t as [a b c d]. cbn [TetCorners MapTet In]. intros H.
  rewrite (H a), (H b), (H c), (H d); auto 6.
Qed.

Section Mesh.
  Variables (method : Method) (sign : SignField) (domain : PositionSigns).
  Local Notation mesh := (MeshOf method sign domain).
  (** A corner that is inside after warping is where it was. *)
  Lemma PlusStays v : CornerSigns mesh v = Plus -> PositionIn mesh (Corner v) = Scale Steps v.
  Proof.
    assert (W : forall (s : Sign) w, WarpedSign s w = Plus -> WarpedPosition v w = Scale Steps v)
      by (intros s [|d n]; [reflexivity | discriminate]).
    destruct method; unfold CornerSigns;
      cbn [MeshOf StuffedMesh SweptMesh PlacedMesh KeySweptMesh KeyMesh SignIn PositionIn
        MeshVertexSign MeshPosition PlacedSign PlacedPosition]; apply W.
  Qed.

  Variable cells : CellSet.
  Hypothesis IsOne : IsOctree cells.
  Hypothesis Kept : KeepsSurface (CornerSigns mesh) cells.

  (** All of a tetrahedron that is not a structured one is inside. *)
  Lemma PlainIsPlus tid i : InGradedMesh cells tid -> StructuredName tid = None ->
    CornerSigns mesh (GradedVertexAt tid i) = Plus.
  Proof.
    intros M N. destruct (CornerSigns mesh (GradedVertexAt tid i)) eqn:E; [reflexivity | |];
      (destruct (TouchedTetsPlain (CornerSigns mesh) cells tid i IsOne Kept M) as [stid S];
       [rewrite E; discriminate | congruence]).
  Qed.

  (** It stands in the mesh as in the lattice. *)
  Lemma PlainPlaced tid : InGradedMesh cells tid -> StructuredName tid = None ->
    MapTet (PositionIn mesh) (MapTet Corner (GetGradedTet tid))
    = MapTet (Move Steps (C3 0 0 0)) (GetGradedTet tid).
  Proof.
    intros M N.
    transitivity (MapTet (fun v => PositionIn mesh (Corner v)) (GetGradedTet tid));
      [now destruct (GetGradedTet tid)|].
    apply MapTetSame. intros v I. destruct (GradedVertexIn _ _ I) as [i ->].
    rewrite PlusStays; [|now apply PlainIsPlus].
    unfold Move. destruct (GradedVertexAt tid i). reflexivity.
  Qed.

  Theorem CertifiedGradedMesh tid t : InGradedMesh cells tid -> In t (GradedTetsWithin mesh tid) ->
    WithinDegrees (IZR (LeastAngle method) / 100) (IZR (GreatestAngle method) / 100)
      (MapTet (PositionIn mesh) t).
  Proof.
    intros M I. unfold GradedTetsWithin in I. destruct (StructuredName tid) as [stid|] eqn:N.
    - destruct (CertifiedMesh method sign domain) as (positive & angles & _).
      assert (J : In (MapTet (PositionIn mesh) t) (PlacedWithin mesh stid))
        by (unfold PlacedWithin; now apply in_map).
      pose proof (positive _ _ J) as P.
      destruct (MapTet (PositionIn mesh) t) as [a b c d] eqn:E.
      split; [exact P|]. intros p q r s K. exact (angles _ _ p q r s J K).
    - destruct I as [<- | []]. rewrite (PlainPlaced tid M N).
      pose proof (TransitionDegrees _
        (MoveWellShaped Steps (C3 0 0 0) StepsPositive _ _ (TransitionAngles tid))) as W.
      destruct (MapTet (Move Steps (C3 0 0 0)) (GetGradedTet tid)) as [a b c d].
      destruct W as [P W]. split; [exact P|]. intros p q r s K.
      pose proof (W p q r s K) as B.
      destruct method; cbn [LeastAngle GreatestAngle]; lra.
  Qed.
End Mesh.
