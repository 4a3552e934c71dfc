open Certified
open Json

type case = { levels : int; given : Mesh_domains.t }

(* The least number first, then the least of the others: what is left of a tetrahedron's order
   is which way round it is. *)
let turned = function
  | [ a; b; c; d ] -> (
      let all = [ [ a; b; c; d ]; [ b; a; d; c ]; [ c; d; a; b ]; [ d; c; b; a ] ] in
      match List.find (fun tet -> List.hd tet = min (min a b) (min c d)) all with
      | [ first; p; q; r ] ->
          let least = min p (min q r) in
          let rest = if p = least then [ p; q; r ] else if q = least then [ q; r; p ] else [ r; p; q ] in
          first :: rest
      | _ -> assert false)
  | _ -> assert false

let numbers = function
  | List l -> List.map (function Int n -> n | _ -> assert false) l
  | _ -> assert false

let in_order tets = List.sort compare (List.map (fun tet -> turned (numbers tet)) tets)

let judged { levels; given = { Mesh_domains.name; lattice; domain; _ } } =
  let sampled = Domain.within lattice domain in
  let mesh = Settler.mesh (Settler.settle levelGap angleThresholds lattice sampled) in
  let edges = Sampled.cut_edges (Sampled.from_plus_to_minus sampled.sign) lattice in
  let points, tets =
    Sampled.numbered
      (fun v -> Convert.point_of_coord3 (mesh.positionIn v))
      (Grader.iter_tets mesh levels lattice)
  in
  Object
    [
      ("name", Text name);
      ("origin", Notation.point lattice.origin);
      ("cells", Notation.point lattice.cells);
      ("levels", Int levels);
      ("even", Sampled.sign_grid domain.sign lattice 0);
      ("odd", Sampled.sign_grid domain.sign lattice 1);
      ("cut", List (List.map (Sampled.explicit_cut sampled.cut) edges));
      ("points", points);
      ("tets", List (List.map (fun tet -> List (List.map (fun n -> Int n) tet)) (in_order tets)));
    ]

let solid name lattice text =
  {
    Mesh_domains.name;
    lattice;
    cuts = Explicit;
    guarantee = Angles;
    domain = Domain.of_position_sign (Solid.position_sign (Solid.parse text));
  }

(* All but some points of a box: cells of every size meet in any way. *)
let holes =
  let sign p =
    if Chance.below 1500 73 [ p.Convert.x; p.y; p.z ] = 0 then Minus else Plus
  in
  {
    Mesh_domains.name = "a box with holes, by three levels";
    lattice = Mesh_domains.lattice (-6) (-4) (-6) 14 13 13;
    cuts = Explicit;
    guarantee = Angles;
    domain = Mesh_domains.sampled sign (Mesh_domains.any_of Mesh_domains.beside_thresholds 73);
  }

let all_cases =
  let around = Mesh_domains.lattice (-10) (-10) (-8) 11 10 10 in
  let ball = solid "a ball, by one level" around "sphere 0.37 -0.81 0.59 7.3" in
  [ { levels = 1; given = ball }; { levels = 3; given = holes } ]

let all () = List.map judged all_cases
