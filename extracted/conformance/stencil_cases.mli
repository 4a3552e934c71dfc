(** The 81 sign patterns, the sign of corner 1 running fastest: - 0 +, with what the certified functions say of
    them. *)

val all : unit -> Json.t list
