(** * A constant of the C++ side

    Arrays and structures alike are rows of their parts, down to the entries:
    numbers (enumerators and truth values among them), numbers in floating point
    as [m 2^e], and names. *)

From Coq Require Import ZArith String List Bool.
Import ListNotations.
Open Scope Z_scope.

Inductive Table :=
| Number (n : Z)
| Double (m e : Z)
| Text (s : string)
| Row (parts : list Table).

Fixpoint Equal (a b : Table) : bool :=
  match a, b with
  | Number m, Number n => m =? n
  | Double m e, Double n f => (m =? n) && (e =? f)
  | Text s, Text t => String.eqb s t
  | Row l, Row k =>
      (fix EqualRows l k :=
         match l, k with
         | [], [] => true
         | x :: l', y :: k' => Equal x y && EqualRows l' k'
         | _, _ => false
         end) l k
  | _, _ => false
  end.

(** ** Defects *)

(** An entry a little wrong. *)
Definition SpoiledEntries (t : Table) : list Table :=
  match t with
  | Number n => [Number (n + 1); Number (n - 1); Number (- n - 1)]
  | Double m e => [Double (m + 1) e; Double (m - 1) e; Double m (e + 1)]
  | Text s => [Text (String.append s "'"); Text ""]
  | Row _ => []
  end.

(** Every table that differs from [t] in one entry, spoiled in these ways. *)
Fixpoint Spoiled (t : Table) : list Table :=
  match t with
  | Row parts =>
      map Row
        ((fix SpoiledRows parts :=
            match parts with
            | [] => []
            | x :: rest =>
                map (fun y => y :: rest) (Spoiled x) ++
                map (cons x) (SpoiledRows rest)
            end) parts)
  | entry => SpoiledEntries entry
  end.

Fixpoint EntryCount (t : Table) : Z :=
  match t with
  | Row parts => fold_right (fun x n => EntryCount x + n) 0 parts
  | _ => 1
  end.
