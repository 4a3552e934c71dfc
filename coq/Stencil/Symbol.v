(** * Symbolic vertices of two tetrahedra that share a face

    Whatever the vertices of the paper are, the stencils on the two sides of a
    face only ever combine five of them.  A [Symbol] names one of the five, or
    a cut between two of them; [Interpret] turns it into the vertex meant.
    Symbols can be compared and enumerated, which vertices cannot. *)

From Certet Require Import Stencil.Definitions.

(** The three vertices of the shared face and the one on either side. *)
Inductive Label := F1 | F2 | F3 | P | Q.

Inductive Symbol :=
| Base : Label -> Symbol
| CutOf : Label -> Label -> Symbol.

Definition SameLabel (a b : Label) : bool :=
  match a, b with
  | F1, F1 | F2, F2 | F3, F3 | P, P | Q, Q => true
  | _, _ => false
  end.

Definition SameSymbol (s t : Symbol) : bool :=
  match s, t with
  | Base a, Base b => SameLabel a b
  | CutOf a b, CutOf c d => SameLabel a c && SameLabel b d
  | _, _ => false
  end.

Definition Member (s : Symbol) (symbols : list Symbol) : bool :=
  existsb (SameSymbol s) symbols.

(** ** The stencil functions' parameters, on symbols *)

(** A sign for each of the five. *)
Definition SignOf (s1 s2 s3 sp sq : Sign) (l : Label) : Sign :=
  match l with F1 => s1 | F2 => s2 | F3 => s3 | P => sp | Q => sq end.

Definition SymbolSign (sign : Label -> Sign) (s : Symbol) : Sign :=
  match s with Base l => sign l | CutOf _ _ => OnSurface end.

Definition SymbolIntersection (s t : Symbol) : Symbol :=
  match s, t with Base a, Base b => CutOf a b | _, _ => s end.

(** ** What symbols mean *)

Section Interpret.
  Variable Vertex : Type.
  Variable GetIntersection : Vertex -> Vertex -> Vertex.
  Variables f1 f2 f3 p q : Vertex.

  Definition Locate (l : Label) : Vertex :=
    match l with F1 => f1 | F2 => f2 | F3 => f3 | P => p | Q => q end.

  Definition Interpret (s : Symbol) : Vertex :=
    match s with
    | Base l => Locate l
    | CutOf a b => GetIntersection (Locate a) (Locate b)
    end.
End Interpret.

(** ** The six ways in which two tetrahedra share a face *)

Inductive Arrangement :=
  Arrange : Label -> Label -> Label -> Label ->
            Label -> Label -> Label -> Label -> Arrangement.

(** In the paper's order, see [CompatibilityOrders]. *)
Definition Arrangements : list Arrangement :=
  [Arrange P F1 F2 F3 Q F1 F2 F3;
   Arrange P F1 F2 F3 F1 Q F3 F2;
   Arrange F1 P F2 F3 Q F1 F3 F2;
   Arrange F1 P F2 F3 F1 Q F2 F3;
   Arrange F1 F2 P F3 F1 F2 Q F3;
   Arrange F1 F2 F3 P F1 F2 F3 Q].

(** ** Enumerating signs *)

Definition ForAllSigns (test : Sign -> bool) : bool :=
  test Plus && test OnSurface && test Minus.

(** [test] holds of all the 3^5 sign assignments. *)
Definition ForAllSignAssignments (test : (Label -> Sign) -> bool) : bool :=
  ForAllSigns (fun s1 => ForAllSigns (fun s2 => ForAllSigns (fun s3 =>
  ForAllSigns (fun sp => ForAllSigns (fun sq =>
    test (SignOf s1 s2 s3 sp sq)))))).
