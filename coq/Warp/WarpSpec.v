(** * Which cut [Warp] chooses

    Of the violating cuts the nearest, and of those equally near the first.
    Section 2 of Labelle and Shewchuk's algorithm, as the paper uses it; the
    order is this product's own. *)

From Certet Require Import Lattice.Definitions.
From Certet Require Import Warp.Warp.
Open Scope Z_scope.

(** Among the directions of a list that violate, [d] is the first of the
    nearest: those before it are farther, those after it no nearer. *)
Definition FirstNearest (violates : Direction -> bool) (cut : Direction -> Z)
  (directions : list Direction) (d : Direction) : Prop :=
  exists earlier later, directions = (earlier ++ d :: later)%list /\
    (forall e, In e earlier -> violates e = true ->
       CutDistanceSquared cut d < CutDistanceSquared cut e) /\
    (forall e, In e later -> violates e = true ->
       CutDistanceSquared cut d <= CutDistanceSquared cut e).
