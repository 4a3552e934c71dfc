(** * The warped lattice leaves no gaps

    A point is near a rounded count of many parts, hence nearly in a placed
    structured tetrahedron: were it outside a face, it would be so by a whole
    unit of volume, since its coordinates are integers like those of the
    corners, and the parts are more than that. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.Cases.AdmissibleProof
  Embedding.LatticeEmbedsProof Embedding.EdgeRank Embedding.WarpedLatticeProof
  Embedding.MeshEmbedsProof Embedding.GreedyProof Embedding.LevelProof
  Embedding.LatticeVolumeProof Embedding.StarProof Embedding.FillingProof
  Embedding.ApproachProof.
Open Scope Z_scope.

(** ** Inside a tetrahedron *)

Lemma WholeUnits n k part rest : k < n -> Z.abs rest <= k ->
  0 <= n * part + rest -> 0 <= part.
Proof. intros K R P. destruct (Z.le_gt_cases 0 part); [assumption|nia]. Qed.

(** [m] bounds the edges, [e] what is missing. *)
Lemma NormalDotBound m e u v w : 0 <= m -> 0 <= e ->
  Near m u -> Near m v -> Near e w ->
  Z.abs (Dot (Cross u v) w) <= 6 * (m * m) * e.
Proof.
  intros M E. destruct u as [a b c], v as [x y z], w as [p q r].
  unfold Near. cbn [XOf YOf ZOf Cross Dot].
  intros (A & B & C) (X & Y & Z) (P & Q & R).
  assert (T : forall a x p, Z.abs a <= m -> Z.abs x <= m -> Z.abs p <= e ->
    - (m * m * e) <= a * x * p <= m * m * e).
  { intros a' x' p' Ha Hx Hp.
    apply Z.abs_le. rewrite !Z.abs_mul.
    apply Z.mul_le_mono_nonneg; auto using Z.abs_nonneg.
    - apply Z.mul_nonneg_nonneg; apply Z.abs_nonneg.
    - apply Z.mul_le_mono_nonneg; auto using Z.abs_nonneg. }
  pose proof (T b z p B Z P). pose proof (T c y p C Y P).
  pose proof (T c x q C X Q). pose proof (T a z q A Z Q).
  pose proof (T a y r A Y R). pose proof (T b x r B X R). apply Z.abs_le.
  replace ((b * z - c * y) * p + (c * x - a * z) * q + (a * y - b * x) * r)
    with (b * z * p - c * y * p + c * x * q - a * z * q + a * y * r - b * x * r)
    by ring.
  repeat match goal with H : _ <= ?i * ?j * ?k <= _ |- _ =>
    revert H; generalize (i * j * k); intros ? H end. lia.
Qed.

Lemma InsideByVolumes t w x m e : 0 <= m -> 0 <= e ->
  NonNegative w -> 0 < SixVolumeOf t -> 6 * (m * m) * e < Total w ->
  (forall p q, In p (TetCorners t) -> In q (TetCorners t) ->
     Near m (Difference p q)) ->
  Near e (Difference (PointOf w t) (Scale (Total w) x)) ->
  NonNegative (Parts 1 x t).
Proof.
  intros M E W V L Edges Missing.
  pose proof (PartsOfPoint w t) as P.
  set (n := Total w) in *. set (y := PointOf w t) in *.
  set (d := Difference y (Scale n x)) in *.
  destruct t as [p q r s], w as [a b c g]. cbn [TetCorners In] in Edges.
  unfold Parts in *. cbn [Blend] in P. injection P as Pa Pb Pc Pg.
  cbn [NonNegative] in *. destruct W as (Wa & Wb & Wc & Wg).
  assert (Split : forall normal corner,
    n * Dot normal (Difference (Scale 1 corner) x)
    = Dot normal (Difference (Scale n corner) y) + Dot normal d).
  { intros normal corner. unfold d.
    destruct normal, corner, y, x. cbn [Difference Scale Dot]. ring. }
  assert (Bound : forall i j k, In i [p; q; r; s] -> In j [p; q; r; s] ->
    In k [p; q; r; s] -> Z.abs (Dot (Normal i j k) d) <= 6 * (m * m) * e).
  { intros i j k I J K. apply NormalDotBound; auto. }
  cbn [In] in Bound.
  cbn [SixVolumeOf] in V. set (volume := SixVolume p q r s) in *.
  pose proof (fun i => Z.mul_nonneg_nonneg volume i (Z.lt_le_incl _ _ V)) as VW.
  repeat split.
  - apply (WholeUnits n (6 * (m * m) * e) _ (Dot (Normal q r s) d)); auto 8.
    rewrite Z.mul_opp_r, Split. pose proof (VW a Wa). lia.
  - apply (WholeUnits n (6 * (m * m) * e) _ (- Dot (Normal p r s) d));
      [auto|rewrite Z.abs_opp; auto 8|].
    rewrite Split. pose proof (VW b Wb). lia.
  - apply (WholeUnits n (6 * (m * m) * e) _ (Dot (Normal p q s) d)); auto 8.
    rewrite Z.mul_opp_r, Split. pose proof (VW c Wc). lia.
  - apply (WholeUnits n (6 * (m * m) * e) _ (- Dot (Normal p q r) d));
      [auto|rewrite Z.abs_opp; auto 8|].
    rewrite Split. pose proof (VW g Wg). lia.
Qed.

(** ** A placed structured tetrahedron *)

Definition Swap {V : Type} (t : UnstructuredTet V) : UnstructuredTet V :=
  match t with UT _ a b c d => UT _ a b d c end.

Section Covers.
  Variables (place : Coord3 -> Coord3) (D : Z).
  Hypothesis Keeps : KeepsShortEdges place.
  Hypothesis Bounded : forall v d, DirectionKind d = Short ->
    NoLonger D (Difference (place v) (place (Translate v (Offset d)))).

  Lemma BoundPositive : 0 <= D.
  Proof. destruct (Bounded (C3 0 0 0) Dir_ppp eq_refl) as [H _]. lia. Qed.

  (** A long edge is two short ones. *)
  Lemma EdgesBounded v d :
    Near (2 * D) (Difference (place v) (place (Translate v (Offset d)))).
  Proof.
    pose proof BoundPositive as P.
    assert (Two : forall e f, DirectionKind e = Short -> DirectionKind f = Short ->
      Translate (Offset e) (Offset f) = Offset d ->
      Near (2 * D) (Difference (place v) (place (Translate v (Offset d))))).
    { intros e f E F S. rewrite <- S, <- TranslateTwice.
      pose proof (Bounded v e E) as A.
      pose proof (Bounded (Translate v (Offset e)) f F) as B.
      destruct (place v), (place (Translate v (Offset e))),
        (place (Translate (Translate v (Offset e)) (Offset f))).
      unfold Near, NoLonger in *. cbn [Difference XOf YOf ZOf] in *. lia. }
    destruct (DirectionKind d) eqn:K.
    - destruct d; try discriminate K;
        [apply (Two Dir_ppp Dir_pmm)|apply (Two Dir_mmm Dir_mpp)
        |apply (Two Dir_ppp Dir_mpm)|apply (Two Dir_mmm Dir_pmp)
        |apply (Two Dir_ppp Dir_mmp)|apply (Two Dir_mmm Dir_ppm)]; reflexivity.
    - pose proof (Bounded v d K) as A. unfold Near, NoLonger in *. lia.
  Qed.

  Lemma CornersNear tid p q : In p (Corners tid) -> In q (Corners tid) ->
    Near (2 * D) (Difference (place p) (place q)).
  Proof.
    intros I J. destruct (SamePoint3 p q) as [<-|N].
    - pose proof BoundPositive. destruct (place p). unfold Near.
      cbn [Difference XOf YOf ZOf]. lia.
    - destruct (EdgeBetween tid p q I J N) as [d ->]. apply EdgesBounded.
  Qed.

  Lemma CoversInteger x : exists tid w, InLattice tid /\ NonNegative w /\
    0 < Total w /\ PointOf w (MapTet place (LatticeTet tid)) = Scale (Total w) x.
  Proof.
    pose proof BoundPositive as P.
    set (m := 2 * D). set (e := 2 * D * D).
    assert (E : 0 <= e) by (unfold e; apply Z.mul_nonneg_nonneg; lia).
    set (k := 6 * (m * m) * e).
    assert (K : 0 <= k)
      by (unfold k, m; repeat apply Z.mul_nonneg_nonneg; lia).
    set (n := Z.to_nat (k + 1)).
    assert (N : Z.of_nat n = k + 1) by (unfold n; lia).
    destruct (Approach place D Keeps Bounded n ltac:(unfold n; lia)
      (Scale (Z.of_nat n) x)) as (p & q & r & s & A).
    destruct (MixWeighs n p q r s ltac:(unfold n; lia)) as (tid & w & Ev & W & T & M).
    assert (Pt : PointOf w (MapTet place (LatticeTet tid)) = Rounded place n p q r s).
    { rewrite PointOfCoordinates. unfold Rounded. cbv zeta.
      rewrite (M (fun v => XOf (place v))), (M (fun v => YOf (place v))),
        (M (fun v => ZOf (place v))). reflexivity. }
    rewrite <- Pt, <- T in A.
    assert (Edges : forall u v, In u (TetCorners (MapTet place (LatticeTet tid))) ->
      In v (TetCorners (MapTet place (LatticeTet tid))) -> Near m (Difference u v)).
    { intros u v. pose proof (CornersNear tid) as C. unfold m.
      unfold Corners, LatticeTet in *. destruct (GetStructuredTet tid).
      cbn [MapTet TetCorners In] in *.
      intros [<-|[<-|[<-|[<-|[]]]]] [<-|[<-|[<-|[<-|[]]]]]; apply C; tauto. }
    exists tid. pose proof (KeptVolume place tid Keeps) as V.
    unfold KeepsHand in V.
    destruct tid as [anchor case].
    destruct (LatticeTet (STId anchor case)) as [v1 v2 v3 v4] eqn:L.
    destruct (CaseHandedness case).
    - exists (Parts 1 x (MapTet place (UT _ v1 v2 v3 v4))).
      split; [exact Ev|]. split; [|rewrite PartsTotal, PartsPoint, Z.mul_1_r; auto].
      apply (InsideByVolumes _ w x m e); auto; [unfold m; lia|fold k; lia].
    - set (t := MapTet place (UT _ v1 v2 v3 v4)) in *.
      exists (Swap (Parts 1 x (Swap t))).
      assert (S : forall u, PointOf (Swap u) t = PointOf u (Swap t)).
      { intros [a b c d]. unfold t. cbn [MapTet Swap PointOf].
        destruct (place v1), (place v2), (place v3), (place v4).
        cbn [Scale Translate]. f_equal; ring. }
      assert (S' : forall u, Total (Swap u) = Total u)
        by (intros []; cbn [Swap Total]; ring).
      assert (S'' : forall u, NonNegative u -> NonNegative (Swap u))
        by (intros []; cbn [Swap NonNegative]; tauto).
      assert (Back : forall u : Weights, Swap (Swap u) = u) by (intros []; reflexivity).
      split; [exact Ev|]. split; [|rewrite S, S', PartsTotal, PartsPoint, Z.mul_1_r; auto].
      apply S'', (InsideByVolumes (Swap t) (Swap w) x m e); auto;
        [unfold m; lia|rewrite S'; fold k; lia| |].
      + intros u v I J. apply Edges; [revert I|revert J]; unfold t;
          cbn [MapTet Swap TetCorners In]; tauto.
      + rewrite <- S, S', Back. exact A.
  Qed.
End Covers.

(** ** Rational points *)

Lemma ScaledKeeps m place : 0 < m -> KeepsShortEdges place ->
  KeepsShortEdges (fun v => Scale m (place v)).
Proof.
  intros M K v d S. specialize (K v d S).
  destruct (Offset d) as [a b c], (place v), (place (Translate v (C3 a b c))).
  cbn [Scale Difference SameOctant] in *. rewrite <- !Z.mul_sub_distr_l.
  rewrite !(Z.mul_comm m), !Z.mul_assoc.
  repeat split; apply Z.mul_pos_pos; tauto.
Qed.

Lemma ScaledNoLonger m D u v : 0 < m -> NoLonger D (Difference u v) ->
  NoLonger (m * D) (Difference (Scale m u) (Scale m v)).
Proof.
  intros M. destruct u, v. unfold NoLonger. cbn [Scale Difference XOf YOf ZOf].
  rewrite <- !Z.mul_sub_distr_l, !Z.abs_mul, !(Z.abs_eq m) by lia.
  intros (A & B & C). repeat split; apply Z.mul_le_mono_nonneg_l; lia.
Qed.

Theorem LatticeCovers place D m x :
  KeepsShortEdges place ->
  (forall v d, DirectionKind d = Short ->
     NoLonger D (Difference (place v) (place (Translate v (Offset d))))) ->
  0 < m ->
  exists tid w, InLattice tid /\ NonNegative w /\ 0 < Total w /\
    Scale m (PointOf w (MapTet place (LatticeTet tid))) = Scale (Total w) x.
Proof.
  intros K B M.
  destruct (CoversInteger (fun v => Scale m (place v)) (m * D)
    (ScaledKeeps m place M K)
    (fun v d S => ScaledNoLonger m D _ _ M (B v d S)) x)
    as (tid & w & E & W & T & P).
  exists tid, w. repeat (split; [assumption|]). rewrite <- P.
  destruct w as [a b c d], (LatticeTet tid) as [p q r s].
  cbn [MapTet PointOf]. destruct (place p), (place q), (place r), (place s).
  cbn [Scale Translate]. f_equal; ring.
Qed.

(** ** Warps *)

Lemma PlacedNoLonger warping v d :
  (forall v d t, warping v = Moves d t -> 0 <= t <= Steps) ->
  DirectionKind d = Short ->
  let place v := WarpedPosition v (warping v) in
  NoLonger (5 * Steps) (Difference (place v) (place (Translate v (Offset d)))).
Proof.
  intros M S place.
  assert (H : forall f, Axis f ->
    Z.abs (f (Difference (place v) (place (Translate v (Offset d))))) <= 5 * Steps).
  { intros f F.
    assert (E : forall a b, f (Difference a b) = f b - f a)
      by (intros [] []; destruct F as [->|[->| ->]]; reflexivity).
    assert (E' : f (Translate v (Offset d)) = f v + f (Offset d))
      by (destruct v, (Offset d); destruct F as [->|[->| ->]]; reflexivity).
    unfold place. rewrite E, !ShiftOfPlace, E' by exact F.
    assert (B : forall u, - (2 * Steps) <= Shift f (warping u) <= 2 * Steps).
    { intros u. destruct (warping u) as [|e t] eqn:W; [split; discriminate|].
      apply M in W. cbn [Shift]. destruct F as [->|[->| ->]], e;
        cbn [XOf YOf ZOf Offset]; lia. }
    pose proof (B v). pose proof (B (Translate v (Offset d))).
    destruct (ShortOffset f d F S) as [-> | ->]; lia. }
  split; [|split]; apply H; unfold Axis; auto.
Qed.

Theorem WarpedLatticeCovers long short sign cut m x :
  long <= 64 -> short <= 128 -> CutsOnEdges sign cut -> 0 < m ->
  exists tid w, InLattice tid /\ NonNegative w /\ 0 < Total w /\
    Scale m (PointOf w
      (MapTet (WarpedPlace (TH long short) sign cut) (LatticeTet tid)))
    = Scale (Total w) x.
Proof.
  intros L S C. unfold WarpedPlace, MeshPosition.
  apply (LatticeCovers _ (5 * Steps));
    [apply WarpKeepsShortEdges; [split|]; assumption|].
  intros v d. apply PlacedNoLonger. intros u e t E.
  destruct (WarpedMeans _ sign cut u e t E) as (-> & O & _).
  exact (CutFromInRange sign cut C u e O).
Qed.

Theorem UncrossedLatticeCovers warping m x :
  MovesAtMost AngleThresholds warping -> Uncrossed warping -> 0 < m ->
  exists tid w, InLattice tid /\ NonNegative w /\ 0 < Total w /\
    Scale m (PointOf w
      (MapTet (fun v => WarpedPosition v (warping v)) (LatticeTet tid)))
    = Scale (Total w) x.
Proof.
  intros M U. apply (LatticeCovers _ (5 * Steps)); [apply UncrossedKeepsShortEdges; assumption|].
  intros v d. apply PlacedNoLonger. intros u e t E. pose proof (M u e t E) as B.
  change (ThresholdSteps AngleThresholds (DirectionKind e))
    with (match DirectionKind e with Long => 18688 | Short => 26112 end) in B.
  change Steps with 65536. destruct (DirectionKind e); lia.
Qed.
