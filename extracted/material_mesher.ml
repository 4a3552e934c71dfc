open Certified

type tet = material * coord3 unstructuredTet

let iter_inside lattice tets visit =
  let visit_inside (material, tet) = if material <> outside then visit (material, tet) in
  Lattice.iter_tets lattice (fun id -> List.iter visit_inside (tets id))

let settled thresholds lattice { Material_domain.material; cut } =
  let order = materialsInTurn thresholds material cut (Lattice.points lattice) in
  let zeros = settleMaterials widestAngles thresholds material cut order in
  (iter_inside lattice (settledMaterialTets thresholds material cut zeros), placeIn zeros)

let iter_unmoved lattice { Material_domain.material; cut } visit =
  let before v = Some (material v) in
  let shared _ = outside in
  iter_inside lattice (placedMaterialTets before (fun _ -> Stays) cut shared) visit
