% Joins: the program solves goals that only look facts up, all at once, instead of exchanging messages about each. This
% file selects these goals. Predicates that are defined by a single conjunction are replaced by it: the program
% generates defined(Head, Body) from their texts.

% solved(+Goal, +Values, -End): the program has solved a whole query, and has the values of its answers.
solved(Goal, Values, End) :-
    planned(Goal, Goals),
    converse(solve(Goals, Values), Reply),
    Reply = solved(How),
    End = done(How).

% with_joins(+Goal, +Guarded, -Joining): joins the longest possible front part of a conjunction.
with_joins(Goal, Guarded, Joining) :-
    ( leading(64, Goal, Guarded, Some, SomeGuarded, Rest) ->
        Joined = joined(Some, SomeGuarded),
        ( Rest == true -> Joining = Joined ; Joining = (Joined, Rest) )
    ; Joining = Guarded
    ).

leading(_, Goal, _, _, _, _) :- var(Goal), !, fail.
leading(N, (A, B), (A1, B1), Some, SomeGuarded, Rest) :- !,
    N > 0,
    may_join(A, A1),
    M is N - 1,
    ( leading(M, B, B1, Bs, Bs1, Rest) ->
        Some = (A, Bs), SomeGuarded = (A1, Bs1)
    ; Some = A, SomeGuarded = A1, Rest = B1
    ).
leading(_, A, A1, A, A1, true) :- may_join(A, A1).

% A goal that needs a variable of a later goal is left to the engine, which reports it.
may_join(Goal, Guarded) :- Guarded \= (bound_first(_, _), _), \+ \+ planned(Goal, _).

% joined(+Goal, +Guarded): solves Goal by the program if that pays for the messages, otherwise as Guarded.
joined(Goal, Guarded) :-
    ( worth_joining(Goal, Goals) ->
        term_variables(Goals-Goal, Variables),
        converse(need(join(Goals, Variables)), Reply),
        ( Reply == declined -> call(Guarded) ; chunk(Reply, Variables) )
    ; call(Guarded)
    ).

% Known facts about a thing are cheaper to read than to request; a single goal is a stream of its own.
worth_joining(Goal, Goals) :-
    planned(Goal, Goals),
    Goals = [First|Rest],
    ( over_all(First) -> true ; Rest = [_|_], First =.. [_, About|_], \+ ground(About) ).

over_all(findall(_, _, _)).
over_all(aggregate_all(_, _, _)).
over_all(mean_by(_, _, _, _, _, _)).

% planned(+Goal, -Goals): the same as a list of goals that the program supports.
planned(Goal, Goals) :- planned(Goal, 8, Goals, []), in_number(64, Goals).

in_number(_, []).
in_number(N, [_|Rest]) :- N > 0, M is N - 1, in_number(M, Rest).

planned(Goal, _, _, _) :- var(Goal), !, fail.
planned((A, B), Depth, Goals, Rest) :- !, planned(A, Depth, Goals, Goals1), planned(B, Depth, Goals1, Rest).
planned((A ; B), Depth, [either([As, Bs])|Rest], Rest) :- !,
    nonvar(A),
    A \= (_ -> _),
    planned(A, Depth, As, []),
    planned(B, Depth, Bs, []).
planned(\+ A, Depth, [\+ As|Rest], Rest) :- !, planned(A, Depth, As, []).
planned(not(A), Depth, [\+ As|Rest], Rest) :- !, planned(A, Depth, As, []).
planned(once(A), Depth, [once(As)|Rest], Rest) :- !, planned(A, Depth, As, []).
planned(forall(A, B), Depth, [forall(As, Bs)|Rest], Rest) :- !, planned(A, Depth, As, []), planned(B, Depth, Bs, []).
planned(findall(T, A, L), Depth, [findall(T, As, L)|Rest], Rest) :- !, planned(A, Depth, As, []).
planned(aggregate_all(K, A, R), Depth, [aggregate_all(K, As, R)|Rest], Rest) :- !, nonvar(K), planned(A, Depth, As, []).
planned(mean_by(K, N, A, K1, M, C), Depth, [mean_by(K, N, As, K1, M, C)|Rest], Rest) :- !, planned(A, Depth, As, []).
planned(same(A, B), _, [A = B|Rest], Rest) :- !.
planned(Goal, _, [Goal|Rest], Rest) :- joined_goal(Goal), !.
planned(Goal, Depth, Goals, Rest) :-
    Depth > 0,
    callable(Goal),
    Less is Depth - 1,
    defined(Goal, Body),
    planned(Body, Less, Goals, Rest).

joined_goal(true).
joined_goal(instance_of(_, _)).
joined_goal(is_a(_, _)).
joined_goal(of_class(_, _)).
joined_goal(triple(_, _, _)).
joined_goal(stated(_, _, _)).
joined_goal(has_data_value(_, _)).
joined_goal(value(_, _, _)).
joined_goal(relation(_, _, _)).
joined_goal(part(_, _)).
joined_goal(part_below(_, _, _)).
joined_goal(above(_, _, _)).
joined_goal(timed(_, _, _)).
joined_goal(related(_, _, _)).
joined_goal(episode(_, _)).
joined_goal(last_episode(_, _)).
joined_goal(telemetry_in(_, _, _, _, _)).
joined_goal(thing(_, _)).
joined_goal(known(_, _, _)).
joined_goal(number(_)).
joined_goal(length(_, _)).
joined_goal(_ = _).
joined_goal(_ is _).
joined_goal(_ =< _).
joined_goal(_ >= _).
joined_goal(_ < _).
joined_goal(_ > _).
joined_goal(_ =:= _).
joined_goal(_ =\= _).

% mean_by(+Key, +Number, +Goal, -Of, -Mean, -Count): computed like the program does, where the program does not.
mean_by(Key, Number, Goal, Of, Mean, Count) :-
    findall(Key-Number, Goal, All),
    mean_by_key(All, Of, Mean, Count).
