//! URDFs for viewers, which draw collision shapes translucent or not at all.

use super::xml::parsing_options;
use roxmltree::{Document, Node};
use std::borrow::Cow;
use std::fmt::Write;

/// Colour of the added shapes: red, green, blue.
const COLOR: &str = "0.72 0.76 0.8";
/// Opacity of the shapes of the link that holds the tool, which may enclose it.
const HAND_OPACITY: f64 = 0.3;

/// Returns a URDF for viewers. If no link has visual geometry, each link gets its collision shapes
/// as visual geometry: opaque, except for the link `hand`, whose shapes may enclose the tool. Any
/// other text is returned as it is.
///
/// ```
/// use wisch_robot::show_collision_shapes;
///
/// let urdf = r#"<robot name="r"><link name="arm"><collision><geometry><sphere radius="0.1"/></geometry></collision></link></robot>"#;
/// assert!(show_collision_shapes(urdf, "hand").contains(r#"<visual><geometry><sphere radius="0.1"/></geometry>"#));
/// ```
pub fn show_collision_shapes<'a>(urdf: &'a str, hand: &str) -> Cow<'a, str> {
    let Ok(document) = Document::parse_with_options(urdf, parsing_options()) else {
        return urdf.into();
    };
    let links = || {
        document
            .root_element()
            .children()
            .filter(|node| node.has_tag_name("link"))
    };
    let shapes = |link: Node<'_, '_>, kind: &str| {
        (link.children())
            .filter(|node| node.has_tag_name(kind))
            .map(|node| node.range())
            .collect::<Vec<_>>()
    };
    if links().any(|link| !shapes(link, "visual").is_empty()) {
        return urdf.into();
    }
    let mut shown = String::with_capacity(2 * urdf.len());
    let mut copied = 0;
    for link in links() {
        let opacity = if link.attribute("name") == Some(hand) {
            HAND_OPACITY
        } else {
            1.0
        };
        for collision in link
            .children()
            .filter(|node| node.has_tag_name("collision"))
        {
            shown += &urdf[copied..collision.range().end];
            copied = collision.range().end;
            shown += "<visual>";
            for part in collision.children().filter(Node::is_element) {
                if part.has_tag_name("origin") || part.has_tag_name("geometry") {
                    shown += &urdf[part.range()];
                }
            }
            let _ = write!(
                shown,
                r#"<material name="shape_{opacity}"><color rgba="{COLOR} {opacity}"/></material></visual>"#
            );
        }
    }
    shown += &urdf[copied..];
    shown.into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Appearance, RobotModel};

    const BARE: &str = r#"<robot name="r">
  <link name="base"><collision><origin xyz="0 0 0.1"/><geometry><box size="0.1 0.2 0.3"/></geometry></collision></link>
  <link name="hand"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <joint name="j" type="fixed"><parent link="base"/><child link="hand"/></joint>
</robot>"#;

    #[test]
    fn a_robot_without_visual_geometry_shows_its_collision_shapes() {
        let shown = show_collision_shapes(BARE, "hand");
        let mut no_mesh = |_: &str| Err(String::new());
        let model = RobotModel::from_urdf("r", &shown, &mut no_mesh).expect("it is a URDF");
        let appearance = Appearance::from_urdf("r", &shown, &model, &mut no_mesh);
        let appearance = appearance.expect("it is a URDF");
        let opacity = |name: &str| {
            let link = model.link(name).expect("it is there");
            let visuals = appearance.visuals(link).expect("it is visible");
            assert_eq!(visuals.len(), 1, "{name}");
            visuals[0].color.expect("it has a colour")[3]
        };
        assert_eq!((opacity("base"), opacity("hand")), (1.0, 0.3));
        let bare = RobotModel::from_urdf("r", BARE, &mut no_mesh).expect("it is a URDF");
        assert_eq!(bare.links(), model.links(), "nothing else changes");
    }

    #[test]
    fn a_urdf_with_visuals_or_broken_xml_is_unchanged() {
        let shown = show_collision_shapes(BARE, "hand").into_owned();
        assert_eq!(show_collision_shapes(&shown, "hand"), shown);
        assert_eq!(show_collision_shapes("<robot", "hand"), "<robot");
    }
}
