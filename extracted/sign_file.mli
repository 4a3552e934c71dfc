(** Sampled domains in a text file:

{v
certet-signs
lattice OX OY OZ NX NY NZ     origin (even, lattice units), reference points
even                          NZ * NY lines of NX signs, each + 0 or -,
+0-...                        x running along the line, then y, then z
odd
+0-...
cuts                          optional; one edge to a line: its + end, its
X Y Z X Y Z T                 - end, and the steps from the former
v}

    An edge that is not listed is cut in the middle. *)

exception Malformed of string

val read_materials : string -> Lattice.t * Material_domain.t
(** The same of several materials: the first line is [certet-materials], a row has numbers
    from 0, the outside, and a cut has the end of the higher material first. *)

val read : string -> Lattice.t * Domain.t
(** Raises {!Malformed} with one sentence that names the file and the line, or
    [Sys_error]. *)
