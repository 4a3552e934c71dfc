open Certified
open Convert

(* A level from the one below, by a single step of [closedCells]. *)
let parents below =
  closedCells (fun level c -> match level with O -> below c | S _ -> false) (S O)

let octree_around is_kept levels =
  let remembered decide =
    let known = Hashtbl.create 4096 in
    fun c -> Domain.remembered known (point_of_coord3 c) (fun () -> decide c)
  in
  let rec build cells level =
    if level >= levels then []
    else
      let cells = remembered cells in
      cells :: build (parents cells) (level + 1)
  in
  let by_level = Array.of_list (build is_kept 0) in
  fun level c ->
    let n = int_of_nat level in
    n >= levels || by_level.(n) c

let octree sign = octree_around (isNearSurface sign)

(* Points of a cell that can be left out are all inside one material, as one of them is. *)
let is_near_other_material material_in c =
  match material_in (List.hd (pointsOfCell c)) with
  | Some m when m <> outside -> isNearSurface (signAmongMaterials material_in m) c
  | _ -> true

let axis_orders = [ XYZ; XZY; YXZ; YZX; ZXY; ZYX ]
let sides = [ false; true ]

let iter_flags level cell visit =
  let iter list f = List.iter f list in
  iter axis_orders (fun order ->
      iter sides (fun s ->
          iter sides (fun t ->
              iter sides (fun u -> visit (MakeFlag (level, cell, order, s, t, u))))))

(* The cells of a level that touch the lattice. *)
let iter_cells level { Lattice.origin; cells } visit =
  let rec halved n levels = if levels = 0 then n else halved (n asr 1) (levels - 1) in
  let range origin cells =
    let first = halved (origin / 2) level in
    List.init (halved ((origin / 2) + cells - 1) level - first + 1) (fun n -> first + n)
  in
  List.iter
    (fun z ->
      List.iter
        (fun y ->
          List.iter
            (fun x -> visit (coord3_of_point { x; y; z }))
            (range origin.x cells.x))
        (range origin.y cells.y))
    (range origin.z cells.z)

let rec nat_of_int n = if n = 0 then O else S (nat_of_int (n - 1))

let iter_names cells levels lattice visit =
  for n = 0 to levels do
    let level = nat_of_int n in
    iter_cells n lattice (fun cell ->
        iter_flags level cell (fun flag ->
            if isPresent cells flag then
              match tetOfFlag cells flag with
              | GTId (_, naming) as name when naming = flag -> visit name
              | _ -> ()))
  done

let iter_tets mesh levels lattice visit =
  let known = Hashtbl.create 4096 in
  let sign v =
    Domain.remembered known (point_of_coord3 v) (fun () -> mesh.signIn (Corner v))
  in
  let cells = octree sign levels in
  iter_names cells levels lattice (fun name ->
      List.iter visit (gradedTetsWithin mesh name))

let iter_material_tets mesh levels lattice visit =
  let known = Hashtbl.create 4096 in
  let material_in v =
    Domain.remembered known (point_of_coord3 v) (fun () -> mesh.Material_mesher.material_in v)
  in
  let whole name =
    match getGradedTet name with
    | UT (a, _, _, _) as tet -> (Option.get (material_in a), mapTet (scale steps) tet)
  in
  let cells = octree_around (is_near_other_material material_in) levels in
  iter_names cells levels lattice (fun name ->
      match structuredName name with
      | Some id -> Material_mesher.iter_within mesh id visit
      | None -> visit (whole name))
