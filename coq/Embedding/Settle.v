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
       a long direction e at t steps, then for each short neighbour w = v + d with
       d . e > 0 that is 0, in direction -e by t' steps, t becomes
       min (t, Steps / 2 - t' - k).  The product's k is 1 if v and w were both -
       and 0 otherwise ([LevelGap]), which leaves flat walls flat; with 1 always
       ([StrictGap]) no two vertices come level.
    6. Cuts that remain between + and - are kept alpha away from both ends
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

(** ** The rule *)

Section Settle.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField) (gap : Gap).

  (** The sign of now. *)
  Definition SignAmong (zeros : Zeros) (v : Coord3) : Sign :=
    WarpedSign (sign v) (PlaceIn zeros v).

  Definition LinkAmong (zeros : Zeros) (v : Coord3) : Link Sign :=
    Gather (fun d => SignAmong zeros (Translate v (Offset d))).

  (** A move by [t] in the long direction [e], not to cross the neighbour's in
      direction [d]. *)
  Definition ShortOf (zeros : Zeros) (v : Coord3) (e : Direction) (t : Z)
    (d : Direction) : Z :=
    let w := Translate v (Offset d) in
    match DirectionKind d, PlaceIn zeros w with
    | Short, Moves e' t' =>
        if (0 <? Dot (Offset d) (Offset e))
           && Coord3Equal (Translate (Offset e) (Offset e')) (C3 0 0 0)
        then Z.min t (Steps / 2 - t' - gap (sign v) (sign w)) else t
    | _, _ => t
    end.

  Definition Shortened (zeros : Zeros) (v : Coord3) (e : Direction) (t : Z) : Z :=
    match DirectionKind e with
    | Long => fold_left (ShortOf zeros v e) AllDirections t
    | Short => t
    end.

  (** One vertex has its turn. *)
  Definition SettleOne (zeros : Zeros) (v : Coord3) : Zeros :=
    match WarpVertex th sign cut v with
    | Stays => zeros
    | Moves e t =>
        if IsDisk (LinkAmong zeros v)
        then PositiveMap.add (PointKey v) (Moves e (Shortened zeros v e t)) zeros
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
