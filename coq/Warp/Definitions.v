(** * What [Warp/] defines: cuts, and which vertex moves where *)

From Certet Require Export Stencil.Definitions.
From Certet Require Export Warp.Cut Warp.Warp Warp.WarpSpec.
