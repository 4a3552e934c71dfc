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

(* Layers of rows of one character for each point. *)
let sign_grid domain lattice shift =
  let row points = Notation.signs (List.map domain.Domain.sign points) in
  List (List.map (fun layer -> List (List.map row layer)) (lattice_points lattice shift))

(* Every edge from a + point to a - point, in the order of the + points and of
   the directions. *)
let cut_edges sign lattice =
  let around plus =
    if sign plus <> Plus then []
    else
      List.filter_map
        (fun d ->
          let minus = translate plus (offset d) in
          if sign minus = Minus then Some (plus, minus) else None)
        allDirections
  in
  List.concat_map
    (fun shift -> List.concat_map around (List.concat (List.concat (lattice_points lattice shift))))
    [ 0; 1 ]

let explicit_cut domain (plus, minus) =
  let ends = Notation.[ coord3 plus; coord3 minus ] in
  let numbers = List.concat_map (function List l -> l | other -> [ other ]) ends in
  List (numbers @ [ Int (Convert.int_of_z (domain.Domain.cut plus minus)) ])

(* Six times the volume of the structured tetrahedron as warping left it. *)
let warped_volume thresholds domain corners =
  let place v = Mesher.position thresholds domain (Corner v) in
  match List.map place corners with
  | [ a; b; c; d ] ->
      let u = Convert.(b.x - a.x, b.y - a.y, b.z - a.z) in
      let v = Convert.(c.x - a.x, c.y - a.y, c.z - a.z) in
      let w = Convert.(d.x - a.x, d.y - a.y, d.z - a.z) in
      let determinant (a1, a2, a3) (b1, b2, b3) (c1, c2, c3) =
        (a1 * ((b2 * c3) - (b3 * c2))) - (a2 * ((b1 * c3) - (b3 * c1)))
        + (a3 * ((b1 * c2) - (b2 * c1)))
      in
      determinant u v w
  | _ -> assert false

let is_turned_over thresholds domain (STId (_, case) as id) =
  let (ST (v1, v2, v3, v4, _, _, _, _)) = getStructuredTet id in
  let corners = [ v1; v2; v3; v4 ] in
  let on_surface v =
    meshVertexSign thresholds domain.Domain.sign domain.Domain.cut (Corner v) = OnSurface
  in
  List.for_all on_surface corners
  &&
  let volume = warped_volume thresholds domain corners in
  match caseHandedness case with RightHanded -> volume <= 0 | LeftHanded -> volume >= 0

let turned_over thresholds lattice domain =
  let count = ref 0 in
  Lattice.iter_tets lattice (fun id -> if is_turned_over thresholds domain id then incr count);
  !count

(* The points that the tetrahedra use, sorted; and the tetrahedra by number. *)
let numbered thresholds lattice domain =
  let tets = ref [] in
  Mesher.iter_tets thresholds lattice domain (fun (UT (a, b, c, d)) ->
      tets := List.map (Mesher.position thresholds domain) [ a; b; c; d ] :: !tets);
  let tets = List.rev !tets in
  let points = List.sort_uniq compare (List.concat tets) in
  let numbers = Hashtbl.create 1024 in
  List.iteri (fun n p -> Hashtbl.add numbers p n) points;
  (points, List.map (List.map (Hashtbl.find numbers)) tets)

(* Which thresholds are used in the end, by name. *)
let choose { Mesh_domains.cuts; guarantee; lattice; _ } domain =
  match (cuts, guarantee) with
  | Midpoint, _ -> ("midpoint", 0)
  | Explicit, Embedding -> ("embedding", 0)
  | Explicit, Angles -> (
      match turned_over angleThresholds lattice domain with
      | 0 -> ("angles", 0)
      | count -> ("embedding", count))

let judged ({ Mesh_domains.name; lattice; cuts; guarantee; domain } as case) =
  let sampled = Domain.within lattice domain in
  let decided = if cuts = Midpoint then Domain.midpoint sampled else sampled in
  let used, turned_over = choose case decided in
  let thresholds = List.assoc used Notation.thresholds in
  let points, tets = numbered thresholds lattice decided in
  let given_cuts = match cuts with Midpoint -> [] | Explicit -> cut_edges sampled.sign lattice in
  Object
    [
      ("name", Text name);
      ("origin", Notation.point lattice.origin);
      ("cells", Notation.point lattice.cells);
      ("cuts", Text (match cuts with Explicit -> "explicit" | Midpoint -> "midpoint"));
      ("guarantee", Text (match guarantee with Angles -> "angles" | Embedding -> "embedding"));
      ("even", sign_grid domain lattice 0);
      ("odd", sign_grid domain lattice 1);
      ("cut", List (List.map (explicit_cut sampled) given_cuts));
      ("turned_over", Int turned_over);
      ("thresholds", Text used);
      ("points", List (List.map Notation.point points));
      ("tets", List (List.map (fun tet -> List (List.map (fun n -> Int n) tet)) tets));
    ]

let all () = List.map judged Mesh_domains.all
