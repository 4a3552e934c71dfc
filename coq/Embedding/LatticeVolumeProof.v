(** * Who keeps the short edges turns no tetrahedron over

    The four short edges of a placed structured tetrahedron lead around it, one
    along each diagonal of a cube; the volume is the determinant of three of
    them, and their sum is the fourth one's opposite. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Embedding.StarProof.
Open Scope Z_scope.

Lemma DeterminantPositive a1 b1 c1 a2 b2 c2 a3 b3 c3 :
  0 < a1 -> 0 < b1 -> 0 < c1 -> 0 < a2 -> 0 < b2 -> 0 < c2 ->
  0 < a3 -> 0 < b3 -> 0 < c3 ->
  a3 < a1 + a2 -> b2 < b1 + b3 -> c1 < c2 + c3 ->
  0 < a1 * (b2 * c3 + c2 * b3) + b1 * (a2 * c3 + c2 * a3)
      + c1 * (a2 * b3 - b2 * a3).
Proof.
  intros A1 B1 C1 A2 B2 C2 A3 B3 C3 A B C.
  assert (P : forall x y, 0 < x -> 0 < y -> 0 < x * y) by exact Z.mul_pos_pos.
  destruct (Z.le_gt_cases 0 (a2 * b3 - b2 * a3)) as [H|H].
  - pose proof (P a1 _ A1 (P b2 c3 B2 C3)). pose proof (P a1 _ A1 (P c2 b3 C2 B3)).
    pose proof (P b1 _ B1 (P a2 c3 A2 C3)). pose proof (P b1 _ B1 (P c2 a3 C2 A3)).
    pose proof (Z.mul_nonneg_nonneg c1 _ (Z.lt_le_incl _ _ C1) H). lia.
  - assert (N : 0 < (c2 + c3 - c1) * (b2 * a3 - a2 * b3)) by (apply P; lia).
    assert (S : 0 < c3 * (b2 * (a1 + a2 - a3) + a2 * (b1 + b3 - b2)))
      by (apply P; [exact C3|apply Z.add_pos_pos; apply P; lia]).
    assert (T : 0 < c2 * (a3 * (b1 + b3 - b2) + b3 * (a1 + a2 - a3)))
      by (apply P; [exact C2|apply Z.add_pos_pos; apply P; lia]).
    lia.
Qed.

(** Four vectors along the diagonals that lead around. *)
Lemma DiagonalsTurnRight P Q R S :
  SameOctant (C3 1 1 1) P -> SameOctant (C3 1 (-1) (-1)) Q ->
  SameOctant (C3 (-1) 1 (-1)) R -> SameOctant (C3 (-1) (-1) 1) S ->
  Translate (Translate P Q) (Translate R S) = C3 0 0 0 ->
  0 < Dot (Cross P Q) R.
Proof.
  destruct P as [a1 b1 c1], Q as [a2 b2 c2], R as [a3 b3 c3], S as [a4 b4 c4].
  cbn [SameOctant Translate]. intros HP HQ HR HS E.
  assert (Ea : a1 + a2 + (a3 + a4) = 0) by (injection E; auto).
  assert (Eb : b1 + b2 + (b3 + b4) = 0) by (injection E; auto).
  assert (Ec : c1 + c2 + (c3 + c4) = 0) by (injection E; auto).
  pose proof (DeterminantPositive a1 b1 c1 a2 (- b2) (- c2) (- a3) b3 (- c3)) as D.
  cbn [Cross Dot].
  replace ((b1 * c2 - c1 * b2) * a3 + (c1 * a2 - a1 * c2) * b3
    + (a1 * b2 - b1 * a2) * c3)
    with (a1 * (- b2 * - c3 + - c2 * b3) + b1 * (a2 * - c3 + - c2 * - a3)
      + c1 * (a2 * b3 - - b2 * - a3)) by ring.
  apply D; lia.
Qed.

Section Kept.
  Variable place : Coord3 -> Coord3.
  Hypothesis Keeps : KeepsShortEdges place.

  Lemma Step anchor d u v : DirectionKind d = Short -> Translate u (Offset d) = v ->
    SameOctant (Offset d)
      (Difference (place (Translate anchor u)) (place (Translate anchor v))).
  Proof. intros K <-. rewrite <- TranslateTwice. apply Keeps, K. Qed.

  (** The diagonals lead from [p] to [q], and so on, around. *)
  Ltac around p p' q q' r r' s s' :=
    match goal with |- context [Translate ?anchor _] =>
      pose proof (DiagonalsTurnRight _ _ _ _
        (Step anchor Dir_ppp p p' eq_refl eq_refl)
        (Step anchor Dir_pmm q q' eq_refl eq_refl)
        (Step anchor Dir_mpm r r' eq_refl eq_refl)
        (Step anchor Dir_mmp s s' eq_refl eq_refl))
    end;
    repeat match goal with |- context [place ?v] =>
      let x := fresh "x" in set (x := place v) in *; clearbody x end;
    repeat match goal with x : Coord3 |- _ => destruct x end;
    unfold SixVolume, Normal; cbn [Difference Translate Cross Dot] in *;
    match goal with D : _ -> 0 < ?d |- 0 < ?g =>
      replace g with d by ring; apply D; f_equal; ring end.

  Lemma HandKept tid : KeepsHand place tid.
  Proof.
    destruct tid as [anchor []]; cbn [KeepsHand LatticeTet GetStructuredTet CaseHandedness].
    - around (C3 0 2 2) (C3 1 3 3) (C3 1 3 3) (C3 2 2 2)
             (C3 2 2 2) (C3 1 3 1) (C3 1 3 1) (C3 0 2 2).
    - around (C3 1 1 1) (C3 2 2 2) (C3 0 2 2) (C3 1 1 1)
             (C3 2 2 2) (C3 1 3 1) (C3 1 3 1) (C3 0 2 2).
    - around (C3 0 2 2) (C3 1 3 3) (C3 1 3 3) (C3 2 2 2)
             (C3 1 1 3) (C3 0 2 2) (C3 2 2 2) (C3 1 1 3).
    - around (C3 1 1 1) (C3 2 2 2) (C3 0 2 2) (C3 1 1 1)
             (C3 1 1 3) (C3 0 2 2) (C3 2 2 2) (C3 1 1 3).
    - around (C3 2 0 2) (C3 3 1 3) (C3 2 2 2) (C3 3 1 1)
             (C3 3 1 3) (C3 2 2 2) (C3 3 1 1) (C3 2 0 2).
    - around (C3 1 1 1) (C3 2 2 2) (C3 2 2 2) (C3 3 1 1)
             (C3 2 0 2) (C3 1 1 1) (C3 3 1 1) (C3 2 0 2).
    - around (C3 2 0 2) (C3 3 1 3) (C3 1 1 3) (C3 2 0 2)
             (C3 3 1 3) (C3 2 2 2) (C3 2 2 2) (C3 1 1 3).
    - around (C3 1 1 1) (C3 2 2 2) (C3 1 1 3) (C3 2 0 2)
             (C3 2 0 2) (C3 1 1 1) (C3 2 2 2) (C3 1 1 3).
    - around (C3 2 2 0) (C3 3 3 1) (C3 2 2 2) (C3 3 1 1)
             (C3 3 1 1) (C3 2 2 0) (C3 3 3 1) (C3 2 2 2).
    - around (C3 1 1 1) (C3 2 2 2) (C3 2 2 2) (C3 3 1 1)
             (C3 3 1 1) (C3 2 2 0) (C3 2 2 0) (C3 1 1 1).
    - around (C3 2 2 0) (C3 3 3 1) (C3 1 3 1) (C3 2 2 0)
             (C3 2 2 2) (C3 1 3 1) (C3 3 3 1) (C3 2 2 2).
    - around (C3 1 1 1) (C3 2 2 2) (C3 1 3 1) (C3 2 2 0)
             (C3 2 2 2) (C3 1 3 1) (C3 2 2 0) (C3 1 1 1).
  Qed.
End Kept.

Theorem KeptVolume place tid : KeepsShortEdges place -> KeepsHand place tid.
Proof. intros K. exact (HandKept place K tid). Qed.
