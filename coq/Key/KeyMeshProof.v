(** * With diagonals by key the output is one mesh: proof

    As in [MeshProof], for any order of the cuts. *)

From Certet Require Import Key.Definitions.
From Certet Require Import Lattice.ArrangementProof Stencil.Symbol
  Stencil.SymbolProof Stencil.TriangleChecker Stencil.TriangleCheckerProof
  Stuffing.NameProof Stuffing.MeshProof Embedding.EdgeRank
  Key.Orders Key.OrderProof Key.KeyChecker Key.KeysApartProof Key.FaceRuleProof
  Key.KeyFollowsProof.
Open Scope Z_scope.

(** The sign of a symbol in use is that of the vertex that it names. *)
Lemma RankedSign f1 f2 f3 p q key before warping s :
  In s (NamedRanked f1 f2 f3 p q key before warping) ->
  forall r, In r (TetCorners s) ->
    SymbolSign (NamedSign f1 f2 f3 p before warping) r
    = PlacedSign before warping (Name f1 f2 f3 p q r).
Proof.
  intros I r R. pose proof (NamedFits f1 f2 f3 p q key before warping) as fits.
  pose proof (CheckStaysInSound _ _ (fits_stays _ _ fits) s r I R) as stays.
  destruct r as [l|a b]; rewrite ?NameBase, ?NameCut; [|reflexivity].
  cbn [SymbolSign]. apply NamedSignCorner.
  destruct l; cbn in stays; discriminate stays || (cbn; tauto).
Qed.

Section Inside.
  Variables (key : Coord3 -> Coord3 -> Z) (before : SignField).
  Variables (warping : Coord3 -> Warping) (tid : StructuredTetId).
  Hypothesis apart : KeysApart key (Corners tid).
  Let made := OrderedNames key before warping tid.
  Let signed v := PlacedSign before warping v.

  Lemma OrderedInside t : In t made ->
    (exists v, In v (TetCorners t) /\ signed v = Plus) /\
    (forall v, In v (TetCorners t) -> signed v <> Minus).
  Proof.
    unfold made. destruct (OrderedViewed key before warping tid apart)
      as (h & f1 & f2 & f3 & p & q & D & V & _ & ->).
    intros I. apply in_map_iff in I. destruct I as (s & <- & I).
    pose proof (NamedFits f1 f2 f3 p q key before warping) as fits.
    destruct (CheckInnerSound _ _ (fits_inner _ _ fits) s I) as [(r & R & plus) none].
    pose proof (RankedSign f1 f2 f3 p q key before warping s I) as E.
    split.
    - exists (Name f1 f2 f3 p q r). split; [|rewrite <- E; assumption].
      apply OrientCorners. rewrite MapTetCorners. apply in_map, R.
    - intros v W. apply OrientCorners in W. rewrite MapTetCorners in W.
      apply in_map_iff in W. destruct W as (x & <- & X). rewrite <- E by exact X.
      apply none, X.
  Qed.

  (** A triangle on a face of the lattice belongs to one tetrahedron of each side. *)
  Theorem OrderedTriangleOnce i t u a b c :
    In t made -> In u made -> HasTriangle t a b c -> HasTriangle u a b c ->
    LiesIn (FaceOf tid i) a -> LiesIn (FaceOf tid i) b -> LiesIn (FaceOf tid i) c ->
    t = u.
  Proof.
    unfold made. destruct (OrderedViewed key before warping tid apart)
      as (h & f1 & f2 & f3 & p & q & D & V & _ & ->).
    destruct (FaceNamed f1 f2 f3 p q tid i V) as (face & listed & ->).
    apply (NamedTriangleOnce f1 f2 f3 p q h face _ D).
    exact (fits_once _ _ (NamedFits f1 f2 f3 p q key before warping) face listed).
  Qed.

  Lemma OrderedReachesOff i t : In t made ->
    ~ (forall v, In v (TetCorners t) -> LiesIn (FaceOf tid i) v).
  Proof.
    unfold made. destruct (OrderedViewed key before warping tid apart)
      as (h & f1 & f2 & f3 & p & q & D & V & _ & ->).
    destruct (FaceNamed f1 f2 f3 p q tid i V) as (face & listed & ->).
    intros I on. apply in_map_iff in I. destruct I as (s & <- & I).
    pose proof (NamedFits f1 f2 f3 p q key before warping) as fits.
    refine (CheckReachesOffSound face _ (fits_reaches _ _ fits face listed) s I _).
    intros r R. apply (LiesOnLiesIn f1 f2 f3 p q D). apply on, OrientCorners.
    rewrite MapTetCorners. apply in_map, R.
  Qed.

  Lemma OrderedStaysIn t v : In t made -> In v (TetCorners t) ->
    LiesIn (Corners tid) v.
  Proof.
    intros I J. pose proof (proj1 (OrderedFollows key before warping tid apart t I) v J) as B.
    destruct v; cbn [Belongs LiesIn] in *; tauto.
  Qed.

  (** A triangle with an inner corner is met twice within the structured
      tetrahedron, or lies on one of its faces that has a + corner. *)
  Lemma OrderedTriangleClosed t a b c : In t made -> HasTriangle t a b c ->
    (signed a = OnSurface /\ signed b = OnSurface /\ signed c = OnSurface) \/
    (exists u, In u made /\ u <> t /\ HasTriangle u a b c) \/
    (exists i,
       (exists f, In f (FaceOf tid i) /\ signed (Corner f) = Plus) /\
       LiesIn (FaceOf tid i) a /\ LiesIn (FaceOf tid i) b /\ LiesIn (FaceOf tid i) c).
  Proof.
    unfold made. destruct (OrderedViewed key before warping tid apart)
      as (h & f1 & f2 & f3 & p & q & D & V & _ & ->).
    intros I has. apply in_map_iff in I. destruct I as (s & <- & I).
    rewrite OrientHasTriangle in has.
    destruct (HasTriangleNamed _ _ _ _ _ D _ _ _ _ has)
      as (sa & sb & sc & -> & -> & -> & has_s).
    pose proof (NamedFits f1 f2 f3 p q key before warping) as fits.
    pose proof (RankedSign f1 f2 f3 p q key before warping s I) as E.
    destruct (proj1 has_s) as (A & B & K).
    destruct (CheckClosedSound _ _ (fits_closed _ _ fits) s sa sb sc I has_s)
      as [surface | [(r & inside_r & differs & has_r) | (face & listed & plus & on)]].
    - left. unfold signed. revert surface. cbn [TriangleOnSurface].
      rewrite !E, !andb_true_iff by assumption. intros [[za zb] zc].
      repeat split; match goal with |- ?x = OnSurface => now destruct x end.
    - right. left. exists (Orient h (MapTet (Name f1 f2 f3 p q) r)).
      split; [apply in_map_iff; eauto|]. split.
      + intros same. apply differs.
        now apply (MapNameInjective f1 f2 f3 p q D), (OrientInjective h).
      + apply OrientHasTriangle, HasTriangleName; assumption.
    - right. right.
      destruct (NamedFace f1 f2 f3 p q tid face V listed) as [i is_face].
      exists i. rewrite is_face. split.
      + apply existsb_exists in plus. destruct plus as (l & L & plus).
        exists (LocateFive f1 f2 f3 p q l). split; [apply in_map, L|].
        assert (T : In l TetLabels).
        { destruct listed as [<-|[<-|[<-|[<-|[]]]]]; cbn in L |- *; intuition auto. }
        unfold signed.
        rewrite <- (NamedSignCorner f1 f2 f3 p q before warping l T).
        destruct (NamedSign _ _ _ _ _ _ l); reflexivity || discriminate plus.
      + now apply (TriangleOnLiesIn f1 f2 f3 p q D).
  Qed.
End Inside.

(** ** Across faces *)

Section Mesh.
  Variables (key : Coord3 -> Coord3 -> Z) (before : SignField).
  Variable warping : Coord3 -> Warping.
  Hypothesis apart : forall tid, KeysApart key (Corners tid).

  Lemma OrderedNeverInNeighbor tid i t :
    In t (OrderedNames key before warping tid) ->
    ~ In t (OrderedNames key before warping (NeighborOf tid i)).
  Proof.
    intros here there.
    apply (OrderedReachesOff key before warping tid (apart tid) i t here). intros v J.
    pose proof (OrderedStaysIn key before warping tid (apart tid) t v here J) as in_tid.
    pose proof (OrderedStaysIn key before warping _ (apart _) t v there J) as in_nei.
    destruct (FaceShared tid i) as (f1 & f2 & f3 & p & q & is_face & distinct & arranged).
    unfold FaceOf. rewrite is_face. unfold NeighborOf in in_nei.
    unfold Corners in *.
    destruct (GetStructuredTet (fst (NeighborAcross (GetStructuredTet tid) i))).
    destruct (GetStructuredTet tid).
    exact (LiesInBoth _ _ _ _ _ _ _ _ _ _ _ _ _ v distinct arranged in_tid in_nei).
  Qed.

  Theorem OrderedBoundary tid t a b c :
    In t (OrderedNames key before warping tid) -> HasTriangle t a b c ->
    let signed v := PlacedSign before warping v in
    (signed a = OnSurface /\ signed b = OnSurface /\ signed c = OnSurface) \/
    (exists u, u <> t /\ HasTriangle u a b c /\
       (In u (OrderedNames key before warping tid) \/
        exists i, In u (OrderedNames key before warping (NeighborOf tid i)))).
  Proof.
    intros inside has signed.
    destruct (OrderedTriangleClosed key before warping tid (apart tid) t a b c inside has)
      as [surface | [(u & U & differs & has_u) | (i & plus & in_a & in_b & in_c)]].
    - left. exact surface.
    - right. exists u. auto.
    - right.
      destruct (proj1 (OrderedFacesAgree key before warping tid i (apart _) (apart _)
        plus a b c in_a in_b in_c) (ex_intro _ t (conj inside has))) as (u & U & has_u).
      exists u. split; [|split; [exact has_u|eauto]].
      intros ->. exact (OrderedNeverInNeighbor tid i t inside U).
  Qed.
End Mesh.
