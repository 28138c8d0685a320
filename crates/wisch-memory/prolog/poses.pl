% Poses of things: [Frame, [X, Y, Z], [Qx, Qy, Qz, Qw]], computed from stored joints. Requests at a time are answered by
% episode, because simultaneous runs overlap.

is_at_time(O, Time, Pose) :- given(Time, 'the time of a pose'), known(thing, O, Name), need(pose(Name, Time), Found), member(_-Pose, Found).

% Without a time, the last known pose.
is_at(O, Pose) :- known(thing, O, Name), need(last_pose(Name), [Found]), Pose = Found.

mng_lookup_position(O, Frame, Time, [P, Q]) :- is_at_time(O, Time, [Frame, P, Q]).

tf(O, Pose) :- is_at(O, Pose).
tf(O, Time, P, Q) :- is_at_time(O, Time, [_, P, Q]).

% object_trajectory(+O, +When, +dt(D), -Trajectory): a list of Time-Pose; or num_samples(N).
object_trajectory(O, When, Sampling, Trajectory) :- object_trajectory_in(_, O, When, Sampling, Trajectory).

object_trajectory_in(Episode, O, When, Sampling, Trajectory) :-
    during_what(Episode, When, S, E, Of),
    known(thing, O, Name),
    need(trajectory(Name, S, E, Sampling, Of), Found),
    episode_and(Episode, Trajectory, Found).

tf_mng_trajectory(O, S, E, Trajectory) :- object_trajectory(O, [S, E], dt(0.1), Trajectory).

% telemetry(+Channel, +When, +Statistic, -Value): Channel is force, vertical_force, speed, a joint or a column of the
% telemetry; Statistic is max, min, mean or rms.
telemetry(Channel, When, Statistic, Value) :- telemetry_in(_, Channel, When, Statistic, Value).

telemetry_in(Episode, Channel, When, Statistic, Value) :-
    ( var(Channel) -> unknown_yet('the channel of telemetry') ; var(Statistic) -> unknown_yet('the statistic of telemetry') ; true ),
    during_what(Episode, When, S, E, Of),
    need(telemetry(Channel, S, E, Statistic, Of), Found),
    episode_and(Episode, Value, Found).

% during_what(?Episode, +When, -S, -E, -Of): When is [S, E] or an event; Of is something of the only episode that is
% meant, or any.
during_what(_, When, _, _, _) :- var(When), !, unknown_yet('when: an event or [S, E]').
during_what(Episode, [S, E], S, E, Of) :- !, given(S, 'the start of [S, E]'), given(E, 'the end of [S, E]'), forward(S, E), ( var(Episode) -> Of = any ; known(thing, Episode, Of) ).
during_what(_, Event, S, E, Name) :- known(thing, Event, Name), lasts(event(Name), S, E).

episode_and(Episode, Answer, Found) :-
    thing(Episode, Name),
    member(Name-Answer0, Found),
    Answer = Answer0.
