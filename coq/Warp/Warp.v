(** * Warping: a vertex too close to the surface is moved onto it

    A vertex with a nonzero sign is violated when a cut on one of its 14 edges
    lies strictly nearer than alpha times the edge's length.  It moves to the
    nearest violating cut and its sign becomes 0.  The decision looks at the
    vertex and its neighbours as they were before any warping, so it is the
    same in whatever order the vertices are visited.  Of two violating cuts at
    the same distance the one whose direction comes first in [AllDirections]
    wins. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Warp.Cut.
Open Scope Z_scope.

(** [TH long short]: alpha of long and of short edges, in 256ths. *)
Inductive Thresholds := TH : Z -> Z -> Thresholds.

(** The widest angles; the lattice may fold where nothing is kept. *)
Definition AngleThresholds : Thresholds := TH 73 102.

(** The warped lattice stays an embedding. *)
Definition EmbeddingThresholds : Thresholds := TH 64 105.

(** No vertex is ever violated. *)
Definition NoWarpThresholds : Thresholds := TH 0 0.

(** A threshold in steps. *)
Definition ThresholdSteps (th : Thresholds) (k : EdgeKind) : Z :=
  match th, k with
  | TH long _, Long => long * (Steps / 256)
  | TH _ short, Short => short * (Steps / 256)
  end.

(** What becomes of a vertex: it stays, or it moves along an edge by a number
    of steps and lands on the surface. *)
Inductive Warping :=
| Stays : Warping
| Moves : Direction -> Z -> Warping.

Definition Opposite (a b : Sign) : bool :=
  match a, b with
  | Plus, Minus | Minus, Plus => true
  | _, _ => false
  end.

Section Warp.
  Variable th : Thresholds.
  (** The vertex's sign, its neighbours' signs, and for each edge to a
      neighbour of opposite sign the steps from the vertex to the cut. *)
  Variable sign : Sign.
  Variable neighbor_sign : Direction -> Sign.
  Variable cut : Direction -> Z.

  Definition Violates (d : Direction) : bool :=
    Opposite sign (neighbor_sign d)
    && (cut d <? ThresholdSteps th (DirectionKind d)).

  (** The square of the distance to a cut, in steps of a unit edge. *)
  Definition CutDistanceSquared (d : Direction) : Z :=
    LengthSquared (DirectionKind d) * (cut d * cut d).

  Definition NearerOf (best : Warping) (d : Direction) : Warping :=
    if Violates d then
      match best with
      | Stays => Moves d (cut d)
      | Moves e _ =>
          if CutDistanceSquared d <? CutDistanceSquared e
          then Moves d (cut d) else best
      end
    else best.

  Definition Warp : Warping := fold_left NearerOf AllDirections Stays.
End Warp.

(** The sign that a vertex has after warping. *)
Definition WarpedSign (sign : Sign) (w : Warping) : Sign :=
  match w with Stays => sign | Moves _ _ => OnSurface end.

(** The position, in steps, that lattice vertex [v] has after warping. *)
Definition WarpedPosition (v : Coord3) (w : Warping) : Coord3 :=
  match w with
  | Stays => Scale Steps v
  | Moves d t => Translate (Scale Steps v) (Scale t (Offset d))
  end.
