% What differs between Prolog systems, for Scryer Prolog.

:- use_module(library(between)).
:- use_module(library(charsio)).
:- use_module(library(iso_ext)).
:- use_module(library(lists)).

open_host :- open('/dev/stdin', read, _, [alias(host)]).

parse_query(Chars, Goal, Names) :-
    append(Chars, " .", Terminated),
    read_term_from_chars(Terminated, Goal, [variable_names(Names)]).

counter_set(N) :- bb_put(wisch_counter, N).
counter_get(N) :- bb_get(wisch_counter, N).

atom_number(A, N) :-
    atom(A),
    atom_chars(A, Cs),
    catch(number_chars(N, Cs), _, fail).

is_list(L) :- nonvar(L), ( L == [] -> true ; L = [_|T], is_list(T) ).

ignore(G) :- ( call(G) -> true ; true ).
