(** * How many triangles of the surface an edge is in

    An edge at a cut lies in a face of the lattice, and each side of the face has
    one triangle there; or it leads across a structured tetrahedron, which has
    two.  At an edge between two 0 corners the ring around it is decisive: a
    triangle for each place where + begins or ends. *)

From Coq Require Import ZArith List Bool Arith Lia.
From Coq Require Logic.FinFun.
From Certet Require Import Lattice.Coord3 Lattice.Direction.
From Certet Require Import Lattice.StructuredTet Lattice.NeighborSpec.
From Certet Require Import Stencil.UnstructuredTet Stencil.TriangleSpec.
From Certet Require Import Warp.Cut Warp.Warp.
From Certet Require Import Stuffing.Stuffing.
From Certet Require Import Angles.AnglesSpec Angles.Cases.Isometry.
From Certet Require Import Embedding.EmbeddingSpec Embedding.PiecesSpec.
From Certet Require Import Embedding.DiskRule.
From Certet Require Import Embedding.EdgeRank Embedding.GreedyProof.
From Certet Require Import Embedding.MeshApartProof.
From Certet Require Import Embedding.LinkProof.
From Certet Require Import Embedding.SettleSpec.
From Certet Require Import Topology.SurfaceSpec Topology.CliqueProof.
From Certet Require Import Topology.LocalSurfaceProof Topology.SurfaceProof.
From Certet Require Import Topology.RingProof.
Import ListNotations.

(** ** The corners of a structured tetrahedron *)

Lemma FourApart {A} (a b c d : A) : NoDup [a; b; c; d] <->
  a <> b /\ a <> c /\ a <> d /\ b <> c /\ b <> d /\ c <> d.
Proof.
  split.
  - intros N. rewrite !NoDup_cons_iff in N. cbn [In] in N.
    destruct N as (Na & Nb & Nc & _).
    repeat split; intros ->; tauto.
  - intros (Ab & Ac & Ad & Bc & Bd & Cd). repeat constructor; cbn [In];
      intros K; repeat (destruct K as [K|K]; [congruence|]); exact K.
Qed.

Lemma ThreeApart {A} (a b c : A) : NoDup [a; b; c] <-> a <> b /\ a <> c /\ b <> c.
Proof.
  split.
  - intros N. rewrite !NoDup_cons_iff in N. cbn [In] in N. destruct N as (Na & Nb & _).
    repeat split; intros ->; tauto.
  - intros (Ab & Ac & Bc). repeat constructor; cbn [In];
      intros K; repeat (destruct K as [K|K]; [congruence|]); exact K.
Qed.

Lemma OtherTwo tid a b : In a (Corners tid) -> In b (Corners tid) -> a <> b ->
  exists e f, NoDup [a; b; e; f] /\ In e (Corners tid) /\ In f (Corners tid).
Proof.
  intros A B N. pose proof (CornersNoDup tid) as D. unfold Corners in *.
  destruct (GetStructuredTet tid) as [v1 v2 v3 v4]. apply FourApart in D.
  cbn [In] in A, B |- *.
  assert (G : forall x y, In x [v1; v2; v3; v4] -> In y [v1; v2; v3; v4] ->
    a <> x -> a <> y -> b <> x -> b <> y -> x <> y ->
    exists e f, NoDup [a; b; e; f] /\
      (v1 = e \/ v2 = e \/ v3 = e \/ v4 = e \/ False) /\
      (v1 = f \/ v2 = f \/ v3 = f \/ v4 = f \/ False)).
  { intros x y X Y Ax Ay Bx By Xy. exists x, y. split; [|split; assumption].
    apply FourApart. auto 8. }
  clear -A B N D G. destruct D as (D12 & D13 & D14 & D23 & D24 & D34).
  destruct A as [<-|[<-|[<-|[<-|[]]]]], B as [<-|[<-|[<-|[<-|[]]]]];
    first [congruence
      |apply (G v1 v2); cbn [In]; auto; congruence
      |apply (G v1 v3); cbn [In]; auto; congruence
      |apply (G v1 v4); cbn [In]; auto; congruence
      |apply (G v2 v3); cbn [In]; auto; congruence
      |apply (G v2 v4); cbn [In]; auto; congruence
      |apply (G v3 v4); cbn [In]; auto; congruence].
Qed.

Lemma OtherOne tid a b c : In a (Corners tid) -> In b (Corners tid) ->
  In c (Corners tid) -> NoDup [a; b; c] ->
  exists e, NoDup [a; b; c; e] /\ In e (Corners tid).
Proof.
  intros A B C N. apply ThreeApart in N. destruct N as (Ab & Ac & Bc).
  destruct (OtherTwo tid a b A B Ab) as (e & f & D & E & F).
  assert (I : incl (Corners tid) [a; b; e; f]).
  { apply CornersAre; [exact D|reflexivity|].
    intros x. cbn [In]. intros [<-|[<-|[<-|[<-|[]]]]]; assumption. }
  apply FourApart in D. destruct D as (_ & Ae & Af & Be & Bf & Ef).
  destruct (I c C) as [<-|[<-|[<-|[<-|[]]]]];
    [congruence|congruence|exists f|exists e]; (split; [apply FourApart|assumption]);
    auto 8.
Qed.

Section Mesh.
  Variables (before : SignField) (warping : Coord3 -> Warping).
  Local Notation after := (SignAfter before warping).
  Local Notation on_it := (OnIt before warping).
  Local Notation triangle := (LocalTriangle before warping).
  Local Notation surface := (SurfaceTriangle before warping).

  (** ** Across the inside *)

  Lemma InnerEdge x y z tid : InLattice tid -> triangle tid x y z ->
    Reach (Corners tid) [x; y] ->
    (forall a b, x = Corner a -> y = Corner b -> False) ->
    exists z', z' <> z /\ surface x y z' /\
      forall z'', surface x y z'' -> z'' = z \/ z'' = z'.
  Proof.
    intros E T R B.
    destruct (LocalInnerEdge before warping tid x y z E R B T) as (z' & N & T' & U).
    assert (R' : forall w, Reach (Corners tid) [x; y; w]).
    { intros w c C. destruct (R c C) as (v & V & I). exists v. cbn [In] in *. tauto. }
    exists z'. split; [exact N|].
    split; [apply (SurfaceInside before warping tid); auto|].
    intros z'' W. destruct (SurfaceWhere before warping x y z'' W) as (tid' & E' & L).
    assert (tid = tid').
    { destruct (LocalOnIt before warping tid' x y z'' E' L) as (X & Y & _).
      apply (ReachDetermines before warping tid tid' [x; y]); try assumption.
      intros v. cbn [In]. intros [<-|[<-|[]]]; assumption. }
    subst tid'. exact (U z'' L).
  Qed.

  (** ** In a face *)

  (** The ends of the two are three corners. *)
  Lemma FaceEnds tid x y c : on_it tid x -> on_it tid y -> x <> y ->
    (forall a b, x = Corner a -> y = Corner b -> False) ->
    In c (Corners tid) -> (forall v, In v [x; y] -> ~ In c (Ends v)) ->
    exists f1 f2 f3, NoDup [f1; f2; f3] /\
      (forall e, In e [f1; f2; f3] <-> In e (Ends x ++ Ends y)).
  Proof.
    intros X Y N B I Off.
    assert (Cut3 : forall a m v, on_it tid (Cut a m) -> on_it tid v -> Cut a m <> v ->
      ~ In c (Ends (Cut a m)) -> ~ In c (Ends v) ->
      exists e, NoDup [a; m; e] /\ In e (Ends v) /\
        forall f, In f (Ends v) -> In f [a; m; e]).
    { intros a m v [(A & M & Sa & Sm) _] V D Oc Ov.
      assert (Am : a <> m) by (intros ->; congruence).
      cbn [Ends In] in Oc. destruct v as [b|b n].
      - destruct V as [[Ib _] Sb]. fold (after b) in Sb.
        exists b. cbn [Ends In].
        split; [|split; [auto|intros f [<-|[]]; auto]].
        apply ThreeApart. unfold SignAfter in *. repeat split; congruence.
      - destruct V as [(Ib & In_ & Sb & Sn) _]. cbn [Ends In] in *.
        assert (Bn : b <> n) by (intros ->; congruence).
        assert (An : a <> n) by (intros ->; congruence).
        assert (Bm : b <> m) by (intros ->; congruence).
        destruct (SamePoint3 a b) as [<-|Ab].
        + assert (m <> n) by congruence.
          exists n. split; [apply ThreeApart; auto|split; [cbn; tauto|]].
          intros f [<-|[<-|[]]]; auto.
        + destruct (SamePoint3 m n) as [<-|Mn].
          * exists b. split; [apply ThreeApart; auto|split; [cbn; tauto|]].
            intros f [<-|[<-|[]]]; auto.
          * exfalso.
            assert (incl (Corners tid) [a; m; b; n]).
            { apply CornersAre; [|reflexivity|].
              - apply FourApart. auto 8.
              - intros w. cbn [In]. intros [<-|[<-|[<-|[<-|[]]]]]; assumption. }
            destruct (H c I) as [<-|[<-|[<-|[<-|[]]]]]; tauto. }
    pose proof (Off x (or_introl eq_refl)) as Ox.
    pose proof (Off y (or_intror (or_introl eq_refl))) as Oy.
    destruct x as [a|a m].
    - destruct y as [b|b m]; [destruct (B a b eq_refl eq_refl)|].
      destruct (Cut3 b m (Corner a) Y X (not_eq_sym N) Oy Ox) as (e & D & Ie & All).
      exists b, m, e. split; [exact D|]. intros f. rewrite in_app_iff.
      split; [|intros [F|F]; [apply All, F|cbn [Ends In] in *; tauto]].
      cbn [In]. intros [<-|[<-|[<-|[]]]]; cbn [Ends In] in *; tauto.
    - destruct (Cut3 a m y X Y N Ox Oy) as (e & D & Ie & All).
      exists a, m, e. split; [exact D|]. intros f. rewrite in_app_iff.
      split; [|intros [F|F]; [cbn [Ends In] in *; tauto|apply All, F]].
      cbn [In]. intros [<-|[<-|[<-|[]]]]; cbn [Ends In] in *; tauto.
  Qed.

  (** Who has the ends of a vertex on the surface has the vertex. *)
  Lemma OnItToo tid tid' x : on_it tid x ->
    (forall e, In e (Ends x) -> In e (Corners tid')) -> on_it tid' x.
  Proof.
    intros [B S] I. split; [|exact S]. destruct x as [c|a m]; cbn [Belongs Ends In] in *.
    - split; [apply I; tauto|tauto].
    - split; [apply I; tauto|]. split; [apply I; tauto|tauto].
  Qed.

  Lemma FaceEdge x y z tid c : InLattice tid -> triangle tid x y z ->
    In c (Corners tid) -> (forall v, In v [x; y] -> ~ In c (Ends v)) ->
    (forall a b, x = Corner a -> y = Corner b -> False) ->
    exists z', z' <> z /\ surface x y z' /\
      forall z'', surface x y z'' -> z'' = z \/ z'' = z'.
  Proof.
    intros E T I Off B.
    destruct (LocalOnIt before warping tid x y z E T) as (X & Y & Z).
    assert (N : x <> y) by (destruct T as [(t & _ & H) _]; apply H).
    destruct (FaceEnds tid x y c X Y N B I Off) as (f1 & f2 & f3 & D & M).
    assert (In_ : forall own, on_it own x -> on_it own y ->
      incl [f1; f2; f3] (Corners own)).
    { intros own Ox Oy e Ie. apply M, in_app_iff in Ie.
      destruct Ie as [Ie|Ie]; [exact (EndsWithin _ _ own x e Ox Ie)
        |exact (EndsWithin _ _ own y e Oy Ie)]. }
    assert (Here : forall own, incl [f1; f2; f3] (Corners own) ->
      on_it own x /\ on_it own y).
    { intros own K. split; [apply (OnItToo tid)|apply (OnItToo tid)]; try assumption;
        intros e Ie; apply K, M, in_app_iff; auto. }
    pose proof (In_ tid X Y) as F.
    assert (Nc : ~ In c [f1; f2; f3]).
    { intros K. apply M, in_app_iff in K.
      destruct K as [K|K]; [apply (Off x)|apply (Off y)]; cbn; auto. }
    pose proof (proj1 (ThreeApart _ _ _) D) as (D12 & D13 & D23).
    assert (C1 : f1 <> c) by (intros <-; apply Nc; cbn; tauto).
    assert (C2 : f2 <> c) by (intros <-; apply Nc; cbn; tauto).
    assert (C3 : f3 <> c) by (intros <-; apply Nc; cbn; tauto).
    assert (Adj : forall u v, In u [f1; f2; f3; c] -> In v [f1; f2; f3; c] -> u <> v ->
      Adjacent u v).
    { assert (G : incl [f1; f2; f3; c] (Corners tid)).
      { intros w W. cbn [In] in W. destruct W as [<-|[<-|[<-|[<-|[]]]]];
          [apply F|apply F|apply F|exact I]; cbn; tauto. }
      intros u v U V. apply (CornersAdjacent tid); apply G; assumption. }
    destruct (ApexesOfFace f1 f2 f3) as (p & q & Npq & Ap & Aq & Only);
      try (apply Adj; cbn [In]; auto).
    assert (exists c', c' <> c /\ (Adjacent f1 c' /\ Adjacent f2 c' /\ Adjacent f3 c') /\
      forall w, Adjacent f1 w -> Adjacent f2 w -> Adjacent f3 w -> w = c \/ w = c')
      as (c' & Nc' & Ac' & Only').
    { destruct (Only c); try (apply Adj; cbn [In]; auto); subst c;
        [exists q|exists p]; (split; [congruence|]); (split; [assumption|]);
        intros w W1 W2 W3; destruct (Only w W1 W2 W3); auto. }
    destruct (CliqueIsTet f1 f2 f3 c') as (tid' & E' & F'); try apply Ac';
      try (apply Adj; cbn [In]; auto).
    { exists tid. split; [exact E|]. apply F. cbn. tauto. }
    assert (F3 : incl [f1; f2; f3] (Corners tid'))
      by (intros w W; apply F'; cbn [In] in *; tauto).
    destruct (Here tid' F3) as [X' Y'].
    assert (Off' : forall own d, incl [f1; f2; f3] (Corners own) -> In d (Corners own) ->
      ~ In d [f1; f2; f3] -> ~ Reach (Corners own) [x; y]).
    { intros own d G Dd Nd R. destruct (R d Dd) as (v & V & W).
      apply Nd, M, in_app_iff. cbn [In] in V.
      destruct V as [<-|[<-|[]]]; auto. }
    assert (Fresh : forall v, (Adjacent f1 v /\ Adjacent f2 v /\ Adjacent f3 v) ->
      ~ In v [f1; f2; f3]).
    { intros v (V1 & V2 & V3). cbn [In].
      intros [<-|[<-|[<-|[]]]]; eapply NeverAdjacent; eassumption. }
    destruct (LocalFaceEdge before warping tid x y E X Y N) as (z0 & T0 & U0);
      [apply (Off' tid c); [exact F|exact I|exact Nc]|exact B|].
    destruct (LocalFaceEdge before warping tid' x y E' X' Y' N) as (z' & T' & U');
      [apply (Off' tid' c'); [exact F3|apply F'; cbn; tauto|apply Fresh, Ac']|exact B|].
    assert (z0 = z) by (symmetry; apply U0, T). subst z0.
    assert (Rz : forall own w, InLattice own -> triangle own x y w ->
      Reach (Corners own) [x; y; w]).
    { intros own w Eo [(t & J & H) S].
      destruct (LocalOnIt before warping own x y w Eo
        (conj (ex_intro _ t (conj J H)) S)) as (Xo & Yo & Wo).
      destruct (LocalShape before warping own x y w t J H Xo Yo Wo)
        as [_ [R|(a & b & _ & _ & Ea & Eb & _)]]; [exact R|].
      destruct (B a b Ea Eb). }
    exists z'. split.
    { intros ->. destruct (Rz tid z E T c I) as (v & V & W).
      destruct (LocalOnIt before warping tid' x y z E' T') as (_ & _ & Z').
      cbn [In] in V. destruct V as [<-|[<-|[<-|[]]]];
        [apply (Off x); cbn; auto|apply (Off y); cbn; auto|].
      pose proof (EndsWithin before warping tid' z c Z' W) as K.
      assert (G : incl (Corners tid') [f1; f2; f3; c']).
      { apply CornersAre; [|reflexivity|exact F'].
        pose proof (Fresh c' Ac') as Fr. cbn [In] in Fr.
        apply FourApart. repeat split; try assumption; intros ->; tauto. }
      destruct (G c K) as [Q|[Q|[Q|[Q|[]]]]]; congruence. }
    split; [apply (SurfaceInside before warping tid'); auto|].
    intros z'' W. destruct (SurfaceWhere before warping x y z'' W) as (own & Eo & L).
    destruct (LocalOnIt before warping own x y z'' Eo L) as (Xo & Yo & _).
    pose proof (In_ own Xo Yo) as Fo.
    destruct (OtherOne own f1 f2 f3) as (e & De & Ie);
      [apply Fo; cbn; tauto|apply Fo; cbn; tauto|apply Fo; cbn; tauto|exact D|].
    assert (Go : incl (Corners own) [f1; f2; f3; e]).
    { apply CornersAre; [exact De|reflexivity|]. intros v. cbn [In].
      intros [<-|[<-|[<-|[<-|[]]]]]; [apply Fo|apply Fo|apply Fo|exact Ie]; cbn; tauto. }
    apply FourApart in De. destruct De as (_ & _ & E1 & _ & E2 & E3).
    assert (Ae : forall v, In v [f1; f2; f3] -> Adjacent v e).
    { intros v V. apply (CornersAdjacent own); [apply Fo, V|exact Ie|].
      cbn [In] in V. destruct V as [<-|[<-|[<-|[]]]]; assumption. }
    destruct (Only' e) as [->| ->]; try (apply Ae; cbn; tauto).
    - left. apply U0. replace tid with own; [exact L|].
      apply CornersDetermine; [assumption..|]. intros v V. apply Go in V. cbn [In] in V.
      destruct V as [<-|[<-|[<-|[<-|[]]]]]; [apply F|apply F|apply F|exact I]; cbn; tauto.
    - right. apply U'. replace tid' with own; [exact L|].
      apply CornersDetermine; [assumption..|]. intros v V. apply F', Go, V.
  Qed.

  Lemma CutEdge x y z : surface x y z ->
    (forall a b, x = Corner a -> y = Corner b -> False) ->
    exists z', z' <> z /\ surface x y z' /\
      forall z'', surface x y z'' -> z'' = z \/ z'' = z'.
  Proof.
    intros T B. destruct (SurfaceWhere before warping x y z T) as (tid & E & L).
    assert (Dec : forall c, {In c (Ends x ++ Ends y)} + {~ In c (Ends x ++ Ends y)})
      by (intros c; apply in_dec, SamePoint3).
    destruct (forallb (fun c => if Dec c then true else false) (Corners tid)) eqn:R.
    - apply (InnerEdge x y z tid E L); [|exact B]. intros c C.
      rewrite forallb_forall in R. specialize (R c C). destruct (Dec c) as [I|];
        [|discriminate R]. apply in_app_iff in I.
      destruct I; [exists x|exists y]; cbn [In]; auto.
    - assert (exists c, In c (Corners tid) /\ ~ In c (Ends x ++ Ends y)) as (c & C & Off).
      { clear -R. induction (Corners tid) as [|c cs IH]; [discriminate R|].
        cbn [forallb] in R. destruct (Dec c) as [I|N].
        - destruct (IH R) as (d & D & N). exists d. cbn. auto.
        - exists c. cbn. auto. }
      apply (FaceEdge x y z tid c E L C); [|exact B].
      intros v V K. apply Off, in_app_iff. cbn [In] in V.
      destruct V as [<-|[<-|[]]]; auto.
  Qed.

  (** ** Between two 0 corners *)

  Section Zeros.
    Variables (a : Coord3) (d : Direction).
    Local Notation at_ e := (Translate a (Offset e)).
    Let now (e : Direction) : Sign := after (at_ e).
    Let b := at_ d.
    Let ends := Boundary now (RingPairs d).
    Let third (pair : Direction * Direction) : MeshVertex :=
      CrossingAt after (at_ (fst pair)) (at_ (snd pair)).

    Lemma InEnds e f : In (e, f) ends <->
      Adjacent b (at_ e) /\ Adjacent b (at_ f) /\ Adjacent (at_ e) (at_ f) /\
      after (at_ e) = Plus /\ after (at_ f) <> Plus /\
      (after (at_ f) = OnSurface -> forall e', Adjacent b (at_ e') ->
         Adjacent (at_ f) (at_ e') -> after (at_ e') = Plus -> e' = e).
    Proof.
      assert (C : forall e f, In (e, f) (Crossings now (RingPairs d)) <->
        Adjacent b (at_ e) /\ Adjacent b (at_ f) /\ Adjacent (at_ e) (at_ f) /\
        after (at_ e) = Plus /\ after (at_ f) <> Plus).
      { intros e' f'. unfold Crossings. rewrite filter_In, InRingPairs.
        unfold b. rewrite !(NextInLinkMeans a). unfold Crosses, IsInner, now.
        rewrite andb_true_iff. destruct (after (at_ e')), (after (at_ f')); cbn;
          intuition congruence. }
      unfold ends, Boundary. rewrite filter_In, C. unfold Bounds.
      rewrite orb_true_iff, forallb_forall.
      assert (Z : negb (IsZero now f) = true <-> after (at_ f) <> OnSurface).
      { unfold IsZero, now. destruct (after (at_ f)); cbn; intuition congruence. }
      rewrite Z. split.
      - intros ((Be & Bf & Ef & Pe & Pf) & O). repeat (split; [assumption|]).
        intros Zf e' Be' Fe' Pe'. destruct O as [O|O]; [congruence|].
        specialize (O (e', f) (proj2 (C e' f) (conj Be' (conj Bf
          (conj (AdjacentMutual _ _ Fe') (conj Pe' Pf)))))).
        cbv beta iota in O. rewrite SameDirectionRefl in O. cbn [negb orb] in O.
        symmetry. apply SameDirectionMeans, O.
      - intros (Be & Bf & Ef & Pe & Pf & O). split; [auto|].
        destruct (after (at_ f)) eqn:S; [congruence| |left; discriminate].
        right. intros [e' f'] I. apply C in I. destruct I as (Be' & _ & Ef' & Pe' & _).
        destruct (SameDirection f f') eqn:F; [|reflexivity].
        apply SameDirectionMeans in F. subst f'. cbn [negb orb].
        rewrite (O eq_refl e' Be' (AdjacentMutual _ _ Ef') Pe'). apply SameDirectionRefl.
    Qed.

    Hypothesis OfLattice : LatticePoint a.
    Hypothesis ZeroA : after a = OnSurface.
    Hypothesis ZeroB : after b = OnSurface.

    Lemma ZeroThird z : surface (Corner a) (Corner b) z <-> In z (map third ends).
    Proof.
      assert (Nab : a <> b).
      { intros E. apply (NeverAdjacent a). exists d. exact E. }
      assert (To : forall x, Adjacent a x -> exists e, x = at_ e)
        by (intros x [e ->]; eauto).
      rewrite in_map_iff. split.
      - intros T. destruct (SurfaceWhere before warping _ _ z T) as (tid & E & L).
        destruct (LocalOnIt before warping tid _ _ z E L) as ([[Ia _] _] & [[Ib _] _] & _).
        destruct (OtherTwo tid a b Ia Ib Nab) as (x & y & D & Ix & Iy).
        assert (exists e f, In (at_ e) (Corners tid) /\ In (at_ f) (Corners tid) /\
          NoDup [a; b; at_ e; at_ f] /\ after (at_ e) = Plus /\ after (at_ f) <> Plus /\
          z = CrossingAt after (at_ e) (at_ f)) as (e & f & Ie & If & De & Pe & Pf & ->).
        { pose proof (proj1 (FourApart _ _ _ _) D) as (_ & Ax & Ay & Bx & By & Xy).
          destruct (To x) as [e ->]; [apply (CornersAdjacent tid); assumption|].
          destruct (To y) as [f ->]; [apply (CornersAdjacent tid); assumption|].
          destruct (LocalZeroEdge before warping tid a b _ _ z E Ia Ib Ix Iy D L)
            as [(P & Q & ->)|(P & Q & ->)]; [exists e, f|exists f, e];
            repeat (split; [assumption|]); auto.
          split; [|auto]. apply FourApart. auto 8. }
        exists (e, f). split; [reflexivity|]. apply InEnds.
        pose proof (proj1 (FourApart _ _ _ _) De) as (_ & Ae & Af & Be & Bf & Ef).
        split; [apply (CornersAdjacent tid); assumption|].
        split; [apply (CornersAdjacent tid); assumption|].
        split; [apply (CornersAdjacent tid); assumption|].
        split; [exact Pe|]. split; [exact Pf|]. intros Zf e' Be' Fe' Pe'.
        unfold CrossingAt in T. rewrite Zf in T.
        destruct (SurfaceOfZeros before warping _ _ _ T)
          as (_ & _ & _ & _ & _ & _ & _ & x0 & _ & _ & _ & O).
        apply (OffsetsDiffer e' e a). transitivity x0; [|symmetry]; apply O.
        + repeat split; try assumption. exists e'. reflexivity.
        + repeat split; try exact Pe.
          * exists e. reflexivity.
          * apply (CornersAdjacent tid); assumption.
          * apply AdjacentMutual. apply (CornersAdjacent tid); assumption.
      - intros ([e f] & <- & I). apply InEnds in I.
        destruct I as (Be & Bf & Ef & Pe & Pf & O). unfold third. cbn [fst snd].
        destruct (CliqueIsTet a b (at_ e) (at_ f)) as (tid & E & G); try assumption;
          try (eexists; reflexivity).
        assert (De : NoDup [a; b; at_ e; at_ f]).
        { assert (Na : forall g, a <> at_ g)
            by (intros g K; apply (NeverAdjacent a); exists g; exact K).
          assert (Nb : forall g, Adjacent b (at_ g) -> b <> at_ g)
            by (intros g K K'; rewrite <- K' in K; exact (NeverAdjacent b K)).
          assert (Nef : at_ e <> at_ f) by congruence.
          apply FourApart. auto 8. }
        pose proof (proj1 (FourApart _ _ _ _) De) as (_ & Ae & Af & Be' & Bf' & Ef').
        assert (GI : In a (Corners tid) /\ In b (Corners tid) /\
          In (at_ e) (Corners tid) /\ In (at_ f) (Corners tid))
          by (repeat split; apply G; cbn; tauto).
        destruct GI as (Ga & Gb & Ge & Gf).
        destruct (after (at_ f)) eqn:Sf; [congruence| |].
        + unfold CrossingAt. rewrite Sf.
          apply (ZerosOnSurface before warping tid a b (at_ f) (at_ e)); try assumption;
            auto.
          * intros v. cbn [In]. intros [<-|[<-|[<-|[<-|[]]]]]; assumption.
          * intros x (Ax & Bx & Fx & Px). destruct (To x Ax) as [e' ->].
            rewrite (O eq_refl e' Bx Fx Px). reflexivity.
        + assert (L : triangle tid (Corner a) (CrossingAt after (at_ e) (at_ f)) (Corner b)).
          { replace (Corner b) with (CrossingAt after (at_ e) b)
              by (unfold CrossingAt; rewrite ZeroB; reflexivity).
            apply (LocalZeroFan before warping tid a b (at_ e) (at_ f)); try assumption;
              congruence. }
          apply (SurfaceTurned before warping).
          apply (SurfaceInside before warping tid _ _ _ E L).
          unfold CrossingAt. rewrite Sf. intros c C.
          assert (K : In c [a; b; at_ e; at_ f]).
          { revert c C. apply CornersAre; [exact De|reflexivity|exact G]. }
          cbn [In] in K. destruct K as [<-|[<-|[<-|[<-|[]]]]];
            [exists (Corner a)|exists (Corner b)|exists (Cut (at_ e) (at_ f))
            |exists (Cut (at_ e) (at_ f))]; cbn; tauto.
    Qed.

    Lemma ThirdsOnce : NoDup (map third ends).
    Proof.
      assert (N : NoDup ends) by (apply NoDup_filter, NoDup_filter, RingPairsOnce).
      assert (Inj : forall p q, In p ends -> In q ends -> third p = third q -> p = q).
      { intros [e f] [e' f'] I J Eq. unfold third in Eq. cbn [fst snd] in Eq.
        apply InEnds in I, J. destruct I as (_ & _ & _ & _ & Pf & O).
        destruct J as (Be' & _ & Ef' & Pe' & Pf' & _). unfold CrossingAt in Eq.
        destruct (after (at_ f)) eqn:Sf; [congruence| |];
          destruct (after (at_ f')) eqn:Sf'; try congruence; try discriminate Eq.
        - injection Eq as Eq. apply OffsetsDiffer in Eq. subst f'. f_equal. symmetry.
          apply O; auto using AdjacentMutual.
        - injection Eq as E1 E2. apply OffsetsDiffer in E1, E2. congruence. }
      revert N Inj. generalize ends as l. induction l as [|p l IH]; intros N Inj;
        [constructor|]. apply NoDup_cons_iff in N. destruct N as [Np N].
      cbn [map]. constructor.
      - intros I. apply in_map_iff in I. destruct I as (q & Eq & I).
        apply Np. rewrite (Inj p q); cbn [In]; auto.
      - apply IH; [exact N|]. intros q r Q R. apply Inj; cbn [In]; auto.
    Qed.
  End Zeros.

  (** ** Every edge *)

  Theorem BoundaryClosed x y z : surface x y z ->
    exists thirds, NoDup thirds /\ (forall w, In w thirds <-> surface x y w) /\
      Nat.Even (length thirds).
  Proof.
    intros T.
    assert (Two : (exists z', z' <> z /\ surface x y z' /\
        forall z'', surface x y z'' -> z'' = z \/ z'' = z') ->
      exists thirds, NoDup thirds /\ (forall w, In w thirds <-> surface x y w) /\
        Nat.Even (length thirds)).
    { intros (z' & N & T' & U). exists [z; z'].
      split; [repeat constructor; cbn [In]; intros K; intuition|].
      split; [|exists 1%nat; reflexivity]. intros w. cbn [In]. split.
      - intros [<-|[<-|[]]]; assumption.
      - intros W. destruct (U w W); auto. }
    destruct x as [a|a m]; [destruct y as [b|b m]|];
      try (apply Two, (CutEdge _ _ z T); intros ? ? E F; discriminate E || discriminate F).
    clear Two. destruct (SurfaceWhere before warping _ _ z T) as (tid & E & L).
    destruct (LocalOnIt before warping tid _ _ z E L) as ([[Ia _] Sa] & [[Ib _] Sb] & _).
    assert (Nab : a <> b) by (destruct L as [(t & _ & (_ & H & _)) _]; congruence).
    destruct (CornersAdjacent tid a b Ia Ib Nab) as [d ->].
    eexists. split; [exact (ThirdsOnce a d Sa Sb)|]. split.
    - intros w.
      pose proof (ZeroThird a d (ex_intro _ tid (conj E Ia)) Sa Sb w). tauto.
    - rewrite map_length. apply BoundaryEven.
  Qed.

  Theorem EdgesInTwo x y z : DisksAround after -> surface x y z ->
    exists z', z' <> z /\ surface x y z' /\
      forall z'', surface x y z'' -> z'' = z \/ z'' = z'.
  Proof.
    intros Disks T.
    destruct x as [a|a m]; [destruct y as [b|b m]|];
      try (apply (CutEdge _ _ z T); intros ? ? E F; discriminate E || discriminate F).
    destruct (SurfaceWhere before warping _ _ z T) as (tid & E & L).
    destruct (LocalOnIt before warping tid _ _ z E L) as ([[Ia _] Sa] & [[Ib _] Sb] & _).
    assert (Nab : a <> b) by (destruct L as [(t & _ & (_ & H & _)) _]; congruence).
    destruct (CornersAdjacent tid a b Ia Ib Nab) as [d ->].
    assert (La : LatticePoint a) by (exists tid; auto).
    pose proof (fun w => ZeroThird a d La Sa Sb w) as Th.
    pose proof (ThirdsOnce a d Sa Sb) as N. pose proof (proj1 (Th z) T) as I.
    set (now := fun e => after (Translate a (Offset e))) in *.
    assert (Short : (length (Boundary now (RingPairs d)) <= 2)%nat).
    { apply GoodRingBounds. apply in_map_iff in I. destruct I as ([e f] & _ & I).
      apply InEnds in I. destruct I as (_ & _ & _ & P & _).
      pose proof (Disks a Sa (ex_intro _ e P)) as D.
      change (StrictDisk now = true) in D.
      unfold StrictDisk in D. apply andb_prop in D. destruct D as [_ D].
      rewrite forallb_forall in D. specialize (D d (InAllDirections d)).
      apply orb_prop in D. destruct D as [D|D].
      - unfold IsZero in D. unfold now in D. unfold SignAfter in D. rewrite Sb in D. discriminate D.
      - apply andb_prop in D. apply D. }
    pose proof (BoundaryEven now d) as Ev.
    rewrite <- (map_length (fun pair => CrossingAt after
      (Translate a (Offset (fst pair))) (Translate a (Offset (snd pair))))) in Short, Ev.
    destruct (map _ (Boundary now (RingPairs d))) as [|u [|v [|? ?]]].
    - destruct I.
    - destruct Ev as [k K]. cbn [length] in K. lia.
    - cbn [In] in Th, I. apply NoDup_cons_iff in N. cbn [In] in N.
      destruct I as [<-|[<-|[]]].
      + exists v. split; [intros ->; tauto|]. split; [apply Th; auto|].
        intros w W. apply Th in W. intuition.
      + exists u. split; [intros ->; tauto|]. split; [apply Th; auto|].
        intros w W. apply Th in W. intuition.
    - cbn [length] in Short. lia.
  Qed.
End Mesh.
