(* The OCaml side of the bridge: the only place where the constructors of the
   extracted code are matched for C++.

   Into C++ and out of it go integers and arrays of integers:
   - a sign is 0 for -, 1 for 0, 2 for +
   - a case or a direction is its place in [allCases] or [allDirections]
   - a coordinate triple is three integers
   - a material is itself, and -1 is none
   - the C++ closures of a call are named by one integer, the frame. *)

open Certified

external get_sign : int -> int -> int = "certified_get_sign"
external get_intersection : int -> int -> int -> int = "certified_get_intersection"
external get_key : int -> int -> int -> int = "certified_get_key"
external neighbor_sign : int -> int -> int = "certified_neighbor_sign"
external neighbor_cut : int -> int -> int = "certified_neighbor_cut"
external sign_at_step : int -> int -> int = "certified_sign_at_step"
external domain_sign : int -> int array -> int = "certified_domain_sign"
external domain_cut : int -> int array -> int = "certified_domain_cut"
external holds : int -> int array -> int = "certified_holds"
external emit : int -> int array -> unit = "certified_emit"
external get_material : int -> int -> int = "certified_get_material"
external material_intersection : int -> int -> int -> int = "certified_material_intersection"
external domain_material : int -> int array -> int = "certified_domain_material"
external material_cut : int -> int array -> int = "certified_material_cut"
external emit_material : int -> int -> int array -> unit = "certified_emit_material"

(* Raised by the stubs after they have put a C++ exception aside. *)
exception Parked

let z = Convert.z_of_int
let int = Convert.int_of_z

let sign_of_int = function
  | 0 -> Minus
  | 1 -> OnSurface
  | 2 -> Plus
  | n -> invalid_arg (Printf.sprintf "%d is no sign" n)

let int_of_sign = function Minus -> 0 | OnSurface -> 1 | Plus -> 2

let index_of list element =
  let rec search i = function
    | [] -> invalid_arg "the element is not in its list"
    | head :: tail -> if head = element then i else search (i + 1) tail
  in
  search 0 list

let case_of_int = List.nth allCases
let int_of_case = index_of allCases
let direction_of_int = List.nth allDirections
let int_of_direction = index_of allDirections
let coord3 x y z' = C3 (z x, z y, z z')
let ints_of_coord3 (C3 (x, y, z)) = [ int x; int y; int z ]
let thresholds long short = TH (z long, z short)
let ints_of_thresholds (TH (long, short)) = [ int long; int short ]

(* {1 The lattice} *)

let constants () =
  let direction d =
    let kind = directionKind d in
    ints_of_coord3 (offset d)
    @ [ (match kind with Long -> 1 | Short -> 0); int (lengthSquared kind) ]
  in
  Array.of_list
    ([ Convert.int_of_nat stepBits; int steps; int midpointCut ]
    @ ints_of_thresholds angleThresholds
    @ ints_of_thresholds embeddingThresholds
    @ ints_of_thresholds noWarpThresholds
    @ ints_of_thresholds keyThresholds
    @ List.concat_map direction allDirections)

let threshold_steps long short is_long =
  int (thresholdSteps (thresholds long short) (if is_long <> 0 then Long else Short))

let case_count () = List.length allCases

let is_right_handed case =
  match caseHandedness (case_of_int case) with RightHanded -> 1 | LeftHanded -> 0

(* An order is shown by what it does to four points. *)
let ints_of_order order =
  let mark n = coord3 n 0 0 in
  let ((a, b), c), d = order (mark 0) (mark 1) (mark 2) (mark 3) in
  List.map (fun (C3 (n, _, _)) -> int n) [ a; b; c; d ]

let structured_tet x y z case =
  let neighbor (STId (anchor, case), order) =
    ints_of_coord3 anchor @ (int_of_case case :: ints_of_order order)
  in
  match getStructuredTet (STId (coord3 x y z, case_of_int case)) with
  | ST (v1, v2, v3, v4, n1, n2, n3, n4) ->
      Array.of_list
        (List.concat_map ints_of_coord3 [ v1; v2; v3; v4 ]
        @ List.concat_map neighbor [ n1; n2; n3; n4 ])

(* {1 The stencils} *)

let vertices tets =
  Array.of_list (List.concat_map (fun (UT (a, b, c, d)) -> [ a; b; c; d ]) tets)

let sign_of frame v = sign_of_int (get_sign frame v)

let unstructured_tets frame v1 v2 v3 v4 =
  vertices (getUnstructuredTets (sign_of frame) (get_intersection frame) v1 v2 v3 v4)

let key_tets frame v1 v2 v3 v4 =
  let key a b = z (get_key frame a b) in
  vertices (getKeyTets (sign_of frame) (get_intersection frame) key v1 v2 v3 v4)

let material_tets frame v1 v2 v3 v4 shared =
  let material v = match get_material frame v with -1 -> None | m -> Some (z m) in
  let intersection = material_intersection frame in
  getMaterialTets material intersection v1 v2 v3 v4 (z shared)
  |> List.concat_map (fun (m, UT (a, b, c, d)) -> [ int m; a; b; c; d ])
  |> Array.of_list

(* {1 Warping} *)

let warping direction distance =
  if direction < 0 then Stays else Moves (direction_of_int direction, z distance)

let warp_vertex frame long short sign =
  let neighbor_sign d = sign_of_int (neighbor_sign frame (int_of_direction d)) in
  let cut d = z (neighbor_cut frame (int_of_direction d)) in
  match warp (thresholds long short) (sign_of_int sign) neighbor_sign cut with
  | Stays -> [| -1; 0 |]
  | Moves (d, t) -> [| int_of_direction d; int t |]

let warped_sign sign direction distance =
  int_of_sign (warpedSign (sign_of_int sign) (warping direction distance))

let warped_position x y z direction distance =
  Array.of_list
    (ints_of_coord3 (warpedPosition (coord3 x y z) (warping direction distance)))

(* {1 Links} *)

let numbers = gather int_of_direction

(* A set of neighbours: bit n for the direction with number n. *)
let link_of_set set = gather (fun d -> (set lsr at numbers d) land 1 <> 0)

(* Two bits for each sign. *)
let is_disk signs =
  let sign d = sign_of_int ((signs lsr (2 * at numbers d)) land 3) in
  if isDisk (gather sign) then 1 else 0

(* The sets of 0 neighbours that leave a strict disk, in ascending order. *)
let disks plus =
  let is_disk = diskOf (link_of_set plus) in
  let rest = ((1 lsl List.length allDirections) - 1) land lnot plus in
  let rec from zero found =
    let found = if is_disk (link_of_set zero) then zero :: found else found in
    if zero = rest then List.rev found else from ((zero - rest) land rest) found
  in
  Array.of_list (from 0 [])

let in_one_piece set = if inOnePiece (link_of_set set) then 1 else 0

(* {1 Cuts} *)

let bisection frame =
  int (bisect (fun t -> sign_of_int (sign_at_step frame (int t))))

let edge_point ax ay az bx by bz t =
  Array.of_list (ints_of_coord3 (pointOnEdge (coord3 ax ay az) (coord3 bx by bz) (z t)))

(* {1 Voxels} *)

let voxel_sign frame half sx sy sz ox oy oz vx vy vz =
  let grid = Grid (z half, coord3 sx sy sz, coord3 ox oy oz) in
  let image voxel = holds frame (Array.of_list (ints_of_coord3 voxel)) <> 0 in
  int_of_sign (voxelSigns grid image (coord3 vx vy vz))

(* {1 Meshes} *)

let domain frame =
  let sign v = sign_of_int (domain_sign frame (Array.of_list (ints_of_coord3 v))) in
  let cut plus minus =
    z (domain_cut frame (Array.of_list (ints_of_coord3 plus @ ints_of_coord3 minus)))
  in
  { Domain.sign; cut }

let emit_placed frame position (UT (a, b, c, d)) =
  let coordinates v =
    let { Convert.x; y; z } = position v in
    [ x; y; z ]
  in
  emit frame (Array.of_list (List.concat_map coordinates [ a; b; c; d ]))

let emit_tet frame thresholds domain =
  emit_placed frame (Mesher.position thresholds domain)

let lattice ox oy oz nx ny nz =
  { Lattice.origin = { x = ox; y = oy; z = oz }; cells = { x = nx; y = ny; z = nz } }

let stuff_one frame long short x y z case =
  let thresholds = thresholds long short in
  let domain = domain frame in
  stuffTet thresholds domain.sign domain.cut (STId (coord3 x y z, case_of_int case))
  |> List.iter (emit_tet frame thresholds domain)

let stuff_all frame long short ox oy oz nx ny nz =
  let thresholds = thresholds long short in
  let lattice = lattice ox oy oz nx ny nz in
  let domain = Domain.within lattice (domain frame) in
  Mesher.iter_tets thresholds lattice domain (emit_tet frame thresholds domain)

let diagonals by_key = if by_key <> 0 then Settler.By_key else Settler.By_parity

let settle_all frame long short strict by_key ox oy oz nx ny nz =
  let lattice = lattice ox oy oz nx ny nz in
  let gap = if strict <> 0 then strictGap else levelGap in
  let domain = Domain.within lattice (domain frame) in
  let settled =
    Settler.settle ~diagonals:(diagonals by_key) gap (thresholds long short) lattice domain
  in
  Settler.iter_tets settled (emit_placed frame (Settler.position settled))

(* Of a mesh whose vertices settle, or are all moved. *)
let grade_all frame long short settles by_key levels ox oy oz nx ny nz =
  let lattice = lattice ox oy oz nx ny nz in
  let domain = Domain.within lattice (domain frame) in
  let thresholds = thresholds long short in
  let mesh =
    if settles <> 0 then
      Settler.mesh
        (Settler.settle ~diagonals:(diagonals by_key) levelGap thresholds lattice domain)
    else Mesher.mesh thresholds domain
  in
  Grader.iter_tets mesh levels lattice
    (emit_placed frame (fun v -> Convert.point_of_coord3 (mesh.positionIn v)))

(* {1 Meshes of several materials} *)

let is_well_shaped ax ay az bx by bz cx cy cz dx dy dz =
  let tet = UT (coord3 ax ay az, coord3 bx by bz, coord3 cx cy cz, coord3 dx dy dz) in
  if isWellShaped widestAngles tet then 1 else 0

let material_domain frame =
  let material v = z (domain_material frame (Array.of_list (ints_of_coord3 v))) in
  let cut higher lower =
    z (material_cut frame (Array.of_list (ints_of_coord3 higher @ ints_of_coord3 lower)))
  in
  { Material_domain.material; cut }

let emit_of_material frame (material, UT (a, b, c, d)) =
  emit_material frame (int material)
    (Array.of_list (List.concat_map ints_of_coord3 [ a; b; c; d ]))

let settle_materials frame long short ox oy oz nx ny nz =
  let lattice = lattice ox oy oz nx ny nz in
  let domain = Material_domain.within lattice (material_domain frame) in
  Material_mesher.iter_tets
    (Material_mesher.settle (thresholds long short) lattice domain)
    lattice (emit_of_material frame)

let halve_materials frame ox oy oz nx ny nz =
  let lattice = lattice ox oy oz nx ny nz in
  let domain = Material_domain.within lattice (material_domain frame) in
  Material_mesher.iter_tets
    (Material_mesher.unmoved (Material_domain.midpoint domain))
    lattice (emit_of_material frame)

(* Graded, by points that settle or stay where they are. *)
let grade_materials frame long short settles levels ox oy oz nx ny nz =
  let lattice = lattice ox oy oz nx ny nz in
  let domain = Material_domain.within lattice (material_domain frame) in
  let mesh =
    if settles <> 0 then Material_mesher.settle (thresholds long short) lattice domain
    else Material_mesher.unmoved (Material_domain.midpoint domain)
  in
  Grader.iter_material_tets mesh levels lattice (emit_of_material frame)

let () =
  Callback.register_exception "certified.parked" Parked;
  Callback.register "certified.constants" constants;
  Callback.register "certified.threshold_steps" threshold_steps;
  Callback.register "certified.case_count" case_count;
  Callback.register "certified.right_handed" is_right_handed;
  Callback.register "certified.structured_tet" structured_tet;
  Callback.register "certified.unstructured_tets" unstructured_tets;
  Callback.register "certified.key_tets" key_tets;
  Callback.register "certified.warp" warp_vertex;
  Callback.register "certified.warped_sign" warped_sign;
  Callback.register "certified.warped_position" warped_position;
  Callback.register "certified.is_disk" is_disk;
  Callback.register "certified.disks" disks;
  Callback.register "certified.in_one_piece" in_one_piece;
  Callback.register "certified.bisect" bisection;
  Callback.register "certified.point_on_edge" edge_point;
  Callback.register "certified.voxel_sign" voxel_sign;
  Callback.register "certified.stuff_tet" stuff_one;
  Callback.register "certified.stuff" stuff_all;
  Callback.register "certified.settle" settle_all;
  Callback.register "certified.grade" grade_all;
  Callback.register "certified.material_tets" material_tets;
  Callback.register "certified.is_well_shaped" is_well_shaped;
  Callback.register "certified.settle_materials" settle_materials;
  Callback.register "certified.halve_materials" halve_materials;
  Callback.register "certified.grade_materials" grade_materials
