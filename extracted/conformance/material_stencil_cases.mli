(** The 52 patterns of materials, with what the certified functions say of them. *)

val all : unit -> Json.t list
