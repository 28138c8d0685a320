% Where things were: poses are [Frame, [X, Y, Z], [Qx, Qy, Qz, Qw]], computed from the joints that are stored.

is_at_time(O, Time, Pose) :- number(Time), known(thing, O, Name), need(pose(Name, Time), [Found]), Pose = Found.

% Without a time, the last that is known.
is_at(O, Pose) :- known(thing, O, Name), need(last_pose(Name), [Found]), Pose = Found.

mng_lookup_position(O, Frame, Time, [P, Q]) :- number(Time), is_at_time(O, Time, [Frame, P, Q]).

tf(O, Pose) :- is_at(O, Pose).
tf(O, Time, P, Q) :- number(Time), is_at_time(O, Time, [_, P, Q]).

% object_trajectory(+O, +[S, E], +dt(D), -Trajectory): a list of Time-Pose; or num_samples(N).
object_trajectory(O, [S, E], Sampling, Trajectory) :-
    number(S),
    number(E),
    known(thing, O, Name),
    need(trajectory(Name, S, E, Sampling), Trajectory).

tf_mng_trajectory(O, S, E, Trajectory) :- object_trajectory(O, [S, E], dt(0.1), Trajectory).

% telemetry(+Channel, +[S, E], +Statistic, -Value): of force, vertical_force, speed, a joint or a column of the telemetry;
% the statistic is max, min, mean or rms.
telemetry(Channel, [S, E], Statistic, Value) :-
    number(S),
    number(E),
    need(telemetry(Channel, S, E, Statistic), [Found]),
    Value = Found.
