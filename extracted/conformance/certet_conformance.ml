(* certet-conformance: cases by which another implementation can check itself,
   with what the certified functions say of them, as JSON.

   usage: certet-conformance PAGE   PAGE explains the cases, and stands first *)

let lines_of file =
  let channel = open_in file in
  let rec read lines =
    match input_line channel with
    | line -> read (line :: lines)
    | exception End_of_file -> List.rev lines
  in
  Fun.protect ~finally:(fun () -> close_in channel) (fun () -> read [])

let sections page =
  let text line = Json.Text line in
  let direction d = Notation.coord3 (Certified.offset d) in
  let thresholds (name, th) =
    let steps kind = Json.Int (Notation.threshold_steps th kind) in
    (name, Json.List [ steps Long; steps Short ])
  in
  [
    ("certet_conformance", Json.Int 1);
    ("read_me", Json.List (List.map text (lines_of page)));
    ("steps", Json.Int Notation.steps);
    ("directions", Json.List (List.map direction Certified.allDirections));
    ("thresholds", Json.Object (List.map thresholds Notation.thresholds));
    ("lattice", Json.List (Lattice_cases.all ()));
    ("stencils", Json.List (Stencil_cases.all ()));
    ("warp", Json.List (Warp_cases.all ()));
    ("bisect", Json.List (Bisect_cases.all ()));
    ("meshes", Json.List (Mesh_cases.all ()));
    ("disks", Json.List (Disk_cases.all ()));
    ("settled", Json.List (Settled_cases.all ()));
    ("material_stencils", Json.List (Material_stencil_cases.all ()));
    ("materials", Json.List (Material_cases.all ()));
    ("graded", Json.List (Graded_cases.all ()));
  ]

let () =
  match Sys.argv with
  | [| _; page |] -> (
      match Json.print_document stdout (sections page) with
      | () -> ()
      | exception Sys_error sentence ->
          prerr_endline ("certet-conformance: " ^ sentence);
          exit 1)
  | _ ->
      prerr_endline "usage: certet-conformance PAGE";
      exit 2
