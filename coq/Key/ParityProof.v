(** * The Parity Rule is an order of the cuts: proof *)

From Certet Require Import Key.Definitions.
From Certet Require Import Embedding.EdgeRank.
Open Scope Z_scope.

Theorem ParityIsAnOrder :
  forall Vertex GetSign GetIntersection GetKey (v1 v2 v3 v4 : Vertex),
    KeepsParity GetKey v1 v2 v3 v4 ->
    GetKeyTets Vertex GetSign GetIntersection GetKey v1 v2 v3 v4
    = GetUnstructuredTets Vertex GetSign GetIntersection v1 v2 v3 v4.
Proof.
  intros Vertex GetSign GetIntersection GetKey v1 v2 v3 v4
    (long & first & second & order & longs & firsts & seconds).
  cbn [In] in longs, firsts, seconds.
  assert (decided : forall x y, x < y -> (x <? y) = true /\ (y <? x) = false)
    by (intros x y L; split; [apply Z.ltb_lt | apply Z.ltb_ge]; lia).
  destruct (decided long first) as [LF FL]; [lia|].
  destruct (decided long second) as [LS SL]; [lia|].
  destruct (decided first second) as [FS SF]; [lia|].
  unfold GetKeyTets, GetUnstructuredTets.
  destruct (GetSign v1), (GetSign v2), (GetSign v3), (GetSign v4); try reflexivity;
    unfold Prism, Pyramid, Wedge, WedgeTowards, Before;
    rewrite ?(longs v1 v2), ?(longs v2 v1), ?(longs v3 v4), ?(longs v4 v3),
      ?(firsts v1 v4), ?(firsts v4 v1), ?(firsts v2 v3), ?(firsts v3 v2),
      ?(seconds v1 v3), ?(seconds v3 v1), ?(seconds v2 v4), ?(seconds v4 v2) by tauto;
    rewrite ?LF, ?FL, ?LS, ?SL, ?FS, ?SF; reflexivity.
Qed.

(** ** In the lattice *)

Lemma LatticeKeepsParity (key : Coord3 -> Coord3 -> Z) (shift : Z) tid : InLattice tid ->
  (forall a b, In a (Corners tid) -> In b (Corners tid) ->
     key a b = shift + EdgeRank a b) ->
  match GetStructuredTet tid with
    ST v1 v2 v3 v4 _ _ _ _ =>
      KeepsParity (MeshKey key) (Corner v1) (Corner v2) (Corner v3) (Corner v4)
  end.
Proof.
  intros Even keys. pose proof (RankAt tid Even) as ranks.
  unfold Corners in keys. destruct (GetStructuredTet tid) as [v1 v2 v3 v4 n1 n2 n3 n4].
  exists shift, (shift + 1), (shift + 2). split; [lia|].
  set (at_ := VertexAt (ST v1 v2 v3 v4 n1 n2 n3 n4)) in *.
  assert (E : forall i j, key (at_ i) (at_ j) = shift + PlaceRank i j).
  { intros i j. rewrite keys, ranks by (destruct i, j; cbn; tauto). reflexivity. }
  repeat split; intros a b I; cbn [In] in I;
    repeat (destruct I as [[= <- <-]|I]; [cbn [MeshKey]|]); try contradiction.
  - exact (eq_trans (E First Second) (Z.add_0_r _)).
  - exact (eq_trans (E Second First) (Z.add_0_r _)).
  - exact (eq_trans (E Third Fourth) (Z.add_0_r _)).
  - exact (eq_trans (E Fourth Third) (Z.add_0_r _)).
  - exact (E First Fourth).
  - exact (E Fourth First).
  - exact (E Second Third).
  - exact (E Third Second).
  - exact (E First Third).
  - exact (E Third First).
  - exact (E Second Fourth).
  - exact (E Fourth Second).
Qed.

(** If all cuts are equally far from their + ends, as those in the middle are, the
    tetrahedra are the paper's. *)
Theorem EqualCutsKeepParity before warping cut t tid : InLattice tid ->
  (forall a m, In a (Corners tid) -> In m (Corners tid) -> cut a m = t) ->
  KeyNames before warping cut tid = PlacedNames before warping tid.
Proof.
  intros Even equal.
  pose proof (LatticeKeepsParity (CutKey cut) (3 * t) tid Even) as parity.
  unfold KeyNames, OrderedNames, PlacedNames. unfold Corners in *.
  destruct tid as [anchor case]. destruct (GetStructuredTet (STId anchor case)).
  rewrite ParityIsAnOrder; [reflexivity|]. apply parity.
  intros a b A B. unfold CutKey. rewrite equal by assumption. reflexivity.
Qed.

(** And so are those in the order of the ranks alone. *)
Theorem RanksKeepParity before warping tid : InLattice tid ->
  OrderedNames EdgeRank before warping tid = PlacedNames before warping tid.
Proof.
  intros Even.
  pose proof (LatticeKeepsParity EdgeRank 0 tid Even ltac:(intros; lia)) as parity.
  unfold OrderedNames, PlacedNames.
  destruct tid as [anchor case]. destruct (GetStructuredTet (STId anchor case)).
  rewrite ParityIsAnOrder; [reflexivity|exact parity].
Qed.
