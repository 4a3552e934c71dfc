(** * The surface of the mesh that keeps the shape: proof *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Embedding.GreedyProof Embedding.LinkProof
  Embedding.SettleProof Embedding.SettledMeshProof Topology.DiskPointProof
  Topology.DiskKeptProof Topology.DiskManifoldProof.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpVertex Settle StrictDisk].

(** ** The strict disk in so many words *)

Lemma WholeMeans v (inside : Coord3 -> Prop) :
  Whole v inside <->
  (exists x, inside x /\ Adjacent v x) /\ Hangs (fun x => inside x /\ Adjacent v x).
Proof.
  assert (S : forall x, Adjacent v x /\ inside x <-> inside x /\ Adjacent v x)
    by tauto.
  unfold Whole, Hangs. split; intros [(x & X) J].
  - split; [exists x; tauto|]. intros u w U W.
    apply (JoinedSame _ _ _ u w S). apply J; tauto.
  - split; [exists x; tauto|]. intros u w Vu U Vw W.
    apply (JoinedSame _ _ _ u w S). apply J; tauto.
Qed.

Lemma GoodEdgeMeans now v z : GoodEdge now v z <-> RunAround now v z.
Proof.
  assert (S : forall x, Adjacent v x /\ Adjacent z x /\ now x = Plus <->
    now x = Plus /\ Adjacent v x /\ Adjacent z x) by tauto.
  unfold GoodEdge, RunAround, Hangs. split; intros [(x & X) J].
  - split; [exists x; tauto|]. intros u w U W.
    apply (JoinedSame _ _ _ u w S). apply J; tauto.
  - split; [exists x; tauto|]. intros u w Vu Zu U Vw Zw W.
    apply (JoinedSame _ _ _ u w S). apply J; tauto.
Qed.

Theorem StrictDiskIff now v : StrictDisk (LinkOf now v) = true <-> DiskAround now v.
Proof.
  etransitivity; [exact (PointDiskIff now v)|].
  unfold PointDisk, DiskAround. rewrite !WholeMeans. split.
  - intros ((P & P') & (N & N') & G & W). repeat (split; [assumption|]). split.
    + intros z Z A. apply GoodEdgeMeans, G; assumption.
    + intros y z p q. intros. apply (W y z p q); assumption.
  - intros (P & P' & N & N' & G & W). split; [tauto|]. split; [tauto|]. split.
    + intros y A Y. apply GoodEdgeMeans, G; assumption.
    + intros y z p q. intros. apply (W y z p q); assumption.
Qed.

(** ** Who is 0 keeps its disk *)

Lemma DisksStay sign now : (forall v, sign v <> OnSurface) ->
  ByDisks sign now -> DisksAround now.
Proof.
  intros Decided. induction 1 as [now S|v before now _ IH D V E].
  - apply NoZeroDisksAround. intros z. rewrite S. apply Decided.
  - apply (DisksAroundKept before); [exact IH| |].
    + intros u. destruct (SamePoint3 u v) as [->|N]; [|left; exact (E u N)].
      destruct (before v) eqn:B; [right|left; congruence|right];
        (split; [exact V|]; split; [congruence|exact D]).
    + intros u w U W A. apply (NeverAdjacent v).
      assert (Only : forall x, now x <> before x -> x = v).
      { intros x X. destruct (SamePoint3 x v) as [|N]; [assumption|].
        destruct (X (E x N)). }
      rewrite (Only u U), (Only w W) in A. exact A.
Qed.

Theorem SettledDisksAround th sample cut gap vs :
  let sign := OpenSigns sample in
  DisksAround (SignAmong sign (Settle th sign cut gap vs)).
Proof.
  intros sign. apply (DisksStay sign); [exact (OpenDecided sample)|].
  apply SettledByDisks.
Qed.

(** ** The surface *)

Theorem SettledSurfaceManifold th sample cut gap vs a b c :
  let sign := OpenSigns sample in
  let warping := PlaceIn (Settle th sign cut gap vs) in
  ManifoldAt sign warping a b c.
Proof.
  intros sign warping. apply SurfaceManifold.
  apply (DisksAroundSame (SignAmong sign (Settle th sign cut gap vs)));
    [reflexivity|apply SettledDisksAround].
Qed.
