open Certified
open Json

let lattice_points { Lattice.origin; cells } shift =
  let row j k =
    List.init cells.x (fun i ->
        Convert.coord3_of_point
          {
            x = origin.x + (2 * i) + shift;
            y = origin.y + (2 * j) + shift;
            z = origin.z + (2 * k) + shift;
          })
  in
  List.init cells.z (fun k -> List.init cells.y (fun j -> row j k))

let grid write_row lattice shift =
  List (List.map (fun layer -> List (List.map write_row layer)) (lattice_points lattice shift))

let sign_grid sign = grid (fun row -> Notation.signs (List.map sign row))

let material_grid material =
  grid (fun row -> List (List.map (fun v -> Int (Convert.int_of_z (material v))) row))

let from_plus_to_minus sign v w = sign v = Plus && sign w = Minus
let from_higher_to_lower material v w = Z.ltb (material w) (material v)

let cut_edges is_cut lattice =
  let around v =
    List.filter_map
      (fun d ->
        let w = translate v (offset d) in
        if is_cut v w then Some (v, w) else None)
      allDirections
  in
  List.concat_map around (Lattice.points lattice)

let explicit_cut cut (v, w) =
  let ends = Notation.[ coord3 v; coord3 w ] in
  let numbers = List.concat_map (function List l -> l | other -> [ other ]) ends in
  List (numbers @ [ Int (Convert.int_of_z (cut v w)) ])

let moved place lattice =
  let entry v =
    match place v with
    | Stays -> None
    | Moves (d, t) -> (
        match Notation.coord3 v with
        | List point -> Some (List (point @ [ Int (Notation.direction d); Int (Convert.int_of_z t) ]))
        | _ -> None)
  in
  List (List.filter_map entry (Lattice.points lattice))

let numbered position iter_tets =
  let tets = ref [] in
  iter_tets (fun (UT (a, b, c, d)) -> tets := List.map position [ a; b; c; d ] :: !tets);
  let tets = List.rev !tets in
  let points = List.sort_uniq compare (List.concat tets) in
  let numbers = Hashtbl.create 1024 in
  List.iteri (fun n p -> Hashtbl.add numbers p n) points;
  let numbered_tet tet = List (List.map (fun p -> Int (Hashtbl.find numbers p)) tet) in
  (List (List.map Notation.point points), List.map numbered_tet tets)
