(** * A defect in any entry is refused

    Every table with any one of its entries spoiled: none passes. *)

From Coq Require Import ZArith List String Bool.
From CertetTables Require Import Table TableRules StencilTables EngineTables TablesSpec CppTables CertifiedTables.
Import ListNotations.
Open Scope Z_scope.

Theorem EveryDefectRefused :
  forallb (fun '((_, table), (_, passes)) =>
      forallb (fun spoiled => negb (passes spoiled)) (Spoiled table)) Dumped = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

(** How many entries and how many defects that are. *)
Definition SumOf (f : Table -> Z) : Z :=
  fold_right (fun '(_, table) n => f table + n) 0 CppTables.

Eval vm_compute in
  (SumOf EntryCount, SumOf (fun t => Z.of_nat (List.length (Spoiled t)))).
