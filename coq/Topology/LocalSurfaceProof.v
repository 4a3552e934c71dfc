(** * The surface within one structured tetrahedron

    [StencilSurface] looked at all sign patterns on symbols; here vertices and
    triangles of the mesh are seen as symbols.  What then holds of the mesh is in
    [SurfaceViewProof]. *)

From Certet Require Import Topology.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stencil.TriangleChecker
  Stencil.TriangleCheckerProof Stuffing.NameProof Embedding.EdgeRank
  Embedding.MeshApartProof Topology.StencilSurface Topology.StencilSurfaceProof.
From Certet Require Import Mesh.Method.

(** ** What the surface looks at

    Whatever the mesh: each structured tetrahedron has a view on symbols that keeps
    what [CheckSurface] checks, and a triangle that is not on the surface is met
    twice. *)

Record SurfaceMesh := {
  signs_before : SignField;
  warping_of : Coord3 -> Warping;
  made_within : StructuredTetId -> list (UnstructuredTet MeshVertex);
  surface_belongs : forall tid t v, InLattice tid -> In t (made_within tid) ->
    In v (TetCorners t) -> Belongs (SignAfter signs_before warping_of) (Corners tid) v;
  surface_reaches : forall tid t c, InLattice tid -> In t (made_within tid) ->
    In c (Corners tid) -> exists v, In v (TetCorners t) /\ In c (Ends v);
  surface_boundary : forall tid t a b c,
    In t (made_within tid) -> HasTriangle t a b c ->
    let signed v := PlacedSign signs_before warping_of v in
    (signed a = OnSurface /\ signed b = OnSurface /\ signed c = OnSurface) \/
    exists u, u <> t /\ HasTriangle u a b c /\
      (In u (made_within tid) \/ exists i, In u (made_within (NeighborOf tid i)));
  surface_viewed : forall tid, exists h f1 f2 f3 p q sign ts,
    NoDup [f1; f2; f3; p; q] /\ Corners tid = [f1; f2; f3; p] /\
    (forall l, In l Four ->
       SignAfter signs_before warping_of (LocateFive f1 f2 f3 p q l) = sign l) /\
    made_within tid = map (fun s => Orient h (MapTet (Name f1 f2 f3 p q) s)) ts /\
    CheckSurface sign ts = true
}.

Definition made (mesh : SurfaceMesh) : Mesh :=
  MakeMesh (made_within mesh) (PlacedSign (signs_before mesh) (warping_of mesh))
           (PlacedPosition (warping_of mesh) (fun _ _ => MidpointCut)).

(** ** In points *)

(** Where + and other points meet: the cut, or the 0 corner. *)
Definition CrossingAt (after : Coord3 -> Sign) (e f : Coord3) : MeshVertex :=
  match after f with Minus => Cut e f | _ => Corner f end.

(** On the face with the cut from [a] to [m]: the other vertex on the surface. *)
Definition ThirdAt (after : Coord3 -> Sign) (a m c : Coord3) : MeshVertex :=
  match after c with Plus => Cut c m | Minus => Cut a c | OnSurface => Corner c end.

(** Every corner is an end of one of these. *)
Definition Reach (corners : list Coord3) (vs : list MeshVertex) : Prop :=
  forall c, In c corners -> exists v, In v vs /\ In c (Ends v).

Section Mesh.
  Variable mesh : SurfaceMesh.
  Local Notation names := (made_within mesh).
  Local Notation after := (SignAfter (signs_before mesh) (warping_of mesh)).
  Local Notation placed := (PlacedSign (signs_before mesh) (warping_of mesh)).

  (** A vertex of this structured tetrahedron, on the surface. *)
  Definition OnIt (tid : StructuredTetId) (x : MeshVertex) : Prop :=
    Belongs after (Corners tid) x /\ placed x = OnSurface.

  (** A triangle in it, on the surface. *)
  Definition LocalTriangle (tid : StructuredTetId) (x y z : MeshVertex) : Prop :=
    AmongTriangles (names tid) x y z /\
    placed x = OnSurface /\ placed y = OnSurface /\ placed z = OnSurface.

  Lemma LocalOnIt tid x y z : InLattice tid -> LocalTriangle tid x y z ->
    OnIt tid x /\ OnIt tid y /\ OnIt tid z.
  Proof.
    intros E [(t & I & ((X & Y & Z) & _)) S].
    pose proof (fun v => surface_belongs mesh tid t v E I) as F.
    unfold OnIt. repeat split; try apply F; tauto.
  Qed.

  Lemma AmongTurned ts (x y z : MeshVertex) : AmongTriangles ts x y z ->
    AmongTriangles ts y x z /\ AmongTriangles ts x z y.
  Proof.
    intros (t & I & (A & B) & N). unfold AmongTriangles, HasTriangle.
    split; exists t; repeat split; try tauto; intuition congruence.
  Qed.

  Lemma LocalTurned tid x y z : LocalTriangle tid x y z ->
    LocalTriangle tid y x z /\ LocalTriangle tid x z y.
  Proof.
    unfold LocalTriangle. intros [A S]. apply AmongTurned in A. tauto.
  Qed.

  (** ** A view on symbols *)

  Section View.
    Variables (tid : StructuredTetId) (h : Handedness) (f1 f2 f3 p q : Coord3).
    Variable sign : Label -> Sign.
    Variable ts : list SymbolicTet.

    Let name := Name f1 f2 f3 p q.
    Let at_ := LocateFive f1 f2 f3 p q.

    Hypothesis Apart : NoDup [f1; f2; f3; p; q].
    Hypothesis Points : Corners tid = [f1; f2; f3; p].
    Hypothesis Signs : forall l, In l Four -> after (at_ l) = sign l.
    Hypothesis Named : names tid = map (fun s => Orient h (MapTet name s)) ts.

    Lemma AtInjective l m : at_ l = at_ m -> l = m.
    Proof. apply (LocateInjective f1 f2 f3 p q Apart). Qed.

    Lemma AtIn c : In c (Corners tid) <-> exists l, In l Four /\ c = at_ l.
    Proof.
      rewrite Points. change [f1; f2; f3; p] with (map at_ Four). rewrite in_map_iff.
      split; intros (l & A & B); exists l; auto.
    Qed.

    Lemma AtIs s l : In l Four -> Is sign s l = true <-> after (at_ l) = s.
    Proof. intros L. unfold Is. rewrite IsSignEqual, Signs by exact L. tauto. Qed.

    Lemma ValidOn s : In s (Valids sign) -> OnIt tid (name s).
    Proof.
      unfold Valids, OnIt. rewrite filter_In, InAll. intros [A V]. unfold name.
      destruct s as [a|a m]; rewrite ?NameBase, ?NameCut; fold at_.
      - apply (AtIs OnSurface a A) in V. unfold SignAfter in V.
        split; [|exact V]. split; [apply AtIn; eauto|]. unfold SignAfter. congruence.
      - cbn [Valid] in V. apply andb_prop in V. destruct A as [A M], V as [V W].
        apply (AtIs _ _ A) in V. apply (AtIs _ _ M) in W.
        split; [|reflexivity]. repeat split; try apply AtIn; eauto.
    Qed.

    Lemma OnValid x : OnIt tid x -> exists s, In s (Valids sign) /\ x = name s.
    Proof.
      intros [B S]. unfold Valids, name. destruct x as [c|a m]; cbn [Belongs] in B.
      - destruct B as [I _]. apply AtIn in I. destruct I as (l & L & ->).
        exists (Base l). rewrite NameBase, filter_In, InAll. repeat split; auto.
        apply AtIs; assumption.
      - destruct B as (A & M & Sa & Sm). apply AtIn in A, M.
        destruct A as (l & L & ->), M as (k & K & ->).
        exists (CutOf l k). rewrite NameCut, filter_In, InAll. repeat split; auto.
        cbn [Valid]. apply andb_true_intro. split; apply AtIs; assumption.
    Qed.

    Lemma NameDiffers s r : name s = name r <-> s = r.
    Proof.
      split; [apply (NameInjective f1 f2 f3 p q Apart)|intros ->; reflexivity].
    Qed.

    Lemma TriangleNamed s r u : In s (Valids sign) -> In r (Valids sign) ->
      In u (Valids sign) ->
      IsTriangle ts s r u = true <-> LocalTriangle tid (name s) (name r) (name u).
    Proof.
      intros S R U.
      assert (Z : placed (name s) = OnSurface /\ placed (name r) = OnSurface /\
        placed (name u) = OnSurface)
        by (repeat split; apply ValidOn; assumption).
      transitivity (AmongTriangles ts s r u).
      - unfold IsTriangle, AmongTriangles, SomeHas. rewrite andb_true_iff, existsb_exists.
        split.
        + intros [Ds (t & I & H)]. exists t. split; [exact I|].
          unfold Distinct in Ds. rewrite !andb_true_iff, !SameSymbolDiffers in Ds.
          unfold Has in H. rewrite !andb_true_iff, !MemberIn in H.
          unfold HasTriangle. tauto.
        + intros (t & I & H). split.
          * destruct H as [_ H]. unfold Distinct.
            rewrite !andb_true_iff, !SameSymbolDiffers. tauto.
          * exists t. split; [exact I|]. apply (HasHasTriangle t t s r u H), H.
      - unfold LocalTriangle, AmongTriangles. rewrite Named. split.
        + intros (t & I & H). split; [|exact Z].
          exists (Orient h (MapTet name t)). split.
          * apply in_map_iff. exists t. auto.
          * rewrite OrientHasTriangle. apply (HasTriangleName f1 f2 f3 p q Apart), H.
        + intros [(t & I & H) _]. apply in_map_iff in I. destruct I as (t' & <- & I).
          exists t'. split; [exact I|].
          rewrite OrientHasTriangle in H.
          apply (HasTriangleName f1 f2 f3 p q Apart) in H. exact H.
    Qed.

    Lemma TouchesEnds l s : In l Four -> Touches l s = true <-> In (at_ l) (Ends (name s)).
    Proof.
      intros L. unfold name. destruct s as [a|a m]; rewrite ?NameBase, ?NameCut;
        cbn [Touches Ends In]; fold at_; rewrite ?orb_true_iff, !SameLabelEqual;
        split; intuition (try congruence); subst; try (left; reflexivity);
        try (right; left; reflexivity); auto using AtInjective, eq_sym.
    Qed.

    Lemma CoverReach symbols : Cover symbols = true <->
      Reach (Corners tid) (map name symbols).
    Proof.
      unfold Cover, Reach. rewrite forallb_forall. split.
      - intros C c I. apply AtIn in I. destruct I as (l & L & ->).
        specialize (C l L). apply existsb_exists in C. destruct C as (s & S & T).
        exists (name s). split; [apply in_map, S|]. apply TouchesEnds; assumption.
      - intros C l L. destruct (C (at_ l)) as (v & V & E); [apply AtIn; eauto|].
        apply in_map_iff in V. destruct V as (s & <- & V).
        apply existsb_exists. exists s. split; [exact V|]. apply TouchesEnds; assumption.
    Qed.

    Lemma CrossingNamed e f : In f Four ->
      name (Crossing sign e f) = CrossingAt after (at_ e) (at_ f).
    Proof.
      intros F. unfold Crossing, CrossingAt, name. pose proof (AtIs Minus f F) as M.
      destruct (Is sign Minus f).
      - rewrite (proj1 M eq_refl). apply NameCut.
      - destruct (after (at_ f)); try (apply NameBase).
        exfalso. enough (false = true) by discriminate. apply M. reflexivity.
    Qed.

    Lemma ThirdNamed a m c : In c Four ->
      name (FaceThird sign a m c) = ThirdAt after (at_ a) (at_ m) (at_ c).
    Proof.
      intros C. unfold FaceThird, ThirdAt, name. pose proof (AtIs Minus c C) as M.
      pose proof (AtIs Plus c C) as Q'.
      destruct (Is sign Plus c); [rewrite (proj1 Q' eq_refl); apply NameCut|].
      destruct (Is sign Minus c); [rewrite (proj1 M eq_refl); apply NameCut|].
      destruct (after (at_ c)); try (apply NameBase); exfalso;
        enough (false = true) by discriminate; tauto.
    Qed.

    Lemma LabelsOf a b c d : In a (Corners tid) -> In b (Corners tid) ->
      In c (Corners tid) -> In d (Corners tid) -> NoDup [a; b; c; d] ->
      exists la lb lc ld, a = at_ la /\ b = at_ lb /\ c = at_ lc /\ d = at_ ld /\
        In la Four /\ In lb Four /\ In lc Four /\ In ld Four /\ NoDup [la; lb; lc; ld].
    Proof.
      rewrite !AtIn. intros (la & A & ->) (lb & B & ->) (lc & C & ->) (ld & D & ->) N.
      exists la, lb, lc, ld. repeat (split; [reflexivity || assumption|]).
      apply (NoDup_map_inv at_). exact N.
    Qed.
  End View.
End Mesh.
