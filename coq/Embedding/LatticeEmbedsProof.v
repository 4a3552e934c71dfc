(** * The lattice embeds as long as no short edge is turned over

    A lattice point is counted in steps along the four diagonals of a cube.
    The image of four counts does not change when one is added to all of them.
    Every structured tetrahedron is a chain of four points, each one step
    farther than the last, every step along another diagonal; so its weighted
    points are counts rounded in several ways (see [Rounding]).  A placed point
    has three coordinates, each of which rises along two of the diagonals and
    falls along the others: this is what it means that short edges are kept. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Embedding.Rounding.
Open Scope Z_scope.

(** ** Coordinates *)

Definition XOf (c : Coord3) : Z := match c with C3 x _ _ => x end.
Definition YOf (c : Coord3) : Z := match c with C3 _ y _ => y end.
Definition ZOf (c : Coord3) : Z := match c with C3 _ _ z => z end.

Lemma PointOfCoordinates {V : Type} (place : V -> Coord3) w t :
  PointOf w (MapTet place t)
  = C3 (Weigh (fun v => XOf (place v)) w t) (Weigh (fun v => YOf (place v)) w t)
       (Weigh (fun v => ZOf (place v)) w t).
Proof.
  destruct w as [a b c d], t as [p q r s]. cbn [MapTet PointOf Weigh].
  destruct (place p), (place q), (place r), (place s).
  cbn [Scale Translate XOf YOf ZOf]. f_equal; ring.
Qed.

Lemma SamePoint {V W : Type} (f : V -> Coord3) (h : W -> Coord3) w t w' t' :
  PointOf w (MapTet f t) = PointOf w' (MapTet h t') <->
  Weigh (fun v => XOf (f v)) w t = Weigh (fun v => XOf (h v)) w' t' /\
  Weigh (fun v => YOf (f v)) w t = Weigh (fun v => YOf (h v)) w' t' /\
  Weigh (fun v => ZOf (f v)) w t = Weigh (fun v => ZOf (h v)) w' t'.
Proof.
  rewrite !PointOfCoordinates. split; [intros E; injection E; auto|].
  intros (-> & -> & ->). reflexivity.
Qed.

(** ** Counts *)

Definition ToPoint (p q r s : Z) : Coord3 :=
  C3 (p + q - r - s) (p - q + r - s) (p - q - r + s).

Lemma ToPointTurns p q r s :
  ToPoint (p + 1) (q + 1) (r + 1) (s + 1) = ToPoint p q r s.
Proof. unfold ToPoint. f_equal; lia. Qed.

Lemma ToPointNext p q r s :
  ToPoint (p + 1) q r s = Translate (ToPoint p q r s) (Offset Dir_ppp) /\
  ToPoint p (q + 1) r s = Translate (ToPoint p q r s) (Offset Dir_pmm) /\
  ToPoint p q (r + 1) s = Translate (ToPoint p q r s) (Offset Dir_mpm) /\
  ToPoint p q r (s + 1) = Translate (ToPoint p q r s) (Offset Dir_mmp).
Proof. unfold ToPoint. cbn [Offset Translate]. repeat split; f_equal; lia. Qed.

(** A chain, its steps along the diagonals as [T] orders them. *)
Lemma ChainWeighs (T : Z -> Z -> Z -> Z -> Coord3) (w : Weights)
  (v1 v2 v3 v4 : Coord3) i j k l :
  NonNegative w ->
  v1 = T i j k l -> v4 = T (i + 1) j k l -> v2 = T (i + 1) (j + 1) k l ->
  v3 = T (i + 1) (j + 1) (k + 1) l ->
  exists i' j' k' l', forall g : Coord3 -> Z,
    Weigh g w (UT _ v1 v2 v3 v4)
    = Mix (Z.to_nat (Total w)) (fun i j k l => g (T i j k l)) i' j' k' l'.
Proof.
  destruct w as [a b c d]. intros (A & B & C & D) -> -> -> ->.
  cbn [Total Weigh].
  exists ((a + b + c + d) * i + (d + b + c)), ((a + b + c + d) * j + (b + c)),
    ((a + b + c + d) * k + c), ((a + b + c + d) * l). intros g.
  pose proof (MixChain (fun i j k l => g (T i j k l))
    (Z.to_nat a) (Z.to_nat d) (Z.to_nat b) (Z.to_nat c) i j k l) as M.
  cbv beta zeta in M.
  replace (Z.to_nat a + Z.to_nat d + Z.to_nat b + Z.to_nat c)%nat
    with (Z.to_nat (a + b + c + d)) in M by lia.
  rewrite !Nat2Z.inj_add, !Z2Nat.id in M by lia.
  rewrite M. ring.
Qed.

(** [T] orders the diagonals, [i j k l] are the counts of the first vertex. *)
Ltac chain W T i j k l :=
  lazymatch type of W with NonNegative ?w =>
  lazymatch goal with |- context [UT Coord3 ?v1 ?v2 ?v3 ?v4] =>
    destruct (ChainWeighs T w v1 v2 v3 v4 i j k l W) as (? & ? & ? & ? & E);
    [unfold ToPoint; cbn [Translate]; f_equal; lia ..|];
    cbv beta in E; eexists _, _, _, _; exact E
  end end.

(** The order of the steps is another one in each of the twelve cases. *)
Lemma LatticeWeighs tid w : InLattice tid -> NonNegative w ->
  exists p q r s, forall g : Coord3 -> Z,
    Weigh g w (LatticeTet tid)
    = Mix (Z.to_nat (Total w)) (fun p q r s => g (ToPoint p q r s)) p q r s.
Proof.
  pose proof ChainWeighs as ChainWeighs. unfold Mix in *.
  destruct tid as [[x y z] case]. intros ([a ->] & [b ->] & [c ->]) W.
  destruct case; cbn [LatticeTet GetStructuredTet].
  - chain W (fun p q r s => ToPoint p q r s) (a + b + 1) (a - c - 1) (b - c) 0.
  - chain W (fun q p r s => ToPoint p q r s) (a - c - 1) (a + b + 1) (b - c) 0.
  - chain W (fun p q s r => ToPoint p q r s) (a + b + 1) (a - c - 1) 0 (b - c).
  - chain W (fun q p s r => ToPoint p q r s) (a - c - 1) (a + b + 1) 0 (b - c).
  - chain W (fun p r q s => ToPoint p q r s) (a + b + 1) (b - c - 1) (a - c) 0.
  - chain W (fun r p q s => ToPoint p q r s) (b - c - 1) (a + b + 1) (a - c) 0.
  - chain W (fun p r s q => ToPoint p q r s) (a + b + 1) (b - c - 1) 0 (a - c).
  - chain W (fun r p s q => ToPoint p q r s) (b - c - 1) (a + b + 1) 0 (a - c).
  - chain W (fun p s q r => ToPoint p q r s) (a + b + 2) 0 (a - c + 1) (b - c + 1).
  - chain W (fun s p q r => ToPoint p q r s) 0 (a + b + 2) (a - c + 1) (b - c + 1).
  - chain W (fun p s r q => ToPoint p q r s) (a + b + 2) 0 (b - c + 1) (a - c + 1).
  - chain W (fun s p r q => ToPoint p q r s) 0 (a + b + 2) (b - c + 1) (a - c + 1).
Qed.

(** ** The lattice embeds *)

Section Embeds.
  Variable place : Coord3 -> Coord3.
  Hypothesis Keeps : KeepsShortEdges place.

  Let at_ (f : Coord3 -> Z) p q r s := f (place (ToPoint p q r s)).

  Lemma AtTurns f : Turns (at_ f).
  Proof. intros p q r s. unfold at_. rewrite ToPointTurns. reflexivity. Qed.

  Lemma Steps4 p q r s :
    SameOctant (C3 1 1 1)
      (Difference (place (ToPoint p q r s)) (place (ToPoint (p + 1) q r s))) /\
    SameOctant (C3 1 (-1) (-1))
      (Difference (place (ToPoint p q r s)) (place (ToPoint p (q + 1) r s))) /\
    SameOctant (C3 (-1) 1 (-1))
      (Difference (place (ToPoint p q r s)) (place (ToPoint p q (r + 1) s))) /\
    SameOctant (C3 (-1) (-1) 1)
      (Difference (place (ToPoint p q r s)) (place (ToPoint p q r (s + 1)))).
  Proof.
    destruct (ToPointNext p q r s) as (-> & -> & -> & ->).
    pose proof (fun d => Keeps (ToPoint p q r s) d) as K.
    repeat split; [apply (K Dir_ppp)|apply (K Dir_pmm)|apply (K Dir_mpm)
                  |apply (K Dir_mmp)]; reflexivity.
  Qed.

  Ltac rises :=
    intros p q r s; cbv beta;
    match goal with |- context [at_ ?f] => unfold at_ end;
    match goal with |- context [place (ToPoint ?a ?b ?c ?d)] =>
      pose proof (Steps4 a b c d) as H end;
    repeat match goal with |- context [place ?v] =>
      destruct (place v) end;
    cbn [SameOctant Difference XOf YOf ZOf] in *; lia.

  Lemma XRises : Rises (at_ XOf).
  Proof. rises. Qed.
  Lemma YRises : Rises (fun p r q s => at_ YOf p q r s).
  Proof. rises. Qed.
  Lemma ZRises : Rises (fun p s q r => at_ ZOf p q r s).
  Proof. rises. Qed.

  Theorem LatticeEmbeds tid tid' : InLattice tid -> InLattice tid' ->
    MeetInSharedVertices place (LatticeTet tid) (LatticeTet tid').
  Proof.
    intros L L' w w' W W' T E g.
    destruct (LatticeWeighs tid w L W) as (p & q & r & s & M).
    destruct (LatticeWeighs tid' w' L' W') as (p' & q' & r' & s' & M').
    rewrite <- T in M'. rewrite M, M'.
    destruct (Z.to_nat (Total w)) as [|n] eqn:N; [reflexivity|].
    apply SamePoint in E. destruct E as (Ex & Ey & Ez).
    rewrite M, M' in Ex, Ey, Ez.
    destruct (MixInjective (S n) (at_ XOf) (at_ YOf) (at_ ZOf) p q r s p' q' r' s')
      as (c & -> & -> & -> & ->);
      auto using AtTurns, XRises, YRises, ZRises with arith.
    symmetry. apply MixTurns. intros i j k l. f_equal. apply ToPointTurns.
  Qed.
End Embeds.
