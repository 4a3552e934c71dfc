(** * The stencils are one greedy rule

    All diagonals of the 81 stencils follow the order of [EdgeRank]: a + corner
    is not joined to a cut while an edge of its own to the same outer corner
    comes earlier; nor are two cuts of opposite edges while the inner end of one
    has an earlier edge to the outer end of the other.  Since a rank is a matter
    of the edge alone, the two sides of a face agree without looking at each
    other. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Export Lattice.EdgeRank.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stuffing.NameProof.
From Certet Require Angles.Cases.SymmetryProof.
Open Scope Z_scope.

(** The vertex lies in the structured tetrahedron with these corners; a corner
    of the output is not outside, and a cut leads from inside to outside. *)
Definition Belongs (after : Coord3 -> Sign) (corners : list Coord3)
  (v : MeshVertex) : Prop :=
  match v with
  | Corner c => In c corners /\ after c <> Minus
  | Cut a m => In a corners /\ In m corners /\ after a = Plus /\ after m = Minus
  end.

(** The rule. *)
Definition MayJoin (after : Coord3 -> Sign) (u v : MeshVertex) : Prop :=
  match u, v with
  | Corner a, Cut b m => after a = Plus -> EdgeRank b m <= EdgeRank a m
  | Cut a m, Cut b n => a <> b -> m <> n -> EdgeRank a m <= EdgeRank a n
  | _, _ => True
  end.

Definition Follows (after : Coord3 -> Sign) (corners : list Coord3)
  (t : UnstructuredTet MeshVertex) : Prop :=
  (forall v, In v (TetCorners t) -> Belongs after corners v) /\
  (forall u v, In u (TetCorners t) -> In v (TetCorners t) -> MayJoin after u v).

(** The rule in any order of the cuts, told by a key for each edge.  A + corner is
    not joined to a cut while its own cut of the edge to the same outer corner
    comes earlier.  Two cuts of opposite edges are not joined while both that
    could be joined instead come earlier; and while one corner has the earlier
    cuts to both outer corners, only the later of these is joined. *)
Definition MayJoinBy (key : Coord3 -> Coord3 -> Z) (after : Coord3 -> Sign)
  (u v : MeshVertex) : Prop :=
  match u, v with
  | Corner a, Cut b m => after a = Plus -> key b m <= key a m
  | Cut a m, Cut b n => a <> b -> m <> n ->
      (key a m <= key b m \/ key b n <= key a n) /\
      (key a m <= key b m -> key a n <= key b n -> key a n <= key a m)
  | _, _ => True
  end.

Definition FollowsBy (key : Coord3 -> Coord3 -> Z) (after : Coord3 -> Sign)
  (corners : list Coord3) (t : UnstructuredTet MeshVertex) : Prop :=
  (forall v, In v (TetCorners t) -> Belongs after corners v) /\
  (forall u v, In u (TetCorners t) -> In v (TetCorners t) -> MayJoinBy key after u v).

(** ** Ranks within a structured tetrahedron *)

(** [v1 v2] and [v3 v4] are long. *)
Definition PlaceRank (i j : Place) : Z :=
  match i, j with
  | First, Fourth | Fourth, First | Second, Third | Third, Second => 1
  | First, Third | Third, First | Second, Fourth | Fourth, Second => 2
  | _, _ => 0
  end.

(** The direction from one point to another, if it is one. *)
Definition DirectionTo (u v : Coord3) : option Direction :=
  find (fun d => Coord3Equal (Offset d) (Difference u v)) AllDirections.

Lemma EdgeRankTranslate a b c u v :
  let even := C3 (2 * a) (2 * b) (2 * c) in
  EdgeRank (Translate even u) (Translate even v) = EdgeRank u v.
Proof.
  cbv zeta. unfold EdgeRank. rewrite SymmetryProof.TranslatedDifference.
  destruct (Difference u v), u. cbn [Translate]. rewrite Z.add_comm, Z.even_add_mul_2. reflexivity.
Qed.

Lemma DirectionToMeans u v d :
  DirectionTo u v = Some d -> v = Translate u (Offset d).
Proof.
  intros E. apply find_some in E. destruct E as [_ E].
  destruct u, v, (Offset d). cbn [Difference Coord3Equal Translate] in *.
  rewrite !andb_true_iff, !Z.eqb_eq in E. f_equal; lia.
Qed.

Section Structured.
  Variable tid : StructuredTetId.
  Hypothesis Even : InLattice tid.

  Let at_ (i : Place) := VertexAt (GetStructuredTet tid) i.

  Lemma RankAt i j : EdgeRank (at_ i) (at_ j) = PlaceRank i j.
  Proof.
    unfold at_. destruct tid as [[x y z] case], Even as ([a ->] & [b ->] & [c ->]).
    destruct case, i, j; cbn [GetStructuredTet VertexAt];
      rewrite EdgeRankTranslate; reflexivity.
  Qed.

  Lemma EdgeAt i j : i <> j -> exists d, at_ j = Translate (at_ i) (Offset d).
  Proof.
    clear Even. intros N. enough (DirectionTo (at_ i) (at_ j) <> None) as S.
    { destruct (DirectionTo (at_ i) (at_ j)) as [d|] eqn:D; [|congruence].
      exists d. apply DirectionToMeans, D. }
    unfold at_, DirectionTo. destruct tid as [anchor case].
    destruct case, i, j; try congruence; cbn [GetStructuredTet VertexAt];
      rewrite SymmetryProof.TranslatedDifference; discriminate.
  Qed.

  Lemma PlaceOf c : In c (Corners tid) <-> exists i, c = at_ i.
  Proof.
    unfold at_, Corners. destruct (GetStructuredTet tid) as [v1 v2 v3 v4].
    cbn [In VertexAt]. split.
    - intros [<-|[<-|[<-|[<-|[]]]]];
        [exists First|exists Second|exists Third|exists Fourth]; reflexivity.
    - intros [[] ->]; tauto.
  Qed.

  Lemma EdgeBetween a m : In a (Corners tid) -> In m (Corners tid) -> a <> m ->
    exists d, m = Translate a (Offset d).
  Proof.
    rewrite !PlaceOf. intros [i ->] [j ->] N. apply EdgeAt. congruence.
  Qed.

  (** Three ranks at a corner, *)
  Lemma RanksDiffer a b m :
    In a (Corners tid) -> In b (Corners tid) -> In m (Corners tid) ->
    a <> b -> a <> m -> b <> m -> EdgeRank a m <> EdgeRank b m.
  Proof.
    rewrite !PlaceOf. intros [i ->] [j ->] [k ->]. rewrite !RankAt.
    destruct i, j, k; cbn; congruence.
  Qed.

  (** and the same for opposite edges. *)
  Lemma OppositeRanks a b m n :
    In a (Corners tid) -> In b (Corners tid) -> In m (Corners tid) ->
    In n (Corners tid) ->
    a <> b -> m <> n -> a <> m -> a <> n -> b <> m -> b <> n ->
    EdgeRank a n = EdgeRank b m.
  Proof.
    rewrite !PlaceOf. intros [i ->] [j ->] [k ->] [l ->]. rewrite !RankAt.
    destruct i, j; try congruence; destruct k; try congruence;
      destruct l; reflexivity || congruence.
  Qed.
End Structured.

(** ** The stencils follow the rule *)

(** The labels of [v1 v2 v3 v4]; [Q] is none of them. *)
Definition LabelPlace (l : Label) : Place :=
  match l with F1 => First | F2 => Second | F3 => Third | P | Q => Fourth end.

Definition LabelRank (a b : Label) : Z := PlaceRank (LabelPlace a) (LabelPlace b).

Definition IsSign (s : Sign) (s' : Sign) : bool :=
  match s, s' with
  | Plus, Plus | OnSurface, OnSurface | Minus, Minus => true
  | _, _ => false
  end.

Section Checker.
  Variable sign : Label -> Sign.

  Definition CheckBelongs (s : Symbol) : bool :=
    match s with
    | Base a => negb (SameLabel a Q) && negb (IsSign (sign a) Minus)
    | CutOf a m =>
        negb (SameLabel a Q) && negb (SameLabel m Q) &&
        IsSign (sign a) Plus && IsSign (sign m) Minus
    end.

  Definition CheckMayJoin (s r : Symbol) : bool :=
    match s, r with
    | Base a, CutOf b m =>
        negb (IsSign (sign a) Plus) || (LabelRank b m <=? LabelRank a m)
    | CutOf a m, CutOf b n =>
        SameLabel a b || SameLabel m n || (LabelRank a m <=? LabelRank a n)
    | _, _ => true
    end.

  Definition CheckFollows (t : UnstructuredTet Symbol) : bool :=
    forallb CheckBelongs (TetCorners t) &&
    forallb (fun s => forallb (CheckMayJoin s) (TetCorners t)) (TetCorners t).
End Checker.

Lemma StencilsFollow : ForAllSignAssignments (fun sign =>
  forallb (CheckFollows sign)
    (SymbolicTets GetUnstructuredTets sign F1 F2 F3 P)) = true.
Proof. vm_compute. reflexivity. Qed.

Lemma IsSignEqual s s' : IsSign s s' = true <-> s = s'.
Proof. destruct s, s'; cbn; intuition congruence. Qed.

Section Sound.
  Variable after : Coord3 -> Sign.
  Variable tid : StructuredTetId.
  Hypothesis Even : InLattice tid.

  Let at_ (l : Label) := VertexAt (GetStructuredTet tid) (LabelPlace l).
  Let name := Name (at_ F1) (at_ F2) (at_ F3) (at_ P) (at_ Q).
  Variable sign : Label -> Sign.
  Hypothesis Signs : forall l, sign l = after (at_ l).

  Lemma LocateAt l : LocateFive (at_ F1) (at_ F2) (at_ F3) (at_ P) (at_ Q) l = at_ l.
  Proof. destruct l; reflexivity. Qed.

  Lemma AtCorner l : In (at_ l) (Corners tid).
  Proof. apply PlaceOf. exists (LabelPlace l). reflexivity. Qed.

  Lemma LabelRankAt a b : EdgeRank (at_ a) (at_ b) = LabelRank a b.
  Proof. apply RankAt, Even. Qed.

  Lemma BelongsSound s : CheckBelongs sign s = true ->
    Belongs after (Corners tid) (name s).
  Proof.
    unfold name. destruct s as [a|a m]; rewrite ?NameBase, ?NameCut, ?LocateAt;
      cbn [CheckBelongs Belongs];
      rewrite !andb_true_iff, ?negb_true_iff, ?IsSignEqual, !Signs.
    - intros [_ N]. split; [apply AtCorner|]. intros E. rewrite E in N. discriminate N.
    - intros [[_ A] M]. auto using AtCorner.
  Qed.

  Lemma MayJoinSound s r : CheckMayJoin sign s r = true ->
    MayJoin after (name s) (name r).
  Proof.
    unfold name.
    destruct s as [a|a m], r as [b|b n]; rewrite ?NameBase, ?NameCut, ?LocateAt;
      cbn [CheckMayJoin MayJoin]; try exact (fun _ => I);
      rewrite !LabelRankAt, !orb_true_iff, Z.leb_le, ?negb_true_iff;
      rewrite ?SameLabelEqual, ?Signs.
    - intros [E|E] A; [|exact E]. rewrite A in E. discriminate E.
    - intros [[-> | ->]|E] A M; congruence || exact E.
  Qed.

  Lemma FollowsSound h t : CheckFollows sign t = true ->
    Follows after (Corners tid) (Orient h (MapTet name t)).
  Proof.
    unfold CheckFollows. rewrite andb_true_iff, !forallb_forall.
    intros [B J].
    assert (N : forall v, In v (TetCorners (Orient h (MapTet name t))) ->
      exists s, v = name s /\ In s (TetCorners t)).
    { intros v I. apply OrientCorners in I. unfold name in I.
      rewrite MapTetCorners in I. apply in_map_iff in I.
      destruct I as (s & <- & I). exists s. auto. }
    split.
    - intros v I. destruct (N v I) as (s & -> & S). apply BelongsSound, B, S.
    - intros u v I I'. destruct (N u I) as (s & -> & S).
      destruct (N v I') as (r & -> & R). apply MayJoinSound.
      specialize (J s S). rewrite forallb_forall in J. apply J, R.
  Qed.
End Sound.

(** The names of the output's tetrahedra are those of the stencils on labels;
    [q] is any point. *)
Lemma PlacedLabelled before warping tid q :
  let at_ := VertexAt (GetStructuredTet tid) in
  let sign l := PlacedSign before warping (Corner (at_ (LabelPlace l))) in
  exists h, PlacedNames before warping tid
    = map (fun s => Orient h
        (MapTet (Name (at_ First) (at_ Second) (at_ Third) (at_ Fourth) q) s))
        (SymbolicTets GetUnstructuredTets
           (SignOf (sign F1) (sign F2) (sign F3) (sign P)
              (PlacedSign before warping (Corner q))) F1 F2 F3 P).
Proof.
  intros at_ sign. unfold PlacedNames, at_, sign, at_. destruct tid as [anchor case].
  destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4].
  cbn [VertexAt LabelPlace].
  exists (CaseHandedness case).
  pose proof (InterpretTets GetUnstructuredTets GetUnstructuredTetsNatural
    MeshVertex (PlacedSign before warping) MeshIntersection (Corner v1)
    (Corner v2) (Corner v3) (Corner v4) (Corner q) F1 F2 F3 P) as N.
  cbn [Locate] in N. rewrite N. apply map_map.
Qed.

Theorem StuffedFollows before warping tid t : InLattice tid ->
  In t (PlacedNames before warping tid) ->
  Follows (fun c => PlacedSign before warping (Corner c)) (Corners tid) t.
Proof.
  intros Even I. set (after := fun c => PlacedSign before warping (Corner c)).
  set (at_ := VertexAt (GetStructuredTet tid)).
  set (sign := fun l => after (at_ (LabelPlace l))).
  destruct (PlacedLabelled before warping tid (at_ Fourth)) as (h & E).
  rewrite E in I. apply in_map_iff in I. destruct I as (s & <- & I).
  pose proof (ForAllSignAssignmentsSound _ StencilsFollow
    (sign F1) (sign F2) (sign F3) (sign P) (sign Q)) as C.
  cbv beta in C. rewrite forallb_forall in C.
  refine (FollowsSound after tid Even _ _ h s (C s I)).
  intros []; reflexivity.
Qed.

(** ** The rule of ranks is that of an order *)

Lemma RanksAreKeys tid : InLattice tid -> KeysApart EdgeRank (Corners tid).
Proof.
  intros Even a b m A B M. apply PlaceOf in A, B, M.
  destruct A as [i ->], B as [j ->], M as [k ->]. rewrite !RankAt by exact Even.
  destruct i, j, k; cbn; intuition congruence.
Qed.

Lemma FollowsByRank tid after t : InLattice tid ->
  Follows after (Corners tid) t -> FollowsBy EdgeRank after (Corners tid) t.
Proof.
  intros Even [B J]. split; [exact B|]. intros u v U V.
  pose proof (J u v U V) as uv. pose proof (J v u V U) as vu.
  pose proof (B u U) as Bu. pose proof (B v V) as Bv.
  destruct u as [a|a m], v as [b|b n]; cbn [MayJoin MayJoinBy Belongs] in *;
    try exact I; [exact uv|].
  intros N M. specialize (uv N M). specialize (vu (not_eq_sym N) (not_eq_sym M)).
  destruct Bu as (A & Cm & Pa & Mm), Bv as (Cb & Cn & Pb & Mn).
  assert (a <> m /\ a <> n /\ b <> m /\ b <> n) as (am & an & bm & bn)
    by (repeat split; congruence).
  pose proof (OppositeRanks tid Even a b m n A Cb Cm Cn N M am an bm bn).
  pose proof (OppositeRanks tid Even a b n m A Cb Cn Cm N (not_eq_sym M) an am bn bm).
  split; [left|]; lia.
Qed.
