type t =
  | Int of int
  | Bool of bool
  | Text of string
  | List of t list
  | Object of (string * t) list

let quoted text =
  let buffer = Buffer.create (String.length text + 2) in
  Buffer.add_char buffer '"';
  String.iter
    (function
      | ('"' | '\\') as c ->
          Buffer.add_char buffer '\\';
          Buffer.add_char buffer c
      | c when c < ' ' -> Buffer.add_string buffer (Printf.sprintf "\\u%04x" (Char.code c))
      | c -> Buffer.add_char buffer c)
    text;
  Buffer.add_char buffer '"';
  Buffer.contents buffer

let rec print channel = function
  | Int n -> output_string channel (string_of_int n)
  | Bool b -> output_string channel (string_of_bool b)
  | Text text -> output_string channel (quoted text)
  | List values -> enclosed channel '[' ']' (print channel) values
  | Object fields ->
      enclosed channel '{' '}'
        (fun (key, value) ->
          output_string channel (quoted key);
          output_char channel ':';
          print channel value)
        fields

and enclosed : 'a. out_channel -> char -> char -> ('a -> unit) -> 'a list -> unit =
 fun channel first last print_one values ->
  output_char channel first;
  List.iteri
    (fun i value ->
      if i > 0 then output_char channel ',';
      print_one value)
    values;
  output_char channel last

(* One line for each element of a list, so that versions can be compared. *)
let print_section channel = function
  | List values ->
      output_string channel "[\n";
      List.iteri
        (fun i value ->
          if i > 0 then output_string channel ",\n";
          print channel value)
        values;
      output_string channel "\n]"
  | value -> print channel value

let print_document channel sections =
  output_string channel "{\n";
  List.iteri
    (fun i (key, value) ->
      if i > 0 then output_string channel ",\n";
      output_string channel (quoted key);
      output_string channel ": ";
      print_section channel value)
    sections;
  output_string channel "\n}\n"
