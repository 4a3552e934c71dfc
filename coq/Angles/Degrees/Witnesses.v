(** * Domains that come near the bounds

    Small domains, given by the signs of a few lattice vertices and the cuts of
    a few edges; all other vertices lie on the surface, where nothing happens,
    and all other cuts at their edges' middles. *)

From Certet Require Import Angles.Definitions.
Open Scope Z_scope.

Definition SignTable (table : list (Coord3 * Sign)) : SignField :=
  fun v =>
    match find (fun e => Coord3Equal (fst e) v) table with
    | Some e => snd e
    | None => OnSurface
    end.

Definition CutTable (table : list (Coord3 * Coord3 * Z)) : CutField :=
  fun a b =>
    match find (fun e => Coord3Equal (fst (fst e)) a
                         && Coord3Equal (snd (fst e)) b) table with
    | Some e => snd e
    | None => MidpointCut
    end.

Definition WitnessTet : StructuredTetId := STId (C3 0 0 0) Tet_I1.

(** Small angles: one corner is warped towards another. *)
Definition SmallAngleSigns : SignField :=
  SignTable [(C3 0 2 2, Plus); (C3 2 2 2, Minus);
             (C3 1 3 1, Plus); (C3 1 3 3, Minus)].

Definition SmallAngleCuts (warped long short : Z) : CutField :=
  CutTable [(C3 1 3 1, C3 2 2 2, Steps - warped);
            (C3 1 3 1, C3 1 3 3, long); (C3 0 2 2, C3 1 3 3, short)].

Definition SmallAngleCuts_73_102 := SmallAngleCuts 26111 46848 26112.
Definition SmallAngleCuts_64_105 := SmallAngleCuts 26879 49152 26880.

(** Large angles: three corners are warped, two of them to cuts of edges to [low]
    and [high]. *)
Definition LargeAngleSigns (low high : Coord3) : SignField :=
  SignTable [(C3 0 2 2, Plus); (C3 2 2 2, Plus); (C3 1 3 1, Plus); (C3 1 3 3, Plus);
             (C3 2 4 2, Minus); (low, Minus); (high, Minus)].

Definition LargeAngleTable (low high : Coord3) (middle aside : Z)
  : list (Coord3 * Coord3 * Z) :=
  [(C3 2 2 2, C3 2 4 2, middle); (C3 1 3 1, low, aside); (C3 1 3 3, high, aside)].

Definition LargeAngleTable_73_102 := LargeAngleTable (C3 1 1 1) (C3 1 1 3) 18687 18687.
Definition LargeAngleTable_64_105 := LargeAngleTable (C3 2 2 0) (C3 2 2 4) 16383 26879.

Definition LargeAngleSigns_73_102 := LargeAngleSigns (C3 1 1 1) (C3 1 1 3).
Definition LargeAngleSigns_64_105 := LargeAngleSigns (C3 2 2 0) (C3 2 2 4).

Definition LargeAngleCuts_73_102 : CutField := CutTable LargeAngleTable_73_102.
Definition LargeAngleCuts_64_105 : CutField := CutTable LargeAngleTable_64_105.

(** ** The same, known by the sign at every position *)

(** How many steps from [a] a position lies on the edge from [a] to [b], if it
    does. *)
Definition StepOnEdge (a b position : Coord3) : option Z :=
  let edge := Difference a b in
  let t := Dot (Difference (Scale Steps a) position) edge / Dot edge edge in
  if (0 <=? t) && (t <=? Steps) && Coord3Equal (PointOnEdge a b t) position
  then Some t else None.

(** Inside up to the cut and outside beyond, on the edges of a table; elsewhere
    on the surface, but for the lattice points of another. *)
Fixpoint DomainTable (points : list (Coord3 * Sign)) (cuts : list (Coord3 * Coord3 * Z))
  (position : Coord3) : Sign :=
  match cuts with
  | [] => SignTable (map (fun e => (Scale Steps (fst e), snd e)) points) position
  | (a, b, cut) :: rest =>
      match StepOnEdge a b position with
      | Some t => if t <=? cut then Plus else Minus
      | None => DomainTable points rest position
      end
  end.

Definition SmallAngleDomain (warped long short : Z) : PositionSigns :=
  DomainTable [] [(C3 1 3 1, C3 2 2 2, Steps - warped);
                  (C3 1 3 1, C3 1 3 3, long); (C3 0 2 2, C3 1 3 3, short)].

Definition LargeAngleDomain_73_102 : PositionSigns :=
  DomainTable [(C3 0 2 2, Plus)] LargeAngleTable_73_102.
Definition LargeAngleDomain_64_105 : PositionSigns :=
  DomainTable [(C3 0 2 2, Plus)] LargeAngleTable_64_105.

(** Both angles that cuts in the middle can make: an even edge inside, an odd
    edge outside. *)
Definition MidpointSigns : SignField :=
  SignTable [(C3 0 2 2, Plus); (C3 2 2 2, Plus); (C3 1 3 1, Minus); (C3 1 3 3, Minus)].

(** ** What they show *)

(** An acute angle whose cotangent's square is at least the fraction; an
    obtuse one likewise. *)
Definition Sharper (k : CotSquared) (e : Coord3 * Coord3 * Coord3 * Coord3)
  : bool :=
  match k, e with
    CotSq num den, (p, q, r, s) =>
      (0 <? NormalsProduct p q r s) &&
      (num * (SixVolume p q r s ^ 2 * EdgeSquared p q)
         <=? den * NormalsProduct p q r s ^ 2)
  end.

Definition Blunter (k : CotSquared) (e : Coord3 * Coord3 * Coord3 * Coord3)
  : bool :=
  match k, e with
    CotSq num den, (p, q, r, s) =>
      (NormalsProduct p q r s <? 0) &&
      (num * (SixVolume p q r s ^ 2 * EdgeSquared p q)
         <=? den * NormalsProduct p q r s ^ 2)
  end.

(** Some edge of some output tetrahedron passes the test. *)
Definition Exhibits (th : Thresholds) (sign : SignField) (cut : CutField)
  (test : Coord3 * Coord3 * Coord3 * Coord3 -> bool) : bool :=
  existsb (fun t => existsb test (DihedralEdges t))
    (StuffedTets th sign cut WitnessTet).
