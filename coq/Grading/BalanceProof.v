(** * What balance says of the cells around a flag: proofs *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Grading.Octree Grading.Flag
  Grading.GradedTet Grading.FlagProof.
Open Scope Z_scope.

(** ** Used points *)

Lemma InCube o a b c :
  In (Arrange o a b c) UnitCube <-> 0 <= a <= 1 /\ 0 <= b <= 1 /\ 0 <= c <= 1.
Proof.
  split.
  - intros I. assert (In (Arrange o a b c) UnitCube) as J by exact I.
    destruct o; cbn in J;
      repeat (destruct J as [J | J]; [injection J as <- <- <-; lia|]); destruct J.
  - intros (A & B & C).
    assert (a = 0 \/ a = 1) as [-> | ->] by lia;
      assert (b = 0 \/ b = 1) as [-> | ->] by lia;
      assert (c = 0 \/ c = 1) as [-> | ->] by lia;
      destruct o; cbn; tauto.
Qed.

(** A point is used exactly when one of eight children, as seen, exists. *)
Lemma UsedSeen cells x i j k :
  IsUsed cells (LevelOf x) (PointInHalfSides x i j k) = true <->
  exists i' j' k', 0 <= i' <= 1 /\ 0 <= j' <= 1 /\ 0 <= k' <= 1 /\
    HasChild cells (LevelOf x) (ChildSeen x (i + i') (j + j') (k + k')) = true.
Proof.
  destruct x as [[|l] v o s t u]; destruct (Arranged o v) as (a & b & c & ->);
    cbn [LevelOf IsUsed HasChild].
  { split; [discriminate | intros (? & ? & ? & _ & _ & _ & [=])]. }
  rewrite existsb_exists. arrange.
  pose (back := fun (s : bool) (d : Z) => if s then 1 - d else d). split.
  - intros (d & I & E). destruct (Arranged o d) as (da & db & dc & ->).
    apply InCube in I. destruct I as (A & B & C).
    exists (back s da), (back t db), (back u dc).
    repeat split; try (subst back; cbv beta; destruct s, t, u; lia).
    rewrite <- E. f_equal. arrange. rewrite DifferenceArrange. apply SameArrange; subst back; cbv beta; signs.
  - intros (da & db & dc & A & B & C & E).
    exists (Arrange o (back s da) (back t db) (back u dc)).
    split; [apply InCube; subst back; cbv beta; signs; lia|].
    rewrite <- E. f_equal. arrange. rewrite DifferenceArrange. apply SameArrange; subst back; cbv beta; signs.
Qed.

(** ** Balance *)

Section Balanced.
  Variable cells : CellSet.
  Hypothesis Balance : IsBalanced cells.

  Lemma HalfSeen s a n d :
    (2 * a + ChildAlong s n + Signed s d) / 2 = a + Signed s ((n + d) / 2).
  Proof. destruct s; cbn [ChildAlong Signed]; euclid. Qed.

  Lemma StepArrange o a b c : -1 <= a <= 1 -> -1 <= b <= 1 -> -1 <= c <= 1 ->
    a * b * c = 0 -> WithinFaceOrEdge (Arrange o a b c).
  Proof. destruct o; cbn; intros; repeat split; try lia. Qed.

  Lemma SignedWithin s d : -1 <= d <= 1 -> -1 <= Signed s d <= 1.
  Proof. destruct s; cbn; lia. Qed.

  (** With a child exist the cells around it, one level up. *)
  Lemma CellsAround x i j k di dj dk :
    HasChild cells (LevelOf x) (ChildSeen x i j k) = true ->
    -1 <= di <= 1 -> -1 <= dj <= 1 -> -1 <= dk <= 1 ->
    di * dj * dk = 0 ->
    cells (LevelOf x) (CellSeen x ((i + di) / 2) ((j + dj) / 2) ((k + dk) / 2)) = true.
  Proof.
    destruct x as [[|l] v o s t u]; destruct (Arranged o v) as (a & b & c & ->);
      cbn [LevelOf HasChild]; [discriminate|].
    arrange. intros E Bi Bj Bk Z.
    assert (W : WithinFaceOrEdge (Arrange o (Signed s di) (Signed t dj) (Signed u dk)))
      by (apply StepArrange; try (apply SignedWithin; assumption);
            destruct s, t, u; cbn [Signed]; lia).
    pose proof (Balance _ _ _ W E) as P. revert P.
    rewrite TranslateArrange, ParentArrange, !HalfSeen. intros P; exact P.
  Qed.

  (** A cell that exists, one of whose children does not see the other side. *)
  Lemma FaceChild x i j k :
    HasChild cells (LevelOf x) (ChildSeen x i j k) = true ->
    1 <= i <= 2 -> 0 <= j <= 1 -> 0 <= k <= 1 ->
    cells (LevelOf x) (CellSeen x 0 0 0) = true /\
    cells (LevelOf x) (CellSeen x 1 0 0) = true.
  Proof.
    intros E Bi Bj Bk.
    assert (j / 2 = 0) as Hj by (apply Z.div_small; lia).
    assert (k / 2 = 0) as Hk by (apply Z.div_small; lia).
    assert (i = 1 \/ i = 2) as [-> | ->] by lia.
    - split.
      + pose proof (CellsAround x 1 j k 0 0 0 E) as P. rewrite !Z.add_0_r, Hj, Hk in P.
        apply P; lia.
      + pose proof (CellsAround x 1 j k 1 0 0 E) as P. rewrite !Z.add_0_r, Hj, Hk in P.
        apply P; lia.
    - split.
      + pose proof (CellsAround x 2 j k (-1) 0 0 E) as P. rewrite !Z.add_0_r, Hj, Hk in P.
        apply P; lia.
      + pose proof (CellsAround x 2 j k 0 0 0 E) as P. rewrite !Z.add_0_r, Hj, Hk in P.
        apply P; lia.
  Qed.

  (** If the middle of a face is used, both its cells exist; *)
  Lemma FaceUsed x :
    IsUsed cells (LevelOf x) (PointInHalfSides x 1 0 0) = true ->
    cells (LevelOf x) (CellSeen x 0 0 0) = true /\
    cells (LevelOf x) (CellSeen x 1 0 0) = true.
  Proof.
    intros U. apply UsedSeen in U. destruct U as (i & j & k & Bi & Bj & Bk & E).
    apply FaceChild in E; [exact E | lia ..].
  Qed.

  (** if that of an edge is, all four cells around it do. *)
  Lemma EdgeUsed x i j :
    IsUsed cells (LevelOf x) (PointInHalfSides x 1 1 0) = true ->
    0 <= i <= 1 -> 0 <= j <= 1 ->
    cells (LevelOf x) (CellSeen x i j 0) = true.
  Proof.
    intros U Hi Hj. apply UsedSeen in U. destruct U as (i' & j' & k' & Bi & Bj & Bk & E).
    assert (A : forall n m, 0 <= n <= 1 -> 0 <= m <= 1 ->
      exists d, -1 <= d <= 1 /\ (1 + n + d) / 2 = m).
    { intros n m Hn Hm. exists (m - n). split; [lia|].
      euclid. }
    destruct (A i' i Bi Hi) as (di & Di & <-), (A j' j Bj Hj) as (dj & Dj & <-).
    pose proof (CellsAround x _ _ _ di dj 0 E Di Dj ltac:(lia) ltac:(lia)) as P.
    replace ((0 + k' + 0) / 2) with 0 in P
      by (symmetry; apply Z.div_small; lia).
    exact P.
  Qed.
End Balanced.

(** ** Used points without a child *)

Lemma NotUsed cells x i j k i' j' k' :
  IsUsed cells (LevelOf x) (PointInHalfSides x i j k) = false ->
  i <= i' <= i + 1 -> j <= j' <= j + 1 -> k <= k' <= k + 1 ->
  HasChild cells (LevelOf x) (ChildSeen x i' j' k') = false.
Proof.
  intros U Bi Bj Bk. apply not_true_is_false. intros E.
  apply not_true_iff_false in U. apply U, UsedSeen.
  exists (i' - i), (j' - j), (k' - k). repeat split; try lia.
  rewrite !Zplus_minus. exact E.
Qed.

Lemma Used cells x i j k i' j' k' :
  HasChild cells (LevelOf x) (ChildSeen x i' j' k') = true ->
  i <= i' <= i + 1 -> j <= j' <= j + 1 -> k <= k' <= k + 1 ->
  IsUsed cells (LevelOf x) (PointInHalfSides x i j k) = true.
Proof.
  intros E Bi Bj Bk. apply UsedSeen.
  exists (i' - i), (j' - j), (k' - k). repeat split; try lia.
  rewrite !Zplus_minus. exact E.
Qed.
