(** * Orders of cuts: there are few

    The stencils look at keys only to compare cuts that share an end, so that
    the ranks of the cuts in some order do as well. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Key.KeyTet.
From Certet Require Import Stencil.SymbolProof Key.Orders.
Open Scope Z_scope.

(** ** Keys that compare alike give the same tetrahedra *)

Definition CompareAlike {Vertex : Type} (GetSign : Vertex -> Sign)
    (key key' : Vertex -> Vertex -> Z) (corners : list Vertex) : Prop :=
  forall a e b f, In a corners -> In e corners -> In b corners -> In f corners ->
    GetSign a = Plus -> GetSign e = Minus -> GetSign b = Plus -> GetSign f = Minus ->
    a = b \/ e = f -> (key a e <? key b f) = (key' a e <? key' b f).

Section Alike.
  Variables (Vertex : Type) (GetIntersection : Vertex -> Vertex -> Vertex).
  Variables key key' : Vertex -> Vertex -> Z.

  Local Notation alike a e b f := (Before _ key a e b f = Before _ key' a e b f).

  Lemma PyramidAlike h a b e z : alike a e b e ->
    Pyramid _ GetIntersection key h a b e z = Pyramid _ GetIntersection key' h a b e z.
  Proof. unfold Pyramid. intros ->. reflexivity. Qed.

  Lemma PrismAlike h a b c e : alike a e b e -> alike a e c e -> alike b e c e ->
    Prism _ GetIntersection key h a b c e = Prism _ GetIntersection key' h a b c e.
  Proof. unfold Prism. intros -> -> ->. reflexivity. Qed.

  Lemma WedgeAlike h a b e f : alike a e b e -> alike a f b f ->
    alike a f a e -> alike b f b e ->
    Wedge _ GetIntersection key h a b e f = Wedge _ GetIntersection key' h a b e f.
  Proof. unfold Wedge, WedgeTowards. intros -> -> -> ->. reflexivity. Qed.
End Alike.

Lemma KeyTetsAlike Vertex GetSign GetIntersection key key' (v1 v2 v3 v4 : Vertex) :
  CompareAlike GetSign key key' [v1; v2; v3; v4] ->
  GetKeyTets Vertex GetSign GetIntersection key v1 v2 v3 v4
  = GetKeyTets Vertex GetSign GetIntersection key' v1 v2 v3 v4.
Proof.
  intros alike. unfold CompareAlike in alike. cbn [In] in alike.
  unfold GetKeyTets.
  destruct (GetSign v1) eqn:S1, (GetSign v2) eqn:S2, (GetSign v3) eqn:S3,
    (GetSign v4) eqn:S4; try reflexivity;
    (apply PrismAlike || apply PyramidAlike || apply WedgeAlike);
    apply alike; first [assumption | solve [auto 6]].
Qed.

(** ** Renaming the vertices *)

Section Natural.
  Variables A B : Type.
  Variables (f : A -> B) (CutA : A -> A -> A) (CutB : B -> B -> B).
  Variables (KeyA : A -> A -> Z) (KeyB : B -> B -> Z).
  Variable corners : list A.
  Hypothesis SameCut : forall v w, In v corners -> In w corners ->
    CutB (f v) (f w) = f (CutA v w).
  Hypothesis SameKey : forall v w, In v corners -> In w corners ->
    KeyB (f v) (f w) = KeyA v w.

  Lemma BeforeNatural a e b g :
    In a corners -> In e corners -> In b corners -> In g corners ->
    Before B KeyB (f a) (f e) (f b) (f g) = Before A KeyA a e b g.
  Proof. unfold Before. intros. rewrite !SameKey by assumption. reflexivity. Qed.

  Ltac by_shape :=
    intros; rewrite ?BeforeNatural by assumption;
    repeat match goal with |- context [if ?b then _ else _] => destruct b end;
    repeat match goal with h : Handedness |- _ => destruct h end;
    cbn [map Handed Mirrored MapTet]; rewrite ?SameCut by assumption; reflexivity.

  Lemma PyramidNatural h a b e z :
    In a corners -> In b corners -> In e corners -> In z corners ->
    Pyramid B CutB KeyB h (f a) (f b) (f e) (f z)
    = map (MapTet f) (Pyramid A CutA KeyA h a b e z).
  Proof. unfold Pyramid, PyramidInOrder. by_shape. Qed.

  Lemma PrismNatural h a b c e :
    In a corners -> In b corners -> In c corners -> In e corners ->
    Prism B CutB KeyB h (f a) (f b) (f c) (f e)
    = map (MapTet f) (Prism A CutA KeyA h a b c e).
  Proof. unfold Prism, PrismInOrder. by_shape. Qed.

  Lemma WedgeNatural h a b e g :
    In a corners -> In b corners -> In e corners -> In g corners ->
    Wedge B CutB KeyB h (f a) (f b) (f e) (f g)
    = map (MapTet f) (Wedge A CutA KeyA h a b e g).
  Proof. unfold Wedge, WedgeTowards, WedgeAcross, WedgeBeside. by_shape. Qed.
End Natural.

Lemma KeyTetsNatural {A B : Type} (f : A -> B) SignA SignB CutA CutB KeyA KeyB
    (v1 v2 v3 v4 : A) :
  let corners := [v1; v2; v3; v4] in
  (forall v, In v corners -> SignB (f v) = SignA v) ->
  (forall v w, In v corners -> In w corners -> CutB (f v) (f w) = f (CutA v w)) ->
  (forall v w, In v corners -> In w corners -> KeyB (f v) (f w) = KeyA v w) ->
  GetKeyTets B SignB CutB KeyB (f v1) (f v2) (f v3) (f v4)
  = map (MapTet f) (GetKeyTets A SignA CutA KeyA v1 v2 v3 v4).
Proof.
  intros corners SameSign SameCut SameKey.
  assert (I1 : In v1 corners) by (cbn; tauto).
  assert (I2 : In v2 corners) by (cbn; tauto).
  assert (I3 : In v3 corners) by (cbn; tauto).
  assert (I4 : In v4 corners) by (cbn; tauto).
  assert (paper := GetUnstructuredTetsNatural A B f SignA SignB CutA CutB v1 v2 v3 v4
    SameSign SameCut).
  pose proof (PrismNatural A B f CutA CutB KeyA KeyB corners SameCut SameKey) as prism.
  pose proof (PyramidNatural A B f CutA CutB KeyA KeyB corners SameCut SameKey) as pyramid.
  pose proof (WedgeNatural A B f CutA CutB KeyA KeyB corners SameCut SameKey) as wedge.
  unfold GetKeyTets. rewrite !SameSign by assumption.
  destruct (SignA v1), (SignA v2), (SignA v3), (SignA v4);
    first [exact paper | apply prism; assumption | apply pyramid; assumption
          | apply wedge; assumption].
Qed.

(** ** Ranks instead of keys *)

Section Ranks.
  Variable T : Type.
  Variable same : T -> T -> bool.
  Hypothesis Same : forall x y, same x y = true <-> x = y.

  Variable key : T -> Z.

  Fixpoint InsertByKey (x : T) (l : list T) : list T :=
    match l with
    | [] => [x]
    | y :: r => if key x <? key y then x :: l else y :: InsertByKey x r
    end.

  Definition SortByKey (l : list T) : list T := fold_right InsertByKey [] l.

  Lemma InsertListed x l : In (InsertByKey x l) (Insertions x l).
  Proof.
    induction l as [|y r IH]; cbn; [tauto|].
    destruct (key x <? key y); [left; reflexivity|]. right. apply in_map, IH.
  Qed.

  Lemma SortListed l : In (SortByKey l) (Orders l).
  Proof.
    induction l as [|x r IH]; cbn; [tauto|].
    apply in_flat_map. exists (SortByKey r). split; [exact IH|apply InsertListed].
  Qed.

  Lemma InInserted y x l : In y (InsertByKey x l) <-> y = x \/ In y l.
  Proof.
    induction l as [|z r IH]; cbn; [intuition congruence|].
    destruct (key x <? key z); cbn; rewrite ?IH; intuition congruence.
  Qed.

  Lemma InSorted y l : In y (SortByKey l) <-> In y l.
  Proof.
    induction l as [|x r IH]; [reflexivity|]. cbn [SortByKey fold_right].
    rewrite InInserted. fold (SortByKey r). rewrite IH. cbn. intuition congruence.
  Qed.

  Fixpoint InOrder (l : list T) : Prop :=
    match l with
    | [] => True
    | x :: r => (forall y, In y r -> key x <= key y) /\ InOrder r
    end.

  Lemma InsertInOrder x l : InOrder l -> InOrder (InsertByKey x l).
  Proof.
    induction l as [|y r IH]; cbn; [intuition|]. intros [first rest].
    destruct (Z.ltb_spec (key x) (key y)) as [L|L]; cbn.
    - split; [|auto]. intros z [<-|I]; [lia|]. specialize (first z I). lia.
    - split; [|auto]. intros z I. apply InInserted in I.
      destruct I as [->|I]; auto.
  Qed.

  Lemma SortInOrder l : InOrder (SortByKey l).
  Proof. induction l; cbn; [exact I|]. apply InsertInOrder, IHl. Qed.

  Lemma RankNonNegative l x : 0 <= RankIn same l x.
  Proof. induction l as [|y r IH]; cbn -[Z.add]; [lia|]. destruct (same x y); lia. Qed.

  Lemma RankOrders l x y : InOrder l -> In x l -> In y l ->
    RankIn same l x <= RankIn same l y -> key x <= key y.
  Proof.
    induction l as [|z r IH]; cbn -[Z.add]; [tauto|]. intros [first rest] Ix Iy.
    destruct (same x z) eqn:Ex.
    - apply Same in Ex. subst z. intros _. destruct Iy as [<-|Iy]; [lia|]. auto.
    - destruct (same y z) eqn:Ey.
      + pose proof (RankNonNegative r x). intros L. exfalso. lia.
      + assert (x <> z) by (intros ->; rewrite (proj2 (Same z z) eq_refl) in Ex; discriminate).
        assert (y <> z) by (intros ->; rewrite (proj2 (Same z z) eq_refl) in Ey; discriminate).
        intros L. apply IH; intuition congruence || lia.
  Qed.

  (** Cuts of different keys compare by rank as by key. *)
  Lemma RankCompares l x y : In x l -> In y l -> key x <> key y ->
    (RankIn same (SortByKey l) x <? RankIn same (SortByKey l) y) = (key x <? key y).
  Proof.
    intros Ix Iy N. rewrite <- InSorted in Ix, Iy.
    pose proof (RankOrders _ x y (SortInOrder l) Ix Iy).
    pose proof (RankOrders _ y x (SortInOrder l) Iy Ix).
    destruct (Z.ltb_spec (key x) (key y)), (Z.ltb_spec (RankIn same (SortByKey l) x)
      (RankIn same (SortByKey l) y)); lia || reflexivity.
  Qed.
End Ranks.

Arguments InsertByKey {T}.
Arguments SortByKey {T}.
Arguments InOrder {T}.
Arguments SortListed {T}.
Arguments InSorted {T}.
Arguments SortInOrder {T}.
Arguments RankCompares {T}.
