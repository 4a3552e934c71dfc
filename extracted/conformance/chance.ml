let mixed h n =
  let h = (h lxor n) * 0x1f123bb5159a55e5 in
  let h = (h lxor (h lsr 29)) * 0x2127599bf4325c37 in
  h lxor (h lsr 31)

let number seed words = List.fold_left mixed (mixed 0x5eed seed) words land max_int
let below n seed words = number seed words mod n
let one_of list seed words = List.nth list (below (List.length list) seed words)
