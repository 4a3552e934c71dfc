(** * Stencils: the tetrahedra of the output

    A structured tetrahedron is replaced by zero to three unstructured ones,
    according to the signs of its four vertices.  Section 3.2 of the paper.

    The table is printed in full, one arm for each of the 81 sign patterns, so
    that it can be read against the picture.  A cut is always taken from the
    inner to the outer end of its edge.  Where an edge pair leaves a
    quadrilateral, its diagonal depends on the face alone: it ends at the cut
    on the long edge if exactly one of the two cut edges is long, and follows
    the (unfolded) Parity Rule if both are short.  Each tetrahedron is
    right-handed when its structured tetrahedron is. *)

From Coq Require Import List.
Import ListNotations.

(** Inside the domain (+), on its boundary (0), outside (-). *)
Inductive Sign := Plus | OnSurface | Minus.

Section UnstructuredTet.
  Variable Vertex : Type.

  Inductive UnstructuredTet :=
    UT : Vertex -> Vertex -> Vertex -> Vertex -> UnstructuredTet.

  Variable GetSign : Vertex -> Sign.
  Variable GetIntersection : Vertex -> Vertex -> Vertex.

  (** The corners; [c34] is the cut of the edge from [v3] to [v4]. *)
  Variables v1 v2 v3 v4 : Vertex.

  Local Notation c12 := (GetIntersection v1 v2).
  Local Notation c13 := (GetIntersection v1 v3).
  Local Notation c14 := (GetIntersection v1 v4).
  Local Notation c21 := (GetIntersection v2 v1).
  Local Notation c23 := (GetIntersection v2 v3).
  Local Notation c24 := (GetIntersection v2 v4).
  Local Notation c31 := (GetIntersection v3 v1).
  Local Notation c32 := (GetIntersection v3 v2).
  Local Notation c34 := (GetIntersection v3 v4).
  Local Notation c41 := (GetIntersection v4 v1).
  Local Notation c42 := (GetIntersection v4 v2).
  Local Notation c43 := (GetIntersection v4 v3).

  Definition GetUnstructuredTets : list UnstructuredTet :=
    match GetSign v1, GetSign v2, GetSign v3, GetSign v4 with
    | Plus, Plus, Plus, Plus =>
        [UT v1 v2 v3 v4]
    | Plus, Plus, Plus, OnSurface =>
        [UT v1 v2 v3 v4]
    | Plus, Plus, Plus, Minus =>
        [UT v2 v1 c34 v3;
         UT v2 v1 c14 c34;
         UT v2 c14 c24 c34]
    | Plus, Plus, OnSurface, Plus =>
        [UT v1 v2 v3 v4]
    | Plus, Plus, OnSurface, OnSurface =>
        [UT v1 v2 v3 v4]
    | Plus, Plus, OnSurface, Minus =>
        [UT v2 v1 c14 v3;
         UT v2 c14 c24 v3]
    | Plus, Plus, Minus, Plus =>
        [UT v1 v2 c43 v4;
         UT v1 v2 c23 c43;
         UT v1 c23 c13 c43]
    | Plus, Plus, Minus, OnSurface =>
        [UT v1 v2 c23 v4;
         UT v1 c23 c13 v4]
    | Plus, Plus, Minus, Minus =>
        [UT v1 v2 c23 c14;
         UT v1 c23 c13 c14;
         UT v2 c23 c14 c24]
    | Plus, OnSurface, Plus, Plus =>
        [UT v1 v2 v3 v4]
    | Plus, OnSurface, Plus, OnSurface =>
        [UT v1 v2 v3 v4]
    | Plus, OnSurface, Plus, Minus =>
        [UT v1 v3 c34 v2;
         UT v1 c34 c14 v2]
    | Plus, OnSurface, OnSurface, Plus =>
        [UT v1 v2 v3 v4]
    | Plus, OnSurface, OnSurface, OnSurface =>
        [UT v1 v2 v3 v4]
    | Plus, OnSurface, OnSurface, Minus =>
        [UT v1 v2 v3 c14]
    | Plus, OnSurface, Minus, Plus =>
        [UT v1 v4 v2 c43;
         UT v1 c43 v2 c13]
    | Plus, OnSurface, Minus, OnSurface =>
        [UT v1 v2 c13 v4]
    | Plus, OnSurface, Minus, Minus =>
        [UT v1 v2 c13 c14]
    | Plus, Minus, Plus, Plus =>
        [UT v4 v3 c12 v1;
         UT v4 v3 c32 c12;
         UT v4 c32 c42 c12]
    | Plus, Minus, Plus, OnSurface =>
        [UT v3 v1 c12 v4;
         UT v3 c12 c32 v4]
    | Plus, Minus, Plus, Minus =>
        [UT v1 v3 c34 c12;
         UT v1 c34 c14 c12;
         UT v3 c34 c12 c32]
    | Plus, Minus, OnSurface, Plus =>
        [UT v4 v1 v3 c12;
         UT v4 c12 v3 c42]
    | Plus, Minus, OnSurface, OnSurface =>
        [UT v1 c12 v3 v4]
    | Plus, Minus, OnSurface, Minus =>
        [UT v1 c12 v3 c14]
    | Plus, Minus, Minus, Plus =>
        [UT v1 v4 c12 c43;
         UT v1 c43 c12 c13;
         UT v4 c43 c42 c12]
    | Plus, Minus, Minus, OnSurface =>
        [UT v1 c12 c13 v4]
    | Plus, Minus, Minus, Minus =>
        [UT v1 c12 c13 c14]
    | OnSurface, Plus, Plus, Plus =>
        [UT v1 v2 v3 v4]
    | OnSurface, Plus, Plus, OnSurface =>
        [UT v1 v2 v3 v4]
    | OnSurface, Plus, Plus, Minus =>
        [UT v2 v3 v1 c34;
         UT v2 c34 v1 c24]
    | OnSurface, Plus, OnSurface, Plus =>
        [UT v1 v2 v3 v4]
    | OnSurface, Plus, OnSurface, OnSurface =>
        [UT v1 v2 v3 v4]
    | OnSurface, Plus, OnSurface, Minus =>
        [UT v2 v1 c24 v3]
    | OnSurface, Plus, Minus, Plus =>
        [UT v2 v4 c43 v1;
         UT v2 c43 c23 v1]
    | OnSurface, Plus, Minus, OnSurface =>
        [UT v2 v1 v4 c23]
    | OnSurface, Plus, Minus, Minus =>
        [UT v2 v1 c24 c23]
    | OnSurface, OnSurface, Plus, Plus =>
        [UT v1 v2 v3 v4]
    | OnSurface, OnSurface, Plus, OnSurface =>
        [UT v1 v2 v3 v4]
    | OnSurface, OnSurface, Plus, Minus =>
        [UT v3 c34 v1 v2]
    | OnSurface, OnSurface, OnSurface, Plus =>
        [UT v1 v2 v3 v4]
    | OnSurface, OnSurface, OnSurface, OnSurface => []
    | OnSurface, OnSurface, OnSurface, Minus => []
    | OnSurface, OnSurface, Minus, Plus =>
        [UT v4 c43 v2 v1]
    | OnSurface, OnSurface, Minus, OnSurface => []
    | OnSurface, OnSurface, Minus, Minus => []
    | OnSurface, Minus, Plus, Plus =>
        [UT v4 v3 c32 v1;
         UT v4 c32 c42 v1]
    | OnSurface, Minus, Plus, OnSurface =>
        [UT v3 v4 v1 c32]
    | OnSurface, Minus, Plus, Minus =>
        [UT v3 c34 v1 c32]
    | OnSurface, Minus, OnSurface, Plus =>
        [UT v4 v3 c42 v1]
    | OnSurface, Minus, OnSurface, OnSurface => []
    | OnSurface, Minus, OnSurface, Minus => []
    | OnSurface, Minus, Minus, Plus =>
        [UT v4 c43 c42 v1]
    | OnSurface, Minus, Minus, OnSurface => []
    | OnSurface, Minus, Minus, Minus => []
    | Minus, Plus, Plus, Plus =>
        [UT v3 v4 c21 v2;
         UT v3 v4 c41 c21;
         UT v3 c41 c31 c21]
    | Minus, Plus, Plus, OnSurface =>
        [UT v3 v2 v4 c21;
         UT v3 c21 v4 c31]
    | Minus, Plus, Plus, Minus =>
        [UT v2 v3 c21 c34;
         UT v2 c34 c21 c24;
         UT v3 c34 c31 c21]
    | Minus, Plus, OnSurface, Plus =>
        [UT v4 v2 c21 v3;
         UT v4 c21 c41 v3]
    | Minus, Plus, OnSurface, OnSurface =>
        [UT v2 c21 v4 v3]
    | Minus, Plus, OnSurface, Minus =>
        [UT v2 c21 c24 v3]
    | Minus, Plus, Minus, Plus =>
        [UT v2 v4 c43 c21;
         UT v2 c43 c23 c21;
         UT v4 c43 c21 c41]
    | Minus, Plus, Minus, OnSurface =>
        [UT v2 c21 v4 c23]
    | Minus, Plus, Minus, Minus =>
        [UT v2 c21 c24 c23]
    | Minus, OnSurface, Plus, Plus =>
        [UT v3 v4 c41 v2;
         UT v3 c41 c31 v2]
    | Minus, OnSurface, Plus, OnSurface =>
        [UT v3 v4 c31 v2]
    | Minus, OnSurface, Plus, Minus =>
        [UT v3 c34 c31 v2]
    | Minus, OnSurface, OnSurface, Plus =>
        [UT v4 v3 v2 c41]
    | Minus, OnSurface, OnSurface, OnSurface => []
    | Minus, OnSurface, OnSurface, Minus => []
    | Minus, OnSurface, Minus, Plus =>
        [UT v4 c43 v2 c41]
    | Minus, OnSurface, Minus, OnSurface => []
    | Minus, OnSurface, Minus, Minus => []
    | Minus, Minus, Plus, Plus =>
        [UT v3 v4 c41 c32;
         UT v3 c41 c31 c32;
         UT v4 c41 c32 c42]
    | Minus, Minus, Plus, OnSurface =>
        [UT v3 v4 c31 c32]
    | Minus, Minus, Plus, Minus =>
        [UT v3 c34 c31 c32]
    | Minus, Minus, OnSurface, Plus =>
        [UT v4 v3 c42 c41]
    | Minus, Minus, OnSurface, OnSurface => []
    | Minus, Minus, OnSurface, Minus => []
    | Minus, Minus, Minus, Plus =>
        [UT v4 c43 c42 c41]
    | Minus, Minus, Minus, OnSurface => []
    | Minus, Minus, Minus, Minus => []
    end.
End UnstructuredTet.
