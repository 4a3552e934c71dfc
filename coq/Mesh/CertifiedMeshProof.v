(** * Every mesh of the product is certified: proof *)

From Coq Require Import ZArith Reals List Lra.
From Certet Require Import Lattice.Coord3 Lattice.StructuredTet.
From Certet Require Import Stencil.UnstructuredTet Stencil.StencilSet.
From Certet Require Import Warp.Cut Warp.Warp.
From Certet Require Import Stuffing.Stuffing Stuffing.Domain.
From Certet Require Import Angles.Geometry Angles.AnglesSpec Angles.DegreesSpec.
From Certet Require Import Angles.AngleTheorems Angles.DomainProof.
From Certet Require Import Angles.Degrees.DegreesProof.
From Certet Require Import Angles.Degrees.DomainDegreesProof.
From Certet Require Import Range.RangeSpec Range.RangeProof.
From Certet Require Import Mesh.Method Mesh.CertifiedSpec.
From Certet Require Import Mesh.PlacedMeshProof.
Open Scope Z_scope.

Local Strategy 1000 [WarpVertex Bisect].

(** [StuffTet] makes the mesh of the placement that [Warp] leaves. *)
Lemma StuffedIsPlaced th sign cut :
  StuffedMesh th sign cut = PlacedMesh sign (WarpVertex th sign cut) cut.
Proof. reflexivity. Qed.

Lemma NoWarpThresholdsAtMostHalf : AtMostHalf NoWarpThresholds.
Proof. intros []; vm_compute; discriminate. Qed.

Lemma StuffedCertified th sign cut (least greatest : Z) :
  let mesh := StuffedMesh th sign cut in
  AtMostHalf th -> CutsOnEdges sign cut ->
  (forall tid t, In t (StuffedTets th sign cut tid) ->
     WithinDegrees (IZR least / 100) (IZR greatest / 100) t) ->
  th = AngleThresholds \/ th = EmbeddingThresholds \/ th = NoWarpThresholds ->
  TetsPositive mesh /\
  AnglesBetween mesh least greatest /\
  FacesConform mesh /\
  BoundaryIsSurface mesh /\
  NothingOverflows mesh th.
Proof.
  intros mesh half on within. unfold mesh. rewrite StuffedIsPlaced.
  apply PlacedCertified; [exact within|].
  intros tid. apply StuffedModerate; assumption.
Qed.

Theorem CertifiedMesh :
  forall (method : Method) (sign : SignField) (domain : PositionSigns),
    let mesh := MeshOf method sign domain in
    TetsPositive mesh /\
    AnglesBetween mesh (LeastAngle method) (GreatestAngle method) /\
    FacesConform mesh /\
    BoundaryIsSurface mesh /\
    NothingOverflows mesh (MethodThresholds method).
Proof.
  intros [] sign domain.
  - apply StuffedCertified; [apply AngleThresholdsAtMostHalf | apply BisectedOnEdges
      | apply BisectedBoundsInDegrees | tauto].
  - apply StuffedCertified; [apply EmbeddingThresholdsAtMostHalf | apply BisectedOnEdges
      | apply BisectedBoundsEmbeddingInDegrees | tauto].
  - apply StuffedCertified; [apply NoWarpThresholdsAtMostHalf | apply MidpointOnEdges
      | | tauto].
    intros tid t I. cbn [LeastAngle GreatestAngle].
    replace (IZR 3000 / 100)%R with 30%R by lra.
    replace (IZR 13500 / 100)%R with 135%R by lra.
    exact (MidpointBoundsInDegrees sign tid t I).
Qed.
