open Certified
open Json

(* A wall halfway between planes of even and of odd points, so rough that points across it
   would pass each other; with short edges that violate one of them or none. *)
let rough_wall =
  let sign p = if p.Convert.z <= 0 then Plus else Minus in
  let cut plus minus =
    let any_of list = Mesh_domains.any_of list 31 plus minus in
    let above = (Convert.point_of_coord3 minus).z and below = (Convert.point_of_coord3 plus).z in
    let across = [ 14000; 16000; 17000; 18000; 18600 ] in
    match (below, above) with
    | 0, 2 -> any_of across
    | -1, 1 -> Notation.steps - any_of across
    | _ -> any_of [ 22000; 25000; 32768; 40536; 43536 ]
  in
  {
    Mesh_domains.name = "a rough wall";
    lattice = Mesh_domains.lattice 0 0 (-4) 7 7 5;
    cuts = Explicit;
    guarantee = Angles;
    domain = Mesh_domains.sampled sign cut;
  }

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

let all () = List.map judged (Mesh_domains.by_angles @ [ rough_wall ])
