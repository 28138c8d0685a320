//! The drawing of an unrolled surface: how much it is stretched, and where a tool touches it with its whole footprint.

use crate::draw::{BANDS, Panel, Pen, View, count_decimals, format_decimal, px};
use maud::{Markup, html};
use wisch::geometry::{Bounds2, Point2, Sheet, SheetPoint, Vector2};

const WIDTH: f64 = 760.0;
/// Largest height of a map.
const MAP_HEIGHT: f64 = 330.0;
/// Height of the line above a map.
const HEAD: f64 = 24.0;
/// Height of the scale of colours below a map.
const SCALE: f64 = 54.0;
/// Number of cells along the longer side of the chart.
const CELLS: f64 = 160.0;
/// Width of a band in the scale of colours.
const BAND_WIDTH: f64 = 50.0;

/// An unrolled surface with a tool.
pub struct SheetInput<'a> {
    /// Title of the picture.
    pub title: &'a str,
    /// The surface.
    pub sheet: &'a Sheet,
    /// Limit of the stretch on 99 % of the area \[1\].
    pub stretch_limit: f64,
    /// Compression that the tool needs to touch a place with its whole footprint \[m\].
    pub needed_compression: &'a dyn Fn(&SheetPoint) -> f64,
    /// Compression depth of the tool \[m\].
    pub compression_depth: f64,
}

/// A map of the chart, with the scale of its colours.
struct Map<'a> {
    heading: String,
    /// Value at a point, in the unit of the scale.
    value: &'a dyn Fn(&SheetPoint) -> f64,
    limit: f64,
    unit: &'static str,
    above: String,
}

/// Draws the chart twice as SVG: coloured by stretch, and by the compression that the tool needs.
pub fn sheet_drawing(input: &SheetInput) -> String {
    let maps = [
        Map {
            heading: format!(
                "Stretch of lengths; the limit is {:.0} %",
                100.0 * input.stretch_limit
            ),
            value: &|point| 100.0 * point.stretch,
            limit: 100.0 * input.stretch_limit,
            unit: "%",
            above: "above the limit".to_owned(),
        },
        Map {
            heading: format!(
                "Compression that the tool needs to touch with its whole footprint; it has {} mm",
                1e3 * input.compression_depth
            ),
            value: &|point| 1e3 * (input.needed_compression)(point),
            limit: 1e3 * input.compression_depth,
            unit: "mm",
            above: "a part of the footprint does not touch".to_owned(),
        },
    ];
    let mut top = 0.0;
    let mut body = html! {};
    for (number, map) in maps.iter().enumerate() {
        let panel = draw_map(input.sheet, map, number);
        body = html! {
            (body)
            g transform=(format!("translate(0 {})", px(top))) { (panel.body) }
        };
        top += panel.height;
    }
    let what = "Unrolled surface; x and y are those of the chart";
    let panel = Panel {
        width: WIDTH,
        height: top,
        body,
    };
    panel.standalone(input.title, what)
}

fn draw_map(sheet: &Sheet, map: &Map, number: usize) -> Panel {
    let outline = sheet.outline();
    let bounds = Bounds2::from_points(outline.outer().iter().copied()).unwrap_or(Bounds2 {
        min: Point2::new(-0.5, -0.5),
        max: Point2::new(0.5, 0.5),
    });
    let view = View::with_axes(bounds, Vector2::new(WIDTH, MAP_HEIGHT));
    let cell = bounds.size().max() / CELLS;
    let count = |length: f64| (length / cell).ceil().max(1.0) as usize;
    let [columns, rows] = [count(bounds.size().x), count(bounds.size().y)];
    // The last pen is for values above the limit.
    let mut pens: [Pen; BANDS + 1] = Default::default();
    for row in 0..rows {
        let at = |column: usize, i: f64, j: f64| {
            bounds.min + Vector2::new(column as f64 + i, row as f64 + j) * cell
        };
        let band = |column: usize| {
            // The middle may be just outside where the cell is on the border.
            let offsets = [[0.5, 0.5], [0.1, 0.1], [0.9, 0.1], [0.1, 0.9], [0.9, 0.9]];
            let point = (offsets.iter()).find_map(|&[i, j]| sheet.lift(at(column, i, j)))?;
            let value = (map.value)(&point);
            let band = (value / map.limit * BANDS as f64) as usize;
            Some(if value > map.limit {
                BANDS
            } else {
                band.min(BANDS - 1)
            })
        };
        let bands: Vec<Option<usize>> = (0..columns).map(band).collect();
        let mut first = 0;
        for run in bands.chunk_by(|one, other| one == other) {
            let end = first + run.len();
            if let Some(band) = run[0] {
                let (low, high) = (view.at(at(first, 0.0, 0.0)), view.at(at(end, 0.0, 1.0)));
                pens[band].line([low, (high.0, low.1), high, (low.0, high.1)]);
                pens[band].close();
            }
            first = end;
        }
    }
    let clip = format!("chart-{number}");
    let rings = view.rings(outline.rings());
    let bottom = HEAD + view.bottom() + 8.0;
    let body = html! {
        text class="text" x="12" y="16" { (map.heading) }
        g transform=(format!("translate(0 {HEAD})")) {
            clipPath id=(clip) { path clip-rule="evenodd" d=(rings) {} }
            g clip-path=(format!("url(#{clip})")) {
                @for (i, pen) in pens.into_iter().enumerate() {
                    @let class = if i < BANDS { format!("cell band-{}", i + 1) } else { "beyond-limit".to_owned() };
                    path class=(class) d=(pen.path()) {}
                }
            }
            path class="outline" d=(rings) {}
            (view.axes())
        }
        g transform=(format!("translate(48 {})", px(bottom))) { (draw_scale(map)) }
    };
    Panel {
        width: WIDTH,
        height: bottom + SCALE,
        body,
    }
}

/// Draws the colours with their values; the last colour is above the limit.
fn draw_scale(map: &Map) -> Markup {
    let step = map.limit / BANDS as f64;
    let digits = count_decimals(step) + 1;
    let end = BANDS as f64 * BAND_WIDTH;
    html! {
        @for band in 0..BANDS {
            @let x = BAND_WIDTH * band as f64;
            rect class=(format!("band-{}", band + 1)) x=(px(x)) y="0" width=(px(BAND_WIDTH)) height="14" {}
            text class="text small quiet middle" x=(px(x)) y="28" { (format_decimal(step * band as f64, digits)) }
        }
        text class="text small quiet middle" x=(px(end)) y="28" { (format_decimal(map.limit, digits)) " " (map.unit) }
        rect class="beyond-limit" x=(px(end + 30.0)) y="0" width="24" height="14" {}
        text class="text small" x=(px(end + 62.0)) y="11" { (map.above) }
    }
}
