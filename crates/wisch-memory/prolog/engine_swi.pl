% Predicates that differ between Prolog systems, for SWI-Prolog.

:- set_prolog_flag(double_quotes, chars).
:- style_check(-singleton).
:- use_module(library(process), [process_kill/2]).
:- use_module(library(occurs), [sub_term/2]).

open_host :-
    set_stream(user_input, alias(host)),
    set_stream(user_input, encoding(utf8)),
    set_stream(user_output, encoding(utf8)),
    catch(thread_create(end_with(user_input), _, [detached(true)]), _, true).

% end_with(+Stream): ends this process when the stream closes, even during a query: the program is gone then. It reads
% nothing, and does not lock the stream while it waits.
end_with(Name) :-
    stream_property(Stream, alias(Name)),
    repeat,
    wait_for_input([Stream], _, infinite),
    sleep(0.1),
    wait_for_input([Stream], Ready, 0.0),
    Ready \== [],
    peek_char(Stream, end_of_file),
    !,
    current_prolog_flag(pid, Itself),
    process_kill(Itself, kill).

% The other thread would take the rest of the line for unread input.
hear(Term) :- read_term(host, Term, []), skip(host, '\n').

parse_query(Chars, Goal, Names) :-
    atom_chars(Text, Chars),
    open_string(Text, Stream),
    call_cleanup(read_query(Stream, Goal, Names), close(Stream)).

read_query(Stream, Goal, Names) :-
    read_term(Stream, Goal, [variable_names(Names)]),
    % Only this system has dictionaries.
    ( sub_term(Part, Goal), is_dict(Part) -> throw(error(syntax_error(dictionary), none)) ; true ),
    ( Goal == end_of_file -> throw(error(syntax_error(end_of_file), none)) ; true ),
    read_term(Stream, Rest, []),
    ( Rest == end_of_file -> true ; throw(error(syntax_error(end_of_clause_expected), none)) ).

% finite(+Term): the term is acyclic, so that it can be written.
finite(Term) :- ( acyclic_term(Term) -> true ; throw(cyclic) ).

counter_set(N) :- nb_setval(wisch_counter, N).
counter_get(N) :- nb_getval(wisch_counter, N).

list_max(L, M) :- max_list(L, M).
list_min(L, M) :- min_list(L, M).
