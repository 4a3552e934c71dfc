open Certified
open Json

(* [runs] are the signs along an edge: each holds from its step on, until the
   next. *)
let sign_at runs t =
  List.fold_left (fun known (start, sign) -> if start <= t then sign else known) Plus runs

let judged runs =
  let cut = bisect (fun t -> sign_at runs (Convert.int_of_z t)) in
  let run (start, sign) = List [ Int start; Notation.sign sign ] in
  Object [ ("signs", List (List.map run runs)); ("cut", Int (Convert.int_of_z cut)) ]

let last = Notation.steps - 1

(* Where a surface is worth a look: at powers of two and at the thresholds. *)
let places =
  let powers = List.init 16 (fun bit -> 1 lsl bit) in
  let limits =
    List.concat_map
      (fun (_, th) ->
        List.concat_map
          (fun kind ->
            let t = Notation.threshold_steps th kind in
            [ t; Notation.steps - t ])
          [ Long; Short ])
      Notation.thresholds
  in
  List.concat_map (fun t -> [ t - 1; t; t + 1 ]) (powers @ limits)
  |> List.filter (fun t -> 0 <= t && t <= last)
  |> List.sort_uniq compare

let inside_up_to t = [ (0, Plus); (t + 1, Minus) ]
let on_surface_at t = [ (0, Plus); (t, OnSurface); (t + 1, Minus) ]

(* Inside before [low] and outside after [high]; in between the signs follow no
   surface, in runs by chance. *)
let noise low high seed =
  let starts = List.init 40 (fun n -> low + Chance.below (high - low + 1) seed [ n ]) in
  let sign t = Chance.one_of [ Plus; Minus; Plus; Minus; OnSurface ] seed [ t; 1 ] in
  let inner = List.map (fun t -> (t, sign t)) (List.sort_uniq compare starts) in
  ((0, Plus) :: inner) @ [ (high + 1, Minus) ]

let noise_about_one_place seed =
  let middle = 100 + Chance.below (last - 200) seed [ 9 ] in
  noise (middle - 30) (middle + 30) seed

let cases () =
  List.map inside_up_to places
  @ List.map on_surface_at (List.filter (( < ) 0) places)
  @ List.init 40 (noise 1 last)
  @ List.init 20 noise_about_one_place

let all () = List.map judged (cases ())
