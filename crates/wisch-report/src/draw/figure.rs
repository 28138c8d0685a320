//! A picture with what explains it.

use super::legend::{self, Entry};
use super::panel::Panel;
use maud::html;

/// A picture with its name and what explains its marks.
pub(crate) struct Figure {
    pub(crate) panel: Panel,
    pub(crate) entries: Vec<Entry>,
    /// What is seen, for those who do not see it, and for the headline of the file.
    pub(crate) what: String,
}

impl Figure {
    /// As a file of its own, its legend so far from the left and right.
    pub(crate) fn standalone(self, title: &str, [left, right]: [f64; 2]) -> String {
        let panel = self.panel;
        let (legend, below) = legend::rows(
            &self.entries,
            [left, panel.height],
            panel.width - left - right,
        );
        Panel {
            height: panel.height + below,
            body: html! { (panel.body) (legend) },
            ..panel
        }
        .standalone(title, &self.what)
    }
}
