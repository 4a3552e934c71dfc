(** * The pieces of the samples are the pieces of the image: proof

    Even points are joined by long edges just as their voxels are by faces.  An odd
    point has an even one of its own voxel next to it, and joins no two groups. *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Angles.Cases.Isometry Embedding.LeavingProof
  Embedding.LinkProof.
Open Scope Z_scope.

(** ** Along one axis *)

Section Axis.
  Variables half s o : Z.
  Hypothesis Half : 0 < half.
  Hypothesis Fine : 2 * half <= s.

  Let index (x : Z) : Z := (o + half * x) / s.

  Lemma IndexIs x i : index x = i <-> i * s <= o + half * x < (i + 1) * s.
  Proof.
    unfold index. split.
    - intros <-. pose proof (Z.div_mod (o + half * x) s ltac:(lia)).
      pose proof (Z.mod_pos_bound (o + half * x) s ltac:(lia)). nia.
    - intros B. symmetry. apply (Z.div_unique_pos _ _ i (o + half * x - i * s)); lia.
  Qed.

  Lemma IndexRises x y : x <= y -> index x <= index y.
  Proof. intros L. unfold index. apply Z.div_le_mono; nia. Qed.

  Lemma IndexNext x : index (x + 2) = index x \/ index (x + 2) = index x + 1.
  Proof.
    pose proof (proj1 (IndexIs x _) eq_refl) as B.
    pose proof (IndexRises x (x + 2) ltac:(lia)).
    pose proof (proj1 (IndexIs (x + 2) _) eq_refl) as B'.
    assert (index (x + 2) < index x + 2) by nia. lia.
  Qed.

  (** One of the two points half an edge away is in the same voxel. *)
  Lemma IndexHalf x : index (x + 1) = index x \/ index (x - 1) = index x.
  Proof.
    pose proof (proj1 (IndexIs x _) eq_refl) as B.
    destruct (Z_lt_le_dec (o + half * (x + 1)) ((index x + 1) * s)) as [L|L];
      [left|right]; apply IndexIs; nia.
  Qed.

  Lemma IndexFound i : exists a, index (2 * a) = i.
  Proof.
    exists ((i * s - o + 2 * half - 1) / (2 * half)). apply IndexIs.
    set (n := i * s - o + 2 * half - 1).
    pose proof (Z.div_mod n (2 * half) ltac:(lia)).
    pose proof (Z.mod_pos_bound n (2 * half) ltac:(lia)). unfold n in *. nia.
  Qed.
End Axis.

(** A walk along an axis. *)
Lemma LineJoined (here : Coord3 -> Prop) (at_ : Z -> Coord3) :
  (forall n, Adjacent (at_ n) (at_ (n + 1))) ->
  forall n m, (forall k, n <= k <= m \/ m <= k <= n -> here (at_ k)) ->
    Joined here Adjacent (at_ n) (at_ m).
Proof.
  intros A.
  assert (Up : forall j n, 0 <= j -> (forall k, n <= k <= n + j -> here (at_ k)) ->
    Joined here Adjacent (at_ n) (at_ (n + j))).
  { intros j n J. revert j J. apply (natlike_ind (fun j => (forall k, n <= k <= n + j ->
      here (at_ k)) -> Joined here Adjacent (at_ n) (at_ (n + j)))).
    - intros H. rewrite Z.add_0_r. constructor. apply H. lia.
    - intros j J IH H. replace (n + Z.succ j) with ((n + j) + 1) by lia.
      apply (Joined_step _ _ _ (at_ (n + j))); [|apply A|apply H; lia].
      apply IH. intros k K. apply H. lia. }
  intros n m H. destruct (Z_le_gt_dec n m) as [L|L].
  - replace m with (n + (m - n)) by lia. apply Up; [lia|]. intros k K. apply H. lia.
  - apply JoinedBack; [exact AdjacentMutual|].
    replace n with (m + (n - m)) by lia. apply Up; [lia|]. intros k K. apply H. lia.
Qed.

Section Voxels.
  Variables (half sx sy sz ox oy oz : Z).
  Let grid := Grid half (C3 sx sy sz) (C3 ox oy oz).
  Variable image : Coord3 -> bool.

  Hypothesis Half : 0 < half.
  Hypothesis FineX : 2 * half <= sx.
  Hypothesis FineY : 2 * half <= sy.
  Hypothesis FineZ : 2 * half <= sz.

  Let ix x := (ox + half * x) / sx.
  Let iy y := (oy + half * y) / sy.
  Let iz z := (oz + half * z) / sz.
  Let owner := Owner grid.
  Let sign := VoxelSigns grid image.
  Let inside (x : Coord3) : Prop := image x = true.
  Local Notation voxels := (Joined inside Beside).
  Local Notation samples := (Joined (fun v => sign v = Plus) Adjacent).

  Lemma OwnerIs x y z : owner (C3 x y z) = C3 (ix x) (iy y) (iz z).
  Proof. reflexivity. Qed.

  Lemma PlusInside v : sign v = Plus -> inside (owner v).
  Proof.
    unfold sign, VoxelSigns, inside, InImage. destruct v as [x y z]. fold owner.
    destruct (image (owner (C3 x y z))); [reflexivity|discriminate].
  Qed.

  Lemma EvenPlus a y z : sign (C3 (2 * a) y z) = Plus <-> inside (owner (C3 (2 * a) y z)).
  Proof.
    unfold sign, VoxelSigns, inside, InImage. fold owner.
    rewrite Z.even_mul. cbn [Z.even orb]. rewrite andb_true_r.
    destruct (image _); intuition congruence.
  Qed.

  (** ** From samples to voxels *)

  Lemma LongOwners v d : DirectionKind d = Long -> inside (owner v) ->
    inside (owner (Translate v (Offset d))) ->
    voxels (owner v) (owner (Translate v (Offset d))).
  Proof.
    intros K V W.
    enough (E : owner (Translate v (Offset d)) = owner v \/
      Beside (owner v) (owner (Translate v (Offset d)))).
    { destruct E as [E|E]; [rewrite E; constructor; exact V|].
      apply JoinedNext; assumption. }
    clear V W. destruct v as [x y z].
    assert (Down : forall f : Z -> Z, (forall t, f (t + 2) = f t \/ f (t + 2) = f t + 1) ->
      forall t, f (t + -2) = f t \/ f (t + -2) = f t - 1).
    { intros f F t. destruct (F (t + -2)) as [E|E];
        replace (t + -2 + 2) with t in E by lia; lia. }
    pose proof (IndexNext half sx ox Half FineX) as X. fold ix in X.
    pose proof (IndexNext half sy oy Half FineY) as Y. fold iy in Y.
    pose proof (IndexNext half sz oz Half FineZ) as Z'. fold iz in Z'.
    pose proof (Down ix X x). pose proof (Down iy Y y). pose proof (Down iz Z' z).
    specialize (X x). specialize (Y y). specialize (Z' z).
    destruct d; try discriminate K; cbn [Offset Translate];
      rewrite !OwnerIs, ?Z.add_0_r; unfold Beside; cbn [Difference In].
    - destruct X as [E|E]; rewrite E; [left; reflexivity|right].
      left. f_equal; lia.
    - destruct H as [E|E]; rewrite E; [left; reflexivity|right].
      right; left. f_equal; lia.
    - destruct Y as [E|E]; rewrite E; [left; reflexivity|right].
      right; right; left. f_equal; lia.
    - destruct H0 as [E|E]; rewrite E; [left; reflexivity|right].
      right; right; right; left. f_equal; lia.
    - destruct Z' as [E|E]; rewrite E; [left; reflexivity|right].
      right; right; right; right; left. f_equal; lia.
    - destruct H1 as [E|E]; rewrite E; [left; reflexivity|right].
      right; right; right; right; right; left. f_equal; lia.
  Qed.

  (** A short edge leads from any point to a point of the same voxel. *)
  Lemma SameOwner v : exists d, DirectionKind d = Short /\
    owner (Translate v (Offset d)) = owner v.
  Proof.
    destruct v as [x y z].
    pose proof (IndexHalf half sx ox Half FineX x) as X. fold ix in X.
    pose proof (IndexHalf half sy oy Half FineY y) as Y. fold iy in Y.
    pose proof (IndexHalf half sz oz Half FineZ z) as Z'. fold iz in Z'.
    destruct X as [X|X], Y as [Y|Y], Z' as [Z'|Z'];
      [exists Dir_ppp|exists Dir_ppm|exists Dir_pmp|exists Dir_pmm
      |exists Dir_mpp|exists Dir_mpm|exists Dir_mmp|exists Dir_mmm];
      (split; [reflexivity|]); cbn [Offset Translate]; rewrite !OwnerIs;
      f_equal; assumption.
  Qed.

  (** The neighbours of an odd point that is + are of one piece. *)
  Lemma CubeJoined v d e :
    (match v with C3 x _ _ => Z.even x = false end) -> sign v = Plus ->
    DirectionKind d = Short -> DirectionKind e = Short ->
    inside (owner (Translate v (Offset d))) -> inside (owner (Translate v (Offset e))) ->
    voxels (owner (Translate v (Offset d))) (owner (Translate v (Offset e))).
  Proof.
    intros Odd P Kd Ke Id Ie.
    assert (C : CubeParted grid image v = false).
    { revert P. unfold sign, VoxelSigns. destruct v as [x y z]. rewrite Odd.
      cbn [orb]. destruct (CubeParted grid image (C3 x y z)); [|reflexivity].
      cbn [negb]. rewrite andb_false_r. discriminate. }
    assert (Cd : CubeInner grid image v d = true) by (unfold CubeInner; rewrite Kd; exact Id).
    assert (Ce : CubeInner grid image v e = true) by (unfold CubeInner; rewrite Ke; exact Ie).
    unfold CubeParted in C.
    rewrite (proj2 (existsb_exists _ _) (ex_intro _ d (conj (InAllDirections d) Cd))) in C.
    cbn [andb] in C. apply negb_false_iff in C.
    destruct (OnePieceMeans v _ C) as [_ J].
    assert (W : forall x y, Joined (InPart v (CubeInner grid image v)) Adjacent x y ->
      voxels (owner x) (owner y)).
    { assert (In_ : forall x, InPart v (CubeInner grid image v) x -> inside (owner x)).
      { intros x (f & -> & F). unfold CubeInner in F.
        destruct (DirectionKind f); [discriminate F|exact F]. }
      induction 1 as [x X|x y w K IH [f ->] X].
      - constructor. apply In_, X.
      - apply (JoinedThen _ _ _ _ (owner y)); [exact IH|].
        apply JoinedInside in K. destruct K as [_ Y].
        apply LongOwners; [|apply In_, Y|apply In_, X].
        destruct Y as (g & -> & G), X as (h & E & H). unfold CubeInner in G, H.
        destruct (DirectionKind g) eqn:Kg; [discriminate G|].
        destruct (DirectionKind h) eqn:Kh; [discriminate H|].
        clear -Kg Kh E. destruct v as [x y z].
        destruct f; try reflexivity; exfalso;
          destruct g; try discriminate Kg; destruct h; try discriminate Kh;
          cbn [Offset Translate] in E; injection E as Ex Ey Ez; lia. }
    apply W, J; [exists d|exists e]; auto.
  Qed.

  Lemma ShortOwners v d : DirectionKind d = Short ->
    (match v with C3 x _ _ => Z.even x = false end) -> sign v = Plus ->
    inside (owner (Translate v (Offset d))) ->
    voxels (owner v) (owner (Translate v (Offset d))).
  Proof.
    intros K Odd P I. destruct (SameOwner v) as (e & Ke & E). rewrite <- E.
    apply CubeJoined; try assumption. rewrite E. apply PlusInside, P.
  Qed.

  Lemma SamplesThenVoxels p q : samples p q -> voxels (owner p) (owner q).
  Proof.
    induction 1 as [p P|p q r J IH [d ->] R].
    - constructor. apply PlusInside, P.
    - apply (JoinedThen _ _ _ _ (owner q) _ IH).
      apply JoinedInside in J. destruct J as [_ Q].
      destruct (DirectionKind d) eqn:K.
      + apply LongOwners; [exact K|apply PlusInside, Q|apply PlusInside, R].
      + destruct (Z.even (match q with C3 x _ _ => x end)) eqn:E.
        * (* the other is odd *)
          assert (exists e, DirectionKind e = Short /\
            Translate (Translate q (Offset d)) (Offset e) = q) as (e & Ke & Back).
          { destruct q as [x y z]. destruct d; try discriminate K;
              [exists Dir_mmm|exists Dir_ppp|exists Dir_mmp|exists Dir_ppm
              |exists Dir_mpm|exists Dir_pmp|exists Dir_pmm|exists Dir_mpp];
              (split; [reflexivity|]); cbn [Offset Translate]; f_equal; lia. }
          apply JoinedBack.
          { intros u v. unfold Beside. destruct u as [a b c], v as [a' b' c'].
            cbn [Difference In]. intros B.
            repeat match type of B with _ \/ _ => destruct B as [B|B] end;
              try contradiction; injection B as B1 B2 B3.
            - right; left. f_equal; lia.
            - left. f_equal; lia.
            - right; right; right; left. f_equal; lia.
            - right; right; left. f_equal; lia.
            - right; right; right; right; right; left. f_equal; lia.
            - right; right; right; right; left. f_equal; lia. }
          rewrite <- Back at 2. apply ShortOwners; try assumption.
          -- destruct q as [x y z]. destruct d; try discriminate K; cbn [Offset Translate];
               rewrite Z.even_add, E; reflexivity.
          -- rewrite Back. apply PlusInside, Q.
        * apply ShortOwners; try assumption; [destruct q; exact E|apply PlusInside, R].
  Qed.

  (** ** From voxels to samples *)

  Definition EvenPoint (a b c : Z) : Coord3 := C3 (2 * a) (2 * b) (2 * c).

  Lemma EvenPointPlus a b c : sign (EvenPoint a b c) = Plus <->
    inside (C3 (ix (2 * a)) (iy (2 * b)) (iz (2 * c))).
  Proof. apply EvenPlus. Qed.

  Lemma NextX a b c : Adjacent (EvenPoint a b c) (EvenPoint (a + 1) b c).
  Proof. exists Dir_p00. unfold EvenPoint. cbn [Offset Translate]. f_equal; lia. Qed.

  Lemma NextY a b c : Adjacent (EvenPoint a b c) (EvenPoint a (b + 1) c).
  Proof. exists Dir_0p0. unfold EvenPoint. cbn [Offset Translate]. f_equal; lia. Qed.

  Lemma NextZ a b c : Adjacent (EvenPoint a b c) (EvenPoint a b (c + 1)).
  Proof. exists Dir_00p. unfold EvenPoint. cbn [Offset Translate]. f_equal; lia. Qed.

  (** Between two indices that are equal or next to each other there is no other. *)
  Lemma Between (f : Z -> Z) n m k : (forall x y, x <= y -> f x <= f y) ->
    (f (2 * m) = f (2 * n) \/ f (2 * m) = f (2 * n) + 1 \/ f (2 * m) = f (2 * n) - 1) ->
    n <= k <= m \/ m <= k <= n -> f (2 * k) = f (2 * n) \/ f (2 * k) = f (2 * m).
  Proof.
    intros R E B.
    assert (f (2 * n) <= f (2 * k) <= f (2 * m) \/ f (2 * m) <= f (2 * k) <= f (2 * n))
      by (destruct B; [left|right]; split; apply R; lia).
    lia.
  Qed.

  Let near (i j : Z) : Prop := j = i \/ j = i + 1 \/ j = i - 1.

  Lemma Along (line : Z -> Coord3) (f : Z -> Z) (full : Z -> Prop) n m :
    (forall k, Adjacent (line k) (line (k + 1))) -> (forall x y, x <= y -> f x <= f y) ->
    (forall k, sign (line k) = Plus <-> full (f (2 * k))) ->
    near (f (2 * n)) (f (2 * m)) ->
    sign (line n) = Plus -> sign (line m) = Plus -> samples (line n) (line m).
  Proof.
    intros Next R F N P Q. apply (LineJoined _ line); [exact Next|].
    intros k K. apply F. apply F in P, Q.
    destruct (Between f n m k R N K) as [E|E]; rewrite E; assumption.
  Qed.

  Lemma AlongX a a' b c : near (ix (2 * a)) (ix (2 * a')) ->
    sign (EvenPoint a b c) = Plus -> sign (EvenPoint a' b c) = Plus ->
    samples (EvenPoint a b c) (EvenPoint a' b c).
  Proof.
    exact (Along (fun a => EvenPoint a b c) ix
      (fun i => inside (C3 i (iy (2 * b)) (iz (2 * c)))) a a' (fun a => NextX a b c)
      (IndexRises half sx ox Half FineX) (fun a => EvenPointPlus a b c)).
  Qed.

  Lemma AlongY a b b' c : near (iy (2 * b)) (iy (2 * b')) ->
    sign (EvenPoint a b c) = Plus -> sign (EvenPoint a b' c) = Plus ->
    samples (EvenPoint a b c) (EvenPoint a b' c).
  Proof.
    exact (Along (fun b => EvenPoint a b c) iy
      (fun j => inside (C3 (ix (2 * a)) j (iz (2 * c)))) b b' (fun b => NextY a b c)
      (IndexRises half sy oy Half FineY) (fun b => EvenPointPlus a b c)).
  Qed.

  Lemma AlongZ a b c c' : near (iz (2 * c)) (iz (2 * c')) ->
    sign (EvenPoint a b c) = Plus -> sign (EvenPoint a b c') = Plus ->
    samples (EvenPoint a b c) (EvenPoint a b c').
  Proof.
    exact (Along (fun c => EvenPoint a b c) iz
      (fun k => inside (C3 (ix (2 * a)) (iy (2 * b)) k)) c c' (fun c => NextZ a b c)
      (IndexRises half sz oz Half FineZ) (fun c => EvenPointPlus a b c)).
  Qed.

  Lemma OwnerOfEven a b c :
    owner (EvenPoint a b c) = C3 (ix (2 * a)) (iy (2 * b)) (iz (2 * c)).
  Proof. reflexivity. Qed.

  (** Even points of one voxel. *)
  Lemma OneVoxel a b c a' b' c' :
    owner (EvenPoint a' b' c') = owner (EvenPoint a b c) ->
    sign (EvenPoint a b c) = Plus -> samples (EvenPoint a b c) (EvenPoint a' b' c').
  Proof.
    rewrite !OwnerOfEven. intros E P.
    assert (X : ix (2 * a') = ix (2 * a)) by congruence.
    assert (Y : iy (2 * b') = iy (2 * b)) by congruence.
    assert (Z' : iz (2 * c') = iz (2 * c)) by congruence.
    assert (P1 : sign (EvenPoint a' b c) = Plus)
      by (apply EvenPointPlus; rewrite X; apply EvenPointPlus, P).
    assert (P2 : sign (EvenPoint a' b' c) = Plus)
      by (apply EvenPointPlus; rewrite X, Y; apply EvenPointPlus, P).
    assert (P3 : sign (EvenPoint a' b' c') = Plus)
      by (apply EvenPointPlus; rewrite X, Y, Z'; apply EvenPointPlus, P).
    apply (JoinedThen _ _ _ _ (EvenPoint a' b c)); [apply AlongX; unfold near; auto|].
    apply (JoinedThen _ _ _ _ (EvenPoint a' b' c)); [apply AlongY; unfold near; auto|].
    apply AlongZ; unfold near; auto.
  Qed.

  Lemma VoxelFound i : exists a b c, owner (EvenPoint a b c) = i.
  Proof.
    destruct i as [i j k].
    destruct (IndexFound half sx ox Half FineX i) as [a A].
    destruct (IndexFound half sy oy Half FineY j) as [b B].
    destruct (IndexFound half sz oz Half FineZ k) as [c C].
    exists a, b, c. rewrite OwnerOfEven. unfold ix, iy, iz. congruence.
  Qed.

  (** Even points of voxels that share a face. *)
  Lemma TwoVoxels a b c a' b' c' :
    Beside (owner (EvenPoint a b c)) (owner (EvenPoint a' b' c')) ->
    sign (EvenPoint a b c) = Plus -> sign (EvenPoint a' b' c') = Plus ->
    samples (EvenPoint a b c) (EvenPoint a' b' c').
  Proof.
    rewrite !OwnerOfEven. intros B P Q. unfold Beside in B. cbn [Difference In] in B.
    set (i := ix (2 * a)) in *. set (i' := ix (2 * a')) in *.
    set (j := iy (2 * b)) in *. set (j' := iy (2 * b')) in *.
    set (k := iz (2 * c)) in *. set (k' := iz (2 * c')) in *.
    assert (Cases : (near i i' /\ j' = j /\ k' = k) \/ (i' = i /\ near j j' /\ k' = k) \/
      (i' = i /\ j' = j /\ near k k')).
    { repeat match type of B with _ \/ _ => destruct B as [B|B] end;
        try contradiction; injection B as B1 B2 B3; unfold near; lia. }
    pose proof (proj1 (EvenPointPlus a' b' c') Q) as In_. fold i' j' k' in In_.
    destruct Cases as [(N & E & F)|[(E & N & F)|(E & F & N)]].
    - assert (R : sign (EvenPoint a' b c) = Plus).
      { apply EvenPointPlus. fold i' j k. rewrite <- E, <- F. exact In_. }
      apply (JoinedThen _ _ _ _ (EvenPoint a' b c)); [apply AlongX; assumption|].
      apply OneVoxel; [|exact R]. rewrite !OwnerOfEven. fold i' j k j' k'. congruence.
    - assert (R : sign (EvenPoint a b' c) = Plus).
      { apply EvenPointPlus. fold i j' k. rewrite <- E, <- F. exact In_. }
      apply (JoinedThen _ _ _ _ (EvenPoint a b' c)); [apply AlongY; assumption|].
      apply OneVoxel; [|exact R]. rewrite !OwnerOfEven. fold i k i' j' k'. congruence.
    - assert (R : sign (EvenPoint a b c') = Plus).
      { apply EvenPointPlus. fold i j k'. rewrite <- E, <- F. exact In_. }
      apply (JoinedThen _ _ _ _ (EvenPoint a b c')); [apply AlongZ; assumption|].
      apply OneVoxel; [|exact R]. rewrite !OwnerOfEven. fold i j i' j' k'. congruence.
  Qed.

  Lemma VoxelsThenSamples u v : voxels u v ->
    forall a b c a' b' c', owner (EvenPoint a b c) = u -> owner (EvenPoint a' b' c') = v ->
      samples (EvenPoint a b c) (EvenPoint a' b' c').
  Proof.
    induction 1 as [u U|u v w J IH B W]; intros a b c a' b' c' E F.
    - apply OneVoxel; [congruence|]. apply EvenPointPlus. rewrite <- OwnerOfEven, E. exact U.
    - destruct (VoxelFound v) as (a1 & b1 & c1 & G).
      apply (JoinedThen _ _ _ _ (EvenPoint a1 b1 c1)); [apply IH; assumption|].
      apply JoinedInside in J. destruct J as [_ V].
      apply TwoVoxels; [rewrite G, F; exact B| |];
        apply EvenPointPlus; rewrite <- OwnerOfEven; congruence.
  Qed.

  (** A + point is joined to an even point of its voxel. *)
  Lemma ToEven p : OfLattice p -> sign p = Plus ->
    exists a b c, owner (EvenPoint a b c) = owner p /\ samples p (EvenPoint a b c).
  Proof.
    intros [E|O] P.
    - destruct p as [x y z]. destruct E as ([a ->] & [b ->] & [c ->]).
      exists a, b, c. split; [reflexivity|]. constructor. exact P.
    - destruct (SameOwner p) as (d & K & Q).
      assert (exists a b c, Translate p (Offset d) = EvenPoint a b c) as (a & b & c & T).
      { destruct p as [x y z]. destruct O as ([a A] & [b B] & [c C]).
        assert (F : forall t u, t + 1 = 2 * u -> exists n m, t + 1 = 2 * n /\ t + -1 = 2 * m)
          by (intros t u H; exists u, (u - 1); lia).
        destruct (F x a A) as (a1 & a2 & A1 & A2). destruct (F y b B) as (b1 & b2 & B1 & B2).
        destruct (F z c C) as (c1 & c2 & C1 & C2).
        destruct d; try discriminate K; cbn [Offset Translate]; unfold EvenPoint;
          [exists a1, b1, c1|exists a2, b2, c2|exists a1, b1, c2|exists a2, b2, c1
          |exists a1, b2, c1|exists a2, b1, c2|exists a2, b1, c1|exists a1, b2, c2];
          f_equal; assumption. }
      exists a, b, c. rewrite <- T. split; [exact Q|].
      apply JoinedNext; [exact P|exists d; reflexivity|].
      rewrite T. apply EvenPointPlus. rewrite <- OwnerOfEven, <- T, Q.
      apply PlusInside, P.
  Qed.

  Lemma PiecesAgree p q : OfLattice p -> OfLattice q -> sign p = Plus -> sign q = Plus ->
    samples p q <-> voxels (owner p) (owner q).
  Proof.
    intros Lp Lq P Q. split; [apply SamplesThenVoxels|]. intros J.
    destruct (ToEven p Lp P) as (a & b & c & E & Jp).
    destruct (ToEven q Lq Q) as (a' & b' & c' & F & Jq).
    apply (JoinedThen _ _ _ _ _ _ Jp).
    apply (JoinedThen _ _ _ _ (EvenPoint a' b' c'));
      [apply (VoxelsThenSamples _ _ J); assumption|].
    apply JoinedBack; [exact AdjacentMutual|exact Jq].
  Qed.

  Lemma SampleFound x : inside x -> exists p, OfLattice p /\ sign p = Plus /\ owner p = x.
  Proof.
    intros I. destruct (VoxelFound x) as (a & b & c & E). exists (EvenPoint a b c).
    split; [left; repeat split; eexists; reflexivity|]. split; [|exact E].
    apply EvenPointPlus. rewrite <- OwnerOfEven, E. exact I.
  Qed.
End Voxels.

Theorem VoxelPiecesKept grid image p q :
  let sign := VoxelSigns grid image in
  FineEnough grid -> OfLattice p -> OfLattice q -> sign p = Plus -> sign q = Plus ->
  Joined (fun v => sign v = Plus) Adjacent p q <->
  Joined (fun x => image x = true) Beside (Owner grid p) (Owner grid q).
Proof.
  destruct grid as [half [sx sy sz] [ox oy oz]]. intros sign (H & X & Y & Z').
  exact (PiecesAgree half sx sy sz ox oy oz image H X Y Z' p q).
Qed.

Theorem VoxelsSampled grid image x :
  FineEnough grid -> image x = true ->
  exists p, OfLattice p /\ VoxelSigns grid image p = Plus /\ Owner grid p = x.
Proof.
  destruct grid as [half [sx sy sz] [ox oy oz]]. intros (H & X & Y & Z').
  exact (SampleFound half sx sy sz ox oy oz image H X Y Z' x).
Qed.
