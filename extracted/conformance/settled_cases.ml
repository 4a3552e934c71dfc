open Certified
open Json

let judged { Mesh_domains.name; lattice; domain; _ } =
  let sampled = Domain.within lattice domain in
  let settled = Settler.settle levelGap angleThresholds lattice sampled in
  let edges = Sampled.cut_edges (Sampled.from_plus_to_minus sampled.sign) lattice in
  let points, tets = Sampled.numbered (Settler.position settled) (Settler.iter_tets settled) in
  Object
    [
      ("name", Text name);
      ("origin", Notation.point lattice.origin);
      ("cells", Notation.point lattice.cells);
      ("even", Sampled.sign_grid domain.sign lattice 0);
      ("odd", Sampled.sign_grid domain.sign lattice 1);
      ("cut", List (List.map (Sampled.explicit_cut sampled.cut) edges));
      ("moved", Sampled.moved (Settler.place settled) lattice);
      ("points", points);
      ("tets", List tets);
    ]

let all () = List.map judged Mesh_domains.by_angles
