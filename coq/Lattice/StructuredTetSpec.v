(** * What a structured tetrahedron must tell about its neighbours

    Section 4.1 of the paper.  Call the i-th neighbour of a tetrahedron
    [v1 v2 v3 v4] by its identifier [nei_tid], and line its vertices up by
    [nei_order]: they must be [v1 v2 v3 v4] again, except in place i. *)

From Certet Require Import Lattice.Coord3 Lattice.StructuredTet.

Section GetStructuredTet_Spec.

  Variables (v1 v2 v3 v4 : Coord3)
            (nei_tid : StructuredTetId)
            (nei_order : VertexOrder).

  (** The vertices of the neighbour, lined up. *)
  Definition U :=
    match GetStructuredTet nei_tid with
      ST u1 u2 u3 u4 _ _ _ _ =>
        nei_order u1 u2 u3 u4
    end.

  Definition Face1Correct :=
    match U with (u1, u2, u3, u4) =>
      ~ (v1 = u1) /\ (v2 = u2) /\
      (v3 = u3) /\ (v4 = u4)
    end.

  Definition Face2Correct :=
    match U with (u1, u2, u3, u4) =>
      (v1 = u1) /\ ~ (v2 = u2) /\
      (v3 = u3) /\ (v4 = u4)
    end.

  Definition Face3Correct :=
    match U with (u1, u2, u3, u4) =>
      (v1 = u1) /\ (v2 = u2) /\
      ~ (v3 = u3) /\ (v4 = u4)
    end.

  Definition Face4Correct :=
    match U with (u1, u2, u3, u4) =>
      (v1 = u1) /\ (v2 = u2) /\
      (v3 = u3) /\ ~ (v4 = u4)
    end.

End GetStructuredTet_Spec.
