open Certified
open Json

(* Six times the volume of the structured tetrahedron as warping left it. *)
let warped_volume thresholds domain corners =
  let place v = Mesher.position thresholds domain (Corner v) in
  match List.map place corners with
  | [ a; b; c; d ] ->
      let u = Convert.(b.x - a.x, b.y - a.y, b.z - a.z) in
      let v = Convert.(c.x - a.x, c.y - a.y, c.z - a.z) in
      let w = Convert.(d.x - a.x, d.y - a.y, d.z - a.z) in
      let determinant (a1, a2, a3) (b1, b2, b3) (c1, c2, c3) =
        (a1 * ((b2 * c3) - (b3 * c2))) - (a2 * ((b1 * c3) - (b3 * c1)))
        + (a3 * ((b1 * c2) - (b2 * c1)))
      in
      determinant u v w
  | _ -> assert false

let is_turned_over thresholds domain (STId (_, case) as id) =
  let (ST (v1, v2, v3, v4, _, _, _, _)) = getStructuredTet id in
  let corners = [ v1; v2; v3; v4 ] in
  let on_surface v =
    meshVertexSign thresholds domain.Domain.sign domain.Domain.cut (Corner v) = OnSurface
  in
  List.for_all on_surface corners
  &&
  let volume = warped_volume thresholds domain corners in
  match caseHandedness case with RightHanded -> volume <= 0 | LeftHanded -> volume >= 0

let turned_over thresholds lattice domain =
  let count = ref 0 in
  Lattice.iter_tets lattice (fun id -> if is_turned_over thresholds domain id then incr count);
  !count

let numbered thresholds lattice domain =
  Sampled.numbered (Mesher.position thresholds domain)
    (Mesher.iter_tets thresholds lattice domain)

(* Which thresholds are used in the end, by name. *)
let choose { Mesh_domains.cuts; guarantee; lattice; _ } domain =
  match (cuts, guarantee) with
  | Midpoint, _ -> ("midpoint", 0)
  | Explicit, Embedding -> ("embedding", 0)
  | Explicit, Angles -> (
      match turned_over angleThresholds lattice domain with
      | 0 -> ("angles", 0)
      | count -> ("embedding", count))

let judged ({ Mesh_domains.name; lattice; cuts; guarantee; domain } as case) =
  let sampled = Domain.within lattice domain in
  let decided = if cuts = Midpoint then Domain.midpoint sampled else sampled in
  let used, turned_over = choose case decided in
  let thresholds = List.assoc used Notation.thresholds in
  let points, tets = numbered thresholds lattice decided in
  let given_cuts = match cuts with Midpoint -> [] | Explicit -> Sampled.cut_edges (Sampled.from_plus_to_minus sampled.sign) lattice in
  Object
    [
      ("name", Text name);
      ("origin", Notation.point lattice.origin);
      ("cells", Notation.point lattice.cells);
      ("cuts", Text (match cuts with Explicit -> "explicit" | Midpoint -> "midpoint"));
      ("guarantee", Text (match guarantee with Angles -> "angles" | Embedding -> "embedding"));
      ("even", Sampled.sign_grid domain.sign lattice 0);
      ("odd", Sampled.sign_grid domain.sign lattice 1);
      ("cut", List (List.map (Sampled.explicit_cut sampled.cut) given_cuts));
      ("turned_over", Int turned_over);
      ("thresholds", Text used);
      ("points", points);
      ("tets", List tets);
    ]

let all () = List.map judged Mesh_domains.all
