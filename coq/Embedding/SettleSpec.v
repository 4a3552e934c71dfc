(** * Vertices become 0 one at a time

    What the rule of the strict disk comes to, whatever the order, and whoever
    chooses the vertices: signs that follow from those of the samples by such
    steps.  Where the vertices then lie does not matter here. *)

From Certet Require Import Stuffing.Definitions.
From Certet Require Import Embedding.PiecesSpec Embedding.DiskRule.

(** ** What a strict disk is *)

(** The signs around [v]. *)
Definition LinkOf (now : SignField) (v : Coord3) : Direction -> Sign :=
  fun d => now (Translate v (Offset d)).

(** Lattice points that are joined to each other by edges, if there are any. *)
Definition Hangs (inside : Coord3 -> Prop) : Prop :=
  forall u w, inside u -> inside w -> Joined inside Adjacent u w.

Section Around.
  Variables (now : SignField) (v : Coord3).

  (** Around the edge from [v] to [z] the + are in one run or none, and not
      everything. *)
  Definition RunAround (z : Coord3) : Prop :=
    (exists x, now x <> Plus /\ Adjacent v x /\ Adjacent z x) /\
    Hangs (fun x => now x = Plus /\ Adjacent v x /\ Adjacent z x).

  (** On the sphere of the neighbours of [v]: the + are in one piece, and the
      others too; around each 0 the + are one run or none; and no edge from 0 to 0
      has + on both sides. *)
  Definition DiskAround : Prop :=
    (exists x, now x = Plus /\ Adjacent v x) /\
    Hangs (fun x => now x = Plus /\ Adjacent v x) /\
    (exists x, now x <> Plus /\ Adjacent v x) /\
    Hangs (fun x => now x <> Plus /\ Adjacent v x) /\
    (forall z, now z = OnSurface -> Adjacent v z -> RunAround z) /\
    (forall y z p q,
       now y = OnSurface -> now z = OnSurface -> now p = Plus -> now q = Plus ->
       Adjacent v y -> Adjacent v z -> Adjacent y z ->
       Adjacent v p -> Adjacent y p -> Adjacent z p ->
       Adjacent v q -> Adjacent y q -> Adjacent z q -> p = q).
End Around.

(** ** Steps *)

(** Each when its link is a strict disk, the last one last. *)
Inductive ByDisks (sign : SignField) : SignField -> Prop :=
| ByDisks_none : forall now, (forall u, now u = sign u) -> ByDisks sign now
| ByDisks_one : forall v before now,
    ByDisks sign before -> StrictDisk (LinkOf before v) = true ->
    now v = OnSurface -> (forall u, u <> v -> now u = before u) ->
    ByDisks sign now.

(** Every vertex that is 0 and has an inner neighbour has a strict disk around
    it. *)
Definition DisksAround (now : SignField) : Prop :=
  forall z, now z = OnSurface ->
    (exists d, now (Translate z (Offset d)) = Plus) ->
    StrictDisk (LinkOf now z) = true.
