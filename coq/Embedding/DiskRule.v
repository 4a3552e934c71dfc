(** * The rule of the strict disk

    A violated vertex becomes 0 when its link is a strict disk at that moment,
    and otherwise stays.  The link of a vertex are its 14 neighbours, a sphere of
    24 triangles; it is a strict disk if its + vertices are in one piece, and its
    others too, and no 0 vertex pinches the +: around each of these the + is one
    run, and no edge between two has + on both sides.  The vertices have their
    turns one after the other; those of one turn are not adjacent, so that they
    may be decided together. *)

From Certet Require Import Stuffing.Definitions.

(** ** The link *)

Definition SameDirection (d e : Direction) : bool :=
  Coord3Equal (Offset d) (Offset e).

(** The neighbours in directions [d] and [e] are neighbours of each other. *)
Definition NextInLink (d e : Direction) : bool :=
  existsb (fun f => Coord3Equal (Offset f) (Difference (Offset d) (Offset e)))
    AllDirections.

(** The part of the link that is joined to what has been reached, in so many
    steps. *)
Fixpoint Flood (steps : nat) (part : Direction -> bool) (reached : list Direction)
  : list Direction :=
  match steps with
  | O => reached
  | S fewer =>
      Flood fewer part
        (filter (fun d => part d &&
           existsb (fun e => SameDirection e d || NextInLink e d) reached)
           AllDirections)
  end.

(** It is not empty, and in one piece. *)
Definition OnePiece (part : Direction -> bool) : bool :=
  match filter part AllDirections with
  | [] => false
  | first :: _ =>
      let reached := Flood 13 part [first] in
      forallb (fun d => negb (part d) || existsb (SameDirection d) reached)
        AllDirections
  end.

Section Link.
  (** The signs of the neighbours. *)
  Variable now : Direction -> Sign.

  Definition IsInner (d : Direction) : bool :=
    match now d with Plus => true | _ => false end.
  Definition IsZero (d : Direction) : bool :=
    match now d with OnSurface => true | _ => false end.

  (** Around the edge to [d], those next to both its ends: at most one run of +,
      and something else. *)
  Definition GoodRing (d : Direction) : bool :=
    let ring := filter (NextInLink d) AllDirections in
    let changes := filter (fun '(e, f) =>
      NextInLink e f && IsInner e && negb (IsInner f)) (list_prod ring ring) in
    existsb (fun e => negb (IsInner e)) ring && (length changes <=? 2)%nat.

  (** The edge from [d] to [e] has no + on both sides. *)
  Definition NoWallBetween (d e : Direction) : bool :=
    forallb (fun f => forallb (fun g =>
      negb (IsInner f && NextInLink d f && NextInLink e f
            && IsInner g && NextInLink d g && NextInLink e g)
      || SameDirection f g) AllDirections) AllDirections.

  Definition StrictDisk : bool :=
    OnePiece IsInner && OnePiece (fun d => negb (IsInner d)) &&
    forallb (fun d => negb (IsZero d) ||
      GoodRing d && forallb (fun e =>
        negb (IsZero e && NextInLink d e) || NoWallBetween d e) AllDirections)
      AllDirections.
End Link.

(** ** The rule *)

Section Rule.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Variable turn : Coord3 -> nat.

  Definition Violated (v : Coord3) : bool :=
    match WarpVertex th sign cut v with Moves _ _ => true | Stays => false end.

  (** Who is 0 when so many turns are over. *)
  Fixpoint Settled (turns : nat) (v : Coord3) : bool :=
    match turns with
    | O => false
    | S fewer =>
        Settled fewer v ||
        (Nat.eqb (turn v) fewer && Violated v &&
         StrictDisk (fun d =>
           let u := Translate v (Offset d) in
           if Settled fewer u then OnSurface else sign u))
    end.

  (** The sign at that time. *)
  Definition SignNow (turns : nat) (v : Coord3) : Sign :=
    if Settled turns v then OnSurface else sign v.

  Definition DiskStays (turns : nat) (v : Coord3) : bool :=
    negb (Settled turns v).
End Rule.

(** ** The order *)

(** Adjacent vertices have different colours. *)
Definition Colour (v : Coord3) : nat :=
  match v with
    C3 x y z =>
      (if Z.even x then 0 else 2) + (if Z.even ((x + y + z) / 2) then 0 else 1)
  end.

Section Order.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).

  (** Those that are nearest to the surface come first, in four classes; of these
      the outer ones; of these the even ones. *)
  Definition Turn (v : Coord3) : nat :=
    match WarpVertex th sign cut v with
    | Stays => 0
    | Moves d t =>
        8 * Z.to_nat (4 * t / ThresholdSteps th (DirectionKind d))
        + match sign v with Minus => 0 | _ => 4 end + Colour v
    end.

  Definition Turns : nat := 32.

  (** The rule: who stays when all turns are over. *)
  Definition DiskRule : Coord3 -> bool := DiskStays th sign cut Turn Turns.
End Order.
