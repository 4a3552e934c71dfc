(** * Around a + point the mesh is joined by faces

    Within one structured tetrahedron, and across each face that has the point as
    a corner, where both sides have the same triangles; and so along every edge
    from + to +. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stencil.TriangleChecker
  Stencil.TriangleCheckerProof Stuffing.NameProof Stuffing.MeshProof
  Angles.AngleTheorems Embedding.EdgeRank Embedding.MeshApartProof
  Embedding.LeavingProof Embedding.StarProof.
Open Scope Z_scope.

(** ** The stencils *)

(** The same, or with a common triangle. *)
Definition Close (s r : SymbolicTet) : bool :=
  SameTet s r || existsb (Has r) (Triangles s).

(** Any two are joined by way of a third; and on a face with a + corner there is
    a triangle. *)
Definition CheckWhole (sign : Label -> Sign) (ts : list SymbolicTet) : bool :=
  forallb (fun s => forallb (fun r => existsb (fun m => Close s m && Close m r) ts)
    ts) ts &&
  forallb (fun face => negb (SomePlus sign face) ||
    existsb (fun t => existsb (TriangleOn face) (Triangles t)) ts) Faces.

Lemma StencilsWhole : ForAllSignAssignments (fun sign =>
  CheckWhole sign (SymbolicTets GetUnstructuredTets sign F1 F2 F3 P)) = true.
Proof. vm_compute. reflexivity. Qed.

Section Mesh.
  Variables (before : SignField) (warping : Coord3 -> Warping).

  Let after c := PlacedSign before warping (Corner c).
  Let names := PlacedNames before warping.
  Let mesh := InMesh before warping.
  Local Notation joined := (Joined mesh ShareFace).

  Lemma ShareFaceMutual t u : ShareFace t u -> ShareFace u t.
  Proof. intros (a & b & c & H & K). exists a, b, c. auto. Qed.

  Lemma MadeInMesh tid t : InLattice tid -> In t (names tid) -> mesh t.
  Proof. intros E I. exists tid. auto. Qed.

  (** ** Within a structured tetrahedron *)

  Lemma CloseMeans h f1 f2 f3 p q s r : NoDup [f1; f2; f3; p; q] ->
    Close s r = true ->
    let name x := Orient h (MapTet (Name f1 f2 f3 p q) x) in
    name s = name r \/ ShareFace (name s) (name r).
  Proof.
    intros D C. apply orb_prop in C. destruct C as [C|C].
    - apply SameTetEqual in C. subst r. auto.
    - right. apply existsb_exists in C. destruct C as ([[a b] c] & I & H).
      apply TrianglesHasTriangle in I.
      apply (HasHasTriangle s r a b c I) in H.
      exists (Name f1 f2 f3 p q a), (Name f1 f2 f3 p q b), (Name f1 f2 f3 p q c).
      rewrite !OrientHasTriangle, !HasTriangleName by exact D. auto.
  Qed.

  Lemma Within tid t u : InLattice tid -> In t (names tid) -> In u (names tid) ->
    joined t u.
  Proof.
    intros E I J. pose proof (MadeInMesh tid t E I) as T.
    pose proof (MadeInMesh tid u E J) as U.
    pose proof (fun t => MadeInMesh tid t E) as M. unfold names in I, J, M.
    destruct (Labelled before warping tid)
      as (h & f1 & f2 & f3 & p & q & s1 & s2 & s3 & sp & sq & D & _ & _ & _ & N).
    rewrite N in I, J, M.
    apply in_map_iff in I. destruct I as (s & <- & I).
    apply in_map_iff in J. destruct J as (r & <- & J).
    pose proof (ForAllSignAssignmentsSound _ StencilsWhole s1 s2 s3 sp sq) as C.
    cbv beta in C. unfold CheckWhole in C. apply andb_prop in C.
    destruct C as [C _]. rewrite forallb_forall in C. specialize (C s I).
    rewrite forallb_forall in C. specialize (C r J).
    apply existsb_exists in C. destruct C as (m & K & C).
    apply andb_prop in C. destruct C as [A B].
    assert (Mm : mesh (Orient h (MapTet (Name f1 f2 f3 p q) m))).
    { apply M. apply (in_map (fun s =>
        Orient h (MapTet (Name f1 f2 f3 p q) s))), K. }
    destruct (CloseMeans h f1 f2 f3 p q s m D A) as [A'|A'],
      (CloseMeans h f1 f2 f3 p q m r D B) as [B'|B'].
    - rewrite A', B'. constructor. exact U.
    - rewrite A'. apply JoinedNext; assumption.
    - rewrite <- B'. apply JoinedNext; assumption.
    - eapply JoinedThen; apply JoinedNext; eassumption.
  Qed.

  (** ** Across a face *)

  (** Any warp's mesh is, by name, that of its signs without a warp. *)
  Lemma SignAsStuffed v :
    PlacedSign before warping v
    = MeshVertexSign NoWarpThresholds after (fun _ _ => MidpointCut) v.
  Proof.
    destruct v as [c|a m]; [|reflexivity]. cbn [MeshVertexSign].
    rewrite NeverWarped; [reflexivity|]. intros a b _ _. split; discriminate.
  Qed.

  Lemma NamesAsStuffed tid :
    names tid = StuffTet NoWarpThresholds after (fun _ _ => MidpointCut) tid.
  Proof.
    unfold names, PlacedNames, StuffTet. destruct tid as [anchor case].
    destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4]. f_equal.
    rewrite (GetUnstructuredTetsNatural MeshVertex MeshVertex (fun v => v)
      (MeshVertexSign NoWarpThresholds after (fun _ _ => MidpointCut))
      (PlacedSign before warping)
      MeshIntersection MeshIntersection (Corner v1) (Corner v2) (Corner v3)
      (Corner v4)).
    - rewrite <- map_id. apply map_ext. intros []. reflexivity.
    - intros v _. apply SignAsStuffed.
    - reflexivity.
  Qed.

  (** A face with a + corner has a triangle. *)
  Lemma FaceHasTriangle tid i f : In f (FaceOf tid i) -> after f = Plus ->
    exists t a b c, In t (names tid) /\ HasTriangle t a b c /\
      LiesIn (FaceOf tid i) a /\ LiesIn (FaceOf tid i) b /\
      LiesIn (FaceOf tid i) c.
  Proof.
    intros I A. unfold names.
    destruct (Labelled before warping tid)
      as (h & f1 & f2 & f3 & p & q & s1 & s2 & s3 & sp & sq & D & _ & V & S & N).
    rewrite N. destruct (FaceNamed f1 f2 f3 p q tid i V) as (face & L & F).
    rewrite F in *. pose proof (ForAllSignAssignmentsSound _ StencilsWhole s1 s2 s3 sp sq) as C.
    cbv beta in C. unfold CheckWhole in C. apply andb_prop in C.
    destruct C as [_ C]. rewrite forallb_forall in C. specialize (C face L).
    apply orb_prop in C. destruct C as [C|C].
    - exfalso. rewrite negb_true_iff in C.
      enough (true = false) by discriminate. rewrite <- C. symmetry.
      apply in_map_iff in I. destruct I as (l & <- & I).
      apply existsb_exists. exists l. split; [exact I|].
      rewrite <- S; [unfold after in A; rewrite A; reflexivity|].
      revert I. clear -L. cbn in L. intuition subst; cbn in *; tauto.
    - apply existsb_exists in C. destruct C as (s & J & C).
      apply existsb_exists in C. destruct C as ([[a b] c] & T & C).
      apply TrianglesHasTriangle in T.
      exists (Orient h (MapTet (Name f1 f2 f3 p q) s)), (Name f1 f2 f3 p q a),
        (Name f1 f2 f3 p q b), (Name f1 f2 f3 p q c).
      split; [apply (in_map (fun s => Orient h (MapTet (Name f1 f2 f3 p q) s))), J|].
      rewrite OrientHasTriangle, HasTriangleName by exact D. split; [exact T|].
      apply (TriangleOnLiesIn f1 f2 f3 p q D), C.
  Qed.

  Lemma NeighborOfLattice tid i : InLattice tid -> InLattice (NeighborOf tid i).
  Proof.
    intros E. assert (In (VertexAt (GetStructuredTet tid) First) (Corners tid))
      as I by (apply PlaceOf; eauto).
    destruct (FromOrigin tid _ E I) as (a & b & c & case & _ & -> & _).
    rewrite NeighborMoved. apply HasEvenAnchorMeans.
    destruct case, i; reflexivity.
  Qed.

  Lemma Across tid i p t u : InLattice tid -> In p (FaceOf tid i) ->
    after p = Plus -> In t (names tid) -> In u (names (NeighborOf tid i)) ->
    joined t u.
  Proof.
    intros E I A T U. pose proof (NeighborOfLattice tid i E) as E'.
    destruct (FaceHasTriangle tid i p I A) as (s & a & b & c & S & H & Fa & Fb & Fc).
    pose proof (FaceTriangulationsAgree NoWarpThresholds after
      (fun _ _ => MidpointCut) tid i) as G. cbv zeta in G.
    rewrite <- !NamesAsStuffed in G.
    specialize (G (ex_intro _ p (conj I
      (eq_trans (eq_sym (SignAsStuffed (Corner p))) A))) a b c Fa Fb Fc).
    destruct (proj1 G (ex_intro _ s (conj S H))) as (r & R & K).
    apply (JoinedThen _ _ _ t s u); [exact (Within tid t s E T S)|].
    apply (JoinedThen _ _ _ s r u); [|exact (Within _ r u E' R U)].
    apply JoinedNext; [exact (MadeInMesh tid s E S)| |exact (MadeInMesh _ r E' R)].
    exists a, b, c. auto.
  Qed.
  (** ** Around a point, and along an edge *)

  Lemma MadeSomewhere tid p : In p (Corners tid) -> after p = Plus ->
    exists t, In t (names tid).
  Proof.
    intros I A. assert (exists i, In p (FaceOf tid i)) as [i F].
    { unfold Corners, FaceOf in *. destruct (GetStructuredTet tid).
      cbn [In] in I. destruct I as [<-|[<-|[<-|[<-|[]]]]];
        [exists Second|exists First|exists First|exists First]; cbn; tauto. }
    destruct (FaceHasTriangle tid i p F A) as (t & _ & _ & _ & T & _).
    exists t. exact T.
  Qed.

  Lemma AroundJoined p tid target : AroundPoint p tid target ->
    after p = Plus -> InLattice tid ->
    forall t u, In t (names tid) -> In u (names target) -> joined t u.
  Proof.
    intros R A. induction R as [tid I|tid i target I F R IH]; intros E t u T U.
    - exact (Within tid t u E T U).
    - pose proof (NeighborOfLattice tid i E) as E'.
      assert (N : In p (Corners (NeighborOf tid i))) by (destruct R; assumption).
      destruct (MadeSomewhere _ p N A) as (s & S).
      apply (JoinedThen _ _ _ t s u).
      + exact (Across tid i p t s E F A T S).
      + exact (IH E' s u S U).
  Qed.

  Let made := MadeAt before warping.

  Lemma MadeAtJoined p t u : after p = Plus -> made p t -> made p u -> joined t u.
  Proof.
    intros A (tid & E & I & T) (tid' & E' & I' & U).
    pose proof (StarConnected tid p E I) as R.
    pose proof (StarConnected tid' p E' I') as R'.
    assert (H : In p (Corners (Home p))) by (clear -R; induction R; assumption).
    destruct (MadeSomewhere _ p H A) as (s & S).
    apply (JoinedThen _ _ _ t s u); [exact (AroundJoined p tid _ R A E t s T S)|].
    apply JoinedBack; [exact ShareFaceMutual|].
    exact (AroundJoined p tid' _ R' A E' u s U S).
  Qed.

  Lemma PointsThenFaces p q t : Joined (PlusAfter before warping) Adjacent p q ->
    made p t -> (exists tid, InLattice tid /\ In q (Corners tid)) /\
      forall u, made q u -> joined t u.
  Proof.
    intros J. induction J as [p A|p q r J IH [d ->] A]; intros T.
    - split; [destruct T as (tid & E & I & _); eauto|].
      intros u U. exact (MadeAtJoined p t u A T U).
    - destruct (IH T) as ((tid & E & I) & K).
      destruct (EdgeInStar tid q d E I) as (other & E' & Q & R).
      split; [eauto|]. intros u U.
      apply JoinedInside in J. destruct J as [_ B].
      destruct (MadeSomewhere other q Q B) as (s & S).
      apply (JoinedThen _ _ _ t s u); [apply K; exists other; auto|].
      apply (MadeAtJoined (Translate q (Offset d))); [exact A|exists other; auto|exact U].
  Qed.
End Mesh.
