(** * Sets of stencils, of which the paper's is one

    A stencil set may be any function of the type of [GetUnstructuredTets].
    What the paper states about its own stencils is stated here about any set,
    so that another one is certified by the same checker.  A set is natural
    if it looks at its vertices through their signs alone; every table of sign
    patterns is. *)

From Coq Require Import List.
From Certet Require Import Stencil.UnstructuredTet Stencil.CompatibilitySpec.
Import ListNotations.

Definition StencilSet : Type :=
  forall Vertex : Type,
    (Vertex -> Sign) -> (Vertex -> Vertex -> Vertex) ->
    Vertex -> Vertex -> Vertex -> Vertex -> list (UnstructuredTet Vertex).

Definition MapTet {A B : Type} (f : A -> B) (t : UnstructuredTet A)
  : UnstructuredTet B :=
  match t with UT _ a b c d => UT B (f a) (f b) (f c) (f d) end.

(** To rename the vertices and to apply the stencil, in either order. *)
Definition Natural (T : StencilSet) : Prop :=
  forall (A B : Type) (f : A -> B)
         (SignA : A -> Sign) (SignB : B -> Sign)
         (IntersectionA : A -> A -> A) (IntersectionB : B -> B -> B)
         (v1 v2 v3 v4 : A),
    let corners := [v1; v2; v3; v4] in
    (forall v, In v corners -> SignB (f v) = SignA v) ->
    (forall v w, In v corners -> In w corners ->
       IntersectionB (f v) (f w) = f (IntersectionA v w)) ->
    T B SignB IntersectionB (f v1) (f v2) (f v3) (f v4)
    = map (MapTet f) (T A SignA IntersectionA v1 v2 v3 v4).

(** [AllEdgesCompatible], of any stencil set. *)
Definition AllStencilEdgesCompatible (T : StencilSet)
    (Vertex : Type) (GetSign : Vertex -> Sign)
    (GetIntersection : Vertex -> Vertex -> Vertex)
    (f1 f2 f3 p q u1 u2 u3 u4 v1 v2 v3 v4 : Vertex) : Prop :=
  forall (t1 t2 : UnstructuredTet Vertex),
    In t1 (T Vertex GetSign GetIntersection u1 u2 u3 u4) ->
    In t2 (T Vertex GetSign GetIntersection v1 v2 v3 v4) ->
    Forall (EdgePairCompatible Vertex GetIntersection f1 f2 f3 p q)
      (list_prod (Edges Vertex t1) (Edges Vertex t2)).

(** [CompatibilityOrders], of any stencil set. *)
Definition CompatibleStencils (T : StencilSet) : Prop :=
  forall Vertex GetSign GetIntersection f1 f2 f3 p q,
    let P := AllStencilEdgesCompatible T Vertex GetSign
               GetIntersection f1 f2 f3 p q in
    P p f1 f2 f3 q f1 f2 f3 /\
    P p f1 f2 f3 f1 q f3 f2 /\
    P f1 p f2 f3 q f1 f3 f2 /\
    P f1 p f2 f3 f1 q f2 f3 /\
    P f1 f2 p f3 f1 f2 q f3 /\
    P f1 f2 f3 p f1 f2 f3 q.
