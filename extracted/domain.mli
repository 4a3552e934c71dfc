(** A domain as the certified functions see it: the sign of every lattice
    vertex, and the cut of every edge from a + vertex to a - vertex. *)

type t = { sign : Certified.signField; cut : Certified.cutField }

val bisected : (Certified.coord3 -> Certified.sign) -> Certified.cutField
(** The certificate's [BisectedCuts], given the sign at any position in steps. *)

val midpoint : t -> t
(** The domain with every edge cut in the middle, and its surface inside. *)

val of_position_sign : (Certified.coord3 -> Certified.sign) -> t
(** A domain known by its sign at any position in steps. *)

val within : Lattice.t -> t -> t
(** The domain with everything outside but the inner points of the lattice, and
    with every answer remembered, so that each is asked for once. *)
