(** * Three levels up no volume overflows: proof *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Lattice.Tiling Mesh.Method Mesh.CertifiedSpec
  Range.RangeSpec Range.RangeProof.
From Certet Require Import Grading.Octree Grading.Flag Grading.GradedTet
  Grading.Surface Grading.GradingSpec.
From Certet Require Import Grading.GradedVolumeProof Grading.GradedMeshProof.
Open Scope Z_scope.

(** ** How wide a tetrahedron is *)

Definition IsNarrow (a b : Coord3) : bool :=
  match Difference a b with
    C3 x y z => (Z.abs x <=? 2) && (Z.abs y <=? 2) && (Z.abs z <=? 2)
  end.

Lemma AllNarrow :
  ForAllFlags (fun tid =>
    match GetGradedTet tid with
      UT _ a b c d => IsNarrow a b && IsNarrow a c && IsNarrow a d
    end) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma MovedNarrow level v a b : (level <= 3)%nat -> IsNarrow a b = true ->
  Bounded (2 ^ 20)
    (Difference (Move Steps (C3 0 0 0) (Move (HalfSide level) v a))
       (Move Steps (C3 0 0 0) (Move (HalfSide level) v b))).
Proof.
  intros L N. rewrite !MoveDifference. unfold IsNarrow in N.
  destruct (Difference a b) as [x y z]. apply andb_prop in N as [N Z].
  apply andb_prop in N as [X Y]. apply Z.leb_le in X, Y, Z.
  assert (H : 1 <= HalfSide level <= 8).
  { do 4 (destruct level as [|level]; [vm_compute; split; discriminate|]). lia. }
  change Steps with 65536. change (2 ^ 20) with 1048576.
  intros []; cbn [Scale Along]; nia.
Qed.

Lemma StepsInType v k : Bounded LatticeLimit v ->
  InType 32 (Along k (Move Steps (C3 0 0 0) v)).
Proof.
  intros B. specialize (B k). unfold LatticeLimit in B. unfold InType.
  change (2 ^ (32 - 1)) with 2147483648. change Steps with 65536.
  destruct v, k; unfold Move; cbn [Translate Scale Along] in *; lia.
Qed.

Theorem GradedVolumesFit :
  forall (method : Method) (sign : SignField) (domain : PositionSigns) cells,
    let mesh := MeshOf method sign domain in
    IsOctree cells -> KeepsSurface (CornerSigns mesh) cells ->
    forall tid t, InGradedMesh cells tid -> StructuredName tid = None ->
      (LevelOf (FlagOfName tid) <= 3)%nat ->
      (forall i, Bounded LatticeLimit (GradedVertexAt tid i)) ->
      In t (GradedTetsWithin mesh tid) -> VolumeFits (MapTet (PositionIn mesh) t).
Proof.
  intros method sign domain cells mesh octree kept tid t M N L B I.
  unfold GradedTetsWithin in I. rewrite N in I. destruct I as [<- | []]. subst mesh.
  rewrite (PlainPlaced method sign domain cells octree kept tid M N).
  assert (T : forall v, In v (TetCorners (GetGradedTet tid)) -> forall k,
    InType 32 (Along k (Move Steps (C3 0 0 0) v))).
  { intros v V k. destruct (GradedVertexIn tid v V) as [i ->]. now apply StepsInType. }
  destruct tid as [kind [level c o s t u]]. cbn [FlagOfName LevelOf] in L.
  rewrite MovedTet in *.
  pose proof (ForEachFlag _ AllNarrow kind o s t u) as W. cbv beta in W.
  destruct (GetGradedTet (GTId kind (AtOrigin o s t u))) as [p q r w].
  apply andb_prop in W as [W W3]. apply andb_prop in W as [W1 W2].
  cbn [MapTet VolumeFits TetCorners] in *.
  apply WideVolumesFit; try (now apply MovedNarrow).
  intros x [<- | [<- | [<- | [<- | []]]]]; apply T; cbn [In]; tauto.
Qed.
