(** * The strict disk by tables

    [StrictDisk] of [DiskRule] as it runs: what depends on the lattice alone is
    laid out once, what depends on the + of a link once for all its 0. *)

From Coq Require Import Arith.
From Certet Require Import Stencil.Definitions.
From Certet Require Import Embedding.DiskRule.

(** ** One thing for each of the fourteen neighbours *)

Inductive Link (A : Type) : Type :=
  L14 : A -> A -> A -> A -> A -> A -> A -> A -> A -> A -> A -> A -> A -> A ->
        Link A.
Arguments L14 {A}.

(** In the order of [AllDirections]. *)
Definition Gather {A : Type} (f : Direction -> A) : Link A :=
  L14 (f Dir_p00) (f Dir_m00) (f Dir_0p0) (f Dir_0m0) (f Dir_00p) (f Dir_00m)
      (f Dir_ppp) (f Dir_mmm) (f Dir_ppm) (f Dir_mmp)
      (f Dir_pmp) (f Dir_mpm) (f Dir_mpp) (f Dir_pmm).

Definition At {A : Type} (l : Link A) (d : Direction) : A :=
  match l with
    L14 p00 m00 q0p0 q0m0 q00p q00m ppp mmm ppm mmp pmp mpm mpp pmm =>
      match d with
      | Dir_p00 => p00 | Dir_m00 => m00
      | Dir_0p0 => q0p0 | Dir_0m0 => q0m0
      | Dir_00p => q00p | Dir_00m => q00m
      | Dir_ppp => ppp | Dir_mmm => mmm | Dir_ppm => ppm | Dir_mmp => mmp
      | Dir_pmp => pmp | Dir_mpm => mpm | Dir_mpp => mpp | Dir_pmm => pmm
      end
  end.

(** ** The lattice's own tables *)

(** Who is next to whom in a link: around a neighbour lies a ring of four or
    six. *)
Definition NeighborTable : Link (list Direction) :=
  Gather (fun d => filter (NextInLink d) AllDirections).

(** The edges of that ring, either way. *)
Definition RingTable : Link (list (Direction * Direction)) :=
  Gather (fun d => filter (fun '(e, f) => NextInLink e f)
    (list_prod (At NeighborTable d) (At NeighborTable d))).

(** The edges of the link, and what lies on both sides of each. *)
Definition WallTable : list ((Direction * Direction) * (Direction * Direction)) :=
  flat_map (fun d => flat_map (fun e =>
    let sides := filter (NextInLink e) (At NeighborTable d) in
    map (pair (d, e)) (filter (fun '(f, g) => negb (SameDirection f g))
      (list_prod sides sides)))
    (At NeighborTable d)) AllDirections.

(** ** One piece *)

Definition Spread (part reached : Link bool) : Link bool :=
  Gather (fun d =>
    At part d && (At reached d || existsb (At reached) (At NeighborTable d))).

Fixpoint SpreadFor (rounds : nat) (part reached : Link bool) : Link bool :=
  match rounds with
  | O => reached
  | S fewer => SpreadFor fewer part (Spread part reached)
  end.

Definition InOnePiece (part : Link bool) : bool :=
  match filter (At part) AllDirections with
  | [] => false
  | first :: _ =>
      let reached := SpreadFor 13 part (Gather (SameDirection first)) in
      forallb (fun d => negb (At part d) || At reached d) AllDirections
  end.

(** ** The disk *)

(** The + are in one piece, and the others too. *)
Definition TwoPieces (plus : Link bool) : bool :=
  InOnePiece plus && InOnePiece (Gather (fun d => negb (At plus d))).

(** Where no 0 may be: the ring is all +, or has more than one run of +. *)
Definition Pinched (plus : Link bool) (d : Direction) : bool :=
  negb (existsb (fun e => negb (At plus e)) (At NeighborTable d)
        && (length (filter (fun '(e, f) => At plus e && negb (At plus f))
              (At RingTable d)) <=? 2)%nat).

(** Edges that may not be from 0 to 0: with + on both sides. *)
Definition Walls (plus : Link bool) : list (Direction * Direction) :=
  map fst (filter (fun '(_, (f, g)) => At plus f && At plus g) WallTable).

Definition DiskOf (plus : Link bool) : Link bool -> bool :=
  if TwoPieces plus then
    let pinched := filter (Pinched plus) AllDirections in
    let walls := Walls plus in
    fun zero =>
      forallb (fun d => negb (At zero d)) pinched &&
      forallb (fun '(d, e) => negb (At zero d && At zero e)) walls
  else fun _ => false.

Definition IsDisk (link : Link Sign) : bool :=
  DiskOf (Gather (IsInner (At link))) (Gather (IsZero (At link))).
