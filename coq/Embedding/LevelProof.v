(** * Where ends come level, interiors are still apart

    If the ends of a short edge may come level, the lattice need no longer
    embed; but it does as soon as all moves are a little shorter.  A point that
    is inside two tetrahedra stays inside both when their vertices are moved by
    little enough, if their volumes are positive; so there was none. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Embedding.WarpedLatticeProof Embedding.GreedyProof
  Embedding.MeshEmbedsProof Embedding.MeshApartProof.
Open Scope Z_scope.

(** ** A point's weights from volumes *)

(** The weights of [y], counted [n] times, among the vertices. *)
Definition Parts (n : Z) (y : Coord3) (t : UnstructuredTet Coord3) : Weights :=
  match t with
    UT _ a b c d =>
      UT _ (- Dot (Normal b c d) (Difference (Scale n b) y))
           (Dot (Normal a c d) (Difference (Scale n a) y))
           (- Dot (Normal a b d) (Difference (Scale n a) y))
           (Dot (Normal a b c) (Difference (Scale n a) y))
  end.

Ltac coordinates :=
  repeat match goal with v : Coord3 |- _ => destruct v end;
  unfold Parts, SixVolumeOf, SixVolume, Normal;
  cbn [Difference Cross Dot Scale Translate PointOf Total Blend].

Lemma PartsPoint n y t : PointOf (Parts n y t) t = Scale (SixVolumeOf t) y.
Proof. destruct t as [a b c d]. coordinates. f_equal; ring. Qed.

Lemma PartsTotal n y t : Total (Parts n y t) = SixVolumeOf t * n.
Proof. destruct t as [a b c d]. coordinates. ring. Qed.

(** They are the weights, but for the volume. *)
Lemma PartsOfPoint w t :
  Parts (Total w) (PointOf w t) t = Blend (SixVolumeOf t) w 0 w.
Proof. destruct w as [p q r s], t as [a b c d]. coordinates. f_equal; ring. Qed.

Lemma PointOfBlend x w t : PointOf (Blend x w 0 w) t = Scale x (PointOf w t).
Proof. destruct w as [p q r s], t as [a b c d]. coordinates. f_equal; ring. Qed.

(** ** Moving by little *)

(** The old position many times, and the new one once. *)
Definition Nearly (n : Z) (old new : Coord3) : Coord3 := Translate (Scale n old) new.

(** A triple product grows as its first factors say. *)
Lemma TripleGrows u u' v v' w w' :
  exists x y z, forall n,
    Dot (Cross (Nearly n u u') (Nearly n v v')) (Nearly n w w')
    = Dot (Cross u v) w * (n * n * n) + x * (n * n) + y * n + z.
Proof.
  exists (Dot (Cross u v) w' + Dot (Cross u v') w + Dot (Cross u' v) w),
    (Dot (Cross u v') w' + Dot (Cross u' v) w' + Dot (Cross u' v') w),
    (Dot (Cross u' v') w').
  intros n. unfold Nearly. coordinates. ring.
Qed.

Definition Eventually (P : Z -> Prop) : Prop := exists m, forall n, m <= n -> P n.

Lemma EventuallyAnd P Q : Eventually P -> Eventually Q ->
  Eventually (fun n => P n /\ Q n).
Proof.
  intros [m H] [m' H']. exists (Z.max m m'). intros n L.
  split; [apply H|apply H']; lia.
Qed.

Lemma EventuallyMeans (P Q : Z -> Prop) :
  (forall n, P n -> Q n) -> Eventually P -> Eventually Q.
Proof. intros H [m A]. exists m. auto. Qed.

Lemma CubicPositive k x y z : 0 < k ->
  Eventually (fun n => 0 < k * (n * n * n) + x * (n * n) + y * n + z).
Proof.
  intros K. exists (1 + Z.abs x + Z.abs y + Z.abs z). intros n L.
  assert (A : 0 <= (k - 1) * (n * n * n))
    by (apply Z.mul_nonneg_nonneg; [|repeat apply Z.mul_nonneg_nonneg]; lia).
  assert (B : 0 <= (n - (1 + Z.abs x + Z.abs y + Z.abs z)) * (n * n))
    by (apply Z.mul_nonneg_nonneg; [|apply Z.mul_nonneg_nonneg]; lia).
  assert (C : 0 <= (x + Z.abs x) * (n * n))
    by (apply Z.mul_nonneg_nonneg; [|apply Z.mul_nonneg_nonneg]; lia).
  assert (D : 0 <= (Z.abs y * (n - 1)) * n)
    by (repeat apply Z.mul_nonneg_nonneg; lia).
  assert (E : 0 <= (y + Z.abs y) * n) by (apply Z.mul_nonneg_nonneg; lia).
  assert (F : 0 <= Z.abs z * ((n - 1) * (n + 1)))
    by (repeat apply Z.mul_nonneg_nonneg; lia).
  assert (G : 0 < n * n) by (apply Z.mul_pos_pos; lia).
  generalize dependent (Z.abs x). generalize dependent (Z.abs y). intros.
  assert (H : - Z.abs z <= z) by lia. generalize dependent (Z.abs z). intros.
  clear L. nia.
Qed.

Lemma TriplePositive u u' v v' w w' : 0 < Dot (Cross u v) w ->
  Eventually (fun n =>
    0 < Dot (Cross (Nearly n u u') (Nearly n v v')) (Nearly n w w')).
Proof.
  intros P. destruct (TripleGrows u u' v v' w w') as (x & y & z & E).
  destruct (CubicPositive _ x y z P) as [m H]. exists m. intros n L.
  rewrite E. apply H, L.
Qed.

Lemma TripleNegative u u' v v' w w' : 0 < - Dot (Cross u v) w ->
  Eventually (fun n =>
    0 < - Dot (Cross (Nearly n u u') (Nearly n v v')) (Nearly n w w')).
Proof.
  intros P. destruct (TripleGrows u u' v v' w w') as (x & y & z & E).
  destruct (CubicPositive _ (- x) (- y) (- z) P) as [m H]. exists m. intros n L.
  rewrite E. specialize (H n L). lia.
Qed.

Lemma DifferenceNearly n a a' b b' :
  Difference (Nearly n a a') (Nearly n b b')
  = Nearly n (Difference a b) (Difference a' b').
Proof. unfold Nearly. coordinates. f_equal; ring. Qed.

Lemma ScaleNearly k n a a' : Scale k (Nearly n a a') = Nearly n (Scale k a) (Scale k a').
Proof. unfold Nearly. coordinates. f_equal; ring. Qed.

(** A point inside stays inside. *)
Lemma StaysInside {V} (old new : V -> Coord3) (t : UnstructuredTet V) w y' :
  AllPositive w -> Positive (MapTet old t) ->
  Eventually (fun n => AllPositive
    (Parts (Total w) (Nearly n (PointOf w (MapTet old t)) y')
       (MapTet (fun v => Nearly n (old v) (new v)) t))).
Proof.
  intros W P. pose proof (PartsOfPoint w (MapTet old t)) as E.
  set (y := PointOf w (MapTet old t)) in *. clearbody y.
  set (k := Total w) in *. clearbody k.
  destruct w as [p q r s], t as [a b c d]. cbn [MapTet Positive AllPositive] in *.
  unfold Parts, SixVolumeOf, Normal in *. cbn [Blend] in E.
  injection E as Ea Eb Ec Ed. destruct W as (Wa & Wb & Wc & Wd).
  repeat apply EventuallyAnd.
  all: eapply EventuallyMeans;
    [intros n H; rewrite ScaleNearly, !DifferenceNearly; exact H|].
  - apply TripleNegative. rewrite Ea. nia.
  - apply TriplePositive. rewrite Eb. nia.
  - apply TripleNegative. rewrite Ec. nia.
  - apply TriplePositive. rewrite Ed. nia.
Qed.

Lemma PointNearly {V} (old new : V -> Coord3) (t : UnstructuredTet V) w n :
  PointOf w (MapTet (fun v => Nearly n (old v) (new v)) t)
  = Nearly n (PointOf w (MapTet old t)) (PointOf w (MapTet new t)).
Proof.
  destruct w as [p q r s], t as [a b c d]. cbn [MapTet]. unfold Nearly.
  destruct (old a), (old b), (old c), (old d), (new a), (new b), (new c), (new d).
  cbn [PointOf Scale Translate]. f_equal; ring.
Qed.

Lemma OverlapNearly {V} (old new : V -> Coord3) (t t' : UnstructuredTet V) :
  Positive (MapTet old t') -> Overlap (MapTet old t) (MapTet old t') ->
  exists n, 0 <= n /\
    let near v := Nearly n (old v) (new v) in
    Overlap (MapTet near t) (MapTet near t').
Proof.
  intros P (w & w' & W & W' & T & O).
  destruct (StaysInside old new t' w' (PointOf w (MapTet new t)) W' P) as [m H].
  exists (Z.max 0 m). split; [lia|]. specialize (H (Z.max 0 m) ltac:(lia)).
  set (n := Z.max 0 m) in *. cbv zeta.
  rewrite <- O, <- PointNearly, <- T in H.
  set (near := fun v => Nearly n (old v) (new v)) in *.
  set (y := PointOf w (MapTet near t)) in *.
  set (volume := SixVolumeOf (MapTet near t')).
  pose proof (PartsTotal (Total w) y (MapTet near t')) as PT.
  assert (0 < volume).
  { assert (A : forall u, AllPositive u -> 0 < Total u) by (intros []; cbn; lia).
    pose proof (A _ H) as A1. pose proof (A _ W) as A2. rewrite PT in A1.
    apply (Z.mul_pos_cancel_r _ _ A2). exact A1. }
  exists (Blend volume w 0 w), (Parts (Total w) y (MapTet near t')).
  split; [|split; [exact H|split]].
  - destruct w as [p q r s]. cbn [Blend AllPositive] in *. nia.
  - rewrite PT, TotalBlend. fold volume. ring.
  - rewrite PartsPoint, PointOfBlend. reflexivity.
Qed.

(** ** The mesh *)

Section Level.
  Variables (before : SignField) (warping : Coord3 -> Warping) (cut : CutField).
  Hypothesis Moved : MovesAtMost AngleThresholds warping.
  Hypothesis Level : UncrossedOrLevel warping.
  Hypothesis Cuts : CutsInside before warping cut.

  Let old := PlacedPosition warping cut.
  (** Where nothing moves. *)
  Let new := PlacedPosition (fun _ => Stays) cut.

  Lemma NearlyKeeps n : 0 <= n ->
    KeepsShortEdges (fun c => Nearly n (old (Corner c)) (new (Corner c))).
  Proof.
    intros N v d K. apply SameOctantByAxis. intros f F.
    pose proof (ApproachByAxis warping (Steps / 2) ltac:(discriminate)
      Moved Level f v d F K) as H.
    unfold old, new. cbn [PlacedPosition].
    assert (E : forall a b, f (Difference a b) = f b - f a)
      by (intros [] []; destruct F as [->|[->| ->]]; reflexivity).
    assert (E' : f (Translate v (Offset d)) = f v + f (Offset d))
      by (destruct v, (Offset d); destruct F as [->|[->| ->]]; reflexivity).
    assert (E'' : forall a b, f (Nearly n a b) = n * f a + f b)
      by (intros [] []; destruct F as [->|[->| ->]]; reflexivity).
    rewrite E, !E'', !ShiftOfPlace, E' by exact F. cbn [Shift].
    change Steps with 65536 in *. change (65536 / 2) with 32768 in *.
    destruct (ShortOffset f d F K) as [D|D]; rewrite D in *; nia.
  Qed.

  Lemma NearlyStraight n a m f : Axis f ->
    PlacedSign before warping (Corner a) = Plus ->
    PlacedSign before warping (Corner m) = Minus ->
    Share cut (fun c => f (Nearly n (old (Corner c)) (new (Corner c)))) (Cut a m)
    = Steps * f (Nearly n (old (Cut a m)) (new (Cut a m))).
  Proof.
    intros F A M. pose proof (ShareOfCut before warping cut a m f F A M) as E.
    pose proof (ShareOnEdge cut a m f F) as E'.
    assert (N : forall a b, f (Nearly n a b) = n * f a + f b)
      by (intros [] []; destruct F as [->|[->| ->]]; reflexivity).
    fold old in E. cbn [Share] in *. rewrite !N.
    unfold new. cbn [PlacedPosition WarpedPosition].
    transitivity (n * (Steps * f (old (Cut a m)))
      + Steps * f (PointOnEdge a m (cut a m))); [rewrite <- E, <- E'|]; ring.
  Qed.

  Theorem LevelInteriorsApart tid tid' t t' :
    InLattice tid -> InLattice tid' ->
    In t (PlacedNames before warping tid) ->
    In t' (PlacedNames before warping tid') ->
    Positive (MapTet old t') -> Overlap (MapTet old t) (MapTet old t') ->
    tid = tid' /\ t = t'.
  Proof.
    intros E E' I I' P O.
    destruct (OverlapNearly old new t t' P O) as (n & N & O').
    refine (ApartBySharing before warping _ tid tid' t t' E E' I I' _ O').
    apply (StraightMeshEmbeds before warping cut) with tid tid'; try assumption.
    - intros a m f. apply NearlyStraight.
    - apply NearlyKeeps, N.
  Qed.
End Level.
