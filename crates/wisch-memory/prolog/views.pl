% Views, which the program draws. An unknown name is an error before anything is drawn.

show :- view(show).
show(What) :- shown(What, Shown), view(show(Shown)).
show(What, How) :- shown(What, Shown), ( how(How) -> view(show(Shown, How)) ; throw(error(domain_error(time_or_interval, How), show)) ).
show(What, How, Style) :- shown(What, Shown), ( how(How) -> view(show(Shown, How, Style)) ; throw(error(domain_error(time_or_interval, How), show)) ).

how(Time) :- number(Time).
how(interval(S, E)) :- number(S), number(E), forward(S, E).
how(interval(S, E, dt(D))) :- number(S), number(E), forward(S, E), number(D), D > 0.
how([S, E]) :- number(S), number(E), forward(S, E).

shown(What, _) :- var(What), !, unknown_yet('the thing to show').
shown(trajectory(O), trajectory(Name)) :- !, known(thing, O, Name).
shown(particles(O), particles(Name)) :- !, known(thing, O, Name).
shown([], []) :- !.
shown([X|Xs], [Y|Ys]) :- !, shown(X, Y), shown(Xs, Ys).
shown(O, Name) :- known(thing, O, Name).

highlight(What) :- shown(What, Shown), view(highlight(Shown)).
highlight(What, Color) :- shown(What, Shown), view(highlight(Shown, Color)).
highlight_trajectory(O, S, E, Color) :- given(S, 'the start of the trajectory'), given(E, 'the end of the trajectory'), forward(S, E), shown(O, Shown), view(highlight(trajectory(Shown), interval(S, E), Color)).
marker_highlight(O, Color) :- highlight(O, Color).

% data_vis(+Diagram(Id), +Properties): Properties is a list such as data: [Xs, Ys], title: T, xlabel: X, ylabel: Y.
data_vis(Diagram, Properties) :-
    ( nonvar(Diagram), Diagram =.. [Kind, _], member(Kind, [piechart, barchart, timeline, linechart, scatter]) -> true
    ; throw(error(domain_error(diagram, Diagram), data_vis))
    ),
    ( is_list(Properties) -> true ; throw(error(type_error(list, Properties), data_vis)) ),
    view(data_vis(Diagram, Properties)).

% wear_chart(+Tool): stiffness of a tool, episode by episode.
wear_chart(Tool) :-
    known(thing, Tool, Name),
    need(series(wear, Name), Points),
    ( Points == [] -> throw(telemetry('no episode with this tool states its stiffness')) ; true ),
    numbered(Points, 1, Episodes, Values),
    data_vis(linechart(wear), [data: [Episodes, Values], title: Name, xlabel: episode, ylabel: 'stiffness [N/m]']).

numbered([], _, [], []).
numbered([_-Value|Points], N, [N|Ns], [Value|Values]) :- M is N + 1, numbered(Points, M, Ns, Values).

% local_time(+Time, -Text)
local_time(Time, Text) :- given(Time, 'the time of local_time'), need(local_time(Time), [Text]).

view(Command) :- finite(Command), ( ground(Command) -> say(view(Command)) ; throw(error(instantiation_error, Command)) ).
