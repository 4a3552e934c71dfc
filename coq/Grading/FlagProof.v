(** * What flags beside a flag see: proofs

    Coordinates seen from a flag make all axes and directions alike, so that
    nothing below is proved 48 times. *)

From Certet Require Import Lattice.Definitions Grading.Octree Grading.Flag.
Open Scope Z_scope.

(** Halves and rests, by linear arithmetic. *)
Ltac euclid := Z.to_euclidean_division_equations; lia.

(** ** Vectors by their coordinates along the axes of an order *)

Lemma Arranged o v : exists a b c, v = Arrange o a b c.
Proof. destruct v as [x y z], o; cbn; eauto. Qed.

Lemma TranslateArrange o a b c a' b' c' :
  Translate (Arrange o a b c) (Arrange o a' b' c')
  = Arrange o (a + a') (b + b') (c + c').
Proof. destruct o; reflexivity. Qed.

Lemma ScaleArrange o n a b c :
  Scale n (Arrange o a b c) = Arrange o (n * a) (n * b) (n * c).
Proof. destruct o; reflexivity. Qed.

Lemma DifferenceArrange o a b c a' b' c' :
  Difference (Arrange o a b c) (Arrange o a' b' c')
  = Arrange o (a' - a) (b' - b) (c' - c).
Proof. destruct o; reflexivity. Qed.

Lemma ParentArrange o a b c :
  ParentCell (Arrange o a b c) = Arrange o (a / 2) (b / 2) (c / 2).
Proof. destruct o; reflexivity. Qed.

Lemma OneArrange o : C3 1 1 1 = Arrange o 1 1 1.
Proof. destruct o; reflexivity. Qed.

Lemma ArrangeSwapLast o a b c : Arrange (SwapLast o) a b c = Arrange o a c b.
Proof. destruct o; reflexivity. Qed.

Lemma ArrangeSwapFirst o a b c : Arrange (SwapFirst o) a b c = Arrange o b a c.
Proof. destruct o; reflexivity. Qed.

Lemma AlongFirstArrange o a b c : AlongFirst o (Arrange o a b c) = a.
Proof. destruct o; reflexivity. Qed.

Lemma SwapLastTwice o : SwapLast (SwapLast o) = o.
Proof. destruct o; reflexivity. Qed.

Lemma SwapFirstTwice o : SwapFirst (SwapFirst o) = o.
Proof. destruct o; reflexivity. Qed.

Lemma RotateInOut o : RotateIn (RotateOut o) = o.
Proof. destruct o; reflexivity. Qed.

Lemma RotateOutIn o : RotateOut (RotateIn o) = o.
Proof. destruct o; reflexivity. Qed.

Lemma ArrangeRotateIn o a b c : Arrange (RotateIn o) a b c = Arrange o b c a.
Proof. destruct o; reflexivity. Qed.

Lemma ArrangeRotateOut o a b c : Arrange (RotateOut o) a b c = Arrange o c a b.
Proof. destruct o; reflexivity. Qed.

Lemma AlongSecondArrange o a b c : AlongFirst (SwapFirst o) (Arrange o a b c) = b.
Proof. destruct o; reflexivity. Qed.

Lemma AlongThirdArrange o a b c : AlongFirst (RotateIn o) (Arrange o a b c) = c.
Proof. destruct o; reflexivity. Qed.

Lemma SameArrange o a b c a' b' c' : a = a' -> b = b' -> c = c' ->
  Arrange o a b c = Arrange o a' b' c'.
Proof. congruence. Qed.

Lemma ArrangeInjective o a b c a' b' c' :
  Arrange o a b c = Arrange o a' b' c' -> a = a' /\ b = b' /\ c = c'.
Proof. destruct o; cbn; intros [=]; auto. Qed.

(** A flag with its cell's index by the flag's own axes. *)
Ltac flag x :=
  let level := fresh "level" in let v := fresh "v" in let o := fresh "o" in
  let s := fresh "s" in let t := fresh "t" in let u := fresh "u" in
  let a := fresh "a" in let b := fresh "b" in let c := fresh "c" in
  destruct x as [level v o s t u]; destruct (Arranged o v) as (a & b & c & ->).

Ltac arrange :=
  cbn [OtherCorner OtherEdge OtherFace OtherCell];
  unfold PointSeen, PointInHalfSides, CellSeen, ChildSeen, CentreInHalfSides;
  cbn [LevelOf CellOf StepFrom];
  unfold CellSeen; cbn [LevelOf CellOf StepFrom];
  match goal with o : AxisOrder |- _ =>
    rewrite ?(OneArrange o);
    repeat (progress rewrite ?ArrangeSwapLast, ?ArrangeSwapFirst, ?ArrangeRotateIn,
      ?ArrangeRotateOut, ?ScaleArrange, ?TranslateArrange, ?ParentArrange)
  end.

Ltac signs :=
  repeat match goal with s : bool |- _ => destruct s end;
  cbn [Signed ChildAlong negb]; try ring.

Ltac seen x := flag x; arrange; try (apply SameArrange; signs).

(** ** Cells, children and points *)

Lemma CellHere x : CellSeen x 0 0 0 = CellOf x.
Proof. flag x; arrange. apply SameArrange; signs. Qed.

Lemma CellByCorner x i j k : CellSeen (OtherCorner x) i j k = CellSeen x i j (- k).
Proof. seen x. Qed.
Lemma CellByEdge x i j k : CellSeen (OtherEdge x) i j k = CellSeen x i k j.
Proof. seen x. Qed.
Lemma CellByFace x i j k : CellSeen (OtherFace x) i j k = CellSeen x j i k.
Proof. seen x. Qed.
Lemma CellByCell x i j k : CellSeen (OtherCell x) i j k = CellSeen x (1 - i) j k.
Proof. seen x. Qed.

Lemma ChildByCorner x i j k : ChildSeen (OtherCorner x) i j k = ChildSeen x i j (1 - k).
Proof. seen x. Qed.
Lemma ChildByEdge x i j k : ChildSeen (OtherEdge x) i j k = ChildSeen x i k j.
Proof. seen x. Qed.
Lemma ChildByFace x i j k : ChildSeen (OtherFace x) i j k = ChildSeen x j i k.
Proof. seen x. Qed.
Lemma ChildByCell x i j k : ChildSeen (OtherCell x) i j k = ChildSeen x (3 - i) j k.
Proof. seen x. Qed.

Lemma PointByCorner x i j k :
  PointInHalfSides (OtherCorner x) i j k = PointInHalfSides x i j (- k).
Proof. seen x. Qed.
Lemma PointByEdge x i j k :
  PointInHalfSides (OtherEdge x) i j k = PointInHalfSides x i k j.
Proof. seen x. Qed.
Lemma PointByFace x i j k :
  PointInHalfSides (OtherFace x) i j k = PointInHalfSides x j i k.
Proof. seen x. Qed.
Lemma PointByCell x i j k :
  PointInHalfSides (OtherCell x) i j k = PointInHalfSides x (2 - i) j k.
Proof. seen x. Qed.

Lemma LevelByCorner x : LevelOf (OtherCorner x) = LevelOf x.
Proof. destruct x; reflexivity. Qed.
Lemma LevelByEdge x : LevelOf (OtherEdge x) = LevelOf x.
Proof. destruct x; reflexivity. Qed.
Lemma LevelByFace x : LevelOf (OtherFace x) = LevelOf x.
Proof. destruct x; reflexivity. Qed.
Lemma LevelByCell x : LevelOf (OtherCell x) = LevelOf x.
Proof. destruct x; reflexivity. Qed.

Lemma CellOfCorner x : CellOf (OtherCorner x) = CellOf x.
Proof. destruct x; reflexivity. Qed.
Lemma CellOfEdge x : CellOf (OtherEdge x) = CellOf x.
Proof. destruct x; reflexivity. Qed.
Lemma CellOfFace x : CellOf (OtherFace x) = CellOf x.
Proof. destruct x; reflexivity. Qed.
Lemma CellOfCell x : CellOf (OtherCell x) = CellSeen x 1 0 0.
Proof. destruct x; reflexivity. Qed.

(** ** There and back *)

Lemma CornerTwice x : OtherCorner (OtherCorner x) = x.
Proof. destruct x; cbn; now rewrite negb_involutive. Qed.
Lemma EdgeTwice x : OtherEdge (OtherEdge x) = x.
Proof. destruct x; cbn; now rewrite SwapLastTwice. Qed.
Lemma FaceTwice x : OtherFace (OtherFace x) = x.
Proof. destruct x; cbn; now rewrite SwapFirstTwice. Qed.
Lemma CellTwice x : OtherCell (OtherCell x) = x.
Proof.
  flag x; cbn [OtherCell]; rewrite negb_involutive; f_equal.
  arrange. apply SameArrange; signs.
Qed.

Lemma CornerThenCell x : OtherCell (OtherCorner x) = OtherCorner (OtherCell x).
Proof. flag x; cbn [OtherCell OtherCorner]. f_equal. arrange. apply SameArrange; signs. Qed.
Lemma CellThenEdge x : OtherEdge (OtherCell x) = OtherCell (OtherEdge x).
Proof. flag x; cbn [OtherCell OtherEdge]. f_equal. arrange. apply SameArrange; signs. Qed.
Lemma CornerThenFace x : OtherFace (OtherCorner x) = OtherCorner (OtherFace x).
Proof. destruct x; reflexivity. Qed.
(** Around a face of a cell. *)
Lemma AroundFace x :
  OtherEdge (OtherCorner (OtherEdge (OtherCorner x)))
  = OtherCorner (OtherEdge (OtherCorner (OtherEdge x))).
Proof. destruct x; reflexivity. Qed.

(** ** Where the parent lies *)

Lemma AheadNot s n : IsAhead (negb s) n = negb (IsAhead s n).
Proof. unfold IsAhead. destruct s, (Z.even n); reflexivity. Qed.

Lemma AheadEdgeByCorner x : AheadAtEdge (OtherCorner x) = AheadAtEdge x.
Proof. destruct x; reflexivity. Qed.
Lemma AheadCornerByCorner x : AheadAtCorner (OtherCorner x) = negb (AheadAtCorner x).
Proof. destruct x; apply AheadNot. Qed.
Lemma AheadEdgeByEdge x : AheadAtEdge (OtherEdge x) = AheadAtCorner x.
Proof. destruct x as [l [] o s t u]; destruct o; reflexivity. Qed.
Lemma AheadCornerByEdge x : AheadAtCorner (OtherEdge x) = AheadAtEdge x.
Proof. destruct x as [l [] o s t u]; destruct o; reflexivity. Qed.

Lemma SeenByCorner x i j k : PointSeen (OtherCorner x) i j k = PointSeen x i j (- k).
Proof. unfold PointSeen. now rewrite LevelByCorner, PointByCorner. Qed.
Lemma SeenByEdge x i j k : PointSeen (OtherEdge x) i j k = PointSeen x i k j.
Proof. unfold PointSeen. now rewrite LevelByEdge, PointByEdge. Qed.
Lemma SeenByFace x i j k : PointSeen (OtherFace x) i j k = PointSeen x j i k.
Proof. unfold PointSeen. now rewrite LevelByFace, PointByFace. Qed.
Lemma SeenByCell x i j k : PointSeen (OtherCell x) i j k = PointSeen x (2 - i) j k.
Proof. unfold PointSeen. now rewrite LevelByCell, PointByCell. Qed.

(** ** One level down and up *)

Lemma HalfSideUp l : HalfSide (S l) = 2 * HalfSide l.
Proof. unfold HalfSide. rewrite Nat2Z.inj_succ, Z.pow_succ_r; lia. Qed.

Lemma AheadOfPart s a n : IsAhead s (2 * a + ChildAlong s n) = Z.even n.
Proof.
  unfold IsAhead. destruct s; cbn [ChildAlong]; rewrite Z.even_add, Z.even_mul; cbn [orb];
    rewrite ?Z.even_sub; now destruct (Z.even n).
Qed.

Ltac finer x :=
  destruct x as [[|] v o s t u]; [discriminate|];
  destruct (Arranged o v) as (a & b & c & ->);
  cbn [FinerInCell FinerInOther].

Lemma FinerInCellLevel x l : LevelOf x = S l -> LevelOf (FinerInCell x) = l.
Proof. destruct x as [[|] ? ? ? ? ?]; cbn; congruence. Qed.
Lemma FinerInOtherLevel x l : LevelOf x = S l -> LevelOf (FinerInOther x) = l.
Proof. destruct x as [[|] ? ? ? ? ?]; cbn; congruence. Qed.

Lemma CellByFinerInCell x l i j k : LevelOf x = S l ->
  CellSeen (FinerInCell x) i j k = ChildSeen x (1 + j) (1 - k) i.
Proof. intros L. finer x. arrange. apply SameArrange; signs. Qed.
Lemma CellByFinerInOther x l i j k : LevelOf x = S l ->
  CellSeen (FinerInOther x) i j k = ChildSeen x (2 - i) (1 + j) (1 - k).
Proof. intros L. finer x. arrange. apply SameArrange; signs. Qed.

Lemma SeenByFinerInCell x l i j k : LevelOf x = S l ->
  PointSeen (FinerInCell x) (2 * k + 1) (2 * i - 1) (1 - 2 * j) = PointSeen x i j k.
Proof.
  intros L. finer x. arrange. rewrite HalfSideUp. apply SameArrange; signs.
Qed.
Lemma SeenByFinerInOther x l i j k : LevelOf x = S l ->
  PointSeen (FinerInOther x) (3 - 2 * i) (2 * j - 1) (1 - 2 * k) = PointSeen x i j k.
Proof.
  intros L. finer x. arrange. rewrite HalfSideUp. apply SameArrange; signs.
Qed.

(** The order's other names. *)
Lemma AheadTells level o a b c s t u :
  AheadAtFace (MakeFlag level (Arrange o a b c) o s t u) = IsAhead s a /\
  AheadAtEdge (MakeFlag level (Arrange o a b c) o s t u) = IsAhead t b /\
  AheadAtCorner (MakeFlag level (Arrange o a b c) o s t u) = IsAhead u c.
Proof. destruct o; repeat split; reflexivity. Qed.

Lemma AheadInCell x l : LevelOf x = S l ->
  AheadAtFace (FinerInCell x) = true /\ AheadAtEdge (FinerInCell x) = false /\
  AheadAtCorner (FinerInCell x) = true.
Proof.
  intros L. finer x. arrange. rewrite <- (ArrangeRotateIn o).
  match goal with |- context [MakeFlag ?l (Arrange ?o ?a ?b ?c) ?o ?s ?t ?u] =>
    destruct (AheadTells l o a b c s t u) as (-> & -> & ->)
  end.
  rewrite ?AheadNot, !AheadOfPart. auto.
Qed.

Lemma AheadInOther x l : LevelOf x = S l ->
  AheadAtFace (FinerInOther x) = false /\ AheadAtEdge (FinerInOther x) = false /\
  AheadAtCorner (FinerInOther x) = true.
Proof.
  intros L. finer x. arrange.
  match goal with |- context [MakeFlag ?l (Arrange ?o ?a ?b ?c) ?o ?s ?t ?u] =>
    destruct (AheadTells l o a b c s t u) as (-> & -> & ->)
  end.
  rewrite !AheadNot, !AheadOfPart. auto.
Qed.

Lemma HalfOfPart s a n : 0 <= n <= 1 -> (2 * a + ChildAlong s n) / 2 = a.
Proof. destruct s; cbn [ChildAlong]; intros; euclid. Qed.

Lemma PartOfHalf s a n : 0 <= n <= 1 -> IsAhead s a = Z.even n ->
  2 * (a / 2) + ChildAlong s n = a.
Proof.
  unfold IsAhead. intros B A.
  assert (n = 0 \/ n = 1) as [-> | ->] by lia; cbn in A;
    pose proof (Z.div_mod a 2 ltac:(lia)) as D; rewrite Zmod_even in D;
    destruct s, (Z.even a); try discriminate A; cbn [ChildAlong]; lia.
Qed.

Lemma CoarserOfCell x l : LevelOf x = S l -> Coarser (FinerInCell x) = x.
Proof.
  intros L. destruct (AheadInCell x l L) as (A & _). revert A. finer x. cbn [Coarser].
  intros ->. rewrite RotateOutIn, negb_involutive. f_equal.
  arrange. rewrite !HalfOfPart by lia. reflexivity.
Qed.

Lemma CoarserOfOther x l : LevelOf x = S l -> Coarser (FinerInOther x) = x.
Proof.
  intros L. destruct (AheadInOther x l L) as (A & _).
  pose proof (CellByFinerInOther x l 1 0 0 L) as C. revert A C. finer x. cbn [Coarser].
  intros -> ->. rewrite !negb_involutive. f_equal.
  arrange. rewrite !HalfOfPart by lia. reflexivity.
Qed.

Lemma LevelOfCoarser x : LevelOf (Coarser x) = S (LevelOf x).
Proof. destruct x as [l c o s t u]; cbn [Coarser]. now destruct (AheadAtFace _). Qed.

Lemma CellOfCoarser x : AheadAtEdge x = false -> AheadAtCorner x = true ->
  AheadAtFace x = true -> FinerInCell (Coarser x) = x.
Proof.
  flag x. destruct (AheadTells level o a b c s t u) as (F & -> & ->).
  intros E C F'. cbn [Coarser]. rewrite F'. rewrite F in F'. cbn [FinerInCell].
  rewrite RotateInOut, negb_involutive. f_equal.
  unfold ChildSeen. rewrite ParentArrange, ScaleArrange, ArrangeRotateOut, TranslateArrange.
  apply SameArrange; apply PartOfHalf; try lia; rewrite ?AheadNot, ?E, ?C, ?F'; reflexivity.
Qed.

Lemma OtherOfCoarser x : AheadAtEdge x = false -> AheadAtCorner x = true ->
  AheadAtFace x = false -> FinerInOther (Coarser x) = x.
Proof.
  flag x. destruct (AheadTells level o a b c s t u) as (F & -> & ->).
  intros E C F'. cbn [Coarser]. rewrite F'. rewrite F in F'. cbn [FinerInOther].
  rewrite !negb_involutive. f_equal. arrange.
  assert (Z0 : forall r d, Signed r 0 = 0 /\ d + 0 = d) by (intros []; cbn; lia).
  apply SameArrange.
  - unfold IsAhead in F'. pose proof (Z.div_mod a 2 ltac:(lia)) as D.
    rewrite Zmod_even in D.
    destruct s, (Z.even a); try discriminate F'; cbn [Signed ChildAlong negb];
      euclid.
  - destruct (Z0 t b) as [-> ->]. apply PartOfHalf; [lia|]. now rewrite E.
  - destruct (Z0 u c) as [-> ->]. apply PartOfHalf; [lia|]. now rewrite AheadNot, C.
Qed.
