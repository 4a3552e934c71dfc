(** * The bounds are sharp within 0.02 degrees: proofs *)

From Coq Require Import ZArith Reals List Bool Lra Lia.
From Certet Require Import Lattice.Definitions Stencil.Definitions
  Warp.Definitions Stuffing.Definitions Angles.Definitions.
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
  cbv zeta in Hb. pose proof PILower as PL. pose proof PIUpper as PU.
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
  apply IZR_le in Pn. apply IZR_lt in Pd.
  pose proof (RadiansBound _ B) as R.
  assert (Pc : 0 < cos (Radians degrees)) by (apply cos_gt_0; lra).
  assert (Q : 0 < N ^ 2 + D) by nra.
  assert (S : 0 < sqrt (N ^ 2 + D)) by (apply sqrt_lt_R0; exact Q).
  assert (E : sqrt (N ^ 2 + D) * sqrt (N ^ 2 + D) = N ^ 2 + D)
    by (apply sqrt_sqrt; lra).
  unfold Cosine. set (s := sqrt (N ^ 2 + D)) in *.
  set (c := cos (Radians degrees)) in *.
  assert (G : c * s <= N).
  { apply Rsqr_incr_0_var; [|lra]. unfold Rsqr.
    rewrite plus_IZR in C.
    assert (H2 : (IZR n + IZR d) * c ^ 2 * (N ^ 2 + D) <= IZR n * (N ^ 2 + D))
      by (apply Rmult_le_compat_r; lra).
    apply (Rmult_le_reg_l (IZR n + IZR d)); [lra|].
    replace (c * s * (c * s)) with (c ^ 2 * (s * s)) by ring.
    rewrite E. nra. }
  apply (Rmult_le_reg_r s); [exact S|].
  replace (N / s * s) with N by (field; lra). exact G.
Qed.

Lemma AcosAtMost x a : -1 <= x <= 1 -> 0 <= a <= PI -> cos a <= x -> acos x <= a.
Proof.
  intros Bx Ba H. destruct (Rle_dec (acos x) a) as [L|L]; [exact L|exfalso].
  apply Rnot_le_lt in L. pose proof (acos_bound x) as B.
  pose proof (cos_decreasing_1 a (acos x) ltac:(lra) ltac:(lra) ltac:(lra)
                ltac:(lra) L) as M.
  rewrite cos_acos in M by exact Bx. lra.
Qed.

Lemma SharperDegrees n d degrees p q r s :
  CotangentOver (CotSq n d) degrees -> (0 < SixVolume p q r s)%Z ->
  Sharper (CotSq n d) (p, q, r, s) = true -> DihedralDegrees p q r s <= degrees.
Proof.
  intros C V T. cbn [Sharper] in T. apply andb_prop in T. destruct T as [T1 T2].
  apply Z.ltb_lt, IZR_lt in T1. apply Z.leb_le, IZR_le in T2.
  destruct (DegreesIsCosine p q r s V) as [PD ->].
  set (D := IZR (SixVolume p q r s ^ 2 * EdgeSquared p q)) in *.
  rewrite (mult_IZR n), (mult_IZR d) in T2. fold D in T2.
  pose proof PI_RGT_0 as PP. pose proof (RadiansBound degrees (proj1 C)) as R.
  pose proof (CosineBound (IZR (NormalsProduct p q r s)) D PD) as B.
  assert (L : acos (Cosine (IZR (NormalsProduct p q r s)) D) <= Radians degrees).
  { apply AcosAtMost; [exact B|lra|].
    apply (CosineAtLeast n d); try assumption. rewrite pow_IZR. exact T2. }
  set (x := acos _) in *. unfold Radians in L.
  assert (K : 0 < 180 * / PI)
    by (apply Rmult_lt_0_compat; [lra|apply Rinv_0_lt_compat, PP]).
  apply (Rmult_le_compat_r (180 * / PI)) in L; [|lra].
  replace (degrees * PI / 180 * (180 * / PI)) with degrees in L by (field; lra).
  replace (x * 180 / PI) with (x * (180 * / PI)) by (field; lra). exact L.
Qed.

Lemma BlunterDegrees n d rest p q r s :
  CotangentOver (CotSq n d) rest -> (0 < SixVolume p q r s)%Z ->
  Blunter (CotSq n d) (p, q, r, s) = true ->
  180 - rest <= DihedralDegrees p q r s.
Proof.
  intros C V T. cbn [Blunter] in T. apply andb_prop in T. destruct T as [T1 T2].
  apply Z.ltb_lt, IZR_lt in T1. apply Z.leb_le, IZR_le in T2.
  destruct (DegreesIsCosine p q r s V) as [PD ->].
  set (D := IZR (SixVolume p q r s ^ 2 * EdgeSquared p q)) in *.
  rewrite (mult_IZR n), (mult_IZR d) in T2. fold D in T2.
  pose proof PI_RGT_0 as PP. pose proof (RadiansBound rest (proj1 C)) as R.
  pose proof (CosineBound (IZR (NormalsProduct p q r s)) D PD) as B.
  assert (L : PI - acos (Cosine (IZR (NormalsProduct p q r s)) D)
              <= Radians rest).
  { rewrite <- acos_opp. apply AcosAtMost; [lra|lra|].
    replace (- Cosine (IZR (NormalsProduct p q r s)) D)
      with (Cosine (- IZR (NormalsProduct p q r s)) D).
    - apply (CosineAtLeast n d); try assumption; [lra|].
      replace ((- IZR (NormalsProduct p q r s)) ^ 2)
        with (IZR (NormalsProduct p q r s) ^ 2) by ring.
      rewrite pow_IZR. exact T2.
    - unfold Cosine.
      replace ((- IZR (NormalsProduct p q r s)) ^ 2)
        with (IZR (NormalsProduct p q r s) ^ 2) by ring.
      unfold Rdiv. ring. }
  set (x := acos _) in *. unfold Radians in L.
  assert (K : 0 < 180 * / PI)
    by (apply Rmult_lt_0_compat; [lra|apply Rinv_0_lt_compat, PP]).
  apply (Rmult_le_compat_r (180 * / PI)) in L; [|lra].
  replace (rest * PI / 180 * (180 * / PI)) with rest in L by (field; lra).
  replace ((PI - x) * (180 * / PI)) with (180 - x * (180 * / PI)) in L
    by (field; lra).
  replace (x * 180 / PI) with (x * (180 * / PI)) by (field; lra). lra.
Qed.

(** ** The four domains *)

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

Ltac by_fraction f :=
  apply (CotangentOverBy _ _ _ f);
  first [lia | lra | cbv zeta; lra | rewrite plus_IZR; lra].

Theorem Sharp_73_102_least : exists sign cut tid t p q r s,
  CutsOnEdges sign cut /\ In t (StuffedTets AngleThresholds sign cut tid) /\
  In (p, q, r, s) (DihedralEdges t) /\ DihedralDegrees p q r s <= 1079 / 100.
Proof.
  assert (C : CutsOnEdges SmallAngleSigns SmallAngleCuts_73_102)
    by (apply CutsOnEdgesTable; reflexivity).
  assert (K : CotangentOver (CotSq 27572 1000) (1079 / 100)) by (by_fraction (98233274 / 100000000)).
  destruct (ExhibitsMeans AngleThresholds SmallAngleSigns SmallAngleCuts_73_102
    (Sharper (CotSq 27572 1000)) ltac:(vm_compute; reflexivity))
    as (t & p & q & r & s & I & J & T).
  exists SmallAngleSigns, SmallAngleCuts_73_102, WitnessTet, t, p, q, r, s.
  repeat (split; [assumption|]). apply (SharperDegrees _ _ _ _ _ _ _ K).
  - exact (EdgeVolume _ t _ _ _ _ (StuffedWidest _ _ _ _ C I) J).
  - exact T.
Qed.

Theorem Sharp_73_102_greatest : exists sign cut tid t p q r s,
  CutsOnEdges sign cut /\ In t (StuffedTets AngleThresholds sign cut tid) /\
  In (p, q, r, s) (DihedralEdges t) /\ 16474 / 100 <= DihedralDegrees p q r s.
Proof.
  assert (C : CutsOnEdges LargeAngleSigns_73_102 LargeAngleCuts_73_102)
    by (apply CutsOnEdgesTable; reflexivity).
  assert (K : CotangentOver (CotSq 13442 1000) (1526 / 100)) by (by_fraction (96475061 / 100000000)).
  destruct (ExhibitsMeans AngleThresholds LargeAngleSigns_73_102
    LargeAngleCuts_73_102 (Blunter (CotSq 13442 1000)) ltac:(vm_compute; reflexivity))
    as (t & p & q & r & s & I & J & T).
  exists LargeAngleSigns_73_102, LargeAngleCuts_73_102, WitnessTet, t, p, q, r, s.
  repeat (split; [assumption|]).
  replace (16474 / 100) with (180 - 1526 / 100) by lra.
  apply (BlunterDegrees _ _ _ _ _ _ _ K).
  - exact (EdgeVolume _ t _ _ _ _ (StuffedWidest _ _ _ _ C I) J).
  - exact T.
Qed.

Theorem Sharp_64_105_least : exists sign cut tid t p q r s,
  CutsOnEdges sign cut /\ In t (StuffedTets EmbeddingThresholds sign cut tid) /\
  In (p, q, r, s) (DihedralEdges t) /\ DihedralDegrees p q r s <= 929 / 100.
Proof.
  assert (C : CutsOnEdges SmallAngleSigns SmallAngleCuts_64_105)
    by (apply CutsOnEdgesTable; reflexivity).
  assert (K : CotangentOver (CotSq 37442 1000) (929 / 100)) by (by_fraction (98689618 / 100000000)).
  destruct (ExhibitsMeans EmbeddingThresholds SmallAngleSigns
    SmallAngleCuts_64_105 (Sharper (CotSq 37442 1000)) ltac:(vm_compute; reflexivity))
    as (t & p & q & r & s & I & J & T).
  exists SmallAngleSigns, SmallAngleCuts_64_105, WitnessTet, t, p, q, r, s.
  repeat (split; [assumption|]). apply (SharperDegrees _ _ _ _ _ _ _ K).
  - exact (EdgeVolume _ t _ _ _ _ (StuffedEmbedding _ _ _ _ C I) J).
  - exact T.
Qed.

Theorem Sharp_64_105_greatest : exists sign cut tid t p q r s,
  CutsOnEdges sign cut /\ In t (StuffedTets EmbeddingThresholds sign cut tid) /\
  In (p, q, r, s) (DihedralEdges t) /\ 16144 / 100 <= DihedralDegrees p q r s.
Proof.
  assert (C : CutsOnEdges LargeAngleSigns_64_105 LargeAngleCuts_64_105)
    by (apply CutsOnEdgesTable; reflexivity).
  assert (K : CotangentOver (CotSq 8877 1000) (1856 / 100)) by (by_fraction (94801031 / 100000000)).
  destruct (ExhibitsMeans EmbeddingThresholds LargeAngleSigns_64_105
    LargeAngleCuts_64_105 (Blunter (CotSq 8877 1000)) ltac:(vm_compute; reflexivity))
    as (t & p & q & r & s & I & J & T).
  exists LargeAngleSigns_64_105, LargeAngleCuts_64_105, WitnessTet, t, p, q, r, s.
  repeat (split; [assumption|]).
  replace (16144 / 100) with (180 - 1856 / 100) by lra.
  apply (BlunterDegrees _ _ _ _ _ _ _ K).
  - exact (EdgeVolume _ t _ _ _ _ (StuffedEmbedding _ _ _ _ C I) J).
  - exact T.
Qed.

Definition BoundsAreSharp :=
  conj Sharp_73_102_least (conj Sharp_73_102_greatest
    (conj Sharp_64_105_least Sharp_64_105_greatest)).
