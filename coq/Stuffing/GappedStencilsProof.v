(** * What compatible edges do not tell: proofs *)

From Certet Require Import Stuffing.Definitions.
From Certet Require Import Stencil.OtherStencils Stencil.TriangleChecker
  Stencil.CompatibilityProof.
Open Scope Z_scope.

Theorem OverlapCompatible :
  forall Vertex GetIntersection (f1 f2 f3 p q : Vertex),
    TwoEdgesCompatible Vertex GetIntersection f1 f2 f3 p q
      f1 (GetIntersection f1 f2) f1 f2.
Proof.
  intros. apply EC_3.
  - apply SV_1. reflexivity.
  - eapply NI_4; [apply FC_1 | apply FC_4 | apply FC_2 |].
    apply SPNI3D_2, SPNI1D_2, AS_1, A_1.
Qed.

Theorem FewerStencilsCompatible :
  forall T T' : StencilSet,
    CompatibleStencils T ->
    (forall Vertex GetSign GetIntersection v1 v2 v3 v4 t,
       In t (T' Vertex GetSign GetIntersection v1 v2 v3 v4) ->
       In t (T Vertex GetSign GetIntersection v1 v2 v3 v4)) ->
    CompatibleStencils T'.
Proof.
  intros T T' compatible fewer Vertex GetSign GetIntersection f1 f2 f3 p q.
  destruct (compatible Vertex GetSign GetIntersection f1 f2 f3 p q)
    as (C1 & C2 & C3 & C4 & C5 & C6).
  repeat split; intros t1 t2 I1 I2; apply fewer in I1, I2; auto.
Qed.

Theorem GappedStencilsCompatible : CompatibleStencils GappedStencils.
Proof.
  apply (FewerStencilsCompatible GetUnstructuredTets GappedStencils CompatibilityOrders).
  intros Vertex GetSign GetIntersection v1 v2 v3 v4 t.
  unfold GappedStencils.
  destruct (GetSign v1) eqn:S1, (GetSign v2) eqn:S2, (GetSign v3) eqn:S3,
    (GetSign v4) eqn:S4; try trivial.
  unfold GetUnstructuredTets. rewrite S1, S2, S3, S4. intros I. right. exact I.
Qed.

(** Two tetrahedra of the lattice, with signs + + + on their face, - on one
    side and + on the other. *)
Theorem GappedStencilsLeaveHole :
  exists (GetSign : MeshVertex -> Sign) (f1 f2 f3 p q : MeshVertex),
    let T := GappedStencils MeshVertex GetSign MeshIntersection in
    GetSign f1 = Plus /\ GetSign f2 = Plus /\ GetSign f3 = Plus /\
    AmongTriangles (T f1 f2 f3 q) f1 f2 f3 /\
    ~ AmongTriangles (T f1 f2 f3 p) f1 f2 f3.
Proof.
  exists (fun v => match v with
                   | Corner (C3 1 3 3) => Minus | Corner _ => Plus | _ => OnSurface
                   end),
    (Corner (C3 0 2 2)), (Corner (C3 2 2 2)), (Corner (C3 1 3 1)),
    (Corner (C3 1 3 3)), (Corner (C3 1 1 1)).
  cbn. repeat (split; [reflexivity|]). split.
  - eexists. split; [left; reflexivity|]. unfold HasTriangle. cbn.
    repeat split; (tauto || discriminate).
  - intros (t & I & (A & B & C) & _).
    repeat destruct I as [<- | I]; try contradiction I; cbn in A, B, C;
      repeat match goal with
      | H : _ \/ _ |- _ => destruct H as [H | H]; try discriminate H
      end; contradiction.
Qed.

Theorem GappedStencilsRejected : CheckSharedFaces GappedStencils = false.
Proof. vm_compute. reflexivity. Qed.
