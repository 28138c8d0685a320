//! Self-contained HTML files, which load nothing from the network.

use crate::draw::page_rules;
use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = include_str!("page.css");

/// Returns an HTML file. `style`: CSS rules of this page beside the common rules. `main`: its contents.
pub(crate) fn document(title: &str, style: &str, main: &Markup) -> String {
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(page_rules())) (PreEscaped(STYLE)) (PreEscaped(style)) }
            }
            body { main { (main) } }
        }
    }
    .into_string()
}
