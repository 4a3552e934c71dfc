(** * The corners of a structured tetrahedron *)

From Certet Require Import Embedding.Definitions.
From Certet Require Import Embedding.MeshApartProof Topology.CliqueProof.

Lemma FourApart {A} (a b c d : A) : NoDup [a; b; c; d] <->
  a <> b /\ a <> c /\ a <> d /\ b <> c /\ b <> d /\ c <> d.
Proof.
  split.
  - intros N. rewrite !NoDup_cons_iff in N. cbn [In] in N.
    destruct N as (Na & Nb & Nc & _).
    repeat split; intros ->; tauto.
  - intros (Ab & Ac & Ad & Bc & Bd & Cd). repeat constructor; cbn [In];
      intros K; repeat (destruct K as [K|K]; [congruence|]); exact K.
Qed.

Lemma ThreeApart {A} (a b c : A) : NoDup [a; b; c] <-> a <> b /\ a <> c /\ b <> c.
Proof.
  split.
  - intros N. rewrite !NoDup_cons_iff in N. cbn [In] in N. destruct N as (Na & Nb & _).
    repeat split; intros ->; tauto.
  - intros (Ab & Ac & Bc). repeat constructor; cbn [In];
      intros K; repeat (destruct K as [K|K]; [congruence|]); exact K.
Qed.

Lemma OtherTwo tid a b : In a (Corners tid) -> In b (Corners tid) -> a <> b ->
  exists e f, NoDup [a; b; e; f] /\ In e (Corners tid) /\ In f (Corners tid).
Proof.
  intros A B N. pose proof (CornersNoDup tid) as D. unfold Corners in *.
  destruct (GetStructuredTet tid) as [v1 v2 v3 v4]. apply FourApart in D.
  cbn [In] in A, B |- *.
  assert (G : forall x y, In x [v1; v2; v3; v4] -> In y [v1; v2; v3; v4] ->
    a <> x -> a <> y -> b <> x -> b <> y -> x <> y ->
    exists e f, NoDup [a; b; e; f] /\
      (v1 = e \/ v2 = e \/ v3 = e \/ v4 = e \/ False) /\
      (v1 = f \/ v2 = f \/ v3 = f \/ v4 = f \/ False)).
  { intros x y X Y Ax Ay Bx By Xy. exists x, y. split; [|split; assumption].
    apply FourApart. auto 8. }
  clear -A B N D G. destruct D as (D12 & D13 & D14 & D23 & D24 & D34).
  destruct A as [<-|[<-|[<-|[<-|[]]]]], B as [<-|[<-|[<-|[<-|[]]]]];
    first [congruence
      |apply (G v1 v2); cbn [In]; auto; congruence
      |apply (G v1 v3); cbn [In]; auto; congruence
      |apply (G v1 v4); cbn [In]; auto; congruence
      |apply (G v2 v3); cbn [In]; auto; congruence
      |apply (G v2 v4); cbn [In]; auto; congruence
      |apply (G v3 v4); cbn [In]; auto; congruence].
Qed.

Lemma OtherOne tid a b c : In a (Corners tid) -> In b (Corners tid) ->
  In c (Corners tid) -> NoDup [a; b; c] ->
  exists e, NoDup [a; b; c; e] /\ In e (Corners tid).
Proof.
  intros A B C N. apply ThreeApart in N. destruct N as (Ab & Ac & Bc).
  destruct (OtherTwo tid a b A B Ab) as (e & f & D & E & F).
  assert (I : incl (Corners tid) [a; b; e; f]).
  { apply CornersAre; [exact D|reflexivity|].
    intros x. cbn [In]. intros [<-|[<-|[<-|[<-|[]]]]]; assumption. }
  apply FourApart in D. destruct D as (_ & Ae & Af & Be & Bf & Ef).
  destruct (I c C) as [<-|[<-|[<-|[<-|[]]]]];
    [congruence|congruence|exists f|exists e]; (split; [apply FourApart|assumption]);
    auto 8.
Qed.
