(** * The stencils are compatible across every face

    Section 6 of the paper: lattice and stencils together.  In a tiling whose
    neighbours stand in the six arrangements any compatible set of stencils
    fits; that the paper's fit the lattice is written out for the four faces. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Lattice.Arrangement Lattice.Tiling
  Lattice.TilingProof Lattice.ArrangementProof Stencil.TilingSpec
  Stencil.CompatibilityProof.

Lemma ArrangedCompatible S Vertex GetSign GetIntersection f1 f2 f3 p q
    u1 u2 u3 u4 v1 v2 v3 v4 :
  CompatibleStencils S ->
  Arranged f1 f2 f3 p q u1 u2 u3 u4 v1 v2 v3 v4 ->
  AllStencilEdgesCompatible S Vertex GetSign GetIntersection f1 f2 f3 p q
    u1 u2 u3 u4 v1 v2 v3 v4.
Proof.
  intros compatible.
  destruct (compatible Vertex GetSign GetIntersection f1 f2 f3 p q)
    as (order1 & order2 & order3 & order4 & order5 & order6).
  now intros [].
Qed.

Theorem StencilsFitTiling :
  forall (S : StencilSet) (T : Tiling),
    CompatibleStencils S -> TilingFacesCorrect T -> OrdersKnown T ->
    CompatibleInTiling S T.
Proof.
  intros S T compatible correct known GetSign GetIntersection id i v u w.
  pose proof (TilingArranged T correct known id i) as arranged.
  destruct (Others i) as [[j k] l]; now apply ArrangedCompatible.
Qed.

Theorem StencilsFitLattice : CompatibleInTiling GetUnstructuredTets LatticeTiling.
Proof.
  exact (StencilsFitTiling GetUnstructuredTets LatticeTiling CompatibilityOrders
           LatticeFacesCorrect LatticeOrdersKnown).
Qed.

(** ** The four faces *)

Definition CompatibleAcross (i : Place) : Prop :=
  forall GetSign GetIntersection tid,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 nei1 nei2 nei3 nei4 =>
        let '(nei, order) := Pick (nei1, nei2, nei3, nei4) i in
        match GetStructuredTet nei with
          ST u1 u2 u3 u4 _ _ _ _ =>
            let '(w1, w2, w3, w4) := order u1 u2 u3 u4 in
            let w := Pick (w1, w2, w3, w4) in
            let '(j, k, l) := Others i in
            AllEdgesCompatible Coord3 GetSign GetIntersection
              (w j) (w k) (w l) (Pick (v1, v2, v3, v4) i) (w i)
              v1 v2 v3 v4 u1 u2 u3 u4
        end
    end.

Lemma FaceCompatible i : CompatibleAcross i.
Proof.
  intros GetSign GetIntersection tid.
  pose proof (StencilsFitLattice GetSign GetIntersection tid i) as fits. revert fits.
  unfold LinedUp; cbn [LatticeTiling Identifier VertexOf NeighborAt].
  destruct (GetStructuredTet tid) as [? ? ? ? [tid1 ?] [tid2 ?] [tid3 ?] [tid4 ?]].
  destruct i; cbn [NeighborAcross VertexAt fst snd Pick Others].
  - destruct (GetStructuredTet tid1); cbn [VertexAt]; now destruct (_ _ _ _ _) as [[[? ?] ?] ?].
  - destruct (GetStructuredTet tid2); cbn [VertexAt]; now destruct (_ _ _ _ _) as [[[? ?] ?] ?].
  - destruct (GetStructuredTet tid3); cbn [VertexAt]; now destruct (_ _ _ _ _) as [[[? ?] ?] ?].
  - destruct (GetStructuredTet tid4); cbn [VertexAt]; now destruct (_ _ _ _ _) as [[[? ?] ?] ?].
Qed.

Theorem Face1Compatible : CompatibleAcross First.
Proof. apply FaceCompatible. Qed.
Theorem Face2Compatible : CompatibleAcross Second.
Proof. apply FaceCompatible. Qed.
Theorem Face3Compatible : CompatibleAcross Third.
Proof. apply FaceCompatible. Qed.
Theorem Face4Compatible : CompatibleAcross Fourth.
Proof. apply FaceCompatible. Qed.
