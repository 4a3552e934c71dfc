(** * The surface within one structured tetrahedron

    [StencilSurface] looked at all sign patterns on symbols; here the same is said
    of the mesh. *)

From Coq Require Import ZArith List Bool Lia.
From Certet Require Import Lattice.Definitions Stencil.Definitions
  Warp.Definitions Stuffing.Definitions Angles.Definitions Embedding.Definitions
  Topology.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stencil.TriangleChecker
  Stencil.TriangleCheckerProof Stuffing.NameProof Embedding.EdgeRank
  Embedding.MeshApartProof Embedding.LeavingProof Topology.StencilSurface.
Import ListNotations.

(** ** What checks of lists tell *)

Lemma FourLabelsMeans test a b c d : FourLabels test = true ->
  In a Four -> In b Four -> In c Four -> In d Four -> NoDup [a; b; c; d] ->
  test a b c d = true.
Proof.
  unfold FourLabels. intros C A B Cc Dd N. rewrite forallb_forall in C.
  specialize (C a A). rewrite forallb_forall in C.
  specialize (C b B). rewrite forallb_forall in C.
  specialize (C c Cc). rewrite forallb_forall in C. specialize (C d Dd).
  assert (E : SameLabel a b || SameLabel a c || SameLabel a d || SameLabel b c ||
    SameLabel b d || SameLabel c d = false); [|rewrite E in C; exact C].
  apply NoDup_cons_iff in N. destruct N as [Na N].
  apply NoDup_cons_iff in N. destruct N as [Nb N].
  apply NoDup_cons_iff in N. destruct N as [Nc _]. cbn [In] in *.
  assert (F : forall x y, x <> y -> SameLabel x y = false).
  { intros x y D. apply not_true_iff_false. rewrite SameLabelEqual. exact D. }
  rewrite !F by intuition. reflexivity.
Qed.

Lemma OneMeans {A} (test : A -> bool) (l : list A) :
  match filter test l with [_] => true | _ => false end = true ->
  exists x, In x l /\ test x = true /\
    forall y, In y l -> test y = true -> y = x.
Proof.
  intros O.
  assert (M : forall y, In y (filter test l) <-> In y l /\ test y = true)
    by (intros y; apply filter_In).
  destruct (filter test l) as [|x [|? ?]]; try discriminate O. cbn [In] in M.
  exists x. split; [apply M; auto|]. split; [apply M; auto|].
  intros y I T. destruct (proj2 (M y) (conj I T)) as [E|[]]. congruence.
Qed.

Lemma OneMoreMeans test l s : OneMore s (filter test l) = true ->
  exists r, r <> s /\ In r l /\ test r = true /\
    forall y, In y l -> test y = true -> y = s \/ y = r.
Proof.
  intros O.
  assert (M : forall y, In y (filter test l) <-> In y l /\ test y = true)
    by (intros y; apply filter_In).
  destruct (filter test l) as [|x [|y [|? ?]]]; try discriminate O. cbn [In] in M.
  cbn [OneMore] in O. apply andb_prop in O. destruct O as [N O].
  apply SameSymbolDiffers in N. apply orb_prop in O.
  destruct O as [O|O]; apply SameSymbolEqual in O; subst.
  - exists y. split; [congruence|]. split; [apply M; auto|]. split; [apply M; auto|].
    intros z I T. destruct (proj2 (M z) (conj I T)) as [E|[E|[]]]; auto.
  - exists x. split; [congruence|]. split; [apply M; auto|]. split; [apply M; auto|].
    intros z I T. destruct (proj2 (M z) (conj I T)) as [E|[E|[]]]; auto.
Qed.

(** ** In points *)

(** Where + and other points meet: the cut, or the 0 corner. *)
Definition CrossingAt (after : Coord3 -> Sign) (e f : Coord3) : MeshVertex :=
  match after f with Minus => Cut e f | _ => Corner f end.

(** On the face with the cut from [a] to [m]: the other vertex on the surface. *)
Definition ThirdAt (after : Coord3 -> Sign) (a m c : Coord3) : MeshVertex :=
  match after c with Plus => Cut c m | Minus => Cut a c | OnSurface => Corner c end.

(** Every corner is an end of one of these. *)
Definition Reach (corners : list Coord3) (vs : list MeshVertex) : Prop :=
  forall c, In c corners -> exists v, In v vs /\ In c (Ends v).

Section Mesh.
  Variables (before : SignField) (warping : Coord3 -> Warping).

  Local Notation after := (SignAfter before warping).
  Local Notation names := (PlacedNames before warping).
  Local Notation placed := (PlacedSign before warping).

  (** A vertex of this structured tetrahedron, on the surface. *)
  Definition OnIt (tid : StructuredTetId) (x : MeshVertex) : Prop :=
    Belongs after (Corners tid) x /\ placed x = OnSurface.

  (** A triangle in it, on the surface. *)
  Definition LocalTriangle (tid : StructuredTetId) (x y z : MeshVertex) : Prop :=
    AmongTriangles (names tid) x y z /\
    placed x = OnSurface /\ placed y = OnSurface /\ placed z = OnSurface.

  Lemma LocalOnIt tid x y z : InLattice tid -> LocalTriangle tid x y z ->
    OnIt tid x /\ OnIt tid y /\ OnIt tid z.
  Proof.
    intros E [(t & I & ((X & Y & Z) & _)) S].
    pose proof (proj1 (StuffedFollows before warping tid t E I)) as F.
    unfold OnIt. fold after in F. repeat split; try apply F; tauto.
  Qed.

  Lemma AmongTurned ts (x y z : MeshVertex) : AmongTriangles ts x y z ->
    AmongTriangles ts y x z /\ AmongTriangles ts x z y.
  Proof.
    intros (t & I & (A & B) & N). unfold AmongTriangles, HasTriangle.
    split; exists t; repeat split; try tauto; intuition congruence.
  Qed.

  Lemma LocalTurned tid x y z : LocalTriangle tid x y z ->
    LocalTriangle tid y x z /\ LocalTriangle tid x z y.
  Proof.
    unfold LocalTriangle. intros [A S]. apply AmongTurned in A. tauto.
  Qed.

  (** ** A view on symbols *)

  Section View.
    Variables (tid : StructuredTetId) (h : Handedness) (f1 f2 f3 p q : Coord3).
    Variable sign : Label -> Sign.

    Let name := Name f1 f2 f3 p q.
    Let at_ := LocateFive f1 f2 f3 p q.
    Let ts := SymbolicTets GetUnstructuredTets sign F1 F2 F3 P.

    Hypothesis Apart : NoDup [f1; f2; f3; p; q].
    Hypothesis Points : Corners tid = [f1; f2; f3; p].
    Hypothesis Signs : forall l, In l Four -> after (at_ l) = sign l.
    Hypothesis Named : names tid = map (fun s => Orient h (MapTet name s)) ts.
    Hypothesis Fits : CheckSurface sign ts = true.

    Lemma AtInjective l m : at_ l = at_ m -> l = m.
    Proof. apply (LocateInjective f1 f2 f3 p q Apart). Qed.

    Lemma AtIn c : In c (Corners tid) <-> exists l, In l Four /\ c = at_ l.
    Proof.
      rewrite Points. change [f1; f2; f3; p] with (map at_ Four). rewrite in_map_iff.
      split; intros (l & A & B); exists l; auto.
    Qed.

    Lemma AtIs s l : In l Four -> Is sign s l = true <-> after (at_ l) = s.
    Proof. intros L. unfold Is. rewrite IsSignEqual, Signs by exact L. tauto. Qed.

    Lemma InAll s : In s AllSymbols <->
      match s with Base a => In a Four | CutOf a m => In a Four /\ In m Four end.
    Proof.
      unfold AllSymbols. rewrite in_app_iff, !in_map_iff. split.
      - intros [(l & <- & I)|([a m] & <- & I)]; [exact I|]. apply in_prod_iff, I.
      - destruct s as [a|a m]; intros I; [left; exists a; auto|].
        right. exists (a, m). split; [reflexivity|]. apply in_prod_iff, I.
    Qed.

    Lemma ValidOn s : In s (Valids sign) -> OnIt tid (name s).
    Proof.
      unfold Valids, OnIt. rewrite filter_In, InAll. intros [A V]. unfold name.
      destruct s as [a|a m]; rewrite ?NameBase, ?NameCut; fold at_.
      - apply (AtIs OnSurface a A) in V. unfold SignAfter in V.
        split; [|exact V]. split; [apply AtIn; eauto|]. unfold SignAfter. congruence.
      - cbn [Valid] in V. apply andb_prop in V. destruct A as [A M], V as [V W].
        apply (AtIs _ _ A) in V. apply (AtIs _ _ M) in W.
        split; [|reflexivity]. repeat split; try apply AtIn; eauto.
    Qed.

    Lemma OnValid x : OnIt tid x -> exists s, In s (Valids sign) /\ x = name s.
    Proof.
      intros [B S]. unfold Valids, name. destruct x as [c|a m]; cbn [Belongs] in B.
      - destruct B as [I _]. apply AtIn in I. destruct I as (l & L & ->).
        exists (Base l). rewrite NameBase, filter_In, InAll. repeat split; auto.
        apply AtIs; assumption.
      - destruct B as (A & M & Sa & Sm). apply AtIn in A, M.
        destruct A as (l & L & ->), M as (k & K & ->).
        exists (CutOf l k). rewrite NameCut, filter_In, InAll. repeat split; auto.
        cbn [Valid]. apply andb_true_intro. split; apply AtIs; assumption.
    Qed.

    Lemma NameDiffers s r : name s = name r <-> s = r.
    Proof.
      split; [apply (NameInjective f1 f2 f3 p q Apart)|intros ->; reflexivity].
    Qed.

    Lemma TriangleNamed s r u : In s (Valids sign) -> In r (Valids sign) ->
      In u (Valids sign) ->
      IsTriangle ts s r u = true <-> LocalTriangle tid (name s) (name r) (name u).
    Proof.
      intros S R U.
      assert (Z : placed (name s) = OnSurface /\ placed (name r) = OnSurface /\
        placed (name u) = OnSurface)
        by (repeat split; apply ValidOn; assumption).
      transitivity (AmongTriangles ts s r u).
      - unfold IsTriangle, AmongTriangles, SomeHas. rewrite andb_true_iff, existsb_exists.
        split.
        + intros [Ds (t & I & H)]. exists t. split; [exact I|].
          unfold Distinct in Ds. rewrite !andb_true_iff, !SameSymbolDiffers in Ds.
          unfold Has in H. rewrite !andb_true_iff, !MemberIn in H.
          unfold HasTriangle. tauto.
        + intros (t & I & H). split.
          * destruct H as [_ H]. unfold Distinct.
            rewrite !andb_true_iff, !SameSymbolDiffers. tauto.
          * exists t. split; [exact I|]. apply (HasHasTriangle t t s r u H), H.
      - unfold LocalTriangle, AmongTriangles. rewrite Named. split.
        + intros (t & I & H). split; [|exact Z].
          exists (Orient h (MapTet name t)). split.
          * apply in_map_iff. exists t. auto.
          * rewrite OrientHasTriangle. apply (HasTriangleName f1 f2 f3 p q Apart), H.
        + intros [(t & I & H) _]. apply in_map_iff in I. destruct I as (t' & <- & I).
          exists t'. split; [exact I|].
          rewrite OrientHasTriangle in H.
          apply (HasTriangleName f1 f2 f3 p q Apart) in H. exact H.
    Qed.

    Lemma TouchesEnds l s : In l Four -> Touches l s = true <-> In (at_ l) (Ends (name s)).
    Proof.
      intros L. unfold name. destruct s as [a|a m]; rewrite ?NameBase, ?NameCut;
        cbn [Touches Ends In]; fold at_; rewrite ?orb_true_iff, !SameLabelEqual;
        split; intuition (try congruence); subst; try (left; reflexivity);
        try (right; left; reflexivity); auto using AtInjective, eq_sym.
    Qed.

    Lemma CoverReach symbols : Cover symbols = true <->
      Reach (Corners tid) (map name symbols).
    Proof.
      unfold Cover, Reach. rewrite forallb_forall. split.
      - intros C c I. apply AtIn in I. destruct I as (l & L & ->).
        specialize (C l L). apply existsb_exists in C. destruct C as (s & S & T).
        exists (name s). split; [apply in_map, S|]. apply TouchesEnds; assumption.
      - intros C l L. destruct (C (at_ l)) as (v & V & E); [apply AtIn; eauto|].
        apply in_map_iff in V. destruct V as (s & <- & V).
        apply existsb_exists. exists s. split; [exact V|]. apply TouchesEnds; assumption.
    Qed.

    Lemma CrossingNamed e f : In f Four ->
      name (Crossing sign e f) = CrossingAt after (at_ e) (at_ f).
    Proof.
      intros F. unfold Crossing, CrossingAt, name. pose proof (AtIs Minus f F) as M.
      destruct (Is sign Minus f).
      - rewrite (proj1 M eq_refl). apply NameCut.
      - destruct (after (at_ f)); try (apply NameBase).
        exfalso. enough (false = true) by discriminate. apply M. reflexivity.
    Qed.

    Lemma ThirdNamed a m c : In c Four ->
      name (FaceThird sign a m c) = ThirdAt after (at_ a) (at_ m) (at_ c).
    Proof.
      intros C. unfold FaceThird, ThirdAt, name. pose proof (AtIs Minus c C) as M.
      pose proof (AtIs Plus c C) as Q'.
      destruct (Is sign Plus c); [rewrite (proj1 Q' eq_refl); apply NameCut|].
      destruct (Is sign Minus c); [rewrite (proj1 M eq_refl); apply NameCut|].
      destruct (after (at_ c)); try (apply NameBase); exfalso;
        enough (false = true) by discriminate; tauto.
    Qed.

    Lemma CrossingValid e f : In e Four -> In f Four -> Is sign Plus e = true ->
      Is sign Plus f = false -> In (Crossing sign e f) (Valids sign).
    Proof.
      intros E F Pe Pf. unfold Valids, Crossing. rewrite filter_In, InAll.
      destruct (Is sign Minus f) eqn:M.
      - split; [auto|]. cbn [Valid]. rewrite Pe, M. reflexivity.
      - split; [exact F|]. cbn [Valid]. unfold Is in *. destruct (sign f); auto.
    Qed.

    Lemma ThirdValid a m c : In a Four -> In m Four -> In c Four ->
      Is sign Plus a = true -> Is sign Minus m = true ->
      In (FaceThird sign a m c) (Valids sign).
    Proof.
      intros A M C Pa Mm. unfold Valids, FaceThird. rewrite filter_In, InAll.
      destruct (Is sign Plus c) eqn:Pc.
      - split; [auto|]. cbn [Valid]. rewrite Pc, Mm. reflexivity.
      - destruct (Is sign Minus c) eqn:Mc.
        + split; [auto|]. cbn [Valid]. rewrite Pa, Mc. reflexivity.
        + split; [exact C|]. cbn [Valid]. unfold Is in *. destruct (sign c); auto.
    Qed.

    Lemma LabelsOf a b c d : In a (Corners tid) -> In b (Corners tid) ->
      In c (Corners tid) -> In d (Corners tid) -> NoDup [a; b; c; d] ->
      exists la lb lc ld, a = at_ la /\ b = at_ lb /\ c = at_ lc /\ d = at_ ld /\
        In la Four /\ In lb Four /\ In lc Four /\ In ld Four /\ NoDup [la; lb; lc; ld].
    Proof.
      rewrite !AtIn. intros (la & A & ->) (lb & B & ->) (lc & C & ->) (ld & D & ->) N.
      exists la, lb, lc, ld. repeat (split; [reflexivity || assumption|]).
      apply (NoDup_map_inv at_). exact N.
    Qed.

    (** ** What holds *)

    Lemma ViewTriangle x y z t : In t (names tid) -> HasTriangle t x y z ->
      OnIt tid x -> OnIt tid y -> OnIt tid z ->
      (forall u, In u (names tid) -> HasTriangle u x y z -> u = t) /\
      (Reach (Corners tid) [x; y; z] \/
       exists a b c e, x = Corner a /\ y = Corner b /\ z = Corner c /\
         In e (Corners tid) /\ after e = Plus /\
         Reach (Corners tid) [x; y; z; Corner e]).
    Proof.
      intros I H X Y Z. rewrite Named in I. apply in_map_iff in I.
      destruct I as (t' & <- & I).
      destruct (OnValid x X) as (s & S & ->), (OnValid y Y) as (r & R & ->),
        (OnValid z Z) as (u & U & ->).
      rewrite OrientHasTriangle in H. apply (HasTriangleName f1 f2 f3 p q Apart) in H.
      pose proof Fits as C. unfold CheckSurface in C. rewrite !andb_true_iff in C.
      destruct C as [[[[[C _] _] _] _] _]. unfold CheckTriangles, ForAllTriangles3 in C.
      rewrite forallb_forall in C. specialize (C t' I).
      rewrite forallb_forall in C. specialize (C s S).
      rewrite forallb_forall in C. specialize (C r R).
      rewrite forallb_forall in C. specialize (C u U).
      assert (E : Distinct s r u && Has t' (s, r, u) = true).
      { rewrite (proj2 (HasHasTriangle t' t' s r u H) H).
        destruct H as [_ H]. unfold Distinct.
        rewrite !andb_true_iff, !SameSymbolDiffers. tauto. }
      rewrite E in C. cbn [negb orb] in C. apply andb_prop in C. destruct C as [C T].
      split.
      - intros v V K. rewrite Named in V. apply in_map_iff in V.
        destruct V as (v' & <- & V). rewrite OrientHasTriangle in K.
        apply (HasTriangleName f1 f2 f3 p q Apart) in K.
        rewrite forallb_forall in C. specialize (C v' V).
        rewrite (proj2 (HasHasTriangle v' v' s r u K) K) in C. cbn [negb orb] in C.
        apply SameTetEqual in C. subst v'. reflexivity.
      - apply orb_prop in T. destruct T as [T|T].
        + left. apply (CoverReach [s; r; u]), T.
        + right. rewrite !andb_true_iff in T. destruct T as [[[Bs Br] Bu] T].
          destruct s as [a|]; [|discriminate Bs]. destruct r as [b|]; [|discriminate Br].
          destruct u as [c|]; [|discriminate Bu].
          apply existsb_exists in T. destruct T as (l & L & T).
          apply andb_prop in T. destruct T as [Pl T].
          exists (at_ a), (at_ b), (at_ c), (at_ l). unfold name. rewrite !NameBase.
          repeat (split; [reflexivity|]). split; [apply AtIn; eauto|].
          split; [apply AtIs; assumption|]. apply CoverReach in T.
          cbn [map] in T. unfold name in T. rewrite !NameBase in T. exact T.
    Qed.

    Lemma ViewZeros a b c e : In a (Corners tid) -> In b (Corners tid) ->
      In c (Corners tid) -> In e (Corners tid) -> NoDup [a; b; c; e] ->
      after a = OnSurface -> after b = OnSurface -> after c = OnSurface ->
      after e = Plus -> LocalTriangle tid (Corner a) (Corner b) (Corner c).
    Proof.
      intros A B Cc E N Sa Sb Sc Se.
      destruct (LabelsOf a b c e A B Cc E N)
        as (la & lb & lc & le & -> & -> & -> & -> & La & Lb & Lc & Le & Nl).
      pose proof Fits as C. unfold CheckSurface in C. rewrite !andb_true_iff in C.
      destruct C as [[[[[_ C] _] _] _] _].
      pose proof (FourLabelsMeans _ la lb lc le C La Lb Lc Le Nl) as T. cbv beta in T.
      apply (AtIs _ _ La) in Sa. apply (AtIs _ _ Lb) in Sb. apply (AtIs _ _ Lc) in Sc.
      apply (AtIs _ _ Le) in Se. rewrite Sa, Sb, Sc, Se in T. cbn [andb] in T.
      apply TriangleNamed in T;
        [unfold name in T; rewrite !NameBase in T; exact T|..];
        unfold Valids; rewrite filter_In, InAll; auto.
    Qed.

    Lemma ViewFaceEdge x y : OnIt tid x -> OnIt tid y -> x <> y ->
      ~ Reach (Corners tid) [x; y] -> (forall a b, x = Corner a -> y = Corner b -> False) ->
      exists z, LocalTriangle tid x y z /\ forall z', LocalTriangle tid x y z' ->
        OnIt tid z' -> z' = z.
    Proof.
      intros X Y N R B.
      destruct (OnValid x X) as (s & S & ->), (OnValid y Y) as (r & R' & ->).
      pose proof Fits as C. unfold CheckSurface in C. rewrite !andb_true_iff in C.
      destruct C as [[[[[_ _] C] _] _] _]. unfold CheckEdges in C.
      rewrite forallb_forall in C. specialize (C s S).
      rewrite forallb_forall in C. specialize (C r R'). cbv zeta in C.
      assert (Ns : SameSymbol s r = false).
      { apply not_true_iff_false. rewrite SameSymbolEqual, <- NameDiffers. exact N. }
      assert (Nb : IsBase s && IsBase r = false).
      { destruct s as [a|], r as [b|]; try reflexivity. exfalso.
        apply (B (at_ a) (at_ b)); apply NameBase. }
      assert (Nc : Cover [s; r] = false).
      { apply not_true_iff_false. rewrite CoverReach. exact R. }
      rewrite Ns, Nb, Nc in C. cbn [orb] in C. apply OneMeans in C.
      destruct C as (u & U & T & O). exists (name u).
      split; [apply TriangleNamed; assumption|].
      intros z' L Z. destruct (OnValid z' Z) as (v & V & ->). f_equal.
      apply O; [exact V|]. apply TriangleNamed; assumption.
    Qed.

    Lemma ViewInnerEdge x y z : OnIt tid x -> OnIt tid y -> OnIt tid z ->
      Reach (Corners tid) [x; y] -> (forall a b, x = Corner a -> y = Corner b -> False) ->
      LocalTriangle tid x y z ->
      exists z', z' <> z /\ LocalTriangle tid x y z' /\
        forall z'', LocalTriangle tid x y z'' -> OnIt tid z'' -> z'' = z \/ z'' = z'.
    Proof.
      intros X Y Z R B T.
      destruct (OnValid x X) as (s & S & ->), (OnValid y Y) as (r & R' & ->),
        (OnValid z Z) as (u & U & ->).
      pose proof Fits as C. unfold CheckSurface in C. rewrite !andb_true_iff in C.
      destruct C as [[[[[_ _] C] _] _] _]. unfold CheckEdges in C.
      rewrite forallb_forall in C. specialize (C s S).
      rewrite forallb_forall in C. specialize (C r R'). cbv zeta in C.
      apply TriangleNamed in T; try assumption.
      assert (Ns : SameSymbol s r = false).
      { unfold IsTriangle, Distinct in T. destruct (SameSymbol s r); [discriminate T|reflexivity]. }
      assert (Nb : IsBase s && IsBase r = false).
      { destruct s as [a|], r as [b|]; try reflexivity. exfalso.
        apply (B (at_ a) (at_ b)); apply NameBase. }
      apply (CoverReach [s; r]) in R. rewrite Ns, Nb, R in C. cbn [orb] in C.
      rewrite forallb_forall in C. specialize (C u).
      destruct (OneMoreMeans _ _ _ (C (proj2 (filter_In _ _ _) (conj U T))))
        as (v & N & V & Tv & O).
      exists (name v). split; [rewrite NameDiffers; exact N|].
      split; [apply TriangleNamed; assumption|].
      intros z'' L Z''. destruct (OnValid z'' Z'') as (w & W & ->). rewrite !NameDiffers.
      apply O; [exact W|]. apply TriangleNamed; assumption.
    Qed.

    Lemma ViewZeroEdge a b e f z : In a (Corners tid) -> In b (Corners tid) ->
      In e (Corners tid) -> In f (Corners tid) -> NoDup [a; b; e; f] ->
      after a = OnSurface -> after b = OnSurface -> OnIt tid z ->
      LocalTriangle tid (Corner a) (Corner b) z ->
      (after e = Plus /\ after f <> Plus /\ z = CrossingAt after e f) \/
      (after f = Plus /\ after e <> Plus /\ z = CrossingAt after f e).
    Proof.
      intros A B E F N Sa Sb Z T.
      destruct (LabelsOf a b e f A B E F N)
        as (la & lb & le & lf & -> & -> & -> & -> & La & Lb & Le & Lf & Nl).
      pose proof Fits as C. unfold CheckSurface in C. rewrite !andb_true_iff in C.
      destruct C as [[[[[_ _] _] C] _] _].
      pose proof (FourLabelsMeans _ la lb le lf C La Lb Le Lf Nl) as C'. cbv beta in C'.
      destruct (OnValid z Z) as (u & U & ->).
      pose proof (proj2 (AtIs _ _ La) Sa) as Va. pose proof (proj2 (AtIs _ _ Lb) Sb) as Vb.
      rewrite Va, Vb in C'. cbn [andb] in C'.
      rewrite forallb_forall in C'. specialize (C' u U).
      replace (Corner (at_ la)) with (name (Base la)) in T by apply NameBase.
      replace (Corner (at_ lb)) with (name (Base lb)) in T by apply NameBase.
      apply TriangleNamed in T;
        [|unfold Valids; rewrite filter_In, InAll; auto ..|exact U].
      rewrite T in C'. cbn [negb orb] in C'. apply orb_prop in C'.
      assert (Q' : forall l, In l Four -> negb (Is sign Plus l) = true ->
        after (at_ l) <> Plus).
      { intros l L W. rewrite <- (AtIs Plus l L). destruct (Is sign Plus l);
          [discriminate W|discriminate]. }
      destruct C' as [C'|C']; apply andb_prop in C'; destruct C' as [C' S];
        apply andb_prop in C'; destruct C' as [V W]; apply SameSymbolEqual in S;
        [left|right]; (split; [apply AtIs; assumption|]);
        (split; [auto|]); subst u; apply CrossingNamed; assumption.
    Qed.

    Lemma ViewZeroFan z w e f : In z (Corners tid) -> In w (Corners tid) ->
      In e (Corners tid) -> In f (Corners tid) -> NoDup [z; w; e; f] ->
      after z = OnSurface -> after e = Plus -> after f <> Plus ->
      (after w = Plus -> CrossingAt after e f = CrossingAt after w f \/
         LocalTriangle tid (Corner z) (CrossingAt after e f) (CrossingAt after w f)) /\
      (after w <> Plus ->
         LocalTriangle tid (Corner z) (CrossingAt after e f) (CrossingAt after e w)).
    Proof.
      intros Z W E F N Sz Se Sf.
      destruct (LabelsOf z w e f Z W E F N)
        as (lz & lw & le & lf & -> & -> & -> & -> & Lz & Lw & Le & Lf & Nl).
      pose proof Fits as C. unfold CheckSurface, CheckZeroFans in C.
      rewrite !andb_true_iff in C. destruct C as [[_ [C _]] _].
      pose proof (FourLabelsMeans _ lz lw le lf C Lz Lw Le Lf Nl) as C'. cbv beta in C'.
      pose proof (proj2 (AtIs _ _ Lz) Sz) as Vz. pose proof (proj2 (AtIs _ _ Le) Se) as Ve.
      assert (Q' : forall l, In l Four -> after (at_ l) <> Plus -> Is sign Plus l = false).
      { intros l L K. apply not_true_iff_false. rewrite (AtIs Plus l L). exact K. }
      pose proof (Q' lf Lf Sf) as Vf. rewrite Vz, Ve, Vf in C'. cbn [andb negb] in C'.
      rewrite <- !CrossingNamed by assumption.
      replace (Corner (at_ lz)) with (name (Base lz)) by apply NameBase.
      assert (Bz : In (Base lz) (Valids sign))
        by (unfold Valids; rewrite filter_In, InAll; auto).
      pose proof (CrossingValid le lf Le Lf Ve Vf) as Cef.
      split; intros Sw.
      - rewrite (proj2 (AtIs _ _ Lw) Sw) in C'. apply orb_prop in C'.
        destruct C' as [C'|C'].
        + left. apply NameDiffers, SameSymbolEqual, C'.
        + right. apply TriangleNamed in C'; [exact C'|exact Bz|exact Cef|].
          apply CrossingValid; try assumption. apply AtIs; assumption.
      - rewrite (Q' lw Lw Sw) in C'. apply TriangleNamed in C'; [exact C'|exact Bz|exact Cef|].
        apply CrossingValid; auto.
    Qed.

    Lemma ViewZeroEnds z x y : In z (Corners tid) -> after z = OnSurface ->
      OnIt tid x -> OnIt tid y -> LocalTriangle tid (Corner z) x y ->
      exists e f, In e (Corners tid) /\ In f (Corners tid) /\ f <> z /\
        after e = Plus /\ after f <> Plus /\ x = CrossingAt after e f.
    Proof.
      intros Z Sz X Y T. apply AtIn in Z. destruct Z as (l & L & ->).
      destruct (OnValid x X) as (s & S & ->), (OnValid y Y) as (r & R & ->).
      pose proof Fits as C. unfold CheckSurface, CheckZeroFans in C.
      rewrite !andb_true_iff in C. destruct C as [[_ [_ C]] _].
      rewrite forallb_forall in C. specialize (C l L).
      rewrite forallb_forall in C. specialize (C s S).
      rewrite forallb_forall in C. specialize (C r R).
      replace (Corner (at_ l)) with (name (Base l)) in T by apply NameBase.
      pose proof (proj2 (AtIs _ _ L) Sz) as Vz.
      apply TriangleNamed in T;
        [|unfold Valids; rewrite filter_In, InAll; auto|assumption|assumption].
      rewrite Vz, T in C. cbn [andb] in C. apply existsb_exists in C.
      destruct C as (e & E & C). apply existsb_exists in C. destruct C as (f & F & C).
      rewrite !andb_true_iff in C. destruct C as [[[Ve Vf] Nz] C].
      exists (at_ e), (at_ f). split; [apply AtIn; eauto|]. split; [apply AtIn; eauto|].
      split.
      { intros K. apply AtInjective in K. subst f.
        rewrite (proj2 (SameLabelEqual l l) eq_refl) in Nz. discriminate Nz. }
      split; [apply AtIs; assumption|]. split.
      { rewrite <- (AtIs Plus f F). destruct (Is sign Plus f); [discriminate Vf|discriminate]. }
      apply SameSymbolEqual in C. subst s. apply CrossingNamed, F.
    Qed.

    Lemma ViewCutFan a m c d : In a (Corners tid) -> In m (Corners tid) ->
      In c (Corners tid) -> In d (Corners tid) -> NoDup [a; m; c; d] ->
      after a = Plus -> after m = Minus ->
      let s := Cut a m in let r := ThirdAt after a m c in let u := ThirdAt after a m d in
      (LocalTriangle tid s r u \/
       exists w, LocalTriangle tid s r w /\ LocalTriangle tid s w u) /\
      forall w x, LocalTriangle tid s w x -> OnIt tid w -> OnIt tid x ->
        w = r \/ w = u \/ LocalTriangle tid s r w.
    Proof.
      intros A M Cc Dd N Sa Sm. cbv zeta.
      destruct (LabelsOf a m c d A M Cc Dd N)
        as (la & lm & lc & ld & -> & -> & -> & -> & La & Lm & Lc & Ld & Nl).
      pose proof Fits as C. unfold CheckSurface in C. rewrite !andb_true_iff in C.
      destruct C as [_ C].
      pose proof (FourLabelsMeans _ la lm lc ld C La Lm Lc Ld Nl) as C'. cbv beta in C'.
      pose proof (proj2 (AtIs _ _ La) Sa) as Va. pose proof (proj2 (AtIs _ _ Lm) Sm) as Vm.
      rewrite Va, Vm in C'. cbn [andb] in C'. cbv zeta in C'.
      apply andb_prop in C'. destruct C' as [C' O].
      rewrite <- !ThirdNamed by assumption.
      replace (Cut (at_ la) (at_ lm)) with (name (CutOf la lm)) by apply NameCut.
      assert (S : In (CutOf la lm) (Valids sign)).
      { unfold Valids. rewrite filter_In, InAll. cbn [Valid]. rewrite Va, Vm. auto. }
      pose proof (ThirdValid la lm lc La Lm Lc Va Vm) as R.
      pose proof (ThirdValid la lm ld La Lm Ld Va Vm) as U. split.
      - apply orb_prop in C'. destruct C' as [T|T].
        + left. apply TriangleNamed; assumption.
        + right. apply existsb_exists in T. destruct T as (w & W & T).
          apply andb_prop in T. exists (name w). split; apply TriangleNamed; tauto.
      - intros w x T W X. destruct (OnValid w W) as (w' & W' & ->),
          (OnValid x X) as (x' & X' & ->).
        apply TriangleNamed in T; try assumption.
        rewrite forallb_forall in O. specialize (O w' W').
        rewrite forallb_forall in O. specialize (O x' X'). rewrite T in O.
        cbn [negb orb] in O. apply orb_prop in O. destruct O as [O|O].
        + apply orb_prop in O. rewrite !NameDiffers.
          destruct O as [O|O]; apply SameSymbolEqual in O; auto.
        + right. right. apply TriangleNamed; assumption.
    Qed.
  End View.
End Mesh.

(** Every structured tetrahedron has such a view. *)
Lemma Viewed before warping tid : exists h f1 f2 f3 p q sign,
  NoDup [f1; f2; f3; p; q] /\ Corners tid = [f1; f2; f3; p] /\
  (forall l, In l Four ->
     SignAfter before warping (LocateFive f1 f2 f3 p q l) = sign l) /\
  PlacedNames before warping tid
  = map (fun s => Orient h (MapTet (Name f1 f2 f3 p q) s))
      (SymbolicTets GetUnstructuredTets sign F1 F2 F3 P) /\
  CheckSurface sign (SymbolicTets GetUnstructuredTets sign F1 F2 F3 P) = true.
Proof.
  destruct (Labelled before warping tid)
    as (h & f1 & f2 & f3 & p & q & s1 & s2 & s3 & sp & sq & D & C & _ & S & N).
  exists h, f1, f2, f3, p, q, (SignOf s1 s2 s3 sp sq).
  repeat (split; [assumption|]).
  exact (ForAllSignAssignmentsSound _ SurfaceChecked s1 s2 s3 sp sq).
Qed.
