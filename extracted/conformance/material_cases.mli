(** Whole meshes of several materials. *)

val all : unit -> Json.t list
