open Certified
open Json

type case = {
  thresholds : string * thresholds;
  sign : sign;
  neighbors : sign array;  (* by the number of the direction *)
  cuts : int array;
}

let directions = Array.of_list allDirections
let count = Array.length directions

let number_of direction =
  let rec search n = if directions.(n) = direction then n else search (n + 1) in
  search 0

let cuts_left case sign_after =
  List.filter
    (fun d -> opposite sign_after case.neighbors.(d))
    (List.init count Fun.id)

let judged case =
  let name, thresholds = case.thresholds in
  let warping =
    warp thresholds case.sign
      (fun d -> case.neighbors.(number_of d))
      (fun d -> Convert.z_of_int case.cuts.(number_of d))
  in
  let after = warpedSign case.sign warping in
  let origin = Convert.coord3_of_point { x = 0; y = 0; z = 0 } in
  let direction, distance =
    match warping with
    | Stays -> (-1, 0)
    | Moves (d, t) -> (number_of d, Convert.int_of_z t)
  in
  Object
    [
      ("thresholds", Text name);
      ("sign", Notation.sign case.sign);
      ("neighbors", Notation.signs (Array.to_list case.neighbors));
      ("cuts", List (List.map (fun t -> Int t) (Array.to_list case.cuts)));
      ("direction", Int direction);
      ("distance", Int distance);
      ("displacement", Notation.coord3 (warpedPosition origin warping));
      ("sign_after", Notation.sign after);
      ("cuts_left", List (List.map (fun d -> Int d) (cuts_left case after)));
    ]

let kind d = directionKind directions.(d)
let other = function Plus -> Minus | Minus -> Plus | OnSurface -> OnSurface

(* A vertex of which the edges given are cut, and no other: the rest have cuts
   of no steps that do not count. *)
let with_cuts thresholds sign cut_edges =
  let neighbors = Array.make count sign in
  let cuts = Array.make count 0 in
  List.iter
    (fun (d, t) ->
      neighbors.(d) <- other sign;
      cuts.(d) <- t)
    cut_edges;
  { thresholds; sign; neighbors; cuts }

let all_directions = List.init count Fun.id

(* One edge, with cuts at its ends, in its middle, and on and beside either
   threshold. *)
let single (name, th) =
  let places d =
    let limit = Notation.threshold_steps th (kind d) in
    let seen_from_afar = Notation.steps - limit in
    [ 0; 1; limit - 1; limit; limit + 1; Notation.steps / 2; seen_from_afar; Notation.steps - 1;
      Notation.steps ]
    |> List.filter (fun t -> 0 <= t) |> List.sort_uniq compare
  in
  List.concat_map
    (fun d ->
      List.concat_map
        (fun t -> List.map (fun s -> with_cuts (name, th) s [ (d, t) ]) [ Plus; Minus ])
        (places d))
    all_directions

(* Every sign of the vertex and of a neighbour, with a cut that would violate. *)
let sign_pairs thresholds =
  List.concat_map
    (fun sign ->
      List.concat_map
        (fun neighbor ->
          List.map
            (fun d ->
              let neighbors = Array.make count OnSurface in
              neighbors.(d) <- neighbor;
              { thresholds; sign; neighbors; cuts = Array.make count 7 })
            [ 0; 5; 6; 13 ])
        Notation.all_signs)
    Notation.all_signs

(* The farthest cut of a long edge that is no farther than [short] steps along
   a short one: 4 long^2 <= 3 short^2. *)
let long_as_far_as short =
  let rec search t = if 4 * (t + 1) * (t + 1) <= 3 * short * short then search (t + 1) else t in
  search (short / 2)

(* Two edges: ties, one step more, and a long one against a short one. *)
let pair thresholds d e =
  let _, th = thresholds in
  let limit d = Notation.threshold_steps th (kind d) in
  let near = min (limit d) (limit e) - 1 in
  let ends = [ (near, near); (near - 1, near); (near, near - 1); (0, 0) ] in
  let across =
    if kind d = kind e then [ (limit d, near) ]
    else
      (* d comes first, so it is the long one *)
      let long = long_as_far_as near in
      [ (long, near); (long + 1, near); (limit d - 1, limit e - 1); (limit d, limit e - 1) ]
  in
  List.map (fun (t, u) -> with_cuts thresholds Plus [ (d, t); (e, u) ]) (ends @ across)

let pairs thresholds =
  List.concat_map
    (fun d ->
      List.concat_map
        (fun e -> if e > d then pair thresholds d e else [])
        all_directions)
    all_directions

(* Many violations at once, often at the same distance. *)
let random thresholds seed =
  let _, th = thresholds in
  let long = Notation.threshold_steps th Long in
  let short = Notation.threshold_steps th Short in
  let places = [ 1; 2; 3; long - 1; long; short - 1; short; long_as_far_as 3000; 3000 ] in
  let sign d = Chance.one_of [ Plus; Minus; Minus; Plus; OnSurface ] seed [ 1; d ] in
  let cut d = max 0 (Chance.one_of places seed [ 2; d ]) in
  { thresholds; sign = Chance.one_of [ Plus; Minus ] seed [ 0 ];
    neighbors = Array.init count sign; cuts = Array.init count cut }

let cases () =
  let warping = List.filter (fun (name, _) -> name <> "midpoint") Notation.thresholds in
  List.concat_map single Notation.thresholds
  @ List.concat_map sign_pairs Notation.thresholds
  @ List.concat_map pairs warping
  @ List.concat_map (fun th -> List.init 100 (random th)) Notation.thresholds

let all () = List.map judged (cases ())
