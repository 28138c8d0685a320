//! Checks of a task on a curved surface: the contact model holds for the tool, the dirt does not
//! slide, and no object is near. A tool that touches with a part of its footprint is planned with
//! that part ([`BendContact`]).

use super::PlanError;
use crate::geometry::{Bounds2, Mesh, Point2, Point3, Vector2};
use crate::represent::{
    ElasticFoundation, LocalPressure, SURFACE_SKIN, Surface, SurfaceShape, Task, dirt_friction,
    effective_pressure,
};
use nalgebra::{Matrix2, Rotation2};
use rayon::prelude::*;
use std::f64::consts::PI;
use std::fmt;

/// Ranges of the touched share and of the pressure [1].
type Ranges = [[f64; 2]; 2];

/// Number of yaws at which the tool is tried.
const YAWS: usize = 90;
/// Half the distance between the checked points of an object [m], which is also their slack.
const SEARCH_STEP: f64 = 0.01;
/// Largest ratio of the distance between two places in space to their distance in the chart [1]:
/// charts of meshes are stretched by a few percent.
const MOST_STRETCH: f64 = 1.1;

/// Contact of an upright tool with a curved surface, at nominal force.
///
/// The tool is an elastic foundation with the compression δ of the task, at least
/// [`RIGID_COMPRESSION`](crate::represent::RIGID_COMPRESSION).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BendContact {
    /// Least and largest share of the footprint that touches, over all yaws; on a cone or a mesh,
    /// also over all places \[1\].
    pub touched_share: [f64; 2],
    /// Least and largest pressure over the nominal pressure, over the footprint and all yaws \[1\];
    /// 0 where the tool does not touch. Foam bottoms out beyond
    /// [`MAX_PRESSURE`](crate::represent::MAX_PRESSURE).
    pub pressure: [f64; 2],
    /// Length across the bend of the longest rectangular tool that would touch everywhere \[m\].
    pub fitting_length: f64,
    /// Compression δ that the model assumes \[m\].
    pub compression: f64,
}

impl BendContact {
    /// Returns the contact of a task's tool; `None` on a plane, and for a tool that hovers.
    ///
    /// ```
    /// use wisch::plan::BendContact;
    /// use wisch::prelude::*;
    /// use wisch::represent::SurfaceShape;
    ///
    /// let mut pipe = Surface::new("pipe", Polygon::rectangle(Vector2::new(0.4, 0.3)), Pose::identity());
    /// pipe.shape = SurfaceShape::Cylinder { radius: 0.5, axis: 0.0 };
    /// let plate = Tool::pad("plate", Vector3::new(0.06, 0.1, 0.02))?;
    /// let dirt = ParticleDistribution::new(&[Point2::origin()])?;
    /// let mut task = Task::new(Action::Absorb, pipe, plate, "crumbs", dirt);
    /// task.interaction.compression_depth_m = 0.0;
    /// let contact = BendContact::from_task(&task).expect("the pipe bends");
    /// assert!(contact.touched_share[0] < 0.4);
    /// // √(12 δ R)
    /// assert!((contact.fitting_length - 0.0245).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_task(task: &Task) -> Option<Self> {
        if task.surface.shape.is_plane() {
            return None;
        }
        let tool = ElasticFoundation::from_interaction(&task.tool.footprint, &task.interaction)?;
        let widen =
            |[low, high]: [f64; 2], [least, most]: [f64; 2]| [low.min(least), high.max(most)];
        let merge = |[share, pressure]: Ranges, other: Ranges| {
            [widen(share, other[0]), widen(pressure, other[1])]
        };
        let nothing = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        let turns: Vec<Rotation2<f64>> = yaws().map(Rotation2::new).collect();
        let at_bend = |bend: &Matrix2<f64>| {
            let at_yaw = |turn| {
                let (here, _) = tool.press_turned(bend, turn);
                let pressure = tool.range(&here).map(|value| value.max(0.0));
                [[tool.touched_share(&here); 2], pressure]
            };
            turns.iter().map(at_yaw).fold(nothing, merge)
        };
        let bends = task.surface.bends();
        // Minima and maxima are the same in any order.
        let [touched_share, pressure] =
            (bends.par_iter().map(|(_, bend)| at_bend(bend))).reduce(|| nothing, merge);
        // κL² = 12 δ on a bulge, 24 δ in a hollow.
        let radii = task.surface.least_radii();
        let length = |factor: f64, radius: f64| libm::sqrt(factor * tool.compression() * radius);
        Some(Self {
            touched_share,
            pressure,
            fitting_length: length(12.0, radii.bulge).min(length(24.0, radii.hollow)),
            compression: tool.compression(),
        })
    }
}

impl fmt::Display for BendContact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [least, most] = self.touched_share.map(|share| 100.0 * share);
        let [weakest, strongest] = self.pressure;
        let compression = 1e3 * self.compression;
        if least >= 100.0 {
            write!(f, "the whole tool touches the bend at every yaw")?;
        } else if most - least < 0.5 {
            write!(f, "{least:.0} % of the tool touches the bend")?;
        } else {
            write!(
                f,
                "{least:.0} to {most:.0} % of the tool touches the bend, depending on its yaw"
            )?;
        }
        write!(
            f,
            "; pressure {weakest:.2} to {strongest:.2} of the nominal one, for a compression of {compression:.1} mm"
        )?;
        if least < 100.0 {
            write!(
                f,
                "; a tool square to the bend and at most {:.3} m long across it would touch everywhere",
                self.fitting_length
            )?;
        }
        Ok(())
    }
}

/// The yaws at which the tool is tried [rad]; a half turn changes no contact.
fn yaws() -> impl Iterator<Item = f64> {
    (0..YAWS).map(|i| i as f64 * PI / YAWS as f64)
}

/// Returns the foundation of a task's tool, its pressure at a yaw [rad], and the least pressure at
/// which it acts, on the tightest bend of the surface. `None` on a plane, for a tool that hovers,
/// and if the whole tool acts.
pub(super) fn partial_contact(
    task: &Task,
    yaw: f64,
) -> Option<(ElasticFoundation, LocalPressure, f64)> {
    if task.surface.shape.is_plane() {
        return None;
    }
    let bend = task.surface.tightest_bend();
    let tool = ElasticFoundation::from_interaction(&task.tool.footprint, &task.interaction)?;
    let least = effective_pressure(&task.interaction.likelihood);
    let pressure = tool.press_upright(&bend, yaw);
    (tool.range(&pressure)[0] < least).then_some((tool, pressure, least))
}

/// Returns a vector across a hollow [m]: nearer to its centre than the length of this vector, the
/// tool acts at no yaw. Zero on other surfaces; a cone or a mesh has no common direction of its
/// hollows.
pub(super) fn gap_in_hollow(task: &Task) -> Vector2 {
    let SurfaceShape::Cylinder { radius, axis } = task.surface.shape else {
        return Vector2::zeros();
    };
    let tool = ElasticFoundation::from_interaction(&task.tool.footprint, &task.interaction);
    let Some(tool) = tool.filter(|_| radius < 0.0) else {
        return Vector2::zeros();
    };
    let least = effective_pressure(&task.interaction.likelihood);
    let bend = task.surface.shape.bend(Point2::origin());
    // f′(u) = m + u²/2δ|R| reaches the limit at u² = 2 (limit − m) δ |R|.
    let gaps = yaws().map(|yaw| {
        let missing = (least - tool.press_upright(&bend, yaw).middle).max(0.0);
        libm::sqrt(2.0 * missing * tool.compression() * -radius)
    });
    let across = Vector2::new(-libm::sin(axis), libm::cos(axis));
    across * gaps.fold(f64::INFINITY, f64::min)
}

/// Checks that the contact model holds on the surface of a task. A plane always passes.
///
/// # Errors
/// [`PlanError::Shape`], [`PlanError::TooBent`], [`PlanError::HoversOffBend`] or
/// [`PlanError::SteepBend`].
pub(super) fn check_bend(task: &Task) -> Result<(), PlanError> {
    let surface = &task.surface;
    if surface.shape.is_plane() {
        return Ok(());
    }
    if let Some(fault) = surface.shape_fault() {
        let surface = surface.name.clone();
        return Err(PlanError::Shape { surface, fault });
    }
    let radii = surface.least_radii();
    for radius in [radii.bulge, -radii.hollow] {
        if radius.is_infinite() {
            continue;
        }
        let reach = touched_reach(task, radius);
        if reach > radius.abs() {
            return Err(PlanError::TooBent {
                tool: task.tool.name.clone(),
                surface: surface.name.clone(),
                radius,
                reach,
            });
        }
        check_gap(task, radius)?;
    }
    let slope = surface.steepest_slope();
    // The kind of the medium and the friction of the surface are not part of a task, so the smallest friction counts.
    let friction = dirt_friction(crate::represent::MediumKind::Solid, 0.0);
    if task.treatment.is_none() && task.dirt_slide().is_none() && slope > libm::atan(friction) {
        return Err(PlanError::SteepBend {
            surface: surface.name.clone(),
            slope: slope.to_degrees(),
        });
    }
    Ok(())
}

/// Checks that a hovering tool acts over its whole length: its ends neither meet a hollow nor hover
/// too far over a bulge.
fn check_gap(task: &Task, radius: f64) -> Result<(), PlanError> {
    if !task.interaction.hovers() {
        return Ok(());
    }
    let corners = task.tool.footprint.edges();
    let reach = corners
        .map(|edge| edge.start.coords.norm())
        .fold(0.0, f64::max);
    let gap = task.interaction.gap_m;
    // The effect decreases with the gap: f′ = gap / (gap + sag).
    let least = effective_pressure(&task.interaction.likelihood);
    let limit = if radius > 0.0 {
        gap * (1.0 / least - 1.0)
    } else {
        gap
    };
    let sag = reach * reach / (2.0 * radius.abs());
    if sag <= limit {
        return Ok(());
    }
    Err(PlanError::HoversOffBend {
        tool: task.tool.name.clone(),
        surface: task.surface.name.clone(),
        radius,
        sag,
        limit,
    })
}

/// Returns how far from its centre a tool touches across the bend, at any yaw [m]. In a hollow this
/// is the reach of the tool, as its ends touch first; on a bulge it is at most that reach. If the
/// reach is within the radius, the whole tool counts.
fn touched_reach(task: &Task, radius: f64) -> f64 {
    let footprint = &task.tool.footprint;
    let corners = footprint.edges().map(|edge| edge.start.coords.norm());
    let reach = corners.fold(0.0, f64::max);
    let tool = ElasticFoundation::from_interaction(footprint, &task.interaction);
    // The part that touches matters only if the tool reaches beyond the axis of the bend.
    let Some(tool) = tool.filter(|_| radius > 0.0 && reach > radius) else {
        return reach;
    };
    // f′(u) = m − u²/2δR vanishes at u² = 2 m δ R.
    let bends = task.surface.bends();
    let most = bends
        .iter()
        .flat_map(|(_, bend)| yaws().map(|yaw| tool.press_upright(bend, yaw).middle));
    let most = most.fold(0.0, f64::max);
    libm::sqrt(2.0 * most * tool.compression() * radius).min(reach)
}

/// Checks that no object of a scene is within a radius of the outer side of a curved surface.
/// Objects below the surface support it, as under a plane.
///
/// `scene`: meshes in the surface frame.
pub(super) fn check_scene<'a>(
    surface: &Surface,
    scene: impl IntoIterator<Item = &'a Mesh>,
    radius: f64,
) -> Result<(), PlanError> {
    for mesh in scene {
        let distance = find_distance_above(surface, mesh, radius + SEARCH_STEP);
        if distance < radius + SEARCH_STEP {
            return Err(PlanError::ObstacleOnBend {
                surface: surface.name.clone(),
                distance,
                needed: radius + SEARCH_STEP,
            });
        }
    }
    Ok(())
}

/// Returns the distance of the part of a mesh on the outer side of a surface from the surface [m], exact to
/// [`SEARCH_STEP`]; infinite if it is above `limit`. Only triangles near the surface are divided.
fn find_distance_above(surface: &Surface, mesh: &Mesh, limit: f64) -> f64 {
    let outline = &surface.outline;
    let height_and_distance = |point: &Point3| {
        let at = surface.shape.chart(*point);
        let beside = if outline.contains(at.place) {
            0.0
        } else {
            let edges = outline.edges().map(|edge| edge.distance(at.place));
            edges.fold(f64::INFINITY, f64::min)
        };
        (at.height, at.height.hypot(beside))
    };
    let bounds = Bounds2::from_points(outline.outer().iter().copied());
    let center = bounds.map_or_else(Point2::origin, |bounds| bounds.center());
    let foot = Point3::from(surface.shape.place(center, 0.0).translation.vector);
    let corners = outline
        .outer()
        .iter()
        .map(|corner| (corner - center).norm());
    let size = MOST_STRETCH * corners.fold(0.0, f64::max);
    let is_mesh = matches!(surface.shape, SurfaceShape::Mesh(_));
    let mut least = f64::INFINITY;
    let mut open: Vec<[Point3; 3]> = mesh.corners().collect();
    while let Some([a, b, c]) = open.pop() {
        let middle = Point3::from((a.coords + b.coords + c.coords) / 3.0);
        let reach = [a, b, c].map(|corner| (corner - middle).norm());
        let reach = reach.into_iter().fold(0.0, f64::max);
        // Distance and height change by at most the distance moved. The limit counts twice, because
        // a mesh is approximate.
        let far = 2.0 * limit + reach;
        if (middle - foot).norm() > size + far {
            continue;
        }
        let (height, _) = height_and_distance(&middle);
        if height.abs() > far || !is_mesh && height + reach <= SURFACE_SKIN {
            continue;
        }
        let sides = [[a, b, c], [b, c, a], [c, a, b]];
        let length = |[from, to, _]: &[Point3; 3]| (to - from).norm();
        let longest =
            (sides.into_iter()).max_by(|one, other| length(one).total_cmp(&length(other)));
        let Some([from, to, tip]) = longest.filter(|side| length(side) > 2.0 * SEARCH_STEP) else {
            let corners = [a, b, c].map(|corner| height_and_distance(&corner));
            let above = (corners.into_iter()).filter(|&(height, _)| height > SURFACE_SKIN);
            least = above.fold(least, |least, (_, distance)| least.min(distance));
            continue;
        };
        let between = nalgebra::center(&from, &to);
        open.extend([[from, between, tip], [between, to, tip]]);
    }
    if least > limit { f64::INFINITY } else { least }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Polygon, Pose, Vector3};

    #[test]
    fn a_large_plate_is_found_over_a_small_pipe() {
        let mut pipe = Surface::new(
            "pipe",
            Polygon::rectangle(Vector2::new(0.02, 0.02)),
            Pose::identity(),
        );
        pipe.shape = SurfaceShape::Cylinder {
            radius: 0.3,
            axis: 0.0,
        };
        // 60 m wide: its corners and those of a coarse division are far from the pipe.
        let plate = Mesh::cuboid(Vector3::new(60.0, 60.0, 0.002)).expect("it has a volume");
        let at = |height: f64| {
            let shift = Pose::translation(0.37, -0.23, height);
            find_distance_above(&pipe, &plate.transform(&shift), 0.06)
        };
        assert!((at(0.051) - 0.05).abs() < SEARCH_STEP, "{}", at(0.051));
        assert_eq!(at(0.075), f64::INFINITY);
        assert_eq!(at(-0.01), f64::INFINITY, "what lies below supports it");

        // A spike from beyond the axis, of which only the tip is near.
        let base = [[-0.1, -0.1], [0.1, -0.1], [0.0, 0.1]].map(|[x, y]| Point3::new(x, y, -0.5));
        let spike = Mesh::new(
            [&base[..], &[Point3::new(0.0, 0.0, 0.05)]].concat(),
            vec![[0, 1, 3], [1, 2, 3], [2, 0, 3]],
        );
        let distance = find_distance_above(&pipe, &spike.expect("triangles"), 0.06);
        assert!(distance < 0.06, "{distance}");
    }

    #[test]
    fn the_text_of_a_contact_states_the_share_and_the_length_that_would_fit() {
        let contact = BendContact {
            touched_share: [0.391, 0.55],
            pressure: [0.0, 3.85],
            fitting_length: 0.02449,
            compression: 1e-4,
        };
        assert_eq!(
            contact.to_string(),
            "39 to 55 % of the tool touches the bend, depending on its yaw; pressure 0.00 to 3.85 of the nominal one, for a compression of 0.1 mm; a tool square to the bend and at most 0.024 m long across it would touch everywhere"
        );
        let whole = BendContact {
            touched_share: [1.0; 2],
            pressure: [0.83, 1.08],
            fitting_length: 0.245,
            compression: 0.01,
        };
        assert_eq!(
            whole.to_string(),
            "the whole tool touches the bend at every yaw; pressure 0.83 to 1.08 of the nominal one, for a compression of 10.0 mm"
        );
    }
}
