(** * Three or four materials in one tetrahedron, in full

    What [GetMaterialTets] gives in the 11 patterns that have a fill, each list
    printed as it comes: first the tetrahedra of each material against the rest,
    then the fill.  Where four materials meet they are eight; where three meet,
    seven, or four if the fourth corner lies on an interface.  In all other
    patterns there are two materials or one, and no fill. *)

From Certet Require Import Material.Definitions.
Open Scope Z_scope.

Section MaterialPatterns.
  Variable Vertex : Type.
  Variable GetMaterial : Vertex -> option Material.
  (** The cut of an edge, whichever end is named first. *)
  Variable GetCut : Vertex -> Vertex -> Vertex.

  Variables v1 v2 v3 v4 : Vertex.

  Local Notation c12 := (GetCut v1 v2).
  Local Notation c13 := (GetCut v1 v3).
  Local Notation c14 := (GetCut v1 v4).
  Local Notation c23 := (GetCut v2 v3).
  Local Notation c24 := (GetCut v2 v4).
  Local Notation c34 := (GetCut v3 v4).

  (** None: another pattern. *)
  Definition ThreeOrFourInFull
    : option (list (Material * UnstructuredTet Vertex)) :=
    match GetMaterial v1, GetMaterial v2, GetMaterial v3, GetMaterial v4 with
    | Some m1, Some m2, Some m3, Some m4 =>
        match m1 =? m2, m3 =? m4, m1 =? m3, m2 =? m4, m1 =? m4, m2 =? m3 with
        (* all four differ *)
        | false, false, false, false, false, false =>
            Some
              [(m1, UT _ v1 c12 c13 c14);
               (m2, UT _ v2 c12 c24 c23);
               (m3, UT _ v3 c34 c13 c23);
               (m4, UT _ v4 c34 c24 c14);
               (m1, UT _ c12 c34 c13 c14);
               (m2, UT _ c12 c34 c24 c23);
               (m3, UT _ c12 c34 c23 c13);
               (m4, UT _ c12 c34 c14 c24)]
        (* the ends of a long edge are one material *)
        | true, false, false, false, false, false =>
            Some
              [(m1, UT _ v1 v2 c23 c14);
               (m1, UT _ v1 c23 c13 c14);
               (m1, UT _ v2 c23 c14 c24);
               (m3, UT _ v3 c34 c13 c23);
               (m4, UT _ v4 c34 c24 c14);
               (m1, UT _ c13 c14 c23 c34);
               (m1, UT _ c14 c24 c23 c34)]
        | false, true, false, false, false, false =>
            Some
              [(m1, UT _ v1 c12 c13 c14);
               (m2, UT _ v2 c12 c24 c23);
               (m3, UT _ v3 v4 c14 c23);
               (m3, UT _ v3 c14 c13 c23);
               (m3, UT _ v4 c14 c23 c24);
               (m3, UT _ c13 c14 c12 c23);
               (m3, UT _ c14 c24 c12 c23)]
        (* the ends of a short edge are one material *)
        | false, false, true, false, false, false =>
            Some
              [(m1, UT _ v1 v3 c34 c12);
               (m1, UT _ v1 c34 c14 c12);
               (m1, UT _ v3 c34 c12 c23);
               (m2, UT _ v2 c12 c24 c23);
               (m4, UT _ v4 c34 c24 c14);
               (m2, UT _ c12 c34 c24 c23);
               (m4, UT _ c12 c34 c14 c24)]
        | false, false, false, true, false, false =>
            Some
              [(m1, UT _ v1 c12 c13 c14);
               (m2, UT _ v2 v4 c34 c12);
               (m2, UT _ v2 c34 c23 c12);
               (m2, UT _ v4 c34 c12 c14);
               (m3, UT _ v3 c34 c13 c23);
               (m1, UT _ c12 c34 c13 c14);
               (m3, UT _ c12 c34 c23 c13)]
        | false, false, false, false, true, false =>
            Some
              [(m1, UT _ v1 v4 c12 c34);
               (m1, UT _ v1 c34 c12 c13);
               (m1, UT _ v4 c34 c24 c12);
               (m2, UT _ v2 c12 c24 c23);
               (m3, UT _ v3 c34 c13 c23);
               (m2, UT _ c12 c34 c24 c23);
               (m3, UT _ c12 c34 c23 c13)]
        | false, false, false, false, false, true =>
            Some
              [(m1, UT _ v1 c12 c13 c14);
               (m2, UT _ v2 v3 c12 c34);
               (m2, UT _ v2 c34 c12 c24);
               (m2, UT _ v3 c34 c13 c12);
               (m4, UT _ v4 c34 c24 c14);
               (m1, UT _ c12 c34 c13 c14);
               (m4, UT _ c12 c34 c14 c24)]
        | _, _, _, _, _, _ => None
        end
    (* one corner lies on an interface, and the others differ *)
    | None, Some m2, Some m3, Some m4 =>
        match m2 =? m3, m2 =? m4, m3 =? m4 with
        | false, false, false =>
            Some
              [(m2, UT _ v2 v1 c24 c23);
               (m3, UT _ v3 c34 v1 c23);
               (m4, UT _ v4 c34 c24 v1);
               (m2, UT _ v1 c34 c24 c23)]
        | _, _, _ => None
        end
    | Some m1, None, Some m3, Some m4 =>
        match m1 =? m3, m1 =? m4, m3 =? m4 with
        | false, false, false =>
            Some
              [(m1, UT _ v1 v2 c13 c14);
               (m3, UT _ v3 c34 c13 v2);
               (m4, UT _ v4 c34 v2 c14);
               (m1, UT _ v2 c34 c13 c14)]
        | _, _, _ => None
        end
    | Some m1, Some m2, None, Some m4 =>
        match m1 =? m2, m1 =? m4, m2 =? m4 with
        | false, false, false =>
            Some
              [(m1, UT _ v1 c12 v3 c14);
               (m2, UT _ v2 c12 c24 v3);
               (m4, UT _ v4 v3 c24 c14);
               (m4, UT _ v3 c12 c24 c14)]
        | _, _, _ => None
        end
    | Some m1, Some m2, Some m3, None =>
        match m1 =? m2, m1 =? m3, m2 =? m3 with
        | false, false, false =>
            Some
              [(m1, UT _ v1 c12 c13 v4);
               (m2, UT _ v2 c12 v4 c23);
               (m3, UT _ v3 v4 c13 c23);
               (m3, UT _ v4 c12 c13 c23)]
        | _, _, _ => None
        end
    | _, _, _, _ => None
    end.
End MaterialPatterns.
