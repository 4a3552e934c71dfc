(** * With diagonals by key the mesh has the pieces of the samples: proof

    What is made within a structured tetrahedron is one piece in any order of the
    cuts, and both sides of a face agree. *)

From Certet Require Import Key.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stencil.TriangleChecker
  Stencil.TriangleCheckerProof Stuffing.NameProof Stuffing.MeshProof
  Embedding.EdgeRank Embedding.LeavingProof Embedding.AroundProof
  Key.Orders Key.OrderProof Key.KeyChecker Key.KeysApartProof Key.FaceRuleProof
  Key.KeyFollowsProof Key.KeyMeshProof Key.KeyMesh
  Embedding.PiecesSpec Mesh.Method Mesh.MeshPiecesSpec Mesh.MeshPiecesProof.
Open Scope Z_scope.

Lemma OrdersWhole : ForAllCornerSigns (fun sign =>
  forallb (fun order => CheckWhole sign (RankedTets sign order))
    (Orders (CutsOf sign))) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Section Mesh.
  Variables (before : SignField) (warping : Coord3 -> Warping) (cut : CutField).
  Let key := CutKey cut.
  Let mesh := KeyMesh before warping cut.

  (** ** Symbols *)

  Lemma NamedWhole tid : exists h f1 f2 f3 p q,
    let sign := NamedSign f1 f2 f3 p before warping in
    let ts := NamedRanked f1 f2 f3 p q key before warping in
    NoDup [f1; f2; f3; p; q] /\ VerticesAre f1 f2 f3 p q tid F1 F2 F3 P /\
    TetsWithin mesh tid = map (fun s => Orient h (MapTet (Name f1 f2 f3 p q) s)) ts /\
    CheckWhole sign ts = true.
  Proof.
    pose proof (CutKeysApart cut tid) as apart. fold key in apart.
    destruct (CornersNamed tid) as (f1 & f2 & f3 & p & q & D & V & C).
    rewrite C in apart.
    destruct (OrderedNamed f1 f2 f3 p q D key before warping tid V apart) as [h N].
    exists h, f1, f2, f3, p, q. cbv zeta. repeat (split; [assumption|]).
    pose proof (ForAllCornerSignsSound _ OrdersWhole
      (PlacedSign before warping (Corner f1)) (PlacedSign before warping (Corner f2))
      (PlacedSign before warping (Corner f3)) (PlacedSign before warping (Corner p))) as W.
    cbv beta in W. rewrite forallb_forall in W.
    exact (W _ (NamedOrderListed _ _ _ _ _ _ _ _)).
  Qed.

  Lemma KeyWhole tid t u : InLattice tid -> In t (TetsWithin mesh tid) ->
    In u (TetsWithin mesh tid) -> Joined (TetOf mesh) ShareFace t u.
  Proof.
    intros E I J. assert (M : forall t, In t (TetsWithin mesh tid) -> TetOf mesh t)
      by (intros s S; exists tid; auto).
    pose proof (M u J) as U. pose proof (M t I) as T.
    destruct (NamedWhole tid) as (h & f1 & f2 & f3 & p & q & D & _ & N & C).
    rewrite N in I, J, M.
    apply in_map_iff in I. destruct I as (s & <- & I).
    apply in_map_iff in J. destruct J as (r & <- & J).
    unfold CheckWhole in C. apply andb_prop in C.
    destruct C as [C _]. rewrite forallb_forall in C. specialize (C s I).
    rewrite forallb_forall in C. specialize (C r J).
    apply existsb_exists in C. destruct C as (m & K & C).
    apply andb_prop in C. destruct C as [A B].
    assert (Mm : TetOf mesh (Orient h (MapTet (Name f1 f2 f3 p q) m))).
    { apply M. apply (in_map (fun s =>
        Orient h (MapTet (Name f1 f2 f3 p q) s))), K. }
    destruct (CloseMeans h f1 f2 f3 p q s m D A) as [A'|A'],
      (CloseMeans h f1 f2 f3 p q m r D B) as [B'|B'].
    - rewrite A', B'. constructor. exact U.
    - rewrite A'. apply JoinedNext; assumption.
    - rewrite <- B'. apply JoinedNext; assumption.
    - eapply JoinedThen; apply JoinedNext; eassumption.
  Qed.

  Lemma KeyFace tid i f : In f (FaceOf tid i) -> InsideMesh mesh f ->
    exists a b c, AmongTriangles (TetsWithin mesh tid) a b c /\
      LiesIn (FaceOf tid i) a /\ LiesIn (FaceOf tid i) b /\ LiesIn (FaceOf tid i) c.
  Proof.
    intros I A.
    destruct (NamedWhole tid) as (h & f1 & f2 & f3 & p & q & D & V & N & C).
    rewrite N. destruct (FaceNamed f1 f2 f3 p q tid i V) as (face & L & F).
    rewrite F in *. unfold CheckWhole in C. apply andb_prop in C.
    destruct C as [_ C]. rewrite forallb_forall in C. specialize (C face L).
    apply orb_prop in C. destruct C as [C|C].
    - exfalso. rewrite negb_true_iff in C.
      enough (true = false) by discriminate. rewrite <- C. symmetry.
      apply in_map_iff in I. destruct I as (l & <- & I).
      apply existsb_exists. exists l. split; [exact I|].
      rewrite (NamedSignCorner f1 f2 f3 p q before warping).
      + unfold InsideMesh in A. cbn [mesh KeyMesh SignIn] in A. rewrite A. reflexivity.
      + revert I. clear -L. cbn in L. intuition subst; cbn in *; tauto.
    - apply existsb_exists in C. destruct C as (s & J & C).
      apply existsb_exists in C. destruct C as ([[a b] c] & T & C).
      apply TrianglesHasTriangle in T.
      exists (Name f1 f2 f3 p q a), (Name f1 f2 f3 p q b), (Name f1 f2 f3 p q c).
      split; [|apply (TriangleOnLiesIn f1 f2 f3 p q D), C].
      exists (Orient h (MapTet (Name f1 f2 f3 p q) s)).
      split; [apply (in_map (fun s => Orient h (MapTet (Name f1 f2 f3 p q) s))), J|].
      rewrite OrientHasTriangle, HasTriangleName by exact D. exact T.
  Qed.

  (** ** The mesh *)

  Theorem KeyJoinsWithin : JoinsWithin mesh.
  Proof.
    constructor.
    - intros tid t v _ I.
      exact (proj1 (OrderedFollows key before warping tid (CutKeysApart cut tid) t I) v).
    - intros tid t c _ I.
      exact (OrderedReaches key before warping tid (CutKeysApart cut tid) t I c).
    - intros tid t _ I.
      destruct (OrderedInside key before warping tid (CutKeysApart cut tid) t I)
        as [(v & V & plus) _].
      pose proof (proj1 (OrderedFollows key before warping tid (CutKeysApart cut tid) t I)
        v V) as B.
      destruct v as [c|a m]; [|discriminate plus]. exists c. destruct B. auto.
    - exact KeyWhole.
    - exact KeyFace.
    - intros tid i f I A a b c Fa Fb Fc.
      apply (KeyFacesAgree before warping cut tid i (ex_intro _ f (conj I A)) a b c Fa Fb Fc).
  Qed.
End Mesh.
