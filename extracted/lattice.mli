(** The piece of the lattice that is searched. *)

type t = {
  origin : Convert.point;  (** an even point, in lattice units *)
  cells : Convert.point;  (** how many reference points along each axis *)
}
(** The even points [origin + 2(i,j,k)], [0 <= i < cells.x] and so on, and the
    odd points [origin + 2(i,j,k) + (1,1,1)]. *)

val is_inner : t -> Convert.point -> bool
(** Whether a lattice point is in the piece and not among the outermost, those
    with the first or last index of an axis. *)

val points : t -> Certified.coord3 list
(** All of them, row by row: x innermost, then y, then z, even points first. *)

val iter_tets : t -> (Certified.structuredTetId -> unit) -> unit
(** Visits the structured tetrahedra that can hold an inner point: reference
    points with z outermost, then y, then x, and for each of them the twelve
    cases in their order. *)
