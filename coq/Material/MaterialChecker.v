(** * Deciding whether the tetrahedra of materials fit together

    On symbols for the five vertices around a face, as in [TriangleChecker], but
    with patterns of materials in the place of signs.  Materials matter only by
    which vertices share one, so that each vertex names the first that has the
    same: 203 patterns of five vertices, 52 of four. *)

From Certet Require Import Material.Definitions.
From Certet Require Import Stencil.Symbol Stencil.TriangleChecker.
Open Scope Z_scope.

Definition FiveLabels : list Label := [F1; F2; F3; P; Q].

(** A number for each, as its material. *)
Definition Code (l : Label) : Material :=
  match l with F1 => 0 | F2 => 1 | F3 => 2 | P => 3 | Q => 4 end.

Definition LeaderOf (o1 o2 o3 op oq : option Label) (l : Label) : option Label :=
  match l with F1 => o1 | F2 => o2 | F3 => o3 | P => op | Q => oq end.

Definition SameLeader (o : option Label) (l : Label) : bool :=
  match o with Some k => SameLabel k l | None => false end.

(** Who is named, names itself. *)
Definition NamesItself (leader : Label -> option Label) (l : Label) : bool :=
  match leader l with
  | Some k => SameLeader (leader k) k
  | None => true
  end.

Definition Leaders (l : Label) : list (option Label) :=
  match l with
  | F1 => [None; Some F1]
  | F2 => [None; Some F1; Some F2]
  | F3 => [None; Some F1; Some F2; Some F3]
  | P => [None; Some F1; Some F2; Some F3; Some P]
  | Q => [None; Some F1; Some F2; Some F3; Some P; Some Q]
  end.

Definition ForAllPatterns (test : (Label -> option Label) -> bool) : bool :=
  forallb (fun o1 => forallb (fun o2 => forallb (fun o3 => forallb (fun op =>
    forallb (fun oq =>
      let leader := LeaderOf o1 o2 o3 op oq in
      if forallb (NamesItself leader) FiveLabels then test leader else true)
    (Leaders Q)) (Leaders P)) (Leaders F3)) (Leaders F2)) (Leaders F1).

(** ** The tetrahedra on symbols *)

Definition SymbolMaterial (leader : Label -> option Label) (s : Symbol)
  : option Material :=
  match s with Base l => option_map Code (leader l) | CutOf _ _ => None end.

(** The cut of an edge, its ends in the order of [FiveLabels]. *)
Definition EdgeSymbol (s t : Symbol) : Symbol :=
  match s, t with
  | Base a, Base b => if Code b <? Code a then CutOf b a else CutOf a b
  | _, _ => s
  end.

Definition Shared : Material := 5.

(** The materials' tetrahedra, or another set of them. *)
Definition MaterialSet : Type :=
  forall Vertex : Type,
    (Vertex -> option Material) -> (Vertex -> Vertex -> Vertex) ->
    Vertex -> Vertex -> Vertex -> Vertex -> Material ->
    list (Material * UnstructuredTet Vertex).

Section Check.
  Variable T : MaterialSet.

  Definition SymbolicMaterials (leader : Label -> option Label) (a b c d : Label)
    : list (Material * SymbolicTet) :=
    T Symbol (SymbolMaterial leader) EdgeSymbol (Base a) (Base b) (Base c) (Base d)
      Shared.

  (** Each triangle that [ts] have on the face, [us] have too, and of the same
      material if the face has a corner that has one. *)
  Definition CheckMaterialsIncluded (labelled : bool) (face : list Label)
    (ts us : list (Material * SymbolicTet)) : bool :=
    forallb (fun t =>
      let rivals :=
        if labelled then OfMaterial (fst t) us else map snd us in
      (negb labelled || (0 <=? fst t) && (fst t <? Shared)) &&
      forallb (fun abc => negb (TriangleOn face abc) || SomeHas rivals abc)
        (Triangles (snd t))) ts.

  Definition Labelled (leader : Label -> option Label) (face : list Label) : bool :=
    existsb (fun l => match leader l with Some _ => true | None => false end) face.

  Definition CheckMaterialFace (arrangement : Arrangement) : bool :=
    match arrangement with Arrange a b c d a' b' c' d' =>
      ForAllPatterns (fun leader =>
        let face := [F1; F2; F3] in
        let labelled := Labelled leader face in
        let ts := SymbolicMaterials leader a b c d in
        let us := SymbolicMaterials leader a' b' c' d' in
        CheckMaterialsIncluded labelled face ts us
        && CheckMaterialsIncluded labelled face us ts)
    end.

  Definition CheckMaterialFaces : bool := forallb CheckMaterialFace Arrangements.
End Check.

(** ** One structured tetrahedron *)

Section CheckInside.
  Variable T : MaterialSet.

  (** A triangle on a face belongs to one tetrahedron, any other to two. *)
  Definition CheckTwice (ts : list (Material * SymbolicTet)) : bool :=
    forallb (fun t =>
      forallb (fun abc =>
        match filter (fun u => Has (snd u) abc) ts,
              existsb (fun face => TriangleOn face abc) Faces with
        | [_], true => true
        | [u; w], false => negb (SameTet (snd u) (snd w))
        | _, _ => false
        end) (Triangles (snd t))) ts.

  (** A cut is named in the order of [FiveLabels]. *)
  Definition Ordered (s : Symbol) : bool :=
    match s with Base _ => true | CutOf a b => Code a <? Code b end.

  Definition CheckMaterialInside : bool :=
    ForAllPatterns (fun leader =>
      let ts := SymbolicMaterials T leader F1 F2 F3 P in
      CheckTwice ts
      && forallb (fun t => forallb Ordered (TetCorners (snd t))) ts).
End CheckInside.
