(** * Of one material, the rule that runs is that of one surface: proof *)

From Coq Require Import FMapPositive.
From Certet Require Import Material.Definitions.
From Certet Require Import Angles.Cases.AdmissibleProof Embedding.DiskTables
  Embedding.GreedyProof Embedding.SettleProof Material.MaterialProof
  Material.MaterialReducesProof Material.SettleMaterials.
Open Scope Z_scope.

(** Checking a proof needs their names, never what they are. *)
Local Strategy 1000 [WarpVertex WarpMaterialVertex IsDisk].

Lemma TargetDepends th field field' cut v : (forall u, field u = field' u) ->
  WarpMaterialVertex th field cut v = WarpMaterialVertex th field' cut v.
Proof.
  intros E. unfold WarpMaterialVertex. rewrite (E v).
  destruct (field' v) as [m|]; [|reflexivity].
  apply WarpDepends; intros d; unfold Violates, SignAmongMaterials, MaterialCutFrom;
    cbv zeta; rewrite !E; reflexivity.
Qed.

Lemma AtGathered {A} (f : Direction -> A) d : At (Gather f) d = f d.
Proof. destruct d; reflexivity. Qed.

Lemma FoldSame {A B} (P : A -> Prop) (f g : A -> B -> A) :
  (forall a b, P a -> f a b = g a b) -> (forall a b, P a -> P (g a b)) ->
  forall l a, P a -> fold_left f l a = fold_left g l a.
Proof.
  intros E K l. induction l as [|b l IH]; intros a H; [reflexivity|].
  cbn [fold_left]. rewrite (E a b H). apply IH, K, H.
Qed.

Section One.
  Variables (bounds : AngleBounds) (th : Thresholds) (sign : SignField) (cut : CutField).
  Variable m : Material.
  Hypothesis Above : Outside < m.
  Hypothesis Decided : forall v, sign v <> OnSurface.

  Let material (v : Coord3) : Material := match sign v with Plus => m | _ => Outside end.
  Local Notation field := (fun v => Some (material v)).

  Lemma FieldIsOne v : Some (material v) = OneMaterial m (sign v).
  Proof.
    unfold material. pose proof (Decided v).
    destruct (sign v); cbn [OneMaterial]; congruence.
  Qed.

  Lemma TargetSame v : WarpMaterialVertex th field cut v = WarpVertex th sign cut v.
  Proof.
    rewrite <- (MaterialWarpReduces th sign cut m v Above).
    apply TargetDepends, FieldIsOne.
  Qed.

  (** Between the inside and the outside. *)
  Lemma TargetMeans v e t : WarpVertex th sign cut v = Moves e t ->
    sign v = Plus /\ sign (Translate v (Offset e)) = Minus \/
    sign v = Minus /\ sign (Translate v (Offset e)) = Plus.
  Proof.
    intros W. destruct (WarpedMeans th sign cut v e t W) as (_ & O & _).
    destruct (sign v), (sign (Translate v (Offset e))); try discriminate O; auto.
  Qed.

  (** ** Links *)

  Lemma SignsSame inner zeros v : inner m = true -> inner Outside = false ->
    SignsAmong inner (MaterialLink material zeros v) = LinkAmong sign zeros v.
  Proof.
    intros I O.
    assert (E : forall u,
      match PlacedMaterial field (PlaceIn zeros) u with
      | None => OnSurface
      | Some k => if inner k then Plus else Minus
      end = SignAmong sign zeros u).
    { intros u. unfold PlacedMaterial, SignAmong.
      destruct (PlaceIn zeros u); [|reflexivity]. cbn [WarpedSign]. unfold material.
      pose proof (Decided u). destruct (sign u); rewrite ?I, ?O; congruence. }
    unfold SignsAmong, MaterialLink, LinkAmong, Gather. cbn [At]. rewrite !E. reflexivity.
  Qed.

  Lemma InLinkAmong zeros v d k : At (MaterialLink material zeros v) d = Some k ->
    k = m \/ k = Outside.
  Proof.
    unfold MaterialLink. rewrite AtGathered. unfold PlacedMaterial.
    destruct (PlaceIn zeros _); [|discriminate]. intros [= <-]. unfold material.
    destruct (sign _); auto.
  Qed.

  Lemma LeastFrom l : (forall k, In k l -> k = m \/ k = Outside) ->
    forall a, a = Outside \/ a = m /\ In Outside l -> fold_left Z.min l a = Outside.
  Proof.
    induction l as [|k l IH]; intros B a A; cbn [fold_left].
    - destruct A as [A|[_ []]]; exact A.
    - apply IH; [intros n I; apply B; right; exact I|].
      destruct (B k) as [K|K]; [left; reflexivity| |]; destruct A as [A|[A [I|I]]];
        try (left; lia); right; (split; [lia|exact I]).
  Qed.

  Lemma LowestIsOutside l : (forall k, In k l -> k = m \/ k = Outside) ->
    In Outside l -> LowestOf l = Outside.
  Proof.
    intros B I. destruct l as [|k l]; [destruct I|]. cbn [LowestOf].
    apply LeastFrom; [intros n J; apply B; right; exact J|].
    destruct I as [I|I]; [left; exact I|].
    destruct (B k) as [K|K]; [left; reflexivity|right; auto|left; exact K].
  Qed.

  Lemma DisksAmong link signs materials :
    (forall inner, inner m = true -> inner Outside = false ->
       SignsAmong inner link = signs) ->
    (forall k, In k materials -> k = m \/ k = Outside) -> In Outside materials ->
    AreDisks materials link = IsDisk signs.
  Proof.
    intros S B O.
    assert (NotOut : m =? Outside = false) by (apply Z.eqb_neq; lia).
    unfold AreDisks. rewrite (LowestIsOutside materials B O).
    rewrite (S (fun k => negb (k =? Outside)))
      by (rewrite ?NotOut, ?Z.eqb_refl; reflexivity).
    destruct (IsDisk signs) eqn:D; [|apply andb_false_r].
    rewrite andb_true_r. apply forallb_forall. intros k I.
    destruct (B k I) as [-> | ->]; [|rewrite Z.eqb_refl; reflexivity].
    rewrite (S (Z.eqb m)), D, orb_true_r by (exact NotOut || apply Z.eqb_refl).
    reflexivity.
  Qed.

  Lemma AroundMeans zeros v e t : WarpVertex th sign cut v = Moves e t ->
    let materials := MaterialsAround material v e (MaterialLink material zeros v) in
    (forall k, In k materials -> k = m \/ k = Outside) /\ In Outside materials.
  Proof.
    intros W. cbv zeta. unfold MaterialsAround.
    assert (F : forall u, material u = m \/ material u = Outside)
      by (intros u; unfold material; destruct (sign u); auto).
    assert (L : forall d k, At (MaterialLink material zeros v) d = Some k ->
      k = m \/ k = Outside) by (intros d k; apply InLinkAmong).
    assert (O : material v = Outside \/ material (Translate v (Offset e)) = Outside).
    { unfold material. destruct (TargetMeans v e t W) as [[_ ->]|[-> _]]; auto. }
    revert F L O. generalize (MaterialLink material zeros v), material.
    intros link solid F L O. split.
    - intros k I. apply MaterialsOfIn in I. destruct I as (o & I & ->).
      destruct I as [I|[I|I]]; [injection I as <-; apply F..|].
      apply in_map_iff in I. destruct I as (d & I & _). exact (L d k I).
    - apply MaterialsOfIn. exists (Some Outside). split; [|reflexivity].
      destruct O as [<-|<-]; [left|right; left]; reflexivity.
  Qed.

  Lemma DisksSame zeros v e t : WarpVertex th sign cut v = Moves e t ->
    AreDisks (MaterialsAround material v e (MaterialLink material zeros v))
      (MaterialLink material zeros v)
    = IsDisk (LinkAmong sign zeros v).
  Proof.
    intros W. destruct (AroundMeans zeros v e t W) as [B O].
    exact (DisksAmong _ _ _ (fun inner => SignsSame inner zeros v) B O).
  Qed.

  Lemma NoFillsTouch zeros v : FillsWouldTouch (MaterialLink material zeros v) = false.
  Proof.
    apply not_true_iff_false. intros T. unfold FillsWouldTouch in T.
    apply existsb_exists in T. destruct T as ([[d e] [f g]] & _ & T).
    destruct (DirectionKind d), (DirectionKind e); try discriminate T.
    destruct (At _ d) as [k|] eqn:K; [|discriminate T].
    destruct (At _ e) as [n|] eqn:N; [|discriminate T].
    destruct (At _ f) as [o|] eqn:P; [|discriminate T].
    destruct (At _ g) as [o'|] eqn:Q; [|discriminate T].
    apply InLinkAmong in K, N, P, Q.
    rewrite !andb_true_iff, !negb_true_iff, !Z.eqb_neq, Z.eqb_eq in T. lia.
  Qed.

  (** ** One turn *)

  (** Who moved was violated. *)
  Definition AtTargets (zeros : Zeros) : Prop :=
    forall v e t, PlaceIn zeros v = Moves e t ->
      exists t', WarpVertex th sign cut v = Moves e t'.

  Lemma AtTargetsMoved zeros v e t t' : AtTargets zeros ->
    WarpVertex th sign cut v = Moves e t ->
    AtTargets (PositiveMap.add (PointKey v) (Moves e t') zeros).
  Proof.
    intros A W u f s P. destruct (SamePoint3 u v) as [->|N].
    - rewrite PlacedHere in P. injection P as <- <-. exists t. exact W.
    - rewrite PlacedElsewhere in P by exact N. exact (A u f s P).
  Qed.

  Lemma SideSame v e t : WarpVertex th sign cut v = Moves e t ->
    MaterialSide th material cut v = sign v.
  Proof.
    intros W. unfold MaterialSide. rewrite TargetSame, W. unfold IsHigher, material.
    destruct (TargetMeans v e t W) as [[-> ->]|[-> ->]].
    - rewrite (proj2 (Z.ltb_lt Outside m)) by exact Above. reflexivity.
    - rewrite (proj2 (Z.ltb_ge m Outside)) by lia. reflexivity.
  Qed.

  Lemma TurnSame v : MaterialTurn th material cut v = Turn th sign cut v.
  Proof.
    unfold MaterialTurn, Turn. rewrite TargetSame.
    destruct (WarpVertex th sign cut v) as [|e t] eqn:W; [reflexivity|].
    unfold IsHigher, material. destruct (TargetMeans v e t W) as [[-> ->]|[-> ->]].
    - rewrite (proj2 (Z.ltb_lt Outside m)) by exact Above. reflexivity.
    - rewrite (proj2 (Z.ltb_ge m Outside)) by lia. reflexivity.
  Qed.

  Lemma ViolatesSame v d :
    MaterialViolatesAt th material cut v d = ViolatesAt th sign cut v d.
  Proof.
    assert (Out : (Outside =? m) = false) by (apply Z.eqb_neq; lia).
    assert (Out' : (m =? Outside) = false) by (apply Z.eqb_neq; lia).
    assert (L : (m <? Outside) = false) by (apply Z.ltb_ge; lia).
    assert (L' : (Outside <? m) = true) by (apply Z.ltb_lt; lia).
    unfold MaterialViolatesAt, ViolatesAt, Violates, SignAmongMaterials,
      MaterialCutFrom, CutFrom, material. cbv zeta.
    pose proof (Decided v) as D. pose proof (Decided (Translate v (Offset d))) as D'.
    destruct (sign v), (sign (Translate v (Offset d)));
      try (exfalso; apply D; reflexivity); try (exfalso; apply D'; reflexivity);
      rewrite ?Z.eqb_refl, ?Out, ?Out', ?L, ?L'; reflexivity.
  Qed.

  Lemma StaysRatherSame v e t reached :
    StaysRather th (MaterialViolatesAt th material cut v) e t reached
    = StaysRather th (ViolatesAt th sign cut v) e t reached.
  Proof.
    unfold StaysRather. f_equal. generalize AllDirections. intros ds.
    induction ds as [|d ds IH]; [reflexivity|]. cbn [forallb].
    rewrite ViolatesSame, IH. reflexivity.
  Qed.

  Local Notation room side target turn :=
    (RoomBeside side LevelGap target turn).

  Lemma RoomSame zeros v e t d : AtTargets zeros -> WarpVertex th sign cut v = Moves e t ->
    room (MaterialSide th material cut) (WarpMaterialVertex th field cut)
      (MaterialTurn th material cut) zeros v e t d
    = room sign (WarpVertex th sign cut) (Turn th sign cut) zeros v e t d.
  Proof.
    intros A W. unfold RoomBeside. cbv zeta. rewrite TargetSame, !TurnSame.
    set (w := Translate v (Offset d)).
    destruct (DirectionKind d), (0 <? Dot (Offset d) (Offset e)); try reflexivity.
    unfold RoomFor. rewrite (SideSame v e t W).
    destruct (PlaceIn zeros w) as [|e' t'] eqn:P.
    - destruct (WarpVertex th sign cut w) as [|e' t'] eqn:W'; [reflexivity|].
      rewrite (SideSame w e' t' W'). reflexivity.
    - destruct (A w e' t' P) as [s' W']. rewrite (SideSame w e' s' W'). reflexivity.
  Qed.

  Lemma ShortenedSame zeros v e t : AtTargets zeros ->
    WarpVertex th sign cut v = Moves e t ->
    Shortened (MaterialSide th material cut) LevelGap (WarpMaterialVertex th field cut)
      (MaterialTurn th material cut) zeros v e t
    = Shortened sign LevelGap (WarpVertex th sign cut) (Turn th sign cut) zeros v e t.
  Proof.
    intros A W. unfold Shortened. destruct (DirectionKind e); try reflexivity.
    generalize t at 2 4. generalize AllDirections. intros ds.
    induction ds as [|d ds IH]; intros r; [reflexivity|]. cbn [fold_left].
    rewrite (RoomSame zeros v e t d A W). apply IH.
  Qed.

  Lemma LowerIsOutside zeros v k : AtTargets zeros ->
    LowerIn material zeros v = Some k -> k = Outside.
  Proof.
    intros A. unfold LowerIn. destruct (PlaceIn zeros v) as [|e t] eqn:P; [discriminate|].
    intros [= <-]. destruct (A v e t P) as [t' W]. unfold LowerOf, material.
    destruct (TargetMeans v e t' W) as [[-> ->]|[-> ->]]; lia.
  Qed.

  Lemma SharedIsOutside zeros tid : AtTargets zeros ->
    SharedIn material zeros tid = Outside.
  Proof.
    intros A. unfold SharedIn. destruct (Corners tid) as [|v vs]; [reflexivity|].
    cbn [map]. destruct (LowerIn material zeros v) as [k|] eqn:L; [|reflexivity].
    exact (LowerIsOutside zeros v k A L).
  Qed.

  Lemma AllMayShare zeros tid : AtTargets zeros ->
    MayShare bounds material cut zeros tid = true.
  Proof.
    intros A. unfold MayShare. destruct (HaveMoved zeros tid) eqn:H; [|reflexivity].
    rewrite (SharedIsOutside zeros tid A), Z.eqb_refl, andb_true_r.
    apply forallb_forall. intros v I. unfold HaveMoved in H.
    rewrite forallb_forall in H. specialize (H v I).
    destruct (LowerIn material zeros v) as [k|] eqn:L.
    - rewrite (LowerIsOutside zeros v k A L). apply forallb_forall. intros d _.
      apply Z.leb_le. unfold material. destruct (sign _); lia.
    - unfold LowerIn in L. destruct (PlaceIn zeros v); [discriminate H|discriminate L].
  Qed.

  Lemma OneSame zeros v : AtTargets zeros ->
    SettleOneMaterial bounds th material cut zeros v
    = SettleOne th sign cut LevelGap zeros v.
  Proof.
    intros A. unfold SettleOneMaterial, SettleOne. rewrite TargetSame.
    destruct (WarpVertex th sign cut v) as [|e t] eqn:W; [reflexivity|]. cbv zeta.
    rewrite (DisksSame zeros v e t W), NoFillsTouch, andb_true_r.
    destruct (IsDisk _); [|reflexivity]. rewrite (ShortenedSame zeros v e t A W).
    rewrite StaysRatherSame. destruct (StaysRather _ _ _ _ _); [reflexivity|].
    cbn [negb andb]. rewrite (proj2 (forallb_forall _ _)); [reflexivity|].
    intros tid _. apply AllMayShare. exact (AtTargetsMoved zeros v e t _ A W).
  Qed.

  Lemma OneAtTargets zeros v : AtTargets zeros ->
    AtTargets (SettleOne th sign cut LevelGap zeros v).
  Proof.
    intros A. unfold SettleOne.
    destruct (WarpVertex th sign cut v) as [|e t] eqn:W; [exact A|].
    destruct (IsDisk _); [|exact A]. cbv zeta.
    destruct (StaysRather _ _ _ _ _); [exact A|].
    exact (AtTargetsMoved zeros v e t _ A W).
  Qed.

  (** ** All of them *)

  Lemma NobodyAtTargets : AtTargets NoZeros.
  Proof. intros v e t P. rewrite NoneIn in P. discriminate P. Qed.

  Theorem SettleReduces vs :
    SettleMaterials bounds th material cut vs = Settle th sign cut LevelGap vs.
  Proof.
    unfold SettleMaterials, Settle.
    exact (FoldSame AtTargets _ _ OneSame OneAtTargets vs NoZeros NobodyAtTargets).
  Qed.

  Theorem MaterialsInTurnReduce vs :
    MaterialsInTurn th material cut vs = InTurn th sign cut vs.
  Proof.
    unfold MaterialsInTurn, InTurn. cbv zeta.
    rewrite (map_ext _ (fun v => (Turn th sign cut v, v)))
      by (intros v; rewrite TurnSame; reflexivity).
    rewrite (filter_ext _ (Violated th sign cut)); [reflexivity|].
    intros v. rewrite TargetSame. reflexivity.
  Qed.

  Theorem SettledTetsReduce vs tid :
    OfMaterial m
      (SettledMaterialTets th material cut
         (SettleMaterials bounds th material cut vs) tid)
    = SettledTets th sign cut (Settle th sign cut LevelGap vs) tid.
  Proof.
    rewrite SettleReduces. set (zeros := Settle th sign cut LevelGap vs).
    assert (A : AtTargets zeros).
    { apply (FoldKeeps AtTargets); [|exact NobodyAtTargets].
      intros now v. apply OneAtTargets. }
    unfold SettledTets. rewrite <- (PlacedReduces sign _ _ tid m Above).
    unfold SettledMaterialTets, PlacedMaterialTets. do 2 f_equal.
    rewrite (MaterialNamesDepend _ (PlacedMaterial (fun c => OneMaterial m (sign c))
      (PlaceIn zeros))).
    - unfold MaterialNames. rewrite (SharedIsOutside zeros tid A). reflexivity.
    - intros c. unfold PlacedMaterial. destruct (PlaceIn zeros c); [apply FieldIsOne|reflexivity].
  Qed.
End One.
