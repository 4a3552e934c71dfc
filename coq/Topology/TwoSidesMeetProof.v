(** * The meshes of both sides meet on the surface alone: proof

    A point of both has the same shares at every lattice point.  Let a cut be
    heavier in the inner tetrahedron.  At its inner end, which the outer one does
    not have, this is made good by a cut that is heavier in the outer one; at the
    outer end of that by one that is heavier in the inner; and so on, until four
    corners have two cuts on opposite edges in either.  But the greedy rule joins
    only one of the two pairs. *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Embedding.LatticeEmbedsProof
  Embedding.WarpedLatticeProof Embedding.Measure Embedding.EdgeRank
  Embedding.GreedyProof Embedding.MeshEmbedsProof Embedding.MeshApartProof
  Embedding.LinkProof Topology.CliqueProof Topology.CornersProof
  Topology.TwoSidesFillProof.
Open Scope Z_scope.

Lemma RankMutual tid a b : InLattice tid -> In a (Corners tid) -> In b (Corners tid) ->
  EdgeRank a b = EdgeRank b a.
Proof.
  intros E A B. apply PlaceOf in A, B. destruct A as [i ->], B as [j ->].
  rewrite !RankAt by exact E. destruct i, j; reflexivity.
Qed.

Section Mesh.
  Variables (before : SignField) (warping : Coord3 -> Warping) (cut : CutField).
  Hypothesis Cuts : CutsInside before warping cut.

  Local Notation after := (SignAfter before warping).
  Local Notation weight := (WeightOf SameVertex).
  Local Notation share c := (Share cut (At SamePoint3 c)).

  (** A vertex of either side, by its name on the inner. *)
  Definition Sound (v : MeshVertex) : Prop :=
    match v with
    | Corner _ => True
    | Cut a m => after a = Plus /\ after m = Minus /\ 0 < cut a m < Steps
    end.

  Lemma ShareSound c v : Sound v -> 0 <= share c v /\
    (0 < share c v -> v = Corner c \/ (exists m, v = Cut c m) \/ exists a, v = Cut a c).
  Proof.
    destruct v as [a|a m]; cbn [Share Sound]; unfold At.
    - intros _. destruct (SamePoint3 c a) as [->|]; [|split; [lia|intros; exfalso; lia]].
      change Steps with 65536. split; [lia|]. auto.
    - intros (A & M & C). assert (N : a <> m) by congruence.
      destruct (SamePoint3 c a) as [<-|], (SamePoint3 c m) as [<-|];
        try congruence; (split; [lia|]); eauto 6; lia.
  Qed.

  Lemma SharePositive c v : Sound v -> In c (Ends v) -> 0 < share c v.
  Proof.
    destruct v as [a|a m]; cbn [Share Sound Ends In]; unfold At.
    - intros _ [<-|[]]. destruct (SamePoint3 a a); [|congruence].
      change Steps with 65536. lia.
    - intros (A & M & C). assert (N : a <> m) by congruence.
      intros [<-|[<-|[]]]; destruct (SamePoint3 a a), (SamePoint3 a m),
        (SamePoint3 m a), (SamePoint3 m m); congruence || lia.
  Qed.

  Lemma InsideEdge tid a m : In a (Corners tid) -> In m (Corners tid) ->
    after a = Plus -> after m = Minus -> 0 < cut a m < Steps.
  Proof.
    intros A M Sa Sm. assert (N : a <> m) by congruence.
    destruct (EdgeBetween tid a m A M N) as [d ->]. apply Cuts; assumption.
  Qed.

  Section Two.
    Variables (tid : StructuredTetId) (w : Weights) (t : UnstructuredTet MeshVertex).
    Variables (tid' : StructuredTetId) (w' : Weights) (t' : UnstructuredTet MeshVertex).

    Hypothesis Even : InLattice tid.
    Hypothesis W : NonNegative w.
    Hypothesis W' : NonNegative w'.

    (** [t] is of the inside, [t'] of the outside. *)
    Hypothesis InnerHas : forall v, In v (TetCorners t) ->
      (forall c, In c (Ends v) -> In c (Corners tid)) /\
      match v with
      | Corner c => after c <> Minus
      | Cut a m => after a = Plus /\ after m = Minus
      end.
    Hypothesis OuterHas : forall v, In v (TetCorners t') ->
      (forall c, In c (Ends v) -> In c (Corners tid')) /\
      match v with
      | Corner c => after c <> Plus
      | Cut a m => after a = Plus /\ after m = Minus
      end.
    Hypothesis InnerJoins : forall a m b n,
      In (Cut a m) (TetCorners t) -> In (Cut b n) (TetCorners t) -> a <> b -> m <> n ->
      EdgeRank a m <= EdgeRank a n.
    Hypothesis OuterJoins : forall a m b n,
      In (Cut a m) (TetCorners t') -> In (Cut b n) (TetCorners t') -> a <> b -> m <> n ->
      EdgeRank m a <= EdgeRank m b.

    Hypothesis Same : forall g, Weigh (Share cut g) w t = Weigh (Share cut g) w' t'.

    Lemma InnerSound v : In v (TetCorners t) -> Sound v.
    Proof.
      intros I. destruct (InnerHas v I) as [K S]. destruct v as [c|a m]; [exact Logic.I|].
      destruct S as [A M]. split; [exact A|]. split; [exact M|].
      apply (InsideEdge tid); try assumption; apply K; cbn; auto.
    Qed.

    Lemma OuterSound v : In v (TetCorners t') -> Sound v.
    Proof.
      intros I. destruct (OuterHas v I) as [K S]. destruct v as [c|a m]; [exact Logic.I|].
      destruct S as [A M]. split; [exact A|]. split; [exact M|].
      apply (InsideEdge tid'); try assumption; apply K; cbn; auto.
    Qed.

    Lemma SharesNonNegative c v : In v (TetCorners t) \/ In v (TetCorners t') ->
      0 <= share c v.
    Proof. intros [I|I]; apply ShareSound; auto using InnerSound, OuterSound. Qed.

    Lemma HeavyInner v : weight w' t' v < weight w t v -> In v (TetCorners t).
    Proof.
      intros L. apply (WeightyCorner _ SameVertex w).
      pose proof (WeightNonNegative _ SameVertex w' t' v W'). lia.
    Qed.

    Lemma HeavyOuter v : weight w t v < weight w' t' v -> In v (TetCorners t').
    Proof.
      intros L. apply (WeightyCorner _ SameVertex w').
      pose proof (WeightNonNegative _ SameVertex w t v W). lia.
    Qed.

    (** At an inner end. *)
    Lemma MadeOuter c v : In c (Ends v) -> weight w' t' v < weight w t v ->
      exists u, weight w t u < weight w' t' u /\
        (u = Corner c \/ (exists m, u = Cut c m) \/ exists a, u = Cut a c).
    Proof.
      intros C L. pose proof (HeavyInner v L) as I.
      destruct (Balance _ SameVertex w' t' w t (share c) v W' (eq_sym (Same _)))
        as (u & P & H); [intros x [X|X]; apply SharesNonNegative; auto| |exact L|].
      - apply SharePositive; [apply InnerSound, I|exact C].
      - exists u. split; [exact H|]. apply ShareSound; [|exact P].
        apply OuterSound, HeavyOuter, H.
    Qed.

    (** At an outer end. *)
    Lemma MadeInner c v : In c (Ends v) -> weight w t v < weight w' t' v ->
      exists u, weight w' t' u < weight w t u /\
        (u = Corner c \/ (exists m, u = Cut c m) \/ exists a, u = Cut a c).
    Proof.
      intros C L. pose proof (HeavyOuter v L) as I.
      destruct (Balance _ SameVertex w t w' t' (share c) v W (Same _))
        as (u & P & H); [intros x [X|X]; apply SharesNonNegative; auto| |exact L|].
      - apply SharePositive; [apply OuterSound, I|exact C].
      - exists u. split; [exact H|]. apply ShareSound; [|exact P].
        apply InnerSound, HeavyInner, H.
    Qed.

    Lemma NextOuter a m : weight w' t' (Cut a m) < weight w t (Cut a m) ->
      exists n, weight w t (Cut a n) < weight w' t' (Cut a n).
    Proof.
      intros L. destruct (InnerHas _ (HeavyInner _ L)) as [_ [A _]].
      destruct (MadeOuter a (Cut a m)) as (u & H & [->|[[n ->]|[b ->]]]);
        [left; reflexivity|exact L| | |].
      - destruct (OuterHas _ (HeavyOuter _ H)) as [_ N]. contradiction.
      - exists n. exact H.
      - destruct (OuterHas _ (HeavyOuter _ H)) as [_ [_ N]]. congruence.
    Qed.

    Lemma NextInner a n : weight w t (Cut a n) < weight w' t' (Cut a n) ->
      exists b, weight w' t' (Cut b n) < weight w t (Cut b n).
    Proof.
      intros L. destruct (OuterHas _ (HeavyOuter _ L)) as [_ [_ N]].
      destruct (MadeInner n (Cut a n)) as (u & H & [->|[[m ->]|[b ->]]]);
        [right; left; reflexivity|exact L| | |].
      - destruct (InnerHas _ (HeavyInner _ H)) as [_ K]. contradiction.
      - destruct (InnerHas _ (HeavyInner _ H)) as [_ [K _]]. congruence.
      - exists b. exact H.
    Qed.

    Lemma NotHeavier a m : ~ weight w' t' (Cut a m) < weight w t (Cut a m).
    Proof.
      intros Am. destruct (NextOuter a m Am) as [n An]. destruct (NextInner a n An) as [b Bn].
      destruct (NextOuter b n Bn) as [k Bk]. destruct (NextInner b k Bk) as [e Ek].
      pose proof (HeavyInner _ Am) as Iam. pose proof (HeavyInner _ Bn) as Ibn.
      pose proof (HeavyInner _ Ek) as Iek.
      pose proof (HeavyOuter _ An) as Oan. pose proof (HeavyOuter _ Bk) as Obk.
      destruct (InnerHas _ Iam) as [Kam [Sa Sm]]. destruct (InnerHas _ Ibn) as [Kbn [Sb Sn]].
      destruct (InnerHas _ Iek) as [Kek [_ Sk]]. cbn [Ends In] in Kam, Kbn, Kek.
      assert (Ca : In a (Corners tid)) by (apply Kam; auto).
      assert (Cm : In m (Corners tid)) by (apply Kam; auto).
      assert (Cb : In b (Corners tid)) by (apply Kbn; auto).
      assert (Cn : In n (Corners tid)) by (apply Kbn; auto).
      assert (Ck : In k (Corners tid)) by (apply Kek; auto).
      assert (Nmn : m <> n) by (intros ->; lia).
      assert (Nab : a <> b) by (intros ->; lia).
      assert (Nkn : k <> n) by (intros ->; lia).
      assert (k = m).
      { assert (I : incl (Corners tid) [a; b; m; n]).
        { apply CornersAre; [|reflexivity|].
          - apply FourApart. repeat split; congruence.
          - intros v. cbn [In]. intros [<-|[<-|[<-|[<-|[]]]]]; assumption. }
        destruct (I k Ck) as [<-|[<-|[<-|[<-|[]]]]]; congruence. }
      subst k.
      pose proof (InnerJoins a m b n Iam Ibn Nab Nmn) as R.
      pose proof (OuterJoins a n b m Oan Obk Nab (not_eq_sym Nmn)) as R'.
      assert (Nam : a <> m) by congruence. assert (Nan : a <> n) by congruence.
      assert (Nbm : b <> m) by congruence. assert (Nbn : b <> n) by congruence.
      pose proof (OppositeRanks tid Even a b m n Ca Cb Cm Cn Nab Nmn Nam Nan Nbm Nbn) as P.
      pose proof (OppositeRanks tid Even a b n m Ca Cb Cn Cm Nab (not_eq_sym Nmn)
        Nan Nam Nbn Nbm) as Q.
      rewrite (RankMutual tid n a), (RankMutual tid n b) in R' by assumption.
      pose proof (RanksDiffer tid Even a b m Ca Cb Cm Nab Nam Nbm) as D.
      apply D. lia.
    Qed.

    Lemma CutsAgree a m : weight w t (Cut a m) = weight w' t' (Cut a m).
    Proof.
      destruct (Z.lt_total (weight w t (Cut a m)) (weight w' t' (Cut a m))) as [L|[E|L]];
        [|exact E|destruct (NotHeavier a m L)].
      destruct (NextInner a m L) as [b H]. destruct (NotHeavier b m H).
    Qed.

    Lemma CornersAgree c : weight w t (Corner c) = weight w' t' (Corner c).
    Proof.
      destruct (Z.lt_total (weight w t (Corner c)) (weight w' t' (Corner c)))
        as [L|[E|L]]; [|exact E|].
      - destruct (MadeInner c (Corner c)) as (u & H & [->|[[m ->]|[a ->]]]);
          [left; reflexivity|exact L|lia| |]; rewrite CutsAgree in H; lia.
      - destruct (MadeOuter c (Corner c)) as (u & H & [->|[[m ->]|[a ->]]]);
          [left; reflexivity|exact L|lia| |]; rewrite CutsAgree in H; lia.
    Qed.

    Lemma BothSame : SameWeights w t w' t'.
    Proof.
      apply (EqualWeights MeshVertex SameVertex).
      intros [c|a m]; [apply CornersAgree|apply CutsAgree].
    Qed.
  End Two.

  (** ** The two meshes *)

  Local Notation place := (PlacedPosition warping cut).
  Local Notation other := (OtherSigns before).

  Lemma OtherCutsInside : CutsInside other warping (OtherCuts cut).
  Proof.
    intros v d u A M. rewrite AfterNegated in A, M.
    assert (Sv : after v = Minus) by (destruct (after v); discriminate || reflexivity).
    assert (Su : after u = Plus) by (destruct (after u); discriminate || reflexivity).
    destruct (AdjacentMutual v u (ex_intro _ d eq_refl)) as [e E].
    unfold OtherCuts. pose proof (Cuts u e) as K. cbv zeta in K.
    rewrite <- E in K. specialize (K Su Sv). lia.
  Qed.

  Lemma OtherShare g v : Share (OtherCuts cut) g v = Share cut g (NameHere v).
  Proof. destruct v as [c|a m]; [reflexivity|]. cbn [Share NameHere]. unfold OtherCuts. ring. Qed.

  Lemma OtherHas tid t0 : InLattice tid -> In t0 (PlacedNames other warping tid) ->
    let t := MapTet NameHere t0 in
    (forall v, In v (TetCorners t) ->
       (forall c, In c (Ends v) -> In c (Corners tid)) /\
       match v with
       | Corner c => after c <> Plus
       | Cut a m => after a = Plus /\ after m = Minus
       end) /\
    (forall a m b n, In (Cut a m) (TetCorners t) -> In (Cut b n) (TetCorners t) ->
       a <> b -> m <> n -> EdgeRank m a <= EdgeRank m b).
  Proof.
    intros E I t. destruct (StuffedFollows other warping tid t0 E I) as [B J].
    assert (N : forall v, In v (TetCorners t) -> exists u, v = NameHere u /\ In u (TetCorners t0)).
    { intros v V. unfold t in V. destruct t0 as [p q r s]. cbn [MapTet TetCorners In] in *.
      destruct V as [<-|[<-|[<-|[<-|[]]]]]; eexists; (split; [reflexivity|]); tauto. }
    assert (C : forall a m, In (Cut a m) (TetCorners t) -> In (Cut m a) (TetCorners t0)).
    { intros a m V. destruct (N _ V) as ([c|b n] & Eq & U); cbn [NameHere] in Eq;
        [discriminate Eq|]. injection Eq as -> ->. exact U. }
    split.
    - intros v V. destruct (N v V) as (u & -> & U). specialize (B u U).
      destruct u as [c|a m]; cbn [NameHere Belongs Ends In] in *.
      + destruct B as [Ic Nc]. split; [intros x [<-|[]]; exact Ic|].
        rewrite AfterNegated in Nc. destruct (after c); cbn in Nc; congruence.
      + destruct B as (Ia & Im & Sa & Sm). rewrite AfterNegated in Sa, Sm.
        split; [intros x [<-|[<-|[]]]; assumption|].
        split; [destruct (after m)|destruct (after a)]; discriminate || reflexivity.
    - intros a m b n V V' Nab Nmn. exact (J _ _ (C a m V) (C b n V') Nmn Nab).
  Qed.

  Lemma KeptMeet tid tid' t t' :
    KeepsShortEdges (fun v => WarpedPosition v (warping v)) ->
    InLattice tid -> InLattice tid' ->
    In t (PlacedNames before warping tid) -> In t' (OtherNames before warping tid') ->
    MeetInSharedVertices place t t'.
  Proof.
    intros Keeps E E' I I' w w' W W' T X.
    unfold OtherNames in I'. apply in_map_iff in I'. destruct I' as (t0 & <- & I').
    destruct (StuffedFollows before warping tid t E I) as [B J].
    destruct (StuffedFollows other warping tid' t0 E' I') as [B' _].
    destruct (OtherHas tid' t0 E' I') as [H' J'].
    apply (BothSame tid w t tid' w' (MapTet NameHere t0)); try assumption.
    - intros v V. specialize (B v V). destruct v as [c|a m]; cbn [Belongs Ends In] in *.
      + split; [intros x [<-|[]]; apply B|apply B].
      + destruct B as (Ia & Im & Sa & Sm).
        split; [intros x [<-|[<-|[]]]; assumption|split; assumption].
    - intros a m b n V V' Nab Nmn. exact (J _ _ V V' Nab Nmn).
    - destruct (CarriesTet before warping cut Cuts tid w t W B) as (u & Un & Tu & Eu).
      destruct (CarriesTet other warping (OtherCuts cut) OtherCutsInside tid' w' t0 W' B')
        as (u' & Un' & Tu' & Eu').
      assert (Eu2 : forall g, Weigh g u' (LatticeTet tid')
        = Weigh (Share cut g) w' (MapTet NameHere t0)).
      { intros g. rewrite Eu', WeighMap. destruct w', t0. cbn [Weigh].
        rewrite !OtherShare. reflexivity. }
      intros g. rewrite <- Eu, <- Eu2. revert g.
      apply (LatticeEmbeds _ Keeps tid tid' E E' u u' Un Un'); [congruence|].
      change (fun v => WarpedPosition v (warping v)) with (fun c => place (Corner c)).
      assert (Straight : forall before' cut' a m f, Axis f ->
        PlacedSign before' warping (Corner a) = Plus ->
        PlacedSign before' warping (Corner m) = Minus ->
        Share cut' (fun c => f (PlacedPosition warping cut' (Corner c))) (Cut a m)
        = Steps * f (PlacedPosition warping cut' (Cut a m)))
        by (intros; apply (ShareOfCut before'); assumption).
      apply ByAxis. intros f F.
      rewrite (PointByAxis (fun c => place (Corner c)) f u _ F),
        (PointByAxis (fun c => place (Corner c)) f u' _ F).
      rewrite Eu, Eu'.
      rewrite (SharesOfPoint before warping cut place (Straight before cut) (Corners tid)
        f w t F B).
      change (fun c => f (place (Corner c)))
        with (fun c => f (PlacedPosition warping (OtherCuts cut) (Corner c))).
      rewrite (SharesOfPoint other warping (OtherCuts cut) _ (Straight other (OtherCuts cut))
        (Corners tid') f w' t0 F B').
      rewrite <- (PointByAxis place f w t F),
        <- (PointByAxis (PlacedPosition warping (OtherCuts cut)) f w' t0 F).
      rewrite <- OtherSidePlaced, X. reflexivity.
  Qed.

  Theorem TwoSidesMeet tid tid' t t' :
    MovesAtMost AngleThresholds warping -> Uncrossed warping ->
    InLattice tid -> InLattice tid' ->
    In t (PlacedNames before warping tid) -> In t' (OtherNames before warping tid') ->
    MeetInSharedVertices place t t'.
  Proof. intros M U. apply KeptMeet, UncrossedKeepsShortEdges; assumption. Qed.

  (** What they share is on the surface. *)
  Theorem TwoSidesShare tid tid' t t' v : InLattice tid -> InLattice tid' ->
    In t (PlacedNames before warping tid) -> In t' (OtherNames before warping tid') ->
    In v (TetCorners t) -> In v (TetCorners t') ->
    PlacedSign before warping v = OnSurface.
  Proof.
    intros E E' I I' V V'. unfold OtherNames in I'. apply in_map_iff in I'.
    destruct I' as (t0 & <- & I'). destruct v as [c|a m]; [|reflexivity].
    destruct (proj1 (StuffedFollows before warping tid t E I) _ V) as [_ N].
    destruct (proj1 (OtherHas tid' t0 E' I') _ V') as [_ N'].
    unfold SignAfter in N'. destruct (PlacedSign before warping (Corner c)); congruence.
  Qed.
End Mesh.

Theorem WarpedTwoSidesMeet long short sign cut tid tid' t t' :
  0 < long <= 64 -> 0 < short <= 128 -> CutsOnEdges sign cut ->
  let warping := WarpVertex (TH long short) sign cut in
  InLattice tid -> InLattice tid' ->
  In t (PlacedNames sign warping tid) -> In t' (OtherNames sign warping tid') ->
  MeetInSharedVertices (PlacedPosition warping cut) t t'.
Proof.
  intros L S C warping. apply KeptMeet.
  - exact (ThresholdsInside long short sign cut L S C).
  - apply (WarpKeepsShortEdges (TH long short) sign cut); [|exact C].
    cbn [MovesLittle]. lia.
Qed.
