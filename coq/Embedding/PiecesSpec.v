(** * Pieces

    Two points are of one piece if they are joined by steps inside: lattice
    points with the sign + by edges of the lattice, tetrahedra of the mesh by
    common faces. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Embedding.EmbeddingSpec.

(** Joined by steps, all of them inside. *)
Inductive Joined {V : Type} (inside : V -> Prop) (next : V -> V -> Prop)
  : V -> V -> Prop :=
| Joined_here : forall v, inside v -> Joined inside next v v
| Joined_step : forall u v w,
    Joined inside next u v -> next v w -> inside w -> Joined inside next u w.

(** ** A vertex leaves *)

(** The points [inside] are those of [now] but for [v], which has a neighbour
    among them; and its neighbours among them are joined to each other by steps
    between such neighbours. *)
Definition Leaves {V : Type} (next : V -> V -> Prop) (v : V)
  (inside now : V -> Prop) : Prop :=
  inside v /\ ~ now v /\ (forall u, u <> v -> (now u <-> inside u)) /\
  (exists u, next v u /\ now u) /\
  (forall u w, next v u -> next v w -> now u -> now w ->
     Joined (fun x => now x /\ next v x) next u w).

(** One after the other, the last first. *)
Inductive AllLeave {V : Type} (next : V -> V -> Prop)
  : (V -> Prop) -> (V -> Prop) -> Prop :=
| AllLeave_none : forall inside now,
    (forall u, now u <-> inside u) -> AllLeave next inside now
| AllLeave_one : forall v inside then_ now,
    AllLeave next inside then_ -> Leaves next v then_ now ->
    AllLeave next inside now.

(** ** The lattice and the mesh *)

Definition Adjacent (u v : Coord3) : Prop :=
  exists d, v = Translate u (Offset d).

Definition ShareFace (t u : UnstructuredTet MeshVertex) : Prop :=
  exists a b c, HasTriangle t a b c /\ HasTriangle u a b c.

Section Mesh.
  Variables (before : SignField) (warping : Coord3 -> Warping).

  Definition PlusBefore (c : Coord3) : Prop := before c = Plus.
  Definition PlusAfter (c : Coord3) : Prop :=
    PlacedSign before warping (Corner c) = Plus.

  Definition InMesh (t : UnstructuredTet MeshVertex) : Prop :=
    exists tid, InLattice tid /\ In t (PlacedNames before warping tid).

  (** [t] is made in a structured tetrahedron that has [c] as a corner. *)
  Definition MadeAt (c : Coord3) (t : UnstructuredTet MeshVertex) : Prop :=
    exists tid, InLattice tid /\ In c (Corners tid) /\
      In t (PlacedNames before warping tid).

  (** No face of the lattice whose corners are all on the surface has + on both
      sides. *)
  Definition NoWall : Prop :=
    forall a b c p q,
      a <> b -> b <> c -> a <> c ->
      (forall v, In v [a; b; c] ->
         PlacedSign before warping (Corner v) = OnSurface) ->
      PlusAfter p -> PlusAfter q ->
      (exists tid, InLattice tid /\ incl [a; b; c; p] (Corners tid)) ->
      (exists tid, InLattice tid /\ incl [a; b; c; q] (Corners tid)) ->
      p = q.
End Mesh.
