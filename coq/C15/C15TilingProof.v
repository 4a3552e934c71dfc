(** * C15 is a tiling whose neighbours know each other: proof

    Vertices stand at fixed offsets from their primitive cell, so that it is enough
    to look at the tetrahedra of one. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Cases.Isometry Lattice.Tiling
  C15.Sites C15.C15Tet C15.C15Spec.
Open Scope Z_scope.
Open Scope bool_scope.

Definition AllPlaces : list Place := [First; Second; Third; Fourth].

Definition SamePlace (i j : Place) : bool :=
  match i, j with
  | First, First | Second, Second | Third, Third | Fourth, Fourth => true
  | _, _ => false
  end.

Lemma SamePlaceEqual i j : SamePlace i j = true <-> i = j.
Proof. destruct i, j; cbn; intuition congruence. Qed.

Lemma InAllPlaces i : In i AllPlaces.
Proof. destruct i; cbn; tauto. Qed.

Lemma InAllC15Cases case : In case AllC15Cases.
Proof. destruct case; cbn; tauto. Qed.

(** What a look at all cases and places finds is so. *)
Lemma OfEachPlace (test : C15Case -> Place -> bool) :
  forallb (fun case => forallb (test case) AllPlaces) AllC15Cases = true ->
  forall case i, test case i = true.
Proof.
  intros T case i. rewrite forallb_forall in T. specialize (T case (InAllC15Cases case)).
  rewrite forallb_forall in T. exact (T i (InAllPlaces i)).
Qed.

Lemma OfEachTwoPlaces (test : C15Case -> Place -> Place -> bool) :
  forallb (fun case => forallb (fun i => forallb (test case i) AllPlaces) AllPlaces)
    AllC15Cases = true ->
  forall case i j, test case i j = true.
Proof.
  intros T case i j.
  pose proof (OfEachPlace (fun case i => forallb (test case i) AllPlaces) T case i) as T'.
  cbv beta in T'. rewrite forallb_forall in T'. exact (T' j (InAllPlaces j)).
Qed.

(** ** Cells *)

Lemma CellTranslated c d :
  CellPosition (Translate c d) = Translate (CellPosition c) (CellPosition d).
Proof. destruct c, d. cbn [CellPosition Translate]. f_equal; ring. Qed.

Lemma TranslateAssociative a b c :
  Translate (Translate a b) c = Translate a (Translate b c).
Proof. destruct a, b, c. cbn [Translate]. f_equal; ring. Qed.

Lemma TranslateInjective a x y : Translate a x = Translate a y -> x = y.
Proof.
  destruct a, x, y. cbn [Translate]. intros E. injection E as E1 E2 E3.
  f_equal; lia.
Qed.

(** ** Neighbours *)

Lemma PickFour {A : Type} (f : Place -> A) i :
  Pick (f First, f Second, f Third, f Fourth) i = f i.
Proof. destruct i; reflexivity. Qed.

(** The neighbour's vertex that stands at place [j], as in the first cell. *)
Definition LinedCorner (case : C15Case) (i j : Place) : Coord3 :=
  match C15NeighborOf case i with
    Nei away other p q r s =>
      Translate (CellPosition away) (C15Corner other (Pick (p, q, r, s) j))
  end.

Lemma LinedUpAt cell case i j :
  LinedUp C15Tiling (C15Id cell case) i j
  = Translate (CellPosition cell) (LinedCorner case i j).
Proof.
  unfold LinedUp, LinedCorner. cbn [C15Tiling NeighborAt VertexOf C15Across].
  destruct (C15NeighborOf case i) as [away other p q r s].
  cbv beta iota zeta delta [OrderOfPlaces].
  rewrite !(PickFour (C15Vertex _)).
  destruct j; cbn [Pick C15Vertex];
    rewrite CellTranslated, TranslateAssociative; reflexivity.
Qed.

Lemma LinedCorners case i j :
  Coord3Equal (LinedCorner case i j) (C15Corner case j) = negb (SamePlace i j).
Proof.
  apply eqb_prop.
  exact (OfEachTwoPlaces (fun case i j =>
    eqb (Coord3Equal (LinedCorner case i j) (C15Corner case j)) (negb (SamePlace i j)))
    ltac:(vm_compute; reflexivity) case i j).
Qed.

Theorem C15FacesCorrect : TilingFacesCorrect C15Tiling.
Proof.
  intros [cell case] i j. rewrite LinedUpAt. cbn [C15Tiling VertexOf C15Vertex].
  pose proof (LinedCorners case i j) as L.
  destruct (SamePlace i j) eqn:S; cbn [negb] in L.
  - apply SamePlaceEqual in S. subst j. split; [|congruence].
    intros E. apply TranslateInjective in E. rewrite E, Coord3EqualRefl in L.
    discriminate L.
  - apply Coord3EqualTrue in L. rewrite L. split; [|reflexivity].
    intros _ E. subst j. rewrite (proj2 (SamePlaceEqual i i) eq_refl) in S.
    discriminate S.
Qed.

(** *** The way back *)

(** Cases are told apart by their corners. *)
Definition SameCase (a b : C15Case) : bool :=
  forallb (fun i => Coord3Equal (C15Corner a i) (C15Corner b i)) AllPlaces.

Lemma CaseFound a : find (SameCase a) AllC15Cases = Some a.
Proof. destruct a; reflexivity. Qed.

Lemma FindAlike {A : Type} (f g : A -> bool) l :
  (forall x, f x = g x) -> find f l = find g l.
Proof.
  intros E. induction l as [|x r IH]; [reflexivity|]. cbn [find]. rewrite E, IH.
  reflexivity.
Qed.

Lemma SameCaseEqual a b : SameCase a b = true -> a = b.
Proof.
  unfold SameCase. rewrite forallb_forall. intros S.
  assert (E : forall i, C15Corner a i = C15Corner b i)
    by (intros i; apply Coord3EqualTrue, S, InAllPlaces).
  assert (Some a = Some b) as same; [|congruence].
  rewrite <- (CaseFound a), <- (CaseFound b). apply FindAlike. intros c. unfold SameCase.
  cbn [forallb AllPlaces]. rewrite !E. reflexivity.
Qed.

Definition PlacesUndo (p q : Place * Place * Place * Place) : bool :=
  forallb (fun i => SamePlace (Pick p (Pick q i)) i) AllPlaces.

Lemma PickPick {A : Type} (t : A * A * A * A) p1 p2 p3 p4 i :
  Pick (Pick t p1, Pick t p2, Pick t p3, Pick t p4) i = Pick t (Pick (p1, p2, p3, p4) i).
Proof. destruct i; reflexivity. Qed.

Lemma PlacesUndone p q r s p' q' r' s' :
  PlacesUndo (p, q, r, s) (p', q', r', s') = true ->
  Undoes (OrderOfPlaces p' q' r' s') (OrderOfPlaces p q r s).
Proof.
  unfold PlacesUndo, AllPlaces. cbn [forallb]. rewrite !andb_true_iff, !SamePlaceEqual.
  intros (E1 & E2 & E3 & E4 & _) a b c d.
  cbv beta iota zeta delta [OrderOfPlaces].
  rewrite !PickPick.
  change (Pick (p', q', r', s') First) with p' in E1.
  change (Pick (p', q', r', s') Second) with q' in E2.
  change (Pick (p', q', r', s') Third) with r' in E3.
  change (Pick (p', q', r', s') Fourth) with s' in E4.
  rewrite E1, E2, E3, E4. reflexivity.
Qed.

(** The neighbour across from [i] has at place [j] the vertex that the tetrahedron
    has not, and leads back from there. *)
Definition LeadsBack (case : C15Case) (i j : Place) : bool :=
  match C15NeighborOf case i with
    Nei away other p q r s =>
      SamePlace j (Pick (p, q, r, s) i) &&
      match C15NeighborOf other j with
        Nei back case' p' q' r' s' =>
          Coord3Equal (Translate away back) (C3 0 0 0) && SameCase case' case &&
          PlacesUndo (p, q, r, s) (p', q', r', s') &&
          PlacesUndo (p', q', r', s') (p, q, r, s)
      end
  end.

Theorem C15NeighborInvolution : TilingInvolution C15Tiling.
Proof.
  intros [cell case] i.
  pose proof (OfEachPlace (fun case i => existsb (LeadsBack case i) AllPlaces)
    ltac:(vm_compute; reflexivity) case i) as T.
  apply existsb_exists in T. destruct T as (j & _ & T). unfold LeadsBack in T.
  rewrite LinedUpAt. unfold LinedCorner.
  cbn [C15Tiling NeighborAt VertexOf C15Across Identifier].
  destruct (C15NeighborOf case i) as [away other p q r s].
  apply andb_prop in T. destruct T as [J T]. apply SamePlaceEqual in J.
  destruct (C15NeighborOf other j) as [back case' p' q' r' s'] eqn:B.
  rewrite !andb_true_iff in T. destruct T as [[[A C] U] U'].
  apply Coord3EqualTrue in A.
  apply SameCaseEqual in C.
  subst case'.
  exists j, (OrderOfPlaces p' q' r' s'). cbn [C15Vertex C15Across].
  rewrite B. split; [|split; [|split]].
  - rewrite CellTranslated, TranslateAssociative, <- J. reflexivity.
  - f_equal. f_equal. rewrite TranslateAssociative, A.
    destruct cell. cbn [Translate]. f_equal; ring.
  - apply PlacesUndone, U.
  - apply PlacesUndone, U'.
Qed.

(** ** Vertices *)

Theorem C15VerticesApart : VerticesApart C15Tiling.
Proof.
  intros [cell case] i j. cbn [C15Tiling VertexOf C15Vertex]. intros E.
  apply TranslateInjective in E.
  pose proof (OfEachTwoPlaces (fun case i j =>
    eqb (Coord3Equal (C15Corner case i) (C15Corner case j)) (SamePlace i j))
    ltac:(vm_compute; reflexivity) case i j) as T.
  apply eqb_prop in T. rewrite E, Coord3EqualRefl in T. apply SamePlaceEqual. auto.
Qed.

Lemma ModuloFour k x : (4 * k + x) mod 4 = x mod 4.
Proof. rewrite Z.add_comm, Z.mul_comm. apply Z.mod_add. discriminate. Qed.

(** Cells are translated images of one another. *)
Lemma SiteTranslated cell p : SiteOf (Translate (CellPosition cell) p) = SiteOf p.
Proof.
  destruct cell, p. cbn [CellPosition Translate SiteOf]. rewrite !ModuloFour.
  reflexivity.
Qed.

Lemma OffsetsTranslated cell p :
  OffsetsAround (Translate (CellPosition cell) p) = OffsetsAround p.
Proof. unfold OffsetsAround. now rewrite SiteTranslated. Qed.

Lemma MetalTranslated cell p :
  MetalOf (Translate (CellPosition cell) p) = MetalOf p.
Proof. unfold MetalOf. now rewrite SiteTranslated. Qed.

Lemma DifferenceTranslated a x y :
  Difference (Translate a x) (Translate a y) = Difference x y.
Proof. destruct a, x, y. cbn [Difference Translate]. f_equal; ring. Qed.

(** The primitive cell that a vertex of the lattice is in. *)
Definition CellOf (p : Coord3) : Coord3 :=
  match Difference (SitePosition (SiteOf p)) p with
    C3 x y z =>
      let half := (x / 4 + y / 4 + z / 4) / 2 in
      C3 (half - x / 4) (half - y / 4) (half - z / 4)
  end.

Definition IsVertexTest (p : Coord3) : bool :=
  Coord3Equal p (Translate (CellPosition (CellOf p)) (SitePosition (SiteOf p))).

Theorem C15VerticesInLattice tid i : IsC15Vertex (C15Vertex tid i).
Proof.
  destruct tid as [cell case]. cbn [C15Vertex].
  pose proof (OfEachPlace (fun case i => IsVertexTest (C15Corner case i))
    ltac:(vm_compute; reflexivity) case i) as T.
  apply Coord3EqualTrue in T. unfold IsC15Vertex. rewrite SiteTranslated.
  exists (Translate cell (CellOf (C15Corner case i))).
  rewrite CellTranslated, TranslateAssociative. now f_equal.
Qed.

Lemma MemberOffset o l : existsb (Coord3Equal o) l = true <-> In o l.
Proof.
  rewrite existsb_exists. split.
  - intros (x & I & E). apply Coord3EqualTrue in E. now subst.
  - intros I. exists o. split; [exact I|apply Coord3EqualRefl].
Qed.

Theorem C15VerticesJoined tid i j : i <> j ->
  C15Edge (C15Vertex tid i) (C15Vertex tid j).
Proof.
  intros N. destruct tid as [cell case]. unfold C15Edge. cbn [C15Vertex].
  rewrite OffsetsTranslated, DifferenceTranslated. apply MemberOffset.
  pose proof (OfEachTwoPlaces (fun case i j => SamePlace i j ||
    existsb (Coord3Equal (Difference (C15Corner case i) (C15Corner case j)))
      (OffsetsAround (C15Corner case i))) ltac:(vm_compute; reflexivity) case i j) as T.
  cbv beta in T. apply orb_prop in T. destruct T as [T|T]; [|exact T].
  apply SamePlaceEqual in T. contradiction.
Qed.

(** *** Edges are those between vertices of the lattice at such a distance *)

Lemma VertexAtSite p : IsC15Vertex p -> exists cell s,
  p = Translate (CellPosition cell) (SitePosition s) /\ SiteOf (SitePosition s) = s.
Proof.
  intros (cell & E). exists cell, (SiteOf p). split; [exact E|].
  destruct (SiteOf p); reflexivity.
Qed.

Lemma InAllSites s : In s AllSites.
Proof. destruct s; cbn; tauto. Qed.

Lemma SquareAtMost x : x * x <= 12 -> In x [-3; -2; -1; 0; 1; 2; 3].
Proof.
  intros L. assert (-4 < x < 4) by nia.
  assert (x = -3 \/ x = -2 \/ x = -1 \/ x = 0 \/ x = 1 \/ x = 2 \/ x = 3) by lia.
  cbn [In]. intuition.
Qed.

Lemma JoinedAtMost a b : JoinedSquared a b <= 12.
Proof. destruct a, b; cbn; lia. Qed.

Lemma EdgesThere : forallb (fun s => forallb (fun o =>
    let p := SitePosition s in
    let q := Translate p o in
    IsVertexTest q && (EdgeSquared p q =? JoinedSquared (SiteMetal s) (MetalOf q)) &&
    existsb (Coord3Equal (Difference q p)) (OffsetsAround q))
  (SiteOffsets s)) AllSites = true.
Proof. vm_compute. reflexivity. Qed.

Definition SmallOffsets : list Coord3 :=
  let r := [-3; -2; -1; 0; 1; 2; 3] in
  flat_map (fun x => flat_map (fun y => map (fun z => C3 x y z) r) r) r.

(** Whether a point is a vertex, and no more than a cell away, by parities. *)
Definition MayBeVertex (p : Coord3) : bool :=
  match Difference (SitePosition (SiteOf p)) p with
    C3 x y z =>
      (x mod 4 =? 0) && (y mod 4 =? 0) && (z mod 4 =? 0) &&
      ((x / 4 + y / 4 + z / 4) mod 2 =? 0)
  end.

Lemma VertexMayBe p : IsC15Vertex p -> MayBeVertex p = true.
Proof.
  intros ([i j k] & E). unfold MayBeVertex. set (s := SitePosition (SiteOf p)) in *.
  assert (D : Difference s p = C3 (4 * (j + k)) (4 * (i + k)) (4 * (i + j))).
  { rewrite E. destruct s. cbn [CellPosition Translate Difference]. f_equal; ring. }
  rewrite D. rewrite !(Z.mul_comm 4), !Z.mod_mul, !Z.div_mul by discriminate.
  replace (j + k + (i + k) + (i + j)) with ((i + j + k) * 2) by ring.
  rewrite Z.mod_mul by discriminate. reflexivity.
Qed.

Lemma EdgesAll : forallb (fun s => forallb (fun o =>
    let p := SitePosition s in
    let q := Translate p o in
    negb (MayBeVertex q && (Dot o o =? JoinedSquared (SiteMetal s) (MetalOf q))) ||
    existsb (Coord3Equal o) (SiteOffsets s))
  SmallOffsets) AllSites = true.
Proof. vm_compute. reflexivity. Qed.

Theorem C15EdgesAreThese a b : IsC15Vertex a -> IsC15Vertex b ->
  C15Edge a b <-> EdgeSquared a b = JoinedSquared (MetalOf a) (MetalOf b).
Proof.
  intros Va Vb. destruct (VertexAtSite a Va) as (cell & s & -> & S).
  set (o := Difference (Translate (CellPosition cell) (SitePosition s)) b).
  assert (B : b = Translate (CellPosition cell) (Translate (SitePosition s) o)).
  { unfold o. destruct (CellPosition cell), (SitePosition s), b.
    cbn [Difference Translate]. f_equal; ring. }
  unfold C15Edge. fold o. rewrite OffsetsTranslated. unfold OffsetsAround. rewrite S.
  rewrite MetalTranslated.
  assert (M : MetalOf b = MetalOf (Translate (SitePosition s) o))
    by (rewrite B at 1; apply MetalTranslated).
  assert (Q : EdgeSquared (Translate (CellPosition cell) (SitePosition s)) b = Dot o o)
    by reflexivity.
  assert (S' : MetalOf (SitePosition s) = SiteMetal s) by (unfold MetalOf; now rewrite S).
  rewrite Q, M, S'. split.
  - intros I. pose proof EdgesThere as T. rewrite forallb_forall in T.
    specialize (T s (InAllSites s)). rewrite forallb_forall in T. specialize (T o I).
    cbv beta zeta in T. rewrite !andb_true_iff, Z.eqb_eq in T.
    destruct T as [[_ T] _]. rewrite <- T. unfold EdgeSquared.
    replace (Difference (SitePosition s) (Translate (SitePosition s) o)) with o;
      [reflexivity|].
    destruct (SitePosition s), o. cbn [Difference Translate]. f_equal; ring.
  - intros E. apply MemberOffset. pose proof EdgesAll as T. rewrite forallb_forall in T.
    specialize (T s (InAllSites s)). rewrite forallb_forall in T.
    assert (I : In o SmallOffsets).
    { assert (L : Dot o o <= 12).
      { rewrite E. apply JoinedAtMost. }
      clearbody o. destruct o as [x y z]. cbn [Dot] in L.
      pose proof (Z.square_nonneg x). pose proof (Z.square_nonneg y).
      pose proof (Z.square_nonneg z).
      unfold SmallOffsets. cbv zeta.
      apply in_flat_map. exists x. split; [apply SquareAtMost; lia|].
      apply in_flat_map. exists y. split; [apply SquareAtMost; lia|].
      apply in_map. apply SquareAtMost. lia. }
    specialize (T o I). cbv beta zeta in T. apply orb_prop in T.
    destruct T as [T|T]; [|exact T]. exfalso.
    rewrite E, Z.eqb_refl, andb_true_r in T.
    assert (V : MayBeVertex (Translate (SitePosition s) o) = true).
    { apply VertexMayBe. destruct Vb as (cell' & Eb).
      exists (Translate cell' (match cell with C3 i j k => C3 (-i) (-j) (-k) end)).
      assert (Sb : SiteOf b = SiteOf (Translate (SitePosition s) o))
        by (rewrite B at 1; apply SiteTranslated).
      rewrite <- Sb. apply (TranslateInjective (CellPosition cell)).
      rewrite <- B, Eb at 1. destruct cell, cell', (SitePosition (SiteOf b)).
      cbn [CellPosition Translate]. f_equal; ring. }
    rewrite V in T. discriminate T.
Qed.

(** ** Volumes *)

Theorem C15VolumesPositive case : 0 < C15SixVolume case.
Proof. destruct case; reflexivity. Qed.

Theorem C15VolumesFill : C15SixVolumes = CellSixVolume.
Proof. vm_compute. reflexivity. Qed.
