(** * The structured tetrahedra are correct

    Each case is one small piece of integer arithmetic, since all points stand
    at fixed offsets from the reference point. *)

From Coq Require Import ZArith List Lia.
From Certet Require Import Lattice.Coord3 Lattice.StructuredTet.
From Certet Require Import Lattice.StructuredTetSpec.
Import ListNotations.
Open Scope Z_scope.

(** Two points at fixed offsets are equal, or differ in some coordinate. *)
Ltac points :=
  match goal with
  | |- C3 _ _ _ = C3 _ _ _ => rewrite <- ?Z.add_assoc; reflexivity
  | |- C3 _ _ _ <> C3 _ _ _ => let E := fresh in intros E; injection E; lia
  end.

Theorem FacesCorrect :
  forall tid : StructuredTetId,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 (tid1, o1) (tid2, o2) (tid3, o3) (tid4, o4) =>
        (Face1Correct v1 v2 v3 v4 tid1 o1) /\
        (Face2Correct v1 v2 v3 v4 tid2 o2) /\
        (Face3Correct v1 v2 v3 v4 tid3 o3) /\
        (Face4Correct v1 v2 v3 v4 tid4 o4)
    end.
Proof.
  intros [[x y z] []]; cbn; repeat split; points.
Qed.

(** The four vertices of a structured tetrahedron are four, *)
Lemma VerticesDistinct :
  forall tid : StructuredTetId,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 _ _ _ _ =>
        v1 <> v2 /\ v1 <> v3 /\ v1 <> v4 /\ v2 <> v3 /\ v2 <> v4 /\ v3 <> v4
    end.
Proof.
  intros [[x y z] []]; cbn; repeat split; points.
Qed.

(** and none of them is the reference point. *)
Lemma AnchorApart (anchor : Coord3) (case : StructuredTetCase) :
  match GetStructuredTet (STId anchor case) with
    ST v1 v2 v3 v4 _ _ _ _ =>
      v1 <> anchor /\ v2 <> anchor /\ v3 <> anchor /\ v4 <> anchor
  end.
Proof.
  destruct anchor as [x y z], case; cbn; repeat split; points.
Qed.
