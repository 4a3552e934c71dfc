(** * Three or four materials in full: proof *)

From Certet Require Import Material.Definitions.
From Certet Require Import Stencil.Symbol Material.MaterialPatterns
  Material.MaterialChecker Material.MaterialNameProof.
Open Scope Z_scope.

Definition AmongFour {V} (v1 v2 v3 v4 : V) (l : Label) : V :=
  match l with F1 => v1 | F2 => v2 | F3 => v3 | _ => v4 end.

Ltac in_full :=
  match goal with
    |- context [SymbolicMaterials GetMaterialTets ?l F1 F2 F3 P] =>
      let r := eval vm_compute in (SymbolicMaterials GetMaterialTets l F1 F2 F3 P) in
      change (SymbolicMaterials GetMaterialTets l F1 F2 F3 P) with r
  end;
  cbv [map fst snd MapTet SymbolVertex AmongFour Meant Z.eqb Pos.eqb].

Theorem ThreeOrFourMaterials :
  forall Vertex GetMaterial GetIntersection v1 v2 v3 v4 shared tets,
    ThreeOrFourInFull Vertex GetMaterial
      (MaterialCut Vertex GetMaterial GetIntersection) v1 v2 v3 v4 = Some tets ->
    GetMaterialTets Vertex GetMaterial GetIntersection v1 v2 v3 v4 shared = tets.
Proof.
  intros V G I v1 v2 v3 v4 shared tets.
  pose proof (TetsNamed V G I (AmongFour v1 v2 v3 v4) shared F1 F2 F3 P) as N.
  cbn [AmongFour] in N. rewrite N. clear N.
  unfold ThreeOrFourInFull, Leader, LeaderFound, Shares.
  cbn [find FiveLabels AmongFour].
  destruct (G v1) as [m1|] eqn:G1, (G v2) as [m2|] eqn:G2, (G v3) as [m3|] eqn:G3,
    (G v4) as [m4|] eqn:G4; try discriminate; rewrite ?Z.eqb_refl;
    repeat match goal with |- context [?a =? ?b] =>
      destruct (a =? b); try discriminate end;
    intros [= <-]; in_full; rewrite ?G1, ?G2, ?G3, ?G4; reflexivity.
Qed.
