(** * What warping can leave of one tetrahedron, enumerated

    The four corners of the case I1 stand for those of all twelve cases.  Each
    corner has a sign after warping, and each corner on the surface has moved
    along one of its fourteen edges (if it never moved, then by nothing).
    The output tetrahedra are those of any set of stencils, run on symbols; the
    product's is [GetUnstructuredTets]. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Forms.Checker.
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

Definition SymbolTets (stencils : StencilSet) (signs : Quad Sign)
  : list (UnstructuredTet Symbol) :=
  stencils Symbol (SymbolSign signs) SymbolIntersection
    (CornerOf V1) (CornerOf V2) (CornerOf V3) (CornerOf V4).

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

Definition AllConfigurations (stencils : StencilSet)
  : list (Quad Sign * Quad (option Direction)) :=
  flat_map (fun signs =>
    match SymbolTets stencils signs with
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

(** From one point to another, if they differ. *)
Definition SegmentBetween (p q : Coord3) : Segment :=
  if Coord3Equal p q then Fixed p else Sliding p q.

Definition SymbolSegment (r : Ranges) (moves : Quad (option Direction))
  (v : Symbol) : Segment :=
  match v with
  | CornerOf l =>
      let p := Of Canonical l in
      match Of moves l with
      | None => Fixed (Scale 256 p)
      | Some d =>
          SegmentBetween (Along p (Offset d) 0)
            (Along p (Offset d) (MoveLimit r (DirectionKind d)))
      end
  | CutOf a b =>
      let p := Of Canonical a in
      let e := Difference p (Of Canonical b) in
      SegmentBetween (Along p e (CutFrom r (LabelKind a b)))
        (Along p e (CutTo r (LabelKind a b)))
  end.

(** All that one sign pattern can become stays within bounds. *)
Definition CheckSigns (stencils : StencilSet) (bounds : AngleBounds)
  (r : Ranges) (signs : Quad Sign) : bool :=
  match SymbolTets stencils signs with
  | [] => true
  | tets =>
      forallb (fun moves =>
        forallb (fun t => CheckTet bounds (MapTet (SymbolSegment r moves) t))
          tets) (MovesFor signs)
  end.

(** ** Fewer configurations

    Half turns of the tetrahedron exchange its corners by twos and respect the
    stencils, so one sign pattern of each orbit needs to be checked. *)

Inductive Turn := Turn1234 | Turn2143 | Turn3412 | Turn4321.
Definition AllTurns : list Turn := [Turn1234; Turn2143; Turn3412; Turn4321].

Definition TurnLabel (g : Turn) (l : Label) : Label :=
  match g, l with
  | Turn1234, _ => l
  | Turn2143, V1 => V2 | Turn2143, V2 => V1
  | Turn2143, V3 => V4 | Turn2143, V4 => V3
  | Turn3412, V1 => V3 | Turn3412, V2 => V4
  | Turn3412, V3 => V1 | Turn3412, V4 => V2
  | Turn4321, V1 => V4 | Turn4321, V2 => V3
  | Turn4321, V3 => V2 | Turn4321, V4 => V1
  end.

Definition TurnQuad {T} (g : Turn) (q : Quad T) : Quad T :=
  Q4 (Of q (TurnLabel g V1)) (Of q (TurnLabel g V2))
    (Of q (TurnLabel g V3)) (Of q (TurnLabel g V4)).

Definition TurnSymbol (g : Turn) (v : Symbol) : Symbol :=
  match v with
  | CornerOf l => CornerOf (TurnLabel g l)
  | CutOf a b => CutOf (TurnLabel g a) (TurnLabel g b)
  end.

(** The rank of a sign pattern; an orbit's first is the one to check. *)
Definition Rank (signs : Quad Sign) : Z :=
  let digit s := match s with Plus => 0 | OnSurface => 1 | Minus => 2 end in
  match signs with
    Q4 a b c d => ((digit a * 3 + digit b) * 3 + digit c) * 3 + digit d
  end.

Definition FirstOfOrbit (signs : Quad Sign) : bool :=
  forallb (fun g => Rank signs <=? Rank (TurnQuad g signs)) AllTurns.

Definition Representatives : list (Quad Sign) := filter FirstOfOrbit AllSigns.

(** The dearest patterns are those of three surface corners; they are a job of
    their own. *)
Definition SurfaceCorners (signs : Quad Sign) : Z :=
  let one s := match s with OnSurface => 1 | _ => 0 end in
  match signs with Q4 a b c d => one a + one b + one c + one d end.

Definition CheckRepresentatives (stencils : StencilSet) (bounds : AngleBounds)
  (r : Ranges) (take : Z -> bool) : bool :=
  forallb (CheckSigns stencils bounds r)
    (filter (fun signs => take (SurfaceCorners signs)) Representatives).
