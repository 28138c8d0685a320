use super::demo::{Demo, Trouble};
use super::*;
use crate::report::palette::page_rules;
use crate::report::rasterize;
use crate::report::tests::{KEEP, board, requests};
use maud::DOCTYPE;
use std::path::PathBuf;
use wisch::represent::Action;

fn keep(name: &str, bytes: impl AsRef<[u8]>) {
    let Some(folder) = std::env::var_os(KEEP).map(PathBuf::from) else {
        return;
    };
    std::fs::create_dir_all(&folder).expect("the folder can be made");
    std::fs::write(folder.join(name), bytes).expect("the file is written");
}

/// A page with nothing but the rounds.
fn page(section: &Markup) -> String {
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { "rounds" }
                style { (PreEscaped(page_rules())) (PreEscaped(include_str!("../page.css"))) }
            }
            body { main { (section) } }
        }
    }
    .into_string()
}

fn three_rounds() -> Demo {
    let troubles = [Trouble::Pushed, Trouble::Tilted(0.05), Trouble::Nothing];
    Demo::new(board(Action::Absorb), &troubles)
}

#[test]
fn three_rounds_are_shown() {
    let demo = three_rounds();
    let views = demo.views();
    let input = demo.input(&views);
    let rounds = demo.with_replays(&views);
    let html = page(&section_of(&input, &rounds));
    keep("rounds.html", &html);
    assert_eq!(requests(&html), [""; 0]);
    assert!(html.len() < 1_000_000, "{} bytes", html.len());
    let pictures = pictures_of(&input, &rounds);
    assert_eq!(pictures.len(), 1 + 3 * 5);
    for (stem, svg) in pictures {
        assert!(svg.len() < 150_000, "{stem}: {} bytes", svg.len());
        let png = rasterize(&svg, 1.5).expect("our own pictures can be drawn");
        keep(&format!("{stem}.svg"), &svg);
        keep(&format!("{stem}.png"), png);
    }
}
