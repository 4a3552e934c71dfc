open Certified
open Convert

exception Malformed of string

type source = { name : string; channel : in_channel; mutable line : int }

let fail source what =
  raise (Malformed (Printf.sprintf "%s, line %d: %s" source.name source.line what))

let next source =
  source.line <- source.line + 1;
  match input_line source.channel with
  | line -> Some (String.trim line)
  | exception End_of_file -> None

let expect source what =
  match next source with
  | Some line when line = what -> ()
  | _ -> fail source (Printf.sprintf "'%s' is missing" what)

let words line = String.split_on_char ' ' line |> List.filter (( <> ) "")

let sign_of_char source = function
  | '+' -> Plus
  | '0' -> OnSurface
  | '-' -> Minus
  | c -> fail source (Printf.sprintf "'%c' is no sign" c)

let read_lattice source =
  let number word =
    match int_of_string_opt word with
    | Some n -> n
    | None -> fail source (Printf.sprintf "'%s' is no whole number" word)
  in
  match Option.map words (next source) with
  | Some [ "lattice"; ox; oy; oz; nx; ny; nz ] ->
      let origin = { x = number ox; y = number oy; z = number oz } in
      let cells = { x = number nx; y = number ny; z = number nz } in
      if (origin.x lor origin.y lor origin.z) land 1 <> 0 then
        fail source "the origin is not an even point";
      { Lattice.origin; cells }
  | _ -> fail source "the lattice is missing"

(* One grid of rows of answers; [shift] is 0 for the even points and 1 for the odd. *)
let read_grid source { Lattice.origin; cells } shift read_row answers =
  for k = 0 to cells.z - 1 do
    for j = 0 to cells.y - 1 do
      let row = Option.map (read_row source) (next source) in
      match row with
      | Some row when List.length row = cells.x ->
          List.iteri
            (fun i answer ->
              let p =
                {
                  x = origin.x + (2 * i) + shift;
                  y = origin.y + (2 * j) + shift;
                  z = origin.z + (2 * k) + shift;
                }
              in
              Hashtbl.replace answers p answer)
            row
      | _ -> fail source (Printf.sprintf "a row of %d answers is missing" cells.x)
    done
  done

let signs_of_row source row = List.map (sign_of_char source) (List.of_seq (String.to_seq row))

let materials_of_row source row =
  let material word =
    match int_of_string_opt word with
    | Some m when m >= 0 -> z_of_int m
    | _ -> fail source (Printf.sprintf "'%s' is no material" word)
  in
  List.map material (words row)

let rec read_cuts source cuts =
  match next source with
  | None -> ()
  | Some "" -> read_cuts source cuts
  | Some line -> (
      match List.map int_of_string_opt (words line) with
      | [ Some px; Some py; Some pz; Some mx; Some my; Some mz; Some t ] ->
          let plus = { x = px; y = py; z = pz } in
          let minus = { x = mx; y = my; z = mz } in
          Hashtbl.replace cuts (plus, minus) (z_of_int t);
          read_cuts source cuts
      | _ -> fail source "a cut is seven whole numbers")

(* The lattice, what is told of its points, and the cuts of edges. *)
let read_source title read_row otherwise source =
  let answers = Hashtbl.create 4096 in
  let cuts = Hashtbl.create 4096 in
  expect source title;
  let lattice = read_lattice source in
  expect source "even";
  read_grid source lattice 0 read_row answers;
  expect source "odd";
  read_grid source lattice 1 read_row answers;
  (match next source with
  | None | Some "" -> ()
  | Some "cuts" -> read_cuts source cuts
  | Some _ -> fail source "'cuts' or the end is expected");
  let answer v =
    Option.value (Hashtbl.find_opt answers (point_of_coord3 v)) ~default:otherwise
  in
  let cut first last =
    Option.value
      (Hashtbl.find_opt cuts (point_of_coord3 first, point_of_coord3 last))
      ~default:midpointCut
  in
  (lattice, answer, cut)

let with_file name read =
  let channel = open_in name in
  Fun.protect
    ~finally:(fun () -> close_in_noerr channel)
    (fun () -> read { name; channel; line = 0 })

let read name =
  let lattice, sign, cut = with_file name (read_source "certet-signs" signs_of_row Minus) in
  (lattice, { Domain.sign; cut })

let read_materials name =
  let lattice, material, cut =
    with_file name (read_source "certet-materials" materials_of_row outside)
  in
  (lattice, { Material_domain.material; cut })
