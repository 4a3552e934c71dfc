(** * What [Warp] promises

    A vertex stays only if nothing violates it, and moves only to a violating
    cut that no other violating cut is nearer than.  Section 2 of Labelle and
    Shewchuk's algorithm, as the paper uses it. *)

From Coq Require Import ZArith.
From Certet Require Import Lattice.Direction Stencil.UnstructuredTet.
From Certet Require Import Warp.Warp.
Open Scope Z_scope.

Definition WarpCorrect (th : Thresholds) (sign : Sign)
  (neighbor_sign : Direction -> Sign) (cut : Direction -> Z) : Prop :=
  match Warp th sign neighbor_sign cut with
  | Stays => forall d, Violates th sign neighbor_sign cut d = false
  | Moves d t =>
      t = cut d /\ Violates th sign neighbor_sign cut d = true /\
      forall e, Violates th sign neighbor_sign cut e = true ->
        CutDistanceSquared cut d <= CutDistanceSquared cut e
  end.
