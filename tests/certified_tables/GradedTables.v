(** * Tables of graded interiors *)

From Coq Require Import ZArith String List Bool.
From Certet Require Import Certificate.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet.
From CertetTables Require Import Table TableRules StencilTables.
Import ListNotations.
Open Scope Z_scope.

(** ** Graded interiors

    A flag by its axes and sides, and the tetrahedra that flags name, from the
    centre of the flag's cell, in half sides. *)

Definition GradedKinds : list GradedKind :=
  [BccTet; EdgeHalfTet; FaceHalfTet; QuarterTet; PyramidTet].
Definition AxisOrders : list AxisOrder := [XYZ; XZY; YXZ; YZX; ZXY; ZYX].

(** Of each order three sides, that of the face changing first. *)
Definition FlagsOfCell : list Flag :=
  flat_map (fun o => map (fun n => MakeFlag 0 Origin o (Z.odd n) (Z.odd (n / 2)) (Z.odd (n / 4)))
                       (Upto 8))
    AxisOrders.

(** Along which axes lie the face, the edge's place in it, and the edge. *)
Definition AxesOf (o : AxisOrder) : list Z :=
  let '(C3 x y z) := Arrange o 0 1 2 in
  map (fun n => PlaceOf Z.eqb n [x; y; z]) (Upto 3).

Definition FlagEntry (x : Flag) : Table :=
  let '(MakeFlag _ _ o s t u) := x in
  Row [Numbers (AxesOf o); Row (map Truth [s; t; u])].

Definition GradedTetEntry (kind : GradedKind) (x : Flag) : Table :=
  let from_centre v := Translate v (Scale (-1) (PointSeen x 0 0 0)) in
  let '(UT _ a b c d) := GetGradedTet (GTId kind x) in
  Row (map (fun v => Point (from_centre v)) [a; b; c; d]).

Definition IsSameFlag (x y : Flag) : bool :=
  match x, y with
    MakeFlag _ c _ s t u, MakeFlag _ d _ s' t' u' =>
      Coord3Equal c d && Bool.eqb s s' && Bool.eqb t t' && Bool.eqb u u'
  end.

(** Whether a flag is the name of its tetrahedron. *)
Definition IsName (kind : GradedKind) (x : Flag) : bool := IsSameFlag (NamingFlag kind x) x.

Definition OfFlags (entry : GradedKind -> Flag -> Table) (kinds : list GradedKind) : Table :=
  Row (map (fun kind => Row (map (entry kind) FlagsOfCell)) kinds).
