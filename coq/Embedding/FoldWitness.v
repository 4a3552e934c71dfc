(** * Two domains whose meshes fold

    Four - corners of one structured tetrahedron, + everywhere else.  The warp
    moves two of them up and the two others down until they have changed sides:
    their own tetrahedron is turned over and dropped, and the kept ones above and
    below overlap.  At 73/256 this shows that a rule is needed, at 65/256 that
    64/256 cannot be improved without one. *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.Degrees.Witnesses.
Open Scope Z_scope.

(** - at the corners of [WitnessTet]. *)
Definition FoldSigns : SignField :=
  fun v => if existsb (Coord3Equal v) (Corners WitnessTet) then Minus else Plus.

(** Its corners are violated straight up and straight down. *)
Definition FoldCuts (t : Z) : CutField :=
  CutTable [(C3 0 4 2, C3 0 2 2, Steps - t); (C3 2 4 2, C3 2 2 2, Steps - t);
            (C3 1 1 1, C3 1 3 1, Steps - t); (C3 1 1 3, C3 1 3 3, Steps - t)].

(** The kept tetrahedra below and above. *)
Definition BelowId : StructuredTetId := STId (C3 0 0 0) Tet_I4.
Definition AboveId : StructuredTetId := STId (C3 0 2 0) Tet_I4.

Definition Below : UnstructuredTet MeshVertex :=
  UT _ (Corner (C3 0 2 2)) (Corner (C3 2 2 2))
       (Corner (C3 1 1 3)) (Corner (C3 1 1 1)).
Definition Above : UnstructuredTet MeshVertex :=
  UT _ (Corner (C3 0 4 2)) (Corner (C3 2 4 2))
       (Corner (C3 1 3 3)) (Corner (C3 1 3 1)).

(** Both are made; and the middle has the weights [near] at the moved vertices
    and [far] at the others in both. *)
Definition Folds (th : Thresholds) (t near far : Z) : Prop :=
  StuffTet th FoldSigns (FoldCuts t) BelowId = [Below] /\
  StuffTet th FoldSigns (FoldCuts t) AboveId = [Above] /\
  PointOf (UT _ near near far far)
    (MapTet (MeshPosition th FoldSigns (FoldCuts t)) Below)
  = PointOf (UT _ far far near near)
      (MapTet (MeshPosition th FoldSigns (FoldCuts t)) Above).

Lemma FoldCutsOnEdges t : 0 <= t <= Steps -> CutsOnEdges FoldSigns (FoldCuts t).
Proof.
  intros T a b _ _. unfold FoldCuts, CutTable. cbn [find fst snd].
  repeat match goal with |- context [if ?c then _ else _] => destruct c end;
    cbn [snd]; unfold MidpointCut; change Steps with 65536 in *;
    try change (65536 / 2) with 32768; lia.
Qed.

Lemma FoldsMeans th t near far : 0 <= t <= Steps -> 0 < near -> 0 < far ->
  Folds th t near far -> SomeMeshFolds th.
Proof.
  intros T N F (B & A & E).
  exists FoldSigns, (FoldCuts t), BelowId, AboveId, Below, Above.
  split; [exact (FoldCutsOnEdges t T)|].
  split; [repeat split; exists 0; reflexivity|].
  split; [split; [exists 0|split; [exists 1|exists 0]]; reflexivity|].
  rewrite A, B. split; [left; reflexivity|]. split; [left; reflexivity|].
  split; [discriminate|].
  exists (UT _ near near far far), (UT _ far far near near).
  split; [cbn; auto|]. split; [cbn; auto|]. split; [cbn; ring|exact E].
Qed.

Theorem AngleThresholdsFold : SomeMeshFolds AngleThresholds.
Proof.
  apply (FoldsMeans AngleThresholds 18687 49152 2303);
    [split; discriminate|reflexivity|reflexivity|vm_compute; repeat split; reflexivity].
Qed.

Theorem SixtyFiveFolds : SomeMeshFolds (TH 65 105).
Proof.
  apply (FoldsMeans (TH 65 105) 16639 16384 85);
    [split; discriminate|reflexivity|reflexivity|vm_compute; repeat split; reflexivity].
Qed.
