(** The loops around the certified functions: the reference mesher. *)

type tet = Certified.meshVertex Certified.unstructuredTet

val iter_tets : Certified.thresholds -> Lattice.t -> Domain.t -> (tet -> unit) -> unit
(** Visits the tetrahedra of the mesh, all of positive volume, in the order of
    {!Lattice.iter_tets} and within it that of the stencils.  The domain is
    used as it is given: see {!Domain.within}. *)

val position : Certified.thresholds -> Domain.t -> Certified.meshVertex -> Convert.point
(** Where a vertex of the mesh lies, in steps. *)

val mesh : Certified.thresholds -> Domain.t -> Certified.mesh
(** The certificate's [StuffedMesh]. *)
