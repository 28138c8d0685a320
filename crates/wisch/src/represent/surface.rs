//! The target surface: a planar polygon with a pose and the edges over which a skim may push.

use crate::geometry::{Edge, Point2, Polygon, Pose};

/// A planar target surface. Its frame has z pointing out of the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Name, as the knowledge base and PDDL goals call it.
    pub name: String,
    /// Outline in the surface frame [m].
    pub outline: Polygon,
    /// Where the surface stands in the world.
    pub world_from_surface: Pose,
    /// Indices of the outline's edges over which a skim may push particles.
    pub skim_edges: Vec<usize>,
}

impl Surface {
    /// The edge over which a straight move from `from` (on the surface) to `to` leaves it first.
    ///
    /// A move that ends inside but crosses a notch on its way has left the surface all the same.
    pub fn exit_edge(&self, from: Point2, to: Point2) -> Option<usize> {
        self.outline
            .edges()
            .enumerate()
            .filter_map(|(index, edge)| crossing(from, to, &edge).map(|share| (share, index)))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, index)| index)
    }

    /// Whether edge `index` is one over which a skim may push.
    pub fn is_skim_edge(&self, index: usize) -> bool {
        self.skim_edges.contains(&index)
    }
}

/// Where along `from → to` (0..1) the move crosses the edge outwards; `None` if it does not.
fn crossing(from: Point2, to: Point2, edge: &Edge) -> Option<f64> {
    let along = edge.end - edge.start;
    // The interior lies left of the edge: positive side = inside.
    let side_from = along.perp(&(from - edge.start));
    let side_to = along.perp(&(to - edge.start));
    if side_from < 0.0 || side_to >= 0.0 {
        return None;
    }
    let s = side_from / (side_from - side_to);
    let at = from + (to - from) * s;
    let t = (at - edge.start).dot(&along) / along.norm_squared();
    (0.0..=1.0).contains(&t).then_some(s)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector2;

    #[test]
    fn a_move_leaves_over_the_first_edge_it_crosses() {
        let surface = Surface {
            name: "board".into(),
            outline: Polygon::rectangle(Vector2::new(0.4, 0.2)),
            world_from_surface: Pose::identity(),
            skim_edges: vec![0],
        };
        let from = Point2::new(0.15, 0.05);
        assert_eq!(surface.exit_edge(from, Point2::new(0.19, 0.09)), None);
        assert_eq!(surface.exit_edge(from, Point2::new(0.15, -0.2)), Some(0));
        assert_eq!(surface.exit_edge(from, Point2::new(0.5, 0.2)), Some(1));
        assert_eq!(surface.exit_edge(from, Point2::new(0.15, 0.4)), Some(2));
        assert_eq!(surface.exit_edge(from, Point2::new(-1.0, 0.05)), Some(3));
    }
}
