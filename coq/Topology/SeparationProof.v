(** * On a sphere, what parts two pieces is in one piece

    If the + vertices of a link are in one piece, and the others too, then so are
    the edges from one to the other, going from one to the next by a common
    triangle.  Suppose a part of these edges is closed under such steps.  A
    triangle has none or two edges of it; so it is where some function of the
    vertices changes, because the link has no holes; and that function is the same
    all over + and all over the rest. *)

From Coq Require Import Arith.
From Certet Require Import Embedding.Definitions.
From Certet Require Import Angles.Cases.Isometry Embedding.LeavingProof
  Embedding.LinkProof Topology.CliqueProof.
Open Scope bool_scope.

(** ** What is reached in a finite graph *)

Section Closure.
  Variables (V : Type) (Same : forall u v : V, {u = v} + {u <> v}).
  Variables (step : V -> V -> bool) (all : list V) (start : V).

  Local Notation joined := (Joined (fun x => In x all) (fun x y => step x y = true)).

  Lemma ClosureFrom n : forall l, NoDup l -> incl l all -> In start l ->
    (forall u, In u l -> joined start u) -> (length all <= n + length l)%nat ->
    exists l', In start l' /\ (forall u, In u l' -> joined start u) /\
      forall u w, In u l' -> In w all -> step u w = true -> In w l'.
  Proof.
    induction n as [|n IH]; intros l N I S J L.
    - exists l. split; [exact S|]. split; [exact J|]. intros u w _ W _.
      revert w W. apply NoDup_length_incl; assumption.
    - destruct (existsb (fun u => existsb (fun w =>
        step u w && if in_dec Same w l then false else true) all) l) eqn:E.
      + apply existsb_exists in E. destruct E as (u & U & E).
        apply existsb_exists in E. destruct E as (w & W & E).
        apply andb_prop in E. destruct E as [T F].
        destruct (in_dec Same w l) as [|Out]; [discriminate F|].
        apply (IH (w :: l)).
        * constructor; assumption.
        * intros x [<-|X]; [exact W|exact (I x X)].
        * right. exact S.
        * intros x [<-|X]; [|exact (J x X)].
          exact (Joined_step _ _ start u w (J u U) T W).
        * cbn [length]. lia.
      + exists l. split; [exact S|]. split; [exact J|]. intros u w U W T.
        destruct (in_dec Same w l) as [|Out]; [assumption|]. exfalso.
        enough (true = false) by discriminate. rewrite <- E. symmetry.
        apply existsb_exists. exists u. split; [exact U|].
        apply existsb_exists. exists w. split; [exact W|]. rewrite T.
        destruct (in_dec Same w l); [contradiction|reflexivity].
  Qed.

  Lemma Closure : In start all ->
    exists l, In start l /\ (forall u, In u l -> joined start u) /\
      forall u w, In u l -> In w all -> step u w = true -> In w l.
  Proof.
    intros A. apply (ClosureFrom (length all) [start]).
    - repeat constructor. intros [].
    - intros x [<-|[]]. exact A.
    - left. reflexivity.
    - intros x [<-|[]]. constructor. exact A.
    - lia.
  Qed.
End Closure.

(** ** The link has no holes *)

(** Built up by one vertex after the other, the last first, each of which meets
    the link so far in one piece. *)
Fixpoint BuiltUp (ds : list Direction) : bool :=
  match ds with
  | [] => true
  | [_] => true
  | d :: rest =>
      OnePiece (fun e => existsb (SameDirection e) rest && NextInLink d e) && BuiltUp rest
  end.

Definition Build : list Direction :=
  [Dir_m00; Dir_mmm; Dir_mmp; Dir_mpm; Dir_mpp; Dir_0m0; Dir_0p0; Dir_00m; Dir_00p;
   Dir_pmm; Dir_pmp; Dir_ppm; Dir_ppp; Dir_p00].

Lemma LinkBuiltUp : BuiltUp Build = true.
Proof. vm_compute. reflexivity. Qed.

Lemma InBuild d : In d Build.
Proof. destruct d; cbn; tauto. Qed.

Lemma NextMutual d e : NextInLink d e = true -> NextInLink e d = true.
Proof.
  rewrite !(NextInLinkMeans (C3 0 0 0)). apply AdjacentMutual.
Qed.

Lemma NextDiffers d e : NextInLink d e = true -> SameDirection d e = false.
Proof.
  intros N. destruct (SameDirection d e) eqn:S; [|reflexivity].
  apply SameDirectionMeans in S. subst e. destruct d; discriminate N.
Qed.

Lemma InSame d ds : existsb (SameDirection d) ds = true <-> In d ds.
Proof.
  rewrite existsb_exists. split.
  - intros (e & I & S). apply SameDirectionMeans in S. subst e. exact I.
  - intros I. exists d. split; [exact I|apply SameDirectionRefl].
Qed.

(** Pieces, in directions. *)
Lemma OnePieceWalk part (same : Direction -> Direction -> Prop) :
  OnePiece part = true ->
  (forall d, part d = true -> same d d) ->
  (forall d e f, part d = true -> part e = true -> part f = true ->
     same d e -> NextInLink e f = true -> same d f) ->
  (exists d, part d = true) /\
  forall d e, part d = true -> part e = true -> same d e.
Proof.
  intros O R S. destruct (OnePieceMeans (C3 0 0 0) part O) as [(x & d0 & _ & D0) J].
  split; [exists d0; exact D0|]. intros d e D E.
  set (o := C3 0 0 0) in *.
  assert (W : forall x y, Joined (InPart o part) Adjacent x y ->
    forall d e, x = Translate o (Offset d) -> y = Translate o (Offset e) ->
      part d = true -> part e = true -> same d e).
  { clear -R S. induction 1 as [x [g [-> G]]|x y w K IH N [g [-> G]]];
      intros d e Ex Ey D E.
    - assert (d = e) as <-; [|apply R, D]. apply (OffsetsDiffer d e o). congruence.
    - apply JoinedInside in K. destruct K as [_ [h [-> H]]].
      apply (S d h e); try assumption.
      + apply IH; auto.
      + apply (NextInLinkMeans o). rewrite <- Ey. exact N. }
  apply (W (Translate o (Offset d)) (Translate o (Offset e))); auto.
  apply J; eexists; eauto.
Qed.

(** What changes evenly around all triangles is the change of a function. *)
Theorem Integrate (change : Direction -> Direction -> bool) :
  (forall d e f, NextInLink d e = true -> NextInLink e f = true ->
     NextInLink d f = true -> xorb (change d e) (change e f) = change d f) ->
  (forall d e, change d e = change e d) ->
  exists g, forall d e, NextInLink d e = true -> change d e = xorb (g d) (g e).
Proof.
  intros T M.
  assert (All : forall ds, BuiltUp ds = true -> exists g, forall d e, In d ds -> In e ds ->
    NextInLink d e = true -> change d e = xorb (g d) (g e)).
  { induction ds as [|w rest IH]; intros B.
    - exists (fun _ => false). intros d e [].
    - destruct rest as [|r rest].
      { exists (fun _ => false). intros d e [<-|[]] [<-|[]] N.
        destruct w; discriminate N. }
      set (ds := r :: rest) in *.
      assert (Split : OnePiece (fun e => existsb (SameDirection e) ds && NextInLink w e) = true
        /\ BuiltUp ds = true) by (apply andb_prop in B; exact B).
      destruct Split as [O B']. destruct (IH B') as [g G].
      set (part := fun e => existsb (SameDirection e) ds && NextInLink w e) in *.
      assert (Part : forall e, part e = true <-> In e ds /\ NextInLink w e = true)
        by (intros e; unfold part; rewrite andb_true_iff, InSame; tauto).
      destruct (OnePieceWalk part (fun d e => xorb (g d) (change d w) = xorb (g e) (change e w)) O)
        as [(u & U) C].
      + reflexivity.
      + intros d e f D E F Q N. apply Part in D, E, F. rewrite Q.
        pose proof (G e f (proj1 E) (proj1 F) N) as K.
        pose proof (T e f w N (NextMutual w f (proj2 F)) (NextMutual w e (proj2 E))) as K'.
        revert K K'. clear. destruct (change e f), (change f w), (change e w), (g e), (g f);
          cbn; congruence.
      + exists (fun d => if SameDirection w d then xorb (g u) (change u w) else g d).
        assert (New : forall e, In e ds -> NextInLink w e = true ->
          change w e = xorb (xorb (g u) (change u w)) (g e)).
        { intros e E N. rewrite (C u e U (proj2 (Part e) (conj E N))), (M w e).
          destruct (g e), (change e w); reflexivity. }
        intros d e [<-|D] [<-|E] N.
        * destruct w; discriminate N.
        * rewrite SameDirectionRefl, (NextDiffers w e N). exact (New e E N).
        * rewrite SameDirectionRefl, (NextDiffers w d (NextMutual _ _ N)), M,
            (New d D (NextMutual _ _ N)).
          apply xorb_comm.
        * destruct (SameDirection w d) eqn:Wd.
          -- apply SameDirectionMeans in Wd. subst d. rewrite (NextDiffers w e N).
             exact (New e E N).
          -- destruct (SameDirection w e) eqn:We; [|exact (G d e D E N)].
             apply SameDirectionMeans in We. subst e.
             rewrite M, (New d D (NextMutual _ _ N)). apply xorb_comm. }
  destruct (All Build LinkBuiltUp) as [g G]. exists g. intros d e N.
  apply G; auto using InBuild.
Qed.

(** ** The edges between + and the rest *)

Section Parts.
  Variable inner : Direction -> bool.

  Definition AllCrossings : list (Direction * Direction) :=
    filter (fun '(e, f) => NextInLink e f && inner e && negb (inner f))
      (list_prod AllDirections AllDirections).

  Lemma InAllCrossings e f : In (e, f) AllCrossings <->
    NextInLink e f = true /\ inner e = true /\ inner f = false.
  Proof.
    unfold AllCrossings. rewrite filter_In, in_prod_iff, !andb_true_iff, negb_true_iff.
    pose proof (InAllDirections e). pose proof (InAllDirections f). tauto.
  Qed.

  (** To the next by a common triangle. *)
  Definition Turns (p q : Direction * Direction) : bool :=
    let '(e, f) := p in let '(e', f') := q in
    SameDirection f f' && NextInLink e e' || SameDirection e e' && NextInLink f f'.

  Lemma TurnsMutual p q : Turns p q = true -> Turns q p = true.
  Proof.
    destruct p as [e f], q as [e' f']. unfold Turns.
    intros T. apply orb_prop in T. destruct T as [T|T]; apply andb_prop in T;
      destruct T as [S N]; apply SameDirectionMeans in S; subst;
      rewrite SameDirectionRefl, (NextMutual _ _ N); cbn [andb orb]; auto using orb_true_r.
  Qed.

  Lemma SamePair (p q : Direction * Direction) : {p = q} + {p <> q}.
  Proof. decide equality; decide equality. Qed.

  Hypothesis InnerWhole : OnePiece inner = true.
  Hypothesis OuterWhole : OnePiece (fun d => negb (inner d)) = true.

  Theorem CrossingsJoined p q : In p AllCrossings -> In q AllCrossings ->
    Joined (fun x => In x AllCrossings) (fun x y => Turns x y = true) p q.
  Proof.
    intros P Q.
    destruct (Closure _ SamePair Turns AllCrossings p P) as (l & Lp & J & C).
    enough (L : In q l) by exact (J q L).
    set (m := fun x => if in_dec SamePair x l then true else false).
    assert (Same : forall x y, In x AllCrossings -> In y AllCrossings ->
      Turns x y = true -> m x = m y).
    { intros x y X Y T. unfold m. destruct (in_dec SamePair x l) as [I|I],
        (in_dec SamePair y l) as [K|K]; try reflexivity; exfalso.
      - apply K, (C x y); assumption.
      - apply I, (C y x); auto using TurnsMutual. }
    set (change := fun d e => if inner d then (if inner e then false else m (d, e))
      else if inner e then m (e, d) else false).
    destruct (Integrate change) as [g G].
    - intros d e f De Ef Df. unfold change.
      assert (Tf : forall a b c, NextInLink a c = true -> NextInLink b c = true ->
        NextInLink a b = true -> inner a = true -> inner b = true -> inner c = false ->
        m (a, c) = m (b, c)).
      { intros a b c Ac Bc Ab A B Cc.
        apply Same; [apply InAllCrossings; auto|apply InAllCrossings; auto|].
        unfold Turns. rewrite SameDirectionRefl, Ab. reflexivity. }
      assert (Te : forall a b c, NextInLink a b = true -> NextInLink a c = true ->
        NextInLink b c = true -> inner a = true -> inner b = false -> inner c = false ->
        m (a, b) = m (a, c)).
      { intros a b c Ab Ac Bc A B Cc.
        apply Same; [apply InAllCrossings; auto|apply InAllCrossings; auto|].
        unfold Turns. rewrite SameDirectionRefl, Bc. apply orb_true_r. }
      pose proof (NextMutual _ _ De). pose proof (NextMutual _ _ Ef).
      pose proof (NextMutual _ _ Df).
      destruct (inner d) eqn:D, (inner e) eqn:E, (inner f) eqn:F; try reflexivity.
      + rewrite xorb_false_l. apply Tf; assumption.
      + rewrite (Tf d f e) by assumption. apply xorb_nilpotent.
      + rewrite xorb_false_r. apply Te; assumption.
      + rewrite xorb_false_r. apply Tf; assumption.
      + rewrite (Te e d f) by assumption. apply xorb_nilpotent.
      + rewrite xorb_false_l. apply Te; assumption.
    - intros d e. unfold change. destruct (inner d), (inner e); reflexivity.
    - assert (In_ : forall d e, inner d = true -> inner e = true -> g d = g e).
      { apply (OnePieceWalk inner (fun d e => g d = g e) InnerWhole); [reflexivity|].
        intros d e f D E F -> N. pose proof (G e f N) as K. unfold change in K.
        rewrite E, F in K. destruct (g e), (g f); cbn in K; congruence. }
      assert (Out : forall d e, inner d = false -> inner e = false -> g d = g e).
      { intros d e D E.
        apply (OnePieceWalk (fun d => negb (inner d)) (fun d e => g d = g e) OuterWhole);
          [reflexivity| |rewrite D; reflexivity|rewrite E; reflexivity].
        intros a b c _ B Cc -> N. pose proof (G b c N) as K. unfold change in K.
        rewrite negb_true_iff in B, Cc. rewrite B, Cc in K.
        destruct (g b), (g c); cbn in K; congruence. }
      assert (Value : forall e f, In (e, f) AllCrossings -> m (e, f) = xorb (g e) (g f)).
      { intros e f I. apply InAllCrossings in I. destruct I as (N & E & F).
        rewrite <- (G e f N). unfold change. rewrite E, F. reflexivity. }
      destruct p as [e f], q as [e' f'].
      pose proof (Value e f P) as Vp. pose proof (Value e' f' Q) as Vq.
      apply InAllCrossings in P, Q. destruct P as (_ & E & F), Q as (_ & E' & F').
      rewrite (In_ e' e E' E), (Out f' f F' F), <- Vp in Vq. unfold m in Vq.
      destruct (in_dec SamePair (e', f') l) as [L|L]; [exact L|].
      destruct (in_dec SamePair (e, f) l); [discriminate Vq|contradiction].
  Qed.
End Parts.
