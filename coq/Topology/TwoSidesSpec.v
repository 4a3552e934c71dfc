(** * The mesh of the other side

    With + and - exchanged the same warp gives a mesh of what is outside.  A cut is
    then counted from its other end; by its name in the mesh of the inside the two
    can be compared. *)

From Certet Require Import Embedding.Definitions.
Open Scope Z_scope.

Definition Negate (s : Sign) : Sign :=
  match s with Plus => Minus | OnSurface => OnSurface | Minus => Plus end.

Definition OtherSigns (sign : SignField) : SignField := fun v => Negate (sign v).

Definition OtherCuts (cut : CutField) : CutField := fun a b => Steps - cut b a.

(** The name that a vertex of the other mesh has in this one. *)
Definition NameHere (v : MeshVertex) : MeshVertex :=
  match v with Corner c => Corner c | Cut a m => Cut m a end.

(** The tetrahedra of the other side, by these names. *)
Definition OtherNames (before : SignField) (warping : Coord3 -> Warping)
  (tid : StructuredTetId) : list (UnstructuredTet MeshVertex) :=
  map (MapTet NameHere) (PlacedNames (OtherSigns before) warping tid).
