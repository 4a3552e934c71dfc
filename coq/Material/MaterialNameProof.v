(** * Symbols as names of mesh vertices, with materials

    As in [NameProof]: what holds of the tetrahedra on symbols, for each pattern
    of materials, holds of [MaterialNames]. *)

From Certet Require Import Material.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.TriangleChecker Stuffing.NameProof Material.MaterialProof
  Material.MaterialChecker.
Open Scope Z_scope.

(** ** Every field of materials has a pattern *)

Section Pattern.
  Variable materialOf : Label -> option Material.

  Definition Shares (m : Material) (l : Label) : bool :=
    match materialOf l with Some n => n =? m | None => false end.

  Definition LeaderFound (l : Label) : option Label :=
    match materialOf l with
    | None => None
    | Some m => find (Shares m) FiveLabels
    end.

  Definition Leader : Label -> option Label :=
    LeaderOf (LeaderFound F1) (LeaderFound F2) (LeaderFound F3) (LeaderFound P)
      (LeaderFound Q).

  Lemma LeaderIs l : Leader l = LeaderFound l.
  Proof. destruct l; reflexivity. Qed.

  Lemma SharesOwn l m : materialOf l = Some m -> Shares m l = true.
  Proof. intros E. unfold Shares. rewrite E. apply Z.eqb_refl. Qed.

  Lemma LeaderMeans l :
    match Leader l with
    | None => materialOf l = None
    | Some k => materialOf l <> None /\ materialOf k = materialOf l
    end.
  Proof.
    rewrite LeaderIs. unfold LeaderFound.
    destruct (materialOf l) as [m|] eqn:E; [|reflexivity].
    destruct (find (Shares m) FiveLabels) as [k|] eqn:F.
    - apply find_some in F as [_ F]. unfold Shares in F.
      destruct (materialOf k) as [n|]; [|discriminate F].
      apply Z.eqb_eq in F as ->. split; congruence.
    - exfalso. pose proof (find_none _ _ F l) as N.
      rewrite (SharesOwn l m E) in N.
      discriminate N. destruct l; cbn; tauto.
  Qed.

  Lemma LeaderSame l k : materialOf l = materialOf k -> Leader l = Leader k.
  Proof. rewrite !LeaderIs. unfold LeaderFound. intros ->. reflexivity. Qed.

  Lemma LeaderListed l : In (Leader l) (Leaders l).
  Proof.
    rewrite LeaderIs. unfold LeaderFound.
    destruct (materialOf l) as [m|] eqn:E; [|destruct l; cbn; tauto].
    apply SharesOwn in E. cbn [find FiveLabels].
    destruct l; rewrite E; cbn [Leaders In];
      repeat match goal with |- context [if ?b then _ else _] => destruct b end; tauto.
  Qed.

  Lemma LeadersNameThemselves : forallb (NamesItself Leader) FiveLabels = true.
  Proof.
    apply forallb_forall. intros l _. unfold NamesItself.
    pose proof (LeaderMeans l) as M. destruct (Leader l) as [k|] eqn:E; [|reflexivity].
    destruct M as [_ S]. rewrite (LeaderSame k l S), E. cbn [SameLeader].
    apply SameLabelEqual. reflexivity.
  Qed.

  Lemma ForAllPatternsSound test : ForAllPatterns test = true -> test Leader = true.
  Proof.
    unfold ForAllPatterns. intros H.
    rewrite forallb_forall in H. specialize (H _ (LeaderListed F1)).
    rewrite forallb_forall in H. specialize (H _ (LeaderListed F2)).
    rewrite forallb_forall in H. specialize (H _ (LeaderListed F3)).
    rewrite forallb_forall in H. specialize (H _ (LeaderListed P)).
    rewrite forallb_forall in H. specialize (H _ (LeaderListed Q)).
    cbn [Leader LeaderOf] in H. fold Leader in H. cbv zeta in H.
    rewrite LeadersNameThemselves in H. exact H.
  Qed.

  (** The material that a code stands for. *)
  Definition Meant (shared : Material) (code : Material) : Material :=
    let of l := match materialOf l with Some m => m | None => 0 end in
    if code =? 0 then of F1 else if code =? 1 then of F2
    else if code =? 2 then of F3 else if code =? 3 then of P
    else if code =? 4 then of Q else shared.

  Lemma MeantShared shared : Meant shared Shared = shared.
  Proof. reflexivity. Qed.

  Lemma MeantCode shared l m : materialOf l = Some m -> Meant shared (Code l) = m.
  Proof. intros E. destruct l; cbn; rewrite E; reflexivity. Qed.

  Lemma MeantBelow shared shared' code : code < Shared -> 0 <= code ->
    Meant shared code = Meant shared' code.
  Proof.
    unfold Shared, Meant. intros L N.
    repeat match goal with |- context [code =? ?k] =>
      destruct (Z.eqb_spec code k) end; lia.
  Qed.

  Lemma MeantLeader shared l : materialOf l = option_map (Meant shared) (option_map Code (Leader l)).
  Proof.
    pose proof (LeaderMeans l) as M. destruct (Leader l) as [k|]; [|exact M].
    destruct M as [N S]. cbn [option_map].
    destruct (materialOf l) as [m|] eqn:E; [|congruence].
    rewrite (MeantCode shared k m S). reflexivity.
  Qed.

  Lemma MeantApart shared l k : forall c d,
    option_map Code (Leader l) = Some c -> option_map Code (Leader k) = Some d ->
    Meant shared c = Meant shared d -> c = d.
  Proof.
    intros c d E F M.
    assert (S : materialOf l = materialOf k).
    { rewrite (MeantLeader shared l), (MeantLeader shared k), E, F. cbn. congruence. }
    rewrite (LeaderSame l k S) in E. congruence.
  Qed.
End Pattern.

Lemma CodeInjective a b : Code a = Code b -> a = b.
Proof. destruct a, b; reflexivity || discriminate. Qed.

(** ** Tetrahedra in names *)

Section AnyVertex.
  Variables (V : Type) (G : V -> option Material) (I : V -> V -> V).
  Variable place : Label -> V.

  Definition SymbolVertex (s : Symbol) : V :=
    match s with
    | Base l => place l
    | CutOf a b => MaterialCut V G I (place a) (place b)
    end.

  Local Notation leader := (Leader (fun l => G (place l))).

  Lemma TetsNamed (shared : Material) (a b c d : Label) :
    GetMaterialTets V G I (place a) (place b) (place c) (place d) shared
    = map (fun t => (Meant (fun l => G (place l)) shared (fst t),
                     MapTet SymbolVertex (snd t)))
        (SymbolicMaterials GetMaterialTets leader a b c d).
  Proof.
    pose proof (MaterialTetsRenamed Symbol V SymbolVertex
      (Meant (fun l => G (place l)) shared) (SymbolMaterial leader) G EdgeSymbol I
      (Base a) (Base b) (Base c) (Base d)) as R.
    cbn [SymbolVertex] in R.
    rewrite <- (MeantShared (fun l => G (place l)) shared) at 1. apply R; clear R.
    - intros v J. assert (exists l, v = Base l) as [l ->]
        by (cbn in J; intuition eauto).
      apply (MeantLeader (fun l => G (place l))).
    - intros v w m n J K. assert (exists l, v = Base l) as [l ->]
        by (cbn in J; intuition eauto).
      assert (exists k, w = Base k) as [k ->] by (cbn in K; intuition eauto).
      apply (MeantApart (fun l => G (place l))).
    - intros v w m n J K. assert (exists l, v = Base l) as [l ->]
        by (cbn in J; intuition eauto).
      assert (exists k, w = Base k) as [k ->] by (cbn in K; intuition eauto).
      cbn [SymbolMaterial SymbolVertex]. intros E F N.
      assert (X : MaterialCut Symbol (SymbolMaterial leader) EdgeSymbol (Base l) (Base k)
        = EdgeSymbol (Base l) (Base k)).
      { unfold MaterialCut. cbn [SymbolMaterial]. rewrite E, F.
        destruct (m <? n); [|reflexivity]. cbn [EdgeSymbol].
        assert (C : Code l <> Code k).
        { intros C. apply CodeInjective in C as ->. congruence. }
        destruct (Z.ltb_spec (Code l) (Code k)), (Z.ltb_spec (Code k) (Code l));
          try lia; reflexivity. }
      rewrite X. cbn [EdgeSymbol].
      destruct (Code k <? Code l); [|reflexivity]. cbn [SymbolVertex].
      pose proof (MeantLeader (fun l => G (place l)) 0 l) as Ml.
      pose proof (MeantLeader (fun l => G (place l)) 0 k) as Mk.
      rewrite E in Ml. rewrite F in Mk.
      apply (MaterialCutEitherWay _ _ _ _ _ (Meant (fun l => G (place l)) 0 m)
        (Meant (fun l => G (place l)) 0 n)); [exact Ml | exact Mk |].
      intros S. apply N. exact (MeantApart (fun l => G (place l)) 0 l k m n E F S).
  Qed.
End AnyVertex.

(** ** Names *)

Section Names.
  Variables f1 f2 f3 p q : Coord3.
  Hypothesis distinct : NoDup [f1; f2; f3; p; q].
  Variable material : MaterialField.

  Local Notation locate := (LocateFive f1 f2 f3 p q).

  Definition MaterialAt (l : Label) : option Material := material (locate l).
  Local Notation leader := (Leader MaterialAt).

  (** A cut's name begins with its higher material. *)
  Definition MaterialName (s : Symbol) : MeshVertex :=
    match s with
    | Base l => Corner (locate l)
    | CutOf a b =>
        MaterialCut MeshVertex (VertexMaterial material) MeshIntersection
          (Corner (locate a)) (Corner (locate b))
    end.

  Lemma MaterialCutNamed x y :
    MaterialCut MeshVertex (VertexMaterial material) MeshIntersection (Corner x) (Corner y)
      = Cut x y \/
    MaterialCut MeshVertex (VertexMaterial material) MeshIntersection (Corner x) (Corner y)
      = Cut y x.
  Proof.
    unfold MaterialCut. cbn [VertexMaterial].
    destruct (material x), (material y); cbn [MeshIntersection]; auto.
    destruct (_ <? _); auto.
  Qed.

  Lemma LiesOnMaterialName (face : list Label) (s : Symbol) :
    LiesOn face s = true <-> LiesIn (map locate face) (MaterialName s).
  Proof.
    destruct s as [l|a b]; cbn [LiesOn MaterialName].
    - apply OnFaceIn, distinct.
    - rewrite andb_true_iff, !(OnFaceIn f1 f2 f3 p q distinct).
      destruct (MaterialCutNamed (locate a) (locate b)) as [-> | ->]; cbn [LiesIn]; tauto.
  Qed.

  Lemma LabelledCorner (face : list Label) :
    Labelled leader face = true <->
    exists f, In f (map locate face) /\ material f <> None.
  Proof.
    unfold Labelled. rewrite existsb_exists. split.
    - intros (l & I & E). exists (locate l). split; [apply in_map, I|].
      pose proof (LeaderMeans MaterialAt l) as M. destruct (leader l); [|discriminate E].
      exact (proj1 M).
    - intros (f & I & N). apply in_map_iff in I as (l & <- & I). exists l.
      split; [exact I|]. pose proof (LeaderMeans MaterialAt l) as M.
      destruct (leader l); [reflexivity|]. contradiction.
  Qed.

  (** ** [MaterialNames] in names *)

  Variable shared : StructuredTetId -> Material.

  Definition NamedMaterials : Label -> Label -> Label -> Label ->
    list (Material * SymbolicTet) := SymbolicMaterials GetMaterialTets leader.

  Definition NameTet (tid : StructuredTetId) (t : Material * SymbolicTet)
    : Material * UnstructuredTet MeshVertex :=
    (Meant MaterialAt (shared tid) (fst t),
     Orient (Hand tid) (MapTet MaterialName (snd t))).

  Lemma MaterialNamesNamed (tid : StructuredTetId) (a b c d : Label) :
    VerticesAre f1 f2 f3 p q tid a b c d ->
    MaterialNames material shared tid = map (NameTet tid) (NamedMaterials a b c d).
  Proof.
    unfold VerticesAre. destruct tid as [anchor case]. cbn [MaterialNames].
    destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4].
    intros (-> & -> & -> & ->).
    pose proof (TetsNamed MeshVertex (VertexMaterial material) MeshIntersection
      (fun l => Corner (locate l)) (shared (STId anchor case)) a b c d) as N.
    cbv beta in N. rewrite N, map_map. apply map_ext. intros [k [x y z w]].
    unfold NameTet, OrientMaterialTet. cbn [fst snd Hand].
    destruct x, y, z, w; reflexivity.
  Qed.
End Names.
