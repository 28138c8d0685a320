//! Frames of a predicted effect over time.

use std::collections::HashSet;
use wisch::geometry::{Bounds2, PlanarPose, Point2};
use wisch::plan::{Plan, PredictionProgress};
use wisch::represent::{Action, Fate, GoalState, ParticleDistribution, Performance, Surface, Task};

/// Maximum number of frames of a prediction, including first and last.
pub const MAX_FRAMES: usize = 80;
/// Maximum number of particles in a frame.
pub const MAX_DRAWN: usize = 6_000;
/// Distance below which coordinates belong to the same row or column of a grid [m].
const SAME_LINE: f64 = 1e-6;
/// Deviation from which distances of lines are no multiples of one distance, as a share of it [1].
const UNEQUAL: f64 = 0.05;

/// The state of the particles at one time of a prediction.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Distance travelled in contact so far \[m\].
    pub distance: f64,
    /// Pose of the tool in the surface frame.
    pub surface_from_tool: PlanarPose,
    /// Index of the stroke; `None` before the first.
    pub stroke: Option<usize>,
    /// Every n-th particle; of a treated surface, every n-th row and column of its points. Position in the surface frame
    /// \[m\] and fate.
    pub particles: Vec<(Point2, Fate)>,
    /// Performance over all particles, including those that the frame leaves out.
    pub performance: Performance,
}

/// A recorder of a prediction that keeps at most `MAX_FRAMES` frames, evenly distributed over the motions.
///
/// ```ignore
/// let mut frames = EffectFrames::new(&task, &plan);
/// let prediction = predict(&task, &plan, |progress| frames.record(progress));
/// ```
#[derive(Debug, Clone)]
pub struct EffectFrames {
    surface: Surface,
    goal: GoalState,
    frames: Vec<Frame>,
    kept: Vec<usize>,
    motions: usize,
    seen: usize,
}

impl EffectFrames {
    /// Makes a recorder that holds the particles before the first stroke.
    pub fn new(task: &Task, plan: &Plan) -> Self {
        let heading = plan
            .tcp_path()
            .first()
            .map_or(0.0, |corner| corner.surface_from_tool.heading);
        let mut frames = Self {
            surface: task.surface.clone(),
            goal: plan.graph.goal,
            frames: Vec::new(),
            kept: kept_particles(task),
            motions: plan.strokes.iter().map(|s| s.motions().count()).sum(),
            seen: 0,
        };
        frames.keep(
            0.0,
            PlanarPose::new(plan.tool_start, heading),
            None,
            &task.particles,
        );
        frames
    }

    /// Records the result of one motion.
    pub fn record(&mut self, progress: &PredictionProgress) {
        // Motion n of N is kept if n * MAX_FRAMES / N passes a whole number, so the last one is always kept.
        let gaps = MAX_FRAMES - 1;
        let due = |seen: usize| seen * gaps / self.motions.max(gaps);
        self.seen += 1;
        if self.motions <= gaps || due(self.seen) > due(self.seen - 1) {
            self.keep(
                progress.distance,
                progress.surface_from_tool,
                Some(progress.stroke),
                &progress.field.distribution(),
            );
        }
    }

    /// Returns the frames in order of time.
    pub fn frames(&self) -> &[Frame] {
        &self.frames
    }

    fn keep(
        &mut self,
        distance: f64,
        surface_from_tool: PlanarPose,
        stroke: Option<usize>,
        particles: &ParticleDistribution,
    ) {
        self.frames.push(Frame {
            distance,
            surface_from_tool,
            stroke,
            particles: (self.kept.iter())
                .map(|&i| (particles.position(i), particles.fate(i)))
                .collect(),
            performance: Performance::evaluate(particles, &self.goal, &self.surface),
        });
    }
}

/// Returns the indices of the particles of a task that frames and maps keep.
pub(crate) fn kept_particles(task: &Task) -> Vec<usize> {
    let places: Vec<Point2> = task.particles.iter().map(|(place, _)| place).collect();
    thin_places(&places, MAX_DRAWN, task.action)
}

/// Returns the indices of at most `most` particles: every n-th, or every n-th row and column of a treated surface.
pub(crate) fn thin_places(places: &[Point2], most: usize, action: Action) -> Vec<usize> {
    if action.treats() {
        return PlaceGrid::new(places, most).kept;
    }
    (0..places.len())
        .step_by(find_thinning(places.len(), most))
        .collect()
}

/// Points in rows and columns: every n-th row and column of more points.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlaceGrid {
    /// Indices of the kept points, rising.
    pub(crate) kept: Vec<usize>,
    /// Distance of the kept columns and rows [m].
    pub(crate) cell: [f64; 2],
}

impl PlaceGrid {
    /// Selects at most [`MAX_DRAWN`] points of a task's treated surface.
    pub(crate) fn of_task(task: &Task) -> Self {
        let places: Vec<Point2> = task.particles.iter().map(|(place, _)| place).collect();
        Self::new(&places, MAX_DRAWN)
    }

    /// Selects at most `most` points. Of points that are not in rows and columns, every n-th is kept.
    pub(crate) fn new(places: &[Point2], most: usize) -> Self {
        let Some((indices, gaps)) = find_lattice(places) else {
            return Self::of_loose_points(places, most);
        };
        let counts = [0, 1].map(|axis| indices.iter().map(|index| index[axis]).max().unwrap_or(0));
        let mut step = 1;
        loop {
            let is_kept = |i: &usize| {
                let mut axes = indices[*i].iter().zip(counts);
                axes.all(|(index, last)| index % step == (step / 2).min(last))
            };
            let kept: Vec<usize> = (0..places.len()).filter(is_kept).collect();
            // A step beyond all rows and columns would keep no more.
            if kept.len() <= most || step > counts[0].max(counts[1]) {
                let kept = kept.into_iter().take(most).collect();
                let cell = gaps.map(|gap| step as f64 * gap);
                return Self { kept, cell };
            }
            step += 1;
        }
    }

    fn of_loose_points(places: &[Point2], most: usize) -> Self {
        let step = find_thinning(places.len(), most);
        let size = Bounds2::from_points(places.iter().copied()).map_or(0.0, |bounds| {
            let size = bounds.size();
            size.x * size.y
        });
        let side = (size * step as f64 / places.len().max(1) as f64).sqrt();
        Self {
            kept: (0..places.len()).step_by(step).collect(),
            cell: [side, side],
        }
    }
}

/// Returns the column and row of each point, and the distances of columns and of rows [m]. `None` if the points are not at
/// equal distances along both axes, or if less than half of them have a neighbour.
fn find_lattice(places: &[Point2]) -> Option<(Vec<[usize; 2]>, [f64; 2])> {
    let lines = [0, 1].map(|axis| find_lines_along(places, axis));
    let gaps = [find_equal_gap(&lines[0])?, find_equal_gap(&lines[1])?];
    // A single row is as high as its columns are wide.
    let least = gaps[0].min(gaps[1]);
    let gaps = gaps.map(|gap| if gap.is_finite() { gap } else { least });
    if !least.is_finite() {
        return None;
    }
    let index = |place: &Point2, axis: usize| {
        ((place[axis] - lines[axis][0]) / gaps[axis]).round() as usize
    };
    let indices: Vec<[usize; 2]> = (places.iter())
        .map(|place| [index(place, 0), index(place, 1)])
        .collect();
    let all: HashSet<[usize; 2]> = indices.iter().copied().collect();
    let has_neighbour = |[i, j]: &[usize; 2]| {
        let mut around = [
            [i.wrapping_sub(1), *j],
            [i + 1, *j],
            [*i, j.wrapping_sub(1)],
            [*i, j + 1],
        ]
        .into_iter();
        around.any(|index| all.contains(&index))
    };
    let count = all.iter().filter(|index| has_neighbour(index)).count();
    (2 * count >= all.len()).then_some((indices, gaps))
}

/// Returns the distance of neighbouring lines if all distances are multiples of it, infinity for a single line.
fn find_equal_gap(lines: &[f64]) -> Option<f64> {
    let gaps = || lines.windows(2).map(|pair| pair[1] - pair[0]);
    let least = gaps().fold(f64::INFINITY, f64::min);
    let count: f64 = gaps().map(|gap| (gap / least).round()).sum();
    if count == 0.0 {
        return Some(f64::INFINITY);
    }
    // The mean, as coordinates in files are rounded.
    let mean = (lines[lines.len() - 1] - lines[0]) / count;
    let is_multiple = |gap: f64| (gap / mean - (gap / mean).round()).abs() < UNEQUAL;
    gaps().all(is_multiple).then_some(mean)
}

/// Returns the distinct coordinates of points along an axis, rising [m].
fn find_lines_along(places: &[Point2], axis: usize) -> Vec<f64> {
    let mut lines: Vec<f64> = places.iter().map(|place| place[axis]).collect();
    lines.sort_by(f64::total_cmp);
    lines.dedup_by(|next, line| *next - *line < SAME_LINE);
    lines
}

/// Returns the smallest step that selects at most `most` out of `count`.
fn find_thinning(count: usize, most: usize) -> usize {
    count.div_ceil(most).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_long_row_is_thinned_too() {
        let kept = PlaceGrid::new(&grid(6500, 1), 6000).kept;
        assert!(kept.len() > 3000 && kept.len() <= 6000, "{}", kept.len());
    }

    /// Returns the points of a grid of 1 cm, row by row.
    fn grid(columns: usize, rows: usize) -> Vec<Point2> {
        (0..columns * rows)
            .map(|i| Point2::new(0.01 * (i % columns) as f64, 0.01 * (i / columns) as f64))
            .collect()
    }

    #[test]
    fn a_thinned_grid_is_a_grid() {
        let places = grid(100, 60);
        assert_eq!(PlaceGrid::new(&places, 6_000).kept.len(), 6_000);
        let thinned = PlaceGrid::new(&places, 5_999);
        assert_eq!(thinned.kept.len(), 50 * 30);
        assert!(thinned.cell.iter().all(|side| (side - 0.02).abs() < 1e-9));
        let kept: Vec<Point2> = thinned.kept.iter().map(|&i| places[i]).collect();
        assert_eq!(find_lines_along(&kept, 0).len(), 50);
        assert_eq!(find_lines_along(&kept, 1).len(), 30);
    }

    #[test]
    fn a_diagonal_strip_of_a_grid_is_a_grid() {
        let is_near = |place: &Point2| (place.x - place.y).abs() < 0.011;
        let strip: Vec<Point2> = grid(100, 100).into_iter().filter(is_near).collect();
        let found = PlaceGrid::new(&strip, 1_000);
        assert_eq!(found.kept.len(), strip.len());
        assert!(found.cell.iter().all(|side| (side - 0.01).abs() < 1e-9));
    }

    #[test]
    fn points_without_rows_are_thinned_one_by_one() {
        let places: Vec<Point2> = (0..1_000)
            .map(|i| Point2::new(f64::from(i * 7_919 % 1_000), f64::from(i)))
            .collect();
        let thinned = PlaceGrid::new(&places, 500);
        assert_eq!(thinned.kept.len(), 500);
        assert!((thinned.cell[0] - 44.7).abs() < 0.2, "{:?}", thinned.cell);
        let few = [[0.0, 0.0], [0.013, 0.051], [0.094, 0.02]].map(Point2::from);
        let side = PlaceGrid::new(&few, 500).cell[0];
        assert!(
            (side - (0.094_f64 * 0.051 / 3.0).sqrt()).abs() < 1e-9,
            "{side}"
        );
        assert!(PlaceGrid::new(&[], 10).kept.is_empty());
        assert_eq!(PlaceGrid::new(&[Point2::origin()], 10).cell, [0.0, 0.0]);
    }
}
