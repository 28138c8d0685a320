use super::*;
use crate::ask::Term;

fn command(text: &str) -> Result<ViewCommand, String> {
    ViewCommand::from_term(&Term::parse(text).unwrap()).map_err(|error| error.to_string())
}

fn wishes(text: &str) -> Vec<ViewRequest> {
    match command(text).unwrap() {
        ViewCommand::Show(wishes) => wishes,
        ViewCommand::Plot(plot) => panic!("{plot:?}"),
    }
}

fn plot(text: &str) -> Plot {
    match command(text).unwrap() {
        ViewCommand::Plot(plot) => plot,
        ViewCommand::Show(wishes) => panic!("{wishes:?}"),
    }
}

fn thing(name: &str) -> ViewSubject {
    ViewSubject::Thing(name.to_owned())
}

#[test]
fn all_forms_of_show_are_parsed() {
    let sponge = "semco:sponge";
    for (text, subject, when) in [
        ("show('semco:sponge')", thing(sponge), ViewTime::Latest),
        ("show('semco:sponge',12)", thing(sponge), ViewTime::At(12.0)),
        (
            "show('semco:sponge',interval(1,2.5))",
            thing(sponge),
            ViewTime::During([1.0, 2.5]),
        ),
        (
            "show('semco:sponge',[1,2.5])",
            thing(sponge),
            ViewTime::During([1.0, 2.5]),
        ),
        (
            "show(trajectory('semco:sponge'),interval(1,2,dt(0.5)))",
            ViewSubject::Trajectory(sponge.to_owned()),
            ViewTime::Every([1.0, 2.0], 0.5),
        ),
        (
            "show(particles('semco:breadcrumbs'),3)",
            ViewSubject::Particles("semco:breadcrumbs".to_owned()),
            ViewTime::At(3.0),
        ),
    ] {
        let wanted = ViewRequest {
            subject,
            when,
            emphasis: Emphasis::Plain,
            colour: None,
        };
        assert_eq!(wishes(text), [wanted], "{text}");
    }
    assert_eq!(wishes("show"), []);
}

#[test]
fn a_list_gives_a_wish_per_entry() {
    let wishes = wishes("show([a,trajectory(b),trajectory([c,d])],1)");
    let subjects: Vec<ViewSubject> = wishes.into_iter().map(|wish| wish.subject).collect();
    let way = |name: &str| ViewSubject::Trajectory(name.to_owned());
    assert_eq!(subjects, [thing("a"), way("b"), way("c"), way("d")]);
}

#[test]
fn highlights_have_emphasis_and_colour() {
    let red = Colour([213, 52, 43]);
    for (text, when, colour) in [
        ("highlight(a)", ViewTime::Latest, None),
        ("highlight(a,red)", ViewTime::Latest, Some(red)),
        (
            "highlight(a,'#0a0B0c')",
            ViewTime::Latest,
            Some(Colour([10, 11, 12])),
        ),
        (
            "highlight(a,color([1,0,0.2]))",
            ViewTime::Latest,
            Some(Colour([255, 0, 51])),
        ),
        (
            "highlight(a,interval(1,2),[=(color,red)])",
            ViewTime::During([1.0, 2.0]),
            Some(red),
        ),
    ] {
        let wanted = ViewRequest {
            subject: thing("a"),
            when,
            emphasis: Emphasis::Strong,
            colour,
        };
        assert_eq!(wishes(text), [wanted], "{text}");
    }
    assert_eq!(
        wishes("show(a,1,red)")[0].colour,
        Some(red),
        "styles of show"
    );
}

#[test]
fn invalid_commands_are_reported() {
    for (text, says) in [
        ("dance(a)", "dance(a) cannot be drawn"),
        (
            "show(shadow(a))",
            "shadow(a) is not a thing, trajectory(Thing), particles(Thing) or list of these",
        ),
        (
            "show(trajectory(particles(a)))",
            "trajectory(particles(a)) is not a thing, trajectory(Thing), particles(Thing) or list of these",
        ),
        (
            "show(a,interval(2,1))",
            "interval(2, 1) is not a time, interval(Start, End) or interval(Start, End, dt(Seconds))",
        ),
        (
            "show(a,interval(1,2,dt(0)))",
            "interval(1, 2, dt(0)) is not a time, interval(Start, End) or interval(Start, End, dt(Seconds))",
        ),
        (
            "show(a,1,redish)",
            "redish is not a color; did you mean red?",
        ),
        (
            "show(a,1,warm)",
            "warm is not a color; expected a name such as red, or a code such as '#ff0000'",
        ),
        (
            "highlight(a,[2,0,0])",
            "[2, 0, 0] is not a color; its parts go from 0 to 1",
        ),
    ] {
        assert_eq!(command(text).unwrap_err(), says, "{text}");
    }
}

#[test]
fn every_diagram_takes_its_data() {
    let amounts = PlotData::Amounts(vec![("a".to_owned(), 1.0), ("b".to_owned(), 2.5)]);
    let points = PlotData::Points(vec![[1.0, 3.0], [2.0, 4.0]]);
    let spans = PlotData::Spans(vec![
        ("a".to_owned(), [1.0, 2.0]),
        ("b".to_owned(), [3.0; 2]),
    ]);
    for (diagram, data, wanted) in [
        ("piechart", "[[a,b],[1,2.5]]", &amounts),
        ("barchart", "[[a,b],[1,2.5]]", &amounts),
        ("barchart", "[[a,1],[b,2.5]]", &amounts),
        ("barchart", "[-(a,1),-(b,2.5)]", &amounts),
        ("linechart", "[[1,2],[3,4]]", &points),
        ("scatter", "[[1,2],[3,4]]", &points),
        ("timeline", "[[a,b],[[1,2],3]]", &spans),
        ("timeline", "[[a,b],[interval(1,2),3]]", &spans),
        ("timeline", "[-(a,-(1,2)),-(b,3)]", &spans),
        ("timeline", "[[a,[1,2]],[b,3]]", &spans),
    ] {
        for property in [
            format!(":(data,{data})"),
            format!("=(data,{data})"),
            format!("data({data})"),
        ] {
            let plot = plot(&format!("data_vis({diagram}(d1),[{property}])"));
            assert_eq!(plot.diagram.as_str(), diagram);
            assert_eq!(plot.id, "d1");
            assert_eq!(&plot.data, wanted, "{diagram}: {property}");
        }
    }
}

#[test]
fn labels_of_diagrams_may_be_names_or_characters() {
    let plot = plot(
        "data_vis(scatter(x),[:(data,[[],[]]),:(title,'Two words'),:(xlabel,[t,i,m,e]),:(ylabel,:(semco,force))])",
    );
    assert_eq!(plot.title, "Two words");
    assert_eq!(plot.x_label, "time");
    assert_eq!(plot.y_label, "semco:force");
    assert_eq!(plot.data, PlotData::Points(Vec::new()));
}

#[test]
fn invalid_data_is_reported() {
    for (text, says) in [
        (
            "data_vis(piechart(a),[:(title,t)])",
            "piechart: data is missing; expected data: [Xs, Ys]",
        ),
        (
            "data_vis(piechart(a),[:(data,[[a,b],[1,-2]])])",
            "piechart: Ys[1]: -2 is not a number from 0 on",
        ),
        (
            "data_vis(barchart(a),[:(data,[[a,b,c],[1,2]])])",
            "barchart: data has 3 Xs, but 2 Ys",
        ),
        (
            "data_vis(linechart(a),[:(data,[[1,x],[1,2]])])",
            "linechart: Xs[1]: x is not a number",
        ),
        (
            "data_vis(timeline(a),[:(data,[[a],[[2,1]]])])",
            "timeline: Ys[0]: [2, 1] is not a time or [Start, End]",
        ),
        (
            "data_vis(scatter(a),[:(data,[[1,2],[3,4],5])])",
            "scatter: data[2]: 5 is not a pair",
        ),
        (
            "data_vis(scatter(a),[:(data,7)])",
            "scatter: data: 7 is not [Xs, Ys] or a list of pairs",
        ),
        (
            "data_vis(radar(a),[:(data,[])])",
            "radar(a) cannot be drawn",
        ),
    ] {
        assert_eq!(command(text).unwrap_err(), says, "{text}");
    }
}
