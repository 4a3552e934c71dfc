open Certified

type t = { material : coord3 -> material; cut : cutField }

let within lattice domain =
  let materials = Hashtbl.create 4096 in
  let cuts = Hashtbl.create 4096 in
  let material v =
    let p = Convert.point_of_coord3 v in
    Domain.remembered materials p (fun () ->
        if Lattice.is_inner lattice p then domain.material v else outside)
  in
  let cut higher lower =
    let edge = (Convert.point_of_coord3 higher, Convert.point_of_coord3 lower) in
    Domain.remembered cuts edge (fun () -> domain.cut higher lower)
  in
  { material; cut }

let midpoint { material; _ } = { material; cut = midpointCuts }
