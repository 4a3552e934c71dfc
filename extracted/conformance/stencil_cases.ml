open Certified
open Json

(* Corner n of the structured tetrahedron stands at (n, 0, 0). *)
let place n = Convert.coord3_of_point { x = n; y = 0; z = 0 }
let number v = string_of_int (Convert.point_of_coord3 v).x

let vertex = function
  | Corner c -> Text (number c)
  | Cut (plus, minus) -> Text (number plus ^ number minus)

let tet (UT (a, b, c, d)) = List (List.map vertex [ a; b; c; d ])

let stencil signs =
  let sign = function
    | Corner c -> List.nth signs ((Convert.point_of_coord3 c).x - 1)
    | Cut _ -> OnSurface
  in
  let corner n = Corner (place n) in
  let tets =
    getUnstructuredTets sign meshIntersection (corner 1) (corner 2) (corner 3) (corner 4)
  in
  let written handedness = List (List.map (fun t -> tet (orient handedness t)) tets) in
  Object
    [ ("signs", Notation.signs signs);
      ("right_handed", written RightHanded);
      ("left_handed", written LeftHanded) ]

let all () =
  let each = Notation.all_signs in
  List.concat_map (fun d ->
      List.concat_map (fun c ->
          List.concat_map (fun b -> List.map (fun a -> stencil [ a; b; c; d ]) each) each)
        each)
    each
