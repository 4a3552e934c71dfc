(** A domain as the kit writes it down, and the mesh that comes of it. *)

open Certified

val sign_grid : signField -> Lattice.t -> int -> Json.t
(** Layers of rows of one character for each point; 0 for the even points, 1 for the odd. *)

val material_grid : (coord3 -> material) -> Lattice.t -> int -> Json.t
(** The same of numbers. *)

val from_plus_to_minus : signField -> coord3 -> coord3 -> bool
val from_higher_to_lower : (coord3 -> material) -> coord3 -> coord3 -> bool

val cut_edges : (coord3 -> coord3 -> bool) -> Lattice.t -> (coord3 * coord3) list
(** The edges that are cut, in the order of their first ends and of the directions. *)

val explicit_cut : cutField -> coord3 * coord3 -> Json.t
(** Both ends and the steps: seven numbers. *)

val moved : (coord3 -> warping) -> Lattice.t -> Json.t
(** The points that moved, each with its direction and distance: five numbers. *)

val numbered :
  ('vertex -> Convert.point) -> (('vertex unstructuredTet -> unit) -> unit) -> Json.t * Json.t list
(** The points that the tetrahedra use, sorted; and the tetrahedra by number. *)
