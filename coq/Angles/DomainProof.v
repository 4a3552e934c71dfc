(** * The product's own cuts lie on their edges: what follows

    The theorems that ask for [CutsOnEdges], without asking. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Warp.CutProof Angles.AngleTheorems
  Angles.LatticeProof Stuffing.NameProof Stuffing.VerticesProof.
Open Scope Z_scope.

Local Strategy 1000 [Warp Bisect BisectFrom].

(** ** The cuts *)

Theorem BisectedOnEdges sign domain : CutsOnEdges sign (BisectedCuts domain).
Proof.
  intros a b _ _. unfold BisectedCuts.
  pose proof (proj1 (BisectOnEdge (fun t => domain (PointOnEdge a b t)))). lia.
Qed.

Theorem MidpointOnEdges sign : CutsOnEdges sign MidpointCuts.
Proof. intros a b _ _. unfold MidpointCuts. vm_compute. split; discriminate. Qed.

Lemma EdgeEnds a b :
  PointOnEdge a b 0 = Scale Steps a /\ PointOnEdge a b Steps = Scale Steps b.
Proof.
  unfold PointOnEdge. generalize Steps. intros n.
  destruct a, b. cbn [Translate Scale Difference]. split; f_equal; ring.
Qed.

Theorem BisectedCutsFind domain a b :
  SampledSigns domain a = Plus -> SampledSigns domain b = Minus ->
  let t := BisectedCuts domain a b in
  let at_step s := domain (PointOnEdge a b s) in
  at_step t = OnSurface \/ at_step t = Plus /\ at_step (t + 1) = Minus.
Proof.
  intros inner outer. destruct (EdgeEnds a b) as [start finish].
  unfold SampledSigns in *. rewrite <- start in inner. rewrite <- finish in outer.
  exact (BisectFinds (fun s => domain (PointOnEdge a b s)) inner outer).
Qed.

(** ** Cuts that remain after warping *)

(** Two corners of a structured tetrahedron are joined by an edge. *)
Lemma CornersJoined tid p q : In p (Corners tid) -> In q (Corners tid) ->
  p <> q -> exists d, q = Translate p (Offset d).
Proof.
  assert (F : forall v u, existsb (fun d => Coord3Equal (Translate u (Offset d)) v)
                AllDirections = true -> exists d, v = Translate u (Offset d)).
  { intros v u E. apply existsb_exists in E. destruct E as (d & _ & E).
    exists d. destruct v, (Translate u (Offset d)). cbn in E.
    rewrite !Bool.andb_true_iff, !Z.eqb_eq in E.
    destruct E as [[-> ->] ->]. reflexivity. }
  destruct tid as [[x y z] case].
  assert (T : forall a b : Coord3,
    (exists d, b = Translate a (Offset d)) ->
    exists d, Translate (C3 x y z) b = Translate (Translate (C3 x y z) a) (Offset d)).
  { intros a b (d & ->). exists d. destruct a, (Offset d). cbn [Translate].
    f_equal; ring. }
  unfold Corners.
  destruct case; cbv beta iota zeta delta [GetStructuredTet];
    cbn [In]; intros I J N;
    repeat destruct I as [<- | I]; try contradiction;
    repeat destruct J as [<- | J]; try contradiction;
    solve [exfalso; apply N; reflexivity | apply T, F; reflexivity].
Qed.

Lemma ThresholdPositive th k :
  th = AngleThresholds \/ th = EmbeddingThresholds -> 0 < ThresholdSteps th k.
Proof. intros [-> | ->]; destruct k; reflexivity. Qed.

Lemma ProductAtMostHalf th :
  th = AngleThresholds \/ th = EmbeddingThresholds -> AtMostHalf th.
Proof.
  intros [-> | ->]; [exact AngleThresholdsAtMostHalf | exact EmbeddingThresholdsAtMostHalf].
Qed.

Theorem KeptCutsInside th sign cut tid t p m :
  th = AngleThresholds \/ th = EmbeddingThresholds -> CutsOnEdges sign cut ->
  In t (StuffTet th sign cut tid) -> In (Cut p m) (TetCorners t) ->
  sign p = Plus /\ sign m = Minus /\ 0 < cut p m < Steps.
Proof.
  intros product on I J.
  pose proof (WarpIsAdmissible th sign cut tid (ProductAtMostHalf th product) on)
    as [_ A].
  assert (E : exists v w, In v (Corners tid) /\ In w (Corners tid) /\
    MeshVertexSign th sign cut (Corner v) = Plus /\
    MeshVertexSign th sign cut (Corner w) = Minus /\ Cut p m = Cut v w).
  { clear A on. revert I J. unfold StuffTet, Corners. destruct tid as [anchor c].
    destruct (GetStructuredTet (STId anchor c)) as [v1 v2 v3 v4 n1 n2 n3 n4].
    intros I J. apply in_map_iff in I. destruct I as (u & <- & I).
    apply OrientCorners in J.
    destruct (StencilVertices _ _ _ _ _ _ _ I J)
      as [(v & K & E) | (v & w & V & W & Sv & Sw & E)];
      [discriminate E | exists v, w; auto]. }
  destruct E as (v & w & V & W & Sv & Sw & E).
  assert (N : v <> w) by (intros ->; rewrite Sv in Sw; discriminate Sw).
  assert (v = p /\ w = m) as [-> ->] by (split; congruence). clear E.
  destruct (CornersJoined tid p m V W N) as [d ->].
  split; [|split].
  - apply (SignBefore th sign cut p); [exact Sv | discriminate].
  - apply (SignBefore th sign cut _ Minus Sw). discriminate.
  - pose proof (A p d V W Sv Sw).
    pose proof (ThresholdPositive th (DirectionKind d) product). lia.
Qed.

(** ** The theorems about cuts on edges, for bisected domains *)

Theorem BisectedWarpIsAdmissible th sign domain tid : AtMostHalf th ->
  Admissible sign (WarpVertex th sign (BisectedCuts domain)) (BisectedCuts domain)
    th (Corners tid).
Proof. intros half. exact (WarpIsAdmissible _ _ _ tid half (BisectedOnEdges _ _)). Qed.

Theorem BisectedBounds sign domain tid t :
  In t (StuffedTets AngleThresholds sign (BisectedCuts domain) tid) ->
  WellShaped (AB (CotSq 221 8) (CotSq 1751 130)) t.
Proof. exact (StuffedWidest _ _ tid t (BisectedOnEdges _ _)). Qed.

Theorem BisectedBoundsEmbedding sign domain tid t :
  In t (StuffedTets EmbeddingThresholds sign (BisectedCuts domain) tid) ->
  WellShaped (AB (CotSq 563 15) (CotSq 80 9)) t.
Proof. exact (StuffedEmbedding _ _ tid t (BisectedOnEdges _ _)). Qed.

Theorem BisectedPositiveVolume th sign domain tid t :
  th = AngleThresholds \/ th = EmbeddingThresholds ->
  In t (StuffedTets th sign (BisectedCuts domain) tid) -> Positive t.
Proof.
  intros [-> | ->] I.
  - exact (WellShapedPositive _ _ (BisectedBounds _ _ _ _ I)).
  - exact (WellShapedPositive _ _ (BisectedBoundsEmbedding _ _ _ _ I)).
Qed.

Theorem BisectedLatticePositive sign domain tid :
  Positive (WarpedTet EmbeddingThresholds sign (BisectedCuts domain) tid).
Proof. exact (WarpedLatticePositive _ _ tid (BisectedOnEdges _ _)). Qed.

(** ** Cuts in the middle *)

Theorem MidpointNeverWarps sign v :
  WarpVertex NoWarpThresholds (Decided sign) MidpointCuts v = Stays.
Proof. exact (NeverWarped _ _ v (MidpointOnEdges _)). Qed.

Theorem MidpointPositiveVolume sign tid t :
  In t (StuffedTets NoWarpThresholds (Decided sign) MidpointCuts tid) -> Positive t.
Proof. intros I. exact (WellShapedPositive _ _ (MidpointBounds sign tid t I)). Qed.
