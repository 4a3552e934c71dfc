(** Graded meshes: the loops around the certified functions. *)

val octree : Certified.signField -> int -> Certified.cellSet
(** The certificate's [GradedOctree], by the signs of lattice points after warping,
    of so many levels; every cell is decided once. *)

val iter_names : Certified.cellSet -> int -> Lattice.t -> (Certified.gradedTetId -> unit) -> unit
(** Visits the names of the tetrahedra of an octree of so many levels that have a
    flag in a cell that touches the lattice; larger cells after smaller ones. *)

val iter_tets : Certified.mesh -> int -> Lattice.t -> (Mesher.tet -> unit) -> unit
(** Visits the tetrahedra of a mesh that is graded by so many levels. *)
