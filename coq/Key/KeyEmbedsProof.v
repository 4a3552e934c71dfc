(** * The mesh with diagonals by key embeds: proof

    In any order of the cuts a structured tetrahedron is filled in one way, and
    at 1/4 of a long edge the lattice embeds whoever is warped. *)

From Certet Require Import Key.Definitions.
From Certet Require Import Angles.Cases.AdmissibleProof Angles.AngleTheorems
  Embedding.EdgeRank Embedding.GreedyProof Embedding.WarpedLatticeProof
  Embedding.MeshEmbedsProof Embedding.MeshApartProof Embedding.WarpOrClampProof
  Key.KeysApartProof Key.KeyFollowsProof Key.KeyBoundsProof.
Open Scope Z_scope.

Section Placed.
  Variables (key : Coord3 -> Coord3 -> Z) (before : SignField).
  Variables (warping : Coord3 -> Warping) (cut : CutField).
  Variables tid tid' : StructuredTetId.
  Variables t t' : UnstructuredTet MeshVertex.
  Hypothesis Even : InLattice tid.
  Hypothesis Even' : InLattice tid'.
  Hypothesis apart : KeysApart key (Corners tid).
  Hypothesis apart' : KeysApart key (Corners tid').
  Hypothesis here : In t (OrderedNames key before warping tid).
  Hypothesis there : In t' (OrderedNames key before warping tid').

  Theorem OrderedMeshEmbeds :
    CutsInside before warping cut ->
    KeepsShortEdges (fun c => WarpedPosition c (warping c)) ->
    MeetInSharedVertices (PlacedPosition warping cut) t t'.
  Proof.
    intros inside keeps.
    apply (StraightOrderEmbeds before warping cut (PlacedPosition warping cut) inside)
      with (key := key) (tid := tid) (tid' := tid'); try assumption.
    - intros a m f F A M. apply (ShareOfCut before); assumption.
    - exact (OrderedFollows key before warping tid apart t here).
    - exact (OrderedFollows key before warping tid' apart' t' there).
  Qed.

  Theorem OrderedInteriorsApart place :
    MeetInSharedVertices place t t' ->
    Overlap (MapTet place t) (MapTet place t') -> tid = tid' /\ t = t'.
  Proof.
    apply (ApartByCorners (fun c => PlacedSign before warping (Corner c)));
      try assumption.
    - exact (OrderedReaches key before warping tid apart t here).
    - exact (proj1 (OrderedFollows key before warping tid' apart' t' there)).
    - intros same. destruct same. exact (OrderedKnown key before warping tid apart t t' here there).
  Qed.
End Placed.

(** ** The paper's warp *)

Section Warped.
  Variables (long short : Z) (sign : SignField) (cut : CutField).
  Variables tid tid' : StructuredTetId.
  Variables t t' : UnstructuredTet MeshVertex.
  Let th := TH long short.
  Hypothesis Long : 0 < long <= 64.
  Hypothesis Short : 0 < short <= 128.
  Hypothesis OnEdges : CutsOnEdges sign cut.
  Hypothesis Even : InLattice tid.
  Hypothesis Even' : InLattice tid'.
  Hypothesis here : In t (KeyStuffTet th sign cut tid).
  Hypothesis there : In t' (KeyStuffTet th sign cut tid').

  Theorem KeyMeshEmbeds : MeetInSharedVertices (MeshPosition th sign cut) t t'.
  Proof.
    apply (OrderedMeshEmbeds (CutKey cut) sign (WarpVertex th sign cut) cut tid tid' t t'
      Even Even' (CutKeysApart cut tid) (CutKeysApart cut tid') here there);
      apply LittleWarpFits; assumption.
  Qed.

  Theorem KeyInteriorsApart :
    Overlap (MapTet (MeshPosition th sign cut) t)
            (MapTet (MeshPosition th sign cut) t') ->
    tid = tid' /\ t = t'.
  Proof.
    apply (OrderedInteriorsApart (CutKey cut) sign (WarpVertex th sign cut) tid tid' t t'
      Even Even' (CutKeysApart cut tid) (CutKeysApart cut tid') here there).
    exact KeyMeshEmbeds.
  Qed.
End Warped.

(** ** Any rule of who stays *)

Section Ruled.
  Variables (sign : SignField) (cut : CutField).
  Variables (stays : Coord3 -> bool) (limit : Coord3 -> Z).
  Hypothesis OnEdges : CutsOnEdges sign cut.

  Let warping := RuledWarping KeyThresholds sign cut stays limit.
  Let clamped := ClampedCut KeyThresholds cut.

  (** Nobody moves by half a unit. *)
  Lemma RuledKeepsShortEdges : KeepsShortEdges (fun c => WarpedPosition c (warping c)).
  Proof.
    apply (LittleMoves warping). intros v d t E.
    destruct (RuledMeans KeyThresholds sign cut stays limit OnEdges v d t E) as (s & W & L).
    destruct (WarpedMeans KeyThresholds sign cut v d s W) as (_ & _ & B).
    unfold KeyThresholds, ThresholdSteps in B. change (Steps / 256) with 256 in B.
    change Steps with 65536. destruct (DirectionKind d); lia.
  Qed.

  Lemma KeyRuledInside : CutsInside sign warping clamped.
  Proof.
    apply ClampedInside; [exact KeyThresholdsAtMostHalf|]. intros []; reflexivity.
  Qed.

  Theorem KeyRuledMeshEmbeds tid tid' t t' :
    InLattice tid -> InLattice tid' ->
    In t (KeyNames sign warping clamped tid) ->
    In t' (KeyNames sign warping clamped tid') ->
    MeetInSharedVertices (PlacedPosition warping clamped) t t'.
  Proof.
    intros E E' I I'.
    exact (OrderedMeshEmbeds (CutKey clamped) sign warping clamped tid tid' t t' E E'
      (CutKeysApart clamped tid) (CutKeysApart clamped tid') I I' KeyRuledInside
      RuledKeepsShortEdges).
  Qed.

  Theorem KeyRuledInteriorsApart tid tid' t t' :
    InLattice tid -> InLattice tid' ->
    In t (KeyNames sign warping clamped tid) ->
    In t' (KeyNames sign warping clamped tid') ->
    Overlap (MapTet (PlacedPosition warping clamped) t)
            (MapTet (PlacedPosition warping clamped) t') ->
    tid = tid' /\ t = t'.
  Proof.
    intros E E' I I'.
    apply (OrderedInteriorsApart (CutKey clamped) sign warping tid tid' t t' E E'
      (CutKeysApart clamped tid) (CutKeysApart clamped tid') I I').
    exact (KeyRuledMeshEmbeds tid tid' t t' E E' I I').
  Qed.
End Ruled.
