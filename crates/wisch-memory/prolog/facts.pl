% Facts of the memory, fetched on demand. They are
%
%     i(Individual, Class, Start, End, Parent, Episode)    none for a missing field
%     c(Class, Individuals)                                of exactly this class, several hundred in a list
%     k(Parent, Part)
%     v(Individual, Property, Value)
%     f(Request, Individuals)                              results of a filter, several hundred in a list
%     r(Individual, Property, Object)
%
% with names as 'semco:Collision_20261122-005612-3f2a-17'.

% known(+Kind, +Term, -Name): the full name of prefix:'Local', 'Local' or an IRI; Kind is class, property or thing. An
% unknown name in the text of the query is an error. A value that the query itself has bound names nothing, and fails.
known(Kind, Term, Name) :-
    ground(Term),
    !,
    ( Kind == thing, atom(Term), i(Term, _, _, _, _, _) -> Name = Term
    ; resolved(Kind-Term, Found) -> Name = Found
    ; need(resolve(Kind, Term), [Found]),
      assertz(resolved(Kind-Term, Found)),
      Name = Found
    ).
known(Kind, _, _) :- what_kind(Kind, What), unknown_yet(What).

what_kind(class, 'the class').
what_kind(property, 'the property').
what_kind(thing, 'the thing that this is about').

% thing(?Term, -Name): like known/3; a variable stays unbound.
thing(Term, Name) :- var(Term), !, Name = Term.
thing(Term, Name) :- known(thing, Term, Name).

% in_closure(+Kind, +Name, -Other): Other is in the closure of subclasses, superclasses, subproperties or
% superproperties, which includes Name.
in_closure(Kind, Name, Other) :-
    ( closure(Kind, Name, Others) -> true
    ; Request =.. [Kind, Name],
      need(Request, Others),
      assertz(closure(Kind, Name, Others))
    ),
    member(Other, Others).

% individual(?I, ?Class, ?Start, ?End, ?Parent, ?Episode)
individual(I, Class, Start, End, Parent, Episode) :-
    nonvar(I),
    !,
    ( i(I, Class0, Start0, End0, Parent0, Episode0) -> true
    ; known(thing, I, Name),
      ensure(individual(Name)),
      i(Name, Class0, Start0, End0, Parent0, Episode0) ->
        true
    ),
    Class = Class0, Start = Start0, End = End0, Parent = Parent0, Episode = Episode0.
individual(I, Class, Start, End, Parent, Episode) :-
    nonvar(Class),
    !,
    member_of(Class, I),
    individual(I, Class, Start, End, Parent, Episode).
individual(I, Class, Start, End, Parent, Episode) :-
    stream(individuals, i(I, Class, Start, End, Parent, Episode)).

% member_of(+Class, -I): instances of exactly this class.
member_of(Class, I) :- nonvar(I), !, individual(I, Class, _, _, _, _).
member_of(Class, I) :-
    Request = members(Class),
    ( loaded(Request) -> true
    ; need(size(Request), [few]) -> ensure(Request)
    ; true
    ),
    ( loaded(Request) -> c(Class, Is), member(I, Is)
    ; stream(named_members(Class), I)
    ).

% part(?Parent, ?Part)
part(Parent, Part) :- nonvar(Part), !, thing(Parent, Whole), individual(Part, _, _, _, Whole, _), Whole \== none.
part(Parent, Part) :- nonvar(Parent), !, known(thing, Parent, Whole), ensure(parts(Whole)), k(Whole, Part).
part(Parent, Part) :- stream(individuals, i(Part, _, _, _, Parent, _)), Parent \== none.

% value(?I, ?Property, ?Value): values of exactly this property.
value(I, Property, Value) :-
    nonvar(I),
    !,
    known(thing, I, Name),
    ( nonvar(Property) -> ensure_value(Name, Property) ; ensure(statements(Name)) ),
    v(Name, Property, Value).
value(I, Property, Value) :-
    nonvar(Property),
    !,
    stream(values(Property), Value0-I0),
    I = I0,
    Value = Value0.
value(I, Property, Value) :- stream(values, v(I, Property, Value)).

ensure_value(I, Property) :- v(I, Property, _), !.
ensure_value(I, _) :- loaded(statements(I)), !.
ensure_value(I, Property) :- fetch(values_of(I, Property)).

% relation(?I, ?Property, ?Object): relations of exactly this property.
relation(I, Property, Object) :-
    nonvar(I),
    !,
    known(thing, I, Name),
    ensure(statements(Name)),
    thing(Object, Found),
    r(Name, Property, Found).
relation(I, Property, Object) :-
    nonvar(Object),
    !,
    known(thing, Object, Found),
    stream(related_to(Found), r(I, Property, Found)).
relation(I, Property, Object) :- nonvar(Property), !, stream(relations(Property), r(I, Property, Object)).
relation(I, Property, Object) :- stream(relations, r(I, Property, Object)).

% filtered(+Property, +Operator, +Number, -I): the program compares. Small results are kept.
filtered(Property, Operator, Number, I) :-
    Request = filter(Property, Operator, Number),
    ( loaded(Request) -> true
    ; need(size(Request), [few]) -> ensure(Request)
    ; true
    ),
    ( loaded(Request) -> f(Request, Is), member(I, Is)
    ; stream(Request, I)
    ).
