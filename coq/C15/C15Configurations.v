(** * What warping can leave of one tetrahedron of C15, enumerated

    As in [KeyConfigurations], of one tetrahedron of each of the three kinds.  An
    edge's direction is the offset to its other end, and a symmetry of the tetrahedron
    is an order of its corners together with an isometry that carries it, and the
    edges around it, to itself.  Of configurations that symmetries carry to each
    other the first is checked. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Forms.Checker Angles.Cases.Configurations
  Angles.Cases.Isometry Key.KeyTet Key.Orders Key.KeyConfigurations.
From Certet Require Import C15.Sites C15.C15Tet C15.C15Stuffing.
Open Scope Z_scope.

Definition PlaceOf (l : Label) : Place :=
  match l with V1 => First | V2 => Second | V3 => Third | V4 => Fourth end.

(** The corners of a case in the first cell. *)
Definition CaseCorners (case : C15Case) : Quad Coord3 :=
  Q4 (C15Corner case First) (C15Corner case Second)
     (C15Corner case Third) (C15Corner case Fourth).

(** ** Frames

    An order of the corners, and a linear map. *)

Inductive Frame := Fr : Quad Label -> Linear -> Frame.

Definition OrderIn (f : Frame) : Quad Label := match f with Fr g _ => g end.
Definition MapOf (f : Frame) : Linear := match f with Fr _ m => m end.

(** How many pairs of labels stand the other way round. *)
Definition Inversions (g : Quad Label) : Z :=
  let number l := match l with V1 => 1 | V2 => 2 | V3 => 3 | V4 => 4 end in
  let one a b := if number b <? number a then 1 else 0 in
  match g with
    Q4 a b c d => one a b + one a c + one a d + one b c + one b d + one c d
  end.

(** Whether each label stands in it once. *)
Definition AllDifferent (g : Quad Label) : bool :=
  forallb (fun l => forallb (fun k =>
    implb (LabelEqual (Of g l) (Of g k)) (LabelEqual l k)) AllLabels) AllLabels.

Definition LabelOrders : list (Quad Label) :=
  filter AllDifferent (Product4 AllLabels AllLabels AllLabels AllLabels).

(** 1 for an even order, -1 for an odd one. *)
Definition OrderDeterminant (g : Quad Label) : Z :=
  if Z.even (Inversions g) then 1 else -1.

Definition SameMetal (a b : Metal) : bool :=
  match a, b with Mg, Mg | Cu, Cu => true | _, _ => false end.

(** The map carries corners [p], in their order, to corners [q], up to a
    translation, *)
Definition CarriesQuad (p q : Quad Coord3) (f : Frame) : bool :=
  let 'Fr g m := f in
  forallb (fun l =>
    Coord3Equal (Apply m (Difference (Of p (Of g V1)) (Of p (Of g l))))
      (Difference (Of q V1) (Of q l))) AllLabels.

(** and the edges of each, with their metals. *)
Definition CarriesEdges (p q : Quad Coord3) (f : Frame) : bool :=
  let 'Fr g m := f in
  forallb (fun l =>
    let a := Of p (Of g l) in
    let b := Of q l in
    SameMetal (MetalOf a) (MetalOf b) &&
    forallb (fun o =>
      existsb (Coord3Equal (Apply m o)) (OffsetsAround b) &&
      SameMetal (MetalOf (Translate a o)) (MetalOf (Translate b (Apply m o))))
      (OffsetsAround a))%bool AllLabels.

Definition IsFrame (p q : Quad Coord3) (f : Frame) : bool :=
  if CarriesQuad p q f then
    if Determinant (MapOf f) =? OrderDeterminant (OrderIn f)
    then CarriesEdges p q f else false
  else false.

Definition Frames (p q : Quad Coord3) : list Frame :=
  filter (IsFrame p q)
    (flat_map (fun g => map (Fr g) AllIsometries) LabelOrders).

(** ** Configurations *)

Definition OffsetMoves : Type := Quad (option Coord3).

Definition SignsIn (g : Quad Label) (signs : Quad Sign) : Quad Sign :=
  Q4 (Of signs (Of g V1)) (Of signs (Of g V2)) (Of signs (Of g V3)) (Of signs (Of g V4)).

Definition MovesIn (f : Frame) (moves : OffsetMoves) : OffsetMoves :=
  let 'Fr g m := f in
  let image l := option_map (Apply m) (Of moves (Of g l)) in
  Q4 (image V1) (image V2) (image V3) (image V4).

(** A number for each; that of the signs comes first. *)
Definition MoveCode (move : option Coord3) : Z :=
  match move with None => 0 | Some o => Z.land (172 + OffsetRank o) 511 end.

Definition MovesCode (moves : OffsetMoves) : Z :=
  match moves with
    Q4 a b c d =>
      ((MoveCode a * 512 + MoveCode b) * 512 + MoveCode c) * 512 + MoveCode d
  end.

Definition Code (signs : Quad Sign) (moves : OffsetMoves) : Z :=
  2 ^ 36 * Rank signs + MovesCode moves.

Section Case.
  Variable case : C15Case.
  Let corners := CaseCorners case.

  Definition Symmetries : list Frame := Frames corners corners.

  Definition IsFirst (symmetries : list Frame) (signs : Quad Sign)
    (moves : OffsetMoves) : bool :=
    let code := Code signs moves in
    forallb (fun f => code <=? Code (SignsIn (OrderIn f) signs) (MovesIn f moves))
      symmetries.

  Definition FirstSigns (symmetries : list Frame) (signs : Quad Sign) : bool :=
    forallb (fun f => Rank signs <=? Rank (SignsIn (OrderIn f) signs)) symmetries.

  (** The corner, if any, towards which a corner has moved. *)
  Definition TargetsCorner (from to : Label) (move : option Coord3) : bool :=
    match move with
    | None => false
    | Some o => Coord3Equal (Translate (Of corners from) o) (Of corners to)
    end.

  (** As [ConsistentWith]. *)
  Definition C15ConsistentWith (moves : OffsetMoves) (before : Quad Sign) : bool :=
    forallb (fun i => forallb (fun j =>
      if TargetsCorner i j (Of moves i)
      then if Opposite (Of before i) (Of before j)
           then negb (TargetsCorner j i (Of moves j)) else false
      else true) AllLabels) AllLabels.

  Definition C15Consistent (signs : Quad Sign) (moves : OffsetMoves) : bool :=
    existsb (C15ConsistentWith moves)
      match signs with
        Q4 a b c d =>
          Product4 (SignsBefore a) (SignsBefore b) (SignsBefore c) (SignsBefore d)
      end.

  Definition OffsetMovesOf (s : Sign) (p : Coord3) : list (option Coord3) :=
    match s with OnSurface => map Some (OffsetsAround p) | _ => [None] end.

  Definition C15MovesFor (symmetries : list Frame) (signs : Quad Sign)
    : list OffsetMoves :=
    match signs, corners with
      Q4 a b c d, Q4 p q r s =>
        filter (fun moves =>
          if IsFirst symmetries signs moves then C15Consistent signs moves else false)
          (Product4 (OffsetMovesOf a p) (OffsetMovesOf b q)
             (OffsetMovesOf c r) (OffsetMovesOf d s))
    end.

  (** ** The check *)

  Variables (bounds : AngleBounds) (th : C15Thresholds).

  Definition LabelThreshold (a b : Label) : Z :=
    th (MetalOf (Of corners a)) (MetalOf (Of corners b)).

  Definition C15Ranges (order : list (Label * Label)) : list CutRange :=
    map (fun '(a, e) =>
      CR (a, e) (LabelThreshold a e) (256 - LabelThreshold e a)) order.

  Definition C15Segment (moves : OffsetMoves) (ranges : list CutRange) (v : Symbol)
    : Segment :=
    match v with
    | CornerOf l =>
        let p := Of corners l in
        match Of moves l with
        | None => Fixed (Scale 256 p)
        | Some o =>
            SegmentBetween (Along p o 0)
              (Along p o (th (MetalOf p) (MetalOf (Translate p o))))
        end
    | CutOf a b =>
        let p := Of corners a in
        let e := Difference p (Of corners b) in
        match RangeOf (a, b) ranges with
        | None => Fixed (Scale 256 p)
        | Some (lo, hi) => SegmentBetween (Along p e lo) (Along p e hi)
        end
    end.

  Definition HasPlus (signs : Quad Sign) : bool :=
    match signs with
    | Q4 Plus _ _ _ | Q4 _ Plus _ _ | Q4 _ _ Plus _ | Q4 _ _ _ Plus => true
    | _ => false
    end.

  (** All that one sign pattern can become, in every order of its cuts. *)
  Definition CheckC15Signs (symmetries : list Frame) (signs : Quad Sign) : bool :=
    if FirstSigns symmetries signs then
      if HasPlus signs then
        let all_moves := C15MovesFor symmetries signs in
        forallb (fun order =>
          let ranges := Tightened (C15Ranges order) in
          let tets := OrderedTets signs order in
          forallb (fun moves =>
            forallb (fun t => CheckRanged bounds (C15Segment moves) t Halvings ranges)
              tets) all_moves) (Orders (CutsBetween signs))
      else true
    else true.

  (** Of those with some numbers of corners on the surface. *)
  Definition CheckC15Case (take : Z -> bool) : bool :=
    let symmetries := Symmetries in
    forallb (CheckC15Signs symmetries)
      (filter (fun signs => take (SurfaceCorners signs)) AllSigns).
End Case.
