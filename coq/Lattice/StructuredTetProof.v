(** * The structured tetrahedra are correct: the paper's words

    What [TilingFacesCorrect] says for every place, written out for four. *)

From Certet Require Import Lattice.Definitions.
From Certet Require Import Lattice.Tiling Lattice.TilingProof.
Open Scope Z_scope.

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
  intros tid.
  assert (own : forall i j, j <> i ->
    VertexAt (GetStructuredTet tid) j = LinedUp LatticeTiling tid i j)
    by (intros i j differ; symmetry; now apply LatticeFacesCorrect).
  assert (across : forall i,
    VertexAt (GetStructuredTet tid) i <> LinedUp LatticeTiling tid i i)
    by (intros i same; now apply (LatticeFacesCorrect tid i i)).
  unfold LinedUp in *; cbn [LatticeTiling VertexOf NeighborAt] in *.
  destruct (GetStructuredTet tid)
    as [v1 v2 v3 v4 [tid1 o1] [tid2 o2] [tid3 o3] [tid4 o4]].
  unfold Face1Correct, Face2Correct, Face3Correct, Face4Correct, U.
  pose proof (across First); pose proof (own First Second);
    pose proof (own First Third); pose proof (own First Fourth).
  pose proof (across Second); pose proof (own Second First);
    pose proof (own Second Third); pose proof (own Second Fourth).
  pose proof (across Third); pose proof (own Third First);
    pose proof (own Third Second); pose proof (own Third Fourth).
  pose proof (across Fourth); pose proof (own Fourth First);
    pose proof (own Fourth Second); pose proof (own Fourth Third).
  clear own across; cbn [VertexAt NeighborAcross] in *.
  destruct (GetStructuredTet tid1), (GetStructuredTet tid2),
    (GetStructuredTet tid3), (GetStructuredTet tid4); cbn [VertexAt] in *.
  destruct (o1 _ _ _ _) as [[[? ?] ?] ?], (o2 _ _ _ _) as [[[? ?] ?] ?],
    (o3 _ _ _ _) as [[[? ?] ?] ?], (o4 _ _ _ _) as [[[? ?] ?] ?].
  cbn [Pick] in *.
  repeat split; first [assumption | match goal with H : _ -> ?g |- ?g => apply H; discriminate end].
Qed.

(** The four vertices of a structured tetrahedron are four, *)
Lemma VerticesDistinct :
  forall tid : StructuredTetId,
    match GetStructuredTet tid with
      ST v1 v2 v3 v4 _ _ _ _ =>
        v1 <> v2 /\ v1 <> v3 /\ v1 <> v4 /\ v2 <> v3 /\ v2 <> v4 /\ v3 <> v4
    end.
Proof.
  intros tid; pose proof (LatticeVerticesApart tid) as apart.
  cbn [LatticeTiling VertexOf] in apart; destruct (GetStructuredTet tid).
  repeat split; intros same; [ apply (apart First Second) in same
    | apply (apart First Third) in same | apply (apart First Fourth) in same
    | apply (apart Second Third) in same | apply (apart Second Fourth) in same
    | apply (apart Third Fourth) in same ]; discriminate.
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
