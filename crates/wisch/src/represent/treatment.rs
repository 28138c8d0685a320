//! Treatments of a surface: polishing and painting, whose particles are places of the surface.

use super::{DirtArea, Fate, GoalState, ParticleDistribution, ParticleError, SourceError};
use crate::geometry::{Bounds2, Point2};

/// Margin of shares for rounding [1].
const ROUNDING: f64 = 1e-9;

/// Target of an action that treats the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Treatment {
    /// Passes of a pad under pressure.
    Polish {
        /// Passes over each place.
        passes: u32,
        /// Largest number of passes over any place, over all rounds.
        max_passes: u32,
        /// Coefficient k_p of Preston's law [1/Pa]: removed depth over pressure and travel (Preston 1927).
        preston: Option<f64>,
    },
    /// A coat of paint.
    Dispense {
        /// Target thickness \[m\].
        thickness: f64,
        /// Volume of paint per metre of travel [m³/m].
        volume_per_metre: f64,
    },
}

impl Treatment {
    /// Returns the goal of the treatment with a tool of this width \[m\].
    pub fn goal(&self, width: f64) -> GoalState {
        match *self {
            Self::Polish { passes, .. } => GoalState::Polished { passes },
            Self::Dispense {
                thickness,
                volume_per_metre,
            } => GoalState::Dispensed {
                thickness,
                per_pass: volume_per_metre / width,
            },
        }
    }

    /// Returns the depth that one pass removes or leaves \[m\], for a tool of this width \[m\] with this force \[N\]; `None`
    /// without a coefficient.
    pub fn depth_per_pass(&self, width: f64, force: f64) -> Option<f64> {
        match *self {
            // Preston: depth = k_p · pressure · travel; pressure times the footprint's mean length is force over width.
            Self::Polish { preston, .. } => preston.map(|preston| preston * force / width),
            Self::Dispense {
                volume_per_metre, ..
            } => Some(volume_per_metre / width),
        }
    }

    /// Returns the mean of the passes over all places and their standard deviation \[1\].
    ///
    /// ```
    /// use wisch::geometry::Point2;
    /// use wisch::represent::{Fate, ParticleDistribution, Treatment};
    /// let at = |passes| (Point2::origin(), Fate::Treated { passes });
    /// let places = ParticleDistribution::with_fates(&[at(1.0), at(3.0)])?;
    /// assert_eq!(Treatment::spread(&places), [2.0, 1.0]);
    /// # Ok::<(), wisch::represent::ParticleError>(())
    /// ```
    pub fn spread(places: &ParticleDistribution) -> [f64; 2] {
        let count = places.len().max(1) as f64;
        let passes = || places.iter().map(|(_, fate)| fate.passes());
        let mean = passes().sum::<f64>() / count;
        let squares: f64 = passes().map(|passes| (passes - mean).powi(2)).sum();
        [mean, (squares / count).sqrt()]
    }

    /// Returns the share of the places that were polished more often than the treatment allows \[1\], counted in whole
    /// passes; `None` for a treatment without such a limit.
    ///
    /// ```
    /// use wisch::geometry::Point2;
    /// use wisch::represent::{Fate, ParticleDistribution, Treatment};
    /// let at = |passes| (Point2::origin(), Fate::Treated { passes });
    /// let places = ParticleDistribution::with_fates(&[at(2.0), at(3.4), at(3.6), at(7.0)])?;
    /// let polish = Treatment::Polish { passes: 2, max_passes: 3, preston: None };
    /// assert_eq!(polish.share_above_limit(&places), Some(0.5));
    /// # Ok::<(), wisch::represent::ParticleError>(())
    /// ```
    pub fn share_above_limit(&self, places: &ParticleDistribution) -> Option<f64> {
        let Self::Polish { max_passes, .. } = *self else {
            return None;
        };
        let is_above = |fate: Fate| fate.passes().round() > f64::from(max_passes);
        let above = places.iter().filter(|(_, fate)| is_above(*fate)).count();
        Some(above as f64 / places.len().max(1) as f64)
    }

    /// Whether more of the places than 1 − `target` were polished more often than the treatment
    /// allows, so that the goal is not met. The share is the mean over possible states of the
    /// surface, each with its weight.
    ///
    /// ```
    /// use wisch::geometry::Point2;
    /// use wisch::represent::{Fate, ParticleDistribution, Treatment};
    /// let at = |passes| (Point2::origin(), Fate::Treated { passes });
    /// let places = ParticleDistribution::with_fates(&[at(2.0), at(3.4), at(3.4), at(7.0)])?;
    /// let polish = Treatment::Polish { passes: 2, max_passes: 3, preston: None };
    /// assert!(polish.exceeds_limit([(&places, 1.0)], 0.76));
    /// assert!(!polish.exceeds_limit([(&places, 1.0)], 0.75));
    /// # Ok::<(), wisch::represent::ParticleError>(())
    /// ```
    pub fn exceeds_limit<'a>(
        &self,
        states: impl IntoIterator<Item = (&'a ParticleDistribution, f64)>,
        target: f64,
    ) -> bool {
        let shares = states
            .into_iter()
            .map(|(places, weight)| weight * self.share_above_limit(places).unwrap_or(0.0));
        shares.sum::<f64>() > 1.0 - target + ROUNDING
    }
}

/// Returns about `count` places of a surface: the middles of square cells, row by row along x, except those under an
/// object.
///
/// # Errors
/// [`SourceError::Count`] for a count outside its limits, or an error for cells so coarse that none
/// is free.
///
/// ```
/// use wisch::geometry::{Polygon, Vector2};
/// use wisch::represent::{DirtArea, OccupiedArea, surface_cells};
/// let plate = Polygon::rectangle(Vector2::new(0.4, 0.3));
/// let area = DirtArea { outline: &plate, occupied: &OccupiedArea::default() };
/// assert_eq!(surface_cells(area, 1200)?.len(), 40 * 30);
/// # Ok::<(), wisch::represent::SourceError>(())
/// ```
pub fn surface_cells(
    area: DirtArea<'_>,
    count: usize,
) -> Result<ParticleDistribution, SourceError> {
    SourceError::check_count(count)?;
    let bounds = Bounds2::from_points(area.outline.outer().iter().copied());
    let none = SourceError::NoRoom {
        draws: 0,
        placed: 0,
        count,
    };
    let Some(bounds) = bounds else {
        return Err(none);
    };
    let size = bounds.size();
    // The cell size follows from the outline's own area, so that about `count` cells lie on it.
    let side = (area.outline.area() / count as f64).sqrt();
    let cells = |length: f64| ((length / side).round() as usize).max(1);
    let (columns, rows) = (cells(size.x), cells(size.y));
    let middle = |i: usize, count: usize| (i as f64 + 0.5) / count as f64;
    let places: Vec<(Point2, Fate)> = (0..rows)
        .flat_map(|row| (0..columns).map(move |column| (row, column)))
        .map(|(row, column)| {
            let (x, y) = (middle(column, columns), middle(row, rows));
            bounds.min + size.component_mul(&nalgebra::Vector2::new(x, y))
        })
        .filter(|&place| area.contains(place))
        .map(|place| (place, Fate::OnSurface))
        .collect();
    if places.is_empty() {
        return Err(none);
    }
    ParticleDistribution::with_fates(&places).map_err(|error: ParticleError| error.into())
}
