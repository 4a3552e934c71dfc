(** * The walk over the environment

    Prints, as the kernel holds them, the statements of some theorems and
    everything that they reach: one parenthesized line for each definition and
    inductive type, with its full name.  No notation, no coercion, no short name
    and no implicit argument comes between: Coq's printer is not asked, but for
    the names of sorts.  [terms.py] makes the lines readable. *)

From Ltac2 Require Import Ltac2.

Ltac2 say (s : string) := Message.of_string s.
Ltac2 cat := Message.concat.

Ltac2 rec path_message (ids : ident list) :=
  match ids with
  | [] => say ""
  | id :: ids =>
      match ids with
      | [] => Message.of_ident id
      | _ :: _ => cat (Message.of_ident id) (cat (say ".") (path_message ids))
      end
  end.

Ltac2 name r := path_message (Env.path r).

Ltac2 rec spaced (parts : message list) :=
  match parts with
  | [] => say ""
  | part :: parts => cat (say " ") (cat part (spaced parts))
  end.

Ltac2 node (tag : string) (parts : message list) :=
  cat (say "(") (cat (say tag) (cat (spaced parts) (say ")"))).

Ltac2 bound b :=
  match Constr.Binder.name b with
  | None => say "_"
  | Some id => Message.of_ident id
  end.

Ltac2 size := 4096.

Ltac2 rec hash_string s i h :=
  match Int.equal i (String.length s) with
  | true => h
  | false =>
      let h := Int.add (Int.mul h 31) (Char.to_int (String.get s i)) in
      hash_string s (Int.add i 1) (Int.sub h (Int.mul size (Int.div h size)))
  end.

Ltac2 rec hash_path ids h :=
  match ids with
  | [] => h
  | id :: ids => hash_path ids (hash_string (Ident.to_string id) 0 h)
  end.

Ltac2 rec same_path p q :=
  match p with
  | [] => match q with [] => true | _ :: _ => false end
  | a :: p =>
      match q with
      | [] => false
      | b :: q => match Ident.equal a b with true => same_path p q | false => false end
      end
  end.

Ltac2 Type state := { seen : ident list list array; mutable todo : Std.reference list }.

Ltac2 visit st r :=
  let p := Env.path r in
  let h := hash_path (List.rev p) 7 in
  let bucket := Array.get (st.(seen)) h in
  match List.exist (same_path p) bucket with
  | true => ()
  | false =>
      Array.set (st.(seen)) h (p :: bucket);
      st.(todo) := r :: st.(todo)
  end.

Ltac2 rec term st (c : constr) : message :=
  let sub := term st in
  let global r := visit st r; name r in
  let binder tag b rest := node tag (bound b :: sub (Constr.Binder.type b) :: rest) in
  match Constr.Unsafe.kind c with
  | Constr.Unsafe.Rel n => cat (say "#") (Message.of_int n)
  | Constr.Unsafe.Sort _ => Message.of_constr c
  | Constr.Unsafe.Cast c _ _ => sub c
  | Constr.Unsafe.Prod b c => binder "forall" b [sub c]
  | Constr.Unsafe.Lambda b c => binder "fun" b [sub c]
  | Constr.Unsafe.LetIn b v c => binder "let" b [sub v; sub c]
  | Constr.Unsafe.App f args =>
      node "app" (sub f :: List.map sub (Array.to_list args))
  | Constr.Unsafe.Constant c _ => global (Std.ConstRef c)
  | Constr.Unsafe.Ind i _ => global (Std.IndRef i)
  | Constr.Unsafe.Constructor c _ => name (Std.ConstructRef c)
  | Constr.Unsafe.Case _ predicate _ c branches =>
      node "match" (sub predicate :: sub c :: List.map sub (Array.to_list branches))
  | Constr.Unsafe.Fix structural which binders bodies =>
      node "fix" (Message.of_int which :: List.flatten (List.init (Array.length binders) (fun i =>
        [Message.of_int (Array.get structural i); bound (Array.get binders i);
         sub (Constr.Binder.type (Array.get binders i)); sub (Array.get bodies i)])))
  | Constr.Unsafe.CoFix which binders bodies =>
      node "cofix" (Message.of_int which :: List.flatten (List.init (Array.length binders) (fun i =>
        [bound (Array.get binders i);
         sub (Constr.Binder.type (Array.get binders i)); sub (Array.get bodies i)])))
  | _ => say "(unprintable)"
  end.

Ltac2 type_of st r := term st (Constr.type (Env.instantiate r)).

Ltac2 only r := {
  Std.rBeta := false; Std.rMatch := false; Std.rFix := false;
  Std.rCofix := false; Std.rZeta := false; Std.rDelta := false;
  Std.rConst := [r]
}.

Ltac2 constant st r :=
  let c := Env.instantiate r in
  let body := Std.eval_cbv (only r) c in
  match Constr.equal c body with
  | true => node "hidden" [name r; type_of st r]
  | false => node "definition" [name r; type_of st r; term st body]
  end.

Ltac2 inductive st i :=
  let d := Ind.data i in
  List.iter (fun b => visit st (Std.IndRef (Ind.repr (Ind.get_block d b))))
    (List.init (Ind.nblocks d) (fun b => b));
  let constructor n :=
    let r := Std.ConstructRef (Ind.get_constructor d n) in
    node "constructor" [name r; type_of st r] in
  node "inductive"
    (name (Std.IndRef i) :: type_of st (Std.IndRef i)
     :: List.init (Ind.nconstructors d) constructor).

Ltac2 rec close st :=
  match st.(todo) with
  | [] => ()
  | r :: rest =>
      st.(todo) := rest;
      Message.print
        (match r with
         | Std.ConstRef _ => constant st r
         | Std.IndRef i => inductive st i
         | _ => node "unknown" [name r]
         end);
      close st
  end.

Ltac2 walk (statements : Std.reference list) (definitions : Std.reference list) :=
  let st := { seen := Array.make size []; todo := [] } in
  List.iter (fun r => Message.print (node "statement" [name r; type_of st r])) statements;
  List.iter (visit st) definitions;
  close st.
