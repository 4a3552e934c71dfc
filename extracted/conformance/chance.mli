(** Numbers that look random and are the same everywhere, made from a seed and
    from what they are for. *)

val below : int -> int -> int list -> int
(** [below n seed words] is in [0 .. n - 1]. *)

val one_of : 'a list -> int -> int list -> 'a
