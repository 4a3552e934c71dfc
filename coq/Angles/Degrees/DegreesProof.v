(** * From cotangents' squares to degrees: proofs

    The axioms of Coq's real numbers enter here and nowhere else. *)

From Coq Require Import Reals Lra.
From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.Forms.CheckerProof
  Angles.AngleTheorems.
Open Scope R_scope.

(** ** Numbers *)

Lemma PIBetween : 31415 / 10000 <= PI <= 31416 / 10000.
Proof.
  pose proof (PI_2_3_7_ineq 2) as H. unfold tg_alt, PI_2_3_7_tg, Ratan_seq in H.
  cbn [sum_f_R0 Nat.mul Nat.add pow] in H.
  rewrite !INR_IZR_INZ in H. cbn in H. lra.
Qed.

(** A partial sum of the cosine's series, written out. *)
Ltac series :=
  unfold cos_approx, cos_term; cbn [sum_f_R0 Nat.mul Nat.add];
  rewrite !INR_IZR_INZ; cbn [fact Nat.mul Nat.add];
  cbn [Z.of_nat Pos.of_succ_nat Pos.succ]; field.

Lemma CosLower a : 0 <= a <= 2 ->
  1 - a ^ 2 / 2 + a ^ 4 / 24 - a ^ 6 / 720 <= cos a.
Proof.
  intros B. destruct (pre_cos_bound a 1 ltac:(lra) ltac:(lra)) as [L _].
  refine (Rle_trans _ _ _ (Req_le _ _ _) L). series.
Qed.

Lemma CosUpper a : 0 <= a <= 2 ->
  cos a <= 1 - a ^ 2 / 2 + a ^ 4 / 24.
Proof.
  intros B. destruct (pre_cos_bound a 0 ltac:(lra) ltac:(lra)) as [_ L].
  refine (Rle_trans _ _ _ L (Req_le _ _ _)). series.
Qed.

(** ** One angle *)

Definition Radians (degrees : R) : R := degrees * PI / 180.

(** n/d is at most the square of the cotangent of the angle. *)
Definition Cotangent (k : CotSquared) (degrees : R) : Prop :=
  match k with
    CotSq n d =>
      0 < degrees < 90 /\ (0 <= n)%Z /\ (0 < d)%Z /\
      IZR n <= IZR (n + d) * (cos (Radians degrees)) ^ 2
  end.

Lemma RadiansBound x : 0 < x < 90 -> 0 < Radians x < PI / 2.
Proof. intros B. unfold Radians. pose proof PI_RGT_0. split; nra. Qed.

Lemma RadiansRest x : Radians (180 - x) = PI - Radians x.
Proof. unfold Radians. field. Qed.

(** As [DihedralDegrees] has it. *)
Lemma DegreesAtLeast degrees x : Radians degrees <= x -> degrees <= x * 180 / PI.
Proof.
  unfold Radians. intros L. pose proof PI_RGT_0 as P.
  apply (Rmult_le_reg_r (PI / 180)); [lra|].
  replace (x * 180 / PI * (PI / 180)) with x by (field; lra). lra.
Qed.

Lemma DegreesAtMost degrees x : x <= Radians degrees -> x * 180 / PI <= degrees.
Proof.
  unfold Radians. intros L. pose proof PI_RGT_0 as P.
  apply (Rmult_le_reg_r (PI / 180)); [lra|].
  replace (x * 180 / PI * (PI / 180)) with x by (field; lra). lra.
Qed.

Lemma Lagrange a b c d :
  (Dot (Normal a b c) (Normal a b c) * Dot (Normal a b d) (Normal a b d)
   = NormalsProduct a b c d ^ 2 + SixVolume a b c d ^ 2 * EdgeSquared a b)%Z.
Proof.
  destruct a, b, c, d. unfold NormalsProduct, SixVolume, EdgeSquared, Normal.
  cbn [Difference Cross Dot]. ring.
Qed.

Lemma DotNonNegative u : (0 <= Dot u u)%Z.
Proof. destruct u. cbn [Dot]. nia. Qed.

Lemma EdgePositive a b c d : (0 < SixVolume a b c d)%Z -> (0 < EdgeSquared a b)%Z.
Proof.
  intros V. pose proof (DotNonNegative (Difference a b)) as P.
  fold (EdgeSquared a b) in P.
  destruct (Z.eq_dec (EdgeSquared a b) 0) as [E|]; [exfalso|lia].
  pose proof (Lagrange a b c d) as L. rewrite E in L.
  unfold EdgeSquared, SixVolume, Normal in *.
  destruct (Difference a b) as [x y z].
  assert (x = 0 /\ y = 0 /\ z = 0)%Z as (-> & -> & ->) by (cbn [Dot] in E; nia).
  destruct (Difference a c), (Difference a d). cbn [Cross Dot] in V. lia.
Qed.

(** The cosine that [DihedralDegrees] takes. *)
Definition Cosine (N D : R) : R := N / sqrt (N ^ 2 + D).

Lemma CosineOpposite N D : Cosine (- N) D = - Cosine N D.
Proof.
  unfold Cosine. replace ((- N) ^ 2) with (N ^ 2) by ring. unfold Rdiv. ring.
Qed.

(** The denominator. *)
Lemma Hypotenuse N D : 0 < D -> let s := sqrt (N ^ 2 + D) in
  0 < N ^ 2 + D /\ 0 < s /\ s * s = N ^ 2 + D.
Proof.
  intros P. assert (Q : 0 < N ^ 2 + D) by nra. split; [exact Q|].
  split; [apply sqrt_lt_R0; exact Q|apply sqrt_sqrt; lra].
Qed.

Lemma CosineCompared N D c : 0 < D -> let s := sqrt (N ^ 2 + D) in
  (N <= c * s -> Cosine N D <= c) /\ (c * s <= N -> c <= Cosine N D).
Proof.
  intros P s. destruct (Hypotenuse N D P) as (_ & S & _). fold s in S.
  unfold Cosine. fold s.
  split; intros H; apply (Rmult_le_reg_r s); try exact S;
    replace (N / s * s) with N by (field; lra); exact H.
Qed.

Lemma CosinePositive degrees : 0 < degrees < 90 -> 0 < cos (Radians degrees).
Proof. intros B. pose proof (RadiansBound degrees B). apply cos_gt_0; lra. Qed.

Lemma CosineBound N D : 0 < D -> -1 <= Cosine N D <= 1.
Proof.
  intros P. unfold Cosine. destruct (Hypotenuse N D P) as (Q & S & _).
  assert (A : Rabs N <= sqrt (N ^ 2 + D)).
  { rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr. nra. }
  pose proof (Rle_abs N) as A1. pose proof (Rle_abs (- N)) as A2.
  rewrite Rabs_Ropp in A2.
  set (s := sqrt (N ^ 2 + D)) in *.
  replace (N / s) with (N * / s) by reflexivity.
  assert (I : 0 < / s) by (apply Rinv_0_lt_compat; exact S).
  assert (E : s * / s = 1) by (field; lra).
  split; nra.
Qed.

Lemma CosineAtMost k degrees N D (n d : Z) : k = CotSq n d ->
  Cotangent k degrees -> 0 < D ->
  N <= 0 \/ IZR d * N ^ 2 <= IZR n * D ->
  Cosine N D <= cos (Radians degrees).
Proof.
  intros -> (B & Pn & Pd & C) P H.
  apply IZR_le in Pn. apply IZR_lt in Pd. apply CosineCompared; [exact P|].
  destruct (Hypotenuse N D P) as (Q & S & E). pose proof (CosinePositive _ B) as Pc.
  set (s := sqrt (N ^ 2 + D)) in *. set (c := cos (Radians degrees)) in *.
  destruct H as [H|H]; [nra|].
  destruct (Rle_dec N 0) as [|T]; [nra|].
  apply Rnot_le_lt in T.
  apply Rsqr_incr_0_var; [|nra]. unfold Rsqr.
  rewrite plus_IZR in C.
  assert (H1 : (IZR n + IZR d) * N ^ 2 <= IZR n * (N ^ 2 + D)) by nra.
  assert (H2 : IZR n * (N ^ 2 + D)
               <= (IZR n + IZR d) * c ^ 2 * (N ^ 2 + D))
    by (apply Rmult_le_compat_r; lra).
  apply (Rmult_le_reg_l (IZR n + IZR d)); [lra|].
  replace (c * s * (c * s)) with (c ^ 2 * (s * s)) by ring.
  rewrite E. nra.
Qed.

Lemma AcosAtLeast x a : -1 <= x <= 1 -> 0 <= a <= PI -> x <= cos a -> a <= acos x.
Proof.
  intros Bx Ba H. destruct (Rle_dec a (acos x)) as [L|L]; [exact L|exfalso].
  apply Rnot_le_lt in L. pose proof (acos_bound x) as B.
  pose proof (cos_decreasing_1 (acos x) a ltac:(lra) ltac:(lra) ltac:(lra)
                ltac:(lra) L) as M.
  rewrite cos_acos in M by exact Bx. lra.
Qed.

Lemma DegreesIsCosine a b c d : (0 < SixVolume a b c d)%Z ->
  let N := IZR (NormalsProduct a b c d) in
  let D := IZR (SixVolume a b c d ^ 2 * EdgeSquared a b) in
  0 < D /\ DihedralDegrees a b c d = acos (Cosine N D) * 180 / PI.
Proof.
  intros V N D. pose proof (EdgePositive _ _ _ _ V) as L. split.
  - apply IZR_lt. nia.
  - unfold DihedralDegrees, Cosine. rewrite <- sqrt_mult_alt.
    + rewrite <- mult_IZR, Lagrange, plus_IZR.
      replace (IZR (NormalsProduct a b c d ^ 2)) with (N ^ 2).
      * reflexivity.
      * unfold N. rewrite pow_IZR. reflexivity.
    + apply IZR_le, DotNonNegative.
Qed.

Theorem DegreesBounds acute obtuse least rest greatest t :
  Cotangent acute least -> Cotangent obtuse rest -> greatest = 180 - rest ->
  WellShaped (AB acute obtuse) t -> WithinDegrees least greatest t.
Proof.
  intros Ca Co ->. destruct t as [a b c d]. intros [V H]. split; [exact V|].
  intros p q r s I. destruct (H p q r s I) as [H1 H2].
  rewrite <- (EvenOrders _ _ _ _ _ _ _ _ I) in V.
  destruct (DegreesIsCosine p q r s V) as [PD ->].
  set (D := IZR (SixVolume p q r s ^ 2 * EdgeSquared p q)) in *.
  destruct acute as [n k] eqn:Ea, obtuse as [n' k'] eqn:Eo.
  pose proof (RadiansBound least (proj1 Ca)) as Ra.
  pose proof (RadiansBound rest (proj1 Co)) as Ro.
  pose proof (CosineBound (IZR (NormalsProduct p q r s)) D PD) as B.
  split; [apply DegreesAtLeast|apply DegreesAtMost; rewrite RadiansRest].
  - apply AcosAtLeast; [exact B|lra|].
    apply (CosineAtMost _ _ _ _ _ _ eq_refl Ca PD).
    destruct H1 as [H1|H1]; [left; apply IZR_le in H1; exact H1|right].
    apply IZR_le in H1. rewrite (mult_IZR k), (mult_IZR n) in H1.
    rewrite pow_IZR. exact H1.
  - apply Ropp_le_cancel, (Rplus_le_reg_l PI).
    replace (PI + - (PI - Radians rest)) with (Radians rest) by ring.
    change (PI + - ?x) with (PI - x). rewrite <- acos_opp, <- CosineOpposite.
    apply AcosAtLeast; [rewrite CosineOpposite; lra|lra|].
    apply (CosineAtMost _ _ _ _ _ _ eq_refl Co PD).
    destruct H2 as [H2|H2]; [left; apply IZR_le in H2; lra|right].
    apply IZR_le in H2. rewrite (mult_IZR k'), (mult_IZR n') in H2.
    replace ((- IZR (NormalsProduct p q r s)) ^ 2)
      with (IZR (NormalsProduct p q r s) ^ 2) by ring.
    rewrite pow_IZR. exact H2.
Qed.

(** ** The six angles *)

(** [low] is a rational lower bound of the cosine. *)
Lemma CotangentBy n d degrees (low : R) :
  0 < degrees < 90 -> (0 <= n)%Z -> (0 < d)%Z -> 0 <= low ->
  (let b := degrees * (31416 / 10000) / 180 in
   low <= 1 - b ^ 2 / 2 + b ^ 4 / 24 - b ^ 6 / 720) ->
  IZR n <= IZR (n + d) * low ^ 2 ->
  Cotangent (CotSq n d) degrees.
Proof.
  intros B Pn Pd Pl Hb Hl. repeat (split; [assumption|]).
  cbv zeta in Hb. pose proof PIBetween as [PL U].
  pose proof PI_RGT_0 as PP.
  pose proof (RadiansBound degrees B) as R.
  set (b := degrees * (31416 / 10000) / 180) in *.
  assert (L : Radians degrees <= b) by (unfold Radians, b; nra).
  assert (Hb2 : b <= 2) by (unfold b; lra).
  assert (B2 : 0 <= b <= 2) by lra.
  assert (C : low <= cos (Radians degrees)).
  { apply (Rle_trans _ (cos b)); [pose proof (CosLower b B2); lra|].
    apply cos_decr_1; lra. }
  assert (Q : 0 < IZR (n + d)) by (apply IZR_lt; lia).
  apply (Rle_trans _ _ _ Hl). apply Rmult_le_compat_l; [lra|].
  apply pow_incr. lra.
Qed.

Ltac by_cosine low :=
  apply (CotangentBy _ _ _ low);
  first [lia | lra | cbv zeta; lra | rewrite plus_IZR; lra].

(** Both bounds, the greater by what it lacks of 180: [low] and [low'] are lower bounds
    of the cosines of the lesser and of what is lacking. *)
Ltac by_cosines lacking low low' :=
  apply (DegreesBounds _ _ _ lacking); [by_cosine low|by_cosine low'|lra].

(** [bounds] says it in cotangents, and [convert] makes degrees of these. *)
Ltac in_degrees convert bounds := intros; eapply convert, bounds; eassumption.

Lemma Cotangent10_77 : Cotangent (CotSq 221 8) (1077 / 100).
Proof. by_cosine (98238131 / 100000000). Qed.
Lemma Cotangent15_24 : Cotangent (CotSq 1751 130) (1524 / 100).
Proof. by_cosine (96482917 / 100000000). Qed.
Lemma Cotangent9_27 : Cotangent (CotSq 563 15) (927 / 100).
Proof. by_cosine (98693953 / 100000000). Qed.
Lemma Cotangent18_54 : Cotangent (CotSq 80 9) (1854 / 100).
Proof. by_cosine (94809629 / 100000000). Qed.

(** Two angles whose cosines are known. *)
Lemma CosineSquared30 : (cos (Radians 30)) ^ 2 = 3 / 4.
Proof.
  unfold Radians. replace (30 * PI / 180) with (PI / 6) by field. rewrite cos_PI6.
  replace ((sqrt 3 / 2) ^ 2) with (sqrt 3 * sqrt 3 / 4) by field.
  rewrite sqrt_sqrt by lra. reflexivity.
Qed.

Lemma CosineSquared45 : (cos (Radians 45)) ^ 2 = 1 / 2.
Proof.
  unfold Radians. replace (45 * PI / 180) with (PI / 4) by field. rewrite cos_PI4.
  assert (P : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  replace ((1 / sqrt 2) ^ 2) with (/ (sqrt 2 * sqrt 2)) by (field; lra).
  rewrite sqrt_sqrt by lra. lra.
Qed.

(** n/d is the square of the cotangent of the angle. *)
Definition CotangentIs (n d : Z) (degrees : R) : Prop :=
  0 < degrees < 90 /\ (0 <= n)%Z /\ (0 < d)%Z /\
  IZR (n + d) * (cos (Radians degrees)) ^ 2 = IZR n.

Lemma CotangentIs30 : CotangentIs 3 1 30.
Proof.
  unfold CotangentIs. rewrite CosineSquared30. change (3 + 1)%Z with 4%Z.
  repeat split; lra || lia.
Qed.
Lemma CotangentIs45 : CotangentIs 1 1 45.
Proof.
  unfold CotangentIs. rewrite CosineSquared45. change (1 + 1)%Z with 2%Z.
  repeat split; lra || lia.
Qed.

Lemma CotangentExactly n d degrees :
  CotangentIs n d degrees -> Cotangent (CotSq n d) degrees.
Proof. intros (B & N & D & E). repeat (split; [assumption|]). lra. Qed.

(** ** In degrees *)

Lemma WidestInDegrees t :
  WellShaped WidestAngles t -> WithinDegrees (1077 / 100) (16476 / 100) t.
Proof. apply (DegreesBounds _ _ _ _ _ t Cotangent10_77 Cotangent15_24). lra. Qed.

Lemma EmbeddingInDegrees t :
  WellShaped EmbeddingAngles t -> WithinDegrees (927 / 100) (16146 / 100) t.
Proof. apply (DegreesBounds _ _ _ _ _ t Cotangent9_27 Cotangent18_54). lra. Qed.

Lemma MidpointInDegrees t : WellShaped MidpointAngles t -> WithinDegrees 30 135 t.
Proof.
  apply (DegreesBounds _ _ _ _ _ t (CotangentExactly _ _ _ CotangentIs30)
           (CotangentExactly _ _ _ CotangentIs45)). lra.
Qed.

Theorem DihedralBoundsInDegrees sign cut tid t : CutsOnEdges sign cut ->
  In t (StuffedTets AngleThresholds sign cut tid) ->
  WithinDegrees (1077 / 100) (16476 / 100) t.
Proof. intros C I. exact (WidestInDegrees t (StuffedWidest sign cut tid t C I)). Qed.

Theorem DihedralBoundsEmbeddingInDegrees sign cut tid t : CutsOnEdges sign cut ->
  In t (StuffedTets EmbeddingThresholds sign cut tid) ->
  WithinDegrees (927 / 100) (16146 / 100) t.
Proof.
  intros C I. exact (EmbeddingInDegrees t (StuffedEmbedding sign cut tid t C I)).
Qed.

Theorem NoSurfaceBoundsInDegrees sign tid t : (forall v, sign v <> OnSurface) ->
  In t (StuffedTets NoWarpThresholds sign (fun _ _ => MidpointCut) tid) ->
  WithinDegrees 30 135 t.
Proof. intros N I. exact (MidpointInDegrees t (StuffedMidpoint sign tid t N I)). Qed.

Theorem MidpointBoundsInDegrees sign tid t :
  let decided v := InOrOut (sign v) in
  In t (StuffedTets NoWarpThresholds decided (fun _ _ => MidpointCut) tid) ->
  WithinDegrees 30 135 t.
Proof. apply NoSurfaceBoundsInDegrees. intros v. apply InOrOutDecides. Qed.
