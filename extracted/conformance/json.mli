(** As much of JSON as the kit needs. *)

type t =
  | Int of int
  | Bool of bool
  | Text of string  (** UTF-8 *)
  | List of t list
  | Object of (string * t) list

val print_document : out_channel -> (string * t) list -> unit
(** An object; where a member is a list, each of its elements has a line. *)
