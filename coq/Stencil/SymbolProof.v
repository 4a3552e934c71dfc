(** * Symbols stand for vertices

    Comparing and enumerating symbols is sound, and the paper's stencils are
    natural, so that running a natural stencil set on symbols tells what it
    does on any vertices. *)

From Certet Require Import Stencil.Definitions.
From Certet Require Import Stencil.Symbol.

Lemma SameLabelEqual (a b : Label) : SameLabel a b = true <-> a = b.
Proof. split; [destruct a, b; easy | intros ->; now destruct b]. Qed.

Lemma SameSymbolEqual (s t : Symbol) : SameSymbol s t = true <-> s = t.
Proof.
  destruct s, t; cbn; rewrite ?andb_true_iff, ?SameLabelEqual;
    intuition congruence.
Qed.

Lemma MemberIn (s : Symbol) (symbols : list Symbol) :
  Member s symbols = true <-> In s symbols.
Proof.
  unfold Member; rewrite existsb_exists; split.
  - now intros (t & inside & ->%SameSymbolEqual).
  - intros inside; exists s; split; [easy | now apply SameSymbolEqual].
Qed.

Lemma ForAllSignsSound (test : Sign -> bool) :
  ForAllSigns test = true -> forall s, test s = true.
Proof.
  unfold ForAllSigns; rewrite !andb_true_iff.
  intros [[plus zero] minus] []; assumption.
Qed.

Lemma ForAllSignAssignmentsSound (test : (Label -> Sign) -> bool) :
  ForAllSignAssignments test = true ->
  forall s1 s2 s3 sp sq, test (SignOf s1 s2 s3 sp sq) = true.
Proof.
  intros all s1 s2 s3 sp sq.
  do 5 (eapply ForAllSignsSound in all; cbn beta in all).
  exact all.
Qed.

(** ** Naturality *)

(** For any table of sign patterns, and a little besides. *)
Ltac by_patterns :=
  intros A B f SignA SignB IntersectionA IntersectionB v1 v2 v3 v4 corners
    SameSign SameIntersection;
  unfold corners in *; cbn [In] in *;
  lazymatch goal with |- ?T B _ _ _ _ _ _ = _ => unfold T end;
  rewrite ?SameSign, ?SameIntersection by tauto;
  destruct (SignA v1), (SignA v2), (SignA v3), (SignA v4); reflexivity.

Lemma GetUnstructuredTetsNatural : Natural GetUnstructuredTets.
Proof. by_patterns. Qed.

(** ** From symbols to vertices *)

Section Interpret.
  Variables (T : StencilSet) (natural : Natural T).
  Variables (Vertex : Type) (GetSign : Vertex -> Sign).
  Variable GetIntersection : Vertex -> Vertex -> Vertex.
  Variables f1 f2 f3 p q : Vertex.

  Let locate := Locate Vertex f1 f2 f3 p q.
  Let interpret := Interpret Vertex GetIntersection f1 f2 f3 p q.

  (** The signs of the five vertices. *)
  Let sign := SignOf (GetSign f1) (GetSign f2) (GetSign f3)
                     (GetSign p) (GetSign q).

  Lemma InterpretTets (a b c d : Label) :
    T Vertex GetSign GetIntersection (locate a) (locate b) (locate c) (locate d)
    = map (MapTet interpret)
        (T Symbol (SymbolSign sign) SymbolIntersection
           (Base a) (Base b) (Base c) (Base d)).
  Proof.
    apply (natural Symbol Vertex interpret (SymbolSign sign) GetSign
             SymbolIntersection GetIntersection
             (Base a) (Base b) (Base c) (Base d)).
    - cbn [In]; intros v corner.
      assert (exists l, v = Base l) as [l ->] by intuition eauto.
      now destruct l.
    - cbn [In]; intros v w corner1 corner2.
      assert (exists l, v = Base l) as [l ->] by intuition eauto.
      assert (exists m, w = Base m) as [m ->] by intuition eauto.
      reflexivity.
  Qed.
End Interpret.
