(** * Pieces of the mesh are pieces of the samples

    With the paper's stencils: what [AroundProof] says of whatever joins within. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Embedding.AroundProof Embedding.WholeProof.
Open Scope Z_scope.

(** ** What a warp may keep *)

Section Kept.
  Variables (sign : SignField) (warping : Coord3 -> Warping).

  (** No point is inside two tetrahedra; *)
  Definition NoneOverlap (place : MeshVertex -> Coord3) : Prop :=
    forall tid tid' t t', InLattice tid -> InLattice tid' ->
      In t (PlacedNames sign warping tid) -> In t' (PlacedNames sign warping tid') ->
      Overlap (MapTet place t) (MapTet place t') -> tid = tid' /\ t = t'.

  (** the pieces by faces are those of the samples by edges; *)
  Definition SamePieces : Prop :=
    forall p q t u, PlusAfter sign warping p -> PlusAfter sign warping q ->
      MadeAt sign warping p t -> MadeAt sign warping q u ->
      Joined (InMesh sign warping) ShareFace t u <->
      Joined (PlusBefore sign) Adjacent p q.

  (** none is lost; *)
  Definition NoneLost : Prop :=
    forall p, PlusBefore sign p -> (exists tid, InLattice tid /\ In p (Corners tid)) ->
      exists q t, PlusAfter sign warping q /\ MadeAt sign warping q t /\
        Joined (PlusBefore sign) Adjacent p q.

  (** those of the outside are the same; *)
  Definition SameOutside : Prop :=
    forall p q, ~ PlusBefore sign p -> ~ PlusBefore sign q ->
      Joined (fun v => ~ PlusAfter sign warping v) Adjacent p q <->
      Joined (fun v => ~ PlusBefore sign v) Adjacent p q.

  (** and none of these is new. *)
  Definition NoCavity : Prop :=
    forall p, ~ PlusAfter sign warping p ->
      exists q, ~ PlusBefore sign q /\
        Joined (fun v => ~ PlusAfter sign warping v) Adjacent p q.
End Kept.

(** ** Pieces *)

Theorem MeshPieces before warping p q t u :
  NoWall before warping ->
  PlusAfter before warping p -> PlusAfter before warping q ->
  MadeAt before warping p t -> MadeAt before warping q u ->
  Joined (InMesh before warping) ShareFace t u <->
  Joined (PlusAfter before warping) Adjacent p q.
Proof. intros walls. exact (PiecesByEdges _ _ (PlacedJoins before warping) walls p q t u). Qed.

Theorem PiecesKept before warping p q t u :
  AllLeave Adjacent (PlusBefore before) (PlusAfter before warping) ->
  NoWall before warping ->
  PlusAfter before warping p -> PlusAfter before warping q ->
  MadeAt before warping p t -> MadeAt before warping q u ->
  Joined (InMesh before warping) ShareFace t u <->
  Joined (PlusBefore before) Adjacent p q.
Proof.
  intros leaves walls.
  exact (PiecesOfSamples _ _ _ (PlacedJoins before warping) leaves p q t u walls).
Qed.

Theorem NoPieceLost before warping p :
  AllLeave Adjacent (PlusBefore before) (PlusAfter before warping) ->
  PlusBefore before p -> (exists tid, InLattice tid /\ In p (Corners tid)) ->
  exists q t, PlusAfter before warping q /\ MadeAt before warping q t /\
    Joined (PlusBefore before) Adjacent p q.
Proof. exact (fun leaves => NoSampleLost _ _ _ (PlacedJoins before warping) leaves p). Qed.
