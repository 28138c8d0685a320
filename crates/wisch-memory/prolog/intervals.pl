% Time: when things were, and how intervals lie to each other. Times are seconds since 1970.

event_interval(Event, Start, End) :- thing(Event, E), timed(E, Start, End).

timed(E, Start, End) :- nonvar(E), !, individual(E, _, Start, End, _, _), Start \== none.
timed(E, Start, End) :- nonvar(Start), nonvar(End), !, number(Start), number(End), stream(at(Start, End), E).
timed(E, Start, End) :- stream(individuals, i(E, _, Start, End, _, _)), Start \== none.

% occurs(?Event, [?Start, ?End])
occurs(Event, [Start, End]) :- event_interval(Event, Start, End).
occurs(Event) :- event_interval(Event, _, _).

has_time_interval(Event, [Start, End]) :- event_interval(Event, Start, End).

% during(:Statement, ?[Start, End]): of an event, that it happens within these times, which are its own where
% they are not given; of a pose, that it is so from the first to the last; of others, that they hold.
during(Statement, Interval) :- event_of(Statement, Event), !, when(Event, Interval, S, E), thing(Event, X), within(X, S, E).
during(is_at(O, P), Interval) :- !, times(Interval, S, E), is_at_time(O, S, P), is_at_time(O, E, Q), near(P, Q).
during(run(Goal), Interval) :- !, ( var(Goal) -> throw(error(instantiation_error, during)) ; during(Goal, Interval) ).
during(Goal, Interval) :- times(Interval, _, _), run(Goal).

since(Statement, Time) :- event_of(Statement, Event), !, event_interval(Event, S, _), ( var(Time) -> Time = S ; number(Time), S >= Time ).
since(is_at(O, P), Time) :- !, is_at_time(O, Time, P).
since(Goal, Time) :- number(Time), run(Goal).

until(Statement, Time) :- event_of(Statement, Event), !, event_interval(Event, _, E), ( var(Time) -> Time = E ; number(Time), E =< Time ).
until(is_at(O, P), Time) :- !, is_at_time(O, Time, P).
until(Goal, Time) :- number(Time), run(Goal).

event_of(occurs(E), E).
event_of(is_event(E), E).

times([S, E], S, E) :- number(S), number(E).

when(_, Interval, S, E) :- var(Interval), !, Interval = [S, E].
when(_, [S, E], S, E).

within(X, S, E) :- number(S), number(E), !, ( nonvar(X) -> timed(X, S0, E0), S0 >= S, E0 =< E ; stream(relation(during_or_equal, S, E), j(X, _, _)) ).
within(X, S, E) :- timed(X, S, E).

near([F, [X1, Y1, Z1], _], [F, [X2, Y2, Z2], _]) :- (X1-X2)*(X1-X2) + (Y1-Y2)*(Y1-Y2) + (Z1-Z2)*(Z1-Z2) =< 1.0e-6.

% The relations of Allen. Either side is an event, or [Start, End]; where one is not known, the program finds it.
interval_before(A, B) :- related(before, A, B).
interval_after(A, B) :- related(after, A, B).
interval_meets(A, B) :- related(meets, A, B).
interval_met_by(A, B) :- related(met_by, A, B).
interval_overlaps(A, B) :- related(overlaps, A, B).
interval_overlapped_by(A, B) :- related(overlapped_by, A, B).
interval_starts(A, B) :- related(starts, A, B).
interval_started_by(A, B) :- related(started_by, A, B).
interval_finishes(A, B) :- related(finishes, A, B).
interval_finished_by(A, B) :- related(finished_by, A, B).
interval_during(A, B) :- related(during, A, B).
interval_contains(A, B) :- related(contains, A, B).
interval_equals(A, B) :- related(equals, A, B).
% They have a time in common: in KnowRob's words, they are not disjoint.
interval_intersects(A, B) :- related(intersects, A, B).

related(Relation, A, B) :-
    side(A, A1),
    side(B, B1),
    ( A1 = unknown, B1 = unknown -> stream(pairs(Relation), A-B)
    ; A1 = unknown -> B1 = at(S, E), inverse(Relation, Inverse), found(Inverse, S, E, A)
    ; B1 = unknown -> A1 = at(S, E), found(Relation, S, E, B)
    ; A1 = at(S1, E1), B1 = at(S2, E2), allen(Relation, S1, E1, S2, E2)
    ),
    not_same(A, B).

side(X, unknown) :- var(X), !.
side([S, E], at(S, E)) :- number(S), number(E), !.
side(X, at(S, E)) :- thing(X, Name), timed(Name, S, E).

not_same(A, B) :- ( A == B -> fail ; true ).

% found(+Relation, +S, +E, -B): [S, E] stands in this relation to B.
found(Relation, S, E, B) :- inverse(Relation, Inverse), stream(relation(Inverse, S, E), j(B, _, _)).

inverse(before, after).
inverse(after, before).
inverse(meets, met_by).
inverse(met_by, meets).
inverse(overlaps, overlapped_by).
inverse(overlapped_by, overlaps).
inverse(starts, started_by).
inverse(started_by, starts).
inverse(finishes, finished_by).
inverse(finished_by, finishes).
inverse(during, contains).
inverse(contains, during).
inverse(equals, equals).
inverse(intersects, intersects).

allen(before, _, E1, S2, _) :- E1 < S2.
allen(after, S1, _, _, E2) :- S1 > E2.
allen(meets, _, E1, S2, _) :- E1 =:= S2.
allen(met_by, S1, _, _, E2) :- S1 =:= E2.
allen(overlaps, S1, E1, S2, E2) :- S1 < S2, E1 > S2, E1 < E2.
allen(overlapped_by, S1, E1, S2, E2) :- S2 < S1, E2 > S1, E2 < E1.
allen(starts, S1, E1, S2, E2) :- S1 =:= S2, E1 < E2.
allen(started_by, S1, E1, S2, E2) :- S1 =:= S2, E1 > E2.
allen(finishes, S1, E1, S2, E2) :- E1 =:= E2, S1 > S2.
allen(finished_by, S1, E1, S2, E2) :- E1 =:= E2, S1 < S2.
allen(during, S1, E1, S2, E2) :- S1 > S2, E1 < E2.
allen(contains, S1, E1, S2, E2) :- S1 < S2, E1 > E2.
allen(equals, S1, E1, S2, E2) :- S1 =:= S2, E1 =:= E2.
allen(intersects, S1, E1, S2, E2) :- S1 =< E2, S2 =< E1.
