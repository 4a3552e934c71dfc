open Certified
open Json

(* Corner n of the structured tetrahedron stands at (n, 0, 0), a cut at its ends, the
   lower first. *)
let place n = Convert.coord3_of_point { x = n; y = 0; z = 0 }
let number v = (Convert.point_of_coord3 v).x

let cut v w =
  match (v, w) with
  | Corner a, Corner b -> if number a < number b then Cut (a, b) else Cut (b, a)
  | _ -> invalid_arg "a cut has no cuts"

let vertex = function
  | Corner c -> string_of_int (number c)
  | Cut (a, b) -> string_of_int (number a) ^ string_of_int (number b)

(* 0 for a corner that moved, and a letter for each material. *)
let letter = function None -> '0' | Some m -> Char.chr (Char.code 'A' + Convert.int_of_z m)
let shared = Convert.z_of_int 25

let stencil corners =
  let material = function
    | Corner c -> List.nth corners (number c - 1)
    | Cut _ -> None
  in
  let corner n = Corner (place n) in
  let tets = getMaterialTets material cut (corner 1) (corner 2) (corner 3) (corner 4) shared in
  let tet handedness (m, t) =
    let (UT (a, b, c, d)) = orient handedness t in
    let owner = Text (String.make 1 (letter (Some m))) in
    List (owner :: List.map (fun v -> Text (vertex v)) [ a; b; c; d ])
  in
  let written handedness = List (List.map (tet handedness) tets) in
  Object
    [
      ("corners", Text (String.of_seq (Seq.map letter (List.to_seq corners))));
      ("right_handed", written RightHanded);
      ("left_handed", written LeftHanded);
    ]

(* Every corner has moved, is of a material that was there before, or of the next. *)
let patterns =
  let rec from corners fresh =
    if List.length corners = 4 then [ List.rev corners ]
    else
      from (None :: corners) fresh
      @ List.concat
          (List.init (fresh + 1) (fun m ->
               from (Some (Convert.z_of_int m) :: corners) (max fresh (m + 1))))
  in
  from [] 0

let all () = List.map stencil patterns
