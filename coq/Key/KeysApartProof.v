(** * Cuts that share an end never have the same key: proof *)

From Certet Require Import Key.Definitions.
From Certet Require Import Embedding.EdgeRank.
From Certet Require Lattice.FaceProof Angles.Cases.SymmetryProof.
Open Scope Z_scope.
Definition OtherRank (rank : Z) : Z :=
  match rank with 1 => 2 | 2 => 1 | _ => rank end.

Lemma EdgeRankMoved a u v :
  EdgeRank (Translate a u) (Translate a v)
  = if Z.even (match a with C3 x _ _ => x end) then EdgeRank u v
    else OtherRank (EdgeRank u v).
Proof.
  unfold EdgeRank. rewrite SymmetryProof.TranslatedDifference.
  destruct a as [x y z], (Difference u v) as [dx dy dz], u as [ux uy uz].
  cbn [Translate]. rewrite Z.even_add.
  destruct (Z.even dx), (Z.even x), (Z.even ux), (dx * dy * dz =? 1); reflexivity.
Qed.

Lemma RankAtCorner tid : exists turned : bool,
  forall k l, EdgeRank (VertexAt (GetStructuredTet tid) k) (VertexAt (GetStructuredTet tid) l)
  = (if turned then OtherRank else fun r => r) (PlaceRank k l).
Proof.
  destruct tid as [[x y z] case]. exists (negb (Z.even x)). intros k l.
  rewrite !FaceProof.VertexMoves, EdgeRankMoved.
  destruct (Z.even x), case, k, l; reflexivity.
Qed.

Lemma RanksApart tid : KeysApart EdgeRank (Corners tid).
Proof.
  intros a b m A B M. apply PlaceOf in A, B, M.
  destruct A as [i ->], B as [j ->], M as [k ->].
  destruct (RankAtCorner tid) as [turned ranks]. rewrite !ranks.
  destruct i, j, k; try congruence; destruct turned; cbn; intros; split; discriminate.
Qed.

Lemma RankInRange a b : 0 <= EdgeRank a b < 3.
Proof.
  unfold EdgeRank. destruct (Difference a b), a.
  destruct (Z.even _); [lia|]. destruct (Bool.eqb _ _); lia.
Qed.

Theorem CutKeysApart cut tid : KeysApart (CutKey cut) (Corners tid).
Proof.
  intros a b m A B M ab am bm.
  destruct (RanksApart tid a b m A B M ab am bm) as [to from]. unfold CutKey.
  pose proof (RankInRange a m). pose proof (RankInRange b m).
  pose proof (RankInRange m a). pose proof (RankInRange m b). lia.
Qed.

