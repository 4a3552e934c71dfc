(** * When a mesh embeds

    Two tetrahedra of a mesh should meet exactly in the hull of the vertices
    they share: not at all, in a vertex, an edge, a face, or in all of
    themselves.  The points of a tetrahedron are the weighted means of its
    vertices.  Integer weights of one total do for every rational point, so
    that nothing is rounded here. *)

From Certet Require Import Angles.Definitions.
Open Scope Z_scope.

Definition SixVolumeOf (t : UnstructuredTet Coord3) : Z :=
  match t with UT _ a b c d => SixVolume a b c d end.

(** ** Points by weights *)

(** One weight for each vertex. *)
Definition Weights : Type := UnstructuredTet Z.

Definition NonNegative (w : Weights) : Prop :=
  match w with UT _ a b c d => 0 <= a /\ 0 <= b /\ 0 <= c /\ 0 <= d end.

Definition AllPositive (w : Weights) : Prop :=
  match w with UT _ a b c d => 0 < a /\ 0 < b /\ 0 < c /\ 0 < d end.

Definition Total (w : Weights) : Z :=
  match w with UT _ a b c d => a + b + c + d end.

(** The weighted sum of a quantity of the vertices. *)
Definition Weigh {V : Type} (g : V -> Z) (w : Weights) (t : UnstructuredTet V)
  : Z :=
  match w, t with
    UT _ a b c d, UT _ p q r s => a * g p + b * g q + c * g r + d * g s
  end.

(** [Total w] times the mean of the vertices. *)
Definition PointOf (w : Weights) (t : UnstructuredTet Coord3) : Coord3 :=
  match w, t with
    UT _ a b c d, UT _ p q r s =>
      Translate (Translate (Scale a p) (Scale b q))
                (Translate (Scale c r) (Scale d s))
  end.

(** Each vertex weighs the same in both tetrahedra, so only vertices of both
    weigh anything. *)
Definition SameWeights {V : Type} (w : Weights) (t : UnstructuredTet V)
  (w' : Weights) (t' : UnstructuredTet V) : Prop :=
  forall g : V -> Z, Weigh g w t = Weigh g w' t'.

(** With its vertices at [place], a point that [t] and [t'] have in common is a
    mean of vertices they have in common, and is so in one way. *)
Definition MeetInSharedVertices {V : Type} (place : V -> Coord3)
  (t t' : UnstructuredTet V) : Prop :=
  forall w w', NonNegative w -> NonNegative w' -> Total w = Total w' ->
    PointOf w (MapTet place t) = PointOf w' (MapTet place t') ->
    SameWeights w t w' t'.

(** A point inside both. *)
Definition Overlap (t t' : UnstructuredTet Coord3) : Prop :=
  exists w w', AllPositive w /\ AllPositive w' /\ Total w = Total w' /\
    PointOf w t = PointOf w' t'.

(** ** The lattice *)

(** The structured tetrahedron itself. *)
Definition LatticeTet (tid : StructuredTetId) : UnstructuredTet Coord3 :=
  match GetStructuredTet tid with ST v1 v2 v3 v4 _ _ _ _ => UT _ v1 v2 v3 v4 end.

Definition SameOctant (u v : Coord3) : Prop :=
  match u, v with
    C3 a b c, C3 x y z => 0 < a * x /\ 0 < b * y /\ 0 < c * z
  end.

(** No short edge is turned over along any axis. *)
Definition KeepsShortEdges (place : Coord3 -> Coord3) : Prop :=
  forall v d, DirectionKind d = Short ->
    SameOctant (Offset d)
      (Difference (place v) (place (Translate v (Offset d)))).

(** A placed structured tetrahedron is right-handed as the product orients it. *)
Definition KeepsHand (place : Coord3 -> Coord3) (tid : StructuredTetId) : Prop :=
  match tid, LatticeTet tid with
    STId _ case, UT _ a b c d =>
      match CaseHandedness case with
      | RightHanded => 0 < SixVolume (place a) (place b) (place c) (place d)
      | LeftHanded => 0 < SixVolume (place a) (place b) (place d) (place c)
      end
  end.

(** No vertex is moved by half a unit along any axis: alpha is at most 1/4 of a
    long edge and at most 1/2 of a short one. *)
Definition MovesLittle (th : Thresholds) : Prop :=
  match th with TH long short => long <= 64 /\ short <= 128 end.

(** Where the warp puts the lattice points, in steps. *)
Definition WarpedPlace (th : Thresholds) (sign : SignField) (cut : CutField)
  (c : Coord3) : Coord3 := MeshPosition th sign cut (Corner c).

(** Somewhere two different tetrahedra of one mesh overlap. *)
Definition SomeMeshFolds (th : Thresholds) : Prop :=
  exists sign cut tid tid' t t',
    CutsOnEdges sign cut /\ InLattice tid /\ InLattice tid' /\
    In t (StuffTet th sign cut tid) /\ In t' (StuffTet th sign cut tid') /\
    tid <> tid' /\
    Overlap (MapTet (MeshPosition th sign cut) t)
            (MapTet (MeshPosition th sign cut) t').

(** ** Any other warp *)

(** The vertices of the tetrahedra that [GetUnstructuredTets] puts in place of
    one structured tetrahedron, by name; [PlacedTets] are these at their
    positions. *)
Definition PlacedNames (before : SignField) (warping : Coord3 -> Warping)
  (tid : StructuredTetId) : list (UnstructuredTet MeshVertex) :=
  match tid, GetStructuredTet tid with
  | STId _ case, ST v1 v2 v3 v4 _ _ _ _ =>
      map (Orient (CaseHandedness case))
          (GetUnstructuredTets MeshVertex (PlacedSign before warping)
             MeshIntersection (Corner v1) (Corner v2) (Corner v3) (Corner v4))
  end.

(** Every cut that remains is strictly inside its edge. *)
Definition CutsInside (before : SignField) (warping : Coord3 -> Warping)
  (cut : CutField) : Prop :=
  forall v d, let u := Translate v (Offset d) in
    PlacedSign before warping (Corner v) = Plus ->
    PlacedSign before warping (Corner u) = Minus ->
    0 < cut v u < Steps.

(** No vertex moves farther than alpha of its edge. *)
Definition MovesAtMost (th : Thresholds) (warping : Coord3 -> Warping) : Prop :=
  forall v d t, warping v = Moves d t ->
    0 <= t <= ThresholdSteps th (DirectionKind d).

(** If the ends of a short edge move towards each other along parallel long
    edges, they move by so many steps together, at most. *)
Definition ApproachAtMost (limit : Z) (warping : Coord3 -> Warping) : Prop :=
  forall v d e e' t t',
    DirectionKind d = Short -> DirectionKind e = Long ->
    Translate (Offset e) (Offset e') = C3 0 0 0 ->
    0 < Dot (Offset d) (Offset e) ->
    warping v = Moves e t -> warping (Translate v (Offset d)) = Moves e' t' ->
    t + t' <= limit.

(** They do not cross, nor do they come side by side. *)
Definition Uncrossed : (Coord3 -> Warping) -> Prop :=
  ApproachAtMost (Steps / 2 - 1).

(** They may come side by side: this is what makes flat walls flat. *)
Definition UncrossedOrLevel : (Coord3 -> Warping) -> Prop :=
  ApproachAtMost (Steps / 2).
