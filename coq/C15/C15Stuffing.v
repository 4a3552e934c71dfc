(** * Stuffing C15 by key

    The mesher of C15 but for loops and files.  The key of a cut is how far it lies
    from its + end, in parts of its edge; of two cuts equally far the one whose edge
    leads further down comes first, then further to the front, then to the left.
    Cuts that share an end never have the same key.

    A vertex is warped as in the body-centred cubic lattice: one that a cut violates
    moves to the nearest such cut, by what its neighbours were before.  How near a
    cut violates depends on the metals of the vertex and of the edge's other end. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Key.KeyTet Key.KeyStuffing.
From Certet Require Import C15.Sites C15.C15Tet C15.TilingStuffing.
Open Scope Z_scope.

(** ** Keys *)

(** Offsets of edges have coordinates from -3 to 3. *)
Definition OffsetRank (o : Coord3) : Z :=
  match o with C3 x y z => x + 7 * y + 49 * z end.

Definition C15CutKey (cut : CutField) (plus minus : Coord3) : Z :=
  343 * cut plus minus + OffsetRank (Difference plus minus).

(** ** Warping *)

(** Alpha of an edge by the metal of the vertex and that of the other end, in
    256ths. *)
Definition C15Thresholds : Type := Metal -> Metal -> Z.

Definition C15KeyThresholds : C15Thresholds := fun own other =>
  match own, other with
  | Mg, Mg => 86 | Mg, Cu => 96 | Cu, Mg => 80 | Cu, Cu => 99
  end.

(** Of the edge from [a] to [b] at [a], in steps. *)
Definition EdgeThreshold (th : C15Thresholds) (a b : Coord3) : Z :=
  th (MetalOf a) (MetalOf b) * (Steps / 256).

(** What becomes of a vertex: it stays, or moves along the edge with this offset by
    a number of steps and lands on the surface. *)
Inductive C15Warping :=
| Unmoved : C15Warping
| Moved : Coord3 -> Z -> C15Warping.

Section Warp.
  Variable th : C15Thresholds.
  Variable sign : SignField.
  Variable cut : CutField.

  (** Steps from [v] to the cut of its edge to [v + o]. *)
  Definition C15CutFrom (v o : Coord3) : Z :=
    let u := Translate v o in
    match sign v with
    | Plus => cut v u
    | _ => Steps - cut u v
    end.

  Definition C15Violates (v o : Coord3) : bool :=
    let u := Translate v o in
    (Opposite (sign v) (sign u) && (C15CutFrom v o <? EdgeThreshold th v u))%bool.

  (** The square of the distance to a cut, in steps of a unit edge. *)
  Definition C15CutDistance (v o : Coord3) : Z :=
    JoinedSquared (MetalOf v) (MetalOf (Translate v o))
    * (C15CutFrom v o * C15CutFrom v o).

  Definition C15NearerOf (v : Coord3) (best : C15Warping) (o : Coord3) : C15Warping :=
    if C15Violates v o then
      match best with
      | Unmoved => Moved o (C15CutFrom v o)
      | Moved e _ =>
          if C15CutDistance v o <? C15CutDistance v e
          then Moved o (C15CutFrom v o) else best
      end
    else best.

  Definition C15WarpVertex (v : Coord3) : C15Warping :=
    fold_left (C15NearerOf v) (OffsetsAround v) Unmoved.
End Warp.

(** ** Signs and places after warping *)

Section Placement.
  Variable before : SignField.
  Variable warping : Coord3 -> C15Warping.
  Variable cut : CutField.

  Definition C15After (c : Coord3) : Sign :=
    match warping c with Unmoved => before c | Moved _ _ => OnSurface end.

  (** In steps. *)
  Definition C15Position (v : MeshVertex) : Coord3 :=
    match v with
    | Corner c =>
        match warping c with
        | Unmoved => Scale Steps c
        | Moved o t => Translate (Scale Steps c) (Scale t o)
        end
    | Cut plus minus => PointOnEdge plus minus (cut plus minus)
    end.

  (** The tetrahedra put in place of one, by the names of their vertices, *)
  Definition C15Names (tid : C15TetId) : list (UnstructuredTet MeshVertex) :=
    TilingNames C15Tiling (C15CutKey cut) C15After tid.

  (** and at their positions. *)
  Definition C15Tets (tid : C15TetId) : list (UnstructuredTet Coord3) :=
    map (MapTet C15Position) (C15Names tid).

  (** The tetrahedron of the lattice itself, warped. *)
  Definition C15WarpedTet (tid : C15TetId) : UnstructuredTet Coord3 :=
    let at_ i := C15Position (Corner (C15Vertex tid i)) in
    UT _ (at_ First) (at_ Second) (at_ Third) (at_ Fourth).
End Placement.
