(** * Across each of a flag's four sides: proofs *)

From Certet Require Import Grading.Definitions.
From Certet Require Import Grading.FlagProof Grading.BalanceProof
  Grading.PartitionProof Grading.GradedVolumeProof
  Grading.FaceSeenProof Grading.FinerBesideProof.
Open Scope Z_scope.

Section Across.
  Variable cells : CellSet.
  Hypothesis Balance : IsBalanced cells.


  (** The two flags see the same face. *)
  Definition Meet (z y : Flag) (w' : Place) (w : Place) : Prop :=
    IsPresent cells y = true /\ IsOuter (KindAt cells y) y w' = true /\
    TetOfFlag cells (FlagAcross cells y w') = TetOfFlag cells z /\
    SameVertices (FaceSeen (KindAt cells z) z w) (FaceSeen (KindAt cells y) y w') /\
    LiesBetween (FaceSeen (KindAt cells z) z w) (ApexSeen (KindAt cells z) z w)
      (ApexSeen (KindAt cells y) y w').

  Lemma AcrossCorner z : IsPresent cells z = true -> IsOuter (KindAt cells z) z First = true ->
    exists w', Meet z (FlagAcross cells z First) w' First.
  Proof.
    intros P O. cbn [FlagAcross]. destruct (IsPresent cells (OtherCorner z)) eqn:Q.
    - exists First. split; [exact Q|]. rewrite KindByCorner. cbn [FlagAcross].
      rewrite CornerTwice, P. split; [|split].
      + destruct (KindAt cells z); exact O || discriminate O.
      + reflexivity.
      + split; destruct (KindAt cells z); try discriminate O; cbn [FaceSeen ApexSeen];
          [shared | shared | sides | sides].
    - assert (K : KindAt cells z = QuarterTet).
      { destruct (KindAt cells z) eqn:K; try discriminate O; [|reflexivity].
        rewrite (CornerPresent cells Balance z P) in Q by (rewrite K; discriminate).
        discriminate Q. }
      destruct (QuarterLevel cells z K) as [l L].
      destruct (proj2 (FinerInCellThere cells Balance z l L)) as [P' K']; [auto|].
      exists Fourth. split; [exact P'|]. rewrite K, K'. cbn [FlagAcross].
      split; [reflexivity|].
      split; [|split; [now apply (FinerInCellFace z l) | now apply (FinerInCellSides z l)]].
      pose proof (KindTells cells (FinerInCell z)) as T. rewrite K' in T.
      unfold AcrossExists in T. rewrite T.
      destruct (AheadInCell z l L) as (_ & E & C).
      now rewrite (PyramidNameKept _ E C), (CoarserOfCell z l L).
  Qed.

  Lemma AcrossEdge z : IsPresent cells z = true -> IsOuter (KindAt cells z) z Second = true ->
    exists w', Meet z (FlagAcross cells z Second) w' Second.
  Proof.
    intros P O. exists Second. cbn [FlagAcross]. split; [now rewrite PresentEdge|].
    cbn [FlagAcross]. rewrite EdgeTwice.
    pose proof (KindTells cells z) as T. pose proof (KindTells cells (OtherEdge z)) as T'.
    rewrite AcrossByEdge, FaceUsedByEdge in T'. pose proof (OffDiagonalByEdge z) as D.
    split; [|split; [reflexivity|]].
    - destruct (KindAt cells z); destruct (KindAt cells (OtherEdge z)); cbn [IsOuter] in *;
        rewrite ?D; auto; intuition congruence.
    - cbn [IsOuter] in O.
      split; destruct (KindAt cells z); destruct (KindAt cells (OtherEdge z));
        try (exfalso; intuition congruence); cbn [FaceSeen ApexSeen]; meets.
  Qed.

  Lemma AcrossFace z : IsPresent cells z = true -> IsOuter (KindAt cells z) z Third = true ->
    exists w', Meet z (FlagAcross cells z Third) w' Third.
  Proof.
    intros P O. exists Third. cbn [FlagAcross]. split; [now rewrite PresentFace|].
    cbn [FlagAcross]. rewrite FaceTwice.
    pose proof (KindTells cells z) as T. pose proof (KindTells cells (OtherFace z)) as T'.
    rewrite EdgeUsedByFace in T'.
    assert (A : EdgeIsUsed cells z = true -> AcrossExists cells z = true).
    { intros U. apply (EdgeUsed cells Balance z 1 0); [exact U | lia ..]. }
    assert (A' : EdgeIsUsed cells z = true -> AcrossExists cells (OtherFace z) = true).
    { intros U. unfold AcrossExists. rewrite LevelByFace, CellByFace.
      apply (EdgeUsed cells Balance z 0 1); [exact U | lia ..]. }
    split; [|split; [reflexivity|]].
    - now destruct (KindAt cells (OtherFace z)).
    - destruct (EdgeIsUsed cells z);
        [rewrite (A eq_refl) in T; rewrite (A' eq_refl) in T'|];
        split; destruct (KindAt cells z); destruct (KindAt cells (OtherFace z));
        try (exfalso; intuition congruence); cbn [FaceSeen ApexSeen];
        try (destruct (IsOffDiagonal z)); try (destruct (IsOffDiagonal (OtherFace z)));
        meets.
  Qed.

  Lemma AcrossCell z : IsPresent cells z = true -> IsOuter (KindAt cells z) z Fourth = true ->
    exists w', Meet z (FlagAcross cells z Fourth) w' Fourth.
  Proof.
    intros P O. cbn [FlagAcross].
    destruct (cells (LevelOf z) (CellSeen z 1 0 0)) eqn:A.
    - destruct (IsPresent cells (OtherCell z)) eqn:Q.
      + pose proof (proj1 (proj1 (PresentTells cells z) P)) as H.
        exists Fourth. split; [exact Q|]. rewrite (KindByCell cells z H A).
        cbn [FlagAcross]. rewrite LevelByCell, CellByCell. change (1 - 1) with 0.
        rewrite H, CellTwice, P.
        pose proof (KindTells cells z) as T. unfold AcrossExists in T.
        split; [|split; [reflexivity|]].
        * destruct (KindAt cells z); exact O.
        * split; destruct (KindAt cells z); try discriminate O; try congruence;
            cbn [FaceSeen ApexSeen]; meets.
      + assert (K : KindAt cells z = QuarterTet).
        { pose proof (KindTells cells z) as T. unfold AcrossExists in T.
          destruct (KindAt cells z) eqn:K; try discriminate O; [|reflexivity | congruence].
          rewrite (CellPresent cells z P) in Q by (rewrite K; auto). discriminate Q. }
        destruct (QuarterLevel cells z K) as [l L].
        destruct (proj2 (FinerInOtherThere cells Balance z l L)) as [P' K']; [auto|].
        exists Fourth. split; [exact P'|]. rewrite K, K'. cbn [FlagAcross].
        split; [reflexivity|].
        split; [|split; [now apply (FinerInOtherFace z l)
                        | now apply (FinerInOtherSides z l)]].
        pose proof (KindTells cells (FinerInOther z)) as T. rewrite K' in T.
        unfold AcrossExists in T. rewrite T.
        destruct (AheadInOther z l L) as (_ & E & C).
        now rewrite (PyramidNameKept _ E C), (CoarserOfOther z l L).
    - assert (K : KindAt cells z = PyramidTet) by now apply PyramidOf.
      pose proof (BesideName cells Balance z P) as (P0 & K0 & T0).
      rewrite K in P0, K0, T0. cbn [NamingFlag] in P0, K0, T0.
      set (x0 := WithCornerOffDiagonal z) in *.
      destruct (PyramidNameTells z) as [E C]. fold x0 in E, C.
      pose proof (LevelOfCoarser x0) as L. set (y := Coarser x0) in *.
      assert (base : forall w',
        SameVertices (FaceSeen QuarterTet y w') (FaceSeen PyramidTet x0 Fourth) ->
        LiesBetween (FaceSeen QuarterTet y w') (ApexSeen QuarterTet y w')
          (ApexSeen PyramidTet x0 Fourth) ->
        SameVertices (FaceSeen PyramidTet z Fourth) (FaceSeen QuarterTet y w') /\
        LiesBetween (FaceSeen PyramidTet z Fourth) (ApexSeen PyramidTet z Fourth)
          (ApexSeen QuarterTet y w')).
      { intros w' S D.
        assert (S' : SameVertices (FaceSeen PyramidTet z Fourth) (FaceSeen QuarterTet y w'))
          by (apply (SameTrans _ (FaceSeen PyramidTet x0 Fourth));
              [apply NameFace | now apply SameSym]).
        split; [exact S'|]. apply (BetweenSame _ _ _ _ (SameSym _ _ S')), BetweenSwap.
        cbn [ApexSeen]. rewrite <- NameApex. exact D. }
      destruct (AheadAtFace x0) eqn:F.
      + pose proof (CellOfCoarser x0 E C F) as B. fold y in B.
        destruct (proj1 (FinerInCellThere cells Balance y _ L)) as (P' & K' & Q'); [rewrite B; auto|].
        exists First. split; [exact P'|]. rewrite K, K'. cbn [FlagAcross]. rewrite Q', B.
        split; [reflexivity|]. split; [exact T0|].
        pose proof (FinerInCellFace y _ L) as S. pose proof (FinerInCellSides y _ L) as D.
        rewrite B in S, D. apply base; assumption.
      + pose proof (OtherOfCoarser x0 E C F) as B. fold y in B.
        destruct (proj1 (FinerInOtherThere cells Balance y _ L)) as (P' & K' & Q'); [rewrite B; auto|].
        exists Fourth. split; [exact P'|]. rewrite K, K'. cbn [FlagAcross].
        pose proof (KindTells cells y) as T. rewrite K' in T. destruct T as [T _].
        unfold AcrossExists in T. rewrite T, Q', B.
        split; [reflexivity|]. split; [exact T0|].
        pose proof (FinerInOtherFace y _ L) as S. pose proof (FinerInOtherSides y _ L) as D.
        rewrite B in S, D. apply base; assumption.
  Qed.

  Lemma FlagsMeet z w : IsPresent cells z = true -> IsOuter (KindAt cells z) z w = true ->
    exists w', Meet z (FlagAcross cells z w) w' w.
  Proof.
    destruct w; [apply AcrossCorner | apply AcrossEdge | apply AcrossFace | apply AcrossCell].
  Qed.
End Across.
