//! Frames of a predicted effect over time.

use wisch::geometry::{PlanarPose, Point2};
use wisch::plan::{Plan, PredictionProgress};
use wisch::represent::{Action, Fate, GoalState, ParticleDistribution, Performance, Surface, Task};

/// Maximum number of frames of a prediction, including first and last.
pub const MAX_FRAMES: usize = 80;
/// Maximum number of particles in a frame.
pub const MAX_DRAWN: usize = 6_000;
/// Distance below which coordinates belong to the same row or column of a grid [m].
const SAME_LINE: f64 = 1e-6;
/// Points that fill less of their grid than one in this number are no grid.
const SPARSE: usize = 20;

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
        .step_by(thinning(places.len(), most))
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
        let lines = [0, 1].map(|axis| lines_along(places, axis));
        let [columns, rows] = [&lines[0], &lines[1]].map(Vec::len);
        if columns.saturating_mul(rows) > SPARSE.saturating_mul(places.len()) {
            let step = thinning(places.len(), most);
            let size = [&lines[0], &lines[1]].map(|line| line[line.len() - 1] - line[0]);
            let side = (size[0] * size[1] * step as f64 / places.len() as f64).sqrt();
            return Self {
                kept: (0..places.len()).step_by(step).collect(),
                cell: [side, side],
            };
        }
        let rank = |place: &Point2, axis: usize| {
            lines[axis].partition_point(|line| *line < place[axis] - SAME_LINE)
        };
        let ranks: Vec<[usize; 2]> = (places.iter())
            .map(|place| [rank(place, 0), rank(place, 1)])
            .collect();
        let mut step = 1;
        loop {
            let is_kept = |i: &usize| {
                let mut axes = ranks[*i].iter().zip(&lines);
                axes.all(|(rank, lines)| rank % step == (step / 2).min(lines.len() - 1))
            };
            let kept: Vec<usize> = (0..places.len()).filter(is_kept).collect();
            if kept.len() <= most {
                let gap = |line: &Vec<f64>| {
                    let gaps = line.windows(2).map(|pair| pair[1] - pair[0]);
                    gaps.fold(f64::INFINITY, f64::min)
                };
                let gaps = [gap(&lines[0]), gap(&lines[1])];
                let least = gaps[0].min(gaps[1]);
                // A single row is as high as its columns are wide.
                let cell = gaps.map(|gap| if gap.is_finite() { gap } else { least });
                return Self {
                    kept,
                    cell: cell.map(|gap| {
                        if gap.is_finite() {
                            step as f64 * gap
                        } else {
                            0.0
                        }
                    }),
                };
            }
            step += 1;
        }
    }
}

/// Returns the distinct coordinates of points along an axis, rising [m].
fn lines_along(places: &[Point2], axis: usize) -> Vec<f64> {
    let mut lines: Vec<f64> = places.iter().map(|place| place[axis]).collect();
    lines.sort_by(f64::total_cmp);
    lines.dedup_by(|next, line| *next - *line < SAME_LINE);
    lines
}

/// Returns the smallest step that selects at most `most` out of `count`.
fn thinning(count: usize, most: usize) -> usize {
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
        assert_eq!(lines_along(&kept, 0).len(), 50);
        assert_eq!(lines_along(&kept, 1).len(), 30);
    }

    #[test]
    fn points_without_rows_are_thinned_one_by_one() {
        let places: Vec<Point2> = (0..1_000)
            .map(|i| Point2::new(f64::from(i * 7_919 % 1_000), f64::from(i)))
            .collect();
        let thinned = PlaceGrid::new(&places, 500);
        assert_eq!(thinned.kept.len(), 500);
        assert!((thinned.cell[0] - 44.7).abs() < 0.2, "{:?}", thinned.cell);
        assert!(PlaceGrid::new(&[], 10).kept.is_empty());
        assert_eq!(PlaceGrid::new(&[Point2::origin()], 10).cell, [0.0, 0.0]);
    }
}
