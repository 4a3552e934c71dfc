(** * Extraction: the executable functions as OCaml

    What the theorems of [Certificate] speak of is what is extracted here, with
    nothing in between.  Integers stay the inductive [Z] of the proofs, which
    cannot overflow; only booleans, lists, pairs and options become OCaml's own.

    [make extract] runs this file and writes the result to [extracted/]. *)

From Coq Require Import Extraction ExtrOcamlBasic.
From Certet Require Import Topology.Definitions Material.Definitions.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet
  Grading.Surface.
From Certet Require Import Key.KeyTet Key.KeyStuffing Key.FaceRule.
From Certet Require Import Embedding.DiskTables Material.MaterialShape
  Material.SettleMaterials.

Extraction Language OCaml.

Extraction "certified.ml"
  (* the lattice *)
  Translate Scale Difference Coord3Equal
  AllDirections Offset DirectionKind LengthSquared
  AllCases CaseHandedness GetStructuredTet
  (* the stencils *)
  GetUnstructuredTets
  (* cuts *)
  StepBits Steps Bisect MidpointCut InOrOut PointOnEdge
  (* warping *)
  AngleThresholds EmbeddingThresholds NoWarpThresholds ThresholdSteps
  Warp.Warp.Warp WarpedSign WarpedPosition
  (* the whole of it *)
  MeshVertexSign MeshIntersection MeshPosition Orient WarpVertex StuffTet
  (* domains *)
  SampledSigns BisectedCuts MidpointCuts Decided
  (* the warp that keeps the shape *)
  Gather At InOnePiece TwoPieces Pinched Walls DiskOf IsDisk
  OpenSigns OpenCuts Turn Turns InTurn LevelGap StrictGap
  Embedding.Settle.Settle PlaceIn ClampedCut SettledTets SettledMesh
  PlacedNames PlacedPosition
  (* the samples of a label image *)
  CubeParted VoxelSigns
  (* several materials *)
  Outside GetMaterialTets WarpMaterialVertex PlacedMaterial PlacedMaterialTets
  WidestAngles IsWellShaped AreDisks FillsWouldTouch MaterialsInTurn
  Material.SettleMaterials.SettleMaterials SettledMaterialTets
  (* diagonals by key *)
  KeyThresholds Lattice.EdgeRank.EdgeRank CutKey MeshKey GetKeyTets KeyNames KeyTets KeyStuffTet
  FaceTriangles
  (* graded interiors *)
  IsNearSurface OctreeAround GradedOctree HalfSide CentreInHalfSides
  PointSeen CellSeen ChildSeen OtherCorner OtherEdge OtherFace OtherCell
  IsPresent KindAt NamingFlag TetOfFlag FlagsOf
  GradedVertices GradedHandedness GetGradedTet GradedNeighbor
  StructuredName GradedTetsWithin.
