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

val sampled :
  (Convert.point -> Certified.sign) -> (Certified.coord3 -> Certified.coord3 -> int) -> Domain.t
(** Signs by a function of the lattice point; cuts by one of both ends. *)

val any_of : int list -> int -> Certified.coord3 -> Certified.coord3 -> int
(** One of a list, by chance: by a seed and both ends of an edge. *)

val by_angles : t list
(** Those whose edges are not cut in the middle, and that ask for [Angles]. *)
