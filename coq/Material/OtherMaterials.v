(** * Three wrong ways to mesh materials

    They show that the checkers of [MaterialFacesAgree] and [MaterialTriangleTwice]
    can say no. *)

From Certet Require Import Material.Definitions.
Open Scope Z_scope.

Section OtherMaterials.
  Variable Vertex : Type.
  Variable GetMaterial : Vertex -> option Material.
  Variable GetIntersection : Vertex -> Vertex -> Vertex.
  Variables v1 v2 v3 v4 : Vertex.
  Variable shared : Material.

  (** Each material against the rest, and nothing between them: where three meet
      there is a hole. *)
  Definition UnfilledMaterials : list (Material * UnstructuredTet Vertex) :=
    match MaterialsOf Vertex GetMaterial [v1; v2; v3; v4] with
    | [] => [(shared, UT _ v1 v2 v3 v4)]
    | materials =>
        flat_map (TetsOfOne Vertex GetMaterial GetIntersection v1 v2 v3 v4)
          materials
    end.

  (** In one of the 11 patterns, the fill is of another of the three
      materials. *)
  Definition MislabelledMaterials : list (Material * UnstructuredTet Vertex) :=
    match GetMaterial v1, GetMaterial v2, GetMaterial v3, GetMaterial v4 with
    | Some m1, Some _, Some _, None =>
        UnfilledMaterials ++
        map (fun t => (m1, snd t))
          (MaterialFill Vertex GetMaterial
             (MaterialCut Vertex GetMaterial GetIntersection) v1 v2 v3 v4)
    | _, _, _, _ =>
        GetMaterialTets Vertex GetMaterial GetIntersection v1 v2 v3 v4 shared
    end.

  (** In one of them, the fill is divided along the other diagonal. *)
  Definition TwistedMaterials : list (Material * UnstructuredTet Vertex) :=
    let c v w := MaterialCut Vertex GetMaterial GetIntersection v w in
    match GetMaterial v1, GetMaterial v2, GetMaterial v3, GetMaterial v4 with
    | Some m1, Some m2, Some m3, Some m4 =>
        match m1 =? m2, m1 =? m3, m1 =? m4, m3 =? m4 with
        | true, false, false, false =>
            UnfilledMaterials ++
            [(m1, UT _ (c v1 v3) (c v1 v4) (c v2 v4) (c v3 v4));
             (m1, UT _ (c v1 v3) (c v2 v4) (c v2 v3) (c v3 v4))]
        | _, _, _, _ =>
            GetMaterialTets Vertex GetMaterial GetIntersection v1 v2 v3 v4 shared
        end
    | _, _, _, _ =>
        GetMaterialTets Vertex GetMaterial GetIntersection v1 v2 v3 v4 shared
    end.
End OtherMaterials.
