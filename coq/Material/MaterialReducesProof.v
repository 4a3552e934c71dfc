(** * One material and the outside: today's stencils; and bad sets refused *)

From Certet Require Import Material.Definitions.
From Certet Require Import Material.OtherMaterials Material.MaterialProof
  Material.MaterialChecker.
Open Scope Z_scope.

(** ** What a warp depends on *)

Lemma WarpDepends th s s' n n' c c' :
  (forall d, Violates th s n c d = Violates th s' n' c' d) ->
  (forall d, Violates th s n c d = true -> c d = c' d) ->
  Warp th s n c = Warp th s' n' c'.
Proof.
  intros V C. unfold Warp.
  assert (H : forall ds best,
    match best with Stays => True | Moves e _ => c e = c' e end ->
    fold_left (NearerOf th s n c) ds best = fold_left (NearerOf th s' n' c') ds best).
  { induction ds as [|d ds IH]; intros best B; cbn [fold_left]; [reflexivity|].
    assert (E : NearerOf th s n c best d = NearerOf th s' n' c' best d).
    { unfold NearerOf. rewrite <- (V d). destruct (Violates th s n c d) eqn:W; [|reflexivity].
      unfold CutDistanceSquared. rewrite <- (C d W).
      destruct best as [|e t]; [reflexivity|]. rewrite <- B. reflexivity. }
    rewrite <- E. apply IH. unfold NearerOf.
    destruct (Violates th s n c d) eqn:W; [|exact B].
    destruct best as [|e t]; [exact (C d W)|]. destruct (_ <? _); [exact (C d W)|exact B]. }
  apply H. trivial.
Qed.

Lemma OnSurfaceStays th n c : Warp th OnSurface n c = Stays.
Proof.
  unfold Warp.
  assert (N : forall ds best, fold_left (NearerOf th OnSurface n c) ds best = best).
  { induction ds as [|d ds IH]; intros best; [reflexivity|exact (IH best)]. }
  apply N.
Qed.

(** From here on its name is needed, never its steps. *)
Local Strategy 1000 [Warp].

(** ** What a material has without the fill *)

Lemma OfMaterialApp {V} m (ts us : list (Material * UnstructuredTet V)) :
  OfMaterial m (ts ++ us) = OfMaterial m ts ++ OfMaterial m us.
Proof. unfold OfMaterial. rewrite filter_app, map_app. reflexivity. Qed.

Lemma OfOne {V} m n (ts : list (UnstructuredTet V)) :
  OfMaterial m (map (pair n) ts) = if n =? m then ts else [].
Proof.
  unfold OfMaterial.
  induction ts as [|t ts IH]; cbn [map filter fst]; [now destruct (n =? m)|].
  destruct (n =? m); cbn [map snd]; rewrite IH; reflexivity.
Qed.

Lemma OfMany V G I v1 v2 v3 v4 m ms : NoDup ms ->
  OfMaterial m (flat_map (TetsOfOne V G I v1 v2 v3 v4) ms)
  = if existsb (Z.eqb m) ms
    then GetUnstructuredTets V (SignAmongMaterials V G m) (MaterialCut V G I) v1 v2 v3 v4
    else [].
Proof.
  induction ms as [|n ms IH]; intros N; [reflexivity|].
  apply NoDup_cons_iff in N as [A N]. cbn [flat_map existsb].
  rewrite OfMaterialApp, (IH N). unfold TetsOfOne at 1. rewrite OfOne.
  rewrite (Z.eqb_sym n m). destruct (Z.eqb_spec m n) as [->|D]; [|reflexivity].
  destruct (existsb (Z.eqb n) ms) eqn:E.
  - apply existsb_exists in E as (k & J & ->%Z.eqb_eq). contradiction.
  - apply app_nil_r.
Qed.

Lemma NoneWithoutInside V G I v1 v2 v3 v4 m :
  (forall v, In v [v1; v2; v3; v4] -> G v <> Some m) ->
  GetUnstructuredTets V (SignAmongMaterials V G m) (MaterialCut V G I) v1 v2 v3 v4
  = [].
Proof.
  intros N.
  assert (S : forall v, In v [v1; v2; v3; v4] ->
    SignAmongMaterials V G m v <> Plus).
  { intros v J E. apply AmongMeans in E. exact (N v J E). }
  unfold GetUnstructuredTets. cbn [In] in S.
  pose proof (S v1 ltac:(tauto)) as S1. pose proof (S v2 ltac:(tauto)) as S2.
  pose proof (S v3 ltac:(tauto)) as S3. pose proof (S v4 ltac:(tauto)) as S4.
  destruct (SignAmongMaterials V G m v1); [congruence| |];
    (destruct (SignAmongMaterials V G m v2); [congruence| |];
      (destruct (SignAmongMaterials V G m v3); [congruence| |];
        (destruct (SignAmongMaterials V G m v4); [congruence| |]; reflexivity))).
Qed.

(** What a material has: its stencils and its fill. *)
Lemma MaterialIsStencilsAndFill V G I v1 v2 v3 v4 shared m :
  (exists v n, In v [v1; v2; v3; v4] /\ G v = Some n) ->
  OfMaterial m (GetMaterialTets V G I v1 v2 v3 v4 shared)
  = GetUnstructuredTets V (SignAmongMaterials V G m) (MaterialCut V G I) v1 v2 v3 v4
    ++ OfMaterial m (MaterialFill V G (MaterialCut V G I) v1 v2 v3 v4).
Proof.
  intros (v & n & J & E). unfold GetMaterialTets.
  pose proof (MaterialsOfIn V G [v1; v2; v3; v4]) as M.
  pose proof (MaterialsOfOnce V G [v1; v2; v3; v4]) as O.
  destruct (MaterialsOf V G [v1; v2; v3; v4]) as [|k ks].
  - exfalso. apply (M n). eauto.
  - rewrite OfMaterialApp, (OfMany V G I v1 v2 v3 v4 m (k :: ks) O). f_equal.
    destruct (existsb (Z.eqb m) (k :: ks)) eqn:X; [reflexivity|].
    symmetry. apply NoneWithoutInside. intros w L F.
    assert (T : existsb (Z.eqb m) (k :: ks) = true)
      by (apply existsb_exists; exists m; split; [apply M; eauto|apply Z.eqb_refl]).
    congruence.
Qed.

(** ** One material and the outside *)

Lemma TwoMaterialsNoFill V G C (v1 v2 v3 v4 : V) m n :
  (forall v, In v [v1; v2; v3; v4] -> G v = None \/ G v = Some m \/ G v = Some n) ->
  MaterialFill V G C v1 v2 v3 v4 = [].
Proof.
  intros H. cbn [In] in H. unfold MaterialFill.
  destruct (H v1 ltac:(tauto)) as [E1|[E1|E1]],
    (H v2 ltac:(tauto)) as [E2|[E2|E2]], (H v3 ltac:(tauto)) as [E3|[E3|E3]],
    (H v4 ltac:(tauto)) as [E4|[E4|E4]]; rewrite ?E1, ?E2, ?E3, ?E4;
    rewrite ?Z.eqb_refl; try reflexivity; rewrite ?(Z.eqb_sym n m);
    destruct (m =? n); reflexivity.
Qed.

Theorem MaterialReduces : forall Vertex GetMaterial GetIntersection v1 v2 v3 v4 m,
  Outside < m ->
  (forall v, In v [v1; v2; v3; v4] ->
     GetMaterial v = Some m \/ GetMaterial v = None \/
     GetMaterial v = Some Outside) ->
  OfMaterial m
    (GetMaterialTets Vertex GetMaterial GetIntersection v1 v2 v3 v4 Outside)
  = GetUnstructuredTets Vertex (SignAmongMaterials Vertex GetMaterial m)
      GetIntersection v1 v2 v3 v4.
Proof.
  intros V G I v1 v2 v3 v4 m Above H.
  assert (D : (exists v n, In v [v1; v2; v3; v4] /\ G v = Some n) \/
    forall v, In v [v1; v2; v3; v4] -> G v = None).
  { assert (X : forall vs : list V, (exists v n, In v vs /\ G v = Some n) \/
      forall v, In v vs -> G v = None).
    { induction vs as [|v vs [(w & n & J & E)|N]].
      - right. intros v [].
      - left. exists w, n. split; [right; exact J|exact E].
      - destruct (G v) as [n|] eqn:E.
        + left. exists v, n. split; [left; reflexivity|exact E].
        + right. intros w [<-|J]; [exact E|exact (N w J)]. }
    apply X. }
  assert (Same : GetUnstructuredTets V (SignAmongMaterials V G m) (MaterialCut V G I)
      v1 v2 v3 v4
    = GetUnstructuredTets V (SignAmongMaterials V G m) I v1 v2 v3 v4).
  { rewrite (StencilsAskFromPlusToMinus V V (fun v => v) (SignAmongMaterials V G m)
      (SignAmongMaterials V G m) I (MaterialCut V G I)).
    - rewrite <- map_id. apply map_ext. intros []. reflexivity.
    - reflexivity.
    - intros v w J K P N. apply AmongMeans in P. apply AmongMeans in N as (n & E & N).
      unfold MaterialCut. rewrite P, E.
      destruct (H w K) as [X|[X|X]]; rewrite X in E; try congruence.
      injection E as <-. destruct (Z.ltb_spec m Outside); [lia|reflexivity]. }
  destruct D as [D|N].
  - rewrite (MaterialIsStencilsAndFill V G I v1 v2 v3 v4 Outside m D), Same.
    rewrite (TwoMaterialsNoFill V G _ v1 v2 v3 v4 m Outside); [apply app_nil_r|].
    intros v J. destruct (H v J) as [|[|]]; auto.
  - unfold GetMaterialTets.
    pose proof (MaterialsOfIn V G [v1; v2; v3; v4]) as M.
    destruct (MaterialsOf V G [v1; v2; v3; v4]) as [|k ks].
    + unfold OfMaterial. cbn [filter fst]. destruct (Z.eqb_spec Outside m); [lia|].
      cbn [map]. symmetry.
      unfold GetUnstructuredTets, SignAmongMaterials. cbn [In] in N.
      rewrite !N by tauto. reflexivity.
    + exfalso. destruct (proj1 (M k) (or_introl eq_refl)) as (v & J & E).
      rewrite (N v J) in E. discriminate E.
Qed.

(** *** Of the whole mesh *)

(** With any signs at the corners. *)
Lemma NamesReduce (sign : MeshVertex -> Sign) tid m : Outside < m ->
  OfMaterial m
    (MaterialNames (fun c => OneMaterial m (sign (Corner c))) (fun _ => Outside) tid)
  = match tid, GetStructuredTet tid with
    | STId _ case, ST v1 v2 v3 v4 _ _ _ _ =>
        map (Orient (CaseHandedness case))
          (GetUnstructuredTets MeshVertex sign MeshIntersection
             (Corner v1) (Corner v2) (Corner v3) (Corner v4))
    end.
Proof.
  intros Above. unfold MaterialNames.
  destruct tid as [anchor case].
  destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4].
  set (material := fun c => OneMaterial m (sign (Corner c))).
  assert (R : OfMaterial m (GetMaterialTets MeshVertex (VertexMaterial material)
      MeshIntersection (Corner v1) (Corner v2) (Corner v3) (Corner v4) Outside)
    = GetUnstructuredTets MeshVertex
        (SignAmongMaterials MeshVertex (VertexMaterial material) m)
        MeshIntersection (Corner v1) (Corner v2) (Corner v3) (Corner v4)).
  { apply MaterialReduces; [exact Above|]. intros v J.
    assert (exists c, v = Corner c) as [c ->] by (cbn in J; intuition eauto).
    unfold VertexMaterial, material.
    destruct (sign (Corner c)); cbn [OneMaterial]; auto. }
  assert (S : GetUnstructuredTets MeshVertex
      (SignAmongMaterials MeshVertex (VertexMaterial material) m)
      MeshIntersection (Corner v1) (Corner v2) (Corner v3) (Corner v4)
    = GetUnstructuredTets MeshVertex sign MeshIntersection
        (Corner v1) (Corner v2) (Corner v3) (Corner v4)).
  { rewrite (StencilsAskFromPlusToMinus _ _ (fun v => v) sign
      (SignAmongMaterials MeshVertex (VertexMaterial material) m)
      MeshIntersection MeshIntersection).
    - rewrite <- map_id. apply map_ext. intros []. reflexivity.
    - intros v J. assert (exists c, v = Corner c) as [c ->]
        by (cbn in J; intuition eauto).
      unfold SignAmongMaterials, VertexMaterial, material.
      destruct (sign (Corner c)); cbn [OneMaterial].
      + rewrite Z.eqb_refl. reflexivity.
      + reflexivity.
      + destruct (Z.eqb_spec Outside m); [lia|reflexivity].
    - reflexivity. }
  rewrite <- S, <- R. unfold OfMaterial.
  generalize (GetMaterialTets MeshVertex (VertexMaterial material) MeshIntersection
    (Corner v1) (Corner v2) (Corner v3) (Corner v4) Outside).
  induction l as [|[n t] l IH]; [reflexivity|].
  cbn [map filter OrientMaterialTet fst snd].
  destruct (n =? m); cbn [map snd]; rewrite IH; reflexivity.
Qed.

Theorem MaterialMeshReduces : forall th sign cut tid m,
  Outside < m ->
  OfMaterial m
    (MaterialNames
       (fun c => OneMaterial m (MeshVertexSign th sign cut (Corner c)))
       (fun _ => Outside) tid)
  = StuffTet th sign cut tid.
Proof. intros th sign cut tid m. exact (NamesReduce (MeshVertexSign th sign cut) tid m). Qed.

(** *** Of warping *)

Theorem MaterialWarpReduces : forall th sign cut m v, Outside < m ->
  WarpMaterialVertex th (fun c => OneMaterial m (sign c)) cut v
  = WarpVertex th sign cut v.
Proof.
  intros th sign cut m v Above. unfold WarpMaterialVertex, WarpVertex.
  assert (Out : (Outside =? m) = false) by (apply Z.eqb_neq; lia).
  assert (Out' : (m =? Outside) = false) by (apply Z.eqb_neq; lia).
  assert (L : (m <? Outside) = false) by (apply Z.ltb_ge; lia).
  assert (L' : (Outside <? m) = true) by (apply Z.ltb_lt; lia).
  destruct (sign v) eqn:S; cbn [OneMaterial].
  - apply WarpDepends; intros d; unfold Violates, SignAmongMaterials, MaterialCutFrom, CutFrom;
      cbv zeta; rewrite S; destruct (sign (Translate v (Offset d)));
      cbn [OneMaterial Opposite andb]; rewrite ?Z.eqb_refl, ?Out, ?L; try reflexivity;
      discriminate.
  - symmetry. apply OnSurfaceStays.
  - apply WarpDepends; intros d; unfold Violates, SignAmongMaterials, MaterialCutFrom, CutFrom;
      cbv zeta; rewrite S; destruct (sign (Translate v (Offset d)));
      cbn [OneMaterial Opposite andb]; rewrite ?Z.eqb_refl, ?Out', ?L'; try reflexivity;
      discriminate.
Qed.

(** *** Of everything *)

Lemma MaterialNamesDepend material material' shared tid :
  (forall c, material c = material' c) ->
  MaterialNames material shared tid = MaterialNames material' shared tid.
Proof.
  intros E. unfold MaterialNames. destruct tid as [anchor case].
  destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4]. f_equal.
  assert (F : forall v, VertexMaterial material v = option_map (fun n => n)
    (VertexMaterial material' v)).
  { intros [c|a b]; cbn [VertexMaterial option_map]; [|reflexivity].
    rewrite E. destruct (material' c); reflexivity. }
  pose proof (MaterialTetsRenamed MeshVertex MeshVertex (fun v => v) (fun n => n)
    (VertexMaterial material') (VertexMaterial material) MeshIntersection MeshIntersection
    (Corner v1) (Corner v2) (Corner v3) (Corner v4)) as R.
  rewrite R.
  - unfold RenameTet. rewrite <- map_id. apply map_ext. intros [k []]. reflexivity.
  - intros v _. apply F.
  - intros v w k l _ _ _ _ X. exact X.
  - intros v w k l _ _ X Y _. unfold MaterialCut. rewrite !F, X, Y. reflexivity.
Qed.

Lemma OfMaterialMapped {A B} (g : UnstructuredTet A -> UnstructuredTet B) m ts :
  OfMaterial m (map (fun t => (fst t, g (snd t))) ts) = map g (OfMaterial m ts).
Proof.
  unfold OfMaterial. induction ts as [|[n t] ts IH]; cbn [map filter fst snd]; [reflexivity|].
  destruct (n =? m); cbn [map snd]; rewrite IH; reflexivity.
Qed.

Lemma PlacedReduces sign warping cut tid m : Outside < m ->
  OfMaterial m
    (PlacedMaterialTets (fun c => OneMaterial m (sign c)) warping cut
       (fun _ => Outside) tid)
  = PlacedTets sign warping cut tid.
Proof.
  intros Above. unfold PlacedMaterialTets. rewrite OfMaterialMapped.
  rewrite (MaterialNamesDepend _
    (fun c => OneMaterial m (PlacedSign sign warping (Corner c)))).
  - rewrite NamesReduce by exact Above. unfold PlacedTets.
    destruct tid as [anchor case]. destruct (GetStructuredTet _). reflexivity.
  - intros c. unfold PlacedMaterial. cbn [PlacedSign].
    destruct (warping c); reflexivity.
Qed.

Theorem MaterialStuffingReduces : forall th sign cut tid m, Outside < m ->
  let material c := OneMaterial m (sign c) in
  OfMaterial m
    (PlacedMaterialTets material (WarpMaterialVertex th material cut) cut
       (fun _ => Outside) tid)
  = StuffedTets th sign cut tid.
Proof.
  intros th sign cut tid m Above material.
  assert (W : forall v, WarpMaterialVertex th material cut v = WarpVertex th sign cut v)
    by (intros v; apply MaterialWarpReduces, Above).
  unfold PlacedMaterialTets, StuffedTets. rewrite OfMaterialMapped.
  rewrite (MaterialNamesDepend _ (fun c => OneMaterial m (MeshVertexSign th sign cut (Corner c)))).
  - rewrite MaterialMeshReduces by exact Above. apply map_ext.
    assert (P : forall v, PlacedPosition (WarpMaterialVertex th material cut) cut v
      = MeshPosition th sign cut v).
    { intros [c|a b]; cbn [PlacedPosition MeshPosition]; [rewrite W|]; reflexivity. }
    intros []. cbn [MapTet]. rewrite !P. reflexivity.
  - intros c. unfold PlacedMaterial. cbn [MeshVertexSign]. rewrite W.
    destruct (WarpVertex th sign cut c); reflexivity.
Qed.

(** ** Bad sets are refused *)

Theorem MislabelledMaterialsRejected :
  CheckMaterialFaces MislabelledMaterials = false.
Proof. vm_compute. reflexivity. Qed.

Theorem UnfilledMaterialsRejected : CheckMaterialInside UnfilledMaterials = false.
Proof. vm_compute. reflexivity. Qed.

Theorem TwistedMaterialsRejected : CheckMaterialInside TwistedMaterials = false.
Proof. vm_compute. reflexivity. Qed.
