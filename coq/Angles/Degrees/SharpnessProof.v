(** * The bounds are sharp within 0.02 degrees: proofs *)

From Coq Require Import Reals Lra.
From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.Forms.CheckerProof
  Angles.AngleTheorems Angles.Degrees.DegreesProof Angles.Degrees.Witnesses.
Open Scope R_scope.

(** n/d is at least the square of the cotangent of the angle. *)
Definition CotangentOver (k : CotSquared) (degrees : R) : Prop :=
  match k with
    CotSq n d =>
      0 < degrees < 90 /\ (0 <= n)%Z /\ (0 < d)%Z /\
      IZR (n + d) * (cos (Radians degrees)) ^ 2 <= IZR n
  end.

Lemma CotangentOverBy n d degrees (high : R) :
  0 < degrees < 90 -> (0 <= n)%Z -> (0 < d)%Z ->
  (let b := degrees * (31415 / 10000) / 180 in
   1 - b ^ 2 / 2 + b ^ 4 / 24 <= high) ->
  IZR (n + d) * high ^ 2 <= IZR n ->
  CotangentOver (CotSq n d) degrees.
Proof.
  intros B Pn Pd Hb Hh. repeat (split; [assumption|]).
  cbv zeta in Hb. pose proof PIBetween as [PL PU].
  pose proof (RadiansBound degrees B) as R.
  set (b := degrees * (31415 / 10000) / 180) in *.
  assert (L : b <= Radians degrees) by (unfold Radians, b; nra).
  assert (Hb2 : 0 <= b <= 2) by (unfold b; lra).
  assert (C : cos (Radians degrees) <= high).
  { apply (Rle_trans _ (cos b)); [|pose proof (CosUpper b Hb2); lra].
    apply cos_decr_1; lra. }
  assert (P : 0 < cos (Radians degrees)) by (apply cos_gt_0; lra).
  assert (Q : 0 < IZR (n + d)) by (apply IZR_lt; lia).
  refine (Rle_trans _ _ _ _ Hh). apply Rmult_le_compat_l; [lra|].
  apply pow_incr. lra.
Qed.

Lemma CosineAtLeast n d degrees N D :
  CotangentOver (CotSq n d) degrees -> 0 < D ->
  0 < N -> IZR n * D <= IZR d * N ^ 2 ->
  cos (Radians degrees) <= Cosine N D.
Proof.
  intros (B & Pn & Pd & C) P PN H.
  apply IZR_le in Pn. apply IZR_lt in Pd. apply (CosineCompared N D _ P).
  destruct (Hypotenuse N D P) as (Q & S & E). pose proof (CosinePositive _ B) as Pc.
  set (s := sqrt (N ^ 2 + D)) in *. set (c := cos (Radians degrees)) in *.
  apply Rsqr_incr_0_var; [|lra]. unfold Rsqr. rewrite plus_IZR in C.
  assert (H2 : (IZR n + IZR d) * c ^ 2 * (N ^ 2 + D) <= IZR n * (N ^ 2 + D))
    by (apply Rmult_le_compat_r; lra).
  apply (Rmult_le_reg_l (IZR n + IZR d)); [lra|].
  replace (c * s * (c * s)) with (c ^ 2 * (s * s)) by ring.
  rewrite E. nra.
Qed.

Lemma AcosAtMost x a : -1 <= x <= 1 -> 0 <= a <= PI -> cos a <= x -> acos x <= a.
Proof.
  intros Bx Ba H. destruct (Rle_dec (acos x) a) as [L|L]; [exact L|exfalso].
  apply Rnot_le_lt in L. pose proof (acos_bound x) as B.
  pose proof (cos_decreasing_1 a (acos x) ltac:(lra) ltac:(lra) ltac:(lra)
                ltac:(lra) L) as M.
  rewrite cos_acos in M by exact Bx. lra.
Qed.

(** What [Sharper] and [Blunter] have compared, in real numbers. *)
Lemma AcosAtMostBy n d degrees N D :
  CotangentOver (CotSq n d) degrees -> 0 < D ->
  0 < N -> IZR n * D <= IZR d * N ^ 2 ->
  acos (Cosine N D) <= Radians degrees.
Proof.
  intros C P PN H. pose proof (RadiansBound degrees (proj1 C)) as R.
  apply AcosAtMost; [exact (CosineBound N D P)|lra|].
  exact (CosineAtLeast n d degrees N D C P PN H).
Qed.

Lemma SharperDegrees n d degrees p q r s :
  CotangentOver (CotSq n d) degrees -> (0 < SixVolume p q r s)%Z ->
  Sharper (CotSq n d) (p, q, r, s) = true -> DihedralDegrees p q r s <= degrees.
Proof.
  intros C V T. cbn [Sharper] in T. apply andb_prop in T. destruct T as [T1 T2].
  apply Z.ltb_lt, IZR_lt in T1. apply Z.leb_le, IZR_le in T2.
  destruct (DegreesIsCosine p q r s V) as [PD ->].
  rewrite (mult_IZR n), (mult_IZR d) in T2. apply DegreesAtMost.
  apply (AcosAtMostBy n d); try assumption. rewrite pow_IZR. exact T2.
Qed.

Lemma BlunterDegrees n d rest p q r s :
  CotangentOver (CotSq n d) rest -> (0 < SixVolume p q r s)%Z ->
  Blunter (CotSq n d) (p, q, r, s) = true ->
  180 - rest <= DihedralDegrees p q r s.
Proof.
  intros C V T. cbn [Blunter] in T. apply andb_prop in T. destruct T as [T1 T2].
  apply Z.ltb_lt, IZR_lt in T1. apply Z.leb_le, IZR_le in T2.
  destruct (DegreesIsCosine p q r s V) as [PD ->]. apply DegreesAtLeast.
  pose proof (CosineBound (IZR (NormalsProduct p q r s)) _ PD) as B.
  rewrite RadiansRest, <- (Ropp_involutive (IZR (NormalsProduct p q r s))).
  rewrite CosineOpposite, acos_opp.
  apply Rplus_le_compat_l, Ropp_le_contravar, (AcosAtMostBy n d);
    [assumption..|lra|].
  rewrite (mult_IZR n), (mult_IZR d) in T2.
  replace ((- IZR (NormalsProduct p q r s)) ^ 2)
    with (IZR (NormalsProduct p q r s) ^ 2) by ring.
  rewrite pow_IZR. exact T2.
Qed.

(** ** Exhibits *)

Lemma CutsOnEdgesTable sign table :
  forallb (fun e => (0 <=? snd e) && (snd e <=? Steps))%Z table = true ->
  CutsOnEdges sign (CutTable table).
Proof.
  intros T a b _ _. unfold CutTable.
  destruct (find _ table) as [e|] eqn:F.
  - apply find_some in F. destruct F as [I _].
    rewrite forallb_forall in T. specialize (T e I).
    apply andb_prop in T. rewrite !Z.leb_le in T. exact T.
  - change MidpointCut with 32768%Z. change Steps with 65536%Z. lia.
Qed.

Lemma SomeEdge (ts : list (UnstructuredTet Coord3)) test :
  existsb (fun t => existsb test (DihedralEdges t)) ts = true ->
  exists t p q r s, In t ts /\ In (p, q, r, s) (DihedralEdges t) /\
    test (p, q, r, s) = true.
Proof.
  intros T. apply existsb_exists in T.
  destruct T as (t & I & T). apply existsb_exists in T.
  destruct T as ([[[p q] r] s] & J & T). exists t, p, q, r, s. auto.
Qed.

Lemma ExhibitsMeans th sign cut test : Exhibits th sign cut test = true ->
  exists t p q r s, In t (StuffedTets th sign cut WitnessTet) /\
    In (p, q, r, s) (DihedralEdges t) /\ test (p, q, r, s) = true.
Proof. exact (SomeEdge (StuffedTets th sign cut WitnessTet) test). Qed.

Lemma EdgeVolume bounds t p q r s : WellShaped bounds t ->
  In (p, q, r, s) (DihedralEdges t) -> (0 < SixVolume p q r s)%Z.
Proof.
  destruct bounds as [acute obtuse], t as [a b c d]. intros [V _] I.
  rewrite (EvenOrders _ _ _ _ _ _ _ _ I). exact V.
Qed.

(** One of the dihedral angles of these tetrahedra is such a number of degrees. *)
Definition HasAngle (P : R -> Prop) (ts : list (UnstructuredTet Coord3)) : Prop :=
  exists t p q r s, In t ts /\ In (p, q, r, s) (DihedralEdges t) /\
    P (DihedralDegrees p q r s).

Section Exhibited.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Variables (bounds : AngleBounds) (n d : Z) (degrees : R).
  Local Notation tets := (StuffedTets th sign cut WitnessTet).
  Hypothesis Shaped : forall t, In t tets -> WellShaped bounds t.
  Hypothesis Over : CotangentOver (CotSq n d) degrees.

  Lemma Exhibited test (P : R -> Prop) :
    (forall p q r s, (0 < SixVolume p q r s)%Z -> test (p, q, r, s) = true ->
       P (DihedralDegrees p q r s)) ->
    Exhibits th sign cut test = true -> HasAngle P tets.
  Proof.
    intros T E. apply ExhibitsMeans in E as (t & p & q & r & s & I & J & H).
    exists t, p, q, r, s. repeat (split; [assumption|]).
    exact (T p q r s (EdgeVolume _ t _ _ _ _ (Shaped t I) J) H).
  Qed.

  Lemma ExhibitsLeast : Exhibits th sign cut (Sharper (CotSq n d)) = true ->
    HasAngle (fun x => x <= degrees) tets.
  Proof. apply Exhibited. intros p q r s. exact (SharperDegrees n d _ p q r s Over). Qed.

  Lemma ExhibitsGreatest : Exhibits th sign cut (Blunter (CotSq n d)) = true ->
    HasAngle (fun x => 180 - degrees <= x) tets.
  Proof. apply Exhibited. intros p q r s. exact (BlunterDegrees n d _ p q r s Over). Qed.
End Exhibited.

(** ** The four domains *)

(** Some signs and cuts on edges have such an angle. *)
Definition Reached (th : Thresholds) (P : R -> Prop) : Prop :=
  exists sign cut tid t p q r s,
    CutsOnEdges sign cut /\ In t (StuffedTets th sign cut tid) /\
    In (p, q, r, s) (DihedralEdges t) /\ P (DihedralDegrees p q r s).

Lemma ReachedBy th sign cut (P : R -> Prop) : CutsOnEdges sign cut ->
  (CutsOnEdges sign cut -> HasAngle P (StuffedTets th sign cut WitnessTet)) ->
  Reached th P.
Proof.
  intros C A. destruct (A C) as (t & p & q & r & s & H).
  exists sign, cut, WitnessTet, t, p, q, r, s. exact (conj C H).
Qed.

Ltac by_fraction f :=
  apply (CotangentOverBy _ _ _ f);
  first [lia | lra | cbv zeta; lra | rewrite plus_IZR; lra].

(** By which test an exhibit is found, the shape that all tetrahedra there have,
    and a bound above the cosine, in hundred millionths. *)
Ltac exhibit found bounds n shape high :=
  apply (found _ _ _ bounds n 1000%Z);
    [intros t I; eapply shape; eassumption|by_fraction (high / 100000000)|
     vm_compute; reflexivity].

(** Of which signs and cuts, too. *)
Ltac reach signs cuts found bounds n shape high :=
  apply (ReachedBy _ signs cuts);
    [apply CutsOnEdgesTable; reflexivity|intros; exhibit found bounds n shape high].

(** Within 0.02 degrees of the bounds. *)
Definition Sharply (reached : Thresholds -> (R -> Prop) -> Prop) : Prop :=
  reached AngleThresholds (fun x => x <= 1079 / 100) /\
  reached AngleThresholds (fun x => 16474 / 100 <= x) /\
  reached EmbeddingThresholds (fun x => x <= 929 / 100) /\
  reached EmbeddingThresholds (fun x => 16144 / 100 <= x).

Lemma SharplyBy (reached : Thresholds -> (R -> Prop) -> Prop) :
  reached AngleThresholds (fun x => x <= 1079 / 100) ->
  reached AngleThresholds (fun x => 180 - 1526 / 100 <= x) ->
  reached EmbeddingThresholds (fun x => x <= 929 / 100) ->
  reached EmbeddingThresholds (fun x => 180 - 1856 / 100 <= x) ->
  Sharply reached.
Proof.
  unfold Sharply. replace (16474 / 100) with (180 - 1526 / 100) by lra.
  replace (16144 / 100) with (180 - 1856 / 100) by lra. auto.
Qed.

Theorem BoundsAreSharp : Sharply Reached.
Proof.
  apply SharplyBy.
  - reach SmallAngleSigns SmallAngleCuts_73_102 ExhibitsLeast WidestAngles 27572%Z StuffedWidest 98233274.
  - reach LargeAngleSigns_73_102 LargeAngleCuts_73_102 ExhibitsGreatest WidestAngles 13442%Z StuffedWidest 96475061.
  - reach SmallAngleSigns SmallAngleCuts_64_105 ExhibitsLeast EmbeddingAngles 37442%Z StuffedEmbedding 98689618.
  - reach LargeAngleSigns_64_105 LargeAngleCuts_64_105 ExhibitsGreatest EmbeddingAngles 8877%Z StuffedEmbedding 94801031.
Qed.
