(** * The warp with a rule of who stays

    A violated vertex may as well stay where it is, if the cuts around it are
    then kept alpha away from both ends of their edges; and one that moves may
    stop short of its cut.  Any vertex may, whatever its neighbours do, so that
    the rule is free to look after other things than angles: that the mesh does
    not fold, and that the shape stays in one piece. *)

From Certet Require Import Angles.Definitions.
Open Scope Z_scope.

(** The kind of the edge from [a] to [b]. *)
Definition KindBetween (a b : Coord3) : EdgeKind :=
  match Difference a b with C3 x _ _ => if Z.even x then Long else Short end.

Section WarpOrClamp.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).

  (** The rule: who stays though violated, and how far the others move at
      most. *)
  Variables (stays : Coord3 -> bool) (limit : Coord3 -> Z).

  (** The target is that of the paper's rule, chosen once. *)
  Definition RuledWarping (v : Coord3) : Warping :=
    match WarpVertex th sign cut v with
    | Stays => Stays
    | Moves d t =>
        if stays v then Stays else Moves d (Z.max 0 (Z.min t (limit v)))
    end.

  (** No nearer than alpha to either end. *)
  Definition ClampedCut (a b : Coord3) : Z :=
    let alpha := ThresholdSteps th (KindBetween a b) in
    Z.max alpha (Z.min (Steps - alpha) (cut a b)).

  (** The tetrahedra in steps. *)
  Definition WarpOrClamp (tid : StructuredTetId)
    : list (UnstructuredTet Coord3) :=
    PlacedTets sign RuledWarping ClampedCut tid.
End WarpOrClamp.

(** ** Limits under which nothing is crossed *)

Section Limit.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).

  (** Targets [e] from [v] and [e'] from its neighbour in direction [d] lie
      beyond each other: both are long, parallel, towards each other, and half
      an edge or more together. *)
  Definition Crosses (d e : Direction) (t : Z) (other : Warping) : bool :=
    match DirectionKind d, DirectionKind e, other with
    | Short, Long, Moves e' t' =>
        Coord3Equal (Translate (Offset e) (Offset e')) (C3 0 0 0) &&
        (0 <? Dot (Offset d) (Offset e)) && (Steps <=? 2 * (t + t'))
    | _, _, _ => false
    end.

  Definition CrossedAt (v : Coord3) : bool :=
    match WarpVertex th sign cut v with
    | Stays => false
    | Moves e t =>
        existsb (fun d =>
          Crosses d e t (WarpVertex th sign cut (Translate v (Offset d))))
          AllDirections
    end.

  (** Each of two such vertices goes no farther than [stop]. *)
  Definition StopIfCrossed (stop : Z) (v : Coord3) : Z :=
    if CrossedAt v then stop else Steps.
End Limit.

(** A quarter of an edge: two that stop there come level, so that a wall halfway
    between lattice planes comes out flat. *)
Definition Quarter : Z := Steps / 4.
