open Certified
open Json

(* Reference points: around the origin, and at the ends of the range. *)
let anchors =
  [ (0, 0, 0); (2, -4, 6); (-2, 4, -6); (-10, 62, 1024);
    (31992, -31992, 31992); (-31992, 31992, -31992) ]

(* A vertex order, read off by where four marks go. *)
let order_places (order : vertexOrder) =
  let mark n = Convert.coord3_of_point { x = n; y = 0; z = 0 } in
  let ((a, b), c), d = order (mark 1) (mark 2) (mark 3) (mark 4) in
  List (List.map (fun m -> Int (Convert.point_of_coord3 m).x) [ a; b; c; d ])

let neighbor (STId (anchor, case), order) =
  Object
    [ ("anchor", Notation.coord3 anchor); ("case", Notation.case case);
      ("order", order_places order) ]

let structured_tet anchor case =
  let (ST (v1, v2, v3, v4, n1, n2, n3, n4)) = getStructuredTet (STId (anchor, case)) in
  Object
    [
      ("anchor", Notation.coord3 anchor);
      ("case", Notation.case case);
      ("right_handed", Bool (caseHandedness case = RightHanded));
      ("vertices", List (List.map Notation.coord3 [ v1; v2; v3; v4 ]));
      ("neighbors", List (List.map neighbor [ n1; n2; n3; n4 ]));
    ]

let all () =
  List.concat_map
    (fun (x, y, z) ->
      List.map (structured_tet (Convert.coord3_of_point { x; y; z })) allCases)
    anchors
