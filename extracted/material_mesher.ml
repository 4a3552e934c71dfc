open Certified

type tet = material * coord3 unstructuredTet

type mesh = {
  tets_within : structuredTetId -> tet list;
  material_in : coord3 -> material option;
  place : coord3 -> warping;
}

let settle thresholds lattice { Material_domain.material; cut } =
  let order = materialsInTurn thresholds material cut (Lattice.points lattice) in
  let zeros = settleMaterials widestAngles thresholds material cut order in
  let place = placeIn zeros in
  {
    tets_within = settledMaterialTets thresholds material cut zeros;
    material_in = placedMaterial (fun v -> Some (material v)) place;
    place;
  }

let unmoved { Material_domain.material; cut } =
  let before v = Some (material v) in
  let place _ = Stays in
  let shared _ = outside in
  { tets_within = placedMaterialTets before place cut shared; material_in = before; place }

let iter_within { tets_within; _ } id visit =
  let visit_inside (material, tet) = if material <> outside then visit (material, tet) in
  List.iter visit_inside (tets_within id)

let iter_tets mesh lattice visit =
  Lattice.iter_tets lattice (fun id -> iter_within mesh id visit)
