let print channel points tets =
  let unit = float_of_int (Convert.int_of_z Certified.steps) in
  let lattice c = float_of_int c /. unit in
  Printf.fprintf channel "MeshVersionFormatted 2\n\nDimension 3\n\n";
  Printf.fprintf channel "Vertices\n%d\n" (List.length points);
  List.iter
    (fun { Convert.x; y; z } ->
      Printf.fprintf channel "%.17g %.17g %.17g 0\n" (lattice x) (lattice y)
        (lattice z))
    points;
  Printf.fprintf channel "\nTetrahedra\n%d\n" (List.length tets);
  List.iter
    (fun (a, b, c, d, material) ->
      Printf.fprintf channel "%d %d %d %d %d\n" a b c d material)
    tets;
  Printf.fprintf channel "\nEnd\n"

let write file points tets =
  let growing = file ^ ".part" in
  let channel = open_out growing in
  match
    print channel points tets;
    close_out channel;
    Sys.rename growing file
  with
  | () -> ()
  | exception failure ->
      close_out_noerr channel;
      Sys.remove growing;
      raise failure
