(** * Pieces of any mesh

    As in [Embedding/PiecesSpec.v], of whatever tetrahedra are made within each
    structured tetrahedron. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Embedding.PiecesSpec Mesh.Method.

Section Mesh.
  Variable mesh : Mesh.

  (** A tetrahedron of the mesh. *)
  Definition TetOf (t : UnstructuredTet MeshVertex) : Prop :=
    exists tid, InLattice tid /\ In t (TetsWithin mesh tid).

  (** [t] is made in a structured tetrahedron that has [c] as a corner. *)
  Definition MadeAround (c : Coord3) (t : UnstructuredTet MeshVertex) : Prop :=
    exists tid, InLattice tid /\ In c (Corners tid) /\ In t (TetsWithin mesh tid).

  (** A lattice point that is inside the mesh. *)
  Definition InsideMesh (c : Coord3) : Prop := SignIn mesh (Corner c) = Plus.

  (** Two tetrahedra are joined by faces just as + corners of their structured
      tetrahedra are joined by edges of the lattice. *)
  Definition PiecesAreThoseOf (inside : Coord3 -> Prop) : Prop :=
    forall p q t u, InsideMesh p -> InsideMesh q ->
      MadeAround p t -> MadeAround q u ->
      Joined TetOf ShareFace t u <-> Joined inside Adjacent p q.
End Mesh.
