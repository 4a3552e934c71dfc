(** * Tetrahedra around a + point, and those of its neighbours

    Whatever is made within the structured tetrahedra: if what is made within each
    is one piece, and both sides of a face agree, then it is joined by faces around
    every + point and along every edge from + to +.  Conversely a common face has a
    + end in both structured tetrahedra, or is a wall.  No diagonal matters. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Embedding.EdgeRank Embedding.GreedyProof
  Embedding.MeshApartProof Embedding.LeavingProof Embedding.LinkProof
  Embedding.StarProof.
Open Scope Z_scope.

Lemma ShareFaceMutual t u : ShareFace t u -> ShareFace u t.
Proof. intros (a & b & c & H & K). exists a, b, c. auto. Qed.

Lemma NeighborOfLattice tid i : InLattice tid -> InLattice (NeighborOf tid i).
Proof.
  intros E. assert (In (VertexAt (GetStructuredTet tid) First) (Corners tid))
    as I by (apply PlaceOf; eauto).
  destruct (FromOrigin tid _ E I) as (a & b & c & case & _ & -> & _).
  rewrite NeighborMoved. apply HasEvenAnchorMeans.
  destruct case, i; reflexivity.
Qed.

(** What has ends at all corners of a structured tetrahedron belongs to no other. *)
Lemma OneOwner after tid tid' (t : UnstructuredTet MeshVertex) :
  InLattice tid -> InLattice tid' ->
  (forall c, In c (Corners tid) -> exists v, In v (TetCorners t) /\ In c (Ends v)) ->
  (forall v, In v (TetCorners t) -> Belongs after (Corners tid') v) -> tid = tid'.
Proof.
  intros E E' R B. apply CornersDetermine; [assumption..|]. intros c J.
  destruct (R c J) as (v & V & K). exact (EndsBelong _ _ v c (B v V) K).
Qed.

(** ** What is asked *)

Section Made.
  Variables (within : StructuredTetId -> list (UnstructuredTet MeshVertex))
    (after : SignField).

  Definition Made (t : UnstructuredTet MeshVertex) : Prop :=
    exists tid, InLattice tid /\ In t (within tid).

  (** Within a structured tetrahedron that has [c] as a corner. *)
  Definition MadeBeside (c : Coord3) (t : UnstructuredTet MeshVertex) : Prop :=
    exists tid, InLattice tid /\ In c (Corners tid) /\ In t (within tid).

  Definition IsInside (c : Coord3) : Prop := after c = Plus.

  (** No face of the lattice whose corners are all on the surface has + on both
      sides. *)
  Definition NoWallAmong : Prop :=
    forall a b c p q,
      a <> b -> b <> c -> a <> c ->
      (forall v, In v [a; b; c] -> after v = OnSurface) ->
      IsInside p -> IsInside q ->
      (exists tid, InLattice tid /\ incl [a; b; c; p] (Corners tid)) ->
      (exists tid, InLattice tid /\ incl [a; b; c; q] (Corners tid)) ->
      p = q.

  Record JoinsWithin : Prop := {
    within_belongs : forall tid t v, InLattice tid -> In t (within tid) ->
      In v (TetCorners t) ->
      Belongs after (Corners tid) v;
    within_reaches : forall tid t c, InLattice tid -> In t (within tid) ->
      In c (Corners tid) -> exists v, In v (TetCorners t) /\ In c (Ends v);
    within_inner : forall tid t, InLattice tid -> In t (within tid) ->
      exists c, In c (Corners tid) /\ IsInside c;
    within_whole : forall tid t u, InLattice tid -> In t (within tid) ->
      In u (within tid) -> Joined (Made) ShareFace t u;
    within_face : forall tid i f, In f (FaceOf tid i) -> IsInside f ->
      exists a b c, AmongTriangles (within tid) a b c /\
        LiesIn (FaceOf tid i) a /\ LiesIn (FaceOf tid i) b /\ LiesIn (FaceOf tid i) c;
    within_agree : forall tid i f, In f (FaceOf tid i) -> IsInside f ->
      forall a b c, LiesIn (FaceOf tid i) a -> LiesIn (FaceOf tid i) b ->
        LiesIn (FaceOf tid i) c ->
        AmongTriangles (within tid) a b c ->
        AmongTriangles (within (NeighborOf tid i)) a b c
  }.
End Made.

Arguments within_belongs {within after}.
Arguments within_reaches {within after}.
Arguments within_inner {within after}.
Arguments within_whole {within after}.
Arguments within_face {within after}.
Arguments within_agree {within after}.

Section Joined.
  Variables (within : StructuredTetId -> list (UnstructuredTet MeshVertex))
    (after : SignField).
  Hypothesis joins : JoinsWithin within after.

  Local Notation inside := (IsInside after).
  Local Notation joined := (Joined (Made within) ShareFace).
  Local Notation points := (Joined inside Adjacent).

  (** ** Around a + point *)

  Lemma MadeOfWithin tid t : InLattice tid -> In t (within tid) -> Made within t.
  Proof. intros E I. exists tid. auto. Qed.

  Lemma JoinedAcross tid i p t u : InLattice tid -> In p (FaceOf tid i) ->
    inside p -> In t (within tid) -> In u (within (NeighborOf tid i)) -> joined t u.
  Proof.
    intros E I A T U. pose proof (NeighborOfLattice tid i E) as E'.
    destruct (within_face joins tid i p I A)
      as (a & b & c & among & Fa & Fb & Fc).
    destruct (within_agree joins tid i p I A a b c Fa Fb Fc among) as (r & R & K).
    destruct among as (s & S & H).
    apply (JoinedThen _ _ _ t s u); [exact (within_whole joins tid t s E T S)|].
    apply (JoinedThen _ _ _ s r u); [|exact (within_whole joins _ r u E' R U)].
    apply JoinedNext; [exact (MadeOfWithin tid s E S)| |exact (MadeOfWithin _ r E' R)].
    exists a, b, c. auto.
  Qed.

  Lemma SomethingWithin tid p : In p (Corners tid) -> inside p ->
    exists t, In t (within tid).
  Proof.
    intros I A. assert (exists i, In p (FaceOf tid i)) as [i F].
    { unfold Corners, FaceOf in *. destruct (GetStructuredTet tid).
      cbn [In] in I. destruct I as [<-|[<-|[<-|[<-|[]]]]];
        [exists Second|exists First|exists First|exists First]; cbn; tauto. }
    destruct (within_face joins tid i p F A) as (_ & _ & _ & (t & T & _) & _).
    exists t. exact T.
  Qed.

  Lemma JoinedAround p tid target : AroundPoint p tid target -> inside p ->
    InLattice tid -> forall t u, In t (within tid) -> In u (within target) -> joined t u.
  Proof.
    intros R A. induction R as [tid I|tid i target I F R IH]; intros E t u T U.
    - exact (within_whole joins tid t u E T U).
    - pose proof (NeighborOfLattice tid i E) as E'.
      assert (N : In p (Corners (NeighborOf tid i))) by (destruct R; assumption).
      destruct (SomethingWithin _ p N A) as (s & S).
      apply (JoinedThen _ _ _ t s u).
      + exact (JoinedAcross tid i p t s E F A T S).
      + exact (IH E' s u S U).
  Qed.

  Lemma MadeAroundJoined p t u : inside p -> MadeBeside within p t ->
    MadeBeside within p u -> joined t u.
  Proof.
    intros A (tid & E & I & T) (tid' & E' & I' & U).
    pose proof (StarConnected tid p E I) as R.
    pose proof (StarConnected tid' p E' I') as R'.
    assert (H : In p (Corners (Home p))) by (clear -R; induction R; assumption).
    destruct (SomethingWithin _ p H A) as (s & S).
    apply (JoinedThen _ _ _ t s u); [exact (JoinedAround p tid _ R A E t s T S)|].
    apply JoinedBack; [exact ShareFaceMutual|].
    exact (JoinedAround p tid' _ R' A E' u s U S).
  Qed.

  Lemma TetsJoined p q t : points p q -> MadeBeside within p t ->
    (exists tid, InLattice tid /\ In q (Corners tid)) /\
    forall u, MadeBeside within q u -> joined t u.
  Proof.
    intros J. induction J as [p A|p q r J IH [d ->] A]; intros T.
    - split; [destruct T as (tid & E & I & _); eauto|].
      intros u U. exact (MadeAroundJoined p t u A T U).
    - destruct (IH T) as ((tid & E & I) & K).
      destruct (EdgeInStar tid q d E I) as (other & E' & Q & R).
      split; [eauto|]. intros u U.
      apply JoinedInside in J. destruct J as [_ B].
      destruct (SomethingWithin other q Q B) as (s & S).
      apply (JoinedThen _ _ _ t s u); [apply K; exists other; auto|].
      apply (MadeAroundJoined (Translate q (Offset d)));
        [exact A|exists other; auto|exact U].
  Qed.

  (** ** From faces to points *)

  Lemma OwnerWithin tid tid' t : InLattice tid -> InLattice tid' ->
    In t (within tid) -> In t (within tid') -> tid = tid'.
  Proof.
    intros E E' I I'. apply (OneOwner after tid tid' t E E').
    - intros c. exact (within_reaches joins tid t c E I).
    - intros v. exact (within_belongs joins tid' t v E' I').
  Qed.

  Lemma PointsOfOne tid p q : In p (Corners tid) -> In q (Corners tid) ->
    inside p -> inside q -> points p q.
  Proof.
    intros I J A B. destruct (SamePoint3 p q) as [<-|N].
    - constructor. exact A.
    - destruct (EdgeBetween tid p q I J N) as [d E].
      apply JoinedNext; [exact A|exists d; exact E|exact B].
  Qed.

  Hypothesis Walls : NoWallAmong after.

  Lemma FaceJoinsPoints tid tid' t u p q : InLattice tid -> InLattice tid' ->
    In t (within tid) -> In u (within tid') -> ShareFace t u ->
    In p (Corners tid) -> In q (Corners tid') -> inside p -> inside q -> points p q.
  Proof.
    intros E E' T U (x & y & z & H & K) I J A B.
    pose proof (fun v => within_belongs joins tid t v E T) as F.
    pose proof (fun v => within_belongs joins tid' u v E' U) as F'.
    destruct H as ((Tx & Ty & Tz) & Xy & Yz & Xz), K as ((Ux & Uy & Uz) & _).
    assert (Inner : forall v e, In v (TetCorners t) -> In v (TetCorners u) ->
      In e (Ends v) -> after e = Plus -> points p q).
    { intros v e V V' Z P.
      pose proof (EndsBelong after _ v e (F v V) Z) as Q.
      pose proof (EndsBelong after _ v e (F' v V') Z) as Q'.
      apply (JoinedThen _ _ _ p e q); eapply PointsOfOne; eassumption. }
    assert (InnerEnd : forall v, Belongs after (Corners tid) v ->
      (exists e, In e (Ends v) /\ after e = Plus) \/
      exists c, v = Corner c /\ after c = OnSurface).
    { intros [c|a m]; cbn [Belongs Ends In].
      - intros [_ N]. destruct (after c) eqn:S; [left|right|congruence]; eauto.
      - intros (_ & _ & S & _). eauto. }
    destruct (InnerEnd x (F x Tx)) as [(e & Z & P)|(a & -> & Sa)]; [eauto|].
    destruct (InnerEnd y (F y Ty)) as [(e & Z & P)|(b & -> & Sb)]; [eauto|].
    destruct (InnerEnd z (F z Tz)) as [(e & Z & P)|(c & -> & Sc)]; [eauto|].
    replace q with p; [constructor; exact A|].
    assert (Sub : forall corners r, Belongs after corners (Corner a) ->
      Belongs after corners (Corner b) -> Belongs after corners (Corner c) ->
      In r corners -> incl [a; b; c; r] corners).
    { intros corners r [Ia _] [Ib _] [Ic _] R v. cbn [In].
      intros [<-|[<-|[<-|[<-|[]]]]]; assumption. }
    apply (Walls a b c p q); try congruence.
    - intros v. cbn [In]. intros [<-|[<-|[<-|[]]]]; assumption.
    - exists tid. split; [exact E|]. apply Sub; auto.
    - exists tid'. split; [exact E'|]. apply Sub; auto.
  Qed.

  Lemma FacesJoinPoints t u : joined t u ->
    forall p q, inside p -> inside q -> MadeBeside within p t -> MadeBeside within q u ->
      points p q.
  Proof.
    induction 1 as [t M|t s u J IH S M]; intros p q A B.
    - intros (tid & E & I & T) (tid' & E' & I' & T').
      pose proof (OwnerWithin tid tid' t E E' T T'). subst tid'.
      exact (PointsOfOne tid p q I I' A B).
    - intros P (tid' & E' & I' & U).
      apply JoinedInside in J. destruct J as [_ (tid & E & K)].
      destruct (within_inner joins tid s E K) as (c & C & Cp).
      apply (JoinedThen _ _ _ p c q).
      + apply (IH p c A Cp P). exists tid. auto.
      + exact (FaceJoinsPoints tid tid' s u c q E E' K U S C I' Cp B).
  Qed.

  (** Two tetrahedra are joined by faces just as + corners of their structured
      tetrahedra are joined by edges of the lattice. *)
  Theorem PiecesByEdges p q t u : inside p -> inside q ->
    MadeBeside within p t -> MadeBeside within q u -> joined t u <-> points p q.
  Proof.
    intros A B T U. split.
    - intros J. exact (FacesJoinPoints t u J p q A B T U).
    - intros J. exact (proj2 (TetsJoined p q t J T) u U).
  Qed.
End Joined.

(** ** Where vertices leave one after the other *)

Section Leaving.
  Variables (within : StructuredTetId -> list (UnstructuredTet MeshVertex))
    (after : SignField) (before : Coord3 -> Prop).
  Hypothesis joins : JoinsWithin within after.
  Hypothesis leaves : AllLeave Adjacent before (IsInside after).

  Theorem PiecesOfSamples p q t u : NoWallAmong after ->
    IsInside after p -> IsInside after q ->
    MadeBeside within p t -> MadeBeside within q u ->
    Joined (Made within) ShareFace t u <-> Joined before Adjacent p q.
  Proof.
    intros walls A B T U.
    rewrite (PiecesByEdges within after joins walls p q t u A B T U).
    symmetry. exact (KeepsPieces _ _ SamePoint3 AdjacentMutual _ _ leaves p q A B).
  Qed.

  Theorem NoSampleLost p :
    before p -> (exists tid, InLattice tid /\ In p (Corners tid)) ->
    exists q t, IsInside after q /\ MadeBeside within q t /\ Joined before Adjacent p q.
  Proof.
    intros P (tid & E & I).
    destruct (LosesNoPiece _ _ SamePoint3 AdjacentMutual _ _ leaves p P) as (q & Q & J).
    assert (exists tid, InLattice tid /\ In q (Corners tid)) as (own & Own & K).
    { clear -J E I. induction J as [p P|p q r J IH [d ->] R]; [eauto|].
      destruct (IH I) as (own & Own & K).
      destruct (EdgeInStar own q d Own K) as (other & O & _ & H). eauto. }
    destruct (SomethingWithin within after joins own q K Q) as (t & T).
    exists q, t. split; [exact Q|]. split; [exists own; auto|exact J].
  Qed.
End Leaving.
