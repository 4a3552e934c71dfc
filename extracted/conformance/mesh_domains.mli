(** The domains whose whole meshes are in the kit. *)

type t = {
  name : string;
  lattice : Lattice.t;
  cuts : cuts;
  guarantee : guarantee;  (** what is asked for *)
  domain : Domain.t;
}

and cuts = Explicit | Midpoint
and guarantee = Angles | Embedding

val all : t list

val lattice : int -> int -> int -> int -> int -> int -> Lattice.t
val beside_thresholds : int list

val by_angles : t list
(** Those whose edges are not cut in the middle, and that ask for [Angles]. *)
