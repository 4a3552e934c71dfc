(** * Symbols as names of mesh vertices

    If the five lattice vertices of two adjacent tetrahedra are distinct,
    symbols and the mesh vertices they stand for correspond one to one, and what
    holds of the stencils on symbols holds of [StuffTet]. *)

From Certet Require Import Stuffing.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stencil.TriangleChecker.

(** How a vertex is warped plays no part, and is costly to look into. *)
Local Opaque WarpVertex.

(** ** Orientation moves no corner to another tetrahedron *)

Lemma OrientCorners h t m : In m (TetCorners (Orient h t)) <-> In m (TetCorners t).
Proof. destruct h, t; cbn; tauto. Qed.

Lemma OrientHasTriangle h t a b c :
  HasTriangle (Orient h t) a b c <-> HasTriangle t a b c.
Proof. unfold HasTriangle; rewrite !OrientCorners; tauto. Qed.

Lemma OrientInjective h t u : Orient h t = Orient h u -> t = u.
Proof. destruct h, t, u; cbn; congruence. Qed.

Section Names.
  Variables f1 f2 f3 p q : Coord3.
  Hypothesis distinct : NoDup [f1; f2; f3; p; q].

  Definition LocateFive : Label -> Coord3 := Locate Coord3 f1 f2 f3 p q.

  Definition Name : Symbol -> MeshVertex :=
    Interpret MeshVertex MeshIntersection
      (Corner f1) (Corner f2) (Corner f3) (Corner p) (Corner q).

  Lemma LocateCorner (l : Label) :
    Locate MeshVertex (Corner f1) (Corner f2) (Corner f3) (Corner p) (Corner q) l
    = Corner (LocateFive l).
  Proof. now destruct l. Qed.

  Lemma NameBase (l : Label) : Name (Base l) = Corner (LocateFive l).
  Proof. apply LocateCorner. Qed.

  Lemma NameCut (a b : Label) :
    Name (CutOf a b) = Cut (LocateFive a) (LocateFive b).
  Proof. cbn; now rewrite !LocateCorner. Qed.

  (** ** One to one *)

  Lemma LocateInjective (a b : Label) : LocateFive a = LocateFive b -> a = b.
  Proof.
    repeat match goal with H : NoDup (_ :: _) |- _ =>
      apply NoDup_cons_iff in H as [? H]; cbn [In] in * end.
    destruct a, b; cbn; intros same; try reflexivity; exfalso; intuition congruence.
  Qed.

  Lemma NameInjective (s t : Symbol) : Name s = Name t -> s = t.
  Proof.
    destruct s, t; rewrite ?NameBase, ?NameCut; intros [=]; f_equal;
      now apply LocateInjective.
  Qed.

  Lemma MapNameInjective (t u : SymbolicTet) : MapTet Name t = MapTet Name u -> t = u.
  Proof.
    destruct t, u; cbn; intros [=]; f_equal; now apply NameInjective.
  Qed.

  Lemma OnFaceIn (face : list Label) (l : Label) :
    existsb (SameLabel l) face = true <-> In (LocateFive l) (map LocateFive face).
  Proof.
    rewrite existsb_exists, in_map_iff; split.
    - intros (m & inside & ->%SameLabelEqual); eauto.
    - intros (m & same & inside); exists m; rewrite SameLabelEqual.
      split; [easy | symmetry; now apply LocateInjective].
  Qed.

  Lemma LiesOnLiesIn (face : list Label) (s : Symbol) :
    LiesOn face s = true <-> LiesIn (map LocateFive face) (Name s).
  Proof.
    destruct s; rewrite ?NameBase, ?NameCut; cbn;
      rewrite ?andb_true_iff, ?OnFaceIn; tauto.
  Qed.

  Lemma TriangleOnLiesIn (face : list Label) (a b c : Symbol) :
    TriangleOn face (a, b, c) = true <->
    LiesIn (map LocateFive face) (Name a) /\
    LiesIn (map LocateFive face) (Name b) /\
    LiesIn (map LocateFive face) (Name c).
  Proof. cbn; rewrite !andb_true_iff, !LiesOnLiesIn; tauto. Qed.

  (** What lies in a face has a name. *)
  Lemma LiesInName (face : list Label) (v : MeshVertex) :
    LiesIn (map LocateFive face) v -> exists s, v = Name s.
  Proof.
    destruct v as [x | x y]; cbn [LiesIn]; rewrite !in_map_iff.
    - intros (l & <- & _); exists (Base l); now rewrite NameBase.
    - intros [(l & <- & _) (m & <- & _)]; exists (CutOf l m); now rewrite NameCut.
  Qed.

  (** ** Triangles *)

  Lemma MapTetCorners (t : SymbolicTet) :
    TetCorners (MapTet Name t) = map Name (TetCorners t).
  Proof. now destruct t. Qed.

  Lemma InNames (s : Symbol) (symbols : list Symbol) :
    In (Name s) (map Name symbols) <-> In s symbols.
  Proof.
    split; [| apply in_map].
    rewrite in_map_iff; now intros (t & ->%NameInjective & inside).
  Qed.

  Lemma HasTriangleName (t : SymbolicTet) (a b c : Symbol) :
    HasTriangle (MapTet Name t) (Name a) (Name b) (Name c) <-> HasTriangle t a b c.
  Proof.
    unfold HasTriangle; rewrite MapTetCorners, !InNames.
    assert (apart : forall s r, Name s <> Name r <-> s <> r).
    { split; [congruence | intros differ same; now apply differ, NameInjective]. }
    now rewrite !apart.
  Qed.

  Lemma HasTriangleNamed (t : SymbolicTet) (x y z : MeshVertex) :
    HasTriangle (MapTet Name t) x y z ->
    exists a b c, x = Name a /\ y = Name b /\ z = Name c /\ HasTriangle t a b c.
  Proof.
    intros has; pose proof has as [(in_x & in_y & in_z) _].
    rewrite MapTetCorners, in_map_iff in in_x, in_y, in_z.
    destruct in_x as (a & <- & _), in_y as (b & <- & _), in_z as (c & <- & _).
    exists a, b, c; repeat (split; [reflexivity |]); now apply HasTriangleName.
  Qed.

  (** ** [StuffTet] in names *)

  Variables (th : Thresholds) (sign : SignField) (cut : CutField).

  Definition CornerSign (c : Coord3) : Sign :=
    MeshVertexSign th sign cut (Corner c).

  Definition LabelSign : Label -> Sign :=
    SignOf (CornerSign f1) (CornerSign f2) (CornerSign f3)
           (CornerSign p) (CornerSign q).

  Lemma LabelSignCorner (l : Label) : LabelSign l = CornerSign (LocateFive l).
  Proof. now destruct l. Qed.

  Lemma SymbolSignName (s : Symbol) :
    SymbolSign LabelSign s = MeshVertexSign th sign cut (Name s).
  Proof.
    destruct s as [l | a b].
    - rewrite NameBase; exact (LabelSignCorner l).
    - rewrite NameCut; reflexivity.
  Qed.

  Lemma SomePlusCorner (face : list Label) :
    SomePlus LabelSign face = true <->
    exists f, In f (map LocateFive face) /\ CornerSign f = Plus.
  Proof.
    unfold SomePlus; rewrite existsb_exists; split.
    - intros (l & inside & plus); exists (LocateFive l); split; [now apply in_map |].
      rewrite <- LabelSignCorner; now destruct (LabelSign l).
    - intros (f & inside & plus).
      apply in_map_iff in inside as (l & <- & inside).
      exists l; rewrite LabelSignCorner, plus; auto.
  Qed.

  (** The tetrahedron's vertices, in its own order. *)
  Definition VerticesAre (tid : StructuredTetId) (a b c d : Label) : Prop :=
    match GetStructuredTet tid with ST v1 v2 v3 v4 _ _ _ _ =>
      v1 = LocateFive a /\ v2 = LocateFive b /\
      v3 = LocateFive c /\ v4 = LocateFive d
    end.

  Definition NamedTets : Label -> Label -> Label -> Label -> list SymbolicTet :=
    SymbolicTets GetUnstructuredTets LabelSign.

  Lemma StuffTetNamed (tid : StructuredTetId) (a b c d : Label) :
    VerticesAre tid a b c d ->
    exists h, StuffTet th sign cut tid
              = map (fun t => Orient h (MapTet Name t)) (NamedTets a b c d).
  Proof.
    unfold VerticesAre; destruct tid as [anchor case]; cbn [StuffTet].
    destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4].
    intros (-> & -> & -> & ->); exists (CaseHandedness case).
    rewrite <- !LocateCorner, (InterpretTets _ GetUnstructuredTetsNatural).
    apply map_map.
  Qed.

  Lemma AmongStuffTet (tid : StructuredTetId) (a b c d : Label) (x y z : Symbol) :
    VerticesAre tid a b c d ->
    AmongTriangles (StuffTet th sign cut tid) (Name x) (Name y) (Name z) <->
    AmongTriangles (NamedTets a b c d) x y z.
  Proof.
    intros [h ->]%StuffTetNamed; split.
    - intros (t & inside & has); apply in_map_iff in inside as (s & <- & inside).
      exists s; split; [easy |].
      now apply HasTriangleName, (OrientHasTriangle h).
    - intros (s & inside & has); exists (Orient h (MapTet Name s)); split.
      + apply in_map_iff; eauto.
      + now apply OrientHasTriangle, HasTriangleName.
  Qed.
End Names.
