(** * What [Material/] defines: the stencils of several materials *)

From Certet Require Export Embedding.Definitions.
From Certet Require Export Material.MaterialTet Material.MaterialMesh
  Material.MaterialSpec.
