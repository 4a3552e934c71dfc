(** * When the stencils on the two sides of a face are compatible

    Section 5.1 of the paper.  Tetrahedra [f1 f2 f3 p] and [f1 f2 f3 q] share
    the face [f1 f2 f3].  Two edges of the stencils, one from each side, are
    compatible if their interiors do not meet.  All that is known of a cut is
    that it lies strictly inside its edge, so a barycentric coordinate is
    known only as 0, 1, or something between. *)

From Coq Require Import List.
From Certet Require Import Stencil.UnstructuredTet.
Import ListNotations.

(** ** Barycentric coordinates (5.1.1) *)

Inductive BCoord := Zero | Interior | One.

(** ** A point outside the interior of a segment, in one coordinate (5.1.4) *)

(** [Below c a b]: coordinate [c] is below the interior of the segment from
    [a] to [b].  Two [Interior] coordinates are never compared. *)
Inductive Below : BCoord -> BCoord -> BCoord -> Prop :=
| B_1 : Below Zero Zero Interior
| B_2 : Below Zero Zero One
| B_3 : Below Zero Interior Interior
| B_4 : Below Zero Interior One.

Inductive Above : BCoord -> BCoord -> BCoord -> Prop :=
| A_1 : Above One Zero Interior
| A_2 : Above One Zero One
| A_3 : Above One Interior Interior
| A_4 : Above One Interior One.

(** The same, with the ends of the segment in either order. *)
Section Below_Above_Symm.
  Variables c a b : BCoord.
  Inductive BelowSymm : Prop :=
  | BS_1 : Below c a b -> BelowSymm
  | BS_2 : Below c b a -> BelowSymm.
  Inductive AboveSymm : Prop :=
  | AS_1 : Above c a b -> AboveSymm
  | AS_2 : Above c b a -> AboveSymm.
End Below_Above_Symm.

Section Segment_Point_Not_Intersecting_1D.
  Variables c a b : BCoord.
  Inductive SPNI1D : Prop :=
  | SPNI1D_1 : BelowSymm c a b -> SPNI1D
  | SPNI1D_2 : AboveSymm c a b -> SPNI1D.
End Segment_Point_Not_Intersecting_1D.

(** One coordinate of the three is enough. *)
Section Segment_Point_Not_Intersecting_3D.
  Variables a1 a2 a3 b1 b2 b3 c1 c2 c3 : BCoord.
  Inductive SPNI3D : Prop :=
  | SPNI3D_1 : SPNI1D c1 a1 b1 -> SPNI3D
  | SPNI3D_2 : SPNI1D c2 a2 b2 -> SPNI3D
  | SPNI3D_3 : SPNI1D c3 a3 b3 -> SPNI3D.
End Segment_Point_Not_Intersecting_3D.

(** ** Two segments with disjoint interiors (5.1.4) *)

(** Both ends of one are below the other. *)
Section Segment_Segment_Not_Intersecting_1D.
  Variables a b c d : BCoord.
  Inductive SSNI1D : Prop :=
  | SSNI1D_1 : BelowSymm a c d ->
      BelowSymm b c d -> SSNI1D
  | SSNI1D_2 : BelowSymm c a b ->
      BelowSymm d a b -> SSNI1D.
End Segment_Segment_Not_Intersecting_1D.

Section Segment_Segment_Not_Intersecting_3D.
  Variables a1 a2 a3 b1 b2 b3
            c1 c2 c3 d1 d2 d3 : BCoord.
  Inductive SSNI3D : Prop :=
  | SSNI3D_1 : SSNI1D a1 b1 c1 d1 -> SSNI3D
  | SSNI3D_2 : SSNI1D a2 b2 c2 d2 -> SSNI3D
  | SSNI3D_3 : SSNI1D a3 b3 c3 d3 -> SSNI3D.
End Segment_Segment_Not_Intersecting_3D.

Section Compatibility.
  Variable Vertex : Type.
  Variable GetSign : Vertex -> Sign.
  Variable GetIntersection : Vertex -> Vertex -> Vertex.
  Variables f1 f2 f3 p q : Vertex.

  (** ** Coordinates within the shared face (5.1.2) *)

  Inductive FCoord : Vertex -> BCoord -> BCoord -> BCoord -> Prop :=
  | FC_1 : FCoord f1 One Zero Zero
  | FC_2 : FCoord f2 Zero One Zero
  | FC_3 : FCoord f3 Zero Zero One
  | FC_4 : FCoord (GetIntersection f1 f2)
             Interior Interior Zero
  | FC_5 : FCoord (GetIntersection f2 f1)
             Interior Interior Zero
  | FC_6 : FCoord (GetIntersection f1 f3)
             Interior Zero Interior
  | FC_7 : FCoord (GetIntersection f3 f1)
             Interior Zero Interior
  | FC_8 : FCoord (GetIntersection f2 f3)
             Zero Interior Interior
  | FC_9 : FCoord (GetIntersection f3 f2)
             Zero Interior Interior.

  (** ** Vertices off the shared face, on either side (5.1.3) *)

  Inductive PCoord : Vertex -> Prop :=
  | PC_1 : PCoord p
  | PC_2 : PCoord (GetIntersection p f1)
  | PC_3 : PCoord (GetIntersection f1 p)
  | PC_4 : PCoord (GetIntersection p f2)
  | PC_5 : PCoord (GetIntersection f2 p)
  | PC_6 : PCoord (GetIntersection p f3)
  | PC_7 : PCoord (GetIntersection f3 p).

  Inductive QCoord : Vertex -> Prop :=
  | QC_1 : QCoord q
  | QC_2 : QCoord (GetIntersection q f1)
  | QC_3 : QCoord (GetIntersection f1 q)
  | QC_4 : QCoord (GetIntersection q f2)
  | QC_5 : QCoord (GetIntersection f2 q)
  | QC_6 : QCoord (GetIntersection q f3)
  | QC_7 : QCoord (GetIntersection f3 q).

  (** ** Two compatible edges (5.1.5) *)

  (** [v] is an end of [(u1, u2)], or off the shared face on side [V]. *)
  Section Special_Vertex.
    Variables (v u1 u2 : Vertex)
              (V : Vertex -> Prop).
    Inductive SpecialVertex : Prop :=
    | SV_1 : v = u1 -> SpecialVertex
    | SV_2 : v = u2 -> SpecialVertex
    | SV_3 : V v -> SpecialVertex.
  End Special_Vertex.

  (** [v] is not in the interior of [(u1, u2)]. *)
  Section Not_In.
    Variables (v u1 u2 : Vertex)
              (V U : Vertex -> Prop).
    Inductive NotIn : Prop :=
    | NI_1 : SpecialVertex v u1 u2 V -> NotIn
    | NI_2 : U u1 -> NotIn
    | NI_3 : U u2 -> NotIn
    | NI_4 : forall a1 a2 a3 b1 b2 b3 c1 c2 c3 : BCoord,
        FCoord u1 a1 a2 a3 ->
        FCoord u2 b1 b2 b3 ->
        FCoord v c1 c2 c3 ->
        SPNI3D a1 a2 a3 b1 b2 b3 c1 c2 c3 ->
        NotIn.
  End Not_In.

  (** Edge [(p1, p2)] is from the side of [p], edge [(q1, q2)] from that of
      [q]. *)
  Section Two_Edges_Compatible.
    Variables p1 p2 q1 q2 : Vertex.
    Inductive TwoEdgesCompatible : Prop :=
    | EC_1 : SpecialVertex p1 q1 q2 PCoord ->
        NotIn p2 q1 q2 PCoord QCoord ->
        TwoEdgesCompatible
    | EC_2 : SpecialVertex p2 q1 q2 PCoord ->
        NotIn p1 q1 q2 PCoord QCoord ->
        TwoEdgesCompatible
    | EC_3 : SpecialVertex q1 p1 p2 QCoord ->
        NotIn q2 p1 p2 QCoord PCoord ->
        TwoEdgesCompatible
    | EC_4 : SpecialVertex q2 p1 p2 QCoord ->
        NotIn q1 p1 p2 QCoord PCoord ->
        TwoEdgesCompatible
    | EC_5 : forall a1 a2 a3 b1 b2 b3
                    c1 c2 c3 d1 d2 d3 : BCoord,
        FCoord p1 a1 a2 a3 ->
        FCoord p2 b1 b2 b3 ->
        FCoord q1 c1 c2 c3 ->
        FCoord q2 d1 d2 d3 ->
        SSNI3D a1 a2 a3 b1 b2 b3
               c1 c2 c3 d1 d2 d3 ->
        TwoEdgesCompatible.
  End Two_Edges_Compatible.

  (** ** All edges of two stencils *)

  Definition Edge : Type := Vertex * Vertex.

  Definition Edges (t : UnstructuredTet Vertex) : list Edge :=
    match t with UT _ u v w r =>
      [(u, v); (u, w); (u, r); (v, w); (v, r); (w, r)]
    end.

  Definition EdgePairCompatible (ee : Edge * Edge) : Prop :=
    let '((p1, p2), (q1, q2)) := ee in
    TwoEdgesCompatible p1 p2 q1 q2.

  (** Every edge of one with every edge of the other: the cartesian product,
      [list_prod], which the paper calls list_produces. *)
  Definition AllEdgesCompatible
      (u1 u2 u3 u4 v1 v2 v3 v4 : Vertex) : Prop :=
    let T := GetUnstructuredTets Vertex
               GetSign GetIntersection in
    forall (t1 t2 : UnstructuredTet Vertex),
      List.In t1 (T u1 u2 u3 u4) ->
      List.In t2 (T v1 v2 v3 v4) ->
      Forall EdgePairCompatible
        (list_prod (Edges t1) (Edges t2)).

End Compatibility.
