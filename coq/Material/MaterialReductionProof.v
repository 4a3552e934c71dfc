(** * From placements of materials to the enumerated configurations: proofs

    A tetrahedron of a material comes from the stencils, and is then one of the
    placement of that material against the rest; or from the fill. *)

From Certet Require Import Material.Definitions.
From Certet Require Import Angles.Cases.Configurations
  Angles.Cases.SymmetryProof Angles.Cases.ReductionProof Material.MaterialProof
  Material.MaterialConfigurations.
Open Scope Z_scope.

Local Notation SymbolTets := (Configurations.SymbolTets GetUnstructuredTets).
Local Notation CheckRepresentatives :=
  (Configurations.CheckRepresentatives GetUnstructuredTets).

(** ** The fill on symbols *)

(** A corner, or a cut between two materials. *)
Definition BetweenMaterials (materials : Quad (option Material)) (v : Symbol) : Prop :=
  match v with
  | CornerOf _ => True
  | CutOf a b =>
      LabelEqual a b = false /\
      exists m n, Of materials a = Some m /\ Of materials b = Some n /\ m <> n
  end.

Definition SameInterfaces (q q' : Quad (option Material)) : Prop :=
  forall l, Of q l = None <-> Of q' l = None.

Definition BetweenMaterialsTet (q : Quad (option Material))
  (t : UnstructuredTet Symbol) : Prop :=
  match t with
    UT _ a b c d =>
      BetweenMaterials q a /\ BetweenMaterials q b /\ BetweenMaterials q c /\
      BetweenMaterials q d
  end.

Ltac listed_as q' :=
  exists q'; eexists; split; [cbn; tauto|]; split;
  [ intros []; cbn [Of]; split; intros E; discriminate E || reflexivity
  | vm_compute;
    first [ left; reflexivity | right; left; reflexivity
          | right; right; left; reflexivity
          | right; right; right; left; reflexivity ] ].

Lemma FillListed q m t : In (m, t) (FillOf q) ->
  (exists q' n, In q' ThreeOrFour /\ SameInterfaces q q' /\ In (n, t) (FillOf q')) /\
  BetweenMaterialsTet q t.
Proof.
  destruct q as [o1 o2 o3 o4]. unfold FillOf at 1, MaterialFill.
  cbn [Of SymbolIntersection].
  destruct o1 as [m1|], o2 as [m2|], o3 as [m3|], o4 as [m4|]; try (intros []; fail);
    repeat match goal with |- context [?a =? ?b] =>
      destruct (Z.eqb_spec a b); try (intros []; fail) end;
    cbn [In]; intros I;
    repeat match goal with H : _ \/ _ |- _ => destruct H as [H|H] end;
    try contradiction; injection I as <- <-;
    (split;
     [ first
       [ listed_as (Q4 (Some 1) (Some 2) (Some 3) (Some 4))
       | listed_as (Q4 (Some 1) (Some 1) (Some 2) (Some 3))
       | listed_as (Q4 (Some 2) (Some 3) (Some 1) (Some 1))
       | listed_as (Q4 (Some 1) (Some 2) (Some 1) (Some 3))
       | listed_as (Q4 (Some 2) (Some 1) (Some 3) (Some 1))
       | listed_as (Q4 (Some 1) (Some 2) (Some 3) (Some 1))
       | listed_as (Q4 (Some 2) (Some 1) (Some 1) (Some 3))
       | listed_as (Q4 None (Some 1) (Some 2) (Some 3))
       | listed_as (Q4 (Some 1) None (Some 2) (Some 3))
       | listed_as (Q4 (Some 1) (Some 2) None (Some 3))
       | listed_as (Q4 (Some 1) (Some 2) (Some 3) None) ]
     | cbn [BetweenMaterialsTet BetweenMaterials Of LabelEqual];
       repeat split; do 2 eexists; repeat split; congruence ]).
Qed.

(** ** One material against the rest *)

Section Placement.
  Variable before : MaterialField.
  Variable warping : Coord3 -> Warping.
  Variable cut : CutField.

  Local Notation material := (PlacedMaterial before warping).

  (** Signs before warping, as material [m] sees them. *)
  Definition BeforeAmong (m : Material) (c : Coord3) : Sign :=
    SignAmongMaterials Coord3 before m c.

  (** Steps to the cut of an edge from either end. *)
  Definition EitherCut (a b : Coord3) : Z :=
    match material a, material b with
    | Some m, Some n => if m <? n then Steps - cut b a else cut a b
    | _, _ => cut a b
    end.

  Lemma SignAmongPlaced m c :
    SignAmongMaterials MeshVertex (VertexMaterial material) m (Corner c)
    = PlacedSign (BeforeAmong m) warping (Corner c).
  Proof.
    unfold SignAmongMaterials, BeforeAmong, PlacedMaterial.
    cbn [VertexMaterial PlacedSign].
    destruct (warping c); cbn [WarpedSign]; reflexivity.
  Qed.

  Lemma PlacedMeans m c :
    match PlacedSign (BeforeAmong m) warping (Corner c) with
    | Plus => material c = Some m
    | OnSurface => material c = None
    | Minus => exists n, material c = Some n /\ n <> m
    end.
  Proof.
    rewrite <- SignAmongPlaced. unfold SignAmongMaterials. cbn [VertexMaterial].
    destruct (material c) as [n|]; [|reflexivity].
    destruct (Z.eqb_spec n m) as [->|N]; [reflexivity|eauto].
  Qed.

  (** The mesh vertex meant by a cut, whichever end is named first. *)
  Definition EitherWay (v : MeshVertex) : MeshVertex :=
    match v with
    | Corner c => Corner c
    | Cut a b =>
        MaterialCut MeshVertex (VertexMaterial material) MeshIntersection
          (Corner a) (Corner b)
    end.

  Lemma EitherWayPosition v :
    PlacedPosition warping cut (EitherWay v) = PlacedPosition warping EitherCut v.
  Proof.
    destruct v as [c|a b]; [reflexivity|]. cbn [EitherWay].
    unfold MaterialCut. cbn [VertexMaterial].
    assert (E : PlacedPosition warping EitherCut (Cut a b)
      = PointOnEdge a b (EitherCut a b)) by reflexivity.
    rewrite E. unfold EitherCut.
    destruct (material a) as [m|]; [|reflexivity].
    destruct (material b) as [n|]; [|reflexivity].
    destruct (m <? n); [|reflexivity]. cbn [MeshIntersection PlacedPosition].
    unfold PointOnEdge. destruct a, b. cbn [Scale Translate Difference]. f_equal; ring.
  Qed.

  Lemma PositionsEitherWay t :
    MapTet (PlacedPosition warping cut) (MapTet EitherWay t)
    = MapTet (PlacedPosition warping EitherCut) t.
  Proof. destruct t. cbn [MapTet]. rewrite !EitherWayPosition. reflexivity. Qed.

  Lemma OrientMapped {A} (f : MeshVertex -> A) h t :
    MapTet f (Orient h t)
    = match h, MapTet f t with
      | RightHanded, u => u
      | LeftHanded, UT _ a b c d => UT _ a b d c
      end.
  Proof. destruct h, t; reflexivity. Qed.

  Lemma StencilsEitherWay m v1 v2 v3 v4 :
    GetUnstructuredTets MeshVertex
      (SignAmongMaterials MeshVertex (VertexMaterial material) m)
      (MaterialCut MeshVertex (VertexMaterial material) MeshIntersection)
      (Corner v1) (Corner v2) (Corner v3) (Corner v4)
    = map (MapTet EitherWay)
        (GetUnstructuredTets MeshVertex (PlacedSign (BeforeAmong m) warping)
           MeshIntersection (Corner v1) (Corner v2) (Corner v3) (Corner v4)).
  Proof.
    apply (StencilsAskFromPlusToMinus MeshVertex MeshVertex EitherWay
      (PlacedSign (BeforeAmong m) warping)
      (SignAmongMaterials MeshVertex (VertexMaterial material) m) MeshIntersection
      (MaterialCut MeshVertex (VertexMaterial material) MeshIntersection)
      (Corner v1) (Corner v2) (Corner v3) (Corner v4)).
    - intros v J. assert (exists c, v = Corner c) as [c ->]
        by (cbn in J; intuition eauto). apply SignAmongPlaced.
    - intros v w J K _ _. assert (exists c, v = Corner c) as [c ->]
        by (cbn in J; intuition eauto).
      assert (exists d, w = Corner d) as [d ->] by (cbn in K; intuition eauto).
      reflexivity.
  Qed.

  (** ** The three kinds of tetrahedra *)

  Variable shared : StructuredTetId -> Material.
  Variable tid : StructuredTetId.

  Local Notation corners := (CornersOf tid).
  Local Notation Stand :=
    (fun v => PlacedPosition warping EitherCut (Stands corners v)).
  Definition MaterialQuad : Quad (option Material) :=
    QuadOf (fun l => material (Of corners l)).

  Definition OrientPoints (h : Handedness) (t : UnstructuredTet Coord3)
    : UnstructuredTet Coord3 :=
    match h, t with RightHanded, u => u | LeftHanded, UT _ a b c d => UT _ a b d c end.

  Lemma KindsOfTets m t :
    In (m, t) (PlacedMaterialTets before warping cut shared tid) ->
    (InterfacesAlone before warping tid /\ t = PlacedWhole warping cut tid) \/
    In t (PlacedTets (BeforeAmong m) warping EitherCut tid) \/
    (exists s, In (m, s) (FillOf MaterialQuad) /\
       t = OrientPoints (Hand tid) (MapTet Stand s)).
  Proof.
    intros I. unfold PlacedMaterialTets, MaterialNames in I.
    unfold InterfacesAlone, PlacedWhole, PlacedTets, MaterialQuad, Hand,
      CornersOf, Corners.
    destruct tid as [anchor case].
    destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4].
    apply in_map_iff in I as ([k u] & E & I). cbn [fst snd] in E.
    injection E as -> <-. apply in_map_iff in I as ([k s] & E & I).
    unfold OrientMaterialTet in E. cbn [fst snd] in E. injection E as -> <-.
    apply MaterialTetFrom in I as [(N1 & N2 & N3 & N4 & _ & ->)|[I|I]].
    - left. split; [|reflexivity]. cbn [VertexMaterial] in *.
      intros v [<-|[<-|[<-|[<-|[]]]]]; assumption.
    - right. left. rewrite StencilsEitherWay in I.
      apply in_map_iff in I as (w & <- & I).
      apply in_map_iff. exists (Orient (CaseHandedness case) w).
      split; [|apply in_map, I]. rewrite !OrientMapped, PositionsEitherWay. reflexivity.
    - right. right.
      pose proof (FillRenamed Symbol MeshVertex
        (fun v => EitherWay (Stands (Q4 v1 v2 v3 v4) v)) (fun n => n)
        (fun v => match v with
                  | CornerOf l => material (Of (Q4 v1 v2 v3 v4) l)
                  | CutOf _ _ => None
                  end)
        (VertexMaterial material) (CornerOf V1) (CornerOf V2) (CornerOf V3)
        (CornerOf V4)) as R.
      specialize (R ltac:(intros v J;
        assert (exists l, v = CornerOf l) as [l ->] by (cbn in J; intuition eauto);
        cbn [Stands EitherWay VertexMaterial]; now destruct (material _))).
      specialize (R (fun v w k l _ _ _ _ E => E)).
      specialize (R SymbolIntersection
        (MaterialCut MeshVertex (VertexMaterial material) MeshIntersection)).
      specialize (R ltac:(intros v w a b J K _ _ _;
        assert (exists l, v = CornerOf l) as [l ->] by (cbn in J; intuition eauto);
        assert (exists l', w = CornerOf l') as [l' ->] by (cbn in K; intuition eauto);
        reflexivity)).
      cbn [Stands EitherWay Of] in R. rewrite R in I. clear R.
      apply in_map_iff in I as ([n u] & E & I). unfold RenameTet in E.
      cbn [fst snd] in E. injection E as -> <-.
      exists u. split.
      + unfold FillOf, QuadOf. revert I. unfold MaterialFill. exact (fun H => H).
      + rewrite OrientMapped. unfold OrientPoints.
        assert (X : MapTet (PlacedPosition warping cut)
            (MapTet (fun v => EitherWay (Stands (Q4 v1 v2 v3 v4) v)) u)
          = MapTet (fun v => PlacedPosition warping EitherCut
              (Stands (Q4 v1 v2 v3 v4) v)) u).
        { destruct u. cbn [MapTet]. rewrite !EitherWayPosition. reflexivity. }
        rewrite X. reflexivity.
  Qed.
End Placement.
