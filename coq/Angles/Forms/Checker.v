(** * A checker of tetrahedra whose vertices slide on segments

    Each vertex of a tetrahedron is fixed or slides, independently of the
    others, from one point to another.  [CheckTet] answers whether the
    tetrahedron stays right-handed and its six dihedral angles within bounds.
    Cheap ranges of the numerator and denominator of the cotangent decide most
    angles; for the others the inequality is expanded in full, and where that
    fails one segment is halved.  Conditionals stand where one expects [&&]
    and [||], because those compute both sides. *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Angles.Forms.BoxForm.
Open Scope Z_scope.

Inductive Segment :=
| Fixed : Coord3 -> Segment
| Sliding : Coord3 -> Coord3 -> Segment.

(** ** From functions of points to forms *)

(** A function either ignores a vertex or is affine in it. *)
Definition Degree (used : bool) (s : Segment) : nat :=
  match used, s with true, Sliding _ _ => 1 | _, _ => 0 end.

Definition Ends {T} (used : bool) (s : Segment) (f : Coord3 -> T)
  : Form T (Degree used s) :=
  match used, s return Form T (Degree used s) with
  | true, Fixed p => f p
  | true, Sliding p q => (f p, f q)
  | false, Fixed p => f p
  | false, Sliding p _ => f p
  end.

(** Which of the four vertices a function uses. *)
Inductive Uses := Use : bool -> bool -> bool -> bool -> Uses.

Definition Degrees (m : Uses) (a b c d : Segment) : list nat :=
  match m with
    Use ma mb mc md => [Degree ma a; Degree mb b; Degree mc c; Degree md d]
  end.

Definition Table (m : Uses) (a b c d : Segment)
  (f : Coord3 -> Coord3 -> Coord3 -> Coord3 -> Z)
  : BoxForm (Degrees m a b c d) :=
  match m return BoxForm (Degrees m a b c d) with
    Use ma mb mc md =>
      Ends ma a (fun p => Ends mb b (fun q => Ends mc c (fun r =>
        Ends md d (fun s => f p q r s))))
  end.

(** ** The quantities of one edge *)

Definition X (v : Coord3) : Z := match v with C3 x _ _ => x end.
Definition Y (v : Coord3) : Z := match v with C3 _ y _ => y end.
Definition W (v : Coord3) : Z := match v with C3 _ _ z => z end.

Definition OfVolume := Use true true true true.
Definition OfFaceC := Use true true true false.
Definition OfFaceD := Use true true false true.
Definition OfEdge := Use true true false false.

Section Edge.
  Variables a b c d : Segment.

  Definition VolumeForm := Table OfVolume a b c d SixVolume.

  (** The sum over the three coordinates of the products of two forms. *)
  Definition DotForm (m n : Uses)
    (f g : Coord3 -> Coord3 -> Coord3 -> Coord3 -> Coord3) :=
    let product (k : Coord3 -> Z) :=
      BoxMul (Degrees m a b c d) (Degrees n a b c d)
        (Table m a b c d (fun p q r s => k (f p q r s)))
        (Table n a b c d (fun p q r s => k (g p q r s))) in
    let ds := SumDegrees (Degrees m a b c d) (Degrees n a b c d) in
    BoxAdd ds (product X) (BoxAdd ds (product Y) (product W)).

  Definition NormalsForm :=
    DotForm OfFaceC OfFaceD
      (fun p q r _ => Normal p q r) (fun p q _ s => Normal p q s).
  Definition NormalsDegrees :=
    SumDegrees (Degrees OfFaceC a b c d) (Degrees OfFaceD a b c d).

  Definition EdgeForm :=
    DotForm OfEdge OfEdge
      (fun p q _ _ => Difference p q) (fun p q _ _ => Difference p q).
  Definition EdgeDegrees :=
    SumDegrees (Degrees OfEdge a b c d) (Degrees OfEdge a b c d).

  Definition VolumeDegrees := Degrees OfVolume a b c d.
End Edge.

(** ** The check of one edge *)

(** den normals^2 <= num volume^2 edge^2, expanded. *)
Definition CheckFull (k : CotSquared) (a b c d : Segment) : bool :=
  let nd := NormalsDegrees a b c d in
  let n := NormalsForm a b c d in
  let vd := VolumeDegrees a b c d in
  let v := VolumeForm a b c d in
  match k with
    CotSq num den =>
      AtMost den num (SumDegrees nd nd)
        (SumDegrees (SumDegrees vd vd) (EdgeDegrees a b c d))
        (BoxMul nd nd n n)
        (BoxMul (SumDegrees vd vd) (EdgeDegrees a b c d)
           (BoxMul vd vd v v) (EdgeForm a b c d))
  end.

(** The two halves of a segment, in a space scaled twice. *)
Definition Doubled (s : Segment) : Segment :=
  match s with
  | Fixed p => Fixed (Scale 2 p)
  | Sliding p q => Sliding (Scale 2 p) (Scale 2 q)
  end.

Definition FirstHalf (s : Segment) : Segment :=
  match s with
  | Fixed p => Fixed (Scale 2 p)
  | Sliding p q => Sliding (Scale 2 p) (Translate p q)
  end.

Definition SecondHalf (s : Segment) : Segment :=
  match s with
  | Fixed p => Fixed (Scale 2 p)
  | Sliding p q => Sliding (Translate p q) (Scale 2 q)
  end.

Definition CheckHalves (k : CotSquared) (a b c d : Segment) : bool :=
  let a2 := Doubled a in let b2 := Doubled b in
  let c2 := Doubled c in let d2 := Doubled d in
  if (if CheckFull k (FirstHalf a) b2 c2 d2
      then CheckFull k (SecondHalf a) b2 c2 d2 else false) then true
  else if (if CheckFull k a2 (FirstHalf b) c2 d2
      then CheckFull k a2 (SecondHalf b) c2 d2 else false) then true
  else if (if CheckFull k a2 b2 (FirstHalf c) d2
      then CheckFull k a2 b2 (SecondHalf c) d2 else false) then true
  else if CheckFull k a2 b2 c2 (FirstHalf d)
      then CheckFull k a2 b2 c2 (SecondHalf d) else false.

(** [volume]: the least six volumes; [extreme]: a bound of the normals' product
    on the side that matters; [edge]: the least edge squared. *)
Definition CheckRanges (k : CotSquared) (volume extreme edge : Z) : bool :=
  match k with
    CotSq num den =>
      if 0 <=? edge
      then den * (extreme * extreme) <=? num * ((volume * volume) * edge)
      else false
  end.

(** From the cheapest to the dearest. *)
Definition CheckBound (k : CotSquared) (volume extreme edge : Z)
  (a b c d : Segment) : bool :=
  if CheckRanges k volume extreme edge then true
  else if CheckFull k a b c d then true
  else CheckHalves k a b c d.

Definition CheckEdge (bounds : AngleBounds) (volume : Z)
  (a b c d : Segment) : bool :=
  match bounds with
    AB acute obtuse =>
      let nd := NormalsDegrees a b c d in
      let n := NormalsForm a b c d in
      let most := Upper nd n in
      let least := Lower nd n in
      let edge := Lower (EdgeDegrees a b c d) (EdgeForm a b c d) in
      if (if most <=? 0 then true
          else CheckBound acute volume most edge a b c d)
      then (if 0 <=? least then true
            else CheckBound obtuse volume least edge a b c d)
      else false
  end.

Definition CheckTet (bounds : AngleBounds) (t : UnstructuredTet Segment)
  : bool :=
  match t with
    UT _ a b c d =>
      let volume := Lower (VolumeDegrees a b c d) (VolumeForm a b c d) in
      if 0 <? volume
      then forallb (fun '(p, q, r, s) => CheckEdge bounds volume p q r s)
             (DihedralEdges t)
      else false
  end.
