(** A domain as the certified functions see it: the sign of every lattice
    vertex, and the cut of every edge from a + vertex to a - vertex. *)

type t = { sign : Certified.signField; cut : Certified.cutField }

val midpoint : t -> t
(** The domain with every edge cut in the middle, and its surface inside: the
    certificate's [Decided] and [MidpointCuts]. *)

val of_position_sign : Certified.positionSigns -> t
(** A domain known by its sign at any position in steps: the certificate's
    [SampledSigns] and [BisectedCuts]. *)

val within : Lattice.t -> t -> t
(** The domain with everything outside but the inner points of the lattice, and
    with every answer remembered, so that each is asked for once. *)

val remembered : ('key, 'answer) Hashtbl.t -> 'key -> (unit -> 'answer) -> 'answer
(** The answer in the table, or one that is computed and put there. *)
