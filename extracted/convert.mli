(** The one place where the certificate's unbounded integers meet the machine's.

    An integer that does not fit in OCaml's 63 bits is an error; it is never
    truncated. *)

exception Overflow

val int_of_z : Certified.z -> int
(** Raises {!Overflow} outside [[min_int, max_int]]. *)

val z_of_int : int -> Certified.z

val int_of_nat : Certified.nat -> int

type point = { x : int; y : int; z : int }
(** A [coord3] in machine integers, in whatever unit it was. *)

val point_of_coord3 : Certified.coord3 -> point
(** Raises {!Overflow}. *)

val coord3_of_point : point -> Certified.coord3
