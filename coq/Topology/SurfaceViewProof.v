(** * What holds of the surface within one structured tetrahedron

    What [CheckSurface] checked on symbols, in a view on them ([Viewed]). *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stencil.TriangleChecker
  Stencil.TriangleCheckerProof Stuffing.NameProof Topology.StencilSurface
  Topology.StencilSurfaceProof Topology.LocalSurfaceProof.

Section View.
  Variable mesh : SurfaceMesh.
  Variable tid : StructuredTetId.
  Local Notation within := (made_within mesh).
  Local Notation after := (SignAfter (signs_before mesh) (warping_of mesh)).
  Local Notation on_it := (OnIt mesh).
  Local Notation triangle := (LocalTriangle mesh).

  (** A view on symbols, and what is known of names in it. *)
  Local Ltac viewed :=
    destruct (surface_viewed mesh tid)
      as (h & f1 & f2 & f3 & p & q & sign & ts & Apart & Points & Signs & Named & Fits);
    pose proof (AtInjective f1 f2 f3 p q Apart) as AtInjective;
    pose proof (AtIn tid f1 f2 f3 p q Points) as AtIn;
    pose proof (AtIs mesh f1 f2 f3 p q sign Signs) as AtIs;
    pose proof (OnValid mesh tid f1 f2 f3 p q sign Points Signs) as OnValid;
    pose proof (NameDiffers f1 f2 f3 p q Apart) as NameDiffers;
    pose proof (TriangleNamed mesh tid h f1 f2 f3 p q sign ts Apart Points Signs Named)
      as TriangleNamed;
    pose proof (CoverReach tid f1 f2 f3 p q Apart Points) as CoverReach;
    pose proof (CrossingNamed mesh f1 f2 f3 p q sign Signs) as CrossingNamed;
    pose proof (ThirdNamed mesh f1 f2 f3 p q sign Signs) as ThirdNamed;
    pose proof (LabelsOf tid f1 f2 f3 p q Points) as LabelsOf;
    pose proof (CrossingValid sign) as CrossingValid;
    pose proof (ThirdValid sign) as ThirdValid.

  Lemma LocalShape x y z t :
    In t (within tid) -> HasTriangle t x y z ->
    on_it tid x -> on_it tid y -> on_it tid z ->
    (forall u, In u (within tid) -> HasTriangle u x y z -> u = t) /\
    (Reach (Corners tid) [x; y; z] \/
     exists a b c e, x = Corner a /\ y = Corner b /\ z = Corner c /\
       In e (Corners tid) /\ after e = Plus /\
       Reach (Corners tid) [x; y; z; Corner e]).
  Proof.
    viewed. intros I H X Y Z. rewrite Named in I. apply in_map_iff in I.
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
        exists (LocateFive f1 f2 f3 p q a), (LocateFive f1 f2 f3 p q b),
          (LocateFive f1 f2 f3 p q c), (LocateFive f1 f2 f3 p q l). rewrite !NameBase.
        repeat (split; [reflexivity|]). split; [apply AtIn; eauto|].
        split; [apply AtIs; assumption|]. apply CoverReach in T.
        cbn [map] in T. rewrite !NameBase in T. exact T.
  Qed.

  Lemma LocalZeros a b c e : In a (Corners tid) -> In b (Corners tid) ->
    In c (Corners tid) -> In e (Corners tid) -> NoDup [a; b; c; e] ->
    after a = OnSurface -> after b = OnSurface -> after c = OnSurface ->
    after e = Plus -> triangle tid (Corner a) (Corner b) (Corner c).
  Proof.
    viewed. intros A B Cc E N Sa Sb Sc Se.
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

  Lemma LocalFaceEdge x y : InLattice tid -> on_it tid x -> on_it tid y -> x <> y ->
    ~ Reach (Corners tid) [x; y] -> (forall a b, x = Corner a -> y = Corner b -> False) ->
    exists z, triangle tid x y z /\ forall z', triangle tid x y z' -> z' = z.
  Proof.
    viewed. intros E X Y N R B.
    destruct (OnValid x X) as (s & S & ->), (OnValid y Y) as (r & R' & ->).
    pose proof Fits as C. unfold CheckSurface in C. rewrite !andb_true_iff in C.
    destruct C as [[[[[_ _] C] _] _] _]. unfold CheckEdges in C.
    rewrite forallb_forall in C. specialize (C s S).
    rewrite forallb_forall in C. specialize (C r R'). cbv zeta in C.
    assert (Ns : SameSymbol s r = false).
    { apply not_true_iff_false. rewrite SameSymbolEqual, <- NameDiffers. exact N. }
    assert (Nb : IsBase s && IsBase r = false).
    { destruct s as [a|], r as [b|]; try reflexivity. exfalso.
      eapply B; apply NameBase. }
    assert (Nc : Cover [s; r] = false).
    { apply not_true_iff_false. rewrite CoverReach. exact R. }
    rewrite Ns, Nb, Nc in C. cbn [orb] in C. apply OneMeans in C.
    destruct C as (u & U & T & O). exists (Name f1 f2 f3 p q u).
    split; [apply TriangleNamed; assumption|].
    intros z' L. destruct (LocalOnIt mesh tid _ _ z' E L) as (_ & _ & Z).
    destruct (OnValid z' Z) as (v & V & ->). f_equal.
    apply O; [exact V|]. apply TriangleNamed; assumption.
  Qed.

  Lemma LocalInnerEdge x y z : InLattice tid ->
    Reach (Corners tid) [x; y] -> (forall a b, x = Corner a -> y = Corner b -> False) ->
    triangle tid x y z ->
    exists z', z' <> z /\ triangle tid x y z' /\
      forall z'', triangle tid x y z'' -> z'' = z \/ z'' = z'.
  Proof.
    viewed. intros E R B T. destruct (LocalOnIt mesh tid x y z E T) as (X & Y & Z).
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
      eapply B; apply NameBase. }
    apply (CoverReach [s; r]) in R. rewrite Ns, Nb, R in C. cbn [orb] in C.
    rewrite forallb_forall in C. specialize (C u).
    destruct (OneMoreMeans _ _ _ (C (proj2 (filter_In _ _ _) (conj U T))))
      as (v & N & V & Tv & O).
    exists (Name f1 f2 f3 p q v). split; [rewrite NameDiffers; exact N|].
    split; [apply TriangleNamed; assumption|].
    intros z'' L. destruct (LocalOnIt mesh tid _ _ z'' E L) as (_ & _ & Z'').
    destruct (OnValid z'' Z'') as (w & W & ->). rewrite !NameDiffers.
    apply O; [exact W|]. apply TriangleNamed; assumption.
  Qed.

  Lemma LocalZeroEdge a b e f z : InLattice tid ->
    In a (Corners tid) -> In b (Corners tid) ->
    In e (Corners tid) -> In f (Corners tid) -> NoDup [a; b; e; f] ->
    triangle tid (Corner a) (Corner b) z ->
    (after e = Plus /\ after f <> Plus /\ z = CrossingAt after e f) \/
    (after f = Plus /\ after e <> Plus /\ z = CrossingAt after f e).
  Proof.
    viewed. intros In_ A B E F N T.
    destruct (LocalOnIt mesh tid _ _ z In_ T) as ((_ & Sa) & (_ & Sb) & Z).
    change (after a = OnSurface) in Sa. change (after b = OnSurface) in Sb.
    destruct (LabelsOf a b e f A B E F N)
      as (la & lb & le & lf & -> & -> & -> & -> & La & Lb & Le & Lf & Nl).
    pose proof Fits as C. unfold CheckSurface in C. rewrite !andb_true_iff in C.
    destruct C as [[[[[_ _] _] C] _] _].
    pose proof (FourLabelsMeans _ la lb le lf C La Lb Le Lf Nl) as C'. cbv beta in C'.
    destruct (OnValid z Z) as (u & U & ->).
    pose proof (proj2 (AtIs _ _ La) Sa) as Va. pose proof (proj2 (AtIs _ _ Lb) Sb) as Vb.
    rewrite Va, Vb in C'. cbn [andb] in C'.
    rewrite forallb_forall in C'. specialize (C' u U).
    rewrite <- (NameBase f1 f2 f3 p q la) in T.
    rewrite <- (NameBase f1 f2 f3 p q lb) in T.
    apply TriangleNamed in T;
      [|unfold Valids; rewrite filter_In, InAll; auto ..|exact U].
    rewrite T in C'. cbn [negb orb] in C'. apply orb_prop in C'.
    assert (Q' : forall l, In l Four -> negb (Is sign Plus l) = true ->
      after (LocateFive f1 f2 f3 p q l) <> Plus).
    { intros l L W. rewrite <- (AtIs Plus l L). destruct (Is sign Plus l);
        [discriminate W|discriminate]. }
    destruct C' as [C'|C']; apply andb_prop in C'; destruct C' as [C' S];
      apply andb_prop in C'; destruct C' as [V W]; apply SameSymbolEqual in S;
      [left|right]; (split; [apply AtIs; assumption|]);
      (split; [auto|]); subst u; apply CrossingNamed; assumption.
  Qed.

  Lemma LocalZeroFan z w e f : In z (Corners tid) -> In w (Corners tid) ->
    In e (Corners tid) -> In f (Corners tid) -> NoDup [z; w; e; f] ->
    after z = OnSurface -> after e = Plus -> after f <> Plus ->
    (after w = Plus -> CrossingAt after e f = CrossingAt after w f \/
       triangle tid (Corner z) (CrossingAt after e f) (CrossingAt after w f)) /\
    (after w <> Plus ->
       triangle tid (Corner z) (CrossingAt after e f) (CrossingAt after e w)).
  Proof.
    viewed. intros Z W E F N Sz Se Sf.
    destruct (LabelsOf z w e f Z W E F N)
      as (lz & lw & le & lf & -> & -> & -> & -> & Lz & Lw & Le & Lf & Nl).
    pose proof Fits as C. unfold CheckSurface, CheckZeroFans in C.
    rewrite !andb_true_iff in C. destruct C as [[_ [C _]] _].
    pose proof (FourLabelsMeans _ lz lw le lf C Lz Lw Le Lf Nl) as C'. cbv beta in C'.
    pose proof (proj2 (AtIs _ _ Lz) Sz) as Vz. pose proof (proj2 (AtIs _ _ Le) Se) as Ve.
    assert (Q' : forall l, In l Four -> after (LocateFive f1 f2 f3 p q l) <> Plus ->
      Is sign Plus l = false).
    { intros l L K. apply not_true_iff_false. rewrite (AtIs Plus l L). exact K. }
    pose proof (Q' lf Lf Sf) as Vf. rewrite Vz, Ve, Vf in C'. cbn [andb negb] in C'.
    rewrite <- !CrossingNamed by assumption.
    rewrite <- (NameBase f1 f2 f3 p q lz).
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

  Lemma LocalZeroEnds z x y : InLattice tid -> triangle tid (Corner z) x y ->
    exists e f, In e (Corners tid) /\ In f (Corners tid) /\ f <> z /\
      after e = Plus /\ after f <> Plus /\ x = CrossingAt after e f.
  Proof.
    viewed. intros In_ T.
    destruct (LocalOnIt mesh tid _ x y In_ T) as (((Z & _) & Sz) & X & Y).
    change (after z = OnSurface) in Sz. apply AtIn in Z. destruct Z as (l & L & ->).
    destruct (OnValid x X) as (s & S & ->), (OnValid y Y) as (r & R & ->).
    pose proof Fits as C. unfold CheckSurface, CheckZeroFans in C.
    rewrite !andb_true_iff in C. destruct C as [[_ [_ C]] _].
    rewrite forallb_forall in C. specialize (C l L).
    rewrite forallb_forall in C. specialize (C s S).
    rewrite forallb_forall in C. specialize (C r R).
    rewrite <- (NameBase f1 f2 f3 p q l) in T.
    pose proof (proj2 (AtIs _ _ L) Sz) as Vz.
    apply TriangleNamed in T;
      [|unfold Valids; rewrite filter_In, InAll; auto|assumption|assumption].
    rewrite Vz, T in C. cbn [andb] in C. apply existsb_exists in C.
    destruct C as (e & E & C). apply existsb_exists in C. destruct C as (f & F & C).
    rewrite !andb_true_iff in C. destruct C as [[[Ve Vf] Nz] C].
    exists (LocateFive f1 f2 f3 p q e), (LocateFive f1 f2 f3 p q f).
    split; [apply AtIn; eauto|]. split; [apply AtIn; eauto|].
    split.
    { intros K. apply AtInjective in K. subst f.
      rewrite (proj2 (SameLabelEqual l l) eq_refl) in Nz. discriminate Nz. }
    split; [apply AtIs; assumption|]. split.
    { rewrite <- (AtIs Plus f F). destruct (Is sign Plus f); [discriminate Vf|discriminate]. }
    apply SameSymbolEqual in C. subst s. apply CrossingNamed, F.
  Qed.

  Lemma LocalCutFan a m c d : InLattice tid ->
    In a (Corners tid) -> In m (Corners tid) ->
    In c (Corners tid) -> In d (Corners tid) -> NoDup [a; m; c; d] ->
    after a = Plus -> after m = Minus ->
    let s := Cut a m in let r := ThirdAt after a m c in let u := ThirdAt after a m d in
    (triangle tid s r u \/ exists w, triangle tid s r w /\ triangle tid s w u) /\
    forall w x, triangle tid s w x -> w = r \/ w = u \/ triangle tid s r w.
  Proof.
    viewed. intros In_ A M Cc Dd N Sa Sm. cbv zeta.
    destruct (LabelsOf a m c d A M Cc Dd N)
      as (la & lm & lc & ld & -> & -> & -> & -> & La & Lm & Lc & Ld & Nl).
    pose proof Fits as C. unfold CheckSurface in C. rewrite !andb_true_iff in C.
    destruct C as [_ C].
    pose proof (FourLabelsMeans _ la lm lc ld C La Lm Lc Ld Nl) as C'. cbv beta in C'.
    pose proof (proj2 (AtIs _ _ La) Sa) as Va. pose proof (proj2 (AtIs _ _ Lm) Sm) as Vm.
    rewrite Va, Vm in C'. cbn [andb] in C'. cbv zeta in C'.
    apply andb_prop in C'. destruct C' as [C' O].
    rewrite <- !ThirdNamed by assumption.
    rewrite <- (NameCut f1 f2 f3 p q la lm).
    assert (S : In (CutOf la lm) (Valids sign)).
    { unfold Valids. rewrite filter_In, InAll. cbn [Valid]. rewrite Va, Vm. auto. }
    pose proof (ThirdValid la lm lc La Lm Lc Va Vm) as R.
    pose proof (ThirdValid la lm ld La Lm Ld Va Vm) as U. split.
    - apply orb_prop in C'. destruct C' as [T|T].
      + left. apply TriangleNamed; assumption.
      + right. apply existsb_exists in T. destruct T as (w & W & T).
        apply andb_prop in T. exists (Name f1 f2 f3 p q w). split; apply TriangleNamed; tauto.
    - intros w x T. destruct (LocalOnIt mesh tid _ w x In_ T) as (_ & W & X).
      destruct (OnValid w W) as (w' & W' & ->),
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
