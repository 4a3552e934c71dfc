(** Meshes of several materials: tetrahedra with their materials, positions in steps, in
    the order of {!Lattice.iter_tets}.  Those of the outside are left out.  A domain is
    used as it is given: see {!Material_domain.within}. *)

type tet = Certified.material * Certified.coord3 Certified.unstructuredTet

val settled :
  Certified.thresholds ->
  Lattice.t ->
  Material_domain.t ->
  ((tet -> unit) -> unit) * (Certified.coord3 -> Certified.warping)
(** Every point of the lattice that is violated has its turn, in the certificate's
    order: how to visit the tetrahedra, and what became of a point.  [SettleMaterials] and
    [SettledMaterialTets]. *)

val iter_unmoved : Lattice.t -> Material_domain.t -> (tet -> unit) -> unit
(** Nobody moves: [PlacedMaterialTets], with the cuts of the domain as they are. *)
