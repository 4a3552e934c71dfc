(** Thresholds (64/256, 105/256): however far the four corners of a structured
    tetrahedron are warped, along whatever edges, it is not turned over. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Cases.Configurations.
Open Scope Z_scope.

(** Where a corner may go farthest, in 256ths, and where it starts. *)
Definition Places (th : Thresholds) (l : Label) : list Coord3 :=
  Scale 256 (Of Canonical l) ::
  map (fun d => Along (Of Canonical l) (Offset d) (Alpha th (DirectionKind d)))
    AllDirections.

Definition NeverTurnedOver (th : Thresholds) : bool :=
  forallb (fun a => forallb (fun b => forallb (fun c =>
    let n := Normal a b c in
    forallb (fun d => 0 <=? Dot n (Difference a d)) (Places th V4))
      (Places th V3)) (Places th V2)) (Places th V1).

Lemma LatticeKeepsVolume : NeverTurnedOver EmbeddingThresholds = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
