(** * The symmetries of the lattice that keep a vertex

    Forty-eight linear maps permute the axes and mirror some of them.  They
    carry the fourteen edges of a vertex to one another and change no dihedral
    angle. *)

From Certet Require Import Angles.Definitions.
Open Scope Z_scope.

(** The images of the three unit vectors. *)
Inductive Linear := Lin : Coord3 -> Coord3 -> Coord3 -> Linear.

Definition Apply (m : Linear) (v : Coord3) : Coord3 :=
  match m, v with
    Lin a b c, C3 x y z =>
      Translate (Scale x a) (Translate (Scale y b) (Scale z c))
  end.

Definition Determinant (m : Linear) : Z :=
  match m with Lin a b c => Dot (Cross a b) c end.

Definition Orthonormal (m : Linear) : Prop :=
  match m with
    Lin a b c =>
      Dot a a = 1 /\ Dot b b = 1 /\ Dot c c = 1 /\
      Dot a b = 0 /\ Dot a c = 0 /\ Dot b c = 0
  end.

Definition OrthonormalTest (m : Linear) : bool :=
  match m with
    Lin a b c =>
      (Dot a a =? 1) && (Dot b b =? 1) && (Dot c c =? 1) &&
      (Dot a b =? 0) && (Dot a c =? 0) && (Dot b c =? 0)
  end.

Definition Axes : list Coord3 :=
  [C3 1 0 0; C3 (-1) 0 0; C3 0 1 0; C3 0 (-1) 0; C3 0 0 1; C3 0 0 (-1)].

Definition AllIsometries : list Linear :=
  filter OrthonormalTest
    (flat_map (fun a => flat_map (fun b => map (Lin a b) Axes) Axes) Axes).

(** ** Quantities of a tetrahedron under a linear map *)

Lemma ApplyDifference m x y :
  Apply m (Difference x y) = Difference (Apply m x) (Apply m y).
Proof.
  destruct m as [[a1 a2 a3] [b1 b2 b3] [c1 c2 c3]], x, y.
  cbn [Apply Difference Translate Scale]. f_equal; ring.
Qed.

Lemma ApplyScale m k x : Apply m (Scale k x) = Scale k (Apply m x).
Proof.
  destruct m as [[a1 a2 a3] [b1 b2 b3] [c1 c2 c3]], x.
  cbn [Apply Translate Scale]. f_equal; ring.
Qed.

Lemma ApplyTranslate m x y :
  Apply m (Translate x y) = Translate (Apply m x) (Apply m y).
Proof.
  destruct m as [[a1 a2 a3] [b1 b2 b3] [c1 c2 c3]], x, y.
  cbn [Apply Translate Scale]. f_equal; ring.
Qed.

Lemma ApplyDot m u v : Orthonormal m -> Dot (Apply m u) (Apply m v) = Dot u v.
Proof.
  destruct m as [a b c], u as [u1 u2 u3], v as [v1 v2 v3].
  intros (Haa & Hbb & Hcc & Hab & Hac & Hbc).
  transitivity (u1 * v1 * Dot a a + u2 * v2 * Dot b b + u3 * v3 * Dot c c
    + (u1 * v2 + u2 * v1) * Dot a b + (u1 * v3 + u3 * v1) * Dot a c
    + (u2 * v3 + u3 * v2) * Dot b c).
  - destruct a, b, c. cbn [Apply Translate Scale Dot]. ring.
  - rewrite Haa, Hbb, Hcc, Hab, Hac, Hbc. cbn [Dot]. ring.
Qed.

Lemma ApplyTriple m u v t :
  Dot (Cross (Apply m u) (Apply m v)) (Apply m t)
  = Determinant m * Dot (Cross u v) t.
Proof.
  destruct m as [[a1 a2 a3] [b1 b2 b3] [c1 c2 c3]], u, v, t.
  cbn [Apply Translate Scale Dot Cross Determinant]. ring.
Qed.

Lemma CrossDotCross u v t :
  Dot (Cross u v) (Cross u t) = Dot u u * Dot v t - Dot u t * Dot v u.
Proof. destruct u, v, t. cbn [Dot Cross]. ring. Qed.

(** A linear map followed by a translation. *)
Definition Move (m : Linear) (shift x : Coord3) : Coord3 :=
  Translate shift (Apply m x).

Lemma MoveDifference m s x y :
  Difference (Move m s x) (Move m s y) = Apply m (Difference x y).
Proof.
  rewrite ApplyDifference. unfold Move.
  destruct (Apply m x), (Apply m y), s.
  cbn [Difference Translate]. f_equal; ring.
Qed.

Section Quantities.
  Variables (m : Linear) (s : Coord3).
  Hypothesis Hm : Orthonormal m.
  Variables a b c d : Coord3.

  Lemma MoveVolume :
    SixVolume (Move m s a) (Move m s b) (Move m s c) (Move m s d)
    = Determinant m * SixVolume a b c d.
  Proof.
    unfold SixVolume, Normal. rewrite !MoveDifference. apply ApplyTriple.
  Qed.

  Lemma MoveNormals :
    NormalsProduct (Move m s a) (Move m s b) (Move m s c) (Move m s d)
    = NormalsProduct a b c d.
  Proof.
    unfold NormalsProduct, Normal. rewrite !MoveDifference, !CrossDotCross.
    rewrite !ApplyDot by assumption. reflexivity.
  Qed.

  Lemma MoveEdge : EdgeSquared (Move m s a) (Move m s b) = EdgeSquared a b.
  Proof.
    unfold EdgeSquared. rewrite !MoveDifference. apply ApplyDot, Hm.
  Qed.
End Quantities.

(** ** Well-shaped tetrahedra *)

Section Invariance.
  Variable k : CotSquared.

  (** What the two bounds depend on. *)
  Lemma BoundsDepend a b c d a' b' c' d' :
    SixVolume a' b' c' d' ^ 2 = SixVolume a b c d ^ 2 ->
    NormalsProduct a' b' c' d' = NormalsProduct a b c d ->
    EdgeSquared a' b' = EdgeSquared a b ->
    (AngleAtLeast k a b c d -> AngleAtLeast k a' b' c' d') /\
    (AngleAtMost k a b c d -> AngleAtMost k a' b' c' d').
  Proof.
    intros V N L. destruct k as [num den].
    unfold AngleAtLeast, AngleAtMost. rewrite V, N, L. split; trivial.
  Qed.

  Ltac quantities :=
    repeat match goal with v : Coord3 |- _ => destruct v end;
    unfold SixVolume, NormalsProduct, EdgeSquared, Normal;
    cbn [Difference Cross Dot]; ring.

  (** An edge may be named from either end. *)
  Lemma BoundsReversed a b c d :
    (AngleAtLeast k a b c d -> AngleAtLeast k b a d c) /\
    (AngleAtMost k a b c d -> AngleAtMost k b a d c).
  Proof. apply BoundsDepend; quantities. Qed.

  (** A mirror image. *)
  Lemma BoundsMirrored a b c d :
    (AngleAtLeast k a b c d -> AngleAtLeast k a b d c) /\
    (AngleAtMost k a b c d -> AngleAtMost k a b d c).
  Proof. apply BoundsDepend; quantities. Qed.

  Lemma BoundsMoved m s a b c d :
    Orthonormal m -> Determinant m ^ 2 = 1 ->
    (AngleAtLeast k (Move m s a) (Move m s b) (Move m s c) (Move m s d) ->
     AngleAtLeast k a b c d) /\
    (AngleAtMost k (Move m s a) (Move m s b) (Move m s c) (Move m s d) ->
     AngleAtMost k a b c d).
  Proof.
    intros Hm Hd. apply BoundsDepend.
    - rewrite MoveVolume, Z.pow_mul_l, Hd. ring.
    - symmetry. apply MoveNormals, Hm.
    - symmetry. apply MoveEdge, Hm.
  Qed.
End Invariance.

(** The twelve even orders of the vertices. *)
Definition EvenPermutations {V} (t : UnstructuredTet V)
  : list (UnstructuredTet V) :=
  match t with
    UT _ a b c d =>
      [UT _ a b c d; UT _ a c d b; UT _ a d b c;
       UT _ b a d c; UT _ b d c a; UT _ b c a d;
       UT _ c d a b; UT _ c a b d; UT _ c b d a;
       UT _ d c b a; UT _ d b a c; UT _ d a c b]
  end.

Lemma WellShapedPermuted bounds (t t' : UnstructuredTet Coord3) :
  In t' (EvenPermutations t) -> WellShaped bounds t -> WellShaped bounds t'.
Proof.
  destruct bounds as [acute obtuse], t as [a b c d].
  cbn [EvenPermutations In]. intros I [V H].
  assert (H' : forall p q r s,
    In (p, q, r, s) (DihedralEdges (UT _ a b c d)) ->
    (AngleAtLeast acute p q r s /\ AngleAtMost obtuse p q r s) /\
    (AngleAtLeast acute q p s r /\ AngleAtMost obtuse q p s r)).
  { intros p q r s J. destruct (H p q r s J) as [H1 H2].
    repeat split; try assumption; apply BoundsReversed; assumption. }
  clear H. cbn [DihedralEdges In] in H'.
  assert (H1 := H' a b c d ltac:(tauto)). assert (H2 := H' a c d b ltac:(tauto)).
  assert (H3 := H' a d b c ltac:(tauto)). assert (H4 := H' b c a d ltac:(tauto)).
  assert (H5 := H' b d c a ltac:(tauto)). assert (H6 := H' c d a b ltac:(tauto)).
  clear H'.
  repeat (destruct I as [<-|I]; [
    split;
    [ replace (SixVolume _ _ _ _) with (SixVolume a b c d); [exact V|];
      destruct a, b, c, d; unfold SixVolume, Normal;
      cbn [Difference Cross Dot]; ring
    | intros p q r s J; cbn [DihedralEdges In] in J;
      repeat (destruct J as [J|J]; [injection J as <- <- <- <-; tauto|]);
      destruct J ]
    |]).
  destruct I.
Qed.

Lemma AnglesMoved acute obtuse m s a b c d :
  Orthonormal m -> Determinant m ^ 2 = 1 ->
  let t := UT _ a b c d in
  (forall p q r u, In (p, q, r, u) (DihedralEdges (MapTet (Move m s) t)) ->
     AngleAtLeast acute p q r u /\ AngleAtMost obtuse p q r u) ->
  forall p q r u, In (p, q, r, u) (DihedralEdges t) ->
    AngleAtLeast acute p q r u /\ AngleAtMost obtuse p q r u.
Proof.
  intros Hm Hd t H p q r u J. unfold t in *. cbn [MapTet DihedralEdges In] in *.
  repeat (destruct J as [J|J]; [injection J as <- <- <- <-;
    match goal with |- AngleAtLeast _ ?x ?y ?z ?w /\ _ =>
      destruct (H (Move m s x) (Move m s y) (Move m s z) (Move m s w)
                  ltac:(tauto)) as [H1 H2]
    end;
    split; [apply (BoundsMoved acute m s) | apply (BoundsMoved obtuse m s)];
    assumption |]).
  destruct J.
Qed.

Lemma WellShapedMoved bounds m s a b c d :
  Orthonormal m -> Determinant m = 1 ->
  WellShaped bounds (UT _ (Move m s a) (Move m s b) (Move m s c) (Move m s d)) ->
  WellShaped bounds (UT _ a b c d).
Proof.
  intros Hm Hd. destruct bounds as [acute obtuse]. intros [V H].
  rewrite MoveVolume, Hd, Z.mul_1_l in V. split; [exact V|].
  apply (AnglesMoved acute obtuse m s); [exact Hm|rewrite Hd; reflexivity|exact H].
Qed.

Lemma WellShapedMirrored bounds m s a b c d :
  Orthonormal m -> Determinant m = -1 ->
  WellShaped bounds (UT _ (Move m s a) (Move m s b) (Move m s c) (Move m s d)) ->
  WellShaped bounds (UT _ a b d c).
Proof.
  intros Hm Hd. destruct bounds as [acute obtuse]. intros [V H].
  rewrite MoveVolume, Hd in V. split.
  - replace (SixVolume a b d c) with (-1 * SixVolume a b c d); [exact V|].
    destruct a, b, c, d. unfold SixVolume, Normal.
    cbn [Difference Cross Dot]. ring.
  - assert (H' : forall p q r t,
      In (p, q, r, t) (DihedralEdges (UT _ a b c d)) ->
      AngleAtLeast acute p q r t /\ AngleAtMost obtuse p q r t).
    { apply (AnglesMoved acute obtuse m s); [exact Hm|rewrite Hd; reflexivity|exact H]. }
    assert (M : forall p q r t,
      AngleAtLeast acute p q r t /\ AngleAtMost obtuse p q r t ->
      (AngleAtLeast acute p q t r /\ AngleAtMost obtuse p q t r) /\
      (AngleAtLeast acute q p r t /\ AngleAtMost obtuse q p r t)).
    { intros p q r t [H1 H2].
      assert (H3 : AngleAtLeast acute p q t r) by (apply BoundsMirrored, H1).
      assert (H4 : AngleAtMost obtuse p q t r) by (apply BoundsMirrored, H2).
      repeat split; try assumption; apply BoundsReversed; assumption. }
    clear H V. cbn [DihedralEdges In] in H'.
    assert (H1 := M _ _ _ _ (H' a b c d ltac:(tauto))).
    assert (H2 := M _ _ _ _ (H' a c d b ltac:(tauto))).
    assert (H3 := M _ _ _ _ (H' a d b c ltac:(tauto))).
    assert (H4 := M _ _ _ _ (H' b c a d ltac:(tauto))).
    assert (H5 := M _ _ _ _ (H' b d c a ltac:(tauto))).
    assert (H6 := M _ _ _ _ (H' c d a b ltac:(tauto))).
    clear H' M. intros p q r t J. cbn [DihedralEdges In] in J.
    repeat (destruct J as [J|J]; [injection J as <- <- <- <-; tauto|]).
    destruct J.
Qed.

(** ** The forty-eight maps and the fourteen edges *)

Lemma IsometryOrthonormal m : In m AllIsometries -> Orthonormal m.
Proof.
  intros I. apply filter_In in I. destruct I as [_ T].
  destruct m as [a b c]. unfold OrthonormalTest in T.
  rewrite !andb_true_iff, !Z.eqb_eq in T. cbn [Orthonormal]. tauto.
Qed.

Definition SameKind (k l : EdgeKind) : bool :=
  match k, l with Long, Long | Short, Short => true | _, _ => false end.

Lemma SameKindEqual k l : SameKind k l = true -> k = l.
Proof. destruct k, l; reflexivity || discriminate. Qed.

Lemma Coord3EqualTrue a b : Coord3Equal a b = true -> a = b.
Proof.
  destruct a, b. cbn [Coord3Equal].
  rewrite !andb_true_iff, !Z.eqb_eq. intros [[-> ->] ->]. reflexivity.
Qed.

Lemma Coord3EqualRefl a : Coord3Equal a a = true.
Proof. destruct a. cbn [Coord3Equal]. rewrite !Z.eqb_refl. reflexivity. Qed.

Lemma InAllDirections d : In d AllDirections.
Proof. destruct d; cbn; tauto. Qed.

(** An isometry carries direction [d] to direction [e]. *)
Definition Carries (m : Linear) (d e : Direction) : bool :=
  Coord3Equal (Apply m (Offset d)) (Offset e)
  && SameKind (DirectionKind d) (DirectionKind e).

Lemma CarriesMeans m d e : Carries m d e = true ->
  Apply m (Offset d) = Offset e /\ DirectionKind d = DirectionKind e.
Proof.
  unfold Carries. rewrite andb_true_iff. intros [E K].
  split; [apply Coord3EqualTrue, E | apply SameKindEqual, K].
Qed.

(** Of each isometry and direction, if a look at all of them finds it. *)
Lemma OfEachIsometry (found : Linear -> Direction -> bool) :
  forallb (fun m => forallb (found m) AllDirections) AllIsometries = true ->
  forall m d, In m AllIsometries -> found m d = true.
Proof.
  intros T m d I. rewrite forallb_forall in T. specialize (T m I).
  rewrite forallb_forall in T. exact (T d (InAllDirections d)).
Qed.

Lemma ImageOfDirection m d : In m AllIsometries ->
  exists e, Apply m (Offset d) = Offset e /\ DirectionKind d = DirectionKind e.
Proof.
  intros I.
  pose proof (OfEachIsometry (fun m d => existsb (Carries m d) AllDirections)
    ltac:(vm_compute; reflexivity) m d I) as T.
  apply existsb_exists in T. destruct T as (e & _ & T).
  exists e. apply CarriesMeans, T.
Qed.

Lemma OriginOfDirection m e : In m AllIsometries ->
  exists d, Apply m (Offset d) = Offset e /\ DirectionKind d = DirectionKind e.
Proof.
  intros I.
  pose proof (OfEachIsometry (fun m e => existsb (fun d => Carries m d e) AllDirections)
    ltac:(vm_compute; reflexivity) m e I) as T.
  apply existsb_exists in T. destruct T as (d & _ & T).
  exists d. apply CarriesMeans, T.
Qed.

Lemma ApplyInjective m x y : Orthonormal m -> Apply m x = Apply m y -> x = y.
Proof.
  intros Hm E.
  assert (D : Dot (Difference x y) (Difference x y) = 0).
  { rewrite <- (ApplyDot m) by exact Hm. rewrite ApplyDifference, E.
    destruct (Apply m y). cbn [Difference Dot]. ring. }
  destruct x as [x1 x2 x3], y as [y1 y2 y3]. cbn [Difference Dot] in D.
  pose proof (Z.square_nonneg (y1 - x1)). pose proof (Z.square_nonneg (y2 - x2)).
  pose proof (Z.square_nonneg (y3 - x3)).
  assert (E1 : (y1 - x1) * (y1 - x1) = 0) by lia.
  assert (E2 : (y2 - x2) * (y2 - x2) = 0) by lia.
  assert (E3 : (y3 - x3) * (y3 - x3) = 0) by lia.
  apply Z.mul_eq_0 in E1, E2, E3. f_equal; lia.
Qed.
