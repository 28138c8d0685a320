% Predicates that differ between Prolog systems, for Scryer Prolog.

:- use_module(library(between)).
:- use_module(library(charsio)).
:- use_module(library(iso_ext)).
:- use_module(library(lists)).
:- use_module(library(pairs)).

open_host :- open('/dev/stdin', read, _, [alias(host)]).

hear(Term) :- read_term(host, Term, []).

parse_query(Chars, Goal, Names) :- read_term_from_chars(Chars, Goal, [variable_names(Names)]).

% This system writes ... for a cyclic term, which the program recognises. Its acyclic_term/1 fails on strings.
finite(_).

counter_set(N) :- bb_put(wisch_counter, N).
counter_get(N) :- bb_get(wisch_counter, N).

atom_number(A, N) :-
    atom(A),
    atom_chars(A, Cs),
    catch(number_chars(N, Cs), _, fail).

is_list(L) :- nonvar(L), ( L == [] -> true ; L = [_|T], is_list(T) ).

ignore(G) :- ( call(G) -> true ; true ).

not(G) :- \+ call(G).

plus(A, B, C) :- nonvar(A), nonvar(B), !, C is A + B.
plus(A, B, C) :- nonvar(A), !, B is C - A.
plus(A, B, C) :- A is C - B.

last([X|Xs], Last) :- last_of(Xs, X, Last).

last_of([], X, X).
last_of([X|Xs], _, Last) :- last_of(Xs, X, Last).

delete([], _, []).
delete([X|Xs], Y, Zs) :- X \= Y, !, Zs = [X|Rest], delete(Xs, Y, Rest).
delete([_|Xs], Y, Zs) :- delete(Xs, Y, Zs).

subtract([], _, []).
subtract([X|Xs], Ys, Zs) :- memberchk(X, Ys), !, subtract(Xs, Ys, Zs).
subtract([X|Xs], Ys, [X|Zs]) :- subtract(Xs, Ys, Zs).

intersection([], _, []).
intersection([X|Xs], Ys, Zs) :- memberchk(X, Ys), !, Zs = [X|Rest], intersection(Xs, Ys, Rest).
intersection([_|Xs], Ys, Zs) :- intersection(Xs, Ys, Zs).

union([], Ys, Ys).
union([X|Xs], Ys, Zs) :- memberchk(X, Ys), !, union(Xs, Ys, Zs).
union([X|Xs], Ys, [X|Zs]) :- union(Xs, Ys, Zs).

flatten(List, Flat) :- flat(List, [], Flat).

flat(X, Rest, [X|Rest]) :- var(X), !.
flat([], Rest, Rest) :- !.
flat([X|Xs], Rest, Flat) :- !, flat(Xs, Rest, Flat1), flat(X, Flat1, Flat).
flat(X, Rest, [X|Rest]).

msort(List, Sorted) :- keyed_by_itself(List, Pairs), keysort(Pairs, Ordered), pairs_values(Ordered, Sorted).

keyed_by_itself([], []).
keyed_by_itself([X|Xs], [X-X|Pairs]) :- keyed_by_itself(Xs, Pairs).

include(_, [], []).
include(G, [X|Xs], Ys) :- ( call(G, X) -> Ys = [X|Rest] ; Ys = Rest ), include(G, Xs, Rest).

exclude(_, [], []).
exclude(G, [X|Xs], Ys) :- ( call(G, X) -> Ys = Rest ; Ys = [X|Rest] ), exclude(G, Xs, Rest).

partition(_, [], [], []).
partition(G, [X|Xs], Ys, Zs) :-
    ( call(G, X) -> Ys = [X|Ys1], Zs = Zs1 ; Ys = Ys1, Zs = [X|Zs1] ),
    partition(G, Xs, Ys1, Zs1).

sumlist(L, Sum) :- sum_list(L, Sum).
max_list(L, Max) :- list_max(L, Max).
min_list(L, Min) :- list_min(L, Min).

atomic_list_concat(Parts, Atom) :- texts(Parts, Texts), append(Texts, Chars), atom_chars(Atom, Chars).

% Joins parts with a separator; if the parts are unknown, splits at it.
atomic_list_concat(Parts, Separator, Atom) :-
    ground(Parts),
    is_list(Parts),
    !,
    atom_chars(Separator, Between),
    texts(Parts, Texts),
    joined(Texts, Between, Chars),
    atom_chars(Atom, Chars).
atomic_list_concat(Parts, Separator, Atom) :-
    atom(Separator),
    Separator \== '',
    atomic(Atom),
    !,
    atom_chars(Separator, Between),
    text(Atom, Chars),
    split(Chars, Between, Parts).
atomic_list_concat(Parts, Separator, Atom) :-
    throw(error(instantiation_error, atomic_list_concat(Parts, Separator, Atom))).

texts([], []).
texts([X|Xs], [Cs|Css]) :- text(X, Cs), texts(Xs, Css).

text(X, Cs) :- number(X), !, number_chars(X, Cs).
text(X, Cs) :- atom_chars(X, Cs).

joined([], _, []).
joined([Cs|Css], Between, Chars) :- joined_after(Css, Between, Rest), append(Cs, Rest, Chars).

joined_after([], _, []).
joined_after([Cs|Css], Between, Chars) :-
    joined_after(Css, Between, Rest),
    append(Cs, Rest, Chars0),
    append(Between, Chars0, Chars).

split(Chars, Between, [Part|Parts]) :-
    ( append(Before, Rest, Chars), append(Between, After, Rest) ->
        atom_chars(Part, Before),
        split(After, Between, Parts)
    ; atom_chars(Part, Chars),
      Parts = []
    ).
