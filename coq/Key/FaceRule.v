(** * What lies on a face of the lattice, from the face alone

    The triangles that a face with a + corner is divided into: a function of the
    signs of its corners and the keys of its cuts. *)

From Coq Require Import ZArith List.
From Certet Require Import Stencil.UnstructuredTet Key.KeyTet.
Import ListNotations.

Section FaceRule.
  Variable Vertex : Type.
  Variable GetSign : Vertex -> Sign.
  Variable GetIntersection : Vertex -> Vertex -> Vertex.
  Variable GetKey : Vertex -> Vertex -> Z.

  Local Notation cut := (GetIntersection).

  Definition Triangle : Type := Vertex * Vertex * Vertex.

  (** Two + corners and a - corner: the diagonal ends at the cut that comes
      first. *)
  Definition Halves (a b e : Vertex) : list Triangle :=
    if Before Vertex GetKey a e b e
    then [(a, b, cut a e); (b, cut a e, cut b e)]
    else [(a, b, cut b e); (a, cut a e, cut b e)].

  Definition FaceTriangles (f1 f2 f3 : Vertex) : list Triangle :=
    match GetSign f1, GetSign f2, GetSign f3 with
    | Plus, Plus, Minus => Halves f1 f2 f3
    | Plus, Minus, Plus => Halves f1 f3 f2
    | Minus, Plus, Plus => Halves f2 f3 f1
    | Plus, OnSurface, Minus => [(f1, f2, cut f1 f3)]
    | Plus, Minus, OnSurface => [(f1, f3, cut f1 f2)]
    | OnSurface, Plus, Minus => [(f1, f2, cut f2 f3)]
    | Minus, Plus, OnSurface => [(f2, f3, cut f2 f1)]
    | OnSurface, Minus, Plus => [(f1, f3, cut f3 f2)]
    | Minus, OnSurface, Plus => [(f2, f3, cut f3 f1)]
    | Plus, Minus, Minus => [(f1, cut f1 f2, cut f1 f3)]
    | Minus, Plus, Minus => [(f2, cut f2 f1, cut f2 f3)]
    | Minus, Minus, Plus => [(f3, cut f3 f1, cut f3 f2)]
    | Minus, _, _ | _, Minus, _ | _, _, Minus => []
    | OnSurface, OnSurface, OnSurface => []
    | _, _, _ => [(f1, f2, f3)]
    end.

  (** [a b c] are the corners of a triangle of the list, in any order. *)
  Definition AmongFaceTriangles (triangles : list Triangle) (a b c : Vertex) : Prop :=
    exists x y z, In (x, y, z) triangles /\
      (In a [x; y; z] /\ In b [x; y; z] /\ In c [x; y; z]) /\
      (a <> b /\ b <> c /\ a <> c).
End FaceRule.

Arguments AmongFaceTriangles {Vertex}.
