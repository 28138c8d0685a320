% The predicates that a query may call, with what they say. The program's list, completion and manual are made of it.
predicate(instance_of, 2, 'instance_of(I, Class): I is of this class or of one below it').
predicate(has_type, 2, 'has_type(I, Class): the same').
predicate(owl_individual_of, 2, 'owl_individual_of(I, Class): the same').
predicate(rdfs_individual_of, 2, 'rdfs_individual_of(I, Class): the same').
predicate(subclass_of, 2, 'subclass_of(Class, Super): Class is Super or below it').
predicate(rdfs_subclass_of, 2, 'rdfs_subclass_of(Class, Super): the same').
predicate(owl_subclass_of, 2, 'owl_subclass_of(Class, Super): the same').
predicate(is_episode, 1, 'is_episode(I): I is an episode').
predicate(is_action, 1, 'is_action(I): I is an action').
predicate(is_process, 1, 'is_process(I): I is a process').
predicate(is_event, 1, 'is_event(I): I is an event').
predicate(is_state, 1, 'is_state(I): I is a state').
predicate(is_task, 1, 'is_task(I): I is a task').
predicate(triple, 3, 'triple(S, P, O): S stands in P to O; P may be transitive(P) or reflexive(P)').
predicate(holds, 3, 'holds(S, P, O): the same').
predicate(holds, 1, 'holds(P(S, O)): the same').
predicate(owl_has, 3, 'owl_has(S, P, O): the same').
predicate(rdf_has, 3, 'rdf_has(S, P, O): the same').
predicate(has_data_value, 2, 'has_data_value(I, performance =< 0.8): a value of I meets a condition').
predicate(has_subevent, 2, 'has_subevent(Event, Part): Part is a part of Event').
predicate(subAction, 2, 'subAction(Event, Part): the same').
predicate(has_participant, 2, 'has_participant(Event, Thing): Thing takes part in Event').
predicate(is_performed_by, 2, 'is_performed_by(Action, Agent): Agent does Action').
predicate(executes_task, 2, 'executes_task(Action, Task): Action is done for Task').
predicate(is_classified_by, 2, 'is_classified_by(Event, Concept): Concept says what Event is').
predicate(action_status, 2, 'action_status(Action, State): how Action ended').
predicate(action_succeeded, 1, 'action_succeeded(Action): the goal was met').
predicate(action_failed, 1, 'action_failed(Action): the goal was not met').
predicate(tell, 1, 'tell(holds(S, P, O)): keeps a statement in this memory, when the query has ended and holds').
predicate(occurs, 1, 'occurs(Event): Event has a time').
predicate(occurs, 2, 'occurs(Event, [S, E]): Event lasts from S to E [s since 1970]').
predicate(event_interval, 3, 'event_interval(Event, S, E): the same').
predicate(has_time_interval, 2, 'has_time_interval(Event, [S, E]): the same').
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
predicate(is_at, 2, 'is_at(O, [Frame, [X, Y, Z], [Qx, Qy, Qz, Qw]]): the last known pose; with during, since or until at that time').
predicate(mng_lookup_position, 4, 'mng_lookup_position(O, Frame, Time, [P, Q]): where O was').
predicate(tf, 2, 'tf(O, Pose): the last known pose').
predicate(tf, 4, 'tf(O, Time, P, Q): where O was').
predicate(object_trajectory, 4, 'object_trajectory(O, When, dt(D), T): poses of O as Time-Pose over [S, E] or an event; or num_samples(N)').
predicate(object_trajectory_in, 5, 'object_trajectory_in(Episode, O, When, dt(D), T): the same, of one episode').
predicate(tf_mng_trajectory, 4, 'tf_mng_trajectory(O, S, E, T): the same every 0.1 s').
predicate(telemetry, 4, 'telemetry(Channel, When, Statistic, V): max, min, mean or rms of force, vertical_force, speed, a joint or a column of the telemetry over [S, E] or an event; by episode').
predicate(telemetry_in, 5, 'telemetry_in(Episode, Channel, When, Statistic, V): the same, of one episode').
predicate(show, 0, 'show: the scene').
predicate(show, 1, 'show(What): a thing, trajectory(O), particles(O), or a list of these').
predicate(show, 2, 'show(What, When): at a time, or over interval(S, E) or interval(S, E, dt(D))').
predicate(show, 3, 'show(What, When, Style): with a colour').
predicate(highlight, 1, 'highlight(What): light it up').
predicate(highlight, 2, 'highlight(What, Color): in a colour').
predicate(highlight_trajectory, 4, 'highlight_trajectory(O, S, E, Color): the part of a trajectory').
predicate(marker_highlight, 2, 'marker_highlight(What, Color): the same as highlight/2').
predicate(data_vis, 2, 'data_vis(barchart(Id), [data: [Xs, Ys], title: T]): a piechart, barchart, timeline, linechart or scatter').
predicate(wear_chart, 1, 'wear_chart(Tool): draws the stiffness [N/m] of a tool over its episodes').
predicate(local_time, 2, 'local_time(T, Text): a time [s since 1970] as date and time where this machine stands').
predicate(low_performance, 2, 'low_performance(A, P): actions and rounds with an estimated performance of 80 % or less').
predicate(low_performance_round, 2, 'low_performance_round(R, P): rounds with an estimated performance of 80 % or less').
predicate(final_performance, 2, 'final_performance(Episode, P): the estimated performance in the end').
predicate(goal_met, 1, 'goal_met(Action): wiping that met its goal').
predicate(goal_missed, 2, 'goal_missed(Action, P): wiping that did not meet its goal').
predicate(rounds_needed, 2, 'rounds_needed(Action, N): how many rounds it took').
predicate(wiping_time, 2, 'wiping_time(Action, Seconds): how long it took').
predicate(performance_by_round, 3, 'performance_by_round(Action, N, P): how the performance grew').
predicate(prediction_error, 2, 'prediction_error(Round, E): predicted less estimated performance').
predicate(overconfident_prediction, 2, 'overconfident_prediction(Round, E): predicted over 10 points too high').
predicate(uncertain_estimate, 2, 'uncertain_estimate(Round, W): 90 % intervals wider than 20 points').
predicate(estimate_missed_truth, 3, 'estimate_missed_truth(Round, E, T): the simulated truth lies outside the interval').
predicate(human_collision, 3, 'human_collision(Motion, C, [S, E]): motions during which a human pushed the robot').
predicate(human_collision_in, 4, 'human_collision_in(Episode, Motion, C, [S, E]): the same, of one episode').
predicate(collisions_of, 2, 'collisions_of(Episode, N): how many collisions were felt').
predicate(peak_force_per_collision, 2, 'peak_force_per_collision(C, F): the largest force [N] of each collision').
predicate(hardest_collision, 2, 'hardest_collision(C, F): the collision with the largest force [N]').
predicate(interrupted_stroke, 2, 'interrupted_stroke(Stroke, C): strokes during which something collided').
predicate(pushed_then_recovered, 2, 'pushed_then_recovered(Action, N): N collisions, and the goal was met all the same').
predicate(protective_stop, 3, 'protective_stop(Stop, Time, Round): the robot stopped itself').
predicate(contact_share, 2, 'contact_share(Round, Share): time in contact over time near the surface').
predicate(poor_contact, 2, 'poor_contact(Round, Share): less than 80 % of the time in contact').
predicate(contact_loss_near_edge, 2, 'contact_loss_near_edge(Loss, D): contact lost within 3 cm of an edge').
predicate(mean_force_per_stroke, 2, 'mean_force_per_stroke(Stroke, F): mean normal force [N], negative where the tool presses').
predicate(weak_stroke, 2, 'weak_stroke(Stroke, F): pressed with less than 8 N').
predicate(stroke_without_contact, 1, 'stroke_without_contact(Stroke): touched nothing').
predicate(longest_contact, 3, 'longest_contact(Episode, C, Seconds): the longest contact of an episode').
predicate(contact_time, 2, 'contact_time(Round, Seconds): time in contact').
predicate(stick_slip, 2, 'stick_slip(Stroke, Event): strokes that stuck and slipped').
predicate(landing, 3, 'landing(Motion, Event, F): the tool came down harder than it wipes, with F [N] at most').
predicate(overload, 3, 'overload(Motion, Event, F): pressed on the surface much harder than asked for, with F [N] at most').
predicate(vibration, 3, 'vibration(Motion, Event, F): the tool shook, with F [N] at most').
predicate(hand_guiding, 3, 'hand_guiding(Motion, Event, F): somebody led the tool by hand, with F [N] at most').
predicate(recovery_that_worked, 4, 'recovery_that_worked(Action, Round, Before, After): the round that reached the target').
predicate(recovery_gain, 2, 'recovery_gain(Round, Gain): what a further round brought').
predicate(round_without_progress, 1, 'round_without_progress(Round): a further round that brought nothing').
predicate(relocalized, 3, 'relocalized(Round, Tilt, Offset): the surface was found elsewhere [rad, m]').
predicate(tilted_surface, 2, 'tilted_surface(Round, Tilt): found tilted by over 1 degree [rad]').
predicate(contact_force_drift, 4, 'contact_force_drift(Surface, Slope, First, Last): force [N] that is lost slowly over episodes').
predicate(localization_drift, 4, 'localization_drift(Surface, Slope, First, Last): a surface [m] that creeps away over episodes, since it last changed at once').
predicate(localization_change, 4, 'localization_change(Surface, T, Before, After): a surface [m] that is found elsewhere at once').
predicate(drift_cause, 3, 'drift_cause(Surface, Change, Cause): how far [m] a surface is found from where it was at first, and why: worn_tool, stiffer_tool, lowered_surface, raised_surface, tool_and_surface or cannot_be_told, by force against depth').
predicate(tool_wear, 4, 'tool_wear(Tool, Slope, First, Last): a tool that grows softer over episodes [N/m]').
predicate(tool_performance, 4, 'tool_performance(Tool, Medium, Mean, N): which tool is good for what').
predicate(strategy_performance, 3, 'strategy_performance(Strategy, Mean, N): which strategy is good').
predicate(surface_performance, 3, 'surface_performance(Surface, Mean, N): which surface is difficult').
predicate(episode_with_tool, 2, 'episode_with_tool(Episode, Tool): episodes in which a tool was used').
predicate(episode_on_surface, 2, 'episode_on_surface(Episode, Surface): episodes on a surface').
predicate(last_episode, 2, 'last_episode(Episode, Time): the latest, and when it ended').
predicate(episode_of, 2, 'episode_of(Thing, Episode): the episode that something belongs to').
predicate(sure_failure, 2, 'sure_failure(Action, High): even the upper end of the interval is below the target').
predicate(kb_call, 1, 'kb_call(Goal): calls it').
predicate(ask, 1, 'ask(Goal): calls it').
predicate(during, 2, 'Statement during [S, E]: what the statement is about lies within these times; an error where that has no time').
predicate(since, 2, 'Statement since T: what the statement is about begins then or later').
predicate(until, 2, 'Statement until T: what the statement is about ends then or earlier').
