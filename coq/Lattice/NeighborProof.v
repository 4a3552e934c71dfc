(** * Neighbours are mutual: the lattice in the words of its own functions *)

From Certet Require Import Lattice.Definitions.
From Certet Require Import Lattice.Tiling Lattice.TilingProof.

Theorem NeighborInvolution :
  forall (tid : StructuredTetId) (i : Place),
    let '(nei, order) := NeighborAcross (GetStructuredTet tid) i in
    exists (j : Place) (back_order : VertexOrder),
      VertexAt (GetStructuredTet nei) j
      = LinedUpVertexAt order (GetStructuredTet nei) i /\
      NeighborAcross (GetStructuredTet nei) j = (tid, back_order) /\
      Undoes back_order order /\ Undoes order back_order.
Proof.
  intros tid i; pose proof (LatticeInvolution tid i) as mutual; revert mutual.
  unfold LinedUp; cbn [LatticeTiling Identifier VertexOf NeighborAt].
  destruct (NeighborAcross (GetStructuredTet tid) i) as [nei order].
  unfold LinedUpVertexAt; destruct (GetStructuredTet nei).
  exact (fun mutual => mutual).
Qed.
