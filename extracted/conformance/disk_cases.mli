(** All links of a vertex: for each set of + neighbours that leaves a strict disk at all,
    where no 0 may be. *)

val all : unit -> Json.t list
