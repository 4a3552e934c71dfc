(** Whole meshes: the domain as the mesher sees it, and the points and
    tetrahedra that come of it. *)

val all : unit -> Json.t list
