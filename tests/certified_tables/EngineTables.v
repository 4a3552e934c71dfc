(** * Tables of the engine's names and numbers *)

From Coq Require Import ZArith String List Bool.
From Certet Require Import Certificate.
From CertetTables Require Import Table TableRules StencilTables.
Import ListNotations.
Open Scope Z_scope.

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
