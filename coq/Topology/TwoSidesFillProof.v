(** * The meshes of both sides leave no gaps: proof *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stuffing.NameProof Angles.Cases.AdmissibleProof
  Embedding.LatticeEmbedsProof Embedding.WarpedLatticeProof Embedding.EdgeRank
  Embedding.MeshEmbedsProof Embedding.LatticeCoversProof Topology.StencilSurface
  Topology.FillProof.
Open Scope Z_scope.

Lemma WeighMap {U V} (f : U -> V) g w t :
  Weigh g w (MapTet f t) = Weigh (fun u => g (f u)) w t.
Proof. destruct w, t. reflexivity. Qed.

Definition OrientWeights (h : Handedness) (w : Weights) : Weights :=
  match h, w with
  | RightHanded, _ => w
  | LeftHanded, UT _ a b c d => UT _ a b d c
  end.

Lemma WeighOriented h g w t : Weigh g (OrientWeights h w) (Orient h t) = Weigh g w t.
Proof. destruct h, w, t; cbn [OrientWeights Orient Weigh]; ring. Qed.

Lemma OrientedNonNegative h w : NonNegative w -> NonNegative (OrientWeights h w).
Proof. destruct h, w; cbn [OrientWeights NonNegative]; tauto. Qed.

Lemma PointByAxis {V} (place : V -> Coord3) f w t : Axis f ->
  f (PointOf w (MapTet place t)) = Weigh (fun v => f (place v)) w t.
Proof.
  intros F. destruct w as [a b c d], t as [p q r s]. cbn [MapTet PointOf Weigh].
  destruct (place p), (place q), (place r), (place s). cbn [Scale Translate].
  destruct F as [->|[->| ->]]; cbn [XOf YOf ZOf]; ring.
Qed.

Lemma ByAxis u v : (forall f, Axis f -> f u = f v) -> u = v.
Proof.
  intros E. destruct u as [x y z], v as [x' y' z'].
  pose proof (E XOf (or_introl eq_refl)) as X.
  pose proof (E YOf (or_intror (or_introl eq_refl))) as Y.
  pose proof (E ZOf (or_intror (or_intror eq_refl))) as Z'. cbn in X, Y, Z'. congruence.
Qed.

Lemma AxisScale f n v : Axis f -> f (Scale n v) = n * f v.
Proof. intros [->|[->| ->]]; destruct v; reflexivity. Qed.

Lemma TotalWeigh {V} w (t : UnstructuredTet V) : Total w = Weigh (fun _ => 1) w t.
Proof. destruct w, t. cbn [Total Weigh]. ring. Qed.

Section Mesh.
  Variables (before : SignField) (warping : Coord3 -> Warping) (cut : CutField).
  Hypothesis Cuts : CutsInside before warping cut.

  Local Notation after := (SignAfter before warping).
  Local Notation place := (PlacedPosition warping cut).

  (** Constant, or along an axis. *)
  Definition OnStraights (value : MeshVertex -> Z) : Prop :=
    forall a m, after a = Plus -> after m = Minus ->
      Steps * value (Cut a m)
      = (Steps - cut a m) * value (Corner a) + cut a m * value (Corner m).

  Lemma OneStraight : OnStraights (fun _ => 1).
  Proof. intros a m _ _. ring. Qed.

  Lemma AxisStraight f : Axis f -> OnStraights (fun v => f (place v)).
  Proof.
    intros F a m A M. symmetry. exact (ShareOfCut before warping cut a m f F A M).
  Qed.

  (** A tetrahedron of either mesh, or one of the lattice with nothing but 0
      corners. *)
  Definition OneOf (tid : StructuredTetId) (t : UnstructuredTet MeshVertex) : Prop :=
    In t (PlacedNames before warping tid) \/ In t (OtherNames before warping tid) \/
    t = MapTet Corner (LatticeTet tid) /\
      forall c, In c (Corners tid) -> after c = OnSurface.

  Lemma AfterNegated c : PlacedSign (OtherSigns before) warping (Corner c)
    = Negate (after c).
  Proof. unfold SignAfter. cbn [PlacedSign]. destruct (warping c); reflexivity. Qed.

  Theorem TetFills tid w : NonNegative w ->
    exists t w' times, OneOf tid t /\ NonNegative w' /\ 0 < times /\
      forall value, OnStraights value ->
        Weigh value w' t = times * Weigh (fun c => value (Corner c)) w (LatticeTet tid).
  Proof.
    intros W. set (vertex := VertexAt (GetStructuredTet tid)).
    set (q := vertex Fourth).
    set (name := Name (vertex First) (vertex Second) (vertex Third) (vertex Fourth) q).
    set (point := fun l => vertex (LabelPlace l)).
    assert (Base_ : forall l, name (Base l) = Corner (point l)).
    { intros []; reflexivity. }
    assert (Cut_ : forall a m, name (CutOf a m) = Cut (point a) (point m)).
    { intros a m. unfold name. rewrite NameCut. destruct a, m; reflexivity. }
    destruct (PlacedLabelled before warping tid q) as (h & N).
    destruct (PlacedLabelled (OtherSigns before) warping tid q) as (h' & N').
    cbv zeta in N, N'. fold vertex name in N, N'.
    rewrite !AfterNegated in N'. change (PlacedSign before warping (Corner ?c))
      with (after c) in N.
    cbn [LabelPlace] in N, N'.
    set (s1 := after (vertex First)) in *. set (s2 := after (vertex Second)) in *.
    set (s3 := after (vertex Third)) in *. set (sp := after (vertex Fourth)) in *.
    set (sq := after q) in *. set (sign := SignOf s1 s2 s3 sp sq) in *.
    assert (Sign_ : forall l, sign l = after (point l)) by (intros []; reflexivity).
    assert (Outer_ : SymbolicTets GetUnstructuredTets
        (SignOf (Negate s1) (Negate s2) (Negate s3) (Negate sp) (Negate sq)) F1 F2 F3 P
      = SymbolicTets GetUnstructuredTets (fun l => Negate (sign l)) F1 F2 F3 P).
    { unfold sign. clear. destruct s1, s2, s3, sp; reflexivity. }
    rewrite Outer_ in N'.
    destruct (Fills sign Steps (fun p m => cut (point p) (point m)))
      with (w := w) as (t & w' & times & I & W' & T & E).
    - intros p m (_ & _ & Sp & Sm). rewrite Sign_ in Sp, Sm.
      assert (Npm : point p <> point m) by congruence.
      assert (In_ : forall l, In (point l) (Corners tid))
        by (intros l; apply PlaceOf; eexists; reflexivity).
      destruct (EdgeBetween tid _ _ (In_ p) (In_ m) Npm) as [d Ed].
      rewrite Ed. apply Cuts; [exact Sp|]. rewrite <- Ed. exact Sm.
    - exact (ForAllSignAssignmentsSound _ FillsChecked s1 s2 s3 sp sq).
    - exact W.
    - assert (St : forall value, OnStraights value ->
        StraightOn sign Steps (fun p m => cut (point p) (point m))
          (fun s => value (name s))).
      { intros value V p m (_ & _ & Sp & Sm). rewrite Sign_ in Sp, Sm.
        rewrite Cut_, !Base_. apply V; assumption. }
      assert (Whole : forall value, Weigh (fun s => value (name s)) w
          (UT _ (Base F1) (Base F2) (Base F3) (Base P))
        = Weigh (fun c => value (Corner c)) w (LatticeTet tid)).
      { intros value. unfold LatticeTet, name, vertex. destruct (GetStructuredTet tid).
        destruct w. reflexivity. }
      apply in_app_or in I. destruct I as [I|I]; [|apply in_app_or in I; destruct I as [I|I]].
      + exists (Orient h (MapTet name t)), (OrientWeights h w'), times.
        split; [left; rewrite N; apply (in_map (fun s => Orient h (MapTet name s))), I|].
        split; [apply OrientedNonNegative, W'|]. split; [exact T|]. intros value V.
        rewrite WeighOriented, WeighMap, <- Whole. apply E, St, V.
      + apply in_map_iff in I. destruct I as (t0 & <- & I).
        assert (Swap : forall s, NameHere (name s) = name (SwapCut s)).
        { intros [l|a m]; cbn [SwapCut]; rewrite ?Base_, ?Cut_; reflexivity. }
        exists (MapTet NameHere (Orient h' (MapTet name t0))), (OrientWeights h' w'), times.
        split.
        { right. left. unfold OtherNames. apply in_map. rewrite N'.
          apply (in_map (fun s => Orient h' (MapTet name s))), I. }
        split; [apply OrientedNonNegative, W'|]. split; [exact T|]. intros value V.
        rewrite WeighMap, WeighOriented, WeighMap, <- Whole, <- (E _ (St value V)).
        rewrite WeighMap. destruct w', t0. cbn [Weigh]. rewrite !Swap. reflexivity.
      + unfold Dropped in I. destruct (forallb (Is sign OnSurface) Four) eqn:Z'; [|destruct I].
        destruct I as [<-|[]]. exists (MapTet Corner (LatticeTet tid)), w', times.
        split.
        { right. right. split; [reflexivity|]. intros c C. apply PlaceOf in C.
          destruct C as [i ->]. rewrite forallb_forall in Z'.
          fold vertex.
          assert (exists l, In l Four /\ vertex i = point l) as (l & L & ->).
          { destruct i; [exists F1|exists F2|exists F3|exists P];
              (split; [cbn; tauto|reflexivity]). }
          specialize (Z' l L). apply IsSignEqual in Z'. rewrite <- Sign_. exact Z'. }
        split; [exact W'|]. split; [exact T|]. intros value V.
        rewrite <- Whole, <- (E _ (St value V)), WeighMap.
        unfold LatticeTet, name, vertex. destruct (GetStructuredTet tid). destruct w'.
        reflexivity.
  Qed.

  (** ** Every point *)

  (** One that the placed lattice covers. *)
  Lemma CoveredFills n x :
    (exists tid w, InLattice tid /\ NonNegative w /\ 0 < Total w /\
       Scale n (PointOf w (MapTet (fun v => WarpedPosition v (warping v)) (LatticeTet tid)))
       = Scale (Total w) x) ->
    exists tid t w, InLattice tid /\ OneOf tid t /\ NonNegative w /\ 0 < Total w /\
      Scale n (PointOf w (MapTet place t)) = Scale (Total w) x.
  Proof.
    intros (tid & w0 & E & W0 & T0 & X).
    destruct (TetFills tid w0 W0) as (t & w & times & O & W & T & V).
    assert (Total_ : Total w = times * Total w0).
    { rewrite (TotalWeigh w t), (TotalWeigh w0 (LatticeTet tid)). apply (V _ OneStraight). }
    exists tid, t, w. split; [exact E|]. split; [exact O|]. split; [exact W|].
    split; [rewrite Total_; nia|]. apply ByAxis. intros f F.
    rewrite !AxisScale, Total_ by exact F.
    rewrite (PointByAxis place f w t F), (V _ (AxisStraight f F)).
    pose proof (f_equal f X) as Fx. rewrite !AxisScale in Fx by exact F.
    rewrite (PointByAxis (fun v => WarpedPosition v (warping v)) f w0 _ F) in Fx.
    cbn [PlacedPosition]. nia.
  Qed.

  Theorem TwoSidesFill n x : MovesAtMost AngleThresholds warping -> Uncrossed warping ->
    0 < n ->
    exists tid t w, InLattice tid /\ OneOf tid t /\ NonNegative w /\ 0 < Total w /\
      Scale n (PointOf w (MapTet place t)) = Scale (Total w) x.
  Proof.
    intros M U Pn. apply CoveredFills. exact (UncrossedLatticeCovers warping n x M U Pn).
  Qed.
End Mesh.

(** With thresholds that embed. *)
Lemma ThresholdsInside long short sign cut : let th := TH long short in
  0 < long <= 64 -> 0 < short <= 128 -> CutsOnEdges sign cut ->
  CutsInside sign (WarpVertex th sign cut) cut.
Proof.
  intros th L S C.
  assert (T : forall k, 0 < ThresholdSteps th k <= 32768).
  { intros k. unfold th, ThresholdSteps. change (Steps / 256) with 256.
    destruct k; lia. }
  apply CutsInsideWarped; try assumption; intros k; specialize (T k);
    change Steps with 65536; lia.
Qed.

Theorem WarpedTwoSidesFill long short sign cut n x :
  0 < long <= 64 -> 0 < short <= 128 -> CutsOnEdges sign cut -> 0 < n ->
  let warping := WarpVertex (TH long short) sign cut in
  exists tid t w, InLattice tid /\ OneOf sign warping tid t /\
    NonNegative w /\ 0 < Total w /\
    Scale n (PointOf w (MapTet (PlacedPosition warping cut) t)) = Scale (Total w) x.
Proof.
  intros L S C N warping. apply CoveredFills.
  - exact (ThresholdsInside long short sign cut L S C).
  - unfold warping. apply (LatticeCovers _ (5 * Steps)); [| |exact N].
    + apply WarpKeepsShortEdges; [split; lia|exact C].
    + intros v d. apply PlacedNoLonger. intros u e t E.
      destruct (WarpedMeans _ sign cut u e t E) as (-> & O & _).
      exact (CutFromInRange sign cut C u e O).
Qed.

(** By its own names the mesh of the other side lies where it does by these. *)
Theorem OtherSidePlaced warping cut t :
  MapTet (PlacedPosition warping cut) (MapTet NameHere t)
  = MapTet (PlacedPosition warping (OtherCuts cut)) t.
Proof.
  assert (E : forall v, PlacedPosition warping cut (NameHere v)
    = PlacedPosition warping (OtherCuts cut) v).
  { intros [c|a m]; [reflexivity|]. cbn [NameHere PlacedPosition].
    unfold OtherCuts, PointOnEdge. destruct a, m. cbn [Difference Scale Translate].
    f_equal; ring. }
  destruct t. cbn [MapTet]. rewrite !E. reflexivity.
Qed.
