(** * The mesh embeds

    A cut counts for the two ends of its edge, so that a point of an output
    tetrahedron is a point of its placed structured tetrahedron.  If two output
    tetrahedra have a point in common, the lattice points weigh the same in it
    from both sides, because the lattice embeds; and a structured tetrahedron is
    filled in one way. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.Cases.AdmissibleProof
  Embedding.LatticeEmbedsProof Embedding.WarpedLatticeProof Embedding.EdgeRank
  Embedding.GreedyProof.
Open Scope Z_scope.

(** ** Blending weights *)

Definition Blend (x : Z) (w : Weights) (y : Z) (u : Weights) : Weights :=
  match w, u with
    UT _ a b c d, UT _ p q r s =>
      UT _ (x * a + y * p) (x * b + y * q) (x * c + y * r) (x * d + y * s)
  end.

Lemma WeighBlend {V} (g : V -> Z) x w y u t :
  Weigh g (Blend x w y u) t = x * Weigh g w t + y * Weigh g u t.
Proof. destruct w, u, t. cbn [Blend Weigh]. ring. Qed.

Lemma TotalBlend x w y u : Total (Blend x w y u) = x * Total w + y * Total u.
Proof. destruct w, u. cbn [Blend Total]. ring. Qed.

Lemma NonNegativeBlend x w y u : 0 <= x -> 0 <= y ->
  NonNegative w -> NonNegative u -> NonNegative (Blend x w y u).
Proof.
  destruct w, u. cbn [Blend NonNegative]. intros X Y W U.
  repeat split; apply Z.add_nonneg_nonneg; apply Z.mul_nonneg_nonneg; tauto.
Qed.

(** ** Weights of a structured tetrahedron *)

(** Its weighted points that weigh [g] as a given vertex or tetrahedron does. *)
Definition Carries (tid : StructuredTetId) (total : Z)
  (weight : (Coord3 -> Z) -> Z) : Prop :=
  exists w, NonNegative w /\ Total w = total /\
    forall g, Weigh g w (LatticeTet tid) = weight g.

Lemma CarriesBlend tid x m f y n h : 0 <= x -> 0 <= y ->
  Carries tid m f -> Carries tid n h ->
  Carries tid (x * m + y * n) (fun g => x * f g + y * h g).
Proof.
  intros X Y (w & W & Tw & Ew) (u & U & Tu & Eu). exists (Blend x w y u).
  split; [apply NonNegativeBlend; assumption|].
  rewrite TotalBlend, Tw, Tu. split; [reflexivity|].
  intros g. rewrite WeighBlend, Ew, Eu. reflexivity.
Qed.

Lemma CarriesMeans tid m n f h : m = n -> (forall g, f g = h g) ->
  Carries tid m f -> Carries tid n h.
Proof.
  intros <- E (w & W & T & Ew). exists w. repeat split; auto.
  intros g. rewrite Ew. apply E.
Qed.

Lemma CarriesCorner tid c : In c (Corners tid) -> Carries tid 1 (fun g => g c).
Proof.
  unfold Carries, Corners, LatticeTet.
  destruct (GetStructuredTet tid) as [v1 v2 v3 v4].
  intros [<-|[<-|[<-|[<-|[]]]]];
    [exists (UT _ 1 0 0 0)|exists (UT _ 0 1 0 0)|exists (UT _ 0 0 1 0)
    |exists (UT _ 0 0 0 1)]; cbn [NonNegative Total Weigh]; repeat split; lia.
Qed.

Section Mesh.
  Variables (before : SignField) (warping : Coord3 -> Warping) (cut : CutField).
  Variable place : MeshVertex -> Coord3.
  Hypothesis Cuts : CutsInside before warping cut.

  Let after c := PlacedSign before warping (Corner c).

  (** A cut lies where its shares put it. *)
  Hypothesis Straight : forall a m f, Axis f -> after a = Plus -> after m = Minus ->
    Share cut (fun c => f (place (Corner c))) (Cut a m) = Steps * f (place (Cut a m)).

  Lemma CarriesVertex tid v : Belongs after (Corners tid) v ->
    Carries tid Steps (fun g => Share cut g v).
  Proof.
    intros B. destruct v as [c|a m].
    - destruct B as [I _]. apply (CarriesMeans tid (Steps * 1 + 0 * 1) _
        (fun g => Steps * g c + 0 * g c)); [reflexivity|intros; cbn [Share]; lia|].
      apply CarriesBlend; auto using CarriesCorner; discriminate || lia.
    - destruct (CutBelongs after cut Cuts tid a m B) as (A & M & _ & _ & _ & C).
      apply (CarriesMeans tid ((Steps - cut a m) * 1 + cut a m * 1) _
        (fun g => (Steps - cut a m) * g a + cut a m * g m));
        [lia|reflexivity|].
      apply CarriesBlend; auto using CarriesCorner; lia.
  Qed.

  Lemma CarriesTet tid w t : NonNegative w ->
    (forall v, In v (TetCorners t) -> Belongs after (Corners tid) v) ->
    Carries tid (Steps * Total w) (fun g => Weigh (Share cut g) w t).
  Proof.
    destruct w as [a b c d], t as [p q r s]. intros (A & B & C & D) H.
    assert (V : forall v, In v [p; q; r; s] ->
      Carries tid Steps (fun g => Share cut g v)) by (intros; apply CarriesVertex; auto).
    cbn [In] in V. cbn [Total Weigh].
    apply (CarriesMeans tid
      (1 * (a * Steps + b * Steps) + 1 * (c * Steps + d * Steps)) _
      (fun g => 1 * (a * Share cut g p + b * Share cut g q)
        + 1 * (c * Share cut g r + d * Share cut g s)));
      [ring|intros; ring|].
    apply CarriesBlend; [lia|lia|apply CarriesBlend; auto 8 ..].
  Qed.

  Lemma ShareOfPosition corners f v : Axis f -> Belongs after corners v ->
    Share cut (fun c => f (place (Corner c))) v = Steps * f (place v).
  Proof.
    intros F B. destruct v as [c|a m]; [reflexivity|].
    destruct B as (_ & _ & A & M). apply Straight; assumption.
  Qed.

  Lemma SharesOfPoint corners f w t : Axis f ->
    (forall v, In v (TetCorners t) -> Belongs after corners v) ->
    Weigh (Share cut (fun c => f (place (Corner c)))) w t
    = Steps * Weigh (fun v => f (place v)) w t.
  Proof.
    intros F H. destruct w as [a b c d], t as [p q r s].
    pose proof (fun v I => ShareOfPosition corners f v F (H v I)) as E.
    cbn [TetCorners In] in E. cbn [Weigh].
    rewrite !E by auto. ring.
  Qed.

  Hypothesis Keeps : KeepsShortEdges (fun c => place (Corner c)).

  (** In any order of the cuts. *)
  Theorem StraightOrderEmbeds key tid tid' t t' : InLattice tid -> InLattice tid' ->
    KeysApart key (Corners tid) -> KeysApart key (Corners tid') ->
    FollowsBy key after (Corners tid) t -> FollowsBy key after (Corners tid') t' ->
    MeetInSharedVertices place t t'.
  Proof.
    intros Even Even' K K' F F' w w' W W' T E.
    apply (GreedyUnique key after cut Cuts tid w t tid' w' t');
      [exact (conj K (conj W F))|exact (conj K' (conj W' F'))|].
    destruct (CarriesTet tid w t W (proj1 F)) as (u & U & Tu & Eu).
    destruct (CarriesTet tid' w' t' W' (proj1 F')) as (u' & U' & Tu' & Eu').
    intros g. rewrite <- Eu, <- Eu'. revert g.
    apply (LatticeEmbeds _ Keeps tid tid' Even Even' u u' U U'); [congruence|].
    assert (Same : forall f, Axis f ->
      Weigh (fun v => f (place v)) w t = Weigh (fun v => f (place v)) w' t' ->
      Weigh (fun c => f (place (Corner c))) u (LatticeTet tid)
      = Weigh (fun c => f (place (Corner c))) u' (LatticeTet tid')).
    { intros f A Ef. rewrite Eu, Eu'.
      rewrite (SharesOfPoint (Corners tid) f w t A (proj1 F)).
      rewrite (SharesOfPoint (Corners tid') f w' t' A (proj1 F')).
      rewrite Ef. reflexivity. }
    apply (SamePoint place place) in E. destruct E as (Ex & Ey & Ez).
    apply (SamePoint (fun c => place (Corner c)) (fun c => place (Corner c))).
    unfold Axis in Same. auto 6.
  Qed.

  Theorem StraightMeshEmbeds tid tid' t t' : InLattice tid -> InLattice tid' ->
    In t (PlacedNames before warping tid) ->
    In t' (PlacedNames before warping tid') ->
    MeetInSharedVertices place t t'.
  Proof.
    intros Even Even' I I'. apply (StraightOrderEmbeds EdgeRank tid tid');
      try apply RanksAreKeys; try apply FollowsByRank; try assumption;
      apply StuffedFollows; assumption.
  Qed.
End Mesh.

(** ** Warped vertices, and cuts on unwarped edges *)

Lemma ShareOnEdge (cut : CutField) a m f : Axis f ->
  Share cut (fun c => f (Scale Steps c)) (Cut a m)
  = Steps * f (PointOnEdge a m (cut a m)).
Proof.
  intros F. unfold PointOnEdge. cbn [Share].
  destruct a, m; cbn [Difference Scale Translate].
  destruct F as [->|[->| ->]]; cbn [XOf YOf ZOf]; ring.
Qed.

(** The ends of a cut have not moved. *)
Lemma EndsStay before warping a m :
  PlacedSign before warping (Corner a) = Plus ->
  PlacedSign before warping (Corner m) = Minus ->
  warping a = Stays /\ warping m = Stays.
Proof.
  cbn [PlacedSign]. destruct (warping a), (warping m); try discriminate. auto.
Qed.

Lemma ShareOfCut before warping cut a m f : Axis f ->
  PlacedSign before warping (Corner a) = Plus ->
  PlacedSign before warping (Corner m) = Minus ->
  Share cut (fun c => f (PlacedPosition warping cut (Corner c))) (Cut a m)
  = Steps * f (PlacedPosition warping cut (Cut a m)).
Proof.
  intros F A M. destruct (EndsStay before warping a m A M) as [Sa Sm].
  cbn [PlacedPosition]. rewrite <- ShareOnEdge by exact F.
  cbn [Share]. rewrite Sa, Sm. reflexivity.
Qed.

Theorem PlacedMeshEmbeds before warping cut tid tid' t t' :
  CutsInside before warping cut ->
  KeepsShortEdges (fun c => WarpedPosition c (warping c)) ->
  InLattice tid -> InLattice tid' ->
  In t (PlacedNames before warping tid) ->
  In t' (PlacedNames before warping tid') ->
  MeetInSharedVertices (PlacedPosition warping cut) t t'.
Proof.
  intros C K. apply (StraightMeshEmbeds before warping cut); try assumption.
  intros a m f F A M. apply (ShareOfCut before); assumption.
Qed.

(** ** The product's mesh *)

Lemma StuffedByName th sign cut tid :
  StuffTet th sign cut tid = PlacedNames sign (WarpVertex th sign cut) tid.
Proof.
  unfold StuffTet, PlacedNames. destruct tid as [anchor case].
  destruct (GetStructuredTet (STId anchor case)). reflexivity.
Qed.

(** Where something is ever violated, the cuts that remain are alpha away from
    both ends. *)
Lemma CutsInsideWarped th sign cut : AtMostHalf th ->
  (forall k, 0 < ThresholdSteps th k) -> CutsOnEdges sign cut ->
  CutsInside sign (WarpVertex th sign cut) cut.
Proof.
  intros H P C v d u A M.
  pose proof (WarpLeavesAdmissible th sign cut H C [v; u]) as [_ Cuts].
  specialize (Cuts v d (or_introl eq_refl) (or_intror (or_introl eq_refl)) A M).
  specialize (P (DirectionKind d)). fold u in Cuts. lia.
Qed.

(** The paper's warp at alpha of at most 1/4 of a long edge and 1/2 of a short one. *)
Lemma LittleWarpFits long short sign cut :
  let th := TH long short in
  0 < long <= 64 -> 0 < short <= 128 -> CutsOnEdges sign cut ->
  CutsInside sign (WarpVertex th sign cut) cut /\
  KeepsShortEdges (fun c => WarpedPosition c (WarpVertex th sign cut c)).
Proof.
  intros th L S C. split.
  - assert (T : forall k, 0 < ThresholdSteps th k <= 32768).
    { intros k. unfold th, ThresholdSteps. change (Steps / 256) with 256.
      destruct k; lia. }
    apply CutsInsideWarped; try assumption; intros k; specialize (T k);
      change Steps with 65536; lia.
  - apply (WarpKeepsShortEdges th sign cut); [|exact C].
    unfold th. cbn [MovesLittle]. lia.
Qed.

Theorem MeshEmbeds long short sign cut tid tid' t t' :
  let th := TH long short in
  0 < long <= 64 -> 0 < short <= 128 ->
  CutsOnEdges sign cut -> InLattice tid -> InLattice tid' ->
  In t (StuffTet th sign cut tid) -> In t' (StuffTet th sign cut tid') ->
  MeetInSharedVertices (MeshPosition th sign cut) t t'.
Proof.
  intros th L S C E E' I I'. rewrite StuffedByName in I, I'.
  apply (PlacedMeshEmbeds sign (WarpVertex th sign cut) cut tid tid' t t');
    try assumption; apply LittleWarpFits; assumption.
Qed.

Theorem MidpointMeshEmbeds sign tid tid' t t' :
  let decided v := InOrOut (sign v) in
  let cut (_ _ : Coord3) := MidpointCut in
  InLattice tid -> InLattice tid' ->
  In t (StuffTet NoWarpThresholds decided cut tid) ->
  In t' (StuffTet NoWarpThresholds decided cut tid') ->
  MeetInSharedVertices (MeshPosition NoWarpThresholds decided cut) t t'.
Proof.
  intros decided cut E E' I I'. rewrite StuffedByName in I, I'.
  apply (PlacedMeshEmbeds decided (WarpVertex NoWarpThresholds decided cut) cut)
    with tid tid'; try assumption.
  - intros v d u _ _. reflexivity || (split; reflexivity).
  - apply (WarpKeepsShortEdges NoWarpThresholds decided cut).
    + split; discriminate.
    + intros a b _ _. split; discriminate.
Qed.

(** ** Any placement that crosses no short edge *)

Theorem PlacedEmbeds before warping cut tid tid' t t' :
  MovesAtMost AngleThresholds warping -> Uncrossed warping ->
  CutsInside before warping cut -> InLattice tid -> InLattice tid' ->
  In t (PlacedNames before warping tid) ->
  In t' (PlacedNames before warping tid') ->
  MeetInSharedVertices (PlacedPosition warping cut) t t'.
Proof.
  intros M U C. apply PlacedMeshEmbeds; [exact C|].
  apply UncrossedKeepsShortEdges; assumption.
Qed.
