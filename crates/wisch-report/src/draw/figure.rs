//! A picture with its description and legend.

use super::legend::{self, Entry};
use super::panel::Panel;
use maud::html;

/// A picture with its description and legend.
pub(crate) struct Figure {
    pub(crate) panel: Panel,
    pub(crate) entries: Vec<Entry>,
    /// Description of the picture, for screen readers and for the headline of the file.
    pub(crate) what: String,
}

impl Figure {
    /// Returns an SVG file with a headline and a legend. The second argument: margins of the legend, left and right.
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
