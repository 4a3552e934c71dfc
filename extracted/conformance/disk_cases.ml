open Certified
open Json

let count = List.length allDirections
let numbers = gather Notation.direction
let link_of_set set = gather (fun d -> (set lsr at numbers d) land 1 <> 0)
let set_of directions = List.fold_left (fun set d -> set lor (1 lsl at numbers d)) 0 directions

(* Each wall once, and its lower number first. *)
let wall_pairs plus =
  walls plus
  |> List.map (fun (d, e) -> (at numbers d, at numbers e))
  |> List.filter (fun (d, e) -> d < e)
  |> List.sort_uniq compare
  |> List.map (fun (d, e) -> List [ Int d; Int e ])

let row set =
  let plus = link_of_set set in
  if not (twoPieces plus) then None
  else
    let nowhere = set_of (List.filter (pinched plus) allDirections) in
    Some (List [ Int set; Int nowhere; List (wall_pairs plus) ])

let all () = List.filter_map row (List.init (1 lsl count) Fun.id)
