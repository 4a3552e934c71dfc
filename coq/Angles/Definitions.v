(** * What [Angles/] defines: angles as inequalities between integers, what
      warping may leave behind *)

From Certet Require Export Stuffing.Definitions.
From Certet Require Export Angles.Geometry Angles.AnglesSpec.
