(** * Cuts: where the surface crosses an edge

    Every edge is divided in [Steps] equal steps, and a cut is a whole number
    of steps counted from the inner (+) end.  [StepBits] stands here and nowhere
    else. *)

From Certet Require Import Stencil.Definitions.
Open Scope Z_scope.

Definition StepBits : nat := 16.
Definition Steps : Z := 2 ^ Z.of_nat StepBits.

(** [BisectFrom sign rounds lo] looks for the surface in the [2^rounds] steps
    that follow [lo], whose sign is not -.  [sign t] is the domain's sign at
    [t] steps from the inner end.  The answer is the last step known to be
    inside, or a step found to lie on the surface. *)
Fixpoint BisectFrom (sign : Z -> Sign) (rounds : nat) (lo : Z) : Z :=
  match rounds with
  | O => lo
  | S r =>
      let middle := lo + 2 ^ Z.of_nat r in
      match sign middle with
      | Plus => BisectFrom sign r middle
      | OnSurface => middle
      | Minus => BisectFrom sign r lo
      end
  end.

(** The cut of an edge from a + end (0 steps) to a - end ([Steps] steps). *)
Definition Bisect (sign : Z -> Sign) : Z := BisectFrom sign StepBits 0.

(** The cut that label images ask for.  It tells nothing of a surface, so a
    domain that is cut so is either in or out: what lies on its surface counts
    as inside. *)
Definition MidpointCut : Z := Steps / 2.

Definition InOrOut (s : Sign) : Sign :=
  match s with Minus => Minus | _ => Plus end.

(** Positions of the output are in steps: lattice coordinates times [Steps].
    [PointOnEdge a b t] lies [t] steps from [a] on the edge from [a] to [b]. *)
Definition PointOnEdge (a b : Coord3) (t : Z) : Coord3 :=
  Translate (Scale Steps a) (Scale t (Difference a b)).
