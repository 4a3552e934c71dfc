open Convert

type t = { origin : point; cells : point }

let is_inner lattice p =
  let inner p origin cells =
    let d = p - origin in
    let index = (d - (d land 1)) / 2 in
    0 < index && index < cells - 1
  in
  inner p.x lattice.origin.x lattice.cells.x
  && inner p.y lattice.origin.y lattice.cells.y
  && inner p.z lattice.origin.z lattice.cells.z

let points { origin; cells } =
  let grid shift =
    let row j k =
      List.init cells.x (fun i ->
          coord3_of_point
            {
              x = origin.x + (2 * i) + shift;
              y = origin.y + (2 * j) + shift;
              z = origin.z + (2 * k) + shift;
            })
    in
    let layer k = List.concat (List.init cells.y (fun j -> row j k)) in
    List.concat (List.init cells.z layer)
  in
  grid 0 @ grid 1

let iter_tets { origin; cells } visit =
  for k = 0 to cells.z - 2 do
    for j = 0 to cells.y - 2 do
      for i = 0 to cells.x - 2 do
        let anchor =
          coord3_of_point
            {
              x = origin.x + (2 * i);
              y = origin.y + (2 * j);
              z = origin.z + (2 * k);
            }
        in
        List.iter
          (fun case -> visit (Certified.STId (anchor, case)))
          Certified.allCases
      done
    done
  done
