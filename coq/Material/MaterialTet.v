(** * The tetrahedra of the output, for any number of materials

    Every corner of a structured tetrahedron has a material, one of which may be
    the outside, or lies on an interface.  Its tetrahedra are those that
    [GetUnstructuredTets] makes of each material against the rest, and, where
    three or four materials meet, what remains between them: the fill.

    An edge between two materials has one cut, whichever of the two is looked
    at; it is taken from the higher to the lower material, from the inside to
    the outside in particular. *)

From Certet Require Import Stencil.Definitions.
Open Scope Z_scope.

(** Materials are numbers, of which the lowest is the outside. *)
Definition Material : Type := Z.
Definition Outside : Material := 0.

(** ** The fill

    The 11 ways in which three or four materials meet, each printed in full.  A
    face with three materials is divided by the cut of its long edge: at each
    end of that edge stands a triangle of that end's material, and at the apex
    across from it two, that of the apex and the one between the three cuts,
    which counts as the apex's material too.  The latter is where the fill
    begins.  Each tetrahedron is right-handed when its structured tetrahedron
    is. *)

Section MaterialFill.
  Variable Vertex : Type.

  (** None: on an interface. *)
  Variable GetMaterial : Vertex -> option Material.
  (** The cut of an edge, whichever end is named first. *)
  Variable GetCut : Vertex -> Vertex -> Vertex.

  Variables v1 v2 v3 v4 : Vertex.

  Local Notation c12 := (GetCut v1 v2).
  Local Notation c13 := (GetCut v1 v3).
  Local Notation c14 := (GetCut v1 v4).
  Local Notation c23 := (GetCut v2 v3).
  Local Notation c24 := (GetCut v2 v4).
  Local Notation c34 := (GetCut v3 v4).

  Definition MaterialFill : list (Material * UnstructuredTet Vertex) :=
    match GetMaterial v1, GetMaterial v2, GetMaterial v3, GetMaterial v4 with
    | Some m1, Some m2, Some m3, Some m4 =>
        match m1 =? m2, m3 =? m4, m1 =? m3, m2 =? m4, m1 =? m4, m2 =? m3 with
        (* all four differ *)
        | false, false, false, false, false, false =>
            [(m1, UT _ c12 c34 c13 c14);
             (m2, UT _ c12 c34 c24 c23);
             (m3, UT _ c12 c34 c23 c13);
             (m4, UT _ c12 c34 c14 c24)]
        (* the ends of a long edge are one material *)
        | true, false, false, false, false, false =>
            [(m1, UT _ c13 c14 c23 c34);
             (m1, UT _ c14 c24 c23 c34)]
        | false, true, false, false, false, false =>
            [(m3, UT _ c13 c14 c12 c23);
             (m3, UT _ c14 c24 c12 c23)]
        (* the ends of a short edge are one material *)
        | false, false, true, false, false, false =>
            [(m2, UT _ c12 c34 c24 c23);
             (m4, UT _ c12 c34 c14 c24)]
        | false, false, false, true, false, false =>
            [(m1, UT _ c12 c34 c13 c14);
             (m3, UT _ c12 c34 c23 c13)]
        | false, false, false, false, true, false =>
            [(m2, UT _ c12 c34 c24 c23);
             (m3, UT _ c12 c34 c23 c13)]
        | false, false, false, false, false, true =>
            [(m1, UT _ c12 c34 c13 c14);
             (m4, UT _ c12 c34 c14 c24)]
        (* two materials or one *)
        | _, _, _, _, _, _ => []
        end
    (* one corner lies on an interface, and the others differ *)
    | None, Some m2, Some m3, Some m4 =>
        match m2 =? m3, m2 =? m4, m3 =? m4 with
        | false, false, false => [(m2, UT _ v1 c34 c24 c23)]
        | _, _, _ => []
        end
    | Some m1, None, Some m3, Some m4 =>
        match m1 =? m3, m1 =? m4, m3 =? m4 with
        | false, false, false => [(m1, UT _ v2 c34 c13 c14)]
        | _, _, _ => []
        end
    | Some m1, Some m2, None, Some m4 =>
        match m1 =? m2, m1 =? m4, m2 =? m4 with
        | false, false, false => [(m4, UT _ v3 c12 c24 c14)]
        | _, _, _ => []
        end
    | Some m1, Some m2, Some m3, None =>
        match m1 =? m2, m1 =? m3, m2 =? m3 with
        | false, false, false => [(m3, UT _ v4 c12 c13 c23)]
        | _, _, _ => []
        end
    (* two corners or more lie on an interface *)
    | _, _, _, _ => []
    end.
End MaterialFill.

(** ** All of a structured tetrahedron *)

Section GetMaterialTets.
  Variable Vertex : Type.
  Variable GetMaterial : Vertex -> option Material.
  Variable GetIntersection : Vertex -> Vertex -> Vertex.

  (** One material against all others. *)
  Definition SignAmongMaterials (m : Material) (v : Vertex) : Sign :=
    match GetMaterial v with
    | None => OnSurface
    | Some n => if n =? m then Plus else Minus
    end.

  (** The edge from [v] to [w], from its higher material to its lower one. *)
  Definition MaterialCut (v w : Vertex) : Vertex :=
    match GetMaterial v, GetMaterial w with
    | Some m, Some n =>
        if m <? n then GetIntersection w v else GetIntersection v w
    | _, _ => GetIntersection v w
    end.

  (** The materials of some vertices, each once, as they come. *)
  Definition AddMaterial (found : list Material) (v : Vertex) : list Material :=
    match GetMaterial v with
    | None => found
    | Some m => if existsb (Z.eqb m) found then found else found ++ [m]
    end.

  Definition MaterialsOf (vertices : list Vertex) : list Material :=
    fold_left AddMaterial vertices [].

  Variables v1 v2 v3 v4 : Vertex.

  Definition TetsOfOne (m : Material)
    : list (Material * UnstructuredTet Vertex) :=
    map (pair m)
      (GetUnstructuredTets Vertex (SignAmongMaterials m) MaterialCut
         v1 v2 v3 v4).

  (** [shared] is the material of a tetrahedron whose corners all lie on an
      interface, which they do not tell. *)
  Definition GetMaterialTets (shared : Material)
    : list (Material * UnstructuredTet Vertex) :=
    match MaterialsOf [v1; v2; v3; v4] with
    | [] => [(shared, UT _ v1 v2 v3 v4)]
    | materials =>
        flat_map TetsOfOne materials ++
        MaterialFill Vertex GetMaterial MaterialCut v1 v2 v3 v4
    end.
End GetMaterialTets.

(** The tetrahedra of one material. *)
Definition OfMaterial {Vertex : Type} (m : Material)
  (tets : list (Material * UnstructuredTet Vertex))
  : list (UnstructuredTet Vertex) :=
  map snd (filter (fun t => fst t =? m) tets).
