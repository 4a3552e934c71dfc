(** However far the four corners of a tetrahedron of C15 are warped, along whatever
    edges, it is not turned over. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Cases.Configurations.
From Certet Require Import C15.Sites C15.C15Tet C15.C15Stuffing C15.C15Configurations.
Open Scope Z_scope.

(** Where a corner starts, and where it may go farthest, in 256ths. *)
Definition Reaches (case : C15Case) (th : C15Thresholds) (l : Label) : list Coord3 :=
  let p := Of (CaseCorners case) l in
  Scale 256 p ::
  map (fun o => Along p o (th (MetalOf p) (MetalOf (Translate p o)))) (OffsetsAround p).

Definition C15NeverTurnedOver (case : C15Case) (th : C15Thresholds) : bool :=
  let as_ := Reaches case th V1 in let bs := Reaches case th V2 in
  let cs := Reaches case th V3 in let ds := Reaches case th V4 in
  forallb (fun a => forallb (fun b => forallb (fun c =>
    let n := Normal a b c in
    forallb (fun d => 0 <? Dot n (Difference a d)) ds) cs) bs) as_.

Lemma C15LatticeKeepsVolume :
  forallb (fun case => C15NeverTurnedOver case C15KeyThresholds)
    [Tet_A01; Tet_B1; Tet_C1] = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
