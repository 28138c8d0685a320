% Predicates that users of robot memories know, in the dialects of KnowRob and openEASE.

:- op(800, yfx, during).
:- op(800, yfx, since).
:- op(800, yfx, until).

% Types ---------------------------------------------------------------------------------------------------

instance_of(I, Class) :- nonvar(Class), !, known(class, Class, Name), thing(I, Thing), of_class(Thing, Name).
instance_of(I, Class) :- nonvar(I), !, thing(I, Thing), individual(Thing, Exact, _, _, _, _), in_closure(superclasses, Exact, Class).
instance_of(I, Class) :- individual(I, Exact, _, _, _, _), in_closure(superclasses, Exact, Class).

of_class(I, Class) :- nonvar(I), !, individual(I, Exact, _, _, _, _), once(in_closure(subclasses, Class, Exact)).
of_class(I, Class) :- in_closure(subclasses, Class, Exact), member_of(Exact, I).

has_type(I, Class) :- instance_of(I, Class).
owl_individual_of(I, Class) :- instance_of(I, Class).
rdfs_individual_of(I, Class) :- instance_of(I, Class).

subclass_of(Class, Super) :- nonvar(Class), !, known(class, Class, Name), in_closure(superclasses, Name, Other), same_class(Super, Other).
subclass_of(Class, Super) :- nonvar(Super), !, known(class, Super, Name), in_closure(subclasses, Name, Class).
subclass_of(Class, Super) :- need(classes, Classes), member(Class, Classes), in_closure(superclasses, Class, Super).

rdfs_subclass_of(Class, Super) :- subclass_of(Class, Super).
owl_subclass_of(Class, Super) :- subclass_of(Class, Super).

same_class(Term, Name) :- var(Term), !, Term = Name.
same_class(Term, Name) :- known(class, Term, Name).

is_a(I, Class) :- ( nonvar(I) -> thing(I, Thing) ; Thing = I ), of_class(Thing, Class).

is_episode(I) :- is_a(I, 'soma:Episode').
is_action(I) :- is_a(I, 'dul:Action').
is_process(I) :- is_a(I, 'dul:Process').
is_event(I) :- is_a(I, 'dul:Event').
is_state(I) :- is_a(I, 'soma:State').
is_task(I) :- is_a(I, 'dul:Task').

% Statements ----------------------------------------------------------------------------------------------

% triple(?Subject, ?Property, ?Object); Property may be transitive(P) or reflexive(P).
triple(S, P, O) :- var(P), !, thing(S, S1), object(O, O1), entailed(S1, P, O1).
triple(S, transitive(P), O) :- !, property(P, Name), thing(S, S1), object(O, O1), reached(Name, S1, O1).
triple(S, reflexive(P), O) :- !,
    property(P, Name),
    thing(S, S1),
    object(O, O1),
    ( var(S1), var(O1) -> unknown_yet('the subject or the object of a reflexive property')
    ; nonvar(S1), O1 = S1
    ; var(S1), S1 = O1
    ; stated(S1, Name, O1)
    ).
triple(S, P, O) :- property(P, Name), stated_terms(S, Name, O).

stated_terms(S, 'rdf:type', C) :- !, instance_of(S, C).
stated_terms(S, 'rdfs:subClassOf', C) :- !, subclass_of(S, C).
stated_terms(S, Name, O) :- annotation(Name), !, thing(S, S1), exactly(S1, Name, O).
stated_terms(S, Name, O) :- thing(S, S1), object(O, O1), stated(S1, Name, O1).

holds(S, P, O) :- triple(S, P, O).
owl_has(S, P, O) :- triple(S, P, O).
rdf_has(S, P, O) :- triple(S, P, O).

% holds(+Property(S, O)), as in holds(hasParticipant(C, X))
holds(Statement) :- nonvar(Statement), Statement =.. [P, S, O], triple(S, P, O).

property(P, _) :- var(P), !, unknown_yet('the property').
property(P, Name) :- known(property, P, Name).

% An object may be a value or a thing.
object(O, O) :- var(O), !.
object(O, O) :- number(O), !.
object(O, Name) :- ( catch(known(thing, O, Found), unknown(_, _, _), fail) -> Name = Found ; Name = O ).

stated(S, Name, O) :- in_closure(subproperties, Name, Exact), exactly(S, Exact, O).
stated(S, Name, O) :- inverse_of(Name, Inverse), in_closure(subproperties, Inverse, Exact), exactly(O, Exact, S).

inverse_of('dul:isConstituentOf', 'dul:hasConstituent').
inverse_of('dul:isParticipantIn', 'dul:hasParticipant').
inverse_of('dul:isExecutedIn', 'dul:executesTask').
inverse_of('dul:classifies', 'dul:isClassifiedBy').

exactly(S, 'dul:hasConstituent', O) :- !, part(S, O).
exactly(S, Exact, O) :- annotation(Exact), !, value(S, Exact, O).
exactly(S, Exact, O) :- ( var(O) -> true ; atom(O), has_colon(O) ), relation(S, Exact, O).
exactly(S, Exact, O) :- ( var(O) -> true ; number(O) -> true ; atom(O) ), same_value(S, Exact, O).

% A number in a query need not have the stored form: 1 matches 1.0.
same_value(S, Exact, O) :- number(O), !, value(S, Exact, V), number(V), V =:= O.
same_value(S, Exact, O) :- value(S, Exact, O).

% entailed(?S, -P, ?O): statements with any property, and those that follow for the properties above it.
entailed(S, 'rdf:type', C) :- ( var(C) -> true ; is_class(C) ), instance_of(S, C).
entailed(S, P, O) :- statement(S, Exact, O), in_closure(superproperties, Exact, P).
entailed(S, P, O) :- linked(O, Exact, S), in_closure(superproperties, Exact, Above), inverse_of(P, Above).

statement(S, P, O) :- linked(S, P, O).
statement(S, P, O) :- ( var(S) -> true ; is_name(S) ), value(S, P, V), ( number(O) -> number(V), V =:= O ; O = V ).

% linked(?S, -P, ?O): both are things. Values are never subjects, and no relation leads to them.
linked(S, P, O) :- ( var(S) -> true ; is_name(S) ), ( var(O) -> true ; is_name(O) ), linked_things(S, P, O).

linked_things(S, 'dul:hasConstituent', O) :- part(S, O).
linked_things(S, P, O) :- relation(S, P, O).

is_class(C) :- is_name(C), catch(known(class, C, _), unknown(_, _, _), fail).

is_name(Term) :- atom(Term), has_colon(Term).

reached(Name, S, O) :- nonvar(S), !, reach(Name, [S], [], O).
reached(Name, S, O) :- nonvar(O), !, reach_back(Name, [O], [], S).
reached(Name, S, O) :- findall(S0, stated(S0, Name, _), Ss0), sort(Ss0, Ss), member(S, Ss), reach(Name, [S], [], O).

reach(Name, [S|Rest], Seen, O) :-
    findall(X, (stated(S, Name, X), \+ member(X, Seen)), Xs0),
    sort(Xs0, Xs),
    append(Seen, Xs, Seen1),
    append(Rest, Xs, Next),
    ( member(O, Xs) ; reach(Name, Next, Seen1, O) ).

reach_back(Name, [O|Rest], Seen, S) :-
    findall(X, (stated(X, Name, O), \+ member(X, Seen)), Xs0),
    sort(Xs0, Xs),
    append(Seen, Xs, Seen1),
    append(Rest, Xs, Next),
    ( member(S, Xs) ; reach_back(Name, Next, Seen1, S) ).

% Their values are texts, also where something has the same name.
annotation('rdfs:label').
annotation('rdfs:comment').

% has_data_value(?I, +Condition): conditions such as performance =< 0.8, performance(V), or hasForceValue = F.
has_data_value(I, Condition) :-
    nonvar(Condition),
    condition(Condition, Property, Operator, Bound),
    !,
    property(Property, Name),
    thing(I, Thing),
    in_closure(subproperties, Name, Exact),
    matching(Thing, Exact, Operator, Bound).
has_data_value(_, Condition) :- var(Condition), !, unknown_yet('the condition of has_data_value').
has_data_value(_, Condition) :- throw(error(domain_error(condition, Condition), has_data_value)).

condition(P =< X, P, =<, X).
condition(P >= X, P, >=, X).
condition(P < X, P, <, X).
condition(P > X, P, >, X).
condition(P =:= X, P, =:=, X).
condition(P = X, P, =, X).
condition(P, Name, =, X) :- P =.. [Name, X].

matching(I, Exact, =, X) :- !, ( var(I), number(X) -> among(I, Exact, =:=, X) ; value(I, Exact, X0), same_number(X, X0) ).
matching(I, Exact, Operator, Bound) :- Number is Bound, ( var(I) -> among(I, Exact, Operator, Number) ; value(I, Exact, V), number(V), compared(Operator, V, Number) ).

same_number(X, X0) :- number(X), number(X0), !, X =:= X0.
same_number(X, X).

among(I, Exact, Operator, Number) :- filtered(Exact, Operator, Number, I).

compared(=<, A, B) :- A =< B.
compared(>=, A, B) :- A >= B.
compared(<, A, B) :- A < B.
compared(>, A, B) :- A > B.
compared(=:=, A, B) :- A =:= B.

has_subevent(Event, Part) :- thing(Event, E), thing(Part, P), part(E, P).
subAction(Event, Part) :- has_subevent(Event, Part).

has_participant(Event, Thing) :- triple(Event, dul:hasParticipant, Thing).
is_performed_by(Action, Agent) :- triple(Action, soma:isPerformedBy, Agent).
executes_task(Action, Task) :- triple(Action, dul:executesTask, Task).
is_classified_by(Thing, Concept) :- triple(Thing, dul:isClassifiedBy, Concept).

action_status(Action, Status) :- triple(Action, soma:hasExecutionState, Status).
action_succeeded(Action) :- triple(Action, soma:hasExecutionState, soma:'ExecutionState_Succeeded').
action_failed(Action) :- triple(Action, soma:hasExecutionState, soma:'ExecutionState_Failed').

% tell(+Statement): stores a statement holds(S, P, O), a new individual has_type(I, Class), or a list of them, if the
% whole query succeeds.
tell(Statement) :- \+ ground(Statement), !, unknown_yet('every part of the statement of tell').
tell([]) :- !.
tell([S|Ss]) :- !, tell(S), tell(Ss).
tell(holds(S, P, O)) :- !, known(property, P, P1), tell_property(P1, S, O).
tell(triple(S, P, O)) :- !, tell(holds(S, P, O)).
tell(has_type(I, Class)) :- !, tell_property('rdf:type', I, Class).
tell(Statement) :- throw(error(domain_error(statement, Statement), tell)).

tell_property('rdf:type', I, Class) :- !,
    known(class, Class, Name),
    need(introduce(I, Name), Facts),
    store(Facts),
    % Earlier members do not include it.
    retractall(loaded(members(Name))),
    retractall(c(Name, _)).
tell_property(P, S, O) :-
    known(thing, S, S1),
    tellable(P),
    ( annotation(P) -> O1 = O ; object(O, O1) ),
    told(S1, P, O1).

% The episodes fix these properties, so statements cannot change them.
tellable(P) :- ( member(P, ['rdfs:subClassOf', 'dul:hasConstituent', 'dul:isConstituentOf']) -> throw(untold(P)) ; true ).

told(S, P, O) :-
    ( exactly(S, P, O) -> true
    ; need(tell(S, P, O), Facts),
      store(Facts),
      % Earlier results of the query do not include it.
      retractall(loaded(filter(P, _, _))),
      retractall(f(filter(P, _, _), _))
    ).

kb_call(Goal) :- call(Goal).
ask(Goal) :- call(Goal).
