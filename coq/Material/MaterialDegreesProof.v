(** * The angles of several materials, in degrees *)

From Coq Require Import Reals.
From Certet Require Import Material.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.Degrees.DegreesProof
  Material.Demotion Material.MaterialBoundsProof Material.MaterialWarpProof
  Material.SettleMaterials Material.SettleMaterialsProof.

Theorem MaterialDihedralBoundsInDegrees : forall before warping cut shared tid m t,
  AdmissibleMaterials before warping cut AngleThresholds (Corners tid) ->
  (InterfacesAlone before warping tid ->
     WellShaped WidestAngles (PlacedWhole warping cut tid)) ->
  In (m, t) (PlacedMaterialTets before warping cut shared tid) ->
  WithinDegrees (1077 / 100) (16476 / 100) t.
Proof. in_degrees WidestInDegrees MaterialDihedralBounds. Qed.

Theorem SettledMaterialBoundsInDegrees :
  EachSettledTet (WithinDegrees (1077 / 100) (16476 / 100)).
Proof. in_degrees WidestInDegrees SettledMaterialBounds. Qed.

Theorem DemotedBoundsInDegrees :
  EachDemotedTet (WithinDegrees (1077 / 100) (16476 / 100)).
Proof. in_degrees WidestInDegrees DemotedBounds. Qed.

Theorem MaterialMidpointBoundsInDegrees :
  forall (material : Coord3 -> Material) shared tid m t,
    In (m, t) (PlacedMaterialTets (fun v => Some (material v)) (fun _ => Stays)
                 MidpointCuts shared tid) ->
    WithinDegrees 30 135 t.
Proof. in_degrees MidpointInDegrees MaterialMidpointBounds. Qed.
