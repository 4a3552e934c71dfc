(** * What [Stencil/] defines: the stencils, what compatible means, triangles *)

From Certet Require Export Lattice.Definitions.
From Certet Require Export Stencil.UnstructuredTet Stencil.StencilSet
  Stencil.CompatibilitySpec Stencil.TriangleSpec.
