(** * The paper's stencils are compatible

    Section 5.2 of the paper.  The checker looks at 6 arrangements, 243 sign
    assignments each, and every pair of edges. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Stencil.CompatibilityChecker Stencil.SymbolProof
  Stencil.CompatibilityCheckerProof.

Lemma CompatibilityOrders :
  forall Vertex GetSign GetIntersection f1 f2 f3 p q,
    let P := AllEdgesCompatible Vertex GetSign
               GetIntersection f1 f2 f3 p q in
    P p f1 f2 f3 q f1 f2 f3 /\
    P p f1 f2 f3 f1 q f3 f2 /\
    P f1 p f2 f3 q f1 f3 f2 /\
    P f1 p f2 f3 f1 q f2 f3 /\
    P f1 f2 p f3 f1 f2 q f3 /\
    P f1 f2 f3 p f1 f2 f3 q.
Proof.
  apply (CheckCompatibilitySound GetUnstructuredTets GetUnstructuredTetsNatural).
  vm_compute; reflexivity.
Qed.
