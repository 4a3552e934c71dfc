(** * How many triangles of the surface an edge is in

    Two at a cut, as [CutEdgeProof] says.  At an edge between two 0 corners the
    ring around it is decisive: a triangle for each place where + begins or ends. *)

From Coq Require Import Arith.
From Coq Require Logic.FinFun.
From Certet Require Import Topology.Definitions.
From Certet Require Import Angles.Cases.Isometry Embedding.LinkProof
  Topology.CliqueProof Topology.LocalSurfaceProof
  Topology.SurfaceViewProof Topology.SurfaceProof
  Topology.RingProof Topology.CornersProof Topology.CutEdgeProof Topology.MeshSurfaceSpec.

Section Mesh.
  Variable mesh : SurfaceMesh.
  Local Notation after := (SignAfter (signs_before mesh) (warping_of mesh)).
  Local Notation triangle := (LocalTriangle mesh).
  Local Notation surface := (SurfaceOf (made mesh)).

  (** ** Between two 0 corners *)

  Section Zeros.
    Variables (a : Coord3) (d : Direction).
    Local Notation at_ e := (Translate a (Offset e)).
    Let now (e : Direction) : Sign := after (at_ e).
    Let b := at_ d.
    Let ends := Boundary now (RingPairs d).
    Let third (pair : Direction * Direction) : MeshVertex :=
      CrossingAt after (at_ (fst pair)) (at_ (snd pair)).

    Lemma InEnds e f : In (e, f) ends <->
      Adjacent b (at_ e) /\ Adjacent b (at_ f) /\ Adjacent (at_ e) (at_ f) /\
      after (at_ e) = Plus /\ after (at_ f) <> Plus /\
      (after (at_ f) = OnSurface -> forall e', Adjacent b (at_ e') ->
         Adjacent (at_ f) (at_ e') -> after (at_ e') = Plus -> e' = e).
    Proof.
      assert (C : forall e f, In (e, f) (Crossings now (RingPairs d)) <->
        Adjacent b (at_ e) /\ Adjacent b (at_ f) /\ Adjacent (at_ e) (at_ f) /\
        after (at_ e) = Plus /\ after (at_ f) <> Plus).
      { intros e' f'. unfold Crossings. rewrite filter_In, InRingPairs.
        unfold b. rewrite !(NextInLinkMeans a). unfold Crosses, IsInner, now.
        rewrite andb_true_iff. destruct (after (at_ e')), (after (at_ f')); cbn;
          intuition congruence. }
      unfold ends, Boundary. rewrite filter_In, C. unfold Bounds.
      rewrite orb_true_iff, forallb_forall.
      assert (Z : negb (IsZero now f) = true <-> after (at_ f) <> OnSurface).
      { unfold IsZero, now. destruct (after (at_ f)); cbn; intuition congruence. }
      rewrite Z. split.
      - intros ((Be & Bf & Ef & Pe & Pf) & O). repeat (split; [assumption|]).
        intros Zf e' Be' Fe' Pe'. destruct O as [O|O]; [congruence|].
        specialize (O (e', f) (proj2 (C e' f) (conj Be' (conj Bf
          (conj (AdjacentMutual _ _ Fe') (conj Pe' Pf)))))).
        cbv beta iota in O. rewrite SameDirectionRefl in O. cbn [negb orb] in O.
        symmetry. apply SameDirectionMeans, O.
      - intros (Be & Bf & Ef & Pe & Pf & O). split; [auto|].
        destruct (after (at_ f)) eqn:S; [congruence| |left; discriminate].
        right. intros [e' f'] I. apply C in I. destruct I as (Be' & _ & Ef' & Pe' & _).
        destruct (SameDirection f f') eqn:F; [|reflexivity].
        apply SameDirectionMeans in F. subst f'. cbn [negb orb].
        rewrite (O eq_refl e' Be' (AdjacentMutual _ _ Ef') Pe'). apply SameDirectionRefl.
    Qed.

    Hypothesis OfLattice : LatticePoint a.
    Hypothesis ZeroA : after a = OnSurface.
    Hypothesis ZeroB : after b = OnSurface.

    Lemma ZeroThird z : surface (Corner a) (Corner b) z <-> In z (map third ends).
    Proof.
      assert (Nab : a <> b).
      { intros E. apply (NeverAdjacent a). exists d. exact E. }
      assert (To : forall x, Adjacent a x -> exists e, x = at_ e)
        by (intros x [e ->]; eauto).
      rewrite in_map_iff. split.
      - intros T. destruct (SurfaceWhere mesh _ _ z T) as (tid & E & L).
        destruct (LocalOnIt mesh tid _ _ z E L) as ([[Ia _] _] & [[Ib _] _] & _).
        destruct (OtherTwo tid a b Ia Ib Nab) as (x & y & D & Ix & Iy).
        assert (exists e f, In (at_ e) (Corners tid) /\ In (at_ f) (Corners tid) /\
          NoDup [a; b; at_ e; at_ f] /\ after (at_ e) = Plus /\ after (at_ f) <> Plus /\
          z = CrossingAt after (at_ e) (at_ f)) as (e & f & Ie & If & De & Pe & Pf & ->).
        { pose proof (proj1 (FourApart _ _ _ _) D) as (_ & Ax & Ay & Bx & By & Xy).
          destruct (To x) as [e ->]; [apply (CornersAdjacent tid); assumption|].
          destruct (To y) as [f ->]; [apply (CornersAdjacent tid); assumption|].
          destruct (LocalZeroEdge mesh tid a b _ _ z E Ia Ib Ix Iy D L)
            as [(P & Q & ->)|(P & Q & ->)]; [exists e, f|exists f, e];
            repeat (split; [assumption|]); auto.
          split; [|auto]. apply FourApart. auto 8. }
        exists (e, f). split; [reflexivity|]. apply InEnds.
        pose proof (proj1 (FourApart _ _ _ _) De) as (_ & Ae & Af & Be & Bf & Ef).
        split; [apply (CornersAdjacent tid); assumption|].
        split; [apply (CornersAdjacent tid); assumption|].
        split; [apply (CornersAdjacent tid); assumption|].
        split; [exact Pe|]. split; [exact Pf|]. intros Zf e' Be' Fe' Pe'.
        unfold CrossingAt in T. rewrite Zf in T.
        destruct (SurfaceOfZeros mesh _ _ _ T)
          as (_ & _ & _ & _ & _ & _ & _ & x0 & _ & _ & _ & O).
        apply (OffsetsDiffer e' e a). transitivity x0; [|symmetry]; apply O.
        + repeat split; try assumption. exists e'. reflexivity.
        + repeat split; try exact Pe.
          * exists e. reflexivity.
          * apply (CornersAdjacent tid); assumption.
          * apply AdjacentMutual. apply (CornersAdjacent tid); assumption.
      - intros ([e f] & <- & I). apply InEnds in I.
        destruct I as (Be & Bf & Ef & Pe & Pf & O). unfold third. cbn [fst snd].
        destruct (CliqueIsTet a b (at_ e) (at_ f)) as (tid & E & G); try assumption;
          try (eexists; reflexivity).
        assert (De : NoDup [a; b; at_ e; at_ f]).
        { assert (Na : forall g, a <> at_ g)
            by (intros g K; apply (NeverAdjacent a); exists g; exact K).
          assert (Nb : forall g, Adjacent b (at_ g) -> b <> at_ g)
            by (intros g K K'; rewrite <- K' in K; exact (NeverAdjacent b K)).
          assert (Nef : at_ e <> at_ f) by congruence.
          apply FourApart. auto 8. }
        pose proof (proj1 (FourApart _ _ _ _) De) as (_ & Ae & Af & Be' & Bf' & Ef').
        assert (GI : In a (Corners tid) /\ In b (Corners tid) /\
          In (at_ e) (Corners tid) /\ In (at_ f) (Corners tid))
          by (repeat split; apply G; cbn; tauto).
        destruct GI as (Ga & Gb & Ge & Gf).
        destruct (after (at_ f)) eqn:Sf; [congruence| |].
        + unfold CrossingAt. rewrite Sf.
          apply (ZerosOnSurface mesh tid a b (at_ f) (at_ e)); try assumption;
            auto.
          * intros v. cbn [In]. intros [<-|[<-|[<-|[<-|[]]]]]; assumption.
          * intros x (Ax & Bx & Fx & Px). destruct (To x Ax) as [e' ->].
            rewrite (O eq_refl e' Bx Fx Px). reflexivity.
        + assert (L : triangle tid (Corner a) (CrossingAt after (at_ e) (at_ f)) (Corner b)).
          { replace (Corner b) with (CrossingAt after (at_ e) b)
              by (unfold CrossingAt; rewrite ZeroB; reflexivity).
            apply (LocalZeroFan mesh tid a b (at_ e) (at_ f)); try assumption;
              congruence. }
          apply (SurfaceTurned mesh).
          apply (SurfaceInside mesh tid _ _ _ E L).
          unfold CrossingAt. rewrite Sf. intros c C.
          assert (K : In c [a; b; at_ e; at_ f]).
          { revert c C. apply CornersAre; [exact De|reflexivity|exact G]. }
          cbn [In] in K. destruct K as [<-|[<-|[<-|[<-|[]]]]];
            [exists (Corner a)|exists (Corner b)|exists (Cut (at_ e) (at_ f))
            |exists (Cut (at_ e) (at_ f))]; cbn; tauto.
    Qed.

    Lemma ThirdsOnce : NoDup (map third ends).
    Proof.
      assert (N : NoDup ends) by (apply NoDup_filter, NoDup_filter, RingPairsOnce).
      assert (Inj : forall p q, In p ends -> In q ends -> third p = third q -> p = q).
      { intros [e f] [e' f'] I J Eq. unfold third in Eq. cbn [fst snd] in Eq.
        apply InEnds in I, J. destruct I as (_ & _ & _ & _ & Pf & O).
        destruct J as (Be' & _ & Ef' & Pe' & Pf' & _). unfold CrossingAt in Eq.
        destruct (after (at_ f)) eqn:Sf; [congruence| |];
          destruct (after (at_ f')) eqn:Sf'; try congruence; try discriminate Eq.
        - injection Eq as Eq. apply OffsetsDiffer in Eq. subst f'. f_equal. symmetry.
          apply O; auto using AdjacentMutual.
        - injection Eq as E1 E2. apply OffsetsDiffer in E1, E2. congruence. }
      revert N Inj. generalize ends as l. induction l as [|p l IH]; intros N Inj;
        [constructor|]. apply NoDup_cons_iff in N. destruct N as [Np N].
      cbn [map]. constructor.
      - intros I. apply in_map_iff in I. destruct I as (q & Eq & I).
        apply Np. rewrite (Inj p q); cbn [In]; auto.
      - apply IH; [exact N|]. intros q r Q R. apply Inj; cbn [In]; auto.
    Qed.
  End Zeros.

  (** ** Every edge *)

  Theorem EdgesInEven x y z : surface x y z ->
    exists thirds, NoDup thirds /\ (forall w, In w thirds <-> surface x y w) /\
      Nat.Even (length thirds).
  Proof.
    intros T.
    assert (Two : (exists z', z' <> z /\ surface x y z' /\
        forall z'', surface x y z'' -> z'' = z \/ z'' = z') ->
      exists thirds, NoDup thirds /\ (forall w, In w thirds <-> surface x y w) /\
        Nat.Even (length thirds)).
    { intros (z' & N & T' & U). exists [z; z'].
      split; [repeat constructor; cbn [In]; intros K; intuition|].
      split; [|exists 1%nat; reflexivity]. intros w. cbn [In]. split.
      - intros [<-|[<-|[]]]; assumption.
      - intros W. destruct (U w W); auto. }
    destruct x as [a|a m]; [destruct y as [b|b m]|];
      try (apply Two, (CutEdge mesh _ _ z T); intros ? ? E F; discriminate E || discriminate F).
    clear Two. destruct (SurfaceWhere mesh _ _ z T) as (tid & E & L).
    destruct (LocalOnIt mesh tid _ _ z E L) as ([[Ia _] Sa] & [[Ib _] Sb] & _).
    assert (Nab : a <> b) by (destruct L as [(t & _ & (_ & H & _)) _]; congruence).
    destruct (CornersAdjacent tid a b Ia Ib Nab) as [d ->].
    eexists. split; [exact (ThirdsOnce a d Sa Sb)|]. split.
    - intros w.
      pose proof (ZeroThird a d (ex_intro _ tid (conj E Ia)) Sa Sb w). tauto.
    - rewrite map_length. apply BoundaryEven.
  Qed.

  Theorem EdgesInTwo x y z : DisksAround after -> surface x y z ->
    exists z', z' <> z /\ surface x y z' /\
      forall z'', surface x y z'' -> z'' = z \/ z'' = z'.
  Proof.
    intros Disks T.
    destruct x as [a|a m]; [destruct y as [b|b m]|];
      try (apply (CutEdge mesh _ _ z T); intros ? ? E F; discriminate E || discriminate F).
    destruct (SurfaceWhere mesh _ _ z T) as (tid & E & L).
    destruct (LocalOnIt mesh tid _ _ z E L) as ([[Ia _] Sa] & [[Ib _] Sb] & _).
    assert (Nab : a <> b) by (destruct L as [(t & _ & (_ & H & _)) _]; congruence).
    destruct (CornersAdjacent tid a b Ia Ib Nab) as [d ->].
    assert (La : LatticePoint a) by (exists tid; auto).
    pose proof (fun w => ZeroThird a d La Sa Sb w) as Th.
    pose proof (ThirdsOnce a d Sa Sb) as N. pose proof (proj1 (Th z) T) as I.
    set (now := fun e => after (Translate a (Offset e))) in *.
    assert (Short : (length (Boundary now (RingPairs d)) <= 2)%nat).
    { apply GoodRingBounds. apply in_map_iff in I. destruct I as ([e f] & _ & I).
      apply InEnds in I. destruct I as (_ & _ & _ & P & _).
      pose proof (Disks a Sa (ex_intro _ e P)) as D.
      change (StrictDisk now = true) in D.
      unfold StrictDisk in D. apply andb_prop in D. destruct D as [_ D].
      rewrite forallb_forall in D. specialize (D d (InAllDirections d)).
      apply orb_prop in D. destruct D as [D|D].
      - unfold IsZero in D. unfold now in D. unfold SignAfter in D. rewrite Sb in D. discriminate D.
      - apply andb_prop in D. apply D. }
    pose proof (BoundaryEven now d) as Ev.
    rewrite <- (map_length (fun pair => CrossingAt after
      (Translate a (Offset (fst pair))) (Translate a (Offset (snd pair))))) in Short, Ev.
    destruct (map _ (Boundary now (RingPairs d))) as [|u [|v [|? ?]]].
    - destruct I.
    - destruct Ev as [k K]. cbn [length] in K. lia.
    - cbn [In] in Th, I. apply NoDup_cons_iff in N. cbn [In] in N.
      destruct I as [<-|[<-|[]]].
      + exists v. split; [intros ->; tauto|]. split; [apply Th; auto|].
        intros w W. apply Th in W. intuition.
      + exists u. split; [intros ->; tauto|]. split; [apply Th; auto|].
        intros w W. apply Th in W. intuition.
    - cbn [length] in Short. lia.
  Qed.
End Mesh.
