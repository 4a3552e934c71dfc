open Certified
open Json

type case = {
  name : string;
  lattice : Lattice.t;
  cuts : Mesh_domains.cuts;
  domain : Material_domain.t;
}

let words { Convert.x; y; z } = [ x; y; z ]
let words_of v = words (Convert.point_of_coord3 v)

(* Of a hundred points so many are outside, the others of so many materials. *)
let random seed ~outside:none ~materials cuts =
  let material v =
    let p = words_of v in
    if Chance.below 100 seed (0 :: p) < none then outside
    else Convert.z_of_int (1 + Chance.below materials seed (1 :: p))
  in
  let cut higher lower =
    Convert.z_of_int (Chance.one_of cuts seed (words_of higher @ words_of lower))
  in
  { Material_domain.material; cut }

(* Three balls that overlap; where they do, the one that a point is deeper in. *)
let balls =
  let level (x, y, z, r) v =
    let { Convert.x = px; y = py; z = pz } = Convert.point_of_coord3 v in
    let squared c from = ((float_of_int c /. 65536.) -. from) ** 2. in
    squared px x +. squared py y +. squared pz z -. (r *. r)
  in
  let all = [ (-1.3, 0.2, 0.1, 3.1); (1.7, 0.7, -0.4, 2.7); (0.4, -1.6, 0.8, 2.3) ] in
  let material_at v =
    let deeper (n, best, least) ball =
      let l = level ball v in
      if l < least then (n + 1, n, l) else (n + 1, best, least)
    in
    let _, best, _ = List.fold_left deeper (1, 0, 0.) all in
    Convert.z_of_int best
  in
  let material v = material_at (scale steps v) in
  let cut higher lower =
    let last = material lower in
    bisect (fun t -> if material_at (pointOnEdge higher lower t) = last then Minus else Plus)
  in
  { Material_domain.material; cut }

let near_one_end = [ 40; 9000; 15000; 18687 ]

(* All four corners of some tetrahedra move, beside the outside or not. *)
let near_either_end =
  let near = [ 40; 9000; 15000 ] in
  near @ List.map (fun t -> Notation.steps - t) near

let all_cases =
  let case name (cuts : Mesh_domains.cuts) lattice domain = { name; cuts; lattice; domain } in
  let lattice = Mesh_domains.lattice and anywhere = Mesh_domains.beside_thresholds in
  [
    case "three balls" Explicit (lattice (-6) (-6) (-6) 7 7 7) balls;
    case "three balls, with midpoints" Midpoint (lattice (-6) (-6) (-6) 7 7 7) balls;
    case "one material" Explicit (lattice 0 0 0 5 5 5)
      (random 21 ~outside:50 ~materials:1 anywhere);
    case "two materials" Explicit (lattice 2 (-4) 6 5 5 5)
      (random 22 ~outside:20 ~materials:2 anywhere);
    case "two materials that nothing parts" Explicit (lattice 0 0 0 6 5 5)
      (random 23 ~outside:0 ~materials:2 near_one_end);
    case "two materials beside hollows" Explicit (lattice 0 0 0 7 7 7)
      (random 66 ~outside:2 ~materials:2 near_either_end);
    case "three materials near each other" Explicit (lattice (-2) 0 4 5 6 5)
      (random 24 ~outside:10 ~materials:3 near_one_end);
    case "twelve materials" Explicit (lattice 0 0 0 5 5 5)
      (random 25 ~outside:10 ~materials:12 anywhere);
    case "four materials, with midpoints" Midpoint (lattice 0 0 0 5 5 5)
      (random 26 ~outside:20 ~materials:4 anywhere);
  ]

(* Each tetrahedron led by its material. *)
let numbered iter =
  let materials = ref [] in
  let iter_tets visit =
    iter (fun (m, tet) ->
        materials := Convert.int_of_z m :: !materials;
        visit tet)
  in
  let points, tets = Sampled.numbered Convert.point_of_coord3 iter_tets in
  let led m tet = match tet with List l -> List (Int m :: l) | t -> t in
  (points, List (List.map2 led (List.rev !materials) tets))

let judged { name; lattice; cuts; domain } =
  let sampled = Material_domain.within lattice domain in
  let midpoint = cuts = Mesh_domains.Midpoint in
  let mesh =
    if midpoint then Material_mesher.unmoved (Material_domain.midpoint sampled)
    else Material_mesher.settle angleThresholds lattice sampled
  in
  let points, tets = numbered (Material_mesher.iter_tets mesh lattice) in
  let edges =
    if midpoint then []
    else Sampled.cut_edges (Sampled.from_higher_to_lower sampled.material) lattice
  in
  Object
    [
      ("name", Text name);
      ("origin", Notation.point lattice.origin);
      ("cells", Notation.point lattice.cells);
      ("cuts", Text (if midpoint then "midpoint" else "explicit"));
      ("even", Sampled.material_grid domain.material lattice 0);
      ("odd", Sampled.material_grid domain.material lattice 1);
      ("cut", List (List.map (Sampled.explicit_cut sampled.cut) edges));
      ("moved", Sampled.moved mesh.place lattice);
      ("points", points);
      ("tets", tets);
    ]

let all () = List.map judged all_cases
