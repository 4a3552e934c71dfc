(** * The mesh with diagonals by key *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Mesh.Method Key.KeyStuffing.

(** That of any warp and any cuts. *)
Definition KeyMesh (before : SignField) (warping : Coord3 -> Warping)
  (cut : CutField) : Mesh :=
  MakeMesh (KeyNames before warping cut) (PlacedSign before warping)
           (PlacedPosition warping cut).

(** That of one sweep in the order of a list: the product's rule of who stays, at
    the thresholds of this order. *)
Definition KeySweptMesh (sign : SignField) (cut : CutField) (turns : list Coord3)
  : Mesh :=
  KeyMesh sign (PlaceIn (Settle KeyThresholds sign cut LevelGap turns))
          (ClampedCut KeyThresholds cut).
