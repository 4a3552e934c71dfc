(** * Neighbours share their faces, and know each other: proofs

    What is across from a flag does not depend on the tetrahedron that has it,
    but for which of its points the face has.  So a face is looked at from one of
    its flags, and the neighbour's face from the flag across. *)

From Certet Require Import Grading.Definitions Lattice.Tiling.
From Certet Require Import Grading.FlagProof Grading.BalanceProof
  Grading.PartitionProof Grading.GradedVolumeProof
  Grading.FaceSeenProof Grading.FinerBesideProof Grading.FlagAcrossProof.
Open Scope Z_scope.

Section Around.
  Variable cells : CellSet.
  Hypothesis Balance : IsBalanced cells.

  Local Notation across x w := (TetOfFlag cells (FlagAcross cells x w)).


  (** ** All flags at a face have the same neighbour across *)

  Lemma PyramidAround x : IsPresent cells x = true -> KindAt cells x = PyramidTet ->
    IsOffDiagonal x = true ->
    TetOfFlag cells (OtherEdge (OtherCorner (OtherEdge x)))
    = TetOfFlag cells (OtherEdge (OtherCorner x)).
  Proof.
    intros P K off.
    assert (Kc : forall y, KindAt cells y = PyramidTet -> KindAt cells (OtherCorner y) = PyramidTet)
      by (intros y Ky; now rewrite KindByCorner).
    pose proof (KindByEdgePyramid cells) as Ke.
    assert (T1 : TetOfFlag cells (OtherEdge (OtherCorner x))
                 = TetOfFlag cells (OtherCorner (OtherEdge (OtherCorner x))))
      by (symmetry; apply TetByCorner; auto 8).
    assert (T2 : TetOfFlag cells (OtherEdge (OtherCorner (OtherEdge x)))
                 = TetOfFlag cells (OtherCorner (OtherEdge (OtherCorner (OtherEdge x)))))
      by (symmetry; apply TetByCorner; auto 8).
    rewrite T1, T2, <- AroundFace. apply TetByEdge; [auto 8|].
    now rewrite OffDiagonalByCorner, OffDiagonalByEdge, OffDiagonalByCorner, off.
  Qed.

  (** Two flags that see a face together have the same tetrahedron across. *)
  Lemma EdgeMates x : IsPresent cells x = true ->
    KindAt cells x = BccTet \/ KindAt cells x = EdgeHalfTet ->
    across (OtherCell x) Second = across x Second.
  Proof.
    intros P K. cbn [FlagAcross]. rewrite CellThenEdge. apply TetByCell.
    - now rewrite PresentEdge.
    - pose proof (KindTells cells x) as T. pose proof (KindTells cells (OtherEdge x)) as T'.
      rewrite AcrossByEdge, FaceUsedByEdge in T'.
      destruct K as [K | K]; rewrite K in T;
        destruct (KindAt cells (OtherEdge x)); auto; exfalso; intuition congruence.
  Qed.

  Lemma FaceMates x :
    KindAt cells x = BccTet \/ KindAt cells x = FaceHalfTet \/ KindAt cells x = PyramidTet ->
    across (OtherCorner x) Third = across x Third.
  Proof.
    intros K. cbn [FlagAcross]. rewrite CornerThenFace. apply TetByCorner.
    pose proof (KindTells cells x) as T. pose proof (KindTells cells (OtherFace x)) as T'.
    rewrite EdgeUsedByFace in T'.
    assert (A : EdgeIsUsed cells x = true -> AcrossExists cells x = true).
    { intros U. apply (EdgeUsed cells Balance x 1 0); [exact U | lia ..]. }
    destruct (EdgeIsUsed cells x);
      [rewrite (A eq_refl) in T|];
      destruct K as [K | [K | K]]; rewrite K in T;
      destruct (KindAt cells (OtherFace x)); auto; exfalso; intuition congruence.
  Qed.

  Lemma CornerMates x : IsPresent cells x = true -> KindAt cells x = EdgeHalfTet ->
    across (OtherCell x) First = across x First.
  Proof.
    intros P K. cbn [FlagAcross].
    assert (Pc : IsPresent cells (OtherCorner x) = true)
      by (apply (CornerPresent cells Balance); [exact P | rewrite K; discriminate]).
    assert (Kc : KindAt cells (OtherCorner x) = EdgeHalfTet) by now rewrite KindByCorner.
    assert (Ps : IsPresent cells (OtherCell (OtherCorner x)) = true)
      by (apply (CellPresent cells); auto).
    rewrite Pc, <- CornerThenCell, Ps. apply TetByCell; auto.
  Qed.

  Lemma CellMates x : IsPresent cells x = true -> KindAt cells x = FaceHalfTet ->
    across (OtherCorner x) Fourth = across x Fourth.
  Proof.
    intros P K. cbn [FlagAcross].
    pose proof (BesideCorner cells Balance x P ltac:(auto)) as (Pc & Kc & _). rewrite K in Kc.
    assert (Ps : IsPresent cells (OtherCell x) = true) by (apply (CellPresent cells); auto).
    assert (Psc : IsPresent cells (OtherCell (OtherCorner x)) = true)
      by (apply (CellPresent cells); auto).
    pose proof (KindTells cells x) as T. rewrite K in T. destruct T as [A _].
    unfold AcrossExists in A. rewrite LevelByCorner, CellByCorner. change (- 0) with 0.
    rewrite A, Ps, Psc, CornerThenCell. apply TetByCorner.
    rewrite KindByCell; [auto | now apply PresentTells | exact A].
  Qed.

  Lemma BaseMates x y : KindAt cells x = PyramidTet -> KindAt cells y = PyramidTet ->
    WithCornerOffDiagonal y = WithCornerOffDiagonal x ->
    FlagAcross cells y Fourth = FlagAcross cells x Fourth.
  Proof.
    intros K K' N. cbn [FlagAcross].
    pose proof (KindTells cells x) as T. pose proof (KindTells cells y) as T'.
    rewrite K in T. rewrite K' in T'. unfold AcrossExists in *. now rewrite T, T', N.
  Qed.

  (** So every flag at a face tells the neighbour. *)
  Lemma FaceOfFlag knd x z w : InGradedMesh cells (GTId knd x) ->
    In z (FlagsOf (GTId knd x)) -> IsOuter knd z w = true ->
    exists i, SameVertices (GradedFace (GTId knd x) i) (FaceSeen knd z w) /\
      GradedVertexAt (GTId knd x) i = ApexSeen knd z w /\
      GradedNeighbor cells (GTId knd x) i = across z w.
  Proof.
    intros M I O. destruct (NamedBy _ _ _ M) as (P & K & N).
    unfold GradedNeighbor, GradedFace, GradedVertexAt.
    destruct knd; cbn [FlagsOf In] in I.
    - (* The lattice's own. *)
      pose proof (BesideCorner cells Balance x P ltac:(auto)) as (Pc & Kc & _).
      pose proof (BesideCell cells x P ltac:(auto)) as (Ps & Ks & _).
      rewrite K in Kc, Ks.
      assert (S : forall y, In y [x; OtherCell x] ->
        across (OtherCorner y) Third = across y Third)
        by (intros y [<- | [<- | []]]; apply FaceMates; auto).
      pose proof (S x ltac:(cbn; tauto)). pose proof (S (OtherCell x) ltac:(cbn; tauto)).
      pose proof (EdgeMates x P ltac:(auto)).
      pose proof (EdgeMates (OtherCorner x) Pc ltac:(auto)) as E.
      rewrite CornerThenCell in E.
      destruct w; try discriminate O.
      + destruct I as [<- | [<- | [<- | [<- | []]]]];
          [exists First | exists Second | exists First | exists Second];
          cbn [FlagAtFace Others GradedVertices FaceSeen ApexSeen]; destruct (IsUpperEdge x);
          cbn [Pick]; (split; [shared | split; [apex | auto]]).
      + destruct (IsUpperEdge x) eqn:U;
          destruct I as [<- | [<- | [<- | [<- | []]]]];
          [exists Third | exists Third | exists Fourth | exists Fourth
          |exists Fourth | exists Fourth | exists Third | exists Third];
          cbn [FlagAtFace Others GradedVertices FaceSeen ApexSeen]; rewrite U;
          cbn [Pick]; (split; [shared | split; [apex | auto]]).
    - pose proof (EdgeMates x P ltac:(auto)). pose proof (CornerMates x P K).
      destruct I as [<- | [<- | []]]; destruct w; try discriminate O;
        [exists First | exists Second | exists Third | exists First | exists Second
        |exists Fourth];
        cbn [FlagAtFace Others GradedVertices FaceSeen ApexSeen Pick]; (split; [shared | split; [apex | auto]]).
    - pose proof (FaceMates x ltac:(auto)). pose proof (CellMates x P K).
      destruct I as [<- | [<- | []]]; destruct w; try discriminate O;
        [exists Second | exists Third | exists Fourth | exists First | exists Third
        |exists Fourth];
        cbn [FlagAtFace Others GradedVertices FaceSeen ApexSeen Pick]; (split; [shared | split; [apex | auto]]).
    - destruct I as [<- | []]. exists w. destruct w;
        cbn [FlagAtFace Others GradedVertices FaceSeen ApexSeen Pick]; (split; [shared | split; [apex | auto]]).
    - cbn [NamingFlag] in N. pose proof (NameOffDiagonal x N) as off.
      pose proof (BesideCorner cells Balance x P ltac:(auto)) as (Pc & Kc & _).
      pose proof (BesideEdge cells x P K off) as (Pe & Ke & _).
      rewrite K in Kc, Ke.
      pose proof (FaceMates x ltac:(auto)). pose proof (FaceMates (OtherEdge x) ltac:(auto)).
      pose proof (PyramidAround x P K off).
      assert (B : forall y, In y (FlagsOf (GTId PyramidTet x)) ->
        FlagAcross cells y Fourth = FlagAcross cells x Fourth).
      { cbn [FlagsOf In]. intros y J. apply BaseMates; [exact K | |].
        - destruct J as [<- | [<- | [<- | [<- | []]]]]; rewrite ?KindByCorner; assumption.
        - destruct J as [<- | [<- | [<- | [<- | []]]]];
            rewrite ?PyramidNameByCorner, ?(PyramidNameByEdge x off); reflexivity. }
      cbn [FlagsOf In] in B.
      destruct w; try discriminate O.
      + destruct I as [<- | [<- | [<- | [<- | []]]]]; cbn [IsOuter] in O;
          rewrite ?OffDiagonalByCorner, ?OffDiagonalByEdge, ?off in O; try discriminate O;
          exists First; cbn [FlagAtFace Others GradedVertices FaceSeen ApexSeen Pick];
          (split; [shared | split; [apex | auto]]).
      + destruct I as [<- | [<- | [<- | [<- | []]]]];
          [exists Third | exists Third | exists Second | exists Second];
          cbn [FlagAtFace Others GradedVertices FaceSeen ApexSeen Pick];
          rewrite ?OffDiagonalByCorner, ?OffDiagonalByEdge, ?off; cbn [negb]; (split; [shared | split; [apex | auto]]).
      + exists Fourth. cbn [FlagAtFace Others GradedVertices Pick]. split.
        * destruct I as [<- | [<- | [<- | [<- | []]]]]; cbn [FaceSeen];
            rewrite ?OffDiagonalByCorner, ?OffDiagonalByEdge, ?off; cbn [negb]; shared.
        * split; [|now rewrite (B z I)].
          destruct I as [<- | [<- | [<- | [<- | []]]]]; cbn [ApexSeen]; apex.
  Qed.
End Around.

(** ** The theorems *)

Section Neighbor.
  Variables (cells : CellSet) (tid : GradedTetId) (i : Place).
  Hypothesis IsOne : IsOctree cells.
  Hypothesis M : InGradedMesh cells tid.
  Local Notation nei := (GradedNeighbor cells tid i).

  Lemma NeighborMeets : InGradedMesh cells nei /\
    exists j, SameVertices (GradedFace tid i) (GradedFace nei j) /\
      LiesBetween (GradedFace tid i) (GradedVertexAt tid i) (GradedVertexAt nei j) /\
      GradedNeighbor cells nei j = tid.
  Proof.
    destruct IsOne as [Balance _]. destruct tid as [knd x].
    pose proof (FlagSeesFace cells knd x i M) as S.
    unfold GradedNeighbor at 1 2 3 5.
    destruct (FlagAtFace (GTId knd x) i) as [z w]. destruct S as (I & O & F & A).
    pose proof (FlagBeside cells Balance _ _ _ M I) as (P & K & T).
    destruct (NamedBy _ _ _ M) as (_ & Kx & _). rewrite Kx in K. clear Kx.
    pose proof (proj2 M) as N. rewrite N in T. clear N. subst knd.
    destruct (FlagsMeet cells Balance z w P O) as [w' (P' & O' & T' & F' & D)].
    pose proof (TetInMesh cells Balance _ P') as M'. split; [exact M'|].
    pose proof (FlagOfItsTet cells (FlagAcross cells z w)) as I'.
    unfold TetOfFlag in M', I' |- *.
    destruct (FaceOfFlag cells Balance _ _ _ _ M' I' O') as (j & Fj & Aj & Nj).
    exists j. split; [|split].
    - apply (SameTrans _ _ _ F), (SameTrans _ _ _ F'), SameSym, Fj.
    - rewrite A, Aj. exact (BetweenSame _ _ _ _ (SameSym _ _ F) D).
    - now rewrite Nj, T'.
  Qed.

  Theorem GradedFacesCorrect : InGradedMesh cells nei /\
    exists j, SameVertices (GradedFace tid i) (GradedFace nei j) /\
      LiesBetween (GradedFace tid i) (GradedVertexAt tid i) (GradedVertexAt nei j).
  Proof. destruct NeighborMeets as (M' & j & F & D & _). eauto. Qed.

  Theorem GradedNeighborInvolution :
    exists j, SameVertices (GradedFace tid i) (GradedFace nei j) /\
      GradedNeighbor cells nei j = tid.
  Proof. destruct NeighborMeets as (_ & j & F & _ & N). eauto. Qed.
End Neighbor.
