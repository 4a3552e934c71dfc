(** * The rule of the strict disk gives a manifold: proof *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Angles.AngleTheorems Embedding.DiskRuleProof
  Embedding.DiskPiecesProof Topology.LocalSurfaceProof Topology.SurfaceProof
  Topology.PlacedSurfaceProof
  Topology.EdgeProof Topology.FanProof Topology.CutEdgeProof
  Topology.DiskPointProof Topology.DiskKeptProof.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpVertex Settled StrictDisk].

Lemma DisksAroundSame s s' : (forall x, s' x = s x) -> DisksAround s -> DisksAround s'.
Proof.
  intros E D z Z [d P]. apply (PointDiskIff s' z).
  apply (PointDiskSame s); [intros x _; apply E|]. apply PointDiskIff.
  rewrite E in Z, P. apply D; [exact Z|]. exists d. exact P.
Qed.

Lemma NoZeroDisksAround s : (forall v, s v <> OnSurface) -> DisksAround s.
Proof. intros N z Z. destruct (N z Z). Qed.

(** ** Turn by turn *)

Lemma DisksAroundNow th sign cut turn n : (forall v, sign v <> OnSurface) ->
  TakeTurns th sign cut turn -> DisksAround (SignNow th sign cut turn n).
Proof.
  intros Decided Turns. induction n as [|n IH].
  - apply NoZeroDisksAround. intros v. exact (Decided v).
  - apply (DisksAroundKept (SignNow th sign cut turn n)); [exact IH| |].
    + intros v. destruct (NowStep th sign cut turn Decided n v) as [E|(Z & N & S & S')];
        [left; exact E|right].
      split; [exact Z|]. split; [exact N|].
      apply (SettledMeans th sign cut turn n v S S').
    + intros u v. exact (ChangesApart th sign cut turn Decided Turns n u v).
Qed.

Lemma DisksAroundAfter th sign cut turn turns limit : (forall v, sign v <> OnSurface) ->
  TakeTurns th sign cut turn -> DisksAround (SignAfter sign
    (RuledWarping th sign cut (DiskStays th sign cut turn turns) limit)).
Proof.
  intros Decided Turns.
  apply (DisksAroundSame (SignNow th sign cut turn turns));
    [|exact (DisksAroundNow th sign cut turn turns Decided Turns)].
  intros v. apply AfterDisk.
Qed.

(** ** The mesh *)

Theorem DiskRuleLinks th sign cut limit : (forall v, sign v <> OnSurface) ->
  DisksAround (SignAfter sign (RuledWarping th sign cut (DiskRule th sign cut) limit)).
Proof. intros D. apply DisksAroundAfter; [exact D|exact (TurnsDiffer th sign cut)]. Qed.

(** The edge of a triangle is in one other, and the triangles at its end are one
    fan. *)
Definition ManifoldAt (before : SignField) (warping : Coord3 -> Warping)
  (a b c : MeshVertex) : Prop :=
  SurfaceTriangle before warping a b c ->
  (exists d, d <> c /\ SurfaceTriangle before warping a b d /\
     forall e, SurfaceTriangle before warping a b e -> e = c \/ e = d) /\
  (forall x, InFan before warping a x -> JoinedInFan before warping a b x).

(** Every edge of the surface is in an even number of its triangles. *)
Theorem BoundaryClosed before warping a b c :
  SurfaceTriangle before warping a b c ->
  exists thirds, NoDup thirds /\
    (forall d, In d thirds <-> SurfaceTriangle before warping a b d) /\
    Nat.Even (length thirds).
Proof. exact (EdgesInEven (PlacedSurface before warping) a b c). Qed.

Theorem SurfaceManifold before warping a b c :
  DisksAround (SignAfter before warping) -> ManifoldAt before warping a b c.
Proof.
  intros D T. split; [exact (EdgesInTwo (PlacedSurface before warping) a b c D T)|].
  intros x X. apply (OneFan (PlacedSurface before warping)); [exact D|exists c; exact T|exact X].
Qed.

Theorem DiskSurfaceManifold th sign cut limit a b c :
  let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
  (forall v, sign v <> OnSurface) -> ManifoldAt sign warping a b c.
Proof.
  intros warping D. apply SurfaceManifold, DiskRuleLinks, D.
Qed.

(** Where there are no 0 corners, nothing is asked. *)
Theorem MidpointSurfaceManifold sign a b c :
  let decided v := InOrOut (sign v) in
  let warping := WarpVertex NoWarpThresholds decided (fun _ _ => MidpointCut) in
  ManifoldAt decided warping a b c.
Proof.
  intros decided warping. apply SurfaceManifold. apply NoZeroDisksAround.
  intros v. unfold SignAfter, warping. cbn [PlacedSign].
  rewrite AngleTheorems.NeverWarped.
  - unfold decided. cbn [WarpedSign]. destruct (sign v); discriminate.
  - intros p q _ _. split; discriminate.
Qed.

(** Nor at a cut. *)
Theorem CutsManifold before warping p m b c :
  ManifoldAt before warping (Cut p m) b c.
Proof.
  intros T. split.
  - apply (CutEdge (PlacedSurface before warping)); [exact T|]. intros x y E. discriminate E.
  - intros x X. destruct (SurfaceWhere (PlacedSurface before warping) _ _ _ T) as (tid & E & L).
    destruct (LocalOnIt (PlacedSurface before warping) tid _ _ _ E L) as ([(_ & _ & P & M) _] & _ & _).
    apply (CutFan (PlacedSurface before warping)); [exact P|exact M|exists c; exact T|exact X].
Qed.
