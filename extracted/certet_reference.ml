(* certet-reference: a small mesher that runs the certified functions as they
   were extracted, to compare others with.  It is meant to be clear, not fast. *)

open Certified

let usage =
  "usage: certet-reference [options] OUTPUT.mesh\n\
   The domain is one of\n\
  \  --solid 'sphere X Y Z R' | 'torus X Y Z R r' | 'box X0 Y0 Z0 X1 Y1 Z1'\n\
  \          with --lattice 'OX OY OZ NX NY NZ'\n\
  \  --signs FILE\n\
   all in lattice units, of which a long edge has two.\n\
   Exit status: 0 done, 1 failed, 2 not understood."

exception Usage of string

(* Which theorems shall cover the mesh. *)
type guarantee = Pieces | Angles | Embedding

type request = {
  mutable solid : string option;
  mutable lattice : string option;
  mutable signs : string option;
  mutable guarantee : guarantee;
  mutable midpoint : bool;
  mutable output : string option;
}

(* Of what [Arg] says: the program's name, the fault, and the usage. *)
let first_line text =
  let line = List.hd (String.split_on_char '\n' text) in
  let after = String.length Sys.argv.(0) + 2 in
  String.sub line after (String.length line - after)

let read_request () =
  let r =
    {
      solid = None;
      lattice = None;
      signs = None;
      guarantee = Pieces;
      midpoint = false;
      output = None;
    }
  in
  let set_guarantee = function
    | "embedding" -> r.guarantee <- Embedding
    | "angles" -> r.guarantee <- Angles
    | _ -> r.guarantee <- Pieces
  in
  let options =
    [
      ("--solid", Arg.String (fun s -> r.solid <- Some s), "SOLID a formula");
      ("--lattice", Arg.String (fun s -> r.lattice <- Some s), "BOX what is searched");
      ("--signs", Arg.String (fun s -> r.signs <- Some s), "FILE a sampled domain");
      ( "--guarantee",
        Arg.Symbol ([ "pieces"; "angles"; "embedding" ], set_guarantee),
        " default pieces" );
      ( "--midpoint",
        Arg.Unit (fun () -> r.midpoint <- true),
        " cut edges in the middle, warp nothing" );
    ]
  in
  (match Arg.parse_argv Sys.argv options (fun s -> r.output <- Some s) usage with
  | () -> ()
  | exception Arg.Bad text -> raise (Usage (first_line text)));
  r

let parse_lattice text =
  match
    String.split_on_char ' ' text
    |> List.filter (( <> ) "")
    |> List.map int_of_string_opt
  with
  | [ Some ox; Some oy; Some oz; Some nx; Some ny; Some nz ]
    when (ox lor oy lor oz) land 1 = 0 ->
      {
        Lattice.origin = { x = ox; y = oy; z = oz };
        cells = { x = nx; y = ny; z = nz };
      }
  | _ ->
      raise (Usage (Printf.sprintf "'%s' is no lattice: three even numbers and three more" text))

let domain_of request =
  let lattice, domain =
    match request with
    | { signs = Some file; solid = None; lattice = None; _ } -> Sign_file.read file
    | { signs = None; solid = Some solid; lattice = Some lattice; _ } ->
        ( parse_lattice lattice,
          Domain.of_position_sign (Solid.position_sign (Solid.parse solid)) )
    | _ -> raise (Usage "give --signs, or --solid and --lattice")
  in
  let domain =
    if request.midpoint then Domain.midpoint domain else domain
  in
  (lattice, Domain.within lattice domain)

(* How to visit the tetrahedra, and where their vertices lie. *)
let mesh_of request lattice domain =
  let by_the_paper thresholds =
    (Mesher.iter_tets thresholds lattice domain, Mesher.position thresholds domain)
  in
  match request.guarantee with
  | _ when request.midpoint -> by_the_paper noWarpThresholds
  | Angles -> by_the_paper angleThresholds
  | Embedding -> by_the_paper embeddingThresholds
  | Pieces ->
      let settled = Settler.settle levelGap angleThresholds lattice domain in
      (Settler.iter_tets settled, Settler.position settled)

(* Numbers vertices from 1 in order of appearance. *)
let numbered (iter_tets, position) =
  let numbers = Hashtbl.create 4096 in
  let points = ref [] in
  let tets = ref [] in
  let key = function
    | Corner c -> (Convert.point_of_coord3 c, None)
    | Cut (p, m) -> (Convert.point_of_coord3 p, Some (Convert.point_of_coord3 m))
  in
  let number v =
    match Hashtbl.find_opt numbers (key v) with
    | Some n -> n
    | None ->
        let n = Hashtbl.length numbers + 1 in
        Hashtbl.add numbers (key v) n;
        points := position v :: !points;
        n
  in
  iter_tets (fun (UT (a, b, c, d)) ->
      let a = number a in
      let b = number b in
      let c = number c in
      let d = number d in
      tets := (a, b, c, d) :: !tets);
  (List.rev !points, List.rev !tets)

let run () =
  let request = read_request () in
  let output =
    match request.output with
    | Some file -> file
    | None -> raise (Usage "the output is missing")
  in
  let lattice, domain = domain_of request in
  match numbered (mesh_of request lattice domain) with
  | _, [] -> failwith "nothing is inside: there is no mesh to make"
  | points, tets -> Medit.write output points tets

let () =
  let complain status sentence =
    Printf.eprintf "certet-reference: %s\n" sentence;
    exit status
  in
  match run () with
  | () -> ()
  | exception Arg.Help text -> print_string text
  | exception Usage sentence -> complain 2 sentence
  | exception Solid.Unknown sentence -> complain 2 sentence
  | exception Sign_file.Malformed sentence -> complain 1 sentence
  | exception Sys_error sentence -> complain 1 sentence
  | exception Failure sentence -> complain 1 sentence
  | exception Convert.Overflow -> complain 1 "a number does not fit in 63 bits"
