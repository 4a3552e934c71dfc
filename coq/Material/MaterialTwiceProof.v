(** * Every triangle belongs to two tetrahedra

    Or to one, if it lies on a face of the structured tetrahedron: the other
    side of that face then has the second, by [MaterialFacesAgree]. *)

From Certet Require Import Material.Definitions.
From Certet Require Import Stencil.Symbol Stencil.TriangleChecker
  Stencil.TriangleCheckerProof Stuffing.NameProof Stuffing.MeshProof
  Material.MaterialChecker Material.MaterialNameProof
  Material.MaterialMeshProof.
Open Scope Z_scope.

Section Names.
  Variable material : MaterialField.
  Variables f1 f2 f3 p q : Coord3.
  Hypothesis distinct : NoDup [f1; f2; f3; p; q].

  Local Notation locate := (LocateFive f1 f2 f3 p q).
  Local Notation name := (MaterialName f1 f2 f3 p q material).

  Lemma OrderedNamesApart s r :
    Ordered s = true -> Ordered r = true -> name s = name r -> s = r.
  Proof.
    assert (L : forall a b, locate a = locate b -> a = b)
      by (apply LocateInjective, distinct).
    destruct s as [l|a b], r as [k|c d]; cbn [MaterialName Ordered]; intros O O' E.
    - injection E as E. f_equal. apply L, E.
    - destruct (MaterialCutNamed material (locate c) (locate d)) as [X|X];
        rewrite X in E; discriminate E.
    - destruct (MaterialCutNamed material (locate a) (locate b)) as [X|X];
        rewrite X in E; discriminate E.
    - apply Z.ltb_lt in O, O'.
      destruct (MaterialCutNamed material (locate a) (locate b)) as [X|X],
        (MaterialCutNamed material (locate c) (locate d)) as [Y|Y];
        rewrite X, Y in E; injection E as E1 E2; apply L in E1, E2; subst;
        reflexivity || lia.
  Qed.

  Definition OrderedTet (t : SymbolicTet) : Prop :=
    forall s, In s (TetCorners t) -> Ordered s = true.

  Lemma NamedCorner t v : In v (TetCorners (MapTet name t)) <->
    exists s, In s (TetCorners t) /\ name s = v.
  Proof.
    assert (E : TetCorners (MapTet name t) = map name (TetCorners t))
      by (destruct t; reflexivity).
    rewrite E, in_map_iff. firstorder.
  Qed.

  Lemma TriangleNamed t a b c : OrderedTet t ->
    HasTriangle (MapTet name t) a b c ->
    exists x y z, a = name x /\ b = name y /\ c = name z /\ HasTriangle t x y z.
  Proof.
    intros O [(Ha & Hb & Hc) N].
    apply NamedCorner in Ha as (x & X & <-). apply NamedCorner in Hb as (y & Y & <-).
    apply NamedCorner in Hc as (z & Z & <-). exists x, y, z.
    repeat (split; [reflexivity|]). repeat split; try assumption; intros ->; tauto.
  Qed.

  Lemma NamedTriangle t x y z : OrderedTet t ->
    Ordered x = true -> Ordered y = true -> Ordered z = true ->
    x <> y -> y <> z -> x <> z ->
    HasTriangle (MapTet name t) (name x) (name y) (name z) <-> HasTriangle t x y z.
  Proof.
    intros O Ox Oy Oz Nxy Nyz Nxz.
    assert (C : forall r, Ordered r = true ->
      In (name r) (TetCorners (MapTet name t)) <-> In r (TetCorners t)).
    { intros r Or. rewrite NamedCorner. split; [|eauto].
      intros (s & I & E). apply OrderedNamesApart in E; [subst; exact I| |exact Or].
      apply O, I. }
    unfold HasTriangle. rewrite !C by assumption.
    split; intros [I N]; (split; [exact I|]); [repeat split; assumption|].
    repeat split; intros E; apply OrderedNamesApart in E; tauto.
  Qed.

  Lemma NamedTetsApart t u : OrderedTet t -> OrderedTet u ->
    MapTet name t = MapTet name u -> t = u.
  Proof.
    destruct t as [a b c d], u as [a' b' c' d']. unfold OrderedTet.
    cbn [TetCorners In MapTet]. intros O O' E.
    injection E as E1 E2 E3 E4. f_equal; apply OrderedNamesApart;
      (apply O; tauto) || (apply O'; tauto) || assumption.
  Qed.
End Names.

Theorem MaterialTriangleTwice :
  forall material shared tid t a b c,
    let here := MaterialNames material shared tid in
    In t here -> HasTriangle (snd t) a b c ->
    ((exists i, LiesIn (FaceOf tid i) a /\ LiesIn (FaceOf tid i) b /\
        LiesIn (FaceOf tid i) c) /\
     forall u, In u here -> HasTriangle (snd u) a b c -> u = t) \/
    (exists u, In u here /\ snd u <> snd t /\ HasTriangle (snd u) a b c /\
       forall w, In w here -> HasTriangle (snd w) a b c -> w = t \/ w = u).
Proof.
  intros material shared tid t a b c here I H.
  destruct (VerticesNamed tid) as (f1 & f2 & f3 & p & q & distinct & vertices).
  unfold here in *. clear here.
  rewrite (MaterialNamesNamed f1 f2 f3 p q material shared tid F1 F2 F3 P vertices) in *.
  unfold NamedMaterials in *.
  pose proof MaterialInsideFits as K. unfold CheckMaterialInside in K.
  apply (ForAllPatternsSound (MaterialAt f1 f2 f3 p q material)) in K.
  apply andb_true_iff in K as [Twice Order].
  set (ts := SymbolicMaterials GetMaterialTets _ F1 F2 F3 P) in *. clearbody ts.
  assert (O : forall u, In u ts -> OrderedTet (snd u)).
  { intros u J s C. rewrite forallb_forall in Order. specialize (Order u J).
    rewrite forallb_forall in Order. exact (Order s C). }
  clear Order. set (name := MaterialName f1 f2 f3 p q material) in *.
  set (rename := NameTet f1 f2 f3 p q material shared tid) in *.
  apply in_map_iff in I as (t' & <- & I).
  assert (R : forall u x y z, HasTriangle (snd (rename u)) x y z
    <-> HasTriangle (MapTet name (snd u)) x y z)
    by (intros u x y z; apply OrientHasTriangle).
  apply R in H. pose proof (O t' I) as Ot.
  destruct (TriangleNamed material f1 f2 f3 p q _ a b c Ot H)
    as (x & y & z & -> & -> & -> & T). clear H.
  pose proof T as [(Ix & Iy & Iz) (Nxy & Nyz & Nxz)].
  assert (N : forall u, In u ts ->
    HasTriangle (snd (rename u)) (name x) (name y) (name z)
    <-> HasTriangle (snd u) x y z).
  { intros u J. rewrite R.
    apply (NamedTriangle material f1 f2 f3 p q distinct); auto. }
  unfold CheckTwice in Twice. rewrite forallb_forall in Twice.
  specialize (Twice t' I). rewrite forallb_forall in Twice.
  specialize (Twice (x, y, z) (proj2 (TrianglesHasTriangle _ x y z) T)).
  assert (Own : forall u, In u (filter (fun u => Has (snd u) (x, y, z)) ts)
    <-> In u ts /\ HasTriangle (snd u) x y z).
  { intros u. rewrite filter_In, (HasHasTriangle _ (snd u) x y z T). reflexivity. }
  pose proof (proj2 (Own t') (conj I T)) as J.
  destruct (filter _ ts) as [|u [|w [|]]]; try discriminate Twice;
    destruct (existsb _ Faces) eqn:On; try discriminate Twice.
  - left. destruct J as [<-|[]]. split.
    + apply existsb_exists in On as (face & L & On).
      destruct (NamedFace f1 f2 f3 p q tid face vertices L) as [i Ei].
      exists i. rewrite Ei. cbn [TriangleOn] in On. rewrite !andb_true_iff in On.
      destruct On as [[Lx Ly] Lz].
      apply (LiesOnMaterialName f1 f2 f3 p q distinct material) in Lx, Ly, Lz. auto.
    + intros v V Hv. apply in_map_iff in V as (v' & <- & V).
      apply (N v' V) in Hv. destruct (proj2 (Own v') (conj V Hv)) as [<-|[]]. reflexivity.
  - right. apply SameTetDiffers in Twice.
    assert (Pair : forall k l, (k = u /\ l = w) \/ (k = w /\ l = u) -> k = t' ->
      exists v, In v (map rename ts) /\ snd v <> snd (rename t') /\
        HasTriangle (snd v) (name x) (name y) (name z) /\
        forall v', In v' (map rename ts) ->
          HasTriangle (snd v') (name x) (name y) (name z) -> v' = rename t' \/ v' = v).
    { intros k l KL ->.
      assert (Il : In l ts /\ HasTriangle (snd l) x y z)
        by (apply Own; cbn; destruct KL as [[_ ->]|[_ ->]]; tauto).
      destruct Il as [Il Hl]. exists (rename l). split; [apply in_map, Il|].
      split; [|split].
      - intros E. apply OrientInjective in E.
        apply (NamedTetsApart material f1 f2 f3 p q distinct) in E;
          [|apply O, Il|exact Ot].
        destruct KL as [[-> ->]|[-> ->]]; congruence.
      - apply (N l Il), Hl.
      - intros v' V Hv. apply in_map_iff in V as (v & <- & V). apply (N v V) in Hv.
        pose proof (proj2 (Own v) (conj V Hv)) as [<-|[<-|[]]];
          destruct KL as [[-> ->]|[-> ->]]; auto. }
    destruct J as [E|[E|[]]].
    + exact (Pair u w (or_introl (conj eq_refl eq_refl)) E).
    + exact (Pair w u (or_intror (conj eq_refl eq_refl)) E).
Qed.
