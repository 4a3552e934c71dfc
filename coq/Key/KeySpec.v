(** * What is said of stencils whose diagonals follow an order of the cuts *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Key.KeyStuffing.
Open Scope Z_scope.

(** The order of the Parity Rule: opposite edges are alike, and the long ones
    come first, then [v1 v4] and [v2 v3], then [v1 v3] and [v2 v4]. *)
Definition KeepsParity {Vertex : Type} (GetKey : Vertex -> Vertex -> Z)
    (v1 v2 v3 v4 : Vertex) : Prop :=
  exists long first second, long < first < second /\
    (forall a b, In (a, b) [(v1, v2); (v2, v1); (v3, v4); (v4, v3)] ->
       GetKey a b = long) /\
    (forall a b, In (a, b) [(v1, v4); (v4, v1); (v2, v3); (v3, v2)] ->
       GetKey a b = first) /\
    (forall a b, In (a, b) [(v1, v3); (v3, v1); (v2, v4); (v4, v2)] ->
       GetKey a b = second).
