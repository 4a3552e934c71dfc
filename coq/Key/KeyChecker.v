(** * Deciding whether stencils fit together, in every order of the cuts

    On symbols, as in [TriangleChecker]: the stencils of a structured
    tetrahedron whose corners are the labels [F1 F2 F3 P]. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Stencil.Symbol Stencil.TriangleChecker
  Key.KeyTet Key.FaceRule Key.Orders.
Open Scope Z_scope.
Open Scope bool_scope.

Definition TetLabels : list Label := [F1; F2; F3; P].

(** The cuts of the edges from a + to a - label. *)
Definition CutsOf (sign : Label -> Sign) : list (Label * Label) :=
  filter (fun '(a, e) => IsPlus (sign a) && IsMinus (sign e))
    (list_prod TetLabels TetLabels).

Definition SamePair (x y : Label * Label) : bool :=
  SameLabel (fst x) (fst y) && SameLabel (snd x) (snd y).

(** A key of labels, on symbols. *)
Definition SymbolKey (key : Label -> Label -> Z) (s r : Symbol) : Z :=
  match s, r with Base a, Base b => key a b | _, _ => 0 end.

Definition RankKey (order : list (Label * Label)) (a e : Label) : Z :=
  RankIn SamePair order (a, e).

Definition RankedTets (sign : Label -> Sign) (order : list (Label * Label))
  : list SymbolicTet :=
  GetKeyTets Symbol (SymbolSign sign) SymbolIntersection (SymbolKey (RankKey order))
    (Base F1) (Base F2) (Base F3) (Base P).

Definition RankedTriangles (sign : Label -> Sign) (order : list (Label * Label))
  (f1 f2 f3 : Label) : list TriangleChecker.Triangle :=
  FaceTriangles Symbol (SymbolSign sign) SymbolIntersection
    (SymbolKey (RankKey order)) (Base f1) (Base f2) (Base f3).

(** ** On a face the triangles are those of the face's own rule *)

Definition InTriangle (s : Symbol) (t : TriangleChecker.Triangle) : bool :=
  let '(x, y, z) := t in Member s [x; y; z].

Definition SomeTriangleHas (ts : list TriangleChecker.Triangle)
  (abc : TriangleChecker.Triangle) : bool :=
  let '(a, b, c) := abc in
  existsb (fun t => InTriangle a t && InTriangle b t && InTriangle c t) ts.

(** All six orders of the corners of the four faces. *)
Definition OrderedFaces : list (Label * Label * Label) :=
  filter (fun '(a, b, c) =>
    negb (SameLabel a b) && negb (SameLabel b c) && negb (SameLabel a c))
    (list_prod (list_prod TetLabels TetLabels) TetLabels).

Definition CheckFaceRule (sign : Label -> Sign) (order : list (Label * Label))
  (f : Label * Label * Label) : bool :=
  let '(f1, f2, f3) := f in
  let face := [f1; f2; f3] in
  let rule := RankedTriangles sign order f1 f2 f3 in
  let ts := RankedTets sign order in
  if SomePlus sign face then
    forallb (fun t => forallb (fun abc =>
      negb (TriangleOn face abc) || SomeTriangleHas rule abc) (Triangles t)) ts
    && forallb (SomeHas ts) rule
  else true.

(** ** Every order *)

Definition CheckOrdered (sign : Label -> Sign) (order : list (Label * Label)) : bool :=
  let ts := RankedTets sign order in
  CheckInner sign ts && CheckClosed sign ts
  && CheckStaysIn TetLabels ts
  && forallb (fun face => CheckReachesOff face ts && CheckOnce face ts) Faces
  && forallb (CheckFaceRule sign order) OrderedFaces.

(** The sign of [Q], which is no corner, plays no part. *)
Definition CornerSigns (s1 s2 s3 sp : Sign) : Label -> Sign :=
  SignOf s1 s2 s3 sp OnSurface.

Definition ForAllCornerSigns (test : (Label -> Sign) -> bool) : bool :=
  ForAllSigns (fun s1 => ForAllSigns (fun s2 => ForAllSigns (fun s3 =>
    ForAllSigns (fun sp => test (CornerSigns s1 s2 s3 sp))))).
