% Predicates that a query may call: those listed here, and no others.

% guarded(+Goal, -Guarded): the same goal, with a check before every goal that is not yet known.
guarded(Goal, Guarded) :- guarded(Goal, after([], []), Guarded).

% guarded(+Goal, +After, -Guarded): After holds the goals that follow, and the names of variables. If a later goal binds
% a variable on which the answers of Goal depend, this is an error that names the variable.
guarded(Goal, _, Guarded) :- var(Goal), !, Guarded = run(Goal).
guarded((A, B), F, (A1, B1)) :- !, followed_by(B, F, F1), guarded(A, F1, A1), guarded(B, F, B1).
guarded((A ; B), F, (A1 ; B1)) :- !, guarded(A, F, A1), guarded(B, F, B1).
guarded((A -> B), F, (A1 -> B1)) :- !, followed_by(B, F, F1), guarded(A, F1, A1), guarded(B, F, B1).
guarded(\+ A, F, Guarded) :- !, guarded(A, F, A1), bound_before(\+ A, A, none, F, \+ A1, Guarded).
guarded(!, _, !) :- !.
guarded(_^A, F, A1) :- !, guarded(A, F, A1).
guarded(Goal, _, _) :- \+ callable(Goal), !, throw(error(type_error(callable, Goal), query)).
guarded(A = B, _, same(A, B)) :- !.
guarded(A \= B, F, Guarded) :- !, bound_before(A \= B, A-B, none, F, \+ same(A, B), Guarded).
guarded(A == B, F, Guarded) :- !, bound_before(A == B, A-B, none, F, alike(A, B), Guarded).
guarded(A \== B, F, Guarded) :- !, bound_before(A \== B, A-B, none, F, \+ alike(A, B), Guarded).
guarded(Goal, F, Guarded) :-
    functor(Goal, Name, Arity),
    ( meta(Name, Arity, Kinds) ->
        Goal =.. [_|Arguments],
        guarded_arguments(Kinds, Arguments, F, Safe),
        Guarded0 =.. [Name|Safe],
        ( depends(Goal, Of, Own) -> bound_before(Goal, Of, Own, F, Guarded0, Guarded) ; Guarded = Guarded0 )
    ; printing(Goal, Format, Arguments) ->
        Guarded = printed(Format, Arguments)
    ; formatting(Goal, Sink, Format, Arguments) ->
        Guarded = formatted(Sink, Format, Arguments)
    ; listed(Name, Arity) ->
        ( depends(Goal, Of, Own) -> bound_before(Goal, Of, Own, F, Goal, Guarded) ; Guarded = Goal )
    ; throw(unknown_predicate(Name, Arity))
    ).

guarded_arguments([], [], _, []).
guarded_arguments([Kind|Kinds], [A|As], F, [B|Bs]) :-
    guarded_argument(Kind, A, F, B),
    guarded_arguments(Kinds, As, F, Bs).

guarded_argument(value, A, _, A).
guarded_argument(goal, A, F, B) :- guarded(A, F, A1), with_joins(A, A1, B).
% Statements limited in time are checked before the call.
guarded_argument(statement, A, F, B) :- guarded(A, F, B).
guarded_argument(solutions, A, F, B) :- guarded_solutions(A, F, B).
% Closures are checked when they are called, because their arguments are known only then.
guarded_argument(closure, A, _, run(A)).

guarded_solutions(A, _, B) :- var(A), !, B = run(A).
guarded_solutions(V^A, F, V^B) :- !, guarded_solutions(A, F, B).
guarded_solutions(A, F, B) :- guarded(A, F, B).

followed_by(Goal, after(Goals, Names), after([Goal|Goals], Names)).

% depends(+Goal, -Of, -Own): the answers depend on whether variables of Of are bound, except variables of Own.
depends(not(A), A, none).
depends(forall(A, B), A-B, none).
depends(findall(T, A, _), A, T).
depends(findall(T, A, _, _), A, T).
depends(aggregate_all(Spec, A, _), A, Spec).
depends(A @< B, A-B, none).
depends(A @> B, A-B, none).
depends(A @=< B, A-B, none).
depends(A @>= B, A-B, none).
depends(atom(A), A, none).
depends(number(A), A, none).
depends(integer(A), A, none).
depends(float(A), A, none).
depends(atomic(A), A, none).
depends(compound(A), A, none).
depends(callable(A), A, none).
depends(ground(A), A, none).
depends(is_list(A), A, none).

% bound_before(+Goal, +Of, +Own, +After, +Guarded0, -Guarded): checks at the call that every variable of Of which occurs
% in later goals is bound; otherwise it is an error.
bound_before(Goal, Of, Own, after(Goals, Names), Guarded0, Guarded) :-
    ( Names = [_|_], Goals = [_|_], shared_names(Names, Of, Own, Goals, [Shared|More]) ->
        functor(Goal, Name, _),
        Guarded = (bound_first([Shared|More], Name), Guarded0)
    ; Guarded = Guarded0
    ).

shared_names(Names, Of, Own, Goals, Shared) :-
    term_variables(Of, Vs),
    Vs = [_|_],
    term_variables(Own, Owns),
    term_variables(Goals, Later),
    findall_shared(Names, Vs, Owns, Later, Shared).

findall_shared([], _, _, _, []).
findall_shared([Name=V|Rest], Vs, Owns, Later, Shared) :-
    ( is_among(V, Vs), \+ is_among(V, Owns), is_among(V, Later) -> Shared = [Name=V|Shared1] ; Shared = Shared1 ),
    findall_shared(Rest, Vs, Owns, Later, Shared1).

is_among(V, [W|Ws]) :- ( V == W -> true ; is_among(V, Ws) ).

bound_first([], _).
bound_first([Name=V|Rest], Of) :- ( var(V) -> throw(error(instantiation_error, unbound(Name, Of))) ; bound_first(Rest, Of) ).

% same(?A, ?B): both unify, are the same number, or are names of the same thing.
same(A, B) :- A = B, !.
same(A, B) :- number(A), number(B), !, A =:= B.
same(A, B) :- may_name(A), may_name(B), ( has_prefix(A) -> true ; has_prefix(B) ), thing_named(A, Name), thing_named(B, Name).

alike(A, B) :- A == B, !.
alike(A, B) :- nonvar(A), nonvar(B), \+ number(A), same(A, B).

may_name(Term) :- ( atom(Term) -> true ; nonvar(Term), Term = Prefix:Local, atom(Prefix), atom(Local) ).

has_prefix(Term) :- ( atom(Term) -> has_colon(Term) ; true ), !.

thing_named(Term, Name) :- catch(known(thing, Term, Name), Error, ( Error = unknown(_, _, _) -> fail ; throw(Error) )).

run(Goal) :-
    ( var(Goal) -> unknown_yet('a goal that is called') ; true ),
    guarded(Goal, Guarded),
    call(Guarded).
run(G, A) :- extended(G, [A], H), run(H).
run(G, A, B) :- extended(G, [A, B], H), run(H).
run(G, A, B, C) :- extended(G, [A, B, C], H), run(H).
run(G, A, B, C, D) :- extended(G, [A, B, C, D], H), run(H).
run(G, A, B, C, D, E) :- extended(G, [A, B, C, D, E], H), run(H).
run(G, A, B, C, D, E, F) :- extended(G, [A, B, C, D, E, F], H), run(H).

extended(Goal, _, _) :- var(Goal), !, unknown_yet('a goal that is called').
extended(Goal, More, Extended) :-
    ( callable(Goal) -> true ; throw(error(type_error(callable, Goal), query)) ),
    Goal =.. [Name|Arguments],
    append(Arguments, More, All),
    Extended =.. [Name|All].

meta(call, 1, [goal]).
meta(call, 2, [closure, value]).
meta(call, 3, [closure, value, value]).
meta(call, 4, [closure, value, value, value]).
meta(call, 5, [closure, value, value, value, value]).
meta(call, 6, [closure, value, value, value, value, value]).
meta(call, 7, [closure, value, value, value, value, value, value]).
meta(catch, 3, [goal, value, goal]).
meta(not, 1, [goal]).
meta(once, 1, [goal]).
meta(ignore, 1, [goal]).
meta(forall, 2, [goal, goal]).
meta(findall, 3, [value, goal, value]).
meta(findall, 4, [value, goal, value, value]).
meta(bagof, 3, [value, solutions, value]).
meta(setof, 3, [value, solutions, value]).
meta(aggregate_all, 3, [value, goal, value]).
meta(maplist, 2, [closure, value]).
meta(maplist, 3, [closure, value, value]).
meta(maplist, 4, [closure, value, value, value]).
meta(maplist, 5, [closure, value, value, value, value]).
meta(foldl, 4, [closure, value, value, value]).
meta(foldl, 5, [closure, value, value, value, value]).
meta(foldl, 6, [closure, value, value, value, value, value]).
meta(include, 3, [closure, value, value]).
meta(exclude, 3, [closure, value, value]).
meta(partition, 4, [closure, value, value, value]).
meta(kb_call, 1, [goal]).
meta(ask, 1, [goal]).
meta(during, 2, [statement, value]).
meta(since, 2, [statement, value]).
meta(until, 2, [statement, value]).

listed(Name, Arity) :- builtin(Name, Arity).
listed(Name, Arity) :- predicate(Name, Arity, _).

% Printed text is sent to the program, because standard output carries the protocol.
printing(format(F), F, []).
printing(format(F, As), F, As).
printing(write(T), '~w', [T]).
printing(writeln(T), '~w~n', [T]).
printing(print(T), '~q', [T]).
printing(writeq(T), '~q', [T]).
printing(write_canonical(T), '~q', [T]).
printing(nl, '~n', []).

printed(Format, Arguments) :- need(print(Format, Arguments), _).

formatting(format(Sink, F, As), Sink, F, As).

formatted(Sink, Format, Arguments) :-
    ( nonvar(Sink), member(Sink-How, [atom(A)-A, chars(Cs)-Cs, codes(Cs)-Cs]) -> true
    ; throw(error(domain_error(output_sink, Sink), format))
    ),
    need(format(Format, Arguments), [Text]),
    functor(Sink, Kind, _),
    text_as(Kind, Text, How).

text_as(atom, Text, Text).
text_as(chars, Text, Cs) :- atom_chars(Text, Cs).
text_as(codes, Text, Cs) :- atom_codes(Text, Cs).

builtin(format, 1).
builtin(format, 2).
builtin(format, 3).
builtin(write, 1).
builtin(writeln, 1).
builtin(print, 1).
builtin(writeq, 1).
builtin(write_canonical, 1).
builtin(nl, 0).
builtin(true, 0).
builtin(fail, 0).
builtin(false, 0).
builtin(=, 2).
builtin(\=, 2).
builtin(==, 2).
builtin(\==, 2).
builtin(@<, 2).
builtin(@>, 2).
builtin(@=<, 2).
builtin(@>=, 2).
builtin(compare, 3).
builtin(is, 2).
builtin(=:=, 2).
builtin(=\=, 2).
builtin(<, 2).
builtin(>, 2).
builtin(=<, 2).
builtin(>=, 2).
builtin(throw, 1).
builtin(repeat, 0).
builtin(succ, 2).
builtin(plus, 3).
builtin(subsumes_term, 2).
builtin(unify_with_occurs_check, 2).
builtin(term_variables, 2).
builtin(var, 1).
builtin(nonvar, 1).
builtin(atom, 1).
builtin(number, 1).
builtin(integer, 1).
builtin(float, 1).
builtin(atomic, 1).
builtin(compound, 1).
builtin(callable, 1).
builtin(ground, 1).
builtin(is_list, 1).
builtin(functor, 3).
builtin(arg, 3).
builtin(=.., 2).
builtin(copy_term, 2).
builtin(atom_length, 2).
builtin(atom_concat, 3).
builtin(sub_atom, 5).
builtin(atom_chars, 2).
builtin(atom_codes, 2).
builtin(char_code, 2).
builtin(number_chars, 2).
builtin(number_codes, 2).
builtin(atom_number, 2).
builtin(between, 3).
builtin(length, 2).
builtin(member, 2).
builtin(memberchk, 2).
builtin(append, 2).
builtin(append, 3).
builtin(last, 2).
builtin(delete, 3).
builtin(permutation, 2).
builtin(list_to_set, 2).
builtin(subtract, 3).
builtin(intersection, 3).
builtin(union, 3).
builtin(numlist, 3).
builtin(flatten, 2).
builtin(msort, 2).
builtin(pairs_keys, 2).
builtin(pairs_values, 2).
builtin(pairs_keys_values, 3).
builtin(atomic_list_concat, 2).
builtin(atomic_list_concat, 3).
builtin(reverse, 2).
builtin(nth0, 3).
builtin(nth1, 3).
builtin(select, 3).
builtin(sum_list, 2).
builtin(sumlist, 2).
builtin(max_list, 2).
builtin(min_list, 2).
builtin(sort, 2).
builtin(keysort, 2).

% aggregate_all(+Spec, :Goal, -Result): count, sum(E), max(E), min(E), bag(E) or set(E). For max and min with a witness,
% such as max(E, W), the result is max(E, W).
aggregate_all(Spec, Goal, Result) :- var(Spec), !, throw(error(instantiation_error, aggregate_all(Spec, Goal, Result))).
aggregate_all(count, Goal, Count) :- !, findall(x, Goal, L), length(L, Count).
aggregate_all(bag(E), Goal, L) :- !, findall(E, Goal, L).
aggregate_all(set(E), Goal, S) :- !, findall(E, Goal, L), sort(L, S).
aggregate_all(sum(E), Goal, Sum) :- !, findall(X, (Goal, X is E), L), total(L, 0, Sum).
aggregate_all(mean(E), Goal, Mean) :- !,
    findall(X, (Goal, X is E), L),
    L = [_|_],
    total(L, 0, Sum),
    length(L, N),
    Mean is Sum / N.
aggregate_all(max(E), Goal, Max) :- !, findall(X, (Goal, X is E), [First|L]), largest(L, First, Max).
aggregate_all(min(E), Goal, Min) :- !, findall(X, (Goal, X is E), [First|L]), smallest(L, First, Min).
aggregate_all(max(E, W), Goal, max(X, V)) :- !,
    findall(Y-U, (Goal, Y is E, U = W), [First|L]),
    largest_pair(L, First, X-V).
aggregate_all(min(E, W), Goal, min(X, V)) :- !,
    findall(Y-U, (Goal, Y is E, U = W), [First|L]),
    smallest_pair(L, First, X-V).
aggregate_all(Spec, _, _) :- throw(error(domain_error(aggregate, Spec), aggregate_all)).

total([], Sum, Sum).
total([X|Xs], Sum0, Sum) :- Sum1 is Sum0 + X, total(Xs, Sum1, Sum).

largest([], M, M).
largest([X|Xs], M0, M) :- ( X > M0 -> largest(Xs, X, M) ; largest(Xs, M0, M) ).

smallest([], M, M).
smallest([X|Xs], M0, M) :- ( X < M0 -> smallest(Xs, X, M) ; smallest(Xs, M0, M) ).

largest_pair([], M, M).
largest_pair([X-W|Xs], M-V, R) :- ( X > M -> largest_pair(Xs, X-W, R) ; largest_pair(Xs, M-V, R) ).

smallest_pair([], M, M).
smallest_pair([X-W|Xs], M-V, R) :- ( X < M -> smallest_pair(Xs, X-W, R) ; smallest_pair(Xs, M-V, R) ).
