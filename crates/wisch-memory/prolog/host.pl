% Protocol with the program, which sends queries and the facts that they need.
%
% Both sides send terms, one per line. The program sends ask(Query, Limit), where Query is a string. This side replies
% with names(Names), then rows([row(values(Value, ...), ...), ...]) with the answers, and ends with done(all),
% done(limit) or error(Error). In between it may send need(Request), which the program answers with rows(Facts),
% chunk(Cursor, Rows) or fault(Error), and view(Command), which has no reply.

:- dynamic(i/6).
:- dynamic(k/2).
:- dynamic(v/3).
:- dynamic(r/3).
:- dynamic(c/2).
:- dynamic(f/2).
:- dynamic(loaded/1).
:- dynamic(resolved/2).
:- dynamic(closure/3).

main :-
    open_host,
    repeat,
    hear(Order),
    once(obey(Order)),
    Order == halt,
    !.

obey(halt).
obey(end_of_file) :- halt.
obey(forget) :- forget_facts, say(done(all)), flush_output.
obey(ask(Query, Limit)) :-
    catch(answer(Query, Limit, End), Error, ( plain(Error, Plain), End = error(Plain) )),
    say(End),
    flush_output.

% Engines state the place of an error in different ways.
plain(Error, cyclic) :- catch(( finite(Error), fail ), cyclic, true), !.
plain(error(instantiation_error, Context), Context) :- nonvar(Context), names_unbound(Context), !.
plain(error(Formal, _), error(Formal, none)) :- !.
plain(Error, Error).

names_unbound(unbound(_)).
names_unbound(unbound(_, _)).

answer(Query, Limit, End) :-
    parse_query(Query, Parsed, Names),
    full_names(Parsed, Goal),
    names_and_values(Names, Atoms, Values),
    say(names(Atoms)),
    guarded(Goal, after([], Names), Guarded),
    ( solved(Goal, Values, End) -> true ; gone_through(Goal, Guarded, Values, Limit, End) ).

gone_through(Goal, Guarded, Values, Limit, End) :-
    with_joins(Goal, Guarded, Joining),
    counter_set(0),
    groups(Values, Groups),
    Row =.. [row|Groups],
    findall(Row, at_most(Limit, Joining, Row), Rows),
    say_rows(Rows),
    counter_get(Count),
    ( Count >= Limit -> End = done(limit) ; End = done(all) ).

% full_names(+Term, -Full): names with a prefix, and individuals of episodes, are replaced by their full names, so that
% they unify with facts. Unknown names stay; the goal that needs them reports the error.
full_names(Term, Full) :- var(Term), !, Full = Term.
full_names((A, B), (A1, B1)) :- !, full_names(A, A1), full_names(B, B1).
full_names(true, true) :- !.
full_names(Term, Full) :- atom(Term), !, ( is_individual_like(Term), thing_named(Term, Name) -> Full = Name ; Full = Term ).
full_names(Term, Full) :- atomic(Term), !, Full = Term.
full_names(Prefix:Local, Full) :- atom(Prefix), atom(Local), !, ( thing_named(Prefix:Local, Name) -> Full = Name ; Full = Prefix:Local ).
full_names(Term, Full) :- Term =.. [F|As], full_names_of(As, Bs), Full =.. [F|Bs].

full_names_of([], []).
full_names_of([A|As], [B|Bs]) :- full_names(A, B), full_names_of(As, Bs).

% Class_episode-place. Long texts are frequent, so each character is read once.
is_individual_like(Atom) :- atom_chars(Atom, Cs), once(append(_, ['_'|After], Cs)), memberchk(-, After).

has_colon(Atom) :- atom_chars(Atom, Cs), memberchk(:, Cs).

% groups(+Values, -Groups): values in terms with few arguments, because systems limit the number of arguments.
groups([], []) :- !.
groups(Values, [Group|Groups]) :-
    first(200, Values, Some, Rest),
    Group =.. [values|Some],
    groups(Rest, Groups).

at_most(Limit, Goal, Row) :-
    in_pieces(Goal),
    finite(Row),
    counter_get(Before),
    Count is Before + 1,
    counter_set(Count),
    ( Count >= Limit -> ! ; true ).

% A goal is compiled before it is called, in a time that grows faster than its length. Long conjunctions are therefore
% called in pieces. A cut applies to the whole conjunction.
in_pieces(Goal) :- has_cut(Goal), !, call(Goal).
in_pieces(Goal) :- pieces(Goal).

pieces(Goal) :- piece(64, Goal, Some, Rest), ( Rest == none -> call(Some) ; call(Some), pieces(Rest) ).

piece(N, (A, B), (A, C), Rest) :- N > 1, !, M is N - 1, piece(M, B, C, Rest).
piece(_, (A, B), A, B) :- !.
piece(_, A, A, none).

has_cut(A) :- var(A), !, fail.
has_cut(!).
has_cut((A, B)) :- ( has_cut(A) -> true ; has_cut(B) ).
has_cut((A ; B)) :- ( has_cut(A) -> true ; has_cut(B) ).
has_cut((A -> B)) :- ( has_cut(A) -> true ; has_cut(B) ).

% Each term costs time to write, so many rows go into one term.
say_rows([]) :- !.
say_rows(Rows) :-
    first(256, Rows, Some, Rest),
    say(rows(Some)),
    say_rows(Rest).

first(0, Rest, [], Rest) :- !.
first(_, [], [], []) :- !.
first(N, [X|Xs], [X|Ys], Rest) :- M is N - 1, first(M, Xs, Ys, Rest).

names_and_values([], [], []).
names_and_values([Name=Value|Rest], Names, Values) :-
    ( hidden(Name) ->
        Names = Names1,
        Values = Values1
    ; Names = [Name|Names1],
      Values = [Value|Values1]
    ),
    names_and_values(Rest, Names1, Values1).

hidden(Name) :- sub_atom(Name, 0, 1, _, '_').

say(Term) :-
    write_term(Term, [quoted(true), ignore_ops(true)]),
    put_char('.'),
    nl.

% need(+Request, -Rows): the program's reply to a request.
need(Request, Rows) :-
    converse(need(Request), Reply),
    whole(Reply, Rows).

whole(chunk(Cursor, Some), Rows) :- !,
    converse(need(more(Cursor)), Reply),
    whole(Reply, Rest),
    append(Some, Rest, Rows).
whole(Reply, Rows) :- reply(Reply, Rows).

converse(Said, Reply) :-
    finite(Said),
    say(Said),
    flush_output,
    hear(Reply).

reply(rows(Rows), Rows).
reply(fault(Error), _) :- throw(Error).
reply(end_of_file, _) :- halt.

% stream(+Request, -Row): the rows of a request one by one, fetched as they are needed.
stream(Request, Row) :-
    converse(need(Request), Reply),
    chunk(Reply, Row).

chunk(fault(Error), _) :- throw(Error).
chunk(rows(Rows), Row) :- member(Row, Rows).
chunk(chunk(Cursor, Rows), Row) :-
    ( member(Row, Rows)
    ; converse(need(more(Cursor)), Reply),
      chunk(Reply, Row)
    ).

% ensure(+Request): fetches the facts of a request unless they are here.
ensure(Request) :- loaded(Request), !.
ensure(Request) :-
    fetch(Request),
    ( loaded(Request) -> true ; assertz(loaded(Request)) ).

% fetch(+Request): fetches the facts of a request, chunk by chunk.
fetch(Request) :- converse(need(Request), Reply), take(Reply).

take(rows(Facts)) :- !, store(Facts).
take(chunk(Cursor, Facts)) :- !, store(Facts), fetch(more(Cursor)).
take(Other) :- reply(Other, _).

store([]).
store([Fact|Facts]) :- assertz(Fact), store(Facts).

forget_facts :-
    retractall(i(_, _, _, _, _, _)),
    retractall(k(_, _)),
    retractall(v(_, _, _)),
    retractall(r(_, _, _)),
    retractall(c(_, _)),
    retractall(f(_, _)),
    retractall(loaded(_)),
    retractall(resolved(_, _)),
    retractall(closure(_, _, _)).
