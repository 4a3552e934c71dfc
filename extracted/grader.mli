(** Graded meshes: the loops around the certified functions. *)

val octree : Certified.signField -> int -> Certified.cellSet
(** The certificate's [GradedOctree], by the signs of lattice points after warping,
    of so many levels; every cell is decided once. *)

val iter_names : Certified.cellSet -> int -> Lattice.t -> (Certified.gradedTetId -> unit) -> unit
(** Visits the names of the tetrahedra of an octree of so many levels that have a
    flag in a cell that touches the lattice; larger cells after smaller ones. *)

val iter_tets : Certified.mesh -> int -> Lattice.t -> (Mesher.tet -> unit) -> unit
(** Visits the tetrahedra of a mesh that is graded by so many levels. *)

val iter_material_tets :
  Material_mesher.mesh -> int -> Lattice.t -> (Material_mesher.tet -> unit) -> unit
(** The same where several materials meet: cells are kept that have points of more than one, or
    one that moved, among those that [IsNearSurface] looks at.  Names and what they stand for are
    the certificate's; that they are put together so is not on it. *)
