(** * Neighbours by number

    The four vertices, faces and neighbours of a structured tetrahedron, each
    picked by its place, so that a statement need not be made four times. *)

From Coq Require Import ZArith List.
From Certet Require Import Lattice.Coord3 Lattice.StructuredTet.
Import ListNotations.

Inductive Place := First | Second | Third | Fourth.

Definition VertexAt (t : StructuredTet) (i : Place) : Coord3 :=
  match t with ST v1 v2 v3 v4 _ _ _ _ =>
    match i with
    | First => v1 | Second => v2 | Third => v3 | Fourth => v4
    end
  end.

(** The face across from the vertex at place [i]. *)
Definition FaceAcross (t : StructuredTet) (i : Place) : list Coord3 :=
  match t with ST v1 v2 v3 v4 _ _ _ _ =>
    match i with
    | First => [v2; v3; v4]
    | Second => [v1; v3; v4]
    | Third => [v1; v2; v4]
    | Fourth => [v1; v2; v3]
    end
  end.

(** The neighbour across that face, and the order that lines it up. *)
Definition NeighborAcross (t : StructuredTet) (i : Place)
  : StructuredTetId * VertexOrder :=
  match t with ST _ _ _ _ n1 n2 n3 n4 =>
    match i with
    | First => n1 | Second => n2 | Third => n3 | Fourth => n4
    end
  end.

(** The vertex that [order] puts at place [i]. *)
Definition LinedUpVertexAt (order : VertexOrder) (t : StructuredTet) (i : Place)
  : Coord3 :=
  match t with ST u1 u2 u3 u4 _ _ _ _ =>
    let '(w1, w2, w3, w4) := order u1 u2 u3 u4 in
    match i with
    | First => w1 | Second => w2 | Third => w3 | Fourth => w4
    end
  end.

(** To order the vertices by [o] and the outcome by [o'] changes nothing. *)
Definition Undoes (o' o : VertexOrder) : Prop :=
  forall a b c d : Coord3,
    (let '(a', b', c', d') := o a b c d in o' a' b' c' d') = (a, b, c, d).

(** Identifiers in use have an even reference point.  With an odd one, which
    [GetStructuredTet] takes as well, every tetrahedron has a second name. *)
Definition IsEven (p : Coord3) : Prop :=
  match p with C3 x y z => Z.Even x /\ Z.Even y /\ Z.Even z end.

Definition InLattice (tid : StructuredTetId) : Prop :=
  match tid with STId anchor _ => IsEven anchor end.
