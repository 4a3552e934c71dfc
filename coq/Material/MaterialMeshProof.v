(** * The meshes of the materials fit together

    The checker's verdict on symbols, carried over to [MaterialNames] for every
    structured tetrahedron of the lattice. *)

From Certet Require Import Material.Definitions.
From Certet Require Import Lattice.ArrangementProof Stencil.Symbol
  Stencil.TriangleChecker Stencil.TriangleCheckerProof Stuffing.NameProof
  Stuffing.MeshProof Material.MaterialChecker Material.MaterialProof
  Material.MaterialNameProof.
Open Scope Z_scope.

(** ** What the checker finds *)

Lemma MaterialFacesFit : CheckMaterialFaces GetMaterialTets = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma MaterialInsideFits : CheckMaterialInside GetMaterialTets = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

(** ** Lists of tetrahedra with materials *)

Lemma InOfMaterial {V} m (ts : list (Material * UnstructuredTet V)) t :
  In t (OfMaterial m ts) <-> In (m, t) ts.
Proof.
  unfold OfMaterial. rewrite in_map_iff. split.
  - intros ([n s] & <- & I). apply filter_In in I as [I E].
    apply Z.eqb_eq in E. cbn [fst snd] in *. subst n. exact I.
  - intros I. exists (m, t). split; [reflexivity|]. apply filter_In.
    split; [exact I|]. apply Z.eqb_refl.
Qed.

Lemma InAllMaterials {V} (ts : list (Material * UnstructuredTet V)) t :
  In t (map snd ts) <-> exists m, In (m, t) ts.
Proof.
  rewrite in_map_iff. split.
  - intros ([m s] & <- & I). exists m. exact I.
  - intros (m & I). exists (m, t). split; [reflexivity|exact I].
Qed.

Lemma CheckMaterialsIncludedSound labelled face ts us :
  CheckMaterialsIncluded labelled face ts us = true ->
  forall k t a b c, In (k, t) ts -> HasTriangle t a b c ->
    TriangleOn face (a, b, c) = true ->
    (labelled = true -> 0 <= k < Shared) /\
    exists j u, In (j, u) us /\ HasTriangle u a b c /\ (labelled = true -> j = k).
Proof.
  intros K k t a b c I H O. unfold CheckMaterialsIncluded in K.
  rewrite forallb_forall in K. specialize (K (k, t) I). cbn [fst snd] in K.
  apply andb_true_iff in K as [L K]. split.
  - intros ->. cbn in L. apply andb_true_iff in L as [N L].
    apply Z.leb_le in N. apply Z.ltb_lt in L. lia.
  - rewrite forallb_forall in K. specialize (K (a, b, c)).
    rewrite O in K. cbn [negb orb] in K.
    specialize (K (proj2 (TrianglesHasTriangle t a b c) H)).
    apply existsb_exists in K as (u & J & K).
    apply (HasHasTriangle t u a b c H) in K.
    destruct labelled.
    + apply InOfMaterial in J. exists k, u. auto.
    + apply InAllMaterials in J as (j & J). exists j, u. repeat split; try apply K; auto.
      discriminate.
Qed.

(** ** Both sides of a face *)

Section Face.
  Variable material : MaterialField.
  Variable shared : StructuredTetId -> Material.
  Variables f1 f2 f3 p q : Coord3.
  Hypothesis distinct : NoDup [f1; f2; f3; p; q].

  Local Notation leader := (Leader (MaterialAt f1 f2 f3 p q material)).
  Local Notation locate := (LocateFive f1 f2 f3 p q).
  Local Notation name := (MaterialName f1 f2 f3 p q material).

  (** A triangle of one side is one of the other's. *)
  Lemma SideIncluded labelled tid nei a b c d a' b' c' d' :
    VerticesAre f1 f2 f3 p q tid a b c d ->
    VerticesAre f1 f2 f3 p q nei a' b' c' d' ->
    CheckMaterialsIncluded labelled [F1; F2; F3]
      (SymbolicMaterials GetMaterialTets leader a b c d)
      (SymbolicMaterials GetMaterialTets leader a' b' c' d') = true ->
    forall m t x y z, In (m, t) (MaterialNames material shared tid) ->
      HasTriangle t x y z ->
      LiesIn (map locate [F1; F2; F3]) x -> LiesIn (map locate [F1; F2; F3]) y ->
      LiesIn (map locate [F1; F2; F3]) z ->
      exists n u, In (n, u) (MaterialNames material shared nei) /\
        HasTriangle u x y z /\ (labelled = true -> n = m).
  Proof.
    intros V V' K m t x y z I H Lx Ly Lz.
    pose proof (MaterialNamesNamed f1 f2 f3 p q material shared tid a b c d V) as E.
    pose proof (MaterialNamesNamed f1 f2 f3 p q material shared nei a' b' c' d' V')
      as E'.
    rewrite E in I. rewrite E'. clear E E'.
    apply in_map_iff in I as ([k s] & Es & I). unfold NameTet in Es. cbn [fst snd] in Es.
    injection Es as <- <-. rewrite OrientHasTriangle in H.
    destruct H as [(Hx & Hy & Hz) (Nxy & Nyz & Nxz)].
    assert (C : forall v, In v (TetCorners (MapTet name s)) ->
      exists r, In r (TetCorners s) /\ name r = v).
    { intros v J. destruct s. cbn [MapTet TetCorners In] in *.
      destruct J as [<-|[<-|[<-|[<-|[]]]]]; eexists; (split; [|reflexivity]); tauto. }
    apply C in Hx as (rx & Rx & <-). apply C in Hy as (ry & Ry & <-).
    apply C in Hz as (rz & Rz & <-). clear C.
    apply (LiesOnMaterialName f1 f2 f3 p q distinct) in Lx, Ly, Lz.
    assert (Hs : HasTriangle s rx ry rz) by (repeat split; try assumption; congruence).
    assert (On : TriangleOn [F1; F2; F3] (rx, ry, rz) = true)
      by (unfold TriangleOn; rewrite Lx, Ly, Lz; reflexivity).
    destruct (CheckMaterialsIncludedSound _ _ _ _ K k s rx ry rz I Hs On)
      as (Below & j & u & J & Hu & Same).
    exists (Meant (MaterialAt f1 f2 f3 p q material) (shared nei) j), (Orient (Hand nei) (MapTet name u)).
    split; [|split].
    - apply in_map_iff. exists (j, u). split; [reflexivity|exact J].
    - apply OrientHasTriangle. destruct Hu as [(Ux & Uy & Uz) _].
      assert (C : forall r, In r (TetCorners u) -> In (name r) (TetCorners (MapTet name u))).
      { intros r. destruct u. cbn [TetCorners MapTet In]. intuition congruence. }
      repeat split; try (apply C; assumption); assumption.
    - intros L. rewrite (Same L). specialize (Below L). apply MeantBelow; apply Below.
  Qed.
End Face.

Theorem MaterialFacesAgree :
  forall material shared tid i a b c,
    let face := FaceOf tid i in
    let here := MaterialNames material shared tid in
    let there := MaterialNames material shared (NeighborOf tid i) in
    LiesIn face a -> LiesIn face b -> LiesIn face c ->
    (AmongTriangles (map snd here) a b c <-> AmongTriangles (map snd there) a b c) /\
    ((exists f, In f face /\ material f <> None) -> forall m,
       AmongTriangles (OfMaterial m here) a b c <->
       AmongTriangles (OfMaterial m there) a b c).
Proof.
  intros material shared tid i a b c face here there La Lb Lc.
  destruct (FaceShared tid i) as (f1 & f2 & f3 & p & q & is_face & distinct & arranged).
  apply ArrangedLabels in arranged
    as (l1 & l2 & l3 & l4 & m1 & m2 & m3 & m4 & listed & vertices & vertices').
  assert (named : face = map (LocateFive f1 f2 f3 p q) [F1; F2; F3]) by exact is_face.
  rewrite named in La, Lb, Lc.
  pose proof MaterialFacesFit as K. unfold CheckMaterialFaces in K.
  rewrite forallb_forall in K. specialize (K _ listed). cbn [CheckMaterialFace] in K.
  apply (ForAllPatternsSound (MaterialAt f1 f2 f3 p q material)) in K.
  set (labelled := Labelled _ _) in K.
  apply andb_true_iff in K as [There Back].
  pose proof (SideIncluded material shared f1 f2 f3 p q distinct labelled tid
    (NeighborOf tid i) _ _ _ _ _ _ _ _ vertices vertices' There) as T.
  pose proof (SideIncluded material shared f1 f2 f3 p q distinct labelled
    (NeighborOf tid i) tid _ _ _ _ _ _ _ _ vertices' vertices Back) as B.
  fold here in T, B. fold there in T, B. split; [split|].
  - intros (t & I & H). apply InAllMaterials in I as (m & I).
    destruct (T m t a b c I H La Lb Lc) as (n & u & J & Hu & _).
    exists u. split; [apply InAllMaterials; eauto|exact Hu].
  - intros (t & I & H). apply InAllMaterials in I as (m & I).
    destruct (B m t a b c I H La Lb Lc) as (n & u & J & Hu & _).
    exists u. split; [apply InAllMaterials; eauto|exact Hu].
  - intros some m.
    assert (L : labelled = true)
      by (apply LabelledCorner; rewrite <- named; exact some).
    split; intros (t & I & H); apply InOfMaterial in I.
    + destruct (T m t a b c I H La Lb Lc) as (n & u & J & Hu & S).
      rewrite (S L) in J. exists u. split; [apply InOfMaterial, J|exact Hu].
    + destruct (B m t a b c I H La Lb Lc) as (n & u & J & Hu & S).
      rewrite (S L) in J. exists u. split; [apply InOfMaterial, J|exact Hu].
Qed.
