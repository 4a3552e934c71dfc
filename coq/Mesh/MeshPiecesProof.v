(** * Pieces of any mesh are pieces of its lattice points: proof

    All that is asked of what is made within a structured tetrahedron: that it is
    one piece, that both sides of a face agree, and whose vertices it has.  No
    diagonal matters. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Embedding.EdgeRank Embedding.GreedyProof
  Embedding.MeshApartProof Embedding.LeavingProof Embedding.LinkProof
  Embedding.StarProof Embedding.AroundProof Embedding.PiecesProof.
From Certet Require Import Mesh.Method Mesh.MeshPiecesSpec.
Open Scope Z_scope.

(** ** What is asked of a mesh *)

Record JoinsWithin (mesh : Mesh) : Prop := {
  within_belongs : forall tid t v, InLattice tid -> In t (TetsWithin mesh tid) ->
    In v (TetCorners t) ->
    Belongs (fun c => SignIn mesh (Corner c)) (Corners tid) v;
  within_reaches : forall tid t c, InLattice tid -> In t (TetsWithin mesh tid) ->
    In c (Corners tid) -> exists v, In v (TetCorners t) /\ In c (Ends v);
  within_inner : forall tid t, InLattice tid -> In t (TetsWithin mesh tid) ->
    exists c, In c (Corners tid) /\ InsideMesh mesh c;
  within_whole : forall tid t u, InLattice tid -> In t (TetsWithin mesh tid) ->
    In u (TetsWithin mesh tid) -> Joined (TetOf mesh) ShareFace t u;
  within_face : forall tid i f, In f (FaceOf tid i) -> InsideMesh mesh f ->
    exists a b c, AmongTriangles (TetsWithin mesh tid) a b c /\
      LiesIn (FaceOf tid i) a /\ LiesIn (FaceOf tid i) b /\ LiesIn (FaceOf tid i) c;
  within_agree : forall tid i f, In f (FaceOf tid i) -> InsideMesh mesh f ->
    forall a b c, LiesIn (FaceOf tid i) a -> LiesIn (FaceOf tid i) b ->
      LiesIn (FaceOf tid i) c ->
      AmongTriangles (TetsWithin mesh tid) a b c ->
      AmongTriangles (TetsWithin mesh (NeighborOf tid i)) a b c
}.

Section Mesh.
  Variable mesh : Mesh.
  Hypothesis joins : JoinsWithin mesh.

  Let after c := SignIn mesh (Corner c).
  Local Notation inside := (InsideMesh mesh).
  Local Notation within := (TetsWithin mesh).
  Local Notation joined := (Joined (TetOf mesh) ShareFace).
  Local Notation points := (Joined inside Adjacent).

  (** ** Around a + point *)

  Lemma WithinMesh tid t : InLattice tid -> In t (within tid) -> TetOf mesh t.
  Proof. intros E I. exists tid. auto. Qed.

  Lemma JoinedAcross tid i p t u : InLattice tid -> In p (FaceOf tid i) ->
    inside p -> In t (within tid) -> In u (within (NeighborOf tid i)) -> joined t u.
  Proof.
    intros E I A T U. pose proof (NeighborOfLattice tid i E) as E'.
    destruct (within_face mesh joins tid i p I A)
      as (a & b & c & among & Fa & Fb & Fc).
    destruct (within_agree mesh joins tid i p I A a b c Fa Fb Fc among) as (r & R & K).
    destruct among as (s & S & H).
    apply (JoinedThen _ _ _ t s u); [exact (within_whole mesh joins tid t s E T S)|].
    apply (JoinedThen _ _ _ s r u); [|exact (within_whole mesh joins _ r u E' R U)].
    apply JoinedNext; [exact (WithinMesh tid s E S)| |exact (WithinMesh _ r E' R)].
    exists a, b, c. auto.
  Qed.

  Lemma SomethingWithin tid p : In p (Corners tid) -> inside p ->
    exists t, In t (within tid).
  Proof.
    intros I A. assert (exists i, In p (FaceOf tid i)) as [i F].
    { unfold Corners, FaceOf in *. destruct (GetStructuredTet tid).
      cbn [In] in I. destruct I as [<-|[<-|[<-|[<-|[]]]]];
        [exists Second|exists First|exists First|exists First]; cbn; tauto. }
    destruct (within_face mesh joins tid i p F A) as (_ & _ & _ & (t & T & _) & _).
    exists t. exact T.
  Qed.

  Lemma JoinedAround p tid target : AroundPoint p tid target -> inside p ->
    InLattice tid -> forall t u, In t (within tid) -> In u (within target) -> joined t u.
  Proof.
    intros R A. induction R as [tid I|tid i target I F R IH]; intros E t u T U.
    - exact (within_whole mesh joins tid t u E T U).
    - pose proof (NeighborOfLattice tid i E) as E'.
      assert (N : In p (Corners (NeighborOf tid i))) by (destruct R; assumption).
      destruct (SomethingWithin _ p N A) as (s & S).
      apply (JoinedThen _ _ _ t s u).
      + exact (JoinedAcross tid i p t s E F A T S).
      + exact (IH E' s u S U).
  Qed.

  Lemma MadeAroundJoined p t u : inside p -> MadeAround mesh p t ->
    MadeAround mesh p u -> joined t u.
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

  Lemma TetsJoined p q t : points p q -> MadeAround mesh p t ->
    (exists tid, InLattice tid /\ In q (Corners tid)) /\
    forall u, MadeAround mesh q u -> joined t u.
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
    intros E E' I I'. apply CornersDetermine; [assumption..|]. intros c J.
    destruct (within_reaches mesh joins tid t c E I J) as (v & V & K).
    exact (EndsBelong _ _ v c (within_belongs mesh joins tid' t v E' I' V) K).
  Qed.

  Lemma PointsOfOne tid p q : In p (Corners tid) -> In q (Corners tid) ->
    inside p -> inside q -> points p q.
  Proof.
    intros I J A B. destruct (SamePoint3 p q) as [<-|N].
    - constructor. exact A.
    - destruct (EdgeBetween tid p q I J N) as [d E].
      apply JoinedNext; [exact A|exists d; exact E|exact B].
  Qed.

  Hypothesis Walls : NoWallIn mesh.

  Lemma FaceJoinsPoints tid tid' t u p q : InLattice tid -> InLattice tid' ->
    In t (within tid) -> In u (within tid') -> ShareFace t u ->
    In p (Corners tid) -> In q (Corners tid') -> inside p -> inside q -> points p q.
  Proof.
    intros E E' T U (x & y & z & H & K) I J A B.
    pose proof (fun v => within_belongs mesh joins tid t v E T) as F.
    pose proof (fun v => within_belongs mesh joins tid' u v E' U) as F'.
    fold after in F, F'.
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
    forall p q, inside p -> inside q -> MadeAround mesh p t -> MadeAround mesh q u ->
      points p q.
  Proof.
    induction 1 as [t M|t s u J IH S M]; intros p q A B.
    - intros (tid & E & I & T) (tid' & E' & I' & T').
      pose proof (OwnerWithin tid tid' t E E' T T'). subst tid'.
      exact (PointsOfOne tid p q I I' A B).
    - intros P (tid' & E' & I' & U).
      apply JoinedInside in J. destruct J as [_ (tid & E & K)].
      destruct (within_inner mesh joins tid s E K) as (c & C & Cp).
      apply (JoinedThen _ _ _ p c q).
      + apply (IH p c A Cp P). exists tid. auto.
      + exact (FaceJoinsPoints tid tid' s u c q E E' K U S C I' Cp B).
  Qed.

  Theorem PiecesByEdges : PiecesAreThoseOf mesh inside.
  Proof.
    intros p q t u A B T U. split.
    - intros J. exact (FacesJoinPoints t u J p q A B T U).
    - intros J. exact (proj2 (TetsJoined p q t J T) u U).
  Qed.
End Mesh.

(** ** Where vertices leave one after the other *)

Theorem PiecesOfSamples mesh before :
  JoinsWithin mesh -> NoWallIn mesh ->
  AllLeave Adjacent before (InsideMesh mesh) -> PiecesAreThoseOf mesh before.
Proof.
  intros joins walls L p q t u A B T U.
  rewrite (PiecesByEdges mesh joins walls p q t u A B T U).
  symmetry. exact (KeepsPieces _ _ SamePoint3 AdjacentMutual _ _ L p q A B).
Qed.

Theorem NoSampleLost mesh (before : Coord3 -> Prop) p :
  JoinsWithin mesh -> AllLeave Adjacent before (InsideMesh mesh) ->
  before p -> (exists tid, InLattice tid /\ In p (Corners tid)) ->
  exists q t, InsideMesh mesh q /\ MadeAround mesh q t /\ Joined before Adjacent p q.
Proof.
  intros joins L P (tid & E & I).
  destruct (LosesNoPiece _ _ SamePoint3 AdjacentMutual _ _ L p P) as (q & Q & J).
  assert (exists tid, InLattice tid /\ In q (Corners tid)) as (own & Own & K).
  { clear -J E I. induction J as [p P|p q r J IH [d ->] R]; [eauto|].
    destruct (IH I) as (own & Own & K).
    destruct (EdgeInStar own q d Own K) as (other & O & _ & H). eauto. }
  destruct (SomethingWithin mesh joins own q K Q) as (t & T).
  exists q, t. split; [exact Q|]. split; [exists own; auto|exact J].
Qed.
