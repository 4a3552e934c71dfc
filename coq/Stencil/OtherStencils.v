(** * Three other stencil sets: a good one and two bad ones

    They show that the verification depends on no particular stencils, that it
    can say no, and what it does not ask. *)

From Certet Require Import Stencil.Definitions.

(** The Parity Rule mirrored.  Exchanging [v1] and [v2] keeps long edges long,
    and turns the diagonal of every face with two short cut edges. *)
Definition MirroredStencils : StencilSet :=
  fun Vertex GetSign GetIntersection v1 v2 v3 v4 =>
    GetUnstructuredTets Vertex GetSign GetIntersection v2 v1 v3 v4.

(** The paper's stencils with one diagonal swapped, in one of the 81 patterns:
    the mistake that made holes in the first marching cubes. *)
Definition HoledStencils : StencilSet :=
  fun Vertex GetSign GetIntersection v1 v2 v3 v4 =>
    match GetSign v1, GetSign v2, GetSign v3, GetSign v4 with
    | Plus, Plus, OnSurface, Minus =>
        [UT Vertex v2 v1 (GetIntersection v2 v4) v3;
         UT Vertex v1 (GetIntersection v1 v4) (GetIntersection v2 v4) v3]
    | _, _, _, _ =>
        GetUnstructuredTets Vertex GetSign GetIntersection v1 v2 v3 v4
    end.

(** The paper's stencils with one tetrahedron left out, in one of the 81
    patterns.  No edge crosses another, but the mesh has a hole. *)
Definition GappedStencils : StencilSet :=
  fun Vertex GetSign GetIntersection v1 v2 v3 v4 =>
    match GetSign v1, GetSign v2, GetSign v3, GetSign v4 with
    | Plus, Plus, Plus, Minus =>
        [UT Vertex v2 v1 (GetIntersection v1 v4) (GetIntersection v3 v4);
         UT Vertex v2 (GetIntersection v1 v4) (GetIntersection v2 v4) (GetIntersection v3 v4)]
    | _, _, _, _ =>
        GetUnstructuredTets Vertex GetSign GetIntersection v1 v2 v3 v4
    end.
