(** * Symmetry of the stencils and of the lattice: proofs

    The stencils do not look at what vertices are, half turns respect them,
    and each of the twelve cases, in each of the four orders of a half turn, is
    an isometric image of the canonical corners. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Cases.Configurations Angles.Cases.Isometry.
Open Scope Z_scope.

(** The product's stencils. *)
Local Notation SymbolTets := (Configurations.SymbolTets GetUnstructuredTets).

(** ** Stencils on symbols *)

Lemma InProduct4 {T} (a b c d : list T) w x y z :
  In w a -> In x b -> In y c -> In z d -> In (Q4 w x y z) (Product4 a b c d).
Proof.
  intros. unfold Product4.
  apply in_flat_map. exists w. split; [assumption|].
  apply in_flat_map. exists x. split; [assumption|].
  apply in_flat_map. exists y. split; [assumption|].
  apply in_map. assumption.
Qed.

Lemma InAllSigns (q : Quad Sign) : In q AllSigns.
Proof.
  assert (A : forall s, In s [Plus; OnSurface; Minus])
    by (intros []; cbn; tauto).
  destruct q. apply InProduct4; apply A.
Qed.

Lemma InAllLabels l : In l AllLabels.
Proof. destruct l; cbn; tauto. Qed.

Lemma TurnTwice g l : TurnLabel g (TurnLabel g l) = l.
Proof. destruct g, l; reflexivity. Qed.

Lemma OfTurned {T} g (q : Quad T) l : Of (TurnQuad g q) l = Of q (TurnLabel g l).
Proof. destruct l; reflexivity. Qed.

(** The vertex of the mesh that a symbol stands for. *)
Definition Stands (corners : Quad Coord3) (v : Symbol) : MeshVertex :=
  match v with
  | CornerOf l => Corner (Of corners l)
  | CutOf a b => Cut (Of corners a) (Of corners b)
  end.

(** The stencils do not look at what vertices are. *)
Lemma StencilsNatural (sign : MeshVertex -> Sign) (corners : Quad Coord3) :
  let at_ l := Corner (Of corners l) in
  GetUnstructuredTets MeshVertex sign MeshIntersection
    (at_ V1) (at_ V2) (at_ V3) (at_ V4)
  = map (MapTet (Stands corners))
      (SymbolTets (Q4 (sign (at_ V1)) (sign (at_ V2))
                      (sign (at_ V3)) (sign (at_ V4)))).
Proof.
  intros at_. unfold Configurations.SymbolTets, GetUnstructuredTets. cbn [SymbolSign Of].
  destruct (sign (at_ V1)), (sign (at_ V2)), (sign (at_ V3)), (sign (at_ V4));
    reflexivity.
Qed.

(** Every cut runs from a + corner to another, - corner. *)
Definition CutsFromPlusToMinus (signs : Quad Sign) (v : Symbol) : bool :=
  match v with
  | CornerOf _ => true
  | CutOf a b =>
      match Of signs a, Of signs b with Plus, Minus => true | _, _ => false end
  end.

Definition AllOfTet {V} (ok : V -> bool) (t : UnstructuredTet V) : bool :=
  match t with UT _ a b c d => ok a && ok b && ok c && ok d end.

Lemma StencilCuts signs t : In t (SymbolTets signs) ->
  AllOfTet (CutsFromPlusToMinus signs) t = true.
Proof.
  assert (T : forallb (fun signs =>
    forallb (AllOfTet (CutsFromPlusToMinus signs)) (SymbolTets signs)) AllSigns
    = true) by (vm_compute; reflexivity).
  rewrite forallb_forall in T. specialize (T signs (InAllSigns signs)).
  rewrite forallb_forall in T. exact (T t).
Qed.

(** ** Half turns respect the stencils *)

Definition SymbolEqual (a b : Symbol) : bool :=
  match a, b with
  | CornerOf l, CornerOf m => LabelEqual l m
  | CutOf l m, CutOf l' m' => LabelEqual l l' && LabelEqual m m'
  | _, _ => false
  end.

Lemma SymbolEqualTrue a b : SymbolEqual a b = true -> a = b.
Proof.
  destruct a as [[]|[] []], b as [[]|[] []]; reflexivity || discriminate.
Qed.

Definition TetEqual (t t' : UnstructuredTet Symbol) : bool :=
  match t, t' with
    UT _ a b c d, UT _ a' b' c' d' =>
      SymbolEqual a a' && SymbolEqual b b' && SymbolEqual c c'
      && SymbolEqual d d'
  end.

Lemma TetEqualTrue t t' : TetEqual t t' = true -> t = t'.
Proof.
  destruct t, t'. cbn [TetEqual]. rewrite !andb_true_iff.
  intros [[[A B] C] D]. f_equal; apply SymbolEqualTrue; assumption.
Qed.

(** [t], turned, is in an even order one of the tetrahedra [ts]. *)
Definition TurnsInto (g : Turn) (t : UnstructuredTet Symbol)
  (ts : list (UnstructuredTet Symbol)) : bool :=
  existsb (fun t' => existsb (TetEqual (MapTet (TurnSymbol g) t))
                       (EvenPermutations t')) ts.

Lemma RepresentativeOf signs : exists g,
  In (TurnQuad g signs) Representatives /\
  forall t, In t (SymbolTets signs) -> exists t',
    In t' (SymbolTets (TurnQuad g signs)) /\
    In (MapTet (TurnSymbol g) t) (EvenPermutations t').
Proof.
  assert (T : forallb (fun signs => existsb (fun g =>
    FirstOfOrbit (TurnQuad g signs) &&
    forallb (fun t => TurnsInto g t (SymbolTets (TurnQuad g signs)))
      (SymbolTets signs)) AllTurns) AllSigns = true)
    by (vm_compute; reflexivity).
  rewrite forallb_forall in T. specialize (T signs (InAllSigns signs)).
  apply existsb_exists in T. destruct T as (g & _ & T).
  apply andb_prop in T. destruct T as [F T]. exists g. split.
  - apply filter_In. split; [apply InAllSigns | exact F].
  - intros t I. rewrite forallb_forall in T. specialize (T t I).
    apply existsb_exists in T. destruct T as (t' & I' & T).
    apply existsb_exists in T. destruct T as (t'' & I'' & T).
    apply TetEqualTrue in T. subst t''. exists t'. split; assumption.
Qed.

(** ** Every case is an image of the canonical one *)

Definition CornersOf (tid : StructuredTetId) : Quad Coord3 :=
  match GetStructuredTet tid with ST v1 v2 v3 v4 _ _ _ _ => Q4 v1 v2 v3 v4 end.

Lemma InCorners tid v :
  In v (Corners tid) <-> exists l, v = Of (CornersOf tid) l.
Proof.
  unfold Corners, CornersOf. destruct (GetStructuredTet tid). cbn [In]. split.
  - intros [<-|[<-|[<-|[<-|[]]]]];
      [exists V1|exists V2|exists V3|exists V4]; reflexivity.
  - intros [[] ->]; cbn [Of]; tauto.
Qed.

Definition HandDeterminant (h : Handedness) : Z :=
  match h with RightHanded => 1 | LeftHanded => -1 end.

(** [m] carries four corners to the canonical ones, up to a translation. *)
Definition CarriesCorners (m : Linear) (q : Quad Coord3) : bool :=
  forallb (fun l =>
    Coord3Equal (Apply m (Difference (Of q V1) (Of q l)))
      (Difference (Of Canonical V1) (Of Canonical l))) AllLabels.

Lemma TranslatedDifference a x y :
  Difference (Translate a x) (Translate a y) = Difference x y.
Proof. destruct a, x, y. cbn [Difference Translate]. f_equal; ring. Qed.

Lemma CornersTranslated anchor case l m :
  Difference (Of (CornersOf (STId anchor case)) l)
             (Of (CornersOf (STId anchor case)) m)
  = Difference (Of (CornersOf (STId (C3 0 0 0) case)) l)
               (Of (CornersOf (STId (C3 0 0 0) case)) m).
Proof.
  destruct case, l, m; cbn [CornersOf GetStructuredTet Of];
    rewrite !TranslatedDifference; reflexivity.
Qed.

Lemma InAllCases case : In case AllCases.
Proof. destruct case; cbn; tauto. Qed.

Lemma IsometryOf anchor case g : exists m,
  In m AllIsometries /\
  Determinant m = HandDeterminant (CaseHandedness case) /\
  forall l, Apply m (Difference
      (Of (TurnQuad g (CornersOf (STId anchor case))) V1)
      (Of (TurnQuad g (CornersOf (STId anchor case))) l))
    = Difference (Of Canonical V1) (Of Canonical l).
Proof.
  assert (T : forallb (fun case => forallb (fun g => existsb (fun m =>
    (Determinant m =? HandDeterminant (CaseHandedness case)) &&
    CarriesCorners m (TurnQuad g (CornersOf (STId (C3 0 0 0) case))))
      AllIsometries) AllTurns) AllCases = true) by (vm_compute; reflexivity).
  rewrite forallb_forall in T. specialize (T case (InAllCases case)).
  rewrite forallb_forall in T.
  specialize (T g ltac:(destruct g; cbn; tauto)).
  apply existsb_exists in T. destruct T as (m & I & T).
  apply andb_prop in T. destruct T as [D T]. apply Z.eqb_eq in D.
  exists m. repeat (split; [assumption|]). intros l.
  unfold CarriesCorners in T. rewrite forallb_forall in T.
  specialize (T l (InAllLabels l)). apply Coord3EqualTrue in T.
  rewrite <- T. rewrite !OfTurned, CornersTranslated. reflexivity.
Qed.

(** ** Edges and directions of the canonical corners *)

Lemma CanonicalEdge a b : LabelEqual a b = false -> exists d,
  Difference (Of Canonical a) (Of Canonical b) = Offset d /\
  DirectionKind d = LabelKind a b.
Proof.
  assert (T : forallb (fun a => forallb (fun b =>
    LabelEqual a b || existsb (fun d =>
      Coord3Equal (Difference (Of Canonical a) (Of Canonical b)) (Offset d)
      && SameKind (DirectionKind d) (LabelKind a b)) AllDirections) AllLabels)
      AllLabels = true) by (vm_compute; reflexivity).
  rewrite forallb_forall in T. specialize (T a (InAllLabels a)).
  rewrite forallb_forall in T. specialize (T b (InAllLabels b)).
  intros N. rewrite N in T. cbn [orb] in T.
  apply existsb_exists in T. destruct T as (d & _ & T).
  apply andb_prop in T. destruct T as [E K]. exists d.
  split; [apply Coord3EqualTrue, E | apply SameKindEqual, K].
Qed.

(** A direction that leads from a corner out of the tetrahedron. *)
Definition Outward (l : Label) : Direction :=
  match l with
  | V1 => Dir_m00 | V2 => Dir_p00 | V3 => Dir_00m | V4 => Dir_00p
  end.

Lemma OutwardTargetsNone i j : Targets i j (Some (Outward i)) = false.
Proof. destruct i, j; reflexivity. Qed.

(** ** Membership in the enumeration *)

Lemma InMovesFor signs moves before :
  (forall l, In (Of moves l) (MovesOf (Of signs l))) ->
  (forall l, In (Of before l) (SignsBefore (Of signs l))) ->
  ConsistentWith signs moves before = true -> In moves (MovesFor signs).
Proof.
  intros M B C. destruct signs as [s1 s2 s3 s4] eqn:E.
  unfold MovesFor. apply filter_In. split.
  - destruct moves. apply InProduct4;
      [apply (M V1)|apply (M V2)|apply (M V3)|apply (M V4)].
  - unfold Consistent. apply existsb_exists. exists before.
    split; [|exact C]. destruct before. apply InProduct4;
      [apply (B V1)|apply (B V2)|apply (B V3)|apply (B V4)].
Qed.
