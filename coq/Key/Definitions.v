(** * What [Key/] defines: diagonals that follow the cuts *)

From Certet Require Export Embedding.Definitions.
From Certet Require Export Lattice.EdgeRank Key.KeyTet Key.FaceRule Key.KeyStuffing
  Key.KeySpec.
