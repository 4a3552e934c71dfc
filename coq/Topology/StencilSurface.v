(** * The surface within one structured tetrahedron, on symbols

    What the 81 stencils do where all three vertices of a triangle are on the
    surface: 0 corners, and cuts.  That it holds of the mesh is proved in
    [SurfaceViewProof]. *)

From Coq Require Import Arith.
From Certet Require Import Stencil.Definitions.
From Certet Require Import Stencil.Symbol Stencil.CompatibilityChecker
  Stencil.TriangleChecker Embedding.EdgeRank Embedding.MeshApartProof.
Open Scope bool_scope.

Definition Four : list Label := [F1; F2; F3; P].

Definition AllSymbols : list Symbol :=
  map Base Four ++ map (fun '(a, m) => CutOf a m) (list_prod Four Four).

Section Signs.
  Variable sign : Label -> Sign.

  Definition Is (s : Sign) (l : Label) : bool := IsSign (sign l) s.

  (** The vertices on the surface. *)
  Definition Valid (s : Symbol) : bool :=
    match s with
    | Base a => Is OnSurface a
    | CutOf a m => Is Plus a && Is Minus m
    end.

  Definition Valids : list Symbol := filter Valid AllSymbols.

  Variable ts : list SymbolicTet.

  Definition IsTriangle (s r u : Symbol) : bool :=
    Distinct s r u && SomeHas ts (s, r, u).

  Definition IsBase (s : Symbol) : bool :=
    match s with Base _ => true | _ => false end.

  (** All labels are ends of these. *)
  Definition Cover (symbols : list Symbol) : bool :=
    forallb (fun l => existsb (Touches l) symbols) Four.

  (** Where + and other labels meet: the cut, or the 0 corner. *)
  Definition Crossing (e f : Label) : Symbol :=
    if Is Minus f then CutOf e f else Base f.

  (** On the face with the cut from [a] to [m]: the other vertex on the surface. *)
  Definition FaceThird (a m c : Label) : Symbol :=
    if Is Plus c then CutOf c m else if Is Minus c then CutOf a c else Base c.

  Definition ForAllTriangles3 (test : SymbolicTet -> Symbol -> Symbol -> Symbol -> bool)
    : bool :=
    forallb (fun t => forallb (fun s => forallb (fun r => forallb (fun u =>
      negb (Distinct s r u && Has t (s, r, u)) || test t s r u)
      Valids) Valids) Valids) ts.

  (** A triangle on the surface belongs to one tetrahedron; it lies inside, or its
      corners are 0 and the fourth is +. *)
  Definition CheckTriangles : bool :=
    ForAllTriangles3 (fun t s r u =>
      forallb (fun t' => negb (Has t' (s, r, u)) || SameTet t t') ts &&
      (Cover [s; r; u] ||
       IsBase s && IsBase r && IsBase u &&
       existsb (fun l => Is Plus l && Cover [s; r; u; Base l]) Four)).

  Definition FourLabels (test : Label -> Label -> Label -> Label -> bool) : bool :=
    forallb (fun a => forallb (fun b => forallb (fun c => forallb (fun d =>
      if SameLabel a b || SameLabel a c || SameLabel a d || SameLabel b c ||
         SameLabel b d || SameLabel c d then true else test a b c d)
      Four) Four) Four) Four.

  (** Three 0 corners under a + are a triangle. *)
  Definition CheckZeros : bool :=
    FourLabels (fun a b c d =>
      if Is OnSurface a && Is OnSurface b && Is OnSurface c && Is Plus d
      then IsTriangle (Base a) (Base b) (Base c) else true).

  Definition One (l : list Symbol) : bool :=
    match l with [_] => true | _ => false end.

  Definition OneMore (s : Symbol) (l : list Symbol) : bool :=
    match l with
    | [r; u] => negb (SameSymbol r u) && (SameSymbol s r || SameSymbol s u)
    | _ => false
    end.

  (** An edge on a face, with a cut, lies in one triangle; one across the inside,
      if in any, in two. *)
  Definition CheckEdges : bool :=
    forallb (fun s => forallb (fun r =>
      SameSymbol s r || IsBase s && IsBase r ||
      let thirds := filter (IsTriangle s r) Valids in
      if Cover [s; r] then forallb (fun u => OneMore u thirds) thirds
      else One thirds) Valids) Valids.

  (** A triangle at two 0 corners ends where the other two cross. *)
  Definition CheckZeroEdges : bool :=
    FourLabels (fun a b e f =>
      if Is OnSurface a && Is OnSurface b then
        forallb (fun u => negb (IsTriangle (Base a) (Base b) u) ||
          Is Plus e && negb (Is Plus f) && SameSymbol u (Crossing e f) ||
          Is Plus f && negb (Is Plus e) && SameSymbol u (Crossing f e)) Valids
      else true).

  (** The triangles at a 0 corner: what crosses, and how it goes on. *)
  Definition CheckZeroFans : bool :=
    FourLabels (fun z w e f =>
      if Is OnSurface z && Is Plus e && negb (Is Plus f) then
        if Is Plus w
        then SameSymbol (Crossing e f) (Crossing w f) ||
             IsTriangle (Base z) (Crossing e f) (Crossing w f)
        else IsTriangle (Base z) (Crossing e f) (Crossing e w)
      else true) &&
    forallb (fun z => forallb (fun s => forallb (fun r =>
      if Is OnSurface z && IsTriangle (Base z) s r then
        existsb (fun e => existsb (fun f =>
          Is Plus e && negb (Is Plus f) && negb (SameLabel z f) &&
          SameSymbol s (Crossing e f)) Four) Four
      else true) Valids) Valids) Four.

  (** The triangles at a cut lead from one of its faces to the other. *)
  Definition CheckCutFans : bool :=
    FourLabels (fun a m c d =>
      if Is Plus a && Is Minus m then
        let s := CutOf a m in let r := FaceThird a m c in let u := FaceThird a m d in
        (IsTriangle s r u ||
         existsb (fun w => IsTriangle s r w && IsTriangle s w u) Valids) &&
        forallb (fun w => forallb (fun x => negb (IsTriangle s w x) ||
          SameSymbol r w || SameSymbol u w || IsTriangle s r w) Valids) Valids
      else true).

  Definition CheckSurface : bool :=
    CheckTriangles && CheckZeros && CheckEdges && CheckZeroEdges &&
    CheckZeroFans && CheckCutFans.
End Signs.

Lemma SurfaceChecked : ForAllSignAssignments (fun sign =>
  CheckSurface sign (SymbolicTets GetUnstructuredTets sign F1 F2 F3 P)) = true.
Proof. vm_compute. reflexivity. Qed.
