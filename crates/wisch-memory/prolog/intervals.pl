% Times of events, and relations between intervals. Times are seconds since 1970.

event_interval(Event, Start, End) :- thing(Event, E), timed(E, Start, End).

timed(E, Start, End) :- nonvar(E), !, individual(E, _, S, T, _, _), S \== none, same_time(Start, S), same_time(End, T).
timed(E, Start, End) :- nonvar(Start), nonvar(End), !, number(Start), number(End), stream(at(Start, End), E).
timed(E, Start, End) :- stream(individuals, i(E, _, S, T, _, _)), S \== none, same_time(Start, S), same_time(End, T).

% A time in a query need not have the stored form: 1 equals 1.0.
same_time(Time, T) :- ( number(Time) -> Time =:= T ; Time = T ).

% occurs(?Event, [?Start, ?End])
occurs(Event, [Start, End]) :- event_interval(Event, Start, End).
occurs(Event) :- event_interval(Event, _, _).

has_time_interval(Event, [Start, End]) :- event_interval(Event, Start, End).

% Allen's relations (1983). Either side is an event, or [Start, End]; if one side is unknown, the program finds it.
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
% Both have a time in common: in KnowRob's words, they are not disjoint.
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
side([S, E], at(S, E)) :- number(S), number(E), !, forward(S, E).
side([S, E], _) :- ( var(S) ; var(E) ), !, unknown_yet('each of the two times of an interval').
side(X, at(S, E)) :- thing(X, Name), timed(Name, S, E).

not_same(A, B) :- ( A == B -> fail ; true ).

% found(+Relation, +S, +E, -B): [S, E] has this relation to B.
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
