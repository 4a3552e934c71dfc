(** Whole meshes by the warp that keeps the shape. *)

val all : unit -> Json.t list
