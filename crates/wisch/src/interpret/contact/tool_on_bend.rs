//! A tool on a curved surface: the distribution of its pressure, and the depth to which it sinks
//! in.

use super::downsampling::MeasuredPiece;
use crate::geometry::{PlanarPose, Region};
use crate::interpret::config::InterpretConfig;
use crate::represent::{ElasticFoundation, LocalPressure, Surface, SurfaceShape};
use nalgebra::Vector2;

/// Least force over the nominal force for which the pressure is computed [1]: without force, the
/// tool only just touches.
const LEAST_FORCE: f64 = 1e-3;

/// A tool over the curvature of a believed surface.
#[derive(Debug)]
pub(in crate::interpret) struct ToolOnBend {
    foundation: ElasticFoundation,
    shape: SurfaceShape,
}

impl ToolOnBend {
    /// Returns the tool with a footprint (tool frame) and a compression at nominal force [m]; `None` on a plane, and for a
    /// tool that hovers.
    pub(in crate::interpret) fn new(
        surface: &Surface,
        footprint: &Region,
        compression: f64,
        config: &InterpretConfig,
    ) -> Option<Self> {
        if surface.shape.is_plane() || config.gap_m > 0.0 {
            return None;
        }
        ElasticFoundation::new(footprint, compression).map(|foundation| Self {
            foundation,
            shape: surface.shape.clone(),
        })
    }

    /// Returns the pressure at a force over the nominal one [1] and a pose, with the slope of the surface against the tool.
    pub(super) fn press(&self, force: f64, at: PlanarPose, slope: Vector2<f64>) -> LocalPressure {
        let turn = nalgebra::Rotation2::new(at.heading);
        let bend = turn.inverse().matrix() * self.shape.bend(at.position) * turn.matrix();
        self.foundation.press(force.max(LEAST_FORCE), slope, &bend)
    }

    /// Least and largest value of f′ under the tool [1]; below 0 where it does not touch.
    pub(super) fn range(&self, pressure: &LocalPressure) -> [f64; 2] {
        self.foundation.range(pressure)
    }

    /// Compression of the tool at nominal force on a plane [m].
    pub(super) fn compression(&self) -> f64 {
        self.foundation.compression()
    }

    /// Additional depth to which the tool sinks in over the bend, compared with a plane, at a force
    /// over the nominal one [1] and a pose [m]: κL²/24 if the whole tool touches; negative in a
    /// hollow.
    pub(super) fn sinking(&self, force: f64, at: PlanarPose) -> f64 {
        let force = force.max(LEAST_FORCE);
        self.compression() * (self.press(force, at, Vector2::zeros()).middle - force)
    }

    /// Converts the heights of pieces to those over a plane at the same force, so that they do not depend on how the
    /// tool lies on the bend.
    pub(in crate::interpret) fn level(
        &self,
        pieces: &mut [MeasuredPiece],
        config: &InterpretConfig,
    ) {
        for piece in pieces {
            let force = config.normalized(-piece.force.z).min(1.0);
            let at = PlanarPose::new(piece.position.xy(), piece.heading);
            piece.mean_height += self.sinking(force, at);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point2, Polygon};
    use std::f64::consts::FRAC_PI_2;

    fn tool(radius: f64, compression: f64) -> ToolOnBend {
        let side = Polygon::rectangle(nalgebra::Vector2::new(0.06, 0.1));
        ToolOnBend {
            shape: SurfaceShape::Cylinder { radius, axis: 0.0 },
            foundation: ElasticFoundation::new(&Region::new(vec![side]), compression).unwrap(),
        }
    }

    fn turned(yaw: f64) -> PlanarPose {
        PlanarPose::new(Point2::new(0.1, 0.2), yaw)
    }

    #[test]
    fn a_tool_sinks_in_by_the_mean_height_of_what_it_touches() {
        for (radius, yaw, length) in [(0.5, 0.0, 0.1), (0.5, FRAC_PI_2, 0.06), (-2.0, 0.0, 0.1)] {
            let soft = tool(radius, 0.01);
            let expected = length * length / radius / 24.0;
            for force in [1.0, 0.8] {
                let found = soft.sinking(force, turned(yaw));
                assert!((found - expected).abs() < 1e-9, "{found} {expected}");
            }
        }
        // A strip of width 2y carries the force F/F₀ = 2 κ y³ / 3 L δ, and sinks in by κy²/2.
        let (hard, force) = (tool(0.5, 1e-3), 0.3);
        let half = libm::cbrt(3.0 * force * 0.1 * 1e-3 * 0.5 / 2.0);
        let expected = half * half - force * 1e-3;
        assert!(half < 0.05 && (hard.sinking(force, turned(0.0)) - expected).abs() < 1e-9);
        // Without force, a bulge touches in the middle; the ends of a tool touch a hollow.
        assert!(hard.sinking(0.0, turned(0.0)).abs() < 1e-4);
        let hollow = tool(-0.5, 1e-3).sinking(0.0, turned(0.0));
        assert!((hollow + 0.1 * 0.1 / 8.0 / 0.5).abs() < 1e-4, "{hollow}");
    }
}
