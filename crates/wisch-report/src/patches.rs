//! A surface that is divided into patches: its drawing, and the page of a command over all patches.

use crate::draw::{BANDS, Panel, View, px};
use crate::page::document::document;
use maud::{PreEscaped, html};
use wisch::geometry::{Bounds2, Point2, Polygon, Vector2};

const WIDTH: f64 = 760.0;
/// Largest height of the map.
const MAP_HEIGHT: f64 = 560.0;
/// Room below the map.
const FOOT: f64 = 12.0;
/// Distance between the colours of consecutive patches, in bands.
const COLOUR_STEP: usize = 3;

/// A surface that is divided into patches.
pub struct PatchesInput<'a> {
    /// Title of the picture.
    pub title: &'a str,
    /// Outlines of the patches, on the surface unrolled as one piece \[m\].
    pub patches: &'a [Polygon],
}

/// Draws the patches with their numbers as SVG.
pub fn patches_drawing(input: &PatchesInput) -> String {
    let points = input.patches.iter().flat_map(|patch| patch.outer());
    let bounds = Bounds2::from_points(points.copied()).unwrap_or(Bounds2 {
        min: Point2::new(-0.5, -0.5),
        max: Point2::new(0.5, 0.5),
    });
    let view = View::with_axes(bounds, Vector2::new(WIDTH, MAP_HEIGHT));
    // The two lightest and the two darkest colours hide numbers.
    let band = |index: usize| 2 + (COLOUR_STEP * index) % (BANDS - 3);
    let body = html! {
        @for (index, patch) in input.patches.iter().enumerate() {
            path class=(format!("cell band-{}", band(index))) fill-rule="evenodd" d=(view.rings(patch.rings())) {}
        }
        @for patch in input.patches {
            path class="outline" d=(view.rings(patch.rings())) {}
        }
        @for (index, patch) in input.patches.iter().enumerate() {
            @let (x, y) = view.at(find_innermost(patch));
            text class="text strong middle halo" x=(px(x)) y=(px(y + 5.0)) { (index + 1) }
        }
        (view.axes())
    };
    let what = "Patches on the surface unrolled as one piece, which stretches it; x and y are those of that chart";
    let panel = Panel {
        width: WIDTH,
        height: view.bottom() + FOOT,
        body,
    };
    panel.standalone(input.title, what)
}

const STYLE: &str = "table.facts th { padding-right: 1.5em; white-space: nowrap; } table.facts td { text-align: left; } \
                     table.patches { max-width: none; } table.patches th, table.patches td { padding-right: 1.5em; } \
                     table.patches td.words { text-align: left; } table.patches th.number { text-align: right; } figure svg { max-width: 100%; height: auto; } rect.bar { fill: currentColor; } \
                     table.steps td, table.steps th { white-space: nowrap; overflow-wrap: normal; } \
                     table.steps td.words { white-space: normal; min-width: 11em; } table.steps svg { width: 100px; min-width: 0; height: 14px; display: block; margin-top: 0.4em; }";

/// Input of the page of a command over all patches.
pub struct PatchesPageInput<'a> {
    /// Name of the task.
    pub title: &'a str,
    /// Results on all patches together: name and value.
    pub facts: &'a [(String, String)],
    /// Outlines of all patches, on the surface unrolled as one piece \[m\].
    pub outlines: &'a [Polygon],
    /// The patches, in the order of their numbers.
    pub patches: &'a [PatchRow],
}

/// A patch on the page of all patches.
pub struct PatchRow {
    /// Area \[m²\].
    pub area: f64,
    /// Results on the patch; `None` if it was not wiped.
    pub found: Option<PatchFound>,
}

/// Results of a command on one patch.
pub struct PatchFound {
    /// Whether the goal is met, in words.
    pub goal: String,
    /// The performance, in words.
    pub performance: String,
    /// Number of strokes.
    pub strokes: usize,
    /// Path length in contact \[m\].
    pub distance: f64,
    /// Address of its own page, relative to this one; `None` without a page.
    pub report: Option<String>,
}

/// Returns one self-contained HTML file, which loads nothing from the network.
pub fn patches_page(input: &PatchesPageInput) -> String {
    let outlines = PatchesInput {
        title: input.title,
        patches: input.outlines,
    };
    let main = html! {
        h1 { (input.title) }
        table class="facts" {
            @for (name, value) in input.facts {
                tr { th scope="row" { (name) } td { (value) } }
            }
        }
        figure { (PreEscaped(patches_drawing(&outlines))) }
        div class="scroll" {
            table class="patches" {
                thead { tr {
                    th scope="col" { "patch" } th scope="col" class="number" { "area [m²]" } th scope="col" { "goal" }
                    th scope="col" { "performance" } th scope="col" class="number" { "strokes" }
                    th scope="col" class="number" { "in contact [m]" }
                } }
                tbody {
                    @for (row, number) in input.patches.iter().zip(1..) {
                        tr {
                            th scope="row" {
                                @match row.found.as_ref().and_then(|found| found.report.as_ref()) {
                                    Some(report) => a href=(report) { "patch " (number) },
                                    None => { "patch " (number) },
                                }
                            }
                            td { (format!("{:.4}", row.area)) }
                            @match &row.found {
                                Some(found) => {
                                    td class="words" { (found.goal) } td class="words" { (found.performance) }
                                    td { (found.strokes) } td { (format!("{:.2}", found.distance)) }
                                },
                                None => td class="words" colspan="4" { "not wiped" },
                            }
                        }
                    }
                }
            }
        }
    };
    document(input.title, STYLE, &main)
}

/// A step on the page of a goal of several parts.
pub struct StepRow {
    /// The step in words, such as `fetch sponge`.
    pub words: String,
    /// Start of the step, since the start of the first step \[s\].
    pub began: f64,
    /// Actual time \[s\].
    pub took: f64,
    /// Expected time \[s\].
    pub expected: f64,
    /// The result in words; empty for a step that does not wipe.
    pub result: String,
    /// Address of its own page, relative to this one; `None` without a page.
    pub report: Option<String>,
}

/// Returns one self-contained HTML file over the steps of a goal, which loads nothing from the network.
///
/// `title`: name of the task; `facts`: names and values, such as the parts of the goal and whether they hold; `steps`: the steps,
/// in order.
pub fn steps_page(title: &str, facts: &[(String, String)], steps: &[StepRow]) -> String {
    let end = steps
        .last()
        .map_or(1.0, |step| step.began + step.took)
        .max(1e-9);
    let main = html! {
        h1 { (title) }
        table class="facts" {
            @for (name, value) in facts {
                tr { th scope="row" { (name) } td { (value) } }
            }
        }
        div class="scroll" {
            table class="patches steps" {
                thead { tr {
                    th scope="col" { "step" } th scope="col" { "action" } th scope="col" { "result" }
                    th scope="col" { "course" }
                    th scope="col" class="number" { "began [s]" } th scope="col" class="number" { "took [s]" }
                    th scope="col" class="number" { "expected [s]" }
                } }
                tbody {
                    @for (step, number) in steps.iter().zip(1..) {
                        tr {
                            th scope="row" { (number) }
                            td class="words" {
                                @match &step.report {
                                    Some(report) => a href=(report) { (step.words) },
                                    None => (step.words),
                                }
                            }
                            td class="words" { (step.result) }
                            td {
                                svg width="100" height="14" role="img" aria-label="when the step took place" {
                                    rect class="bar" x=(px(100.0 * step.began / end)) y="3" height="8"
                                        width=(px((100.0 * step.took / end).max(1.0))) {}
                                }
                            }
                            td { (format!("{:.1}", step.began)) } td { (format!("{:.1}", step.took)) }
                            td { (format!("{:.1}", step.expected)) }
                        }
                    }
                }
            }
        }
    };
    document(title, STYLE, &main)
}

/// Number of places along each side of a patch at which a number may stand.
const PLACES: u32 = 24;

/// Returns the place within a patch that is farthest from its border.
fn find_innermost(patch: &Polygon) -> Point2 {
    let Some(bounds) = Bounds2::from_points(patch.outer().iter().copied()) else {
        return Point2::origin();
    };
    let share = |i: u32| (f64::from(i) + 0.5) / f64::from(PLACES);
    let places =
        (0..PLACES).flat_map(|i| (0..PLACES).map(move |j| Vector2::new(share(i), share(j))));
    let places = places.map(|share| bounds.min + bounds.size().component_mul(&share));
    let depth = |place: Point2| {
        let edges = patch.edges().map(|edge| edge.distance(place));
        edges.fold(f64::INFINITY, f64::min)
    };
    let within = places.filter(|place| patch.contains(*place));
    let deepest = within.map(|place| (depth(place), place));
    let deepest = deepest.max_by(|one, two| one.0.total_cmp(&two.0));
    deepest.map_or(bounds.center(), |(_, place)| place)
}
