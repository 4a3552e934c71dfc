(** * Face neighbours of the lattice stand in one of the six arrangements *)

From Certet Require Import Lattice.Coord3 Lattice.StructuredTet.
From Certet Require Import Lattice.StructuredTetSpec Lattice.StructuredTetProof.
From Certet Require Import Lattice.NeighborSpec Lattice.Arrangement.

(** Across its even vertices a tetrahedron may meet the neighbour's in reverse
    order, across its odd ones never. *)
Lemma NeighborOrders (tid : StructuredTetId) :
  match GetStructuredTet tid with
    ST _ _ _ _ (_, o1) (_, o2) (_, o3) (_, o4) =>
      (o1 = Order1234 \/ o1 = Order2143) /\
      (o2 = Order1234 \/ o2 = Order2143) /\
      o3 = Order1234 /\ o4 = Order1234
  end.
Proof. destruct tid as [anchor []]; cbn; tauto. Qed.

Lemma FaceArranged (tid : StructuredTetId) (i : Place) :
  let '(nei, order) := NeighborAcross (GetStructuredTet tid) i in
  match GetStructuredTet tid, GetStructuredTet nei with
    ST v1 v2 v3 v4 _ _ _ _, ST u1 u2 u3 u4 _ _ _ _ =>
      let '(w1, w2, w3, w4) := order u1 u2 u3 u4 in
      match i with
      | First => Arranged w2 w3 w4 v1 w1 v1 v2 v3 v4 u1 u2 u3 u4
      | Second => Arranged w1 w3 w4 v2 w2 v1 v2 v3 v4 u1 u2 u3 u4
      | Third => Arranged w1 w2 w4 v3 w3 v1 v2 v3 v4 u1 u2 u3 u4
      | Fourth => Arranged w1 w2 w3 v4 w4 v1 v2 v3 v4 u1 u2 u3 u4
      end
  end.
Proof.
  pose proof (FacesCorrect tid) as correct.
  pose proof (NeighborOrders tid) as orders.
  destruct (GetStructuredTet tid)
    as [v1 v2 v3 v4 [tid1 o1] [tid2 o2] [tid3 o3] [tid4 o4]].
  destruct correct as (face1 & face2 & face3 & face4).
  destruct orders as (order1 & order2 & -> & ->).
  destruct i; cbn [NeighborAcross].
  - unfold Face1Correct, U in face1.
    destruct (GetStructuredTet tid1) as [u1 u2 u3 u4].
    destruct order1 as [-> | ->]; cbn in *;
      destruct face1 as (_ & -> & -> & ->); constructor.
  - unfold Face2Correct, U in face2.
    destruct (GetStructuredTet tid2) as [u1 u2 u3 u4].
    destruct order2 as [-> | ->]; cbn in *;
      destruct face2 as (-> & _ & -> & ->); constructor.
  - unfold Face3Correct, U in face3.
    destruct (GetStructuredTet tid3) as [u1 u2 u3 u4]; cbn in *.
    destruct face3 as (-> & -> & _ & ->); constructor.
  - unfold Face4Correct, U in face4.
    destruct (GetStructuredTet tid4) as [u1 u2 u3 u4]; cbn in *.
    destruct face4 as (-> & -> & -> & _); constructor.
Qed.
