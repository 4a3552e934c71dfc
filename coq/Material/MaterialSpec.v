(** * What is meant by a mesh of materials that fits, fills, and is well shaped *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Material.MaterialTet Material.MaterialMesh.
Open Scope Z_scope.

(** ** One material and the outside *)

Definition OneMaterial (m : Material) (s : Sign) : option Material :=
  match s with Plus => Some m | OnSurface => None | Minus => Some Outside end.

(** ** Volumes *)

Definition TotalSixVolume (tets : list (Material * UnstructuredTet Coord3)) : Z :=
  fold_right (fun t sum => SixVolumeOf (snd t) + sum) 0 tets.

(** ** Admissible placements *)

Section Placement.
  Variable before : MaterialField.
  Variable warping : Coord3 -> Warping.
  Variable cut : CutField.

  (** A corner that moved, moved by at most alpha of its edge; and if that edge
      leads to another corner, the other has not moved along the same edge.
      Nothing is asked of the materials: a corner may move towards one of a
      third material. *)
  Definition AdmissibleMaterialMoves (th : Thresholds) (corners : list Coord3)
    : Prop :=
    forall v d t, In v corners -> warping v = Moves d t ->
      0 <= t <= ThresholdSteps th (DirectionKind d) /\
      (In (Translate v (Offset d)) corners ->
         forall e s, warping (Translate v (Offset d)) = Moves e s ->
           Translate (Translate v (Offset d)) (Offset e) <> v).

  (** A cut that remains, from a higher to a lower material, lies no nearer than
      alpha to either end. *)
  Definition AdmissibleMaterialCuts (th : Thresholds) (corners : list Coord3)
    : Prop :=
    forall v d m n, In v corners -> In (Translate v (Offset d)) corners ->
      PlacedMaterial before warping v = Some m ->
      PlacedMaterial before warping (Translate v (Offset d)) = Some n ->
      n < m ->
      ThresholdSteps th (DirectionKind d) <= cut v (Translate v (Offset d))
        <= Steps - ThresholdSteps th (DirectionKind d).

  Definition AdmissibleMaterials (th : Thresholds) (corners : list Coord3)
    : Prop :=
    AdmissibleMaterialMoves th corners /\ AdmissibleMaterialCuts th corners.

  (** A structured tetrahedron with all its corners on interfaces is kept whole;
      moves alone do not make it well shaped. *)
  Definition InterfacesAlone (tid : StructuredTetId) : Prop :=
    forall v, In v (Corners tid) -> PlacedMaterial before warping v = None.
End Placement.

(** The cut of an edge from a higher to a lower material lies on the edge. *)
Definition MaterialCutsOnEdges (material : MaterialField) (cut : CutField)
  : Prop :=
  forall a b m n, material a = Some m -> material b = Some n -> n < m ->
    0 <= cut a b <= Steps.

(** Whatever the materials, wherever the cuts: every tetrahedron is within the
    bounds, if those kept whole are. *)
Definition GuaranteesMaterials (th : Thresholds) (bounds : AngleBounds) : Prop :=
  forall before warping cut shared tid,
    AdmissibleMaterials before warping cut th (Corners tid) ->
    (InterfacesAlone before warping tid ->
       WellShaped bounds (PlacedWhole warping cut tid)) ->
    forall m t, In (m, t) (PlacedMaterialTets before warping cut shared tid) ->
      WellShaped bounds t.
