% Predicates that a query may call, with their meaning. The program's list, completion and manual are generated from it.
predicate(instance_of, 2, 'instance_of(I, Class): I is an instance of Class or of a subclass').
predicate(has_type, 2, 'has_type(I, Class): the same as instance_of/2').
predicate(owl_individual_of, 2, 'owl_individual_of(I, Class): the same as instance_of/2').
predicate(rdfs_individual_of, 2, 'rdfs_individual_of(I, Class): the same as instance_of/2').
predicate(subclass_of, 2, 'subclass_of(Class, Super): Class is Super or a subclass of it').
predicate(rdfs_subclass_of, 2, 'rdfs_subclass_of(Class, Super): the same as subclass_of/2').
predicate(owl_subclass_of, 2, 'owl_subclass_of(Class, Super): the same as subclass_of/2').
predicate(is_episode, 1, 'is_episode(I): I is an episode').
predicate(is_action, 1, 'is_action(I): I is an action').
predicate(is_process, 1, 'is_process(I): I is a process').
predicate(is_event, 1, 'is_event(I): I is an event').
predicate(is_state, 1, 'is_state(I): I is a state').
predicate(is_task, 1, 'is_task(I): I is a task').
predicate(triple, 3, 'triple(S, P, O): S has the relation or value P with O; P may be transitive(P) or reflexive(P)').
predicate(holds, 3, 'holds(S, P, O): the same as triple/3').
predicate(holds, 1, 'holds(P(S, O)): the same as triple/3').
predicate(owl_has, 3, 'owl_has(S, P, O): the same as triple/3').
predicate(rdf_has, 3, 'rdf_has(S, P, O): the same as triple/3').
predicate(has_data_value, 2, 'has_data_value(I, performance =< 0.8): a value of I meets a condition').
predicate(has_subevent, 2, 'has_subevent(Event, Part): Part is a part of Event').
predicate(subAction, 2, 'subAction(Event, Part): the same as has_subevent/2').
predicate(has_participant, 2, 'has_participant(Event, Thing): Thing takes part in Event').
predicate(is_performed_by, 2, 'is_performed_by(Action, Agent): Agent performs Action').
predicate(executes_task, 2, 'executes_task(Action, Task): Action executes Task').
predicate(is_classified_by, 2, 'is_classified_by(Event, Concept): Concept classifies Event').
predicate(action_status, 2, 'action_status(Action, State): final state of Action').
predicate(action_succeeded, 1, 'action_succeeded(Action): Action met its goal').
predicate(action_failed, 1, 'action_failed(Action): Action did not meet its goal').
predicate(tell, 1, 'tell(holds(S, P, O)): stores a statement in this memory, if the whole query succeeds; P may be rdfs:label or rdfs:comment; tell(has_type(I, Class)) adds an individual').
predicate(occurs, 1, 'occurs(Event): Event has a time').
predicate(occurs, 2, 'occurs(Event, [S, E]): Event lasts from S to E [s since 1970]').
predicate(event_interval, 3, 'event_interval(Event, S, E): the same as occurs/2').
predicate(has_time_interval, 2, 'has_time_interval(Event, [S, E]): the same as occurs/2').
predicate(interval_before, 2, 'interval_before(A, B): Allen\'s relation; A and B are events or [S, E]').
predicate(interval_after, 2, 'interval_after(A, B): Allen\'s relation; A and B are events or [S, E]').
predicate(interval_meets, 2, 'interval_meets(A, B): Allen\'s relation; A and B are events or [S, E]').
predicate(interval_met_by, 2, 'interval_met_by(A, B): Allen\'s relation; A and B are events or [S, E]').
predicate(interval_overlaps, 2, 'interval_overlaps(A, B): Allen\'s relation; A and B are events or [S, E]').
predicate(interval_overlapped_by, 2, 'interval_overlapped_by(A, B): Allen\'s relation; A and B are events or [S, E]').
predicate(interval_starts, 2, 'interval_starts(A, B): Allen\'s relation; A and B are events or [S, E]').
predicate(interval_started_by, 2, 'interval_started_by(A, B): Allen\'s relation; A and B are events or [S, E]').
predicate(interval_finishes, 2, 'interval_finishes(A, B): Allen\'s relation; A and B are events or [S, E]').
predicate(interval_finished_by, 2, 'interval_finished_by(A, B): Allen\'s relation; A and B are events or [S, E]').
predicate(interval_during, 2, 'interval_during(A, B): Allen\'s relation; A and B are events or [S, E]').
predicate(interval_contains, 2, 'interval_contains(A, B): Allen\'s relation; A and B are events or [S, E]').
predicate(interval_equals, 2, 'interval_equals(A, B): Allen\'s relation; A and B are events or [S, E]').
predicate(interval_intersects, 2, 'interval_intersects(A, B): A and B have a time in common').
predicate(is_at, 2, 'is_at(O, [Frame, [X, Y, Z], [Qx, Qy, Qz, Qw]]): last known pose of O; with during, since or until, the pose at that time').
predicate(mng_lookup_position, 4, 'mng_lookup_position(O, Frame, Time, [P, Q]): pose of O in Frame at Time').
predicate(tf, 2, 'tf(O, Pose): last known pose of O').
predicate(tf, 4, 'tf(O, Time, P, Q): pose of O at Time').
predicate(object_trajectory, 4, 'object_trajectory(O, When, dt(D), T): poses of O as Time-Pose over [S, E] or an event; or num_samples(N)').
predicate(object_trajectory_in, 5, 'object_trajectory_in(Episode, O, When, dt(D), T): the same as object_trajectory/4, in one episode').
predicate(tf_mng_trajectory, 4, 'tf_mng_trajectory(O, S, E, T): the same as object_trajectory/4, every 0.1 s').
predicate(telemetry, 4, 'telemetry(Channel, When, Statistic, V): max, min, mean or rms (over time) of force, vertical_force, speed, a joint or a column of the telemetry over [S, E] or an event; one answer per episode').
predicate(telemetry_in, 5, 'telemetry_in(Episode, Channel, When, Statistic, V): the same as telemetry/4, in one episode').
predicate(show, 0, 'show: shows the scene').
predicate(show, 1, 'show(What): shows a thing, trajectory(O), particles(O), or a list of these').
predicate(show, 2, 'show(What, When): shows What at a time, over interval(S, E) or over interval(S, E, dt(D))').
predicate(show, 3, 'show(What, When, Style): shows What at When in a colour').
predicate(highlight, 1, 'highlight(What): highlights What').
predicate(highlight, 2, 'highlight(What, Color): highlights What in a colour').
predicate(highlight_trajectory, 4, 'highlight_trajectory(O, S, E, Color): highlights the trajectory of O from S to E').
predicate(marker_highlight, 2, 'marker_highlight(What, Color): the same as highlight/2').
predicate(data_vis, 2, 'data_vis(barchart(Id), [data: [Xs, Ys], title: T]): draws a piechart, barchart, timeline, linechart or scatter').
predicate(wear_chart, 1, 'wear_chart(Tool): draws the stiffness [N/m] of a tool over its episodes').
predicate(local_time, 2, 'local_time(T, Text): a time [s since 1970] as date and time in the local time zone; for an undated episode, the seconds from the start of its log').
predicate(low_performance, 2, 'low_performance(A, P): actions and rounds with an estimated performance of 80 % or less').
predicate(low_performance_round, 2, 'low_performance_round(R, P): rounds with an estimated performance of 80 % or less').
predicate(final_performance, 2, 'final_performance(Episode, P): estimated performance after the last round').
predicate(goal_met, 1, 'goal_met(Action): wiping actions that met their goal').
predicate(goal_missed, 2, 'goal_missed(Action, P): wiping actions that missed their goal, with performance P').
predicate(rounds_needed, 2, 'rounds_needed(Action, N): number of rounds of Action').
predicate(wiping_time, 2, 'wiping_time(Action, Seconds): duration of Action').
predicate(performance_by_round, 3, 'performance_by_round(Action, N, P): estimated performance after round N').
predicate(prediction_error, 2, 'prediction_error(Round, E): predicted minus estimated performance').
predicate(overconfident_prediction, 2, 'overconfident_prediction(Round, E): predictions more than 10 points too high').
predicate(uncertain_estimate, 2, 'uncertain_estimate(Round, W): 90 % intervals wider than 20 points').
predicate(estimate_missed_truth, 3, 'estimate_missed_truth(Round, E, T): the ground truth of the simulation lies outside the interval').
predicate(human_collision, 3, 'human_collision(Motion, C, [S, E]): motions during which a human pushed the robot').
predicate(human_collision_in, 4, 'human_collision_in(Episode, Motion, C, [S, E]): the same as human_collision/3, in one episode').
predicate(collisions_of, 2, 'collisions_of(Episode, N): number of detected collisions').
predicate(peak_force_per_collision, 2, 'peak_force_per_collision(C, F): the largest force [N] of each collision').
predicate(hardest_collision, 2, 'hardest_collision(C, F): the collision with the largest force [N]').
predicate(interrupted_stroke, 2, 'interrupted_stroke(Stroke, C): strokes with a collision').
predicate(pushed_then_recovered, 2, 'pushed_then_recovered(Action, N): actions with N collisions that met their goal').
predicate(protective_stop, 3, 'protective_stop(Stop, Time, Round): the robot made a protective stop').
predicate(contact_share, 2, 'contact_share(Round, Share): time in contact divided by time near the surface').
predicate(poor_contact, 2, 'poor_contact(Round, Share): rounds with less than 80 % of the time in contact').
predicate(contact_loss_near_edge, 2, 'contact_loss_near_edge(Loss, D): contact losses within 3 cm of an edge').
predicate(mean_force_per_stroke, 2, 'mean_force_per_stroke(Stroke, F): mean force [N] with which the tool pressed during each stroke').
predicate(weak_stroke, 2, 'weak_stroke(Stroke, F): strokes with a mean force below 8 N').
predicate(stroke_without_contact, 1, 'stroke_without_contact(Stroke): strokes without contact').
predicate(longest_contact, 3, 'longest_contact(Episode, C, Seconds): the longest contact of an episode').
predicate(contact_time, 2, 'contact_time(Round, Seconds): time in contact').
predicate(stick_slip, 2, 'stick_slip(Stroke, Event): strokes with stick-slip').
predicate(landing, 3, 'landing(Motion, Event, F): the tool landed with more force than it wipes with; peak force F [N]').
predicate(overload, 3, 'overload(Motion, Event, F): the force on the surface far exceeded the commanded force; peak force F [N]').
predicate(vibration, 3, 'vibration(Motion, Event, F): the tool vibrated; peak force F [N]').
predicate(hand_guiding, 3, 'hand_guiding(Motion, Event, F): a person guided the tool by hand; peak force F [N]').
predicate(recovery_that_worked, 4, 'recovery_that_worked(Action, Round, Before, After): the round that reached the target').
predicate(recovery_gain, 2, 'recovery_gain(Round, Gain): performance gained by a further round').
predicate(round_without_progress, 1, 'round_without_progress(Round): further rounds without a gain').
predicate(relocalized, 3, 'relocalized(Round, Tilt, Offset): localisation error of the surface [rad, m]').
predicate(tilted_surface, 2, 'tilted_surface(Round, Tilt): surfaces estimated with a tilt of more than 1 degree [rad]').
predicate(warning, 4, 'warning(Episode, Channel, T, P): at T [s since 1970] the memory warned that force, height, contact_share or tracking_error differ from comparable episodes, with p-value P').
predicate(goal_step, 5, 'goal_step(Goal, N, Step, Expected, Taken): step N of a goal of several parts, with its expected and actual time [s]').
predicate(costliest_step, 3, 'costliest_step(Goal, Step, Taken): the step of a goal that took the longest time [s]').
predicate(step_serves, 2, 'step_serves(Step, Part): part of the goal, in PDDL, for which Step was taken').
predicate(step_episode, 2, 'step_episode(Step, Episode): the episode of a wiping step').
predicate(goal_part, 3, 'goal_part(Goal, Part, State): part of a goal, in PDDL; State is holds, open or unknown').
predicate(open_part, 3, 'open_part(Goal, Part, Why): part of a goal that does not hold, or for which this is unknown, with the reason').
predicate(drift, 5, 'drift(runs(Robot, Tool, Surface), Channel, PerRun, P, Runs): drift that wisch memory health reports: change per run since the last sudden change, probability P of chance, and number of runs until a limit, or none').
predicate(contact_force_drift, 4, 'contact_force_drift(Surface, Slope, First, Last): contact force [N] that decreases slowly over episodes').
predicate(localization_drift, 4, 'localization_drift(Surface, Slope, First, Last): localisation error [m] that grows slowly over episodes, since its last sudden change').
predicate(localization_change, 4, 'localization_change(Surface, T, Before, After): sudden change of the localisation error [m]').
predicate(drift_cause, 3, 'drift_cause(Surface, Change, Cause): change [m] of the localisation error since the first episode, and its cause from force against depth: worn_tool, stiffer_tool, lowered_surface, raised_surface, tool_and_surface or unknown').
predicate(tool_wear, 4, 'tool_wear(Tool, Slope, First, Last): stiffness [N/m] of a tool that softens over episodes').
predicate(tool_performance, 4, 'tool_performance(Tool, Medium, Mean, N): mean performance of a tool with a medium, over N episodes').
predicate(strategy_performance, 3, 'strategy_performance(Strategy, Mean, N): mean performance of a strategy, over N episodes').
predicate(surface_performance, 3, 'surface_performance(Surface, Mean, N): mean performance on a surface, over N episodes').
predicate(episode_with_tool, 2, 'episode_with_tool(Episode, Tool): episodes with a tool').
predicate(episode_on_surface, 2, 'episode_on_surface(Episode, Surface): episodes on a surface').
predicate(last_episode, 2, 'last_episode(Episode, Time): the episode that began last, and its end [s since 1970]').
predicate(episode_of, 2, 'episode_of(Thing, Episode): the episode of Thing').
predicate(sure_failure, 2, 'sure_failure(Action, High): actions whose whole confidence interval lies below the target').
predicate(kb_call, 1, 'kb_call(Goal): solves Goal').
predicate(ask, 1, 'ask(Goal): solves Goal').
predicate(during, 2, 'Statement during [S, E]: the event of the statement lies within these times; an error if it has no time').
predicate(since, 2, 'Statement since T: the event of the statement begins at T or later').
predicate(until, 2, 'Statement until T: the event of the statement ends at T or earlier').
