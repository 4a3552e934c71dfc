(** * Who becomes 0 by a strict disk leaves the others their strict disks *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Angles.Cases.Isometry Embedding.GreedyProof
  Embedding.LeavingProof Embedding.LinkProof Topology.DiskPointProof.

(** The last step of a walk to [v]. *)
Lemma LastStep {V} (inside : V -> Prop) next (u v : V) : Joined inside next u v ->
  u <> v -> exists w, inside w /\ next w v.
Proof.
  intros J N. destruct J as [v I|u w v J T I]; [congruence|].
  exists w. apply JoinedInside in J. tauto.
Qed.

(** If [v] leaves a part that hangs together, and its neighbours there hang
    together, the rest does. *)
Lemma RestJoined (here : Coord3 -> Prop) v :
  (forall x y, here x -> here y -> Joined here Adjacent x y) ->
  here v ->
  (forall x y, Adjacent v x -> Adjacent v y -> here x -> here y ->
     Joined (fun w => (here w /\ w <> v) /\ Adjacent v w) Adjacent x y) ->
  forall x y, here x -> x <> v -> here y -> y <> v ->
    Joined (fun w => here w /\ w <> v) Adjacent x y.
Proof.
  intros J V Around x y X Nx Y Ny.
  destruct (LastStep here Adjacent x v (J x v X V) Nx) as (w & W & T).
  assert (L : Leaves Adjacent v here (fun w => here w /\ w <> v)).
  { split; [exact V|]. split; [tauto|]. split; [tauto|]. split.
    - exists w. split; [apply AdjacentMutual, T|]. split; [exact W|].
      intros ->. exact (NeverAdjacent v T).
    - intros a b Na Nb [A _] [B _]. apply Around; assumption. }
  apply (LeavingKeepsPieces _ _ SamePoint3 AdjacentMutual v here _ L x y); auto.
Qed.

Section Same.
  Variables s s' : SignField.

  (** Only the neighbours count. *)
  Lemma PointDiskSame z : (forall x, Adjacent z x -> s' x = s x) ->
    PointDisk s z -> PointDisk s' z.
  Proof.
    intros E (P & N & G & W). split; [|split; [|split]].
    - destruct P as [(x & Zx & Px) J]. split; [exists x; rewrite E; auto|].
      intros u w Zu Hu Zw Hw. rewrite E in Hu, Hw by assumption.
      apply (JoinedWider (fun w => Adjacent z w /\ s w = Plus));
        [intros y [Y S]; rewrite E; auto|auto].
    - destruct N as [(x & Zx & Px) J]. split; [exists x; rewrite E; auto|].
      intros u w Zu Hu Zw Hw. rewrite E in Hu, Hw by assumption.
      apply (JoinedWider (fun w => Adjacent z w /\ s w <> Plus));
        [intros y [Y S]; rewrite E; auto|auto].
    - intros y Zy Sy. rewrite E in Sy by assumption.
      destruct (G y Zy Sy) as [(x & Zx & Yx & Nx) J].
      split; [exists x; rewrite E; auto|].
      intros u w Zu Yu Su Zw Yw Sw. rewrite E in Su, Sw by assumption.
      apply (JoinedWider (fun w => Adjacent z w /\ Adjacent y w /\ s w = Plus));
        [intros v (V & V' & V''); rewrite E; auto|auto].
    - intros y y' p q Zy Zy' Yy' Sy Sy' Zp Yp Y'p Sp Zq Yq Y'q Sq.
      rewrite E in Sy, Sy', Sp, Sq by assumption.
      apply (W y y'); assumption.
  Qed.
End Same.

(** ** One *)

Section One.
  Variables (s s' : SignField) (v : Coord3).
  Hypothesis Others : forall x, x <> v -> s' x = s x.
  Hypothesis Now : s' v = OnSurface.
  Hypothesis Before : s v <> OnSurface.
  Hypothesis Disk : PointDisk s v.

  Lemma PlusStays x : s' x = Plus -> s x = Plus /\ x <> v.
  Proof.
    intros P. assert (N : x <> v) by (intros ->; congruence).
    rewrite Others in P by exact N. auto.
  Qed.

  Lemma ZeroWas x : s' x = OnSurface -> x = v \/ s x = OnSurface /\ x <> v.
  Proof.
    intros Z. destruct (SamePoint3 x v) as [E|N]; [auto|].
    rewrite Others in Z by exact N. auto.
  Qed.

  Lemma OuterStays x : s x <> Plus -> s' x <> Plus.
  Proof. intros N P. apply PlusStays in P. tauto. Qed.

  Section Neighbor.
    Variable z : Coord3.
    Hypothesis Next : Adjacent z v.
    Hypothesis ZeroZ : s z = OnSurface.
    Hypothesis DiskZ : PointDisk s z.
    Hypothesis Inner : exists p, Adjacent z p /\ s' p = Plus.

    Lemma RingAt : GoodEdge s v z.
    Proof.
      apply Disk; [apply AdjacentMutual, Next|exact ZeroZ].
    Qed.

    Lemma InnerWhole : Whole z (fun x => s' x = Plus).
    Proof.
      split; [exact Inner|]. intros x y Zx Px Zy Py.
      apply PlusStays in Px, Py. destruct Px as [Px Nx], Py as [Py Ny].
      destruct DiskZ as ([_ J] & _).
      apply (JoinedSame (fun w => Adjacent z w /\ s' w = Plus)
        (fun w => (Adjacent z w /\ s w = Plus) /\ w <> v)).
      { intros w. split.
        - intros [Zw P]. apply PlusStays in P. tauto.
        - intros [[Zw P] N]. rewrite Others; auto. }
      destruct (s v) eqn:Sv; [|congruence|].
      - apply (RestJoined (fun w => Adjacent z w /\ s w = Plus) v); try tauto.
        + intros a b [Za Pa] [Zb Pb]. apply J; assumption.
        + intros a b Va Vb [Za Pa] [Zb Pb]. destruct RingAt as [_ R].
          apply (JoinedWider (fun w => Adjacent v w /\ Adjacent z w /\ s w = Plus));
            [|apply R; assumption].
          intros w (Vw & Zw & Pw). repeat split; try assumption.
          intros ->. exact (NeverAdjacent v Vw).
      - apply (JoinedWider (fun w => Adjacent z w /\ s w = Plus)); [|apply J; assumption].
        intros w [Zw Pw]. repeat split; try assumption. intros ->. congruence.
    Qed.

    Lemma OuterWhole : Whole z (fun x => s' x <> Plus).
    Proof.
      split; [exists v; split; [exact Next|congruence]|].
      destruct DiskZ as (_ & [_ J] & _). destruct RingAt as [(o & Vo & Zo & No) _].
      assert (Old : forall x y, Adjacent z x -> s x <> Plus -> Adjacent z y -> s y <> Plus ->
        Joined (fun w => Adjacent z w /\ s' w <> Plus) Adjacent x y).
      { intros x y Zx Nx Zy Ny.
        apply (JoinedWider (fun w => Adjacent z w /\ s w <> Plus)); [|apply J; assumption].
        intros w [Zw Nw]. split; [exact Zw|apply OuterStays, Nw]. }
      assert (To : forall x, Adjacent z x -> s' x <> Plus ->
        Joined (fun w => Adjacent z w /\ s' w <> Plus) Adjacent x o).
      { intros x Zx Nx. destruct (SamePoint3 x v) as [->|Nv].
        - apply JoinedNext; [auto|exact Vo|]. split; [exact Zo|apply OuterStays, No].
        - apply Old; try assumption. rewrite <- Others; assumption. }
      intros x y Zx Nx Zy Ny.
      apply (JoinedThen _ _ _ x o y); [apply To; assumption|].
      apply JoinedBack; [exact AdjacentMutual|apply To; assumption].
    Qed.

    Lemma EdgesGood y : Adjacent z y -> s' y = OnSurface -> GoodEdge s' z y.
    Proof.
      intros Zy Sy. destruct (ZeroWas y Sy) as [->|[Zero Ny]].
      - destruct RingAt as [(x & Vx & Zx & Nx) J]. split.
        + exists x. repeat split; auto. apply OuterStays, Nx.
        + intros a b Za Va Pa Zb Vb Pb. apply PlusStays in Pa, Pb.
          apply (JoinedWider (fun w => Adjacent v w /\ Adjacent z w /\ s w = Plus)).
          * intros w (Vw & Zw & Pw). repeat split; try assumption.
            rewrite Others; [exact Pw|]. intros ->. exact (NeverAdjacent v Vw).
          * apply J; tauto.
      - destruct DiskZ as (_ & _ & G & _). destruct (G y Zy Zero) as [(x & Zx & Yx & Nx) J].
        split; [exists x; auto using OuterStays|].
        intros a b Za Ya Pa Zb Yb Pb.
        apply PlusStays in Pa, Pb. destruct Pa as [Pa Na], Pb as [Pb Nb].
        set (here := fun w => Adjacent z w /\ Adjacent y w /\ s w = Plus) in *.
        apply (JoinedSame (fun w => Adjacent z w /\ Adjacent y w /\ s' w = Plus)
          (fun w => here w /\ w <> v)).
        { intros w. unfold here. split.
          - intros (Zw & Yw & P). apply PlusStays in P. tauto.
          - intros [(Zw & Yw & P) N]. rewrite Others; auto. }
        assert (Here : here v \/ ~ here v).
        { unfold here.
          destruct (s v) eqn:Sv; [|congruence|right; intros (_ & _ & F); discriminate F].
          destruct (in_dec SamePoint3 v (map (fun d => Translate y (Offset d)) AllDirections))
            as [I|O].
          - left. apply in_map_iff in I. destruct I as (d & E & _).
            repeat split; try assumption. exists d. symmetry. exact E.
          - right. intros (_ & [d E] & _). apply O, in_map_iff. exists d.
            split; [symmetry; exact E|apply InAllDirections]. }
        destruct Here as [H|H].
        + apply (RestJoined here v); try assumption.
          * intros u w (Zu & Yu & Pu) (Zw & Yw & Pw). apply J; assumption.
          * intros u w Vu Vw (Zu & Yu & Pu) (Zw & Yw & Pw).
            destruct H as (_ & Yv & _). destruct Disk as (_ & _ & _ & W).
            assert (u = w) as <-.
            { apply (W z y u w); auto using AdjacentMutual. }
            constructor. unfold here. repeat split; try assumption.
            intros ->. exact (NeverAdjacent v Vu).
          * unfold here. auto.
          * unfold here. auto.
        + apply (JoinedWider here); [|apply J; assumption].
          intros w Hw. split; [exact Hw|]. intros ->. contradiction.
    Qed.

    Lemma NoWalls y y' p q : Adjacent z y -> Adjacent z y' -> Adjacent y y' ->
      s' y = OnSurface -> s' y' = OnSurface ->
      Adjacent z p -> Adjacent y p -> Adjacent y' p -> s' p = Plus ->
      Adjacent z q -> Adjacent y q -> Adjacent y' q -> s' q = Plus -> p = q.
    Proof.
      intros Zy Zy' Yy' Sy Sy' Zp Yp Y'p Pp Zq Yq Y'q Pq.
      apply PlusStays in Pp, Pq. destruct Pp as [Pp _], Pq as [Pq _].
      destruct (ZeroWas y Sy) as [->|[Zero Ny]].
      - destruct (ZeroWas y' Sy') as [->|[Zero' _]]; [destruct (NeverAdjacent v Yy')|].
        destruct Disk as (_ & _ & _ & W). apply (W z y' p q); auto using AdjacentMutual.
      - destruct (ZeroWas y' Sy') as [->|[Zero' _]].
        + destruct Disk as (_ & _ & _ & W). apply (W z y p q); auto using AdjacentMutual.
        + destruct DiskZ as (_ & _ & _ & W). apply (W y y' p q); assumption.
    Qed.

    Lemma NeighborKept : PointDisk s' z.
    Proof.
      split; [exact InnerWhole|]. split; [exact OuterWhole|].
      split; [exact EdgesGood|exact NoWalls].
    Qed.
  End Neighbor.

  Theorem DiskKept : DisksAround s -> DisksAround s'.
  Proof.
    intros D z Zero [d P]. apply (PointDiskIff s' z).
    assert (Far : ~ Adjacent z v -> PointDisk s z -> PointDisk s' z).
    { intros F. apply PointDiskSame. intros x Zx. apply Others. intros ->. contradiction. }
    destruct (ZeroWas z Zero) as [->|[ZeroZ Nz]].
    - apply Far; [apply NeverAdjacent|exact Disk].
    - assert (DiskZ : PointDisk s z).
      { apply PointDiskIff, D; [exact ZeroZ|]. exists d. apply PlusStays, P. }
      destruct (in_dec SamePoint3 v (map (fun d => Translate z (Offset d)) AllDirections))
        as [I|O].
      + apply in_map_iff in I. destruct I as (e & E & _).
        apply NeighborKept; try assumption; [exists e; symmetry; exact E|].
        exists (Translate z (Offset d)). split; [exists d; reflexivity|exact P].
      + apply Far; [|exact DiskZ]. intros [e E]. apply O, in_map_iff. exists e.
        split; [symmetry; exact E|apply InAllDirections].
  Qed.
End One.

(** ** Many at once *)

Section Many.
  Variable s : SignField.

  Definition Zeroed (vs : list Coord3) : SignField :=
    fun x => if in_dec SamePoint3 x vs then OnSurface else s x.

  Lemma ManyKept vs : DisksAround s ->
    (forall v, In v vs -> s v <> OnSurface /\
       StrictDisk (fun d => s (Translate v (Offset d))) = true) ->
    (forall u v, In u vs -> In v vs -> ~ Adjacent u v) ->
    DisksAround (Zeroed vs).
  Proof.
    intros D. induction vs as [|v vs IH]; intros V A.
    - intros z Z E. apply (PointDiskIff (Zeroed []) z).
      apply (PointDiskSame s); [reflexivity|]. apply PointDiskIff. apply D; assumption.
    - assert (D' : DisksAround (Zeroed vs))
        by (apply IH; intros; [apply V|apply A]; right; assumption).
      destruct (V v (or_introl eq_refl)) as [Nv Disk].
      destruct (in_dec SamePoint3 v vs) as [I|O].
      + intros z Z E. apply (PointDiskIff (Zeroed (v :: vs)) z).
        assert (Same : forall x, Zeroed (v :: vs) x = Zeroed vs x).
        { intros x. unfold Zeroed. destruct (in_dec SamePoint3 x (v :: vs)) as [X|X],
            (in_dec SamePoint3 x vs) as [Y|Y]; try reflexivity; exfalso; cbn [In] in X;
            [destruct X as [<-|X]; contradiction|tauto]. }
        apply (PointDiskSame (Zeroed vs)); [intros x _; apply Same|].
        apply PointDiskIff. apply D'; [rewrite <- Same; exact Z|].
        destruct E as [d E]. exists d. rewrite <- Same. exact E.
      + apply (DiskKept (Zeroed vs) _ v).
        * intros x N. unfold Zeroed. destruct (in_dec SamePoint3 x (v :: vs)) as [X|X],
            (in_dec SamePoint3 x vs) as [Y|Y]; try reflexivity; exfalso; cbn [In] in X;
            [destruct X as [E|X]; [congruence|contradiction]|tauto].
        * unfold Zeroed. destruct (in_dec SamePoint3 v (v :: vs)) as [|N]; [reflexivity|].
          destruct N. left. reflexivity.
        * unfold Zeroed. destruct (in_dec SamePoint3 v vs); [contradiction|exact Nv].
        * apply (PointDiskSame s); [|apply PointDiskIff, Disk].
          intros x X. unfold Zeroed. destruct (in_dec SamePoint3 x vs) as [Y|Y]; [|reflexivity].
          destruct (A v x); cbn [In]; auto.
        * exact D'.
  Qed.
End Many.

(** Any number of vertices, no two adjacent, may become 0 at once. *)
Theorem DisksAroundKept (s s' : SignField) : DisksAround s ->
  (forall v, s' v = s v \/ s' v = OnSurface /\ s v <> OnSurface /\
     StrictDisk (fun d => s (Translate v (Offset d))) = true) ->
  (forall u v, s' u <> s u -> s' v <> s v -> ~ Adjacent u v) ->
  DisksAround s'.
Proof.
  intros D C A z Zero Inner.
  assert (Sign : forall a b : Sign, {a = b} + {a <> b}) by decide equality.
  set (star := z :: map (fun d => Translate z (Offset d)) AllDirections).
  set (vs := filter (fun x => if Sign (s' x) (s x) then false else true) star).
  assert (Vs : forall x, In x vs <-> In x star /\ s' x <> s x).
  { intros x. unfold vs. rewrite filter_In. destruct (Sign (s' x) (s x)); intuition congruence. }
  assert (K : DisksAround (Zeroed s vs)).
  { apply ManyKept; [exact D| |].
    - intros v I. apply Vs in I. destruct (C v) as [E|(_ & N & S)]; [tauto|auto].
    - intros u v U V. apply Vs in U, V. apply A; tauto. }
  assert (Same : forall x, In x star -> s' x = Zeroed s vs x).
  { intros x X. unfold Zeroed. destruct (in_dec SamePoint3 x vs) as [I|O].
    - apply Vs in I. destruct (C x) as [E|(Z & _)]; [tauto|exact Z].
    - destruct (Sign (s' x) (s x)) as [E|N]; [exact E|]. destruct O. apply Vs. auto. }
  assert (Star : forall d, In (Translate z (Offset d)) star).
  { intros d. right. apply (in_map (fun d => Translate z (Offset d))), InAllDirections. }
  apply (PointDiskIff s' z). apply (PointDiskSame (Zeroed s vs)).
  - intros x [d ->]. apply Same, Star.
  - apply PointDiskIff. apply K; [rewrite <- Same; [exact Zero|left; reflexivity]|].
    destruct Inner as [d P]. exists d. rewrite <- Same; [exact P|apply Star].
Qed.
