(** * What [Topology/] defines: the surface, the two sides, label images *)

From Certet Require Export Embedding.Definitions.
From Certet Require Export Topology.SurfaceSpec Topology.TwoSidesSpec
  Topology.VoxelSpec.
