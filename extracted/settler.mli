(** The warp that keeps the shape, over a piece of the lattice: who moves onto the
    surface and who stays is settled for all of it before there are tetrahedra. *)

type t

(** The certificate's [PlacedNames], or its [KeyNames], of the cuts that the mesh has. *)
type diagonals = By_parity | By_key

val settle :
  ?diagonals:diagonals -> Certified.gap -> Certified.thresholds -> Lattice.t -> Domain.t -> t
(** By the Parity Rule, if nothing else is said.  Every point of the lattice that is violated has its turn, in the certificate's
    order; samples on the surface count as outside.  The domain is used as it is
    given: see {!Domain.within}. *)

val place : t -> Certified.coord3 -> Certified.warping
(** What became of a point of the lattice. *)

val iter_tets : t -> (Mesher.tet -> unit) -> unit
(** Visits the tetrahedra of the mesh in the order of {!Mesher.iter_tets}. *)

val position : t -> Certified.meshVertex -> Convert.point
(** Where a vertex of the mesh lies, in steps. *)

val mesh : t -> Certified.mesh
(** The certificate's [SweptMesh]. *)
