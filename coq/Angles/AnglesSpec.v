(** * What warping may leave behind

    The angle theorems hold for every placement of a structured tetrahedron's
    corners and cuts that is [Admissible]; that [Warp] leaves nothing else
    behind is a theorem of its own.  Signs and positions *before* warping are
    those of the lattice; a placement says where the corners went and where
    the remaining cuts are, all in [Steps]. *)

From Certet Require Import Stuffing.Definitions.
From Certet Require Import Angles.Geometry.
Open Scope Z_scope.

(** The four lattice points of a structured tetrahedron. *)
Definition Corners (tid : StructuredTetId) : list Coord3 :=
  match GetStructuredTet tid with ST v1 v2 v3 v4 _ _ _ _ => [v1; v2; v3; v4] end.

Section Placement.
  (** Signs before warping, what becomes of each vertex, and the cuts. *)
  Variable before : SignField.
  Variable warping : Coord3 -> Warping.
  Variable cut : CutField.

  (** The sign after warping. *)
  Definition PlacedSign (v : MeshVertex) : Sign :=
    match v with
    | Corner c => WarpedSign (before c) (warping c)
    | Cut _ _ => OnSurface
    end.

  (** The position after warping, in steps. *)
  Definition PlacedPosition (v : MeshVertex) : Coord3 :=
    match v with
    | Corner c => WarpedPosition c (warping c)
    | Cut plus minus => PointOnEdge plus minus (cut plus minus)
    end.

  (** The tetrahedra that [GetUnstructuredTets] puts in place of one structured
      tetrahedron, oriented as the product orients them, in steps. *)
  Definition PlacedTets (tid : StructuredTetId)
    : list (UnstructuredTet Coord3) :=
    match tid, GetStructuredTet tid with
    | STId _ case, ST v1 v2 v3 v4 _ _ _ _ =>
        map (MapTet PlacedPosition)
          (map (Orient (CaseHandedness case))
             (GetUnstructuredTets MeshVertex PlacedSign MeshIntersection
                (Corner v1) (Corner v2) (Corner v3) (Corner v4)))
    end.

  (** A corner that moved, moved by at most alpha of its edge.  If that edge
      leads to another corner, the other's sign was opposite, and the other
      has not moved along the same edge. *)
  Definition AdmissibleMoves (th : Thresholds) (corners : list Coord3) : Prop :=
    forall v d t, In v corners -> warping v = Moves d t ->
      0 <= t <= ThresholdSteps th (DirectionKind d) /\
      (In (Translate v (Offset d)) corners ->
         Opposite (before v) (before (Translate v (Offset d))) = true /\
         forall e s, warping (Translate v (Offset d)) = Moves e s ->
           Translate (Translate v (Offset d)) (Offset e) <> v).

  (** A cut that remains lies no nearer than alpha to either end. *)
  Definition AdmissibleCuts (th : Thresholds) (corners : list Coord3) : Prop :=
    forall v d, In v corners -> In (Translate v (Offset d)) corners ->
      PlacedSign (Corner v) = Plus ->
      PlacedSign (Corner (Translate v (Offset d))) = Minus ->
      ThresholdSteps th (DirectionKind d) <= cut v (Translate v (Offset d))
        <= Steps - ThresholdSteps th (DirectionKind d).

  Definition Admissible (th : Thresholds) (corners : list Coord3) : Prop :=
    AdmissibleMoves th corners /\ AdmissibleCuts th corners.
End Placement.

(** ** The product's own placement *)

(** The cut of an edge from + to - lies on the edge. *)
Definition CutsOnEdges (sign : SignField) (cut : CutField) : Prop :=
  forall a b, sign a = Plus -> sign b = Minus -> 0 <= cut a b <= Steps.

(** Thresholds at most one half: no edge is short of both its ends. *)
Definition AtMostHalf (th : Thresholds) : Prop :=
  forall k, 2 * ThresholdSteps th k <= Steps.

(** The tetrahedra of [StuffTet] at their positions, in steps. *)
Definition StuffedTets (th : Thresholds) (sign : SignField) (cut : CutField)
  (tid : StructuredTetId) : list (UnstructuredTet Coord3) :=
  map (MapTet (MeshPosition th sign cut)) (StuffTet th sign cut tid).

(** ** The bounds *)

(** 10.77 and 164.76 degrees: 221/8 is the square of the cotangent of an angle
    a little greater than 10.77 degrees, 1751/130 of one a little greater than
    180 - 164.76. *)
Definition WidestAngles : AngleBounds := AB (CotSq 221 8) (CotSq 1751 130).

(** 9.27 and 161.46 degrees. *)
Definition EmbeddingAngles : AngleBounds := AB (CotSq 563 15) (CotSq 80 9).

(** Exactly 30 and 135 degrees. *)
Definition MidpointAngles : AngleBounds := AB (CotSq 3 1) (CotSq 1 1).

(** Whatever the domain, wherever the cuts: the thresholds guarantee bounds. *)
Definition Guarantees (th : Thresholds) (bounds : AngleBounds) : Prop :=
  forall tid before warping cut,
    Admissible before warping cut th (Corners tid) ->
    forall t, In t (PlacedTets before warping cut tid) -> WellShaped bounds t.

(** The structured tetrahedra themselves, after warping, in their own order. *)
Definition WarpedTet (th : Thresholds) (sign : SignField) (cut : CutField)
  (tid : StructuredTetId) : UnstructuredTet Coord3 :=
  match tid, GetStructuredTet tid with
  | STId _ case, ST v1 v2 v3 v4 _ _ _ _ =>
      MapTet (MeshPosition th sign cut)
        (Orient (CaseHandedness case)
           (UT _ (Corner v1) (Corner v2) (Corner v3) (Corner v4)))
  end.

Definition Positive (t : UnstructuredTet Coord3) : Prop :=
  match t with UT _ a b c d => 0 < SixVolume a b c d end.
