(** * What holds of the surface within one structured tetrahedron

    What [CheckSurface] checked on symbols, in a view on them ([Viewed]). *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stencil.TriangleChecker
  Stencil.TriangleCheckerProof Stuffing.NameProof Topology.StencilSurface
  Topology.StencilSurfaceProof Topology.LocalSurfaceProof.

Section View.
  Variable mesh : SurfaceMesh.
  Local Notation before := (signs_before mesh).
  Local Notation warping := (warping_of mesh).
  Local Notation within := (made_within mesh).

  Local Notation after := (SignAfter before warping).
  Local Notation OnIt := (OnIt mesh).
  Local Notation LocalTriangle := (LocalTriangle mesh).

  Variables (tid : StructuredTetId) (h : Handedness) (f1 f2 f3 p q : Coord3).
  Variable sign : Label -> Sign.

  Local Notation name := (Name f1 f2 f3 p q).
  Local Notation at_ := (LocateFive f1 f2 f3 p q).
  Variable ts : list SymbolicTet.

  Hypothesis Apart : NoDup [f1; f2; f3; p; q].
  Hypothesis Points : Corners tid = [f1; f2; f3; p].
  Hypothesis Signs : forall l, In l Four -> after (at_ l) = sign l.
  Hypothesis Named :
    within tid = map (fun s => Orient h (MapTet name s)) ts.
  Hypothesis Fits : CheckSurface sign ts = true.

  Let AtInjective := AtInjective f1 f2 f3 p q Apart.
  Let AtIn := AtIn tid f1 f2 f3 p q Points.
  Let AtIs := AtIs mesh f1 f2 f3 p q sign Signs.
  Let OnValid := OnValid mesh tid f1 f2 f3 p q sign Points Signs.
  Let NameDiffers := NameDiffers f1 f2 f3 p q Apart.
  Let TriangleNamed :=
    TriangleNamed mesh tid h f1 f2 f3 p q sign ts Apart Points Signs Named.
  Let CoverReach := CoverReach tid f1 f2 f3 p q Apart Points.
  Let CrossingNamed := CrossingNamed mesh f1 f2 f3 p q sign Signs.
  Let ThirdNamed := ThirdNamed mesh f1 f2 f3 p q sign Signs.
  Let LabelsOf := LabelsOf tid f1 f2 f3 p q Points.
  Let CrossingValid := CrossingValid sign.
  Let ThirdValid := ThirdValid sign.

  Lemma ViewTriangle x y z t :
    In t (within tid) -> HasTriangle t x y z ->
    OnIt tid x -> OnIt tid y -> OnIt tid z ->
    (forall u, In u (within tid) -> HasTriangle u x y z -> u = t) /\
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
        exists (at_ a), (at_ b), (at_ c), (at_ l). rewrite !NameBase.
        repeat (split; [reflexivity|]). split; [apply AtIn; eauto|].
        split; [apply AtIs; assumption|]. apply CoverReach in T.
        cbn [map] in T. rewrite !NameBase in T. exact T.
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
      [rewrite !NameBase in T; exact T|..];
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
