(** * What [Grading/] defines: octrees, flags, their tetrahedra, where a mesh may
      be graded *)

From Certet Require Export Embedding.Definitions.
From Certet Require Export Grading.Octree Grading.Flag Grading.GradedTet
  Grading.Surface Grading.GradingSpec.
