open Certified

(* Negative inside, positive outside; arguments in lattice units. *)
type t = float -> float -> float -> float

exception Unknown of string

let squared x = x *. x

let sphere cx cy cz r x y z =
  squared (x -. cx) +. squared (y -. cy) +. squared (z -. cz) -. squared r

let torus cx cy cz major minor x y z =
  let from_tube = sqrt (squared (x -. cx) +. squared (y -. cy)) -. major in
  squared from_tube +. squared (z -. cz) -. squared minor

let box x0 y0 z0 x1 y1 z1 x y z =
  let outside low c high = Float.max (low -. c) (c -. high) in
  Float.max (outside x0 x x1) (Float.max (outside y0 y y1) (outside z0 z z1))

let parse text =
  let unknown () =
    raise (Unknown (Printf.sprintf "'%s' is no solid that is known" text))
  in
  match String.split_on_char ' ' text |> List.filter (( <> ) "") with
  | [] -> unknown ()
  | name :: words -> (
      match (name, List.map float_of_string_opt words) with
      | "sphere", [ Some x; Some y; Some z; Some r ] -> sphere x y z r
      | "torus", [ Some x; Some y; Some z; Some major; Some minor ] ->
          torus x y z major minor
      | "box", [ Some a; Some b; Some c; Some d; Some e; Some f ] ->
          box a b c d e f
      | _ -> unknown ())

let position_sign solid v =
  let { Convert.x; y; z } = Convert.point_of_coord3 v in
  let unit = float_of_int (Convert.int_of_z steps) in
  let lattice c = float_of_int c /. unit in
  let level = solid (lattice x) (lattice y) (lattice z) in
  if level < 0. then Plus else if level = 0. then OnSurface else Minus
