(** Meshes by the warp that keeps the shape, graded. *)

val all : unit -> Json.t list
