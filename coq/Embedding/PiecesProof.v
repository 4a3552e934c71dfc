(** * Pieces of the mesh are pieces of the samples: proof

    Tetrahedra around + points that are joined by edges are joined by faces, see
    [AroundProof].  Conversely a common face has a + end in both structured
    tetrahedra, or is a wall. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Stuffing.MeshProof Embedding.EdgeRank
  Embedding.GreedyProof Embedding.MeshApartProof Embedding.LeavingProof
  Embedding.LinkProof Embedding.StarProof Embedding.AroundProof.
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

Section Mesh.
  Variables (before : SignField) (warping : Coord3 -> Warping).

  Let after c := PlacedSign before warping (Corner c).
  Let names := PlacedNames before warping.
  Let made := MadeAt before warping.
  Local Notation joined := (Joined (InMesh before warping) ShareFace).

  (** ** From faces to points *)

  Lemma CornersJoined tid p q : In p (Corners tid) -> In q (Corners tid) ->
    after p = Plus -> after q = Plus -> Joined (PlusAfter before warping) Adjacent p q.
  Proof.
    intros I J A B. destruct (SamePoint3 p q) as [<-|N].
    - constructor. exact A.
    - destruct (EdgeBetween tid p q I J N) as [d E].
      apply JoinedNext; [exact A|exists d; exact E|exact B].
  Qed.

  (** A vertex has an inner end, or is a corner on the surface. *)
  Lemma InnerEnd tid v : Belongs after (Corners tid) v ->
    (exists e, In e (Ends v) /\ after e = Plus) \/
    exists c, v = Corner c /\ after c = OnSurface.
  Proof.
    destruct v as [c|a m]; cbn [Belongs Ends In].
    - intros [_ N]. destruct (after c) eqn:A; [left|right|congruence]; eauto.
    - intros (_ & _ & A & _). eauto.
  Qed.

  Hypothesis Walls : NoWall before warping.

  Lemma FaceThenPoint tid tid' t u p q : InLattice tid -> InLattice tid' ->
    In t (names tid) -> In u (names tid') -> ShareFace t u ->
    In p (Corners tid) -> In q (Corners tid') -> after p = Plus -> after q = Plus ->
    Joined (PlusAfter before warping) Adjacent p q.
  Proof.
    intros E E' T U (x & y & z & H & K) I J A B.
    pose proof (proj1 (StuffedFollows before warping tid t E T)) as F.
    pose proof (proj1 (StuffedFollows before warping tid' u E' U)) as F'.
    fold after in F, F'.
    destruct H as ((Tx & Ty & Tz) & Xy & Yz & Xz), K as ((Ux & Uy & Uz) & _).
    assert (Inner : forall v e, In v (TetCorners t) -> In v (TetCorners u) ->
      In e (Ends v) -> after e = Plus -> Joined (PlusAfter before warping) Adjacent p q).
    { intros v e V V' Z P.
      pose proof (EndsBelong after _ v e (F v V) Z) as Q.
      pose proof (EndsBelong after _ v e (F' v V') Z) as Q'.
      apply (JoinedThen _ _ _ p e q); eapply CornersJoined; eassumption. }
    destruct (InnerEnd tid x (F x Tx)) as [(e & Z & P)|(a & -> & Sa)]; [eauto|].
    destruct (InnerEnd tid y (F y Ty)) as [(e & Z & P)|(b & -> & Sb)]; [eauto|].
    destruct (InnerEnd tid z (F z Tz)) as [(e & Z & P)|(c & -> & Sc)]; [eauto|].
    replace q with p; [constructor; exact A|].
    assert (Sub : forall corners r, Belongs after corners (Corner a) ->
      Belongs after corners (Corner b) -> Belongs after corners (Corner c) ->
      In r corners -> incl [a; b; c; r] corners).
    { intros corners r [Ia _] [Ib _] [Ic _] R v. cbn [In].
      intros [<-|[<-|[<-|[<-|[]]]]]; assumption. }
    apply (Walls a b c p q); try congruence.
    - intros v. cbn [In]. intros [<-|[<-|[<-|[]]]]; assumption.
    - exact A.
    - exact B.
    - exists tid. split; [exact E|]. apply Sub; auto.
    - exists tid'. split; [exact E'|]. apply Sub; auto.
  Qed.

  Lemma HasInnerCorner tid t : InLattice tid -> In t (names tid) ->
    exists c, In c (Corners tid) /\ after c = Plus.
  Proof.
    intros E T. pose proof (proj1 (StuffedFollows before warping tid t E T)) as F.
    unfold names in T. rewrite NamesAsStuffed in T. destruct (TetrahedraInside _ _ _ _ _ T) as [[v [V P]] _].
    rewrite <- SignAsStuffed in P. specialize (F v V).
    destruct v as [c|a m]; [|discriminate P]. exists c. destruct F. auto.
  Qed.

  Lemma FacesThenPoints t u : joined t u ->
    forall p q, after p = Plus -> after q = Plus -> made p t -> made q u ->
      Joined (PlusAfter before warping) Adjacent p q.
  Proof.
    induction 1 as [t M|t s u J IH S M]; intros p q A B.
    - intros (tid & E & I & T) (tid' & E' & I' & T').
      pose proof (OwnerKnown before warping tid tid' t t E E' T T' (incl_refl _)).
      subst tid'. exact (CornersJoined tid p q I I' A B).
    - intros P (tid' & E' & I' & U).
      apply JoinedInside in J. destruct J as [_ (tid & E & K)].
      destruct (HasInnerCorner tid s E K) as (c & C & Cp).
      apply (JoinedThen _ _ _ p c q).
      + apply (IH p c A Cp P). exists tid. auto.
      + exact (FaceThenPoint tid tid' s u c q E E' K U S C I' Cp B).
  Qed.
End Mesh.

(** ** Pieces *)

Theorem MeshPieces before warping p q t u :
  NoWall before warping ->
  PlusAfter before warping p -> PlusAfter before warping q ->
  MadeAt before warping p t -> MadeAt before warping q u ->
  Joined (InMesh before warping) ShareFace t u <->
  Joined (PlusAfter before warping) Adjacent p q.
Proof.
  intros N A B T U. split.
  - intros J. exact (FacesThenPoints before warping N t u J p q A B T U).
  - intros J. exact (proj2 (PointsThenFaces before warping p q t J T) u U).
Qed.

Theorem PiecesKept before warping p q t u :
  AllLeave Adjacent (PlusBefore before) (PlusAfter before warping) ->
  NoWall before warping ->
  PlusAfter before warping p -> PlusAfter before warping q ->
  MadeAt before warping p t -> MadeAt before warping q u ->
  Joined (InMesh before warping) ShareFace t u <->
  Joined (PlusBefore before) Adjacent p q.
Proof.
  intros L N A B T U. rewrite (MeshPieces before warping p q t u N A B T U).
  symmetry. exact (KeepsPieces _ _ SamePoint3 AdjacentMutual _ _ L p q A B).
Qed.

Theorem NoPieceLost before warping p :
  AllLeave Adjacent (PlusBefore before) (PlusAfter before warping) ->
  PlusBefore before p -> (exists tid, InLattice tid /\ In p (Corners tid)) ->
  exists q t, PlusAfter before warping q /\ MadeAt before warping q t /\
    Joined (PlusBefore before) Adjacent p q.
Proof.
  intros L P (tid & E & I).
  destruct (LosesNoPiece _ _ SamePoint3 AdjacentMutual _ _ L p P) as (q & Q & J).
  assert (exists tid, InLattice tid /\ In q (Corners tid)) as (own & Own & K).
  { clear -J E I. induction J as [p P|p q r J IH [d ->] R]; [eauto|].
    destruct (IH I) as (own & Own & K).
    destruct (EdgeInStar own q d Own K) as (other & O & _ & H). eauto. }
  destruct (MadeSomewhere before warping own q K Q) as (t & T).
  exists q, t. split; [exact Q|]. split; [exists own; auto|exact J].
Qed.
