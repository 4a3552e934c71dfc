(** The signs along one edge, with what the certified functions say of
    them. *)

val all : unit -> Json.t list
