(** * The six ways in which two structured tetrahedra share a face

    The orders in which the two list the face [f1 f2 f3] and their own apexes
    [p] and [q].  No other occur in the lattice (see [ArrangementProof]), and
    the stencils agree on these (see [CompatibilityOrders]). *)

Inductive Arranged {Vertex : Type} (f1 f2 f3 p q : Vertex) :
  Vertex -> Vertex -> Vertex -> Vertex ->
  Vertex -> Vertex -> Vertex -> Vertex -> Prop :=
| Arranged_1 : Arranged f1 f2 f3 p q p f1 f2 f3 q f1 f2 f3
| Arranged_2 : Arranged f1 f2 f3 p q p f1 f2 f3 f1 q f3 f2
| Arranged_3 : Arranged f1 f2 f3 p q f1 p f2 f3 q f1 f3 f2
| Arranged_4 : Arranged f1 f2 f3 p q f1 p f2 f3 f1 q f2 f3
| Arranged_5 : Arranged f1 f2 f3 p q f1 f2 p f3 f1 f2 q f3
| Arranged_6 : Arranged f1 f2 f3 p q f1 f2 f3 p f1 f2 f3 q.
