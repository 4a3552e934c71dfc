(** * Stuffing: from a sampled domain to the tetrahedra of the output

    The whole of the mesher but for loops and files: given the signs of the
    lattice vertices and the cuts of the lattice edges, the tetrahedra that
    fill one structured tetrahedron, with their positions. *)

From Certet Require Import Warp.Definitions.
Open Scope Z_scope.

(** A domain as the mesher sees it: the sign of each lattice vertex, and for
    an edge from a + vertex to a - vertex the cut in steps from the former. *)
Definition SignField := Coord3 -> Sign.
Definition CutField := Coord3 -> Coord3 -> Z.

(** A vertex of the output: a corner of the lattice, perhaps warped, or the
    cut of a lattice edge, + end first. *)
Inductive MeshVertex :=
| Corner : Coord3 -> MeshVertex
| Cut : Coord3 -> Coord3 -> MeshVertex.

Section Stuffing.
  Variable th : Thresholds.
  Variable sign : SignField.
  Variable cut : CutField.

  (** Steps from [v] to the cut of its edge in direction [d]. *)
  Definition CutFrom (v : Coord3) (d : Direction) : Z :=
    let u := Translate v (Offset d) in
    match sign v with
    | Plus => cut v u
    | _ => Steps - cut u v
    end.

  Definition WarpVertex (v : Coord3) : Warping :=
    Warp th (sign v) (fun d => sign (Translate v (Offset d))) (CutFrom v).

  Definition MeshVertexSign (v : MeshVertex) : Sign :=
    match v with
    | Corner c => WarpedSign (sign c) (WarpVertex c)
    | Cut _ _ => OnSurface
    end.

  Definition MeshIntersection (a b : MeshVertex) : MeshVertex :=
    match a, b with
    | Corner plus, Corner minus => Cut plus minus
    | _, _ => a
    end.

  (** Where a vertex of the output lies, in steps. *)
  Definition MeshPosition (v : MeshVertex) : Coord3 :=
    match v with
    | Corner c => WarpedPosition c (WarpVertex c)
    | Cut plus minus => PointOnEdge plus minus (cut plus minus)
    end.

  (** Vertex order for a positive volume. *)
  Definition Orient (h : Handedness) (t : UnstructuredTet MeshVertex)
    : UnstructuredTet MeshVertex :=
    match h, t with
    | RightHanded, _ => t
    | LeftHanded, UT _ a b c d => UT _ a b d c
    end.

  Definition StuffTet (tid : StructuredTetId)
    : list (UnstructuredTet MeshVertex) :=
    match tid, GetStructuredTet tid with
    | STId _ case, ST v1 v2 v3 v4 _ _ _ _ =>
        map (Orient (CaseHandedness case))
            (GetUnstructuredTets MeshVertex MeshVertexSign MeshIntersection
               (Corner v1) (Corner v2) (Corner v3) (Corner v4))
    end.
End Stuffing.
