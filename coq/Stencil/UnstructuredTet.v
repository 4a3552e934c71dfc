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

  Definition GetUnstructuredTets (v1 v2 v3 v4 : Vertex)
    : list UnstructuredTet :=
    match GetSign v1, GetSign v2, GetSign v3, GetSign v4 with
    | Plus, Plus, Plus, Plus =>
        [UT v1 v2 v3 v4]
    | Plus, Plus, Plus, OnSurface =>
        [UT v1 v2 v3 v4]
    | Plus, Plus, Plus, Minus =>
        [UT v2 v1 (GetIntersection v3 v4) v3;
           UT v2 v1 (GetIntersection v1 v4) (GetIntersection v3 v4);
           UT v2 (GetIntersection v1 v4) (GetIntersection v2 v4) (GetIntersection v3 v4)]
    | Plus, Plus, OnSurface, Plus =>
        [UT v1 v2 v3 v4]
    | Plus, Plus, OnSurface, OnSurface =>
        [UT v1 v2 v3 v4]
    | Plus, Plus, OnSurface, Minus =>
        [UT v2 v1 (GetIntersection v1 v4) v3;
           UT v2 (GetIntersection v1 v4) (GetIntersection v2 v4) v3]
    | Plus, Plus, Minus, Plus =>
        [UT v1 v2 (GetIntersection v4 v3) v4;
           UT v1 v2 (GetIntersection v2 v3) (GetIntersection v4 v3);
           UT v1 (GetIntersection v2 v3) (GetIntersection v1 v3) (GetIntersection v4 v3)]
    | Plus, Plus, Minus, OnSurface =>
        [UT v1 v2 (GetIntersection v2 v3) v4;
           UT v1 (GetIntersection v2 v3) (GetIntersection v1 v3) v4]
    | Plus, Plus, Minus, Minus =>
        [UT v1 v2 (GetIntersection v2 v3) (GetIntersection v1 v4);
           UT v1 (GetIntersection v2 v3) (GetIntersection v1 v3) (GetIntersection v1 v4);
           UT v2 (GetIntersection v2 v3) (GetIntersection v1 v4) (GetIntersection v2 v4)]
    | Plus, OnSurface, Plus, Plus =>
        [UT v1 v2 v3 v4]
    | Plus, OnSurface, Plus, OnSurface =>
        [UT v1 v2 v3 v4]
    | Plus, OnSurface, Plus, Minus =>
        [UT v1 v3 (GetIntersection v3 v4) v2;
           UT v1 (GetIntersection v3 v4) (GetIntersection v1 v4) v2]
    | Plus, OnSurface, OnSurface, Plus =>
        [UT v1 v2 v3 v4]
    | Plus, OnSurface, OnSurface, OnSurface =>
        [UT v1 v2 v3 v4]
    | Plus, OnSurface, OnSurface, Minus =>
        [UT v1 v2 v3 (GetIntersection v1 v4)]
    | Plus, OnSurface, Minus, Plus =>
        [UT v1 v4 v2 (GetIntersection v4 v3);
           UT v1 (GetIntersection v4 v3) v2 (GetIntersection v1 v3)]
    | Plus, OnSurface, Minus, OnSurface =>
        [UT v1 v2 (GetIntersection v1 v3) v4]
    | Plus, OnSurface, Minus, Minus =>
        [UT v1 v2 (GetIntersection v1 v3) (GetIntersection v1 v4)]
    | Plus, Minus, Plus, Plus =>
        [UT v4 v3 (GetIntersection v1 v2) v1;
           UT v4 v3 (GetIntersection v3 v2) (GetIntersection v1 v2);
           UT v4 (GetIntersection v3 v2) (GetIntersection v4 v2) (GetIntersection v1 v2)]
    | Plus, Minus, Plus, OnSurface =>
        [UT v3 v1 (GetIntersection v1 v2) v4;
           UT v3 (GetIntersection v1 v2) (GetIntersection v3 v2) v4]
    | Plus, Minus, Plus, Minus =>
        [UT v1 v3 (GetIntersection v3 v4) (GetIntersection v1 v2);
           UT v1 (GetIntersection v3 v4) (GetIntersection v1 v4) (GetIntersection v1 v2);
           UT v3 (GetIntersection v3 v4) (GetIntersection v1 v2) (GetIntersection v3 v2)]
    | Plus, Minus, OnSurface, Plus =>
        [UT v4 v1 v3 (GetIntersection v1 v2);
           UT v4 (GetIntersection v1 v2) v3 (GetIntersection v4 v2)]
    | Plus, Minus, OnSurface, OnSurface =>
        [UT v1 (GetIntersection v1 v2) v3 v4]
    | Plus, Minus, OnSurface, Minus =>
        [UT v1 (GetIntersection v1 v2) v3 (GetIntersection v1 v4)]
    | Plus, Minus, Minus, Plus =>
        [UT v1 v4 (GetIntersection v1 v2) (GetIntersection v4 v3);
           UT v1 (GetIntersection v4 v3) (GetIntersection v1 v2) (GetIntersection v1 v3);
           UT v4 (GetIntersection v4 v3) (GetIntersection v4 v2) (GetIntersection v1 v2)]
    | Plus, Minus, Minus, OnSurface =>
        [UT v1 (GetIntersection v1 v2) (GetIntersection v1 v3) v4]
    | Plus, Minus, Minus, Minus =>
        [UT v1 (GetIntersection v1 v2) (GetIntersection v1 v3) (GetIntersection v1 v4)]
    | OnSurface, Plus, Plus, Plus =>
        [UT v1 v2 v3 v4]
    | OnSurface, Plus, Plus, OnSurface =>
        [UT v1 v2 v3 v4]
    | OnSurface, Plus, Plus, Minus =>
        [UT v2 v3 v1 (GetIntersection v3 v4);
           UT v2 (GetIntersection v3 v4) v1 (GetIntersection v2 v4)]
    | OnSurface, Plus, OnSurface, Plus =>
        [UT v1 v2 v3 v4]
    | OnSurface, Plus, OnSurface, OnSurface =>
        [UT v1 v2 v3 v4]
    | OnSurface, Plus, OnSurface, Minus =>
        [UT v2 v1 (GetIntersection v2 v4) v3]
    | OnSurface, Plus, Minus, Plus =>
        [UT v2 v4 (GetIntersection v4 v3) v1;
           UT v2 (GetIntersection v4 v3) (GetIntersection v2 v3) v1]
    | OnSurface, Plus, Minus, OnSurface =>
        [UT v2 v1 v4 (GetIntersection v2 v3)]
    | OnSurface, Plus, Minus, Minus =>
        [UT v2 v1 (GetIntersection v2 v4) (GetIntersection v2 v3)]
    | OnSurface, OnSurface, Plus, Plus =>
        [UT v1 v2 v3 v4]
    | OnSurface, OnSurface, Plus, OnSurface =>
        [UT v1 v2 v3 v4]
    | OnSurface, OnSurface, Plus, Minus =>
        [UT v3 (GetIntersection v3 v4) v1 v2]
    | OnSurface, OnSurface, OnSurface, Plus =>
        [UT v1 v2 v3 v4]
    | OnSurface, OnSurface, OnSurface, OnSurface => []
    | OnSurface, OnSurface, OnSurface, Minus => []
    | OnSurface, OnSurface, Minus, Plus =>
        [UT v4 (GetIntersection v4 v3) v2 v1]
    | OnSurface, OnSurface, Minus, OnSurface => []
    | OnSurface, OnSurface, Minus, Minus => []
    | OnSurface, Minus, Plus, Plus =>
        [UT v4 v3 (GetIntersection v3 v2) v1;
           UT v4 (GetIntersection v3 v2) (GetIntersection v4 v2) v1]
    | OnSurface, Minus, Plus, OnSurface =>
        [UT v3 v4 v1 (GetIntersection v3 v2)]
    | OnSurface, Minus, Plus, Minus =>
        [UT v3 (GetIntersection v3 v4) v1 (GetIntersection v3 v2)]
    | OnSurface, Minus, OnSurface, Plus =>
        [UT v4 v3 (GetIntersection v4 v2) v1]
    | OnSurface, Minus, OnSurface, OnSurface => []
    | OnSurface, Minus, OnSurface, Minus => []
    | OnSurface, Minus, Minus, Plus =>
        [UT v4 (GetIntersection v4 v3) (GetIntersection v4 v2) v1]
    | OnSurface, Minus, Minus, OnSurface => []
    | OnSurface, Minus, Minus, Minus => []
    | Minus, Plus, Plus, Plus =>
        [UT v3 v4 (GetIntersection v2 v1) v2;
           UT v3 v4 (GetIntersection v4 v1) (GetIntersection v2 v1);
           UT v3 (GetIntersection v4 v1) (GetIntersection v3 v1) (GetIntersection v2 v1)]
    | Minus, Plus, Plus, OnSurface =>
        [UT v3 v2 v4 (GetIntersection v2 v1);
           UT v3 (GetIntersection v2 v1) v4 (GetIntersection v3 v1)]
    | Minus, Plus, Plus, Minus =>
        [UT v2 v3 (GetIntersection v2 v1) (GetIntersection v3 v4);
           UT v2 (GetIntersection v3 v4) (GetIntersection v2 v1) (GetIntersection v2 v4);
           UT v3 (GetIntersection v3 v4) (GetIntersection v3 v1) (GetIntersection v2 v1)]
    | Minus, Plus, OnSurface, Plus =>
        [UT v4 v2 (GetIntersection v2 v1) v3;
           UT v4 (GetIntersection v2 v1) (GetIntersection v4 v1) v3]
    | Minus, Plus, OnSurface, OnSurface =>
        [UT v2 (GetIntersection v2 v1) v4 v3]
    | Minus, Plus, OnSurface, Minus =>
        [UT v2 (GetIntersection v2 v1) (GetIntersection v2 v4) v3]
    | Minus, Plus, Minus, Plus =>
        [UT v2 v4 (GetIntersection v4 v3) (GetIntersection v2 v1);
           UT v2 (GetIntersection v4 v3) (GetIntersection v2 v3) (GetIntersection v2 v1);
           UT v4 (GetIntersection v4 v3) (GetIntersection v2 v1) (GetIntersection v4 v1)]
    | Minus, Plus, Minus, OnSurface =>
        [UT v2 (GetIntersection v2 v1) v4 (GetIntersection v2 v3)]
    | Minus, Plus, Minus, Minus =>
        [UT v2 (GetIntersection v2 v1) (GetIntersection v2 v4) (GetIntersection v2 v3)]
    | Minus, OnSurface, Plus, Plus =>
        [UT v3 v4 (GetIntersection v4 v1) v2;
           UT v3 (GetIntersection v4 v1) (GetIntersection v3 v1) v2]
    | Minus, OnSurface, Plus, OnSurface =>
        [UT v3 v4 (GetIntersection v3 v1) v2]
    | Minus, OnSurface, Plus, Minus =>
        [UT v3 (GetIntersection v3 v4) (GetIntersection v3 v1) v2]
    | Minus, OnSurface, OnSurface, Plus =>
        [UT v4 v3 v2 (GetIntersection v4 v1)]
    | Minus, OnSurface, OnSurface, OnSurface => []
    | Minus, OnSurface, OnSurface, Minus => []
    | Minus, OnSurface, Minus, Plus =>
        [UT v4 (GetIntersection v4 v3) v2 (GetIntersection v4 v1)]
    | Minus, OnSurface, Minus, OnSurface => []
    | Minus, OnSurface, Minus, Minus => []
    | Minus, Minus, Plus, Plus =>
        [UT v3 v4 (GetIntersection v4 v1) (GetIntersection v3 v2);
           UT v3 (GetIntersection v4 v1) (GetIntersection v3 v1) (GetIntersection v3 v2);
           UT v4 (GetIntersection v4 v1) (GetIntersection v3 v2) (GetIntersection v4 v2)]
    | Minus, Minus, Plus, OnSurface =>
        [UT v3 v4 (GetIntersection v3 v1) (GetIntersection v3 v2)]
    | Minus, Minus, Plus, Minus =>
        [UT v3 (GetIntersection v3 v4) (GetIntersection v3 v1) (GetIntersection v3 v2)]
    | Minus, Minus, OnSurface, Plus =>
        [UT v4 v3 (GetIntersection v4 v2) (GetIntersection v4 v1)]
    | Minus, Minus, OnSurface, OnSurface => []
    | Minus, Minus, OnSurface, Minus => []
    | Minus, Minus, Minus, Plus =>
        [UT v4 (GetIntersection v4 v3) (GetIntersection v4 v2) (GetIntersection v4 v1)]
    | Minus, Minus, Minus, OnSurface => []
    | Minus, Minus, Minus, Minus => []
    end.
End UnstructuredTet.
