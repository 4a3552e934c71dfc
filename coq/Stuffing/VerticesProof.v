(** * What the vertices of the output are made of *)

From Certet Require Import Stuffing.Definitions.

Local Opaque WarpVertex.

(** Corners, and cuts from a + corner to a - corner. *)
Lemma StencilVertices (sign : MeshVertex -> Sign) v1 v2 v3 v4 t m :
  In t (GetUnstructuredTets MeshVertex sign MeshIntersection
          (Corner v1) (Corner v2) (Corner v3) (Corner v4)) ->
  In m (TetCorners t) ->
  (exists v, In v [v1; v2; v3; v4] /\ m = Corner v) \/
  (exists p q, In p [v1; v2; v3; v4] /\ In q [v1; v2; v3; v4] /\
     sign (Corner p) = Plus /\ sign (Corner q) = Minus /\ m = Cut p q).
Proof.
  unfold GetUnstructuredTets. intros I J.
  destruct (sign (Corner v1)) eqn:S1, (sign (Corner v2)) eqn:S2,
    (sign (Corner v3)) eqn:S3, (sign (Corner v4)) eqn:S4;
    cbn [In MeshIntersection] in I;
    repeat (destruct I as [<- | I]); try contradiction;
    cbn [In TetCorners] in J;
    repeat (destruct J as [<- | J]); try contradiction;
    (left; eexists; split; [|reflexivity]; cbn [In]; tauto) ||
    (right;
     refine (ex_intro _ _ (ex_intro _ _ (conj _ (conj _ (conj _ (conj _ eq_refl))))));
     first [assumption | cbn [In]; tauto]).
Qed.

(** What is not on the surface after warping has the sign that it had. *)
Lemma SignBefore th sign cut v s :
  MeshVertexSign th sign cut (Corner v) = s -> s <> OnSurface -> sign v = s.
Proof.
  cbn [MeshVertexSign]. destruct (WarpVertex th sign cut v); cbn [WarpedSign];
    congruence.
Qed.
