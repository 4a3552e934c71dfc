(** * What the tiling by C15 must be *)

From Certet Require Import Angles.Definitions.
From Certet Require Import Lattice.Tiling C15.Sites C15.C15Tet.
Open Scope Z_scope.

(** Six volumes of one case. *)
Definition C15SixVolume (case : C15Case) : Z :=
  let at_ := C15Corner case in
  SixVolume (at_ First) (at_ Second) (at_ Third) (at_ Fourth).

(** Those of the tetrahedra of a primitive cell, together. *)
Definition C15SixVolumes : Z :=
  fold_right (fun case sum => C15SixVolume case + sum) 0 AllC15Cases.

(** Six times the volume of a primitive cell. *)
Definition CellSixVolume : Z :=
  6 * SixVolume (CellPosition (C3 0 0 0)) (CellPosition (C3 1 0 0))
        (CellPosition (C3 0 1 0)) (CellPosition (C3 0 0 1)).

(** A point is a vertex of the lattice if it is that of a site in some cell. *)
Definition IsC15Vertex (p : Coord3) : Prop :=
  exists cell, p = Translate (CellPosition cell) (SitePosition (SiteOf p)).

(** Two vertices with an edge between them. *)
Definition C15Edge (a b : Coord3) : Prop := In (Difference a b) (OffsetsAround a).
