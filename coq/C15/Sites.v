(** * The lattice C15: vertices and edges

    The Laves phase MgCu2, a cubic crystal.  Its cell has an edge of 8; a primitive
    cell has six vertices, two of magnesium and four of copper, whose places in it
    are the six sites.  Vertices of magnesium have even coordinates, those of copper
    odd ones, and what a vertex's site is can be read off its coordinates modulo 4.

    Two of magnesium are joined at a distance of sqrt 12, one of each at sqrt 11,
    and two of copper at sqrt 8: sixteen edges at a vertex of magnesium, twelve at
    one of copper. *)

From Coq Require Import ZArith List.
From Certet Require Import Lattice.Coord3.
Import ListNotations.
Open Scope Z_scope.

Inductive Metal := Mg | Cu.

(** By the coordinates that a vertex of the site has in the first cell. *)
Inductive Site := Mg000 | Mg222 | Cu555 | Cu577 | Cu757 | Cu775.

Definition AllSites : list Site := [Mg000; Mg222; Cu555; Cu577; Cu757; Cu775].

Definition SiteMetal (s : Site) : Metal :=
  match s with Mg000 | Mg222 => Mg | _ => Cu end.

Definition SitePosition (s : Site) : Coord3 :=
  match s with
  | Mg000 => C3 0 0 0 | Mg222 => C3 2 2 2
  | Cu555 => C3 5 5 5 | Cu577 => C3 5 7 7 | Cu757 => C3 7 5 7 | Cu775 => C3 7 7 5
  end.

(** Where the primitive cell [i j k] begins. *)
Definition CellPosition (c : Coord3) : Coord3 :=
  match c with C3 i j k => C3 (4 * (j + k)) (4 * (i + k)) (4 * (i + j)) end.

(** The site of a vertex. *)
Definition SiteOf (p : Coord3) : Site :=
  match p with
    C3 x y _ =>
      match x mod 4, y mod 4 with
      | 0, _ => Mg000 | 2, _ => Mg222
      | 1, 1 => Cu555 | 1, _ => Cu577
      | _, 1 => Cu757 | _, _ => Cu775
      end
  end.

Definition MetalOf (p : Coord3) : Metal := SiteMetal (SiteOf p).

(** The square of an edge's length. *)
Definition JoinedSquared (a b : Metal) : Z :=
  match a, b with
  | Mg, Mg => 12 | Mg, Cu | Cu, Mg => 11 | Cu, Cu => 8
  end.

(** Where the edges of a vertex lead to, from it. *)
Definition SiteOffsets (s : Site) : list Coord3 :=
  match s with
  | Mg000 =>
      [C3 (-2) (-2) 2; C3 (-2) 2 (-2); C3 2 (-2) (-2); C3 2 2 2; C3 (-3) (-1) (-1);
       C3 (-3) 1 1; C3 (-1) (-3) (-1); C3 (-1) (-1) (-3); C3 (-1) 1 3; C3 (-1) 3 1;
       C3 1 (-3) 1; C3 1 (-1) 3; C3 1 1 (-3); C3 1 3 (-1); C3 3 (-1) 1; C3 3 1 (-1)]
  | Mg222 =>
      [C3 (-2) (-2) (-2); C3 (-2) 2 2; C3 2 (-2) 2; C3 2 2 (-2); C3 (-3) (-1) 1;
       C3 (-3) 1 (-1); C3 (-1) (-3) 1; C3 (-1) (-1) 3; C3 (-1) 1 (-3); C3 (-1) 3 (-1);
       C3 1 (-3) (-1); C3 1 (-1) (-3); C3 1 1 3; C3 1 3 1; C3 3 (-1) (-1); C3 3 1 1]
  | Cu555 =>
      [C3 (-3) 1 1; C3 (-1) (-1) 3; C3 (-1) 3 (-1); C3 1 (-3) 1; C3 1 1 (-3);
       C3 3 (-1) (-1); C3 (-2) (-2) 0; C3 (-2) 0 (-2); C3 0 (-2) (-2); C3 0 2 2;
       C3 2 0 2; C3 2 2 0]
  | Cu577 =>
      [C3 (-3) (-1) (-1); C3 (-1) (-3) 1; C3 (-1) 1 (-3); C3 1 (-1) 3; C3 1 3 (-1);
       C3 3 1 1; C3 (-2) 0 2; C3 (-2) 2 0; C3 0 (-2) (-2); C3 0 2 2; C3 2 (-2) 0;
       C3 2 0 (-2)]
  | Cu757 =>
      [C3 (-3) (-1) 1; C3 (-1) (-3) (-1); C3 (-1) 1 3; C3 1 (-1) (-3); C3 1 3 1;
       C3 3 1 (-1); C3 (-2) 0 (-2); C3 (-2) 2 0; C3 0 (-2) 2; C3 0 2 (-2); C3 2 (-2) 0;
       C3 2 0 2]
  | Cu775 =>
      [C3 (-3) 1 (-1); C3 (-1) (-1) (-3); C3 (-1) 3 1; C3 1 (-3) (-1); C3 1 1 3;
       C3 3 (-1) 1; C3 (-2) (-2) 0; C3 (-2) 0 2; C3 0 (-2) 2; C3 0 2 (-2); C3 2 0 (-2);
       C3 2 2 0]
  end.

Definition OffsetsAround (p : Coord3) : list Coord3 := SiteOffsets (SiteOf p).
