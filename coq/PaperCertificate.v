(** * The paper's certificate

    The paper's own list of statements, word for word, over its two functions:
    [GetStructuredTet], which knows the lattice, and [GetUnstructuredTets], which
    holds the stencils.  What goes beyond it is in [Certificate.v], which exports
    this page.

    [make paper] replays these proofs alone. *)

(** What runs. *)
From Certet Require Export Lattice.Coord3.
From Certet Require Export Lattice.StructuredTet Stencil.UnstructuredTet.

(** What is meant. *)
From Certet Require Export Lattice.StructuredTetSpec Stencil.CompatibilitySpec.

(** Why it holds. *)
From Certet Require Lattice.StructuredTetProof.
From Certet Require Stencil.CompatibilityProof.
From Certet Require Stencil.LatticeCompatibilityProof.

(** Every structured tetrahedron knows its four face neighbours: lined up by
    the order it gives, their vertices are its own except the one across
    (section 4.2). *)
Theorem FacesCorrect :
  forall tid : StructuredTetId,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 (tid1, o1) (tid2, o2) (tid3, o3) (tid4, o4) =>
        (Face1Correct v1 v2 v3 v4 tid1 o1) /\
        (Face2Correct v1 v2 v3 v4 tid2 o2) /\
        (Face3Correct v1 v2 v3 v4 tid3 o3) /\
        (Face4Correct v1 v2 v3 v4 tid4 o4)
    end.
Proof. exact StructuredTetProof.FacesCorrect. Qed.

(** Whatever the vertices, the signs and the cuts, no two edges of the stencils
    on the two sides of a shared face meet in their interiors, if the two
    tetrahedra stand in one of six arrangements (section 5.2). *)
Lemma CompatibilityOrders :
  forall Vertex GetSign GetIntersection f1 f2 f3 p q,
    let P := AllEdgesCompatible Vertex GetSign
               GetIntersection f1 f2 f3 p q in
    P p f1 f2 f3 q f1 f2 f3 /\
    P p f1 f2 f3 f1 q f3 f2 /\
    P f1 p f2 f3 q f1 f3 f2 /\
    P f1 p f2 f3 f1 q f2 f3 /\
    P f1 f2 p f3 f1 f2 q f3 /\
    P f1 f2 f3 p f1 f2 f3 q.
Proof. exact CompatibilityProof.CompatibilityOrders. Qed.

(** The lattice has no other arrangement, so its stencils are compatible across
    the first face of every structured tetrahedron (section 6), *)
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
Proof. exact LatticeCompatibilityProof.Face1Compatible. Qed.

(** across the second, *)
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
Proof. exact LatticeCompatibilityProof.Face2Compatible. Qed.

(** across the third, *)
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
Proof. exact LatticeCompatibilityProof.Face3Compatible. Qed.

(** and across the fourth. *)
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
Proof. exact LatticeCompatibilityProof.Face4Compatible. Qed.
