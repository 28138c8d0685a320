% Frequent questions about wiping, each as a predicate.

% Performance ----------------------------------------------------------------------------------------------

low_performance(Action, Performance) :-
    has_data_value(Action, performance =< 0.8),
    value_of(Action, 'semco:performance', Performance),
    Performance =< 0.8.

low_performance_round(Round, Performance) :-
    has_data_value(Round, performance =< 0.8),
    of_class(Round, 'semco:WipingRound'),
    value_of(Round, 'semco:performance', Performance),
    Performance =< 0.8.

final_performance(Episode, Performance) :-
    wiping_of(Episode, Action),
    value_of(Action, 'semco:performance', Performance).

goal_met(Action) :- of_class(Action, 'semco:WipingAction'), action_succeeded(Action).
goal_missed(Action, Performance) :-
    of_class(Action, 'semco:WipingAction'),
    action_failed(Action),
    value_of(Action, 'semco:performance', Performance).

rounds_needed(Action, Rounds) :-
    of_class(Action, 'semco:WipingAction'),
    aggregate_all(count, round_of(Action, _, _), Rounds).

wiping_time(Action, Seconds) :-
    of_class(Action, 'semco:WipingAction'),
    timed(Action, S, E),
    Seconds is E - S.

performance_by_round(Action, Number, Performance) :-
    of_class(Action, 'semco:WipingAction'),
    round_of(Action, Number, Round),
    value_of(Round, 'semco:performance', Performance).

prediction_error(Round, Error) :-
    of_class(Round, 'semco:WipingRound'),
    value_of(Round, 'semco:predictedPerformance', P),
    value_of(Round, 'semco:performance', E),
    Error is P - E.

overconfident_prediction(Round, Error) :- prediction_error(Round, Error), Error > 0.1.

uncertain_estimate(Round, Width) :-
    of_class(Round, 'semco:WipingRound'),
    value_of(Round, 'semco:performanceLow', L),
    value_of(Round, 'semco:performanceHigh', H),
    Width is H - L,
    Width > 0.2.

estimate_missed_truth(Round, Estimated, True) :-
    of_class(Round, 'semco:WipingRound'),
    value_of(Round, 'semco:simulatedPerformance', True),
    value_of(Round, 'semco:performance', Estimated),
    value_of(Round, 'semco:performanceLow', L),
    value_of(Round, 'semco:performanceHigh', H),
    ( True < L ; True > H ).

% Pushes and their consequences ----------------------------------------------------------------------------

human_collision(Motion, Collision, [S, E]) :-
    of_class(Collision, 'semco:HumanCollision'),
    timed(Collision, S, E),
    part(Motion, Collision).

human_collision_in(Episode, Motion, Collision, [S, E]) :-
    episode(Episode, Name),
    part_below(Name, Collision, 'semco:HumanCollision'),
    timed(Collision, S, E),
    part(Motion, Collision).

collisions_of(Episode, Count) :-
    of_class(Episode, 'semco:WipingEpisode'),
    aggregate_all(count, part_below(Episode, _, 'semco:Collision'), Count).

peak_force_per_collision(Collision, Force) :-
    of_class(Collision, 'semco:Collision'),
    value_of(Collision, 'semco:peakForce', Force).

hardest_collision(Collision, Force) :-
    aggregate_all(max(F, C), peak_force_per_collision(C, F), max(Force, Collision)).

interrupted_stroke(Stroke, Collision) :-
    of_class(Collision, 'semco:Collision'),
    part(Stroke, Collision),
    of_class(Stroke, 'semco:Stroke').

pushed_then_recovered(Action, Collisions) :-
    of_class(Action, 'semco:WipingAction'),
    action_succeeded(Action),
    aggregate_all(count, part_below(Action, _, 'semco:Collision'), Collisions),
    Collisions > 0.

protective_stop(Stop, Time, Round) :-
    of_class(Stop, 'semco:ProtectiveStop'),
    timed(Stop, Time, _),
    above(Stop, Round, 'semco:WipingRound').

% Contact --------------------------------------------------------------------------------------------------

contact_share(Round, Share) :- of_class(Round, 'semco:WipingRound'), value_of(Round, 'semco:contactShare', Share).

poor_contact(Round, Share) :- contact_share(Round, Share), Share < 0.8.

contact_loss_near_edge(Loss, Distance) :-
    of_class(Loss, 'semco:ContactLoss'),
    value_of(Loss, 'semco:edgeDistance', Distance),
    Distance =< 0.03.

mean_force_per_stroke(Stroke, Force) :-
    of_class(Stroke, 'semco:Stroke'),
    value_of(Stroke, 'semco:meanNormalForce', Outward),
    Force is -Outward.

weak_stroke(Stroke, Force) :- mean_force_per_stroke(Stroke, Force), Force < 8.0.

stroke_without_contact(Stroke) :-
    of_class(Stroke, 'semco:Stroke'),
    value_of(Stroke, 'semco:contactShare', Share),
    Share =< 0.01.

longest_contact(Episode, Contact, Seconds) :-
    of_class(Episode, 'semco:WipingEpisode'),
    aggregate_all(max(E - S, C), (part_below(Episode, C, 'semco:ToolContact'), timed(C, S, E)), max(Seconds, Contact)).

contact_time(Round, Seconds) :-
    of_class(Round, 'semco:WipingRound'),
    aggregate_all(sum(E - S), (part_below(Round, C, 'semco:ToolContact'), timed(C, S, E)), Seconds),
    (   Seconds > 0
    ->  true
    ;   contact_share(Round, _)
    ).

stick_slip(Stroke, Event) :-
    of_class(Event, 'semco:StickSlip'),
    part(Stroke, Event),
    of_class(Stroke, 'semco:Stroke').

landing(Motion, Event, Force) :- felt_in(Motion, Event, 'semco:Landing', Force).

overload(Motion, Event, Force) :- felt_in(Motion, Event, 'semco:Overload', Force).

vibration(Motion, Event, Force) :- felt_in(Motion, Event, 'semco:Vibration', Force).

hand_guiding(Motion, Event, Force) :- felt_in(Motion, Event, 'semco:HandGuiding', Force).

felt_in(Motion, Event, Class, Force) :-
    of_class(Event, Class),
    part(Motion, Event),
    value_of(Event, 'semco:peakForce', Force).

% Recovery and localisation --------------------------------------------------------------------------------

recovery_that_worked(Action, Round, Before, After) :-
    of_class(Action, 'semco:WipingAction'),
    value_of(Action, 'semco:target', Target),
    round_of(Action, Number, Round),
    Number > 1,
    value_of(Round, 'semco:performance', After),
    After >= Target,
    Last is Number - 1,
    round_of(Action, Last, Previous),
    value_of(Previous, 'semco:performance', Before),
    Before < Target.

recovery_gain(Round, Gain) :-
    of_class(Action, 'semco:WipingAction'),
    round_of(Action, Number, Round),
    Number > 1,
    Last is Number - 1,
    round_of(Action, Last, Previous),
    value_of(Previous, 'semco:performance', Before),
    value_of(Round, 'semco:performance', After),
    Gain is After - Before.

round_without_progress(Round) :- recovery_gain(Round, Gain), Gain =< 0.005.

relocalized(Round, Tilt, Offset) :-
    of_class(Round, 'semco:WipingRound'),
    value(Round, 'semco:diagnosis', relocalize),
    value_of(Round, 'semco:planeTilt', Tilt),
    value_of(Round, 'semco:planeOffset', Offset).

tilted_surface(Round, Tilt) :-
    of_class(Round, 'semco:WipingRound'),
    value_of(Round, 'semco:planeTilt', Tilt),
    Tilt > 0.0174.

% warning(-Episode, -Channel, -Time, -P): warnings of the memory during an episode.
warning(Episode, Channel, Time, P) :-
    of_class(Warning, 'semco:MemoryWarning'),
    timed(Warning, T, _),
    same_time(Time, T),
    value(Warning, 'semco:warningChannel', Channel),
    value_of(Warning, 'semco:pValue', P),
    episode_of(Warning, Episode).

% Goals of several parts ------------------------------------------------------------------------------------

% goal_step(-Goal, -Number, -Step, -Expected, -Taken): steps of a goal, with expected and actual time [s].
goal_step(Goal, Number, Step, Expected, Taken) :-
    of_class(Goal, 'semco:GoalAction'),
    part(Goal, Step),
    value_of(Step, 'semco:step', N),
    Number is truncate(N),
    value_of(Step, 'semco:expectedTime', Expected),
    value_of(Step, 'semco:takenTime', Taken).

costliest_step(Goal, Step, Taken) :-
    of_class(Goal, 'semco:GoalAction'),
    aggregate_all(max(T, S), goal_step(Goal, _, S, _, T), max(Taken, Step)).

% step_serves(-Step, -Part): parts of the goal, in PDDL, for which a step was taken.
step_serves(Step, Part) :-
    of_class(Step, 'semco:GoalStep'),
    relation(Step, 'semco:servesPart', P),
    value(P, 'semco:goal', Part).

% step_episode(-Step, -Episode): the episode of a wiping step, if the memory has it.
step_episode(Step, Episode) :-
    of_class(Step, 'semco:WipingStep'),
    value(Step, 'semco:stepEpisode', Id),
    atom_concat('semco:WipingEpisode_', Id, Head),
    atom_concat(Head, '-0', Name),
    catch(known(thing, Name, Found), unknown(_, _, _), fail),
    thing(Episode, Found).

% goal_part(-Goal, -Part, -State): parts of a goal, in PDDL, each with the state holds, open or unknown.
goal_part(Goal, Part, State) :-
    of_class(Goal, 'semco:GoalAction'),
    relation(Goal, 'semco:hasGoalPart', P),
    value(P, 'semco:goal', Part),
    value(P, 'semco:partState', State).

open_part(Goal, Part, Why) :-
    of_class(Goal, 'semco:GoalAction'),
    relation(Goal, 'semco:hasGoalPart', P),
    value(P, 'semco:openReason', Why),
    value(P, 'semco:goal', Part).

% Over many episodes ---------------------------------------------------------------------------------------

% drift(-Runs, -Channel, -PerRun, -P, -Left): drifts of the health report, in all episodes.
drift(Runs, Channel, PerRun, P, Left) :-
    need(health_drifts, Found),
    member(d(Runs, Channel, Slope, Chance, Remaining), Found),
    same_time(PerRun, Slope),
    same_time(P, Chance),
    ( Remaining == none -> Left = none ; same_time(Left, Remaining) ).

% contact_force_drift(-Surface, -Slope, -First, -Last): decrease of the mean contact force per episode on this surface
% [N], fitted over at least five episodes since its last sudden change; only significant decreases.
contact_force_drift(Surface, Slope, First, Last) :- drift_at_any_time(contact_force, Surface, d(Slope, First, Last)).

% localization_drift(-Surface, -Slope, -First, -Last): movement of the estimated surface plane per episode [m].
localization_drift(Surface, Slope, First, Last) :- drift_at_any_time(localization, Surface, d(Slope, First, Last)).

% tool_wear(-Tool, -Slope, -First, -Last): relative decrease of a tool's stiffness per episode, and its stiffness [N/m].
tool_wear(Tool, Slope, First, Last) :- drift_at_any_time(wear, Tool, d(Slope, First, Last)).

% localization_change(-Surface, -Time, -Before, -After): sudden change of the estimated surface plane at the episode
% that begins at Time.
localization_change(Surface, Time, Before, After) :-
    thing(Surface, Name),
    all_times(From, To),
    need(changes(localization, From, To), Found),
    member(c(Name, T, B, A), Found),
    same_time(Time, T),
    same_time(Before, B),
    same_time(After, A).

% drift_cause(-Surface, -Change, -Cause): change of the estimated surface from the first to the last episode [m], and the
% cause: a softer tool is compressed by force over stiffness.
drift_cause(Surface, Change, Cause) :- all_times(From, To), drift_cause_within(From, To, Surface, Change, Cause).

drift_cause_within(From, To, Surface, Change, Cause) :-
    thing(Surface, Name),
    need(causes(From, To), Found),
    member(s(Name, C, Cause), Found),
    same_time(Change, C).

% drift(?Statement, -Kind, -Thing, -D): statements about changes over episodes, which limits of time restrict.
drift(contact_force_drift(S, Slope, First, Last), contact_force, S, d(Slope, First, Last)).
drift(localization_drift(S, Slope, First, Last), localization, S, d(Slope, First, Last)).
drift(tool_wear(T, Slope, First, Last), wear, T, d(Slope, First, Last)).

drift_at_any_time(Kind, Thing, D) :- all_times(From, To), drift_within(Kind, From, To, Thing, D).

drift_within(Kind, From, To, Thing, d(Slope, First, Last)) :-
    thing(Thing, Name),
    need(drifts(Kind, From, To), Found),
    member(t(Name, S, F, L), Found),
    noticeable(Kind, F, L),
    same_time(Slope, S),
    same_time(First, F),
    same_time(Last, L).

noticeable(contact_force, First, Last) :- Last < 0.95 * First.
noticeable(localization, First, Last) :- abs(Last - First) > 0.002.
noticeable(wear, First, Last) :- Last < 0.9 * First.

all_times(-1.0e15, 1.0e15).

tool_performance(Tool, Medium, Mean, Count) :-
    thing(Tool, Tool1),
    thing(Medium, Medium1),
    mean_by(T-M, P, (of_class(A, 'semco:WipingAction'), relation(A, 'semco:usesTool', T), relation(A, 'semco:removesMedium', M), value_of(A, 'semco:performance', P)), Tool1-Medium1, Mean, Count).

strategy_performance(Strategy, Mean, Count) :-
    mean_by(S, P, (of_class(A, 'semco:WipingAction'), value(A, 'semco:strategy', S), value_of(A, 'semco:performance', P)), Strategy, Mean, Count).

surface_performance(Surface, Mean, Count) :-
    thing(Surface, Surface1),
    mean_by(S, P, (of_class(A, 'semco:WipingAction'), relation(A, 'semco:actsOnSurface', S), value_of(A, 'semco:performance', P)), Surface1, Mean, Count).

mean_by_key(All, Key, Mean, Count) :-
    keysort(All, Sorted),
    grouped(Sorted, Groups),
    member(Key-Ps, Groups),
    total(Ps, 0, Sum),
    length(Ps, Count),
    Mean is Sum / Count.

grouped([], []).
grouped([Key-V|Rest], [Key-[V|Vs]|Groups]) :- same_key(Rest, Key, Vs, Others), grouped(Others, Groups).

same_key([Key1-V|Rest], Key, [V|Vs], Others) :- Key1 == Key, !, same_key(Rest, Key, Vs, Others).
same_key(Others, _, [], Others).

episode_with_tool(Episode, Tool) :- in_role(Episode, 'semco:usesTool', Tool).
episode_on_surface(Episode, Surface) :- in_role(Episode, 'semco:actsOnSurface', Surface).

% in_role(-Episode, +Role, -Thing): things of this role in the wiping of an episode.
in_role(Episode, Role, Thing) :-
    thing(Thing, Name),
    of_class(Action, 'semco:WipingAction'),
    stated(Action, Role, Name),
    part(Episode, Action).

last_episode(Episode, Time) :-
    thing(Episode, Name),
    need(last_episode, [Name-T]),
    same_time(Time, T).

episode_of(Thing, Episode) :-
    known(thing, Thing, Name),
    above(Name, Episode, 'soma:Episode').

sure_failure(Action, High) :-
    of_class(Action, 'semco:WipingAction'),
    % An interval without a performance is a lower bound: the performance is unknown.
    value_of(Action, 'semco:performance', _),
    value_of(Action, 'semco:performanceHigh', High),
    value_of(Action, 'semco:target', Target),
    High < Target.

% Auxiliary predicates -----------------------------------------------------------------------------------

value_of(I, Property, Number) :- value(I, Property, Value), number(Value), same(Number, Value).

wiping_of(Episode, Action) :- of_class(Action, 'semco:WipingAction'), part(Episode, Action).

round_of(Action, Number, Round) :-
    part(Action, Round),
    of_class(Round, 'semco:WipingRound'),
    value_of(Round, 'semco:round', N),
    Number is truncate(N).

episode(Episode, Name) :- var(Episode), !, of_class(Episode, 'semco:WipingEpisode'), Name = Episode.
episode(Episode, Name) :- known(thing, Episode, Name).

% part_below(+Whole, -Part, +Class): parts at any depth.
part_below(Whole, Part, Class) :- part(Whole, Direct), ( of_class(Direct, Class), Part = Direct ; part_below(Direct, Part, Class) ).

above(Part, Whole, Class) :- part(Direct, Part), ( of_class(Direct, Class) -> Whole = Direct ; above(Direct, Whole, Class) ).
