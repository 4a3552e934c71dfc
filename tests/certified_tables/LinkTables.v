(** * Tables of the link of a vertex *)

From Coq Require Import ZArith String List Bool.
From Certet Require Import Certificate.
From CertetTables Require Import Table TableRules StencilTables EngineTables.
Import ListNotations.
Open Scope Z_scope.

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
