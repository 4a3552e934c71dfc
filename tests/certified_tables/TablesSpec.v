(** * What the tables of the C++ side must be

    Each is computed from the certified functions.  A table that says how the
    engine names or orders things, of which the certificate has no opinion, is
    given by the rule that it follows; [CertifiedTables.v] proves what the rule
    is good for. *)

From Coq Require Import ZArith String List Bool.
From Certet Require Import Certificate.
From Certet Require Import Lattice.EdgeRank Key.KeyTet Key.KeyStuffing.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet.
From CertetTables Require Import Table.
Import ListNotations.
Open Scope Z_scope.

Definition Numbers (l : list Z) : Table := Row (map Number l).
Definition Truth (b : bool) : Table := Number (if b then 1 else 0).
Definition Count {A : Type} (l : list A) : Table := Number (Z.of_nat (length l)).
Definition Upto (n : nat) : list Z := map Z.of_nat (seq 0 n).

(** The parts of a row pass, one for each element of a list. *)
Definition Each {A : Type} (passes : A -> Table -> bool) (l : list A) (t : Table) : bool :=
  match t with
  | Row parts => (length parts =? length l)%nat &&
                 forallb (fun '(a, part) => passes a part) (combine l parts)
  | _ => false
  end.

(** The place of the first [x] in a list, counted from 0. *)
Fixpoint PlaceOf {A : Type} (same : A -> A -> bool) (x : A) (l : list A) : Z :=
  match l with
  | [] => 0
  | y :: rest => if same x y then 0 else 1 + PlaceOf same x rest
  end.

(** Every element once, in the order in which they first come. *)
Definition FirstSeen (l : list Coord3) : list Coord3 :=
  fold_left (fun seen x => if existsb (Coord3Equal x) seen then seen else seen ++ [x])
    l [].

(** ** The structured tetrahedra *)

Definition Point (v : Coord3) : Table :=
  match v with C3 x y z => Numbers [x; y; z] end.

Definition CaseNumber (c : StructuredTetCase) : Z :=
  match c with
  | Tet_I1 => 0 | Tet_I2 => 1 | Tet_I3 => 2 | Tet_I4 => 3
  | Tet_J1 => 4 | Tet_J2 => 5 | Tet_J3 => 6 | Tet_J4 => 7
  | Tet_K1 => 8 | Tet_K2 => 9 | Tet_K3 => 10 | Tet_K4 => 11
  end.

(** A vertex order, as where each of four marks comes from. *)
Definition OrderMarks (o : VertexOrder) : list Z :=
  let mark n := C3 n 0 0 in
  let read c := match c with C3 n _ _ => n end in
  let '(a, b, c, d) := o (mark 0) (mark 1) (mark 2) (mark 3) in
  [read a; read b; read c; read d].

Definition Origin : Coord3 := C3 0 0 0.

Definition CornersOf (c : StructuredTetCase) : list Coord3 :=
  match GetStructuredTet (STId Origin c) with
    ST v1 v2 v3 v4 _ _ _ _ => [v1; v2; v3; v4]
  end.

Definition NeighborsOf (c : StructuredTetCase) : list (StructuredTetId * VertexOrder) :=
  match GetStructuredTet (STId Origin c) with
    ST _ _ _ _ n1 n2 n3 n4 => [n1; n2; n3; n4]
  end.

Definition NeighborEntry (n : StructuredTetId * VertexOrder) : Table :=
  let '(STId anchor c, order) := n in
  Row [Row [Point anchor; Number (CaseNumber c)]; Numbers (OrderMarks order)].

Definition IsRightHanded (c : StructuredTetCase) : bool :=
  match CaseHandedness c with RightHanded => true | LeftHanded => false end.

Definition StructuredTetTable : Table :=
  Row (map (fun c => Row [Row (map Point (CornersOf c));
                          Row (map NeighborEntry (NeighborsOf c));
                          Truth (IsRightHanded c)])
         AllCases).

(** ** Signs and stencils *)

Definition AllSigns : list Sign := [Minus; OnSurface; Plus].
Definition SignNumber (s : Sign) : Z :=
  match s with Minus => 0 | OnSurface => 1 | Plus => 2 end.

(** Pattern n has the sign of corner i in its i-th ternary digit: - 0 +. *)
Definition PatternSign (n i : Z) : Sign :=
  match (n / 3 ^ i) mod 3 with 0 => Minus | 1 => OnSurface | _ => Plus end.
Definition PatternCount : nat := Z.to_nat (3 ^ 4).
Definition PatternSigns : Table :=
  Row (map (fun n => Numbers (map (fun i => SignNumber (PatternSign n i)) (Upto 4)))
         (Upto PatternCount)).

(** Corner a is the pair (a, a), the cut from corner a to corner b is (a, b). *)
Definition StencilOf (n : Z) : list (list (Z * Z)) :=
  let corner i := (i, i) in
  let cut (a b : Z * Z) := (fst a, fst b) in
  map (fun t => match t with UT _ a b c d => [a; b; c; d] end)
      (GetUnstructuredTets (Z * Z) (fun v => PatternSign n (fst v)) cut
         (corner 0) (corner 1) (corner 2) (corner 3)).

(** A stencil has room for three tetrahedra. *)
Definition StencilEntry (tets : list (list (Z * Z))) : Table :=
  let unused := repeat (repeat (0, 0) 4) (3 - length tets) in
  Row [Count tets;
       Row (map (fun t => Row (map (fun v => Numbers [fst v; snd v]) t)) (tets ++ unused))].
Definition StencilTable : Table :=
  Row (map (fun n => StencilEntry (StencilOf n)) (Upto PatternCount)).

(** ** Stencils whose diagonals follow the cuts

    A pattern tells which pairs of its cuts are compared: the two cuts of every
    face that has two + corners and a - one and, where two corners are + and two
    -, those of either + corner.  The first of a pair is the one that comes first
    if both are as far from their + ends; bit [n] of an order says that the second
    cut of pair [n] is nearer. *)

Definition CornersWith (n : Z) (s : Sign) : list Z :=
  filter (fun i => SignNumber (PatternSign n i) =? SignNumber s) (Upto 4).

(** All pairs, those with an earlier second one first. *)
Definition PairsOf (l : list Z) : list (Z * Z) :=
  flat_map (fun q => flat_map (fun p => if p <? q then [(p, q)] else []) l) l.

(** As [EdgeRank] has it, in any structured tetrahedron. *)
Definition CutRank (cut : Z * Z) : Z :=
  let corner i := nth (Z.to_nat i) (CornersOf Tet_I1) Origin in
  EdgeRank (corner (fst cut)) (corner (snd cut)).

Definition CutPairs (n : Z) : list ((Z * Z) * (Z * Z)) :=
  let plus := CornersWith n Plus in
  let minus := CornersWith n Minus in
  let pair x y := if CutRank x <? CutRank y then (x, y) else (y, x) in
  flat_map (fun m => map (fun '(p, q) => pair (p, m) (q, m)) (PairsOf plus)) minus ++
  match plus, minus with
  | [p; q], [e; f] => [pair (p, e) (p, f); pair (q, e) (q, f)]
  | _, _ => []
  end.

(** How far cuts lie from their + ends: each at one of four places, which gives
    all orders of four cuts. *)
Fixpoint Placings (cuts : list (Z * Z)) : list (Z * Z -> Z) :=
  match cuts with
  | [] => [fun _ => 0]
  | (a, b) :: rest =>
      flat_map (fun t => map (fun at_ '(x, y) =>
        if (x =? a) && (y =? b) then t else at_ (x, y)) (Placings rest)) (Upto 4)
  end.

Definition OrderOf (pairs : list ((Z * Z) * (Z * Z))) (at_ : Z * Z -> Z) : Z :=
  fold_right (fun '(x, y) rest => (if at_ y <? at_ x then 1 else 0) + 2 * rest) 0 pairs.

(** The tetrahedra of pattern [n] with cuts in this order; of one that no cuts
    have, none. *)
Definition OrderedStencil (n order : Z) : list (list (Z * Z)) :=
  let corner i := (i, i) in
  let cut (a b : Z * Z) := (fst a, fst b) in
  let found at_ :=
    map (fun t => match t with UT _ a b c d => [a; b; c; d] end)
      (GetKeyTets (Z * Z) (fun v => PatternSign n (fst v)) cut
         (fun a b => 3 * at_ (cut a b) + CutRank (cut a b))
         (corner 0) (corner 1) (corner 2) (corner 3)) in
  match find (fun at_ => OrderOf (CutPairs n) at_ =? order)
             (Placings (list_prod (CornersWith n Plus) (CornersWith n Minus))) with
  | Some at_ => found at_
  | None => []
  end.

Definition SameStencil (s t : list (list (Z * Z))) : bool :=
  Equal (Row (map (fun tet => Row (map (fun '(a, b) => Numbers [a; b]) tet)) s))
        (Row (map (fun tet => Row (map (fun '(a, b) => Numbers [a; b]) tet)) t)).

(** Of each pattern its stencils by orders; *)
Definition OrderedStencils : list (list (list (list (Z * Z)))) :=
  map (fun n => map (OrderedStencil n) (Upto (2 ^ length (CutPairs n))))
    (Upto PatternCount).

(** all once, an empty one first; *)
Definition Distinct (stencils : list (list (list (Z * Z)))) :=
  fold_left (fun seen s =>
    if SameStencil s [] || existsb (SameStencil s) seen then seen else seen ++ [s])
    stencils [].

Definition KeyStencilTable : Table :=
  Row (map StencilEntry ([] :: flat_map Distinct OrderedStencils)).

(** and their numbers: of an order that no cuts have, that of the pattern's first. *)
Definition CutOrdersEntry (n first : Z) (stencils : list (list (list (Z * Z)))) : Table :=
  let own := Distinct stencils in
  let number s := match own, s with
                  | [], _ => 0
                  | _, [] => first
                  | _, _ => first + PlaceOf SameStencil s own
                  end in
  let pair '((a, b), (c, d)) := Row [Numbers [a; b]; Numbers [c; d]] in
  let pairs := CutPairs n in
  Row [Count pairs;
       Row (map pair (pairs ++ repeat ((0, 0), (0, 0)) (4 - length pairs)));
       Numbers (map number stencils ++ repeat 0 (16 - length stencils))].

Definition CutOrdersTable : Table :=
  Row (rev (fst (fold_left (fun '(rows, first) '(n, stencils) =>
    (CutOrdersEntry n first stencils :: rows,
     first + Z.of_nat (length (Distinct stencils))))
    (combine (Upto PatternCount) OrderedStencils) ([], 1)))).

(** ** Directions and thresholds *)

Definition IsLong (k : EdgeKind) : bool := match k with Long => true | Short => false end.
Definition OfDirections (f : Direction -> Table) : Table := Row (map f AllDirections).

Definition ThresholdsEntry (th : Thresholds) : Table :=
  match th with TH long short => Numbers [long; short] end.
Definition StepsEntry (th : Thresholds) : Table :=
  OfDirections (fun d => Number (ThresholdSteps th (DirectionKind d))).

(** ** The engine's names: a vertex is a grid and an index *)

Definition EvenVertex : Coord3 := Origin.
Definition OddVertex : Coord3 := C3 1 1 1.
Definition Grids : list Coord3 := [EvenVertex; OddVertex].

Definition Shift (v : Coord3) : Table :=
  match v with C3 x y z => Numbers [x / 2; y / 2; z / 2] end.
Definition VertexEntry (v : Coord3) : Table :=
  match v with C3 x _ _ => Row [Number (x mod 2); Shift v] end.

(** The families of edges that an index owns, in the order of the output: the
    long edges of the even vertex along x, y, z, those of the odd one, and the
    short edges from the odd vertex to the corners of its cell, x changing first.
    The first end is the owner's. *)
Definition Ahead : list Coord3 := map Offset [Dir_p00; Dir_0p0; Dir_00p].
Definition CellCorners : list Coord3 :=
  map (fun n => C3 (2 * (n mod 2)) (2 * (n / 2 mod 2)) (2 * (n / 4))) (Upto 8).
Definition Families : list (Coord3 * Coord3) :=
  map (fun a => (EvenVertex, Translate EvenVertex a)) Ahead ++
  map (fun a => (OddVertex, Translate OddVertex a)) Ahead ++
  map (fun c => (OddVertex, c)) CellCorners.
Definition Ends (f : Coord3 * Coord3) : list Coord3 := [fst f; snd f].

(** Numbers within a row: the corners of both grids, then the cuts. *)
Definition CornerKinds : Z := Z.of_nat (length Grids).

(** A family is an edge from [v] to [u], its index moved by [moved], if that is
    a vector between indices. *)
Record EdgeName := { family : Z; moved : Coord3; from_first : bool }.

Definition BetweenIndices (v : Coord3) : bool :=
  match v with C3 x y z => Z.even x && Z.even y && Z.even z end.

(** All names of the edge from [v] to [u]. *)
Definition NamesOf (v u : Coord3) : list EdgeName :=
  let named (n : Z) (a b : Coord3) (forward : bool) :=
    let t := Difference a v in
    if BetweenIndices t && Coord3Equal (Translate b t) u
    then [{| family := n; moved := t; from_first := forward |}] else [] in
  flat_map (fun '(n, (first, second)) => named n first second true ++
                                         named n second first false)
    (combine (Upto 14) Families).

Definition EdgeEntry (v u : Coord3) : Table :=
  match NamesOf v u with
  | e :: _ => Row [Number (CornerKinds + family e); Shift (moved e); Truth (from_first e)]
  | [] => Row [Number 0; Shift Origin; Truth false]
  end.

Definition EdgesOf : Table :=
  Row (map (fun v => OfDirections (fun d => EdgeEntry v (Translate v (Offset d)))) Grids).
Definition Neighbors : Table :=
  Row (map (fun v => OfDirections (fun d => VertexEntry (Translate v (Offset d)))) Grids).

(** The direction of an edge as each of its ends sees it. *)
Definition DirectionNumber (v u : Coord3) : Z :=
  PlaceOf Coord3Equal (Difference v u) (map Offset AllDirections).
Definition FamilyDirections : Table :=
  Row (map (fun '(a, b) => Numbers [DirectionNumber a b; DirectionNumber b a]) Families).

Definition EdgeEndsList : list Coord3 := FirstSeen (flat_map Ends Families).
Definition EdgeEnds : Table :=
  Row [Row (map VertexEntry EdgeEndsList);
       Row (map (fun f => Numbers (map (fun v => PlaceOf Coord3Equal v EdgeEndsList) (Ends f)))
              Families)].

(** The tiling as data: its vertices, tetrahedra, edges at a vertex, and edges of a
    cell. *)
Definition LatticeTilingTable : Table :=
  Row [Row (map Point Grids);
       StructuredTetTable;
       OfDirections (fun d => Point (Offset d));
       Row (map (fun f => Row (map Point (Ends f))) Families)].

(** ** The cell: the twelve tetrahedra of an index *)

Definition CellVertices : list Coord3 := FirstSeen (flat_map CornersOf AllCases).
Definition CellNumber (v : Coord3) : Z := PlaceOf Coord3Equal v CellVertices.

Definition CellTable : Table :=
  Row [Row (map VertexEntry CellVertices);
       Row (map (fun c => Numbers (map CellNumber (CornersOf c))) AllCases);
       Row (map (fun c => Row (map (fun a => Row (map (EdgeEntry a) (CornersOf c)))
                                 (CornersOf c))) AllCases)].

(** ** The order of output *)

Definition Mark (n : Z) : MeshVertex := Corner (C3 n 0 0).
Definition ReadMark (v : MeshVertex) : Z := match v with Corner (C3 n _ _) => n | Cut _ _ => -1 end.
Definition TetList {V : Type} (t : UnstructuredTet V) : list V :=
  match t with UT _ a b c d => [a; b; c; d] end.

Definition OutputOrder (c : StructuredTetCase) : list Z :=
  map ReadMark (TetList (Orient (CaseHandedness c)
    (UT _ (Mark 0) (Mark 1) (Mark 2) (Mark 3)))).

(** Where all is inside: what [StuffTet] gives, case by case. *)
Definition InteriorVertices : list Z :=
  let inside (_ : Coord3) := Plus in
  let number v := match v with Corner c => CellNumber c | Cut _ _ => -1 end in
  flat_map (fun c => map number (flat_map TetList
      (StuffTet NoWarpThresholds inside (fun _ _ => 0) (STId Origin c))))
    AllCases.

(** ** Limits *)

(** The most cells of a lattice centred around 0 that pass the door. *)
Definition PassesDoor (cells : Z) : bool :=
  Z.even cells && (- AnchorLimit <=? - cells) &&
  (Value (DoorFormula (- cells) cells) <=? AnchorLimit).
Definition IsCellsLimit (t : Table) : bool :=
  match t with
  | Number n => PassesDoor n && negb (PassesDoor (n + 2))
  | _ => false
  end.

(** The parts of an edge that thresholds are counted in. *)
Definition IsDenominator (t : Table) : bool :=
  match t with
  | Number n => (ThresholdSteps (TH n n) Long =? Steps) &&
                (ThresholdSteps (TH n n) Short =? Steps)
  | _ => false
  end.

(** ** Faces as seen from outside

    The face across from each corner, by the numbers of its corners: any three
    that, seen from the fourth, turn the other way than in a tetrahedron of
    positive volume. *)

Definition UnitTet : list Coord3 := [C3 0 0 0; C3 1 0 0; C3 0 1 0; C3 0 0 1].
Definition IsOutward (across : Z) (face : Table) : bool :=
  let at_ n := nth (Z.to_nat n) UnitTet Origin in
  let is_corner n := (0 <=? n) && (n <? 4) in
  match face with
  | Row [Number a; Number b; Number c] =>
      is_corner a && is_corner b && is_corner c &&
      (SixVolume (at_ a) (at_ b) (at_ c) (at_ across) =? -1)
  | _ => false
  end.
Definition AreOutwardFaces (t : Table) : bool :=
  Each IsOutward (Upto 4) t.

(** ** The methods, and the bounds that every mesh is held to

    What a method is, where it warps and what it promises, in hundredths of degrees,
    is told by [Mesh/Method.v].  The engine has besides a name for it, a number for
    where it cuts edges and whether some violated vertices stay, and names the
    theorem on its angles. *)

Inductive Cuts := OnTheSurface | InTheMiddle.
Definition CutsNumber (c : Cuts) : Z := match c with OnTheSurface => 0 | InTheMiddle => 1 end.

Definition MethodCuts (m : Method) : Cuts :=
  match m with MidpointMethod => InTheMiddle | _ => OnTheSurface end.

Definition MethodSettles (m : Method) : bool :=
  match m with SettledMethod _ => true | _ => false end.

Record NamedMethod := {
  called : string; cuts : Cuts; alpha : Thresholds; settles : bool;
  follows_cuts : bool;  (** whether diagonals end at the lesser cut *)
  least : Z; greatest : Z; theorem : string
}.

Definition Named (name : string) (m : Method) (theorem_ : string) : NamedMethod :=
  {| called := name; cuts := MethodCuts m; alpha := MethodThresholds m;
     settles := MethodSettles m; follows_cuts := false;
     least := LeastAngle m; greatest := GreatestAngle m; theorem := theorem_ |}.

(** Whose turns come when makes no difference to what is told here. *)
Definition Methods : list NamedMethod :=
  [Named "embedded" (SettledMethod []) "SettledBoundsInDegrees";
   Named "angles" AngleMethod "DihedralBounds";
   Named "embedding" EmbeddingMethod "DihedralBoundsEmbedding";
   Named "midpoint" MidpointMethod "MidpointBounds";
   {| called := "key"; cuts := OnTheSurface; alpha := KeyThresholds; settles := true;
      follows_cuts := true; least := 1118; greatest := 15713;
      theorem := "CertifiedKeySweptMesh" |}]%string.

(** The number of 53 bits, written in full, that is nearest to so many hundredths. *)
Definition IsNearest (hundredths : Z) (t : Table) : bool :=
  match t with
  | Double m e =>
      (2 ^ 52 <=? m) && (m <? 2 ^ 53) && (e <=? 0) &&
      (2 * Z.abs (100 * m - hundredths * 2 ^ (- e)) <=? 100)
  | _ => false
  end.
(** A row has its number first, and what it promises last. *)
Definition IsMethod (numbered : Z * NamedMethod) (t : Table) : bool :=
  let (number, named) := numbered in
  match t with
  | Row [row; name; where_; within; rule; diagonals; Row [low; high; promise]] =>
      Equal (Number number) row && Equal (Text (called named)) name &&
      Equal (Number (CutsNumber (cuts named))) where_ &&
      Equal (ThresholdsEntry (alpha named)) within &&
      Equal (Truth (settles named)) rule &&
      Equal (Truth (follows_cuts named)) diagonals &&
      IsNearest (least named) low && IsNearest (greatest named) high &&
      Equal (Text (theorem named)) promise
  | _ => false
  end.
Definition AreMethods : Table -> bool :=
  Each IsMethod (combine (Upto (length Methods)) Methods).

(** ** Links

    A set of directions is a number, with a bit for each. *)

Definition SetNumber (set : Link bool) : Z :=
  fold_right (fun d n => (if At set d then 1 else 0) + 2 * n) 0 AllDirections.

Definition LinkRings : Table :=
  OfDirections (fun d => Number (SetNumber (Gather (NextInLink d)))).

Definition PlaceInLink : Link Z :=
  Gather (fun d => PlaceOf SameDirection d AllDirections).

Definition NumberedSet (n : Z) : Link bool :=
  Gather (fun d => Z.testbit n (At PlaceInLink d)).

(** Sixty-four sets in a number. *)
Definition ConnectedSets : Table :=
  Numbers (map (fun word =>
    fold_right (fun bit n =>
      (if InOnePiece (NumberedSet (64 * word + bit)) then 1 else 0) + 2 * n)
      0 (Upto 64)) (Upto 256)).

(** The triangles of the link, each from its lowest number on, that with the vertex
    make a right-handed tetrahedron; *)
Definition DirectionAt (n : Z) : Direction := nth (Z.to_nat n) AllDirections Dir_p00.
Definition Next (d e : Z) : bool := NextInLink (DirectionAt d) (DirectionAt e).

Definition LinkTriangles : Table :=
  let at_ n := Offset (DirectionAt n) in
  Row (flat_map (fun d => flat_map (fun e => flat_map (fun f =>
    if (d <? e) && (d <? f) && Next d e && Next e f && Next d f &&
       (0 <? SixVolume Origin (at_ d) (at_ e) (at_ f))
    then [Numbers [d; e; f]] else []) (Upto 14)) (Upto 14)) (Upto 14)).

(** its long edges, and who is next to both ends of each. *)
Definition LongLinkEdges : Table :=
  let short n := negb (IsLong (DirectionKind (DirectionAt n))) in
  Row (flat_map (fun d => flat_map (fun e =>
    if (d <? e) && Next d e && short d && short e
    then [Row [Numbers [d; e]; Numbers (filter (fun f => Next d f && Next e f) (Upto 14))]]
    else []) (Upto 14)) (Upto 14)).

(** ** Several materials

    A corner has a material, or has moved.  What counts is which corners have moved and
    which are alike; a cut is named by its ends, the lower number first. *)

Definition MovedCorner : Z := -1.
Definition CornerMaterial (corners : list Z) (i : Z) : Z := nth (Z.to_nat i) corners 0.
Definition Labelling (n : Z) : list Z := map (fun i => (n / 5 ^ i) mod 5 - 1) (Upto 4).

Definition CornerPairs : list (Z * Z) := [(0, 1); (0, 2); (0, 3); (1, 2); (1, 3); (2, 3)].
Definition Likeness (corners : list Z) : Z :=
  let bits := map (Z.eqb MovedCorner) corners ++
    map (fun '(a, b) => CornerMaterial corners a =? CornerMaterial corners b) CornerPairs in
  fold_right (fun (bit : bool) n => (if bit then 1 else 0) + 2 * n) 0 bits.
Definition LikenessCount : nat := Z.to_nat (2 ^ 10).

Definition MaterialPatternList : list (list Z) :=
  fold_left (fun seen l =>
      if existsb (fun k => Likeness k =? Likeness l) seen then seen else seen ++ [l])
    (map Labelling (Upto 625)) [].

Definition PatternOfLikeness : Table :=
  let known := map Likeness MaterialPatternList in
  Numbers (map (fun code => PlaceOf Z.eqb code known) (Upto LikenessCount)).

(** No corner is of the material that a tetrahedron has all of whose corners moved: its
    owner is the number after theirs. *)
Definition MaterialStencilOf (corners : list Z) : list (Z * list (Z * Z)) :=
  let corner i := (i, i) in
  let material (v : Z * Z) :=
    let m := CornerMaterial corners (fst v) in if m =? MovedCorner then None else Some m in
  let cut (a b : Z * Z) := (Z.min (fst a) (fst b), Z.max (fst a) (fst b)) in
  map (fun '(m, t) => (PlaceOf Z.eqb m corners, TetList t))
    (GetMaterialTets (Z * Z) material cut (corner 0) (corner 1) (corner 2) (corner 3) 1000).

(** A stencil has room for eight tetrahedra. *)
Definition MaterialStencilEntry (corners : list Z) : Table :=
  let entry owner tet :=
    Row [Row (map (fun v => Numbers [fst v; snd v]) tet); Number owner] in
  let tets := map (fun '(owner, t) => entry owner t) (MaterialStencilOf corners) in
  Row [Count tets; Row (tets ++ repeat (entry 0 (repeat (0, 0) 4)) (8 - length tets))].

Definition CotangentEntry (c : CotSquared) : Table :=
  match c with CotSq num den => Numbers [num; den] end.
Definition LeastAndGreatest : Table * Table :=
  match WidestAngles with AB least greatest => (CotangentEntry least, CotangentEntry greatest) end.

(** ** Graded interiors

    A flag by its axes and sides, and the tetrahedra that flags name, from the
    centre of the flag's cell, in half sides. *)

Definition GradedKinds : list GradedKind :=
  [BccTet; EdgeHalfTet; FaceHalfTet; QuarterTet; PyramidTet].
Definition AxisOrders : list AxisOrder := [XYZ; XZY; YXZ; YZX; ZXY; ZYX].

(** Of each order three sides, that of the face changing first. *)
Definition FlagsOfCell : list Flag :=
  flat_map (fun o => map (fun n => MakeFlag 0 Origin o (Z.odd n) (Z.odd (n / 2)) (Z.odd (n / 4)))
                       (Upto 8))
    AxisOrders.

(** Along which axes lie the face, the edge's place in it, and the edge. *)
Definition AxesOf (o : AxisOrder) : list Z :=
  let '(C3 x y z) := Arrange o 0 1 2 in
  map (fun n => PlaceOf Z.eqb n [x; y; z]) (Upto 3).

Definition FlagEntry (x : Flag) : Table :=
  let '(MakeFlag _ _ o s t u) := x in
  Row [Numbers (AxesOf o); Row (map Truth [s; t; u])].

Definition GradedTetEntry (kind : GradedKind) (x : Flag) : Table :=
  let from_centre v := Translate v (Scale (-1) (PointSeen x 0 0 0)) in
  let '(UT _ a b c d) := GetGradedTet (GTId kind x) in
  Row (map (fun v => Point (from_centre v)) [a; b; c; d]).

Definition IsSameFlag (x y : Flag) : bool :=
  match x, y with
    MakeFlag _ c _ s t u, MakeFlag _ d _ s' t' u' =>
      Coord3Equal c d && Bool.eqb s s' && Bool.eqb t t' && Bool.eqb u u'
  end.

(** Whether a flag is the name of its tetrahedron. *)
Definition IsName (kind : GradedKind) (x : Flag) : bool := IsSameFlag (NamingFlag kind x) x.

Definition OfFlags (entry : GradedKind -> Flag -> Table) (kinds : list GradedKind) : Table :=
  Row (map (fun kind => Row (map (entry kind) FlagsOfCell)) kinds).

(** ** All of them *)

(** What makes a table right: that it is this one, or that it passes a test. *)
Definition Is (certified : Table) : Table -> bool := Equal certified.

Definition Expected : list (string * (Table -> bool)) :=
  [("case_count", Is (Count AllCases));
   ("order_1234", Is (Numbers (OrderMarks Order1234)));
   ("order_2143", Is (Numbers (OrderMarks Order2143)));
   ("structured_tet_table", Is StructuredTetTable);
   ("direction_count", Is (Count AllDirections));
   ("direction_offset", Is (OfDirections (fun d => Point (Offset d))));
   ("lattice_tiling", Is LatticeTilingTable);
   ("pattern_count", Is (Number (Z.of_nat PatternCount)));
   ("stencil_table", Is StencilTable);
   ("cut_order_count", Is (Number 16));
   ("key_stencil_count", Is (Number 128));
   ("cut_orders", Is CutOrdersTable);
   ("key_stencil_table", Is KeyStencilTable);
   ("moved_corner", Is (Number MovedCorner));
   ("shared_owner", Is (Number 4));
   ("likeness_count", Is (Number (Z.of_nat LikenessCount)));
   ("material_pattern_count", Is (Count MaterialPatternList));
   ("material_patterns", Is (Row (map Numbers MaterialPatternList)));
   ("pattern_of_likeness", Is PatternOfLikeness);
   ("material_stencil_table", Is (Row (map MaterialStencilEntry MaterialPatternList)));
   ("least_angle", Is (fst LeastAndGreatest));
   ("greatest_angle", Is (snd LeastAndGreatest));
   ("step_bits", Is (Number (Z.of_nat StepBits)));
   ("steps", Is (Number Steps));
   ("core::midpoint_cut", Is (Number MidpointCut));
   ("threshold_denominator", IsDenominator);
   ("angle_thresholds", Is (ThresholdsEntry AngleThresholds));
   ("embedding_thresholds", Is (ThresholdsEntry EmbeddingThresholds));
   ("no_warp_thresholds", Is (ThresholdsEntry NoWarpThresholds));
   ("key_thresholds", Is (ThresholdsEntry KeyThresholds));
   ("methods", AreMethods);
   ("core::whole_link", Is (Number (SetNumber (Gather (fun _ => true)))));
   ("core::link_ring", Is LinkRings);
   ("core::link_triangles", Is LinkTriangles);
   ("core::long_link_edges", Is LongLinkEdges);
   ("core::connected_sets", Is ConnectedSets);
   ("core::grid_count", Is (Count Grids));
   ("core::grids", Is (Numbers (Upto (length Grids))));
   ("core::corner_kinds", Is (Number CornerKinds));
   ("core::family_count", Is (Count Families));
   ("core::kind_count", Is (Number (CornerKinds + Z.of_nat (length Families))));
   ("core::families", Is (Row (map (fun f => Row (map VertexEntry (Ends f))) Families)));
   ("core::edges_of", Is EdgesOf);
   ("core::family_directions", Is FamilyDirections);
   ("core::edge_end_count", Is (Count EdgeEndsList));
   ("core::edge_ends", Is EdgeEnds);
   ("core::cell_tet_count", Is (Count AllCases));
   ("core::cell_vertex_count", Is (Count CellVertices));
   ("core::cell", Is CellTable);
   ("core::output_orders", Is (Row (map (fun c => Numbers (OutputOrder c)) AllCases)));
   ("core::interior_size", Is (Count InteriorVertices));
   ("core::interior_vertices", Is (Numbers InteriorVertices));
   ("core::graded_kinds", Is (Numbers (Upto (length GradedKinds))));
   ("core::flag_count", Is (Count FlagsOfCell));
   ("core::flags", Is (Row (map FlagEntry FlagsOfCell)));
   ("core::graded_tets", Is (OfFlags GradedTetEntry GradedKinds));
   ("coordinate_limit", Is (Number LatticeLimit));
   ("anchor_limit", Is (Number AnchorLimit));
   ("cells_limit", IsCellsLimit);
   ("core::edge_limit", Is (Number WidthLimit));
   ("core::outward_faces", AreOutwardFaces);
   ("signs", Is (Numbers (map SignNumber AllSigns)));
   ("sign_of_bits", Is (Numbers (map SignNumber AllSigns)));
   ("opposite", Is (Row (map (fun a => Row (map (fun b => Truth (Opposite a b)) AllSigns))
                           AllSigns)));
   ("pattern_signs", Is PatternSigns);
   ("pattern_index", Is (Numbers (Upto PatternCount)));
   ("cases", Is (Numbers (map CaseNumber AllCases)));
   ("right_handed", Is (Row (map (fun c => Truth (IsRightHanded c)) AllCases)));
   ("is_long", Is (OfDirections (fun d => Truth (IsLong (DirectionKind d)))));
   ("length_squared", Is (OfDirections (fun d => Number (LengthSquared (DirectionKind d)))));
   ("thresholds_in_steps",
      Is (Row (map StepsEntry [AngleThresholds; EmbeddingThresholds; NoWarpThresholds;
                               KeyThresholds])));
   ("core::names_tet",
      Is (OfFlags (fun kind x => Truth (IsName kind x)) (removelast GradedKinds)));
   ("core::neighbor", Is Neighbors)]%string.
