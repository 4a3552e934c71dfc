(* certet-reference: a small mesher that runs the certified functions as they
   were extracted, to compare others with.  It is meant to be clear, not fast. *)

open Certified

let usage =
  "usage: certet-reference [options] OUTPUT.mesh\n\
   The domain is one of\n\
  \  --solid 'sphere X Y Z R' | 'torus X Y Z R r' | 'box X0 Y0 Z0 X1 Y1 Z1'\n\
  \          with --lattice 'OX OY OZ NX NY NZ'\n\
  \  --signs FILE\n\
  \  --materials FILE\n\
   all in lattice units, of which a long edge has two.\n\
   --grade N makes tetrahedra up to N times twice as large away from the surface.\n\
   Exit status: 0 done, 1 failed, 2 not understood."

exception Usage of string

(* Which theorems shall cover the mesh. *)
type guarantee = Pieces | Key | Angles | Embedding

type request = {
  mutable solid : string option;
  mutable lattice : string option;
  mutable signs : string option;
  mutable materials : string option;
  mutable guarantee : guarantee;
  mutable midpoint : bool;
  mutable grade : int;
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
      materials = None;
      guarantee = Pieces;
      midpoint = false;
      grade = 0;
      output = None;
    }
  in
  let set_guarantee = function
    | "embedding" -> r.guarantee <- Embedding
    | "angles" -> r.guarantee <- Angles
    | "key" -> r.guarantee <- Key
    | _ -> r.guarantee <- Pieces
  in
  let options =
    [
      ("--solid", Arg.String (fun s -> r.solid <- Some s), "SOLID a formula");
      ("--lattice", Arg.String (fun s -> r.lattice <- Some s), "BOX what is searched");
      ("--signs", Arg.String (fun s -> r.signs <- Some s), "FILE a sampled domain");
      ( "--materials",
        Arg.String (fun s -> r.materials <- Some s),
        "FILE a sampled domain of several materials" );
      ( "--guarantee",
        Arg.Symbol ([ "pieces"; "key"; "angles"; "embedding" ], set_guarantee),
        " default pieces" );
      ( "--midpoint",
        Arg.Unit (fun () -> r.midpoint <- true),
        " cut edges in the middle, warp nothing" );
      ( "--grade",
        Arg.Int (fun n -> r.grade <- n),
        "N levels of larger tetrahedra away from the surface, 0 to 3" );
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
    | { signs = Some file; solid = None; lattice = None; materials = None; _ } ->
        Sign_file.read file
    | { signs = None; solid = Some solid; lattice = Some lattice; materials = None; _ } ->
        ( parse_lattice lattice,
          Domain.of_position_sign (Solid.position_sign (Solid.parse solid)) )
    | _ -> raise (Usage "give --signs, --materials, or --solid and --lattice")
  in
  let domain =
    if request.midpoint then Domain.midpoint domain else domain
  in
  (lattice, Domain.within lattice domain)

(* Numbers vertices from 1 in order of appearance; [iter_tets] tells the material of each
   tetrahedron, 0 where there is but one. *)
let numbered key position iter_tets =
  let numbers = Hashtbl.create 4096 in
  let points = ref [] in
  let tets = ref [] in
  let number v =
    match Hashtbl.find_opt numbers (key v) with
    | Some n -> n
    | None ->
        let n = Hashtbl.length numbers + 1 in
        Hashtbl.add numbers (key v) n;
        points := position v :: !points;
        n
  in
  iter_tets (fun (material, UT (a, b, c, d)) ->
      let a = number a in
      let b = number b in
      let c = number c in
      let d = number d in
      tets := (a, b, c, d, Convert.int_of_z material) :: !tets);
  (List.rev !points, List.rev !tets)

let mesh_of_one request =
  let lattice, domain = domain_of request in
  let key = function
    | Corner c -> (Convert.point_of_coord3 c, None)
    | Cut (p, m) -> (Convert.point_of_coord3 p, Some (Convert.point_of_coord3 m))
  in
  let made iter_tets position =
    numbered key position (fun visit -> iter_tets (fun tet -> visit (Z0, tet)))
  in
  let graded mesh =
    made
      (Grader.iter_tets mesh request.grade lattice)
      (fun v -> Convert.point_of_coord3 (mesh.positionIn v))
  in
  let by_the_paper thresholds =
    if request.grade > 0 then graded (Mesher.mesh thresholds domain)
    else made (Mesher.iter_tets thresholds lattice domain) (Mesher.position thresholds domain)
  in
  let settled diagonals thresholds =
    let settled = Settler.settle ~diagonals levelGap thresholds lattice domain in
    if request.grade > 0 then graded (Settler.mesh settled)
    else made (Settler.iter_tets settled) (Settler.position settled)
  in
  match request.guarantee with
  | _ when request.midpoint -> by_the_paper noWarpThresholds
  | Angles -> by_the_paper angleThresholds
  | Embedding -> by_the_paper embeddingThresholds
  | Pieces -> settled Settler.By_parity angleThresholds
  | Key -> settled Settler.By_key keyThresholds

(* Vertices lie in different places, so their places are their names. *)
let mesh_of_several request file =
  let lattice, domain = Sign_file.read_materials file in
  let domain = Material_domain.within lattice domain in
  let mesh =
    if request.midpoint then Material_mesher.unmoved (Material_domain.midpoint domain)
    else Material_mesher.settle angleThresholds lattice domain
  in
  numbered Convert.point_of_coord3 Convert.point_of_coord3
    (if request.grade > 0 then Grader.iter_material_tets mesh request.grade lattice
     else Material_mesher.iter_tets mesh lattice)

let mesh_of = function
  | { grade; _ } when grade < 0 || grade > 3 -> raise (Usage "--grade takes 0 to 3 levels")
  | { materials = Some file; signs = None; solid = None; lattice = None; guarantee = Pieces; _ }
    as request ->
      mesh_of_several request file
  | { materials = Some _; _ } ->
      raise (Usage "--materials goes with --midpoint alone")
  | request -> mesh_of_one request

let run () =
  let request = read_request () in
  let output =
    match request.output with
    | Some file -> file
    | None -> raise (Usage "the output is missing")
  in
  match mesh_of request with
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
