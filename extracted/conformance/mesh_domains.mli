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
