(** * Triangles of the output

    A triangle is known by its three vertices, in any order. *)

From Coq Require Import List.
From Certet Require Import Stencil.UnstructuredTet.
Import ListNotations.

Section Triangle.
  Variable Vertex : Type.

  Definition Corners (t : UnstructuredTet Vertex) : list Vertex :=
    match t with UT _ a b c d => [a; b; c; d] end.

  (** [a b c] are three different corners of [t]. *)
  Definition HasTriangle (t : UnstructuredTet Vertex) (a b c : Vertex) : Prop :=
    (In a (Corners t) /\ In b (Corners t) /\ In c (Corners t)) /\
    (a <> b /\ b <> c /\ a <> c).

  Definition AmongTriangles (ts : list (UnstructuredTet Vertex))
      (a b c : Vertex) : Prop :=
    exists t, In t ts /\ HasTriangle t a b c.
End Triangle.

Arguments Corners {Vertex}.
Arguments HasTriangle {Vertex}.
Arguments AmongTriangles {Vertex}.
