//! `wisch ask --view`: a page, or none at all.

use super::{ID, ask, memory};
use std::fs;

const COLLISIONS: &str = "owl_individual_of(C, semco:'Collision'), occurs(C, [S, E]), D is E - S, \
    data_vis(barchart(lasted), [data: [[C], [D]], title: 'How long', ylabel: 'time [s]'])";

#[test]
fn what_a_query_shows_is_drawn_into_one_page() {
    let folder = memory();
    let (code, out, err) = ask(folder.path(), &[COLLISIONS, "--view", "seen.html"]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    assert!(
        out.contains("HumanCollision"),
        "answers are printed all the same: {out}"
    );
    let page = fs::read_to_string(folder.path().join("seen.html")).unwrap();
    assert!(
        page.contains("\"amounts\":[[\"semco:HumanCollision_"),
        "the diagram"
    );
    assert!(page.contains("\"title\":\"How long\"") && page.contains(",1.5]]"));
    assert!(page.contains("<pre id=\"query\" hidden>owl_individual_of(C, semco:'Collision')"));
    let recording = format!("<script type=\"application/gzip\" data-episode=\"{ID}\">");
    assert!(page.contains(&recording), "its episode is shown over time");
    let asks = ["src=\"http", "href=\"http", "url(http", "@import"];
    for network in asks {
        assert!(!page.contains(network), "nothing is asked of the network");
    }
}

#[test]
fn without_a_page_it_is_said_how_to_get_one() {
    let folder = memory();
    let (code, _, err) = ask(folder.path(), &[COLLISIONS]);
    assert_eq!(code, 0);
    assert!(err.contains("--view FILE"), "{err}");
    let (_, _, err) = ask(folder.path(), &["owl_individual_of(C, semco:'Collision')"]);
    assert_eq!(err, "", "where nothing is shown, nothing is said");
}

#[test]
fn what_cannot_be_drawn_leaves_no_page() {
    let folder = memory();
    for (query, says) in [
        (
            "data_vis(piechart(p), [data: [[a, b], [1]]])",
            "piechart: data has 2 Xs, but 1 Ys",
        ),
        ("show(sponge, 5, plaid)", "plaid is not a color"),
    ] {
        let (code, _, err) = ask(folder.path(), &[query, "--view", "seen.html"]);
        assert_eq!(code, 2, "{query}");
        assert!(err.contains(says), "{query}: {err}");
    }
    let (code, _, err) = ask(folder.path(), &["true", "--view", "episodes"]);
    assert_eq!(code, 2);
    assert!(err.contains("--view"), "{err}");
    let files = fs::read_dir(folder.path()).unwrap();
    assert_eq!(files.count(), 1, "only the memory");
}

#[test]
fn what_the_memory_does_not_have_is_a_remark() {
    let folder = memory();
    for (query, says) in [
        ("show(sponge, 5)", "nothing was recorded between 5 and 5 s"),
        ("show(sponge, 1003)", "round-1.parquet"),
    ] {
        let (code, out, err) = ask(folder.path(), &[query, "--view", "seen.html"]);
        assert_eq!((code, out.as_str()), (0, "true\n"), "{query}: {err}");
        assert!(
            err.starts_with("note: ") && err.contains(says),
            "{query}: {err}"
        );
        let page = fs::read_to_string(folder.path().join("seen.html")).unwrap();
        assert!(page.contains(says), "{query}");
    }
}

#[test]
fn a_page_takes_a_query() {
    let folder = memory();
    let (code, _, err) = ask(folder.path(), &["--view", "seen.html"]);
    assert_eq!(code, 2);
    assert!(err.contains("QUERY"), "{err}");
}
