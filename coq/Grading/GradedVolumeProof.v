(** * Volumes and angles of graded tetrahedra: proofs

    A tetrahedron is one of cell 0 0 0 at level 0, moved and enlarged: 240 there
    are, five kinds for each of 48 flags. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Mesh.Method Material.MaterialShape.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet
  Grading.Surface Grading.GradingSpec.
From Certet Require Import Grading.FlagProof.
Open Scope Z_scope.

(** ** Moved and enlarged *)

Definition Move (h : Z) (v p : Coord3) : Coord3 := Scale h (Translate v p).

Lemma MoveDifference h v a b :
  Difference (Move h v a) (Move h v b) = Scale h (Difference a b).
Proof.
  destruct v, a, b. unfold Move. cbn [Translate Scale Difference]. f_equal; ring.
Qed.

Section Moved.
  Variables (h : Z) (v : Coord3).
  Hypothesis Enlarges : 0 < h.
  Local Notation Move := (Move h v).

  Lemma MoveNormal a b c : Normal (Move a) (Move b) (Move c) = Scale (h ^ 2) (Normal a b c).
  Proof.
    unfold Normal. rewrite !MoveDifference.
    destruct (Difference a b), (Difference a c). cbn [Scale Cross]. f_equal; ring.
  Qed.

  Lemma MoveVolume a b c d :
    SixVolume (Move a) (Move b) (Move c) (Move d) = h ^ 3 * SixVolume a b c d.
  Proof.
    unfold SixVolume. rewrite MoveNormal, MoveDifference.
    destruct (Normal a b c), (Difference a d). cbn [Scale Dot]. ring.
  Qed.

  Lemma MoveNormals a b c d :
    NormalsProduct (Move a) (Move b) (Move c) (Move d) = h ^ 4 * NormalsProduct a b c d.
  Proof.
    unfold NormalsProduct. rewrite !MoveNormal.
    destruct (Normal a b c), (Normal a b d). cbn [Scale Dot]. ring.
  Qed.

  Lemma MoveEdge a b : EdgeSquared (Move a) (Move b) = h ^ 2 * EdgeSquared a b.
  Proof.
    unfold EdgeSquared. rewrite MoveDifference.
    destruct (Difference a b). cbn [Scale Dot]. ring.
  Qed.

  Lemma Enlarge n d N V E : d * N ^ 2 <= n * (V ^ 2 * E) ->
    d * (h ^ 4 * N) ^ 2 <= n * ((h ^ 3 * V) ^ 2 * (h ^ 2 * E)).
  Proof.
    intros H. replace (d * (h ^ 4 * N) ^ 2) with (h ^ 8 * (d * N ^ 2)) by ring.
    replace (n * ((h ^ 3 * V) ^ 2 * (h ^ 2 * E))) with (h ^ 8 * (n * (V ^ 2 * E))) by ring.
    apply Z.mul_le_mono_nonneg_l; [apply Z.pow_nonneg; lia | exact H].
  Qed.

  Lemma MoveWellShaped bounds t : WellShaped bounds t -> WellShaped bounds (MapTet Move t).
  Proof.
    destruct bounds as [[n d] [n' d']], t as [a b c e]. intros [V A]. cbn [MapTet].
    assert (P4 : 0 < h ^ 4) by (apply Z.pow_pos_nonneg; lia).
    split; [rewrite MoveVolume; apply Z.mul_pos_pos; [apply Z.pow_pos_nonneg; lia | exact V]|].
    intros p q r s I.
    assert (exists p' q' r' s', In (p', q', r', s') (DihedralEdges (UT _ a b c e)) /\
      p = Move p' /\ q = Move q' /\ r = Move r' /\ s = Move s')
      as (p' & q' & r' & s' & I' & -> & -> & -> & ->).
    { cbn [DihedralEdges In] in I.
      repeat (destruct I as [I | I];
        [injection I as <- <- <- <-; do 4 eexists; split; [|repeat split];
         cbn [DihedralEdges In]; tauto|]).
      destruct I. }
    destruct (A _ _ _ _ I') as [L M]. unfold AngleAtLeast, AngleAtMost in *.
    rewrite MoveNormals, MoveVolume, MoveEdge.
    split; [destruct L as [L | L] | destruct M as [M | M]];
      [left; nia | right; apply Enlarge, L | left; nia | right; apply Enlarge, M].
  Qed.
End Moved.

(** ** The 240 *)

Definition AllOrders : list AxisOrder := [XYZ; XZY; YXZ; YZX; ZXY; ZYX].
Definition AllKinds : list GradedKind :=
  [BccTet; EdgeHalfTet; FaceHalfTet; QuarterTet; PyramidTet].

Definition AtOrigin (o : AxisOrder) (s t u : bool) : Flag :=
  MakeFlag O (C3 0 0 0) o s t u.

Definition ForAllFlags (test : GradedTetId -> bool) : bool :=
  let signs := [true; false] in
  forallb (fun kind => forallb (fun o => forallb (fun s => forallb (fun t =>
    forallb (fun u => test (GTId kind (AtOrigin o s t u)))
      signs) signs) signs) AllOrders) AllKinds.

Lemma ForEachFlag test : ForAllFlags test = true ->
  forall kind o s t u, test (GTId kind (AtOrigin o s t u)) = true.
Proof.
  unfold ForAllFlags. intros all kind o s t u.
  rewrite forallb_forall in all.
  assert (In kind AllKinds) as K by (destruct kind; cbn; tauto).
  apply all in K. rewrite forallb_forall in K.
  assert (In o AllOrders) as J by (destruct o; cbn; tauto).
  apply K in J. rewrite forallb_forall in J.
  assert (B : forall b : bool, In b [true; false]) by (intros []; cbn; tauto).
  pose proof (J s (B s)) as H. rewrite forallb_forall in H.
  pose proof (H t (B t)) as G. rewrite forallb_forall in G. exact (G u (B u)).
Qed.

Lemma MovedFlag level c o s t u i j k :
  PointSeen (MakeFlag level c o s t u) i j k
  = Move (HalfSide level) (Scale 2 c) (PointSeen (AtOrigin o s t u) i j k).
Proof.
  unfold PointSeen, PointInHalfSides, CentreInHalfSides, AtOrigin, Move.
  cbn [LevelOf CellOf StepFrom].
  destruct c, (Arrange o _ _ _). cbn [Scale Translate].
  change (HalfSide 0) with 1. f_equal; ring.
Qed.

Lemma MovedTet kind level c o s t u :
  GetGradedTet (GTId kind (MakeFlag level c o s t u))
  = MapTet (Move (HalfSide level) (Scale 2 c))
      (GetGradedTet (GTId kind (AtOrigin o s t u))).
Proof.
  unfold GetGradedTet.
  change (GradedHandedness (GTId kind (MakeFlag level c o s t u)))
    with (GradedHandedness (GTId kind (AtOrigin o s t u))).
  assert (V : GradedVertices (GTId kind (MakeFlag level c o s t u))
    = let '(v1, v2, v3, v4) := GradedVertices (GTId kind (AtOrigin o s t u)) in
      let move := Move (HalfSide level) (Scale 2 c) in
      (move v1, move v2, move v3, move v4)).
  { destruct kind; cbn [GradedVertices IsUpperEdge AtOrigin]; rewrite !MovedFlag;
      try (destruct t); reflexivity. }
  rewrite V. destruct (GradedVertices (GTId kind (AtOrigin o s t u))) as [[[v1 v2] v3] v4].
  now destruct (GradedHandedness _).
Qed.

Lemma HalfSidePositive l : 0 < HalfSide l.
Proof. unfold HalfSide. apply Z.pow_pos_nonneg; lia. Qed.

(** ** The theorems *)

Lemma ShapedCheck t : IsWellShaped TransitionBounds t = true ->
  WellShaped TransitionBounds t.
Proof.
  destruct t as [a b c d]. unfold IsWellShaped, TransitionBounds. cbv beta iota.
  rewrite andb_true_iff, Z.ltb_lt, forallb_forall. intros [V H]. split; [exact V|].
  intros p q r s I. apply H in I. unfold IsAngleWithin in I. cbv zeta in I.
  apply andb_prop in I as [L M]. apply orb_prop in L, M.
  split; [destruct L as [L | L] | destruct M as [M | M]]; apply Z.leb_le in L || apply Z.leb_le in M;
    unfold AngleAtLeast, AngleAtMost; auto.
Qed.

Lemma AllShaped :
  ForAllFlags (fun tid => IsWellShaped TransitionBounds (GetGradedTet tid)) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem TransitionAngles :
  forall tid, WellShaped TransitionBounds (GetGradedTet tid).
Proof.
  intros [kind [level c o s t u]]. rewrite MovedTet.
  apply MoveWellShaped; [apply HalfSidePositive|].
  apply ShapedCheck. exact (ForEachFlag _ AllShaped kind o s t u).
Qed.

Definition VolumeIsFlags (tid : GradedTetId) : bool :=
  match GetGradedTet tid with
    UT _ a b c d => SixVolume a b c d =? Z.of_nat (length (FlagsOf tid))
  end.

Lemma AllVolumes : ForAllFlags VolumeIsFlags = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem GradedVolume :
  forall tid,
    match GetGradedTet tid with
      UT _ a b c d =>
        SixVolume a b c d = Z.of_nat (length (FlagsOf tid)) * GradedSize tid ^ 3
    end.
Proof.
  intros [kind [level c o s t u]]. rewrite MovedTet.
  pose proof (ForEachFlag _ AllVolumes kind o s t u) as V. unfold VolumeIsFlags in V.
  destruct (GetGradedTet (GTId kind (AtOrigin o s t u))) as [p q r w].
  apply Z.eqb_eq in V. cbn [MapTet]. rewrite MoveVolume, V.
  unfold GradedSize. cbn [FlagOfName LevelOf].
  destruct kind; cbn [FlagsOf length]; ring.
Qed.

(** ** Volumes as flags see them *)

Definition UpSign (up : bool) : Z := if up then 1 else -1.

Definition FlagSign (x : Flag) : Z :=
  match x with
    MakeFlag _ _ o s t u => UpSign (IsEvenOrder o) * UpSign s * UpSign t * UpSign u
  end.

Lemma ArrangeVolume o a b c d e f g h i j k l :
  SixVolume (Arrange o a b c) (Arrange o d e f) (Arrange o g h i) (Arrange o j k l)
  = UpSign (IsEvenOrder o) * SixVolume (C3 a b c) (C3 d e f) (C3 g h i) (C3 j k l).
Proof.
  unfold SixVolume, Normal.
  destruct o; cbn [Arrange IsEvenOrder UpSign Difference Cross Dot]; ring.
Qed.

Lemma SignedIs s n : Signed s n = UpSign s * n.
Proof. destruct s; cbn [Signed UpSign]; ring. Qed.

Lemma SignedVolume s t u a b c d e f g h i j k l :
  SixVolume (C3 (Signed s a) (Signed t b) (Signed u c))
    (C3 (Signed s d) (Signed t e) (Signed u f))
    (C3 (Signed s g) (Signed t h) (Signed u i))
    (C3 (Signed s j) (Signed t k) (Signed u l))
  = UpSign s * UpSign t * UpSign u * SixVolume (C3 a b c) (C3 d e f) (C3 g h i) (C3 j k l).
Proof.
  rewrite !SignedIs. unfold SixVolume, Normal. cbn [Difference Cross Dot]. ring.
Qed.

Lemma VolumeSeen x a b c d e f g h i j k l :
  SixVolume (PointSeen x a b c) (PointSeen x d e f) (PointSeen x g h i) (PointSeen x j k l)
  = HalfSide (LevelOf x) ^ 3 * FlagSign x
    * SixVolume (C3 a b c) (C3 d e f) (C3 g h i) (C3 j k l).
Proof.
  destruct x as [level v o s t u].
  change (PointSeen ?x ?a ?b ?c)
    with (Move (HalfSide (LevelOf x)) (CentreInHalfSides (CellOf x)) (StepFrom x a b c)).
  rewrite MoveVolume. cbn [StepFrom LevelOf CellOf FlagSign].
  rewrite ArrangeVolume, SignedVolume. ring.
Qed.

Lemma SignSquared s : UpSign s * UpSign s = 1.
Proof. destruct s; reflexivity. Qed.

Lemma FlagSignSquared x : FlagSign x * FlagSign x = 1.
Proof.
  destruct x as [level c o s t u]. cbn [FlagSign].
  transitivity ((UpSign (IsEvenOrder o) * UpSign (IsEvenOrder o)) * (UpSign s * UpSign s)
    * (UpSign t * UpSign t) * (UpSign u * UpSign u)); [ring|].
  now rewrite !SignSquared.
Qed.

Lemma ApartSeen x a b c d e f g h i j k l j' k' l' :
  SixVolume (C3 a b c) (C3 d e f) (C3 g h i) (C3 j k l)
  * SixVolume (C3 a b c) (C3 d e f) (C3 g h i) (C3 j' k' l') < 0 ->
  SixVolume (PointSeen x a b c) (PointSeen x d e f) (PointSeen x g h i) (PointSeen x j k l)
  * SixVolume (PointSeen x a b c) (PointSeen x d e f) (PointSeen x g h i)
      (PointSeen x j' k' l') < 0.
Proof.
  rewrite !VolumeSeen.
  generalize (SixVolume (C3 a b c) (C3 d e f) (C3 g h i) (C3 j k l))
    (SixVolume (C3 a b c) (C3 d e f) (C3 g h i) (C3 j' k' l')).
  intros V W H.
  pose proof (HalfSidePositive (LevelOf x)) as P.
  assert (Q : 0 < HalfSide (LevelOf x) ^ 6) by (apply Z.pow_pos_nonneg; lia).
  replace (HalfSide (LevelOf x) ^ 3 * FlagSign x * V * (HalfSide (LevelOf x) ^ 3 * FlagSign x * W))
    with (HalfSide (LevelOf x) ^ 6 * (FlagSign x * FlagSign x) * (V * W)) by ring.
  rewrite FlagSignSquared. nia.
Qed.

(** ** Different points *)

Lemma ScaleInjective h a b : 0 < h -> Scale h a = Scale h b -> a = b.
Proof.
  destruct a, b. cbn [Scale]. intros P [= E F G].
  apply Z.mul_reg_l in E, F, G; [congruence | lia ..].
Qed.

Lemma TranslateInjective v a b : Translate v a = Translate v b -> a = b.
Proof. destruct v, a, b. cbn [Translate]. intros [=]. f_equal; lia. Qed.

Lemma SeenInjective x i j k i' j' k' :
  PointSeen x i j k = PointSeen x i' j' k' -> i = i' /\ j = j' /\ k = k'.
Proof.
  intros E. apply ScaleInjective in E; [|apply HalfSidePositive].
  apply TranslateInjective in E. destruct x as [level c o s t u]. cbn [StepFrom] in E.
  apply ArrangeInjective in E. destruct E as (E & F & G).
  destruct s, t, u; cbn [Signed] in *; lia.
Qed.

Lemma GradedVerticesApart tid i j :
  GradedVertexAt tid i = GradedVertexAt tid j -> i = j.
Proof.
  destruct tid as [kind x]. unfold GradedVertexAt.
  destruct kind; cbn [GradedVertices]; try (destruct (IsUpperEdge x));
    destruct i, j; cbn [Pick]; intros E; try reflexivity;
    apply SeenInjective in E; lia.
Qed.
