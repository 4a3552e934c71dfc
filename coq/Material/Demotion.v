(** * Who stays, where all corners of a tetrahedron come to lie on interfaces

    Of one material and the outside such a tetrahedron is left out; of several
    it has to be kept, and moves alone do not make it well shaped.  So it is
    tested, unless it counts as outside, and if it fails, the corner that moves
    farthest for its edge stays where it is; all at once, for nobody who stays
    spoils another: one that is kept whole has four corners that did move, or had
    no material, and was tested as it is.  Cuts are kept alpha away from both
    ends of their edges. *)

From Certet Require Import Material.Definitions.
From Certet Require Import Material.MaterialShape.
Open Scope Z_scope.

Section Demotion.
  Variables (bounds : AngleBounds) (th : Thresholds).
  Variables (material : MaterialField) (cut : CutField).
  (** The material of a tetrahedron with all corners on interfaces. *)
  Variable shared : StructuredTetId -> Material.

  (** Everyone who is violated moves. *)
  Definition FullWarping (v : Coord3) : Warping :=
    WarpMaterialVertex th material cut v.

  Definition OnInterfaces (tid : StructuredTetId) : bool :=
    forallb (fun v =>
      match PlacedMaterial material FullWarping v with
      | None => true
      | Some _ => false
      end) (Corners tid).

  Definition Spoiled (tid : StructuredTetId) : bool :=
    if shared tid =? Outside then false
    else if OnInterfaces tid
    then negb (IsWellShaped bounds (PlacedWhole FullWarping cut tid)) else false.

  (** Who moves by more alphas of the edge; the first, of two that move equally
      far. *)
  Definition FartherOf (best : option Coord3) (v : Coord3) : option Coord3 :=
    match FullWarping v with
    | Stays => best
    | Moves d t =>
        match best with
        | None => Some v
        | Some u =>
            match FullWarping u with
            | Stays => Some v
            | Moves e s =>
                if s * ThresholdSteps th (DirectionKind d)
                   <? t * ThresholdSteps th (DirectionKind e)
                then Some v else best
            end
        end
    end.

  Definition Farthest (tid : StructuredTetId) : option Coord3 :=
    fold_left FartherOf (Corners tid) None.

  Definition Demoted (v : Coord3) : bool :=
    existsb (fun tid =>
      if Spoiled tid
      then match Farthest tid with
           | Some u => Coord3Equal u v
           | None => false
           end
      else false) (TetsAround v).

  Definition DemotedWarping : Coord3 -> Warping :=
    RuledMaterialWarping th material cut Demoted (fun _ => Steps).

  (** The tetrahedra of all materials in one structured tetrahedron, in steps. *)
  Definition DemotedTets (tid : StructuredTetId)
    : list (Material * UnstructuredTet Coord3) :=
    PlacedMaterialTets material DemotedWarping (ClampedCut th cut) shared tid.
End Demotion.
