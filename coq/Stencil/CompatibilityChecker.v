(** * Deciding compatibility of a stencil set

    One boolean function for each definition of [CompatibilitySpec], on symbols,
    and over all sign assignments.  That a positive answer can be relied upon is
    proved in [CompatibilityCheckerProof]. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Stencil.Symbol.
Open Scope bool_scope.

(** ** Barycentric coordinates *)

Definition IsBelow (c a b : BCoord) : bool :=
  match c, a, b with
  | Zero, Zero, (Interior | One) | Zero, Interior, (Interior | One) => true
  | _, _, _ => false
  end.

Definition IsAbove (c a b : BCoord) : bool :=
  match c, a, b with
  | One, Zero, (Interior | One) | One, Interior, (Interior | One) => true
  | _, _, _ => false
  end.

Definition IsBelowSymm (c a b : BCoord) := IsBelow c a b || IsBelow c b a.
Definition IsAboveSymm (c a b : BCoord) := IsAbove c a b || IsAbove c b a.

(** The point [c] is outside the interior of the segment [a b]. *)
Definition PointAside (c a b : BCoord) : bool :=
  IsBelowSymm c a b || IsAboveSymm c a b.

(** The segments [a b] and [c d] have disjoint interiors. *)
Definition SegmentsApart (a b c d : BCoord) : bool :=
  (IsBelowSymm a c d && IsBelowSymm b c d)
  || (IsBelowSymm c a b && IsBelowSymm d a b).

(** The coordinates in the shared face of a symbol that lies there. *)
Definition FaceCoordinates (s : Symbol) : option (BCoord * BCoord * BCoord) :=
  match s with
  | Base F1 => Some (One, Zero, Zero)
  | Base F2 => Some (Zero, One, Zero)
  | Base F3 => Some (Zero, Zero, One)
  | CutOf F1 F2 | CutOf F2 F1 => Some (Interior, Interior, Zero)
  | CutOf F1 F3 | CutOf F3 F1 => Some (Interior, Zero, Interior)
  | CutOf F2 F3 | CutOf F3 F2 => Some (Zero, Interior, Interior)
  | _ => None
  end.

Definition InFace (l : Label) : bool :=
  match l with F1 | F2 | F3 => true | P | Q => false end.

(** The symbol is off the shared face, on the side of [apex]. *)
Definition IsOff (apex : Label) (s : Symbol) : bool :=
  match s with
  | Base l => SameLabel l apex
  | CutOf a b =>
      (SameLabel a apex && InFace b) || (InFace a && SameLabel b apex)
  end.

(** ** Two edges *)

Definition IsSpecial (v u1 u2 : Symbol) (side : Label) : bool :=
  SameSymbol v u1 || SameSymbol v u2 || IsOff side v.

Definition IsAsideInFace (v u1 u2 : Symbol) : bool :=
  match FaceCoordinates u1, FaceCoordinates u2, FaceCoordinates v with
  | Some (a1, a2, a3), Some (b1, b2, b3), Some (c1, c2, c3) =>
      PointAside c1 a1 b1 || PointAside c2 a2 b2 || PointAside c3 a3 b3
  | _, _, _ => false
  end.

Definition IsNotIn (v u1 u2 : Symbol) (side other : Label) : bool :=
  IsSpecial v u1 u2 side || IsOff other u1 || IsOff other u2
  || IsAsideInFace v u1 u2.

Definition AreApartInFace (p1 p2 q1 q2 : Symbol) : bool :=
  match FaceCoordinates p1, FaceCoordinates p2,
        FaceCoordinates q1, FaceCoordinates q2 with
  | Some (a1, a2, a3), Some (b1, b2, b3),
    Some (c1, c2, c3), Some (d1, d2, d3) =>
      SegmentsApart a1 b1 c1 d1 || SegmentsApart a2 b2 c2 d2
      || SegmentsApart a3 b3 c3 d3
  | _, _, _, _ => false
  end.

Definition CheckTwoEdges (p1 p2 q1 q2 : Symbol) : bool :=
  (IsSpecial p1 q1 q2 P && IsNotIn p2 q1 q2 P Q)
  || (IsSpecial p2 q1 q2 P && IsNotIn p1 q1 q2 P Q)
  || (IsSpecial q1 p1 p2 Q && IsNotIn q2 p1 p2 Q P)
  || (IsSpecial q2 p1 p2 Q && IsNotIn q1 p1 p2 Q P)
  || AreApartInFace p1 p2 q1 q2.

(** ** All edges of two stencils, for all signs, in all arrangements *)

Definition CheckTwoTets (t1 t2 : UnstructuredTet Symbol) : bool :=
  forallb (fun '((p1, p2), (q1, q2)) => CheckTwoEdges p1 p2 q1 q2)
    (list_prod (Edges Symbol t1) (Edges Symbol t2)).

Section Check.
  Variable T : StencilSet.

  (** The stencils on symbols, for an assignment of signs to labels. *)
  Definition SymbolicTets (sign : Label -> Sign) (a b c d : Label)
    : list (UnstructuredTet Symbol) :=
    T Symbol (SymbolSign sign) SymbolIntersection
      (Base a) (Base b) (Base c) (Base d).

  Definition CheckArrangement (arrangement : Arrangement) : bool :=
    match arrangement with Arrange a b c d a' b' c' d' =>
      ForAllSignAssignments (fun sign =>
        let other_side := SymbolicTets sign a' b' c' d' in
        forallb (fun t1 => forallb (CheckTwoTets t1) other_side)
          (SymbolicTets sign a b c d))
    end.

  Definition CheckCompatibility : bool :=
    forallb CheckArrangement Arrangements.
End Check.
