(** * The C++ tables are the certified functions

    CppTables.v is printed by the C++ side, from the constants that the engine
    itself uses. *)

From Coq Require Import ZArith Reals Lra String Bool List.
From Certet Require Import Certificate.
From CertetTables Require Import Table TablesSpec CppTables.
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

(** ** The range

    With these limits nothing overflows: [DoorSuffices], [WarpedFits], [CutFits],
    [MiddleFits], [DecisionsFit], [VolumesFit], [TetsNarrow]. *)

Theorem CppLimitsCertified :
  [CppCoordinateLimit; CppAnchorLimit; CppCoreEdgeLimit] =
  map Number [LatticeLimit; AnchorLimit; WidthLimit].
Proof. vm_compute. reflexivity. Qed.

(** ** The bounds that every mesh is held to

    What the C++ side calls proven is proven, of each method and its thresholds. *)

Definition Promised (m : Method) (t : UnstructuredTet Coord3) : Prop :=
  WithinDegrees (IZR (least (bounds m)) / 100) (IZR (greatest (bounds m)) / 100) t.

Definition Proven (m : Method) : Prop :=
  match cuts m, settles m with
  | OnTheSurface, true =>
      forall sign cut stays limit tid t, CutsOnEdges sign cut ->
        In t (WarpOrClamp (thresholds m) sign cut stays limit tid) ->
        Promised m t
  | OnTheSurface, false =>
      forall sign cut tid t, CutsOnEdges sign cut ->
        In t (map (MapTet (MeshPosition (thresholds m) sign cut))
                (StuffTet (thresholds m) sign cut tid)) ->
        Promised m t
  | InTheMiddle, _ =>
      forall sign tid t,
        let decided v := InOrOut (sign v) in
        let cut (_ _ : Coord3) := MidpointCut in
        In t (map (MapTet (MeshPosition (thresholds m) decided cut))
                (StuffTet (thresholds m) decided cut tid)) ->
        Promised m t
  end.

Theorem CppMethodsProven : AreMethods CppMethods = true /\ Forall Proven Methods.
Proof.
  split; [vm_compute; reflexivity|].
  constructor; [exact RuledBoundsInDegrees|].
  constructor; [exact DihedralBoundsInDegrees|].
  constructor; [exact DihedralBoundsEmbeddingInDegrees|].
  constructor; [|constructor].
  intros sign tid t decided cut I. unfold Promised. cbn [bounds least greatest].
  replace (IZR 3000 / 100)%R with 30%R by lra.
  replace (IZR 13500 / 100)%R with 135%R by lra.
  exact (MidpointBoundsInDegrees sign tid t I).
Qed.
