(** * The C++ tables are the certified functions

    CppTables.v is printed by the C++ side.  Each theorem here says that one
    of its tables is what a certified function computes. *)

From Coq Require Import ZArith Reals Lra List.
From Certet Require Import Certificate.
From CertetTables Require Import TableTypes CppTables.
Import ListNotations.
Open Scope Z_scope.

Definition Origin : Coord3 := C3 0 0 0.

(** ** The lattice *)

(** A vertex order, as where each of four marks comes from. *)
Definition OrderMarks (o : VertexOrder) : list Z :=
  let mark n := C3 n 0 0 in
  let read c := match c with C3 n _ _ => n end in
  let '(a, b, c, d) := o (mark 0) (mark 1) (mark 2) (mark 3) in
  [read a; read b; read c; read d].

Definition RowOf (c : StructuredTetCase) : LatticeRow :=
  let neighbor n := (fst n, OrderMarks (snd n)) in
  match GetStructuredTet (STId Origin c) with
    ST v1 v2 v3 v4 n1 n2 n3 n4 =>
      ([v1; v2; v3; v4],
       [neighbor n1; neighbor n2; neighbor n3; neighbor n4],
       CaseHandedness c)
  end.

Theorem CppStructuredTetsCertified : CppStructuredTets = map RowOf AllCases.
Proof. vm_compute. reflexivity. Qed.

Definition CornersOf (c : StructuredTetCase) : list Coord3 :=
  fst (fst (RowOf c)).

Theorem CppCornersCertified : CppCorners = map CornersOf AllCases.
Proof. vm_compute. reflexivity. Qed.

Definition EdgesOf (c : StructuredTetCase) : list (Coord3 * Coord3) :=
  match CornersOf c with
  | [v1; v2; v3; v4] =>
      [(v1, v2); (v1, v3); (v1, v4); (v2, v3); (v2, v4); (v3, v4)]
  | _ => []
  end.

Theorem CppEdgesCertified : CppEdges = map EdgesOf AllCases.
Proof. vm_compute. reflexivity. Qed.

(** ** The stencils *)

(** Pattern n has the sign of corner i in its i-th ternary digit: - 0 +. *)
Definition PatternSign (n i : Z) : Sign :=
  match (n / 3 ^ i) mod 3 with 0 => Minus | 1 => OnSurface | _ => Plus end.

(** Corner a is the pair (a, a), the cut from corner a to corner b is (a, b). *)
Definition StencilOf (n : Z) : list (list (Z * Z)) :=
  let corner i := (i, i) in
  let cut (a b : Z * Z) := (fst a, fst b) in
  map (fun t => match t with UT _ a b c d => [a; b; c; d] end)
      (GetUnstructuredTets (Z * Z) (fun v => PatternSign n (fst v)) cut
         (corner 0) (corner 1) (corner 2) (corner 3)).

Theorem CppStencilsCertified :
  CppStencils = map (fun n => StencilOf (Z.of_nat n)) (seq 0 81).
Proof. vm_compute. reflexivity. Qed.

(** ** Warping *)

Theorem CppDirectionsCertified :
  CppDirections =
  map (fun d => (Offset d, LengthSquared (DirectionKind d), DirectionKind d))
      AllDirections.
Proof. vm_compute. reflexivity. Qed.

Theorem CppThresholdsCertified :
  CppThresholds = [AngleThresholds; EmbeddingThresholds; NoWarpThresholds].
Proof. vm_compute. reflexivity. Qed.

Theorem CppThresholdStepsCertified :
  CppThresholdSteps =
  [ThresholdSteps AngleThresholds Long; ThresholdSteps AngleThresholds Short;
   ThresholdSteps EmbeddingThresholds Long;
   ThresholdSteps EmbeddingThresholds Short].
Proof. vm_compute. reflexivity. Qed.

Theorem CppStepsCertified :
  CppStepBits = Z.of_nat StepBits /\ CppSteps = Steps.
Proof. vm_compute. split; reflexivity. Qed.

(** ** The range

    With these limits nothing overflows: [DoorSuffices], [WarpedFits], [CutFits],
    [MiddleFits], [DecisionsFit], [VolumesFit], [TetsNarrow]. *)

Theorem CppLimitsCertified : CppLimits = [LatticeLimit; AnchorLimit; WidthLimit].
Proof. vm_compute. reflexivity. Qed.

(** ** The bounds that every mesh is held to

    In hundredths of degrees: what the C++ side calls proven is proven. *)

Definition Proven (bounds : list (Z * Z)) : Prop :=
  match bounds with
  | [(least1, greatest1); (least2, greatest2); (least3, greatest3)] =>
      (forall sign cut tid t, CutsOnEdges sign cut ->
         In t (map (MapTet (MeshPosition AngleThresholds sign cut))
                 (StuffTet AngleThresholds sign cut tid)) ->
         WithinDegrees (IZR least1 / 100) (IZR greatest1 / 100) t) /\
      (forall sign cut tid t, CutsOnEdges sign cut ->
         In t (map (MapTet (MeshPosition EmbeddingThresholds sign cut))
                 (StuffTet EmbeddingThresholds sign cut tid)) ->
         WithinDegrees (IZR least2 / 100) (IZR greatest2 / 100) t) /\
      (forall sign tid t,
         let decided v := InOrOut (sign v) in
         let cut (_ _ : Coord3) := MidpointCut in
         In t (map (MapTet (MeshPosition NoWarpThresholds decided cut))
                 (StuffTet NoWarpThresholds decided cut tid)) ->
         WithinDegrees (IZR least3 / 100) (IZR greatest3 / 100) t)
  | _ => False
  end.

Theorem CppBoundsProven : Proven CppBounds.
Proof.
  split; [exact DihedralBoundsInDegrees|].
  split; [exact DihedralBoundsEmbeddingInDegrees|].
  intros sign tid t decided cut I.
  replace (IZR 3000 / 100)%R with 30%R by lra.
  replace (IZR 13500 / 100)%R with 135%R by lra.
  exact (MidpointBoundsInDegrees sign tid t I).
Qed.
