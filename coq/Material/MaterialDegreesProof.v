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
Proof.
  intros before warping cut shared tid m t A W I.
  exact (WidestInDegrees t
           (MaterialDihedralBounds before warping cut shared tid A W m t I)).
Qed.

Theorem SettledMaterialBoundsInDegrees :
  EachSettledTet (WithinDegrees (1077 / 100) (16476 / 100)).
Proof.
  intros material cut turns tid m t C E N I.
  exact (WidestInDegrees t
           (SettledMaterialBounds material cut turns tid m t C E N I)).
Qed.

Theorem DemotedBoundsInDegrees :
  EachDemotedTet (WithinDegrees (1077 / 100) (16476 / 100)).
Proof.
  intros material cut shared tid m t C E N I.
  exact (WidestInDegrees t
           (DemotedBounds material cut shared tid m t C E N I)).
Qed.

Theorem MaterialMidpointBoundsInDegrees :
  forall (material : Coord3 -> Material) shared tid m t,
    In (m, t) (PlacedMaterialTets (fun v => Some (material v)) (fun _ => Stays)
                 MidpointCuts shared tid) ->
    WithinDegrees 30 135 t.
Proof.
  intros material shared tid m t I.
  exact (MidpointInDegrees t (MaterialMidpointBounds material shared tid m t I)).
Qed.
