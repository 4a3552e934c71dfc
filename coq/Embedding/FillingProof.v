(** * Every rounded count is a point of a structured tetrahedron, and steps

    The converse of [LatticeWeighs]; and one more count moves a rounded point
    along one placed short edge. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Embedding.Rounding Embedding.LatticeEmbedsProof.
Open Scope Z_scope.

(** ** Every count *)

(** Sorted remainders as weights of a chain. *)
Lemma SortedMix (n : nat) (g : Z -> Z -> Z -> Z -> Z) i j k l a b c :
  0 <= c <= b -> b <= a -> a < Z.of_nat n ->
  let N := Z.of_nat n in
  Mix n g (N * i + a) (N * j + b) (N * k + c) (N * l)
  = (N - a) * g i j k l + (a - b) * g (i + 1) j k l
    + (b - c) * g (i + 1) (j + 1) k l + c * g (i + 1) (j + 1) (k + 1) l.
Proof.
  intros C B A N.
  pose proof (MixChain g (Z.to_nat (N - a)) (Z.to_nat (a - b)) (Z.to_nat (b - c))
    (Z.to_nat c) i j k l) as M.
  cbv zeta in M.
  replace (Z.to_nat (N - a) + Z.to_nat (a - b) + Z.to_nat (b - c) + Z.to_nat c)%nat
    with n in M by (unfold N in *; lia).
  fold N in M. rewrite !Nat2Z.inj_add, !Z2Nat.id in M by (unfold N in *; lia).
  replace (a - b + (b - c) + c) with a in M by ring.
  replace (b - c + c) with b in M by ring. exact M.
Qed.

(** A chain from an even point leads around a structured tetrahedron from its
    second vertex, one from an odd point from its fourth. *)
Definition ChainIn (x0 x1 x2 x3 : Coord3) : Prop :=
  exists tid, InLattice tid /\
    (LatticeTet tid = UT _ x2 x0 x1 x3 \/ LatticeTet tid = UT _ x3 x1 x2 x0).

Lemma ParityOf n : exists h, n = 2 * h \/ n = 2 * h + 1.
Proof. destruct (Z.Even_or_Odd n) as [[h H]|[h H]]; exists h; auto. Qed.

(** From an even point it is [c] whose first vertex stands at [offset], from an
    odd point [c']. *)
Ltac chain_in c offset c' offset' :=
  lazymatch goal with |- ChainIn (ToPoint ?p ?q ?r ?s) _ (ToPoint ?i ?j ?k ?l)
      (ToPoint ?i' ?j' ?k' ?l') =>
    destruct (ParityOf (p + q + r + s)) as [h [H|H]];
    [exists (STId (Difference offset (ToPoint i j k l)) c)
    |exists (STId (Difference offset' (ToPoint i' j' k' l')) c')];
    (split;
     [unfold ToPoint; cbn [Difference InLattice]; repeat split;
      match goal with |- Z.Even ?e => exists (e / 2) end;
      Z.div_mod_to_equations; lia
     |unfold LatticeTet, ToPoint; cbn [GetStructuredTet Difference Translate];
      (left; f_equal; f_equal; lia) || (right; f_equal; f_equal; lia)])
  end.

(** The six orders of the last three diagonals; the first one closes the chain. *)
Lemma ChainsIn p q r s :
  ChainIn (ToPoint p q r s) (ToPoint p (q + 1) r s) (ToPoint p (q + 1) (r + 1) s)
    (ToPoint p (q + 1) (r + 1) (s + 1)) /\
  ChainIn (ToPoint p q r s) (ToPoint p (q + 1) r s) (ToPoint p (q + 1) r (s + 1))
    (ToPoint p (q + 1) (r + 1) (s + 1)) /\
  ChainIn (ToPoint p q r s) (ToPoint p q (r + 1) s) (ToPoint p (q + 1) (r + 1) s)
    (ToPoint p (q + 1) (r + 1) (s + 1)) /\
  ChainIn (ToPoint p q r s) (ToPoint p q (r + 1) s) (ToPoint p q (r + 1) (s + 1))
    (ToPoint p (q + 1) (r + 1) (s + 1)) /\
  ChainIn (ToPoint p q r s) (ToPoint p q r (s + 1)) (ToPoint p (q + 1) r (s + 1))
    (ToPoint p (q + 1) (r + 1) (s + 1)) /\
  ChainIn (ToPoint p q r s) (ToPoint p q r (s + 1)) (ToPoint p q (r + 1) (s + 1))
    (ToPoint p (q + 1) (r + 1) (s + 1)).
Proof.
  repeat split.
  - chain_in Tet_K2 (C3 2 2 0) Tet_I1 (C3 0 2 2).
  - chain_in Tet_J2 (C3 2 0 2) Tet_I3 (C3 0 2 2).
  - chain_in Tet_K4 (C3 2 2 0) Tet_J1 (C3 2 0 2).
  - chain_in Tet_I2 (C3 0 2 2) Tet_J3 (C3 2 0 2).
  - chain_in Tet_J4 (C3 2 0 2) Tet_K1 (C3 2 2 0).
  - chain_in Tet_I4 (C3 0 2 2) Tet_K3 (C3 2 2 0).
Qed.

Lemma ChainWeights x0 x1 x2 x3 w0 w1 w2 w3 : ChainIn x0 x1 x2 x3 ->
  0 <= w0 -> 0 <= w1 -> 0 <= w2 -> 0 <= w3 ->
  exists tid w, InLattice tid /\ NonNegative w /\ Total w = w0 + w1 + w2 + w3 /\
    forall g : Coord3 -> Z, Weigh g w (LatticeTet tid)
      = w0 * g x0 + w1 * g x1 + w2 * g x2 + w3 * g x3.
Proof.
  intros (tid & E & [T|T]) A B C D; exists tid.
  - exists (UT _ w2 w0 w1 w3). rewrite T. cbn [NonNegative Total Weigh].
    repeat split; try assumption; intros; ring.
  - exists (UT _ w3 w1 w2 w0). rewrite T. cbn [NonNegative Total Weigh].
    repeat split; try assumption; intros; ring.
Qed.

(** The remainders sorted as [x], [y], [z], along the chain [C] in the order of
    [T]. *)
Ltac sorted n M C T x y z :=
  let tid := fresh "tid" in let w := fresh "w" in let E := fresh "E" in
  destruct (ChainWeights _ _ _ _ (Z.of_nat n - x) (x - y) (y - z) z C)
    as (tid & w & ? & ? & ? & E); try lia;
  exists tid, w; split; [assumption|]; split; [assumption|]; split; [lia|];
  intros g; rewrite E, M; symmetry;
  apply (SortedMix n (fun i j k l => g (T i j k l))); lia.

Theorem MixWeighs (n : nat) p q r s : (0 < n)%nat ->
  exists tid w, InLattice tid /\ NonNegative w /\ Total w = Z.of_nat n /\
    forall g : Coord3 -> Z, Weigh g w (LatticeTet tid)
      = Mix n (fun p q r s => g (ToPoint p q r s)) p q r s.
Proof.
  intros P. set (N := Z.of_nat n). set (c := p mod N).
  assert (R : forall y, exists m a, y = N * m + a /\ 0 <= a < N).
  { intros y. exists (y / N), (y mod N).
    split; [apply Z.div_mod; unfold N; lia|apply Z.mod_pos_bound; unfold N; lia]. }
  (* Turned so that the first count is whole. *)
  assert (M : forall g : Coord3 -> Z,
    Mix n (fun p q r s => g (ToPoint p q r s)) p q r s
    = Mix n (fun p q r s => g (ToPoint p q r s)) (N * (p / N)) (q - c) (r - c) (s - c)).
  { intros g. rewrite <- (MixTurns n _ (- c) p q r s);
      [|intros i j k l; f_equal; apply ToPointTurns].
    f_equal. unfold c. pose proof (Z.div_mod p N ltac:(unfold N; lia)). lia. }
  destruct (R (q - c)) as (mq & a & Eq & A).
  destruct (R (r - c)) as (mr & b & Er & B).
  destruct (R (s - c)) as (ms & d & Es & D).
  rewrite Eq, Er, Es in M. clear Eq Er Es R.
  destruct (ChainsIn (p / N) mq mr ms) as (Qrs & Qsr & Rqs & Rsq & Sqr & Srq).
  destruct (Z.le_gt_cases a b), (Z.le_gt_cases b d), (Z.le_gt_cases a d); try lia.
  - sorted n M Srq (fun s r q p => ToPoint p q r s) d b a.
  - sorted n M Rsq (fun r s q p => ToPoint p q r s) b d a.
  - sorted n M Rqs (fun r q s p => ToPoint p q r s) b a d.
  - sorted n M Sqr (fun s q r p => ToPoint p q r s) d a b.
  - sorted n M Qsr (fun q s r p => ToPoint p q r s) a d b.
  - sorted n M Qrs (fun q r s p => ToPoint p q r s) a b d.
Qed.
