(** * The rule of the strict disk gives a manifold: proof *)

From Coq Require Import ZArith List Bool Lia.
From Certet Require Import Lattice.Definitions Stencil.Definitions
  Warp.Definitions Stuffing.Definitions Angles.Definitions Embedding.Definitions
  Topology.Definitions.
From Certet Require Import Angles.AngleTheorems Embedding.DiskRuleProof
  Embedding.DiskPiecesProof Topology.LocalSurfaceProof Topology.SurfaceProof
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

Section Rule.
  Variables (th : Thresholds) (sign : SignField) (cut : CutField).
  Variable turn : Coord3 -> nat.

  Hypothesis Decided : forall v, sign v <> OnSurface.
  Hypothesis Turns : forall v d, let u := Translate v (Offset d) in
    Violated th sign cut v = true -> Violated th sign cut u = true ->
    turn v <> turn u.

  Local Notation settled := (Settled th sign cut turn).
  Local Notation now := (SignNow th sign cut turn).

  Lemma NowChanges n v : now (S n) v <> now n v ->
    settled (S n) v = true /\ settled n v = false.
  Proof.
    unfold SignNow. intros N. pose proof (SettledStays th sign cut turn n v) as S.
    destruct (settled n v); [rewrite S in N by reflexivity; congruence|].
    destruct (settled (Datatypes.S n) v); [auto|congruence].
  Qed.

  Lemma DisksAroundNow n : DisksAround (now n).
  Proof.
    induction n as [|n IH].
    - apply NoZeroDisksAround. intros v. exact (Decided v).
    - apply (DisksAroundKept (now n)); [exact IH| |].
      + intros v. destruct (settled (S n) v) eqn:S.
        * destruct (settled n v) eqn:S'.
          -- left. unfold SignNow. rewrite S, S'. reflexivity.
          -- right. split; [apply (NowZero th sign cut turn Decided), S|].
             split; [rewrite (NowZero th sign cut turn Decided); congruence|].
             apply (SettledMeans th sign cut turn n v S S').
        * left. unfold SignNow. rewrite S.
          destruct (settled n v) eqn:S'; [|reflexivity].
          rewrite (SettledStays th sign cut turn n v S') in S. discriminate S.
      + intros u v U V. apply NowChanges in U, V. destruct U as [U U'], V as [V V'].
        exact (NotAdjacent th sign cut turn Turns n u v U U' V V').
  Qed.

  Lemma DisksAroundAfter turns limit : DisksAround (SignAfter sign
    (RuledWarping th sign cut (DiskStays th sign cut turn turns) limit)).
  Proof.
    apply (DisksAroundSame (now turns)); [|apply DisksAroundNow].
    intros v. apply AfterDisk.
  Qed.
End Rule.

(** ** The mesh *)

Theorem DiskRuleLinks th sign cut limit : (forall v, sign v <> OnSurface) ->
  DisksAround (SignAfter sign (RuledWarping th sign cut (DiskRule th sign cut) limit)).
Proof. intros D. apply DisksAroundAfter; [exact D|apply TurnsDiffer]. Qed.

Theorem SurfaceManifold before warping a b c :
  DisksAround (SignAfter before warping) -> SurfaceTriangle before warping a b c ->
  (exists d, d <> c /\ SurfaceTriangle before warping a b d /\
     forall e, SurfaceTriangle before warping a b e -> e = c \/ e = d) /\
  (forall x, InFan before warping a x -> JoinedInFan before warping a b x).
Proof.
  intros D T. split; [exact (EdgesInTwo before warping a b c D T)|].
  intros x X. apply OneFan; [exact D|exists c; exact T|exact X].
Qed.

Theorem DiskSurfaceManifold th sign cut limit a b c :
  let warping := RuledWarping th sign cut (DiskRule th sign cut) limit in
  (forall v, sign v <> OnSurface) -> SurfaceTriangle sign warping a b c ->
  (exists d, d <> c /\ SurfaceTriangle sign warping a b d /\
     forall e, SurfaceTriangle sign warping a b e -> e = c \/ e = d) /\
  (forall x, InFan sign warping a x -> JoinedInFan sign warping a b x).
Proof.
  intros warping D. apply SurfaceManifold, DiskRuleLinks, D.
Qed.

(** Where there are no 0 corners, nothing is asked. *)
Theorem MidpointSurfaceManifold sign a b c :
  let decided v := InOrOut (sign v) in
  let warping := WarpVertex NoWarpThresholds decided (fun _ _ => MidpointCut) in
  SurfaceTriangle decided warping a b c ->
  (exists d, d <> c /\ SurfaceTriangle decided warping a b d /\
     forall e, SurfaceTriangle decided warping a b e -> e = c \/ e = d) /\
  (forall x, InFan decided warping a x -> JoinedInFan decided warping a b x).
Proof.
  intros decided warping. apply SurfaceManifold. apply NoZeroDisksAround.
  intros v. unfold SignAfter, warping. cbn [PlacedSign].
  rewrite AngleTheorems.NeverWarped.
  - unfold decided. cbn [WarpedSign]. destruct (sign v); discriminate.
  - intros p q _ _. split; discriminate.
Qed.

(** Nor at a cut. *)
Theorem CutsManifold before warping p m b c :
  SurfaceTriangle before warping (Cut p m) b c ->
  (exists d, d <> c /\ SurfaceTriangle before warping (Cut p m) b d /\
     forall e, SurfaceTriangle before warping (Cut p m) b e -> e = c \/ e = d) /\
  (forall x, InFan before warping (Cut p m) x ->
     JoinedInFan before warping (Cut p m) b x).
Proof.
  intros T. split.
  - apply CutEdge; [exact T|]. intros x y E. discriminate E.
  - intros x X. destruct (SurfaceWhere before warping _ _ _ T) as (tid & E & L).
    destruct (LocalOnIt before warping tid _ _ _ E L) as ([(_ & _ & P & M) _] & _ & _).
    apply CutFan; [exact P|exact M|exists c; exact T|exact X].
Qed.
