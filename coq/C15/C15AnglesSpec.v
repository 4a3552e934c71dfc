(** * What warping may leave behind in C15, and the bounds

    As in [AnglesSpec], with an edge's direction told by the offset to its other end
    and thresholds by the metals of both. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import C15.Sites C15.C15Tet C15.C15Stuffing.
Open Scope Z_scope.

Section Placement.
  Variable before : SignField.
  Variable warping : Coord3 -> C15Warping.
  Variable cut : CutField.

  (** A corner that moved, moved by at most alpha of its edge.  If that edge leads to
      another corner, the other's sign was opposite, and the other has not moved along
      the same edge. *)
  Definition C15AdmissibleMoves (th : C15Thresholds) (corners : list Coord3) : Prop :=
    forall v o t, In v corners -> warping v = Moved o t ->
      let u := Translate v o in
      In o (OffsetsAround v) /\
      0 <= t <= EdgeThreshold th v u /\
      (In u corners ->
         Opposite (before v) (before u) = true /\
         forall e s, warping u = Moved e s -> Translate u e <> v).

  (** A cut that remains lies no nearer than alpha to either end. *)
  Definition C15AdmissibleCuts (th : C15Thresholds) (corners : list Coord3) : Prop :=
    forall v u, In v corners -> In u corners ->
      C15After before warping v = Plus -> C15After before warping u = Minus ->
      EdgeThreshold th v u <= cut v u <= Steps - EdgeThreshold th u v.

  Definition C15Admissible (th : C15Thresholds) (corners : list Coord3) : Prop :=
    C15AdmissibleMoves th corners /\ C15AdmissibleCuts th corners.
End Placement.

(** 14.40 and 149.32 degrees. *)
Definition C15KeyAngles : AngleBounds := AB (CotSq 91 6) (CotSq 71 25).

(** Whatever the domain, wherever the cuts: the thresholds guarantee bounds. *)
Definition C15Guarantees (th : C15Thresholds) (bounds : AngleBounds) : Prop :=
  forall tid before warping cut,
    C15Admissible before warping cut th (C15Corners tid) ->
    forall t, In t (C15Tets before warping cut tid) -> WellShaped bounds t.
