(** * The triangles at a vertex of the surface are one fan

    At a cut by the ring around its edge, whatever the signs.  At a 0 corner by
    its strict disk: what parts + from the rest is in one piece, and each of its
    edges is met by the surface in one vertex. *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Angles.Cases.Isometry Embedding.LeavingProof
  Embedding.LinkProof Topology.CliqueProof Topology.LocalSurfaceProof
  Topology.SurfaceViewProof
  Topology.SurfaceProof Topology.CornersProof Topology.SeparationProof
  Topology.MeshSurfaceSpec.

Lemma RingsWhole : forallb (fun d => OnePiece (NextInLink d)) AllDirections = true.
Proof. vm_compute. reflexivity. Qed.

Section Mesh.
  Variable mesh : SurfaceMesh.
  Local Notation after := (SignAfter (signs_before mesh) (warping_of mesh)).
  Local Notation triangle := (LocalTriangle mesh).
  Local Notation surface := (SurfaceOf (made mesh)).
  Local Notation fan := (FanOf (made mesh)).
  Local Notation joined := (JoinedInFanOf (made mesh)).

  (** A triangle with a cut lies inside a structured tetrahedron. *)
  Lemma SurfaceIfCut tid x y z a m : InLattice tid -> triangle tid x y z ->
    In (Cut a m) [x; y; z] -> surface x y z.
  Proof.
    intros E T I. apply (SurfaceInside mesh tid); [exact E|exact T|].
    pose proof T as [(t & J & H) _].
    destruct (LocalOnIt mesh tid x y z E T) as (X & Y & Z).
    destruct (LocalShape mesh tid x y z t J H X Y Z)
      as [_ [R|(b & c & d & _ & -> & -> & -> & _)]]; [exact R|].
    cbn [In] in I. destruct I as [I|[I|[I|[]]]]; discriminate I.
  Qed.

  Lemma SurfaceFans a x y : surface a x y -> fan a x /\ fan a y.
  Proof.
    intros T. split; [exists y; exact T|].
    exists x. apply (SurfaceTurned mesh), T.
  Qed.

  Lemma SurfaceBack a x y : surface a x y -> surface a y x.
  Proof. apply (SurfaceTurned mesh). Qed.

  Lemma JoinedBySurface a x y : surface a x y -> joined a x y.
  Proof.
    intros T. apply JoinedNext; [apply (SurfaceFans a x y T)|exact T|].
    apply (SurfaceFans a x y T).
  Qed.

  (** ** A cut *)

  Section CutVertex.
    Variables (p m : Coord3).
    Let s := Cut p m.
    Let third := ThirdAt after p m.

    Lemma CutTriangle tid x y : InLattice tid -> triangle tid s x y -> surface s x y.
    Proof. intros E T. apply (SurfaceIfCut tid s x y p m E T). left. reflexivity. Qed.

    Hypothesis P : after p = Plus.
    Hypothesis M : after m = Minus.

    Lemma CutLocal tid c d : InLattice tid -> incl [p; m; c; d] (Corners tid) ->
      NoDup [p; m; c; d] ->
      joined s (third c) (third d) /\
      forall x y, triangle tid s x y -> joined s (third c) x.
    Proof.
      intros E I N.
      destruct (LocalCutFan mesh tid p m c d E) as [T U];
        try assumption; try (apply I; cbn; tauto).
      fold s in T, U. fold (third c) (third d) in T, U.
      assert (J : joined s (third c) (third d)).
      { destruct T as [T|(w & T & W)].
        - apply JoinedBySurface, (CutTriangle tid _ _ E T).
        - apply (JoinedThen _ _ _ _ w); apply JoinedBySurface;
            [exact (CutTriangle tid _ _ E T)|exact (CutTriangle tid _ _ E W)]. }
      split; [exact J|]. intros x y K. destruct (U x y K) as [->|[->|L]].
      - constructor. apply JoinedInside in J. apply J.
      - exact J.
      - apply JoinedBySurface, (CutTriangle tid _ _ E L).
    Qed.

    Lemma FanMutual v x y : joined v x y -> joined v y x.
    Proof. apply JoinedBack. intros u w. apply SurfaceBack. Qed.

    Theorem CutFan x y : fan s x -> fan s y -> joined s x y.
    Proof.
      assert (Found : forall x, fan s x -> exists c, LatticePoint p /\ Adjacent p m /\
        Adjacent p c /\ Adjacent m c /\ joined s (third c) x).
      { intros w [w' T]. destruct (SurfaceWhere mesh _ _ _ T) as (tid & E & L).
        destruct (LocalOnIt mesh tid _ _ _ E L) as ([(Ip & Im & _) _] & _ & _).
        assert (Npm : p <> m) by (apply (SignsDiffer mesh); congruence).
        destruct (OtherTwo tid p m Ip Im Npm) as (c & d & N & Ic & Id).
        assert (I : incl [p; m; c; d] (Corners tid)).
        { intros v. cbn [In]. intros [<-|[<-|[<-|[<-|[]]]]]; assumption. }
        exists c. split; [exists tid; auto|].
        pose proof (proj1 (FourApart _ _ _ _) N) as (_ & Pc & _ & Mc & _).
        split; [apply (CornersAdjacent tid); assumption|].
        split; [apply (CornersAdjacent tid); assumption|].
        split; [apply (CornersAdjacent tid); assumption|].
        exact (proj2 (CutLocal tid c d E I N) w w' L). }
      intros X Y. destruct (Found x X) as (c & Lp & Pm & Pc & Mc & Jc).
      destruct (Found y Y) as (d & _ & _ & Pd & Md & Jd).
      enough (R : joined s (third c) (third d)).
      { apply (JoinedThen _ _ _ x (third c)); [apply FanMutual, Jc|].
        exact (JoinedThen _ _ _ _ _ _ R Jd). }
      destruct Pm as [dm Em], Pc as [dc Ec], Pd as [dd Ed].
      pose proof RingsWhole as R. rewrite forallb_forall in R.
      specialize (R dm (InAllDirections dm)).
      assert (On : forall e, NextInLink dm e = true <-> Adjacent m (Translate p (Offset e))).
      { intros e. rewrite (NextInLinkMeans p), <- Em. tauto. }
      assert (Apart : forall e, Adjacent m (Translate p (Offset e)) ->
        p <> Translate p (Offset e) /\ m <> Translate p (Offset e)).
      { intros e A. split; intros K; [apply (NeverAdjacent p); exists e; exact K|].
        rewrite <- K in A. exact (NeverAdjacent m A). }
      rewrite Ec, Ed. rewrite Ec in Mc. rewrite Ed in Md. apply On in Mc, Md.
      clear Jc Jd Ec Ed. revert dc dd Mc Md.
      refine (proj2 (OnePieceWalk (NextInLink dm) (fun e f =>
        joined s (third (Translate p (Offset e))) (third (Translate p (Offset f)))) R _ _)).
      - intros e Ne.
        apply On in Ne. destruct (ApexesOfFace p m (Translate p (Offset e)))
          as (a & b & _ & (Pa & Ma & Ea) & _ & _);
          [exists dm; exact Em|exists e; reflexivity|exact Ne|].
        destruct (CliqueIsTet p m (Translate p (Offset e)) a) as (tid & E & I);
          try assumption; [exists dm; exact Em|exists e; reflexivity|].
        destruct (Apart e Ne) as [Npe Nme].
        assert (N : NoDup [p; m; Translate p (Offset e); a]).
        { apply FourApart. repeat split; try assumption; intros K; subst.
          - exact (NeverAdjacent _ (ex_intro _ dm K)).
          - exact (NeverAdjacent _ Pa).
          - exact (NeverAdjacent _ Ma).
          - exact (NeverAdjacent _ Ea). }
        destruct (CutLocal tid _ _ E I N) as [J _]. constructor.
        apply JoinedInside in J. apply J.
      - intros e f g Ne Nf Ng K Fg. apply (JoinedThen _ _ _ _ _ _ K).
        apply On in Nf, Ng. apply (NextInLinkMeans p) in Fg.
        destruct (CliqueIsTet p m (Translate p (Offset f)) (Translate p (Offset g)))
          as (tid & E & I); try assumption;
          [exists dm; exact Em|exists f; reflexivity|exists g; reflexivity|].
        apply (CutLocal tid _ _ E I). destruct (Apart f Nf), (Apart g Ng).
        apply FourApart. repeat split; try assumption; intros Q.
        + exact (NeverAdjacent p (ex_intro _ dm (eq_trans Q Em))).
        + rewrite Q in Fg. exact (NeverAdjacent _ Fg).
    Qed.
  End CutVertex.

  (** ** A 0 corner *)

  Section ZeroVertex.
    Variable z : Coord3.
    Local Notation at_ e := (Translate z (Offset e)).
    Let now (e : Direction) : Sign := after (at_ e).
    Let meets (pair : Direction * Direction) : MeshVertex :=
      CrossingAt after (at_ (fst pair)) (at_ (snd pair)).
    Let crossings := AllCrossings (IsInner now).

    Hypothesis Zero : after z = OnSurface.
    Hypothesis OfLattice : LatticePoint z.
    Hypothesis Disk : StrictDisk now = true.

    Lemma InCrossings e f : In (e, f) crossings <->
      Adjacent (at_ e) (at_ f) /\ after (at_ e) = Plus /\ after (at_ f) <> Plus.
    Proof.
      unfold crossings. rewrite InAllCrossings, (NextInLinkMeans z). unfold IsInner, now.
      destruct (after (at_ e)), (after (at_ f)); intuition congruence.
    Qed.

    Lemma DiskHasNoWall f g e e' : after (at_ f) = OnSurface -> after (at_ g) = OnSurface ->
      Adjacent (at_ f) (at_ g) -> Adjacent (at_ f) (at_ e) -> Adjacent (at_ g) (at_ e) ->
      Adjacent (at_ f) (at_ e') -> Adjacent (at_ g) (at_ e') ->
      after (at_ e) = Plus -> after (at_ e') = Plus -> e = e'.
    Proof.
      intros F G Fg Fe Ge Fe' Ge' P P'. pose proof Disk as D.
      unfold StrictDisk in D. apply andb_prop in D. destruct D as [_ D].
      rewrite forallb_forall in D. specialize (D f (InAllDirections f)).
      assert (Zf : IsZero now f = true) by (unfold IsZero, now; rewrite F; reflexivity).
      assert (Zg : IsZero now g = true) by (unfold IsZero, now; rewrite G; reflexivity).
      rewrite Zf in D. cbn [negb orb] in D. apply andb_prop in D. destruct D as [_ D].
      rewrite forallb_forall in D. specialize (D g (InAllDirections g)).
      apply (NextInLinkMeans z) in Fg, Fe, Ge, Fe', Ge'.
      rewrite Zg, Fg in D. cbn [negb orb andb] in D. unfold NoWallBetween in D.
      rewrite forallb_forall in D. specialize (D e (InAllDirections e)).
      rewrite forallb_forall in D. specialize (D e' (InAllDirections e')).
      unfold IsInner, now in D. rewrite P, P', Fe, Ge, Fe', Ge' in D.
      cbn [negb orb andb] in D. apply SameDirectionMeans, D.
    Qed.

    Lemma PointsApart e f w : Adjacent (at_ e) (at_ f) -> Adjacent (at_ e) (at_ w) ->
      Adjacent (at_ f) (at_ w) ->
      exists tid, InLattice tid /\ incl [z; at_ w; at_ e; at_ f] (Corners tid) /\
        NoDup [z; at_ w; at_ e; at_ f].
    Proof.
      intros Ef Ew Fw.
      destruct (CliqueIsTet z (at_ w) (at_ e) (at_ f)) as (tid & E & I);
        try (eexists; reflexivity); auto using AdjacentMutual.
      exists tid. split; [exact E|]. split; [exact I|].
      assert (Nz : forall g, z <> at_ g)
        by (intros g K; apply (NeverAdjacent z); exists g; exact K).
      assert (Na : forall u v, Adjacent u v -> u <> v)
        by (intros u v A ->; exact (NeverAdjacent v A)).
      apply FourApart. repeat split; auto using AdjacentMutual.
    Qed.

    Lemma FanStep p q : In p crossings -> In q crossings -> Turns p q = true ->
      meets p = meets q \/ surface (Corner z) (meets p) (meets q).
    Proof.
      destruct p as [e f], q as [e' f']. intros P Q T.
      apply InCrossings in P, Q. destruct P as (Ef & Pe & Pf), Q as (Ef' & Pe' & Pf').
      unfold meets. cbn [fst snd]. unfold Turns in T. apply orb_prop in T.
      destruct T as [T|T]; apply andb_prop in T; destruct T as [S N];
        apply SameDirectionMeans in S; subst; apply (NextInLinkMeans z) in N.
      - (* from + to + *)
        destruct (PointsApart e f' e' Ef N (AdjacentMutual _ _ Ef')) as (tid & E & I & D).
        destruct (after (at_ f')) eqn:S;
          [congruence|left; unfold CrossingAt; rewrite S; reflexivity|].
        destruct (LocalZeroFan mesh tid z (at_ e') (at_ e) (at_ f')) as [G _];
          try assumption; try (apply I; cbn; tauto); [congruence|].
        destruct (G Pe') as [G'|G']; [left; exact G'|right].
        apply (SurfaceIfCut tid _ _ _ (at_ e) (at_ f') E G').
        unfold CrossingAt. rewrite S. cbn. tauto.
      - (* from outer to outer *)
        rename f' into g. rename e' into e. right.
        destruct (PointsApart e f g Ef Ef' N) as (tid & E & I & D).
        destruct (LocalZeroFan mesh tid z (at_ g) (at_ e) (at_ f)) as [_ G];
          try assumption; try (apply I; cbn; tauto).
        specialize (G Pf').
        destruct (after (at_ f)) eqn:S; [congruence| |].
        + destruct (after (at_ g)) eqn:S'; [congruence| |].
          * unfold CrossingAt in *. rewrite S, S' in *.
            pose proof (proj1 (FourApart _ _ _ _) D) as (Zg & Ze & Zf & Ge & Gf & Ef_).
            apply (ZerosOnSurface mesh tid z (at_ f) (at_ g) (at_ e)); try assumption.
            -- intros v V. apply I. cbn [In] in *. tauto.
            -- auto.
            -- intros x ([h ->] & Fh & Gh & Ph). f_equal. f_equal. symmetry.
               apply (DiskHasNoWall f g); auto using AdjacentMutual.
          * apply (SurfaceIfCut tid _ _ _ (at_ e) (at_ g) E G).
            unfold CrossingAt. rewrite S'. cbn. tauto.
        + apply (SurfaceIfCut tid _ _ _ (at_ e) (at_ f) E G).
          unfold CrossingAt. rewrite S. cbn. tauto.
    Qed.

    Lemma FanMeets x : fan (Corner z) x -> exists p, In p crossings /\ x = meets p.
    Proof.
      intros [y T]. destruct (SurfaceWhere mesh _ _ _ T) as (tid & E & L).
      destruct (LocalOnIt mesh tid _ _ _ E L) as ([[Iz _] _] & _ & _).
      destruct (LocalZeroEnds mesh tid z x y E L)
        as (e & f & Ie & If & Nf & Pe & Pf & ->).
      destruct (CornersAdjacent tid z e Iz Ie) as [d ->];
        [apply (SignsDiffer mesh); congruence|].
      destruct (CornersAdjacent tid z f Iz If) as [g ->]; [congruence|].
      exists (d, g). split; [|reflexivity]. apply InCrossings.
      split; [|auto]. apply (CornersAdjacent tid); try assumption.
      apply (SignsDiffer mesh). congruence.
    Qed.

    Theorem ZeroFan x y : fan (Corner z) x -> fan (Corner z) y ->
      joined (Corner z) x y.
    Proof.
      intros X Y. destruct (FanMeets x X) as (p & P & Ex), (FanMeets y Y) as (q & Q & Ey).
      pose proof Disk as D. unfold StrictDisk in D. apply andb_prop in D. destruct D as [D _].
      apply andb_prop in D. destruct D as [Di Do].
      pose proof (CrossingsJoined (IsInner now) Di Do p q P Q) as J. fold crossings in J.
      subst x y. clear Y. revert X. induction J as [p I|p q r J IH T R]; intros X.
      - constructor. exact X.
      - pose proof (JoinedInside _ _ _ _ _ J) as [P' Q'].
        specialize (IH P Q' X).
        destruct (FanStep q r Q' R T) as [S|S]; [rewrite <- S; exact IH|].
        apply (JoinedThen _ _ _ _ _ _ IH). apply JoinedBySurface, S.
    Qed.
  End ZeroVertex.

  Theorem OneFan a x y : DisksAround after -> fan a x -> fan a y -> joined a x y.
  Proof.
    intros Disks X Y. destruct X as [x' T].
    destruct (SurfaceWhere mesh _ _ _ T) as (tid & E & L).
    destruct (LocalOnIt mesh tid _ _ _ E L) as (A & _ & _).
    destruct a as [z|p m].
    - destruct A as [[Iz _] Sz].
      destruct (LocalZeroEnds mesh tid z x x' E L)
        as (e & _ & Ie & _ & _ & Pe & _).
      apply ZeroFan; [exact Sz|exists tid; auto| |exists x'; exact T|exact Y].
      apply Disks; [exact Sz|].
      destruct (CornersAdjacent tid z e Iz Ie) as [d ->];
        [apply (SignsDiffer mesh); unfold SignAfter in *; congruence|].
      exists d. exact Pe.
    - destruct A as [(_ & _ & P & M) _].
      apply CutFan; [exact P|exact M|exists x'; exact T|exact Y].
  Qed.
End Mesh.
