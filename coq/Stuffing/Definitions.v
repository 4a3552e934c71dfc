(** * What [Stuffing/] defines: the mesher, the domain, the mesh *)

From Certet Require Export Warp.Definitions.
From Certet Require Export Stuffing.Stuffing Stuffing.Domain Stuffing.MeshSpec.
