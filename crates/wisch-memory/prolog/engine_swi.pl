% What differs between Prolog systems, for SWI-Prolog.

:- set_prolog_flag(double_quotes, chars).
:- style_check(-singleton).

open_host :-
    set_stream(user_input, alias(host)),
    set_stream(user_input, encoding(utf8)),
    set_stream(user_output, encoding(utf8)).

parse_query(Chars, Goal, Names) :-
    append(Chars, " .", Terminated),
    atom_chars(Text, Terminated),
    open_string(Text, Stream),
    call_cleanup(read_query(Stream, Goal, Names), close(Stream)).

read_query(Stream, Goal, Names) :-
    read_term(Stream, Goal, [variable_names(Names)]),
    ( Goal == end_of_file -> throw(error(syntax_error(end_of_file), none)) ; true ),
    read_term(Stream, Rest, []),
    ( Rest == end_of_file -> true ; throw(error(syntax_error(end_of_clause_expected), none)) ).

counter_set(N) :- nb_setval(wisch_counter, N).
counter_get(N) :- nb_getval(wisch_counter, N).

list_max(L, M) :- max_list(L, M).
list_min(L, M) :- min_list(L, M).
