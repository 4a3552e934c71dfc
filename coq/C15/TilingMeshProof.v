(** * In any tiling the output by key is one mesh: proof

    As in [FaceRuleProof] and [KeyMeshProof], of a tiling whose vertices are four,
    and whose neighbours share faces. *)

From Certet Require Import Key.Definitions.
From Certet Require Import Lattice.Tiling Stencil.Symbol
  Stencil.SymbolProof Stencil.TriangleChecker Stencil.TriangleCheckerProof
  Stuffing.NameProof Key.Orders Key.OrderProof Key.KeyChecker
  Key.FaceRuleProof C15.TilingStuffing.
Open Scope Z_scope.

(** Some point is none of four. *)
Lemma FifthPoint (a b c d : Coord3) : exists q, ~ In q [a; b; c; d].
Proof.
  destruct a as [a1 a2 a3], b as [b1 b2 b3], c as [c1 c2 c3], d as [d1 d2 d3].
  exists (C3 (1 + Z.abs a1 + Z.abs b1 + Z.abs c1 + Z.abs d1) 0 0). cbn [In].
  intros [E|[E|[E|[E|[]]]]];
    apply (f_equal (fun p => match p with C3 x _ _ => x end)) in E; cbv beta iota in E; lia.
Qed.

Lemma PlaceDecided (i j : Place) : i = j \/ i <> j.
Proof. destruct i, j; auto; right; discriminate. Qed.

(** Nobody moves: signs are those after warping. *)
Local Notation still := (fun _ : Coord3 => Stays).

Section Tiling.
  Variable T : Tiling.
  Hypothesis four : VerticesApart T.
  Variables (key : Coord3 -> Coord3 -> Z) (after : SignField).

  Section One.
    Variable id : Identifier T.
    Hypothesis apart : KeysApart key (VerticesOf T id).
    Let f1 := VertexOf id First.
    Let f2 := VertexOf id Second.
    Let f3 := VertexOf id Third.
    Let p := VertexOf id Fourth.
    Variable q : Coord3.
    Hypothesis distinct : NoDup [f1; f2; f3; p; q].

    Local Notation at_ := (LocateFive f1 f2 f3 p q).
    Local Notation name := (Name f1 f2 f3 p q).
    Local Notation ranked := (NamedRanked f1 f2 f3 p q key after still).
    Local Notation sign := (NamedSign f1 f2 f3 p after still).
    Let made := TilingNames T key after id.

    Lemma TilingNamed : exists h,
      made = map (fun t => Orient h (MapTet name t)) ranked.
    Proof.
      exists (HandOf id). unfold made, TilingNames.
      pose proof (LabelledTets f1 f2 f3 p q distinct key after still apart F1 F2 F3 P
        ltac:(cbn; tauto)) as E.
      rewrite !NameBase in E. cbn [LocateFive Locate] in E.
      transitivity (map (Orient (HandOf id)) (map (MapTet name) ranked));
        [|apply map_map].
      f_equal. exact E.
    Qed.

    Lemma Fits : FitsInside sign ranked.
    Proof. apply NamedFits. Qed.

    Lemma SymbolSigns s r : In s ranked -> In r (TetCorners s) ->
      SymbolSign sign r = AfterSign after (name r).
    Proof.
      intros I X. pose proof (CheckStaysInSound _ _ (fits_stays _ _ Fits) s r I X) as stays.
      destruct r as [l|a b]; rewrite ?NameBase, ?NameCut; [|reflexivity].
      cbn [SymbolSign]. rewrite (NamedSignCorner f1 f2 f3 p q); [reflexivity|].
      destruct l; cbn in stays; discriminate stays || (cbn; tauto).
    Qed.

    (** Faces by labels. *)
    Definition LabelsAcross (i : Place) : list Label :=
      match i with
      | First => [F2; F3; P] | Second => [F1; F3; P]
      | Third => [F1; F2; P] | Fourth => [F1; F2; F3]
      end.

    Lemma FaceByLabels i : TilingFace T id i = map at_ (LabelsAcross i).
    Proof. destruct i; reflexivity. Qed.

    Lemma LabelsListed i : In (LabelsAcross i) Faces.
    Proof. destruct i; cbn; tauto. Qed.

    Lemma FacesListed labels : In labels Faces -> exists i, labels = LabelsAcross i.
    Proof.
      intros [<- | [<- | [<- | [<- | []]]]];
        [exists First|exists Second|exists Third|exists Fourth]; reflexivity.
    Qed.

    Lemma TilingInside t : In t made ->
      (exists v, In v (TetCorners t) /\ AfterSign after v = Plus) /\
      (forall v, In v (TetCorners t) -> AfterSign after v <> Minus).
    Proof.
      destruct TilingNamed as [h ->].
      intros I. apply in_map_iff in I. destruct I as (s & <- & I).
      destruct (CheckInnerSound _ _ (fits_inner _ _ Fits) s I) as [(r & R & plus) none].
      split.
      - exists (name r). split; [|rewrite <- (SymbolSigns s); assumption].
        apply OrientCorners. rewrite MapTetCorners. apply in_map, R.
      - intros v W. apply OrientCorners in W. rewrite MapTetCorners in W.
        apply in_map_iff in W. destruct W as (x & <- & X).
        rewrite <- (SymbolSigns s) by assumption. apply none, X.
    Qed.

    Lemma TilingOnce i t u a b c :
      In t made -> In u made -> HasTriangle t a b c -> HasTriangle u a b c ->
      LiesIn (TilingFace T id i) a -> LiesIn (TilingFace T id i) b ->
      LiesIn (TilingFace T id i) c -> t = u.
    Proof.
      destruct TilingNamed as [h ->]. rewrite FaceByLabels.
      intros in_t in_u has_t has_u in_a in_b in_c.
      apply in_map_iff in in_t as (s & <- & in_s), in_u as (r & <- & in_r).
      rewrite OrientHasTriangle in has_t, has_u.
      destruct (HasTriangleNamed _ _ _ _ _ distinct _ _ _ _ has_t)
        as (sa & sb & sc & -> & -> & -> & has_s).
      rewrite HasTriangleName in has_u by exact distinct.
      do 2 f_equal.
      apply (CheckOnceSound _ _ (fits_once _ _ Fits _ (LabelsListed i))) with sa sb sc;
        try assumption.
      apply (TriangleOnLiesIn f1 f2 f3 p q distinct); auto.
    Qed.

    Lemma TilingReachesOff i t : In t made ->
      ~ (forall v, In v (TetCorners t) -> LiesIn (TilingFace T id i) v).
    Proof.
      destruct TilingNamed as [h ->]. rewrite FaceByLabels.
      intros I on. apply in_map_iff in I. destruct I as (s & <- & I).
      refine (CheckReachesOffSound _ _ (fits_reaches _ _ Fits _ (LabelsListed i)) s I _).
      intros r R. apply (LiesOnLiesIn f1 f2 f3 p q distinct). apply on, OrientCorners.
      rewrite MapTetCorners. apply in_map, R.
    Qed.

    Lemma TilingStaysIn t v : In t made -> In v (TetCorners t) ->
      LiesIn (VerticesOf T id) v.
    Proof.
      destruct TilingNamed as [h ->].
      intros I J. apply in_map_iff in I. destruct I as (s & <- & I).
      apply OrientCorners in J. rewrite MapTetCorners in J.
      apply in_map_iff in J. destruct J as (r & <- & R).
      exact (proj1 (LiesOnLiesIn f1 f2 f3 p q distinct TetLabels r)
        (CheckStaysInSound _ _ (fits_stays _ _ Fits) s r I R)).
    Qed.

    (** A triangle with an inner corner is met twice within, or lies on a face with
        a + corner. *)
    Lemma TilingClosed t a b c : In t made -> HasTriangle t a b c ->
      (AfterSign after a = OnSurface /\ AfterSign after b = OnSurface /\
       AfterSign after c = OnSurface) \/
      (exists u, In u made /\ u <> t /\ HasTriangle u a b c) \/
      (exists i,
         (exists f, In f (TilingFace T id i) /\ after f = Plus) /\
         LiesIn (TilingFace T id i) a /\ LiesIn (TilingFace T id i) b /\
         LiesIn (TilingFace T id i) c).
    Proof.
      destruct TilingNamed as [h ->].
      intros I has. apply in_map_iff in I. destruct I as (s & <- & I).
      rewrite OrientHasTriangle in has.
      destruct (HasTriangleNamed _ _ _ _ _ distinct _ _ _ _ has)
        as (sa & sb & sc & -> & -> & -> & has_s).
      destruct (proj1 has_s) as (A & B & K).
      destruct (CheckClosedSound _ _ (fits_closed _ _ Fits) s sa sb sc I has_s)
        as [surface | [(r & inside_r & differs & has_r) | (face & listed & plus & on)]].
      - left. revert surface. cbn [TriangleOnSurface].
        rewrite !(SymbolSigns s), !andb_true_iff by assumption. intros [[za zb] zc].
        repeat split; match goal with |- ?x = OnSurface => now destruct x end.
      - right. left. exists (Orient h (MapTet name r)).
        split; [apply in_map_iff; eauto|]. split.
        + intros same. apply differs.
          now apply (MapNameInjective f1 f2 f3 p q distinct), (OrientInjective h).
        + apply OrientHasTriangle, HasTriangleName; assumption.
      - right. right. destruct (FacesListed face listed) as [i ->].
        exists i. rewrite FaceByLabels. split.
        + apply existsb_exists in plus. destruct plus as (l & L & plus).
          exists (at_ l). split; [apply in_map, L|].
          assert (In l TetLabels) as M by (destruct i; cbn in L |- *; intuition auto).
          pose proof (NamedSignCorner f1 f2 f3 p q after still l M) as E.
          cbn [PlacedSign WarpedSign] in E. rewrite <- E.
          destruct (NamedSign _ _ _ _ _ _ l); reflexivity || discriminate plus.
        + now apply (TriangleOnLiesIn f1 f2 f3 p q distinct).
    Qed.

    (** The face's own rule. *)
    Lemma TilingRule g1 g2 g3 : NoDup [g1; g2; g3] -> incl [g1; g2; g3] (VerticesOf T id) ->
      (exists g, In g [g1; g2; g3] /\ after g = Plus) ->
      forall a b c, LiesIn [g1; g2; g3] a -> LiesIn [g1; g2; g3] b ->
        LiesIn [g1; g2; g3] c ->
        AmongTriangles made a b c <->
        AmongFaceTriangles
          (FaceTriangles MeshVertex (AfterSign after) MeshIntersection (MeshKey key)
             (Corner g1) (Corner g2) (Corner g3)) a b c.
    Proof.
      intros different inside plus.
      destruct (OrderedFaceNamed f1 f2 f3 p q g1 g2 g3 different inside)
        as (l1 & l2 & l3 & listed & -> & -> & ->).
      exact (NamedFaceRule f1 f2 f3 p q distinct key after still apart made TilingNamed
               l1 l2 l3 listed plus).
    Qed.
  End One.

  Lemma FiveDistinct (id : Identifier T) : exists q,
    NoDup [VertexOf id First; VertexOf id Second; VertexOf id Third;
           VertexOf id Fourth; q].
  Proof.
    clear key after.
    destruct (FifthPoint (VertexOf id First) (VertexOf id Second) (VertexOf id Third)
                (VertexOf id Fourth)) as (q & Q).
    exists q.
    assert (ne : forall i j, i <> j -> VertexOf id i <> VertexOf id j)
      by (intros i j N E; apply N; exact (four id i j E)).
    pose proof (ne First Second ltac:(discriminate)).
    pose proof (ne First Third ltac:(discriminate)).
    pose proof (ne First Fourth ltac:(discriminate)).
    pose proof (ne Second Third ltac:(discriminate)).
    pose proof (ne Second Fourth ltac:(discriminate)).
    pose proof (ne Third Fourth ltac:(discriminate)).
    cbn [In] in Q. repeat constructor; cbn [In]; intuition congruence.
  Qed.

  Theorem TilingFaceRule (id : Identifier T) g1 g2 g3 : KeysApart key (VerticesOf T id) ->
    NoDup [g1; g2; g3] -> incl [g1; g2; g3] (VerticesOf T id) ->
    (exists g, In g [g1; g2; g3] /\ after g = Plus) ->
    forall a b c, LiesIn [g1; g2; g3] a -> LiesIn [g1; g2; g3] b ->
      LiesIn [g1; g2; g3] c ->
      AmongTriangles (TilingNames T key after id) a b c <->
      AmongFaceTriangles
        (FaceTriangles MeshVertex (AfterSign after) MeshIntersection (MeshKey key)
           (Corner g1) (Corner g2) (Corner g3)) a b c.
  Proof.
    intros apart. destruct (FiveDistinct id) as (q & D).
    exact (TilingRule id apart q D g1 g2 g3).
  Qed.

  (** ** Across faces *)

  Hypothesis faces : TilingFacesCorrect T.
  (** A neighbour's vertices, lined up, are its vertices. *)
  Hypothesis reordered : forall id i v,
    In v (VerticesOf T (TilingNeighbor T id i)) <-> exists j, v = LinedUp T id i j.
  Hypothesis apart : forall id, KeysApart key (VerticesOf T id).

  Lemma InVertices (id : Identifier T) v : In v (VerticesOf T id) <-> exists i, v = VertexOf id i.
  Proof.
    unfold VerticesOf. rewrite in_map_iff. split.
    - intros (i & <- & _). eauto.
    - intros (i & ->). exists i. split; [reflexivity|]. destruct i; cbn; tauto.
  Qed.

  Lemma FaceInNeighbor (id : Identifier T) i : incl (TilingFace T id i) (VerticesOf T (TilingNeighbor T id i)).
  Proof.
    intros v I. apply reordered.
    assert (exists j, j <> i /\ v = VertexOf id j) as (j & N & ->).
    { unfold TilingFace in I. destruct i; cbn [Others In] in I;
        repeat (destruct I as [<-|I]; [eexists; split; [|reflexivity]; discriminate|]);
        destruct I. }
    exists j. symmetry. apply faces, N.
  Qed.

  Lemma FaceWithin (id : Identifier T) i : incl (TilingFace T id i) (VerticesOf T id).
  Proof.
    intros v I. unfold TilingFace in I.
    destruct i; cbn [Others] in I; unfold VerticesOf; cbn [map In] in *; tauto.
  Qed.

  Lemma FaceNoDup (id : Identifier T) i : NoDup (TilingFace T id i).
  Proof.
    assert (ne : forall i j, i <> j -> VertexOf id i <> VertexOf id j)
      by (intros j k N E; apply N; exact (four id j k E)).
    unfold TilingFace. destruct i; cbn [Others]; repeat constructor; cbn [In];
      intuition; match goal with H : VertexOf id _ = VertexOf id _ |- _ =>
        apply ne in H; [exact H|discriminate] end.
  Qed.

  (** A vertex of both is on their face. *)
  Lemma OfBoth (id : Identifier T) i v : In v (VerticesOf T id) ->
    In v (VerticesOf T (TilingNeighbor T id i)) -> In v (TilingFace T id i).
  Proof.
    intros here there. apply InVertices in here. destruct here as (j & ->).
    apply reordered in there. destruct there as (k & E).
    assert (N : j <> i).
    { intros ->. destruct (PlaceDecided k i) as [->|K].
      - exact (proj1 (faces id i i) (eq_sym E) eq_refl).
      - rewrite (proj2 (faces id i k) K) in E. apply four in E. congruence. }
    unfold TilingFace. destruct i, j; cbn [Others In]; try congruence; tauto.
  Qed.

  Lemma LiesInFace (id : Identifier T) i v : LiesIn (VerticesOf T id) v ->
    LiesIn (VerticesOf T (TilingNeighbor T id i)) v -> LiesIn (TilingFace T id i) v.
  Proof.
    destruct v as [c|a m]; cbn [LiesIn].
    - apply OfBoth.
    - intros [] []. split; apply OfBoth; assumption.
  Qed.

  Theorem TilingFacesAgree (id : Identifier T) i :
    (exists f, In f (TilingFace T id i) /\ after f = Plus) ->
    forall a b c, LiesIn (TilingFace T id i) a -> LiesIn (TilingFace T id i) b ->
      LiesIn (TilingFace T id i) c ->
      AmongTriangles (TilingNames T key after id) a b c <->
      AmongTriangles (TilingNames T key after (TilingNeighbor T id i)) a b c.
  Proof.
    pose proof (FaceNoDup id i) as D. pose proof (FaceWithin id i) as I.
    pose proof (FaceInNeighbor id i) as J. revert D I J.
    assert (exists g1 g2 g3, TilingFace T id i = [g1; g2; g3]) as (g1 & g2 & g3 & ->)
      by (unfold TilingFace; destruct (Others i) as [[? ?] ?]; eauto).
    intros D I J plus a b c A B C.
    rewrite (TilingFaceRule id g1 g2 g3), (TilingFaceRule (TilingNeighbor T id i) g1 g2 g3);
      auto; reflexivity.
  Qed.

  Theorem TilingTriangleOnce (id : Identifier T) i t u a b c :
    In t (TilingNames T key after id) -> In u (TilingNames T key after id) ->
    HasTriangle t a b c -> HasTriangle u a b c ->
    LiesIn (TilingFace T id i) a -> LiesIn (TilingFace T id i) b ->
    LiesIn (TilingFace T id i) c -> t = u.
  Proof.
    destruct (FiveDistinct id) as (q & D).
    exact (TilingOnce id (apart id) q D i t u a b c).
  Qed.

  Lemma NeverInNeighbor (id : Identifier T) i t : In t (TilingNames T key after id) ->
    ~ In t (TilingNames T key after (TilingNeighbor T id i)).
  Proof.
    intros here there.
    destruct (FiveDistinct id) as (q & D).
    destruct (FiveDistinct (TilingNeighbor T id i)) as (q' & D').
    apply (TilingReachesOff id (apart id) q D i t here). intros v J.
    apply LiesInFace.
    - exact (TilingStaysIn id (apart id) q D t v here J).
    - exact (TilingStaysIn _ (apart _) q' D' t v there J).
  Qed.

  Theorem TilingBoundary (id : Identifier T) t a b c :
    In t (TilingNames T key after id) -> HasTriangle t a b c ->
    (AfterSign after a = OnSurface /\ AfterSign after b = OnSurface /\
     AfterSign after c = OnSurface) \/
    (exists u, u <> t /\ HasTriangle u a b c /\
       (In u (TilingNames T key after id) \/
        exists i, In u (TilingNames T key after (TilingNeighbor T id i)))).
  Proof.
    intros inside has. destruct (FiveDistinct id) as (q & D).
    destruct (TilingClosed id (apart id) q D t a b c inside has)
      as [surface | [(u & U & differs & has_u) | (i & plus & A & B & C)]].
    - left. exact surface.
    - right. exists u. auto.
    - right.
      destruct (proj1 (TilingFacesAgree id i plus a b c A B C)
        (ex_intro _ t (conj inside has))) as (u & U & has_u).
      exists u. split; [|split; [exact has_u|eauto]].
      intros ->. exact (NeverInNeighbor id i t inside U).
  Qed.
End Tiling.
