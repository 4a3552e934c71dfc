(** * The two tetrahedra at a face lie on its two sides: proof *)

From Certet Require Import Angles.Definitions.
Open Scope Z_scope.

Lemma VolumeMoves s a b c d :
  SixVolume (Translate s a) (Translate s b) (Translate s c) (Translate s d)
  = SixVolume a b c d.
Proof.
  assert (D : forall p q, Difference (Translate s p) (Translate s q) = Difference p q)
    by (intros p q; destruct s, p, q; cbn [Translate Difference]; f_equal; ring).
  unfold SixVolume, Normal. rewrite !D. reflexivity.
Qed.

Theorem FaceSides : forall tid i,
  let '(nei, order) := NeighborAcross (GetStructuredTet tid) i in
  match FaceOf tid i with
  | [a; b; c] =>
      SixVolume a b c (VertexAt (GetStructuredTet tid) i)
      * SixVolume a b c (LinedUpVertexAt order (GetStructuredTet nei) i) < 0
  | _ => False
  end.
Proof.
  assert (A : forall s p q, Translate (Translate s p) q = Translate s (Translate p q))
    by (intros s p q; destruct s, p, q; cbn [Translate]; f_equal; ring).
  intros [s case] i. unfold FaceOf.
  destruct case, i;
    cbv beta iota zeta delta [NeighborAcross FaceAcross VertexAt LinedUpVertexAt
      GetStructuredTet Order1234 Order2143];
    rewrite !A, !VolumeMoves; reflexivity.
Qed.
