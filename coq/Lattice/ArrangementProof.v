(** * Face neighbours of the lattice stand in one of the six arrangements *)

From Coq Require Import List.
From Certet Require Import Lattice.Coord3 Lattice.StructuredTet.
From Certet Require Import Lattice.StructuredTetSpec Lattice.StructuredTetProof.
From Certet Require Import Lattice.NeighborSpec Lattice.Arrangement.
Import ListNotations.

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

Definition AllDistinct (a b c d : Coord3) : Prop :=
  a <> b /\ a <> c /\ a <> d /\ b <> c /\ b <> d /\ c <> d.

Lemma ArrangedDistinct (f1 f2 f3 p q v1 v2 v3 v4 u1 u2 u3 u4 : Coord3) :
  Arranged f1 f2 f3 p q v1 v2 v3 v4 u1 u2 u3 u4 ->
  AllDistinct v1 v2 v3 v4 -> AllDistinct u1 u2 u3 u4 -> p <> q ->
  NoDup [f1; f2; f3; p; q].
Proof.
  unfold AllDistinct; intros []; repeat constructor; cbn; intuition congruence.
Qed.

(** The same, with the face as the tetrahedron itself lists it. *)
Lemma FaceShared (tid : StructuredTetId) (i : Place) :
  exists f1 f2 f3 p q : Coord3,
    FaceAcross (GetStructuredTet tid) i = [f1; f2; f3] /\
    NoDup [f1; f2; f3; p; q] /\
    match GetStructuredTet tid,
          GetStructuredTet (fst (NeighborAcross (GetStructuredTet tid) i)) with
      ST v1 v2 v3 v4 _ _ _ _, ST u1 u2 u3 u4 _ _ _ _ =>
        Arranged f1 f2 f3 p q v1 v2 v3 v4 u1 u2 u3 u4
    end.
Proof.
  pose proof (FaceArranged tid i) as arranged.
  pose proof (FacesCorrect tid) as correct.
  pose proof (VerticesDistinct tid) as distinct.
  destruct (GetStructuredTet tid)
    as [v1 v2 v3 v4 [tid1 o1] [tid2 o2] [tid3 o3] [tid4 o4]].
  unfold Face1Correct, Face2Correct, Face3Correct, Face4Correct, U in correct.
  destruct i; cbn [NeighborAcross FaceAcross fst] in *.
  - destruct correct as (face & _).
    pose proof (VerticesDistinct tid1) as distinct1.
    destruct (GetStructuredTet tid1) as [u1 u2 u3 u4].
    destruct (o1 u1 u2 u3 u4) as [[[w1 w2] w3] w4].
    destruct face as (apart & <- & <- & <-).
    exists v2, v3, v4, v1, w1; repeat split; eauto using ArrangedDistinct.
  - destruct correct as (_ & face & _).
    pose proof (VerticesDistinct tid2) as distinct2.
    destruct (GetStructuredTet tid2) as [u1 u2 u3 u4].
    destruct (o2 u1 u2 u3 u4) as [[[w1 w2] w3] w4].
    destruct face as (<- & apart & <- & <-).
    exists v1, v3, v4, v2, w2; repeat split; eauto using ArrangedDistinct.
  - destruct correct as (_ & _ & face & _).
    pose proof (VerticesDistinct tid3) as distinct3.
    destruct (GetStructuredTet tid3) as [u1 u2 u3 u4].
    destruct (o3 u1 u2 u3 u4) as [[[w1 w2] w3] w4].
    destruct face as (<- & <- & apart & <-).
    exists v1, v2, v4, v3, w3; repeat split; eauto using ArrangedDistinct.
  - destruct correct as (_ & _ & _ & face).
    pose proof (VerticesDistinct tid4) as distinct4.
    destruct (GetStructuredTet tid4) as [u1 u2 u3 u4].
    destruct (o4 u1 u2 u3 u4) as [[[w1 w2] w3] w4].
    destruct face as (<- & <- & <- & apart).
    exists v1, v2, v3, v4, w4; repeat split; eauto using ArrangedDistinct.
Qed.
