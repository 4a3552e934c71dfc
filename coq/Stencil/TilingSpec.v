(** * Stencils that fit a tiling

    Any set of stencils in any tiling: no two edges of the stencils on the two
    sides of a face cross. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Lattice.Tiling.

Definition CompatibleInTiling (S : StencilSet) (T : Tiling) : Prop :=
  forall GetSign GetIntersection (id : Identifier T) (i : Place),
    let v := VertexOf id in
    let u := VertexOf (fst (NeighborAt id i)) in
    let w := LinedUp T id i in
    let '(j, k, l) := Others i in
    AllStencilEdgesCompatible S Coord3 GetSign GetIntersection
      (w j) (w k) (w l) (v i) (w i)
      (v First) (v Second) (v Third) (v Fourth)
      (u First) (u Second) (u Third) (u Fourth).
