(** * The mesh of one sweep: it embeds, and has the pieces of the samples *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.AngleTheorems Embedding.GreedyProof
  Embedding.MeshEmbedsProof Embedding.LevelProof Embedding.WarpOrClampProof
  Embedding.RuledMeshProof Embedding.LeavingProof Embedding.LinkProof
  Embedding.PiecesProof Embedding.DiskStepProof Embedding.SettleProof.
Open Scope Z_scope.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpVertex Settle].

(** ** What other samples come to *)

Lemma OpenDecided sample v : OpenSigns sample v <> OnSurface.
Proof. unfold OpenSigns. destruct (sample v); discriminate. Qed.

Theorem OpenCutsOnEdges sample cut :
  CutsOnEdges sample cut -> CutsOnEdges (OpenSigns sample) (OpenCuts sample cut).
Proof.
  intros C a b. unfold OpenSigns, OpenCuts. specialize (C a b).
  destruct (sample a), (sample b); intros A B; try discriminate;
    [change (0 <= Steps <= Steps); change Steps with 65536; lia|auto].
Qed.

(** ** A rule of who stays *)

Lemma PlacedTetsExt before warping warping' cut tid :
  (forall c, warping c = warping' c) ->
  PlacedTets before warping cut tid = PlacedTets before warping' cut tid.
Proof.
  intros E. rewrite !PlacedByName, (PlacedNamesExt _ _ _ _ E). apply map_ext.
  intros [a b c d]. cbn [MapTet].
  assert (P : forall v, PlacedPosition warping cut v = PlacedPosition warping' cut v)
    by (intros []; cbn [PlacedPosition]; [rewrite E|]; reflexivity).
  rewrite !P. reflexivity.
Qed.

Theorem SettledIsWarpOrClamp th sign cut gap vs :
  AtMostHalf th -> CutsOnEdges sign cut -> (forall s s', gap s s' <= 1) ->
  exists stays limit, forall tid,
    SettledTets th sign cut (Settle th sign cut gap vs) tid
    = WarpOrClamp th sign cut stays limit tid.
Proof.
  intros H C G.
  destruct (SettledIsRule th sign cut gap H C G vs) as (stays & limit & E).
  exists stays, limit. intros tid. unfold SettledTets, WarpOrClamp.
  apply PlacedTetsExt, E.
Qed.

Section Embeds.
  Variables (sign : SignField) (cut : CutField) (gap : Gap) (vs : list Coord3).
  Hypothesis OnEdges : CutsOnEdges sign cut.
  Hypothesis GapSmall : forall s s', gap s s' <= 1.

  Let th := AngleThresholds.
  Let warping := PlaceIn (Settle th sign cut gap vs).
  Let place := PlacedPosition warping (ClampedCut th cut).

  Theorem SettledWidest tid t :
    In t (SettledTets th sign cut (Settle th sign cut gap vs) tid) ->
    WellShaped WidestAngles t.
  Proof.
    destruct (SettledIsWarpOrClamp th sign cut gap vs AngleThresholdsAtMostHalf
      OnEdges GapSmall) as (stays & limit & E).
    rewrite E. apply RuledBounds, OnEdges.
  Qed.

  Lemma SettledInside : CutsInside sign warping (ClampedCut th cut).
  Proof.
    intros v d u _ _.
    pose proof (ClampedInRange th cut AngleThresholdsAtMostHalf v d) as R.
    cbv zeta in R. fold u in R.
    assert (P : 0 < ThresholdSteps th (DirectionKind d))
      by (destruct (DirectionKind d); reflexivity).
    fold th in R. lia.
  Qed.

  Theorem SettledGapEmbeds tid tid' t t' : (forall s s', 1 <= gap s s') ->
    InLattice tid -> InLattice tid' ->
    In t (PlacedNames sign warping tid) -> In t' (PlacedNames sign warping tid') ->
    MeetInSharedVertices place t t'.
  Proof.
    intros G. apply (PlacedEmbeds sign).
    - apply SettledMovesAtMost; [exact AngleThresholdsAtMostHalf|exact OnEdges|exact GapSmall].
    - exact (SettledApproach th sign cut gap 1 vs G).
    - exact SettledInside.
  Qed.

  Theorem SettledInteriorsApart tid tid' t t' : (forall s s', 0 <= gap s s') ->
    InLattice tid -> InLattice tid' ->
    In t (PlacedNames sign warping tid) -> In t' (PlacedNames sign warping tid') ->
    Overlap (MapTet place t) (MapTet place t') -> tid = tid' /\ t = t'.
  Proof.
    intros G E E' I I'. apply (LevelInteriorsApart sign warping (ClampedCut th cut));
      try assumption.
    - apply SettledMovesAtMost; [exact AngleThresholdsAtMostHalf|exact OnEdges|exact GapSmall].
    - pose proof (SettledApproach th sign cut gap 0 vs G) as A.
      rewrite Z.sub_0_r in A. exact A.
    - exact SettledInside.
    - apply (WellShapedPositive WidestAngles), (SettledWidest tid').
      unfold SettledTets. rewrite PlacedByName. apply in_map, I'.
  Qed.
End Embeds.

Theorem SettledMeshEmbeds sign cut vs tid tid' t t' :
  let warping := PlaceIn (Settle AngleThresholds sign cut StrictGap vs) in
  CutsOnEdges sign cut -> InLattice tid -> InLattice tid' ->
  In t (PlacedNames sign warping tid) -> In t' (PlacedNames sign warping tid') ->
  MeetInSharedVertices
    (PlacedPosition warping (ClampedCut AngleThresholds cut)) t t'.
Proof.
  intros warping C.
  assert (L : forall s s', StrictGap s s' <= 1) by (intros s s'; discriminate).
  assert (M : forall s s', 1 <= StrictGap s s') by (intros s s'; discriminate).
  exact (SettledGapEmbeds sign cut StrictGap vs C L tid tid' t t' M).
Qed.

(** ** Pieces *)

Section Pieces.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField) (gap : Gap).
  Variable vs : list Coord3.

  Let warping := PlaceIn (Settle th sign cut gap vs).

  Lemma SettledLeaves : AllLeave Adjacent (PlusBefore sign) (PlusAfter sign warping).
  Proof. exact (InsideLeaves sign _ (SettledByDisks th sign cut gap vs)). Qed.

  Lemma SettledOutsideLeaves : AllLeave Adjacent
    (fun v => ~ PlusAfter sign warping v) (fun v => ~ PlusBefore sign v).
  Proof. exact (OutsideLeaves sign _ (SettledByDisks th sign cut gap vs)). Qed.

  Theorem SettledMakesNoWall : (forall v, sign v <> OnSurface) -> NoWall sign warping.
  Proof.
    intros D. apply NoWallInMesh.
    exact (NoWallEver sign D _ (SettledByDisks th sign cut gap vs)).
  Qed.

  Theorem SettledPiecesKept :
    (forall v, sign v <> OnSurface) -> SamePieces sign warping.
  Proof.
    intros D p q t u. apply PiecesKept; [exact SettledLeaves|].
    apply SettledMakesNoWall, D.
  Qed.

  Theorem SettledNoPieceLost : NoneLost sign warping.
  Proof. intros p. apply NoPieceLost. exact SettledLeaves. Qed.

  Theorem SettledOutsideKept : SameOutside sign warping.
  Proof.
    exact (KeepsPieces _ _ SamePoint3 AdjacentMutual _ _ SettledOutsideLeaves).
  Qed.

  Theorem SettledMakesNoCavity : NoCavity sign warping.
  Proof.
    exact (LosesNoPiece _ _ SamePoint3 AdjacentMutual _ _ SettledOutsideLeaves).
  Qed.
End Pieces.

(** ** All at once *)

Lemma LevelGapSmall s s' : LevelGap s s' <= 1.
Proof. destruct s, s'; discriminate. Qed.

Lemma LevelGapAtLeast0 s s' : 0 <= LevelGap s s'.
Proof. destruct s, s'; discriminate. Qed.

Theorem SettledMeshHasItAll sample cut vs : CutsOnEdges sample cut ->
  let th := AngleThresholds in
  let sign := OpenSigns sample in
  let cuts := OpenCuts sample cut in
  let warping := PlaceIn (Settle th sign cuts LevelGap vs) in
  let place := PlacedPosition warping (ClampedCut th cuts) in
  (forall tids t, In t (SettledMesh th sign cuts LevelGap vs tids) ->
     WellShaped WidestAngles t) /\
  NoneOverlap sign warping place /\
  SamePieces sign warping /\
  NoneLost sign warping /\
  SameOutside sign warping /\
  NoCavity sign warping.
Proof.
  intros C th sign cuts warping place. pose proof (OpenCutsOnEdges sample cut C) as O.
  split; [|split; [|split; [|split; [|split]]]].
  - intros tids t I. unfold SettledMesh in I. apply in_flat_map in I.
    destruct I as (tid & _ & I).
    exact (SettledWidest sign cuts LevelGap vs O LevelGapSmall tid t I).
  - intros tid tid' t t'.
    exact (SettledInteriorsApart sign cuts LevelGap vs O LevelGapSmall tid tid' t t'
      LevelGapAtLeast0).
  - exact (SettledPiecesKept th sign cuts LevelGap vs (OpenDecided sample)).
  - exact (SettledNoPieceLost th sign cuts LevelGap vs).
  - exact (SettledOutsideKept th sign cuts LevelGap vs).
  - exact (SettledMakesNoCavity th sign cuts LevelGap vs).
Qed.
