(** * The warp that keeps the shape, of several materials: proofs *)

From Coq Require Import FMapPositive.
From Certet Require Import Material.Definitions.
From Certet Require Import Angles.AngleTheorems Embedding.GreedyProof
  Embedding.DiskTables Embedding.SettleProof Embedding.SettledMeshProof
  Material.MaterialShape Material.MaterialBoundsProof Material.MaterialWarpProof
  Material.SettleMaterials.
Open Scope Z_scope.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpMaterialVertex IsDisk IsWellShaped TetsAround].

Section Settle.
  Variables (bounds : AngleBounds) (th : Thresholds).
  Variables (material : Coord3 -> Material) (cut : CutField).
  Local Notation field := (fun v => Some (material v)).
  Hypothesis Half : AtMostHalf th.
  Hypothesis OnEdges : MaterialCutsOnEdges field cut.

  Local Notation target := (WarpMaterialVertex th field cut).
  Local Notation turn := (MaterialTurn th material cut).
  Local Notation one := (SettleOneMaterial bounds th material cut).
  Local Notation share := (MayShare bounds material cut).
  Local Notation side := (MaterialSide th material cut).
  Local Notation settled := (SettleMaterials bounds th material cut).

  (** Nothing changes, or one vertex is placed. *)
  Lemma OneMaterialMeans zeros v :
    one zeros v = zeros \/
    exists e t, target v = Moves e t /\
      let moved := PositiveMap.add (PointKey v)
        (Moves e (Shortened side LevelGap target turn zeros v e t)) zeros in
      one zeros v = moved /\ forallb (share moved) (TetsAround v) = true.
  Proof.
    unfold SettleOneMaterial. destruct (target v) as [|e t] eqn:W; [auto|].
    destruct (_ && _); [cbv zeta|auto].
    destruct (negb _); [cbn [andb]|auto].
    destruct (forallb _ _) eqn:S; [right|auto]. exists e, t. auto.
  Qed.

  (** ** How far *)

  (** Who moved was violated, and lies between where it was and its target. *)
  Definition TowardMaterialTargets (zeros : Zeros) : Prop :=
    forall v e t, PlaceIn zeros v = Moves e t ->
      exists t', target v = Moves e t' /\ 0 <= t <= t'.

  Lemma MaterialTargetInHalf v e t : target v = Moves e t -> 2 * t < Steps.
  Proof.
    intros W. apply MaterialWarpMeans in W. destruct W as (_ & _ & _ & _ & _ & _ & L).
    specialize (Half (DirectionKind e)). lia.
  Qed.

  Lemma SettledTowardMaterials vs : TowardMaterialTargets (settled vs).
  Proof.
    apply (FoldKeeps TowardMaterialTargets).
    - intros zeros v T. destruct (OneMaterialMeans zeros v) as [->|(e & t & W & -> & _)];
        [exact T|].
      intros u f s E. destruct (SamePoint3 u v) as [->|N].
      + rewrite PlacedHere in E. injection E as <- <-. exists t. split; [exact W|].
        destruct (MaterialWarpMeans th _ cut v e t W) as (m & n & M & N & D & C & _).
        pose proof (MaterialCutFromInRange _ cut OnEdges v e m n M N D) as R.
        rewrite <- C in R.
        split; [|apply ShortenedLess].
        apply ShortenedNotBack; [|exact MaterialTargetInHalf|exact LevelGapSmall|lia].
        intros w f s P. destruct (T _ _ _ P) as (s' & W' & L).
        apply MaterialTargetInHalf in W'. lia.
      + rewrite PlacedElsewhere in E by exact N. exact (T u f s E).
    - intros v e t E. rewrite NoneIn in E. discriminate E.
  Qed.

  (** It is one of the rules of [RuledMaterialWarping]. *)
  Theorem SettledMaterialsAreRuled vs : exists stays limit, forall v,
    RuledMaterialWarping th field cut stays limit v = PlaceIn (settled vs) v.
  Proof.
    exists (fun v => match PlaceIn (settled vs) v with Stays => true | _ => false end),
           (fun v => match PlaceIn (settled vs) v with Stays => 0 | Moves _ t => t end).
    intros v. unfold RuledMaterialWarping.
    destruct (PlaceIn (settled vs) v) as [|e t] eqn:E.
    - destruct (target v); reflexivity.
    - destruct (SettledTowardMaterials vs v e t E) as (s & -> & L). f_equal. lia.
  Qed.

  (** ** Tetrahedra with four corners that moved *)

  Lemma MayShareSame zeros zeros' tid :
    (forall v, In v (Corners tid) -> PlaceIn zeros v = PlaceIn zeros' v) ->
    share zeros tid = share zeros' tid.
  Proof.
    intros E. unfold MayShare, HaveMoved, SharedIn.
    rewrite (PlacedWholeSame (PlaceIn zeros) (PlaceIn zeros') cut cut tid E).
    assert (L : forall v, In v (Corners tid) ->
      LowerIn material zeros v = LowerIn material zeros' v)
      by (intros v I; unfold LowerIn; rewrite (E v I); reflexivity).
    rewrite (map_ext_in _ _ _ L).
    assert (F : forall f g : Coord3 -> bool, (forall v, In v (Corners tid) -> f v = g v) ->
      forallb f (Corners tid) = forallb g (Corners tid)).
    { intros f g. induction (Corners tid) as [|v vs IH]; intros H; [reflexivity|].
      cbn [forallb]. rewrite (H v) by (left; reflexivity). f_equal. apply IH.
      - intros u I. apply E. right. exact I.
      - intros u I. apply L. right. exact I.
      - intros u I. apply H. right. exact I. }
    rewrite (F _ (fun v => match PlaceIn zeros' v with Moves _ _ => true | Stays => false end))
      by (intros v I; rewrite (E v I); reflexivity).
    destruct (forallb _ _); [|reflexivity]. f_equal. apply F.
    intros v I. rewrite (L v I). reflexivity.
  Qed.

  (** Each was looked at when the last of its corners moved. *)
  Theorem SettledShare vs tid : InLattice tid -> share (settled vs) tid = true.
  Proof.
    intros Even. apply (FoldKeeps (fun zeros => share zeros tid = true)).
    - intros zeros v S. destruct (OneMaterialMeans zeros v) as [->|(e & t & _ & -> & A)];
        [exact S|].
      destruct (in_dec SamePoint3 v (Corners tid)) as [I|N].
      + rewrite forallb_forall in A. apply A, InTetsAround; assumption.
      + rewrite <- S. apply MayShareSame. intros u I. apply PlacedElsewhere.
        intros ->. exact (N I).
    - unfold MayShare, HaveMoved. destruct tid as [anchor case].
      unfold Corners. destruct (GetStructuredTet (STId anchor case)).
      cbn [forallb]. rewrite NoneIn. reflexivity.
  Qed.

  Lemma SettledWhole vs c tid : InLattice tid ->
    SharedIn material (settled vs) tid <> Outside ->
    InterfacesAlone field (PlaceIn (settled vs)) tid ->
    WellShaped bounds (PlacedWhole (PlaceIn (settled vs)) c tid).
  Proof.
    intros Even Inner Alone. pose proof (SettledShare vs tid Even) as S.
    unfold MayShare in S.
    assert (M : HaveMoved (settled vs) tid = true).
    { apply forallb_forall. intros v I. specialize (Alone v I).
      unfold PlacedMaterial in Alone. destruct (PlaceIn _ v); [discriminate Alone|reflexivity]. }
    rewrite M in S. apply andb_prop in S as [_ S].
    rewrite (proj2 (Z.eqb_neq _ _) Inner) in S.
    rewrite (PlacedWholeSame _ (PlaceIn (settled vs)) c cut tid) by reflexivity.
    apply IsWellShapedSound, S.
  Qed.
End Settle.

(** ** The angles *)

Lemma AdmissibleMaterialsSame before warping warping' cut th corners :
  (forall v, warping v = warping' v) ->
  AdmissibleMaterials before warping cut th corners ->
  AdmissibleMaterials before warping' cut th corners.
Proof.
  intros E [M C]. split.
  - intros v d t I W. rewrite <- E in W. destruct (M v d t I W) as [B N].
    split; [exact B|]. intros J e s W'. rewrite <- E in W'. exact (N J e s W').
  - intros v d m n I J P Q. unfold PlacedMaterial in P, Q. rewrite <- E in P, Q.
    exact (C v d m n I J P Q).
Qed.

(** Every tetrahedron of every material is such. *)
Definition EachSettledTet (holds : UnstructuredTet Coord3 -> Prop) : Prop :=
  forall material cut turns tid m t,
    MaterialCutsOnEdges (fun v => Some (material v)) cut -> InLattice tid ->
    m <> Outside ->
    In (m, t)
      (SettledMaterialTets AngleThresholds material cut
         (SettleMaterials WidestAngles AngleThresholds material cut turns) tid) ->
    holds t.

Theorem SettledMaterialBounds : EachSettledTet (WellShaped WidestAngles).
Proof.
  intros material cut turns tid m t C Even Inner I.
  set (zeros := SettleMaterials WidestAngles AngleThresholds material cut turns) in *.
  refine (MaterialDihedralBounds (fun v => Some (material v)) (PlaceIn zeros)
    (ClampedCut AngleThresholds cut) (SharedIn material zeros) tid _ _ m t I).
  - destruct (SettledMaterialsAreRuled WidestAngles AngleThresholds material cut
      AngleThresholdsAtMostHalf C turns) as (stays & limit & E).
    apply (AdmissibleMaterialsSame _ _ _ _ _ _ E).
    apply AnyMaterialSubsetStays; [exact AngleThresholdsAtMostHalf|exact C].
  - intros Alone. apply SettledWhole; [exact Even| |exact Alone].
    fold zeros. rewrite <- (AloneAreShared _ _ _ _ tid m t Alone I). exact Inner.
Qed.
