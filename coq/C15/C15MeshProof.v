(** * The output of C15 by key is one mesh: proof *)

From Certet Require Import Key.Definitions.
From Certet Require Import Lattice.Tiling Angles.Cases.Isometry.
From Certet Require Import C15.Sites C15.C15Tet C15.C15Spec C15.C15TilingProof
  C15.TilingStuffing C15.TilingMeshProof C15.C15Stuffing.
Open Scope Z_scope.

(** ** Keys *)

Lemma OffsetsSmall s o : In o (SiteOffsets s) ->
  match o with C3 x y z => -3 <= x <= 3 /\ -3 <= y <= 3 /\ -3 <= z <= 3 end.
Proof.
  destruct s; cbn [SiteOffsets In]; intros I;
    repeat (destruct I as [<-|I]; [lia|]); destruct I.
Qed.

Lemma RanksApart o e : OffsetRank o = OffsetRank e ->
  (match o with C3 x y z => -3 <= x <= 3 /\ -3 <= y <= 3 /\ -3 <= z <= 3 end) ->
  (match e with C3 x y z => -3 <= x <= 3 /\ -3 <= y <= 3 /\ -3 <= z <= 3 end) -> o = e.
Proof.
  destruct o as [x y z], e as [x' y' z']. cbn [OffsetRank]. intros E B B'.
  f_equal; lia.
Qed.

Lemma RankSmall o :
  (match o with C3 x y z => -3 <= x <= 3 /\ -3 <= y <= 3 /\ -3 <= z <= 3 end) ->
  -171 <= OffsetRank o <= 171.
Proof. destruct o. cbn [OffsetRank]. lia. Qed.

Lemma InC15Corners tid v : In v (C15Corners tid) <-> exists i, v = C15Vertex tid i.
Proof. exact (InVertices C15Tiling tid v). Qed.

Lemma CornersSmall tid a b : In a (C15Corners tid) -> In b (C15Corners tid) -> a <> b ->
  match Difference a b with C3 x y z => -3 <= x <= 3 /\ -3 <= y <= 3 /\ -3 <= z <= 3 end.
Proof.
  intros A B N. apply InC15Corners in A, B. destruct A as (i & ->), B as (j & ->).
  apply (OffsetsSmall (SiteOf (C15Vertex tid i))).
  apply C15VerticesJoined. congruence.
Qed.

Theorem C15CutKeysApart cut tid : KeysApart (C15CutKey cut) (C15Corners tid).
Proof.
  intros a b m A B M ab am bm. unfold C15CutKey.
  pose proof (CornersSmall tid a m A M am) as S1.
  pose proof (CornersSmall tid b m B M bm) as S2.
  assert (S3 := CornersSmall tid m a M A (fun E => am (eq_sym E))).
  assert (S4 := CornersSmall tid m b M B (fun E => bm (eq_sym E))).
  pose proof (RankSmall _ S1). pose proof (RankSmall _ S2).
  pose proof (RankSmall _ S3). pose proof (RankSmall _ S4).
  split; intros E.
  - assert (R : OffsetRank (Difference a m) = OffsetRank (Difference b m)) by lia.
    apply ab. pose proof (RanksApart _ _ R S1 S2) as D.
    destruct a, b, m. cbn [Difference] in D. injection D as D1 D2 D3. f_equal; lia.
  - assert (R : OffsetRank (Difference m a) = OffsetRank (Difference m b)) by lia.
    apply ab. pose proof (RanksApart _ _ R S3 S4) as D.
    destruct a, b, m. cbn [Difference] in D. injection D as D1 D2 D3. f_equal; lia.
Qed.

(** ** Neighbours *)

Lemma LinedAreCorners case i :
  match C15NeighborOf case i with
    Nei _ _ p q r s => forall j, exists k, Pick (p, q, r, s) k = j
  end.
Proof.
  pose proof (OfEachTwoPlaces (fun case i j =>
    match C15NeighborOf case i with
      Nei _ _ p q r s => existsb (fun k => SamePlace (Pick (p, q, r, s) k) j) AllPlaces
    end) ltac:(vm_compute; reflexivity) case i) as T. cbv beta in T.
  destruct (C15NeighborOf case i) as [away other p q r s]. intros j. specialize (T j).
  apply existsb_exists in T. destruct T as (k & _ & T). exists k.
  apply SamePlaceEqual, T.
Qed.

Lemma C15Reordered (tid : C15TetId) i v :
  In v (VerticesOf C15Tiling (TilingNeighbor C15Tiling tid i)) <->
  exists j, v = LinedUp C15Tiling tid i j.
Proof.
  rewrite (InVertices C15Tiling). destruct tid as [cell case].
  setoid_rewrite LinedUpAt. unfold LinedCorner, TilingNeighbor.
  cbn [C15Tiling NeighborAt VertexOf C15Across].
  pose proof (LinedAreCorners case i) as L.
  destruct (C15NeighborOf case i) as [away other p q r s]. cbn [fst C15Vertex].
  rewrite CellTranslated. split.
  - intros (j & ->). destruct (L j) as (k & <-). exists k.
    apply TranslateAssociative.
  - intros (j & ->). exists (Pick (p, q, r, s) j). symmetry. apply TranslateAssociative.
Qed.

(** ** The mesh *)

Theorem C15FacesConform after cut (tid : C15TetId) i a b c :
  let face := TilingFace C15Tiling tid i in
  let made := TilingNames C15Tiling (C15CutKey cut) after in
  LiesIn face a -> LiesIn face b -> LiesIn face c ->
  ((exists f, In f face /\ after f = Plus) ->
   AmongTriangles (made tid) a b c <->
   AmongTriangles (made (TilingNeighbor C15Tiling tid i)) a b c) /\
  (forall t u, In t (made tid) -> In u (made tid) ->
     HasTriangle t a b c -> HasTriangle u a b c -> t = u).
Proof.
  intros face made A B C. split.
  - intros plus.
    exact (TilingFacesAgree C15Tiling C15VerticesApart (C15CutKey cut) after
             C15FacesCorrect C15Reordered (C15CutKeysApart cut) tid i plus a b c A B C).
  - intros t u It Iu Ht Hu.
    exact (TilingTriangleOnce C15Tiling C15VerticesApart (C15CutKey cut) after
             (C15CutKeysApart cut) tid i t u a b c It Iu Ht Hu A B C).
Qed.

Theorem C15BoundaryOnSurface after cut (tid : C15TetId) t a b c :
  let made := TilingNames C15Tiling (C15CutKey cut) after in
  let sign := AfterSign after in
  In t (made tid) -> HasTriangle t a b c ->
  (sign a = OnSurface /\ sign b = OnSurface /\ sign c = OnSurface) \/
  (exists u, u <> t /\ HasTriangle u a b c /\
     (In u (made tid) \/
      exists i, In u (made (TilingNeighbor C15Tiling tid i)))).
Proof.
  exact (TilingBoundary C15Tiling C15VerticesApart (C15CutKey cut) after
           C15FacesCorrect C15Reordered (C15CutKeysApart cut) tid t a b c).
Qed.

Theorem C15TetrahedraInside after cut (tid : C15TetId) t :
  In t (TilingNames C15Tiling (C15CutKey cut) after tid) ->
  (exists v, In v (TetCorners t) /\ AfterSign after v = Plus) /\
  (forall v, In v (TetCorners t) -> AfterSign after v <> Minus).
Proof.
  destruct (FiveDistinct C15Tiling C15VerticesApart tid) as (q & D).
  exact (TilingInside C15Tiling (C15CutKey cut) after tid
           (C15CutKeysApart cut tid) q D t).
Qed.
