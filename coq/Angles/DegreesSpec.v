(** * Dihedral angles in degrees

    The one place where real numbers appear: the angle of two faces as anyone
    would define it, so that the integer bounds can be read in degrees. *)

From Coq Require Import Reals.
From Certet Require Import Angles.Definitions.
Open Scope R_scope.

(** The angle between the faces [abc] and [abd] of a tetrahedron, in degrees. *)
Definition DihedralDegrees (a b c d : Coord3) : R :=
  acos (IZR (Dot (Normal a b c) (Normal a b d))
        / (sqrt (IZR (Dot (Normal a b c) (Normal a b c)))
           * sqrt (IZR (Dot (Normal a b d) (Normal a b d)))))
  * 180 / PI.

(** Right-handed, and every dihedral angle between two numbers of degrees. *)
Definition WithinDegrees (least greatest : R) (t : UnstructuredTet Coord3)
  : Prop :=
  match t with
    UT _ a b c d =>
      (0 < SixVolume a b c d)%Z /\
      forall p q r s, In (p, q, r, s) (DihedralEdges t) ->
        least <= DihedralDegrees p q r s <= greatest
  end.
