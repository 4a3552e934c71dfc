(** * The surface of any mesh

    As in [Topology/SurfaceSpec.v], of whatever tetrahedra are made within each
    structured tetrahedron. *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Mesh.Method Mesh.MeshPiecesSpec.

Section Mesh.
  Variable mesh : Mesh.

  Definition SurfaceOf (a b c : MeshVertex) : Prop :=
    exists t, TetOf mesh t /\ HasTriangle t a b c /\
      forall u, TetOf mesh u -> HasTriangle u a b c -> u = t.

  (** [x] is joined to [a] by an edge of the surface. *)
  Definition FanOf (a x : MeshVertex) : Prop := exists y, SurfaceOf a x y.

  (** From [x] to [y] by triangles at [a], each of which has an edge at [a] in
      common with the next. *)
  Definition JoinedInFanOf (a : MeshVertex) : MeshVertex -> MeshVertex -> Prop :=
    Joined (FanOf a) (SurfaceOf a).
End Mesh.
