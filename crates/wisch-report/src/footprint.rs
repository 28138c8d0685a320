//! The drawing of a footprint.

use std::fmt::Write as _;
use wisch::geometry::Point2;
use wisch::represent::Tool;
use wisch::source_location::escape_controls;

/// Margin around the drawing, as a share of the collision sphere's diameter [1].
const MARGIN: f64 = 0.1;
/// Width of the drawing on a page [pixels].
const WIDTH: u32 = 640;
/// Maximum share of the drawing's width for the scale bar [1].
const SCALE_BAR_SHARE: f64 = 0.4;

/// Draws the footprint, the tool centre point, the collision sphere r_s, the direction of motion and a scale as SVG.
/// The view is from above, with the tool's x axis (the motion) to the right; units are millimetres.
pub fn footprint_drawing(tool: &Tool) -> String {
    let mm = |metres: f64| 1e3 * metres;
    let radius = mm(tool.collision_radius());
    // A footprint need not enclose the tool centre point.
    let reach = tool
        .footprint
        .edges()
        .map(|edge| mm(edge.start.coords.amax()))
        .fold(radius, f64::max);
    let half = reach * (1.0 + 2.0 * MARGIN);
    let (low, side, line, text) = (-half, 2.0 * half, half / 150.0, half / 14.0);
    let (bold, dash, cross) = (2.0 * line, 4.0 * line, 3.0 * line);
    let (tip, barb) = (0.9 * half, 0.9 * half - 2.0 * cross);
    let bar = round_length(side * SCALE_BAR_SHARE);
    let (left, top, bottom) = (-0.92 * half, -0.92 * half + 0.5 * text, 0.92 * half);
    let above_bar = bottom - 0.4 * text;
    let (name, outline) = (escape(&tool.name), format_outline(tool));
    // Layers from below: background, collision sphere, footprint, tool centre point with its direction of motion, scale.
    format!(
        r##"<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{WIDTH}" viewBox="{low:.3} {low:.3} {side:.3} {side:.3}" font-family="sans-serif" font-size="{text:.3}">
<title>Footprint of {name}</title>
<rect x="{low:.3}" y="{low:.3}" width="{side:.3}" height="{side:.3}" fill="#ffffff"/>
<circle r="{radius:.3}" fill="none" stroke="#888888" stroke-width="{line:.3}" stroke-dasharray="{dash:.3} {dash:.3}"/>
<path fill="#14829e" fill-opacity="0.55" stroke="#0b5c8c" stroke-width="{line:.3}" fill-rule="evenodd" d="{outline}"/>
<path fill="none" stroke="#b3261e" stroke-width="{line:.3}" d="M{0:.3} 0H{tip:.3}M0 {0:.3}V{cross:.3}M{barb:.3} {0:.3}L{tip:.3} 0L{barb:.3} {cross:.3}"/>
<path stroke="#222222" stroke-width="{bold:.3}" d="M{left:.3} {bottom:.3}h{bar:.3}"/>
<text x="{left:.3}" y="{above_bar:.3}" fill="#222222">{bar} mm</text>
<text x="{left:.3}" y="{top:.3}" fill="#222222">{name}, r_s = {radius:.1} mm</text>
</svg>
"##,
        -cross
    )
}

/// Formats all rings as one path. The picture's y axis points down, the tool's up.
fn format_outline(tool: &Tool) -> String {
    let mut path = String::new();
    for ring in tool.footprint.polygons().iter().flat_map(|p| p.rings()) {
        for (i, Point2 { coords }) in ring.iter().enumerate() {
            let command = if i == 0 { 'M' } else { 'L' };
            // Writing to a String cannot fail.
            let _ = write!(
                path,
                "{command}{:.4} {:.4}",
                1e3 * coords.x,
                -1e3 * coords.y
            );
        }
        path.push('Z');
    }
    path
}

/// Returns the largest number of the form 1, 2 or 5 times a power of ten that is at most `length`.
fn round_length(length: f64) -> f64 {
    let power = 10f64.powf(length.log10().floor());
    [5.0, 2.0, 1.0]
        .into_iter()
        .map(|step| step * power)
        .find(|&candidate| candidate <= length)
        .unwrap_or(power)
}

fn escape(text: &str) -> String {
    escape_controls(text)
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch::geometry::{Mesh, Polygon, Region, Vector2, Vector3};
    use wisch::represent::AngleRange;

    #[test]
    fn scale_bars_are_round() {
        assert_eq!(round_length(7.3), 5.0);
        assert_eq!(round_length(49.0), 20.0);
        assert_eq!(round_length(10.0), 10.0);
    }

    #[test]
    fn the_drawing_is_a_picture_whatever_the_tool_is_called() {
        let size = Vector2::new(0.07, 0.11);
        let tool = Tool {
            name: "<sponge> & \"co\"".to_owned(),
            mesh: Mesh::cuboid(Vector3::new(size.x, size.y, 0.05)).unwrap(),
            footprint: Region::new(vec![Polygon::rectangle(size)]),
            area_of_effect: size,
            rotation_about_normal: AngleRange::FULL,
            tilt: None,
            mount: None,
            second_grip: None,
        };
        crate::rasterize(&footprint_drawing(&tool), 1.0).unwrap();
    }
}
