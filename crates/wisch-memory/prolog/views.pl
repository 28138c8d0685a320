% What is to be looked at: the program draws it. A name that is not known is an error before anything is drawn.

show :- view(show).
show(What) :- shown(What, Shown), view(show(Shown)).
show(What, How) :- shown(What, Shown), ( how(How) -> view(show(Shown, How)) ; throw(error(domain_error(time_or_interval, How), show)) ).
show(What, How, Style) :- shown(What, Shown), ( how(How) -> view(show(Shown, How, Style)) ; throw(error(domain_error(time_or_interval, How), show)) ).

how(Time) :- number(Time).
how(interval(S, E)) :- number(S), number(E).
how(interval(S, E, dt(D))) :- number(S), number(E), number(D), D > 0.
how([S, E]) :- number(S), number(E).

shown(What, _) :- var(What), !, throw(error(instantiation_error, show)).
shown(trajectory(O), trajectory(Name)) :- !, known(thing, O, Name).
shown(particles(O), particles(Name)) :- !, known(thing, O, Name).
shown([], []) :- !.
shown([X|Xs], [Y|Ys]) :- !, shown(X, Y), shown(Xs, Ys).
shown(O, Name) :- known(thing, O, Name).

highlight(What) :- shown(What, Shown), view(highlight(Shown)).
highlight(What, Color) :- shown(What, Shown), view(highlight(Shown, Color)).
highlight_trajectory(O, S, E, Color) :- number(S), number(E), shown(O, Shown), view(highlight(trajectory(Shown), interval(S, E), Color)).
marker_highlight(O, Color) :- highlight(O, Color).

% data_vis(+Diagram(Id), +Properties): Properties is a list of data: [Xs, Ys], title: T, xlabel: X, ylabel: Y.
data_vis(Diagram, Properties) :-
    ( nonvar(Diagram), Diagram =.. [Kind, _], member(Kind, [piechart, barchart, timeline, linechart, scatter]) -> true
    ; throw(error(domain_error(diagram, Diagram), data_vis))
    ),
    ( is_list(Properties) -> true ; throw(error(type_error(list, Properties), data_vis)) ),
    view(data_vis(Diagram, Properties)).

view(Command) :- finite(Command), ( ground(Command) -> say(view(Command)) ; throw(error(instantiation_error, Command)) ).
