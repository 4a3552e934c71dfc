(** * What is certified of every mesh

    One definition for each part of [CertifiedMesh]. *)

From Coq Require Import Reals.
From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.DegreesSpec Range.RangeSpec Mesh.Method.
Open Scope Z_scope.

Section Mesh.
  Variable mesh : Mesh.

  (** The tetrahedra within a structured one, at their positions in steps. *)
  Definition PlacedWithin (tid : StructuredTetId) : list (UnstructuredTet Coord3) :=
    map (MapTet (PositionIn mesh)) (TetsWithin mesh tid).

  (** Every tetrahedron is right-handed, and none is flat. *)
  Definition TetsPositive : Prop :=
    forall tid t, In t (PlacedWithin tid) -> Positive t.

  (** All dihedral angles are between so many hundredths of a degree. *)
  Definition AnglesBetween (least greatest : Z) : Prop :=
    forall tid t p q r s,
      In t (PlacedWithin tid) -> In (p, q, r, s) (DihedralEdges t) ->
      (IZR least / 100 <= DihedralDegrees p q r s <= IZR greatest / 100)%R.

  (** Neighbours conform: a face of the lattice with a corner inside is divided
      into the same triangles from both sides, and each of these belongs to one
      tetrahedron of either side. *)
  Definition FacesConform : Prop :=
    forall tid i a b c,
      let face := FaceOf tid i in
      let here := TetsWithin mesh tid in
      let there := TetsWithin mesh (NeighborOf tid i) in
      LiesIn face a -> LiesIn face b -> LiesIn face c ->
      ((exists f, In f face /\ SignIn mesh (Corner f) = Plus) ->
       AmongTriangles here a b c <-> AmongTriangles there a b c) /\
      (forall t u, In t here -> In u here ->
         HasTriangle t a b c -> HasTriangle u a b c -> t = u).

  (** The boundary is on the surface: a triangle that no other tetrahedron has
      as well, within the same structured one or a neighbour of it, has its
      three vertices there: cuts, corners that are on the surface of themselves,
      or that were warped to a cut. *)
  Definition BoundaryIsSurface : Prop :=
    forall tid t a b c, In t (TetsWithin mesh tid) -> HasTriangle t a b c ->
      (SignIn mesh a = OnSurface /\ SignIn mesh b = OnSurface /\
       SignIn mesh c = OnSurface) \/
      (exists u, u <> t /\ HasTriangle u a b c /\
         (In u (TetsWithin mesh tid) \/
          exists i, In u (TetsWithin mesh (NeighborOf tid i)))).

  (** ** Nothing overflows *)

  (** Positions on the edges of a lattice point, where a vertex is warped to, an
      edge is cut, or bisection looks: in 32 bits. *)
  Definition PositionsFit (v : Coord3) : Prop :=
    forall d low half k, 0 <= low -> 0 <= half -> low + half <= Steps ->
      let u := Translate v (Offset d) in
      Computes 32 (WarpedFormula (Along k v) low (Along k (Offset d)))
        (Along k (WarpedPosition v (Moves d low))) /\
      Computes 32 (CutFormula (Along k v) (Along k u) low)
        (Along k (PointOnEdge v u low)) /\
      Computes 32 (MiddleFormula (Along k v) (Along k u) low half)
        (Along k (PointOnEdge v u (low + half))).

  (** What warping compares: steps in 32 bits, squares of distances in 64. *)
  Definition ComparisonsFit (th : Thresholds) : Prop :=
    forall k t, 0 <= t <= Steps ->
      let 'TH long short := th in
      Computes 32
        (ThresholdFormula (match k with Long => long | Short => short end))
        (ThresholdSteps th k) /\
      Computes 32 (OtherEndFormula t) (Steps - t) /\
      Computes 64 (DistanceFormula (LengthSquared k) t)
        (LengthSquared k * (t * t)).

  (** A volume, in both ways in which it is computed: in 64 bits. *)
  Definition VolumeFits (t : UnstructuredTet Coord3) : Prop :=
    match t with
      UT _ a b c d =>
        Computes 64 (SixVolumeFormula a b c d) (SixVolume a b c d) /\
        Computes 64 (DeterminantFormula a b c d) (SixVolume a b c d)
    end.

  (** All of these, wherever the lattice may lie. *)
  Definition NothingOverflows (th : Thresholds) : Prop :=
    ComparisonsFit th /\
    forall anchor case, Bounded AnchorLimit anchor ->
      (forall v, In v (Corners (STId anchor case)) ->
         Bounded LatticeLimit v /\ PositionsFit v) /\
      (forall t, In t (PlacedWithin (STId anchor case)) -> VolumeFits t).
End Mesh.
