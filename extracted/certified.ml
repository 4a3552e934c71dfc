(* Generated from coq/Extraction.v by "make -C coq extract": do not edit. *)

(** val xorb : bool -> bool -> bool **)

let xorb b1 b2 =
  if b1 then if b2 then false else true else b2

(** val negb : bool -> bool **)

let negb = function
| true -> false
| false -> true

type nat =
| O
| S of nat

(** val fst : ('a1 * 'a2) -> 'a1 **)

let fst = function
| (x, _) -> x

(** val snd : ('a1 * 'a2) -> 'a2 **)

let snd = function
| (_, y) -> y

(** val length : 'a1 list -> nat **)

let rec length = function
| [] -> O
| _ :: l' -> S (length l')

(** val app : 'a1 list -> 'a1 list -> 'a1 list **)

let rec app l m =
  match l with
  | [] -> m
  | a :: l1 -> a :: (app l1 m)

type comparison =
| Eq
| Lt
| Gt

(** val compOpp : comparison -> comparison **)

let compOpp = function
| Eq -> Eq
| Lt -> Gt
| Gt -> Lt

module Coq__1 = struct
 (** val add : nat -> nat -> nat **)
 let rec add n m =
   match n with
   | O -> m
   | S p -> S (add p m)
end
include Coq__1

(** val mul : nat -> nat -> nat **)

let rec mul n m =
  match n with
  | O -> O
  | S p -> add m (mul p m)

type positive =
| XI of positive
| XO of positive
| XH

type z =
| Z0
| Zpos of positive
| Zneg of positive

(** val eqb : bool -> bool -> bool **)

let eqb b1 b2 =
  if b1 then b2 else if b2 then false else true

module Nat =
 struct
  (** val eqb : nat -> nat -> bool **)

  let rec eqb n m =
    match n with
    | O -> (match m with
            | O -> true
            | S _ -> false)
    | S n' -> (match m with
               | O -> false
               | S m' -> eqb n' m')

  (** val leb : nat -> nat -> bool **)

  let rec leb n m =
    match n with
    | O -> true
    | S n' -> (match m with
               | O -> false
               | S m' -> leb n' m')

  (** val ltb : nat -> nat -> bool **)

  let ltb n m =
    leb (S n) m
 end

module Pos =
 struct
  (** val succ : positive -> positive **)

  let rec succ = function
  | XI p -> XO (succ p)
  | XO p -> XI p
  | XH -> XO XH

  (** val add : positive -> positive -> positive **)

  let rec add x y =
    match x with
    | XI p ->
      (match y with
       | XI q -> XO (add_carry p q)
       | XO q -> XI (add p q)
       | XH -> XO (succ p))
    | XO p ->
      (match y with
       | XI q -> XI (add p q)
       | XO q -> XO (add p q)
       | XH -> XI p)
    | XH -> (match y with
             | XI q -> XO (succ q)
             | XO q -> XI q
             | XH -> XO XH)

  (** val add_carry : positive -> positive -> positive **)

  and add_carry x y =
    match x with
    | XI p ->
      (match y with
       | XI q -> XI (add_carry p q)
       | XO q -> XO (add_carry p q)
       | XH -> XI (succ p))
    | XO p ->
      (match y with
       | XI q -> XO (add_carry p q)
       | XO q -> XI (add p q)
       | XH -> XO (succ p))
    | XH ->
      (match y with
       | XI q -> XI (succ q)
       | XO q -> XO (succ q)
       | XH -> XI XH)

  (** val pred_double : positive -> positive **)

  let rec pred_double = function
  | XI p -> XI (XO p)
  | XO p -> XI (pred_double p)
  | XH -> XH

  (** val mul : positive -> positive -> positive **)

  let rec mul x y =
    match x with
    | XI p -> add y (XO (mul p y))
    | XO p -> XO (mul p y)
    | XH -> y

  (** val iter : ('a1 -> 'a1) -> 'a1 -> positive -> 'a1 **)

  let rec iter f x = function
  | XI n' -> f (iter f (iter f x n') n')
  | XO n' -> iter f (iter f x n') n'
  | XH -> f x

  (** val compare_cont : comparison -> positive -> positive -> comparison **)

  let rec compare_cont r x y =
    match x with
    | XI p ->
      (match y with
       | XI q -> compare_cont r p q
       | XO q -> compare_cont Gt p q
       | XH -> Gt)
    | XO p ->
      (match y with
       | XI q -> compare_cont Lt p q
       | XO q -> compare_cont r p q
       | XH -> Gt)
    | XH -> (match y with
             | XH -> r
             | _ -> Lt)

  (** val compare : positive -> positive -> comparison **)

  let compare =
    compare_cont Eq

  (** val eqb : positive -> positive -> bool **)

  let rec eqb p q =
    match p with
    | XI p0 -> (match q with
                | XI q0 -> eqb p0 q0
                | _ -> false)
    | XO p0 -> (match q with
                | XO q0 -> eqb p0 q0
                | _ -> false)
    | XH -> (match q with
             | XH -> true
             | _ -> false)

  (** val iter_op : ('a1 -> 'a1 -> 'a1) -> positive -> 'a1 -> 'a1 **)

  let rec iter_op op p a =
    match p with
    | XI p0 -> op a (iter_op op p0 (op a a))
    | XO p0 -> iter_op op p0 (op a a)
    | XH -> a

  (** val to_nat : positive -> nat **)

  let to_nat x =
    iter_op Coq__1.add x (S O)

  (** val of_succ_nat : nat -> positive **)

  let rec of_succ_nat = function
  | O -> XH
  | S x -> succ (of_succ_nat x)
 end

module Z =
 struct
  (** val double : z -> z **)

  let double = function
  | Z0 -> Z0
  | Zpos p -> Zpos (XO p)
  | Zneg p -> Zneg (XO p)

  (** val succ_double : z -> z **)

  let succ_double = function
  | Z0 -> Zpos XH
  | Zpos p -> Zpos (XI p)
  | Zneg p -> Zneg (Pos.pred_double p)

  (** val pred_double : z -> z **)

  let pred_double = function
  | Z0 -> Zneg XH
  | Zpos p -> Zpos (Pos.pred_double p)
  | Zneg p -> Zneg (XI p)

  (** val pos_sub : positive -> positive -> z **)

  let rec pos_sub x y =
    match x with
    | XI p ->
      (match y with
       | XI q -> double (pos_sub p q)
       | XO q -> succ_double (pos_sub p q)
       | XH -> Zpos (XO p))
    | XO p ->
      (match y with
       | XI q -> pred_double (pos_sub p q)
       | XO q -> double (pos_sub p q)
       | XH -> Zpos (Pos.pred_double p))
    | XH ->
      (match y with
       | XI q -> Zneg (XO q)
       | XO q -> Zneg (Pos.pred_double q)
       | XH -> Z0)

  (** val add : z -> z -> z **)

  let add x y =
    match x with
    | Z0 -> y
    | Zpos x' ->
      (match y with
       | Z0 -> x
       | Zpos y' -> Zpos (Pos.add x' y')
       | Zneg y' -> pos_sub x' y')
    | Zneg x' ->
      (match y with
       | Z0 -> x
       | Zpos y' -> pos_sub y' x'
       | Zneg y' -> Zneg (Pos.add x' y'))

  (** val opp : z -> z **)

  let opp = function
  | Z0 -> Z0
  | Zpos x0 -> Zneg x0
  | Zneg x0 -> Zpos x0

  (** val sub : z -> z -> z **)

  let sub m n =
    add m (opp n)

  (** val mul : z -> z -> z **)

  let mul x y =
    match x with
    | Z0 -> Z0
    | Zpos x' ->
      (match y with
       | Z0 -> Z0
       | Zpos y' -> Zpos (Pos.mul x' y')
       | Zneg y' -> Zneg (Pos.mul x' y'))
    | Zneg x' ->
      (match y with
       | Z0 -> Z0
       | Zpos y' -> Zneg (Pos.mul x' y')
       | Zneg y' -> Zpos (Pos.mul x' y'))

  (** val pow_pos : z -> positive -> z **)

  let pow_pos z0 =
    Pos.iter (mul z0) (Zpos XH)

  (** val pow : z -> z -> z **)

  let pow x = function
  | Z0 -> Zpos XH
  | Zpos p -> pow_pos x p
  | Zneg _ -> Z0

  (** val compare : z -> z -> comparison **)

  let compare x y =
    match x with
    | Z0 -> (match y with
             | Z0 -> Eq
             | Zpos _ -> Lt
             | Zneg _ -> Gt)
    | Zpos x' -> (match y with
                  | Zpos y' -> Pos.compare x' y'
                  | _ -> Gt)
    | Zneg x' ->
      (match y with
       | Zneg y' -> compOpp (Pos.compare x' y')
       | _ -> Lt)

  (** val leb : z -> z -> bool **)

  let leb x y =
    match compare x y with
    | Gt -> false
    | _ -> true

  (** val ltb : z -> z -> bool **)

  let ltb x y =
    match compare x y with
    | Lt -> true
    | _ -> false

  (** val eqb : z -> z -> bool **)

  let eqb x y =
    match x with
    | Z0 -> (match y with
             | Z0 -> true
             | _ -> false)
    | Zpos p -> (match y with
                 | Zpos q -> Pos.eqb p q
                 | _ -> false)
    | Zneg p -> (match y with
                 | Zneg q -> Pos.eqb p q
                 | _ -> false)

  (** val max : z -> z -> z **)

  let max n m =
    match compare n m with
    | Lt -> m
    | _ -> n

  (** val min : z -> z -> z **)

  let min n m =
    match compare n m with
    | Gt -> m
    | _ -> n

  (** val to_nat : z -> nat **)

  let to_nat = function
  | Zpos p -> Pos.to_nat p
  | _ -> O

  (** val of_nat : nat -> z **)

  let of_nat = function
  | O -> Z0
  | S n0 -> Zpos (Pos.of_succ_nat n0)

  (** val pos_div_eucl : positive -> z -> z * z **)

  let rec pos_div_eucl a b =
    match a with
    | XI a' ->
      let (q, r) = pos_div_eucl a' b in
      let r' = add (mul (Zpos (XO XH)) r) (Zpos XH) in
      if ltb r' b
      then ((mul (Zpos (XO XH)) q), r')
      else ((add (mul (Zpos (XO XH)) q) (Zpos XH)), (sub r' b))
    | XO a' ->
      let (q, r) = pos_div_eucl a' b in
      let r' = mul (Zpos (XO XH)) r in
      if ltb r' b
      then ((mul (Zpos (XO XH)) q), r')
      else ((add (mul (Zpos (XO XH)) q) (Zpos XH)), (sub r' b))
    | XH -> if leb (Zpos (XO XH)) b then (Z0, (Zpos XH)) else ((Zpos XH), Z0)

  (** val div_eucl : z -> z -> z * z **)

  let div_eucl a b =
    match a with
    | Z0 -> (Z0, Z0)
    | Zpos a' ->
      (match b with
       | Z0 -> (Z0, a)
       | Zpos _ -> pos_div_eucl a' b
       | Zneg b' ->
         let (q, r) = pos_div_eucl a' (Zpos b') in
         (match r with
          | Z0 -> ((opp q), Z0)
          | _ -> ((opp (add q (Zpos XH))), (add b r))))
    | Zneg a' ->
      (match b with
       | Z0 -> (Z0, a)
       | Zpos _ ->
         let (q, r) = pos_div_eucl a' b in
         (match r with
          | Z0 -> ((opp q), Z0)
          | _ -> ((opp (add q (Zpos XH))), (sub b r)))
       | Zneg b' -> let (q, r) = pos_div_eucl a' (Zpos b') in (q, (opp r)))

  (** val div : z -> z -> z **)

  let div a b =
    let (q, _) = div_eucl a b in q

  (** val even : z -> bool **)

  let even = function
  | Z0 -> true
  | Zpos p -> (match p with
               | XO _ -> true
               | _ -> false)
  | Zneg p -> (match p with
               | XO _ -> true
               | _ -> false)
 end

(** val map : ('a1 -> 'a2) -> 'a1 list -> 'a2 list **)

let rec map f = function
| [] -> []
| a :: t0 -> (f a) :: (map f t0)

(** val flat_map : ('a1 -> 'a2 list) -> 'a1 list -> 'a2 list **)

let rec flat_map f = function
| [] -> []
| x :: t0 -> app (f x) (flat_map f t0)

(** val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1 **)

let rec fold_left f l a0 =
  match l with
  | [] -> a0
  | b :: t0 -> fold_left f t0 (f a0 b)

(** val existsb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec existsb f = function
| [] -> false
| a :: l0 -> (||) (f a) (existsb f l0)

(** val forallb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec forallb f = function
| [] -> true
| a :: l0 -> (&&) (f a) (forallb f l0)

(** val filter : ('a1 -> bool) -> 'a1 list -> 'a1 list **)

let rec filter f = function
| [] -> []
| x :: l0 -> if f x then x :: (filter f l0) else filter f l0

(** val list_prod : 'a1 list -> 'a2 list -> ('a1 * 'a2) list **)

let rec list_prod l l' =
  match l with
  | [] -> []
  | x :: t0 -> app (map (fun y -> (x, y)) l') (list_prod t0 l')

(** val seq : nat -> nat -> nat list **)

let rec seq start = function
| O -> []
| S len0 -> start :: (seq (S start) len0)

type coord3 =
| C3 of z * z * z

(** val translate : coord3 -> coord3 -> coord3 **)

let translate a b =
  let C3 (ax, ay, az) = a in
  let C3 (bx, by_, bz) = b in
  C3 ((Z.add ax bx), (Z.add ay by_), (Z.add az bz))

(** val scale : z -> coord3 -> coord3 **)

let scale n = function
| C3 (x, y, z0) -> C3 ((Z.mul n x), (Z.mul n y), (Z.mul n z0))

(** val difference : coord3 -> coord3 -> coord3 **)

let difference a b =
  let C3 (ax, ay, az) = a in
  let C3 (bx, by_, bz) = b in
  C3 ((Z.sub bx ax), (Z.sub by_ ay), (Z.sub bz az))

(** val coord3Equal : coord3 -> coord3 -> bool **)

let coord3Equal a b =
  let C3 (ax, ay, az) = a in
  let C3 (bx, by_, bz) = b in
  (&&) ((&&) (Z.eqb ax bx) (Z.eqb ay by_)) (Z.eqb az bz)

type direction =
| Dir_p00
| Dir_m00
| Dir_0p0
| Dir_0m0
| Dir_00p
| Dir_00m
| Dir_ppp
| Dir_mmm
| Dir_ppm
| Dir_mmp
| Dir_pmp
| Dir_mpm
| Dir_mpp
| Dir_pmm

(** val allDirections : direction list **)

let allDirections =
  Dir_p00 :: (Dir_m00 :: (Dir_0p0 :: (Dir_0m0 :: (Dir_00p :: (Dir_00m :: (Dir_ppp :: (Dir_mmm :: (Dir_ppm :: (Dir_mmp :: (Dir_pmp :: (Dir_mpm :: (Dir_mpp :: (Dir_pmm :: [])))))))))))))

(** val offset : direction -> coord3 **)

let offset = function
| Dir_p00 -> C3 ((Zpos (XO XH)), Z0, Z0)
| Dir_m00 -> C3 ((Zneg (XO XH)), Z0, Z0)
| Dir_0p0 -> C3 (Z0, (Zpos (XO XH)), Z0)
| Dir_0m0 -> C3 (Z0, (Zneg (XO XH)), Z0)
| Dir_00p -> C3 (Z0, Z0, (Zpos (XO XH)))
| Dir_00m -> C3 (Z0, Z0, (Zneg (XO XH)))
| Dir_ppp -> C3 ((Zpos XH), (Zpos XH), (Zpos XH))
| Dir_mmm -> C3 ((Zneg XH), (Zneg XH), (Zneg XH))
| Dir_ppm -> C3 ((Zpos XH), (Zpos XH), (Zneg XH))
| Dir_mmp -> C3 ((Zneg XH), (Zneg XH), (Zpos XH))
| Dir_pmp -> C3 ((Zpos XH), (Zneg XH), (Zpos XH))
| Dir_mpm -> C3 ((Zneg XH), (Zpos XH), (Zneg XH))
| Dir_mpp -> C3 ((Zneg XH), (Zpos XH), (Zpos XH))
| Dir_pmm -> C3 ((Zpos XH), (Zneg XH), (Zneg XH))

type edgeKind =
| Long
| Short

(** val directionKind : direction -> edgeKind **)

let directionKind = function
| Dir_p00 -> Long
| Dir_m00 -> Long
| Dir_0p0 -> Long
| Dir_0m0 -> Long
| Dir_00p -> Long
| Dir_00m -> Long
| _ -> Short

(** val lengthSquared : edgeKind -> z **)

let lengthSquared = function
| Long -> Zpos (XO (XO XH))
| Short -> Zpos (XI XH)

type structuredTetCase =
| Tet_I1
| Tet_I2
| Tet_I3
| Tet_I4
| Tet_J1
| Tet_J2
| Tet_J3
| Tet_J4
| Tet_K1
| Tet_K2
| Tet_K3
| Tet_K4

type structuredTetId =
| STId of coord3 * structuredTetCase

type vertexOrder =
  coord3 -> coord3 -> coord3 -> coord3 ->
  ((coord3 * coord3) * coord3) * coord3

type structuredTet =
| ST of coord3 * coord3 * coord3 * coord3 * (structuredTetId * vertexOrder)
   * (structuredTetId * vertexOrder) * (structuredTetId * vertexOrder)
   * (structuredTetId * vertexOrder)

(** val order1234 : vertexOrder **)

let order1234 a b c d =
  (((a, b), c), d)

(** val order2143 : vertexOrder **)

let order2143 a b c d =
  (((b, a), d), c)

type handedness =
| RightHanded
| LeftHanded

(** val caseHandedness : structuredTetCase -> handedness **)

let caseHandedness = function
| Tet_I1 -> RightHanded
| Tet_I4 -> RightHanded
| Tet_J2 -> RightHanded
| Tet_J3 -> RightHanded
| Tet_K1 -> RightHanded
| Tet_K4 -> RightHanded
| _ -> LeftHanded

(** val getStructuredTet : structuredTetId -> structuredTet **)

let getStructuredTet = function
| STId (anchor, case) ->
  let v = fun x y z0 -> translate anchor (C3 (x, y, z0)) in
  let nei = fun x y z0 c -> STId ((v x y z0), c) in
  (match case with
   | Tet_I1 ->
     ST ((v Z0 (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos (XO XH)) (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos XH) (Zpos (XI XH)) (Zpos XH)),
       (v (Zpos XH) (Zpos (XI XH)) (Zpos (XI XH))),
       ((nei Z0 (Zpos (XO XH)) Z0 Tet_J4), order2143),
       ((nei (Zneg (XO XH)) (Zpos (XO XH)) Z0 Tet_J1), order1234),
       ((nei Z0 Z0 Z0 Tet_I3), order1234), ((nei Z0 Z0 Z0 Tet_I2), order1234))
   | Tet_I2 ->
     ST ((v Z0 (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos (XO XH)) (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos XH) (Zpos (XI XH)) (Zpos XH)),
       (v (Zpos XH) (Zpos XH) (Zpos XH)), ((nei Z0 Z0 Z0 Tet_K4), order1234),
       ((nei (Zneg (XO XH)) Z0 Z0 Tet_K1), order2143),
       ((nei Z0 Z0 Z0 Tet_I4), order1234), ((nei Z0 Z0 Z0 Tet_I1), order1234))
   | Tet_I3 ->
     ST ((v Z0 (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos (XO XH)) (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos XH) (Zpos XH) (Zpos (XI XH))),
       (v (Zpos XH) (Zpos (XI XH)) (Zpos (XI XH))),
       ((nei Z0 Z0 (Zpos (XO XH)) Tet_K4), order2143),
       ((nei (Zneg (XO XH)) Z0 (Zpos (XO XH)) Tet_K1), order1234),
       ((nei Z0 Z0 Z0 Tet_I1), order1234), ((nei Z0 Z0 Z0 Tet_I4), order1234))
   | Tet_I4 ->
     ST ((v Z0 (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos (XO XH)) (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos XH) (Zpos XH) (Zpos (XI XH))),
       (v (Zpos XH) (Zpos XH) (Zpos XH)), ((nei Z0 Z0 Z0 Tet_J4), order1234),
       ((nei (Zneg (XO XH)) Z0 Z0 Tet_J1), order2143),
       ((nei Z0 Z0 Z0 Tet_I2), order1234), ((nei Z0 Z0 Z0 Tet_I3), order1234))
   | Tet_J1 ->
     ST ((v (Zpos (XO XH)) Z0 (Zpos (XO XH))),
       (v (Zpos (XO XH)) (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos (XI XH)) (Zpos XH) (Zpos XH)),
       (v (Zpos (XI XH)) (Zpos XH) (Zpos (XI XH))),
       ((nei (Zpos (XO XH)) Z0 Z0 Tet_I4), order2143),
       ((nei (Zpos (XO XH)) (Zneg (XO XH)) Z0 Tet_I1), order1234),
       ((nei Z0 Z0 Z0 Tet_J3), order1234), ((nei Z0 Z0 Z0 Tet_J2), order1234))
   | Tet_J2 ->
     ST ((v (Zpos (XO XH)) Z0 (Zpos (XO XH))),
       (v (Zpos (XO XH)) (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos (XI XH)) (Zpos XH) (Zpos XH)),
       (v (Zpos XH) (Zpos XH) (Zpos XH)), ((nei Z0 Z0 Z0 Tet_K2), order1234),
       ((nei Z0 (Zneg (XO XH)) Z0 Tet_K3), order2143),
       ((nei Z0 Z0 Z0 Tet_J4), order1234), ((nei Z0 Z0 Z0 Tet_J1), order1234))
   | Tet_J3 ->
     ST ((v (Zpos (XO XH)) Z0 (Zpos (XO XH))),
       (v (Zpos (XO XH)) (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos XH) (Zpos XH) (Zpos (XI XH))),
       (v (Zpos (XI XH)) (Zpos XH) (Zpos (XI XH))),
       ((nei Z0 Z0 (Zpos (XO XH)) Tet_K2), order2143),
       ((nei Z0 (Zneg (XO XH)) (Zpos (XO XH)) Tet_K3), order1234),
       ((nei Z0 Z0 Z0 Tet_J1), order1234), ((nei Z0 Z0 Z0 Tet_J4), order1234))
   | Tet_J4 ->
     ST ((v (Zpos (XO XH)) Z0 (Zpos (XO XH))),
       (v (Zpos (XO XH)) (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos XH) (Zpos XH) (Zpos (XI XH))),
       (v (Zpos XH) (Zpos XH) (Zpos XH)), ((nei Z0 Z0 Z0 Tet_I4), order1234),
       ((nei Z0 (Zneg (XO XH)) Z0 Tet_I1), order2143),
       ((nei Z0 Z0 Z0 Tet_J2), order1234), ((nei Z0 Z0 Z0 Tet_J3), order1234))
   | Tet_K1 ->
     ST ((v (Zpos (XO XH)) (Zpos (XO XH)) Z0),
       (v (Zpos (XO XH)) (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos (XI XH)) (Zpos XH) (Zpos XH)),
       (v (Zpos (XI XH)) (Zpos (XI XH)) (Zpos XH)),
       ((nei (Zpos (XO XH)) Z0 Z0 Tet_I2), order2143),
       ((nei (Zpos (XO XH)) Z0 (Zneg (XO XH)) Tet_I3), order1234),
       ((nei Z0 Z0 Z0 Tet_K3), order1234), ((nei Z0 Z0 Z0 Tet_K2), order1234))
   | Tet_K2 ->
     ST ((v (Zpos (XO XH)) (Zpos (XO XH)) Z0),
       (v (Zpos (XO XH)) (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos (XI XH)) (Zpos XH) (Zpos XH)),
       (v (Zpos XH) (Zpos XH) (Zpos XH)), ((nei Z0 Z0 Z0 Tet_J2), order1234),
       ((nei Z0 Z0 (Zneg (XO XH)) Tet_J3), order2143),
       ((nei Z0 Z0 Z0 Tet_K4), order1234), ((nei Z0 Z0 Z0 Tet_K1), order1234))
   | Tet_K3 ->
     ST ((v (Zpos (XO XH)) (Zpos (XO XH)) Z0),
       (v (Zpos (XO XH)) (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos XH) (Zpos (XI XH)) (Zpos XH)),
       (v (Zpos (XI XH)) (Zpos (XI XH)) (Zpos XH)),
       ((nei Z0 (Zpos (XO XH)) Z0 Tet_J2), order2143),
       ((nei Z0 (Zpos (XO XH)) (Zneg (XO XH)) Tet_J3), order1234),
       ((nei Z0 Z0 Z0 Tet_K1), order1234), ((nei Z0 Z0 Z0 Tet_K4), order1234))
   | Tet_K4 ->
     ST ((v (Zpos (XO XH)) (Zpos (XO XH)) Z0),
       (v (Zpos (XO XH)) (Zpos (XO XH)) (Zpos (XO XH))),
       (v (Zpos XH) (Zpos (XI XH)) (Zpos XH)),
       (v (Zpos XH) (Zpos XH) (Zpos XH)), ((nei Z0 Z0 Z0 Tet_I2), order1234),
       ((nei Z0 Z0 (Zneg (XO XH)) Tet_I3), order2143),
       ((nei Z0 Z0 Z0 Tet_K2), order1234), ((nei Z0 Z0 Z0 Tet_K3), order1234)))

(** val allCases : structuredTetCase list **)

let allCases =
  Tet_I1 :: (Tet_I2 :: (Tet_I3 :: (Tet_I4 :: (Tet_J1 :: (Tet_J2 :: (Tet_J3 :: (Tet_J4 :: (Tet_K1 :: (Tet_K2 :: (Tet_K3 :: (Tet_K4 :: [])))))))))))

type place =
| First
| Second
| Third
| Fourth

type sign =
| Plus
| OnSurface
| Minus

type 'vertex unstructuredTet =
| UT of 'vertex * 'vertex * 'vertex * 'vertex

(** val getUnstructuredTets :
    ('a1 -> sign) -> ('a1 -> 'a1 -> 'a1) -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a1
    unstructuredTet list **)

let getUnstructuredTets getSign getIntersection v1 v2 v3 v4 =
  match getSign v1 with
  | Plus ->
    (match getSign v2 with
     | Plus ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Minus ->
             (UT (v2, v1, (getIntersection v3 v4), v3)) :: ((UT (v2, v1,
               (getIntersection v1 v4), (getIntersection v3 v4))) :: ((UT
               (v2, (getIntersection v1 v4), (getIntersection v2 v4),
               (getIntersection v3 v4))) :: []))
           | _ -> (UT (v1, v2, v3, v4)) :: [])
        | OnSurface ->
          (match getSign v4 with
           | Minus ->
             (UT (v2, v1, (getIntersection v1 v4), v3)) :: ((UT (v2,
               (getIntersection v1 v4), (getIntersection v2 v4), v3)) :: [])
           | _ -> (UT (v1, v2, v3, v4)) :: [])
        | Minus ->
          (match getSign v4 with
           | Plus ->
             (UT (v1, v2, (getIntersection v4 v3), v4)) :: ((UT (v1, v2,
               (getIntersection v2 v3), (getIntersection v4 v3))) :: ((UT
               (v1, (getIntersection v2 v3), (getIntersection v1 v3),
               (getIntersection v4 v3))) :: []))
           | OnSurface ->
             (UT (v1, v2, (getIntersection v2 v3), v4)) :: ((UT (v1,
               (getIntersection v2 v3), (getIntersection v1 v3), v4)) :: [])
           | Minus ->
             (UT (v1, v2, (getIntersection v2 v3),
               (getIntersection v1 v4))) :: ((UT (v1,
               (getIntersection v2 v3), (getIntersection v1 v3),
               (getIntersection v1 v4))) :: ((UT (v2,
               (getIntersection v2 v3), (getIntersection v1 v4),
               (getIntersection v2 v4))) :: []))))
     | OnSurface ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Minus ->
             (UT (v1, v3, (getIntersection v3 v4), v2)) :: ((UT (v1,
               (getIntersection v3 v4), (getIntersection v1 v4), v2)) :: [])
           | _ -> (UT (v1, v2, v3, v4)) :: [])
        | OnSurface ->
          (match getSign v4 with
           | Minus -> (UT (v1, v2, v3, (getIntersection v1 v4))) :: []
           | _ -> (UT (v1, v2, v3, v4)) :: [])
        | Minus ->
          (match getSign v4 with
           | Plus ->
             (UT (v1, v4, v2, (getIntersection v4 v3))) :: ((UT (v1,
               (getIntersection v4 v3), v2, (getIntersection v1 v3))) :: [])
           | OnSurface -> (UT (v1, v2, (getIntersection v1 v3), v4)) :: []
           | Minus ->
             (UT (v1, v2, (getIntersection v1 v3),
               (getIntersection v1 v4))) :: []))
     | Minus ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Plus ->
             (UT (v4, v3, (getIntersection v1 v2), v1)) :: ((UT (v4, v3,
               (getIntersection v3 v2), (getIntersection v1 v2))) :: ((UT
               (v4, (getIntersection v3 v2), (getIntersection v4 v2),
               (getIntersection v1 v2))) :: []))
           | OnSurface ->
             (UT (v3, v1, (getIntersection v1 v2), v4)) :: ((UT (v3,
               (getIntersection v1 v2), (getIntersection v3 v2), v4)) :: [])
           | Minus ->
             (UT (v1, v3, (getIntersection v3 v4),
               (getIntersection v1 v2))) :: ((UT (v1,
               (getIntersection v3 v4), (getIntersection v1 v4),
               (getIntersection v1 v2))) :: ((UT (v3,
               (getIntersection v3 v4), (getIntersection v1 v2),
               (getIntersection v3 v2))) :: [])))
        | OnSurface ->
          (match getSign v4 with
           | Plus ->
             (UT (v4, v1, v3, (getIntersection v1 v2))) :: ((UT (v4,
               (getIntersection v1 v2), v3, (getIntersection v4 v2))) :: [])
           | OnSurface -> (UT (v1, (getIntersection v1 v2), v3, v4)) :: []
           | Minus ->
             (UT (v1, (getIntersection v1 v2), v3,
               (getIntersection v1 v4))) :: [])
        | Minus ->
          (match getSign v4 with
           | Plus ->
             (UT (v1, v4, (getIntersection v1 v2),
               (getIntersection v4 v3))) :: ((UT (v1,
               (getIntersection v4 v3), (getIntersection v1 v2),
               (getIntersection v1 v3))) :: ((UT (v4,
               (getIntersection v4 v3), (getIntersection v4 v2),
               (getIntersection v1 v2))) :: []))
           | OnSurface ->
             (UT (v1, (getIntersection v1 v2), (getIntersection v1 v3),
               v4)) :: []
           | Minus ->
             (UT (v1, (getIntersection v1 v2), (getIntersection v1 v3),
               (getIntersection v1 v4))) :: [])))
  | OnSurface ->
    (match getSign v2 with
     | Plus ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Minus ->
             (UT (v2, v3, v1, (getIntersection v3 v4))) :: ((UT (v2,
               (getIntersection v3 v4), v1, (getIntersection v2 v4))) :: [])
           | _ -> (UT (v1, v2, v3, v4)) :: [])
        | OnSurface ->
          (match getSign v4 with
           | Minus -> (UT (v2, v1, (getIntersection v2 v4), v3)) :: []
           | _ -> (UT (v1, v2, v3, v4)) :: [])
        | Minus ->
          (match getSign v4 with
           | Plus ->
             (UT (v2, v4, (getIntersection v4 v3), v1)) :: ((UT (v2,
               (getIntersection v4 v3), (getIntersection v2 v3), v1)) :: [])
           | OnSurface -> (UT (v2, v1, v4, (getIntersection v2 v3))) :: []
           | Minus ->
             (UT (v2, v1, (getIntersection v2 v4),
               (getIntersection v2 v3))) :: []))
     | OnSurface ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Minus -> (UT (v3, (getIntersection v3 v4), v1, v2)) :: []
           | _ -> (UT (v1, v2, v3, v4)) :: [])
        | OnSurface ->
          (match getSign v4 with
           | Plus -> (UT (v1, v2, v3, v4)) :: []
           | _ -> [])
        | Minus ->
          (match getSign v4 with
           | Plus -> (UT (v4, (getIntersection v4 v3), v2, v1)) :: []
           | _ -> []))
     | Minus ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Plus ->
             (UT (v4, v3, (getIntersection v3 v2), v1)) :: ((UT (v4,
               (getIntersection v3 v2), (getIntersection v4 v2), v1)) :: [])
           | OnSurface -> (UT (v3, v4, v1, (getIntersection v3 v2))) :: []
           | Minus ->
             (UT (v3, (getIntersection v3 v4), v1,
               (getIntersection v3 v2))) :: [])
        | OnSurface ->
          (match getSign v4 with
           | Plus -> (UT (v4, v3, (getIntersection v4 v2), v1)) :: []
           | _ -> [])
        | Minus ->
          (match getSign v4 with
           | Plus ->
             (UT (v4, (getIntersection v4 v3), (getIntersection v4 v2),
               v1)) :: []
           | _ -> [])))
  | Minus ->
    (match getSign v2 with
     | Plus ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Plus ->
             (UT (v3, v4, (getIntersection v2 v1), v2)) :: ((UT (v3, v4,
               (getIntersection v4 v1), (getIntersection v2 v1))) :: ((UT
               (v3, (getIntersection v4 v1), (getIntersection v3 v1),
               (getIntersection v2 v1))) :: []))
           | OnSurface ->
             (UT (v3, v2, v4, (getIntersection v2 v1))) :: ((UT (v3,
               (getIntersection v2 v1), v4, (getIntersection v3 v1))) :: [])
           | Minus ->
             (UT (v2, v3, (getIntersection v2 v1),
               (getIntersection v3 v4))) :: ((UT (v2,
               (getIntersection v3 v4), (getIntersection v2 v1),
               (getIntersection v2 v4))) :: ((UT (v3,
               (getIntersection v3 v4), (getIntersection v3 v1),
               (getIntersection v2 v1))) :: [])))
        | OnSurface ->
          (match getSign v4 with
           | Plus ->
             (UT (v4, v2, (getIntersection v2 v1), v3)) :: ((UT (v4,
               (getIntersection v2 v1), (getIntersection v4 v1), v3)) :: [])
           | OnSurface -> (UT (v2, (getIntersection v2 v1), v4, v3)) :: []
           | Minus ->
             (UT (v2, (getIntersection v2 v1), (getIntersection v2 v4),
               v3)) :: [])
        | Minus ->
          (match getSign v4 with
           | Plus ->
             (UT (v2, v4, (getIntersection v4 v3),
               (getIntersection v2 v1))) :: ((UT (v2,
               (getIntersection v4 v3), (getIntersection v2 v3),
               (getIntersection v2 v1))) :: ((UT (v4,
               (getIntersection v4 v3), (getIntersection v2 v1),
               (getIntersection v4 v1))) :: []))
           | OnSurface ->
             (UT (v2, (getIntersection v2 v1), v4,
               (getIntersection v2 v3))) :: []
           | Minus ->
             (UT (v2, (getIntersection v2 v1), (getIntersection v2 v4),
               (getIntersection v2 v3))) :: []))
     | OnSurface ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Plus ->
             (UT (v3, v4, (getIntersection v4 v1), v2)) :: ((UT (v3,
               (getIntersection v4 v1), (getIntersection v3 v1), v2)) :: [])
           | OnSurface -> (UT (v3, v4, (getIntersection v3 v1), v2)) :: []
           | Minus ->
             (UT (v3, (getIntersection v3 v4), (getIntersection v3 v1),
               v2)) :: [])
        | OnSurface ->
          (match getSign v4 with
           | Plus -> (UT (v4, v3, v2, (getIntersection v4 v1))) :: []
           | _ -> [])
        | Minus ->
          (match getSign v4 with
           | Plus ->
             (UT (v4, (getIntersection v4 v3), v2,
               (getIntersection v4 v1))) :: []
           | _ -> []))
     | Minus ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Plus ->
             (UT (v3, v4, (getIntersection v4 v1),
               (getIntersection v3 v2))) :: ((UT (v3,
               (getIntersection v4 v1), (getIntersection v3 v1),
               (getIntersection v3 v2))) :: ((UT (v4,
               (getIntersection v4 v1), (getIntersection v3 v2),
               (getIntersection v4 v2))) :: []))
           | OnSurface ->
             (UT (v3, v4, (getIntersection v3 v1),
               (getIntersection v3 v2))) :: []
           | Minus ->
             (UT (v3, (getIntersection v3 v4), (getIntersection v3 v1),
               (getIntersection v3 v2))) :: [])
        | OnSurface ->
          (match getSign v4 with
           | Plus ->
             (UT (v4, v3, (getIntersection v4 v2),
               (getIntersection v4 v1))) :: []
           | _ -> [])
        | Minus ->
          (match getSign v4 with
           | Plus ->
             (UT (v4, (getIntersection v4 v3), (getIntersection v4 v2),
               (getIntersection v4 v1))) :: []
           | _ -> [])))

(** val mapTet :
    ('a1 -> 'a2) -> 'a1 unstructuredTet -> 'a2 unstructuredTet **)

let mapTet f = function
| UT (a, b, c, d) -> UT ((f a), (f b), (f c), (f d))

(** val stepBits : nat **)

let stepBits =
  S (S (S (S (S (S (S (S (S (S (S (S (S (S (S (S O)))))))))))))))

(** val steps : z **)

let steps =
  Z.pow (Zpos (XO XH)) (Z.of_nat stepBits)

(** val bisectFrom : (z -> sign) -> nat -> z -> z **)

let rec bisectFrom sign0 rounds lo =
  match rounds with
  | O -> lo
  | S r ->
    let middle = Z.add lo (Z.pow (Zpos (XO XH)) (Z.of_nat r)) in
    (match sign0 middle with
     | Plus -> bisectFrom sign0 r middle
     | OnSurface -> middle
     | Minus -> bisectFrom sign0 r lo)

(** val bisect : (z -> sign) -> z **)

let bisect sign0 =
  bisectFrom sign0 stepBits Z0

(** val midpointCut : z **)

let midpointCut =
  Z.div steps (Zpos (XO XH))

(** val inOrOut : sign -> sign **)

let inOrOut = function
| Minus -> Minus
| _ -> Plus

(** val pointOnEdge : coord3 -> coord3 -> z -> coord3 **)

let pointOnEdge a b t0 =
  translate (scale steps a) (scale t0 (difference a b))

type thresholds =
| TH of z * z

(** val angleThresholds : thresholds **)

let angleThresholds =
  TH ((Zpos (XI (XO (XO (XI (XO (XO XH))))))), (Zpos (XO (XI (XI (XO (XO (XI
    XH))))))))

(** val embeddingThresholds : thresholds **)

let embeddingThresholds =
  TH ((Zpos (XO (XO (XO (XO (XO (XO XH))))))), (Zpos (XI (XO (XO (XI (XO (XI
    XH))))))))

(** val noWarpThresholds : thresholds **)

let noWarpThresholds =
  TH (Z0, Z0)

(** val thresholdSteps : thresholds -> edgeKind -> z **)

let thresholdSteps th k =
  let TH (long, short) = th in
  (match k with
   | Long ->
     Z.mul long
       (Z.div steps (Zpos (XO (XO (XO (XO (XO (XO (XO (XO XH))))))))))
   | Short ->
     Z.mul short
       (Z.div steps (Zpos (XO (XO (XO (XO (XO (XO (XO (XO XH)))))))))))

type warping =
| Stays
| Moves of direction * z

(** val opposite : sign -> sign -> bool **)

let opposite a b =
  match a with
  | Plus -> (match b with
             | Minus -> true
             | _ -> false)
  | OnSurface -> false
  | Minus -> (match b with
              | Plus -> true
              | _ -> false)

(** val violates :
    thresholds -> sign -> (direction -> sign) -> (direction -> z) ->
    direction -> bool **)

let violates th sign0 neighbor_sign cut d =
  (&&) (opposite sign0 (neighbor_sign d))
    (Z.ltb (cut d) (thresholdSteps th (directionKind d)))

(** val cutDistanceSquared : (direction -> z) -> direction -> z **)

let cutDistanceSquared cut d =
  Z.mul (lengthSquared (directionKind d)) (Z.mul (cut d) (cut d))

(** val nearerOf :
    thresholds -> sign -> (direction -> sign) -> (direction -> z) -> warping
    -> direction -> warping **)

let nearerOf th sign0 neighbor_sign cut best d =
  if violates th sign0 neighbor_sign cut d
  then (match best with
        | Stays -> Moves (d, (cut d))
        | Moves (e, _) ->
          if Z.ltb (cutDistanceSquared cut d) (cutDistanceSquared cut e)
          then Moves (d, (cut d))
          else best)
  else best

(** val warp :
    thresholds -> sign -> (direction -> sign) -> (direction -> z) -> warping **)

let warp th sign0 neighbor_sign cut =
  fold_left (nearerOf th sign0 neighbor_sign cut) allDirections Stays

(** val warpedSign : sign -> warping -> sign **)

let warpedSign sign0 = function
| Stays -> sign0
| Moves (_, _) -> OnSurface

(** val warpedPosition : coord3 -> warping -> coord3 **)

let warpedPosition v = function
| Stays -> scale steps v
| Moves (d, t0) -> translate (scale steps v) (scale t0 (offset d))

type signField = coord3 -> sign

type cutField = coord3 -> coord3 -> z

type meshVertex =
| Corner of coord3
| Cut of coord3 * coord3

(** val cutFrom : signField -> cutField -> coord3 -> direction -> z **)

let cutFrom sign0 cut v d =
  let u = translate v (offset d) in
  (match sign0 v with
   | Plus -> cut v u
   | _ -> Z.sub steps (cut u v))

(** val warpVertex :
    thresholds -> signField -> cutField -> coord3 -> warping **)

let warpVertex th sign0 cut v =
  warp th (sign0 v) (fun d -> sign0 (translate v (offset d)))
    (cutFrom sign0 cut v)

(** val meshVertexSign :
    thresholds -> signField -> cutField -> meshVertex -> sign **)

let meshVertexSign th sign0 cut = function
| Corner c -> warpedSign (sign0 c) (warpVertex th sign0 cut c)
| Cut (_, _) -> OnSurface

(** val meshIntersection : meshVertex -> meshVertex -> meshVertex **)

let meshIntersection a b =
  match a with
  | Corner plus ->
    (match b with
     | Corner minus -> Cut (plus, minus)
     | Cut (_, _) -> a)
  | Cut (_, _) -> a

(** val meshPosition :
    thresholds -> signField -> cutField -> meshVertex -> coord3 **)

let meshPosition th sign0 cut = function
| Corner c -> warpedPosition c (warpVertex th sign0 cut c)
| Cut (plus, minus) -> pointOnEdge plus minus (cut plus minus)

(** val orient :
    handedness -> meshVertex unstructuredTet -> meshVertex unstructuredTet **)

let orient h t0 =
  match h with
  | RightHanded -> t0
  | LeftHanded -> let UT (a, b, c, d) = t0 in UT (a, b, d, c)

(** val stuffTet :
    thresholds -> signField -> cutField -> structuredTetId -> meshVertex
    unstructuredTet list **)

let stuffTet th sign0 cut = function
| STId (c, case) ->
  let ST (v1, v2, v3, v4, _, _, _, _) = getStructuredTet (STId (c, case)) in
  map (orient (caseHandedness case))
    (getUnstructuredTets (meshVertexSign th sign0 cut) meshIntersection
      (Corner v1) (Corner v2) (Corner v3) (Corner v4))

type positionSigns = coord3 -> sign

(** val sampledSigns : positionSigns -> signField **)

let sampledSigns domain v =
  domain (scale steps v)

(** val bisectedCuts : positionSigns -> cutField **)

let bisectedCuts domain plus minus =
  bisect (fun t0 -> domain (pointOnEdge plus minus t0))

(** val midpointCuts : cutField **)

let midpointCuts _ _ =
  midpointCut

(** val decided : signField -> signField **)

let decided sign0 v =
  inOrOut (sign0 v)

(** val dot : coord3 -> coord3 -> z **)

let dot u v =
  let C3 (ux, uy, uz) = u in
  let C3 (vx, vy, vz) = v in
  Z.add (Z.add (Z.mul ux vx) (Z.mul uy vy)) (Z.mul uz vz)

(** val cross : coord3 -> coord3 -> coord3 **)

let cross u v =
  let C3 (ux, uy, uz) = u in
  let C3 (vx, vy, vz) = v in
  C3 ((Z.sub (Z.mul uy vz) (Z.mul uz vy)),
  (Z.sub (Z.mul uz vx) (Z.mul ux vz)), (Z.sub (Z.mul ux vy) (Z.mul uy vx)))

(** val normal : coord3 -> coord3 -> coord3 -> coord3 **)

let normal a b c =
  cross (difference a b) (difference a c)

(** val sixVolume : coord3 -> coord3 -> coord3 -> coord3 -> z **)

let sixVolume a b c d =
  dot (normal a b c) (difference a d)

(** val edgeSquared : coord3 -> coord3 -> z **)

let edgeSquared a b =
  dot (difference a b) (difference a b)

(** val normalsProduct : coord3 -> coord3 -> coord3 -> coord3 -> z **)

let normalsProduct a b c d =
  dot (normal a b c) (normal a b d)

type cotSquared =
| CotSq of z * z

(** val dihedralEdges :
    'a1 unstructuredTet -> ((('a1 * 'a1) * 'a1) * 'a1) list **)

let dihedralEdges = function
| UT (a, b, c, d) ->
  (((a, b), c), d) :: ((((a, c), d), b) :: ((((a, d), b), c) :: ((((b, c),
    a), d) :: ((((b, d), c), a) :: ((((c, d), a), b) :: [])))))

type angleBounds =
| AB of cotSquared * cotSquared

(** val corners : structuredTetId -> coord3 list **)

let corners tid =
  let ST (v1, v2, v3, v4, _, _, _, _) = getStructuredTet tid in
  v1 :: (v2 :: (v3 :: (v4 :: [])))

(** val placedSign :
    signField -> (coord3 -> warping) -> meshVertex -> sign **)

let placedSign before0 warping0 = function
| Corner c -> warpedSign (before0 c) (warping0 c)
| Cut (_, _) -> OnSurface

(** val placedPosition :
    (coord3 -> warping) -> cutField -> meshVertex -> coord3 **)

let placedPosition warping0 cut = function
| Corner c -> warpedPosition c (warping0 c)
| Cut (plus, minus) -> pointOnEdge plus minus (cut plus minus)

(** val placedTets :
    signField -> (coord3 -> warping) -> cutField -> structuredTetId -> coord3
    unstructuredTet list **)

let placedTets before0 warping0 cut = function
| STId (c, case) ->
  let ST (v1, v2, v3, v4, _, _, _, _) = getStructuredTet (STId (c, case)) in
  map (mapTet (placedPosition warping0 cut))
    (map (orient (caseHandedness case))
      (getUnstructuredTets (placedSign before0 warping0) meshIntersection
        (Corner v1) (Corner v2) (Corner v3) (Corner v4)))

(** val widestAngles : angleBounds **)

let widestAngles =
  AB ((CotSq ((Zpos (XI (XO (XI (XI (XI (XO (XI XH)))))))), (Zpos (XO (XO (XO
    XH)))))), (CotSq ((Zpos (XI (XI (XI (XO (XI (XO (XI (XI (XO (XI
    XH))))))))))), (Zpos (XO (XI (XO (XO (XO (XO (XO XH)))))))))))

(** val placedNames :
    signField -> (coord3 -> warping) -> structuredTetId -> meshVertex
    unstructuredTet list **)

let placedNames before0 warping0 = function
| STId (c, case) ->
  let ST (v1, v2, v3, v4, _, _, _, _) = getStructuredTet (STId (c, case)) in
  map (orient (caseHandedness case))
    (getUnstructuredTets (placedSign before0 warping0) meshIntersection
      (Corner v1) (Corner v2) (Corner v3) (Corner v4))

(** val kindBetween : coord3 -> coord3 -> edgeKind **)

let kindBetween a b =
  let C3 (x, _, _) = difference a b in if Z.even x then Long else Short

(** val clampedCut : thresholds -> cutField -> coord3 -> coord3 -> z **)

let clampedCut th cut a b =
  let alpha = thresholdSteps th (kindBetween a b) in
  Z.max alpha (Z.min (Z.sub steps alpha) (cut a b))

(** val sameDirection : direction -> direction -> bool **)

let sameDirection d e =
  coord3Equal (offset d) (offset e)

(** val nextInLink : direction -> direction -> bool **)

let nextInLink d e =
  existsb (fun f ->
    coord3Equal (offset f) (difference (offset d) (offset e))) allDirections

(** val flood :
    nat -> (direction -> bool) -> direction list -> direction list **)

let rec flood steps0 part reached =
  match steps0 with
  | O -> reached
  | S fewer ->
    flood fewer part
      (filter (fun d ->
        (&&) (part d)
          (existsb (fun e -> (||) (sameDirection e d) (nextInLink e d))
            reached)) allDirections)

(** val onePiece : (direction -> bool) -> bool **)

let onePiece part =
  match filter part allDirections with
  | [] -> false
  | first :: _ ->
    let reached =
      flood (S (S (S (S (S (S (S (S (S (S (S (S (S O))))))))))))) part
        (first :: [])
    in
    forallb (fun d ->
      (||) (negb (part d)) (existsb (sameDirection d) reached)) allDirections

(** val isInner : (direction -> sign) -> direction -> bool **)

let isInner now d =
  match now d with
  | Plus -> true
  | _ -> false

(** val isZero : (direction -> sign) -> direction -> bool **)

let isZero now d =
  match now d with
  | OnSurface -> true
  | _ -> false

(** val violated : thresholds -> signField -> cutField -> coord3 -> bool **)

let violated th sign0 cut v =
  match warpVertex th sign0 cut v with
  | Stays -> false
  | Moves (_, _) -> true

(** val colour : coord3 -> nat **)

let colour = function
| C3 (x, y, z0) ->
  add (if Z.even x then O else S (S O))
    (if Z.even (Z.div (Z.add (Z.add x y) z0) (Zpos (XO XH))) then O else S O)

(** val turn : thresholds -> signField -> cutField -> coord3 -> nat **)

let turn th sign0 cut v =
  match warpVertex th sign0 cut v with
  | Stays -> O
  | Moves (d, t0) ->
    add
      (add
        (mul (S (S (S (S (S (S (S (S O))))))))
          (Z.to_nat
            (Z.div (Z.mul (Zpos (XO (XO XH))) t0)
              (thresholdSteps th (directionKind d)))))
        (match sign0 v with
         | Minus -> O
         | _ -> S (S (S (S O))))) (colour v)

(** val turns : nat **)

let turns =
  S (S (S (S (S (S (S (S (S (S (S (S (S (S (S (S (S (S (S (S (S (S (S (S (S
    (S (S (S (S (S (S (S O)))))))))))))))))))))))))))))))

module PositiveMap =
 struct
  type key = positive

  type 'a tree =
  | Leaf
  | Node of 'a tree * 'a option * 'a tree

  type 'a t = 'a tree

  (** val empty : 'a1 t **)

  let empty =
    Leaf

  (** val find : key -> 'a1 t -> 'a1 option **)

  let rec find i = function
  | Leaf -> None
  | Node (l, o, r) ->
    (match i with
     | XI ii -> find ii r
     | XO ii -> find ii l
     | XH -> o)

  (** val add : key -> 'a1 -> 'a1 t -> 'a1 t **)

  let rec add i v = function
  | Leaf ->
    (match i with
     | XI ii -> Node (Leaf, None, (add ii v Leaf))
     | XO ii -> Node ((add ii v Leaf), None, Leaf)
     | XH -> Node (Leaf, (Some v), Leaf))
  | Node (l, o, r) ->
    (match i with
     | XI ii -> Node (l, o, (add ii v r))
     | XO ii -> Node ((add ii v l), o, r)
     | XH -> Node (l, (Some v), r))
 end

type 'a link =
| L14 of 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a

(** val gather : (direction -> 'a1) -> 'a1 link **)

let gather f =
  L14 ((f Dir_p00), (f Dir_m00), (f Dir_0p0), (f Dir_0m0), (f Dir_00p),
    (f Dir_00m), (f Dir_ppp), (f Dir_mmm), (f Dir_ppm), (f Dir_mmp),
    (f Dir_pmp), (f Dir_mpm), (f Dir_mpp), (f Dir_pmm))

(** val at : 'a1 link -> direction -> 'a1 **)

let at l d =
  let L14 (p00, m00, q0p0, q0m0, q00p, q00m, ppp, mmm, ppm, mmp, pmp, mpm,
           mpp, pmm) = l
  in
  (match d with
   | Dir_p00 -> p00
   | Dir_m00 -> m00
   | Dir_0p0 -> q0p0
   | Dir_0m0 -> q0m0
   | Dir_00p -> q00p
   | Dir_00m -> q00m
   | Dir_ppp -> ppp
   | Dir_mmm -> mmm
   | Dir_ppm -> ppm
   | Dir_mmp -> mmp
   | Dir_pmp -> pmp
   | Dir_mpm -> mpm
   | Dir_mpp -> mpp
   | Dir_pmm -> pmm)

(** val neighborTable : direction list link **)

let neighborTable =
  gather (fun d -> filter (nextInLink d) allDirections)

(** val ringTable : (direction * direction) list link **)

let ringTable =
  gather (fun d ->
    filter (fun pat -> let (e, f) = pat in nextInLink e f)
      (list_prod (at neighborTable d) (at neighborTable d)))

(** val wallTable :
    ((direction * direction) * (direction * direction)) list **)

let wallTable =
  flat_map (fun d ->
    flat_map (fun e ->
      let sides = filter (nextInLink e) (at neighborTable d) in
      map (fun x -> ((d, e), x))
        (filter (fun pat -> let (f, g) = pat in negb (sameDirection f g))
          (list_prod sides sides))) (at neighborTable d)) allDirections

(** val spread : bool link -> bool link -> bool link **)

let spread part reached =
  gather (fun d ->
    (&&) (at part d)
      ((||) (at reached d) (existsb (at reached) (at neighborTable d))))

(** val spreadFor : nat -> bool link -> bool link -> bool link **)

let rec spreadFor rounds part reached =
  match rounds with
  | O -> reached
  | S fewer -> spreadFor fewer part (spread part reached)

(** val inOnePiece : bool link -> bool **)

let inOnePiece part =
  match filter (at part) allDirections with
  | [] -> false
  | first :: _ ->
    let reached =
      spreadFor (S (S (S (S (S (S (S (S (S (S (S (S (S O))))))))))))) part
        (gather (sameDirection first))
    in
    forallb (fun d -> (||) (negb (at part d)) (at reached d)) allDirections

(** val twoPieces : bool link -> bool **)

let twoPieces plus =
  (&&) (inOnePiece plus) (inOnePiece (gather (fun d -> negb (at plus d))))

(** val pinched : bool link -> direction -> bool **)

let pinched plus d =
  negb
    ((&&) (existsb (fun e -> negb (at plus e)) (at neighborTable d))
      (Nat.leb
        (length
          (filter (fun pat ->
            let (e, f) = pat in (&&) (at plus e) (negb (at plus f)))
            (at ringTable d))) (S (S O))))

(** val walls : bool link -> (direction * direction) list **)

let walls plus =
  map fst
    (filter (fun pat ->
      let (_, y0) = pat in let (f, g) = y0 in (&&) (at plus f) (at plus g))
      wallTable)

(** val diskOf : bool link -> bool link -> bool **)

let diskOf plus =
  if twoPieces plus
  then let pinched0 = filter (pinched plus) allDirections in
       let walls0 = walls plus in
       (fun zero ->
       (&&) (forallb (fun d -> negb (at zero d)) pinched0)
         (forallb (fun pat ->
           let (d, e) = pat in negb ((&&) (at zero d) (at zero e))) walls0))
  else (fun _ -> false)

(** val isDisk : sign link -> bool **)

let isDisk link0 =
  diskOf (gather (isInner (at link0))) (gather (isZero (at link0)))

(** val openSigns : signField -> signField **)

let openSigns sample v =
  match sample v with
  | Plus -> Plus
  | _ -> Minus

(** val openCuts : signField -> cutField -> cutField **)

let openCuts sample cut plus minus =
  match sample minus with
  | OnSurface -> steps
  | _ -> cut plus minus

(** val spelled : positive -> positive -> positive **)

let rec spelled p rest =
  match p with
  | XI q -> XI (XI (spelled q rest))
  | XO q -> XI (XO (spelled q rest))
  | XH -> XO rest

(** val positiveOf : z -> positive **)

let positiveOf = function
| Z0 -> XH
| Zpos p -> XO p
| Zneg p -> XI p

(** val pointKey : coord3 -> positive **)

let pointKey = function
| C3 (x, y, z0) ->
  spelled (positiveOf x) (spelled (positiveOf y) (positiveOf z0))

type zeros = warping PositiveMap.t

(** val noZeros : zeros **)

let noZeros =
  PositiveMap.empty

(** val placeIn : zeros -> coord3 -> warping **)

let placeIn zeros0 v =
  match PositiveMap.find (pointKey v) zeros0 with
  | Some w -> w
  | None -> Stays

type gap = sign -> sign -> z

(** val levelGap : gap **)

let levelGap s s' =
  match s with
  | Minus -> (match s' with
              | Minus -> Zpos XH
              | _ -> Z0)
  | _ -> Z0

(** val strictGap : gap **)

let strictGap _ _ =
  Zpos XH

(** val towards : direction -> direction -> bool **)

let towards e e' =
  coord3Equal (translate (offset e) (offset e')) (C3 (Z0, Z0, Z0))

(** val roomFor : signField -> gap -> coord3 -> coord3 -> z **)

let roomFor sign0 gap0 v w =
  Z.sub (Z.div steps (Zpos (XO XH))) (gap0 (sign0 v) (sign0 w))

(** val roomBeside :
    signField -> gap -> (coord3 -> warping) -> (coord3 -> nat) -> zeros ->
    coord3 -> direction -> z -> direction -> z **)

let roomBeside sign0 gap0 target turn0 zeros0 v e t0 d =
  let w = translate v (offset d) in
  (match directionKind d with
   | Long -> t0
   | Short ->
     if Z.ltb Z0 (dot (offset d) (offset e))
     then (match placeIn zeros0 w with
           | Stays ->
             (match target w with
              | Stays -> t0
              | Moves (e', t') ->
                if (&&) (towards e e') (Nat.ltb (turn0 v) (turn0 w))
                then Z.div (Z.sub (Z.add (roomFor sign0 gap0 v w) t0) t')
                       (Zpos (XO XH))
                else t0)
           | Moves (e', t') ->
             if towards e e' then Z.sub (roomFor sign0 gap0 v w) t' else t0)
     else t0)

(** val shortened :
    signField -> gap -> (coord3 -> warping) -> (coord3 -> nat) -> zeros ->
    coord3 -> direction -> z -> z **)

let shortened sign0 gap0 target turn0 zeros0 v e t0 =
  match directionKind e with
  | Long ->
    fold_left (fun reached d ->
      Z.min reached (roomBeside sign0 gap0 target turn0 zeros0 v e t0 d))
      allDirections t0
  | Short -> t0

(** val staysRather :
    thresholds -> (direction -> bool) -> direction -> z -> z -> bool **)

let staysRather th violates0 e t0 reached =
  (&&)
    (Z.ltb (Z.sub (thresholdSteps th (directionKind e)) t0)
      (Z.sub t0 reached))
    (forallb (fun d -> (||) (negb (violates0 d)) (sameDirection d e))
      allDirections)

(** val signAmong : signField -> zeros -> coord3 -> sign **)

let signAmong sign0 zeros0 v =
  warpedSign (sign0 v) (placeIn zeros0 v)

(** val linkAmong : signField -> zeros -> coord3 -> sign link **)

let linkAmong sign0 zeros0 v =
  gather (fun d -> signAmong sign0 zeros0 (translate v (offset d)))

(** val violatesAt :
    thresholds -> signField -> cutField -> coord3 -> direction -> bool **)

let violatesAt th sign0 cut v =
  violates th (sign0 v) (fun d -> sign0 (translate v (offset d)))
    (cutFrom sign0 cut v)

(** val settleOne :
    thresholds -> signField -> cutField -> gap -> zeros -> coord3 -> zeros **)

let settleOne th sign0 cut gap0 zeros0 v =
  match warpVertex th sign0 cut v with
  | Stays -> zeros0
  | Moves (e, t0) ->
    if isDisk (linkAmong sign0 zeros0 v)
    then let reached =
           shortened sign0 gap0 (warpVertex th sign0 cut) (turn th sign0 cut)
             zeros0 v e t0
         in
         if staysRather th (violatesAt th sign0 cut v) e t0 reached
         then zeros0
         else PositiveMap.add (pointKey v) (Moves (e, reached)) zeros0
    else zeros0

(** val settle :
    thresholds -> signField -> cutField -> gap -> coord3 list -> zeros **)

let settle th sign0 cut gap0 vs =
  fold_left (settleOne th sign0 cut gap0) vs noZeros

(** val inTurn :
    thresholds -> signField -> cutField -> coord3 list -> coord3 list **)

let inTurn th sign0 cut vs =
  let turned =
    map (fun v -> ((turn th sign0 cut v), v))
      (filter (violated th sign0 cut) vs)
  in
  flat_map (fun n ->
    map snd (filter (fun pat -> let (m, _) = pat in Nat.eqb m n) turned))
    (seq O turns)

(** val settledTets :
    thresholds -> signField -> cutField -> zeros -> structuredTetId -> coord3
    unstructuredTet list **)

let settledTets th sign0 cut zeros0 tid =
  placedTets sign0 (placeIn zeros0) (clampedCut th cut) tid

(** val settledMesh :
    thresholds -> signField -> cutField -> gap -> coord3 list ->
    structuredTetId list -> coord3 unstructuredTet list **)

let settledMesh th sign0 cut gap0 vs tids =
  let zeros0 = settle th sign0 cut gap0 vs in
  flat_map (settledTets th sign0 cut zeros0) tids

type voxelGrid =
| Grid of z * coord3 * coord3

(** val owner : voxelGrid -> coord3 -> coord3 **)

let owner grid v =
  let Grid (half, c, c0) = grid in
  let C3 (sx, sy, sz) = c in
  let C3 (ox, oy, oz) = c0 in
  let C3 (x, y, z0) = v in
  C3 ((Z.div (Z.add ox (Z.mul half x)) sx),
  (Z.div (Z.add oy (Z.mul half y)) sy), (Z.div (Z.add oz (Z.mul half z0)) sz))

(** val inImage : voxelGrid -> (coord3 -> bool) -> coord3 -> bool **)

let inImage grid image v =
  image (owner grid v)

(** val cubeInner :
    voxelGrid -> (coord3 -> bool) -> coord3 -> direction -> bool **)

let cubeInner grid image v d =
  match directionKind d with
  | Long -> false
  | Short -> inImage grid image (translate v (offset d))

(** val cubeParted : voxelGrid -> (coord3 -> bool) -> coord3 -> bool **)

let cubeParted grid image v =
  (&&) (existsb (cubeInner grid image v) allDirections)
    (negb (onePiece (cubeInner grid image v)))

(** val voxelSigns : voxelGrid -> (coord3 -> bool) -> signField **)

let voxelSigns grid image v = match v with
| C3 (x, _, _) ->
  if (&&) (inImage grid image v)
       ((||) (Z.even x) (negb (cubeParted grid image v)))
  then Plus
  else Minus

type material = z

(** val outside : material **)

let outside =
  Z0

(** val materialFill :
    ('a1 -> material option) -> ('a1 -> 'a1 -> 'a1) -> 'a1 -> 'a1 -> 'a1 ->
    'a1 -> (material * 'a1 unstructuredTet) list **)

let materialFill getMaterial getCut v1 v2 v3 v4 =
  match getMaterial v1 with
  | Some m1 ->
    (match getMaterial v2 with
     | Some m2 ->
       (match getMaterial v3 with
        | Some m3 ->
          (match getMaterial v4 with
           | Some m4 ->
             if Z.eqb m1 m2
             then if Z.eqb m3 m4
                  then []
                  else if Z.eqb m1 m3
                       then []
                       else if Z.eqb m2 m4
                            then []
                            else if Z.eqb m1 m4
                                 then []
                                 else if Z.eqb m2 m3
                                      then []
                                      else (m1, (UT ((getCut v1 v3),
                                             (getCut v1 v4), (getCut v2 v3),
                                             (getCut v3 v4)))) :: ((m1, (UT
                                             ((getCut v1 v4), (getCut v2 v4),
                                             (getCut v2 v3),
                                             (getCut v3 v4)))) :: [])
             else if Z.eqb m3 m4
                  then if Z.eqb m1 m3
                       then []
                       else if Z.eqb m2 m4
                            then []
                            else if Z.eqb m1 m4
                                 then []
                                 else if Z.eqb m2 m3
                                      then []
                                      else (m3, (UT ((getCut v1 v3),
                                             (getCut v1 v4), (getCut v1 v2),
                                             (getCut v2 v3)))) :: ((m3, (UT
                                             ((getCut v1 v4), (getCut v2 v4),
                                             (getCut v1 v2),
                                             (getCut v2 v3)))) :: [])
                  else if Z.eqb m1 m3
                       then if Z.eqb m2 m4
                            then []
                            else if Z.eqb m1 m4
                                 then []
                                 else if Z.eqb m2 m3
                                      then []
                                      else (m2, (UT ((getCut v1 v2),
                                             (getCut v3 v4), (getCut v2 v4),
                                             (getCut v2 v3)))) :: ((m4, (UT
                                             ((getCut v1 v2), (getCut v3 v4),
                                             (getCut v1 v4),
                                             (getCut v2 v4)))) :: [])
                       else if Z.eqb m2 m4
                            then if Z.eqb m1 m4
                                 then []
                                 else if Z.eqb m2 m3
                                      then []
                                      else (m1, (UT ((getCut v1 v2),
                                             (getCut v3 v4), (getCut v1 v3),
                                             (getCut v1 v4)))) :: ((m3, (UT
                                             ((getCut v1 v2), (getCut v3 v4),
                                             (getCut v2 v3),
                                             (getCut v1 v3)))) :: [])
                            else if Z.eqb m1 m4
                                 then if Z.eqb m2 m3
                                      then []
                                      else (m2, (UT ((getCut v1 v2),
                                             (getCut v3 v4), (getCut v2 v4),
                                             (getCut v2 v3)))) :: ((m3, (UT
                                             ((getCut v1 v2), (getCut v3 v4),
                                             (getCut v2 v3),
                                             (getCut v1 v3)))) :: [])
                                 else if Z.eqb m2 m3
                                      then (m1, (UT ((getCut v1 v2),
                                             (getCut v3 v4), (getCut v1 v3),
                                             (getCut v1 v4)))) :: ((m4, (UT
                                             ((getCut v1 v2), (getCut v3 v4),
                                             (getCut v1 v4),
                                             (getCut v2 v4)))) :: [])
                                      else (m1, (UT ((getCut v1 v2),
                                             (getCut v3 v4), (getCut v1 v3),
                                             (getCut v1 v4)))) :: ((m2, (UT
                                             ((getCut v1 v2), (getCut v3 v4),
                                             (getCut v2 v4),
                                             (getCut v2 v3)))) :: ((m3, (UT
                                             ((getCut v1 v2), (getCut v3 v4),
                                             (getCut v2 v3),
                                             (getCut v1 v3)))) :: ((m4, (UT
                                             ((getCut v1 v2), (getCut v3 v4),
                                             (getCut v1 v4),
                                             (getCut v2 v4)))) :: [])))
           | None ->
             if Z.eqb m1 m2
             then []
             else if Z.eqb m1 m3
                  then []
                  else if Z.eqb m2 m3
                       then []
                       else (m3, (UT (v4, (getCut v1 v2), (getCut v1 v3),
                              (getCut v2 v3)))) :: [])
        | None ->
          (match getMaterial v4 with
           | Some m4 ->
             if Z.eqb m1 m2
             then []
             else if Z.eqb m1 m4
                  then []
                  else if Z.eqb m2 m4
                       then []
                       else (m4, (UT (v3, (getCut v1 v2), (getCut v2 v4),
                              (getCut v1 v4)))) :: []
           | None -> []))
     | None ->
       (match getMaterial v3 with
        | Some m3 ->
          (match getMaterial v4 with
           | Some m4 ->
             if Z.eqb m1 m3
             then []
             else if Z.eqb m1 m4
                  then []
                  else if Z.eqb m3 m4
                       then []
                       else (m1, (UT (v2, (getCut v3 v4), (getCut v1 v3),
                              (getCut v1 v4)))) :: []
           | None -> [])
        | None -> []))
  | None ->
    (match getMaterial v2 with
     | Some m2 ->
       (match getMaterial v3 with
        | Some m3 ->
          (match getMaterial v4 with
           | Some m4 ->
             if Z.eqb m2 m3
             then []
             else if Z.eqb m2 m4
                  then []
                  else if Z.eqb m3 m4
                       then []
                       else (m2, (UT (v1, (getCut v3 v4), (getCut v2 v4),
                              (getCut v2 v3)))) :: []
           | None -> [])
        | None -> [])
     | None -> [])

(** val signAmongMaterials :
    ('a1 -> material option) -> material -> 'a1 -> sign **)

let signAmongMaterials getMaterial m v =
  match getMaterial v with
  | Some n -> if Z.eqb n m then Plus else Minus
  | None -> OnSurface

(** val materialCut :
    ('a1 -> material option) -> ('a1 -> 'a1 -> 'a1) -> 'a1 -> 'a1 -> 'a1 **)

let materialCut getMaterial getIntersection v w =
  match getMaterial v with
  | Some m ->
    (match getMaterial w with
     | Some n ->
       if Z.ltb m n then getIntersection w v else getIntersection v w
     | None -> getIntersection v w)
  | None -> getIntersection v w

(** val addMaterial :
    ('a1 -> material option) -> material list -> 'a1 -> material list **)

let addMaterial getMaterial found v =
  match getMaterial v with
  | Some m -> if existsb (Z.eqb m) found then found else app found (m :: [])
  | None -> found

(** val materialsOf :
    ('a1 -> material option) -> 'a1 list -> material list **)

let materialsOf getMaterial vertices =
  fold_left (addMaterial getMaterial) vertices []

(** val tetsOfOne :
    ('a1 -> material option) -> ('a1 -> 'a1 -> 'a1) -> 'a1 -> 'a1 -> 'a1 ->
    'a1 -> material -> (material * 'a1 unstructuredTet) list **)

let tetsOfOne getMaterial getIntersection v1 v2 v3 v4 m =
  map (fun x -> (m, x))
    (getUnstructuredTets (signAmongMaterials getMaterial m)
      (materialCut getMaterial getIntersection) v1 v2 v3 v4)

(** val getMaterialTets :
    ('a1 -> material option) -> ('a1 -> 'a1 -> 'a1) -> 'a1 -> 'a1 -> 'a1 ->
    'a1 -> material -> (material * 'a1 unstructuredTet) list **)

let getMaterialTets getMaterial getIntersection v1 v2 v3 v4 shared =
  match materialsOf getMaterial (v1 :: (v2 :: (v3 :: (v4 :: [])))) with
  | [] -> (shared, (UT (v1, v2, v3, v4))) :: []
  | m :: l ->
    app
      (flat_map (tetsOfOne getMaterial getIntersection v1 v2 v3 v4) (m :: l))
      (materialFill getMaterial (materialCut getMaterial getIntersection) v1
        v2 v3 v4)

type materialField = coord3 -> material option

(** val vertexMaterial : materialField -> meshVertex -> material option **)

let vertexMaterial material0 = function
| Corner c -> material0 c
| Cut (_, _) -> None

(** val orientMaterialTet :
    handedness -> (material * meshVertex unstructuredTet) ->
    material * meshVertex unstructuredTet **)

let orientMaterialTet h t0 =
  ((fst t0), (orient h (snd t0)))

(** val materialNames :
    materialField -> (structuredTetId -> material) -> structuredTetId ->
    (material * meshVertex unstructuredTet) list **)

let materialNames material0 shared tid = match tid with
| STId (c, case) ->
  let ST (v1, v2, v3, v4, _, _, _, _) = getStructuredTet (STId (c, case)) in
  map (orientMaterialTet (caseHandedness case))
    (getMaterialTets (vertexMaterial material0) meshIntersection (Corner v1)
      (Corner v2) (Corner v3) (Corner v4) (shared tid))

(** val materialCutFrom :
    materialField -> cutField -> coord3 -> direction -> z **)

let materialCutFrom material0 cut v d =
  let u = translate v (offset d) in
  (match material0 v with
   | Some m ->
     (match material0 u with
      | Some n -> if Z.ltb m n then Z.sub steps (cut u v) else cut v u
      | None -> cut v u)
   | None -> cut v u)

(** val warpMaterialVertex :
    thresholds -> materialField -> cutField -> coord3 -> warping **)

let warpMaterialVertex th material0 cut v =
  match material0 v with
  | Some m ->
    warp th Plus (fun d ->
      signAmongMaterials material0 m (translate v (offset d)))
      (materialCutFrom material0 cut v)
  | None -> Stays

(** val placedMaterial :
    materialField -> (coord3 -> warping) -> coord3 -> material option **)

let placedMaterial before0 warping0 c =
  match warping0 c with
  | Stays -> before0 c
  | Moves (_, _) -> None

(** val placedMaterialTets :
    materialField -> (coord3 -> warping) -> cutField -> (structuredTetId ->
    material) -> structuredTetId -> (material * coord3 unstructuredTet) list **)

let placedMaterialTets before0 warping0 cut shared tid =
  map (fun t0 -> ((fst t0), (mapTet (placedPosition warping0 cut) (snd t0))))
    (materialNames (placedMaterial before0 warping0) shared tid)

(** val placedWhole :
    (coord3 -> warping) -> cutField -> structuredTetId -> coord3
    unstructuredTet **)

let placedWhole warping0 cut = function
| STId (c, case) ->
  let ST (v1, v2, v3, v4, _, _, _, _) = getStructuredTet (STId (c, case)) in
  mapTet (placedPosition warping0 cut)
    (orient (caseHandedness case) (UT ((Corner v1), (Corner v2), (Corner v3),
      (Corner v4))))

type cellSet = nat -> coord3 -> bool

(** val halfSide : nat -> z **)

let halfSide level =
  Z.pow (Zpos (XO XH)) (Z.of_nat level)

(** val centreInHalfSides : coord3 -> coord3 **)

let centreInHalfSides c =
  translate (scale (Zpos (XO XH)) c) (C3 ((Zpos XH), (Zpos XH), (Zpos XH)))

(** val parentCell : coord3 -> coord3 **)

let parentCell = function
| C3 (x, y, z0) ->
  C3 ((Z.div x (Zpos (XO XH))), (Z.div y (Zpos (XO XH))),
    (Z.div z0 (Zpos (XO XH))))

(** val hasChild : cellSet -> nat -> coord3 -> bool **)

let hasChild cells level child =
  match level with
  | O -> false
  | S l -> cells l child

(** val unitCube : coord3 list **)

let unitCube =
  (C3 (Z0, Z0, Z0)) :: ((C3 ((Zpos XH), Z0, Z0)) :: ((C3 (Z0, (Zpos XH),
    Z0)) :: ((C3 ((Zpos XH), (Zpos XH), Z0)) :: ((C3 (Z0, Z0, (Zpos
    XH))) :: ((C3 ((Zpos XH), Z0, (Zpos XH))) :: ((C3 (Z0, (Zpos XH), (Zpos
    XH))) :: ((C3 ((Zpos XH), (Zpos XH), (Zpos XH))) :: [])))))))

(** val isUsed : cellSet -> nat -> coord3 -> bool **)

let isUsed cells level point =
  match level with
  | O -> false
  | S l -> existsb (fun corner -> cells l (difference corner point)) unitCube

type axisOrder =
| XYZ
| XZY
| YXZ
| YZX
| ZXY
| ZYX

(** val arrange : axisOrder -> z -> z -> z -> coord3 **)

let arrange o a b c =
  match o with
  | XYZ -> C3 (a, b, c)
  | XZY -> C3 (a, c, b)
  | YXZ -> C3 (b, a, c)
  | YZX -> C3 (c, a, b)
  | ZXY -> C3 (b, c, a)
  | ZYX -> C3 (c, b, a)

(** val alongFirst : axisOrder -> coord3 -> z **)

let alongFirst o v =
  match o with
  | XYZ -> let C3 (x, _, _) = v in x
  | XZY -> let C3 (x, _, _) = v in x
  | YXZ -> let C3 (_, y, _) = v in y
  | YZX -> let C3 (_, y, _) = v in y
  | _ -> let C3 (_, _, z0) = v in z0

(** val swapLast : axisOrder -> axisOrder **)

let swapLast = function
| XYZ -> XZY
| XZY -> XYZ
| YXZ -> YZX
| YZX -> YXZ
| ZXY -> ZYX
| ZYX -> ZXY

(** val swapFirst : axisOrder -> axisOrder **)

let swapFirst = function
| XYZ -> YXZ
| XZY -> ZXY
| YXZ -> XYZ
| YZX -> ZYX
| ZXY -> XZY
| ZYX -> YZX

(** val rotateIn : axisOrder -> axisOrder **)

let rotateIn o =
  swapFirst (swapLast o)

(** val rotateOut : axisOrder -> axisOrder **)

let rotateOut o =
  swapLast (swapFirst o)

type flag =
| MakeFlag of nat * coord3 * axisOrder * bool * bool * bool

(** val levelOf : flag -> nat **)

let levelOf = function
| MakeFlag (level, _, _, _, _, _) -> level

(** val cellOf : flag -> coord3 **)

let cellOf = function
| MakeFlag (_, c, _, _, _, _) -> c

(** val signed : bool -> z -> z **)

let signed up n =
  if up then n else Z.opp n

(** val stepFrom : flag -> z -> z -> z -> coord3 **)

let stepFrom x i j k =
  let MakeFlag (_, _, o, s, t0, u) = x in
  arrange o (signed s i) (signed t0 j) (signed u k)

(** val pointInHalfSides : flag -> z -> z -> z -> coord3 **)

let pointInHalfSides x i j k =
  translate (centreInHalfSides (cellOf x)) (stepFrom x i j k)

(** val pointSeen : flag -> z -> z -> z -> coord3 **)

let pointSeen x i j k =
  scale (halfSide (levelOf x)) (pointInHalfSides x i j k)

(** val cellSeen : flag -> z -> z -> z -> coord3 **)

let cellSeen x i j k =
  translate (cellOf x) (stepFrom x i j k)

(** val childAlong : bool -> z -> z **)

let childAlong up n =
  if up then n else Z.sub (Zpos XH) n

(** val childSeen : flag -> z -> z -> z -> coord3 **)

let childSeen x i j k =
  let MakeFlag (_, c, o, s, t0, u) = x in
  translate (scale (Zpos (XO XH)) c)
    (arrange o (childAlong s i) (childAlong t0 j) (childAlong u k))

(** val isAhead : bool -> z -> bool **)

let isAhead up n =
  eqb up (Z.even n)

(** val aheadAtFace : flag -> bool **)

let aheadAtFace = function
| MakeFlag (_, c, o, s, _, _) -> isAhead s (alongFirst o c)

(** val aheadAtEdge : flag -> bool **)

let aheadAtEdge = function
| MakeFlag (_, c, o, _, t0, _) -> isAhead t0 (alongFirst (swapFirst o) c)

(** val aheadAtCorner : flag -> bool **)

let aheadAtCorner = function
| MakeFlag (_, c, o, _, _, u) -> isAhead u (alongFirst (rotateIn o) c)

(** val otherCorner : flag -> flag **)

let otherCorner = function
| MakeFlag (level, c, o, s, t0, u) -> MakeFlag (level, c, o, s, t0, (negb u))

(** val otherEdge : flag -> flag **)

let otherEdge = function
| MakeFlag (level, c, o, s, t0, u) ->
  MakeFlag (level, c, (swapLast o), s, u, t0)

(** val otherFace : flag -> flag **)

let otherFace = function
| MakeFlag (level, c, o, s, t0, u) ->
  MakeFlag (level, c, (swapFirst o), t0, s, u)

(** val otherCell : flag -> flag **)

let otherCell x = match x with
| MakeFlag (level, _, o, s, t0, u) ->
  MakeFlag (level, (cellSeen x (Zpos XH) Z0 Z0), o, (negb s), t0, u)

(** val finerInCell : flag -> flag **)

let finerInCell x = match x with
| MakeFlag (n, _, o, s, t0, u) ->
  (match n with
   | O -> x
   | S level ->
     MakeFlag (level, (childSeen x (Zpos XH) (Zpos XH) Z0), (rotateIn o), u,
       s, (negb t0)))

(** val finerInOther : flag -> flag **)

let finerInOther x = match x with
| MakeFlag (n, _, o, s, t0, u) ->
  (match n with
   | O -> x
   | S level ->
     MakeFlag (level, (childSeen x (Zpos (XO XH)) (Zpos XH) (Zpos XH)), o,
       (negb s), t0, (negb u)))

(** val coarser : flag -> flag **)

let coarser x = match x with
| MakeFlag (level, c, o, s, t0, u) ->
  if aheadAtFace x
  then MakeFlag ((S level), (parentCell c), (rotateOut o), t0, (negb u), s)
  else MakeFlag ((S level), (parentCell (cellSeen x (Zpos XH) Z0 Z0)), o,
         (negb s), t0, (negb u))

type gradedKind =
| BccTet
| EdgeHalfTet
| FaceHalfTet
| QuarterTet
| PyramidTet

type gradedTetId =
| GTId of gradedKind * flag

(** val isPresent : cellSet -> flag -> bool **)

let isPresent cells x =
  (&&) (cells (levelOf x) (cellOf x))
    (negb
      (hasChild cells (levelOf x) (childSeen x (Zpos XH) (Zpos XH) (Zpos XH))))

(** val kindAt : cellSet -> flag -> gradedKind **)

let kindAt cells x =
  if cells (levelOf x) (cellSeen x (Zpos XH) Z0 Z0)
  then if isUsed cells (levelOf x) (pointInHalfSides x (Zpos XH) Z0 Z0)
       then if isUsed cells (levelOf x)
                 (pointInHalfSides x (Zpos XH) (Zpos XH) Z0)
            then QuarterTet
            else FaceHalfTet
       else if isUsed cells (levelOf x)
                 (pointInHalfSides x (Zpos XH) (Zpos XH) Z0)
            then EdgeHalfTet
            else BccTet
  else PyramidTet

(** val withLowerCell : flag -> flag **)

let withLowerCell x = match x with
| MakeFlag (_, _, _, s, _, _) -> if s then x else otherCell x

(** val withUpperCorner : flag -> flag **)

let withUpperCorner x = match x with
| MakeFlag (_, _, _, _, _, u) -> if u then x else otherCorner x

(** val isOffDiagonal : flag -> bool **)

let isOffDiagonal x =
  xorb (aheadAtEdge x) (aheadAtCorner x)

(** val withCornerOffDiagonal : flag -> flag **)

let withCornerOffDiagonal x =
  let y = if isOffDiagonal x then x else otherCorner x in
  if aheadAtEdge y then otherEdge y else y

(** val namingFlag : gradedKind -> flag -> flag **)

let namingFlag kind x =
  match kind with
  | BccTet -> withUpperCorner (withLowerCell x)
  | EdgeHalfTet -> withLowerCell x
  | FaceHalfTet -> withUpperCorner x
  | QuarterTet -> x
  | PyramidTet -> withCornerOffDiagonal x

(** val tetOfFlag : cellSet -> flag -> gradedTetId **)

let tetOfFlag cells x =
  GTId ((kindAt cells x), (namingFlag (kindAt cells x) x))

(** val flagsOf : gradedTetId -> flag list **)

let flagsOf = function
| GTId (g, x) ->
  (match g with
   | BccTet ->
     x :: ((otherCorner x) :: ((otherCell x) :: ((otherCorner (otherCell x)) :: [])))
   | EdgeHalfTet -> x :: ((otherCell x) :: [])
   | FaceHalfTet -> x :: ((otherCorner x) :: [])
   | QuarterTet -> x :: []
   | PyramidTet ->
     x :: ((otherCorner x) :: ((otherEdge x) :: ((otherCorner (otherEdge x)) :: []))))

(** val isUpperEdge : flag -> bool **)

let isUpperEdge = function
| MakeFlag (_, _, _, _, t0, _) -> t0

(** val gradedVertices :
    gradedTetId -> ((coord3 * coord3) * coord3) * coord3 **)

let gradedVertices = function
| GTId (kind, x) ->
  let p = pointSeen x in
  (match kind with
   | BccTet ->
     if isUpperEdge x
     then ((((p (Zpos XH) (Zpos XH) (Zneg XH)),
            (p (Zpos XH) (Zpos XH) (Zpos XH))), (p (Zpos (XO XH)) Z0 Z0)),
            (p Z0 Z0 Z0))
     else ((((p (Zpos XH) (Zpos XH) (Zneg XH)),
            (p (Zpos XH) (Zpos XH) (Zpos XH))), (p Z0 Z0 Z0)),
            (p (Zpos (XO XH)) Z0 Z0))
   | EdgeHalfTet ->
     ((((p (Zpos XH) (Zpos XH) (Zpos XH)), (p (Zpos XH) (Zpos XH) Z0)),
       (p (Zpos (XO XH)) Z0 Z0)), (p Z0 Z0 Z0))
   | FaceHalfTet ->
     ((((p (Zpos XH) (Zpos XH) (Zpos XH)),
       (p (Zpos XH) (Zpos XH) (Zneg XH))), (p (Zpos XH) Z0 Z0)), (p Z0 Z0 Z0))
   | QuarterTet ->
     ((((p (Zpos XH) (Zpos XH) (Zpos XH)), (p (Zpos XH) (Zpos XH) Z0)),
       (p (Zpos XH) Z0 Z0)), (p Z0 Z0 Z0))
   | PyramidTet ->
     ((((p (Zpos XH) (Zpos XH) (Zpos XH)),
       (p (Zpos XH) (Zpos XH) (Zneg XH))),
       (p (Zpos XH) (Zneg XH) (Zpos XH))), (p Z0 Z0 Z0)))

(** val isEvenOrder : axisOrder -> bool **)

let isEvenOrder = function
| XYZ -> true
| YZX -> true
| ZXY -> true
| _ -> false

(** val gradedHandedness : gradedTetId -> handedness **)

let gradedHandedness = function
| GTId (kind, f) ->
  let MakeFlag (_, _, o, s, t0, u) = f in
  let right =
    match kind with
    | BccTet -> negb (eqb (isEvenOrder o) (eqb s u))
    | _ -> eqb (isEvenOrder o) (eqb s (eqb t0 u))
  in
  if right then RightHanded else LeftHanded

(** val getGradedTet : gradedTetId -> coord3 unstructuredTet **)

let getGradedTet tid =
  let (p, v4) = gradedVertices tid in
  let (p0, v3) = p in
  let (v1, v2) = p0 in
  (match gradedHandedness tid with
   | RightHanded -> UT (v1, v2, v3, v4)
   | LeftHanded -> UT (v1, v2, v4, v3))

(** val flagAtFace : gradedTetId -> place -> flag * place **)

let flagAtFace tid i =
  let GTId (g, x) = tid in
  (match g with
   | BccTet ->
     (match i with
      | First -> (x, Second)
      | Second -> ((otherCorner x), Second)
      | Third -> ((if isUpperEdge x then x else otherCell x), Third)
      | Fourth -> ((if isUpperEdge x then otherCell x else x), Third))
   | EdgeHalfTet ->
     (match i with
      | Fourth -> ((otherCell x), Third)
      | x0 -> (x, x0))
   | FaceHalfTet ->
     (match i with
      | First -> ((otherCorner x), Second)
      | x0 -> (x, x0))
   | QuarterTet -> (x, i)
   | PyramidTet ->
     (match i with
      | First -> ((otherCorner x), Second)
      | Second -> ((otherEdge x), Third)
      | x0 -> (x, x0)))

(** val flagAcross : cellSet -> flag -> place -> flag **)

let flagAcross cells x = function
| First ->
  if isPresent cells (otherCorner x) then otherCorner x else finerInCell x
| Second -> otherEdge x
| Third -> otherFace x
| Fourth ->
  if cells (levelOf x) (cellSeen x (Zpos XH) Z0 Z0)
  then if isPresent cells (otherCell x) then otherCell x else finerInOther x
  else coarser (withCornerOffDiagonal x)

(** val gradedNeighbor : cellSet -> gradedTetId -> place -> gradedTetId **)

let gradedNeighbor cells tid i =
  let (x, j) = flagAtFace tid i in tetOfFlag cells (flagAcross cells x j)

(** val edgeRank : coord3 -> coord3 -> z **)

let edgeRank a b =
  let C3 (dx, dy, dz) = difference a b in
  let C3 (x, _, _) = a in
  if Z.even dx
  then Z0
  else if eqb (Z.even x) (Z.eqb (Z.mul (Z.mul dx dy) dz) (Zpos XH))
       then Zpos XH
       else Zpos (XO XH)

(** val mirrored : handedness -> handedness **)

let mirrored = function
| RightHanded -> LeftHanded
| LeftHanded -> RightHanded

(** val handed : handedness -> 'a1 unstructuredTet -> 'a1 unstructuredTet **)

let handed h t0 =
  match h with
  | RightHanded -> t0
  | LeftHanded -> let UT (a, b, c, d) = t0 in UT (a, b, d, c)

(** val before : ('a1 -> 'a1 -> z) -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> bool **)

let before getKey a e b f =
  Z.ltb (getKey a e) (getKey b f)

(** val pyramidInOrder :
    ('a1 -> 'a1 -> 'a1) -> handedness -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a1
    unstructuredTet list **)

let pyramidInOrder getIntersection h a b e z0 =
  map (handed (mirrored h)) ((UT (b, a, (getIntersection a e), z0)) :: ((UT
    (b, (getIntersection a e), (getIntersection b e), z0)) :: []))

(** val pyramid :
    ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> handedness -> 'a1 -> 'a1 ->
    'a1 -> 'a1 -> 'a1 unstructuredTet list **)

let pyramid getIntersection getKey h a b e z0 =
  if before getKey a e b e
  then pyramidInOrder getIntersection h a b e z0
  else pyramidInOrder getIntersection (mirrored h) b a e z0

(** val prismInOrder :
    ('a1 -> 'a1 -> 'a1) -> handedness -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a1
    unstructuredTet list **)

let prismInOrder getIntersection h a b c e =
  map (handed h) ((UT (c, b, (getIntersection a e), a)) :: ((UT (c, b,
    (getIntersection b e), (getIntersection a e))) :: ((UT (c,
    (getIntersection b e), (getIntersection c e),
    (getIntersection a e))) :: [])))

(** val prism :
    ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> handedness -> 'a1 -> 'a1 ->
    'a1 -> 'a1 -> 'a1 unstructuredTet list **)

let prism getIntersection getKey h a b c e =
  if before getKey a e b e
  then if before getKey b e c e
       then prismInOrder getIntersection h a b c e
       else if before getKey a e c e
            then prismInOrder getIntersection (mirrored h) a c b e
            else prismInOrder getIntersection h c a b e
  else if before getKey a e c e
       then prismInOrder getIntersection (mirrored h) b a c e
       else if before getKey b e c e
            then prismInOrder getIntersection h b c a e
            else prismInOrder getIntersection (mirrored h) c b a e

(** val wedgeAcross :
    ('a1 -> 'a1 -> 'a1) -> handedness -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a1
    unstructuredTet list **)

let wedgeAcross getIntersection h a b e f =
  map (handed h) ((UT (a, b, (getIntersection b e),
    (getIntersection a f))) :: ((UT (a, (getIntersection b e),
    (getIntersection a e), (getIntersection a f))) :: ((UT (b,
    (getIntersection b e), (getIntersection a f),
    (getIntersection b f))) :: [])))

(** val wedgeBeside :
    ('a1 -> 'a1 -> 'a1) -> handedness -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a1
    unstructuredTet list **)

let wedgeBeside getIntersection h a b e f =
  map (handed h) ((UT (a, b, (getIntersection b e),
    (getIntersection b f))) :: ((UT (a, (getIntersection b e),
    (getIntersection a f), (getIntersection b f))) :: ((UT (a,
    (getIntersection b e), (getIntersection a e),
    (getIntersection a f))) :: [])))

(** val wedgeTowards :
    ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> handedness -> 'a1 -> 'a1 ->
    'a1 -> 'a1 -> 'a1 unstructuredTet list **)

let wedgeTowards getIntersection getKey h a b e f =
  if before getKey b f b e
  then wedgeBeside getIntersection h a b e f
  else wedgeBeside getIntersection (mirrored h) a b f e

(** val wedge :
    ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> handedness -> 'a1 -> 'a1 ->
    'a1 -> 'a1 -> 'a1 unstructuredTet list **)

let wedge getIntersection getKey h a b e f =
  if before getKey a e b e
  then if before getKey a f b f
       then wedgeTowards getIntersection getKey (mirrored h) b a e f
       else wedgeAcross getIntersection (mirrored h) a b f e
  else if before getKey a f b f
       then wedgeAcross getIntersection h a b e f
       else wedgeTowards getIntersection getKey h a b e f

(** val getKeyTets :
    ('a1 -> sign) -> ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> 'a1 -> 'a1
    -> 'a1 -> 'a1 -> 'a1 unstructuredTet list **)

let getKeyTets getSign getIntersection getKey v1 v2 v3 v4 =
  match getSign v1 with
  | Plus ->
    (match getSign v2 with
     | Plus ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Minus -> prism getIntersection getKey RightHanded v1 v2 v3 v4
           | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4)
        | OnSurface ->
          (match getSign v4 with
           | Minus -> pyramid getIntersection getKey LeftHanded v1 v2 v4 v3
           | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4)
        | Minus ->
          (match getSign v4 with
           | Plus -> prism getIntersection getKey LeftHanded v1 v2 v4 v3
           | OnSurface ->
             pyramid getIntersection getKey RightHanded v1 v2 v3 v4
           | Minus -> wedge getIntersection getKey RightHanded v1 v2 v3 v4))
     | OnSurface ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Minus -> pyramid getIntersection getKey RightHanded v1 v3 v4 v2
           | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4)
        | OnSurface -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4
        | Minus ->
          (match getSign v4 with
           | Plus -> pyramid getIntersection getKey LeftHanded v1 v4 v3 v2
           | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4))
     | Minus ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Plus -> prism getIntersection getKey RightHanded v1 v3 v4 v2
           | OnSurface ->
             pyramid getIntersection getKey LeftHanded v1 v3 v2 v4
           | Minus -> wedge getIntersection getKey LeftHanded v1 v3 v2 v4)
        | OnSurface ->
          (match getSign v4 with
           | Plus -> pyramid getIntersection getKey RightHanded v1 v4 v2 v3
           | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4)
        | Minus ->
          (match getSign v4 with
           | Plus -> wedge getIntersection getKey RightHanded v1 v4 v2 v3
           | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4)))
  | OnSurface ->
    (match getSign v2 with
     | Plus ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Minus -> pyramid getIntersection getKey LeftHanded v2 v3 v4 v1
           | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4)
        | OnSurface -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4
        | Minus ->
          (match getSign v4 with
           | Plus -> pyramid getIntersection getKey RightHanded v2 v4 v3 v1
           | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4))
     | OnSurface -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4
     | Minus ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Plus -> pyramid getIntersection getKey LeftHanded v3 v4 v2 v1
           | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4)
        | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4))
  | Minus ->
    (match getSign v2 with
     | Plus ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Plus -> prism getIntersection getKey LeftHanded v2 v3 v4 v1
           | OnSurface ->
             pyramid getIntersection getKey RightHanded v2 v3 v1 v4
           | Minus -> wedge getIntersection getKey RightHanded v2 v3 v1 v4)
        | OnSurface ->
          (match getSign v4 with
           | Plus -> pyramid getIntersection getKey LeftHanded v2 v4 v1 v3
           | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4)
        | Minus ->
          (match getSign v4 with
           | Plus -> wedge getIntersection getKey LeftHanded v2 v4 v1 v3
           | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4))
     | OnSurface ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Plus -> pyramid getIntersection getKey RightHanded v3 v4 v1 v2
           | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4)
        | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4)
     | Minus ->
       (match getSign v3 with
        | Plus ->
          (match getSign v4 with
           | Plus -> wedge getIntersection getKey RightHanded v3 v4 v1 v2
           | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4)
        | _ -> getUnstructuredTets getSign getIntersection v1 v2 v3 v4))

type 'vertex triangle = ('vertex * 'vertex) * 'vertex

(** val halves :
    ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> 'a1 -> 'a1 -> 'a1 -> 'a1
    triangle list **)

let halves getIntersection getKey a b e =
  if before getKey a e b e
  then ((a, b), (getIntersection a e)) :: (((b, (getIntersection a e)),
         (getIntersection b e)) :: [])
  else ((a, b), (getIntersection b e)) :: (((a, (getIntersection a e)),
         (getIntersection b e)) :: [])

(** val faceTriangles :
    ('a1 -> sign) -> ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> 'a1 -> 'a1
    -> 'a1 -> 'a1 triangle list **)

let faceTriangles getSign getIntersection getKey f1 f2 f3 =
  match getSign f1 with
  | Plus ->
    (match getSign f2 with
     | Plus ->
       (match getSign f3 with
        | Minus -> halves getIntersection getKey f1 f2 f3
        | _ -> ((f1, f2), f3) :: [])
     | OnSurface ->
       (match getSign f3 with
        | Minus -> ((f1, f2), (getIntersection f1 f3)) :: []
        | _ -> ((f1, f2), f3) :: [])
     | Minus ->
       (match getSign f3 with
        | Plus -> halves getIntersection getKey f1 f3 f2
        | OnSurface -> ((f1, f3), (getIntersection f1 f2)) :: []
        | Minus ->
          ((f1, (getIntersection f1 f2)), (getIntersection f1 f3)) :: []))
  | OnSurface ->
    (match getSign f2 with
     | Plus ->
       (match getSign f3 with
        | Minus -> ((f1, f2), (getIntersection f2 f3)) :: []
        | _ -> ((f1, f2), f3) :: [])
     | OnSurface ->
       (match getSign f3 with
        | Plus -> ((f1, f2), f3) :: []
        | _ -> [])
     | Minus ->
       (match getSign f3 with
        | Plus -> ((f1, f3), (getIntersection f3 f2)) :: []
        | _ -> []))
  | Minus ->
    (match getSign f2 with
     | Plus ->
       (match getSign f3 with
        | Plus -> halves getIntersection getKey f2 f3 f1
        | OnSurface -> ((f2, f3), (getIntersection f2 f1)) :: []
        | Minus ->
          ((f2, (getIntersection f2 f1)), (getIntersection f2 f3)) :: [])
     | OnSurface ->
       (match getSign f3 with
        | Plus -> ((f2, f3), (getIntersection f3 f1)) :: []
        | _ -> [])
     | Minus ->
       (match getSign f3 with
        | Plus ->
          ((f3, (getIntersection f3 f1)), (getIntersection f3 f2)) :: []
        | _ -> []))

(** val cutKey : cutField -> coord3 -> coord3 -> z **)

let cutKey cut plus minus =
  Z.add (Z.mul (Zpos (XI XH)) (cut plus minus)) (edgeRank plus minus)

(** val meshKey : (coord3 -> coord3 -> z) -> meshVertex -> meshVertex -> z **)

let meshKey key0 a b =
  match a with
  | Corner plus ->
    (match b with
     | Corner minus -> key0 plus minus
     | Cut (_, _) -> Z0)
  | Cut (_, _) -> Z0

(** val keyThresholds : thresholds **)

let keyThresholds =
  TH ((Zpos (XO (XO (XO (XO (XO (XO XH))))))), (Zpos (XI (XI (XI (XI (XI (XO
    XH))))))))

(** val orderedNames :
    (coord3 -> coord3 -> z) -> signField -> (coord3 -> warping) ->
    structuredTetId -> meshVertex unstructuredTet list **)

let orderedNames key0 before0 warping0 = function
| STId (c, case) ->
  let ST (v1, v2, v3, v4, _, _, _, _) = getStructuredTet (STId (c, case)) in
  map (orient (caseHandedness case))
    (getKeyTets (placedSign before0 warping0) meshIntersection (meshKey key0)
      (Corner v1) (Corner v2) (Corner v3) (Corner v4))

(** val keyNames :
    signField -> (coord3 -> warping) -> cutField -> structuredTetId ->
    meshVertex unstructuredTet list **)

let keyNames before0 warping0 cut =
  orderedNames (cutKey cut) before0 warping0

(** val keyTets :
    signField -> (coord3 -> warping) -> cutField -> structuredTetId -> coord3
    unstructuredTet list **)

let keyTets before0 warping0 cut tid =
  map (mapTet (placedPosition warping0 cut))
    (keyNames before0 warping0 cut tid)

(** val keyStuffTet :
    thresholds -> signField -> cutField -> structuredTetId -> meshVertex
    unstructuredTet list **)

let keyStuffTet th sign0 cut =
  keyNames sign0 (warpVertex th sign0 cut) cut

type mesh = { tetsWithin : (structuredTetId -> meshVertex unstructuredTet
                           list); signIn : (meshVertex -> sign);
              positionIn : (meshVertex -> coord3) }

(** val pointsOfCell : coord3 -> coord3 list **)

let pointsOfCell c =
  let centre = centreInHalfSides c in
  centre :: (map (fun d -> translate centre (offset d)) allDirections)

(** val isPlus : sign -> bool **)

let isPlus = function
| Plus -> true
| _ -> false

(** val isNearSurface : signField -> coord3 -> bool **)

let isNearSurface sign0 c =
  negb (forallb (fun v -> isPlus (sign0 v)) (pointsOfCell c))

(** val aroundChildren : coord3 list **)

let aroundChildren =
  filter (fun d ->
    let C3 (x, y, z0) = d in
    let within = fun n -> (&&) (Z.leb Z0 n) (Z.leb n (Zpos XH)) in
    (||) ((||) (within x) (within y)) (within z0))
    (flat_map (fun x ->
      flat_map (fun y ->
        map (fun z0 -> C3 (x, y, z0)) ((Zneg XH) :: (Z0 :: ((Zpos
          XH) :: ((Zpos (XO XH)) :: []))))) ((Zneg XH) :: (Z0 :: ((Zpos
        XH) :: ((Zpos (XO XH)) :: []))))) ((Zneg XH) :: (Z0 :: ((Zpos
      XH) :: ((Zpos (XO XH)) :: [])))))

(** val closedCells : cellSet -> nat -> coord3 -> bool **)

let rec closedCells asked level c =
  match level with
  | O -> asked O c
  | S l ->
    (||) (asked level c)
      (existsb (fun d ->
        closedCells asked l (translate (scale (Zpos (XO XH)) c) d))
        aroundChildren)

(** val octreeAround : cellSet -> nat -> cellSet **)

let octreeAround asked levels level c =
  (||) (Nat.leb levels level) (closedCells asked level c)

(** val gradedOctree : signField -> nat -> cellSet **)

let gradedOctree sign0 levels =
  octreeAround (fun level c ->
    match level with
    | O -> isNearSurface sign0 c
    | S _ -> false) levels

(** val structuredOf : flag -> structuredTetId **)

let structuredOf = function
| MakeFlag (_, c, o, _, t0, _) ->
  STId
    ((translate (scale (Zpos (XO XH)) c)
       (arrange o Z0 (if t0 then Z0 else Zneg (XO XH)) Z0)),
    (match o with
     | XYZ -> if t0 then Tet_K2 else Tet_K3
     | XZY -> if t0 then Tet_J2 else Tet_J3
     | YXZ -> if t0 then Tet_K4 else Tet_K1
     | YZX -> if t0 then Tet_I2 else Tet_I3
     | ZXY -> if t0 then Tet_J4 else Tet_J1
     | ZYX -> if t0 then Tet_I4 else Tet_I1))

(** val structuredName : gradedTetId -> structuredTetId option **)

let structuredName = function
| GTId (g, x) ->
  (match g with
   | BccTet ->
     let MakeFlag (n, _, _, _, _, _) = x in
     (match n with
      | O -> Some (structuredOf x)
      | S _ -> None)
   | _ -> None)

(** val gradedTetsWithin :
    mesh -> gradedTetId -> meshVertex unstructuredTet list **)

let gradedTetsWithin mesh0 tid =
  match structuredName tid with
  | Some stid -> mesh0.tetsWithin stid
  | None -> (mapTet (fun x -> Corner x) (getGradedTet tid)) :: []

(** val isAngleWithin :
    angleBounds -> coord3 -> coord3 -> coord3 -> coord3 -> bool **)

let isAngleWithin bounds a b c d =
  let AB (c0, c1) = bounds in
  let CotSq (num, den) = c0 in
  let CotSq (num', den') = c1 in
  let n = normalsProduct a b c d in
  let scale0 =
    Z.mul (Z.pow (sixVolume a b c d) (Zpos (XO XH))) (edgeSquared a b)
  in
  (&&)
    ((||) (Z.leb n Z0)
      (Z.leb (Z.mul den (Z.pow n (Zpos (XO XH)))) (Z.mul num scale0)))
    ((||) (Z.leb Z0 n)
      (Z.leb (Z.mul den' (Z.pow n (Zpos (XO XH)))) (Z.mul num' scale0)))

(** val isWellShaped : angleBounds -> coord3 unstructuredTet -> bool **)

let isWellShaped bounds t0 = match t0 with
| UT (a, b, c, d) ->
  (&&) (Z.ltb Z0 (sixVolume a b c d))
    (forallb (fun e ->
      let (y, s) = e in
      let (y0, r) = y in let (p, q) = y0 in isAngleWithin bounds p q r s)
      (dihedralEdges t0))

(** val cornerOffsets : z list **)

let cornerOffsets =
  Z0 :: ((Zpos XH) :: ((Zpos (XO XH)) :: ((Zpos (XI XH)) :: [])))

(** val anchors : coord3 -> coord3 list **)

let anchors v =
  filter (fun anchor ->
    let C3 (x, y, z0) = anchor in
    (&&) ((&&) (Z.even x) (Z.even y)) (Z.even z0))
    (flat_map (fun x ->
      flat_map (fun y ->
        map (fun z0 -> difference (C3 (x, y, z0)) v) cornerOffsets)
        cornerOffsets) cornerOffsets)

(** val tetsAround : coord3 -> structuredTetId list **)

let tetsAround v =
  filter (fun tid -> existsb (coord3Equal v) (corners tid))
    (flat_map (fun anchor -> map (fun x -> STId (anchor, x)) allCases)
      (anchors v))

(** val signsAmong :
    (material -> bool) -> material option link -> sign link **)

let signsAmong inner link0 =
  gather (fun d ->
    match at link0 d with
    | Some m -> if inner m then Plus else Minus
    | None -> OnSurface)

(** val lowestOf : material list -> material **)

let lowestOf = function
| [] -> outside
| m :: rest -> fold_left Z.min rest m

(** val areDisks : material list -> material option link -> bool **)

let areDisks materials link0 =
  let lowest = lowestOf materials in
  (&&)
    (forallb (fun m ->
      (||) (Z.eqb m lowest) (isDisk (signsAmong (Z.eqb m) link0))) materials)
    (isDisk (signsAmong (fun m -> negb (Z.eqb m lowest)) link0))

(** val fillsWouldTouch : material option link -> bool **)

let fillsWouldTouch link0 =
  existsb (fun pat ->
    let (y, y0) = pat in
    let (d, e) = y in
    let (f, g) = y0 in
    (match directionKind d with
     | Long -> false
     | Short ->
       (match directionKind e with
        | Long -> false
        | Short ->
          (match at link0 d with
           | Some m ->
             (match at link0 e with
              | Some n ->
                (match at link0 f with
                 | Some side ->
                   (match at link0 g with
                    | Some side' ->
                      (&&)
                        ((&&) ((&&) (negb (Z.eqb m n)) (Z.eqb side side'))
                          (negb (Z.eqb side m))) (negb (Z.eqb side n))
                    | None -> false)
                 | None -> false)
              | None -> false)
           | None -> false)))) wallTable

(** val lowerOf : (coord3 -> material) -> coord3 -> direction -> material **)

let lowerOf material0 v e =
  Z.min (material0 v) (material0 (translate v (offset e)))

(** val isHigher : (coord3 -> material) -> coord3 -> direction -> bool **)

let isHigher material0 v e =
  Z.ltb (material0 (translate v (offset e))) (material0 v)

(** val materialSide :
    thresholds -> (coord3 -> material) -> cutField -> signField **)

let materialSide th material0 cut v =
  match warpMaterialVertex th (fun v0 -> Some (material0 v0)) cut v with
  | Stays -> Minus
  | Moves (e, _) -> if isHigher material0 v e then Plus else Minus

(** val materialLink :
    (coord3 -> material) -> zeros -> coord3 -> material option link **)

let materialLink material0 zeros0 v =
  gather (fun d ->
    placedMaterial (fun v0 -> Some (material0 v0)) (placeIn zeros0)
      (translate v (offset d)))

(** val materialsAround :
    (coord3 -> material) -> coord3 -> direction -> material option link ->
    material list **)

let materialsAround material0 v e link0 =
  materialsOf (fun m -> m) ((Some (material0 v)) :: ((Some
    (material0 (translate v (offset e)))) :: (map (at link0) allDirections)))

(** val lowerIn :
    (coord3 -> material) -> zeros -> coord3 -> material option **)

let lowerIn material0 zeros0 v =
  match placeIn zeros0 v with
  | Stays -> None
  | Moves (e, _) -> Some (lowerOf material0 v e)

(** val sharedIn :
    (coord3 -> material) -> zeros -> structuredTetId -> material **)

let sharedIn material0 zeros0 tid =
  match map (lowerIn material0 zeros0) (corners tid) with
  | [] -> outside
  | o :: _ -> (match o with
               | Some m -> m
               | None -> outside)

(** val haveMoved : zeros -> structuredTetId -> bool **)

let haveMoved zeros0 tid =
  forallb (fun v ->
    match placeIn zeros0 v with
    | Stays -> false
    | Moves (_, _) -> true) (corners tid)

(** val isLowestAt : (coord3 -> material) -> material -> coord3 -> bool **)

let isLowestAt material0 lowest v =
  forallb (fun d -> Z.leb lowest (material0 (translate v (offset d))))
    allDirections

(** val mayShare :
    angleBounds -> (coord3 -> material) -> cutField -> zeros ->
    structuredTetId -> bool **)

let mayShare bounds material0 cut zeros0 tid =
  if haveMoved zeros0 tid
  then let shared = sharedIn material0 zeros0 tid in
       (&&)
         (forallb (fun v ->
           match lowerIn material0 zeros0 v with
           | Some m -> (&&) (Z.eqb m shared) (isLowestAt material0 shared v)
           | None -> false) (corners tid))
         ((||) (Z.eqb shared outside)
           (isWellShaped bounds (placedWhole (placeIn zeros0) cut tid)))
  else true

(** val materialViolatesAt :
    thresholds -> (coord3 -> material) -> cutField -> coord3 -> direction ->
    bool **)

let materialViolatesAt th material0 cut v =
  violates th Plus (fun d ->
    signAmongMaterials (fun u -> Some (material0 u)) (material0 v)
      (translate v (offset d)))
    (materialCutFrom (fun u -> Some (material0 u)) cut v)

(** val materialTurn :
    thresholds -> (coord3 -> material) -> cutField -> coord3 -> nat **)

let materialTurn th material0 cut v =
  match warpMaterialVertex th (fun v0 -> Some (material0 v0)) cut v with
  | Stays -> O
  | Moves (d, t0) ->
    add
      (add
        (mul (S (S (S (S (S (S (S (S O))))))))
          (Z.to_nat
            (Z.div (Z.mul (Zpos (XO (XO XH))) t0)
              (thresholdSteps th (directionKind d)))))
        (if isHigher material0 v d then S (S (S (S O))) else O)) (colour v)

(** val settleOneMaterial :
    angleBounds -> thresholds -> (coord3 -> material) -> cutField -> zeros ->
    coord3 -> zeros **)

let settleOneMaterial bounds th material0 cut zeros0 v =
  match warpMaterialVertex th (fun v0 -> Some (material0 v0)) cut v with
  | Stays -> zeros0
  | Moves (e, t0) ->
    let link0 = materialLink material0 zeros0 v in
    if (&&) (areDisks (materialsAround material0 v e link0) link0)
         (negb (fillsWouldTouch link0))
    then let reached =
           shortened (materialSide th material0 cut) levelGap
             (warpMaterialVertex th (fun v0 -> Some (material0 v0)) cut)
             (materialTurn th material0 cut) zeros0 v e t0
         in
         let moved = PositiveMap.add (pointKey v) (Moves (e, reached)) zeros0
         in
         if (&&)
              (negb
                (staysRather th (materialViolatesAt th material0 cut v) e t0
                  reached))
              (forallb (mayShare bounds material0 cut moved) (tetsAround v))
         then moved
         else zeros0
    else zeros0

(** val settleMaterials :
    angleBounds -> thresholds -> (coord3 -> material) -> cutField -> coord3
    list -> zeros **)

let settleMaterials bounds th material0 cut vs =
  fold_left (settleOneMaterial bounds th material0 cut) vs noZeros

(** val materialsInTurn :
    thresholds -> (coord3 -> material) -> cutField -> coord3 list -> coord3
    list **)

let materialsInTurn th material0 cut vs =
  let violated0 = fun v ->
    match warpMaterialVertex th (fun v0 -> Some (material0 v0)) cut v with
    | Stays -> false
    | Moves (_, _) -> true
  in
  let turned =
    map (fun v -> ((materialTurn th material0 cut v), v))
      (filter violated0 vs)
  in
  flat_map (fun n ->
    map snd (filter (fun pat -> let (m, _) = pat in Nat.eqb m n) turned))
    (seq O turns)

(** val settledMaterialTets :
    thresholds -> (coord3 -> material) -> cutField -> zeros ->
    structuredTetId -> (material * coord3 unstructuredTet) list **)

let settledMaterialTets th material0 cut zeros0 tid =
  placedMaterialTets (fun v -> Some (material0 v)) (placeIn zeros0)
    (clampedCut th cut) (sharedIn material0 zeros0) tid
