(** * Faces of graded tetrahedra as flags see them: proofs *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling Mesh.Method.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet
  Grading.Surface Grading.GradingSpec.
From Certet Require Import Grading.FlagProof Grading.BalanceProof
  Grading.PartitionProof Grading.GradedVolumeProof.
Open Scope Z_scope.

(** Whether the flag's side across from one of its points is on a face of its
    tetrahedron, *)
Definition IsOuter (kind : GradedKind) (x : Flag) (w : Place) : bool :=
  match kind, w with
  | (EdgeHalfTet | QuarterTet), First => true
  | _, First => false
  | PyramidTet, Second => negb (IsOffDiagonal x)
  | _, Second | _, Third => true
  | (FaceHalfTet | QuarterTet | PyramidTet), Fourth => true
  | _, Fourth => false
  end.

(** and the vertices of that face. *)
Definition FaceSeen (kind : GradedKind) (x : Flag) (w : Place) : list Coord3 :=
  let p := PointSeen x in
  match w, kind with
  | First, QuarterTet => [p 1 1 0; p 1 0 0; p 0 0 0]
  | First, _ => [p 1 1 0; p 2 0 0; p 0 0 0]
  | Second, (BccTet | EdgeHalfTet) => [p 1 1 1; p 0 0 0; p 2 0 0]
  | Second, (FaceHalfTet | QuarterTet) => [p 1 1 1; p 1 0 0; p 0 0 0]
  | Second, PyramidTet => [p 1 1 1; p 1 (-1) (-1); p 0 0 0]
  | Third, (EdgeHalfTet | QuarterTet) => [p 1 1 1; p 1 1 0; p 0 0 0]
  | Third, _ => [p 1 1 1; p 1 1 (-1); p 0 0 0]
  | Fourth, QuarterTet => [p 1 1 1; p 1 1 0; p 1 0 0]
  | Fourth, PyramidTet =>
      if IsOffDiagonal x then [p 1 1 1; p 1 1 (-1); p 1 (-1) 1]
      else [p 1 1 1; p 1 1 (-1); p 1 (-1) (-1)]
  | Fourth, _ => [p 1 1 1; p 1 1 (-1); p 1 0 0]
  end.

Lemma SameRefl l : SameVertices l l.
Proof. intros v. reflexivity. Qed.
Lemma SameSym l m : SameVertices l m -> SameVertices m l.
Proof. intros H v. symmetry. apply H. Qed.
Lemma SameTrans l m n : SameVertices l m -> SameVertices m n -> SameVertices l n.
Proof. intros H K v. rewrite (H v). apply K. Qed.

Ltac shared :=
  repeat (progress rewrite ?SeenByCorner, ?SeenByEdge, ?SeenByFace, ?SeenByCell);
  cbn [Z.opp Z.sub Z.add Z.pos_sub Pos.pred_double];
  intros v; cbn [In]; tauto.

(** The vertex across from it. *)
Definition ApexSeen (kind : GradedKind) (x : Flag) (w : Place) : Coord3 :=
  let p := PointSeen x in
  match w, kind with
  | First, _ => p 1 1 1
  | Second, (EdgeHalfTet | QuarterTet) => p 1 1 0
  | Second, _ => p 1 1 (-1)
  | Third, (BccTet | EdgeHalfTet) => p 2 0 0
  | Third, (FaceHalfTet | QuarterTet) => p 1 0 0
  | Third, PyramidTet => if IsOffDiagonal x then p 1 (-1) 1 else p 1 (-1) (-1)
  | Fourth, _ => p 0 0 0
  end.

Lemma BetweenSwap face a b : LiesBetween face a b -> LiesBetween face b a.
Proof. intros H p q r I J K D E F. rewrite Z.mul_comm. now apply H. Qed.

Lemma BetweenSame face face' a b : SameVertices face face' ->
  LiesBetween face a b -> LiesBetween face' a b.
Proof. intros S H p q r I J K. apply H; now apply S. Qed.

(** In whatever order three points are taken, the volumes have the same signs, or
    both the other. *)
Lemma TurnVolume a b c d : SixVolume b c a d = SixVolume a b c d.
Proof.
  destruct a, b, c, d. unfold SixVolume, Normal. cbn [Difference Cross Dot]. ring.
Qed.

Lemma SwapVolume a b c d : SixVolume b a c d = - SixVolume a b c d.
Proof.
  destruct a, b, c, d. unfold SixVolume, Normal. cbn [Difference Cross Dot]. ring.
Qed.

Lemma Between a b c d e : SixVolume a b c d * SixVolume a b c e < 0 ->
  LiesBetween [a; b; c] d e.
Proof.
  intros H.
  assert (T : forall p q r, SixVolume p q r d * SixVolume p q r e < 0 ->
    SixVolume q r p d * SixVolume q r p e < 0) by (intros p q r V; now rewrite (TurnVolume p q r d), (TurnVolume p q r e)).
  assert (S : forall p q r, SixVolume p q r d * SixVolume p q r e < 0 ->
    SixVolume q p r d * SixVolume q p r e < 0).
  { intros p q r V. rewrite (SwapVolume p q r d), (SwapVolume p q r e). lia. }
  intros p q r [<- | [<- | [<- | []]]] [<- | [<- | [<- | []]]] [<- | [<- | [<- | []]]] ? ? ?;
    try match goal with D : ?v <> ?v |- _ => now destruct D end.
  - exact H.
  - exact (T b a c (S a b c H)).
  - exact (S a b c H).
  - exact (T a b c H).
  - exact (T b c a (T a b c H)).
  - exact (T a c b (T b a c (S a b c H))).
Qed.

Ltac sides :=
  repeat (progress rewrite ?SeenByCorner, ?SeenByEdge, ?SeenByFace, ?SeenByCell);
  cbn [Z.opp Z.sub Z.add Z.pos_sub Pos.pred_double];
  apply Between, ApartSeen; vm_compute; reflexivity.

Ltac meets :=
  lazymatch goal with
  | |- LiesBetween _ _ _ => sides
  | |- SameVertices _ _ => shared
  end.

Ltac apex :=
  repeat (progress rewrite ?SeenByCorner, ?SeenByEdge, ?SeenByFace, ?SeenByCell);
  reflexivity.

(** Every face is seen by a flag. *)
Lemma FlagSeesFace cells kind x i : InGradedMesh cells (GTId kind x) ->
  let '(z, w) := FlagAtFace (GTId kind x) i in
  In z (FlagsOf (GTId kind x)) /\ IsOuter kind z w = true /\
  SameVertices (GradedFace (GTId kind x) i) (FaceSeen kind z w) /\
  GradedVertexAt (GTId kind x) i = ApexSeen kind z w.
Proof.
  intros M. destruct (NamedBy _ _ _ M) as (_ & _ & N).
  assert (off : kind = PyramidTet -> IsOffDiagonal x = true).
  { intros ->. exact (NameOffDiagonal x N). }
  unfold GradedFace, GradedVertexAt.
  destruct kind, i; cbn [FlagAtFace FlagsOf IsOuter FaceSeen ApexSeen Others
    GradedVertices];
    rewrite ?OffDiagonalByCorner, ?OffDiagonalByEdge, ?off by reflexivity; cbn [negb];
    try (destruct (IsUpperEdge x)); cbn [Pick];
    (split; [cbn [In]; tauto | split; [reflexivity | split; [shared | apex]]]).
Qed.
