(** * No tetrahedron twice: proof

    Within one structured tetrahedron by looking at all sign patterns on
    symbols; of two structured tetrahedra because what they have in common lies
    in a face, and no tetrahedron of the output does. *)

From Coq Require Logic.FinFun.
From Certet Require Import Stuffing.Definitions.
From Certet Require Import Lattice.FaceProof Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stencil.TriangleChecker Stuffing.NameProof
  Stuffing.MeshProof.

Local Opaque WarpVertex.

(** ** On symbols *)

Definition WithinCorners (t u : SymbolicTet) : bool :=
  forallb (fun s => Member s (TetCorners u)) (TetCorners t).

(** No two have the same corners, whatever their order. *)
Fixpoint AllApart (ts : list SymbolicTet) : bool :=
  match ts with
  | [] => true
  | t :: us =>
      forallb (fun u => negb (WithinCorners t u) && negb (WithinCorners u t)) us
      && AllApart us
  end.

Lemma StencilsApart :
  ForAllSignAssignments (fun sign =>
    AllApart (SymbolicTets GetUnstructuredTets sign F1 F2 F3 P)) = true.
Proof. vm_compute. reflexivity. Qed.

Lemma WithinCornersIn t u : WithinCorners t u = true <->
  forall s, In s (TetCorners t) -> In s (TetCorners u).
Proof.
  unfold WithinCorners. rewrite forallb_forall.
  split; intros all s I; specialize (all s I); now apply MemberIn.
Qed.

Lemma AllApartMeans ts : AllApart ts = true ->
  NoDup ts /\
  forall t u, In t ts -> In u ts -> WithinCorners t u = true -> t = u.
Proof.
  induction ts as [|t ts IH]; cbn [AllApart]; intros apart.
  - split; [constructor | intros t u []].
  - apply andb_prop in apart as [first rest]. rewrite forallb_forall in first.
    destruct (IH rest) as [N D].
    assert (F : forall u, In u ts ->
              WithinCorners t u = false /\ WithinCorners u t = false).
    { intros u I. specialize (first u I). apply andb_prop in first as [A B].
      split; now apply negb_true_iff. }
    split.
    + constructor; [|exact N]. intros I. destruct (F t I) as [A _].
      apply not_true_iff_false in A. apply A, WithinCornersIn. auto.
    + intros r u [<- | I] [<- | J] W; [reflexivity | | | now apply D].
      * rewrite (proj1 (F u J)) in W. discriminate W.
      * rewrite (proj2 (F r I)) in W. discriminate W.
Qed.

(** ** In one structured tetrahedron *)

Section One.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Variable tid : StructuredTetId.

  Lemma StuffTetApart :
    NoDup (StuffTet th sign cut tid) /\
    forall t u, In t (StuffTet th sign cut tid) -> In u (StuffTet th sign cut tid) ->
      (forall v, In v (TetCorners t) -> In v (TetCorners u)) -> t = u.
  Proof.
    destruct (VerticesNamed tid) as (f1 & f2 & f3 & p & q & distinct & vertices).
    destruct (StuffTetNamed f1 f2 f3 p q th sign cut tid F1 F2 F3 P vertices)
      as [h named].
    rewrite named.
    assert (A : AllApart (NamedTets f1 f2 f3 p q th sign cut F1 F2 F3 P) = true).
    { refine (ForAllSignAssignmentsSound _ StencilsApart _ _ _ _ _). }
    apply AllApartMeans in A as [N D]. split.
    - apply FinFun.Injective_map_NoDup; [|exact N].
      intros s r E. now apply (MapNameInjective f1 f2 f3 p q distinct), (OrientInjective h).
    - intros t u I J within.
      apply in_map_iff in I as (s & <- & I), J as (r & <- & J).
      f_equal. f_equal. apply D; [assumption | assumption |].
      apply WithinCornersIn. intros c corner.
      assert (C : In (Name f1 f2 f3 p q c) (TetCorners (MapTet (Name f1 f2 f3 p q) r))).
      { apply (OrientCorners h), within, OrientCorners.
        rewrite MapTetCorners. now apply in_map. }
      rewrite MapTetCorners in C. now apply (InNames f1 f2 f3 p q distinct) in C.
  Qed.
End One.

Theorem StuffTetNoDup : forall th sign cut tid, NoDup (StuffTet th sign cut tid).
Proof. intros. apply StuffTetApart. Qed.

(** ** In two *)

Lemma SomeVertexApart tid other : InLattice tid -> InLattice other -> other <> tid ->
  exists i, forall j,
    VertexAt (GetStructuredTet tid) i <> VertexAt (GetStructuredTet other) j.
Proof.
  intros even even' apart.
  assert (decide : forall i,
    (exists j, VertexAt (GetStructuredTet tid) i = VertexAt (GetStructuredTet other) j) \/
    (forall j, VertexAt (GetStructuredTet tid) i <> VertexAt (GetStructuredTet other) j)).
  { intros i.
    destruct (existsb (fun j => Coord3Equal (VertexAt (GetStructuredTet tid) i)
                (VertexAt (GetStructuredTet other) j)) AllPlaces) eqn:E.
    - left. apply existsb_exists in E as (j & _ & E). exists j. now apply SamePoint.
    - right. intros j same. apply not_true_iff_false in E. apply E, existsb_exists.
      exists j. split; [apply AllPlacesHas | now apply SamePoint]. }
  destruct (decide First); [|eauto]. destruct (decide Second); [|eauto].
  destruct (decide Third); [|eauto]. destruct (decide Fourth); [|eauto].
  exfalso. apply apart, VerticesTell; [assumption | assumption |]. intros []; assumption.
Qed.

Theorem TetrahedraDiffer : forall th sign cut tid other t u,
  InLattice tid -> InLattice other ->
  In t (StuffTet th sign cut tid) -> In u (StuffTet th sign cut other) ->
  (forall v, In v (TetCorners t) -> In v (TetCorners u)) ->
  tid = other /\ t = u.
Proof.
  intros th sign cut tid other t u even even' I J within.
  assert (same : Coord3Equal
            (let 'STId a _ := tid in a) (let 'STId a _ := other in a)
          && CaseEqual (let 'STId _ c := tid in c) (let 'STId _ c := other in c) = true
          \/ other <> tid).
  { destruct (IdEqual tid other) eqn:E.
    - left. destruct tid, other. exact E.
    - right. intros ->. apply not_true_iff_false in E. apply E.
      destruct tid as [a c]. cbn. apply andb_true_intro. split.
      + now apply SamePoint.
      + now destruct c. }
  destruct same as [same | apart].
  - assert (tid = other) as <- by (apply SameId; destruct tid, other; exact same).
    split; [reflexivity|]. now apply (StuffTetApart th sign cut tid).
  - exfalso. destruct (SomeVertexApart tid other even even' apart) as [i away].
    apply (ReachesOff th sign cut tid i t I). intros v corner.
    pose proof (StaysIn th sign cut tid t v I corner) as here.
    pose proof (StaysIn th sign cut other u v J (within v corner)) as there.
    unfold FaceOf.
    assert (away1 := away First). assert (away2 := away Second).
    assert (away3 := away Third). assert (away4 := away Fourth). clear away.
    destruct (GetStructuredTet tid) as [v1 v2 v3 v4 n1 n2 n3 n4].
    destruct (GetStructuredTet other) as [u1 u2 u3 u4 m1 m2 m3 m4].
    cbn [VertexAt] in away1, away2, away3, away4.
    assert (point : forall x, In x [v1; v2; v3; v4] -> In x [u1; u2; u3; u4] ->
              In x (FaceAcross (ST v1 v2 v3 v4 n1 n2 n3 n4) i)).
    { intros x X Y. destruct i; cbn [FaceAcross In VertexAt] in *;
        intuition congruence. }
    destruct v as [x | x y]; cbn [LiesIn] in *; [now apply point|].
    destruct here, there. split; now apply point.
Qed.
