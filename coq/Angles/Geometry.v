(** * Tetrahedra in integer coordinates: volume and dihedral angles

    Nothing here is rounded.  The dihedral angle of [a b c d] at its edge [ab]
    is the angle between the normals of the faces [abc] and [abd]; with
    [n1 = Normal a b c] and [n2 = Normal a b d] its cotangent is

      n1 . n2 / (6 volume * |ab|),

    so that a bound on the angle is an inequality between integers once the
    square of the bound's cotangent is known to lie on the right side of a
    fraction. *)

From Certet Require Import Stencil.Definitions.
Open Scope Z_scope.

Definition Dot (u v : Coord3) : Z :=
  match u, v with
    C3 ux uy uz, C3 vx vy vz => ux * vx + uy * vy + uz * vz
  end.

Definition Cross (u v : Coord3) : Coord3 :=
  match u, v with
    C3 ux uy uz, C3 vx vy vz =>
      C3 (uy * vz - uz * vy) (uz * vx - ux * vz) (ux * vy - uy * vx)
  end.

(** The normal of triangle [abc], twice its area long. *)
Definition Normal (a b c : Coord3) : Coord3 :=
  Cross (Difference a b) (Difference a c).

(** Six times the volume of [abcd]; positive when [abcd] is right-handed. *)
Definition SixVolume (a b c d : Coord3) : Z :=
  Dot (Normal a b c) (Difference a d).

(** The square of the distance from [a] to [b]. *)
Definition EdgeSquared (a b : Coord3) : Z :=
  Dot (Difference a b) (Difference a b).

(** The product of the normals that meet at edge [ab] of [abcd]. *)
Definition NormalsProduct (a b c d : Coord3) : Z :=
  Dot (Normal a b c) (Normal a b d).

(** [CotSq n d] is the fraction n/d, for the square of a cotangent. *)
Inductive CotSquared := CotSq : Z -> Z -> CotSquared.

(** The angle at [ab] is at least the acute angle whose cotangent's square is
    the given fraction. *)
Definition AngleAtLeast (acute : CotSquared) (a b c d : Coord3) : Prop :=
  match acute with
    CotSq num den =>
      NormalsProduct a b c d <= 0 \/
      den * NormalsProduct a b c d ^ 2
        <= num * (SixVolume a b c d ^ 2 * EdgeSquared a b)
  end.

(** The angle at [ab] is at most the obtuse angle whose cotangent's square is
    the given fraction. *)
Definition AngleAtMost (obtuse : CotSquared) (a b c d : Coord3) : Prop :=
  match obtuse with
    CotSq num den =>
      0 <= NormalsProduct a b c d \/
      den * NormalsProduct a b c d ^ 2
        <= num * (SixVolume a b c d ^ 2 * EdgeSquared a b)
  end.

(** The six edges of a tetrahedron: each entry names an edge first, then the
    two other vertices, in an even order. *)
Definition DihedralEdges {V : Type} (t : UnstructuredTet V)
  : list (V * V * V * V) :=
  match t with
    UT _ a b c d =>
      [(a, b, c, d); (a, c, d, b); (a, d, b, c);
       (b, c, a, d); (b, d, c, a); (c, d, a, b)]
  end.

(** A least and a greatest angle: [AB acute obtuse]. *)
Inductive AngleBounds := AB : CotSquared -> CotSquared -> AngleBounds.

(** Right-handed, and all six dihedral angles within the bounds. *)
Definition WellShaped (bounds : AngleBounds) (t : UnstructuredTet Coord3)
  : Prop :=
  match bounds, t with
    AB acute obtuse, UT _ a b c d =>
      0 < SixVolume a b c d /\
      forall p q r s, In (p, q, r, s) (DihedralEdges t) ->
        AngleAtLeast acute p q r s /\ AngleAtMost obtuse p q r s
  end.
