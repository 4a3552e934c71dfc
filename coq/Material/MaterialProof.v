(** * What [GetMaterialTets] looks at

    At its vertices through their materials alone, and at those only by telling
    them apart; the cuts that it asks for lie between different materials. *)

From Certet Require Import Material.Definitions.
Open Scope Z_scope.

Definition Hand (tid : StructuredTetId) : Handedness :=
  match tid with STId _ case => CaseHandedness case end.

(** ** Stencils ask for cuts from + to - alone *)

Lemma StencilsAskFromPlusToMinus (A B : Type) (f : A -> B)
    (SA : A -> Sign) (SB : B -> Sign) (IA : A -> A -> A) (IB : B -> B -> B)
    (v1 v2 v3 v4 : A) :
  let corners := [v1; v2; v3; v4] in
  (forall v, In v corners -> SB (f v) = SA v) ->
  (forall v w, In v corners -> In w corners -> SA v = Plus -> SA w = Minus ->
     IB (f v) (f w) = f (IA v w)) ->
  GetUnstructuredTets B SB IB (f v1) (f v2) (f v3) (f v4)
  = map (MapTet f) (GetUnstructuredTets A SA IA v1 v2 v3 v4).
Proof.
  intros corners S I. unfold corners in *. cbn [In] in *.
  unfold GetUnstructuredTets.
  rewrite (S v1), (S v2), (S v3), (S v4) by tauto. clear S.
  destruct (SA v1) eqn:S1, (SA v2) eqn:S2, (SA v3) eqn:S3, (SA v4) eqn:S4;
    cbn [map MapTet];
    repeat match goal with |- context [IB (f ?v) (f ?w)] =>
      rewrite (I v w) by (assumption || tauto) end;
    reflexivity.
Qed.

(** ** Cuts *)

Lemma MaterialCutEitherWay V G I (v w : V) m n :
  G v = Some m -> G w = Some n -> m <> n ->
  MaterialCut V G I v w = MaterialCut V G I w v.
Proof.
  intros E F N. unfold MaterialCut. rewrite E, F.
  destruct (Z.ltb_spec m n), (Z.ltb_spec n m); try lia; reflexivity.
Qed.

Lemma AmongMeans V (G : V -> option Material) m v :
  (SignAmongMaterials V G m v = Plus <-> G v = Some m) /\
  (SignAmongMaterials V G m v = Minus <-> exists n, G v = Some n /\ n <> m) /\
  (SignAmongMaterials V G m v = OnSurface <-> G v = None).
Proof.
  unfold SignAmongMaterials. destruct (G v) as [n|].
  - destruct (Z.eqb_spec n m) as [->|N]; repeat split; try congruence.
    + intros (k & [= <-] & N). congruence.
    + intros _. eauto.
  - repeat split; try congruence. intros (n & E & _). discriminate E.
Qed.

(** ** The materials that are there *)

Lemma AddMaterialIn V (G : V -> option Material) found v m :
  In m (AddMaterial V G found v) <-> In m found \/ G v = Some m.
Proof.
  unfold AddMaterial. destruct (G v) as [n|]; [|intuition congruence].
  destruct (existsb (Z.eqb n) found) eqn:E.
  - apply existsb_exists in E as (k & I & ->%Z.eqb_eq). split; [auto|].
    intros [J|[= <-]]; assumption.
  - rewrite in_app_iff. cbn [In]. intuition congruence.
Qed.

Lemma MaterialsOfIn V (G : V -> option Material) vs m :
  In m (MaterialsOf V G vs) <-> exists v, In v vs /\ G v = Some m.
Proof.
  unfold MaterialsOf.
  assert (H : forall found, In m (fold_left (AddMaterial V G) vs found) <->
    In m found \/ exists v, In v vs /\ G v = Some m).
  { induction vs as [|v vs IH]; intros found; cbn [fold_left In].
    - split; [auto|]. intros [I|(v & [] & _)]; exact I.
    - rewrite IH, AddMaterialIn. split.
      + intros [[I|E]|(w & I & E)]; eauto.
      + intros [I|(w & [<-|I] & E)]; eauto. }
  rewrite H. cbn [In]. split; [|auto]. intros [[]|E]; exact E.
Qed.

Lemma AddMaterialOnce V (G : V -> option Material) found v :
  NoDup found -> NoDup (AddMaterial V G found v).
Proof.
  intros N. unfold AddMaterial. destruct (G v) as [n|]; [|exact N].
  destruct (existsb (Z.eqb n) found) eqn:E; [exact N|].
  apply NoDup_rev in N. rewrite <- (rev_involutive (found ++ [n])).
  apply NoDup_rev. rewrite rev_app_distr. cbn [rev app].
  constructor; [|exact N]. rewrite <- in_rev. intros I.
  assert (F : existsb (Z.eqb n) found = true)
    by (apply existsb_exists; exists n; split; [exact I|apply Z.eqb_refl]).
  congruence.
Qed.

Lemma MaterialsOfOnce V (G : V -> option Material) vs : NoDup (MaterialsOf V G vs).
Proof.
  unfold MaterialsOf.
  assert (H : forall found, NoDup found -> NoDup (fold_left (AddMaterial V G) vs found)).
  { induction vs as [|v vs IH]; intros found N; cbn [fold_left]; [exact N|].
    apply IH, AddMaterialOnce, N. }
  apply H. constructor.
Qed.

(** ** Where a tetrahedron comes from *)

Lemma MaterialTetFrom V G I v1 v2 v3 v4 shared m t :
  In (m, t) (GetMaterialTets V G I v1 v2 v3 v4 shared) ->
  (G v1 = None /\ G v2 = None /\ G v3 = None /\ G v4 = None /\
   m = shared /\ t = UT _ v1 v2 v3 v4) \/
  (In t (GetUnstructuredTets V (SignAmongMaterials V G m) (MaterialCut V G I)
           v1 v2 v3 v4) \/
   In (m, t) (MaterialFill V G (MaterialCut V G I) v1 v2 v3 v4)).
Proof.
  unfold GetMaterialTets. intros J.
  pose proof (MaterialsOfIn V G [v1; v2; v3; v4]) as M.
  destruct (MaterialsOf V G [v1; v2; v3; v4]) as [|n ms].
  - left. destruct J as [[= <- <-]|[]].
    assert (N : forall v, In v [v1; v2; v3; v4] -> G v = None).
    { intros v K. destruct (G v) as [k|] eqn:E; [|reflexivity].
      exfalso. apply (M k). eauto. }
    repeat split; try (apply N; cbn; tauto).
  - right. apply in_app_or in J as [J|J]; [left|right; exact J].
    apply in_flat_map in J as (k & _ & J). unfold TetsOfOne in J.
    apply in_map_iff in J as (s & [= <- <-] & J). exact J.
Qed.

(** ** Renaming vertices and materials *)

Section Rename.
  Variables (A B : Type) (f : A -> B) (rename : Material -> Material).
  Variables (GA : A -> option Material) (GB : B -> option Material).
  Variables (IA : A -> A -> A) (IB : B -> B -> B).
  Variables v1 v2 v3 v4 : A.
  Let corners := [v1; v2; v3; v4].

  Hypothesis SameMaterial : forall v, In v corners ->
    GB (f v) = option_map rename (GA v).
  Hypothesis Apart : forall v w m n, In v corners -> In w corners ->
    GA v = Some m -> GA w = Some n -> rename m = rename n -> m = n.
  Hypothesis SameCut : forall v w m n, In v corners -> In w corners ->
    GA v = Some m -> GA w = Some n -> m <> n ->
    MaterialCut B GB IB (f v) (f w) = f (MaterialCut A GA IA v w).

  Definition RenameTet (t : Material * UnstructuredTet A)
    : Material * UnstructuredTet B := (rename (fst t), MapTet f (snd t)).

  Lemma RenamedEqual v w m n : In v corners -> In w corners ->
    GA v = Some m -> GA w = Some n -> (rename m =? rename n) = (m =? n).
  Proof.
    intros I J E F. destruct (Z.eqb_spec m n) as [->|N]; [apply Z.eqb_refl|].
    apply Z.eqb_neq. intros R. apply N. exact (Apart v w m n I J E F R).
  Qed.

  Lemma MaterialsRenamed :
    MaterialsOf B GB (map f corners) = map rename (MaterialsOf A GA corners).
  Proof.
    unfold MaterialsOf.
    assert (H : forall vs found, (forall v, In v vs -> In v corners) ->
      (forall m, In m found -> exists v, In v corners /\ GA v = Some m) ->
      fold_left (AddMaterial B GB) (map f vs) (map rename found)
      = map rename (fold_left (AddMaterial A GA) vs found)).
    { induction vs as [|v vs IH]; intros found Hv Hf; cbn [map fold_left];
        [reflexivity|].
      assert (S : AddMaterial B GB (map rename found) (f v)
        = map rename (AddMaterial A GA found v)).
      { unfold AddMaterial. rewrite SameMaterial by (apply Hv; left; reflexivity).
        destruct (GA v) as [m|] eqn:E; cbn [option_map]; [|reflexivity].
        assert (X : existsb (Z.eqb (rename m)) (map rename found)
          = existsb (Z.eqb m) found).
        { clear IH. induction found as [|n found IH]; [reflexivity|].
          cbn [map existsb]. rewrite IH by (intros k K; apply Hf; right; exact K).
          destruct (Hf n (or_introl eq_refl)) as (w & Iw & Ew).
          rewrite (RenamedEqual v w m n (Hv v (or_introl eq_refl)) Iw E Ew).
          reflexivity. }
        rewrite X. destruct (existsb (Z.eqb m) found); [reflexivity|].
        rewrite map_app. reflexivity. }
      rewrite S. apply IH.
      - intros w J. apply Hv. right. exact J.
      - intros m J. apply AddMaterialIn in J as [J|J]; [exact (Hf m J)|].
        exists v. split; [apply Hv; left; reflexivity|exact J]. }
    apply (H corners []); [trivial|intros m []].
  Qed.

  Lemma OneRenamed m : (exists v, In v corners /\ GA v = Some m) ->
    TetsOfOne B GB IB (f v1) (f v2) (f v3) (f v4) (rename m)
    = map RenameTet (TetsOfOne A GA IA v1 v2 v3 v4 m).
  Proof.
    intros (u & Iu & Eu). unfold TetsOfOne.
    rewrite (StencilsAskFromPlusToMinus A B f (SignAmongMaterials A GA m)
      (SignAmongMaterials B GB (rename m)) (MaterialCut A GA IA) (MaterialCut B GB IB)).
    - rewrite !map_map. reflexivity.
    - intros v I. unfold SignAmongMaterials. rewrite (SameMaterial v I).
      destruct (GA v) as [n|] eqn:E; cbn [option_map]; [|reflexivity].
      rewrite (RenamedEqual v u n m I Iu E Eu). reflexivity.
    - intros v w I J P M.
      apply AmongMeans in P. apply AmongMeans in M as (n & E & N).
      exact (SameCut v w m n I J P E (not_eq_sym N)).
  Qed.

  Ltac of_pair same v w I J :=
    pose proof (fun m n => RenamedEqual v w m n I J);
    pose proof (fun m n => same v w m n I J).

  (** The fill, with any cuts that agree. *)
  Lemma FillRenamed (CA : A -> A -> A) (CB : B -> B -> B) :
    (forall v w m n, In v corners -> In w corners ->
       GA v = Some m -> GA w = Some n -> m <> n -> CB (f v) (f w) = f (CA v w)) ->
    MaterialFill B GB CB (f v1) (f v2) (f v3) (f v4)
    = map RenameTet (MaterialFill A GA CA v1 v2 v3 v4).
  Proof.
    intros Same.
    assert (I1 : In v1 corners) by (cbn; tauto).
    assert (I2 : In v2 corners) by (cbn; tauto).
    assert (I3 : In v3 corners) by (cbn; tauto).
    assert (I4 : In v4 corners) by (cbn; tauto).
    unfold MaterialFill. rewrite !SameMaterial by assumption.
    of_pair Same v1 v2 I1 I2. of_pair Same v1 v3 I1 I3. of_pair Same v1 v4 I1 I4.
    of_pair Same v2 v3 I2 I3. of_pair Same v2 v4 I2 I4. of_pair Same v3 v4 I3 I4.
    clear SameMaterial Apart SameCut Same I1 I2 I3 I4.
    destruct (GA v1) as [m1|], (GA v2) as [m2|], (GA v3) as [m3|],
      (GA v4) as [m4|]; cbn [option_map]; try reflexivity;
      repeat match goal with
        H : forall m n, Some ?k = Some m -> Some ?l = Some n -> _ |- _ =>
          specialize (H k l eq_refl eq_refl)
        end;
      repeat match goal with H : (rename ?m =? rename ?n) = _ |- _ =>
        rewrite H; clear H end;
      repeat match goal with |- context [?a =? ?b] =>
        destruct (Z.eqb_spec a b); try reflexivity end;
      unfold RenameTet; cbn [map fst snd MapTet];
      repeat match goal with H : ?m <> ?n -> _, N : ?m <> ?n |- _ =>
        specialize (H N) end;
      repeat match goal with H : CB _ _ = _ |- _ =>
        rewrite ?H; clear H end;
      reflexivity.
  Qed.

  Theorem MaterialTetsRenamed shared :
    GetMaterialTets B GB IB (f v1) (f v2) (f v3) (f v4) (rename shared)
    = map RenameTet (GetMaterialTets A GA IA v1 v2 v3 v4 shared).
  Proof.
    unfold GetMaterialTets. pose proof MaterialsRenamed as M.
    unfold corners in M at 1. cbn [map] in M. rewrite M.
    pose proof (MaterialsOfIn A GA corners) as K. fold corners.
    destruct (MaterialsOf A GA corners) as [|m ms]; cbn [map]; [reflexivity|].
    rewrite map_app, (FillRenamed (MaterialCut A GA IA) _ SameCut). f_equal.
    change (rename m :: map rename ms) with (map rename (m :: ms)).
    assert (H : forall l, (forall k, In k l -> In k (m :: ms)) ->
      flat_map (TetsOfOne B GB IB (f v1) (f v2) (f v3) (f v4)) (map rename l)
      = map RenameTet (flat_map (TetsOfOne A GA IA v1 v2 v3 v4) l)).
    { induction l as [|k l IH]; intros S; cbn [map flat_map]; [reflexivity|].
      rewrite map_app, IH by (intros j J; apply S; right; exact J).
      rewrite OneRenamed by (apply K, S; left; reflexivity). reflexivity. }
    apply H. trivial.
  Qed.
End Rename.
