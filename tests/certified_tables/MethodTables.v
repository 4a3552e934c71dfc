(** * The table of the methods *)

From Coq Require Import ZArith String List Bool.
From Certet Require Import Certificate.
From CertetTables Require Import Table TableRules EngineTables.
Import ListNotations.
Open Scope Z_scope.

(** ** The methods, and the bounds that every mesh is held to

    What a method is, where it warps and what it promises, in hundredths of degrees,
    is told by [Mesh/Method.v].  The engine has besides a name for it, a number for
    where it cuts edges and whether some violated vertices stay, and names the
    theorem on its angles. *)

Inductive Cuts := OnTheSurface | InTheMiddle.
Definition CutsNumber (c : Cuts) : Z := match c with OnTheSurface => 0 | InTheMiddle => 1 end.

Definition MethodCuts (m : Method) : Cuts :=
  match m with MidpointMethod => InTheMiddle | _ => OnTheSurface end.

Definition MethodSettles (m : Method) : bool :=
  match m with SettledMethod _ | KeyMethod _ => true | _ => false end.

(** Whether diagonals end at the lesser cut. *)
Definition MethodFollowsCuts (m : Method) : bool :=
  match m with KeyMethod _ => true | _ => false end.

Record NamedMethod := {
  called : string; cuts : Cuts; alpha : Thresholds; settles : bool;
  follows_cuts : bool;
  least : Z; greatest : Z; theorem : string
}.

Definition Named (name : string) (m : Method) (theorem_ : string) : NamedMethod :=
  {| called := name; cuts := MethodCuts m; alpha := MethodThresholds m;
     settles := MethodSettles m; follows_cuts := MethodFollowsCuts m;
     least := LeastAngle m; greatest := GreatestAngle m; theorem := theorem_ |}.

(** Whose turns come when makes no difference to what is told here. *)
Definition Methods : list NamedMethod :=
  [Named "embedded" (SettledMethod []) "SettledBoundsInDegrees";
   Named "angles" AngleMethod "DihedralBounds";
   Named "embedding" EmbeddingMethod "DihedralBoundsEmbedding";
   Named "midpoint" MidpointMethod "MidpointBounds";
   Named "key" (KeyMethod []) "CertifiedKeySweptMesh"]%string.

(** The number of 53 bits, written in full, that is nearest to so many hundredths. *)
Definition IsNearest (hundredths : Z) (t : Table) : bool :=
  match t with
  | Double m e =>
      (2 ^ 52 <=? m) && (m <? 2 ^ 53) && (e <=? 0) &&
      (2 * Z.abs (100 * m - hundredths * 2 ^ (- e)) <=? 100)
  | _ => false
  end.
(** A row has its number first, and what it promises last. *)
Definition IsMethod (numbered : Z * NamedMethod) (t : Table) : bool :=
  let (number, named) := numbered in
  match t with
  | Row [row; name; where_; within; rule; diagonals; Row [low; high; promise]] =>
      Equal (Number number) row && Equal (Text (called named)) name &&
      Equal (Number (CutsNumber (cuts named))) where_ &&
      Equal (ThresholdsEntry (alpha named)) within &&
      Equal (Truth (settles named)) rule &&
      Equal (Truth (follows_cuts named)) diagonals &&
      IsNearest (least named) low && IsNearest (greatest named) high &&
      Equal (Text (theorem named)) promise
  | _ => false
  end.
Definition AreMethods : Table -> bool :=
  Each IsMethod (combine (Upto (length Methods)) Methods).
