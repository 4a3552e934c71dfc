open Certified

exception Overflow

(* The magnitude grows on the negative side, which reaches one farther. *)
let rec negated = function
  | XH -> -1
  | XO p ->
      let n = negated p in
      if n < min_int / 2 then raise Overflow else 2 * n
  | XI p ->
      let n = negated p in
      if n <= min_int / 2 then raise Overflow else (2 * n) - 1

let int_of_z = function
  | Z0 -> 0
  | Zneg p -> negated p
  | Zpos p ->
      let n = negated p in
      if n = min_int then raise Overflow else -n

(* The positive number -n. *)
let rec positive_of_negated n =
  if n = -1 then XH
  else if n land 1 = 0 then XO (positive_of_negated (n / 2))
  else XI (positive_of_negated ((n + 1) / 2))

let z_of_int n =
  if n = 0 then Z0
  else if n < 0 then Zneg (positive_of_negated n)
  else Zpos (positive_of_negated (-n))

let rec int_of_nat = function O -> 0 | S n -> 1 + int_of_nat n

type point = { x : int; y : int; z : int }

let point_of_coord3 (C3 (x, y, z)) =
  { x = int_of_z x; y = int_of_z y; z = int_of_z z }

let coord3_of_point { x; y; z } = C3 (z_of_int x, z_of_int y, z_of_int z)
