(** * Tables of several materials *)

From Coq Require Import ZArith String List Bool.
From Certet Require Import Certificate.
From CertetTables Require Import Table TableRules StencilTables EngineTables.
Import ListNotations.
Open Scope Z_scope.

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
