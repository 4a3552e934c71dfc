(** * Domains, and the two ways in which they are cut

    A domain that is cut by bisection is known by its sign at every position,
    in steps.  One that is cut in the middle is known at the lattice points
    alone, and its surface counts as inside. *)

From Certet Require Import Warp.Definitions.
From Certet Require Import Stuffing.Stuffing.

Definition PositionSigns : Type := Coord3 -> Sign.

(** What the mesher sees of it: the signs of the lattice points, *)
Definition SampledSigns (domain : PositionSigns) : SignField :=
  fun v => domain (Scale Steps v).

(** and for each edge from a + point to a - point its cut.  Which points these
    are need not be the domain's word: the mesher takes the outermost points of
    its lattice as outside, whatever the domain says. *)
Definition BisectedCuts (domain : PositionSigns) : CutField :=
  fun plus minus => Bisect (fun t => domain (PointOnEdge plus minus t)).

Definition MidpointCuts : CutField := fun _ _ => MidpointCut.

(** Every lattice point in or out. *)
Definition Decided (sign : SignField) : SignField := fun v => InOrOut (sign v).
