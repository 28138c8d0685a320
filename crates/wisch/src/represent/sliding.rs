//! Loose dirt on a steep surface, which slides before the first round.

use super::{Fate, MediumKind, OccupiedArea, ParticleDistribution, Surface};
use crate::geometry::{Bounds2, Mesh, Point2, Vector2, Vector3};

/// Step at which the path of a sliding particle is checked for objects [m], and most steps.
const STEP: f64 = 0.002;
const MAX_STEPS: f64 = 500.0;
/// Distance beyond a border at which a particle that slid over it is placed [m].
const BEYOND: f64 = 1e-3;

/// Friction coefficients of dry grains and of wet dirt at rest on a surface [1].
const DRY_FRICTION: f64 = 0.8;
const WET_FRICTION: f64 = 1.5;

/// Returns the friction coefficient of dirt at rest on a surface \[1\]. Grains hold by their edges and wet dirt by
/// adhesion, at least as well as a tool slides on the surface, whose friction is `of_surface` \[1\]. An assumption, the
/// same in prediction and simulation.
pub fn dirt_friction(kind: MediumKind, of_surface: f64) -> f64 {
    let of_dirt = match kind {
        MediumKind::Solid | MediumKind::Powder => DRY_FRICTION,
        MediumKind::Liquid => WET_FRICTION,
    };
    of_surface.max(of_dirt)
}

/// A surface too steep for loose dirt to rest on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteepSurface {
    /// Angle between the surface's normal and the vertical \[rad\].
    pub slope: f64,
    /// Coefficient of friction of the dirt on the surface \[1\], see [`dirt_friction`].
    pub friction: f64,
    /// Number of particles on the surface before they slid.
    pub lay: usize,
    /// Number of particles that slid over a border or into a hole.
    pub left: usize,
}

impl std::fmt::Display for SteepSurface {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            slope,
            friction,
            lay,
            left,
        } = self;
        let angle = slope.to_degrees();
        let steep = match *slope < std::f64::consts::FRAC_PI_2 {
            true => format!(
                "tan({angle:.1}°) = {:.2} exceeds the friction of the dirt on it, {friction}",
                slope.tan()
            ),
            false => format!("it leans by {angle:.1}°"),
        };
        write!(
            f,
            "the surface is too steep for the dirt to rest, {steep}: {left} of {lay} particles slide off before the first round"
        )
    }
}

/// Lets loose dirt slide down a surface whose slope exceeds its friction. Each particle moves straight down until it
/// meets an object, a hole or a border. `None` if the dirt rests, that is if tan(slope) is at most the friction.
///
/// `obstacles`: meshes in the surface frame. Particles that are already gone stay as they are.
pub fn slide_down(
    particles: &ParticleDistribution,
    surface: &Surface,
    obstacles: &[Mesh],
    friction: f64,
) -> Option<(ParticleDistribution, SteepSurface)> {
    let down = surface.world_from_surface.rotation.inverse() * -Vector3::z();
    let (along, into) = (Vector2::new(down.x, down.y), -down.z);
    // Gravity along the surface against Coulomb friction from gravity into it.
    if along.norm() <= friction * into {
        return None;
    }
    let bounds = Bounds2::from_points(surface.outline.outer().iter().copied())?;
    let length = bounds.size().norm() + BEYOND;
    // Under a ceiling dirt falls, in a direction that does not matter.
    let direction = along.try_normalize(1e-9).unwrap_or_else(Vector2::x);
    let occupied = OccupiedArea::from_scene(obstacles);
    let mut slid = particles.clone();
    let (mut lay, mut left) = (0, 0);
    for (index, (from, fate)) in particles.iter().enumerate() {
        if fate != Fate::OnSurface {
            continue;
        }
        lay += 1;
        let end = exit_point(surface, from, direction, length);
        let way = (end - from).norm();
        let stopped = (!obstacles.is_empty() && into > 0.0)
            .then(|| find_stop(&occupied, from, direction, way))
            .flatten();
        match stopped {
            Some(place) => slid.put(index, place, Fate::OnSurface),
            None => {
                left += 1;
                let edge = surface.exit_edge(from, end + direction * BEYOND);
                let edge = edge.and_then(|edge| u16::try_from(edge).ok()).unwrap_or(0);
                slid.put(index, end + direction * BEYOND, Fate::OffSurface { edge });
            }
        }
    }
    let steep = SteepSurface {
        slope: along.norm().atan2(into),
        friction,
        lay,
        left,
    };
    Some((slid, steep))
}

/// Returns where a straight move leaves the surface.
fn exit_point(surface: &Surface, from: Point2, direction: Vector2, length: f64) -> Point2 {
    let leaves = |edge: crate::geometry::Edge| {
        let border = edge.end - edge.start;
        let divisor = direction.perp(&border);
        let way = (edge.start - from).perp(&border) / divisor;
        let on_border = (edge.start - from).perp(&direction) / divisor;
        (divisor != 0.0 && way >= 0.0 && (0.0..=1.0).contains(&on_border)).then_some(way)
    };
    let ways = surface.outline.edges().filter_map(leaves);
    from + direction * ways.fold(length, f64::min)
}

/// Returns the place before the first object on a straight move, if there is one.
fn find_stop(
    occupied: &OccupiedArea,
    from: Point2,
    direction: Vector2,
    way: f64,
) -> Option<Point2> {
    let step = STEP.max(way / MAX_STEPS);
    let count = (way / step) as usize;
    let at = |i: usize| from + direction * (step * i as f64);
    let first = (1..=count).find(|&i| occupied.contains(at(i)))?;
    Some(at(first - 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Polygon, Pose};

    /// A board of 0.6 x 0.4 m that leans towards −x.
    fn leaning(slope: f64) -> Surface {
        Surface {
            name: "board".into(),
            outline: Polygon::rectangle(Vector2::new(0.6, 0.4)),
            world_from_surface: Pose::new(Vector3::new(0.5, 0.0, 0.4), -Vector3::y() * slope),
            skim_edges: vec![],
            shape: Default::default(),
        }
    }

    fn dirt() -> ParticleDistribution {
        let places = [[0.2, 0.1], [-0.1, -0.15], [0.25, 0.0]].map(Point2::from);
        ParticleDistribution::new(&places).unwrap()
    }

    #[test]
    fn dirt_rests_up_to_the_angle_of_friction_and_slides_off_the_lower_edge_beyond_it() {
        let steepest = 0.3_f64.atan();
        assert_eq!(
            slide_down(&dirt(), &leaning(steepest - 1e-6), &[], 0.3),
            None
        );
        assert_eq!(slide_down(&dirt(), &leaning(0.0), &[], 0.0), None);
        let (slid, steep) = slide_down(&dirt(), &leaning(0.7), &[], 0.3).unwrap();
        assert_eq!((steep.lay, steep.left), (3, 3));
        assert!((steep.slope - 0.7).abs() < 1e-12);
        for ((before, _), (after, fate)) in dirt().iter().zip(slid.iter()) {
            // Straight down to x = −0.3 or 0.3, the lower of the two.
            let world_from_surface = leaning(0.7).world_from_surface;
            let lower = |p: Point2| (world_from_surface * nalgebra::Point3::new(p.x, p.y, 0.0)).z;
            assert!(lower(after) < lower(before));
            assert!((after.x.abs() - 0.3).abs() < 2e-3 && (after.y - before.y).abs() < 1e-9);
            let edge = if after.x < 0.0 { 3 } else { 1 };
            assert_eq!(fate, Fate::OffSurface { edge });
        }
    }

    #[test]
    fn dirt_rests_above_an_object_and_falls_off_walls_and_ceilings() {
        let surface = leaning(0.7);
        let bar = Mesh::cuboid(Vector3::new(0.02, 0.4, 0.02)).unwrap();
        let (slid, steep) = slide_down(&dirt(), &surface, &[bar], 0.3).unwrap();
        // The bar lies across at x = 0; what lies below it slides off.
        let down = surface.world_from_surface.rotation.inverse() * -Vector3::z();
        let above = dirt().iter().filter(|(p, _)| p.x * down.x < 0.0).count();
        assert_eq!(steep.left, 3 - above);
        for (place, fate) in slid.iter().filter(|(_, fate)| *fate == Fate::OnSurface) {
            assert!((0.01..0.0125).contains(&place.x.abs()), "{place} {fate:?}");
        }
        for slope in [1.6, 2.0, std::f64::consts::PI] {
            let (_, steep) = slide_down(&dirt(), &leaning(slope), &[], 5.0).unwrap();
            assert_eq!(steep.left, 3, "{slope}");
        }
    }
}
