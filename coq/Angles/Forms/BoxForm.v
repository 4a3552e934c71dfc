(** * Homogeneous forms over a box, by their Bernstein coefficients

    A parameter that runs from one end of its range to the other is two
    weights [w, u >= 0], not both zero: its share of the first end and of the
    second.  A form of degree d in [w, u] has d + 1 coefficients, of
    w^d, w^(d-1) u, ..., u^d; up to binomial factors they are its Bernstein
    coefficients, and if none of them is negative then neither is the form.
    A box form is a form in the first parameter whose coefficients are forms in
    the second, and so on: homogeneous in each, as a tensor product of Bernstein
    bases.  Its type gives the degree in each. *)

From Coq Require Import ZArith List.
Import ListNotations.
Open Scope Z_scope.

Fixpoint Form (T : Type) (d : nat) : Type :=
  match d with
  | O => T
  | S d' => (T * Form T d')%type
  end.

Fixpoint BoxForm (ds : list nat) : Type :=
  match ds with
  | [] => Z
  | d :: ds' => Form (BoxForm ds') d
  end.

(** ** Forms *)

Fixpoint FormMap {A B} (f : A -> B) (d : nat) : Form A d -> Form B d :=
  match d with
  | O => f
  | S d' => fun p => (f (fst p), FormMap f d' (snd p))
  end.

Fixpoint FormAdd {A} (add : A -> A -> A) (d : nat)
  : Form A d -> Form A d -> Form A d :=
  match d with
  | O => add
  | S d' => fun p q => (add (fst p) (fst q), FormAdd add d' (snd p) (snd q))
  end.

(** [FormAddLow] adds w^(d-k) p to q, for p of degree [k <= d]. *)
Fixpoint FormAddLow {A} (add : A -> A -> A) (k d : nat)
  : Form A k -> Form A d -> Form A d :=
  match k, d with
  | O, O => add
  | O, S _ => fun p q => (add p (fst q), snd q)
  | S _, O => fun _ q => q
  | S k', S d' => fun p q =>
      (add (fst p) (fst q), FormAddLow add k' d' (snd p) (snd q))
  end.

Fixpoint FormMul {A B C} (mul : A -> B -> C) (add : C -> C -> C) (j k : nat)
  : Form A j -> Form B k -> Form C (j + k) :=
  match j with
  | O => fun p q => FormMap (mul p) k q
  | S j' => fun p q =>
      let rest := FormMul mul add j' k (snd p) q in
      match k return Form B k -> Form C (j' + k) -> Form C (S (j' + k)) with
      | O => fun q r => (mul (fst p) q, r)
      | S k' => fun q r =>
          (mul (fst p) (fst q),
           FormAddLow add k' (j' + S k') (FormMap (mul (fst p)) k' (snd q)) r)
      end q rest
  end.

(** The greatest coefficient once divided by its binomial factor.  Degrees 0
    and 1 have none but 1; degree 2 has 1, 2, 1; of the rest no use is made,
    and 0 stands in. *)
Definition HalfUp (z : Z) : Z := (z + 1) / 2.

Fixpoint FormMax {A} (f : A -> Z) (d : nat) : Form A d -> Z :=
  match d with
  | O => f
  | S d' => fun p => Z.max (f (fst p)) (FormMax f d' (snd p))
  end.

Definition FormUpper {A} (f : A -> Z) (d : nat) : Form A d -> Z :=
  match d with
  | O => f
  | 1%nat => fun p => Z.max (f (fst p)) (f (snd p))
  | 2%nat => fun p =>
      Z.max (f (fst p))
        (Z.max (HalfUp (f (fst (snd p)))) (f (snd (snd p))))
  | S d' => fun p => Z.max 0 (FormMax f (S d') p)
  end.

Fixpoint FormAtMost {A B} (ok : A -> B -> bool) (d e : nat)
  : Form A d -> Form B e -> bool :=
  match d, e with
  | O, O => ok
  | S d', S e' => fun p q =>
      if ok (fst p) (fst q) then FormAtMost ok d' e' (snd p) (snd q) else false
  | _, _ => fun _ _ => false
  end.

(** ** Box forms *)

Fixpoint BoxOpp (ds : list nat) : BoxForm ds -> BoxForm ds :=
  match ds with
  | [] => Z.opp
  | d :: ds' => FormMap (BoxOpp ds') d
  end.

Fixpoint BoxAdd (ds : list nat) : BoxForm ds -> BoxForm ds -> BoxForm ds :=
  match ds with
  | [] => Z.add
  | d :: ds' => FormAdd (BoxAdd ds') d
  end.

Fixpoint SumDegrees (ds es : list nat) : list nat :=
  match ds, es with
  | d :: ds', e :: es' => (d + e)%nat :: SumDegrees ds' es'
  | _, _ => []
  end.

Fixpoint BoxMul (ds es : list nat)
  : BoxForm ds -> BoxForm es -> BoxForm (SumDegrees ds es) :=
  match ds, es with
  | [], [] => Z.mul
  | d :: ds', e :: es' =>
      FormMul (BoxMul ds' es') (BoxAdd (SumDegrees ds' es')) d e
  | _, _ => fun _ _ => 0
  end.

(** A number that the form does not exceed when every pair of weights has
    sum 1. *)
Fixpoint Upper (ds : list nat) : BoxForm ds -> Z :=
  match ds with
  | [] => fun z => z
  | d :: ds' => FormUpper (Upper ds') d
  end.

Definition Lower (ds : list nat) (t : BoxForm ds) : Z :=
  - Upper ds (BoxOpp ds t).

(** Coefficient by coefficient, m times the first is at most n times the
    second; false if their degrees differ. *)
Fixpoint AtMost (m n : Z) (ds es : list nat)
  : BoxForm ds -> BoxForm es -> bool :=
  match ds, es with
  | [], [] => fun x y => m * x <=? n * y
  | d :: ds', e :: es' => FormAtMost (AtMost m n ds' es') d e
  | _, _ => fun _ _ => false
  end.

(** ** Their meaning *)

Fixpoint FormValue {A} (value : A -> Z) (w u : Z) (d : nat) : Form A d -> Z :=
  match d with
  | O => value
  | S d' => fun p =>
      w ^ Z.of_nat d * value (fst p) + u * FormValue value w u d' (snd p)
  end.

Fixpoint Value (ds : list nat) (weights : list (Z * Z)) : BoxForm ds -> Z :=
  match ds, weights with
  | [], _ => fun z => z
  | d :: ds', (w, u) :: weights' => FormValue (Value ds' weights') w u d
  | _ :: _, [] => fun _ => 0
  end.

(** The product of the sums of the weights, each to its degree: what a form
    that is 1 everywhere amounts to. *)
Fixpoint Mass (ds : list nat) (weights : list (Z * Z)) : Z :=
  match ds, weights with
  | d :: ds', (w, u) :: weights' => (w + u) ^ Z.of_nat d * Mass ds' weights'
  | _, _ => 1
  end.
