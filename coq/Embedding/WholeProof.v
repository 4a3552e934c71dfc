(** * What is made within a structured tetrahedron is one piece

    A check of stencils, whatever their diagonals, and what it says of the mesh;
    and that the paper's stencils pass it. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stencil.TriangleChecker
  Stencil.TriangleCheckerProof Stuffing.NameProof Stuffing.MeshProof
  Angles.AngleTheorems Embedding.EdgeRank Embedding.MeshApartProof
  Embedding.LeavingProof Embedding.AroundProof.
Open Scope Z_scope.

(** ** The check *)

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

(** ** What it says *)

Section Checked.
  Variables (within : StructuredTetId -> list (UnstructuredTet MeshVertex))
    (after : SignField) (tid : StructuredTetId).
  Variables (h : Handedness) (f1 f2 f3 p q : Coord3) (sign : Label -> Sign)
    (ts : list SymbolicTet).
  Hypothesis D : NoDup [f1; f2; f3; p; q].
  Let name s := Orient h (MapTet (Name f1 f2 f3 p q) s).
  Hypothesis named : within tid = map name ts.
  Hypothesis whole : CheckWhole sign ts = true.

  Lemma CloseMeans s r : Close s r = true ->
    name s = name r \/ ShareFace (name s) (name r).
  Proof.
    intros C. apply orb_prop in C. destruct C as [C|C].
    - apply SameTetEqual in C. subst r. auto.
    - right. apply existsb_exists in C. destruct C as ([[a b] c] & I & H).
      apply TrianglesHasTriangle in I.
      apply (HasHasTriangle s r a b c I) in H.
      unfold name. exists (Name f1 f2 f3 p q a), (Name f1 f2 f3 p q b), (Name f1 f2 f3 p q c).
      rewrite !OrientHasTriangle, !HasTriangleName by exact D. auto.
  Qed.

  Lemma CheckedJoined : InLattice tid ->
    forall t u, In t (within tid) -> In u (within tid) ->
      Joined (Made within) ShareFace t u.
  Proof.
    intros E t u I J.
    assert (M : forall t, In t (within tid) -> Made within t)
      by (intros s S; exists tid; auto).
    pose proof (M t I) as T. pose proof (M u J) as U. rewrite named in I, J, M.
    apply in_map_iff in I. destruct I as (s & <- & I).
    apply in_map_iff in J. destruct J as (r & <- & J).
    pose proof whole as C. unfold CheckWhole in C. apply andb_prop in C.
    destruct C as [C _]. rewrite forallb_forall in C. specialize (C s I).
    rewrite forallb_forall in C. specialize (C r J).
    apply existsb_exists in C. destruct C as (m & K & C).
    apply andb_prop in C. destruct C as [A B].
    pose proof (M (name m) (in_map name ts m K)) as Mm.
    destruct (CloseMeans s m A) as [A'|A'], (CloseMeans m r B) as [B'|B'].
    - rewrite A', B'. constructor. exact U.
    - rewrite A'. apply JoinedNext; assumption.
    - rewrite <- B'. apply JoinedNext; assumption.
    - eapply JoinedThen; apply JoinedNext; eassumption.
  Qed.

  (** A face with a + corner has a triangle. *)
  Lemma CheckedFace i f : VerticesAre f1 f2 f3 p q tid F1 F2 F3 P ->
    (forall l, In l [F1; F2; F3; P] -> after (LocateFive f1 f2 f3 p q l) = sign l) ->
    In f (FaceOf tid i) -> after f = Plus ->
    exists a b c, AmongTriangles (within tid) a b c /\
      LiesIn (FaceOf tid i) a /\ LiesIn (FaceOf tid i) b /\ LiesIn (FaceOf tid i) c.
  Proof.
    intros V S I A. rewrite named.
    destruct (FaceNamed f1 f2 f3 p q tid i V) as (face & L & F).
    rewrite F in *. pose proof whole as C. unfold CheckWhole in C. apply andb_prop in C.
    destruct C as [_ C]. rewrite forallb_forall in C. specialize (C face L).
    apply orb_prop in C. destruct C as [C|C].
    - exfalso. rewrite negb_true_iff in C.
      enough (true = false) by discriminate. rewrite <- C. symmetry.
      apply in_map_iff in I. destruct I as (l & <- & I).
      apply existsb_exists. exists l. split; [exact I|].
      rewrite <- S; [rewrite A; reflexivity|].
      revert I. clear -L. cbn in L. intuition subst; cbn in *; tauto.
    - apply existsb_exists in C. destruct C as (s & J & C).
      apply existsb_exists in C. destruct C as ([[a b] c] & T & C).
      apply TrianglesHasTriangle in T.
      exists (Name f1 f2 f3 p q a), (Name f1 f2 f3 p q b), (Name f1 f2 f3 p q c).
      split; [|apply (TriangleOnLiesIn f1 f2 f3 p q D), C].
      exists (name s). split; [apply in_map, J|].
      unfold name. rewrite OrientHasTriangle, HasTriangleName by exact D. exact T.
  Qed.
End Checked.

(** ** The paper's stencils *)

Lemma StencilsWhole : ForAllSignAssignments (fun sign =>
  CheckWhole sign (SymbolicTets GetUnstructuredTets sign F1 F2 F3 P)) = true.
Proof. vm_compute. reflexivity. Qed.

Section Placed.
  Variables (before : SignField) (warping : Coord3 -> Warping).

  Let after c := PlacedSign before warping (Corner c).
  Let names := PlacedNames before warping.

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

  Lemma PlacedWhole tid : exists h f1 f2 f3 p q sign ts,
    NoDup [f1; f2; f3; p; q] /\ VerticesAre f1 f2 f3 p q tid F1 F2 F3 P /\
    names tid = map (fun s => Orient h (MapTet (Name f1 f2 f3 p q) s)) ts /\
    CheckWhole sign ts = true /\
    (forall l, In l [F1; F2; F3; P] -> after (LocateFive f1 f2 f3 p q l) = sign l).
  Proof.
    destruct (Labelled before warping tid)
      as (h & f1 & f2 & f3 & p & q & s1 & s2 & s3 & sp & sq & D & _ & V & S & N).
    exists h, f1, f2, f3, p, q. do 2 eexists.
    split; [exact D|]. split; [exact V|]. split; [exact N|]. split; [|exact S].
    exact (ForAllSignAssignmentsSound _ StencilsWhole s1 s2 s3 sp sq).
  Qed.

  Theorem PlacedJoins : JoinsWithin names after.
  Proof.
    constructor.
    - intros tid t v E I. exact (proj1 (StuffedFollows before warping tid t E I) v).
    - intros tid t c _ I. exact (ReachesAllCorners before warping tid t I c).
    - intros tid t E T. pose proof (proj1 (StuffedFollows before warping tid t E T)) as F.
      rewrite NamesAsStuffed in T.
      destruct (TetrahedraInside _ _ _ _ _ T) as [[v [V P]] _].
      rewrite <- SignAsStuffed in P. specialize (F v V).
      destruct v as [c|a m]; [|discriminate P]. exists c. destruct F. auto.
    - intros tid t u E.
      destruct (PlacedWhole tid) as (h & f1 & f2 & f3 & p & q & sign & ts & D & _ & N & C & _).
      exact (CheckedJoined names tid h f1 f2 f3 p q sign ts D N C E t u).
    - intros tid i f.
      destruct (PlacedWhole tid) as (h & f1 & f2 & f3 & p & q & sign & ts & D & V & N & C & S).
      exact (CheckedFace names after tid h f1 f2 f3 p q sign ts D N C i f V S).
    - intros tid i f I A a b c Fa Fb Fc among.
      pose proof (FaceTriangulationsAgree NoWarpThresholds after
        (fun _ _ => MidpointCut) tid i) as G. cbv zeta in G.
      rewrite <- !NamesAsStuffed in G.
      exact (proj1 (G (ex_intro _ f (conj I
        (eq_trans (eq_sym (SignAsStuffed (Corner f))) A))) a b c Fa Fb Fc) among).
  Qed.
End Placed.
