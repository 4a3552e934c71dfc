(** * What warping can leave of one tetrahedron, enumerated

    The four corners of the case I1 stand for those of all twelve cases.  Each
    corner has a sign after warping, and each corner on the surface has moved
    along one of its fourteen edges (if it never moved, then by nothing).
    The output tetrahedra are [GetUnstructuredTets]' own, run on symbols. *)

From Coq Require Import ZArith List Bool.
From Certet Require Import Lattice.Coord3 Lattice.Direction.
From Certet Require Import Lattice.StructuredTet Stencil.UnstructuredTet.
From Certet Require Import Warp.Cut Warp.Warp.
From Certet Require Import Angles.Geometry Angles.Checker.
Import ListNotations.
Open Scope Z_scope.

(** ** Symbols *)

(** The four corners, and four things of one kind, one for each. *)
Inductive Label := V1 | V2 | V3 | V4.
Definition AllLabels : list Label := [V1; V2; V3; V4].

Inductive Quad (T : Type) := Q4 : T -> T -> T -> T -> Quad T.
Arguments Q4 {T}.

Definition Of {T} (q : Quad T) (l : Label) : T :=
  match q, l with
  | Q4 a _ _ _, V1 => a | Q4 _ b _ _, V2 => b
  | Q4 _ _ c _, V3 => c | Q4 _ _ _ d, V4 => d
  end.

Definition LabelEqual (a b : Label) : bool :=
  match a, b with
  | V1, V1 | V2, V2 | V3, V3 | V4, V4 => true
  | _, _ => false
  end.

(** A corner, or the cut of the edge from one corner to another. *)
Inductive Symbol :=
| CornerOf : Label -> Symbol
| CutOf : Label -> Label -> Symbol.

Definition SymbolSign (signs : Quad Sign) (v : Symbol) : Sign :=
  match v with CornerOf l => Of signs l | CutOf _ _ => OnSurface end.

Definition SymbolIntersection (a b : Symbol) : Symbol :=
  match a, b with CornerOf p, CornerOf m => CutOf p m | _, _ => a end.

Definition SymbolTets (signs : Quad Sign) : list (UnstructuredTet Symbol) :=
  GetUnstructuredTets Symbol (SymbolSign signs) SymbolIntersection
    (CornerOf V1) (CornerOf V2) (CornerOf V3) (CornerOf V4).

Definition MapTet {A B} (f : A -> B) (t : UnstructuredTet A)
  : UnstructuredTet B :=
  match t with UT _ a b c d => UT _ (f a) (f b) (f c) (f d) end.

(** ** Configurations *)

(** The corners of case I1 at the reference point 0. *)
Definition Canonical : Quad Coord3 :=
  Q4 (C3 0 2 2) (C3 2 2 2) (C3 1 3 1) (C3 1 3 3).

(** Edges 12 and 34 are long. *)
Definition LabelKind (a b : Label) : EdgeKind :=
  match a, b with
  | V1, V2 | V2, V1 | V3, V4 | V4, V3 => Long
  | _, _ => Short
  end.

Definition Product4 {T} (a b c d : list T) : list (Quad T) :=
  flat_map (fun w => flat_map (fun x => flat_map (fun y =>
    map (fun z => Q4 w x y z) d) c) b) a.

Definition AllSigns : list (Quad Sign) :=
  let s := [Plus; OnSurface; Minus] in Product4 s s s s.

(** The corner, if any, towards which a corner has moved. *)
Definition Targets (from to : Label) (move : option Direction) : bool :=
  match move with
  | None => false
  | Some d =>
      Coord3Equal (Translate (Of Canonical from) (Offset d)) (Of Canonical to)
  end.

(** With these signs [before] warping: who kept its place kept its sign, who
    moved towards a corner moved towards one of opposite sign, and no two
    corners moved along one edge. *)
Definition ConsistentWith (signs : Quad Sign) (moves : Quad (option Direction))
  (before : Quad Sign) : bool :=
  forallb (fun i => forallb (fun j =>
    if Targets i j (Of moves i)
    then if Opposite (Of before i) (Of before j)
         then negb (Targets j i (Of moves j)) else false
    else true) AllLabels) AllLabels.

Definition SignsBefore (s : Sign) : list Sign :=
  match s with OnSurface => [Plus; Minus; OnSurface] | _ => [s] end.

Definition Consistent (signs : Quad Sign) (moves : Quad (option Direction))
  : bool :=
  existsb (ConsistentWith signs moves)
    match signs with
      Q4 a b c d =>
        Product4 (SignsBefore a) (SignsBefore b) (SignsBefore c) (SignsBefore d)
    end.

Definition MovesOf (s : Sign) : list (option Direction) :=
  match s with OnSurface => map Some AllDirections | _ => [None] end.

Definition MovesFor (signs : Quad Sign) : list (Quad (option Direction)) :=
  match signs with
    Q4 a b c d =>
      filter (Consistent signs)
        (Product4 (MovesOf a) (MovesOf b) (MovesOf c) (MovesOf d))
  end.

Definition AllConfigurations : list (Quad Sign * Quad (option Direction)) :=
  flat_map (fun signs =>
    match SymbolTets signs with
    | [] => []
    | _ => map (pair signs) (MovesFor signs)
    end) AllSigns.

(** ** Where the vertices can be *)

(** All in 256ths: how far a corner moves, and where cuts remain. *)
Record Ranges := {
  MoveLimit : EdgeKind -> Z;
  CutFrom : EdgeKind -> Z;
  CutTo : EdgeKind -> Z
}.

Definition Alpha (th : Thresholds) (k : EdgeKind) : Z :=
  match th, k with TH long _, Long => long | TH _ short, Short => short end.

Definition RangesOf (th : Thresholds) : Ranges := {|
  MoveLimit := Alpha th;
  CutFrom := Alpha th;
  CutTo := fun k => 256 - Alpha th k
|}.

(** What [t] 256ths of the edge from [p] along [e] amount to. *)
Definition Along (p e : Coord3) (t : Z) : Coord3 :=
  Translate (Scale 256 p) (Scale t e).

Definition SymbolSegment (r : Ranges) (moves : Quad (option Direction))
  (v : Symbol) : Segment :=
  match v with
  | CornerOf l =>
      let p := Of Canonical l in
      match Of moves l with
      | None => Fixed (Scale 256 p)
      | Some d =>
          Sliding (Scale 256 p)
            (Along p (Offset d) (MoveLimit r (DirectionKind d)))
      end
  | CutOf a b =>
      let p := Of Canonical a in
      let e := Difference p (Of Canonical b) in
      Sliding (Along p e (CutFrom r (LabelKind a b)))
        (Along p e (CutTo r (LabelKind a b)))
  end.

(** All that one sign pattern can become stays within bounds. *)
Definition CheckSigns (bounds : AngleBounds) (r : Ranges) (signs : Quad Sign)
  : bool :=
  let tets := SymbolTets signs in
  forallb (fun moves =>
    forallb (fun t => CheckTet bounds (MapTet (SymbolSegment r moves) t)) tets)
    (MovesFor signs).
