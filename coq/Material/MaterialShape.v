(** * Whether a tetrahedron is well shaped, and which ones are at a point *)

From Certet Require Import Angles.Definitions.
Open Scope Z_scope.

(** ** The test *)

(** [AngleAtLeast] and [AngleAtMost], decided. *)
Definition IsAngleWithin (bounds : AngleBounds) (a b c d : Coord3) : bool :=
  match bounds with
    AB (CotSq num den) (CotSq num' den') =>
      let n := NormalsProduct a b c d in
      let scale := SixVolume a b c d ^ 2 * EdgeSquared a b in
      ((n <=? 0) || (den * n ^ 2 <=? num * scale)) &&
      ((0 <=? n) || (den' * n ^ 2 <=? num' * scale))
  end.

Definition IsWellShaped (bounds : AngleBounds) (t : UnstructuredTet Coord3)
  : bool :=
  match t with
    UT _ a b c d =>
      (0 <? SixVolume a b c d) &&
      forallb (fun e => let '(p, q, r, s) := e in IsAngleWithin bounds p q r s)
        (DihedralEdges t)
  end.

(** ** The structured tetrahedra around a lattice point *)

(** A corner's coordinates, seen from the reference point, are among these. *)
Definition CornerOffsets : list Z := [0; 1; 2; 3].

Definition Anchors (v : Coord3) : list Coord3 :=
  filter (fun anchor =>
    match anchor with C3 x y z => Z.even x && Z.even y && Z.even z end)
    (flat_map (fun x => flat_map (fun y =>
       map (fun z => Difference (C3 x y z) v) CornerOffsets) CornerOffsets) CornerOffsets).

Definition TetsAround (v : Coord3) : list StructuredTetId :=
  filter (fun tid => existsb (Coord3Equal v) (Corners tid))
    (flat_map (fun anchor => map (STId anchor) AllCases) (Anchors v)).
