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

Ltac across i :=
  let GetSign := fresh in let GetIntersection := fresh in let tid := fresh in
  intros GetSign GetIntersection tid;
  pose proof (StencilsFitLattice GetSign GetIntersection tid i) as fits;
  revert fits; unfold LinedUp;
  cbn [LatticeTiling Identifier VertexOf NeighborAt Others];
  destruct (GetStructuredTet tid) as [? ? ? ? [tid1 ?] [tid2 ?] [tid3 ?] [tid4 ?]];
  cbn [NeighborAcross VertexAt fst];
  lazymatch i with
  | First => destruct (GetStructuredTet tid1)
  | Second => destruct (GetStructuredTet tid2)
  | Third => destruct (GetStructuredTet tid3)
  | Fourth => destruct (GetStructuredTet tid4)
  end;
  cbn [VertexAt];
  lazymatch goal with |- context [let '(_, _) := ?w in _] => destruct w as [[[? ?] ?] ?] end;
  exact (fun fits => fits).

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
Proof. across First. Qed.

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
Proof. across Second. Qed.

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
Proof. across Third. Qed.

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
Proof. across Fourth. Qed.
