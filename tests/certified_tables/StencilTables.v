(** * Tables of the structured tetrahedra and of the stencils *)

From Coq Require Import ZArith String List Bool.
From Certet Require Import Certificate.
From CertetTables Require Import Table TableRules.
Import ListNotations.
Open Scope Z_scope.

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
