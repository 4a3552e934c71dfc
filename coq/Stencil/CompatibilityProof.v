(** * The paper's stencils are compatible

    Section 5.2 of the paper.  The checker looks at 6 arrangements, 243 sign
    assignments each, and every pair of edges. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Stencil.SymbolProof
  Stencil.CompatibilityCheckerProof.

Lemma CompatibilityOrders : CompatibleStencils GetUnstructuredTets.
Proof.
  apply (CheckCompatibilitySound GetUnstructuredTets GetUnstructuredTetsNatural).
  vm_compute; reflexivity.
Qed.
