open Certified

type t = {
  name : string;
  lattice : Lattice.t;
  cuts : cuts;
  guarantee : guarantee;
  domain : Domain.t;
}

and cuts = Explicit | Midpoint
and guarantee = Angles | Embedding

let steps = Notation.steps
let lattice ox oy oz nx ny nz =
  { Lattice.origin = { x = ox; y = oy; z = oz }; cells = { x = nx; y = ny; z = nz } }

let of_solid text = Domain.of_position_sign (Solid.position_sign (Solid.parse text))

let words { Convert.x; y; z } = [ x; y; z ]
let words_of v = words (Convert.point_of_coord3 v)

(* Signs by a function of the lattice point; cuts by one of both ends. *)
let sampled sign cut =
  {
    Domain.sign = (fun v -> sign (Convert.point_of_coord3 v));
    cut = (fun plus minus -> Convert.z_of_int (cut plus minus));
  }

let always t _ _ = t
let any_of list seed plus minus = Chance.one_of list seed (words_of plus @ words_of minus)

(* Of a hundred points so many lie on the surface, and so many are inside. *)
let random_sign seed ~zero ~inside p =
  let n = Chance.below 100 seed (0 :: words p) in
  if n < zero then OnSurface else if n < zero + inside then Plus else Minus

(* On and beside each threshold, seen from either end; and the ends. *)
let beside_thresholds =
  [ 0; 1; steps / 2; steps - 1 ]
  @ List.concat_map
      (fun th ->
        List.concat_map
          (fun kind ->
            let t = Notation.threshold_steps th kind in
            List.concat_map (fun by -> [ t + by; steps - t + by ]) [ -1; 0; 1 ])
          [ Long; Short ])
      [ angleThresholds; embeddingThresholds ]

(* Cuts that bring the ends of long edges as near as the angle thresholds let
   them: whole tetrahedra end up on the surface, and some turn over. *)
let folding =
  let near = Notation.threshold_steps angleThresholds Long - 1 in
  [ near; steps - near; steps / 2; steps / 2 ]

(* Tetrahedron I1 of the reference point 0, each corner a quarter of an edge from
   its nearest cut: there it would be as flat as a plane. *)
let flat_corners = [ [ 0; 2; 2 ]; [ 2; 2; 2 ]; [ 1; 3; 1 ]; [ 1; 3; 3 ] ]
let flat_targets = [ [ 0; 4; 2 ]; [ 2; 4; 2 ]; [ 1; 1; 1 ]; [ 1; 1; 3 ] ]

let flattening plus minus =
  let is_edge corner target = corner = words plus && target = words minus in
  if List.exists2 is_edge flat_corners flat_targets then steps / 4 else steps / 2

let is_odd p = p.Convert.x land 1 = 1
let among points p = if List.mem (words p) points then Plus else Minus
let all_but points p = if List.mem (words p) points then Minus else Plus
let checkered p = if is_odd p then Minus else Plus

let case name cuts guarantee lattice domain = { name; lattice; cuts; guarantee; domain }
let cube n = lattice (-n) (-n) (-n) (n + 1) (n + 1) (n + 1)

let smooth =
  let sphere = of_solid "sphere 0.37 -0.81 0.59 3.3" and around = lattice (-4) (-6) (-4) 6 7 6 in
  let box = of_solid "box -2 -2 -2 2 2 2" in
  [
    case "a sphere" Explicit Angles around sphere;
    case "a sphere that embeds" Explicit Embedding around sphere;
    case "a sphere with midpoints" Midpoint Angles around sphere;
    case "a torus" Explicit Angles (lattice (-6) (-6) (-4) 7 7 4)
      (of_solid "torus 0.3 0.2 0.1 3.6 1.6");
    case "a box through lattice points" Explicit Angles (cube 4) box;
    case "a box through lattice points, with midpoints" Midpoint Angles (cube 4) box;
    case "a sphere that leaves the lattice" Explicit Angles (lattice (-2) (-4) (-2) 4 5 4)
      (of_solid "sphere 0 0 0 9");
  ]

let few_points =
  [
    case "nothing inside" Explicit Angles (lattice 0 0 0 3 3 3) (sampled (among []) (always 0));
    case "one inside point" Explicit Angles (cube 2)
      (sampled (among [ [ 0; 0; 0 ] ]) (always 30000));
    case "one outside point" Explicit Angles (cube 4)
      (sampled (all_but [ [ 1; 1; 1 ] ]) (always 20000));
    case "two inside points with common neighbours" Midpoint Angles (cube 4)
      (sampled (among [ [ 0; 0; 0 ]; [ 2; 2; 0 ] ]) (always (steps / 2)));
    case "even points inside, odd points outside" Explicit Embedding (cube 2)
      (sampled checkered (always (steps / 2)));
    case "a tetrahedron that would be flat" Explicit Angles (lattice (-4) (-2) (-4) 6 6 6)
      (sampled (among flat_corners)
         (fun p m -> flattening (Convert.point_of_coord3 p) (Convert.point_of_coord3 m)));
  ]

(* Far out the coordinates nearly fill 32 bits. *)
let random =
  let far = 31992 in
  let upper = far - 14 in
  let folding_sign = random_sign 41 ~zero:0 ~inside:50 in
  let noise seed ~zero ~inside =
    sampled (random_sign seed ~zero ~inside) (any_of beside_thresholds seed)
  in
  [
    case "cuts at the inner ends" Explicit Angles (lattice 0 0 0 5 5 5)
      (sampled (random_sign 1 ~zero:0 ~inside:95) (always 0));
    case "cuts at the outer ends" Explicit Embedding (lattice 0 0 0 5 5 5)
      (sampled (random_sign 2 ~zero:0 ~inside:60) (always (steps - 1)));
    case "random, the angle thresholds" Explicit Angles (lattice 2 (-4) 6 6 5 6)
      (noise 3 ~zero:8 ~inside:80);
    case "random, the embedding thresholds" Explicit Embedding (lattice 2 (-4) 6 5 6 6)
      (noise 4 ~zero:8 ~inside:80);
    case "random, with midpoints" Midpoint Angles (lattice 2 (-4) 6 5 5 6)
      (sampled (random_sign 5 ~zero:20 ~inside:48) (always (steps / 2)));
    case "random, mostly on the surface" Explicit Angles (lattice 0 0 0 5 5 5)
      (noise 6 ~zero:50 ~inside:42);
    case "a lattice that folds" Explicit Angles (lattice 0 0 0 6 6 6)
      (sampled folding_sign (any_of folding 41));
    case "a lattice that would fold" Explicit Embedding (lattice 0 0 0 6 6 6)
      (sampled folding_sign (any_of folding 41));
    case "the upper end of the range" Explicit Angles (lattice upper upper upper 6 6 6)
      (noise 8 ~zero:3 ~inside:92);
    case "the lower end of the range" Explicit Embedding (lattice (-far) (-far) (-far) 6 6 6)
      (noise 9 ~zero:3 ~inside:92);
  ]

let all = few_points @ smooth @ random
let by_angles = List.filter (fun case -> case.cuts = Explicit && case.guarantee = Angles) all
