(** * Machine integers suffice

    The production library computes positions in 32 bits and volumes in 64.
    Lattice coordinates of at most [LatticeLimit] keep every intermediate of a
    position within 32 signed bits; differences of at most four lattice units,
    which is more than any two vertices of one output tetrahedron are apart
    along an axis, keep every intermediate of its volume within 64. *)

From Coq Require Import ZArith Lia.
From Certet Require Import Lattice.Coord3 Lattice.Direction Warp.Cut Warp.Warp.
From Certet Require Import Angles.Geometry.
Open Scope Z_scope.

Definition LatticeLimit : Z := 32000.

(** Every coordinate is at most [limit] in absolute value. *)
Definition Bounded (limit : Z) (v : Coord3) : Prop :=
  match v with C3 x y z => Z.abs x <= limit /\ Z.abs y <= limit /\ Z.abs z <= limit end.

(** A signed 32-bit and a signed 64-bit integer, short of the least one. *)
Definition Int32Limit : Z := 2 ^ 31 - 1.
Definition Int64Limit : Z := 2 ^ 63 - 1.

Lemma ProductBound x y m n : Z.abs x <= m -> Z.abs y <= n -> Z.abs (x * y) <= m * n.
Proof. intros. rewrite Z.abs_mul. apply Z.mul_le_mono_nonneg; lia. Qed.

Lemma SumBound x y m n : Z.abs x <= m -> Z.abs y <= n -> Z.abs (x + y) <= m + n.
Proof. lia. Qed.

Lemma DifferenceBound x y m n :
  Z.abs x <= m -> Z.abs y <= n -> Z.abs (x - y) <= m + n.
Proof. lia. Qed.

Lemma CoordinateFits x e t :
  Z.abs x <= LatticeLimit -> Z.abs e <= 2 -> 0 <= t <= Steps ->
  Z.abs (Steps * x) <= Int32Limit /\ Z.abs (t * e) <= Int32Limit /\
  Z.abs (Steps * x + t * e) <= Int32Limit.
Proof.
  change Steps with 65536. change LatticeLimit with 32000.
  change Int32Limit with 2147483647. intros X E T.
  pose proof (ProductBound t e 65536 2 ltac:(lia) E). lia.
Qed.

(** Every intermediate of a warped position. *)
Theorem WarpedPositionFits v d t :
  Bounded LatticeLimit v -> 0 <= t <= Steps ->
  Bounded Int32Limit (Scale Steps v) /\
  Bounded Int32Limit (Scale t (Offset d)) /\
  Bounded Int32Limit (WarpedPosition v (Moves d t)).
Proof.
  intros B T.
  assert (E : Bounded 2 (Offset d)) by (destruct d; cbn; lia).
  unfold WarpedPosition. destruct v as [x y z], (Offset d) as [e1 e2 e3].
  destruct B as (X & Y & U), E as (E1 & E2 & E3).
  destruct (CoordinateFits x e1 t X E1 T) as (? & ? & ?).
  destruct (CoordinateFits y e2 t Y E2 T) as (? & ? & ?).
  destruct (CoordinateFits z e3 t U E3 T) as (? & ? & ?).
  cbn [Translate Scale Bounded]. auto 10.
Qed.

(** Every intermediate of a cut's position. *)
Theorem PointOnEdgeFits v d t :
  Bounded LatticeLimit v -> 0 <= t <= Steps ->
  Bounded Int32Limit (Difference v (Translate v (Offset d))) /\
  Bounded Int32Limit (Scale t (Difference v (Translate v (Offset d)))) /\
  Bounded Int32Limit (PointOnEdge v (Translate v (Offset d)) t).
Proof.
  intros B T.
  replace (Difference v (Translate v (Offset d))) with (Offset d)
    by (destruct v, (Offset d); cbn [Difference Translate]; f_equal; ring).
  destruct (WarpedPositionFits v d t B T) as (_ & F1 & F2).
  split; [|split; [exact F1|]].
  - assert (E : Bounded 2 (Offset d)) by (destruct d; cbn; lia).
    destruct (Offset d) as [e1 e2 e3]. cbn [Bounded] in *.
    change Int32Limit with 2147483647. lia.
  - unfold PointOnEdge.
    replace (Difference v (Translate v (Offset d))) with (Offset d)
      by (destruct v, (Offset d); cbn [Difference Translate]; f_equal; ring).
    exact F2.
Qed.

(** Every intermediate of six times a volume, from differences of positions. *)
Theorem SixVolumeFits u v w :
  Bounded (4 * Steps) u -> Bounded (4 * Steps) v -> Bounded (4 * Steps) w ->
  match u, v, w, Cross u v with
    C3 u1 u2 u3, C3 v1 v2 v3, C3 w1 w2 w3, C3 n1 n2 n3 =>
      Bounded Int64Limit (C3 (u2 * v3) (u3 * v1) (u1 * v2)) /\
      Bounded Int64Limit (C3 (u3 * v2) (u1 * v3) (u2 * v1)) /\
      Bounded Int64Limit (C3 n1 n2 n3) /\
      Bounded Int64Limit (C3 (n1 * w1) (n2 * w2) (n3 * w3)) /\
      Z.abs (n1 * w1 + n2 * w2) <= Int64Limit /\
      Z.abs (n1 * w1 + n2 * w2 + n3 * w3) <= Int64Limit
  end.
Proof.
  change (4 * Steps) with 262144.
  destruct u as [u1 u2 u3], v as [v1 v2 v3], w as [w1 w2 w3].
  cbn [Bounded Cross]. intros (U1 & U2 & U3) (V1 & V2 & V3) (W1 & W2 & W3).
  change Int64Limit with 9223372036854775807.
  pose proof (ProductBound u2 v3 _ _ U2 V3). pose proof (ProductBound u3 v2 _ _ U3 V2).
  pose proof (ProductBound u3 v1 _ _ U3 V1). pose proof (ProductBound u1 v3 _ _ U1 V3).
  pose proof (ProductBound u1 v2 _ _ U1 V2). pose proof (ProductBound u2 v1 _ _ U2 V1).
  assert (N1 : Z.abs (u2 * v3 - u3 * v2) <= 137438953472)
    by (apply (DifferenceBound _ _ 68719476736 68719476736); assumption).
  assert (N2 : Z.abs (u3 * v1 - u1 * v3) <= 137438953472)
    by (apply (DifferenceBound _ _ 68719476736 68719476736); assumption).
  assert (N3 : Z.abs (u1 * v2 - u2 * v1) <= 137438953472)
    by (apply (DifferenceBound _ _ 68719476736 68719476736); assumption).
  pose proof (ProductBound _ w1 _ _ N1 W1) as P1.
  pose proof (ProductBound _ w2 _ _ N2 W2) as P2.
  pose proof (ProductBound _ w3 _ _ N3 W3) as P3.
  pose proof (SumBound _ _ _ _ P1 P2) as P12.
  pose proof (SumBound _ _ _ _ P12 P3) as P123.
  repeat split;
    match goal with H : Z.abs ?e <= _ |- Z.abs ?e <= _ =>
      apply (Z.le_trans _ _ _ H); vm_compute; discriminate
    end.
Qed.
