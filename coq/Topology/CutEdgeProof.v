(** * How many triangles of the surface an edge at a cut is in

    It lies in a face of the lattice, and each side of the face has one triangle
    there; or it leads across a structured tetrahedron, which has two. *)

From Coq Require Import Arith.
From Coq Require Logic.FinFun.
From Certet Require Import Topology.Definitions.
From Certet Require Import Embedding.EdgeRank Embedding.GreedyProof
  Embedding.MeshApartProof Embedding.LinkProof Topology.CliqueProof
  Topology.CornersProof Topology.LocalSurfaceProof
  Topology.SurfaceViewProof Topology.SurfaceProof.
From Certet Require Import Topology.MeshSurfaceSpec.

Section Mesh.
  Variable mesh : SurfaceMesh.
  Local Notation within := (made_within mesh).
  Local Notation on_it := (OnIt mesh).
  Local Notation triangle := (LocalTriangle mesh).
  Local Notation surface := (SurfaceOf (made mesh)).

  (** ** Across the inside *)

  Lemma InnerEdge x y z tid : InLattice tid -> triangle tid x y z ->
    Reach (Corners tid) [x; y] ->
    (forall a b, x = Corner a -> y = Corner b -> False) ->
    exists z', z' <> z /\ surface x y z' /\
      forall z'', surface x y z'' -> z'' = z \/ z'' = z'.
  Proof.
    intros E T R B.
    destruct (LocalInnerEdge mesh tid x y z E R B T) as (z' & N & T' & U).
    assert (R' : forall w, Reach (Corners tid) [x; y; w]).
    { intros w c C. destruct (R c C) as (v & V & I). exists v. cbn [In] in *. tauto. }
    exists z'. split; [exact N|].
    split; [apply (SurfaceInside mesh tid); auto|].
    intros z'' W. destruct (SurfaceWhere mesh x y z'' W) as (tid' & E' & L).
    assert (tid = tid').
    { destruct (LocalOnIt mesh tid' x y z'' E' L) as (X & Y & _).
      apply (ReachDetermines mesh tid tid' [x; y]); try assumption.
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
      - destruct V as [[Ib _] Sb]. fold (SignAfter (signs_before mesh) (warping_of mesh) b) in Sb.
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
    destruct (LocalOnIt mesh tid x y z E T) as (X & Y & Z).
    assert (N : x <> y) by (destruct T as [(t & _ & H) _]; apply H).
    destruct (FaceEnds tid x y c X Y N B I Off) as (f1 & f2 & f3 & D & M).
    assert (In_ : forall own, on_it own x -> on_it own y ->
      incl [f1; f2; f3] (Corners own)).
    { intros own Ox Oy e Ie. apply M, in_app_iff in Ie.
      destruct Ie as [Ie|Ie]; [exact (EndsWithin _ own x e Ox Ie)
        |exact (EndsWithin _ own y e Oy Ie)]. }
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
    destruct (LocalFaceEdge mesh tid x y E X Y N) as (z0 & T0 & U0);
      [apply (Off' tid c); [exact F|exact I|exact Nc]|exact B|].
    destruct (LocalFaceEdge mesh tid' x y E' X' Y' N) as (z' & T' & U');
      [apply (Off' tid' c'); [exact F3|apply F'; cbn; tauto|apply Fresh, Ac']|exact B|].
    assert (z0 = z) by (symmetry; apply U0, T). subst z0.
    assert (Rz : forall own w, InLattice own -> triangle own x y w ->
      Reach (Corners own) [x; y; w]).
    { intros own w Eo [(t & J & H) S].
      destruct (LocalOnIt mesh own x y w Eo
        (conj (ex_intro _ t (conj J H)) S)) as (Xo & Yo & Wo).
      destruct (LocalShape mesh own x y w t J H Xo Yo Wo)
        as [_ [R|(a & b & _ & _ & Ea & Eb & _)]]; [exact R|].
      destruct (B a b Ea Eb). }
    exists z'. split.
    { intros ->. destruct (Rz tid z E T c I) as (v & V & W).
      destruct (LocalOnIt mesh tid' x y z E' T') as (_ & _ & Z').
      cbn [In] in V. destruct V as [<-|[<-|[<-|[]]]];
        [apply (Off x); cbn; auto|apply (Off y); cbn; auto|].
      pose proof (EndsWithin mesh tid' z c Z' W) as K.
      assert (G : incl (Corners tid') [f1; f2; f3; c']).
      { apply CornersAre; [|reflexivity|exact F'].
        pose proof (Fresh c' Ac') as Fr. cbn [In] in Fr.
        apply FourApart. repeat split; try assumption; intros ->; tauto. }
      destruct (G c K) as [Q|[Q|[Q|[Q|[]]]]]; congruence. }
    split; [apply (SurfaceInside mesh tid'); auto|].
    intros z'' W. destruct (SurfaceWhere mesh x y z'' W) as (own & Eo & L).
    destruct (LocalOnIt mesh own x y z'' Eo L) as (Xo & Yo & _).
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
    intros T B. destruct (SurfaceWhere mesh x y z T) as (tid & E & L).
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
End Mesh.
