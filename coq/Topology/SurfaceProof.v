(** * Which triangles are on the surface

    Those with three vertices on the surface that lie inside a structured
    tetrahedron, and the faces of the lattice with three 0 corners that have + on
    exactly one side. *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Stuffing.MeshProof Embedding.MeshApartProof
  Embedding.AroundProof Topology.CliqueProof Topology.LocalSurfaceProof
  Topology.SurfaceViewProof Topology.MeshSurfaceSpec.

Section Local.
  Variable mesh : SurfaceMesh.
  Local Notation within := (made_within mesh).
  Local Notation after := (SignAfter (signs_before mesh) (warping_of mesh)).
  Local Notation placed := (PlacedSign (signs_before mesh) (warping_of mesh)).
  Local Notation on_it := (OnIt mesh).
  Local Notation triangle := (LocalTriangle mesh).
  Local Notation surface := (SurfaceOf (made mesh)).

  Lemma EndsWithin tid x c : on_it tid x -> In c (Ends x) -> In c (Corners tid).
  Proof. intros [B _]. exact (EndsBelong _ _ x c B). Qed.

  (** What lies inside determines its structured tetrahedron. *)
  Lemma ReachDetermines tid tid' vs : InLattice tid -> InLattice tid' ->
    Reach (Corners tid) vs -> (forall v, In v vs -> on_it tid' v) -> tid = tid'.
  Proof.
    intros E E' R O. apply CornersDetermine; [assumption..|]. intros c I.
    destruct (R c I) as (v & V & C). exact (EndsWithin tid' v c (O v V) C).
  Qed.

  Lemma SurfaceInside tid x y z : InLattice tid -> triangle tid x y z ->
    Reach (Corners tid) [x; y; z] -> surface x y z.
  Proof.
    intros E T R. pose proof T as [(t & I & H) S].
    destruct (LocalOnIt mesh tid x y z E T) as (X & Y & Z).
    exists t. split; [exists tid; auto|]. split; [exact H|].
    intros u (tid' & E' & J) K.
    assert (T' : triangle tid' x y z) by (split; [exists u; auto|exact S]).
    destruct (LocalOnIt mesh tid' x y z E' T') as (X' & Y' & Z').
    assert (tid = tid').
    { apply (ReachDetermines tid tid' [x; y; z]); try assumption.
      intros v. cbn [In]. intros [<-|[<-|[<-|[]]]]; assumption. }
    subst tid'. exact (proj1 (LocalShape mesh tid x y z t I H X Y Z) u J K).
  Qed.

  Lemma SurfaceZero x y z : surface x y z ->
    placed x = OnSurface /\ placed y = OnSurface /\ placed z = OnSurface.
  Proof.
    intros (t & (tid & E & I) & H & U).
    destruct (surface_boundary mesh tid t x y z I H) as [Z|(u & N & K & J)];
      [exact Z|]. exfalso. apply N, U; [|exact K].
    destruct J as [J|[i J]]; [exists tid|exists (NeighborOf tid i)];
      (split; [assumption || apply NeighborOfLattice, E|exact J]).
  Qed.

  Lemma SurfaceWhere x y z : surface x y z ->
    exists tid, InLattice tid /\ triangle tid x y z.
  Proof.
    intros T. pose proof (SurfaceZero x y z T) as S.
    destruct T as (t & (tid & E & I) & H & _). exists tid. split; [exact E|].
    split; [exists t; auto|exact S].
  Qed.

  Lemma SurfaceTurned x y z : surface x y z -> surface y x z /\ surface x z y.
  Proof.
    intros (t & I & H & U). unfold SurfaceOf, HasTriangle in *.
    split; exists t; (split; [exact I|]); (split; [intuition congruence|]);
      intros u J K; apply U; intuition congruence.
  Qed.

  (** ** Three 0 corners *)

  (** [e] is the + on one side of the face. *)
  Definition Above (a b c e : Coord3) : Prop :=
    Adjacent a e /\ Adjacent b e /\ Adjacent c e /\ after e = Plus.

  Lemma ThreeCannotReach tid a b c : ~ Reach (Corners tid) [Corner a; Corner b; Corner c].
  Proof.
    intros R. pose proof (CornersNoDup tid) as N.
    assert (I : incl (Corners tid) [a; b; c]).
    { intros x X. destruct (R x X) as (v & V & W). cbn [In] in *.
      destruct V as [<-|[<-|[<-|[]]]]; cbn [Ends In] in W; intuition. }
    apply (NoDup_incl_length N) in I. unfold Corners in I.
    destruct (GetStructuredTet tid). cbn in I. lia.
  Qed.

  Lemma AboveInLattice tid a b c e : In a (Corners tid) -> InLattice tid ->
    Adjacent a b -> Adjacent a c -> Adjacent b c -> Above a b c e ->
    exists tid', InLattice tid' /\ incl [a; b; c; e] (Corners tid').
  Proof.
    intros I E Ab Ac Bc (Ae & Be & Ce & _).
    apply CliqueIsTet; try assumption. exists tid. auto.
  Qed.

  Lemma SignsDiffer a e : after a <> after e -> a <> e.
  Proof. intros N ->. apply N. reflexivity. Qed.

  Lemma AboveDistinct a b c e : a <> b -> a <> c -> b <> c ->
    after a = OnSurface -> after b = OnSurface -> after c = OnSurface ->
    after e = Plus -> NoDup [a; b; c; e].
  Proof.
    intros Ab Ac Bc A B C E. repeat constructor; cbn [In]; intuition congruence.
  Qed.

  Lemma ZerosMakeTet tid a b c e : InLattice tid -> incl [a; b; c; e] (Corners tid) ->
    a <> b -> a <> c -> b <> c ->
    after a = OnSurface -> after b = OnSurface -> after c = OnSurface ->
    after e = Plus -> triangle tid (Corner a) (Corner b) (Corner c).
  Proof.
    intros E I Ab Ac Bc A B C P. apply (LocalZeros mesh tid a b c e); try assumption;
      try (apply I; cbn; tauto). apply AboveDistinct; assumption.
  Qed.

  Lemma SurfaceOfZeros a b c : surface (Corner a) (Corner b) (Corner c) ->
    a <> b /\ a <> c /\ b <> c /\
    after a = OnSurface /\ after b = OnSurface /\ after c = OnSurface /\
    exists tid e, InLattice tid /\ incl [a; b; c; e] (Corners tid) /\ Above a b c e /\
      forall e', Above a b c e' -> e' = e.
  Proof.
    intros T. pose proof (SurfaceZero _ _ _ T) as (Sa & Sb & Sc).
    pose proof T as (t & (tid & E & I) & H & U).
    assert (L : triangle tid (Corner a) (Corner b) (Corner c))
      by (split; [exists t; auto|auto]).
    destruct (LocalOnIt mesh tid _ _ _ E L) as (X & Y & Z).
    assert (N : a <> b /\ a <> c /\ b <> c) by (destruct H; intuition congruence).
    repeat (split; [tauto || assumption|]). destruct N as (Ab & Ac & Bc).
    destruct (LocalShape mesh tid _ _ _ t I H X Y Z)
      as [_ [R|(a' & b' & c' & e & Ea & Eb & Ec & Ie & Pe & R)]];
      [destruct (ThreeCannotReach tid a b c R)|].
    destruct X as [[Ia _] _], Y as [[Ib _] _], Z as [[Ic _] _].
    assert (Z' : forall v, after v = OnSurface -> v <> e)
      by (intros v V; apply SignsDiffer; congruence).
    exists tid, e. split; [exact E|]. split.
    { intros v. cbn [In]. intros [<-|[<-|[<-|[<-|[]]]]]; assumption. }
    split.
    { repeat split; try exact Pe; apply (CornersAdjacent tid); auto. }
    intros e' Abv. destruct (AboveInLattice tid a b c e' Ia E) as (tid' & E' & I');
      try assumption; try (apply (CornersAdjacent tid); assumption).
    destruct Abv as (_ & _ & _ & Pe').
    destruct (ZerosMakeTet tid' a b c e' E' I' Ab Ac Bc Sa Sb Sc Pe') as [(u & J & K) _].
    assert (u = t) by (apply U; [exists tid'; auto|exact K]). subst u.
    pose proof (OneOwner after tid tid' t E E'
      (fun c => surface_reaches mesh tid t c E I)
      (fun v => surface_belongs mesh tid' t v E' J)).
    subst tid'. assert (In e' (Corners tid)) as W by (apply I'; cbn; tauto).
    destruct (R e' W) as (v & V & In_). cbn [In] in V.
    destruct V as [<-|[<-|[<-|[<-|[]]]]]; cbn [Ends In] in In_;
      destruct In_ as [<-|[]]; unfold SignAfter in *; congruence || reflexivity.
  Qed.

  Lemma ZerosOnSurface tid a b c e : InLattice tid -> incl [a; b; c; e] (Corners tid) ->
    a <> b -> a <> c -> b <> c ->
    after a = OnSurface -> after b = OnSurface -> after c = OnSurface ->
    after e = Plus -> (forall e', Above a b c e' -> e' = e) ->
    surface (Corner a) (Corner b) (Corner c).
  Proof.
    intros E I Ab Ac Bc Sa Sb Sc Pe Only.
    pose proof (ZerosMakeTet tid a b c e E I Ab Ac Bc Sa Sb Sc Pe) as T.
    pose proof T as [(t & J & H) _].
    exists t. split; [exists tid; auto|]. split; [exact H|].
    intros u (tid' & E' & K) G.
    assert (T' : triangle tid' (Corner a) (Corner b) (Corner c))
      by (split; [exists u; auto|auto]).
    destruct (LocalOnIt mesh tid' _ _ _ E' T') as (X' & Y' & Z').
    destruct (LocalShape mesh tid' _ _ _ u K G X' Y' Z')
      as [_ [R|(a' & b' & c' & e' & Ea & Eb & Ec & Ie & Pe' & R)]];
      [destruct (ThreeCannotReach tid' a b c R)|].
    destruct X' as [[Ia _] _], Y' as [[Ib _] _], Z' as [[Ic _] _].
    assert (e' = e).
    { apply Only. repeat split; try exact Pe'; apply (CornersAdjacent tid');
        try assumption; apply SignsDiffer; congruence. }
    subst e'. assert (tid' = tid).
    { apply CornersDetermine; [assumption..|]. intros x Xx.
      destruct (R x Xx) as (v & V & W). apply I. cbn [In] in *.
      destruct V as [<-|[<-|[<-|[<-|[]]]]]; cbn [Ends In] in W; tauto. }
    subst tid'. destruct (LocalOnIt mesh tid _ _ _ E T) as (X & Y & Z).
    exact (proj1 (LocalShape mesh tid _ _ _ t J H X Y Z) u K G).
  Qed.
End Local.
