(** * Face neighbours stand in one of the six arrangements *)

From Certet Require Import Lattice.Definitions.
From Certet Require Import Lattice.Tiling Lattice.TilingProof
  Lattice.Arrangement.

Definition AllDistinct (a b c d : Coord3) : Prop :=
  a <> b /\ a <> c /\ a <> d /\ b <> c /\ b <> d /\ c <> d.

Lemma ArrangedDistinct (f1 f2 f3 p q v1 v2 v3 v4 u1 u2 u3 u4 : Coord3) :
  Arranged f1 f2 f3 p q v1 v2 v3 v4 u1 u2 u3 u4 ->
  AllDistinct v1 v2 v3 v4 -> AllDistinct u1 u2 u3 u4 -> p <> q ->
  NoDup [f1; f2; f3; p; q].
Proof.
  unfold AllDistinct; intros []; repeat constructor; cbn; intuition congruence.
Qed.

(** ** In any tiling whose orders are known *)

Section Tiling.
  Variable T : Tiling.
  Hypothesis Correct : TilingFacesCorrect T.
  Hypothesis Known : OrdersKnown T.
  Hypothesis Apart : VerticesApart T.

  Lemma TilingDistinct (id : Identifier T) :
    AllDistinct (VertexOf id First) (VertexOf id Second)
                (VertexOf id Third) (VertexOf id Fourth).
  Proof. repeat split; intros same; apply Apart in same; discriminate. Qed.

  Variables (id : Identifier T) (i : Place).
  Let v := VertexOf id.
  Let u := VertexOf (fst (NeighborAt id i)).
  Let w := LinedUp T id i.

  Lemma TilingArranged :
    let '(j, k, l) := Others i in
    Arranged (w j) (w k) (w l) (v i) (w i)
      (v First) (v Second) (v Third) (v Fourth)
      (u First) (u Second) (u Third) (u Fourth).
  Proof.
    assert (own : forall j, j <> i -> w j = v j) by (intros j; apply Correct).
    pose proof (Known id i) as known.
    subst u w; unfold LinedUp in *; destruct (NeighborAt id i) as [nei order].
    cbn [fst snd] in *; clearbody v.
    destruct i; cbn [Others];
      [ rewrite <- (own Second), <- (own Third), <- (own Fourth) by discriminate
      | rewrite <- (own First), <- (own Third), <- (own Fourth) by discriminate
      | rewrite <- (own First), <- (own Second), <- (own Fourth) by discriminate
      | rewrite <- (own First), <- (own Second), <- (own Third) by discriminate ];
      (destruct known as [-> | [[first | second] ->]]; try discriminate;
       cbn [Pick Order1234 Order2143]; constructor).
  Qed.

  (** The five points are five, and the face is listed as the tetrahedron itself
      lists it. *)
  Lemma TilingFaceShared :
    exists f1 f2 f3 p q : Coord3,
      (let '(j, k, l) := Others i in [v j; v k; v l]) = [f1; f2; f3] /\
      NoDup [f1; f2; f3; p; q] /\
      Arranged f1 f2 f3 p q
        (v First) (v Second) (v Third) (v Fourth)
        (u First) (u Second) (u Third) (u Fourth).
  Proof.
    pose proof TilingArranged as arranged.
    assert (own : forall j, j <> i -> w j = v j) by (intros j; apply Correct).
    assert (across : v i <> w i) by (intros same; now apply (Correct id i i)).
    destruct (Others i) as [[j k] l] eqn:others.
    exists (w j), (w k), (w l), (v i), (w i); split; [| split; [| exact arranged]].
    - destruct i; injection others as <- <- <-;
        now rewrite !own by discriminate.
    - exact (ArrangedDistinct _ _ _ _ _ _ _ _ _ _ _ _ _ arranged
        (TilingDistinct id) (TilingDistinct _) across).
  Qed.
End Tiling.

(** ** In the lattice *)

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
  destruct (TilingFaceShared LatticeTiling LatticeFacesCorrect LatticeOrdersKnown
              LatticeVerticesApart tid i)
    as (f1 & f2 & f3 & p & q & face & distinct & arranged).
  exists f1, f2, f3, p, q; split; [rewrite <- face | split; [exact distinct |]].
  - cbn [LatticeTiling VertexOf]; destruct (GetStructuredTet tid); now destruct i.
  - revert arranged; cbn [LatticeTiling Identifier VertexOf NeighborAt].
    generalize (fst (NeighborAcross (GetStructuredTet tid) i)); intros nei.
    destruct (GetStructuredTet nei), (GetStructuredTet tid).
    exact (fun arranged => arranged).
Qed.
