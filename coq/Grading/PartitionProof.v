(** * Every flag is in one tetrahedron: proofs *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Grading.Octree Grading.Flag
  Grading.GradedTet Grading.FlagProof Grading.BalanceProof.
Open Scope Z_scope.

(** ** Presence and kind of the flags beside *)

Section Cells.
  Variable cells : CellSet.

  Lemma PresentTells x : IsPresent cells x = true <->
    cells (LevelOf x) (CellSeen x 0 0 0) = true /\
    HasChild cells (LevelOf x) (ChildSeen x 1 1 1) = false.
  Proof.
    unfold IsPresent. rewrite CellHere, andb_true_iff, negb_true_iff. tauto.
  Qed.

  Lemma PresentEdge x : IsPresent cells (OtherEdge x) = IsPresent cells x.
  Proof. unfold IsPresent. now rewrite LevelByEdge, CellOfEdge, ChildByEdge. Qed.

  Lemma PresentFace x : IsPresent cells (OtherFace x) = IsPresent cells x.
  Proof. unfold IsPresent. now rewrite LevelByFace, CellOfFace, ChildByFace. Qed.

  Lemma PresentCorner x : IsPresent cells (OtherCorner x) = true <->
    cells (LevelOf x) (CellSeen x 0 0 0) = true /\
    HasChild cells (LevelOf x) (ChildSeen x 1 1 0) = false.
  Proof.
    rewrite PresentTells, LevelByCorner, CellByCorner, ChildByCorner. reflexivity.
  Qed.

  Lemma PresentCell x : IsPresent cells (OtherCell x) = true <->
    cells (LevelOf x) (CellSeen x 1 0 0) = true /\
    HasChild cells (LevelOf x) (ChildSeen x 2 1 1) = false.
  Proof.
    rewrite PresentTells, LevelByCell, CellByCell, ChildByCell. reflexivity.
  Qed.

  (** What a kind tells. *)
  Definition AcrossExists x := cells (LevelOf x) (CellSeen x 1 0 0).
  Definition FaceIsUsed x := IsUsed cells (LevelOf x) (PointInHalfSides x 1 0 0).
  Definition EdgeIsUsed x := IsUsed cells (LevelOf x) (PointInHalfSides x 1 1 0).

  Lemma KindTells x :
    match KindAt cells x with
    | BccTet => AcrossExists x = true /\ FaceIsUsed x = false /\ EdgeIsUsed x = false
    | EdgeHalfTet => AcrossExists x = true /\ FaceIsUsed x = false /\ EdgeIsUsed x = true
    | FaceHalfTet => AcrossExists x = true /\ FaceIsUsed x = true /\ EdgeIsUsed x = false
    | QuarterTet => AcrossExists x = true /\ FaceIsUsed x = true /\ EdgeIsUsed x = true
    | PyramidTet => AcrossExists x = false
    end.
  Proof.
    unfold KindAt, AcrossExists, FaceIsUsed, EdgeIsUsed.
    destruct (cells _ _); [|reflexivity].
    destruct (IsUsed _ _ _), (IsUsed _ _ _); auto.
  Qed.

  Lemma KindByCorner x : KindAt cells (OtherCorner x) = KindAt cells x.
  Proof.
    unfold KindAt. rewrite LevelByCorner, CellByCorner, !PointByCorner. reflexivity.
  Qed.

  Lemma KindByCell x : cells (LevelOf x) (CellSeen x 0 0 0) = true ->
    AcrossExists x = true -> KindAt cells (OtherCell x) = KindAt cells x.
  Proof.
    unfold AcrossExists. intros H A. unfold KindAt.
    rewrite LevelByCell, CellByCell, !PointByCell.
    change (1 - 1) with 0. change (2 - 1) with 1. now rewrite H, A.
  Qed.

  Lemma AcrossByEdge x : AcrossExists (OtherEdge x) = AcrossExists x.
  Proof. unfold AcrossExists. now rewrite LevelByEdge, CellByEdge. Qed.
  Lemma FaceUsedByEdge x : FaceIsUsed (OtherEdge x) = FaceIsUsed x.
  Proof. unfold FaceIsUsed. now rewrite LevelByEdge, PointByEdge. Qed.
  Lemma EdgeUsedByFace x : EdgeIsUsed (OtherFace x) = EdgeIsUsed x.
  Proof. unfold EdgeIsUsed. now rewrite LevelByFace, PointByFace. Qed.

  (** ** What a tetrahedron is named by *)

  Lemma OffDiagonalByCorner x : IsOffDiagonal (OtherCorner x) = negb (IsOffDiagonal x).
  Proof.
    unfold IsOffDiagonal. rewrite AheadEdgeByCorner, AheadCornerByCorner.
    now destruct (AheadAtEdge x), (AheadAtCorner x).
  Qed.

  Lemma OffDiagonalByEdge x : IsOffDiagonal (OtherEdge x) = IsOffDiagonal x.
  Proof.
    unfold IsOffDiagonal. rewrite AheadEdgeByEdge, AheadCornerByEdge.
    now destruct (AheadAtEdge x), (AheadAtCorner x).
  Qed.

  Lemma PyramidNameByCorner x :
    WithCornerOffDiagonal (OtherCorner x) = WithCornerOffDiagonal x.
  Proof.
    unfold WithCornerOffDiagonal. rewrite OffDiagonalByCorner, CornerTwice.
    destruct (IsOffDiagonal x); reflexivity.
  Qed.

  Lemma PyramidNameByEdge x : IsOffDiagonal x = true ->
    WithCornerOffDiagonal (OtherEdge x) = WithCornerOffDiagonal x.
  Proof.
    intros off. unfold WithCornerOffDiagonal. rewrite OffDiagonalByEdge, off.
    rewrite AheadEdgeByEdge, EdgeTwice. unfold IsOffDiagonal in off.
    destruct (AheadAtEdge x), (AheadAtCorner x); reflexivity || discriminate.
  Qed.

  (** The name's own flag is off the diagonal, and its edge leads to the corner
      nearest the parent's centre. *)
  Lemma PyramidNameTells x :
    AheadAtEdge (WithCornerOffDiagonal x) = false /\
    AheadAtCorner (WithCornerOffDiagonal x) = true.
  Proof.
    unfold WithCornerOffDiagonal, IsOffDiagonal.
    destruct (AheadAtEdge x) eqn:E, (AheadAtCorner x) eqn:C; cbn [xorb];
      rewrite ?AheadEdgeByCorner, ?E;
      rewrite ?AheadEdgeByEdge, ?AheadCornerByEdge, ?AheadEdgeByCorner,
        ?AheadCornerByCorner, ?E, ?C; auto.
  Qed.

  Lemma PyramidNameKept x : AheadAtEdge x = false -> AheadAtCorner x = true ->
    WithCornerOffDiagonal x = x.
  Proof.
    intros E C. unfold WithCornerOffDiagonal, IsOffDiagonal. rewrite E, C. cbn [xorb].
    now rewrite E.
  Qed.

  Lemma WithLowerCellByCell x : WithLowerCell (OtherCell x) = WithLowerCell x.
  Proof.
    pose proof (CellTwice x) as T.
    destruct x as [l c o [] t u]; cbn [OtherCell WithLowerCell negb] in *;
      [exact T | reflexivity].
  Qed.

  Lemma WithUpperCornerByCorner x : WithUpperCorner (OtherCorner x) = WithUpperCorner x.
  Proof. destruct x as [l c o s t []]; reflexivity. Qed.

  Lemma WithLowerCellByCorner x :
    WithLowerCell (OtherCorner x) = OtherCorner (WithLowerCell x).
  Proof.
    pose proof (CornerThenCell x) as T.
    destruct x as [l c o [] t u]; [reflexivity | exact T].
  Qed.

  Lemma NameByCorner kind x :
    kind = BccTet \/ kind = FaceHalfTet \/ kind = PyramidTet ->
    NamingFlag kind (OtherCorner x) = NamingFlag kind x.
  Proof.
    intros [-> | [-> | ->]]; cbn [NamingFlag].
    - now rewrite WithLowerCellByCorner, WithUpperCornerByCorner.
    - apply WithUpperCornerByCorner.
    - apply PyramidNameByCorner.
  Qed.

  Lemma NameByCell kind x : kind = BccTet \/ kind = EdgeHalfTet ->
    NamingFlag kind (OtherCell x) = NamingFlag kind x.
  Proof.
    intros [-> | ->]; cbn [NamingFlag]; now rewrite WithLowerCellByCell.
  Qed.
End Cells.

(** ** Flags of the same tetrahedron *)

Section Octree.
  Variable cells : CellSet.
  Hypothesis Balance : IsBalanced cells.

  Lemma CornerPresent x : IsPresent cells x = true -> KindAt cells x <> QuarterTet ->
    IsPresent cells (OtherCorner x) = true.
  Proof.
    intros P K. apply PresentTells in P. destruct P as [P _]. apply PresentCorner.
    split; [exact P|]. pose proof (KindTells cells x) as T.
    unfold AcrossExists, FaceIsUsed, EdgeIsUsed in T.
    destruct (KindAt cells x).
    - destruct T as (_ & T & _). apply (NotUsed _ _ _ _ _ _ _ _ T); lia.
    - destruct T as (_ & T & _). apply (NotUsed _ _ _ _ _ _ _ _ T); lia.
    - destruct T as (_ & _ & T). apply (NotUsed _ _ _ _ _ _ _ _ T); lia.
    - now destruct K.
    - apply not_true_is_false. intros E.
      apply (FaceChild cells Balance) in E; [|lia ..]. destruct E as [_ E]. congruence.
  Qed.

  Lemma CellPresent x : IsPresent cells x = true ->
    KindAt cells x = BccTet \/ KindAt cells x = EdgeHalfTet \/
    KindAt cells x = FaceHalfTet ->
    IsPresent cells (OtherCell x) = true.
  Proof.
    intros P K. apply PresentCell. pose proof (KindTells cells x) as T.
    unfold AcrossExists, FaceIsUsed, EdgeIsUsed in T.
    destruct K as [K | [K | K]]; rewrite K in T; destruct T as (A & M & Q); (split; [exact A|]).
    - apply (NotUsed _ _ _ _ _ _ _ _ M); lia.
    - apply (NotUsed _ _ _ _ _ _ _ _ M); lia.
    - apply (NotUsed _ _ _ _ _ _ _ _ Q); lia.
  Qed.

  Lemma TetByCorner x :
    KindAt cells x = BccTet \/ KindAt cells x = FaceHalfTet \/
    KindAt cells x = PyramidTet ->
    TetOfFlag cells (OtherCorner x) = TetOfFlag cells x.
  Proof.
    intros K. unfold TetOfFlag. rewrite KindByCorner. f_equal. now apply NameByCorner.
  Qed.

  Lemma TetByCell x : IsPresent cells x = true ->
    KindAt cells x = BccTet \/ KindAt cells x = EdgeHalfTet ->
    TetOfFlag cells (OtherCell x) = TetOfFlag cells x.
  Proof.
    intros P K. apply PresentTells in P. destruct P as [P _].
    unfold TetOfFlag. rewrite KindByCell; [| exact P |].
    - f_equal. now apply NameByCell.
    - pose proof (KindTells cells x) as T. destruct K as [K | K]; rewrite K in T; apply T.
  Qed.

  Lemma KindByEdgePyramid x : KindAt cells x = PyramidTet ->
    KindAt cells (OtherEdge x) = PyramidTet.
  Proof.
    intros K. pose proof (KindTells cells x) as T. rewrite K in T.
    unfold AcrossExists in T. unfold KindAt. rewrite LevelByEdge, CellByEdge.
    now rewrite T.
  Qed.

  Lemma TetByEdge x : KindAt cells x = PyramidTet -> IsOffDiagonal x = true ->
    TetOfFlag cells (OtherEdge x) = TetOfFlag cells x.
  Proof.
    intros K off. unfold TetOfFlag. rewrite (KindByEdgePyramid x K), K. f_equal.
    now apply PyramidNameByEdge.
  Qed.

  (** What the other flags of a tetrahedron are, and that they name it. *)
  Definition Beside (x y : Flag) : Prop :=
    IsPresent cells y = true /\ KindAt cells y = KindAt cells x /\
    TetOfFlag cells y = TetOfFlag cells x.

  Lemma BesideCorner x : IsPresent cells x = true ->
    KindAt cells x = BccTet \/ KindAt cells x = FaceHalfTet \/
    KindAt cells x = PyramidTet -> Beside x (OtherCorner x).
  Proof.
    intros P K. split; [|split].
    - apply CornerPresent; [exact P|].
      destruct K as [-> | [-> | ->]]; discriminate.
    - apply KindByCorner.
    - apply TetByCorner, K.
  Qed.

  Lemma BesideCell x : IsPresent cells x = true ->
    KindAt cells x = BccTet \/ KindAt cells x = EdgeHalfTet -> Beside x (OtherCell x).
  Proof.
    intros P K. split; [|split].
    - apply CellPresent; tauto.
    - apply KindByCell; [apply PresentTells, P|].
      pose proof (KindTells cells x) as T. destruct K as [K | K]; rewrite K in T; apply T.
    - apply TetByCell; assumption.
  Qed.

  Lemma BesideEdge x : IsPresent cells x = true -> KindAt cells x = PyramidTet ->
    IsOffDiagonal x = true -> Beside x (OtherEdge x).
  Proof.
    intros P K off. split; [|split].
    - now rewrite PresentEdge.
    - rewrite K. now apply KindByEdgePyramid.
    - apply TetByEdge; assumption.
  Qed.

  Lemma BesideSelf x : IsPresent cells x = true -> Beside x x.
  Proof. repeat split; assumption. Qed.

  Lemma BesideThen x y z : Beside x y -> Beside y z -> Beside x z.
  Proof. intros (_ & K & T) (P & K' & T'). repeat split; congruence. Qed.

  Lemma BesideName x : IsPresent cells x = true ->
    Beside x (NamingFlag (KindAt cells x) x).
  Proof.
    intros P. destruct (KindAt cells x) eqn:K; cbn [NamingFlag].
    - assert (L : Beside x (WithLowerCell x)).
      { destruct x as [l c o [] t u] eqn:X; [now apply BesideSelf|].
        rewrite <- X in *. cbn [WithLowerCell].
        replace (WithLowerCell x) with (OtherCell x) by (now rewrite X).
        apply BesideCell; auto. }
      apply (BesideThen _ _ _ L). destruct L as (P' & K' & _). rewrite K in K'.
      destruct (WithLowerCell x) as [l c o s t []] eqn:X; [now apply BesideSelf|].
      rewrite <- X in *. replace (WithUpperCorner (WithLowerCell x))
        with (OtherCorner (WithLowerCell x)) by (now rewrite X).
      apply BesideCorner; auto.
    - destruct x as [l c o [] t u] eqn:X; [now apply BesideSelf|].
      rewrite <- X in *.
      replace (WithLowerCell x) with (OtherCell x) by (now rewrite X).
      apply BesideCell; auto.
    - destruct x as [l c o s t []] eqn:X; [now apply BesideSelf|].
      rewrite <- X in *.
      replace (WithUpperCorner x) with (OtherCorner x) by (now rewrite X).
      apply BesideCorner; auto.
    - now apply BesideSelf.
    - unfold WithCornerOffDiagonal. set (y := if IsOffDiagonal x then x else OtherCorner x).
      assert (Beside x y /\ IsOffDiagonal y = true) as [B off].
      { subst y. destruct (IsOffDiagonal x) eqn:off; [split; [now apply BesideSelf | exact off]|].
        split; [apply BesideCorner; auto | rewrite OffDiagonalByCorner, off; reflexivity]. }
      apply (BesideThen _ _ _ B). destruct B as (P' & K' & _). rewrite K in K'.
      destruct (AheadAtEdge y); [apply BesideEdge | apply BesideSelf]; assumption.
  Qed.

  (** ** The partition *)

  Lemma TetInMesh x : IsPresent cells x = true ->
    InGradedMesh cells (TetOfFlag cells x).
  Proof.
    intros P. pose proof (BesideName x P) as (P' & _ & T).
    split; [exact P' | exact T].
  Qed.

  (** A name's own flag. *)
  Lemma NamedBy kind x : InGradedMesh cells (GTId kind x) ->
    IsPresent cells x = true /\ KindAt cells x = kind /\ NamingFlag kind x = x.
  Proof.
    intros [P T]. unfold TetOfFlag in T. injection T as K N.
    rewrite K in N. auto.
  Qed.

  Lemma NameOffDiagonal x : WithCornerOffDiagonal x = x -> IsOffDiagonal x = true.
  Proof.
    intros N. pose proof (PyramidNameTells x) as [E C]. rewrite N in E, C.
    unfold IsOffDiagonal. now rewrite E, C.
  Qed.

  Lemma FlagBeside kind x z : InGradedMesh cells (GTId kind x) ->
    In z (FlagsOf (GTId kind x)) -> Beside x z.
  Proof.
    intros M I. destruct (NamedBy _ _ M) as (P & K & N).
    destruct kind; cbn [FlagsOf In] in I.
    - pose proof (BesideCorner x P ltac:(auto)) as C.
      pose proof (BesideCell x P ltac:(auto)) as S.
      assert (SC : Beside x (OtherCorner (OtherCell x))).
      { apply (BesideThen _ _ _ S). destruct S as (P' & K' & _). rewrite K in K'.
        apply BesideCorner; auto. }
      intuition (subst; auto using BesideSelf).
    - pose proof (BesideCell x P ltac:(auto)) as S.
      intuition (subst; auto using BesideSelf).
    - pose proof (BesideCorner x P ltac:(auto)) as C.
      intuition (subst; auto using BesideSelf).
    - intuition (subst; auto using BesideSelf).
    - cbn [NamingFlag] in N. pose proof (NameOffDiagonal x N) as off.
      pose proof (BesideCorner x P ltac:(auto)) as C.
      pose proof (BesideEdge x P K off) as E.
      assert (EC : Beside x (OtherCorner (OtherEdge x))).
      { apply (BesideThen _ _ _ E). destruct E as (P' & K' & _). rewrite K in K'.
        apply BesideCorner; auto. }
      intuition (subst; auto using BesideSelf).
  Qed.
End Octree.

(** A flag is among those of its tetrahedron. *)
Lemma FlagOfItsTet cells x : In x (FlagsOf (TetOfFlag cells x)).
Proof.
  unfold TetOfFlag. destruct (KindAt cells x); cbn [NamingFlag FlagsOf In].
  - assert (L : WithLowerCell x = x \/ OtherCell (WithLowerCell x) = x).
    { pose proof (CellTwice x). destruct x as [l c o [] t u]; auto. }
    assert (U : forall y, WithUpperCorner y = y \/ OtherCorner (WithUpperCorner y) = y).
    { intros y. pose proof (CornerTwice y). destruct y as [l c o s t []]; auto. }
    destruct (U (WithLowerCell x)) as [-> | V].
    + destruct L as [L | L]; rewrite L; tauto.
    + rewrite <- CornerThenCell, V. destruct L as [L | L]; rewrite L; tauto.
  - pose proof (CellTwice x). destruct x as [l c o [] t u]; auto.
  - pose proof (CornerTwice x). destruct x as [l c o s t []]; auto.
  - auto.
  - unfold WithCornerOffDiagonal.
    destruct (IsOffDiagonal x), (AheadAtEdge _); rewrite ?EdgeTwice, ?CornerTwice; auto.
Qed.

Lemma StepNotZero s : Signed s 1 <> 0.
Proof. destruct s; discriminate. Qed.

Lemma FlagsApart tid : NoDup (FlagsOf tid).
Proof.
  assert (C : forall x, OtherCorner x <> x).
  { intros [l c o s t []]; cbn; discriminate. }
  assert (S : forall x, OtherCell x <> x).
  { intros [l c o [] t u]; cbn; discriminate. }
  assert (SC : forall x, OtherCorner (OtherCell x) <> x).
  { intros [l c o [] t u]; cbn; discriminate. }
  assert (E : forall x, OtherEdge x <> x).
  { intros [l c [] s t u]; cbn; discriminate. }
  assert (EC : forall x, OtherCorner (OtherEdge x) <> x).
  { intros [l c [] s t u]; cbn; discriminate. }
  assert (CS : forall x, OtherCorner x <> OtherCell x).
  { intros [l c o [] t u]; cbn; discriminate. }
  assert (CE : forall x, OtherCorner x <> OtherEdge x).
  { intros [l c [] s t u]; cbn; discriminate. }
  assert (CC : forall x y, OtherCorner x = OtherCorner y -> x = y).
  { intros x y H. rewrite <- (CornerTwice x), H. apply CornerTwice. }
  destruct tid as [[] x]; cbn [FlagsOf]; repeat constructor; cbn [In];
    intuition (try match goal with H : OtherCorner _ = OtherCorner _ |- _ => apply CC in H end;
      eauto using eq_sym).
  all: match goal with
       | H : _ = ?x |- False => first [now apply C in H | now apply S in H
           | now apply SC in H | now apply E in H | now apply EC in H
           | now apply CS in H | now apply CE in H | symmetry in H; first [now apply C in H
           | now apply S in H | now apply CS in H | now apply CE in H]]
       end.
Qed.

Theorem FlagsPartition :
  forall cells, IsOctree cells ->
    (forall x, IsPresent cells x = true ->
       InGradedMesh cells (TetOfFlag cells x)) /\
    (forall tid, InGradedMesh cells tid ->
       NoDup (FlagsOf tid) /\
       forall x, In x (FlagsOf tid) <->
         IsPresent cells x = true /\ TetOfFlag cells x = tid).
Proof.
  intros cells [balance _]. split; [intros x; now apply TetInMesh|].
  intros [kind y] M. split; [apply FlagsApart|]. intros x. split.
  - intros I. pose proof (FlagBeside cells balance _ _ _ M I) as (P & _ & T).
    destruct M as [_ N]. split; [exact P | now rewrite T].
  - intros [_ <-]. apply FlagOfItsTet.
Qed.

(** ** Each place is filled once *)

Lemma AncestorExists cells (balance : IsBalanced cells) l c :
  cells l (AncestorCell l c) = true -> cells (S l) (AncestorCell (S l) c) = true.
Proof.
  intros E. pose proof (balance l (AncestorCell l c) (C3 0 0 0)) as B.
  cbn [AncestorCell]. replace (AncestorCell l c) with (Translate (AncestorCell l c) (C3 0 0 0)).
  - apply B; [cbn; lia | exact E].
  - destruct (AncestorCell l c). cbn. now rewrite !Z.add_0_r.
Qed.

Theorem EachPlaceFilledOnce :
  forall cells, IsOctree cells ->
    forall c, exists level, FillsAt cells level c /\
      forall other, FillsAt cells other c -> other = level.
Proof.
  intros cells [balance [top all]] c.
  assert (up : forall l m, (l <= m)%nat -> cells l (AncestorCell l c) = true ->
    cells m (AncestorCell m c) = true).
  { intros l m le E. induction le; [exact E | now apply AncestorExists]. }
  assert (least : forall n, cells n (AncestorCell n c) = true ->
    exists level, FillsAt cells level c).
  { induction n as [|n IH]; intros E.
    - exists O. split; [exact E | reflexivity].
    - destruct (cells n (AncestorCell n c)) eqn:F; [now apply IH|].
      exists (S n). split; [exact E | exact F]. }
  destruct (least top (all _)) as [level F]. exists level. split; [exact F|].
  assert (order : forall l m, FillsAt cells l c -> FillsAt cells m c -> ~ (l < m)%nat).
  { intros l m [E _] [_ G] lt. destruct m as [|m]; [lia|]. cbn [pred HasChild] in G.
    rewrite (up l m ltac:(lia) E) in G. discriminate. }
  intros other G. pose proof (order _ _ F G). pose proof (order _ _ G F). lia.
Qed.
