open Certified

type t = { sign : signField; cut : cutField }

let midpoint { sign; _ } = { sign = decided sign; cut = midpointCuts }

let of_position_sign position_sign =
  { sign = sampledSigns position_sign; cut = bisectedCuts position_sign }

let remembered table key compute =
  match Hashtbl.find_opt table key with
  | Some known -> known
  | None ->
      let answer = compute () in
      Hashtbl.add table key answer;
      answer

let within lattice domain =
  let signs = Hashtbl.create 4096 in
  let cuts = Hashtbl.create 4096 in
  let sign v =
    let p = Convert.point_of_coord3 v in
    remembered signs p (fun () ->
        if Lattice.is_inner lattice p then domain.sign v else Minus)
  in
  let cut plus minus =
    let edge = (Convert.point_of_coord3 plus, Convert.point_of_coord3 minus) in
    remembered cuts edge (fun () -> domain.cut plus minus)
  in
  { sign; cut }
