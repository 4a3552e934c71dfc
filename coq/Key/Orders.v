(** * The orders of a list, and the rank of a thing in one *)

From Coq Require Import ZArith List.
Import ListNotations.
Open Scope Z_scope.

Fixpoint Insertions {T} (x : T) (l : list T) : list (list T) :=
  match l with
  | [] => [[x]]
  | y :: r => (x :: l) :: map (cons y) (Insertions x r)
  end.

Fixpoint Orders {T} (l : list T) : list (list T) :=
  match l with
  | [] => [[]]
  | x :: r => flat_map (Insertions x) (Orders r)
  end.

(** How many come before; [same] tells things apart. *)
Fixpoint RankIn {T} (same : T -> T -> bool) (order : list T) (x : T) : Z :=
  match order with
  | [] => 0
  | y :: r => if same x y then 0 else 1 + RankIn same r x
  end.
