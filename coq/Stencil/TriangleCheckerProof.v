(** * Stencils that the triangle checker accepts fit together

    Still on symbols: from boolean functions to propositions. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stencil.TriangleChecker.

(** ** Comparing *)

Lemma SameSymbolDiffers (s t : Symbol) : negb (SameSymbol s t) = true <-> s <> t.
Proof. now rewrite negb_true_iff, <- not_true_iff_false, SameSymbolEqual. Qed.

Lemma SameTetEqual (t u : SymbolicTet) : SameTet t u = true <-> t = u.
Proof.
  destruct t, u; cbn; rewrite !andb_true_iff, !SameSymbolEqual.
  split; [intros [[[-> ->] ->] ->]; easy | intros [= -> -> -> ->]; tauto].
Qed.

Lemma SameTetDiffers (t u : SymbolicTet) : negb (SameTet t u) = true <-> t <> u.
Proof. now rewrite negb_true_iff, <- not_true_iff_false, SameTetEqual. Qed.

(** ** Triangles *)

Lemma TrianglesHasTriangle (t : SymbolicTet) (a b c : Symbol) :
  In (a, b, c) (Triangles t) <-> HasTriangle t a b c.
Proof.
  unfold Triangles, Distinct, HasTriangle.
  rewrite filter_In, !in_prod_iff, !andb_true_iff, !SameSymbolDiffers; tauto.
Qed.

Lemma HasHasTriangle (t u : SymbolicTet) (a b c : Symbol) :
  HasTriangle t a b c ->
  Has u (a, b, c) = true <-> HasTriangle u a b c.
Proof.
  unfold Has, HasTriangle; rewrite !andb_true_iff, !MemberIn; tauto.
Qed.

(** A check of every triangle of a list of tetrahedra. *)
Lemma ForAllTriangles (test : SymbolicTet -> Triangle -> bool) ts :
  forallb (fun t => forallb (test t) (Triangles t)) ts = true ->
  forall t a b c, In t ts -> HasTriangle t a b c -> test t (a, b, c) = true.
Proof.
  intros all t a b c inside has.
  rewrite forallb_forall in all; specialize (all t inside).
  rewrite forallb_forall in all; apply all.
  now apply TrianglesHasTriangle.
Qed.

(** ** Both sides of the shared face *)

Lemma CheckIncludedSound face ts us :
  CheckIncluded face ts us = true ->
  forall a b c, TriangleOn face (a, b, c) = true ->
    AmongTriangles ts a b c -> AmongTriangles us a b c.
Proof.
  intros check a b c on (t & inside & has).
  pose proof (ForAllTriangles _ ts check t a b c inside has) as found.
  cbv beta in found; rewrite on in found; cbn in found.
  apply existsb_exists in found as (u & inside_u & has_u).
  exists u; split; [easy |].
  now apply (HasHasTriangle t u).
Qed.

Lemma CheckSharedFacesSound (T : StencilSet) a b c d a' b' c' d' :
  CheckSharedFaces T = true ->
  In (Arrange a b c d a' b' c' d') Arrangements ->
  forall s1 s2 s3 sp sq,
    let sign := SignOf s1 s2 s3 sp sq in
    let face := [F1; F2; F3] in
    SomePlus sign face = true ->
    forall x y z, TriangleOn face (x, y, z) = true ->
      AmongTriangles (SymbolicTets T sign a b c d) x y z <->
      AmongTriangles (SymbolicTets T sign a' b' c' d') x y z.
Proof.
  intros check arrangement s1 s2 s3 sp sq sign face plus x y z on.
  unfold CheckSharedFaces in check; rewrite forallb_forall in check.
  specialize (check _ arrangement).
  apply ForAllSignAssignmentsSound with (s1 := s1) (s2 := s2) (s3 := s3)
    (sp := sp) (sq := sq) in check.
  fold sign face in check; cbv beta zeta in check.
  rewrite plus in check; cbn [negb orb] in check.
  apply andb_true_iff in check as [there back].
  split; now apply (CheckIncludedSound face).
Qed.

(** ** One structured tetrahedron *)

Lemma CheckInnerSound sign ts :
  CheckInner sign ts = true ->
  forall t, In t ts ->
    (exists s, In s (TetCorners t) /\ SymbolSign sign s = Plus) /\
    (forall s, In s (TetCorners t) -> SymbolSign sign s <> Minus).
Proof.
  intros check t inside.
  unfold CheckInner in check; rewrite forallb_forall in check.
  specialize (check t inside); cbv beta zeta in check.
  rewrite andb_true_iff, existsb_exists, forallb_forall in check.
  destruct check as [(sign_s & corner & plus) none]; split.
  - apply in_map_iff in corner as (s & <- & inside_s).
    exists s; split; [easy | now destruct (SymbolSign sign s)].
  - intros s corner_s minus.
    specialize (none _ (in_map (SymbolSign sign) _ _ corner_s)).
    now rewrite minus in none.
Qed.

Lemma CheckClosedSound sign ts :
  CheckClosed sign ts = true ->
  forall t a b c, In t ts -> HasTriangle t a b c ->
    TriangleOnSurface sign (a, b, c) = true \/
    (exists u, In u ts /\ u <> t /\ HasTriangle u a b c) \/
    (exists face, In face Faces /\ SomePlus sign face = true /\
       TriangleOn face (a, b, c) = true).
Proof.
  intros check t a b c inside has.
  pose proof (ForAllTriangles _ ts check t a b c inside has) as found.
  cbv beta in found; rewrite !orb_true_iff, !existsb_exists in found.
  destruct found as [[surface | (u & inside_u & both)] | (face & inside_f & both)].
  - now left.
  - apply andb_true_iff in both as [has_u differs]; right; left.
    apply SameTetDiffers, not_eq_sym in differs.
    exists u; split; [easy | split; [easy |]]; now apply (HasHasTriangle t u).
  - apply andb_true_iff in both as [plus on]; right; right.
    now exists face.
Qed.

Lemma CheckOnceSound face ts :
  CheckOnce face ts = true ->
  forall t u a b c, In t ts -> In u ts ->
    HasTriangle t a b c -> HasTriangle u a b c ->
    TriangleOn face (a, b, c) = true -> t = u.
Proof.
  intros check t u a b c inside_t inside_u has_t has_u on.
  pose proof (ForAllTriangles _ ts check t a b c inside_t has_t) as once.
  cbv beta in once; rewrite on in once; cbn in once.
  rewrite forallb_forall in once; specialize (once u inside_u).
  apply (HasHasTriangle u u a b c has_u) in has_u.
  unfold Has in has_u; rewrite has_u in once; now apply SameTetEqual.
Qed.

Lemma CheckStaysInSound labels ts :
  CheckStaysIn labels ts = true ->
  forall t s, In t ts -> In s (TetCorners t) -> LiesOn labels s = true.
Proof.
  intros check t s inside corner.
  unfold CheckStaysIn in check; rewrite forallb_forall in check.
  specialize (check t inside); rewrite forallb_forall in check; now apply check.
Qed.

Lemma CheckReachesOffSound face ts :
  CheckReachesOff face ts = true ->
  forall t, In t ts ->
    ~ (forall s, In s (TetCorners t) -> LiesOn face s = true).
Proof.
  intros check t inside; rewrite <- forallb_forall, not_true_iff_false.
  unfold CheckReachesOff in check; rewrite forallb_forall in check.
  now apply negb_true_iff, check.
Qed.

Record FitsInside (sign : Label -> Sign) (ts : list SymbolicTet) : Prop := {
  fits_inner : CheckInner sign ts = true;
  fits_closed : CheckClosed sign ts = true;
  fits_stays : CheckStaysIn [F1; F2; F3; P] ts = true;
  fits_reaches : forall face, In face Faces -> CheckReachesOff face ts = true;
  fits_once : forall face, In face Faces -> CheckOnce face ts = true;
}.

Lemma CheckInsideSound (T : StencilSet) :
  CheckInside T = true ->
  forall s1 s2 s3 sp sq,
    let sign := SignOf s1 s2 s3 sp sq in
    FitsInside sign (SymbolicTets T sign F1 F2 F3 P).
Proof.
  intros check s1 s2 s3 sp sq sign.
  apply ForAllSignAssignmentsSound with (s1 := s1) (s2 := s2) (s3 := s3)
    (sp := sp) (sq := sq) in check.
  fold sign in check; cbv beta zeta in check.
  rewrite !andb_true_iff, forallb_forall in check.
  destruct check as [[[inner closed] stays] faces].
  constructor; try assumption; intros face inside;
    now apply faces, andb_true_iff in inside.
Qed.
