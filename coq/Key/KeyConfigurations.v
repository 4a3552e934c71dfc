(** * What warping can leave of one tetrahedron, in every order of the cuts

    As [Angles.Cases.Configurations] has it, and besides, for every sign pattern,
    the cuts in every order.  Cuts in order lie in order, so that the ranges of
    any two cut each other; where that is not enough, the range of one is halved,
    and halves in which the cuts cannot be in order are left out. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Forms.BoxForm Angles.Forms.Checker
  Angles.Cases.Configurations Key.KeyTet Key.Orders.
Open Scope Z_scope.

(** ** The stencils on symbols *)

(** The cuts of the edges from a + to a - corner. *)
Definition CutsBetween (signs : Quad Sign) : list (Label * Label) :=
  filter (fun '(a, e) =>
    match Of signs a, Of signs e with Plus, Minus => true | _, _ => false end)
    (list_prod AllLabels AllLabels).

Definition SamePair (x y : Label * Label) : bool :=
  LabelEqual (fst x) (fst y) && LabelEqual (snd x) (snd y).

Definition SymbolKey (key : Label -> Label -> Z) (u v : Symbol) : Z :=
  match u, v with CornerOf a, CornerOf e => key a e | _, _ => 0 end.

Definition KeyedTets (signs : Quad Sign) (key : Label -> Label -> Z)
  : list (UnstructuredTet Symbol) :=
  GetKeyTets Symbol (SymbolSign signs) SymbolIntersection (SymbolKey key)
    (CornerOf V1) (CornerOf V2) (CornerOf V3) (CornerOf V4).

Definition OrderedTets (signs : Quad Sign) (order : list (Label * Label))
  : list (UnstructuredTet Symbol) :=
  KeyedTets signs (fun a e => RankIn SamePair order (a, e)).

(** ** Ranges of cuts that lie in order *)

(** A cut, and where it can be: in 256ths from its + end. *)
Inductive CutRange := CR : Label * Label -> Z -> Z -> CutRange.

Definition CutIn (x : CutRange) : Label * Label := match x with CR c _ _ => c end.

(** In the order of their keys. *)
Definition InitialRanges (r : Ranges) (order : list (Label * Label)) : list CutRange :=
  map (fun '(a, e) =>
    CR (a, e) (CutFrom r (LabelKind a e)) (CutTo r (LabelKind a e))) order.

(** None begins before one that it follows, *)
Fixpoint RaiseStarts (least : Z) (ranges : list CutRange) : list CutRange :=
  match ranges with
  | [] => []
  | CR c lo hi :: rest =>
      let lo' := Z.max least lo in CR c lo' hi :: RaiseStarts lo' rest
  end.

(** nor ends after one that follows. *)
Fixpoint LowerEnds (ranges : list CutRange) : list CutRange :=
  match ranges with
  | [] => []
  | CR c lo hi :: rest =>
      match LowerEnds rest with
      | [] => [CR c lo hi]
      | CR c' lo' hi' :: rest' => CR c lo (Z.min hi hi') :: CR c' lo' hi' :: rest'
      end
  end.

Definition Tightened (ranges : list CutRange) : list CutRange :=
  LowerEnds match ranges with
            | [] => []
            | CR _ lo _ :: _ => RaiseStarts lo ranges
            end.

Definition IsEmpty (ranges : list CutRange) : bool :=
  existsb (fun x => match x with CR _ lo hi => hi <? lo end) ranges.

Definition Narrowed (c : Label * Label) (narrow : Z -> Z -> Z * Z)
  (ranges : list CutRange) : list CutRange :=
  map (fun x => match x with CR d lo hi =>
    if SamePair c d then let '(lo', hi') := narrow lo hi in CR d lo' hi' else x end)
    ranges.

Definition RangeOf (c : Label * Label) (ranges : list CutRange) : option (Z * Z) :=
  match find (fun x => SamePair c (CutIn x)) ranges with
  | Some (CR _ lo hi) => Some (lo, hi)
  | None => None
  end.

(** The cut of the tetrahedron with the widest range. *)
Definition Widest (ranges : list CutRange) (t : UnstructuredTet Symbol)
  : option (Label * Label * Z * Z) :=
  fold_left (fun best v =>
    match v with
    | CornerOf _ => best
    | CutOf a e =>
        match RangeOf (a, e) ranges with
        | None => best
        | Some (lo, hi) =>
            match best with
            | Some (_, lo', hi') =>
                if hi' - lo' <? hi - lo then Some ((a, e), lo, hi) else best
            | None => Some ((a, e), lo, hi)
            end
        end
    end) (TetCorners t) None.

(** ** A quicker check

    As [CheckTet], but that no segment is halved where it fails, and that the first
    edge that fails is the last that is looked at: ranges will be halved instead. *)

Section Quick.
  Variable bounds : AngleBounds.

  Definition QuickBound (k : CotSquared) (volume extreme edge : Z)
    (a b c d : Segment) : bool :=
    if CheckRanges k volume extreme edge then true else CheckFull k a b c d.

  Definition QuickEdge (volume : Z) (e : Segment * Segment * Segment * Segment) : bool :=
    let '(a, b, c, d) := e in
    match bounds with
      AB acute obtuse =>
        let nd := NormalsDegrees a b c d in
        let n := NormalsForm a b c d in
        let most := Upper nd n in
        let least := Lower nd n in
        let edge := Lower (EdgeDegrees a b c d) (EdgeForm a b c d) in
        if (if most <=? 0 then true
            else QuickBound acute volume most edge a b c d)
        then (if 0 <=? least then true
              else QuickBound obtuse volume least edge a b c d)
        else false
    end.

  Fixpoint QuickEdges (volume : Z) (es : list (Segment * Segment * Segment * Segment))
    : bool :=
    match es with
    | [] => true
    | e :: rest => if QuickEdge volume e then QuickEdges volume rest else false
    end.

  Definition QuickTet (t : UnstructuredTet Segment) : bool :=
    match t with
      UT _ a b c d =>
        let volume := Lower (VolumeDegrees a b c d) (VolumeForm a b c d) in
        if 0 <? volume then QuickEdges volume (DihedralEdges t) else false
    end.
End Quick.

(** ** The check *)

Definition RangedSegment (r : Ranges) (moves : Quad (option Direction))
  (ranges : list CutRange) (v : Symbol) : Segment :=
  match v with
  | CornerOf _ => SymbolSegment r moves v
  | CutOf a b =>
      match RangeOf (a, b) ranges with
      | None => SymbolSegment r moves v
      | Some (lo, hi) =>
          let p := Of Canonical a in
          let e := Difference p (Of Canonical b) in
          SegmentBetween (Along p e lo) (Along p e hi)
      end
  end.

Section Check.
  Variable bounds : AngleBounds.
  (** Where vertices can be while cuts are in such ranges. *)
  Variable segment : list CutRange -> Symbol -> Segment.
  Variable t : UnstructuredTet Symbol.

  Fixpoint CheckRanged (halvings : nat) (ranges : list CutRange) : bool :=
    if IsEmpty ranges then true
    else
      match halvings, Widest ranges t with
      | S n, Some (c, lo, hi) =>
          if QuickTet bounds (MapTet (segment ranges) t) then true
          else
            let middle := (lo + hi) / 2 in
            if CheckRanged n (Tightened (Narrowed c (fun lo hi => (lo, middle)) ranges))
            then CheckRanged n (Tightened (Narrowed c (fun lo hi => (middle, hi)) ranges))
            else false
      | _, _ => CheckTet bounds (MapTet (segment ranges) t)
      end.
End Check.

Definition Halvings : nat := 8.

(** All that one sign pattern can become, in every order of its cuts, stays within
    bounds. *)
Definition CheckOrders (bounds : AngleBounds) (r : Ranges) (signs : Quad Sign) : bool :=
  if match signs with Q4 Plus _ _ _ | Q4 _ Plus _ _ | Q4 _ _ Plus _ | Q4 _ _ _ Plus => true
     | _ => false end
  then
    let all_moves := MovesFor signs in
    forallb (fun order =>
      let ranges := Tightened (InitialRanges r order) in
      let tets := OrderedTets signs order in
      forallb (fun moves =>
        forallb (fun t => CheckRanged bounds (RangedSegment r moves) t Halvings ranges)
          tets)
        all_moves) (Orders (CutsBetween signs))
  else true.

Definition CheckOrderedRepresentatives (bounds : AngleBounds) (r : Ranges)
  (take : Z -> bool) : bool :=
  forallb (CheckOrders bounds r)
    (filter (fun signs => take (SurfaceCorners signs)) Representatives).
