(** * Domains that come near the bounds

    Four small domains, given by the signs of a few lattice vertices and the
    cuts of a few edges; all other vertices lie on the surface, where nothing
    happens, and all other cuts at their edges' middles. *)

From Coq Require Import ZArith List Bool.
From Certet Require Import Lattice.Coord3 Lattice.StructuredTet.
From Certet Require Import Stencil.UnstructuredTet.
From Certet Require Import Warp.Cut Warp.Warp Stuffing.Stuffing.
From Certet Require Import Angles.Geometry Angles.AnglesSpec.
Import ListNotations.
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

(** Large angles: three corners are warped. *)
Definition LargeAngleSigns_73_102 : SignField :=
  SignTable [(C3 0 2 2, Plus); (C3 2 2 2, Plus); (C3 1 3 1, Plus);
             (C3 1 3 3, Plus); (C3 2 4 2, Minus); (C3 1 1 1, Minus);
             (C3 1 1 3, Minus)].

Definition LargeAngleCuts_73_102 : CutField :=
  CutTable [(C3 2 2 2, C3 2 4 2, 18687); (C3 1 3 1, C3 1 1 1, 18687);
            (C3 1 3 3, C3 1 1 3, 18687)].

Definition LargeAngleSigns_64_105 : SignField :=
  SignTable [(C3 0 2 2, Plus); (C3 2 2 2, Plus); (C3 1 3 1, Plus);
             (C3 1 3 3, Plus); (C3 2 4 2, Minus); (C3 2 2 0, Minus);
             (C3 2 2 4, Minus)].

Definition LargeAngleCuts_64_105 : CutField :=
  CutTable [(C3 2 2 2, C3 2 4 2, 16383); (C3 1 3 1, C3 2 2 0, 26879);
            (C3 1 3 3, C3 2 2 4, 26879)].

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
