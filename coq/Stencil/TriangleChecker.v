(** * Deciding whether stencils fit together, triangle by triangle

    Stronger than compatible edges: on the two sides of a face that has a +
    corner, the stencils must have the same triangles there.  Again on symbols,
    for any stencil set; that a positive answer can be relied upon is proved in
    [TriangleCheckerProof]. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Stencil.Symbol Stencil.CompatibilityChecker.
Open Scope bool_scope.

Definition SymbolicTet : Type := UnstructuredTet Symbol.
Definition Triangle : Type := Symbol * Symbol * Symbol.

(** ** Triangles of a tetrahedron *)

Definition Distinct (a b c : Symbol) : bool :=
  negb (SameSymbol a b) && negb (SameSymbol b c) && negb (SameSymbol a c).

(** In every order. *)
Definition Triangles (t : SymbolicTet) : list Triangle :=
  let corners := TetCorners t in
  filter (fun '(a, b, c) => Distinct a b c)
    (list_prod (list_prod corners corners) corners).

(** For three distinct symbols. *)
Definition Has (t : SymbolicTet) (abc : Triangle) : bool :=
  let '(a, b, c) := abc in
  let corners := TetCorners t in
  Member a corners && Member b corners && Member c corners.

Definition SomeHas (ts : list SymbolicTet) (abc : Triangle) : bool :=
  existsb (fun t => Has t abc) ts.

Definition SameTet (t u : SymbolicTet) : bool :=
  match t, u with
    UT _ a b c d, UT _ a' b' c' d' =>
      SameSymbol a a' && SameSymbol b b' && SameSymbol c c' && SameSymbol d d'
  end.

(** ** Faces *)

Definition LiesOn (face : list Label) (s : Symbol) : bool :=
  let on l := existsb (SameLabel l) face in
  match s with Base l => on l | CutOf a b => on a && on b end.

Definition TriangleOn (face : list Label) (abc : Triangle) : bool :=
  let '(a, b, c) := abc in LiesOn face a && LiesOn face b && LiesOn face c.

Definition IsPlus (s : Sign) : bool :=
  match s with Plus => true | _ => false end.

Definition IsMinus (s : Sign) : bool :=
  match s with Minus => true | _ => false end.

Definition SomePlus (sign : Label -> Sign) (face : list Label) : bool :=
  existsb (fun l => IsPlus (sign l)) face.

Definition IsOnSurface (s : Sign) : bool :=
  match s with OnSurface => true | _ => false end.

Definition TriangleOnSurface (sign : Label -> Sign) (abc : Triangle) : bool :=
  let '(a, b, c) := abc in
  let surface s := IsOnSurface (SymbolSign sign s) in
  surface a && surface b && surface c.

(** ** Both sides of the shared face *)

(** Every triangle that [ts] have on the face, [us] have too. *)
Definition CheckIncluded (face : list Label) (ts us : list SymbolicTet) : bool :=
  forallb (fun t =>
    forallb (fun abc => negb (TriangleOn face abc) || SomeHas us abc)
      (Triangles t)) ts.

(** No tetrahedron has all its corners on the face. *)
Definition CheckReachesOff (face : list Label) (ts : list SymbolicTet) : bool :=
  forallb (fun t => negb (forallb (LiesOn face) (TetCorners t))) ts.

(** All corners of all tetrahedra combine the labels given. *)
Definition CheckStaysIn (labels : list Label) (ts : list SymbolicTet) : bool :=
  forallb (fun t => forallb (LiesOn labels) (TetCorners t)) ts.

(** A triangle on the face belongs to one tetrahedron. *)
Definition CheckOnce (face : list Label) (ts : list SymbolicTet) : bool :=
  forallb (fun t =>
    forallb (fun abc =>
      negb (TriangleOn face abc)
      || forallb (fun u => negb (Has u abc) || SameTet t u) ts)
      (Triangles t)) ts.

(** ** One structured tetrahedron *)

Definition Faces : list (list Label) :=
  [[F2; F3; P]; [F1; F3; P]; [F1; F2; P]; [F1; F2; F3]].

(** Every tetrahedron has a + corner, and none has a - corner. *)
Definition CheckInner (sign : Label -> Sign) (ts : list SymbolicTet) : bool :=
  forallb (fun t =>
    let signs := map (SymbolSign sign) (TetCorners t) in
    existsb IsPlus signs && forallb (fun s => negb (IsMinus s)) signs) ts.

(** A triangle that has an inner corner belongs to two tetrahedra, or lies on
    one of the four faces and that face has a + corner. *)
Definition CheckClosed (sign : Label -> Sign) (ts : list SymbolicTet) : bool :=
  forallb (fun t =>
    forallb (fun abc =>
      TriangleOnSurface sign abc
      || existsb (fun u => Has u abc && negb (SameTet t u)) ts
      || existsb (fun face => SomePlus sign face && TriangleOn face abc) Faces)
      (Triangles t)) ts.

(** ** For all signs, in all arrangements *)

Section Check.
  Variable T : StencilSet.

  Definition CheckSharedFace (arrangement : Arrangement) : bool :=
    match arrangement with Arrange a b c d a' b' c' d' =>
      ForAllSignAssignments (fun sign =>
        let face := [F1; F2; F3] in
        let ts := SymbolicTets T sign a b c d in
        let us := SymbolicTets T sign a' b' c' d' in
        negb (SomePlus sign face)
        || CheckIncluded face ts us && CheckIncluded face us ts)
    end.

  Definition CheckSharedFaces : bool := forallb CheckSharedFace Arrangements.

  Definition CheckInside : bool :=
    ForAllSignAssignments (fun sign =>
      let ts := SymbolicTets T sign F1 F2 F3 P in
      CheckInner sign ts && CheckClosed sign ts
      && CheckStaysIn [F1; F2; F3; P] ts
      && forallb (fun face => CheckReachesOff face ts && CheckOnce face ts)
           Faces).
End Check.
