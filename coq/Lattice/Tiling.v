(** * Tilings of space by tetrahedra

    A tiling as data: which tetrahedra there are, their vertices, the neighbours
    across their faces, and which way round they are.  What must hold of it is
    said here once, for every place; of the lattice it is said in the paper's
    words in [PaperCertificate]. *)

From Certet Require Import Lattice.Definitions.

Record Tiling := MakeTiling {
  (** Names of the tetrahedra, *)
  Identifier : Type;
  (** where one stands, *)
  AnchorOf : Identifier -> Coord3;
  (** its vertices, *)
  VertexOf : Identifier -> Place -> Coord3;
  (** its neighbour across from a vertex, with the order that lines it up, *)
  NeighborAt : Identifier -> Place -> Identifier * VertexOrder;
  (** and whether it is right-handed. *)
  HandOf : Identifier -> Handedness
}.

Arguments AnchorOf {t}.
Arguments VertexOf {t}.
Arguments NeighborAt {t}.
Arguments HandOf {t}.

(** One of four, and the three places besides one. *)
Definition Pick {A : Type} (four : A * A * A * A) (i : Place) : A :=
  let '(a, b, c, d) := four in
  match i with First => a | Second => b | Third => c | Fourth => d end.

Definition Others (i : Place) : Place * Place * Place :=
  match i with
  | First => (Second, Third, Fourth)
  | Second => (First, Third, Fourth)
  | Third => (First, Second, Fourth)
  | Fourth => (First, Second, Third)
  end.

Section Tiling.
  Variable T : Tiling.

  Definition VerticesOf (id : Identifier T) : list Coord3 :=
    map (VertexOf id) [First; Second; Third; Fourth].

  (** The vertices of the neighbour across from place [i], lined up. *)
  Definition LinedUp (id : Identifier T) (i : Place) : Place -> Coord3 :=
    let '(nei, order) := NeighborAt id i in
    Pick (order (VertexOf nei First) (VertexOf nei Second)
                (VertexOf nei Third) (VertexOf nei Fourth)).

  (** They are the tetrahedron's own, except the one across. *)
  Definition TilingFacesCorrect : Prop :=
    forall (id : Identifier T) i j, LinedUp id i j = VertexOf id j <-> j <> i.

  (** The neighbour's neighbour across the same face is the tetrahedron itself,
      and the two orders undo each other. *)
  Definition TilingInvolution : Prop :=
    forall (id : Identifier T) i,
      let '(nei, order) := NeighborAt id i in
      exists j back_order,
        VertexOf nei j = LinedUp id i i /\
        NeighborAt nei j = (id, back_order) /\
        Undoes back_order order /\ Undoes order back_order.

  (** Neighbours are lined up already, or across the first two vertices the other
      way round. *)
  Definition OrdersKnown : Prop :=
    forall (id : Identifier T) i,
      let order := snd (NeighborAt id i) in
      order = Order1234 \/ (i = First \/ i = Second) /\ order = Order2143.

  (** The four vertices of each are four. *)
  Definition VerticesApart : Prop :=
    forall (id : Identifier T) i j, VertexOf id i = VertexOf id j -> i = j.
End Tiling.

(** The lattice is one. *)
Definition LatticeTiling : Tiling :=
  MakeTiling StructuredTetId
    (fun '(STId anchor _) => anchor)
    (fun tid => VertexAt (GetStructuredTet tid))
    (fun tid => NeighborAcross (GetStructuredTet tid))
    (fun '(STId _ case) => CaseHandedness case).
