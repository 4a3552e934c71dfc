(** * What warping leaves of several materials: proofs *)

From Certet Require Import Material.Definitions.
From Certet Require Import Warp.WarpProof Angles.Cases.AdmissibleProof
  Angles.AngleTheorems Embedding.WarpOrClampProof Embedding.SettledMeshProof
  Material.MaterialProof Material.MaterialBoundsProof
  Material.MaterialReducesProof Material.MaterialShape Material.Demotion.
Open Scope Z_scope.

(** Checking a proof needs [Warp]'s name, never its steps. *)
Local Strategy 1000 [Warp].

Section Warped.
  Variables (th : Thresholds) (material : MaterialField) (cut : CutField).
  Hypothesis Half : AtMostHalf th.
  Hypothesis OnEdges : MaterialCutsOnEdges material cut.

  (** Who moves, moves towards another material, by less than alpha. *)
  Lemma MaterialWarpMeans v d t : WarpMaterialVertex th material cut v = Moves d t ->
    exists m n, material v = Some m /\ material (Translate v (Offset d)) = Some n /\
      m <> n /\ t = MaterialCutFrom material cut v d /\
      t < ThresholdSteps th (DirectionKind d).
  Proof.
    unfold WarpMaterialVertex. intros E. destruct (material v) as [m|] eqn:M;
      [|discriminate E].
    pose proof (WarpIsCorrect th Plus
      (fun d => SignAmongMaterials Coord3 material m (Translate v (Offset d)))
      (MaterialCutFrom material cut v)) as C.
    rewrite E in C. destruct C as (T & V & _).
    unfold Violates in V. apply andb_prop in V as [O L]. apply Z.ltb_lt in L.
    unfold SignAmongMaterials in O.
    destruct (material (Translate v (Offset d))) as [n|]; [|discriminate O].
    destruct (Z.eqb_spec n m) as [|D]; [discriminate O|].
    exists m, n. repeat split; auto. rewrite T. exact L.
  Qed.

  Lemma MaterialCutFromInRange v d m n :
    material v = Some m -> material (Translate v (Offset d)) = Some n -> m <> n ->
    0 <= MaterialCutFrom material cut v d <= Steps.
  Proof.
    intros M N D. unfold MaterialCutFrom. cbv zeta. rewrite M, N.
    destruct (Z.ltb_spec m n) as [L|L].
    - pose proof (OnEdges _ _ n m N M L). lia.
    - pose proof (OnEdges _ _ m n M N ltac:(lia)). lia.
  Qed.

  (** The cut of an edge as seen from its two ends. *)
  Lemma MaterialCutFromBothEnds v d e m n :
    Translate (Translate v (Offset d)) (Offset e) = v ->
    material v = Some m -> material (Translate v (Offset d)) = Some n -> m <> n ->
    MaterialCutFrom material cut (Translate v (Offset d)) e
    = Steps - MaterialCutFrom material cut v d.
  Proof.
    unfold MaterialCutFrom. cbv zeta. intros E M N D. rewrite E, M, N.
    destruct (Z.ltb_spec m n), (Z.ltb_spec n m); lia.
  Qed.

  Variables (stays : Coord3 -> bool) (limit : Coord3 -> Z).
  Let warping := RuledMaterialWarping th material cut stays limit.

  Lemma RuledMaterialMeans v d t : warping v = Moves d t -> exists s,
    WarpMaterialVertex th material cut v = Moves d s /\ 0 <= t <= s /\
    stays v = false /\ t = Z.max 0 (Z.min s (limit v)).
  Proof.
    unfold warping, RuledMaterialWarping. intros E.
    destruct (WarpMaterialVertex th material cut v) as [|e s] eqn:W; [discriminate E|].
    destruct (MaterialWarpMeans v e s W) as (m & n & M & N & D & T & _).
    pose proof (MaterialCutFromInRange v e m n M N D) as R. rewrite <- T in R.
    destruct (stays v); [discriminate E|]. injection E as -> <-.
    exists s. repeat split; lia.
  Qed.

  Theorem AnyMaterialSubsetStays_ corners :
    AdmissibleMaterials material warping (ClampedCut th cut) th corners.
  Proof.
    split.
    - intros v d t _ E. destruct (RuledMaterialMeans v d t E) as (s & W & B & _).
      destruct (MaterialWarpMeans v d s W) as (m & n & M & N & D & T & L).
      split; [lia|]. intros _ e r F Back.
      destruct (RuledMaterialMeans _ e r F) as (s' & W' & _).
      destruct (MaterialWarpMeans _ e s' W') as (_ & _ & _ & _ & _ & T' & L').
      rewrite (MaterialCutFromBothEnds v d e m n Back M N D) in T'.
      rewrite (OppositeDirection v d e Back) in L'.
      specialize (Half (DirectionKind d)). lia.
    - intros v d m n _ _ _ _ _. exact (ClampedInRange th cut Half v d).
  Qed.
End Warped.

Theorem AnyMaterialSubsetStays : forall th material cut stays limit tid,
  AtMostHalf th -> MaterialCutsOnEdges material cut ->
  AdmissibleMaterials material (RuledMaterialWarping th material cut stays limit)
    (ClampedCut th cut) th (Corners tid).
Proof.
  intros th material cut stays limit tid H C. apply AnyMaterialSubsetStays_; assumption.
Qed.

(** ** Demotion *)

Lemma IsWellShapedSound bounds t : IsWellShaped bounds t = true -> WellShaped bounds t.
Proof.
  destruct t as [a b c d], bounds as [[num den] [num' den']].
  cbn [IsWellShaped WellShaped]. rewrite andb_true_iff, Z.ltb_lt. intros [V E].
  split; [exact V|]. intros p q r s I. rewrite forallb_forall in E.
  specialize (E (p, q, r, s) I). cbn [IsAngleWithin] in E. cbv zeta in E.
  rewrite andb_true_iff, !orb_true_iff, !Z.leb_le in E. exact E.
Qed.

Lemma InTetsAround v tid : InLattice tid -> In v (Corners tid) -> In tid (TetsAround v).
Proof.
  intros Even I. unfold TetsAround. apply filter_In. split.
  - destruct tid as [anchor case]. apply in_flat_map. exists anchor.
    split; [|apply in_map; destruct case; cbn; tauto].
    unfold Anchors. apply filter_In. split.
    + assert (O : exists x y z, In x CornerOffsets /\ In y CornerOffsets /\ In z CornerOffsets /\
        v = Translate anchor (C3 x y z)).
      { destruct case; cbn [Corners GetStructuredTet In] in I;
          destruct I as [<-|[<-|[<-|[<-|[]]]]]; do 3 eexists;
          (split; [|split; [|split; [|reflexivity]]]); cbn; tauto. }
      destruct O as (x & y & z & Ix & Iy & Iz & ->).
      apply in_flat_map. exists x. split; [exact Ix|].
      apply in_flat_map. exists y. split; [exact Iy|].
      apply in_map_iff. exists z. split; [|exact Iz].
      destruct anchor. cbn [Translate Difference]. f_equal; ring.
    + destruct anchor as [x y z]. destruct Even as (X & Y & Z).
      apply Z.even_spec in X, Y, Z. rewrite X, Y, Z. reflexivity.
  - apply existsb_exists. exists v. split; [exact I|].
    destruct v. cbn. rewrite !Z.eqb_refl. reflexivity.
Qed.

Lemma PlacedWholeSame warping warping' c c' tid :
  (forall v, In v (Corners tid) -> warping v = warping' v) ->
  PlacedWhole warping c tid = PlacedWhole warping' c' tid.
Proof.
  unfold PlacedWhole, Corners. destruct tid as [anchor case].
  destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4].
  cbn [In]. intros E.
  destruct (CaseHandedness case); cbn [Orient MapTet PlacedPosition];
    rewrite (E v1), (E v2), (E v3), (E v4) by tauto; reflexivity.
Qed.

(** A tetrahedron with all corners on interfaces is of the material that is told. *)
Lemma AloneAreShared before warping cut shared tid m t :
  InterfacesAlone before warping tid ->
  In (m, t) (PlacedMaterialTets before warping cut shared tid) -> m = shared tid.
Proof.
  intros Alone I. unfold PlacedMaterialTets, MaterialNames in I.
  unfold InterfacesAlone, Corners in Alone. destruct tid as [anchor case].
  destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4].
  apply in_map_iff in I as ([k u] & E & I). cbn [fst snd] in E. injection E as -> _.
  apply in_map_iff in I as ([k s] & E & I). unfold OrientMaterialTet in E.
  cbn [fst snd] in E. injection E as -> _.
  set (G := VertexMaterial (PlacedMaterial before warping)) in I.
  assert (N : forall v, In v [Corner v1; Corner v2; Corner v3; Corner v4] -> G v = None).
  { intros v [<-|[<-|[<-|[<-|[]]]]]; apply Alone; cbn; tauto. }
  apply MaterialTetFrom in I as [(_ & _ & _ & _ & E & _)|[I|I]]; [exact E| |]; exfalso.
  - rewrite NoneWithoutInside in I; [exact I|]. intros v J. rewrite (N v J). discriminate.
  - unfold MaterialFill in I. cbn [In] in N. rewrite !N in I by tauto. exact I.
Qed.

Section Demotion.
  Variables (material : MaterialField) (cut : CutField).
  Variable shared : StructuredTetId -> Material.
  Local Notation th := AngleThresholds.
  Local Notation bounds := WidestAngles.
  Hypothesis OnEdges : MaterialCutsOnEdges material cut.

  Local Notation full := (FullWarping th material cut).
  Local Notation demoted := (DemotedWarping bounds th material cut shared).

  Lemma FarthestMoves tid :
    match Farthest th material cut tid with
    | Some u => In u (Corners tid) /\ full u <> Stays
    | None => forall v, In v (Corners tid) -> full v = Stays
    end.
  Proof.
    unfold Farthest.
    assert (H : forall vs best,
      match best with Some u => full u <> Stays | None => True end ->
      match fold_left (FartherOf th material cut) vs best with
      | Some u => (In u vs \/ best = Some u) /\ full u <> Stays
      | None => best = None /\ forall v, In v vs -> full v = Stays
      end).
    { induction vs as [|v vs IH]; intros best B; cbn [fold_left In].
      - destruct best as [u|]; [split; [right; reflexivity|exact B]|].
        split; [reflexivity|intros v []].
      - specialize (IH (FartherOf th material cut best v)).
        assert (K : FartherOf th material cut best v = Some v /\ full v <> Stays \/
          FartherOf th material cut best v = best /\ (best = None -> full v = Stays)).
        { unfold FartherOf. destruct (full v) as [|d t] eqn:F; [right; auto|].
          destruct best as [u|]; [|left; split; [reflexivity|discriminate]].
          destruct (full u) as [|e s]; [left; split; [reflexivity|discriminate]|].
          destruct (_ <? _); [left|right]; split; auto; discriminate. }
        destruct K as [[K F]|[K F]]; rewrite K in *.
        + specialize (IH F). destruct (fold_left _ vs _) as [u|].
          * destruct IH as [[I|[= ->]] N]; auto.
          * destruct IH as [E _]. discriminate E.
        + specialize (IH B). destruct (fold_left _ vs _) as [u|].
          * destruct IH as [[I|E] N]; auto.
          * destruct IH as [E N]. split; [exact E|].
            intros w [<-|I]; [exact (F E)|exact (N w I)]. }
    specialize (H (Corners tid) None I).
    destruct (fold_left _ _ _) as [u|].
    - destruct H as [[I|E] N]; [auto|discriminate E].
    - exact (proj2 H).
  Qed.

  (** The lattice as it is. *)
  Lemma UnmovedWhole c tid : WellShaped bounds (PlacedWhole (fun _ => Stays) c tid).
  Proof.
    apply (DihedralBounds tid (fun _ => Plus) (fun _ => Stays) c).
    - split; [intros v d t _ E; discriminate E|].
      intros v d _ _ _ N. discriminate N.
    - unfold PlacedTets, PlacedWhole. destruct tid as [anchor case].
      destruct (GetStructuredTet (STId anchor case)). left. reflexivity.
  Qed.

  Lemma DemotedWhole tid : InLattice tid -> shared tid <> Outside ->
    InterfacesAlone material demoted tid ->
    WellShaped bounds (PlacedWhole demoted (ClampedCut th cut) tid).
  Proof.
    intros Even Kept Alone.
    assert (Same : forall v, In v (Corners tid) ->
      demoted v = full v /\ PlacedMaterial material full v = None).
    { intros v I. specialize (Alone v I). unfold PlacedMaterial in *.
      destruct (demoted v) as [|d t] eqn:E.
      - assert (F : full v = Stays)
          by (unfold FullWarping, WarpMaterialVertex; rewrite Alone; reflexivity).
        rewrite F. auto.
      - destruct (RuledMaterialMeans th material cut OnEdges _ _ v d t E)
          as (s & W & B & _ & T).
        destruct (MaterialWarpMeans th material cut v d s W)
          as (m & n & M & N & D & C & _).
        pose proof (MaterialCutFromInRange material cut OnEdges v d m n M N D) as R.
        rewrite <- C in R. replace (Z.max 0 (Z.min s Steps)) with s in T by lia.
        subst t. unfold FullWarping. rewrite W. auto. }
    rewrite (PlacedWholeSame demoted full (ClampedCut th cut) cut tid)
      by (intros v I; apply Same, I).
    destruct (IsWellShaped bounds (PlacedWhole full cut tid)) eqn:Shape;
      [apply IsWellShapedSound, Shape|].
    assert (Bad : Spoiled bounds th material cut shared tid = true).
    { unfold Spoiled. rewrite (proj2 (Z.eqb_neq _ _) Kept).
      assert (On : OnInterfaces th material cut tid = true).
      { apply forallb_forall. intros v I. rewrite (proj2 (Same v I)). reflexivity. }
      rewrite On, Shape. reflexivity. }
    pose proof (FarthestMoves tid) as F.
    destruct (Farthest th material cut tid) as [u|] eqn:Far.
    - exfalso. destruct F as [I N].
      assert (Stay : Demoted bounds th material cut shared u = true).
      { unfold Demoted. apply existsb_exists. exists tid.
        split; [apply InTetsAround; assumption|]. rewrite Bad, Far.
        destruct u. cbn. rewrite !Z.eqb_refl. reflexivity. }
      apply N. rewrite <- (proj1 (Same u I)).
      unfold DemotedWarping, RuledMaterialWarping. rewrite Stay.
      destruct (WarpMaterialVertex th material cut u); reflexivity.
    - rewrite (PlacedWholeSame full (fun _ => Stays) cut cut tid F).
      apply UnmovedWhole.
  Qed.

  Theorem DemotedWithin tid m t : InLattice tid -> m <> Outside ->
    In (m, t) (DemotedTets bounds th material cut shared tid) -> WellShaped bounds t.
  Proof.
    intros Even Inner I. refine (MaterialDihedralBounds material demoted (ClampedCut th cut)
      shared tid _ _ m t I).
    - apply AnyMaterialSubsetStays; [exact AngleThresholdsAtMostHalf|exact OnEdges].
    - intros Alone. apply DemotedWhole; [exact Even| |exact Alone].
      rewrite <- (AloneAreShared _ _ _ _ tid m t Alone I). exact Inner.
  Qed.
End Demotion.

(** Every tetrahedron of every material is such. *)
Definition EachDemotedTet (holds : UnstructuredTet Coord3 -> Prop) : Prop :=
  forall material cut shared tid m t,
    MaterialCutsOnEdges material cut -> InLattice tid -> m <> Outside ->
    In (m, t) (DemotedTets WidestAngles AngleThresholds material cut shared tid) ->
    holds t.

Theorem DemotedBounds : EachDemotedTet (WellShaped WidestAngles).
Proof. intros material cut shared tid m t C. apply DemotedWithin, C. Qed.

(** ** One material and the outside *)

Theorem DemotedReduces : forall bounds th sign cut tid m,
  Outside < m -> AtMostHalf th -> CutsOnEdges sign cut -> InLattice tid ->
  OfMaterial m
    (DemotedTets bounds th (fun c => OneMaterial m (sign c)) cut
       (fun _ => Outside) tid)
  = StuffedTets th sign cut tid.
Proof.
  intros bounds th sign cut tid m Above Half C Even.
  rewrite <- (NobodyStays th sign cut tid Half C Even). unfold WarpOrClamp.
  set (material := fun c => OneMaterial m (sign c)).
  set (warping := RuledWarping th sign cut (fun _ => false) (fun _ => Steps)).
  set (demoted := DemotedWarping bounds th material cut (fun _ => Outside)).
  assert (Nobody : forall v, Demoted bounds th material cut (fun _ => Outside) v = false).
  { intros v. unfold Demoted. induction (TetsAround v) as [|u us IH]; [reflexivity|].
    cbn [existsb]. rewrite IH. reflexivity. }
  assert (W : forall v, demoted v = warping v).
  { intros v. unfold demoted, warping, DemotedWarping, RuledMaterialWarping, RuledWarping.
    unfold material. rewrite (MaterialWarpReduces th sign cut m v Above).
    fold material. rewrite Nobody. reflexivity. }
  rewrite <- (PlacedTetsExt sign demoted warping _ tid W).
  unfold DemotedTets. apply PlacedReduces. exact Above.
Qed.
