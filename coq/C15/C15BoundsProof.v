(** * The angle bounds of C15 with diagonals by key: proof over the integers *)

From Certet Require Import Key.Definitions.
From Certet Require Import Angles.Forms.CheckerProof Angles.Cases.Configurations
  Angles.AngleTheorems.
From Certet Require Import C15.Sites C15.C15Tet C15.C15Stuffing C15.C15AnglesSpec C15.C15WarpSpec
  C15.C15Configurations C15.C15FramesProof C15.C15ReductionProof C15.C15WarpProof
  C15.C15LatticeProof
  C15.Jobs.TwoMagnesiumCuts C15.Jobs.TwoMagnesiumFew C15.Jobs.TwoMagnesiumMany
  C15.Jobs.OneMagnesium C15.Jobs.NoMagnesium.
Open Scope Z_scope.

Lemma StandardChecked case n : In case [Tet_A01; Tet_B1; Tet_C1] -> exists take,
  CheckC15Case case C15KeyAngles C15KeyThresholds take = true /\
  (0 <= n -> take n = true).
Proof.
  intros [<-|[<-|[<-|[]]]].
  - destruct (Z.ltb_spec n 1) as [L|L]; [|destruct (Z.leb_spec n 2) as [L'|L']].
    + exists (fun n => n =? 0). split; [exact TwoMagnesiumCuts|].
      intros P. apply Z.eqb_eq. lia.
    + exists (fun n => (1 <=? n) && (n <=? 2))%bool. split; [exact TwoMagnesiumFew|].
      intros _. apply andb_true_intro. split; apply Z.leb_le; lia.
    + exists (fun n => 3 <=? n). split; [exact TwoMagnesiumMany|].
      intros _. apply Z.leb_le. lia.
  - exists (fun _ => true). split; [exact OneMagnesium|reflexivity].
  - exists (fun _ => true). split; [exact NoMagnesium|reflexivity].
Qed.

Lemma SurfaceCornersNonNegative signs : 0 <= SurfaceCorners signs.
Proof. destruct signs as [[] [] [] []]; cbn; lia. Qed.

Theorem C15DihedralBounds : C15Guarantees C15KeyThresholds C15KeyAngles.
Proof.
  intros [cell case] before warping cut [M C] t I.
  assert (B : Sensible C15KeyAngles) by (cbn; lia).
  destruct (StandardChecked (StandardOf case)
    (SurfaceCorners (LatticeSigns before warping cell case)) (StandardCases case))
    as (take & checked & taken).
  exact (C15PlacementWithin before warping cut _ _ B ThresholdsNonNegative cell case M C
           take checked (taken (SurfaceCornersNonNegative _)) t I).
Qed.

(** Of every tetrahedron, at these thresholds: of admissible placements, *)
Definition EachC15Tet (holds : UnstructuredTet Coord3 -> Prop) : Prop :=
  forall tid before warping cut t,
    C15Admissible before warping cut C15KeyThresholds (C15Corners tid) ->
    In t (C15Tets before warping cut tid) -> holds t.

(** and after warping. *)
Definition EachWarpedC15Tet (holds : UnstructuredTet Coord3 -> Prop) : Prop :=
  forall sign cut tid t, CutsOnEdges sign cut ->
    In t (C15StuffedTets C15KeyThresholds sign cut tid) -> holds t.

Lemma AfterWarping holds : EachC15Tet holds -> EachWarpedC15Tet holds.
Proof.
  intros each sign cut tid t C. apply each.
  exact (C15WarpIsAdmissible C15KeyThresholds sign cut C15KeyAtMostHalf C tid).
Qed.

Theorem C15PositiveVolume : EachC15Tet Positive.
Proof.
  intros tid before warping cut t A I.
  exact (WellShapedPositive _ _ (C15DihedralBounds tid _ _ _ A t I)).
Qed.
