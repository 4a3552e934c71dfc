(** * The surface within one structured tetrahedron, on symbols: what its checks tell *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.TriangleCheckerProof Topology.StencilSurface.

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

(** ** Vertices on the surface *)

Section Signs.
  Variable sign : Label -> Sign.

  Lemma InAll s : In s AllSymbols <->
    match s with Base a => In a Four | CutOf a m => In a Four /\ In m Four end.
  Proof.
    unfold AllSymbols. rewrite in_app_iff, !in_map_iff. split.
    - intros [(l & <- & I)|([a m] & <- & I)]; [exact I|]. apply in_prod_iff, I.
    - destruct s as [a|a m]; intros I; [left; exists a; auto|].
      right. exists (a, m). split; [reflexivity|]. apply in_prod_iff, I.
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
End Signs.
