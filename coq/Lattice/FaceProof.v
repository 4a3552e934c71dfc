(** * A face of the lattice belongs to two tetrahedra: proof

    All points stand at fixed offsets from the reference points, and tetrahedra
    that have a vertex in common have reference points no farther apart than 3.
    If these are even they are 0 or 2 apart along each axis: 27 cases, and each
    is a computation. *)

From Certet Require Import Lattice.Definitions.
Open Scope Z_scope.

Definition Origin : Coord3 := C3 0 0 0.

Definition AllPlaces : list Place := [First; Second; Third; Fourth].

Definition LocalVertex (case : StructuredTetCase) (i : Place) : Coord3 :=
  VertexAt (GetStructuredTet (STId Origin case)) i.

Definition LocalFace (case : StructuredTetCase) (i : Place) : list Coord3 :=
  FaceAcross (GetStructuredTet (STId Origin case)) i.

Definition LocalNeighbor (case : StructuredTetCase) (i : Place) : StructuredTetId :=
  fst (NeighborAcross (GetStructuredTet (STId Origin case)) i).

(** ** Everything moves with the reference point *)

Lemma VertexMoves a case i :
  VertexAt (GetStructuredTet (STId a case)) i = Translate a (LocalVertex case i).
Proof. destruct a, case, i; reflexivity. Qed.

Lemma FaceMoves a case i :
  FaceAcross (GetStructuredTet (STId a case)) i = map (Translate a) (LocalFace case i).
Proof. destruct a, case, i; reflexivity. Qed.

Lemma NeighborMoves a case i :
  fst (NeighborAcross (GetStructuredTet (STId a case)) i)
  = let 'STId b c := LocalNeighbor case i in STId (Translate a b) c.
Proof. destruct a, case, i; reflexivity. Qed.

(** ** Computing *)

Lemma SamePoint a b : Coord3Equal a b = true <-> a = b.
Proof.
  destruct a, b. cbn. rewrite !andb_true_iff, !Z.eqb_eq.
  split; [intros [[-> ->] ->]; reflexivity | intros [= -> -> ->]; auto].
Qed.

Definition CaseEqual (a b : StructuredTetCase) : bool :=
  match a, b with
  | Tet_I1, Tet_I1 | Tet_I2, Tet_I2 | Tet_I3, Tet_I3 | Tet_I4, Tet_I4
  | Tet_J1, Tet_J1 | Tet_J2, Tet_J2 | Tet_J3, Tet_J3 | Tet_J4, Tet_J4
  | Tet_K1, Tet_K1 | Tet_K2, Tet_K2 | Tet_K3, Tet_K3 | Tet_K4, Tet_K4 => true
  | _, _ => false
  end.

Lemma SameCase a b : CaseEqual a b = true -> a = b.
Proof. destruct a, b; reflexivity || discriminate. Qed.

Definition IdEqual (s t : StructuredTetId) : bool :=
  let 'STId a c := s in let 'STId b d := t in Coord3Equal a b && CaseEqual c d.

Lemma SameId s t : IdEqual s t = true -> s = t.
Proof.
  destruct s, t. cbn. intros E. apply andb_prop in E as [E F].
  apply SamePoint in E. apply SameCase in F. congruence.
Qed.

(** Whether a point is a vertex of the tetrahedron at [b]. *)
Definition IsVertex (b : Coord3) (case : StructuredTetCase) (v : Coord3) : bool :=
  existsb (fun j => Coord3Equal v (Translate b (LocalVertex case j))) AllPlaces.

Definition ForAllNear (test : Coord3 -> bool) : bool :=
  let near := [-2; 0; 2] in
  forallb (fun x => forallb (fun y => forallb (fun z => test (C3 x y z))
    near) near) near.

(** The face of [c] at the origin, and [c'] at [b]: either not all of the face's
    vertices are vertices of [c'], or [c'] at [b] is one of the two. *)
Lemma TwoOnly :
  ForAllNear (fun b => forallb (fun c => forallb (fun i => forallb (fun c' =>
    if forallb (IsVertex b c') (LocalFace c i)
    then IdEqual (STId b c') (STId Origin c) || IdEqual (STId b c') (LocalNeighbor c i)
    else true) AllCases) AllPlaces) AllCases) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma BothHave :
  forallb (fun c => forallb (fun i =>
    let 'STId b c' := LocalNeighbor c i in
    forallb (IsVertex Origin c) (LocalFace c i)
    && forallb (IsVertex b c') (LocalFace c i)) AllPlaces) AllCases = true.
Proof. vm_compute. reflexivity. Qed.

Lemma AllCasesHas c : In c AllCases.
Proof. destruct c; cbn; tauto. Qed.

Lemma AllPlacesHas i : In i AllPlaces.
Proof. destruct i; cbn; tauto. Qed.

Lemma ForAll {A} (l : list A) test x :
  forallb test l = true -> In x l -> test x = true.
Proof. intros all. rewrite forallb_forall in all. apply all. Qed.

(** ** From points to computing *)

(** [b] is where [a'] stands as seen from [a]. *)
Lemma SeenFrom a a' case v :
  IsVertex (Difference a a') case v = true <->
  exists j, Translate a v = VertexAt (GetStructuredTet (STId a' case)) j.
Proof.
  unfold IsVertex. rewrite existsb_exists. split.
  - intros (j & _ & E). apply SamePoint in E. exists j. rewrite VertexMoves, E.
    destruct a, a', (LocalVertex case j). cbn [Translate Difference]. f_equal; ring.
  - intros (j & E). exists j. split; [apply AllPlacesHas|]. apply SamePoint.
    rewrite VertexMoves in E. revert E.
    destruct a, a', v, (LocalVertex case j). cbn [Translate Difference].
    intros [= ? ? ?]. f_equal; lia.
Qed.

Lemma LocalBound case j :
  let 'C3 x y z := LocalVertex case j in 0 <= x <= 3 /\ 0 <= y <= 3 /\ 0 <= z <= 3.
Proof. destruct case, j; cbn; lia. Qed.

Lemma LocalFaceBound case i v : In v (LocalFace case i) ->
  let 'C3 x y z := v in 0 <= x <= 3 /\ 0 <= y <= 3 /\ 0 <= z <= 3.
Proof. destruct case, i; cbn; intuition subst; lia. Qed.

Lemma NearIn d (x : Z -> Prop) : Z.Even d -> - 3 <= d <= 3 ->
  (forall e, In e [-2; 0; 2] -> x e) -> x d.
Proof.
  intros [e ->] B all. apply all.
  assert (e = -1 \/ e = 0 \/ e = 1) as [-> | [-> | ->]] by lia; cbn; tauto.
Qed.

(** Reference points of tetrahedra that have a point in common. *)
Lemma NearEnough (test : Coord3 -> bool) a a' case v :
  ForAllNear test = true -> IsEven a -> IsEven a' ->
  (let 'C3 x y z := v in 0 <= x <= 3 /\ 0 <= y <= 3 /\ 0 <= z <= 3) ->
  IsVertex (Difference a a') case v = true ->
  test (Difference a a') = true.
Proof.
  intros all Ea Ea' Bv V. unfold IsVertex in V. apply existsb_exists in V.
  destruct V as (j & _ & V). apply SamePoint in V.
  pose proof (LocalBound case j) as Bj.
  destruct (LocalVertex case j), v, a, a'. cbn [Translate Difference IsEven] in *.
  injection V as Vx Vy Vz.
  destruct Ea as (? & ? & ?), Ea' as (? & ? & ?).
  unfold ForAllNear in all. cbv zeta in all.
  assert (Ev : forall p q, Z.Even p -> Z.Even q -> Z.Even (q - p)).
  { intros p q [r ->] [s ->]. exists (s - r). ring. }
  match goal with |- test (C3 ?x ?y ?z) = true =>
    apply (NearIn x (fun e => test (C3 e y z) = true)); [auto | lia | intros e1 I1];
    apply (NearIn y (fun e => test (C3 e1 e z) = true)); [auto | lia | intros e2 I2];
    apply (NearIn z (fun e => test (C3 e1 e2 e) = true)); [auto | lia | intros e3 I3]
  end.
  apply (ForAll _ _ e1) in all; [|exact I1]. apply (ForAll _ _ e2) in all; [|exact I2].
  apply (ForAll _ _ e3) in all; assumption.
Qed.

Lemma Reaches a a' : a' = Translate a (Difference a a').
Proof. destruct a, a'. cbn. f_equal; ring. Qed.

(** ** The theorem *)

Theorem FaceOfTwo : forall tid i other,
  InLattice tid -> InLattice other ->
  (forall v, In v (FaceAcross (GetStructuredTet tid) i) ->
     exists j, v = VertexAt (GetStructuredTet other) j) <->
  other = tid \/ other = fst (NeighborAcross (GetStructuredTet tid) i).
Proof.
  intros [a c] i [a' c'] even even'. rewrite FaceMoves, NeighborMoves. split.
  - intros shared.
    assert (V : forall v, In v (LocalFace c i) -> IsVertex (Difference a a') c' v = true).
    { intros v I. apply SeenFrom, shared, in_map, I. }
    assert (exists v, In v (LocalFace c i)) as (v & I)
      by (destruct c, i; eexists; left; reflexivity).
    pose proof (NearEnough _ a a' c' v TwoOnly even even' (LocalFaceBound c i v I) (V v I))
      as T. cbv beta in T.
    apply (ForAll _ _ c) in T; [|apply AllCasesHas].
    apply (ForAll _ _ i) in T; [|apply AllPlacesHas].
    apply (ForAll _ _ c') in T; [|apply AllCasesHas].
    assert (W : forallb (IsVertex (Difference a a') c') (LocalFace c i) = true)
      by (apply forallb_forall; exact V).
    cbv beta in T. rewrite W in T. apply orb_prop in T.
    rewrite (Reaches a a').
    destruct T as [T | T]; apply SameId in T.
    + left. injection T as T ->. rewrite T. f_equal. destruct a. cbn. f_equal; ring.
    + right. rewrite <- T. reflexivity.
  - pose proof (ForAll _ _ i (ForAll _ _ c BothHave (AllCasesHas c)) (AllPlacesHas i)) as B.
    cbv beta in B.
    destruct (LocalNeighbor c i) as [b cb] eqn:N.
    apply andb_prop in B as [B1 B2]. intros [E | E] v I;
      injection E as -> ->; apply in_map_iff in I as (w & <- & I); apply SeenFrom.
    + replace (Difference a a) with Origin by (destruct a; cbn; unfold Origin; f_equal; ring).
      exact (ForAll _ _ w B1 I).
    + replace (Difference a (Translate a b)) with b
        by (destruct a, b; cbn; f_equal; ring).
      exact (ForAll _ _ w B2 I).
Qed.

(** The two are two, and the neighbour is in the lattice as well. *)
Theorem NeighborApart : forall tid i,
  fst (NeighborAcross (GetStructuredTet tid) i) <> tid.
Proof.
  intros [[x y z] c] i. rewrite NeighborMoves.
  destruct c, i; cbn; intros E; injection E; discriminate || lia.
Qed.

Theorem NeighborInLattice : forall tid i, InLattice tid ->
  InLattice (fst (NeighborAcross (GetStructuredTet tid) i)).
Proof.
  intros [[x y z] c] i (Ex & Ey & Ez). rewrite NeighborMoves.
  assert (S : forall p q, Z.Even p -> Z.Even q -> Z.Even (p + q)).
  { intros p q [r ->] [s ->]. exists (r + s). ring. }
  destruct c, i; cbn; repeat split; apply S; try assumption;
    solve [exists 0; reflexivity | exists 1; reflexivity | exists (-1); reflexivity].
Qed.

(** Who has all four vertices has each face, and is not both neighbours. *)
Theorem VerticesTell : forall tid other, InLattice tid -> InLattice other ->
  (forall i, exists j, VertexAt (GetStructuredTet tid) i = VertexAt (GetStructuredTet other) j) ->
  other = tid.
Proof.
  intros tid other even even' all.
  assert (N : forall i, other = tid \/ other = fst (NeighborAcross (GetStructuredTet tid) i)).
  { intros i. apply FaceOfTwo; [assumption | assumption |]. intros v I.
    destruct (all First) as [j1 E1], (all Second) as [j2 E2],
      (all Third) as [j3 E3], (all Fourth) as [j4 E4].
    destruct (GetStructuredTet tid) as [v1 v2 v3 v4 n1 n2 n3 n4].
    cbn [VertexAt] in *.
    destruct i; cbn [FaceAcross In] in I; intuition (subst; eauto). }
  destruct (N First) as [E | E1]; [exact E|].
  destruct (N Third) as [E | E3]; [exact E|]. exfalso.
  rewrite E1 in E3. destruct tid as [[x y z] c]. rewrite !NeighborMoves in E3.
  destruct c; cbn in E3; injection E3; discriminate || lia.
Qed.
