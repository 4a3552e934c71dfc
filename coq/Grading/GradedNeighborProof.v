(** * Neighbours share their faces, and know each other: proofs

    What is across from a flag does not depend on the tetrahedron that has it,
    but for which of its points the face has.  So a face is looked at from one of
    its flags, and the neighbour's face from the flag across. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Mesh.Method.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet
  Grading.Surface Grading.GradingSpec.
From Certet Require Import Grading.FlagProof Grading.BalanceProof
  Grading.PartitionProof Grading.GradedVolumeProof.
Open Scope Z_scope.

(** ** Faces as flags see them *)

(** Whether the flag's side across from one of its points is on a face of its
    tetrahedron, *)
Definition IsOuter (kind : GradedKind) (x : Flag) (w : Place) : bool :=
  match kind, w with
  | (EdgeHalfTet | QuarterTet), First => true
  | _, First => false
  | PyramidTet, Second => negb (IsOffDiagonal x)
  | _, Second | _, Third => true
  | (FaceHalfTet | QuarterTet | PyramidTet), Fourth => true
  | _, Fourth => false
  end.

(** and the vertices of that face. *)
Definition FaceSeen (kind : GradedKind) (x : Flag) (w : Place) : list Coord3 :=
  let p := PointSeen x in
  match w, kind with
  | First, QuarterTet => [p 1 1 0; p 1 0 0; p 0 0 0]
  | First, _ => [p 1 1 0; p 2 0 0; p 0 0 0]
  | Second, (BccTet | EdgeHalfTet) => [p 1 1 1; p 0 0 0; p 2 0 0]
  | Second, (FaceHalfTet | QuarterTet) => [p 1 1 1; p 1 0 0; p 0 0 0]
  | Second, PyramidTet => [p 1 1 1; p 1 (-1) (-1); p 0 0 0]
  | Third, (EdgeHalfTet | QuarterTet) => [p 1 1 1; p 1 1 0; p 0 0 0]
  | Third, _ => [p 1 1 1; p 1 1 (-1); p 0 0 0]
  | Fourth, QuarterTet => [p 1 1 1; p 1 1 0; p 1 0 0]
  | Fourth, PyramidTet =>
      if IsOffDiagonal x then [p 1 1 1; p 1 1 (-1); p 1 (-1) 1]
      else [p 1 1 1; p 1 1 (-1); p 1 (-1) (-1)]
  | Fourth, _ => [p 1 1 1; p 1 1 (-1); p 1 0 0]
  end.

Lemma SameRefl l : SameVertices l l.
Proof. intros v. reflexivity. Qed.
Lemma SameSym l m : SameVertices l m -> SameVertices m l.
Proof. intros H v. symmetry. apply H. Qed.
Lemma SameTrans l m n : SameVertices l m -> SameVertices m n -> SameVertices l n.
Proof. intros H K v. rewrite (H v). apply K. Qed.

Ltac shared :=
  repeat (progress rewrite ?SeenByCorner, ?SeenByEdge, ?SeenByFace, ?SeenByCell);
  cbn [Z.opp Z.sub Z.add Z.pos_sub Pos.pred_double];
  intros v; cbn [In]; tauto.

(** The vertex across from it. *)
Definition ApexSeen (kind : GradedKind) (x : Flag) (w : Place) : Coord3 :=
  let p := PointSeen x in
  match w, kind with
  | First, _ => p 1 1 1
  | Second, (EdgeHalfTet | QuarterTet) => p 1 1 0
  | Second, _ => p 1 1 (-1)
  | Third, (BccTet | EdgeHalfTet) => p 2 0 0
  | Third, (FaceHalfTet | QuarterTet) => p 1 0 0
  | Third, PyramidTet => if IsOffDiagonal x then p 1 (-1) 1 else p 1 (-1) (-1)
  | Fourth, _ => p 0 0 0
  end.

Lemma BetweenSwap face a b : LiesBetween face a b -> LiesBetween face b a.
Proof. intros H p q r I J K D E F. rewrite Z.mul_comm. now apply H. Qed.

Lemma BetweenSame face face' a b : SameVertices face face' ->
  LiesBetween face a b -> LiesBetween face' a b.
Proof. intros S H p q r I J K. apply H; now apply S. Qed.

(** In whatever order three points are taken, the volumes have the same signs, or
    both the other. *)
Lemma TurnVolume a b c d : SixVolume b c a d = SixVolume a b c d.
Proof.
  destruct a, b, c, d. unfold SixVolume, Normal. cbn [Difference Cross Dot]. ring.
Qed.

Lemma SwapVolume a b c d : SixVolume b a c d = - SixVolume a b c d.
Proof.
  destruct a, b, c, d. unfold SixVolume, Normal. cbn [Difference Cross Dot]. ring.
Qed.

Lemma Between a b c d e : SixVolume a b c d * SixVolume a b c e < 0 ->
  LiesBetween [a; b; c] d e.
Proof.
  intros H.
  assert (T : forall p q r, SixVolume p q r d * SixVolume p q r e < 0 ->
    SixVolume q r p d * SixVolume q r p e < 0) by (intros p q r V; now rewrite (TurnVolume p q r d), (TurnVolume p q r e)).
  assert (S : forall p q r, SixVolume p q r d * SixVolume p q r e < 0 ->
    SixVolume q p r d * SixVolume q p r e < 0).
  { intros p q r V. rewrite (SwapVolume p q r d), (SwapVolume p q r e). lia. }
  intros p q r [<- | [<- | [<- | []]]] [<- | [<- | [<- | []]]] [<- | [<- | [<- | []]]] ? ? ?;
    try match goal with D : ?v <> ?v |- _ => now destruct D end.
  - exact H.
  - exact (T b a c (S a b c H)).
  - exact (S a b c H).
  - exact (T a b c H).
  - exact (T b c a (T a b c H)).
  - exact (T a c b (T b a c (S a b c H))).
Qed.

Ltac sides :=
  repeat (progress rewrite ?SeenByCorner, ?SeenByEdge, ?SeenByFace, ?SeenByCell);
  cbn [Z.opp Z.sub Z.add Z.pos_sub Pos.pred_double];
  apply Between, ApartSeen; vm_compute; reflexivity.

Ltac meets :=
  lazymatch goal with
  | |- LiesBetween _ _ _ => sides
  | |- SameVertices _ _ => shared
  end.

Ltac apex :=
  repeat (progress rewrite ?SeenByCorner, ?SeenByEdge, ?SeenByFace, ?SeenByCell);
  reflexivity.

(** Every face is seen by a flag. *)
Lemma FlagSeesFace cells kind x i : InGradedMesh cells (GTId kind x) ->
  let '(z, w) := FlagAtFace (GTId kind x) i in
  In z (FlagsOf (GTId kind x)) /\ IsOuter kind z w = true /\
  SameVertices (GradedFace (GTId kind x) i) (FaceSeen kind z w) /\
  GradedVertexAt (GTId kind x) i = ApexSeen kind z w.
Proof.
  intros M. destruct (NamedBy _ _ _ M) as (_ & _ & N).
  assert (off : kind = PyramidTet -> IsOffDiagonal x = true).
  { intros ->. exact (NameOffDiagonal x N). }
  unfold GradedFace, GradedVertexAt.
  destruct kind, i; cbn [FlagAtFace FlagsOf IsOuter FaceSeen ApexSeen Others
    GradedVertices];
    rewrite ?OffDiagonalByCorner, ?OffDiagonalByEdge, ?off by reflexivity; cbn [negb];
    try (destruct (IsUpperEdge x)); cbn [Pick];
    (split; [cbn [In]; tauto | split; [reflexivity | split; [shared | apex]]]).
Qed.

(** ** The flag across *)

Section Across.
  Variable cells : CellSet.
  Hypothesis Balance : IsBalanced cells.

  Local Notation across := (FlagAcross cells).
  Local Notation present := (IsPresent cells).
  Local Notation kind := (KindAt cells).

  (** The two flags see the same face. *)
  Definition Meet (z y : Flag) (w' : Place) (w : Place) : Prop :=
    present y = true /\ IsOuter (kind y) y w' = true /\
    TetOfFlag cells (across y w') = TetOfFlag cells z /\
    SameVertices (FaceSeen (kind z) z w) (FaceSeen (kind y) y w') /\
    LiesBetween (FaceSeen (kind z) z w) (ApexSeen (kind z) z w) (ApexSeen (kind y) y w').

  Lemma QuarterOf x : AcrossExists cells x = true -> FaceIsUsed cells x = true ->
    EdgeIsUsed cells x = true -> kind x = QuarterTet.
  Proof.
    unfold AcrossExists, FaceIsUsed, EdgeIsUsed, KindAt. now intros -> -> ->.
  Qed.

  Lemma PyramidOf x : AcrossExists cells x = false -> kind x = PyramidTet.
  Proof. unfold AcrossExists, KindAt. now intros ->. Qed.

  Lemma QuarterLevel x : kind x = QuarterTet -> exists l, LevelOf x = S l.
  Proof.
    intros K. pose proof (KindTells cells x) as T. rewrite K in T.
    destruct T as (_ & T & _). unfold FaceIsUsed in T.
    destruct (LevelOf x) as [|l]; [discriminate T | now exists l].
  Qed.

  (** A quarter, and the pyramid of a child beside it. *)
  Lemma FinerInCellThere x l : LevelOf x = S l ->
    (present (FinerInCell x) = true /\ kind (FinerInCell x) = PyramidTet) <->
    (present x = true /\ kind x = QuarterTet /\ present (OtherCorner x) = false).
  Proof.
    intros L. set (y := FinerInCell x).
    assert (Ly : LevelOf y = l) by now apply FinerInCellLevel.
    assert (Cy : forall i j k, CellSeen y i j k = ChildSeen x (1 + j) (1 - k) i)
      by (intros; now apply (CellByFinerInCell x l)).
    assert (H : forall i j k, HasChild cells (LevelOf x) (ChildSeen x i j k)
                = cells l (ChildSeen x i j k)) by (intros; now rewrite L).
    split.
    - intros [P K]. apply PresentTells in P. destruct P as [E _].
      pose proof (KindTells cells y) as A. rewrite K in A. unfold AcrossExists in A.
      rewrite Ly, Cy in E, A. change (1 + 0) with 1 in E, A. change (1 - 0) with 1 in E, A.
      rewrite <- H in E, A.
      destruct (FaceChild cells Balance x _ _ _ E ltac:(lia) ltac:(lia) ltac:(lia)) as [E0 E1].
      split; [|split].
      + now apply PresentTells.
      + apply QuarterOf; [exact E1 | |]; apply (Used _ _ _ _ _ _ _ _ E); lia.
      + apply not_true_is_false. intros Q. apply PresentCorner in Q. destruct Q. congruence.
    - intros (P & K & Q). pose proof (KindTells cells x) as T. rewrite K in T.
      apply PresentTells in P. destruct P as [E0 E].
      assert (F : HasChild cells (LevelOf x) (ChildSeen x 1 1 0) = true).
      { apply not_false_is_true. intros F. apply not_true_iff_false in Q. apply Q.
        now apply PresentCorner. }
      rewrite H in E, F.
      assert (A : AcrossExists cells y = false) by (unfold AcrossExists; now rewrite Ly, Cy).
      split; [|now apply PyramidOf]. apply PresentTells. rewrite Ly, Cy. split; [exact F|].
      apply not_true_is_false. intros G. rewrite <- Ly in G.
      apply (FaceChild cells Balance) in G; [|lia ..]. unfold AcrossExists in A.
      destruct G. congruence.
  Qed.

  Lemma FinerInOtherThere x l : LevelOf x = S l ->
    (present (FinerInOther x) = true /\ kind (FinerInOther x) = PyramidTet) <->
    (present x = true /\ kind x = QuarterTet /\ present (OtherCell x) = false).
  Proof.
    intros L. set (y := FinerInOther x).
    assert (Ly : LevelOf y = l) by now apply FinerInOtherLevel.
    assert (Cy : forall i j k, CellSeen y i j k = ChildSeen x (2 - i) (1 + j) (1 - k))
      by (intros; now apply (CellByFinerInOther x l)).
    assert (H : forall i j k, HasChild cells (LevelOf x) (ChildSeen x i j k)
                = cells l (ChildSeen x i j k)) by (intros; now rewrite L).
    split.
    - intros [P K]. apply PresentTells in P. destruct P as [E _].
      pose proof (KindTells cells y) as A. rewrite K in A. unfold AcrossExists in A.
      rewrite Ly, Cy in E, A. change (1 + 0) with 1 in E, A. change (1 - 0) with 1 in E, A.
      change (2 - 0) with 2 in E. change (2 - 1) with 1 in A.
      rewrite <- H in E, A.
      destruct (FaceChild cells Balance x _ _ _ E ltac:(lia) ltac:(lia) ltac:(lia)) as [E0 E1].
      split; [|split].
      + now apply PresentTells.
      + apply QuarterOf; [exact E1 | |]; apply (Used _ _ _ _ _ _ _ _ E); lia.
      + apply not_true_is_false. intros Q. apply PresentCell in Q. destruct Q. congruence.
    - intros (P & K & Q). pose proof (KindTells cells x) as T. rewrite K in T.
      destruct T as (E1 & _). unfold AcrossExists in E1.
      apply PresentTells in P. destruct P as [E0 E].
      assert (F : HasChild cells (LevelOf x) (ChildSeen x 2 1 1) = true).
      { apply not_false_is_true. intros F. apply not_true_iff_false in Q. apply Q.
        now apply PresentCell. }
      rewrite H in E, F.
      assert (A : AcrossExists cells y = false) by (unfold AcrossExists; now rewrite Ly, Cy).
      split; [|now apply PyramidOf]. apply PresentTells. rewrite Ly, Cy. split; [exact F|].
      apply not_true_is_false. intros G. rewrite <- Ly in G.
      apply (FaceChild cells Balance) in G; [|lia ..]. unfold AcrossExists in A.
      destruct G. congruence.
  Qed.

  (** The faces of the two. *)
  Lemma FinerInCellFace x l : LevelOf x = S l ->
    SameVertices (FaceSeen QuarterTet x First) (FaceSeen PyramidTet (FinerInCell x) Fourth).
  Proof.
    intros L. destruct (AheadInCell x l L) as (_ & E & C).
    cbn [FaceSeen]. unfold IsOffDiagonal. rewrite E, C. cbn [xorb].
    rewrite <- (SeenByFinerInCell x l 1 1 0 L), <- (SeenByFinerInCell x l 1 0 0 L),
      <- (SeenByFinerInCell x l 0 0 0 L).
    intros v; cbn; tauto.
  Qed.

  Lemma FinerInOtherFace x l : LevelOf x = S l ->
    SameVertices (FaceSeen QuarterTet x Fourth) (FaceSeen PyramidTet (FinerInOther x) Fourth).
  Proof.
    intros L. destruct (AheadInOther x l L) as (_ & E & C).
    cbn [FaceSeen]. unfold IsOffDiagonal. rewrite E, C. cbn [xorb].
    rewrite <- (SeenByFinerInOther x l 1 1 1 L), <- (SeenByFinerInOther x l 1 1 0 L),
      <- (SeenByFinerInOther x l 1 0 0 L).
    intros v; cbn; tauto.
  Qed.

  Lemma FinerInCellSides x l : LevelOf x = S l ->
    LiesBetween (FaceSeen QuarterTet x First) (ApexSeen QuarterTet x First)
      (ApexSeen PyramidTet (FinerInCell x) Fourth).
  Proof.
    intros L. cbn [FaceSeen ApexSeen].
    rewrite <- (SeenByFinerInCell x l 1 1 0 L), <- (SeenByFinerInCell x l 1 0 0 L),
      <- (SeenByFinerInCell x l 0 0 0 L), <- (SeenByFinerInCell x l 1 1 1 L).
    sides.
  Qed.

  Lemma FinerInOtherSides x l : LevelOf x = S l ->
    LiesBetween (FaceSeen QuarterTet x Fourth) (ApexSeen QuarterTet x Fourth)
      (ApexSeen PyramidTet (FinerInOther x) Fourth).
  Proof.
    intros L. cbn [FaceSeen ApexSeen].
    rewrite <- (SeenByFinerInOther x l 1 1 1 L), <- (SeenByFinerInOther x l 1 1 0 L),
      <- (SeenByFinerInOther x l 1 0 0 L), <- (SeenByFinerInOther x l 0 0 0 L).
    sides.
  Qed.

  Lemma NameApex x : PointSeen (WithCornerOffDiagonal x) 0 0 0 = PointSeen x 0 0 0.
  Proof.
    unfold WithCornerOffDiagonal. cbv zeta.
    destruct (IsOffDiagonal x); destruct (AheadAtEdge _); apex.
  Qed.

  Lemma NameFace x :
    SameVertices (FaceSeen PyramidTet x Fourth)
      (FaceSeen PyramidTet (WithCornerOffDiagonal x) Fourth).
  Proof.
    destruct (PyramidNameTells x) as [E C]. cbn [FaceSeen].
    assert (IsOffDiagonal (WithCornerOffDiagonal x) = true) as ->
      by (unfold IsOffDiagonal; now rewrite E, C).
    clear E C. unfold WithCornerOffDiagonal. cbv zeta.
    destruct (IsOffDiagonal x); destruct (AheadAtEdge _); shared.
  Qed.

  (** ** Across each of a flag's four sides *)

  Lemma AcrossCorner z : present z = true -> IsOuter (kind z) z First = true ->
    exists w', Meet z (across z First) w' First.
  Proof.
    intros P O. cbn [FlagAcross]. destruct (present (OtherCorner z)) eqn:Q.
    - exists First. split; [exact Q|]. rewrite KindByCorner. cbn [FlagAcross].
      rewrite CornerTwice, P. split; [|split].
      + destruct (kind z); exact O || discriminate O.
      + reflexivity.
      + split; destruct (kind z); try discriminate O; cbn [FaceSeen ApexSeen];
          [shared | shared | sides | sides].
    - assert (K : kind z = QuarterTet).
      { destruct (kind z) eqn:K; try discriminate O; [|reflexivity].
        rewrite (CornerPresent cells Balance z P) in Q by (rewrite K; discriminate).
        discriminate Q. }
      destruct (QuarterLevel z K) as [l L].
      destruct (proj2 (FinerInCellThere z l L)) as [P' K']; [auto|].
      exists Fourth. split; [exact P'|]. rewrite K, K'. cbn [FlagAcross].
      split; [reflexivity|].
      split; [|split; [now apply (FinerInCellFace z l) | now apply (FinerInCellSides z l)]].
      pose proof (KindTells cells (FinerInCell z)) as T. rewrite K' in T.
      unfold AcrossExists in T. rewrite T.
      destruct (AheadInCell z l L) as (_ & E & C).
      now rewrite (PyramidNameKept _ E C), (CoarserOfCell z l L).
  Qed.

  Lemma AcrossEdge z : present z = true -> IsOuter (kind z) z Second = true ->
    exists w', Meet z (across z Second) w' Second.
  Proof.
    intros P O. exists Second. cbn [FlagAcross]. split; [now rewrite PresentEdge|].
    cbn [FlagAcross]. rewrite EdgeTwice.
    pose proof (KindTells cells z) as T. pose proof (KindTells cells (OtherEdge z)) as T'.
    rewrite AcrossByEdge, FaceUsedByEdge in T'. pose proof (OffDiagonalByEdge z) as D.
    split; [|split; [reflexivity|]].
    - destruct (kind z); destruct (kind (OtherEdge z)); cbn [IsOuter] in *;
        rewrite ?D; auto; intuition congruence.
    - cbn [IsOuter] in O.
      split; destruct (kind z); destruct (kind (OtherEdge z));
        try (exfalso; intuition congruence); cbn [FaceSeen ApexSeen]; meets.
  Qed.

  Lemma AcrossFace z : present z = true -> IsOuter (kind z) z Third = true ->
    exists w', Meet z (across z Third) w' Third.
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
    - now destruct (kind (OtherFace z)).
    - destruct (EdgeIsUsed cells z);
        [rewrite (A eq_refl) in T; rewrite (A' eq_refl) in T'|];
        split; destruct (kind z); destruct (kind (OtherFace z));
        try (exfalso; intuition congruence); cbn [FaceSeen ApexSeen];
        try (destruct (IsOffDiagonal z)); try (destruct (IsOffDiagonal (OtherFace z)));
        meets.
  Qed.

  Lemma AcrossCell z : present z = true -> IsOuter (kind z) z Fourth = true ->
    exists w', Meet z (across z Fourth) w' Fourth.
  Proof.
    intros P O. cbn [FlagAcross].
    destruct (cells (LevelOf z) (CellSeen z 1 0 0)) eqn:A.
    - destruct (present (OtherCell z)) eqn:Q.
      + pose proof (proj1 (proj1 (PresentTells cells z) P)) as H.
        exists Fourth. split; [exact Q|]. rewrite (KindByCell cells z H A).
        cbn [FlagAcross]. rewrite LevelByCell, CellByCell. change (1 - 1) with 0.
        rewrite H, CellTwice, P.
        pose proof (KindTells cells z) as T. unfold AcrossExists in T.
        split; [|split; [reflexivity|]].
        * destruct (kind z); exact O.
        * split; destruct (kind z); try discriminate O; try congruence;
            cbn [FaceSeen ApexSeen]; meets.
      + assert (K : kind z = QuarterTet).
        { pose proof (KindTells cells z) as T. unfold AcrossExists in T.
          destruct (kind z) eqn:K; try discriminate O; [|reflexivity | congruence].
          rewrite (CellPresent cells z P) in Q by (rewrite K; auto). discriminate Q. }
        destruct (QuarterLevel z K) as [l L].
        destruct (proj2 (FinerInOtherThere z l L)) as [P' K']; [auto|].
        exists Fourth. split; [exact P'|]. rewrite K, K'. cbn [FlagAcross].
        split; [reflexivity|].
        split; [|split; [now apply (FinerInOtherFace z l)
                        | now apply (FinerInOtherSides z l)]].
        pose proof (KindTells cells (FinerInOther z)) as T. rewrite K' in T.
        unfold AcrossExists in T. rewrite T.
        destruct (AheadInOther z l L) as (_ & E & C).
        now rewrite (PyramidNameKept _ E C), (CoarserOfOther z l L).
    - assert (K : kind z = PyramidTet) by now apply PyramidOf.
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
        destruct (proj1 (FinerInCellThere y _ L)) as (P' & K' & Q'); [rewrite B; auto|].
        exists First. split; [exact P'|]. rewrite K, K'. cbn [FlagAcross]. rewrite Q', B.
        split; [reflexivity|]. split; [exact T0|].
        pose proof (FinerInCellFace y _ L) as S. pose proof (FinerInCellSides y _ L) as D.
        rewrite B in S, D. apply base; assumption.
      + pose proof (OtherOfCoarser x0 E C F) as B. fold y in B.
        destruct (proj1 (FinerInOtherThere y _ L)) as (P' & K' & Q'); [rewrite B; auto|].
        exists Fourth. split; [exact P'|]. rewrite K, K'. cbn [FlagAcross].
        pose proof (KindTells cells y) as T. rewrite K' in T. destruct T as [T _].
        unfold AcrossExists in T. rewrite T, Q', B.
        split; [reflexivity|]. split; [exact T0|].
        pose proof (FinerInOtherFace y _ L) as S. pose proof (FinerInOtherSides y _ L) as D.
        rewrite B in S, D. apply base; assumption.
  Qed.

  Lemma FlagsMeet z w : present z = true -> IsOuter (kind z) z w = true ->
    exists w', Meet z (across z w) w' w.
  Proof.
    destruct w; [apply AcrossCorner | apply AcrossEdge | apply AcrossFace | apply AcrossCell].
  Qed.

  (** ** All flags at a face have the same neighbour across *)

  Lemma PyramidAround x : present x = true -> kind x = PyramidTet ->
    IsOffDiagonal x = true ->
    TetOfFlag cells (OtherEdge (OtherCorner (OtherEdge x)))
    = TetOfFlag cells (OtherEdge (OtherCorner x)).
  Proof.
    intros P K off.
    assert (Kc : forall y, kind y = PyramidTet -> kind (OtherCorner y) = PyramidTet)
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
  Lemma EdgeMates x : present x = true -> kind x = BccTet \/ kind x = EdgeHalfTet ->
    TetOfFlag cells (across (OtherCell x) Second) = TetOfFlag cells (across x Second).
  Proof.
    intros P K. cbn [FlagAcross]. rewrite CellThenEdge. apply TetByCell.
    - now rewrite PresentEdge.
    - pose proof (KindTells cells x) as T. pose proof (KindTells cells (OtherEdge x)) as T'.
      rewrite AcrossByEdge, FaceUsedByEdge in T'.
      destruct K as [K | K]; rewrite K in T;
        destruct (kind (OtherEdge x)); auto; exfalso; intuition congruence.
  Qed.

  Lemma FaceMates x :
    kind x = BccTet \/ kind x = FaceHalfTet \/ kind x = PyramidTet ->
    TetOfFlag cells (across (OtherCorner x) Third) = TetOfFlag cells (across x Third).
  Proof.
    intros K. cbn [FlagAcross]. rewrite CornerThenFace. apply TetByCorner.
    pose proof (KindTells cells x) as T. pose proof (KindTells cells (OtherFace x)) as T'.
    rewrite EdgeUsedByFace in T'.
    assert (A : EdgeIsUsed cells x = true -> AcrossExists cells x = true).
    { intros U. apply (EdgeUsed cells Balance x 1 0); [exact U | lia ..]. }
    destruct (EdgeIsUsed cells x);
      [rewrite (A eq_refl) in T|];
      destruct K as [K | [K | K]]; rewrite K in T;
      destruct (kind (OtherFace x)); auto; exfalso; intuition congruence.
  Qed.

  Lemma CornerMates x : present x = true -> kind x = EdgeHalfTet ->
    TetOfFlag cells (across (OtherCell x) First) = TetOfFlag cells (across x First).
  Proof.
    intros P K. cbn [FlagAcross].
    assert (Pc : present (OtherCorner x) = true)
      by (apply (CornerPresent cells Balance); [exact P | rewrite K; discriminate]).
    assert (Kc : kind (OtherCorner x) = EdgeHalfTet) by now rewrite KindByCorner.
    assert (Ps : present (OtherCell (OtherCorner x)) = true)
      by (apply (CellPresent cells); auto).
    rewrite Pc, <- CornerThenCell, Ps. apply TetByCell; auto.
  Qed.

  Lemma CellMates x : present x = true -> kind x = FaceHalfTet ->
    TetOfFlag cells (across (OtherCorner x) Fourth) = TetOfFlag cells (across x Fourth).
  Proof.
    intros P K. cbn [FlagAcross].
    assert (Pc : present (OtherCorner x) = true)
      by (apply (CornerPresent cells Balance); [exact P | rewrite K; discriminate]).
    assert (Kc : kind (OtherCorner x) = FaceHalfTet) by now rewrite KindByCorner.
    assert (Ps : present (OtherCell x) = true) by (apply (CellPresent cells); auto).
    assert (Psc : present (OtherCell (OtherCorner x)) = true)
      by (apply (CellPresent cells); auto).
    pose proof (KindTells cells x) as T. rewrite K in T. destruct T as [A _].
    unfold AcrossExists in A. rewrite LevelByCorner, CellByCorner. change (- 0) with 0.
    rewrite A, Ps, Psc, CornerThenCell. apply TetByCorner.
    rewrite KindByCell; [auto | now apply PresentTells | exact A].
  Qed.

  Lemma BaseMates x y : kind x = PyramidTet -> kind y = PyramidTet ->
    WithCornerOffDiagonal y = WithCornerOffDiagonal x ->
    across y Fourth = across x Fourth.
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
      GradedNeighbor cells (GTId knd x) i = TetOfFlag cells (across z w).
  Proof.
    intros M I O. destruct (NamedBy _ _ _ M) as (P & K & N).
    unfold GradedNeighbor, GradedFace, GradedVertexAt.
    destruct knd; cbn [FlagsOf In] in I.
    - (* The lattice's own. *)
      pose proof (BesideCorner cells Balance x P ltac:(auto)) as (Pc & Kc & _).
      pose proof (BesideCell cells x P ltac:(auto)) as (Ps & Ks & _).
      rewrite K in Kc, Ks.
      assert (S : forall y, In y [x; OtherCell x] ->
        TetOfFlag cells (across (OtherCorner y) Third) = TetOfFlag cells (across y Third))
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
        across y Fourth = across x Fourth).
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
End Across.

(** ** The theorems *)

Lemma NeighborMeets cells : IsOctree cells ->
  forall tid i, InGradedMesh cells tid ->
    InGradedMesh cells (GradedNeighbor cells tid i) /\
    exists j,
      SameVertices (GradedFace tid i) (GradedFace (GradedNeighbor cells tid i) j) /\
      LiesBetween (GradedFace tid i) (GradedVertexAt tid i)
        (GradedVertexAt (GradedNeighbor cells tid i) j) /\
      GradedNeighbor cells (GradedNeighbor cells tid i) j = tid.
Proof.
  intros [Balance _] [knd x] i M.
  pose proof (FlagSeesFace cells knd x i M) as S.
  unfold GradedNeighbor at 1 2 3 5.
  destruct (FlagAtFace (GTId knd x) i) as [z w]. destruct S as (I & O & F & A).
  pose proof (FlagBeside cells Balance _ _ _ M I) as (P & K & T).
  destruct (NamedBy _ _ _ M) as (_ & Kx & _). rewrite Kx in K. clear Kx. subst knd.
  destruct M as [_ N]. rewrite N in T.
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

Theorem GradedFacesCorrect :
  forall cells tid i, IsOctree cells -> InGradedMesh cells tid ->
    let nei := GradedNeighbor cells tid i in
    InGradedMesh cells nei /\
    exists j,
      SameVertices (GradedFace tid i) (GradedFace nei j) /\
      LiesBetween (GradedFace tid i) (GradedVertexAt tid i) (GradedVertexAt nei j).
Proof.
  intros cells tid i octree M nei.
  destruct (NeighborMeets cells octree tid i M) as (M' & j & F & D & _). eauto.
Qed.

Theorem GradedNeighborInvolution :
  forall cells tid i, IsOctree cells -> InGradedMesh cells tid ->
    let nei := GradedNeighbor cells tid i in
    exists j,
      SameVertices (GradedFace tid i) (GradedFace nei j) /\
      GradedNeighbor cells nei j = tid.
Proof.
  intros cells tid i octree M nei.
  destruct (NeighborMeets cells octree tid i M) as (_ & j & F & _ & N). eauto.
Qed.
