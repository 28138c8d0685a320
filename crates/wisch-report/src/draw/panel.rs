//! A drawing, as part of a page or as a file.

use super::numbers::px;
use super::palette::standalone_rules;
use super::view::View;
use maud::{Markup, PreEscaped, html};

/// Width of a picture.
pub(crate) const WIDTH: f64 = 760.0;
/// Gap between the parts of a picture, and around them.
pub(crate) const GAP: f64 = 24.0;
/// Height of the headline of a picture in a file.
const HEADLINE: f64 = 44.0;

/// A drawing with its size.
pub(crate) struct Panel {
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) body: Markup,
}

impl Panel {
    /// Returns an empty drawing.
    pub(crate) fn empty() -> Self {
        Self {
            width: WIDTH,
            height: 0.0,
            body: html! {},
        }
    }

    /// Returns the drawing as part of a page, which defines the colours.
    pub(crate) fn inline(&self, label: &str) -> Markup {
        html! {
            svg viewBox=(format!("0 0 {} {}", px(self.width), px(self.height))) role="img" aria-label=(label) {
                (self.body)
            }
        }
    }

    /// Returns the drawing as a file with light colours and a headline.
    pub(crate) fn standalone(&self, title: &str, what: &str) -> String {
        let height = self.height + HEADLINE;
        html! {
            svg xmlns="http://www.w3.org/2000/svg" width=(px(self.width)) height=(px(height))
                viewBox=(format!("0 0 {} {}", px(self.width), px(height))) {
                style { (PreEscaped(standalone_rules())) }
                rect class="ground" width=(px(self.width)) height=(px(height)) {}
                text class="text strong" x="12" y="20" { (shorten(title, 70)) }
                text class="text small quiet" x="12" y="36" { (what) }
                g transform=(format!("translate(0 {HEADLINE})")) { (self.body) }
            }
        }
        .into_string()
    }
}

/// Clips `body` to the view.
pub(crate) fn inset(view: &View, body: Markup) -> Markup {
    let frame = [view.left(), view.top(), view.width(), view.height()].map(px);
    let [x, y, width, height] = &frame;
    html! {
        svg x=(x) y=(y) width=(width) height=(height) viewBox=(frame.join(" ")) { (body) }
    }
}

/// Shortens a text to `most` characters, with an ellipsis.
pub(crate) fn shorten(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        text.to_owned()
    } else {
        text.chars().take(most - 1).chain(['…']).collect()
    }
}
