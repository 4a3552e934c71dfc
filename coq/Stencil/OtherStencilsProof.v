(** * The checker tells good stencils from bad ones

    Each verdict is one line.  For the bad set the compatibility statement
    itself is shown to be false, so that the checker's no was no false alarm. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Stencil.OtherStencils Stencil.Symbol
  Stencil.CompatibilityChecker Stencil.SymbolProof
  Stencil.CompatibilityCheckerProof.

Lemma MirroredStencilsNatural : Natural MirroredStencils.
Proof.
  intros A B f SignA SignB IA IB v1 v2 v3 v4 corners SameSign SameIntersection.
  apply GetUnstructuredTetsNatural.
  - intros v corner; apply SameSign; cbn in *; tauto.
  - intros v w corner1 corner2; apply SameIntersection; cbn in *; tauto.
Qed.

Theorem MirroredStencilsCompatible : CompatibleStencils MirroredStencils.
Proof.
  apply (CheckCompatibilitySound MirroredStencils MirroredStencilsNatural).
  vm_compute; reflexivity.
Qed.

Theorem HoledStencilsRejected : CheckCompatibility HoledStencils = false.
Proof. vm_compute; reflexivity. Qed.

(** The two diagonals of a quadrilateral that [f1 f2] leaves in the face. *)
Lemma DiagonalsCross :
  ~ TwoEdgesCompatible Symbol SymbolIntersection
      (Base F1) (Base F2) (Base F3) (Base P) (Base Q)
      (Base F2) (CutOf F1 F3) (Base F1) (CutOf F2 F3).
Proof.
  intros compatible.
  repeat match goal with
  | H : TwoEdgesCompatible _ _ _ _ _ _ _ _ _ _ _ |- _ => destruct H
  | H : SpecialVertex _ _ _ _ _ |- _ => inversion H; clear H
  | H : NotIn _ _ _ _ _ _ _ _ _ _ |- _ => inversion H; clear H
  | H : PCoord _ _ _ _ _ _ _ |- _ => inversion H; clear H
  | H : QCoord _ _ _ _ _ _ _ |- _ => inversion H; clear H
  | H : FCoord _ _ _ _ _ _ _ _ _ |- _ => inversion H; subst; clear H
  | H : SSNI3D _ _ _ _ _ _ _ _ _ _ _ _ |- _ => destruct H
  | H : SSNI1D _ _ _ _ |- _ => destruct H
  | H : BelowSymm _ _ _ |- _ => destruct H
  | H : Below _ _ _ |- _ => inversion H; clear H
  | _ => discriminate
  end.
Qed.

(** With signs + + on the face's long edge and - at its third vertex, each side
    of the face has a diagonal of its own. *)
Theorem HoledStencilsIncompatible : ~ CompatibleStencils HoledStencils.
Proof.
  intros compatible.
  pose (sign := SymbolSign (SignOf Plus Plus Minus Plus OnSurface)).
  destruct (compatible Symbol sign SymbolIntersection
              (Base F1) (Base F2) (Base F3) (Base P) (Base Q))
    as (_ & _ & _ & _ & hole & _).
  specialize (hole
    (UT _ (Base F2) (CutOf F1 F3) (CutOf F2 F3) (CutOf P F3))
    (UT _ (Base F1) (CutOf F1 F3) (CutOf F2 F3) (Base Q))).
  rewrite Forall_forall in hole; apply DiagonalsCross.
  refine (hole _ _ (_, _, (_, _)) _); cbn; tauto.
Qed.
