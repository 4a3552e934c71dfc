open Certified

type tet = meshVertex unstructuredTet

let iter_tets thresholds lattice { Domain.sign; cut } visit =
  Lattice.iter_tets lattice (fun id ->
      List.iter visit (stuffTet thresholds sign cut id))

let position thresholds { Domain.sign; cut } v =
  Convert.point_of_coord3 (meshPosition thresholds sign cut v)

let mesh thresholds { Domain.sign; cut } =
  {
    tetsWithin = stuffTet thresholds sign cut;
    signIn = meshVertexSign thresholds sign cut;
    positionIn = meshPosition thresholds sign cut;
  }
