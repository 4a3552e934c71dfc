(** * Vertices become 0 one at a time

    What the rule of the strict disk comes to, whatever the order, and whoever
    chooses the vertices: signs that follow from those of the samples by such
    steps.  Where the vertices then lie does not matter here. *)

From Coq Require Import ZArith.
From Certet Require Import Lattice.Coord3 Lattice.Direction.
From Certet Require Import Stencil.UnstructuredTet.
From Certet Require Import Stuffing.Stuffing.
From Certet Require Import Embedding.DiskRule.

(** The signs around [v]. *)
Definition LinkOf (now : SignField) (v : Coord3) : Direction -> Sign :=
  fun d => now (Translate v (Offset d)).

(** Each when its link is a strict disk, the last one last. *)
Inductive ByDisks (sign : SignField) : SignField -> Prop :=
| ByDisks_none : forall now, (forall u, now u = sign u) -> ByDisks sign now
| ByDisks_one : forall v before now,
    ByDisks sign before -> StrictDisk (LinkOf before v) = true ->
    now v = OnSurface -> (forall u, u <> v -> now u = before u) ->
    ByDisks sign now.

(** Every vertex that is 0 has a strict disk around it, or nothing inside. *)
Definition DisksAround (now : SignField) : Prop :=
  forall v, now v = OnSurface ->
    StrictDisk (LinkOf now v) = true \/ forall d, LinkOf now v d <> Plus.
