(** * Stencils whose diagonals follow an order of the cuts

    The 81 sign patterns of the paper, with diagonals that depend on an order of
    the cuts instead of on the edges alone.  The order is told by a key for each
    cut: the lesser key comes first.

    Two + corners and a - corner span a quadrilateral with their two cuts, and
    its diagonal ends at the cut that comes first: a matter of the face alone.
    In a pattern of two + and two - corners the cuts form a quadrilateral that
    lies in no face of the lattice.  If on the two sides of it different +
    corners have the first cut, those two cuts are joined; if the same + corner
    has it on both sides, the later of its two cuts is joined to the cut across
    from it.

    Cuts that share a - corner are compared, and so are, in this last case, two
    cuts of one + corner; no others.  With the order of the Parity Rule these are
    the paper's stencils, in its order of vertices and tetrahedra: see
    [ParityIsAnOrder]. *)

From Coq Require Import ZArith List.
From Certet Require Import Lattice.StructuredTet Stencil.UnstructuredTet.
Import ListNotations.
Open Scope Z_scope.

(** Any stencil, made right-handed where its corners are taken in an odd order. *)
Definition Mirrored (h : Handedness) : Handedness :=
  match h with RightHanded => LeftHanded | LeftHanded => RightHanded end.

Section KeyTet.
  Variable Vertex : Type.

  Definition Handed (h : Handedness) (t : UnstructuredTet Vertex)
    : UnstructuredTet Vertex :=
    match h, t with
    | RightHanded, _ => t
    | LeftHanded, UT _ a b c d => UT _ a b d c
    end.

  Variable GetSign : Vertex -> Sign.
  Variable GetIntersection : Vertex -> Vertex -> Vertex.

  (** The key of the cut of an edge, from its + to its - end. *)
  Variable GetKey : Vertex -> Vertex -> Z.

  Local Notation cut := (GetIntersection).

  (** The cut of the edge from [a] to [e] comes before that from [b] to [f]. *)
  Definition Before (a e b f : Vertex) : bool := GetKey a e <? GetKey b f.

  (** ** Two + corners, one -, one on the surface

      [(a, b, e, z)] in an even order if right-handed. *)

  (** The cut of [a] comes first. *)
  Definition PyramidInOrder (h : Handedness) (a b e z : Vertex) :=
    map (Handed (Mirrored h))
      [UT _ b a (cut a e) z;
       UT _ b (cut a e) (cut b e) z].

  Definition Pyramid (h : Handedness) (a b e z : Vertex) :=
    if Before a e b e then PyramidInOrder h a b e z
    else PyramidInOrder (Mirrored h) b a e z.

  (** ** Three + corners, one - *)

  (** The cut of [a] comes first, that of [c] last. *)
  Definition PrismInOrder (h : Handedness) (a b c e : Vertex) :=
    map (Handed h)
      [UT _ c b (cut a e) a;
       UT _ c b (cut b e) (cut a e);
       UT _ c (cut b e) (cut c e) (cut a e)].

  Definition Prism (h : Handedness) (a b c e : Vertex) :=
    if Before a e b e then
      if Before b e c e then PrismInOrder h a b c e
      else if Before a e c e then PrismInOrder (Mirrored h) a c b e
      else PrismInOrder h c a b e
    else
      if Before a e c e then PrismInOrder (Mirrored h) b a c e
      else if Before b e c e then PrismInOrder h b c a e
      else PrismInOrder (Mirrored h) c b a e.

  (** ** Two + corners [a] and [b], two - corners [e] and [f] *)

  (** Towards [e] the cut of [b] comes first, towards [f] that of [a]. *)
  Definition WedgeAcross (h : Handedness) (a b e f : Vertex) :=
    map (Handed h)
      [UT _ a b (cut b e) (cut a f);
       UT _ a (cut b e) (cut a e) (cut a f);
       UT _ b (cut b e) (cut a f) (cut b f)].

  (** The cuts of [b] come first towards both, and of these that to [f]. *)
  Definition WedgeBeside (h : Handedness) (a b e f : Vertex) :=
    map (Handed h)
      [UT _ a b (cut b e) (cut b f);
       UT _ a (cut b e) (cut a f) (cut b f);
       UT _ a (cut b e) (cut a e) (cut a f)].

  (** The cuts of [b] come first towards both. *)
  Definition WedgeTowards (h : Handedness) (a b e f : Vertex) :=
    if Before b f b e then WedgeBeside h a b e f
    else WedgeBeside (Mirrored h) a b f e.

  Definition Wedge (h : Handedness) (a b e f : Vertex) :=
    if Before a e b e then
      if Before a f b f then WedgeTowards (Mirrored h) b a e f
      else WedgeAcross (Mirrored h) a b f e
    else
      if Before a f b f then WedgeAcross h a b e f
      else WedgeTowards h a b e f.

  (** ** The table *)

  Variables v1 v2 v3 v4 : Vertex.

  (** Where two + corners share a - corner; elsewhere the paper's stencils have
      no diagonal. *)
  Definition GetKeyTets : list (UnstructuredTet Vertex) :=
    match GetSign v1, GetSign v2, GetSign v3, GetSign v4 with
    | Plus, Plus, Plus, Minus => Prism RightHanded v1 v2 v3 v4
    | Plus, Plus, Minus, Plus => Prism LeftHanded v1 v2 v4 v3
    | Plus, Minus, Plus, Plus => Prism RightHanded v1 v3 v4 v2
    | Minus, Plus, Plus, Plus => Prism LeftHanded v2 v3 v4 v1

    | Plus, Plus, OnSurface, Minus => Pyramid LeftHanded v1 v2 v4 v3
    | Plus, Plus, Minus, OnSurface => Pyramid RightHanded v1 v2 v3 v4
    | Plus, OnSurface, Plus, Minus => Pyramid RightHanded v1 v3 v4 v2
    | Plus, OnSurface, Minus, Plus => Pyramid LeftHanded v1 v4 v3 v2
    | Plus, Minus, Plus, OnSurface => Pyramid LeftHanded v1 v3 v2 v4
    | Plus, Minus, OnSurface, Plus => Pyramid RightHanded v1 v4 v2 v3
    | OnSurface, Plus, Plus, Minus => Pyramid LeftHanded v2 v3 v4 v1
    | OnSurface, Plus, Minus, Plus => Pyramid RightHanded v2 v4 v3 v1
    | Minus, Plus, Plus, OnSurface => Pyramid RightHanded v2 v3 v1 v4
    | Minus, Plus, OnSurface, Plus => Pyramid LeftHanded v2 v4 v1 v3
    | OnSurface, Minus, Plus, Plus => Pyramid LeftHanded v3 v4 v2 v1
    | Minus, OnSurface, Plus, Plus => Pyramid RightHanded v3 v4 v1 v2

    | Plus, Plus, Minus, Minus => Wedge RightHanded v1 v2 v3 v4
    | Plus, Minus, Plus, Minus => Wedge LeftHanded v1 v3 v2 v4
    | Plus, Minus, Minus, Plus => Wedge RightHanded v1 v4 v2 v3
    | Minus, Plus, Plus, Minus => Wedge RightHanded v2 v3 v1 v4
    | Minus, Plus, Minus, Plus => Wedge LeftHanded v2 v4 v1 v3
    | Minus, Minus, Plus, Plus => Wedge RightHanded v3 v4 v1 v2

    | _, _, _, _ => GetUnstructuredTets Vertex GetSign GetIntersection v1 v2 v3 v4
    end.
End KeyTet.
