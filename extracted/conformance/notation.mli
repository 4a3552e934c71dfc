(** How the kit writes down what the certificate speaks of. *)

open Certified

val point : Convert.point -> Json.t
val coord3 : coord3 -> Json.t
val sign : sign -> Json.t

val signs : sign list -> Json.t
(** One character each. *)

val direction : direction -> int
(** Its number. *)

val case : structuredTetCase -> Json.t

val all_signs : sign list

val thresholds : (string * thresholds) list
(** Each pair by the name that the kit has for it. *)

val steps : int
val threshold_steps : thresholds -> edgeKind -> int
