use super::*;

/// Every class of an episode's record.
const CLASSES: [&str; 60] = [
    "WipingEpisode",
    "WipingAction",
    "WipingRound",
    "GoalEpisode",
    "GoalAction",
    "GoalPart",
    "GoalStep",
    "WipingStep",
    "FetchingStep",
    "PuttingBackStep",
    "EmptyingStep",
    "Motion",
    "Approach",
    "Stroke",
    "Transfer",
    "Drive",
    "Retreat",
    "ToolContact",
    "ContactLoss",
    "Collision",
    "HumanCollision",
    "HandGuiding",
    "Landing",
    "Overload",
    "Vibration",
    "StickSlip",
    "ProtectiveStop",
    "Relocalization",
    "MemoryWarning",
    "Wiping",
    "Absorbing",
    "Collecting",
    "Skimming",
    "Treating",
    "Polishing",
    "Painting",
    "WipingTool",
    "Sponge",
    "Broom",
    "WindowWiper",
    "Brush",
    "VacuumNozzle",
    "Medium",
    "Breadcrumbs",
    "GlassChippings",
    "Sand",
    "Dust",
    "Water",
    "Detergent",
    "PolishingPaste",
    "Paint",
    "WipedSurface",
    "ChoppingBoard",
    "Table",
    "Floor",
    "Windshield",
    "SolarPanel",
    "WipingRobot",
    "WipingEvent",
    "EpisodeRecord",
];

/// Every value of an episode's record.
const VALUES: &str = "taskName seed performance performanceLow performanceHigh predictedPerformance \
    simulatedPerformance target rounds strategy goal round strokes contactShare meanNormalForce planeTilt \
    planeOffset forceBias verdict diagnosis ending stroke peakForce samples peakHeight edgeDistance \
    warningChannel warningValue bandLow bandHigh pValue alikeEpisodes step words expectedTime takenTime stepEpisode \
    partState openReason";

fn foreign(name: &&str) -> bool {
    name.starts_with("soma:") || name.starts_with("dul:")
}

#[test]
fn every_class_of_a_record_has_a_label_and_a_comment() {
    let ontology = Ontology::load();
    for class in CLASSES {
        let class = format!("semco:{class}");
        assert_eq!(ontology.kind(&class), Some(TermKind::Class), "{class}");
        let term = ontology.term(&class).unwrap();
        assert!(
            !term.label.is_empty() && !term.comment.is_empty(),
            "{class}"
        );
    }
}

#[test]
fn every_own_term_has_an_ancestor_in_soma_or_dul() {
    let ontology = Ontology::load();
    for (name, term) in ontology.terms().filter(|(name, _)| !foreign(name)) {
        let above = ontology.above(name);
        assert!(above.iter().any(foreign), "{name}");
        let top = match term.kind {
            TermKind::Class | TermKind::Individual => "dul:Entity",
            TermKind::ObjectProperty => "dul:associatedWith",
            TermKind::DataProperty => "dul:hasDataValue",
        };
        assert!(above.contains(&top), "{name} is not below {top}");
    }
}

#[test]
fn every_value_is_a_data_property_with_domain_range_and_unit() {
    let ontology = Ontology::load();
    for value in VALUES.split_whitespace() {
        let name = format!("semco:{value}");
        let term = ontology.term(&name).unwrap_or_else(|| panic!("{name}"));
        assert_eq!(term.kind, TermKind::DataProperty, "{name}");
        assert!(term.domain.is_some(), "{name}");
        match term.range.as_deref() {
            Some("xsd:double") => assert!(
                ["[1]", "[N]", "[m]", "[rad]", "[s]"]
                    .iter()
                    .any(|unit| term.comment.contains(unit)),
                "{name}: {}",
                term.comment
            ),
            range => assert_eq!(range, Some("xsd:string"), "{name}"),
        }
    }
}

#[test]
fn relations_of_tool_medium_and_surface_are_participations() {
    let ontology = Ontology::load();
    let participations = ontology.subproperties("dul:hasParticipant").unwrap();
    for property in [
        "semco:usesTool",
        "semco:removesMedium",
        "semco:actsOnSurface",
        "soma:isPerformedBy",
    ] {
        assert!(participations.contains(&property), "{property}");
    }
}

#[test]
fn tasks_and_events_have_the_parents_of_the_literature() {
    let ontology = Ontology::load();
    let above = |class| ontology.superclasses(class).unwrap();
    assert_eq!(
        above("semco:Absorbing")[..2],
        ["semco:Absorbing", "semco:Wiping"]
    );
    for (class, parent) in [
        ("semco:Absorbing", "soma:Rubbing"),
        ("semco:Absorbing", "soma:Cleaning"),
        ("semco:Collecting", "soma:Pushing"),
        ("semco:Skimming", "dul:Task"),
        ("semco:Polishing", "soma:Rubbing"),
        ("semco:Painting", "dul:Task"),
        ("semco:HumanCollision", "dul:Process"),
        ("semco:ToolContact", "soma:State"),
        ("semco:Stroke", "dul:Action"),
        ("semco:WipingEpisode", "soma:Episode"),
        ("semco:GoalEpisode", "soma:Episode"),
        ("semco:EmptyingStep", "dul:Action"),
    ] {
        assert!(above(class).contains(&parent), "{class} below {parent}");
    }
    // The class of events is not the concept by which they are classified.
    assert!(!above("semco:Collision").contains(&"soma:Collision"));
    assert_eq!(
        ontology.types_of("semco:collision_concept").unwrap()[0],
        "soma:Collision"
    );
}

#[test]
fn superclasses_and_subclasses_are_inverse() {
    let ontology = Ontology::load();
    for upper in ontology.classes() {
        for lower in ontology.classes() {
            assert_eq!(
                ontology.subclasses(upper).unwrap().contains(&lower),
                ontology.superclasses(lower).unwrap().contains(&upper),
                "{lower} below {upper}"
            );
        }
    }
}

#[test]
fn names_and_iris_are_converted_both_ways() {
    let ontology = Ontology::load();
    for (name, _) in ontology.terms() {
        let iri = ontology.expand(name).unwrap();
        assert_eq!(ontology.compact(&iri).as_deref(), Some(name));
    }
    assert_eq!(ontology.compact("http://example.org/x"), None);
    let unknown = ontology.expand("semko:x").unwrap_err();
    assert_eq!((unknown.kind, unknown.nearest()), ("prefix", Some("semco")));
}

#[test]
fn names_are_resolved_or_the_nearest_name_is_reported() {
    let ontology = Ontology::load();
    assert_eq!(
        ontology.resolve("soma", "Collision").unwrap(),
        "soma:Collision"
    );
    assert_eq!(
        ontology.resolve_bare("Collision").unwrap(),
        "semco:Collision"
    );
    assert_eq!(
        ontology.resolve_bare("hasParticipant").unwrap(),
        "dul:hasParticipant"
    );
    assert_eq!(
        ontology.resolve_bare("justin_robot1").unwrap(),
        "semco:humanoid"
    );
    assert_eq!(
        ontology.resolve("smco", "Collision").unwrap_err().nearest(),
        Some("semco")
    );
    assert_eq!(
        ontology.resolve_bare("Strok").unwrap_err().nearest(),
        Some("Stroke")
    );
    let unknown = ontology.superclasses("semco:Swiping").unwrap_err();
    assert_eq!(
        (unknown.kind, unknown.nearest()),
        ("class", Some("semco:Wiping"))
    );
}

/// Returns a file with these lines.
fn file(lines: &str) -> String {
    format!(
        "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' \
         xmlns:rdfs='http://www.w3.org/2000/01/rdf-schema#' \
         xmlns:owl='http://www.w3.org/2002/07/owl#'>{lines}</rdf:RDF>"
    )
}

fn fault(lines: &str) -> String {
    let dul = "http://www.ontologydesignpatterns.org/ont/dul/DUL.owl#";
    let text = file(&lines.replace("dul:", dul));
    Ontology::read(&[("x.owl", &text)]).unwrap_err().to_string()
}

#[test]
fn a_faulty_ontology_is_refused() {
    assert_eq!(
        fault("<owl:Class rdf:about='dul:A'><rdfs:subClassOf rdf:resource='dul:A'/></owl:Class>"),
        "dul:A lies below itself"
    );
    assert_eq!(
        fault(
            "<owl:Class rdf:about='dul:A'><rdfs:subClassOf rdf:resource='dul:B'/></owl:Class>\
             <owl:Class rdf:about='dul:B'><rdfs:subClassOf rdf:resource='dul:A'/></owl:Class>"
        ),
        "dul:A lies below itself"
    );
    assert_eq!(
        fault("<owl:Class rdf:about='dul:A'><rdfs:subClassOf rdf:resource='dul:B'/></owl:Class>"),
        "dul:A lies below dul:B, which is not a class"
    );
    assert_eq!(
        fault("<owl:Class rdf:about='dul:A'/><owl:ObjectProperty rdf:about='dul:A'/>"),
        "x.owl: dul:A is a property, but was declared a class before"
    );
    assert_eq!(
        fault("<owl:Class rdf:about='http://example.org/A'/>"),
        "x.owl: \"http://example.org/A\": its namespace has no prefix"
    );
    assert!(
        Ontology::read(&[("x.owl", "<a>")])
            .unwrap_err()
            .to_string()
            .starts_with("x.owl: ")
    );
}
