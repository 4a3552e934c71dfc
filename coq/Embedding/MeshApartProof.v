(** * No two tetrahedra of the mesh overlap

    A point inside two tetrahedra is a mean of vertices that they share, so they
    have the same four.  These reach all four corners of the structured
    tetrahedron, which tell it; and within it no two output tetrahedra have the
    same vertices. *)

From Coq Require Import Permutation.
From Certet Require Import Embedding.Definitions.
From Certet Require Import Lattice.StructuredTetProof Stencil.Symbol
  Stencil.SymbolProof Stencil.CompatibilityChecker Stencil.TriangleChecker
  Stencil.TriangleCheckerProof Stuffing.NameProof Embedding.LatticeEmbedsProof
  Embedding.Measure Embedding.EdgeRank Embedding.GreedyProof
  Embedding.MeshEmbedsProof.
Open Scope Z_scope.

(** ** The corners tell the structured tetrahedron *)

Lemma CornersNoDup tid : NoDup (Corners tid).
Proof.
  pose proof (VerticesDistinct tid) as D. unfold Corners.
  destruct (GetStructuredTet tid) as [v1 v2 v3 v4].
  repeat constructor; cbn; intuition congruence.
Qed.

Lemma CornersSum (f : Coord3 -> Z) l l' : Permutation l l' ->
  fold_right (fun c s => f c + s) 0 l = fold_right (fun c s => f c + s) 0 l'.
Proof. induction 1; cbn [fold_right] in *; lia. Qed.

(** By four times their centroid. *)
Lemma CornersDetermine tid tid' : InLattice tid -> InLattice tid' ->
  incl (Corners tid) (Corners tid') -> tid = tid'.
Proof.
  intros E E' I.
  assert (P : Permutation (Corners tid) (Corners tid')).
  { apply NoDup_Permutation_bis; [apply CornersNoDup| |exact I].
    unfold Corners. destruct (GetStructuredTet tid), (GetStructuredTet tid').
    cbn. auto. }
  pose proof (CornersSum XOf _ _ P) as Sx. pose proof (CornersSum YOf _ _ P) as Sy.
  pose proof (CornersSum ZOf _ _ P) as Sz. clear P I.
  destruct tid as [[x y z] case], tid' as [[x' y' z'] case'].
  destruct E as ([a ->] & [b ->] & [c ->]), E' as ([a' ->] & [b' ->] & [c' ->]).
  destruct case, case'; cbn [Corners GetStructuredTet Translate fold_right XOf YOf ZOf]
    in Sx, Sy, Sz; first [exfalso; lia | do 2 f_equal; lia].
Qed.

(** ** What the stencils do *)

Definition Touches (l : Label) (s : Symbol) : bool :=
  match s with
  | Base a => SameLabel l a
  | CutOf a m => SameLabel l a || SameLabel l m
  end.

Definition CheckApart (ts : list (UnstructuredTet Symbol)) : bool :=
  forallb (fun s =>
    forallb (fun l => existsb (Touches l) (TetCorners s)) [F1; F2; F3; P] &&
    forallb (fun r =>
      negb (forallb (fun x => Member x (TetCorners r)) (TetCorners s)) ||
      SameTet s r) ts) ts.

Lemma StencilsApart : ForAllSignAssignments (fun sign =>
  CheckApart (SymbolicTets GetUnstructuredTets sign F1 F2 F3 P)) = true.
Proof. vm_compute. reflexivity. Qed.

(** The ends of the edge that a vertex is on. *)
Definition Ends (v : MeshVertex) : list Coord3 :=
  match v with Corner c => [c] | Cut a m => [a; m] end.

(** Of whatever tetrahedra are named from such symbols. *)
Section Checked.
  Variables (h : Handedness) (f1 f2 f3 p q : Coord3) (ts : list SymbolicTet).
  Let name s := Orient h (MapTet (Name f1 f2 f3 p q) s).
  Hypothesis whole : CheckApart ts = true.

  Lemma CheckedReaches t : In t (map name ts) -> forall c, In c [f1; f2; f3; p] ->
    exists v, In v (TetCorners t) /\ In c (Ends v).
  Proof.
    pose proof whole as C.
    intros I c J. apply in_map_iff in I. destruct I as (s & <- & I).
    unfold CheckApart in C. rewrite forallb_forall in C. specialize (C _ I).
    apply andb_prop in C. destruct C as [C _]. rewrite forallb_forall in C.
    assert (L : exists l, In l [F1; F2; F3; P] /\ c = LocateFive f1 f2 f3 p q l).
    { destruct J as [<-|[<-|[<-|[<-|[]]]]];
        [exists F1|exists F2|exists F3|exists P]; cbn; tauto. }
    destruct L as (l & L & ->). specialize (C l L). apply existsb_exists in C.
    destruct C as (x & X & C). exists (Name f1 f2 f3 p q x). split.
    - apply OrientCorners. rewrite MapTetCorners. apply in_map, X.
    - destruct x as [a|a m]; rewrite ?NameBase, ?NameCut; cbn [Touches Ends In] in *;
        rewrite ?orb_true_iff, ?SameLabelEqual in C; intuition congruence.
  Qed.

  Lemma CheckedKnown t t' : NoDup [f1; f2; f3; p; q] ->
    In t (map name ts) -> In t' (map name ts) ->
    incl (TetCorners t) (TetCorners t') -> t = t'.
  Proof.
    pose proof whole as C.
    intros D I I' Sub. apply in_map_iff in I. destruct I as (s & <- & I).
    apply in_map_iff in I'. destruct I' as (r & <- & I').
    unfold CheckApart in C. rewrite forallb_forall in C. specialize (C _ I).
    apply andb_prop in C. destruct C as [_ C]. rewrite forallb_forall in C.
    specialize (C r I'). apply orb_prop in C. destruct C as [C|C].
    - exfalso. rewrite negb_true_iff in C.
      enough (true = false) by discriminate. rewrite <- C. symmetry.
      apply forallb_forall. intros x X. apply MemberIn.
      apply (InNames f1 f2 f3 p q D). rewrite <- MapTetCorners.
      apply (OrientCorners h), Sub, OrientCorners.
      rewrite MapTetCorners. apply in_map, X.
    - apply SameTetEqual in C. subst r. reflexivity.
  Qed.
End Checked.

Section Structured.
  Variables (before : SignField) (warping : Coord3 -> Warping).
  Variable tid : StructuredTetId.

  (** The output's tetrahedra as stencils on labels. *)
  Lemma Labelled : exists h f1 f2 f3 p q s1 s2 s3 sp sq,
    NoDup [f1; f2; f3; p; q] /\ Corners tid = [f1; f2; f3; p] /\
    VerticesAre f1 f2 f3 p q tid F1 F2 F3 P /\
    (forall l, In l [F1; F2; F3; P] ->
       PlacedSign before warping (Corner (LocateFive f1 f2 f3 p q l))
       = SignOf s1 s2 s3 sp sq l) /\
    PlacedNames before warping tid
    = map (fun s => Orient h (MapTet (Name f1 f2 f3 p q) s))
        (SymbolicTets GetUnstructuredTets (SignOf s1 s2 s3 sp sq) F1 F2 F3 P).
  Proof.
    destruct tid as [anchor case] eqn:T.
    pose proof (VerticesDistinct tid) as D. pose proof (AnchorApart anchor case) as A.
    destruct (PlacedLabelled before warping tid anchor) as (h & E).
    rewrite <- T in *. unfold Corners, VerticesAre.
    set (at_ := VertexAt (GetStructuredTet tid)) in *.
    exists h, (at_ First), (at_ Second), (at_ Third), (at_ Fourth), anchor.
    do 5 eexists. split; [|split; [|split; [|split; [|exact E]]]].
    - unfold at_. destruct (GetStructuredTet tid) as [v1 v2 v3 v4].
      cbn [VertexAt]. repeat constructor; cbn; intuition congruence.
    - unfold at_. destruct (GetStructuredTet tid). reflexivity.
    - unfold at_. destruct (GetStructuredTet tid). cbn. auto.
    - intros [] I; reflexivity || (cbn in I; intuition discriminate).
  Qed.

  Lemma ReachesAllCorners t : In t (PlacedNames before warping tid) ->
    forall c, In c (Corners tid) ->
      exists v, In v (TetCorners t) /\ In c (Ends v).
  Proof.
    destruct Labelled as (h & f1 & f2 & f3 & p & q & s1 & s2 & s3 & sp & sq & _ & ->
      & _ & _ & ->).
    exact (CheckedReaches h f1 f2 f3 p q _
      (ForAllSignAssignmentsSound _ StencilsApart s1 s2 s3 sp sq) t).
  Qed.

  Lemma KnownByCorners t t' : In t (PlacedNames before warping tid) ->
    In t' (PlacedNames before warping tid) ->
    incl (TetCorners t) (TetCorners t') -> t = t'.
  Proof.
    destruct Labelled as (h & f1 & f2 & f3 & p & q & s1 & s2 & s3 & sp & sq & D & _
      & _ & _ & ->).
    exact (CheckedKnown h f1 f2 f3 p q _
      (ForAllSignAssignmentsSound _ StencilsApart s1 s2 s3 sp sq) t t' D).
  Qed.
End Structured.

(** ** Interiors are apart *)

Lemma CornerWeighs {V} (Same : forall u v : V, {u = v} + {u <> v}) w
  (t : UnstructuredTet V) v :
  AllPositive w -> In v (TetCorners t) -> 0 < WeightOf Same w t v.
Proof.
  destruct w as [a b c d], t as [p q r s]. unfold WeightOf, At.
  cbn [AllPositive TetCorners In Weigh]. intros W I.
  destruct (Same v p), (Same v q), (Same v r), (Same v s); try lia.
  intuition congruence.
Qed.

Lemma SameCorners {V} (Same : forall u v : V, {u = v} + {u <> v}) w
  (t : UnstructuredTet V) w' t' :
  AllPositive w -> SameWeights w t w' t' -> incl (TetCorners t) (TetCorners t').
Proof.
  intros W E v I. apply (WeightyCorner V Same w'). unfold WeightOf.
  rewrite <- E. exact (CornerWeighs Same w t v W I).
Qed.

Lemma EndsBelong after corners v c : Belongs after corners v ->
  In c (Ends v) -> In c corners.
Proof.
  destruct v; cbn [Belongs Ends In]; intuition congruence.
Qed.

(** The corners tell the structured tetrahedron too. *)
Lemma OwnerKnown before warping tid tid' t t' : InLattice tid -> InLattice tid' ->
  In t (PlacedNames before warping tid) ->
  In t' (PlacedNames before warping tid') ->
  incl (TetCorners t) (TetCorners t') -> tid = tid'.
Proof.
  intros E E' I I' C. apply CornersDetermine; [assumption..|]. intros c J.
  destruct (ReachesAllCorners before warping tid t I c J) as (v & V & K).
  exact (EndsBelong _ _ v c
    (proj1 (StuffedFollows before warping tid' t' E' I') v (C v V)) K).
Qed.

(** Whatever the tetrahedra are made by: a point inside both is inside the hull of
    the vertices that they share. *)
Lemma ApartByCorners after place tid tid' t t' : InLattice tid -> InLattice tid' ->
  (forall c, In c (Corners tid) -> exists v, In v (TetCorners t) /\ In c (Ends v)) ->
  (forall v, In v (TetCorners t') -> Belongs after (Corners tid') v) ->
  (tid = tid' -> incl (TetCorners t) (TetCorners t') -> t = t') ->
  MeetInSharedVertices place t t' ->
  Overlap (MapTet place t) (MapTet place t') -> tid = tid' /\ t = t'.
Proof.
  intros E E' reaches belongs known M (w & w' & W & W' & T & O).
  assert (N : forall w, AllPositive w -> NonNegative w)
    by (intros []; cbn; lia).
  pose proof (SameCorners SameVertex w t w' t' W (M w w' (N w W) (N w' W') T O)) as C.
  assert (same : tid = tid').
  { apply CornersDetermine; [assumption..|]. intros c J.
    destruct (reaches c J) as (v & V & K).
    exact (EndsBelong _ _ v c (belongs v (C v V)) K). }
  split; [exact same|exact (known same C)].
Qed.

Lemma ApartBySharing before warping place tid tid' t t' :
  InLattice tid -> InLattice tid' ->
  In t (PlacedNames before warping tid) ->
  In t' (PlacedNames before warping tid') ->
  MeetInSharedVertices place t t' ->
  Overlap (MapTet place t) (MapTet place t') -> tid = tid' /\ t = t'.
Proof.
  intros E E' I I'.
  apply (ApartByCorners (fun c => PlacedSign before warping (Corner c))); try assumption.
  - exact (ReachesAllCorners before warping tid t I).
  - exact (proj1 (StuffedFollows before warping tid' t' E' I')).
  - intros <-. exact (KnownByCorners before warping tid t t' I I').
Qed.

Theorem InteriorsApart long short sign cut tid tid' t t' :
  let th := TH long short in
  0 < long <= 64 -> 0 < short <= 128 ->
  CutsOnEdges sign cut -> InLattice tid -> InLattice tid' ->
  In t (StuffTet th sign cut tid) -> In t' (StuffTet th sign cut tid') ->
  Overlap (MapTet (MeshPosition th sign cut) t)
          (MapTet (MeshPosition th sign cut) t') ->
  tid = tid' /\ t = t'.
Proof.
  intros th L S C E E' I I'.
  pose proof (MeshEmbeds long short sign cut tid tid' t t' L S C E E' I I') as M.
  rewrite StuffedByName in I, I'.
  exact (ApartBySharing _ _ _ _ _ _ _ E E' I I' M).
Qed.
