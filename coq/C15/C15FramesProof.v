(** * Frames of tetrahedra of C15: proof

    Every tetrahedron is the image of that of its kind, edges and all; orders of
    corners respect the stencils; and of the images that a placement has in the frames
    of its tetrahedron the first is one of those that are checked. *)

From Certet Require Import Key.Definitions.
From Certet Require Import Angles.Cases.Configurations Angles.Cases.Isometry
  Angles.Cases.SymmetryProof Key.Orders Key.OrderProof Key.KeyConfigurations
  Key.RangedProof Key.KeyReductionProof.
From Certet Require Import C15.Sites C15.C15Tet C15.C15TilingProof C15.C15Stuffing
  C15.C15Configurations.
Open Scope Z_scope.
Open Scope bool_scope.

(** ** Orders of the corners *)

Lemma OfSignsIn g signs l : Of (SignsIn g signs) l = Of signs (Of g l).
Proof. destruct l; reflexivity. Qed.

Lemma OfMovesIn f moves l :
  Of (MovesIn f moves) l
  = option_map (Apply (MapOf f)) (Of moves (Of (OrderIn f) l)).
Proof. destruct f, l; reflexivity. Qed.

(** Where a label stands in an order. *)
Definition Standing (g : Quad Label) (l : Label) : Label :=
  match find (fun k => LabelEqual (Of g k) l) AllLabels with Some k => k | None => l end.

Lemma StandsThere g l : In g LabelOrders -> Of g (Standing g l) = l.
Proof.
  intros I.
  assert (T : forallb (fun g =>
    forallb (fun l => LabelEqual (Of g (Standing g l)) l) AllLabels) LabelOrders = true)
    by (vm_compute; reflexivity).
  rewrite forallb_forall in T. specialize (T g I). rewrite forallb_forall in T.
  apply LabelEqualTrue, (T l (InAllLabels l)).
Qed.

Lemma SurfaceCornersIn g signs : In g LabelOrders ->
  SurfaceCorners (SignsIn g signs) = SurfaceCorners signs.
Proof.
  intros I.
  assert (T : forallb (fun g => forallb (fun signs =>
    SurfaceCorners (SignsIn g signs) =? SurfaceCorners signs) AllSigns) LabelOrders = true)
    by (vm_compute; reflexivity).
  rewrite forallb_forall in T. specialize (T g I). rewrite forallb_forall in T.
  apply Z.eqb_eq, (T signs (InAllSigns signs)).
Qed.

Definition PairStanding (g : Quad Label) (x : Label * Label) : Label * Label :=
  (Standing g (fst x), Standing g (snd x)).

Definition SymbolIn (g : Quad Label) (v : Symbol) : Symbol :=
  match v with
  | CornerOf l => CornerOf (Of g l)
  | CutOf a b => CutOf (Of g a) (Of g b)
  end.

(** Two vertices exchanged, where corners are in an odd order. *)
Definition HandedBy {V} (determinant : Z) (t : UnstructuredTet V) : UnstructuredTet V :=
  match t with
    UT _ a b c d => if determinant =? 1 then UT _ a b c d else UT _ a b d c
  end.

Definition ComesFrom (g : Quad Label) (t : UnstructuredTet Symbol)
  (ts : list (UnstructuredTet Symbol)) : bool :=
  existsb (fun t' => existsb (TetEqual t)
    (EvenPermutations (HandedBy (OrderDeterminant g) (MapTet (SymbolIn g) t')))) ts.

(** Orders of the corners respect the stencils and the orders of cuts. *)
Lemma OrderRespected g signs o : In g LabelOrders ->
  In o (Orders (CutsBetween signs)) ->
  In (map (PairStanding g) o) (Orders (CutsBetween (SignsIn g signs))) /\
  forall t, In t (OrderedTets signs o) -> exists t',
    In t' (OrderedTets (SignsIn g signs) (map (PairStanding g) o)) /\
    In t (EvenPermutations (HandedBy (OrderDeterminant g) (MapTet (SymbolIn g) t'))).
Proof.
  assert (T : forallb (fun g => forallb (fun signs =>
    let orders := Orders (CutsBetween (SignsIn g signs)) in
    forallb (fun o =>
      let o' := map (PairStanding g) o in
      if existsb (SameOrder o') orders then
        let ts := OrderedTets (SignsIn g signs) o' in
        forallb (fun t => ComesFrom g t ts) (OrderedTets signs o)
      else false) (Orders (CutsBetween signs))) AllSigns) LabelOrders = true)
    by (vm_cast_no_check (eq_refl true)).
  intros G O. rewrite forallb_forall in T. specialize (T g G).
  rewrite forallb_forall in T. specialize (T signs (InAllSigns signs)). cbv zeta in T.
  rewrite forallb_forall in T. specialize (T o O). cbv beta in T.
  destruct (existsb _ _) eqn:L in T; [|discriminate T]. split.
  - apply existsb_exists in L. destruct L as (o' & L & E).
    apply SameOrderEqual in E. rewrite E. exact L.
  - intros t I. rewrite forallb_forall in T. specialize (T t I).
    apply existsb_exists in T. destruct T as (t' & I' & T).
    apply existsb_exists in T. destruct T as (t'' & I'' & T).
    apply TetEqualTrue in T. subst t''. eauto.
Qed.

(** ** Frames of the cases *)

Definition StandardOf (case : C15Case) : C15Case :=
  match MetalOf (C15Corner case First), MetalOf (C15Corner case Second) with
  | Mg, Mg => Tet_A01 | Mg, Cu => Tet_B1 | Cu, _ => Tet_C1
  end.

Definition FramesOf (case : C15Case) : list Frame :=
  Frames (CaseCorners case) (CaseCorners (StandardOf case)).

Section Frames.
  Variables (p q : Quad Coord3) (f : Frame).
  Hypothesis listed : In f (Frames p q).

  Lemma FrameListed : In (OrderIn f) LabelOrders /\ In (MapOf f) AllIsometries /\
    IsFrame p q f = true.
  Proof.
    apply filter_In in listed. destruct listed as [I T]. split; [|split; [|exact T]];
      apply in_flat_map in I; destruct I as (g & G & I); apply in_map_iff in I;
      destruct I as (m & <- & M); assumption.
  Qed.

  Lemma FrameCarries l :
    Apply (MapOf f) (Difference (Of p (Of (OrderIn f) V1)) (Of p (Of (OrderIn f) l)))
    = Difference (Of q V1) (Of q l).
  Proof.
    destruct FrameListed as (_ & _ & T). unfold IsFrame in T.
    destruct (CarriesQuad p q f) eqn:C; [|discriminate T].
    unfold CarriesQuad in C. destruct f as [g m]. cbn [OrderIn MapOf].
    rewrite forallb_forall in C. apply Coord3EqualTrue, C, InAllLabels.
  Qed.

  Lemma FrameDeterminant : Determinant (MapOf f) = OrderDeterminant (OrderIn f).
  Proof.
    destruct FrameListed as (_ & _ & T). unfold IsFrame in T.
    destruct (CarriesQuad p q f); [|discriminate T].
    destruct (Determinant (MapOf f) =? OrderDeterminant (OrderIn f)) eqn:D;
      [|discriminate T]. apply Z.eqb_eq, D.
  Qed.

  Lemma SameMetalEqual a b : SameMetal a b = true -> a = b.
  Proof. destruct a, b; cbn; congruence. Qed.

  Lemma FrameEdges l :
    MetalOf (Of p (Of (OrderIn f) l)) = MetalOf (Of q l) /\
    forall o, In o (OffsetsAround (Of p (Of (OrderIn f) l))) ->
      In (Apply (MapOf f) o) (OffsetsAround (Of q l)) /\
      MetalOf (Translate (Of p (Of (OrderIn f) l)) o)
      = MetalOf (Translate (Of q l) (Apply (MapOf f) o)).
  Proof.
    destruct FrameListed as (_ & _ & T). unfold IsFrame in T.
    destruct (CarriesQuad p q f); [|discriminate T].
    destruct (Determinant _ =? _); [|discriminate T].
    unfold CarriesEdges in T. destruct f as [g m]. cbn [OrderIn MapOf].
    rewrite forallb_forall in T. specialize (T l (InAllLabels l)). cbv zeta in T.
    apply andb_prop in T. destruct T as [M T]. split; [apply SameMetalEqual, M|].
    intros o I. rewrite forallb_forall in T. specialize (T o I).
    apply andb_prop in T. destruct T as [E N].
    split; [apply MemberOffset, E|apply SameMetalEqual, N].
  Qed.
End Frames.

(** A frame, and after it a symmetry of the kind's tetrahedron, is a frame. *)
Definition MapAfter (n m : Linear) : Linear :=
  match m with Lin a b c => Lin (Apply n a) (Apply n b) (Apply n c) end.

Lemma ApplyAfter n m v : Apply (MapAfter n m) v = Apply n (Apply m v).
Proof.
  destruct m as [a b c], v as [x y z]. cbn [MapAfter Apply].
  rewrite !ApplyTranslate, !ApplyScale. reflexivity.
Qed.

Definition SameMap (m n : Linear) : bool :=
  match m, n with
    Lin a b c, Lin a' b' c' => Coord3Equal a a' && Coord3Equal b b' && Coord3Equal c c'
  end.

Lemma SameMapEqual m n : SameMap m n = true -> m = n.
Proof.
  destruct m, n. cbn [SameMap]. rewrite !andb_true_iff. intros [[A B] C].
  f_equal; apply Coord3EqualTrue; assumption.
Qed.

Definition IsComposed (f h f' : Frame) : bool :=
  if forallb (fun l => LabelEqual (Of (OrderIn f') l) (Of (OrderIn f) (Of (OrderIn h) l)))
       AllLabels
  then SameMap (MapOf f') (MapAfter (MapOf h) (MapOf f)) else false.

Lemma FramesThere : forallb (fun case =>
  let frames := FramesOf case in
  match frames with [] => false | _ => true end &&
  let symmetries := Symmetries (StandardOf case) in
  forallb (fun f => forallb (fun h => existsb (IsComposed f h) frames) symmetries) frames)
  AllC15Cases = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma FrameExists case : exists f, In f (FramesOf case).
Proof.
  pose proof FramesThere as T. rewrite forallb_forall in T.
  specialize (T case (InAllC15Cases case)). cbv zeta in T. apply andb_prop in T.
  destruct T as [T _]. destruct (FramesOf case) as [|f fs]; [discriminate T|].
  exists f. left. reflexivity.
Qed.

Lemma FrameComposed case f h : In f (FramesOf case) ->
  In h (Symmetries (StandardOf case)) -> exists f', In f' (FramesOf case) /\
    (forall l, Of (OrderIn f') l = Of (OrderIn f) (Of (OrderIn h) l)) /\
    (forall v, Apply (MapOf f') v = Apply (MapOf h) (Apply (MapOf f) v)).
Proof.
  intros F H. pose proof FramesThere as T. rewrite forallb_forall in T.
  specialize (T case (InAllC15Cases case)). cbv zeta in T. apply andb_prop in T.
  destruct T as [_ T]. rewrite forallb_forall in T. specialize (T f F).
  rewrite forallb_forall in T. specialize (T h H). apply existsb_exists in T.
  destruct T as (f' & I & C). exists f'. split; [exact I|].
  unfold IsComposed in C. destruct (forallb _ _) eqn:L in C; [|discriminate C].
  rewrite forallb_forall in L. split.
  - intros l. apply LabelEqualTrue, L, InAllLabels.
  - intros v. apply SameMapEqual in C. rewrite C. apply ApplyAfter.
Qed.

(** ** The first image *)

Lemma LeastOf {T} (code : T -> Z) (l : list T) : l <> [] ->
  exists x, In x l /\ forall y, In y l -> code x <= code y.
Proof.
  induction l as [|x [|y r] IH]; intros N; [congruence| |].
  - exists x. split; [left; reflexivity|]. intros z [<-|[]]. lia.
  - destruct IH as (w & I & L); [discriminate|].
    destruct (Z.le_ge_cases (code x) (code w)) as [C|C].
    + exists x. split; [left; reflexivity|]. intros z [<-|J]; [lia|].
      specialize (L z J). lia.
    + exists w. split; [right; exact I|]. intros z [<-|J]; [lia|]. exact (L z J).
Qed.

Lemma QuadEqual {T} (x y : Quad T) : (forall l, Of x l = Of y l) -> x = y.
Proof.
  destruct x, y. intros E. f_equal;
    [exact (E V1)|exact (E V2)|exact (E V3)|exact (E V4)].
Qed.

Lemma FirstFrame case signs moves : exists f, In f (FramesOf case) /\
  IsFirst (Symmetries (StandardOf case)) (SignsIn (OrderIn f) signs) (MovesIn f moves)
  = true.
Proof.
  set (code f := Code (SignsIn (OrderIn f) signs) (MovesIn f moves)).
  destruct (LeastOf code (FramesOf case)) as (f & I & L).
  { destruct (FrameExists case) as (f & I). intros E. rewrite E in I. destruct I. }
  exists f. split; [exact I|]. unfold IsFirst. cbv zeta. apply forallb_forall.
  intros h H. apply Z.leb_le.
  destruct (FrameComposed case f h I H) as (f' & I' & O & M).
  specialize (L f' I'). unfold code in L.
  replace (SignsIn (OrderIn h) (SignsIn (OrderIn f) signs))
    with (SignsIn (OrderIn f') signs)
    by (apply QuadEqual; intros l; rewrite !OfSignsIn, O; reflexivity).
  replace (MovesIn h (MovesIn f moves)) with (MovesIn f' moves); [exact L|].
  apply QuadEqual. intros l. rewrite !OfMovesIn, O.
  destruct (Of moves _); cbn [option_map]; [|reflexivity]. rewrite M. reflexivity.
Qed.

(** Then its signs come first too. *)
Lemma MoveCodeSmall move : 0 <= MoveCode move < 512.
Proof.
  destruct move as [o|]; cbn [MoveCode]; [|lia].
  change 511 with (Z.ones 9). rewrite Z.land_ones by lia.
  apply Z.mod_pos_bound. reflexivity.
Qed.

Lemma FirstHasFirstSigns symmetries signs moves :
  IsFirst symmetries signs moves = true -> FirstSigns symmetries signs = true.
Proof.
  unfold IsFirst, FirstSigns. cbv zeta. rewrite !forallb_forall. intros F f I.
  specialize (F f I). apply Z.leb_le in F. apply Z.leb_le. unfold Code in F.
  assert (B : forall m, 0 <= MovesCode m < 2 ^ 36).
  { intros [a b c d]. unfold MovesCode.
    pose proof (MoveCodeSmall a). pose proof (MoveCodeSmall b).
    pose proof (MoveCodeSmall c). pose proof (MoveCodeSmall d).
    change (2 ^ 36) with 68719476736. lia. }
  pose proof (B moves). pose proof (B (MovesIn f moves)).
  change (2 ^ 36) with 68719476736 in *. lia.
Qed.
