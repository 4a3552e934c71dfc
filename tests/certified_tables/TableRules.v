(** * What tables are written and compared with *)

From Coq Require Import ZArith String List Bool.
From Certet Require Import Certificate.
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
