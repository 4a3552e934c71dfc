(** * Neighbours are mutual *)

From Coq Require Import ZArith.
From Certet Require Import Lattice.Coord3 Lattice.StructuredTet.
From Certet Require Import Lattice.NeighborSpec.
Open Scope Z_scope.

Lemma ThereAndBack (x y z a b c a' b' c' : Z) :
  a + a' = 0 -> b + b' = 0 -> c + c' = 0 ->
  Translate (Translate (C3 x y z) (C3 a b c)) (C3 a' b' c') = C3 x y z.
Proof.
  intros; cbn; rewrite <- !Z.add_assoc, H, H0, H1, !Z.add_0_r; reflexivity.
Qed.

(** Where [Order2143] puts the vertex of place [i]. *)
Definition Swapped (i : Place) : Place :=
  match i with
  | First => Second | Second => First | Third => Fourth | Fourth => Third
  end.

Theorem NeighborInvolution :
  forall (tid : StructuredTetId) (i : Place),
    let '(nei, order) := NeighborAcross (GetStructuredTet tid) i in
    exists (j : Place) (back_order : VertexOrder),
      VertexAt (GetStructuredTet nei) j
      = LinedUpVertexAt order (GetStructuredTet nei) i /\
      NeighborAcross (GetStructuredTet nei) j = (tid, back_order) /\
      Undoes back_order order /\ Undoes order back_order.
Proof.
  intros [[x y z] case] i.
  pose (same := i); pose (swapped := Swapped i).
  destruct case, i; cbv beta iota zeta delta [NeighborAcross GetStructuredTet].
  all: lazymatch goal with
  | |- context [LinedUpVertexAt Order1234] => exists same, Order1234
  | |- context [LinedUpVertexAt Order2143] => exists swapped, Order2143
  end.
  all: subst same swapped; split; [reflexivity |].
  all: split; [| split; intros a b c d; reflexivity].
  all: cbv beta iota zeta delta [NeighborAcross GetStructuredTet Swapped].
  all: f_equal; f_equal; now apply ThereAndBack.
Qed.
