% Statements limited in time: during, since and until. A statement lasts as long as the event that it is about. A limit
% on a statement without an event is an error. Times are seconds since 1970.

% during(:Statement, ?[Start, End]): the event of the statement lies within these times. If they are unbound and the
% statement stands alone, they become the event's own times.
during(Statement, Interval) :- limited(Statement, [during(Interval)]).

% since(:Statement, ?Time), until(:Statement, ?Time): the event begins at Time or later; it ends at Time or earlier.
since(Statement, Time) :- limited(Statement, [since(Time)]).
until(Statement, Time) :- limited(Statement, [until(Time)]).

% limited(:Statement, +Limits): the statement holds, and each of its events meets all limits. Statements are guarded
% already.
limited(Statement, _) :- var(Statement), !, unknown_yet('the statement that is limited in time').
limited(run(Goal), Ls) :- !,
    ( var(Goal) -> unknown_yet('the statement that is limited in time') ; guarded(Goal, Guarded), limited(Guarded, Ls) ).
limited(joined(_, Guarded), Ls) :- !, limited(Guarded, Ls).
limited(during(Statement, Interval), Ls) :- !, limited(Statement, [during(Interval)|Ls]).
limited(since(Statement, Time), Ls) :- !, limited(Statement, [since(Time)|Ls]).
limited(until(Statement, Time), Ls) :- !, limited(Statement, [until(Time)|Ls]).
limited((A, B), Ls) :- !, known_limits(Ls), limited_part(A, Ls), limited_part(B, Ls).
limited((A -> B ; C), Ls) :- !, known_limits(Ls), ( limited_part(A, Ls) -> limited_part(B, Ls) ; limited_part(C, Ls) ).
limited((A ; B), Ls) :- !, known_limits(Ls), ( limited_part(A, Ls) ; limited_part(B, Ls) ).
limited((A -> B), Ls) :- !, known_limits(Ls), ( limited_part(A, Ls) -> limited_part(B, Ls) ).
limited(\+ A, Ls) :- !, known_limits(Ls), \+ limited(A, Ls).
limited(not(A), Ls) :- !, known_limits(Ls), \+ limited(A, Ls).
limited(forall(A, B), Ls) :- !, known_limits(Ls), \+ ( limited(A, Ls), \+ limited_part(B, Ls) ).
limited(once(A), Ls) :- !, once(limited(A, Ls)).
limited(ignore(A), Ls) :- !, ignore(limited(A, Ls)).
limited(call(A), Ls) :- !, limited(A, Ls).
limited(kb_call(A), Ls) :- !, limited(A, Ls).
limited(ask(A), Ls) :- !, limited(A, Ls).
limited(findall(T, A, L), Ls) :- !, known_limits(Ls), findall(T, limited(A, Ls), L).
limited(aggregate_all(K, A, R), Ls) :- !, known_limits(Ls), aggregate_all(K, limited(A, Ls), R).
% A pose holds from the first to the last time, or at a single time.
limited(tf(O, Pose), Ls) :- !, limited(is_at(O, Pose), Ls).
limited(is_at(O, Pose), [Limit]) :- !, known_limits([Limit]), pose_limited(Limit, O, Pose).
% The maximum is taken within the limits, not over all answers.
limited(hardest_collision(C, F), Ls) :- !,
    known_limits(Ls),
    aggregate_all(max(F0, C0), limited(peak_force_per_collision(C0, F0), Ls), max(F1, C1)),
    same(C, C1),
    same(F, F1).
limited(last_episode(Episode, Time), Ls) :- !,
    known_limits(Ls),
    aggregate_all(max(S0, E0-T0), limited_episode(E0, S0, T0, Ls), max(_, E1-T1)),
    same(Episode, E1),
    same(Time, T1).
limited(Drift, Ls) :- drift(Drift, Kind, Thing, D), !,
    known_limits(Ls),
    all_times(From0, To0),
    window(Ls, From0, To0, From, To),
    drift_within(Kind, From, To, Thing, D).
limited(drift_cause(Surface, Change, Cause), Ls) :- !,
    known_limits(Ls),
    all_times(From0, To0),
    window(Ls, From0, To0, From, To),
    drift_cause_within(From, To, Surface, Change, Cause).
limited(occurs(Event), [during([S, E])]) :- var(Event), number(S), number(E), !, forward(S, E), stream(relation(during_or_equal, S, E), j(Event, _, _)).
limited(Statement, Ls) :- has_time(Statement, Of), !,
    checked_limits(Ls),
    call(Statement),
    lasts(Of, S, E),
    kept(Ls, S, E).
limited(Statement, _) :- functor(Statement, Name, Arity), throw(no_time(Name, Arity)).

limited_episode(Episode, S, End, Ls) :- of_class(Episode, 'semco:WipingEpisode'), timed(Episode, S, End), kept(Ls, S, End).

pose_limited(during([S, E]), O, Pose) :-
    is_at_time(O, S, Pose),
    is_at_time(O, E, Last),
    near(Pose, Last),
    object_trajectory(O, [S, E], num_samples(100), Between),
    \+ ( member(_-P, Between), \+ near(Pose, P) ).
pose_limited(since(Time), O, Pose) :- is_at_time(O, Time, Pose).
pose_limited(until(Time), O, Pose) :- is_at_time(O, Time, Pose).

near([F, [X1, Y1, Z1], _], [F, [X2, Y2, Z2], _]) :- (X1-X2)*(X1-X2) + (Y1-Y2)*(Y1-Y2) + (Z1-Z2)*(Z1-Z2) =< 1.0e-6.

% Part of a conjunction: a goal that is not a statement, such as a comparison, holds at any time.
limited_part(Goal, Ls) :- ( callable(Goal), timeless(Goal) -> call(Goal) ; limited(Goal, Ls) ).

timeless(Goal) :- functor(Goal, Name, Arity), ( builtin(Name, Arity) -> true ; of_guard(Name, Arity) ), !.

of_guard(same, 2).
of_guard(alike, 2).
of_guard(bound_first, 2).
of_guard(printed, 2).
of_guard(formatted, 3).

% Limits ---------------------------------------------------------------------------------------------------

% known_limits(+Limits): all times are numbers, and the limits together do not end before they begin.
known_limits(Ls) :- all_known(Ls), window(Ls, -1.0e300, 1.0e300, From, To), forward(From, To).

all_known([]).
all_known([Limit|Ls]) :- ( is_known(Limit) -> true ; not_known(Limit) ), all_known(Ls).

% forward(+Start, +End): an interval that ends before it begins holds no time, so it is an error and no answer.
forward(Start, End) :- ( Start =< End -> true ; throw(backward(Start, End)) ).

% checked_limits(+Limits): the same, but the times of a single limit may be unbound.
checked_limits([Limit]) :- is_open(Limit), !.
checked_limits(Ls) :- known_limits(Ls).

is_known(during(I)) :- nonvar(I), I = [S, E], number(S), number(E).
is_known(since(T)) :- number(T).
is_known(until(T)) :- number(T).

is_open(during(I)) :- ( var(I) -> true ; I = [S, E], var(S), var(E) ).
is_open(since(T)) :- var(T).
is_open(until(T)) :- var(T).

not_known(during(I)) :- ( var(I) ; I = [S, E], ( var(S) ; var(E) ) ), !, unknown_yet('each of the two times of during').
not_known(during(I)) :- throw(error(domain_error(interval, I), during)).
not_known(since(T)) :- given(T, 'the time of since').
not_known(until(T)) :- given(T, 'the time of until').

% given(+Number, +What): checks that a number is bound; otherwise the error names What.
given(Number, _) :- number(Number), !.
given(Number, What) :- var(Number), !, unknown_yet(What).
given(Number, What) :- throw(error(type_error(number, Number), What)).

unknown_yet(What) :- throw(error(instantiation_error, unbound(What))).

kept([], _, _).
kept([Limit|Ls], S, E) :- keeps(Limit, S, E), kept(Ls, S, E).

keeps(during(I), S, E) :- ( is_known(during(I)) -> I = [From, To], S >= From, E =< To ; I = [S, E] ).
keeps(since(T), S, _) :- ( number(T) -> S >= T ; T = S ).
keeps(until(T), _, E) :- ( number(T) -> E =< T ; T = E ).

% window(+Limits, +From0, +To0, -From, -To): the interval that meets all limits.
window([], From, To, From, To).
window([during([S, E])|Ls], F0, T0, From, To) :- F1 is max(F0, S), T1 is min(T0, E), window(Ls, F1, T1, From, To).
window([since(T)|Ls], F0, T0, From, To) :- F1 is max(F0, T), window(Ls, F1, T0, From, To).
window([until(T)|Ls], F0, T0, From, To) :- T1 is min(T0, T), window(Ls, F0, T1, From, To).

% Duration of statements ---------------------------------------------------------------------------------------

% lasts(+Of, -Start, -End)
lasts(event(X), S, E) :- ( time_of(X, S0, E0) -> S = S0, E = E0 ; thing(X, Name), throw(untimed(Name)) ).
lasts(either(X, Y), S, E) :-
    ( time_of(X, S0, E0) -> S = S0, E = E0
    ; ( atom(Y) ; nonvar(Y), Y = _:_ ), catch(time_of(Y, S0, E0), unknown(_, _, _), fail) -> S = S0, E = E0
    ; thing(X, Name), throw(untimed(Name))
    ).
lasts(both(X, Y), S, E) :-
    lasts(event(X), S1, E1),
    lasts(event(Y), S2, E2),
    S is min(S1, S2),
    E is max(E1, E2).
lasts(at(T), T, T).
lasts(span(S, E), S, E).

time_of([S, E], S, E) :- !, number(S), number(E).
time_of(X, S, E) :- thing(X, Name), individual(Name, _, S, E, _, _), S \== none.

% has_time(?Statement, -Of): the subject of a statement, for statements about events.
has_time(instance_of(I, _), event(I)).
has_time(has_type(I, _), event(I)).
has_time(owl_individual_of(I, _), event(I)).
has_time(rdfs_individual_of(I, _), event(I)).
has_time(is_episode(I), event(I)).
has_time(is_action(I), event(I)).
has_time(is_process(I), event(I)).
has_time(is_event(I), event(I)).
has_time(is_state(I), event(I)).
has_time(is_task(I), event(I)).
has_time(triple(S, _, O), either(S, O)).
has_time(holds(S, _, O), either(S, O)).
has_time(owl_has(S, _, O), either(S, O)).
has_time(rdf_has(S, _, O), either(S, O)).
has_time(holds(Statement), either(S, O)) :- nonvar(Statement), Statement =.. [_, S, O].
has_time(has_data_value(I, _), event(I)).
has_time(has_subevent(Event, _), event(Event)).
has_time(subAction(Event, _), event(Event)).
has_time(has_participant(Event, _), event(Event)).
has_time(is_performed_by(Action, _), event(Action)).
has_time(executes_task(Action, _), event(Action)).
has_time(is_classified_by(Event, _), event(Event)).
has_time(action_status(Action, _), event(Action)).
has_time(action_succeeded(Action), event(Action)).
has_time(action_failed(Action), event(Action)).
has_time(occurs(Event), event(Event)).
has_time(occurs(Event, _), event(Event)).
has_time(event_interval(Event, _, _), event(Event)).
has_time(has_time_interval(Event, _), event(Event)).
has_time(interval_before(A, B), both(A, B)).
has_time(interval_after(A, B), both(A, B)).
has_time(interval_meets(A, B), both(A, B)).
has_time(interval_met_by(A, B), both(A, B)).
has_time(interval_overlaps(A, B), both(A, B)).
has_time(interval_overlapped_by(A, B), both(A, B)).
has_time(interval_starts(A, B), both(A, B)).
has_time(interval_started_by(A, B), both(A, B)).
has_time(interval_finishes(A, B), both(A, B)).
has_time(interval_finished_by(A, B), both(A, B)).
has_time(interval_during(A, B), both(A, B)).
has_time(interval_contains(A, B), both(A, B)).
has_time(interval_equals(A, B), both(A, B)).
has_time(interval_intersects(A, B), both(A, B)).
has_time(mng_lookup_position(_, _, T, _), at(T)).
has_time(tf(_, T, _, _), at(T)).
has_time(object_trajectory(_, When, _, _), event(When)).
has_time(object_trajectory_in(_, _, When, _, _), event(When)).
has_time(tf_mng_trajectory(_, S, E, _), span(S, E)).
has_time(telemetry(_, When, _, _), event(When)).
has_time(telemetry_in(_, _, When, _, _), event(When)).
has_time(low_performance(Action, _), event(Action)).
has_time(low_performance_round(Round, _), event(Round)).
has_time(final_performance(Episode, _), event(Episode)).
has_time(goal_met(Action), event(Action)).
has_time(goal_missed(Action, _), event(Action)).
has_time(rounds_needed(Action, _), event(Action)).
has_time(wiping_time(Action, _), event(Action)).
has_time(performance_by_round(Action, _, _), event(Action)).
has_time(prediction_error(Round, _), event(Round)).
has_time(overconfident_prediction(Round, _), event(Round)).
has_time(uncertain_estimate(Round, _), event(Round)).
has_time(estimate_missed_truth(Round, _, _), event(Round)).
has_time(human_collision(_, Collision, _), event(Collision)).
has_time(human_collision_in(_, _, Collision, _), event(Collision)).
has_time(collisions_of(Episode, _), event(Episode)).
has_time(peak_force_per_collision(Collision, _), event(Collision)).
has_time(interrupted_stroke(_, Collision), event(Collision)).
has_time(pushed_then_recovered(Action, _), event(Action)).
has_time(protective_stop(Stop, _, _), event(Stop)).
has_time(contact_share(Round, _), event(Round)).
has_time(poor_contact(Round, _), event(Round)).
has_time(contact_loss_near_edge(Loss, _), event(Loss)).
has_time(mean_force_per_stroke(Stroke, _), event(Stroke)).
has_time(weak_stroke(Stroke, _), event(Stroke)).
has_time(stroke_without_contact(Stroke), event(Stroke)).
has_time(longest_contact(Episode, _, _), event(Episode)).
has_time(contact_time(Round, _), event(Round)).
has_time(stick_slip(_, Event), event(Event)).
has_time(landing(_, Event, _), event(Event)).
has_time(overload(_, Event, _), event(Event)).
has_time(vibration(_, Event, _), event(Event)).
has_time(hand_guiding(_, Event, _), event(Event)).
has_time(recovery_that_worked(_, Round, _, _), event(Round)).
has_time(recovery_gain(Round, _), event(Round)).
has_time(round_without_progress(Round), event(Round)).
has_time(relocalized(Round, _, _), event(Round)).
has_time(tilted_surface(Round, _), event(Round)).
has_time(episode_with_tool(Episode, _), event(Episode)).
has_time(episode_on_surface(Episode, _), event(Episode)).
has_time(warning(_, _, T, _), at(T)).
has_time(goal_step(_, _, Step, _, _), event(Step)).
has_time(costliest_step(_, Step, _), event(Step)).
has_time(step_serves(Step, _), event(Step)).
has_time(step_episode(Step, _), event(Step)).
has_time(goal_part(Goal, _, _), event(Goal)).
has_time(open_part(Goal, _, _), event(Goal)).
has_time(localization_change(_, T, _, _), at(T)).
has_time(episode_of(Thing, _), event(Thing)).
has_time(sure_failure(Action, _), event(Action)).
