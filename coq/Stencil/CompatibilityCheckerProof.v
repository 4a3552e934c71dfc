(** * A stencil set that the checker accepts is compatible

    One small lemma for each boolean function of [CompatibilityChecker]: if it
    answers yes on symbols, the proposition of [CompatibilitySpec] holds of the
    vertices that the symbols stand for. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Stencil.Symbol Stencil.CompatibilityChecker
  Stencil.SymbolProof.

(** Takes hypotheses [a || b = true] and [a && b = true] apart. *)
Ltac take_apart :=
  repeat match goal with
  | H : (_ || _)%bool = true |- _ => apply orb_true_iff in H as [H | H]
  | H : (_ && _)%bool = true |- _ => apply andb_true_iff in H as [H ?]
  end.

(** ** Barycentric coordinates *)

Lemma IsBelowSound c a b : IsBelow c a b = true -> Below c a b.
Proof. destruct c, a, b; easy || constructor. Qed.

Lemma IsAboveSound c a b : IsAbove c a b = true -> Above c a b.
Proof. destruct c, a, b; easy || constructor. Qed.

Lemma IsBelowSymmSound c a b : IsBelowSymm c a b = true -> BelowSymm c a b.
Proof.
  unfold IsBelowSymm; intros H; take_apart;
    [apply BS_1 | apply BS_2]; now apply IsBelowSound.
Qed.

Lemma IsAboveSymmSound c a b : IsAboveSymm c a b = true -> AboveSymm c a b.
Proof.
  unfold IsAboveSymm; intros H; take_apart;
    [apply AS_1 | apply AS_2]; now apply IsAboveSound.
Qed.

Lemma PointAsideSound c a b : PointAside c a b = true -> SPNI1D c a b.
Proof.
  unfold PointAside; intros H; take_apart.
  - now apply SPNI1D_1, IsBelowSymmSound.
  - now apply SPNI1D_2, IsAboveSymmSound.
Qed.

Lemma SegmentsApartSound a b c d : SegmentsApart a b c d = true -> SSNI1D a b c d.
Proof.
  unfold SegmentsApart; intros H; take_apart;
    [apply SSNI1D_1 | apply SSNI1D_2]; now apply IsBelowSymmSound.
Qed.

(** ** Edges and stencils *)

Section Sound.
  Variable Vertex : Type.
  Variable GetIntersection : Vertex -> Vertex -> Vertex.
  Variables f1 f2 f3 p q : Vertex.

  Let interpret := Interpret Vertex GetIntersection f1 f2 f3 p q.
  Let FC := FCoord Vertex GetIntersection f1 f2 f3.

  (** The proposition that a vertex is off the face on the side of [apex]. *)
  Let Off (apex : Label) : Vertex -> Prop :=
    match apex with
    | P => PCoord Vertex GetIntersection f1 f2 f3 p
    | Q => QCoord Vertex GetIntersection f1 f2 f3 q
    | _ => fun _ => True
    end.

  Lemma FaceCoordinatesSound s a1 a2 a3 :
    FaceCoordinates s = Some (a1, a2, a3) -> FC (interpret s) a1 a2 a3.
  Proof. destruct s as [[] | [] []]; cbn; intros [= <- <- <-]; constructor. Qed.

  Lemma IsOffSound apex s : IsOff apex s = true -> Off apex (interpret s).
  Proof. destruct apex, s as [[] | [] []]; cbn; easy || constructor. Qed.

  Lemma IsSpecialSound v u1 u2 side :
    IsSpecial v u1 u2 side = true ->
    SpecialVertex Vertex (interpret v) (interpret u1) (interpret u2) (Off side).
  Proof.
    unfold IsSpecial; intros H; take_apart.
    - apply SV_1; f_equal; now apply SameSymbolEqual.
    - apply SV_2; f_equal; now apply SameSymbolEqual.
    - now apply SV_3, IsOffSound.
  Qed.

  Lemma IsAsideInFaceSound v u1 u2 side other :
    IsAsideInFace v u1 u2 = true ->
    NotIn Vertex GetIntersection f1 f2 f3
      (interpret v) (interpret u1) (interpret u2) side other.
  Proof.
    unfold IsAsideInFace.
    destruct (FaceCoordinates u1) as [[[a1 a2] a3] |] eqn:at_u1; [| easy].
    destruct (FaceCoordinates u2) as [[[b1 b2] b3] |] eqn:at_u2; [| easy].
    destruct (FaceCoordinates v) as [[[c1 c2] c3] |] eqn:at_v; [| easy].
    intros H.
    apply (NI_4 _ _ _ _ _ _ _ _ _ _ a1 a2 a3 b1 b2 b3 c1 c2 c3);
      try now apply FaceCoordinatesSound.
    take_apart; [apply SPNI3D_1 | apply SPNI3D_2 | apply SPNI3D_3];
      now apply PointAsideSound.
  Qed.

  Lemma IsNotInSound v u1 u2 side other :
    IsNotIn v u1 u2 side other = true ->
    NotIn Vertex GetIntersection f1 f2 f3
      (interpret v) (interpret u1) (interpret u2) (Off side) (Off other).
  Proof.
    unfold IsNotIn; intros H; take_apart.
    - now apply NI_1, IsSpecialSound.
    - now apply NI_2, IsOffSound.
    - now apply NI_3, IsOffSound.
    - now apply IsAsideInFaceSound.
  Qed.

  Local Notation compatible p1 p2 q1 q2 :=
    (TwoEdgesCompatible Vertex GetIntersection f1 f2 f3 p q
      (interpret p1) (interpret p2) (interpret q1) (interpret q2)).

  Lemma AreApartInFaceSound p1 p2 q1 q2 :
    AreApartInFace p1 p2 q1 q2 = true -> compatible p1 p2 q1 q2.
  Proof.
    unfold AreApartInFace.
    destruct (FaceCoordinates p1) as [[[a1 a2] a3] |] eqn:at_p1; [| easy].
    destruct (FaceCoordinates p2) as [[[b1 b2] b3] |] eqn:at_p2; [| easy].
    destruct (FaceCoordinates q1) as [[[c1 c2] c3] |] eqn:at_q1; [| easy].
    destruct (FaceCoordinates q2) as [[[d1 d2] d3] |] eqn:at_q2; [| easy].
    intros H.
    apply (EC_5 _ _ _ _ _ _ _ _ _ _ _ a1 a2 a3 b1 b2 b3 c1 c2 c3 d1 d2 d3);
      try now apply FaceCoordinatesSound.
    take_apart; [apply SSNI3D_1 | apply SSNI3D_2 | apply SSNI3D_3];
      now apply SegmentsApartSound.
  Qed.

  Lemma CheckTwoEdgesSound p1 p2 q1 q2 :
    CheckTwoEdges p1 p2 q1 q2 = true -> compatible p1 p2 q1 q2.
  Proof.
    unfold CheckTwoEdges; intros H; take_apart.
    - apply EC_1; [apply (IsSpecialSound _ _ _ P) | apply (IsNotInSound _ _ _ P Q)];
        assumption.
    - apply EC_2; [apply (IsSpecialSound _ _ _ P) | apply (IsNotInSound _ _ _ P Q)];
        assumption.
    - apply EC_3; [apply (IsSpecialSound _ _ _ Q) | apply (IsNotInSound _ _ _ Q P)];
        assumption.
    - apply EC_4; [apply (IsSpecialSound _ _ _ Q) | apply (IsNotInSound _ _ _ Q P)];
        assumption.
    - now apply AreApartInFaceSound.
  Qed.

  Lemma EdgesMapTet (t : UnstructuredTet Symbol) :
    Edges Vertex (MapTet interpret t)
    = map (fun '(s, r) => (interpret s, interpret r)) (Edges Symbol t).
  Proof. now destruct t. Qed.

  Lemma CheckTwoTetsSound (t1 t2 : UnstructuredTet Symbol) :
    CheckTwoTets t1 t2 = true ->
    Forall (EdgePairCompatible Vertex GetIntersection f1 f2 f3 p q)
      (list_prod (Edges Vertex (MapTet interpret t1))
                 (Edges Vertex (MapTet interpret t2))).
  Proof.
    unfold CheckTwoTets; rewrite forallb_forall; intros check.
    apply Forall_forall; intros [e1 e2] inside.
    rewrite !EdgesMapTet in inside.
    apply in_prod_iff in inside as [in1 in2].
    apply in_map_iff in in1 as ([p1 p2] & <- & in1).
    apply in_map_iff in in2 as ([q1 q2] & <- & in2).
    apply CheckTwoEdgesSound.
    exact (check ((p1, p2), (q1, q2)) (in_prod _ _ _ _ in1 in2)).
  Qed.

  Variables (T : StencilSet) (natural : Natural T).
  Variable GetSign : Vertex -> Sign.

  Let locate := Locate Vertex f1 f2 f3 p q.

  Lemma CheckArrangementSound a b c d a' b' c' d' :
    CheckArrangement T (Arrange a b c d a' b' c' d') = true ->
    AllStencilEdgesCompatible T Vertex GetSign GetIntersection f1 f2 f3 p q
      (locate a) (locate b) (locate c) (locate d)
      (locate a') (locate b') (locate c') (locate d').
  Proof.
    intros check t1 t2 in1 in2.
    apply ForAllSignAssignmentsSound with
      (s1 := GetSign f1) (s2 := GetSign f2) (s3 := GetSign f3)
      (sp := GetSign p) (sq := GetSign q) in check.
    unfold locate in in1, in2.
    rewrite (InterpretTets T natural) in in1, in2.
    apply in_map_iff in in1 as (s1 & <- & in1).
    apply in_map_iff in in2 as (s2 & <- & in2).
    apply CheckTwoTetsSound.
    rewrite forallb_forall in check; specialize (check s1 in1).
    rewrite forallb_forall in check; exact (check s2 in2).
  Qed.
End Sound.

Theorem CheckCompatibilitySound (T : StencilSet) :
  Natural T -> CheckCompatibility T = true -> CompatibleStencils T.
Proof.
  intros natural check Vertex GetSign GetIntersection f1 f2 f3 p q.
  unfold CheckCompatibility in check; rewrite forallb_forall in check.
  pose proof (fun a b c d a' b' c' d' inside =>
    CheckArrangementSound Vertex GetIntersection f1 f2 f3 p q T natural GetSign
      a b c d a' b' c' d' (check (Arrange a b c d a' b' c' d') inside)) as sound.
  repeat split.
  - apply (sound P F1 F2 F3 Q F1 F2 F3); cbn; tauto.
  - apply (sound P F1 F2 F3 F1 Q F3 F2); cbn; tauto.
  - apply (sound F1 P F2 F3 Q F1 F3 F2); cbn; tauto.
  - apply (sound F1 P F2 F3 F1 Q F2 F3); cbn; tauto.
  - apply (sound F1 F2 P F3 F1 F2 Q F3); cbn; tauto.
  - apply (sound F1 F2 F3 P F1 F2 F3 Q); cbn; tauto.
Qed.
