(** * The C++ tables are the certified functions

    CppTables.v is printed by the C++ side, from the constants that the engine
    itself uses. *)

From Coq Require Import ZArith Reals Lra String Bool List.
From Certet Require Import Certificate.
From CertetTables Require Import Table TableRules StencilTables KeyTables EngineTables.
From CertetTables Require Import MethodTables LinkTables MaterialTables GradedTables.
From CertetTables Require Import TablesSpec CppTables.
Import ListNotations.
Open Scope Z_scope.

(** ** Every table is right *)

(** No table is dumped of which nothing is expected, and none is left out. *)
Theorem CppTablesExpected : map fst CppTables = map fst Expected.
Proof. reflexivity. Qed.

Definition Dumped : list (string * Table * (string * (Table -> bool))) :=
  combine CppTables Expected.

Theorem CppTablesCertified :
  forallb (fun '((_, table), (_, passes)) => passes table) Dumped = true.
Proof. vm_compute. reflexivity. Qed.

(** A table that passes for another one is that one, so that what differs from
    it in any entry does not pass. *)
Theorem IsTheOnlyOne : forall certified t, Is certified t = true <-> t = certified.
Proof.
  unfold Is. split.
  - revert certified t.
    fix IH 1. intros [m|m e|s|l] [n|n f|u|k]; cbn; try discriminate; intro H.
    + apply Z.eqb_eq in H. congruence.
    + apply andb_prop in H as [H1%Z.eqb_eq H2%Z.eqb_eq]. congruence.
    + apply String.eqb_eq in H. congruence.
    + f_equal. revert k H.
      induction l as [|x l IHl]; intros [|y k] H; try discriminate; [reflexivity|].
      apply andb_prop in H as [H1 H2]. f_equal; [exact (IH x y H1) | exact (IHl k H2)].
  - intros ->. revert certified.
    fix IH 1. intros [n|m e|s|l]; cbn.
    + apply Z.eqb_refl.
    + rewrite !Z.eqb_refl. reflexivity.
    + apply String.eqb_refl.
    + induction l as [|x l IHl]; [reflexivity|].
      apply andb_true_intro. split; [exact (IH x) | exact IHl].
Qed.

(** For instance, and so on for all that are expected to be one table: *)
Theorem CppStructuredTetsCertified : CppStructuredTetTable = StructuredTetTable.
Proof. vm_compute. reflexivity. Qed.

Theorem CppStencilsCertified : CppStencilTable = StencilTable.
Proof. vm_compute. reflexivity. Qed.

Theorem CppKeyStencilsCertified :
  CppCutOrders = CutOrdersTable /\ CppKeyStencilTable = KeyStencilTable.
Proof. split; vm_compute; reflexivity. Qed.

(** ** The range

    With these limits nothing overflows: [DoorSuffices], [WarpedFits], [CutFits],
    [MiddleFits], [DecisionsFit], [VolumesFit], [TetsNarrow]. *)

Theorem CppLimitsCertified :
  [CppCoordinateLimit; CppAnchorLimit; CppCoreEdgeLimit] =
  map Number [LatticeLimit; AnchorLimit; WidthLimit].
Proof. vm_compute. reflexivity. Qed.

(** ** The bounds that every mesh is held to

    What the C++ side calls proven is proven, of every method, wherever the cuts of
    its edges are. *)

Definition Promised (m : Method) (t : UnstructuredTet Coord3) : Prop :=
  WithinDegrees (IZR (LeastAngle m) / 100) (IZR (GreatestAngle m) / 100) t.

Definition Proven (m : Method) : Prop :=
  match m with
  | SettledMethod turns =>
      forall sample cut tids t, CutsOnEdges sample cut ->
        In t (SettledMesh (MethodThresholds m) (OpenSigns sample) (OpenCuts sample cut)
                LevelGap turns tids) ->
        Promised m t
  | KeyMethod turns =>
      forall sample cut tid t, CutsOnEdges sample cut ->
        In t (PlacedWithin (KeySweptMesh (OpenSigns sample) (OpenCuts sample cut) turns)
                tid) ->
        Promised m t
  | AngleMethod | EmbeddingMethod =>
      forall sign cut tid t, CutsOnEdges sign cut ->
        In t (map (MapTet (MeshPosition (MethodThresholds m) sign cut))
                (StuffTet (MethodThresholds m) sign cut tid)) ->
        Promised m t
  | MidpointMethod =>
      forall sign tid t,
        let decided v := InOrOut (sign v) in
        let cut (_ _ : Coord3) := MidpointCut in
        In t (map (MapTet (MeshPosition (MethodThresholds m) decided cut))
                (StuffTet (MethodThresholds m) decided cut tid)) ->
        Promised m t
  end.

Theorem CppMethodsProven : AreMethods CppMethods = true /\ forall m, Proven m.
Proof.
  split; [vm_compute; reflexivity|]. intros [| | |turns|turns].
  - exact DihedralBoundsInDegrees.
  - exact DihedralBoundsEmbeddingInDegrees.
  - intros sign tid t decided cut I. unfold Promised. cbn [LeastAngle GreatestAngle].
    replace (IZR 3000 / 100)%R with 30%R by lra.
    replace (IZR 13500 / 100)%R with 135%R by lra.
    exact (MidpointBoundsInDegrees sign tid t I).
  - intros sample cut. exact (SettledBoundsInDegrees sample cut turns).
  - intros sample cut tid t on. exact (KeySweptBoundsInDegrees sample cut turns on tid t).
Qed.
