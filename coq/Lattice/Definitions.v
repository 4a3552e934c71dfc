(** * What [Lattice/] defines: points, directions, the structured tetrahedra and
      their face neighbours *)

From Coq Require Export ZArith List Bool Lia.
Export ListNotations.
From Certet Require Export Lattice.Coord3 Lattice.Direction
  Lattice.StructuredTet Lattice.StructuredTetSpec Lattice.NeighborSpec.
