(** * A graded mesh conforms, and ends on the surface: proofs

    Where both sides of a face are structured tetrahedra it is as it was.
    Elsewhere the vertices of the face are inside, and both sides have the face
    whole. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Lattice.Tiling Lattice.FaceProof
  Embedding.EdgeRank Embedding.AroundProof Embedding.WholeProof Key.KeyPiecesProof
  Key.CertifiedKeyProof Mesh.Method Mesh.CertifiedSpec Mesh.PlacedMeshProof.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet
  Grading.Surface Grading.GradingSpec.
From Certet Require Import Grading.PartitionProof Grading.GradedVolumeProof
  Grading.FaceSeenProof Grading.GradedNeighborProof Grading.TouchedProof
  Grading.GradedMeshProof.
Open Scope Z_scope.

Local Strategy 1000 [WarpVertex Bisect Settle].

(** ** Vertices *)

Lemma FaceHas tid i v :
  In v (GradedFace tid i) <-> exists j, j <> i /\ v = GradedVertexAt tid j.
Proof.
  unfold GradedFace. split.
  - destruct i; cbn [Others In]; intros [<- | [<- | [<- | []]]];
      (eexists; split; [|reflexivity]; discriminate).
  - intros (j & D & ->). destruct i, j; cbn [Others In]; tauto.
Qed.

Lemma FaceTriple tid i : exists p q r,
  In p (GradedFace tid i) /\ In q (GradedFace tid i) /\ In r (GradedFace tid i) /\
  p <> q /\ q <> r /\ p <> r.
Proof.
  unfold GradedFace. destruct (Others i) as [[j k] l] eqn:O.
  exists (GradedVertexAt tid j), (GradedVertexAt tid k), (GradedVertexAt tid l).
  cbn [In]. repeat split; try tauto; intros E; apply GradedVerticesApart in E;
    destruct i; cbn [Others] in O; congruence.
Qed.

Lemma NotBetweenItself tid i v : ~ LiesBetween (GradedFace tid i) v v.
Proof.
  intros D. destruct (FaceTriple tid i) as (p & q & r & P & Q & R & A & B & C).
  pose proof (D p q r P Q R A B C). nia.
Qed.

(** The vertex across from a shared face is no vertex of the neighbour. *)
Lemma ApexNotShared tid i nei j :
  SameVertices (GradedFace tid i) (GradedFace nei j) ->
  LiesBetween (GradedFace tid i) (GradedVertexAt tid i) (GradedVertexAt nei j) ->
  forall k, GradedVertexAt tid i <> GradedVertexAt nei k.
Proof.
  intros F D k E.
  assert (S : k = j \/ k <> j) by (destruct k, j; (left; reflexivity) || (right; discriminate)).
  destruct S as [-> | S].
  - rewrite <- E in D. exact (NotBetweenItself _ _ _ D).
  - assert (I : In (GradedVertexAt tid i) (GradedFace tid i))
      by (apply F, FaceHas; eauto).
    apply FaceHas in I. destruct I as (l & N & L). apply GradedVerticesApart in L. congruence.
Qed.

Lemma VertexOfTet tid i : In (GradedVertexAt tid i) (TetCorners (GetGradedTet tid)).
Proof.
  unfold GetGradedTet, GradedVertexAt.
  destruct (GradedVertices tid) as [[[v1 v2] v3] v4], (GradedHandedness tid), i;
    cbn [TetCorners In Pick]; tauto.
Qed.

Lemma CornersOfMap t m :
  In m (TetCorners (MapTet Corner t)) <-> exists v, In v (TetCorners t) /\ m = Corner v.
Proof.
  destruct t as [a b c d]. cbn [MapTet TetCorners In]. split.
  - intros [<- | [<- | [<- | [<- | []]]]]; eauto 8.
  - intros (v & [<- | [<- | [<- | [<- | []]]]] & ->); tauto.
Qed.

(** ** Whole faces *)

Definition IsCornerIn (face : list Coord3) (m : MeshVertex) : Prop :=
  exists v, m = Corner v /\ In v face.

Definition IsWhole (face : list Coord3) (a b c : MeshVertex) : Prop :=
  (IsCornerIn face a /\ IsCornerIn face b /\ IsCornerIn face c) /\
  (a <> b /\ b <> c /\ a <> c).

Lemma WholeSame face face' a b c : SameVertices face face' ->
  IsWhole face a b c -> IsWhole face' a b c.
Proof.
  assert (C : SameVertices face face' -> forall m, IsCornerIn face m -> IsCornerIn face' m)
    by (intros S m (v & E & I); exists v; split; [exact E | now apply S]).
  intros S ((A & B & D) & N). split; [auto | exact N].
Qed.

Lemma LiesSame face face' m : SameVertices face face' -> LiesIn face m -> LiesIn face' m.
Proof. destruct m; cbn [LiesIn]; intros S; [apply S | intros [I J]; split; now apply S]. Qed.

(** Three different ones of three are all three. *)
Lemma AllThree {A} (x y z a b c m : A) :
  In a [x; y; z] -> In b [x; y; z] -> In c [x; y; z] ->
  a <> b -> b <> c -> a <> c -> In m [x; y; z] -> In m [a; b; c].
Proof.
  cbn [In]. intros I J K D E F M.
  destruct I as [<- | [<- | [<- | []]]]; destruct J as [<- | [<- | [<- | []]]];
    try (now destruct D); destruct K as [<- | [<- | [<- | []]]];
    try (now destruct E); try (now destruct F); tauto.
Qed.

(** What is within structured tetrahedra, whatever its diagonals. *)
Section Within.
  Variables (names : StructuredTetId -> list (UnstructuredTet MeshVertex)).
  Variable after : SignField.
  Hypothesis joins : JoinsWithin names after.

  Lemma NamesVertices stid t m : InLattice stid -> In t (names stid) ->
    In m (TetCorners t) ->
    (exists i, m = Corner (VertexAt (GetStructuredTet stid) i)) \/
    (exists i j, m = Cut (VertexAt (GetStructuredTet stid) i)
                         (VertexAt (GetStructuredTet stid) j) /\
       after (VertexAt (GetStructuredTet stid) j) = Minus).
  Proof.
    intros even I J. pose proof (within_belongs joins stid t m even I J) as B.
    assert (P : forall v, In v (Corners stid) -> exists i,
      v = VertexAt (GetStructuredTet stid) i).
    { unfold Corners. destruct (GetStructuredTet stid). cbn [VertexAt].
      intros v [<- | [<- | [<- | [<- | []]]]];
        [exists First | exists Second | exists Third | exists Fourth]; reflexivity. }
    destruct m as [c|p q]; cbn [Belongs] in B.
    - left. destruct (P c (proj1 B)) as [i ->]. now exists i.
    - right. destruct B as (V & W & _ & S). destruct (P p V) as [i ->], (P q W) as [j ->].
      exists i, j. auto.
  Qed.

  (** A face of a structured tetrahedron that is inside is whole. *)
  Lemma WholeStructured stid i a b c : InLattice stid ->
    (forall f, In f (FaceOf stid i) -> after f = Plus) ->
    LiesIn (FaceOf stid i) a -> LiesIn (FaceOf stid i) b -> LiesIn (FaceOf stid i) c ->
    AmongTriangles (names stid) a b c <-> IsWhole (FaceOf stid i) a b c.
  Proof.
    intros even plus.
    assert (corner : forall t m, In t (names stid) -> In m (TetCorners t) ->
      LiesIn (FaceOf stid i) m -> IsCornerIn (FaceOf stid i) m).
    { intros t m T I L. destruct (NamesVertices stid t m even T I)
        as [(k & ->) | (k & l & -> & S)]; [now exists (VertexAt (GetStructuredTet stid) k)|].
      cbn [LiesIn] in L. destruct L as [_ L]. rewrite (plus _ L) in S. discriminate. }
    assert (forth : forall t x y z, In t (names stid) -> HasTriangle t x y z ->
      LiesIn (FaceOf stid i) x -> LiesIn (FaceOf stid i) y -> LiesIn (FaceOf stid i) z ->
      IsWhole (FaceOf stid i) x y z).
    { intros t x y z T ((X & Y & Z) & N) LX LY LZ. split; [|exact N].
      exact (conj (corner t x T X LX) (conj (corner t y T Y LY) (corner t z T Z LZ))). }
    intros La Lb Lc. split; [intros (t & T & H); exact (forth t a b c T H La Lb Lc)|].
    intros ((A & B & C) & N).
    assert (exists f, In f (FaceOf stid i)) as [f F]
      by (destruct A as (v & _ & V); eauto).
    destruct (within_face joins stid i f F (plus f F))
      as (x & y & z & (t & T & H) & LX & LY & LZ).
    exists t. split; [exact T|]. split; [|exact N].
    destruct (forth t x y z T H LX LY LZ) as ((X & Y & Z) & D & E & G).
    destruct H as ((HX & HY & HZ) & _).
    assert (all : forall m, IsCornerIn (FaceOf stid i) m -> In m (TetCorners t)).
    { assert (exists u v w, FaceOf stid i = [u; v; w]) as (u & v & w & EF)
        by (unfold FaceOf; destruct (GetStructuredTet stid), i; cbn [FaceAcross]; eauto).
      rewrite EF in X, Y, Z.
      assert (as_list : forall m, IsCornerIn [u; v; w] m ->
        In m [Corner u; Corner v; Corner w]).
      { intros m (p & -> & P). exact (in_map Corner [u; v; w] p P). }
      intros m M. rewrite EF in M.
      pose proof (AllThree _ _ _ _ _ _ m (as_list x X) (as_list y Y) (as_list z Z) D E G
        (as_list m M)) as I.
      cbn [In] in I. destruct I as [<- | [<- | [<- | []]]]; assumption. }
    auto.
  Qed.
End Within.

(** A tetrahedron that is kept whole has its faces whole. *)
Lemma WholePlain tid i a b c :
  LiesIn (GradedFace tid i) a -> LiesIn (GradedFace tid i) b -> LiesIn (GradedFace tid i) c ->
  AmongTriangles [MapTet Corner (GetGradedTet tid)] a b c
  <-> IsWhole (GradedFace tid i) a b c.
Proof.
  intros La Lb Lc.
  assert (C : forall m, LiesIn (GradedFace tid i) m ->
    In m (TetCorners (MapTet Corner (GetGradedTet tid))) -> IsCornerIn (GradedFace tid i) m).
  { intros m L I. apply CornersOfMap in I. destruct I as (v & _ & ->). now exists v. }
  split.
  - intros (t & [<- | []] & (A & B & D) & N). split; [auto | exact N].
  - intros ((A & B & D) & N). eexists. split; [left; reflexivity|]. split; [|exact N].
    assert (I : forall m, IsCornerIn (GradedFace tid i) m ->
      In m (TetCorners (MapTet Corner (GetGradedTet tid)))).
    { intros m (v & -> & V). apply CornersOfMap. exists v. split; [|reflexivity].
      apply FaceHas in V. destruct V as (j & _ & ->). apply VertexOfTet. }
    auto.
Qed.

Lemma MeshJoins method sign domain :
  JoinsWithin (TetsWithin (MeshOf method sign domain))
    (CornerSigns (MeshOf method sign domain)).
Proof. destruct method; try apply PlacedJoins. apply KeyJoinsWithin. Qed.

(** Not by [CertifiedMesh], which rests on real numbers. *)
Lemma MeshConforms method sign domain : FacesConform (MeshOf method sign domain).
Proof. destruct method; try apply PlacedFacesConform. apply KeyFacesConform. Qed.

Lemma MeshBoundary method sign domain : BoundaryIsSurface (MeshOf method sign domain).
Proof. destruct method; try apply PlacedBoundary. apply KeyBoundary. Qed.

(** ** The graded mesh *)

Lemma LatticeApexNotShared stid k : InLattice stid ->
  forall j, VertexAt (GetStructuredTet stid) k
            <> VertexAt (GetStructuredTet (NeighborOf stid k)) j.
Proof.
  intros even j E. apply (NeighborApart stid k).
  apply (VerticesTell stid (NeighborOf stid k) even (NeighborInLattice stid k even)).
  intros i.
  assert (S : i = k \/ i <> k) by (destruct i, k; (left; reflexivity) || (right; discriminate)).
  destruct S as [-> | S]; [now exists j|].
  apply (proj2 (FaceOfTwo stid k (NeighborOf stid k) even (NeighborInLattice stid k even)));
    [now right|].
  destruct (GetStructuredTet stid), i, k; cbn [FaceAcross VertexAt In]; tauto.
Qed.

Section SharedFace.
  Variables (names : StructuredTetId -> list (UnstructuredTet MeshVertex)).
  Variable after : SignField.
  Hypothesis joins : JoinsWithin names after.

  (** What two neighbours have in common lies in their face. *)
  Lemma SharedLiesIn stid k t u m : InLattice stid ->
    In t (names stid) -> In u (names (NeighborOf stid k)) ->
    In m (TetCorners t) -> In m (TetCorners u) -> LiesIn (FaceOf stid k) m.
  Proof.
    intros even T U I J.
    assert (shared : forall i j,
      VertexAt (GetStructuredTet stid) i
      = VertexAt (GetStructuredTet (NeighborOf stid k)) j ->
      In (VertexAt (GetStructuredTet stid) i) (FaceOf stid k)).
    { intros i j E. assert (i <> k) as D
        by (intros ->; exact (LatticeApexNotShared stid k even j E)).
      unfold FaceOf. destruct (GetStructuredTet stid), i, k;
        cbn [FaceAcross VertexAt In]; tauto. }
    pose proof (NeighborInLattice stid k even) as even'.
    destruct (NamesVertices names after joins _ t m even T I)
      as [(i & ->) | (i & j & -> & _)];
      destruct (NamesVertices names after joins _ u _ even' U J) as [(i' & E) | (i' & j' & E & _)];
      try discriminate E.
    - injection E as E. cbn [LiesIn]. now apply (shared i i').
    - injection E as E F. cbn [LiesIn].
      split; [now apply (shared i i') | now apply (shared j j')].
  Qed.
End SharedFace.

Section Mesh.
  Variables (method : Method) (sign : SignField) (domain : PositionSigns).
  Local Notation mesh := (MeshOf method sign domain).
  Variable cells : CellSet.
  Hypothesis IsOne : IsOctree cells.
  Hypothesis Kept : KeepsSurface (CornerSigns mesh) cells.
  Local Notation within := (GradedTetsWithin mesh).

  Lemma FaceOfStructured tid stid i : InGradedMesh cells tid ->
    StructuredName tid = Some stid -> FaceOf stid i = GradedFace tid i.
  Proof.
    intros M N. destruct (StructuredNameCorrect cells tid stid M N) as (_ & V & _).
    unfold FaceOf, GradedFace.
    pose proof (V First) as V1. pose proof (V Second) as V2.
    pose proof (V Third) as V3. pose proof (V Fourth) as V4.
    destruct (GetStructuredTet stid). cbn [VertexAt] in *.
    destruct i; cbn [FaceAcross Others]; congruence.
  Qed.

  (** Within which face it lies, a face that is inside is whole. *)
  Lemma WholeInside tid i a b c : InGradedMesh cells tid ->
    (forall f, In f (GradedFace tid i) -> CornerSigns mesh f = Plus) ->
    LiesIn (GradedFace tid i) a -> LiesIn (GradedFace tid i) b -> LiesIn (GradedFace tid i) c ->
    AmongTriangles (within tid) a b c <-> IsWhole (GradedFace tid i) a b c.
  Proof.
    intros M plus. unfold GradedTetsWithin.
    destruct (StructuredName tid) as [stid|] eqn:N; [|apply WholePlain].
    destruct (StructuredNameCorrect cells tid stid M N) as (even & _).
    rewrite <- (FaceOfStructured tid stid i M N) in *.
    exact (WholeStructured _ _ (MeshJoins method sign domain) stid i a b c even plus).
  Qed.

  Lemma NeighborSides tid i : InGradedMesh cells tid ->
    let nei := GradedNeighbor cells tid i in
    InGradedMesh cells nei /\ exists j,
      SameVertices (GradedFace tid i) (GradedFace nei j) /\
      (forall k, GradedVertexAt tid i <> GradedVertexAt nei k) /\
      (forall k, GradedVertexAt nei j <> GradedVertexAt tid k).
  Proof.
    intros M nei. destruct (NeighborMeets cells tid i IsOne M) as (M' & j & F & D & _).
    split; [exact M'|]. exists j. split; [exact F|]. split.
    - exact (ApexNotShared tid i nei j F D).
    - apply (ApexNotShared nei j tid i); [now apply SameSym|].
      apply (BetweenSame _ _ _ _ F), BetweenSwap, D.
  Qed.

  (** Neighbours that are structured are neighbours in the lattice. *)
  Lemma StructuredNeighbor tid i stid other : InGradedMesh cells tid ->
    StructuredName tid = Some stid ->
    StructuredName (GradedNeighbor cells tid i) = Some other ->
    other = NeighborOf stid i.
  Proof.
    intros M N N'. destruct (NeighborSides tid i M) as (M' & j & F & A & _).
    destruct (StructuredNameCorrect cells _ _ M N) as (even & _).
    destruct (StructuredNameCorrect cells _ _ M' N') as (even' & V' & _).
    destruct (proj1 (FaceOfTwo stid i other even even')) as [E | E]; [| | exact E].
    - intros v I. change (FaceAcross (GetStructuredTet stid) i) with (FaceOf stid i) in I.
      rewrite (FaceOfStructured tid stid i M N) in I. apply F, FaceHas in I.
      destruct I as (k & _ & ->). exists k. apply V'.
    - exfalso. subst other.
      rewrite (StructuredNameUnique cells tid _ stid M M' N N') in A. exact (A i eq_refl).
  Qed.

  Lemma FaceInside tid i nei j : InGradedMesh cells tid -> InGradedMesh cells nei ->
    SameVertices (GradedFace tid i) (GradedFace nei j) ->
    StructuredName tid = None \/ StructuredName nei = None ->
    forall f, In f (GradedFace tid i) -> CornerSigns mesh f = Plus.
  Proof.
    intros M M' F [N | N] f I; [|apply F in I];
      apply FaceHas in I; destruct I as (k & _ & ->).
    - exact (PlainIsPlus method sign domain cells IsOne Kept tid k M N).
    - exact (PlainIsPlus method sign domain cells IsOne Kept nei k M' N).
  Qed.

  Lemma ConformsAcross tid i a b c : InGradedMesh cells tid ->
    let face := GradedFace tid i in
    LiesIn face a -> LiesIn face b -> LiesIn face c ->
    (exists f, In f face /\ SignIn mesh (Corner f) = Plus) ->
    AmongTriangles (within tid) a b c <->
    AmongTriangles (within (GradedNeighbor cells tid i)) a b c.
  Proof.
    intros M face La Lb Lc plus. destruct (NeighborSides tid i M) as (M' & j & F & _).
    assert (inside : StructuredName tid = None \/
      StructuredName (GradedNeighbor cells tid i) = None ->
      AmongTriangles (within tid) a b c <->
      AmongTriangles (within (GradedNeighbor cells tid i)) a b c).
    { intros N. pose proof (FaceInside tid i _ j M M' F N) as P.
      rewrite (WholeInside tid i a b c M P La Lb Lc).
      rewrite (WholeInside _ j a b c M');
        [| intros f I; apply P; now apply F | now apply (LiesSame _ _ _ F) ..].
      split; apply WholeSame; [exact F | now apply SameSym]. }
    destruct (StructuredName tid) as [stid|] eqn:N; [|now apply inside; left].
    destruct (StructuredName (GradedNeighbor cells tid i)) as [other|] eqn:N';
      [|now apply inside; right].
    clear inside. unfold GradedTetsWithin. rewrite N, N'.
    rewrite (StructuredNeighbor tid i stid other M N N').
    pose proof (MeshConforms method sign domain) as conform.
    subst face. rewrite <- (FaceOfStructured tid stid i M N) in *.
    exact (proj1 (conform stid i a b c La Lb Lc) plus).
  Qed.

  Lemma CornersWithin tid t v : InGradedMesh cells tid -> In t (within tid) ->
    In (Corner v) (TetCorners t) -> exists k, v = GradedVertexAt tid k.
  Proof.
    intros M T I. unfold GradedTetsWithin in T.
    destruct (StructuredName tid) as [stid|] eqn:N.
    - destruct (StructuredNameCorrect cells tid stid M N) as (even & V & _).
      destruct (NamesVertices _ _ (MeshJoins method sign domain) stid t _ even T I) as [(k & K) | (k & l & K & _)];
        [|discriminate K]. injection K as ->. exists k. now rewrite V.
    - destruct T as [<- | []]. apply CornersOfMap in I. destruct I as (w & I & [= ->]).
      now apply GradedVertexIn.
  Qed.
  Theorem GradedFacesConform tid i a b c : InGradedMesh cells tid ->
    let face := GradedFace tid i in
    let here := within tid in
    LiesIn face a -> LiesIn face b -> LiesIn face c ->
    ((exists f, In f face /\ SignIn mesh (Corner f) = Plus) ->
     AmongTriangles here a b c <-> AmongTriangles (within (GradedNeighbor cells tid i)) a b c) /\
    (forall t u, In t here -> In u here ->
       HasTriangle t a b c -> HasTriangle u a b c -> t = u).
  Proof.
    intros M face here La Lb Lc. split; [now apply ConformsAcross|].
    intros t u T U HT HU. subst here. unfold GradedTetsWithin in T, U.
    destruct (StructuredName tid) as [stid|] eqn:N.
    - pose proof (MeshConforms method sign domain) as conform.
      subst face. rewrite <- (FaceOfStructured tid stid i M N) in *.
      exact (proj2 (conform stid i a b c La Lb Lc) t u T U HT HU).
    - destruct T as [<- | []], U as [<- | []]. reflexivity.
  Qed.

  (** ** The boundary *)

  (** Across a face that is inside, where either side is kept whole, there is
      another tetrahedron. *)
  Lemma AnotherAcross tid i t a b c : InGradedMesh cells tid ->
    In t (within tid) -> HasTriangle t a b c ->
    LiesIn (GradedFace tid i) a -> LiesIn (GradedFace tid i) b ->
    LiesIn (GradedFace tid i) c ->
    StructuredName tid = None \/ StructuredName (GradedNeighbor cells tid i) = None ->
    exists u, u <> t /\ HasTriangle u a b c /\
      In u (within (GradedNeighbor cells tid i)).
  Proof.
    intros M T H La Lb Lc N. destruct (NeighborSides tid i M) as (M' & j & F & A & B).
    pose proof (FaceInside tid i _ j M M' F N) as P.
    destruct (FaceTriple tid i) as (f & _ & _ & I & _).
    destruct (proj1 (ConformsAcross tid i a b c M La Lb Lc
      (ex_intro _ f (conj I (P f I))))) as (u & U & HU); [exists t; auto|].
    exists u. split; [|auto]. intros ->. destruct N as [N | N].
    - unfold GradedTetsWithin in T. rewrite N in T. destruct T as [<- | []].
      destruct (CornersWithin _ _ (GradedVertexAt tid i) M' U) as [k E];
        [|exact (A k E)].
      apply CornersOfMap. eexists. split; [apply VertexOfTet | reflexivity].
    - unfold GradedTetsWithin in U. rewrite N in U. destruct U as [<- | []].
      destruct (CornersWithin _ _
        (GradedVertexAt (GradedNeighbor cells tid i) j) M T) as [k E]; [|exact (B k E)].
      apply CornersOfMap. eexists. split; [apply VertexOfTet | reflexivity].
  Qed.

  Lemma RemainingPlace (i j k : Place) : i <> j -> j <> k -> i <> k ->
    exists l, i <> l /\ j <> l /\ k <> l.
  Proof.
    destruct i, j, k; intros; try congruence;
      solve [exists First; repeat split; discriminate
            |exists Second; repeat split; discriminate
            |exists Third; repeat split; discriminate
            |exists Fourth; repeat split; discriminate].
  Qed.

  Lemma PlainAnother tid t a b c : InGradedMesh cells tid ->
    StructuredName tid = None -> In t (within tid) -> HasTriangle t a b c ->
    exists i u, u <> t /\ HasTriangle u a b c /\
      In u (within (GradedNeighbor cells tid i)).
  Proof.
    intros M N T H. pose proof H as ((A & B & C) & D & E & F).
    assert (V : forall m, In m (TetCorners t) -> exists i, m = Corner (GradedVertexAt tid i)).
    { intros m I. unfold GradedTetsWithin in T. rewrite N in T. destruct T as [<- | []].
      apply CornersOfMap in I. destruct I as (v & I & ->).
      destruct (GradedVertexIn tid v I) as [i ->]. now exists i. }
    destruct (V a A) as [i ->], (V b B) as [j ->], (V c C) as [k ->].
    destruct (RemainingPlace i j k) as (l & Li & Lj & Lk); [congruence ..|].
    assert (L : forall p, p <> l ->
      LiesIn (GradedFace tid l) (Corner (GradedVertexAt tid p)))
      by (intros p P; cbn [LiesIn]; apply FaceHas; eauto).
    exists l. apply AnotherAcross; auto.
  Qed.

  Theorem GradedBoundaryOnSurface tid t a b c : InGradedMesh cells tid ->
    In t (within tid) -> HasTriangle t a b c ->
    (SignIn mesh a = OnSurface /\ SignIn mesh b = OnSurface /\ SignIn mesh c = OnSurface) \/
    (exists u, u <> t /\ HasTriangle u a b c /\
       (In u (within tid) \/ exists i, In u (within (GradedNeighbor cells tid i)))).
  Proof.
    intros M T H. destruct (StructuredName tid) as [stid|] eqn:N.
    - pose proof T as T'. unfold GradedTetsWithin in T'. rewrite N in T'.
      pose proof (MeshBoundary method sign domain) as boundary.
      destruct (boundary stid t a b c T' H) as [S | (u & D & HU & [U | (k & U)])];
        [now left | right | right].
      + exists u. unfold GradedTetsWithin. rewrite N. auto.
      + destruct (StructuredNameCorrect cells tid stid M N) as (even & _).
        assert (L : forall m, In m (TetCorners t) -> In m (TetCorners u) ->
          LiesIn (GradedFace tid k) m).
        { rewrite <- (FaceOfStructured tid stid k M N).
          intros m. now apply (SharedLiesIn _ _ (MeshJoins method sign domain) stid k t u). }
        pose proof H as ((A & B & C) & _). pose proof HU as ((A' & B' & C') & _).
        destruct (StructuredName (GradedNeighbor cells tid k)) as [other|] eqn:N'.
        * exists u. split; [exact D|]. split; [exact HU|]. right. exists k.
          unfold GradedTetsWithin. rewrite N'.
          now rewrite (StructuredNeighbor tid k stid other M N N').
        * destruct (AnotherAcross tid k t a b c M T H (L a A A') (L b B B') (L c C C'))
            as (u' & D' & HU' & U'); [now right|]. eauto 8.
    - right. destruct (PlainAnother tid t a b c M N T H) as (i & u & D & HU & U). eauto 8.
  Qed.
End Mesh.
