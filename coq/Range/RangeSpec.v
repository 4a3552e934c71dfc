(** * Machine integers suffice: what is meant

    The production library computes in integers of 32 and of 64 bits.  Here are
    the formulas that it computes, as it writes them, one coordinate at a time;
    that a formula fits means that not only its value but every intermediate
    value lies in its type, so that nothing overflows. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling.
Open Scope Z_scope.

(** ** Formulas *)

(** A number at hand, or a sum, a difference, a product of formulas. *)
Inductive Formula :=
| Number : Z -> Formula
| Sum : Formula -> Formula -> Formula
| Less : Formula -> Formula -> Formula
| Product : Formula -> Formula -> Formula.

Fixpoint Value (f : Formula) : Z :=
  match f with
  | Number n => n
  | Sum a b => Value a + Value b
  | Less a b => Value a - Value b
  | Product a b => Value a * Value b
  end.

(** A signed integer of so many bits, in two's complement. *)
Definition InType (bits n : Z) : Prop :=
  - 2 ^ (bits - 1) <= n <= 2 ^ (bits - 1) - 1.

Fixpoint Fits (bits : Z) (f : Formula) : Prop :=
  InType bits (Value f) /\
  match f with
  | Number _ => True
  | Sum a b | Less a b | Product a b => Fits bits a /\ Fits bits b
  end.

(** The formula fits, and computes what the certified functions say. *)
Definition Computes (bits : Z) (f : Formula) (answer : Z) : Prop :=
  Fits bits f /\ Value f = answer.

(** ** The range *)

(** Lattice points in use have coordinates of at most [LatticeLimit]; a lattice
    that reaches no farther than [AnchorLimit] has no others.  Edges of a
    tetrahedron to be measured are at most [WidthLimit] steps along an axis. *)
Definition LatticeLimit : Z := 32000.
Definition AnchorLimit : Z := LatticeLimit - 8.
Definition WidthLimit : Z := 2 ^ 19.

Inductive Axis := AxisX | AxisY | AxisZ.

Definition Along (k : Axis) (v : Coord3) : Z :=
  match v, k with
  | C3 x _ _, AxisX => x
  | C3 _ y _, AxisY => y
  | C3 _ _ z, AxisZ => z
  end.

(** Every coordinate is at most [limit] in absolute value. *)
Definition Bounded (limit : Z) (v : Coord3) : Prop :=
  forall k, - limit <= Along k v <= limit.

(** ** What a tiling must be for it *)

(** No two of these points are more than so many units apart along an axis, *)
Definition NoWider (width : Z) (points : list Coord3) : Prop :=
  forall p q, In p points -> In q points -> Bounded width (Difference p q).

(** no tetrahedron of the tiling is wider, *)
Definition TilingNoWider (width : Z) (T : Tiling) : Prop :=
  forall id, NoWider width (VerticesOf T id).

(** and none reaches farther from where it stands. *)
Definition TilingReaches (reach : Z) (T : Tiling) : Prop :=
  forall (id : Identifier T) i,
    Bounded reach (Difference (AnchorOf id) (VertexOf id i)).

Section Placement.
  Variables (before : SignField) (warping : Coord3 -> Warping) (cut : CutField).
  Variable corners : list Coord3.

  (** A vertex that is made of these corners: one of them, or the cut between a
      + and a - one. *)
  Definition OfCorners (m : MeshVertex) : Prop :=
    match m with
    | Corner v => In v corners
    | Cut p q =>
        In p corners /\ In q corners /\
        PlacedSign before warping (Corner p) = Plus /\
        PlacedSign before warping (Corner q) = Minus
    end.

  (** A corner moves by half of its edge, at most; and cuts lie on edges. *)
  Definition Moderate : Prop :=
    (forall v d t, In v corners -> warping v = Moves d t -> 0 <= 2 * t <= Steps) /\
    (forall p q, OfCorners (Cut p q) -> 0 <= cut p q <= Steps).
End Placement.

(** ** What the library computes *)

(** The first coordinate past a lattice that begins at [low] and has [cells]
    indices along the axis; it is computed once, at the door:
    low + 2 cells + 1. *)
Definition DoorFormula (low cells : Z) : Formula :=
  Sum (Sum (Number low) (Product (Number 2) (Number cells))) (Number 1).

(** A lattice point of grid 0 (even) or 1 (odd), [shift] indices away from
    index [i]: low + 2 (i + shift) + grid. *)
Definition LatticePointFormula (low i shift grid : Z) : Formula :=
  Sum (Sum (Number low) (Product (Number 2) (Sum (Number i) (Number shift))))
      (Number grid).

(** A point moved [t] steps along an edge whose offset is [e]: Steps v + t e. *)
Definition WarpedFormula (v t e : Z) : Formula :=
  Sum (Product (Number Steps) (Number v)) (Product (Number t) (Number e)).

(** The cut of an edge, Steps plus + t (minus - plus); and what bisection looks
    at, where the step [t] is low + half. *)
Definition CutFormula (plus minus t : Z) : Formula :=
  Sum (Product (Number Steps) (Number plus))
      (Product (Number t) (Less (Number minus) (Number plus))).
Definition MiddleFormula (plus minus low half : Z) : Formula :=
  Sum (Product (Number Steps) (Number plus))
      (Product (Sum (Number low) (Number half))
               (Less (Number minus) (Number plus))).

(** A cut seen from the other end, a threshold in steps, and the square of a
    distance. *)
Definition OtherEndFormula (t : Z) : Formula := Less (Number Steps) (Number t).
Definition ThresholdFormula (alpha : Z) : Formula :=
  Product (Number alpha) (Number 256).
Definition DistanceFormula (length_squared t : Z) : Formula :=
  Product (Product (Number length_squared) (Number t)) (Number t).

(** Six times a volume, as the engine decides orientation: with x, y and z of
    an edge from [a], xb (yc zd - zc yd) - yb (xc zd - zc xd)
    + zb (xc yd - yc xd); *)
Definition SixVolumeFormula (a b c d : Coord3) : Formula :=
  let x p := Less (Number (Along AxisX p)) (Number (Along AxisX a)) in
  let y p := Less (Number (Along AxisY p)) (Number (Along AxisY a)) in
  let z p := Less (Number (Along AxisZ p)) (Number (Along AxisZ a)) in
  Sum
    (Less
      (Product (x b) (Less (Product (y c) (z d)) (Product (z c) (y d))))
      (Product (y b) (Less (Product (x c) (z d)) (Product (z c) (x d)))))
    (Product (z b) (Less (Product (x c) (y d)) (Product (y c) (x d)))).

(** and as it is measured: xb (yc zd - zc yd) + yb (zc xd - xc zd)
    + zb (xc yd - yc xd). *)
Definition DeterminantFormula (a b c d : Coord3) : Formula :=
  let x p := Less (Number (Along AxisX p)) (Number (Along AxisX a)) in
  let y p := Less (Number (Along AxisY p)) (Number (Along AxisY a)) in
  let z p := Less (Number (Along AxisZ p)) (Number (Along AxisZ a)) in
  Sum
    (Sum
      (Product (x b) (Less (Product (y c) (z d)) (Product (z c) (y d))))
      (Product (y b) (Less (Product (z c) (x d)) (Product (x c) (z d)))))
    (Product (z b) (Less (Product (x c) (y d)) (Product (y c) (x d)))).
