//! Legends: as a list of a page, and as rows of a picture.

use super::numbers::px;
use maud::{Markup, html};

/// Height of a row [units of the picture].
const ROW: f64 = 23.0;

/// A mark and its meaning.
pub(crate) struct Entry {
    pub(crate) label: String,
    /// Sample of the mark: 24 by 14 units around (12, 0).
    pub(crate) sample: Markup,
}

/// Returns an entry with a line of a CSS class.
pub(crate) fn line(class: &str, label: impl Into<String>) -> Entry {
    Entry {
        label: label.into(),
        sample: html! { path class=(class) d="M2 0h20" {} },
    }
}

/// Returns an entry with an area of a CSS class.
pub(crate) fn area(class: &str, label: impl Into<String>) -> Entry {
    Entry {
        label: label.into(),
        sample: html! { rect class=(class) x="3" y="-5.5" width="18" height="11" {} },
    }
}

/// Returns an entry with a dot of a CSS class.
pub(crate) fn dot(class: &str, label: impl Into<String>) -> Entry {
    Entry {
        label: label.into(),
        sample: html! { path class=(class) stroke-width="7" d="M12 0h0" {} },
    }
}

/// Returns the legend as a list of a page.
pub(crate) fn list(entries: &[Entry]) -> Markup {
    html! {
        @if !entries.is_empty() {
            ul class="legend" { (items(entries)) }
        }
    }
}

/// Returns the items of the legend's list.
pub(crate) fn items(entries: &[Entry]) -> Markup {
    html! {
        @for entry in entries {
            li {
                svg viewBox="0 -9 24 18" width="24" height="18" aria-hidden="true" { (entry.sample) }
                (entry.label)
            }
        }
    }
}

/// Draws the legend as rows of a picture, with its upper left corner at `corner`; returns its height, too.
pub(crate) fn rows(entries: &[Entry], corner: [f64; 2], width: f64) -> (Markup, f64) {
    let [left, top] = corner;
    let (mut x, mut row) = (0.0, 0);
    let mut places = Vec::with_capacity(entries.len());
    for entry in entries {
        let wide = 31.0 + estimate_text_width(&entry.label) + 20.0;
        if x > 0.0 && x + wide > width {
            (x, row) = (0.0, row + 1);
        }
        places.push((entry, left + x, top + ROW * (f64::from(row) + 0.5)));
        x += wide;
    }
    let rows = if entries.is_empty() { 0 } else { row + 1 };
    let body = html! {
        @for (entry, x, y) in places {
            g transform=(format!("translate({} {})", px(x), px(y))) {
                (entry.sample)
                text class="text" font-size="12" x="31" y="4.3" { (entry.label) }
            }
        }
    };
    (body, ROW * f64::from(rows) + 8.0)
}

/// Estimates the width of a text of 12 units in Inter or a similar font.
fn estimate_text_width(text: &str) -> f64 {
    text.chars()
        .map(|c| match c {
            'i' | 'j' | 'l' | 't' | 'f' | 'r' | ' ' | ',' | '.' | '\'' => 4.4,
            'm' | 'w' => 10.4,
            _ => 7.2,
        })
        .sum()
}
