(** * What the tables say together

    A tetrahedron of the output as the engine writes it, read off its tables: the
    stencil of the pattern, its vertices in the order of output, each a vertex of
    the cell or the cut of an edge, which belongs to a family and an owner. *)

From Coq Require Import ZArith List.
From Certet Require Import Certificate.
From CertetTables Require Import Table TableRules StencilTables EngineTables TablesSpec CppTables.
Import ListNotations.
Open Scope Z_scope.

(** The part that a path of numbers leads to. *)
Definition At (path : list Z) (t : Table) : Table :=
  fold_left (fun t n => match t with Row l => nth (Z.to_nat n) l (Row []) | _ => Row [] end)
    path t.
Definition NumberAt (path : list Z) (t : Table) : Z :=
  match At path t with Number n => n | _ => -1 end.

(** The lattice points meant by a shift of the index and by a vertex. *)
Definition ShiftMeant (t : Table) : Coord3 :=
  Scale 2 (C3 (NumberAt [0] t) (NumberAt [1] t) (NumberAt [2] t)).
Definition VertexMeant (t : Table) : Coord3 :=
  let g := NumberAt [0] t in Translate (C3 g g g) (ShiftMeant (At [1] t)).

(** The ends of an edge as the corner sees it for whom it is named. *)
Definition EdgeMeant (e : Table) : Coord3 * Coord3 :=
  let family := At [NumberAt [0] e - NumberAt [] CppCoreCornerKinds] CppCoreFamilies in
  let owner := ShiftMeant (At [1] e) in
  let first := Translate owner (VertexMeant (At [0] family)) in
  let second := Translate owner (VertexMeant (At [1] family)) in
  if NumberAt [2] e =? 1 then (first, second) else (second, first).

(** Vertex [(a, b)] of a stencil, for the [c]-th case. *)
Definition WrittenVertex (c : Z) (v : Table) : MeshVertex :=
  let a := NumberAt [0] v in
  let b := NumberAt [1] v in
  if a =? b
  then Corner (VertexMeant (At [0; NumberAt [1; c; a] CppCoreCell] CppCoreCell))
  else let '(plus, minus) := EdgeMeant (At [2; c; a; b] CppCoreCell) in Cut plus minus.

Definition Written (c pattern : Z) : list (list MeshVertex) :=
  let stencil := At [pattern] CppStencilTable in
  map (fun t => map (fun n =>
      WrittenVertex c (At [1; t; NumberAt [c; n] CppCoreOutputOrders] stencil)) (Upto 4))
    (Upto (Z.to_nat (NumberAt [0] stencil))).

(** The same of the certified mesher, for corners with the signs of the pattern
    and no warping. *)
Definition Stuffed (c : StructuredTetCase) (pattern : Z) : list (list MeshVertex) :=
  let sign v := PatternSign pattern (PlaceOf Coord3Equal v (CornersOf c)) in
  map TetList (StuffTet NoWarpThresholds sign (fun _ _ => 0) (STId Origin c)).
