(** * Machine integers suffice: what is meant

    The production library computes in integers of 32 and of 64 bits.  Here are
    the formulas that it computes, as it writes them, one coordinate at a time;
    that a formula fits means that not only its value but every intermediate
    value lies in its type, so that nothing overflows. *)

From Coq Require Import ZArith.
From Certet Require Import Lattice.Coord3 Lattice.Direction.
From Certet Require Import Warp.Cut Warp.Warp.
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

Coercion Number : Z >-> Formula.

Declare Scope formula_scope.
Delimit Scope formula_scope with formula.
Infix "+" := Sum : formula_scope.
Infix "-" := Less : formula_scope.
Infix "*" := Product : formula_scope.
Bind Scope formula_scope with Formula.

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

(** ** What the library computes *)

Section Formulas.
  Open Scope formula_scope.

  (** The first coordinate past a lattice that begins at [low] and has [cells]
      indices along the axis; it is computed once, at the door. *)
  Definition DoorFormula (low cells : Z) : Formula := low + 2%Z * cells + 1%Z.

  (** A lattice point of grid 0 (even) or 1 (odd), [shift] indices away from
      index [i]. *)
  Definition LatticePointFormula (low i shift grid : Z) : Formula :=
    low + 2%Z * (i + shift) + grid.

  (** A point moved [t] steps along an edge whose offset is [e]. *)
  Definition WarpedFormula (v t e : Z) : Formula := Steps * v + t * e.

  (** The cut of an edge; and what bisection looks at, where the step is a sum. *)
  Definition CutFormula (plus minus t : Z) : Formula :=
    Steps * plus + t * (minus - plus).
  Definition MiddleFormula (plus minus low half : Z) : Formula :=
    Steps * plus + (low + half) * (minus - plus).

  (** A cut seen from the other end, a threshold in steps, and the square of a
      distance. *)
  Definition OtherEndFormula (t : Z) : Formula := Steps - t.
  Definition ThresholdFormula (alpha : Z) : Formula := alpha * 256%Z.
  Definition DistanceFormula (length_squared t : Z) : Formula :=
    length_squared * t * t.

  (** Six times a volume, as the engine decides orientation, *)
  Definition SixVolumeFormula (a b c d : Coord3) : Formula :=
    let x p := Along AxisX p - Along AxisX a in
    let y p := Along AxisY p - Along AxisY a in
    let z p := Along AxisZ p - Along AxisZ a in
    x b * (y c * z d - z c * y d) - y b * (x c * z d - z c * x d)
    + z b * (x c * y d - y c * x d).

  (** and as it is measured. *)
  Definition DeterminantFormula (a b c d : Coord3) : Formula :=
    let x p := Along AxisX p - Along AxisX a in
    let y p := Along AxisY p - Along AxisY a in
    let z p := Along AxisZ p - Along AxisZ a in
    x b * (y c * z d - z c * y d) + y b * (z c * x d - x c * z d)
    + z b * (x c * y d - y c * x d).
End Formulas.
