(** * The warp that keeps the shape, as it runs

    Of samples and cuts, and a list of lattice points, the warp of a whole mesh.
    The rule, in full:

    1. A sample that is exactly 0 counts as -, with the cut of each edge that
       ends there right at that end ([OpenSigns], [OpenCuts]).  Points outside
       the lattice are -.
    2. A vertex is violated if a cut on an edge to a neighbour of opposite sign
       is nearer than alpha of that edge; the nearest such cut is its target, of
       equally near ones the first in [AllDirections]; long edges are of squared
       length 4, short ones of 3 ([WarpVertex]).  Targets come from the samples
       and are never computed again.
    3. The violated vertices have their turns once each, in the order of [Turn]:
       first by floor(4 t / alpha) of the target, with alpha in steps of the
       target's edge; then those with sign - before those with sign +; then by
       [Colour]: even points before odd ones, and of either grid those first of
       which floor((x + y + z) / 2) is even.  Within a colour the order changes
       nothing ([ColourInAnyOrder] in [Certificate]).
    4. A vertex stays for good unless its link, with the signs of now, is a strict
       disk ([IsDisk]).  There is one sweep.
    5. Otherwise it becomes 0 at its target, or short of it: if the target lies in
       a long direction e at t steps, then a short neighbour w = v + d with
       d . e > 0 leaves it so much room and no more ([RoomBeside]): if w is 0, in
       direction -e by t' steps, Steps / 2 - k - t'; if w has its turn later and
       its target in direction -e at t' steps, floor ((Steps / 2 - k + t - t') / 2),
       so that of two who would pass each other either gives up one half.  The
       product's k is 1 if v and w were both - and 0 otherwise ([LevelGap]), which
       leaves flat walls flat; with 1 always ([StrictGap]) no two vertices come
       level.
    6. But it stays if that is nearer to where the surface is: if no cut violates
       it but its target, and to keep this one alpha away moves the cut by less
       than the vertex would fall short of it ([StaysRather]).
    7. Cuts that remain between + and - are kept alpha away from both ends
       ([ClampedCut]), and the stencils fill what is inside.

    All of it is integers. *)

From Coq Require Import FMapPositive.
From Certet Require Import Angles.Definitions.
From Certet Require Import Embedding.WarpOrClamp Embedding.DiskRule
  Embedding.DiskTables.
Open Scope Z_scope.

(** ** Samples that are neither + nor - *)

(** The inside is open: what lies on the surface is outside, *)
Definition OpenSigns (sample : SignField) : SignField :=
  fun v => match sample v with Plus => Plus | _ => Minus end.

(** and cut where it lies. *)
Definition OpenCuts (sample : SignField) (cut : CutField) : CutField :=
  fun plus minus =>
    match sample minus with OnSurface => Steps | _ => cut plus minus end.

(** ** Who is 0, and where *)

(** The bits of a number, each led by a one, and a zero at the end: nothing that
    follows can be mistaken for them. *)
Fixpoint Spelled (p rest : positive) : positive :=
  match p with
  | xI q => xI (xI (Spelled q rest))
  | xO q => xI (xO (Spelled q rest))
  | xH => xO rest
  end.

Definition PositiveOf (n : Z) : positive :=
  match n with Z0 => xH | Zpos p => xO p | Zneg p => xI p end.

(** A point's key: different points have different ones. *)
Definition PointKey (v : Coord3) : positive :=
  match v with
    C3 x y z =>
      Spelled (PositiveOf x) (Spelled (PositiveOf y) (PositiveOf z))
  end.

Definition Zeros : Type := PositiveMap.t Warping.

Definition NoZeros : Zeros := PositiveMap.empty Warping.

(** What has become of a vertex so far. *)
Definition PlaceIn (zeros : Zeros) (v : Coord3) : Warping :=
  match PositiveMap.find (PointKey v) zeros with Some w => w | None => Stays end.

(** ** How near two may come *)

(** What is left between two vertices that move towards each other, in steps, by
    their signs before. *)
Definition Gap : Type := Sign -> Sign -> Z.

Definition LevelGap : Gap :=
  fun s s' => match s, s' with Minus, Minus => 1 | _, _ => 0 end.

Definition StrictGap : Gap := fun _ _ => 1.

Section Room.
  Variables (sign : SignField) (gap : Gap).
  (** Where who is violated would go, and when. *)
  Variables (target : Coord3 -> Warping) (turn : Coord3 -> nat).

  Definition Towards (e e' : Direction) : bool :=
    Coord3Equal (Translate (Offset e) (Offset e')) (C3 0 0 0).

  (** How far two may move towards each other, together. *)
  Definition RoomFor (v w : Coord3) : Z := Steps / 2 - gap (sign v) (sign w).

  (** What the neighbour in direction [d] leaves of it to [v], whose target lies
      at [t] in the long direction [e]. *)
  Definition RoomBeside (zeros : Zeros) (v : Coord3) (e : Direction) (t : Z)
    (d : Direction) : Z :=
    let w := Translate v (Offset d) in
    match DirectionKind d, 0 <? Dot (Offset d) (Offset e) with
    | Short, true =>
        match PlaceIn zeros w, target w with
        | Moves e' t', _ => if Towards e e' then RoomFor v w - t' else t
        | Stays, Moves e' t' =>
            if Towards e e' && Nat.ltb (turn v) (turn w)
            then (RoomFor v w + t - t') / 2 else t
        | Stays, Stays => t
        end
    | _, _ => t
    end.

  Definition Shortened (zeros : Zeros) (v : Coord3) (e : Direction) (t : Z) : Z :=
    match DirectionKind e with
    | Long =>
        fold_left (fun reached d => Z.min reached (RoomBeside zeros v e t d))
          AllDirections t
    | Short => t
    end.
End Room.

(** A vertex that its target alone violates falls short of it by more than the
    cut is moved if it stays. *)
Definition StaysRather (th : Thresholds) (violates : Direction -> bool)
  (e : Direction) (t reached : Z) : bool :=
  (ThresholdSteps th (DirectionKind e) - t <? t - reached) &&
  forallb (fun d => negb (violates d) || SameDirection d e) AllDirections.

(** ** The rule *)

Section Settle.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField) (gap : Gap).

  (** The sign of now. *)
  Definition SignAmong (zeros : Zeros) (v : Coord3) : Sign :=
    WarpedSign (sign v) (PlaceIn zeros v).

  Definition LinkAmong (zeros : Zeros) (v : Coord3) : Link Sign :=
    Gather (fun d => SignAmong zeros (Translate v (Offset d))).

  (** The cut in direction [d] violates [v]. *)
  Definition ViolatesAt (v : Coord3) : Direction -> bool :=
    Violates th (sign v) (fun d => sign (Translate v (Offset d))) (CutFrom sign cut v).

  (** One vertex has its turn. *)
  Definition SettleOne (zeros : Zeros) (v : Coord3) : Zeros :=
    match WarpVertex th sign cut v with
    | Stays => zeros
    | Moves e t =>
        if IsDisk (LinkAmong zeros v) then
          let reached :=
            Shortened sign gap (WarpVertex th sign cut) (Turn th sign cut) zeros v e t in
          if StaysRather th (ViolatesAt v) e t reached then zeros
          else PositiveMap.add (PointKey v) (Moves e reached) zeros
        else zeros
    end.

  (** All of a list, in its order. *)
  Definition Settle (vs : list Coord3) : Zeros := fold_left SettleOne vs NoZeros.

  (** The order of the product: those of a list that are violated, by turns. *)
  Definition InTurn (vs : list Coord3) : list Coord3 :=
    let turned := map (fun v => (Turn th sign cut v, v))
                      (filter (Violated th sign cut) vs) in
    flat_map (fun n => map snd (filter (fun '(m, _) => Nat.eqb m n) turned))
      (seq 0 Turns).

  (** ** The mesh *)

  (** The tetrahedra in one structured tetrahedron, in steps, *)
  Definition SettledTets (zeros : Zeros) (tid : StructuredTetId)
    : list (UnstructuredTet Coord3) :=
    PlacedTets sign (PlaceIn zeros) (ClampedCut th cut) tid.

  (** and in many of them, when all of a list have had their turns. *)
  Definition SettledMesh (vs : list Coord3) (tids : list StructuredTetId)
    : list (UnstructuredTet Coord3) :=
    let zeros := Settle vs in flat_map (SettledTets zeros) tids.
End Settle.
