(** * Near the surface a graded mesh is the lattice: proofs *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Mesh.Method.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet
  Grading.Surface Grading.GradingSpec.
From Certet Require Import Grading.FlagProof Grading.BalanceProof
  Grading.PartitionProof.
Open Scope Z_scope.

(** ** Where all is inside *)

Section Surface.
  Variable sign : SignField.
  Variable cells : CellSet.
  Hypothesis Balance : IsBalanced cells.
  Hypothesis Kept : KeepsSurface sign cells.

  Lemma MissingPoints c v : cells O c = false -> In v (PointsOfCell c) -> sign v = Plus.
  Proof.
    intros E I. destruct (IsNearSurface sign c) eqn:N; [rewrite (Kept c N) in E; discriminate|].
    unfold IsNearSurface in N. apply negb_false_iff in N. rewrite forallb_forall in N.
    apply N in I. destruct (sign v); [reflexivity | discriminate ..].
  Qed.

  Lemma InPoints c d : In (Translate (CentreInHalfSides c) (Offset d)) (PointsOfCell c).
  Proof.
    right. apply (in_map (fun e => Translate (CentreInHalfSides c) (Offset e))).
    destruct d; cbn; tauto.
  Qed.

  Lemma ShortStep x y z : x = 1 \/ x = -1 -> y = 1 \/ y = -1 -> z = 1 \/ z = -1 ->
    exists d, Offset d = C3 x y z.
  Proof.
    intros [-> | ->] [-> | ->] [-> | ->];
      [exists Dir_ppp | exists Dir_ppm | exists Dir_pmp | exists Dir_pmm
      |exists Dir_mpp | exists Dir_mpm | exists Dir_mmp | exists Dir_mmm]; reflexivity.
  Qed.

  Lemma LongStep o x : x = 2 \/ x = -2 -> exists d, Offset d = Arrange o x 0 0.
  Proof.
    intros [-> | ->]; destruct o;
      [exists Dir_p00 | exists Dir_p00 | exists Dir_0p0 | exists Dir_0p0
      |exists Dir_00p | exists Dir_00p
      |exists Dir_m00 | exists Dir_m00 | exists Dir_0m0 | exists Dir_0m0
      |exists Dir_00m | exists Dir_00m]; reflexivity.
  Qed.

  Lemma CornerStep o x y z : x = 1 \/ x = -1 -> y = 1 \/ y = -1 -> z = 1 \/ z = -1 ->
    exists d, Offset d = Arrange o x y z.
  Proof. intros. destruct o; apply ShortStep; assumption. Qed.

  (** The points of a flag that its cell of level 0 looks at. *)
  Lemma NearPoints x i j k : LevelOf x = O ->
    i = 0 /\ j = 0 /\ k = 0 \/
    (i = 1 \/ i = -1) /\ (j = 1 \/ j = -1) /\ (k = 1 \/ k = -1) \/
    (i = 2 \/ i = -2) /\ j = 0 /\ k = 0 ->
    In (PointSeen x i j k) (PointsOfCell (CellOf x)).
  Proof.
    intros L H. unfold PointSeen. rewrite L. change (HalfSide 0) with 1.
    assert (One : forall p, Scale 1 p = p) by (intros []; cbn [Scale]; f_equal; ring).
    rewrite One. unfold PointInHalfSides.
    destruct x as [level c o s t u]. cbn [CellOf StepFrom].
    assert (N : forall r : bool, Signed r 0 = 0) by (intros []; reflexivity).
    destruct H as [(-> & -> & ->) | [(I & J & K) | (I & -> & ->)]].
    - rewrite !N. left. destruct c, o; cbn [CentreInHalfSides Translate Scale Arrange];
        f_equal; ring.
    - destruct (CornerStep o (Signed s i) (Signed t j) (Signed u k)) as [d <-];
        [destruct s; cbn [Signed]; lia | destruct t; cbn [Signed]; lia
        |destruct u; cbn [Signed]; lia | apply InPoints].
    - rewrite !N. destruct (LongStep o (Signed s i)) as [d <-];
        [destruct s; cbn [Signed]; lia | apply InPoints].
  Qed.

  (** No cell of level 0 lies within one that does not exist, so that its corners
      are inside. *)
  Lemma MissingCorners level : forall c d, cells level c = false -> In d UnitCube ->
    sign (Scale (HalfSide (S level)) (Translate c d)) = Plus.
  Proof.
    induction level as [|l IH]; intros c d E I.
    - apply (MissingPoints c _ E).
      assert (exists e, Scale (HalfSide 1) (Translate c d)
                        = Translate (CentreInHalfSides c) (Offset e)) as [e ->];
        [|apply InPoints].
      change (HalfSide 1) with 2. destruct c as [x y z], d as [a b e].
      destruct (ShortStep (2 * a - 1) (2 * b - 1) (2 * e - 1)) as [g G];
        try (apply (InCube XYZ a b e) in I; lia).
      exists g. rewrite G. unfold CentreInHalfSides. cbn [Translate Scale]. f_equal; ring.
    - assert (F : cells l (Translate (Scale 2 c) d) = false).
      { apply not_true_is_false. intros F.
        pose proof (Balance l _ (C3 0 0 0) ltac:(cbn; lia) F) as G.
        replace (ParentCell (Translate (Translate (Scale 2 c) d) (C3 0 0 0))) with c in G
          by (destruct c as [x y z], d as [a b e]; apply (InCube XYZ a b e) in I;
              cbn [Translate Scale ParentCell]; f_equal;
              euclid).
        congruence. }
      pose proof (IH _ _ F I) as P. rewrite <- P. f_equal.
      rewrite (HalfSideUp (S l)). destruct c, d. cbn [Translate Scale]. f_equal; ring.
  Qed.

  (** Above level 0 all four points of a flag are. *)
  Lemma CoarsePoints x l i j k : LevelOf x = S l -> IsPresent cells x = true ->
    0 <= i <= 1 -> 0 <= j <= 1 -> 0 <= k <= 1 -> sign (PointSeen x i j k) = Plus.
  Proof.
    intros L P Bi Bj Bk. apply PresentTells in P. destruct P as [_ E].
    rewrite L in E. cbn [HasChild] in E.
    destruct x as [level v o s t u]. cbn [LevelOf] in L. subst level.
    rewrite <- (MissingCorners l _ (Arrange o (ChildAlong s i) (ChildAlong t j) (ChildAlong u k)) E).
    - f_equal. destruct (Arranged o v) as (a & b & c & ->). arrange. cbn [LevelOf].
      apply SameArrange; signs.
    - apply InCube. destruct s, t, u; cbn [ChildAlong]; lia.
  Qed.

  (** Every vertex is such a point of a flag of its tetrahedron. *)
  Lemma VertexOfFlag tid p : exists z i j k,
    In z (FlagsOf tid) /\ GradedVertexAt tid p = PointSeen z i j k /\
    0 <= i <= 1 /\ 0 <= j <= 1 /\ 0 <= k <= 1.
  Proof.
    assert (goal : forall l v (z : Flag) i j k, In z l -> v = PointSeen z i j k ->
      0 <= i <= 1 -> 0 <= j <= 1 -> 0 <= k <= 1 ->
      exists z i j k, In z l /\ v = PointSeen z i j k /\
        0 <= i <= 1 /\ 0 <= j <= 1 /\ 0 <= k <= 1) by eauto 12.
    assert (low : forall x, PointSeen x 1 1 (-1) = PointSeen (OtherCorner x) 1 1 1)
      by (intros; now rewrite SeenByCorner).
    assert (beyond : forall x, PointSeen x 2 0 0 = PointSeen (OtherCell x) 0 0 0)
      by (intros; now rewrite SeenByCell).
    assert (aside : forall x, PointSeen x 1 (-1) 1
                    = PointSeen (OtherCorner (OtherEdge x)) 1 1 1)
      by (intros; now rewrite SeenByCorner, SeenByEdge).
    unfold GradedVertexAt.
    destruct tid as [[] x]; cbn [GradedVertices FlagsOf]; rewrite ?low, ?beyond, ?aside;
      destruct p; try (destruct (IsUpperEdge x)); cbn [Pick];
      (eapply goal; [| reflexivity | lia ..]); cbn [In]; tauto.
  Qed.

  Lemma Level0Kind x : LevelOf x = O ->
    KindAt cells x = BccTet \/ KindAt cells x = PyramidTet.
  Proof.
    intros L. unfold KindAt. rewrite L. cbn [IsUsed].
    destruct (cells O (CellSeen x 1 0 0)); auto.
  Qed.

  Lemma PyramidPoints x i j k : LevelOf x = O ->
    cells O (CellSeen x 1 0 0) = false ->
    (i = 1 /\ (j = 1 \/ j = -1) /\ (k = 1 \/ k = -1) \/ i = 0 /\ j = 0 /\ k = 0) ->
    sign (PointSeen x i j k) = Plus.
  Proof.
    intros L E H. apply (MissingPoints _ _ E).
    replace (PointSeen x i j k) with (PointSeen (OtherCell x) (2 - i) j k)
      by (rewrite SeenByCell; f_equal; ring).
    rewrite <- CellOfCell. apply NearPoints; [now rewrite LevelByCell|]. lia.
  Qed.

  Lemma TouchedIsBcc tid p : InGradedMesh cells tid ->
    sign (GradedVertexAt tid p) <> Plus ->
    exists x, tid = GTId BccTet x /\ LevelOf x = O.
  Proof.
    destruct tid as [kind x]. intros M N. destruct (NamedBy _ _ _ M) as (P & K & _).
    destruct (LevelOf x) as [|l] eqn:L.
    - destruct (Level0Kind x L) as [B | B]; rewrite B in K; subst kind; [eauto|].
      exfalso. apply N. pose proof (KindTells cells x) as T. rewrite B in T.
      unfold AcrossExists in T. rewrite L in T. unfold GradedVertexAt.
      destruct p; cbn [GradedVertices Pick]; apply PyramidPoints; auto.
    - exfalso. apply N.
      destruct (VertexOfFlag (GTId kind x) p) as (z & i & j & k & I & -> & Bi & Bj & Bk).
      pose proof (FlagBeside cells Balance _ _ _ M I) as (Pz & _).
      apply (CoarsePoints z l); try assumption.
      destruct kind; cbn [FlagsOf In] in I;
        repeat (destruct I as [<- | I];
          [rewrite ?LevelByCorner, ?LevelByCell, ?LevelByEdge, ?LevelByCorner; exact L|]);
        destruct I.
  Qed.
End Surface.

(** ** Structured tetrahedra *)

Lemma StructuredVertices c o t p :
  let x := MakeFlag O c o true t true in
  GradedVertexAt (GTId BccTet x) p = VertexAt (GetStructuredTet (StructuredOf x)) p.
Proof.
  destruct c as [a b e]. cbv zeta.
  destruct o, t, p; unfold GradedVertexAt, PointSeen, PointInHalfSides, CentreInHalfSides;
    cbn [GradedVertices IsUpperEdge Pick StructuredOf GetStructuredTet VertexAt LevelOf CellOf
      StepFrom];
    unfold PointSeen, PointInHalfSides, CentreInHalfSides;
    cbn [Arrange Signed StepFrom CellOf LevelOf Translate Scale];
    change (HalfSide 0) with 1; f_equal; ring.
Qed.

Lemma StructuredHand c o t :
  let x := MakeFlag O c o true t true in
  GradedHandedness (GTId BccTet x)
  = match StructuredOf x with STId _ case => CaseHandedness case end.
Proof. destruct o, t; reflexivity. Qed.

Lemma StructuredInLattice x : InLattice (StructuredOf x).
Proof.
  assert (E : forall n, Z.Even (2 * n + 0)) by (intros n; exists n; ring).
  assert (F : forall n, Z.Even (2 * n + -2)) by (intros n; exists (n - 1); ring).
  destruct x as [level [a b e] o s t u].
  destruct o, t; cbn [StructuredOf Arrange Translate Scale InLattice IsEven];
    (split; [|split]); apply E || apply F.
Qed.

(** A named flag of a tetrahedron of the first kind. *)
Lemma BccName x : NamingFlag BccTet x = x ->
  exists level c o t, x = MakeFlag level c o true t true.
Proof.
  destruct x as [level c o s t u]. cbn [NamingFlag]. intros N.
  assert (u = true).
  { destruct s; cbn [WithLowerCell OtherCell WithUpperCorner OtherCorner] in N;
      destruct u; congruence || discriminate. }
  subst u. destruct s; [eauto|].
  cbn [WithLowerCell OtherCell WithUpperCorner negb] in N. congruence.
Qed.

Theorem TouchedTetsPlain :
  forall sign cells tid i,
    IsOctree cells -> KeepsSurface sign cells -> InGradedMesh cells tid ->
    sign (GradedVertexAt tid i) <> Plus ->
    exists stid, StructuredName tid = Some stid.
Proof.
  intros sign cells tid i [balance _] kept M N.
  destruct (TouchedIsBcc sign cells balance kept tid i M N) as (x & -> & L).
  destruct x as [level c o s t u]. cbn [LevelOf] in L. subst level.
  eexists. reflexivity.
Qed.

Theorem StructuredNameCorrect :
  forall cells tid stid,
    InGradedMesh cells tid -> StructuredName tid = Some stid ->
    InLattice stid /\
    (forall i, GradedVertexAt tid i = VertexAt (GetStructuredTet stid) i) /\
    GradedHandedness tid
    = match stid with STId _ case => CaseHandedness case end.
Proof.
  intros cells [kind x] stid M E. destruct (NamedBy _ _ _ M) as (_ & _ & N).
  destruct kind; try discriminate E. destruct (BccName x N) as (level & c & o & t & ->).
  destruct level as [|l]; [|discriminate E]. cbn [StructuredName] in E. injection E as <-.
  split; [exact (StructuredInLattice (MakeFlag O c o true t true)) | split].
  - intros i. exact (StructuredVertices c o t i).
  - exact (StructuredHand c o t).
Qed.

(** The flag of a structured tetrahedron. *)
Lemma StructuredFlag stid : InLattice stid ->
  exists c o t, StructuredOf (MakeFlag O c o true t true) = stid.
Proof.
  destruct stid as [[x y z] case]. intros ([a ->] & [b ->] & [e ->]).
  assert (exists o t, forall c, StructuredOf (MakeFlag O c o true t true)
    = STId (Translate (Scale 2 c) (Arrange o 0 (if t then 0 else -2) 0)) case)
    as (o & t & S).
  { destruct case;
      [exists ZYX, false | exists YZX, true | exists YZX, false | exists ZYX, true
      |exists ZXY, false | exists XZY, true | exists XZY, false | exists ZXY, true
      |exists YXZ, false | exists XYZ, true | exists XYZ, false | exists YXZ, true];
      reflexivity. }
  exists (Translate (C3 a b e) (Arrange o 0 (if t then 0 else 1) 0)), o, t. rewrite S.
  f_equal. destruct o, t; cbn [Translate Scale Arrange]; f_equal; ring.
Qed.

Theorem SurfaceKept :
  forall sign cells stid i,
    IsOctree cells -> KeepsSurface sign cells -> InLattice stid ->
    sign (VertexAt (GetStructuredTet stid) i) <> Plus ->
    exists tid, InGradedMesh cells tid /\ StructuredName tid = Some stid.
Proof.
  intros sign cells stid i [balance _] kept even N.
  destruct (StructuredFlag stid even) as (c & o & t & S).
  set (x := MakeFlag O c o true t true) in *.
  pose proof (StructuredVertices c o t i) as V. fold x in V. cbv zeta in V.
  rewrite S in V. rewrite <- V in N.
  assert (L : LevelOf x = O) by reflexivity.
  assert (E : forall p, In (GradedVertexAt (GTId BccTet x) i) (PointsOfCell p) ->
    cells O p = true).
  { intros p I. apply not_false_is_true. intros F.
    apply N. exact (MissingPoints sign cells kept p _ F I). }
  assert (near : In (GradedVertexAt (GTId BccTet x) i) (PointsOfCell (CellOf x)) /\
                 In (GradedVertexAt (GTId BccTet x) i) (PointsOfCell (CellOf (OtherCell x)))).
  { assert (back : forall i j k, PointSeen x i j k = PointSeen (OtherCell x) (2 - i) j k)
      by (intros; rewrite SeenByCell; f_equal; ring).
    unfold GradedVertexAt. cbn [GradedVertices].
    split; destruct i, (IsUpperEdge x); cbn [Pick];
      [.. | rewrite back | rewrite back | rewrite back | rewrite back
      | rewrite back | rewrite back | rewrite back | rewrite back];
      (apply NearPoints; [reflexivity | lia]). }
  destruct near as [I J]. apply E in I, J. rewrite CellOfCell in J.
  exists (GTId BccTet x). split; [|cbn [StructuredName]; now rewrite <- S].
  split.
  - unfold IsPresent. rewrite L. cbn [HasChild]. rewrite I. reflexivity.
  - unfold TetOfFlag, KindAt. rewrite L, J. reflexivity.
Qed.

Lemma Coordinates a b c d e f : C3 a b c = C3 d e f -> a = d /\ b = e /\ c = f.
Proof. intros [=]. auto. Qed.

(** No two are the same structured tetrahedron. *)
Theorem StructuredNameUnique :
  forall cells tid other stid,
    InGradedMesh cells tid -> InGradedMesh cells other ->
    StructuredName tid = Some stid -> StructuredName other = Some stid ->
    other = tid.
Proof.
  intros cells [kind x] [kind' y] stid M M' E E'.
  destruct (NamedBy _ _ _ M) as (_ & _ & N). destruct (NamedBy _ _ _ M') as (_ & _ & N').
  destruct kind; try discriminate E. destruct kind'; try discriminate E'.
  destruct (BccName x N) as ([|l] & c & o & t & ->); [|discriminate E].
  destruct (BccName y N') as ([|l] & c' & o' & t' & ->); [|discriminate E'].
  cbn [StructuredName] in E, E'. injection E as E. injection E' as E'.
  rewrite <- E in E'. clear - E'. unfold StructuredOf in E'.
  assert (o' = o /\ t' = t) as [-> ->].
  { injection E' as _ K. destruct o, t, o', t'; discriminate K || auto. }
  injection E' as A. do 2 f_equal.
  destruct c as [a b e], c' as [a' b' e'], o, t; cbn [Translate Scale Arrange] in A;
    apply Coordinates in A; f_equal; lia.
Qed.
