(** * The Parity Rule is an order of the cuts: proof *)

From Certet Require Import Key.Definitions.
Open Scope Z_scope.

Theorem ParityIsAnOrder :
  forall Vertex GetSign GetIntersection GetKey (v1 v2 v3 v4 : Vertex),
    KeepsParity GetKey v1 v2 v3 v4 ->
    GetKeyTets Vertex GetSign GetIntersection GetKey v1 v2 v3 v4
    = GetUnstructuredTets Vertex GetSign GetIntersection v1 v2 v3 v4.
Proof.
  intros Vertex GetSign GetIntersection GetKey v1 v2 v3 v4
    (long & first & second & order & longs & firsts & seconds).
  cbn [In] in longs, firsts, seconds.
  assert (decided : forall x y, x < y -> (x <? y) = true /\ (y <? x) = false)
    by (intros x y L; split; [apply Z.ltb_lt | apply Z.ltb_ge]; lia).
  destruct (decided long first) as [LF FL]; [lia|].
  destruct (decided long second) as [LS SL]; [lia|].
  destruct (decided first second) as [FS SF]; [lia|].
  unfold GetKeyTets, GetUnstructuredTets.
  destruct (GetSign v1), (GetSign v2), (GetSign v3), (GetSign v4); try reflexivity;
    unfold Prism, Pyramid, Wedge, WedgeTowards, Before;
    rewrite ?(longs v1 v2), ?(longs v2 v1), ?(longs v3 v4), ?(longs v4 v3),
      ?(firsts v1 v4), ?(firsts v4 v1), ?(firsts v2 v3), ?(firsts v3 v2),
      ?(seconds v1 v3), ?(seconds v3 v1), ?(seconds v2 v4), ?(seconds v4 v2) by tauto;
    rewrite ?LF, ?FL, ?LS, ?SL, ?FS, ?SF; reflexivity.
Qed.
