(** One vertex with its fourteen edges, with what the certified functions say of
    them. *)

val all : unit -> Json.t list
