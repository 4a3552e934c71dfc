(** * The tables together write what the certified mesher gives *)

From Coq Require Import ZArith List Bool.
From Certet Require Import Certificate.
From CertetTables Require Import Table TableRules StencilTables EngineTables TablesSpec CppTables WrittenSpec.
Import ListNotations.
Open Scope Z_scope.

(** Every edge of the lattice, seen from either end, belongs to one family and
    one owner.  (All vertices are one of these two, moved by a vector between
    indices, and names move along.) *)
Theorem FamiliesNameEveryEdge :
  forall v d, In v Grids -> length (NamesOf v (Translate v (Offset d))) = 1%nat.
Proof. intros v d [<-|[<-|[]]]; destruct d; reflexivity. Qed.

(** Together the tables write what [StuffTet] gives: for each of the twelve cases
    and each of the 81 patterns the same tetrahedra, with the same vertices, in
    the same order. *)
Theorem CppWritesStuffTet :
  map (fun c => map (Written c) (Upto PatternCount)) (Upto (length AllCases)) =
  map (fun c => map (Stuffed c) (Upto PatternCount)) AllCases.
Proof.
  match goal with |- _ = ?stuffed => vm_cast_no_check (eq_refl stuffed) end.
Qed.

(** And the certified mesher was given that pattern: so it sees the corners. *)
Theorem StuffedSigns :
  forallb (fun c => forallb (fun pattern => forallb (fun n =>
      let sign v := PatternSign pattern (PlaceOf Coord3Equal v (CornersOf c)) in
      let v := nth (Z.to_nat n) (CornersOf c) Origin in
      SignNumber (MeshVertexSign NoWarpThresholds sign (fun _ _ => 0) (Corner v)) =?
      SignNumber (PatternSign pattern n))
    (Upto 4)) (Upto PatternCount)) AllCases = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
