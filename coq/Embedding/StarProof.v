(** * The structured tetrahedra around a lattice point

    Any two of them are joined by neighbours across faces that have the point as
    a corner; and every edge of the point is in one of them.  Both are looked up
    around the few points near the origin and moved. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Lattice.FaceProof Angles.Cases.Isometry
  Embedding.EdgeRank.
Open Scope Z_scope.

(** From one to the next across a face with corner [p]. *)
Inductive AroundPoint (p : Coord3) : StructuredTetId -> StructuredTetId -> Prop :=
| Around_here : forall tid, In p (Corners tid) -> AroundPoint p tid tid
| Around_step : forall tid i target,
    In p (Corners tid) -> In p (FaceOf tid i) ->
    AroundPoint p (NeighborOf tid i) target -> AroundPoint p tid target.

(** ** Moving *)

Definition MoveId (a : Coord3) (tid : StructuredTetId) : StructuredTetId :=
  match tid with STId anchor case => STId (Translate a anchor) case end.

Lemma TranslateTwice a b c :
  Translate (Translate a b) c = Translate a (Translate b c).
Proof. destruct a, b, c. cbn [Translate]. f_equal; ring. Qed.

Lemma CornersMoved a tid :
  Corners (MoveId a tid) = map (Translate a) (Corners tid).
Proof.
  destruct tid as [anchor []]; cbn [MoveId]; unfold Corners;
    cbn [GetStructuredTet map]; rewrite !TranslateTwice; reflexivity.
Qed.

Lemma FaceMoved a tid i :
  FaceOf (MoveId a tid) i = map (Translate a) (FaceOf tid i).
Proof.
  unfold FaceOf. destruct tid as [anchor []], i; cbn [MoveId];
    cbn [GetStructuredTet FaceAcross map]; rewrite !TranslateTwice; reflexivity.
Qed.

Lemma NeighborMoved a tid i :
  NeighborOf (MoveId a tid) i = MoveId a (NeighborOf tid i).
Proof.
  unfold NeighborOf. destruct tid as [anchor []], i; cbn [MoveId];
    cbn [GetStructuredTet NeighborAcross fst MoveId];
    rewrite !TranslateTwice; reflexivity.
Qed.

Lemma AroundMoved a p tid target : AroundPoint p tid target ->
  AroundPoint (Translate a p) (MoveId a tid) (MoveId a target).
Proof.
  induction 1 as [tid I|tid i target I F _ IH].
  - constructor. rewrite CornersMoved. apply in_map, I.
  - apply Around_step with i.
    + rewrite CornersMoved. apply in_map, I.
    + rewrite FaceMoved. apply in_map, F.
    + rewrite NeighborMoved. exact IH.
Qed.

(** ** Looking up *)

Definition IsAmong (p : Coord3) (ps : list Coord3) : bool :=
  existsb (Coord3Equal p) ps.

(** In so many steps. *)
Fixpoint Reaches (steps : nat) (p : Coord3) (target tid : StructuredTetId)
  : bool :=
  IsAmong p (Corners tid) &&
  (IdEqual tid target ||
   match steps with
   | O => false
   | S fewer =>
       existsb (fun i => IsAmong p (FaceOf tid i) &&
         Reaches fewer p target (NeighborOf tid i)) AllPlaces
   end).

Lemma IsAmongMeans p ps : IsAmong p ps = true -> In p ps.
Proof.
  intros E. apply existsb_exists in E. destruct E as (q & I & E).
  apply Coord3EqualTrue in E. subst q. exact I.
Qed.

Lemma ReachesMeans steps p target : forall tid,
  Reaches steps p target tid = true -> AroundPoint p tid target.
Proof.
  induction steps as [|fewer IH]; intros tid R; cbn [Reaches] in R;
    apply andb_prop in R; destruct R as [I R]; apply IsAmongMeans in I;
    apply orb_prop in R; destruct R as [R|R]; try discriminate R;
    try (apply SameId in R; subst target; constructor; exact I).
  apply existsb_exists in R. destruct R as (i & _ & R).
  apply andb_prop in R. destruct R as [F R].
  apply Around_step with i; auto using IsAmongMeans.
Qed.

(** The one that all others lead to. *)
Definition Home (p : Coord3) : StructuredTetId :=
  match p with
    C3 x y z =>
      if Z.even x then STId (C3 (-2 + x) (-2 + y) (-2 + z)) Tet_I1
      else STId (C3 (-1 + x) (-3 + y) (-1 + z)) Tet_I1
  end.

Definition AtOrigin (case : StructuredTetCase) : StructuredTetId :=
  STId (C3 0 0 0) case.

(** Those of one case that have [p] as a corner. *)
Definition HasEvenAnchor (tid : StructuredTetId) : bool :=
  match tid with STId (C3 x y z) _ => Z.even x && Z.even y && Z.even z end.

Definition CheckStars : bool :=
  forallb (fun case => forallb (fun i =>
    let p := VertexAt (GetStructuredTet (AtOrigin case)) i in
    HasEvenAnchor (Home p) &&
    Reaches 6 p (Home p) (AtOrigin case) &&
    forallb (fun d => existsb (fun case' => existsb (fun j =>
      let other := STId (Difference
        (VertexAt (GetStructuredTet (AtOrigin case')) j) p) case' in
      HasEvenAnchor other && IsAmong p (Corners other) &&
      IsAmong (Translate p (Offset d)) (Corners other))
      AllPlaces) AllCases) AllDirections) AllPlaces) AllCases.

Lemma StarsChecked : CheckStars = true.
Proof. vm_compute. reflexivity. Qed.

(** ** Anywhere *)

Lemma HasEvenAnchorMeans a b c tid : HasEvenAnchor tid = true ->
  InLattice (MoveId (C3 (2 * a) (2 * b) (2 * c)) tid).
Proof.
  destruct tid as [[x y z] case]. cbn [HasEvenAnchor MoveId Translate InLattice].
  rewrite !andb_true_iff, !Z.even_spec. intros [[[i ->] [j ->]] [k ->]].
  repeat split; [exists (a + i)|exists (b + j)|exists (c + k)]; ring.
Qed.

(** A structured tetrahedron and its corner, moved from the origin. *)
Lemma FromOrigin tid p : InLattice tid -> In p (Corners tid) ->
  exists a b c case i, let even := C3 (2 * a) (2 * b) (2 * c) in
    tid = MoveId even (AtOrigin case) /\
    p = Translate even (VertexAt (GetStructuredTet (AtOrigin case)) i).
Proof.
  destruct tid as [[x y z] case]. intros ([a ->] & [b ->] & [c ->]) I.
  assert (E : STId (C3 (2 * a) (2 * b) (2 * c)) case
    = MoveId (C3 (2 * a) (2 * b) (2 * c)) (AtOrigin case))
    by (cbn [AtOrigin MoveId Translate]; do 2 f_equal; ring).
  rewrite E in *. exists a, b, c, case. rewrite CornersMoved in I.
  apply in_map_iff in I. destruct I as (q & <- & I).
  apply PlaceOf in I. destruct I as [i ->]. exists i. auto.
Qed.

Lemma HomeMoved a b c p : let even := C3 (2 * a) (2 * b) (2 * c) in
  Home (Translate even p) = MoveId even (Home p).
Proof.
  destruct p as [x y z]. cbn [Translate Home].
  rewrite Z.add_comm, Z.even_add_mul_2.
  destruct (Z.even x); cbn [MoveId Translate]; do 2 f_equal; ring.
Qed.

Lemma StarAt case i :
  let p := VertexAt (GetStructuredTet (AtOrigin case)) i in
  HasEvenAnchor (Home p) = true /\ AroundPoint p (AtOrigin case) (Home p) /\
  forall d, exists other, HasEvenAnchor other = true /\
    In p (Corners other) /\ In (Translate p (Offset d)) (Corners other).
Proof.
  intros p. pose proof StarsChecked as C. unfold CheckStars in C.
  rewrite forallb_forall in C. specialize (C case (AllCasesHas case)).
  rewrite forallb_forall in C.
  specialize (C i (AllPlacesHas i)). cbv zeta in C. fold p in C.
  apply andb_prop in C. destruct C as [C E]. apply andb_prop in C.
  destruct C as [H R]. split; [exact H|].
  split; [exact (ReachesMeans 6 p (Home p) _ R)|].
  intros d. rewrite forallb_forall in E. specialize (E d (InAllDirections d)).
  apply existsb_exists in E. destruct E as (case' & _ & E).
  apply existsb_exists in E. destruct E as (j & _ & E).
  apply andb_prop in E. destruct E as [E B]. apply andb_prop in E.
  destruct E as [E A]. eexists. split; [exact E|]. auto using IsAmongMeans.
Qed.

Theorem StarConnected tid p : InLattice tid -> In p (Corners tid) ->
  AroundPoint p tid (Home p).
Proof.
  intros E I. destruct (FromOrigin tid p E I) as (a & b & c & case & i & -> & ->).
  rewrite HomeMoved. apply AroundMoved. apply StarAt.
Qed.

Theorem EdgeInStar tid p d : InLattice tid -> In p (Corners tid) ->
  exists other, InLattice other /\
    In p (Corners other) /\ In (Translate p (Offset d)) (Corners other).
Proof.
  intros E I. destruct (FromOrigin tid p E I) as (a & b & c & case & i & -> & ->).
  destruct (StarAt case i) as (_ & _ & S). destruct (S d) as (other & O & A & B).
  exists (MoveId (C3 (2 * a) (2 * b) (2 * c)) other).
  split; [apply HasEvenAnchorMeans, O|]. rewrite CornersMoved, TranslateTwice.
  auto using in_map.
Qed.
