(** * What [Embedding/] defines: the whole mesh, who stays, pieces *)

From Certet Require Export Angles.Definitions.
From Certet Require Export Embedding.EmbeddingSpec Embedding.WarpOrClamp
  Embedding.PiecesSpec Embedding.DiskRule Embedding.Settle Embedding.SettleSpec.
