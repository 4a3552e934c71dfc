(** A domain of several materials as the certified functions see it: the material of
    every lattice vertex, 0 for the outside, and the cut of every edge from a higher
    material to a lower one. *)

type t = { material : Certified.coord3 -> Certified.material; cut : Certified.cutField }

val within : Lattice.t -> t -> t
(** The same with everything outside but the inner points of the lattice, and with
    every answer remembered: see {!Domain.within}. *)

val midpoint : t -> t
(** The same with every edge cut in the middle: the certificate's [MidpointCuts]. *)
