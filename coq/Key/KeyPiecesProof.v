(** * With diagonals by key the mesh has the pieces of the samples: proof

    What is made within a structured tetrahedron is one piece in any order of the
    cuts, and both sides of a face agree. *)

From Certet Require Import Key.Definitions.
From Certet Require Import Stencil.Symbol Stencil.SymbolProof
  Stencil.CompatibilityChecker Stencil.TriangleChecker
  Stencil.TriangleCheckerProof Stuffing.NameProof Stuffing.MeshProof
  Embedding.EdgeRank Embedding.LeavingProof Embedding.AroundProof Embedding.WholeProof
  Key.Orders Key.OrderProof Key.KeyChecker Key.KeysApartProof Key.FaceRuleProof
  Key.KeyFollowsProof Key.KeyMeshProof
  Mesh.Method.
Open Scope Z_scope.

Lemma OrdersWhole : InEveryOrder CheckWhole.
Proof. vm_cast_no_check (eq_refl true). Qed.

Section Mesh.
  Variables (before : SignField) (warping : Coord3 -> Warping) (cut : CutField).
  Let key := CutKey cut.
  Let mesh := KeyMesh before warping cut.

  (** ** Symbols *)

  Lemma NamedWhole tid : exists h f1 f2 f3 p q,
    let sign := NamedSign f1 f2 f3 p before warping in
    let ts := NamedRanked f1 f2 f3 p q key before warping in
    NoDup [f1; f2; f3; p; q] /\ VerticesAre f1 f2 f3 p q tid F1 F2 F3 P /\
    TetsWithin mesh tid = map (fun s => Orient h (MapTet (Name f1 f2 f3 p q) s)) ts /\
    CheckWhole sign ts = true /\
    (forall l, In l [F1; F2; F3; P] ->
       PlacedSign before warping (Corner (LocateFive f1 f2 f3 p q l)) = sign l).
  Proof.
    destruct (OrderedViewed key before warping tid (CutKeysApart cut tid))
      as (h & f1 & f2 & f3 & p & q & D & V & C & N).
    exists h, f1, f2, f3, p, q. cbv zeta. repeat (split; [assumption|]).
    split;
      [|intros l L; symmetry; exact (NamedSignCorner f1 f2 f3 p q before warping l L)].
    exact (RankedChecked CheckWhole f1 f2 f3 p q key before warping OrdersWhole).
  Qed.

  (** ** The mesh *)

  Theorem KeyJoinsWithin :
    JoinsWithin (TetsWithin mesh) (fun c => SignIn mesh (Corner c)).
  Proof.
    constructor.
    - intros tid t v _ I.
      exact (proj1 (OrderedFollows key before warping tid (CutKeysApart cut tid) t I) v).
    - intros tid t c _ I.
      exact (OrderedReaches key before warping tid (CutKeysApart cut tid) t I c).
    - intros tid t _ I.
      destruct (OrderedInside key before warping tid (CutKeysApart cut tid) t I)
        as [(v & V & plus) _].
      pose proof (proj1 (OrderedFollows key before warping tid (CutKeysApart cut tid) t I)
        v V) as B.
      destruct v as [c|a m]; [|discriminate plus]. exists c. destruct B. auto.
    - intros tid t u E.
      destruct (NamedWhole tid) as (h & f1 & f2 & f3 & p & q & D & _ & N & C & _).
      exact (CheckedJoined _ tid h f1 f2 f3 p q _ _ D N C E t u).
    - intros tid i f.
      destruct (NamedWhole tid) as (h & f1 & f2 & f3 & p & q & D & V & N & C & S).
      exact (CheckedFace _ _ tid h f1 f2 f3 p q _ _ D N C i f V S).
    - intros tid i f I A a b c Fa Fb Fc.
      apply (KeyFacesAgree before warping cut tid i (ex_intro _ f (conj I A)) a b c Fa Fb Fc).
  Qed.
End Mesh.
