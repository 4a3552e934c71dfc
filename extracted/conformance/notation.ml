open Certified

let point { Convert.x; y; z } = Json.List [ Int x; Int y; Int z ]
let coord3 v = point (Convert.point_of_coord3 v)

let char_of_sign = function Plus -> '+' | OnSurface -> '0' | Minus -> '-'
let sign s = Json.Text (String.make 1 (char_of_sign s))
let signs list = Json.Text (String.of_seq (Seq.map char_of_sign (List.to_seq list)))

let case_name = function
  | Tet_I1 -> "I1" | Tet_I2 -> "I2" | Tet_I3 -> "I3" | Tet_I4 -> "I4"
  | Tet_J1 -> "J1" | Tet_J2 -> "J2" | Tet_J3 -> "J3" | Tet_J4 -> "J4"
  | Tet_K1 -> "K1" | Tet_K2 -> "K2" | Tet_K3 -> "K3" | Tet_K4 -> "K4"

let direction d =
  let rec search n = function
    | [] -> invalid_arg "no direction"
    | head :: tail -> if head = d then n else search (n + 1) tail
  in
  search 0 allDirections

let case c = Json.Text (case_name c)
let all_signs = [ Minus; OnSurface; Plus ]

let thresholds =
  [ ("angles", angleThresholds); ("embedding", embeddingThresholds);
    ("midpoint", noWarpThresholds) ]

let steps = Convert.int_of_z steps
let threshold_steps th kind = Convert.int_of_z (thresholdSteps th kind)
