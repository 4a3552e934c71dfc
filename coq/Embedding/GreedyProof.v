(** * A structured tetrahedron is filled in one way

    Two weighted tetrahedra that follow the rule of [MayJoinBy] are the same if
    their shares are: the weight of a cut counts for the ends of its edge, the
    more the nearer.  For let the cut [am] be lighter in the first.  At [m] this
    is made good by a cut [bm].  If [am] comes before [bm], then at [a] it is
    made good by [a] itself or by a cut [an].  The rule does not join [a] to [bm].
    It joins [an] to [bm] only if [an] comes before [bn], and after [am]; and then
    [an], too heavy in the first, is too light in the second, where at [n] it is
    made good by [bn], which the rule does not join to [am].  If [bm] comes before
    [am], the same holds at [b] with the two tetrahedra exchanged. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Embedding.Measure Embedding.EdgeRank.
Open Scope Z_scope.

Lemma SamePoint3 (u v : Coord3) : {u = v} + {u <> v}.
Proof. decide equality; apply Z.eq_dec. Qed.

Lemma SameVertex (u v : MeshVertex) : {u = v} + {u <> v}.
Proof. decide equality; apply SamePoint3. Qed.

Section Greedy.
  Variables (key : Coord3 -> Coord3 -> Z) (after : Coord3 -> Sign) (cut : CutField).

  Hypothesis Inside : forall v d, let u := Translate v (Offset d) in
    after v = Plus -> after u = Minus -> 0 < cut v u < Steps.

  (** A quantity of the lattice points, at a vertex of the output, times
      [Steps]. *)
  Definition Share (g : Coord3 -> Z) (v : MeshVertex) : Z :=
    match v with
    | Corner c => Steps * g c
    | Cut a m => (Steps - cut a m) * g a + cut a m * g m
    end.

  Local Notation weight := (WeightOf SameVertex).

  (** A weighted tetrahedron that follows the rule. *)
  Definition Filling (tid : StructuredTetId) (w : Weights)
    (t : UnstructuredTet MeshVertex) : Prop :=
    KeysApart key (Corners tid) /\ NonNegative w /\ FollowsBy key after (Corners tid) t.

  Definition SameShares (w : Weights) (t : UnstructuredTet MeshVertex)
    (w' : Weights) (t' : UnstructuredTet MeshVertex) : Prop :=
    forall g, Weigh (Share g) w t = Weigh (Share g) w' t'.

  Lemma CutBelongs tid a m :
    Belongs after (Corners tid) (Cut a m) ->
    In a (Corners tid) /\ In m (Corners tid) /\ a <> m /\
    after a = Plus /\ after m = Minus /\ 0 < cut a m < Steps.
  Proof.
    intros (A & M & Pa & Pm). assert (N : a <> m) by congruence.
    destruct (EdgeBetween tid a m A M N) as [d E]; subst m.
    repeat (split; [assumption|]). apply Inside; assumption.
  Qed.

  (** The share of one lattice point. *)
  Local Notation share c := (Share (At SamePoint3 c)).

  (** Who has a share: the point itself, a cut that starts there, one that ends
      there. *)
  Lemma ShareMeans tid c v : Belongs after (Corners tid) v ->
    0 <= share c v /\
    (0 < share c v -> In c (Corners tid) /\
       (v = Corner c \/ (exists m, v = Cut c m) \/ exists a, v = Cut a c)).
  Proof.
    intros B. destruct v as [a|a m]; cbn [Share]; unfold At.
    - destruct B as [I _], (SamePoint3 c a) as [->|]; [|split; [lia|intros; exfalso; lia]].
      change Steps with 65536. split; [lia|]. auto.
    - destruct (CutBelongs tid a m B) as (A & M & N & _ & _ & C).
      destruct (SamePoint3 c a) as [<-|], (SamePoint3 c m) as [<-|];
        try congruence; (split; [lia|]); eauto 6; lia.
  Qed.

  Section Two.
    Variables (tid : StructuredTetId) (w : Weights) (t : UnstructuredTet MeshVertex).
    Variables (tid' : StructuredTetId) (w' : Weights) (t' : UnstructuredTet MeshVertex).
    Hypothesis F : Filling tid w t.
    Hypothesis F' : Filling tid' w' t'.
    Hypothesis E : SameShares w t w' t'.

    (** At a point where a vertex is too light another is too heavy. *)
    Lemma MadeGood c u : 0 < share c u -> weight w t u < weight w' t' u ->
      exists v, weight w' t' v < weight w t v /\ In v (TetCorners t) /\
        In c (Corners tid) /\ Belongs after (Corners tid) v /\
        (v = Corner c \/ (exists m, v = Cut c m) \/ exists a, v = Cut a c).
    Proof.
      destruct F as (Even & W & B & _), F' as (Even' & W' & B' & _).
      intros S L.
      destruct (Balance MeshVertex SameVertex w t w' t' (share c) u W (E _)) as (v & P & H);
        try assumption.
      { intros v [I|I]; [apply (ShareMeans tid); auto|apply (ShareMeans tid'); auto]. }
      assert (I : In v (TetCorners t)).
      { apply (WeightyCorner _ SameVertex w).
        pose proof (WeightNonNegative _ SameVertex w' t' v W'). lia. }
      destruct (ShareMeans tid c v (B v I)) as [_ K]. destruct (K P) as [J M].
      exists v. auto 6.
    Qed.

    (** A heavier vertex is there. *)
    Lemma HeavierBelongs u : weight w t u < weight w' t' u ->
      In u (TetCorners t') /\ Belongs after (Corners tid') u.
    Proof.
      destruct F as (_ & W & _), F' as (_ & _ & B' & _). intros L.
      assert (I : In u (TetCorners t')).
      { apply (WeightyCorner _ SameVertex w').
        pose proof (WeightNonNegative _ SameVertex w t u W). lia. }
      auto.
    Qed.

    Lemma SharesOfCut a m :
      weight w t (Cut a m) < weight w' t' (Cut a m) ->
      after a = Plus /\ after m = Minus /\
      0 < share a (Cut a m) /\ 0 < share m (Cut a m).
    Proof.
      intros L. destruct (HeavierBelongs _ L) as [_ B].
      destruct (CutBelongs tid' a m B) as (_ & _ & N & A & M & C).
      repeat (split; [assumption|]). cbn [Share]. unfold At.
      destruct (SamePoint3 a a), (SamePoint3 a m), (SamePoint3 m a),
        (SamePoint3 m m); try congruence; lia.
    Qed.
  End Two.

  (** No more than four. *)
  Lemma FourCorners tid (a b c m n : Coord3) : NoDup [a; b; c; m; n] ->
    ~ incl [a; b; c; m; n] (Corners tid).
  Proof.
    intros D I. pose proof (NoDup_incl_length D I) as L.
    unfold Corners in L. destruct (GetStructuredTet tid). cbn in L. lia.
  Qed.

  (** No cut is too light that comes before one that is too heavy. *)
  Lemma NotBefore tid w t tid' w' t' a b m :
    Filling tid w t -> Filling tid' w' t' -> SameShares w t w' t' ->
    weight w t (Cut a m) < weight w' t' (Cut a m) ->
    weight w' t' (Cut b m) < weight w t (Cut b m) ->
    In (Cut b m) (TetCorners t) ->
    ~ key a m < key b m.
  Proof.
    intros F F' E L H Ib R. pose proof F as (Apart & W & B & J).
    assert (E' : SameShares w' t' w t) by (intros g; symmetry; apply E).
    destruct (SharesOfCut tid w t tid' w' t' F F' a m L) as (A & M & Sa & _).
    destruct (MadeGood tid w t tid' w' t' F F' E a _ Sa L)
      as (v & Hv & Iv & Ia & Bv & [->|[[n ->]|[n ->]]]).
    - pose proof (J _ _ Iv Ib A). lia.
    - destruct (CutBelongs tid b m (B _ Ib)) as (Jb & Jm & Nb & Pb & _).
      destruct (CutBelongs tid a n Bv) as (_ & Jn & Na & _ & Mn & _).
      assert (N : a <> b) by (intros ->; lia).
      assert (N' : n <> m) by (intros ->; lia).
      destruct (J _ _ Iv Ib N N') as [across beside].
      assert (Lan : key a n <= key b n) by lia.
      specialize (beside Lan ltac:(lia)).
      destruct (Apart m n a Jm Jn Ia) as [_ D]; try congruence.
      destruct (SharesOfCut tid' w' t' tid w t F' F a n Hv) as (_ & _ & _ & Sn).
      destruct (MadeGood tid' w' t' tid w t F' F E' n _ Sn Hv)
        as (u & Hu & Iu & In' & Bu & [->|[[x ->]|[c ->]]]).
      + destruct Bu. congruence.
      + destruct (CutBelongs tid' n x Bu) as (_ & _ & _ & ? & _). congruence.
      + destruct (CutBelongs tid' c n Bu) as (_ & _ & Nc & Pc & _).
        assert (Nac : a <> c) by (intros ->; lia).
        destruct (SamePoint3 c b) as [->|Nbc].
        * pose proof F' as (_ & _ & _ & J').
          destruct (HeavierBelongs tid w t tid' w' t' F F' _ L) as [Im _].
          destruct (J' _ _ Im Iu N (not_eq_sym N')) as [_ beside'].
          specialize (beside' ltac:(lia) Lan). lia.
        * destruct (SharesOfCut tid w t tid' w' t' F F' c n Hu) as (_ & _ & Sc & _).
          destruct (MadeGood tid w t tid' w' t' F F' E c _ Sc Hu) as (_ & _ & _ & Ic & _).
          apply (FourCorners tid a b c m n).
          -- repeat constructor; cbn [In]; intuition congruence.
          -- intros x I. cbn [In] in I. intuition congruence.
    - destruct (CutBelongs tid n a Bv) as (_ & _ & _ & _ & Ma & _).
      congruence.
  Qed.

  Lemma NoLighterCut tid w t tid' w' t' :
    Filling tid w t -> Filling tid' w' t' -> SameShares w t w' t' ->
    forall a m, weight w' t' (Cut a m) <= weight w t (Cut a m).
  Proof.
    intros F F' E a m. apply Z.le_ngt. intros L.
    destruct (SharesOfCut tid w t tid' w' t' F F' a m L) as (A & M & Sa & Sm).
    destruct (MadeGood tid w t tid' w' t' F F' E a _ Sa L) as (_ & _ & _ & Ia & _).
    destruct (MadeGood tid w t tid' w' t' F F' E m _ Sm L)
      as (v & Hv & Iv & Im & Bv & [->|[[n ->]|[b ->]]]).
    - destruct Bv. congruence.
    - destruct (CutBelongs tid m n Bv) as (_ & _ & _ & ? & _). congruence.
    - destruct (CutBelongs tid b m Bv) as (Ib & _ & Nb & _).
      assert (N : a <> b) by (intros ->; lia).
      destruct (proj1 F a b m Ia Ib Im N) as [D _]; [congruence..|].
      destruct (Z.lt_total (key a m) (key b m)) as [R|[R|R]].
      + exact (NotBefore _ _ _ _ _ _ a b m F F' E L Hv Iv R).
      + apply D, R.
      + refine (NotBefore _ _ _ _ _ _ b a m F' F (fun g => eq_sym (E g)) Hv L _ R).
        apply (HeavierBelongs tid w t tid' w' t' F F' _ L).
  Qed.

  Lemma NoLighterCorner tid w t tid' w' t' :
    Filling tid w t -> Filling tid' w' t' -> SameShares w t w' t' ->
    forall c, (forall a m, weight w t (Cut a m) = weight w' t' (Cut a m)) ->
    weight w' t' (Corner c) <= weight w t (Corner c).
  Proof.
    intros F F' E c Cuts. apply Z.le_ngt. intros L.
    destruct (MadeGood tid w t tid' w' t' F F' E c (Corner c))
      as (v & Hv & _ & _ & _ & [->|[[n ->]|[n ->]]]); auto;
      try rewrite Cuts in Hv; try lia.
    cbn [Share]. unfold At. destruct (SamePoint3 c c); [|congruence].
    reflexivity.
  Qed.

  Theorem GreedyUnique tid w t tid' w' t' :
    Filling tid w t -> Filling tid' w' t' -> SameShares w t w' t' ->
    SameWeights w t w' t'.
  Proof.
    intros F F' E. assert (E' : SameShares w' t' w t) by (intros g; symmetry; apply E).
    assert (Cuts : forall a m, weight w t (Cut a m) = weight w' t' (Cut a m)).
    { intros a m. apply Z.le_antisymm;
        [apply (NoLighterCut tid' w' t' tid w t)|apply (NoLighterCut tid w t tid' w' t')];
        assumption. }
    apply (EqualWeights MeshVertex SameVertex). intros [c|a m]; [|apply Cuts].
    apply Z.le_antisymm;
      [apply (NoLighterCorner tid' w' t' tid w t)|apply (NoLighterCorner tid w t tid' w' t')];
      auto.
  Qed.
End Greedy.
