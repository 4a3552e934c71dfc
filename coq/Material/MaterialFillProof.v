(** * The tetrahedra of all materials add up to the structured tetrahedron

    In the barycentric coordinates of its corners, in which a cut has two that
    are not zero, the volumes are polynomials in the places of the six cuts; for
    each pattern of materials their sum is that of the whole. *)

From Certet Require Import Material.Definitions.
From Certet Require Import Stencil.Symbol Stencil.TriangleChecker
  Stuffing.NameProof Stuffing.MeshProof Angles.Cases.Isometry
  Angles.Cases.SymmetryProof Material.MaterialProof Material.MaterialChecker
  Material.MaterialNameProof.
Open Scope Z_scope.

(** ** On symbols *)

Definition Four : list Label := [F1; F2; F3; P].

(** The cut's ends have materials, and two of them. *)
Definition ProperCut (leader : Label -> option Label) (s : Symbol) : bool :=
  match s with
  | Base _ => true
  | CutOf a b =>
      match leader a, leader b with
      | Some k, Some l => negb (SameLabel k l)
      | _, _ => false
      end
  end.

Lemma CutsProper : ForAllPatterns (fun leader =>
  forallb (fun t => forallb (fun s => ProperCut leader s && LiesOn Four s)
    (TetCorners (snd t)))
    (SymbolicMaterials GetMaterialTets leader F1 F2 F3 P)) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Section Barycentric.
  (** Steps of a whole edge, and to the cut between two corners. *)
  Variables (S : Z) (t : Label -> Label -> Z).

  Definition UnitOf (l : Label) : Coord3 :=
    match l with
    | F2 => C3 1 0 0 | F3 => C3 0 1 0 | P => C3 0 0 1 | _ => C3 0 0 0
    end.

  Definition Barycentric (s : Symbol) : Coord3 :=
    match s with
    | Base l => Scale S (UnitOf l)
    | CutOf a b =>
        Translate (Scale (S - t a b) (UnitOf a)) (Scale (t a b) (UnitOf b))
    end.

  Definition SumOver (ts : list (Material * SymbolicTet)) : Z :=
    fold_right (fun u sum => SixVolumeOf (MapTet Barycentric (snd u)) + sum) 0 ts.

  Ltac in_full o1 o2 o3 op oq :=
    let l := eval vm_compute in
      (SymbolicMaterials GetMaterialTets (LeaderOf o1 o2 o3 op oq) F1 F2 F3 P) in
    change (SumOver l = S ^ 3).

  Lemma PatternFills o1 o2 o3 op oq :
    In o1 (Leaders F1) -> In o2 (Leaders F2) -> In o3 (Leaders F3) ->
    In op (Leaders P) ->
    forallb (NamesItself (LeaderOf o1 o2 o3 op oq)) Four = true ->
    SumOver (SymbolicMaterials GetMaterialTets (LeaderOf o1 o2 o3 op oq) F1 F2 F3 P)
    = S ^ 3.
  Proof.
    cbn [In Leaders].
    intros I1 I2 I3 I4 C.
    repeat match goal with
    | H : _ \/ _ |- _ => destruct H as [<-|H]
    | H : False |- _ => destruct H
    end; try discriminate C; clear C;
    match goal with |- context [LeaderOf ?a ?b ?c ?d ?e] =>
      in_full a b c d e end;
    cbv [SumOver fold_right snd MapTet Barycentric SixVolumeOf SixVolume Normal
         Cross Dot Difference Translate Scale UnitOf];
    ring.
  Qed.
End Barycentric.

(** ** In space *)

Section Space.
  Variables (S : Z) (t : Label -> Label -> Z).
  (** Where the corners are, and all symbols. *)
  Variable corner : Label -> Coord3.
  Variable position : Symbol -> Coord3.
  Variable leader : Label -> option Label.

  Hypothesis AtCorner : forall l, In l Four -> position (Base l) = corner l.
  Hypothesis AtCut : forall a b, In a Four -> In b Four ->
    ProperCut leader (CutOf a b) = true ->
    Scale S (position (CutOf a b))
    = Translate (Scale (S - t a b) (corner a)) (Scale (t a b) (corner b)).

  Definition Frame : Linear :=
    Lin (Difference (corner F1) (corner F2)) (Difference (corner F1) (corner F3))
      (Difference (corner F1) (corner P)).

  Lemma FrameUnit l : In l Four ->
    corner l = Translate (corner F1) (Apply Frame (UnitOf l)).
  Proof.
    unfold Frame. intros [<-|[<-|[<-|[<-|[]]]]]; cbn [UnitOf];
      destruct (corner F1), (corner F2), (corner F3), (corner P);
      cbn [Apply Difference Scale Translate]; f_equal; ring.
  Qed.

  Lemma PositionByWeights s :
    ProperCut leader s = true -> LiesOn Four s = true ->
    Scale S (position s)
    = Translate (Scale S (corner F1)) (Apply Frame (Barycentric S t s)).
  Proof.
    assert (On : forall l, existsb (SameLabel l) Four = true -> In l Four)
      by (intros []; cbn; auto; discriminate).
    destruct s as [l|a b]; intros C L; cbn [LiesOn] in L; cbn [Barycentric].
    - rewrite (AtCorner l (On l L)), ApplyScale. rewrite (FrameUnit l (On l L)) at 1.
      destruct (corner F1), (Apply Frame (UnitOf l)).
      cbn [Scale Translate]. f_equal; ring.
    - apply andb_true_iff in L as [La Lb].
      rewrite (AtCut a b (On a La) (On b Lb) C), ApplyTranslate, !ApplyScale.
      rewrite (FrameUnit a (On a La)) at 1. rewrite (FrameUnit b (On b Lb)) at 1.
      destruct (corner F1), (Apply Frame (UnitOf a)), (Apply Frame (UnitOf b)).
      cbn [Scale Translate]. f_equal; ring.
  Qed.

  Lemma ScaledVolume k a b c d :
    SixVolume (Scale k a) (Scale k b) (Scale k c) (Scale k d)
    = k ^ 3 * SixVolume a b c d.
  Proof.
    destruct a, b, c, d. unfold SixVolume, Normal.
    cbn [Scale Difference Cross Dot]. ring.
  Qed.

  Lemma TetByWeights (u : SymbolicTet) :
    forallb (fun s => ProperCut leader s && LiesOn Four s) (TetCorners u) = true ->
    S ^ 3 * SixVolumeOf (MapTet position u)
    = SixVolumeOf (MapTet (Barycentric S t) u)
      * SixVolume (corner F1) (corner F2) (corner F3) (corner P).
  Proof.
    destruct u as [a b c d]. cbn [TetCorners forallb MapTet SixVolumeOf].
    rewrite !andb_true_iff. intros ((Pa & La) & (Pb & Lb) & (Pc & Lc) & (Pd & Ld) & _).
    rewrite <- ScaledVolume.
    rewrite (PositionByWeights a Pa La), (PositionByWeights b Pb Lb),
      (PositionByWeights c Pc Lc), (PositionByWeights d Pd Ld).
    unfold SixVolume, Normal. rewrite !TranslatedDifference, <- !ApplyDifference.
    rewrite ApplyTriple. apply Z.mul_comm.
  Qed.

  Lemma SumByWeights ts :
    forallb (fun u => forallb (fun s => ProperCut leader s && LiesOn Four s)
      (TetCorners (snd u))) ts = true ->
    S ^ 3 * fold_right (fun u sum => SixVolumeOf (MapTet position (snd u)) + sum) 0
      (ts : list (Material * SymbolicTet))
    = SumOver S t ts * SixVolume (corner F1) (corner F2) (corner F3) (corner P).
  Proof.
    induction ts as [|u ts IH]; cbn [forallb fold_right SumOver]; [lia|].
    rewrite andb_true_iff. intros [U R]. specialize (IH R).
    pose proof (TetByWeights (snd u) U) as E. unfold SumOver in IH. lia.
  Qed.
End Space.

(** ** In the mesh *)

Lemma OrientedVolume (place : MeshVertex -> Coord3) h u :
  SixVolumeOf (MapTet place (Orient h u))
  = HandDeterminant h * SixVolumeOf (MapTet place u).
Proof.
  destruct u as [a b c d]. destruct h; cbn [Orient MapTet SixVolumeOf HandDeterminant]; [ring|].
  destruct (place a), (place b), (place c), (place d).
  unfold SixVolume, Normal. cbn [Difference Cross Dot]. ring.
Qed.

Lemma StepsNotZero : Steps <> 0.
Proof. vm_compute. discriminate. Qed.

Theorem MaterialsFill : forall before warping cut shared tid,
  TotalSixVolume (PlacedMaterialTets before warping cut shared tid)
  = SixVolumeOf (PlacedWhole warping cut tid).
Proof.
  intros before warping cut shared tid.
  set (material := PlacedMaterial before warping).
  destruct (VerticesNamed tid) as (f1 & f2 & f3 & p & q & distinct & vertices).
  pose proof (MaterialNamesNamed f1 f2 f3 p q material shared tid F1 F2 F3 P vertices)
    as E.
  unfold PlacedMaterialTets. fold material. rewrite E. clear E.
  set (place := PlacedPosition warping cut).
  set (leader := Leader (MaterialAt f1 f2 f3 p q material)).
  set (name := MaterialName f1 f2 f3 p q material).
  set (locate := LocateFive f1 f2 f3 p q).
  assert (W : SixVolumeOf (PlacedWhole warping cut tid)
    = HandDeterminant (Hand tid) * SixVolume (place (Corner (locate F1)))
        (place (Corner (locate F2))) (place (Corner (locate F3)))
        (place (Corner (locate P)))).
  { revert vertices. unfold VerticesAre, PlacedWhole, Hand.
    destruct tid as [anchor case].
    destruct (GetStructuredTet (STId anchor case)) as [v1 v2 v3 v4].
    intros (-> & -> & -> & ->). rewrite OrientedVolume. reflexivity. }
  rewrite W. clear W.
  assert (Sum : forall ts, TotalSixVolume
      (map (fun u => (fst u, MapTet place (snd u)))
        (map (NameTet f1 f2 f3 p q material shared tid) ts))
    = HandDeterminant (Hand tid) * fold_right
        (fun u sum => SixVolumeOf (MapTet (fun s => place (name s)) (snd u)) + sum) 0 ts).
  { induction ts as [|u ts IH]; cbn [map TotalSixVolume fold_right snd NameTet]; [ring|].
    unfold TotalSixVolume in IH. rewrite IH. unfold NameTet. cbn [snd].
    rewrite OrientedVolume. unfold Hand. destruct u as [k [a b c d]].
    cbn [snd MapTet]. unfold name. ring. }
  rewrite Sum. clear Sum. f_equal.
  (* Steps to the cut of an edge, from the end that is named first. *)
  set (t := fun a b =>
    match material (locate a), material (locate b) with
    | Some m, Some n =>
        if m <? n then Steps - cut (locate b) (locate a) else cut (locate a) (locate b)
    | _, _ => 0
    end).
  assert (C : forallb (fun u => forallb (fun s => ProperCut leader s && LiesOn Four s)
      (TetCorners (snd u))) (NamedMaterials f1 f2 f3 p q material F1 F2 F3 P) = true).
  { exact (ForAllPatternsSound (MaterialAt f1 f2 f3 p q material) _ CutsProper). }
  pose proof (SumByWeights Steps t (fun l => place (Corner (locate l)))
    (fun s => place (name s)) leader) as H.
  specialize (H (fun l _ => eq_refl)).
  assert (AtCut : forall a b, In a Four -> In b Four ->
    ProperCut leader (CutOf a b) = true ->
    Scale Steps (place (name (CutOf a b)))
    = Translate (Scale (Steps - t a b) (place (Corner (locate a))))
                (Scale (t a b) (place (Corner (locate b))))).
  { intros a b _ _ Q. cbn [ProperCut] in Q.
    pose proof (LeaderMeans (MaterialAt f1 f2 f3 p q material) a) as Ma.
    pose proof (LeaderMeans (MaterialAt f1 f2 f3 p q material) b) as Mb.
    fold leader in Ma, Mb.
    destruct (leader a) as [ka|]; [|discriminate Q].
    destruct (leader b) as [kb|]; [|discriminate Q].
    destruct Ma as [Na _], Mb as [Nb _].
    unfold MaterialAt in Na, Nb. fold locate in Na, Nb.
    unfold name, t. cbn [MaterialName]. fold locate. unfold MaterialCut.
    cbn [VertexMaterial].
    destruct (material (locate a)) as [m|] eqn:Ea; [|congruence].
    destruct (material (locate b)) as [n|] eqn:Eb; [|congruence].
    unfold material, PlacedMaterial in Ea, Eb.
    unfold place. cbn [PlacedPosition].
    destruct (warping (locate a)); [|discriminate Ea].
    destruct (warping (locate b)); [|discriminate Eb].
    cbn [WarpedPosition].
    destruct (m <? n); cbn [MeshIntersection PlacedPosition]; unfold PointOnEdge;
      destruct (locate a), (locate b); cbn [Scale Translate Difference]; f_equal; ring. }
  specialize (H AtCut _ C). clear AtCut C.
  pose proof (PatternFills Steps t (leader F1) (leader F2) (leader F3) (leader P)
    (leader Q)) as F.
  pose proof (LeadersNameThemselves (MaterialAt f1 f2 f3 p q material)) as N.
  fold leader in N.
  specialize (F (LeaderListed _ F1) (LeaderListed _ F2) (LeaderListed _ F3)
    (LeaderListed _ P)).
  assert (N' : forallb (NamesItself leader) Four = true).
  { cbn [forallb FiveLabels Four] in *. rewrite !andb_true_iff in *. tauto. }
  specialize (F N'). unfold NamedMaterials in H. fold leader in H.
  change (LeaderOf (leader F1) (leader F2) (leader F3) (leader P) (leader Q))
    with leader in F.
  rewrite F in H. apply Z.mul_cancel_l in H; [exact H|].
  apply Z.pow_nonzero; [exact StepsNotZero|discriminate].
Qed.
