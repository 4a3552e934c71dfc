(** * Tables of the stencils whose diagonals follow the cuts *)

From Coq Require Import ZArith String List Bool.
From Certet Require Import Certificate.
From Certet Require Import Lattice.EdgeRank Key.KeyTet Key.KeyStuffing.
From CertetTables Require Import Table TableRules StencilTables.
Import ListNotations.
Open Scope Z_scope.

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
