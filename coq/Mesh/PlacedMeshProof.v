(** * What is certified of any placement: proofs

    Whatever becomes of the lattice points, and wherever the cuts are: faces
    conform, the boundary is on the surface, and if nothing moves too far
    nothing overflows.  A method has its angles to prove, and no more. *)

From Coq Require Import Reals.
From Certet Require Import Embedding.Definitions.
From Certet Require Import Stuffing.MeshProof Angles.DegreesSpec
  Embedding.AroundProof Embedding.WholeProof Range.RangeSpec Range.RangeProof Mesh.Method
  Mesh.CertifiedSpec.
Open Scope Z_scope.

Local Strategy 1000 [WarpVertex].

Section Placed.
  Variables (before : SignField) (warping : Coord3 -> Warping) (cut : CutField).
  Local Notation mesh := (PlacedMesh before warping cut).

  Theorem PlacedFacesConform : FacesConform mesh.
  Proof.
    intros tid i a b c face here there in_a in_b in_c.
    subst here there. cbn [PlacedMesh TetsWithin SignIn].
    rewrite !(NamesAsStuffed before warping). split.
    - intros (f & inside & plus). apply FaceTriangulationsAgree; try assumption.
      exists f. rewrite <- (SignAsStuffed before warping). auto.
    - intros t u in_t in_u has_t has_u.
      exact (FaceTriangleOnce _ _ _ tid i t u a b c in_t in_u has_t has_u
               in_a in_b in_c).
  Qed.

  Theorem PlacedBoundary : BoundaryIsSurface mesh.
  Proof.
    intros tid t a b c. cbn [PlacedMesh TetsWithin SignIn].
    rewrite (NamesAsStuffed before warping), !(SignAsStuffed before warping).
    intros inside has.
    destruct (BoundaryOnSurface _ _ _ _ _ _ _ _ inside has)
      as [surface | (u & apart & has_u & there)]; [left; exact surface | right].
    exists u. split; [exact apart | split; [exact has_u|]].
    destruct there as [there | (i & there)]; [left; exact there | right].
    exists i. rewrite (NamesAsStuffed before warping). exact there.
  Qed.

  Hypothesis Sane : forall tid, Moderate before warping cut (Corners tid).

  (** Whatever is made of the corners of a structured tetrahedron and of the cuts
      between them, in any order of the diagonals. *)
  Definition MadeOfCorners (names : StructuredTetId -> list (UnstructuredTet MeshVertex))
    : Prop :=
    forall tid u m, In u (names tid) -> In m (TetCorners u) ->
      OfCorners before warping (Corners tid) m.

  Lemma VolumesOfCorners names signs anchor case t :
    MadeOfCorners names -> Bounded AnchorLimit anchor ->
    In t (PlacedWithin (MakeMesh names signs (PlacedPosition warping cut))
            (STId anchor case)) ->
    VolumeFits t.
  Proof.
    intros of_corners near I. unfold PlacedWithin in I. cbn [TetsWithin PositionIn] in I.
    apply in_map_iff in I. destruct I as (u & <- & I).
    set (tid := STId anchor case) in *.
    pose proof (fun m => of_corners tid u m I) as made.
    assert (limit : forall v, In v (Corners tid) -> Bounded LatticeLimit v)
      by (intros v; apply CornersInRange, near).
    assert (in_type : forall m, In m (TetCorners u) -> forall k,
      InType 32 (Along k (PlacedPosition warping cut m))).
    { intros m J k. apply (PlacedInType before warping cut (Corners tid) (Sane tid));
        [exact limit | exact (made m J)]. }
    assert (narrow : forall m n, In m (TetCorners u) -> In n (TetCorners u) ->
      Bounded WidthLimit (Difference (PlacedPosition warping cut m)
                                     (PlacedPosition warping cut n))).
    { intros m n M N k.
      pose proof (PlacedNarrow before warping cut 2 (Corners tid) (CornersNoWider tid)
        (Sane tid) m n (made m M) (made n N) k) as B.
      revert B. change ((2 + 2) * Steps) with 262144. change WidthLimit with 524288.
      lia. }
    destruct u as [a b c d]. cbn [MapTet VolumeFits TetCorners] in *.
    apply VolumesFit; try (apply narrow; cbn [In]; tauto).
    intros p J k. cbn [In] in J.
    repeat (destruct J as [<- | J]; [apply in_type; cbn [In]; tauto|]). destruct J.
  Qed.

  Theorem OfCornersNothingOverflows names signs th :
    MadeOfCorners names -> ComparisonsFit th ->
    NothingOverflows (MakeMesh names signs (PlacedPosition warping cut)) th.
  Proof.
    intros of_corners fit. split; [exact fit|].
    intros anchor case near. split.
    - intros v I. pose proof (CornersInRange anchor case v near I) as limit.
      split; [exact limit|]. intros d low half k L H T u.
      split; [apply WarpedFits; [exact limit | lia]|].
      split; [apply CutFits; [exact limit | lia]|].
      apply MiddleFits; assumption.
    - intros t. apply VolumesOfCorners; assumption.
  Qed.

  Theorem PlacedNothingOverflows th :
    th = AngleThresholds \/ th = EmbeddingThresholds \/ th = NoWarpThresholds ->
    NothingOverflows mesh th.
  Proof.
    intros known. apply OfCornersNothingOverflows.
    - intros tid u m I. exact (PlacedOfCorners _ _ tid u m I).
    - intros k t. exact (DecisionsFit th k t known).
  Qed.
End Placed.

(** ** Angles *)

Lemma DegreesPositive mesh least greatest :
  (forall tid t, In t (PlacedWithin mesh tid) -> WithinDegrees least greatest t) ->
  TetsPositive mesh.
Proof.
  intros within tid t I. pose proof (within tid t I) as W.
  destruct t as [a b c d]. exact (proj1 W).
Qed.

Lemma DegreesBetween mesh (least greatest : Z) :
  (forall tid t, In t (PlacedWithin mesh tid) ->
     WithinDegrees (IZR least / 100) (IZR greatest / 100) t) ->
  AnglesBetween mesh least greatest.
Proof.
  intros within tid t p q r s I J. pose proof (within tid t I) as W.
  destruct t as [a b c d]. exact (proj2 W p q r s J).
Qed.

(** ** Together *)

(** What [CertifiedMesh] says of a mesh. *)
Definition Certified (mesh : Mesh) (least greatest : Z) (th : Thresholds) : Prop :=
  TetsPositive mesh /\
  AnglesBetween mesh least greatest /\
  FacesConform mesh /\
  BoundaryIsSurface mesh /\
  NothingOverflows mesh th.

Theorem PlacedCertified before warping cut th (least greatest : Z) :
  let mesh := PlacedMesh before warping cut in
  (forall tid t, In t (PlacedWithin mesh tid) ->
     WithinDegrees (IZR least / 100) (IZR greatest / 100) t) ->
  (forall tid, Moderate before warping cut (Corners tid)) ->
  th = AngleThresholds \/ th = EmbeddingThresholds \/ th = NoWarpThresholds ->
  Certified mesh least greatest th.
Proof.
  intros mesh within sane known.
  split; [exact (DegreesPositive mesh _ _ within)|].
  split; [exact (DegreesBetween mesh _ _ within)|].
  split; [apply PlacedFacesConform|].
  split; [apply PlacedBoundary|].
  apply PlacedNothingOverflows; assumption.
Qed.

(** ** Clamped cuts are on their edges *)

Lemma ClampedOnEdge th cut p q : AtMostHalf th ->
  (forall kind, 0 <= ThresholdSteps th kind) -> 0 <= ClampedCut th cut p q <= Steps.
Proof.
  intros half some. unfold ClampedCut.
  pose proof (half (KindBetween p q)). pose proof (some (KindBetween p q)). lia.
Qed.
