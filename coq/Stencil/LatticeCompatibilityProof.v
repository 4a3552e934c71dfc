(** * The stencils are compatible across every face of the lattice

    Section 6 of the paper: both functions together.  Each theorem is one of
    the six arrangements of [CompatibilityOrders]. *)

From Certet Require Import Lattice.Coord3 Lattice.StructuredTet.
From Certet Require Import Lattice.NeighborSpec Lattice.Arrangement.
From Certet Require Import Lattice.ArrangementProof.
From Certet Require Import Stencil.UnstructuredTet Stencil.CompatibilitySpec.
From Certet Require Import Stencil.CompatibilityProof.

Lemma ArrangedCompatible Vertex GetSign GetIntersection f1 f2 f3 p q
    u1 u2 u3 u4 v1 v2 v3 v4 :
  Arranged f1 f2 f3 p q u1 u2 u3 u4 v1 v2 v3 v4 ->
  AllEdgesCompatible Vertex GetSign GetIntersection f1 f2 f3 p q
    u1 u2 u3 u4 v1 v2 v3 v4.
Proof.
  destruct (CompatibilityOrders Vertex GetSign GetIntersection f1 f2 f3 p q)
    as (order1 & order2 & order3 & order4 & order5 & order6).
  now intros [].
Qed.

Theorem Face1Compatible :
  forall GetSign GetIntersection tid,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 (tid1, order1) _ _ _ =>
        match GetStructuredTet tid1 with
          ST u1 u2 u3 u4 _ _ _ _ =>
            let '(w1, w2, w3, w4) :=
              order1 u1 u2 u3 u4 in
            AllEdgesCompatible Coord3 GetSign
              GetIntersection w2 w3 w4 v1 w1
              v1 v2 v3 v4 u1 u2 u3 u4
        end
    end.
Proof.
  intros GetSign GetIntersection tid.
  pose proof (FaceArranged tid First) as arranged.
  destruct (GetStructuredTet tid) as [v1 v2 v3 v4 [tid1 order1] ? ? ?].
  cbn in arranged; destruct (GetStructuredTet tid1) as [u1 u2 u3 u4].
  destruct (order1 u1 u2 u3 u4) as [[[w1 w2] w3] w4].
  now apply ArrangedCompatible.
Qed.

Theorem Face2Compatible :
  forall GetSign GetIntersection tid,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 _ (tid2, order2) _ _ =>
        match GetStructuredTet tid2 with
          ST u1 u2 u3 u4 _ _ _ _ =>
            let '(w1, w2, w3, w4) :=
              order2 u1 u2 u3 u4 in
            AllEdgesCompatible Coord3 GetSign
              GetIntersection w1 w3 w4 v2 w2
              v1 v2 v3 v4 u1 u2 u3 u4
        end
    end.
Proof.
  intros GetSign GetIntersection tid.
  pose proof (FaceArranged tid Second) as arranged.
  destruct (GetStructuredTet tid) as [v1 v2 v3 v4 ? [tid2 order2] ? ?].
  cbn in arranged; destruct (GetStructuredTet tid2) as [u1 u2 u3 u4].
  destruct (order2 u1 u2 u3 u4) as [[[w1 w2] w3] w4].
  now apply ArrangedCompatible.
Qed.

Theorem Face3Compatible :
  forall GetSign GetIntersection tid,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 _ _ (tid3, order3) _ =>
        match GetStructuredTet tid3 with
          ST u1 u2 u3 u4 _ _ _ _ =>
            let '(w1, w2, w3, w4) :=
              order3 u1 u2 u3 u4 in
            AllEdgesCompatible Coord3 GetSign
              GetIntersection w1 w2 w4 v3 w3
              v1 v2 v3 v4 u1 u2 u3 u4
        end
    end.
Proof.
  intros GetSign GetIntersection tid.
  pose proof (FaceArranged tid Third) as arranged.
  destruct (GetStructuredTet tid) as [v1 v2 v3 v4 ? ? [tid3 order3] ?].
  cbn in arranged; destruct (GetStructuredTet tid3) as [u1 u2 u3 u4].
  destruct (order3 u1 u2 u3 u4) as [[[w1 w2] w3] w4].
  now apply ArrangedCompatible.
Qed.

Theorem Face4Compatible :
  forall GetSign GetIntersection tid,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 _ _ _ (tid4, order4) =>
        match GetStructuredTet tid4 with
          ST u1 u2 u3 u4 _ _ _ _ =>
            let '(w1, w2, w3, w4) :=
              order4 u1 u2 u3 u4 in
            AllEdgesCompatible Coord3 GetSign
              GetIntersection w1 w2 w3 v4 w4
              v1 v2 v3 v4 u1 u2 u3 u4
        end
    end.
Proof.
  intros GetSign GetIntersection tid.
  pose proof (FaceArranged tid Fourth) as arranged.
  destruct (GetStructuredTet tid) as [v1 v2 v3 v4 ? ? ? [tid4 order4]].
  cbn in arranged; destruct (GetStructuredTet tid4) as [u1 u2 u3 u4].
  destruct (order4 u1 u2 u3 u4) as [[[w1 w2] w3] w4].
  now apply ArrangedCompatible.
Qed.
