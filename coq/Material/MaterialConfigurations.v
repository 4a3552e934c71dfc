(** * What warping can leave of a tetrahedron of several materials, enumerated

    To the configurations of one material against the rest come those of moves
    towards a third material: any, but for two corners along one edge.  To their
    tetrahedra comes the fill. *)

From Certet Require Import Material.Definitions.
From Certet Require Import Angles.Forms.Checker Angles.Cases.Configurations.
Open Scope Z_scope.

(** ** Moves towards a third material *)

Definition NotMutual (moves : Quad (option Direction)) : bool :=
  forallb (fun i => forallb (fun j =>
    negb (Targets i j (Of moves i) && Targets j i (Of moves j))) AllLabels)
    AllLabels.

(** Those that no signs before warping explain. *)
Definition ThirdMoves (signs : Quad Sign) : list (Quad (option Direction)) :=
  match signs with
    Q4 a b c d =>
      filter (fun moves =>
        if NotMutual moves then negb (Consistent signs moves) else false)
        (Product4 (MovesOf a) (MovesOf b) (MovesOf c) (MovesOf d))
  end.

Definition ThirdConfigurations : list (Quad Sign * Quad (option Direction)) :=
  flat_map (fun signs =>
    match SymbolTets GetUnstructuredTets signs with
    | [] => []
    | _ => map (pair signs) (ThirdMoves signs)
    end) AllSigns.

Definition CheckThirdMoves (bounds : AngleBounds) (r : Ranges) : bool :=
  forallb (fun signs =>
    match SymbolTets GetUnstructuredTets signs with
    | [] => true
    | tets =>
        forallb (fun moves => forallb (fun t =>
          CheckTet bounds (MapTet (SymbolSegment r moves) t)) tets)
          (ThirdMoves signs)
    end) Representatives.

(** ** The fill *)

Definition FillOf (materials : Quad (option Material))
  : list (Material * UnstructuredTet Symbol) :=
  MaterialFill Symbol
    (fun v => match v with CornerOf l => Of materials l | CutOf _ _ => None end)
    SymbolIntersection (CornerOf V1) (CornerOf V2) (CornerOf V3) (CornerOf V4).

(** The 11 patterns of three or four materials. *)
Definition ThreeOrFour : list (Quad (option Material)) :=
  [Q4 (Some 1) (Some 2) (Some 3) (Some 4);
   Q4 (Some 1) (Some 1) (Some 2) (Some 3); Q4 (Some 2) (Some 3) (Some 1) (Some 1);
   Q4 (Some 1) (Some 2) (Some 1) (Some 3); Q4 (Some 2) (Some 1) (Some 3) (Some 1);
   Q4 (Some 1) (Some 2) (Some 3) (Some 1); Q4 (Some 2) (Some 1) (Some 1) (Some 3);
   Q4 None (Some 1) (Some 2) (Some 3); Q4 (Some 1) None (Some 2) (Some 3);
   Q4 (Some 1) (Some 2) None (Some 3); Q4 (Some 1) (Some 2) (Some 3) None].

Definition MovesOfMaterial (m : option Material) : list (option Direction) :=
  match m with None => map Some AllDirections | Some _ => [None] end.

Definition FillMoves (materials : Quad (option Material))
  : list (Quad (option Direction)) :=
  match materials with
    Q4 a b c d =>
      Product4 (MovesOfMaterial a) (MovesOfMaterial b) (MovesOfMaterial c)
        (MovesOfMaterial d)
  end.

Definition FillConfigurations
  : list (Quad (option Material) * Quad (option Direction)) :=
  flat_map (fun materials => map (pair materials) (FillMoves materials)) ThreeOrFour.

Definition CheckFill (bounds : AngleBounds) (r : Ranges) : bool :=
  forallb (fun materials =>
    forallb (fun moves => forallb (fun t =>
      CheckTet bounds (MapTet (SymbolSegment r moves) (snd t)))
      (FillOf materials)) (FillMoves materials)) ThreeOrFour.

(** ** Counted *)

Definition CountThirdMoves : Z := Z.of_nat (length ThirdConfigurations).
Definition CountFill : Z := Z.of_nat (length FillConfigurations).
Definition CountFillAngles : Z :=
  Z.of_nat (length (flat_map (fun c => flat_map (fun t => DihedralEdges (snd t))
    (FillOf (fst c))) FillConfigurations)).
