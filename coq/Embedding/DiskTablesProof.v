(** * The strict disk by tables is the strict disk *)

From Coq Require Import Arith.
From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.Cases.Isometry Embedding.DiskTables
  Embedding.LinkProof.

Lemma AtGather {A} (f : Direction -> A) d : At (Gather f) d = f d.
Proof. destruct d; reflexivity. Qed.

Lemma GatherSame {A} (f g : Direction -> A) : (forall d, f d = g d) ->
  Gather f = Gather g.
Proof. intros E. unfold Gather. rewrite !E. reflexivity. Qed.

Lemma EqualIfBothWays (a b : bool) : (a = true <-> b = true) -> a = b.
Proof. destruct a, b; intuition congruence. Qed.

Lemma AllAlike {A} (f g : A -> bool) l : (forall x, f x = g x) ->
  forallb f l = forallb g l.
Proof. intros E. induction l as [|x l IH]; cbn; congruence. Qed.

Lemma SomeAlike {A} (f g : A -> bool) l : (forall x, f x = g x) ->
  existsb f l = existsb g l.
Proof. intros E. induction l as [|x l IH]; cbn; congruence. Qed.

Lemma KeptAlike {A} (f g : A -> bool) l : (forall x, f x = g x) ->
  filter f l = filter g l.
Proof. intros E. induction l as [|x l IH]; cbn; [reflexivity|]. rewrite E, IH. reflexivity. Qed.

(** ** The tables *)

Lemma InNeighborTable d e : In e (At NeighborTable d) <-> NextInLink d e = true.
Proof.
  unfold NeighborTable. rewrite AtGather, filter_In.
  split; [tauto|]. split; [apply InAllDirections|assumption].
Qed.

Lemma NextMutual d e : NextInLink d e = NextInLink e d.
Proof. destruct d, e; reflexivity. Qed.

Lemma InWallTable d e f g : In ((d, e), (f, g)) WallTable <->
  NextInLink d e = true /\
  NextInLink d f = true /\ NextInLink e f = true /\
  NextInLink d g = true /\ NextInLink e g = true /\ SameDirection f g = false.
Proof.
  unfold WallTable. rewrite in_flat_map. split.
  - intros (d' & _ & I). apply in_flat_map in I. destruct I as (e' & E & I).
    apply in_map_iff in I. destruct I as ((f' & g') & Q & I).
    injection Q as -> -> -> ->. apply filter_In in I. destruct I as [I S].
    apply in_prod_iff in I. rewrite !filter_In, !InNeighborTable in I.
    apply InNeighborTable in E. apply negb_true_iff in S. tauto.
  - intros (E & F & F' & G & G' & S). exists d. split; [apply InAllDirections|].
    apply in_flat_map. exists e. split; [apply InNeighborTable, E|].
    apply in_map_iff. exists (f, g). split; [reflexivity|].
    apply filter_In. split; [|apply negb_true_iff, S].
    apply in_prod_iff. rewrite !filter_In, !InNeighborTable. tauto.
Qed.

(** ** One piece *)

Section Pieces.
  Variables (table : Link bool) (part : Direction -> bool).
  Hypothesis Same : forall d, At table d = part d.

  Lemma SpreadStep reached list :
    (forall d, At reached d = existsb (SameDirection d) list) ->
    forall d, At (Spread table reached) d
      = existsb (SameDirection d)
          (filter (fun d => part d &&
             existsb (fun e => SameDirection e d || NextInLink e d) list)
             AllDirections).
  Proof.
    intros R d. unfold Spread. rewrite AtGather, Same.
    assert (In_ : forall e, At reached e = true <-> In e list).
    { intros e. rewrite R, existsb_exists. split.
      - intros (x & I & E). apply SameDirectionMeans in E. congruence.
      - intros I. exists e. split; [exact I|apply SameDirectionRefl]. }
    apply EqualIfBothWays. rewrite andb_true_iff, orb_true_iff, !existsb_exists.
    split.
    - intros [P H]. exists d. split; [|apply SameDirectionRefl].
      apply filter_In. split; [apply InAllDirections|]. rewrite P. cbn [andb].
      apply existsb_exists. destruct H as [H|(e & N & H)].
      + exists d. split; [apply In_, H|]. rewrite SameDirectionRefl. reflexivity.
      + exists e. split; [apply In_, H|]. apply InNeighborTable in N.
        rewrite NextMutual, N. apply orb_true_r.
    - intros (x & I & E). apply SameDirectionMeans in E. subst x.
      apply filter_In in I. destruct I as [_ I]. apply andb_true_iff in I.
      destruct I as [P I]. split; [exact P|]. apply existsb_exists in I.
      destruct I as (e & I & E). apply orb_true_iff in E. destruct E as [E|E].
      + left. apply SameDirectionMeans in E. subst e. apply In_, I.
      + right. exists e. split; [|apply In_, I]. apply InNeighborTable.
        rewrite NextMutual. exact E.
  Qed.

  Lemma SpreadFlood rounds : forall reached list,
    (forall d, At reached d = existsb (SameDirection d) list) ->
    forall d, At (SpreadFor rounds table reached) d
      = existsb (SameDirection d) (Flood rounds part list).
  Proof.
    induction rounds as [|fewer IH]; intros reached list R; [exact R|].
    cbn [SpreadFor Flood]. apply IH, SpreadStep, R.
  Qed.

  Lemma InOnePieceCorrect : InOnePiece table = OnePiece part.
  Proof.
    unfold InOnePiece, OnePiece. rewrite (KeptAlike _ _ _ Same).
    destruct (filter part AllDirections) as [|first rest]; [reflexivity|].
    cbv zeta. apply AllAlike. intros d. rewrite Same. f_equal.
    apply SpreadFlood. intros e. rewrite AtGather. cbn [existsb].
    rewrite orb_false_r. destruct first, e; reflexivity.
  Qed.
End Pieces.

(** ** The disk *)

Section Disk.
  Variable now : Direction -> Sign.

  Let plus := Gather (IsInner now).
  Let zero := Gather (IsZero now).

  Lemma PlusAt d : At plus d = IsInner now d.
  Proof. apply AtGather. Qed.

  Lemma ZeroAt d : At zero d = IsZero now d.
  Proof. apply AtGather. Qed.

  Lemma PinchedCorrect d : Pinched plus d = negb (GoodRing now d).
  Proof.
    unfold Pinched, GoodRing, RingTable. rewrite AtGather.
    unfold NeighborTable. rewrite AtGather. f_equal. f_equal.
    - apply SomeAlike. intros e. rewrite PlusAt. reflexivity.
    - f_equal. f_equal. induction (list_prod _ _) as [|(e, f) l IH]; [reflexivity|].
      cbn [filter]. destruct (NextInLink e f); cbn [filter andb]; [|exact IH].
      rewrite !PlusAt, IH. reflexivity.
  Qed.

  Lemma InWalls d e : In (d, e) (Walls plus) <->
    NextInLink d e = true /\ NoWallBetween now d e = false.
  Proof.
    unfold Walls. rewrite in_map_iff. split.
    - intros ((p & (f & g)) & E & I). cbn [fst] in E. subst p.
      apply filter_In in I. destruct I as [I P]. apply InWallTable in I.
      destruct I as (N & F & F' & G & G' & S). split; [exact N|].
      rewrite !PlusAt in P. apply andb_true_iff in P. destruct P as [P Q].
      apply not_true_iff_false. intros H. unfold NoWallBetween in H.
      rewrite forallb_forall in H. specialize (H f (InAllDirections f)).
      rewrite forallb_forall in H. specialize (H g (InAllDirections g)).
      rewrite F, F', G, G', P, Q, S in H. discriminate H.
    - intros [N W].
      assert (exists f, In f AllDirections /\ exists g, In g AllDirections /\
        negb (IsInner now f && NextInLink d f && NextInLink e f
              && IsInner now g && NextInLink d g && NextInLink e g)
        || SameDirection f g = false) as (f & _ & g & _ & E).
      { unfold NoWallBetween in W.
        destruct (existsb (fun f => existsb (fun g => negb
          (negb (IsInner now f && NextInLink d f && NextInLink e f
                 && IsInner now g && NextInLink d g && NextInLink e g)
           || SameDirection f g)) AllDirections) AllDirections) eqn:X.
        - apply existsb_exists in X. destruct X as (f & I & X).
          apply existsb_exists in X. destruct X as (g & J & X).
          apply negb_true_iff in X. exists f. split; [exact I|]. exists g. auto.
        - exfalso. apply not_true_iff_false in W. apply W.
          apply forallb_forall. intros f I. apply forallb_forall. intros g J.
          apply not_false_iff_true. intros F.
          apply not_true_iff_false in X. apply X. apply existsb_exists.
          exists f. split; [exact I|]. apply existsb_exists. exists g.
          split; [exact J|]. rewrite F. reflexivity. }
      apply orb_false_iff in E. destruct E as [E S]. apply negb_false_iff in E.
      rewrite !andb_true_iff in E. exists ((d, e), (f, g)). split; [reflexivity|].
      apply filter_In. rewrite InWallTable, !PlusAt, andb_true_iff. tauto.
  Qed.

  Theorem IsDiskCorrect : IsDisk (Gather now) = StrictDisk now.
  Proof.
    assert (E : IsDisk (Gather now) = DiskOf plus zero) by reflexivity.
    rewrite E. clear E. unfold DiskOf, TwoPieces, StrictDisk.
    rewrite (InOnePieceCorrect plus (IsInner now) PlusAt).
    rewrite (InOnePieceCorrect _ (fun d => negb (IsInner now d)))
      by (intros d; rewrite AtGather, PlusAt; reflexivity).
    destruct (OnePiece (IsInner now) && OnePiece _); [|reflexivity]. cbv zeta.
    cbn [andb]. apply EqualIfBothWays.
    rewrite andb_true_iff, !forallb_forall. split.
    - intros [P W] d _. rewrite orb_true_iff, andb_true_iff, negb_true_iff.
      destruct (IsZero now d) eqn:Z; [right|left; reflexivity]. split.
      + apply not_false_iff_true. intros G.
        specialize (P d). rewrite ZeroAt, Z in P.
        discriminate P. apply filter_In. split; [apply InAllDirections|].
        rewrite PinchedCorrect, G. reflexivity.
      + apply forallb_forall. intros e _. apply not_false_iff_true. intros F.
        apply orb_false_iff in F. destruct F as [F F'].
        apply negb_false_iff, andb_true_iff in F. destruct F as [Ze N].
        specialize (W (d, e)). cbn beta iota in W. rewrite !ZeroAt, Z, Ze in W.
        discriminate W. apply InWalls. auto.
    - intros H. split.
      + intros d I. apply filter_In in I. destruct I as [_ I].
        rewrite PinchedCorrect in I. apply negb_true_iff in I.
        specialize (H d (InAllDirections d)). rewrite I in H.
        rewrite ZeroAt. destruct (IsZero now d); [discriminate H|reflexivity].
      + intros (d, e) I. apply InWalls in I. destruct I as [N W].
        rewrite !ZeroAt. apply negb_true_iff, not_true_iff_false. intros Z.
        apply andb_true_iff in Z. destruct Z as [Z Ze].
        specialize (H d (InAllDirections d)). rewrite Z in H. cbn [negb orb] in H.
        apply andb_true_iff in H. destruct H as [_ H].
        rewrite forallb_forall in H. specialize (H e (InAllDirections e)).
        rewrite Ze, N, W in H. discriminate H.
  Qed.
End Disk.

Lemma StrictDiskSame f g : (forall d, f d = g d) -> StrictDisk f = StrictDisk g.
Proof.
  intros E. exact (eq_trans (eq_sym (IsDiskCorrect f))
    (eq_trans (f_equal IsDisk (GatherSame f g E)) (IsDiskCorrect g))).
Qed.
