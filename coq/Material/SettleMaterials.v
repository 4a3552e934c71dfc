(** * The warp that keeps the shape, of several materials, as it runs

    [Settle] of [Embedding/Settle.v] with a material for each sample in the place
    of a sign.  The rule, in full:

    1. A vertex is violated if a cut on an edge to a neighbour of another
       material is nearer than alpha of that edge; the nearest such cut is its
       target ([WarpMaterialVertex]).  So it lies between two materials: its own
       and that of the neighbour in the direction of the target.
    2. The violated vertices have their turns in the order of [MaterialTurn]: that
       of one material, with those of the lower of their two materials before
       those of the higher.
    3. A vertex stays for good unless its link is a strict disk for each of the
       materials around it but the lowest, that one being + and the others -, and
       for all of these together ([AreDisks]); and unless no two fills of one
       material would touch each other in an edge alone ([FillsWouldTouch]).
    4. It stays, too, where a tetrahedron would then have four corners that moved
       and could not be kept: one whose corners do not all have the same lower
       material, or have one lower than that beside them, so that it might touch
       others of its material in an edge alone, or one that is not the outside, so
       that it is part of the mesh, but is not well shaped ([MayShare]).
    5. Otherwise it becomes part of an interface at its target, or short of it, or
       stays because that is nearer to where the interface is, as with one material:
       - and + are who is of the lower and of the higher of two materials.
    6. Cuts that remain are kept alpha away from both ends ([ClampedCut]), and
       [GetMaterialTets] fills what there is; a tetrahedron with four corners that
       moved is of their lower material. *)

From Coq Require Import FMapPositive.
From Certet Require Import Material.Definitions.
From Certet Require Import Embedding.DiskTables Material.MaterialShape.
Open Scope Z_scope.

(** ** Links *)

(** The neighbours that are of such a material are +, others -, and those on an
    interface 0. *)
Definition SignsAmong (inner : Material -> bool) (link : Link (option Material))
  : Link Sign :=
  Gather (fun d =>
    match At link d with
    | None => OnSurface
    | Some m => if inner m then Plus else Minus
    end).

Definition LowestOf (materials : list Material) : Material :=
  match materials with [] => Outside | m :: rest => fold_left Z.min rest m end.

(** Each material but the lowest by itself, and all of these together. *)
Definition AreDisks (materials : list Material) (link : Link (option Material))
  : bool :=
  let lowest := LowestOf materials in
  forallb (fun m => (m =? lowest) || IsDisk (SignsAmong (Z.eqb m) link)) materials &&
  IsDisk (SignsAmong (fun m => negb (m =? lowest)) link).

(** On both sides of a long edge of the link that is cut lies the same material,
    a third one, which has nothing else between its two fills there. *)
Definition FillsWouldTouch (link : Link (option Material)) : bool :=
  existsb (fun '((d, e), (f, g)) =>
    match DirectionKind d, DirectionKind e,
          At link d, At link e, At link f, At link g with
    | Short, Short, Some m, Some n, Some side, Some side' =>
        negb (m =? n) && (side =? side') && negb (side =? m) && negb (side =? n)
    | _, _, _, _, _, _ => false
    end) WallTable.

(** ** The rule *)

Section SettleMaterials.
  Variables (bounds : AngleBounds) (th : Thresholds).
  (** Of all lattice points: none lies on an interface. *)
  Variables (material : Coord3 -> Material) (cut : CutField).

  (** Of the two materials that [v] lies between: the lower, and whether its own
      is the higher. *)
  Definition LowerOf (v : Coord3) (e : Direction) : Material :=
    Z.min (material v) (material (Translate v (Offset e))).

  Definition IsHigher (v : Coord3) (e : Direction) : bool :=
    material (Translate v (Offset e)) <? material v.

  (** The side of its surface that a vertex lies on. *)
  Definition MaterialSide : SignField := fun v =>
    match WarpMaterialVertex th (fun v => Some (material v)) cut v with
    | Moves e _ => if IsHigher v e then Plus else Minus
    | Stays => Minus
    end.

  (** The materials of now around [v]. *)
  Definition MaterialLink (zeros : Zeros) (v : Coord3) : Link (option Material) :=
    Gather (fun d =>
      PlacedMaterial (fun v => Some (material v)) (PlaceIn zeros)
        (Translate v (Offset d))).

  (** Those two, and all others around. *)
  Definition MaterialsAround (v : Coord3) (e : Direction)
    (link : Link (option Material)) : list Material :=
    MaterialsOf (option Material) (fun m => m)
      (Some (material v) :: Some (material (Translate v (Offset e)))
       :: map (At link) AllDirections).

  (** The lower material of a vertex that has moved. *)
  Definition LowerIn (zeros : Zeros) (v : Coord3) : option Material :=
    match PlaceIn zeros v with Moves e _ => Some (LowerOf v e) | Stays => None end.

  (** The material of a tetrahedron with four corners that moved. *)
  Definition SharedIn (zeros : Zeros) (tid : StructuredTetId) : Material :=
    match map (LowerIn zeros) (Corners tid) with
    | Some m :: _ => m
    | _ => Outside
    end.

  Definition HaveMoved (zeros : Zeros) (tid : StructuredTetId) : bool :=
    forallb (fun v => match PlaceIn zeros v with Moves _ _ => true | Stays => false end)
      (Corners tid).

  (** No sample around [v] is of a lower one. *)
  Definition IsLowestAt (lowest : Material) (v : Coord3) : bool :=
    forallb (fun d => lowest <=? material (Translate v (Offset d))) AllDirections.

  Definition MayShare (zeros : Zeros) (tid : StructuredTetId) : bool :=
    if HaveMoved zeros tid then
      let shared := SharedIn zeros tid in
      forallb (fun v =>
        match LowerIn zeros v with
        | Some m => (m =? shared) && IsLowestAt shared v
        | None => false
        end) (Corners tid) &&
      ((shared =? Outside) || IsWellShaped bounds (PlacedWhole (PlaceIn zeros) cut tid))
    else true.

  (** The cut in direction [d] violates [v]. *)
  Definition MaterialViolatesAt (v : Coord3) : Direction -> bool :=
    Violates th Plus
      (fun d => SignAmongMaterials Coord3 (fun u => Some (material u)) (material v)
                  (Translate v (Offset d)))
      (MaterialCutFrom (fun u => Some (material u)) cut v).

  Definition MaterialTurn (v : Coord3) : nat :=
    match WarpMaterialVertex th (fun v => Some (material v)) cut v with
    | Stays => 0
    | Moves d t =>
        8 * Z.to_nat (4 * t / ThresholdSteps th (DirectionKind d))
        + (if IsHigher v d then 4 else 0) + Colour v
    end.

  (** One vertex has its turn. *)
  Definition SettleOneMaterial (zeros : Zeros) (v : Coord3) : Zeros :=
    match WarpMaterialVertex th (fun v => Some (material v)) cut v with
    | Stays => zeros
    | Moves e t =>
        let link := MaterialLink zeros v in
        if AreDisks (MaterialsAround v e link) link && negb (FillsWouldTouch link) then
          let reached := Shortened MaterialSide LevelGap
            (WarpMaterialVertex th (fun v => Some (material v)) cut) MaterialTurn
            zeros v e t in
          let moved := PositiveMap.add (PointKey v) (Moves e reached) zeros in
          if negb (StaysRather th (MaterialViolatesAt v) e t reached)
             && forallb (MayShare moved) (TetsAround v)
          then moved else zeros
        else zeros
    end.

  (** All of a list, in its order. *)
  Definition SettleMaterials (vs : list Coord3) : Zeros :=
    fold_left SettleOneMaterial vs NoZeros.

  (** ** The order *)

  (** Those of a list that are violated, by turns. *)
  Definition MaterialsInTurn (vs : list Coord3) : list Coord3 :=
    let violated v :=
      match WarpMaterialVertex th (fun v => Some (material v)) cut v with
      | Moves _ _ => true
      | Stays => false
      end in
    let turned := map (fun v => (MaterialTurn v, v)) (filter violated vs) in
    flat_map (fun n => map snd (filter (fun '(m, _) => Nat.eqb m n) turned))
      (seq 0 Turns).

  (** ** The mesh: the tetrahedra of all materials in one structured tetrahedron *)

  Definition SettledMaterialTets (zeros : Zeros) (tid : StructuredTetId)
    : list (Material * UnstructuredTet Coord3) :=
    PlacedMaterialTets (fun v => Some (material v)) (PlaceIn zeros)
      (ClampedCut th cut) (SharedIn zeros) tid.
End SettleMaterials.
