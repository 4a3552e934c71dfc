(** * The output is one mesh

    The triangle checker's verdict on symbols, carried over to [StuffTet] for
    every structured tetrahedron of the lattice. *)

From Certet Require Import Stuffing.Definitions.
From Certet Require Import Lattice.StructuredTetProof Lattice.Arrangement
  Lattice.ArrangementProof Stencil.Symbol Stencil.TriangleChecker
  Stencil.TriangleCheckerProof Stuffing.NameProof.

Local Opaque WarpVertex.

(** ** What the checker finds *)

Lemma SharedFacesFit : CheckSharedFaces GetUnstructuredTets = true.
Proof. vm_compute; reflexivity. Qed.

Lemma InsideFits : CheckInside GetUnstructuredTets = true.
Proof. vm_compute; reflexivity. Qed.

(** ** Both sides of a face *)

Lemma ArrangedLabels (f1 f2 f3 p q : Coord3) (tid nei : StructuredTetId) :
  match GetStructuredTet tid, GetStructuredTet nei with
    ST v1 v2 v3 v4 _ _ _ _, ST u1 u2 u3 u4 _ _ _ _ =>
      Arranged f1 f2 f3 p q v1 v2 v3 v4 u1 u2 u3 u4
  end ->
  exists a b c d a' b' c' d',
    In (Arrange a b c d a' b' c' d') Arrangements /\
    VerticesAre f1 f2 f3 p q tid a b c d /\
    VerticesAre f1 f2 f3 p q nei a' b' c' d'.
Proof.
  unfold VerticesAre.
  destruct (GetStructuredTet tid), (GetStructuredTet nei); intros [].
  - exists P, F1, F2, F3, Q, F1, F2, F3; cbn; tauto.
  - exists P, F1, F2, F3, F1, Q, F3, F2; cbn; tauto.
  - exists F1, P, F2, F3, Q, F1, F3, F2; cbn; tauto.
  - exists F1, P, F2, F3, F1, Q, F2, F3; cbn; tauto.
  - exists F1, F2, P, F3, F1, F2, Q, F3; cbn; tauto.
  - exists F1, F2, F3, P, F1, F2, F3, Q; cbn; tauto.
Qed.

Theorem FaceTriangulationsAgree :
  forall th sign cut tid i,
    let face := FaceOf tid i in
    (exists f, In f face /\ MeshVertexSign th sign cut (Corner f) = Plus) ->
    forall a b c, LiesIn face a -> LiesIn face b -> LiesIn face c ->
      AmongTriangles (StuffTet th sign cut tid) a b c <->
      AmongTriangles (StuffTet th sign cut (NeighborOf tid i)) a b c.
Proof.
  intros th sign cut tid i face plus a b c in_a in_b in_c.
  destruct (FaceShared tid i) as (f1 & f2 & f3 & p & q & is_face & distinct & arranged).
  apply ArrangedLabels in arranged
    as (l1 & l2 & l3 & l4 & m1 & m2 & m3 & m4 & listed & vertices & vertices').
  assert (face = map (LocateFive f1 f2 f3 p q) [F1; F2; F3]) as named by exact is_face.
  rewrite named in plus, in_a, in_b, in_c.
  destruct (LiesInName _ _ _ _ _ _ _ in_a) as [sa ->].
  destruct (LiesInName _ _ _ _ _ _ _ in_b) as [sb ->].
  destruct (LiesInName _ _ _ _ _ _ _ in_c) as [sc ->].
  unfold NeighborOf.
  rewrite (AmongStuffTet f1 f2 f3 p q distinct th sign cut _ _ _ _ _ _ _ _ vertices).
  rewrite (AmongStuffTet f1 f2 f3 p q distinct th sign cut _ _ _ _ _ _ _ _ vertices').
  apply (CheckSharedFacesSound _ _ _ _ _ _ _ _ _ SharedFacesFit listed).
  - apply (SomePlusCorner f1 f2 f3 p q th sign cut); exact plus.
  - apply (TriangleOnLiesIn f1 f2 f3 p q distinct); auto.
Qed.

(** ** One structured tetrahedron *)

(** Its vertices as the first four of five distinct points. *)
Lemma VerticesNamed (tid : StructuredTetId) :
  exists f1 f2 f3 p q,
    NoDup [f1; f2; f3; p; q] /\
    VerticesAre f1 f2 f3 p q tid F1 F2 F3 P.
Proof.
  pose proof (VerticesDistinct tid) as distinct.
  destruct tid as [anchor case].
  pose proof (AnchorApart anchor case) as apart.
  unfold VerticesAre.
  destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4].
  exists v1, v2, v3, v4, anchor; cbn; split; [| tauto].
  repeat constructor; cbn; intuition congruence.
Qed.

Lemma FaceNamed f1 f2 f3 p q (tid : StructuredTetId) (i : Place) :
  VerticesAre f1 f2 f3 p q tid F1 F2 F3 P ->
  exists labels, In labels Faces /\
    FaceOf tid i = map (LocateFive f1 f2 f3 p q) labels.
Proof.
  unfold VerticesAre, FaceOf; destruct (GetStructuredTet tid); cbn.
  intros (-> & -> & -> & ->); destruct i.
  - exists [F2; F3; P]; cbn; tauto.
  - exists [F1; F3; P]; cbn; tauto.
  - exists [F1; F2; P]; cbn; tauto.
  - exists [F1; F2; F3]; cbn; tauto.
Qed.

Lemma NamedFace f1 f2 f3 p q (tid : StructuredTetId) (labels : list Label) :
  VerticesAre f1 f2 f3 p q tid F1 F2 F3 P -> In labels Faces ->
  exists i, FaceOf tid i = map (LocateFive f1 f2 f3 p q) labels.
Proof.
  unfold VerticesAre, FaceOf; destruct (GetStructuredTet tid); cbn.
  intros (-> & -> & -> & ->) [<- | [<- | [<- | [<- | []]]]].
  - now exists First.
  - now exists Second.
  - now exists Third.
  - now exists Fourth.
Qed.

(** What is found once on symbols is there once under their names. *)
Lemma NamedTriangleOnce f1 f2 f3 p q h face ts : NoDup [f1; f2; f3; p; q] ->
  CheckOnce face ts = true ->
  let named := map (fun s => Orient h (MapTet (Name f1 f2 f3 p q) s)) ts in
  let face := map (LocateFive f1 f2 f3 p q) face in
  forall t u a b c, In t named -> In u named ->
    HasTriangle t a b c -> HasTriangle u a b c ->
    LiesIn face a -> LiesIn face b -> LiesIn face c -> t = u.
Proof.
  cbv zeta. intros distinct once t u a b c in_t in_u has_t has_u in_a in_b in_c.
  apply in_map_iff in in_t as (s & <- & in_s), in_u as (r & <- & in_r).
  rewrite OrientHasTriangle in has_t, has_u.
  destruct (HasTriangleNamed _ _ _ _ _ distinct _ _ _ _ has_t)
    as (sa & sb & sc & -> & -> & -> & has_s).
  rewrite HasTriangleName in has_u by exact distinct.
  do 2 f_equal. apply (CheckOnceSound face ts once) with sa sb sc; try assumption.
  apply (TriangleOnLiesIn f1 f2 f3 p q distinct); auto.
Qed.

Section Inside.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Variable tid : StructuredTetId.
  Let stuffing := StuffTet th sign cut tid.

  (** A tetrahedron of the output has a corner inside the domain and none
      outside. *)
  Theorem TetrahedraInside :
    forall t, In t stuffing ->
      (exists v, In v (TetCorners t) /\ MeshVertexSign th sign cut v = Plus) /\
      (forall v, In v (TetCorners t) -> MeshVertexSign th sign cut v <> Minus).
  Proof.
    intros t inside.
    destruct (VerticesNamed tid) as (f1 & f2 & f3 & p & q & distinct & vertices).
    destruct (StuffTetNamed f1 f2 f3 p q th sign cut tid F1 F2 F3 P vertices)
      as [h named].
    unfold stuffing in inside; rewrite named in inside.
    apply in_map_iff in inside as (s & <- & inside).
    destruct (CheckInnerSound _ _
      (fits_inner _ _ (CheckInsideSound _ InsideFits _ _ _ _ _)) s inside)
      as [(r & corner & plus) none].
    split.
    - exists (Name f1 f2 f3 p q r); split.
      + apply OrientCorners; rewrite MapTetCorners; now apply in_map.
      + now rewrite <- (SymbolSignName f1 f2 f3 p q th sign cut).
    - intros v corner_v.
      apply OrientCorners in corner_v; rewrite MapTetCorners in corner_v.
      apply in_map_iff in corner_v as (r' & <- & corner_r).
      rewrite <- (SymbolSignName f1 f2 f3 p q th sign cut); now apply none.
  Qed.

  (** A triangle on a face of the lattice belongs to one tetrahedron of each
      side. *)
  Theorem FaceTriangleOnce :
    forall i t u a b c,
      In t stuffing -> In u stuffing ->
      HasTriangle t a b c -> HasTriangle u a b c ->
      LiesIn (FaceOf tid i) a -> LiesIn (FaceOf tid i) b ->
      LiesIn (FaceOf tid i) c ->
      t = u.
  Proof.
    intros i t u a b c in_t in_u has_t has_u in_a in_b in_c.
    destruct (VerticesNamed tid) as (f1 & f2 & f3 & p & q & distinct & vertices).
    destruct (FaceNamed f1 f2 f3 p q tid i vertices) as (face & listed & is_face).
    rewrite is_face in in_a, in_b, in_c.
    destruct (StuffTetNamed f1 f2 f3 p q th sign cut tid F1 F2 F3 P vertices)
      as [h named].
    unfold stuffing in *; rewrite named in in_t, in_u.
    apply (NamedTriangleOnce f1 f2 f3 p q h face
      (NamedTets f1 f2 f3 p q th sign cut F1 F2 F3 P) distinct) with a b c; try assumption.
    now apply (CheckInsideSound _ InsideFits).
  Qed.

  (** A tetrahedron of the output has a corner off any given face, *)
  Lemma ReachesOff :
    forall i t, In t stuffing ->
      ~ (forall v, In v (TetCorners t) -> LiesIn (FaceOf tid i) v).
  Proof.
    intros i t inside on.
    destruct (VerticesNamed tid) as (f1 & f2 & f3 & p & q & distinct & vertices).
    destruct (FaceNamed f1 f2 f3 p q tid i vertices) as (face & listed & is_face).
    destruct (StuffTetNamed f1 f2 f3 p q th sign cut tid F1 F2 F3 P vertices)
      as [h named].
    unfold stuffing in inside; rewrite named in inside.
    apply in_map_iff in inside as (s & <- & inside).
    refine (CheckReachesOffSound face (NamedTets f1 f2 f3 p q th sign cut F1 F2 F3 P)
      _ s inside _).
    - now apply (CheckInsideSound _ InsideFits).
    - intros r corner; apply (LiesOnLiesIn f1 f2 f3 p q distinct).
      rewrite <- is_face; apply on, OrientCorners.
      rewrite MapTetCorners; now apply in_map.
  Qed.

  (** but none outside the structured tetrahedron. *)
  Lemma StaysIn :
    forall t v, In t stuffing -> In v (TetCorners t) ->
      match GetStructuredTet tid with ST v1 v2 v3 v4 _ _ _ _ =>
        LiesIn [v1; v2; v3; v4] v
      end.
  Proof.
    intros t v inside corner.
    destruct (VerticesNamed tid) as (f1 & f2 & f3 & p & q & distinct & vertices).
    destruct (StuffTetNamed f1 f2 f3 p q th sign cut tid F1 F2 F3 P vertices)
      as [h named].
    unfold stuffing in inside; rewrite named in inside.
    apply in_map_iff in inside as (s & <- & inside).
    apply OrientCorners in corner; rewrite MapTetCorners in corner.
    apply in_map_iff in corner as (r & <- & corner).
    unfold VerticesAre in vertices; destruct (GetStructuredTet tid).
    destruct vertices as (-> & -> & -> & ->).
    apply (LiesOnLiesIn f1 f2 f3 p q distinct [F1; F2; F3; P]).
    apply (CheckStaysInSound [F1; F2; F3; P]
      (NamedTets f1 f2 f3 p q th sign cut F1 F2 F3 P)) with s; try assumption.
    now apply (CheckInsideSound _ InsideFits).
  Qed.

  (** A triangle with an inner corner is met twice within the structured
      tetrahedron, or lies on one of its faces that has a + corner. *)
  Lemma TriangleClosed :
    forall t a b c,
      In t stuffing -> HasTriangle t a b c ->
      (MeshVertexSign th sign cut a = OnSurface /\
       MeshVertexSign th sign cut b = OnSurface /\
       MeshVertexSign th sign cut c = OnSurface) \/
      (exists u, In u stuffing /\ u <> t /\ HasTriangle u a b c) \/
      (exists i,
         (exists f, In f (FaceOf tid i) /\
            MeshVertexSign th sign cut (Corner f) = Plus) /\
         LiesIn (FaceOf tid i) a /\ LiesIn (FaceOf tid i) b /\
         LiesIn (FaceOf tid i) c).
  Proof.
    intros t a b c inside has.
    destruct (VerticesNamed tid) as (f1 & f2 & f3 & p & q & distinct & vertices).
    destruct (StuffTetNamed f1 f2 f3 p q th sign cut tid F1 F2 F3 P vertices)
      as [h named].
    unfold stuffing in *; rewrite named in *.
    apply in_map_iff in inside as (s & <- & inside).
    rewrite OrientHasTriangle in has.
    destruct (HasTriangleNamed _ _ _ _ _ distinct _ _ _ _ has)
      as (sa & sb & sc & -> & -> & -> & has_s).
    destruct (CheckClosedSound (LabelSign f1 f2 f3 p q th sign cut)
      (NamedTets f1 f2 f3 p q th sign cut F1 F2 F3 P)
      (fits_closed _ _ (CheckInsideSound _ InsideFits _ _ _ _ _))
      s sa sb sc inside has_s)
      as [surface | [(r & inside_r & differs & has_r) | (face & listed & plus & on)]].
    - left; revert surface; cbn [TriangleOnSurface].
      rewrite !(SymbolSignName f1 f2 f3 p q th sign cut), !andb_true_iff.
      intros [[zero_a zero_b] zero_c].
      repeat split;
        match goal with |- ?x = OnSurface => now destruct x end.
    - right; left; exists (Orient h (MapTet (Name f1 f2 f3 p q) r)).
      split; [apply in_map_iff; eauto |]; split.
      + intros same; apply differs.
        now apply (MapNameInjective f1 f2 f3 p q distinct), (OrientInjective h).
      + apply OrientHasTriangle, HasTriangleName; assumption.
    - right; right.
      destruct (NamedFace f1 f2 f3 p q tid face vertices listed) as [i is_face].
      exists i; rewrite is_face; split.
      + now apply (SomePlusCorner f1 f2 f3 p q th sign cut).
      + now apply (TriangleOnLiesIn f1 f2 f3 p q distinct).
  Qed.
End Inside.

(** ** Across faces *)

(** What lies in two adjacent structured tetrahedra lies in their face. *)
Lemma LiesInBoth (f1 f2 f3 p q v1 v2 v3 v4 u1 u2 u3 u4 : Coord3) (v : MeshVertex) :
  NoDup [f1; f2; f3; p; q] ->
  Arranged f1 f2 f3 p q v1 v2 v3 v4 u1 u2 u3 u4 ->
  LiesIn [v1; v2; v3; v4] v -> LiesIn [u1; u2; u3; u4] v -> LiesIn [f1; f2; f3] v.
Proof.
  intros distinct arranged.
  assert (point : forall x, In x [v1; v2; v3; v4] -> In x [u1; u2; u3; u4] ->
                            In x [f1; f2; f3]).
  { assert (p <> q).
    { intros <-; apply (NoDup_remove_2 [f1; f2; f3] [p] p) in distinct.
      apply distinct; cbn; tauto. }
    intros x; destruct arranged; cbn; intuition congruence. }
  destruct v as [x | x y]; cbn [LiesIn]; [auto |].
  intros [? ?] [? ?]; auto.
Qed.

Lemma NeverInNeighbor th sign cut tid i t :
  In t (StuffTet th sign cut tid) ->
  ~ In t (StuffTet th sign cut (NeighborOf tid i)).
Proof.
  intros here there; apply (ReachesOff th sign cut tid i t here).
  intros v corner.
  pose proof (StaysIn th sign cut tid t v here corner) as in_tid.
  pose proof (StaysIn th sign cut _ t v there corner) as in_nei.
  destruct (FaceShared tid i) as (f1 & f2 & f3 & p & q & is_face & distinct & arranged).
  unfold FaceOf; rewrite is_face; unfold NeighborOf in in_nei.
  destruct (GetStructuredTet (fst (NeighborAcross (GetStructuredTet tid) i))).
  destruct (GetStructuredTet tid).
  exact (LiesInBoth _ _ _ _ _ _ _ _ _ _ _ _ _ v distinct arranged in_tid in_nei).
Qed.

Theorem BoundaryOnSurface :
  forall th sign cut tid t a b c,
    In t (StuffTet th sign cut tid) -> HasTriangle t a b c ->
    (MeshVertexSign th sign cut a = OnSurface /\
     MeshVertexSign th sign cut b = OnSurface /\
     MeshVertexSign th sign cut c = OnSurface) \/
    (exists u, u <> t /\ HasTriangle u a b c /\
       (In u (StuffTet th sign cut tid) \/
        exists i, In u (StuffTet th sign cut (NeighborOf tid i)))).
Proof.
  intros th sign cut tid t a b c inside has.
  destruct (TriangleClosed th sign cut tid t a b c inside has)
    as [surface | [(u & inside_u & differs & has_u) | (i & plus & in_a & in_b & in_c)]].
  - now left.
  - right; exists u; auto.
  - right.
    destruct (proj1 (FaceTriangulationsAgree th sign cut tid i plus a b c in_a in_b in_c)
      (ex_intro _ t (conj inside has))) as (u & inside_u & has_u).
    exists u; split; [| split; [easy | eauto]].
    intros ->; exact (NeverInNeighbor th sign cut tid i t inside inside_u).
Qed.
