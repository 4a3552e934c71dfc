(** * The bounds of diagonals by key are sharp within 0.03 degrees: proof *)

From Coq Require Import Reals Lra.
From Certet Require Import Key.Definitions.
From Certet Require Import Angles.DegreesSpec Angles.Degrees.DegreesProof
  Angles.Degrees.Witnesses Angles.Degrees.SharpnessProof Key.KeyBoundsProof.
Open Scope R_scope.

(** A + and a - end of a long edge, and the two corners that face it moved to cuts
    of short edges that lead away. *)
Definition KeySmallSigns : SignField :=
  SignTable [(C3 0 2 2, Plus); (C3 2 2 2, Plus); (C3 1 3 1, Plus); (C3 1 3 3, Minus);
             (C3 (-1) 3 3, Minus); (C3 3 3 3, Minus)].

Definition KeySmallTable : list (Coord3 * Coord3 * Z) :=
  [(C3 0 2 2, C3 (-1) 3 3, 24319%Z); (C3 2 2 2, C3 3 3 3, 24319%Z);
   (C3 1 3 1, C3 1 3 3, 16384%Z)].

Definition KeyLargeTable : list (Coord3 * Coord3 * Z) :=
  LargeAngleTable (C3 2 2 0) (C3 2 2 4) 16383 24319.

Lemma KeyExhibited sign cut test (P : R -> Prop) : CutsOnEdges sign cut ->
  (forall p q r s, (0 < SixVolume p q r s)%Z -> test (p, q, r, s) = true ->
     P (DihedralDegrees p q r s)) ->
  existsb (fun t => existsb test (DihedralEdges t))
    (KeyStuffedTets KeyThresholds sign cut WitnessTet) = true ->
  exists sign cut tid t p q r s, CutsOnEdges sign cut /\
    In t (KeyStuffedTets KeyThresholds sign cut tid) /\
    In (p, q, r, s) (DihedralEdges t) /\ P (DihedralDegrees p q r s).
Proof.
  intros C T E. apply SomeEdge in E. destruct E as (t & p & q & r & s & I & J & H).
  exists sign, cut, WitnessTet, t, p, q, r, s. repeat (split; [assumption|]).
  exact (T p q r s (EdgeVolume _ t _ _ _ _ (KeyBounds sign cut _ t C I) J) H).
Qed.

Theorem KeyBoundsAreSharp :
  (exists sign cut tid t p q r s, CutsOnEdges sign cut /\
     In t (KeyStuffedTets KeyThresholds sign cut tid) /\
     In (p, q, r, s) (DihedralEdges t) /\ DihedralDegrees p q r s <= 1119 / 100) /\
  (exists sign cut tid t p q r s, CutsOnEdges sign cut /\
     In t (KeyStuffedTets KeyThresholds sign cut tid) /\
     In (p, q, r, s) (DihedralEdges t) /\ 15710 / 100 <= DihedralDegrees p q r s).
Proof.
  split.
  - apply (KeyExhibited KeySmallSigns (CutTable KeySmallTable) (Sharper (CotSq 25560 1000))
      (fun x => x <= 1119 / 100)).
    + apply CutsOnEdgesTable. reflexivity.
    + intros p q r s. apply SharperDegrees. by_fraction (98099225 / 100000000).
    + vm_compute. reflexivity.
  - apply (KeyExhibited (LargeAngleSigns (C3 2 2 0) (C3 2 2 4)) (CutTable KeyLargeTable)
      (Blunter (CotSq 5607 1000)) (fun x => 15710 / 100 <= x)).
    + apply CutsOnEdgesTable. reflexivity.
    + intros p q r s V T. replace (15710 / 100) with (180 - 2290 / 100) by lra.
      revert V T. apply BlunterDegrees. by_fraction (92120757 / 100000000).
    + vm_compute. reflexivity.
Qed.
