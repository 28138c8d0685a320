use super::*;
use wisch::geometry::{Mesh, Point2, Point3, Polygon, Pose, Vector2, Vector3};
use wisch::robot::Shape;
use wisch_memory::view::{
    Colour, DirtState, Emphasis, Figure, Occurrence, ShownBody, ShownDirt, ShownEpisode, ShownPart,
    ShownRound, Track, ViewCommand,
};

const QUERY: &str = "owl_individual_of(C, semco:'Collision'), occurs(C, [S, E]), S < E.";

fn answers() -> Answers {
    Answers {
        names: ["C", "S", "Free"].map(str::to_owned).to_vec(),
        rows: vec![vec![
            Term::atom("semco:HumanCollision_20261122-1"),
            Term::Float(1002.5),
            Term::Variable("_1".to_owned()),
        ]],
        is_cut: false,
        views: Vec::new(),
        printed: String::new(),
        remarks: vec!["an episode is left out".to_owned()],
    }
}

/// A push during a round: a robot with one capsule, the path of its tool, particles and a diagram.
fn view() -> View {
    let occurrence = |class: &str, is_collision, interval| Occurrence {
        name: format!("{class}_20261122-1"),
        class: class.to_owned(),
        is_collision,
        interval,
    };
    let capsule = ShownPart {
        link: "arm".to_owned(),
        world_from_shape: Pose::translation(0.0, -1.0, 0.8),
        shape: Shape::Capsule {
            radius: 0.1,
            length: 0.6,
        },
    };
    let query =
        "data_vis(barchart(forces),[:(title,'How hard'),:(data,[[first,second],[20.5,31]])])";
    let plot = match ViewCommand::from_term(&Term::parse(query).unwrap()).unwrap() {
        ViewCommand::Plot(plot) => plot,
        ViewCommand::Show(wishes) => panic!("{wishes:?}"),
    };
    View {
        episodes: vec![ShownEpisode {
            id: "20261122".to_owned(),
            task: "board".to_owned(),
            interval: [1000.0, 1010.0],
            occurrences: vec![
                occurrence("WipingRound", false, [1000.0, 1010.0]),
                occurrence("Stroke", false, [1001.0, 1004.0]),
                occurrence("HumanCollision", true, [1002.0, 1003.0]),
            ],
            looked: vec![[1002.0, 1003.0], [1002.5, 1002.5]],
        }],
        rounds: vec![ShownRound {
            episode: 0,
            number: 1,
            world_from_surface: Pose::translation(0.0, 0.0, 0.77),
            tool_path: vec![Point3::new(0.0, 0.0, 0.77), Point3::new(0.3, 0.0, 0.77)],
            names: ["humanoid", "sponge", "board"].map(str::to_owned),
            outline: Some(Polygon::rectangle(Vector2::new(0.4, 0.3))),
            tool_mesh: Some(Mesh::cuboid(Vector3::new(0.07, 0.11, 0.05)).unwrap()),
            objects: vec![(
                Pose::identity(),
                Mesh::cuboid(Vector3::new(1.0, 1.0, 0.7)).unwrap(),
            )],
        }],
        bodies: vec![ShownBody {
            thing: "semco:humanoid".to_owned(),
            figure: Figure::Robot {
                parts: vec![capsule],
                world_from_tool: Pose::translation(0.1, 0.0, 0.8),
            },
            round: 0,
            time: 1002.5,
            emphasis: Emphasis::Strong,
            colour: None,
        }],
        tracks: vec![Track {
            thing: "semco:sponge".to_owned(),
            round: 0,
            interval: [1002.0, 1003.0],
            path: vec![Point3::new(0.1, 0.0, 0.77), Point3::new(0.2, 0.0, 0.8)],
            samples: vec![(1002.0, Point3::new(0.1, 0.0, 0.77))],
            emphasis: Emphasis::Plain,
            colour: Some(Colour([1, 2, 255])),
        }],
        particles: vec![ShownDirt {
            round: 0,
            state: DirtState::Before,
            positions: vec![Point2::new(0.05, 0.02); 9000],
            colour: None,
        }],
        plots: vec![plot],
        left_out: 3,
        remarks: vec!["there is no spoon".to_owned()],
    }
}

fn page() -> String {
    answers_page(&AnswersInput {
        query: QUERY,
        answers: &answers(),
        view: &view(),
    })
}

/// Returns the script's input.
fn data(page: &str) -> serde_json::Value {
    let marker = "id=\"space-data\">";
    let from = page.find(marker).unwrap() + marker.len();
    let to = from + page[from..].find("</script>").unwrap();
    serde_json::from_str(&page[from..to]).unwrap()
}

#[test]
fn the_page_is_self_contained() {
    let page = page();
    for foreign in ["http:", "https:", "src=", "@import", "url("] {
        assert_eq!(page.find(foreign), None, "{foreign}");
    }
}

#[test]
fn the_page_shows_query_and_answers() {
    let page = page();
    assert!(page.contains("S &lt; E."), "the query, escaped");
    assert!(page.contains("<td>HumanCollision_20261122-1</td><td>1002.500</td>"));
    assert!(page.contains("<th scope=\"col\">S</th>"));
    assert!(
        !page.contains("Free"),
        "a variable without values has no column"
    );
}

#[test]
fn a_query_without_answers_says_so() {
    let page = answers_page(&AnswersInput {
        query: "fail.",
        answers: &Answers::default(),
        view: &View::default(),
    });
    assert!(page.contains("false: the memory has no match"));
    assert!(!page.contains("<canvas"), "an empty scene has no canvas");
}

#[test]
fn queried_data_is_in_the_scene() {
    let data = data(&page());
    let items = data["items"].as_array().unwrap();
    let item = |start: &str| {
        let starts = |item: &&serde_json::Value| item["name"].as_str().unwrap().starts_with(start);
        items
            .iter()
            .find(starts)
            .unwrap_or_else(|| panic!("{start}"))
    };
    let robot = item("humanoid in round 1, 2.5 s");
    assert_eq!(robot["colour"], "limit", "highlighted");
    assert_eq!(robot["solids"][0]["kind"], "capsule");
    assert_eq!(robot["solids"][0]["pose"][1], -1.0);
    let way = item("sponge's path in round 1, 2.0 s to 3.0 s");
    assert_eq!(way["colour"], "#0102ff");
    assert_eq!(way["shines"], true);
    let points = &way["lines"][0]["points"];
    assert_eq!(*points, serde_json::json!([1000, 0, 7700, 2000, 0, 8000]));
    assert_eq!(way["dots"][0]["points"].as_array().unwrap().len(), 3);
    let dirt = item("particles before round 1");
    assert_eq!(
        dirt["dots"][0]["points"].as_array().unwrap().len(),
        3 * 3000
    );
    let surface = item("board");
    assert_eq!(surface["asked"], false);
    assert_eq!(
        data["meshes"].as_array().unwrap().len(),
        2,
        "tool and table"
    );
}

#[test]
fn every_kind_of_event_has_its_lane() {
    let lanes = [
        ("Landing", "landings"),
        ("Overload", "overloads"),
        ("Vibration", "vibrations"),
        ("HandGuiding", "hand guiding"),
    ];
    for (class, lane) in lanes {
        let label = format!(">{lane}</text>");
        assert!(!page().contains(&label));
        let mut more = view();
        let occurrence = Occurrence {
            class: class.to_owned(),
            is_collision: false,
            ..more.episodes[0].occurrences[2].clone()
        };
        more.episodes[0].occurrences.push(occurrence);
        let page = answers_page(&AnswersInput {
            query: QUERY,
            answers: &answers(),
            view: &more,
        });
        assert!(page.contains(&label), "{class}");
    }
}

#[test]
fn collisions_are_marked_over_time() {
    let page = page();
    assert_eq!(page.matches("class=\"event-collision\"").count(), 1);
    assert!(page.contains("HumanCollision_20261122-1: 2.00 to 3.00 s"));
    // Without the collision there is no mark, so the mark comes from the data.
    let mut without = view();
    without.episodes[0].occurrences.pop();
    let page = answers_page(&AnswersInput {
        query: QUERY,
        answers: &answers(),
        view: &without,
    });
    assert!(!page.contains("class=\"event-collision\""));
}

#[test]
fn the_page_shows_diagrams_and_remarks() {
    let page = page();
    assert!(page.contains("The picture is full: 3 more"));
    assert!(page.contains("an episode is left out") && page.contains("there is no spoon"));
    assert!(page.contains("<h3>How hard</h3>"));
    assert!(page.contains(">20.5</text>"));
}

#[test]
fn names_are_escaped() {
    let mut view = view();
    view.bodies[0].thing = "semco:</script><script>alert(1)".to_owned();
    view.plots[0].title = "<b>".to_owned();
    let page = answers_page(&AnswersInput {
        query: "</pre><script>",
        answers: &answers(),
        view: &view,
    });
    assert!(!page.contains("<script>alert"));
    assert!(page.contains("&lt;b&gt;"));
    assert!(page.contains("&lt;/pre&gt;&lt;script&gt;"));
}
