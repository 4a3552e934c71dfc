(** Mesh files in MEDIT's text format. *)

val write : string -> Convert.point list -> (int * int * int * int * int) list -> unit
(** [write file points tets]: points in steps, written in lattice units, of
    which every step is an exact decimal; tetrahedra name them from 1, and
    a number of their own after them.  The file
    grows under a temporary name and appears whole or not at all.
    Raises [Sys_error]. *)
