(** Solids given by a formula, in lattice units. *)

type t

exception Unknown of string

val parse : string -> t
(** One of
    - [sphere X Y Z R]
    - [torus X Y Z R r]: axis along z, [R] from the centre to the tube's
    - [box X0 Y0 Z0 X1 Y1 Z1]

    Raises {!Unknown} with one sentence. *)

val position_sign : t -> Certified.coord3 -> Certified.sign
(** The sign at a position in steps. *)
