(** Meshes of several materials: tetrahedra with their materials, positions in steps.  A domain
    is used as it is given: see {!Material_domain.within}. *)

open Certified

type tet = material * coord3 unstructuredTet

type mesh = {
  tets_within : structuredTetId -> tet list;  (** those of the outside with them *)
  material_in : coord3 -> material option;  (** of a lattice point; nothing where it moved *)
  place : coord3 -> warping;  (** what became of it *)
}

val settle : thresholds -> Lattice.t -> Material_domain.t -> mesh
(** Every point of the lattice that is violated has its turn, in the certificate's
    order: [SettleMaterials] and [SettledMaterialTets]. *)

val unmoved : Material_domain.t -> mesh
(** Nobody moves: [PlacedMaterialTets], with the cuts of the domain as they are. *)

val iter_within : mesh -> structuredTetId -> (tet -> unit) -> unit
(** Visits the tetrahedra of one of the lattice, without those of the outside. *)

val iter_tets : mesh -> Lattice.t -> (tet -> unit) -> unit
(** Visits all, in the order of {!Lattice.iter_tets}. *)
