(** * What lies on a face follows from the face alone: proof

    The checker's verdict on symbols, for every order of the cuts, carried over
    to every structured tetrahedron of the lattice and every key of its edges. *)

From Certet Require Import Key.Definitions.
From Certet Require Import Lattice.StructuredTetProof Lattice.ArrangementProof
  Stencil.Symbol Stencil.SymbolProof Stencil.TriangleChecker
  Stencil.TriangleCheckerProof Stuffing.NameProof Stuffing.MeshProof
  Key.Orders Key.OrderProof Key.KeyChecker Key.KeysApartProof.
Open Scope Z_scope.

Lemma OrdersFit : ForAllCornerSigns (fun sign =>
  forallb (CheckOrdered sign) (Orders (CutsOf sign))) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma SamePairEqual x y : SamePair x y = true <-> x = y.
Proof.
  destruct x, y. unfold SamePair. cbn [fst snd].
  rewrite andb_true_iff, !SameLabelEqual. intuition congruence.
Qed.

Lemma ForAllCornerSignsSound test : ForAllCornerSigns test = true ->
  forall s1 s2 s3 sp, test (CornerSigns s1 s2 s3 sp) = true.
Proof.
  intros all s1 s2 s3 sp. do 4 (eapply ForAllSignsSound in all; cbn beta in all).
  exact all.
Qed.

Lemma OrderChecked s1 s2 s3 sp order :
  let sign := CornerSigns s1 s2 s3 sp in
  In order (Orders (CutsOf sign)) -> CheckOrdered sign order = true.
Proof.
  intros sign. pose proof (ForAllCornerSignsSound _ OrdersFit s1 s2 s3 sp) as C.
  cbv beta in C. rewrite forallb_forall in C. exact (C order).
Qed.

(** ** A structured tetrahedron by names *)

Lemma AtCorner f1 f2 f3 p q l :
  In l TetLabels -> In (LocateFive f1 f2 f3 p q l) [f1; f2; f3; p].
Proof. intros [<-|[<-|[<-|[<-|[]]]]]; cbn; tauto. Qed.

(** Three of its corners, in any order, are a face of symbols. *)
Lemma OrderedFaceNamed f1 f2 f3 p q g1 g2 g3 :
  NoDup [g1; g2; g3] -> incl [g1; g2; g3] [f1; f2; f3; p] ->
  let at_ := LocateFive f1 f2 f3 p q in
  exists l1 l2 l3, In (l1, l2, l3) OrderedFaces /\
    g1 = at_ l1 /\ g2 = at_ l2 /\ g3 = at_ l3.
Proof.
  intros different inside at_.
  assert (label : forall g, In g [f1; f2; f3; p] -> exists l,
    In l TetLabels /\ g = at_ l).
  { intros g [<-|[<-|[<-|[<-|[]]]]];
      [exists F1|exists F2|exists F3|exists P]; cbn; tauto. }
  destruct (label g1) as (l1 & L1 & E1); [apply inside; cbn; tauto|].
  destruct (label g2) as (l2 & L2 & E2); [apply inside; cbn; tauto|].
  destruct (label g3) as (l3 & L3 & E3); [apply inside; cbn; tauto|].
  exists l1, l2, l3. split; [|auto].
  apply filter_In. split; [repeat apply in_prod; assumption|].
  assert (ne : forall l m, at_ l <> at_ m -> negb (SameLabel l m) = true).
  { intros l m D. apply negb_true_iff, not_true_iff_false.
    intros S. apply SameLabelEqual in S. congruence. }
  inversion different as [|? ? D1 D2]. inversion D2 as [|? ? D3 _].
  cbn [In] in D1, D3. rewrite !ne; [reflexivity|..]; rewrite <- ?E1, <- ?E2, <- ?E3;
    intuition congruence.
Qed.

Section Named.
  Variables f1 f2 f3 p q : Coord3.
  Hypothesis distinct : NoDup [f1; f2; f3; p; q].
  Variables (key : Coord3 -> Coord3 -> Z) (before : SignField).
  Variables (warping : Coord3 -> Warping) (tid : StructuredTetId).
  Hypothesis vertices : VerticesAre f1 f2 f3 p q tid F1 F2 F3 P.
  Hypothesis apart : KeysApart key [f1; f2; f3; p].

  Local Notation at_ := (LocateFive f1 f2 f3 p q).
  Local Notation name := (Name f1 f2 f3 p q).
  Let after c := PlacedSign before warping (Corner c).

  Definition NamedSign : Label -> Sign :=
    CornerSigns (after f1) (after f2) (after f3) (after p).

  Definition LabelKey (a e : Label) : Z := key (at_ a) (at_ e).

  Definition NamedOrder : list (Label * Label) :=
    SortByKey (fun '(a, e) => LabelKey a e) (CutsOf NamedSign).

  Lemma NamedSignCorner l : In l TetLabels -> NamedSign l = after (at_ l).
  Proof. intros [<-|[<-|[<-|[<-|[]]]]]; reflexivity. Qed.

  Lemma NamedOrderListed : In NamedOrder (Orders (CutsOf NamedSign)).
  Proof. apply SortListed. Qed.

  Lemma InCuts a e : In a TetLabels -> In e TetLabels ->
    NamedSign a = Plus -> NamedSign e = Minus -> In (a, e) (CutsOf NamedSign).
  Proof.
    intros A E Sa Se. apply filter_In. split; [apply in_prod; assumption|].
    rewrite Sa, Se. reflexivity.
  Qed.

  (** Keys and ranks compare alike. *)
  Lemma RanksCompare a e b f :
    In a TetLabels -> In e TetLabels -> In b TetLabels -> In f TetLabels ->
    NamedSign a = Plus -> NamedSign e = Minus ->
    NamedSign b = Plus -> NamedSign f = Minus -> a = b \/ e = f ->
    (LabelKey a e <? LabelKey b f)
    = (RankKey NamedOrder a e <? RankKey NamedOrder b f).
  Proof.
    intros A E B F Sa Se Sb Sf shared.
    destruct (SamePair (a, e) (b, f)) eqn:S.
    { apply SamePairEqual in S. injection S as -> ->. rewrite !Z.ltb_irrefl. reflexivity. }
    assert (N : (a, e) <> (b, f)) by (intros same; rewrite same in S;
      rewrite (proj2 (SamePairEqual _ _) eq_refl) in S; discriminate S).
    symmetry. unfold RankKey, NamedOrder.
    apply (RankCompares SamePair SamePairEqual (fun '(a, e) => LabelKey a e));
      try (apply InCuts; assumption).
    unfold LabelKey.
    assert (D : forall l m, l <> m -> at_ l <> at_ m)
      by (intros l m ne same; apply ne; exact (LocateInjective f1 f2 f3 p q distinct l m same)).
    destruct shared as [<- | <-].
    - refine (proj2 (apart (at_ e) (at_ f) (at_ a) _ _ _ _ _ _));
        try (apply AtCorner; assumption); apply D; congruence.
    - refine (proj1 (apart (at_ a) (at_ b) (at_ e) _ _ _ _ _ _));
        try (apply AtCorner; assumption); apply D; congruence.
  Qed.

  Lemma LabelledTets a b c d :
    (forall l, In l [a; b; c; d] -> In l TetLabels) ->
    GetKeyTets MeshVertex (PlacedSign before warping) MeshIntersection (MeshKey key)
      (name (Base a)) (name (Base b)) (name (Base c)) (name (Base d))
    = map (MapTet name)
        (GetKeyTets Symbol (SymbolSign NamedSign) SymbolIntersection
           (SymbolKey (RankKey NamedOrder)) (Base a) (Base b) (Base c) (Base d)).
  Proof.
    intros labels.
    assert (base : forall v, In v [Base a; Base b; Base c; Base d] ->
      exists l, v = Base l /\ In l TetLabels).
    { cbn [In]. intros v I.
      repeat (destruct I as [<-|I]; [eexists; split; [reflexivity|];
        apply labels; cbn [In]; tauto|]). destruct I. }
    rewrite (KeyTetsNatural name (SymbolSign NamedSign) (PlacedSign before warping)
      SymbolIntersection MeshIntersection (SymbolKey LabelKey) (MeshKey key)).
    - f_equal. apply KeyTetsAlike. intros x e y f Ix Ie Iy If.
      destruct (base x Ix) as (lx & -> & Lx), (base e Ie) as (le & -> & Le),
        (base y Iy) as (ly & -> & Ly), (base f If) as (lf & -> & Lf).
      cbn [SymbolSign SymbolKey]. intros. apply RanksCompare; try assumption.
      intuition congruence.
    - intros v I. destruct (base v I) as (l & -> & L). rewrite NameBase.
      cbn [SymbolSign]. rewrite NamedSignCorner by exact L. reflexivity.
    - intros v w Iv Iw. destruct (base v Iv) as (l & -> & _), (base w Iw) as (m & -> & _).
      cbn [SymbolIntersection]. rewrite !NameBase, NameCut. reflexivity.
    - intros v w Iv Iw. destruct (base v Iv) as (l & -> & _), (base w Iw) as (m & -> & _).
      rewrite !NameBase. reflexivity.
  Qed.

  Definition NamedRanked : list SymbolicTet := RankedTets NamedSign NamedOrder.

  Lemma OrderedNamed : exists h, OrderedNames key before warping tid
    = map (fun t => Orient h (MapTet name t)) NamedRanked.
  Proof.
    revert vertices. unfold VerticesAre, OrderedNames. destruct tid as [anchor case].
    destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4].
    intros (-> & -> & -> & ->). exists (CaseHandedness case).
    rewrite <- !NameBase, LabelledTets by (cbn; tauto). apply map_map.
  Qed.

  (** Of any tetrahedra that are so named. *)
  Variable names : list (UnstructuredTet MeshVertex).
  Hypothesis named : exists h, names = map (fun t => Orient h (MapTet name t)) NamedRanked.

  Lemma AmongNamed x y z :
    AmongTriangles names (name x) (name y) (name z) <-> AmongTriangles NamedRanked x y z.
  Proof.
    destruct named as [h ->]. split.
    - intros (t & inside & has). apply in_map_iff in inside as (s & <- & inside).
      exists s. split; [easy|].
      now apply (HasTriangleName f1 f2 f3 p q distinct), (OrientHasTriangle h).
    - intros (s & inside & has). exists (Orient h (MapTet name s)). split.
      + apply in_map_iff. eauto.
      + now apply OrientHasTriangle, (HasTriangleName f1 f2 f3 p q distinct).
  Qed.

  Lemma NamedChecked : CheckOrdered NamedSign NamedOrder = true.
  Proof. apply OrderChecked, NamedOrderListed. Qed.

  Lemma NamedFits : FitsInside NamedSign NamedRanked.
  Proof.
    pose proof NamedChecked as C. unfold CheckOrdered in C.
    rewrite !andb_true_iff, !forallb_forall in C.
    destruct C as [[[[inner closed] stays] faces] _].
    constructor; try assumption; intros face inside;
      now apply faces, andb_true_iff in inside.
  Qed.

  (** ** The face's own rule *)

  Definition NameTriangle (t : TriangleChecker.Triangle)
    : FaceRule.Triangle MeshVertex :=
    let '(x, y, z) := t in (name x, name y, name z).

  Lemma LabelledTriangles a b c :
    In a TetLabels -> In b TetLabels -> In c TetLabels ->
    FaceTriangles MeshVertex (PlacedSign before warping) MeshIntersection (MeshKey key)
      (Corner (at_ a)) (Corner (at_ b)) (Corner (at_ c))
    = map NameTriangle (RankedTriangles NamedSign NamedOrder a b c).
  Proof.
    intros A B C. unfold RankedTriangles, FaceTriangles. cbn [SymbolSign].
    rewrite !NamedSignCorner by assumption. unfold after.
    destruct (PlacedSign before warping (Corner (at_ a))) eqn:Sa,
      (PlacedSign before warping (Corner (at_ b))) eqn:Sb,
      (PlacedSign before warping (Corner (at_ c))) eqn:Sc;
      try (cbn [map NameTriangle SymbolIntersection MeshIntersection];
           rewrite ?NameBase, ?NameCut; reflexivity).
    all: unfold Halves, Before; cbn [MeshKey SymbolKey SymbolIntersection MeshIntersection];
      match goal with |- context [key ?x ?e <? key ?y ?e] => idtac end.
    all: fold (LabelKey a c) (LabelKey b c) (LabelKey a b) (LabelKey c b)
           (LabelKey b a) (LabelKey c a);
      rewrite RanksCompare; try assumption; try (right; reflexivity);
      try (rewrite NamedSignCorner by assumption; assumption);
      match goal with |- context [if ?t then _ else _] => destruct t end;
      cbn [map NameTriangle]; rewrite ?NameBase, ?NameCut; reflexivity.
  Qed.

  Lemma SomeTriangleHasMeans ts a b c :
    SomeTriangleHas ts (a, b, c) = true <->
    exists x y z, In (x, y, z) ts /\
      In a [x; y; z] /\ In b [x; y; z] /\ In c [x; y; z].
  Proof.
    unfold SomeTriangleHas. rewrite existsb_exists. split.
    - intros ([[x y] z] & I & H). unfold InTriangle in H.
      rewrite !andb_true_iff, !MemberIn in H. exists x, y, z. tauto.
    - intros (x & y & z & I & H). exists (x, y, z). split; [exact I|].
      unfold InTriangle. rewrite !andb_true_iff, !MemberIn. tauto.
  Qed.

  Lemma NamedFaceRule l1 l2 l3 : In (l1, l2, l3) OrderedFaces ->
    (exists f, In f [at_ l1; at_ l2; at_ l3] /\ after f = Plus) ->
    forall a b c, LiesIn [at_ l1; at_ l2; at_ l3] a ->
      LiesIn [at_ l1; at_ l2; at_ l3] b -> LiesIn [at_ l1; at_ l2; at_ l3] c ->
      AmongTriangles names a b c <->
      OnFace key before warping (at_ l1) (at_ l2) (at_ l3) a b c.
  Proof.
    intros listed plus a b c in_a in_b in_c.
    assert (labels : In l1 TetLabels /\ In l2 TetLabels /\ In l3 TetLabels).
    { apply filter_In in listed. destruct listed as [listed _].
      apply in_prod_iff in listed. destruct listed as [listed ?].
      apply in_prod_iff in listed. tauto. }
    destruct labels as (L1 & L2 & L3).
    set (face := [l1; l2; l3]).
    change [at_ l1; at_ l2; at_ l3] with (map at_ face) in *.
    destruct (LiesInName _ _ _ _ _ _ _ in_a) as [sa ->].
    destruct (LiesInName _ _ _ _ _ _ _ in_b) as [sb ->].
    destruct (LiesInName _ _ _ _ _ _ _ in_c) as [sc ->].
    rewrite AmongNamed. unfold OnFace.
    rewrite (LabelledTriangles l1 l2 l3 L1 L2 L3).
    pose proof NamedChecked as C. unfold CheckOrdered in C.
    rewrite !andb_true_iff in C. destruct C as [_ C].
    rewrite forallb_forall in C. specialize (C _ listed).
    unfold CheckFaceRule in C. fold face in C.
    assert (some : SomePlus NamedSign face = true).
    { apply existsb_exists. destruct plus as (f & I & S).
      unfold face in I. cbn [map In] in I.
      destruct I as [<-|[<-|[<-|[]]]];
        [exists l1|exists l2|exists l3]; (split; [cbn; tauto|]);
        rewrite NamedSignCorner, S by assumption; reflexivity. }
    rewrite some in C. apply andb_true_iff in C. destruct C as [there back].
    assert (on : TriangleOn face (sa, sb, sc) = true)
      by (apply (TriangleOnLiesIn f1 f2 f3 p q distinct); auto).
    assert (ne : forall s r, name s <> name r <-> s <> r).
    { split; [congruence|intros differ same; apply differ].
      exact (NameInjective f1 f2 f3 p q distinct s r same). }
    split.
    - intros (t & inside & has).
      pose proof (ForAllTriangles _ _ there t sa sb sc inside has) as found.
      cbv beta in found. rewrite on in found. cbn [negb orb] in found.
      apply SomeTriangleHasMeans in found. destruct found as (x & y & z & I & H).
      exists (name x), (name y), (name z). split.
      + change (name x, name y, name z) with (NameTriangle (x, y, z)).
        apply in_map, I.
      + change [name x; name y; name z] with (map name [x; y; z]).
        rewrite !(InNames f1 f2 f3 p q distinct), !ne. destruct has. tauto.
    - intros (x' & y' & z' & I & H). apply in_map_iff in I.
      destruct I as ([[x y] z] & E & I). injection E as <- <- <-.
      change [name x; name y; name z] with (map name [x; y; z]) in H.
      rewrite !(InNames f1 f2 f3 p q distinct), !ne in H.
      rewrite forallb_forall in back. specialize (back _ I).
      apply existsb_exists in back. destruct back as (t & inside & has).
      exists t. split; [exact inside|].
      unfold Has in has. rewrite !andb_true_iff, !MemberIn in has.
      destruct has as [[Hx Hy] Hz]. destruct H as [(Ha & Hb & Hc) D].
      split; [|exact D]. cbn [In] in Ha, Hb, Hc.
      repeat split; match goal with
      | H : _ \/ _ |- In ?s _ => destruct H as [<-|[<-|[<-|[]]]]; assumption
      end.
  Qed.
End Named.

(** ** Any structured tetrahedron *)

Lemma CornersNamed tid : exists f1 f2 f3 p q,
  NoDup [f1; f2; f3; p; q] /\ VerticesAre f1 f2 f3 p q tid F1 F2 F3 P /\
  Corners tid = [f1; f2; f3; p].
Proof.
  destruct (VerticesNamed tid) as (f1 & f2 & f3 & p & q & D & V).
  exists f1, f2, f3, p, q. split; [exact D|]. split; [exact V|].
  unfold VerticesAre in V. unfold Corners. destruct (GetStructuredTet tid).
  destruct V as (-> & -> & -> & ->). reflexivity.
Qed.

(** What is made within it, on symbols. *)
Lemma OrderedViewed key before warping tid : KeysApart key (Corners tid) ->
  exists h f1 f2 f3 p q,
    NoDup [f1; f2; f3; p; q] /\ VerticesAre f1 f2 f3 p q tid F1 F2 F3 P /\
    Corners tid = [f1; f2; f3; p] /\
    OrderedNames key before warping tid
    = map (fun s => Orient h (MapTet (Name f1 f2 f3 p q) s))
        (NamedRanked f1 f2 f3 p q key before warping).
Proof.
  intros apart. destruct (CornersNamed tid) as (f1 & f2 & f3 & p & q & D & V & C).
  rewrite C in apart.
  destruct (OrderedNamed f1 f2 f3 p q D key before warping tid V apart) as [h N].
  exists h, f1, f2, f3, p, q. auto.
Qed.

(** What a checker finds in every order holds of it. *)
Definition InEveryOrder (check : (Label -> Sign) -> list SymbolicTet -> bool) : Prop :=
  ForAllCornerSigns (fun sign =>
    forallb (fun order => check sign (RankedTets sign order))
      (Orders (CutsOf sign))) = true.

Lemma RankedChecked check f1 f2 f3 p q key before warping : InEveryOrder check ->
  check (NamedSign f1 f2 f3 p before warping)
    (NamedRanked f1 f2 f3 p q key before warping) = true.
Proof.
  intros all. pose proof (ForAllCornerSignsSound _ all
    (PlacedSign before warping (Corner f1)) (PlacedSign before warping (Corner f2))
    (PlacedSign before warping (Corner f3)) (PlacedSign before warping (Corner p))) as C.
  cbv beta in C. rewrite forallb_forall in C.
  exact (C _ (NamedOrderListed _ _ _ _ _ _ _ _)).
Qed.

(** ** Every face of every structured tetrahedron *)

Section Face.
  Variables (key : Coord3 -> Coord3 -> Z) (before : SignField).
  Variable warping : Coord3 -> Warping.

  Theorem StencilFaceIsFaceRule tid f1 f2 f3 :
    NoDup [f1; f2; f3] -> incl [f1; f2; f3] (Corners tid) ->
    KeysApart key (Corners tid) ->
    (exists f, In f [f1; f2; f3] /\ PlacedSign before warping (Corner f) = Plus) ->
    forall a b c, LiesIn [f1; f2; f3] a -> LiesIn [f1; f2; f3] b ->
      LiesIn [f1; f2; f3] c ->
      AmongTriangles (OrderedNames key before warping tid) a b c <->
      OnFace key before warping f1 f2 f3 a b c.
  Proof.
    intros different face apart plus.
    destruct (CornersNamed tid) as (g1 & g2 & g3 & p & q & distinct & vertices & corners).
    rewrite corners in apart, face.
    destruct (OrderedFaceNamed g1 g2 g3 p q f1 f2 f3 different face)
      as (l1 & l2 & l3 & listed & -> & -> & ->).
    exact (NamedFaceRule g1 g2 g3 p q distinct key before warping apart _
             (OrderedNamed g1 g2 g3 p q distinct key before warping tid vertices apart)
             l1 l2 l3 listed plus).
  Qed.

  (** Both neighbours have the corners of their face. *)
  Lemma FaceOfBoth tid i : exists f1 f2 f3,
    FaceOf tid i = [f1; f2; f3] /\ NoDup [f1; f2; f3] /\
    incl [f1; f2; f3] (Corners tid) /\ incl [f1; f2; f3] (Corners (NeighborOf tid i)).
  Proof.
    destruct (FaceShared tid i) as (f1 & f2 & f3 & p & q & is_face & distinct & arranged).
    exists f1, f2, f3. split; [exact is_face|]. split.
    - repeat match goal with H : NoDup (_ :: _) |- _ =>
        apply NoDup_cons_iff in H as [? H]; cbn [In] in * end.
      repeat constructor; cbn; intuition congruence.
    - unfold Corners, NeighborOf.
      destruct (GetStructuredTet tid),
        (GetStructuredTet (fst (NeighborAcross _ i))).
      split; intros x I; destruct arranged; cbn [In] in *; intuition congruence.
  Qed.

  Theorem OrderedFacesAgree tid i :
    KeysApart key (Corners tid) -> KeysApart key (Corners (NeighborOf tid i)) ->
    let face := FaceOf tid i in
    (exists f, In f face /\ PlacedSign before warping (Corner f) = Plus) ->
    forall a b c, LiesIn face a -> LiesIn face b -> LiesIn face c ->
      AmongTriangles (OrderedNames key before warping tid) a b c <->
      AmongTriangles (OrderedNames key before warping (NeighborOf tid i)) a b c.
  Proof.
    intros here there face plus a b c in_a in_b in_c. unfold face in *. clear face.
    destruct (FaceOfBoth tid i) as (f1 & f2 & f3 & is_face & distinct & I & I').
    rewrite is_face in plus, in_a, in_b, in_c.
    rewrite (StencilFaceIsFaceRule tid f1 f2 f3), (StencilFaceIsFaceRule _ f1 f2 f3);
      assumption || reflexivity.
  Qed.
End Face.

Theorem KeyFacesAgree before warping cut tid i :
  let face := FaceOf tid i in
  (exists f, In f face /\ PlacedSign before warping (Corner f) = Plus) ->
  forall a b c, LiesIn face a -> LiesIn face b -> LiesIn face c ->
    AmongTriangles (KeyNames before warping cut tid) a b c <->
    AmongTriangles (KeyNames before warping cut (NeighborOf tid i)) a b c.
Proof. apply OrderedFacesAgree; apply CutKeysApart. Qed.
