(** * The lattice is a tiling whose neighbours know each other: proof

    Each case is one small piece of integer arithmetic, since all points stand
    at fixed offsets from the reference point. *)

From Certet Require Import Lattice.Definitions.
From Certet Require Import Lattice.Tiling.
Open Scope Z_scope.

(** Two points at fixed offsets are equal, or differ in some coordinate. *)
Ltac points :=
  match goal with
  | |- C3 _ _ _ = C3 _ _ _ => rewrite <- ?Z.add_assoc; reflexivity
  | |- C3 _ _ _ <> C3 _ _ _ => let E := fresh in intros E; injection E; lia
  end.

Theorem LatticeFacesCorrect : TilingFacesCorrect LatticeTiling.
Proof.
  intros [[x y z] case] i j.
  assert (same : LinedUp LatticeTiling (STId (C3 x y z) case) i j
                 = VertexAt (GetStructuredTet (STId (C3 x y z) case)) j
                 \/ i = j) by (destruct case, i, j; cbn; (right; reflexivity) || (left; points)).
  assert (apart : LinedUp LatticeTiling (STId (C3 x y z) case) i i
                  <> VertexAt (GetStructuredTet (STId (C3 x y z) case)) i)
    by (clear j same; destruct case, i; cbn; points).
  split.
  - intros equal <-. exact (apart equal).
  - intros differ. destruct same as [same | <-]; [exact same | easy].
Qed.

Theorem LatticeOrdersKnown : OrdersKnown LatticeTiling.
Proof. intros [anchor []] []; cbn; tauto. Qed.

Theorem LatticeVerticesApart : VerticesApart LatticeTiling.
Proof.
  intros [[x y z] case] i j.
  destruct i, j; try reflexivity; destruct case; cbn;
    intros E; injection E; lia.
Qed.

Lemma ThereAndBack (x y z a b c a' b' c' : Z) :
  a + a' = 0 -> b + b' = 0 -> c + c' = 0 ->
  Translate (Translate (C3 x y z) (C3 a b c)) (C3 a' b' c') = C3 x y z.
Proof.
  intros; cbn; rewrite <- !Z.add_assoc, H, H0, H1, !Z.add_0_r; reflexivity.
Qed.

(** Where [Order2143] puts the vertex of place [i]. *)
Definition Swapped (i : Place) : Place :=
  match i with
  | First => Second | Second => First | Third => Fourth | Fourth => Third
  end.

Theorem LatticeInvolution : TilingInvolution LatticeTiling.
Proof.
  intros [[x y z] case] i; unfold LinedUp; cbn [LatticeTiling Identifier NeighborAt VertexOf].
  pose (same := i); pose (swapped := Swapped i).
  destruct case, i; cbv beta iota zeta delta [NeighborAcross GetStructuredTet].
  all: lazymatch goal with
  | |- context [Pick (Order1234 _ _ _ _)] => exists same, Order1234
  | |- context [Pick (Order2143 _ _ _ _)] => exists swapped, Order2143
  end.
  all: subst same swapped; split; [reflexivity |].
  all: split; [| split; intros a b c d; reflexivity].
  all: cbv beta iota zeta delta [NeighborAcross GetStructuredTet Swapped].
  all: f_equal; f_equal; now apply ThereAndBack.
Qed.
