//! Particles sorted into cells, so that a stroke only meets the particles near it.

use super::{Fate, ParticleDistribution, Surface};
use crate::geometry::{Bounds2, Point2, Vector2};

const NONE: u32 = u32::MAX;
/// Particles per cell that the cell size aims at.
const PARTICLES_PER_CELL: f64 = 8.0;
const MIN_CELL_SIZE: f64 = 1e-3;

/// A particle's place in the field's own order, in which neighbours in space are neighbours in memory.
pub(super) type Slot = u32;

/// Particles of one surface in cells of a uniform grid, each cell a doubly linked list.
///
/// Moving a particle costs constant time and no allocation. The field keeps its own copy of the
/// positions, sorted by cell; [`ParticleField::distribution`] gives them back in the original order.
#[derive(Debug, Clone)]
pub struct ParticleField {
    origin: Point2,
    cell_size: f64,
    per_cell_size: f64,
    columns: usize,
    rows: usize,
    head: Vec<u32>,
    next: Vec<u32>,
    previous: Vec<u32>,
    x: Vec<f64>,
    y: Vec<f64>,
    fate: Vec<Fate>,
    /// Slot → index in the distribution that the field was built from.
    index: Vec<u32>,
    /// The way back.
    slot: Vec<Slot>,
    remaining: usize,
}

impl ParticleField {
    /// Sorts the particles into cells. Cost: proportional to the number of particles.
    pub fn new(particles: &ParticleDistribution) -> Self {
        let bounds = Bounds2::of(particles.remaining()).unwrap_or(Bounds2 {
            min: Point2::origin(),
            max: Point2::origin(),
        });
        let size = bounds.size();
        let count = particles.len().max(1) as f64;
        let cell_size =
            (PARTICLES_PER_CELL * size.x.max(MIN_CELL_SIZE) * size.y.max(MIN_CELL_SIZE) / count)
                .sqrt()
                .max(MIN_CELL_SIZE)
                .max(size.amax() / 4096.0);
        let columns = (size.x / cell_size) as usize + 1;
        let rows = (size.y / cell_size) as usize + 1;
        let mut field = Self {
            origin: bounds.min,
            cell_size,
            per_cell_size: 1.0 / cell_size,
            columns,
            rows,
            head: vec![NONE; columns * rows],
            next: vec![NONE; particles.len()],
            previous: vec![NONE; particles.len()],
            x: Vec::with_capacity(particles.len()),
            y: Vec::with_capacity(particles.len()),
            fate: Vec::with_capacity(particles.len()),
            index: (0..particles.len() as u32).collect(),
            slot: vec![0; particles.len()],
            remaining: 0,
        };
        let cells: Vec<u32> = particles
            .iter()
            .map(|(position, _)| field.cell(position) as u32)
            .collect();
        field.index.sort_by_key(|&i| cells[i as usize]);
        for slot in 0..particles.len() {
            let i = field.index[slot] as usize;
            field.slot[i] = slot as Slot;
            field.x.push(particles.x[i]);
            field.y.push(particles.y[i]);
            field.fate.push(particles.fate[i]);
        }
        // Backwards, so that each list runs in ascending slots.
        for slot in (0..particles.len()).rev() {
            if field.fate[slot].is_on_surface() {
                let cell = field.cell(field.position(slot as Slot));
                field.link(slot as Slot, cell);
                field.remaining += 1;
            }
        }
        field
    }

    /// The particles in their original order.
    pub fn distribution(&self) -> ParticleDistribution {
        let mut particles = ParticleDistribution {
            x: vec![0.0; self.x.len()],
            y: vec![0.0; self.x.len()],
            fate: vec![Fate::OnSurface; self.x.len()],
        };
        self.copy_to(&mut particles);
        particles
    }

    /// Writes the particles into the distribution that the field was built from.
    pub(crate) fn copy_to(&self, particles: &mut ParticleDistribution) {
        for (slot, &i) in self.index.iter().enumerate() {
            particles.x[i as usize] = self.x[slot];
            particles.y[i as usize] = self.y[slot];
            particles.fate[i as usize] = self.fate[slot];
        }
    }

    /// Where particle `index` of the distribution is now, and what became of it.
    pub(crate) fn place(&self, index: usize) -> (Point2, Fate) {
        let slot = self.slot[index];
        (self.position(slot), self.fate[slot as usize])
    }

    /// Moves particle `index` of the distribution by a vector, or off the surface if an edge is in the way. What
    /// is off the surface is left alone.
    pub(super) fn displace(&mut self, index: usize, surface: &Surface, by: Vector2) {
        let slot = self.slot[index];
        let is_here = self.fate[slot as usize].is_on_surface();
        if is_here && !self.drop_beyond_edge(index, surface, by) {
            self.relocate(slot, self.position(slot) + by);
        }
    }

    /// Takes particle `index` off the surface if a move by a vector leads over an edge, and says so.
    pub(super) fn drop_beyond_edge(
        &mut self,
        index: usize,
        surface: &Surface,
        by: Vector2,
    ) -> bool {
        let slot = self.slot[index];
        if !self.fate[slot as usize].is_on_surface() {
            return false;
        }
        let from = self.position(slot);
        let edge = surface.exit_edge(from, from + by);
        if let Some(edge) = edge {
            let edge = u16::try_from(edge).unwrap_or(u16::MAX);
            self.remove(slot, from + by, Fate::OffSurface { edge });
        }
        edge.is_some()
    }

    /// How many particles there were at the beginning.
    pub(super) fn len(&self) -> usize {
        self.index.len()
    }

    /// How many particles still lie on the surface.
    pub fn remaining(&self) -> usize {
        self.remaining
    }

    /// Index of the particle in `slot` in the distribution that the field was built from.
    pub(super) fn index(&self, slot: Slot) -> usize {
        self.index[slot as usize] as usize
    }

    /// Position of the particle in `slot` [m].
    pub(super) fn position(&self, slot: Slot) -> Point2 {
        Point2::new(self.x[slot as usize], self.y[slot as usize])
    }

    /// Moves a particle that stays on the surface.
    pub(super) fn relocate(&mut self, slot: Slot, to: Point2) {
        let (from_cell, to_cell) = (self.cell(self.position(slot)), self.cell(to));
        self.x[slot as usize] = to.x;
        self.y[slot as usize] = to.y;
        if to_cell != from_cell {
            self.unlink(slot, from_cell);
            self.link(slot, to_cell);
        }
    }

    /// Counts so many more passes of a tool over a place.
    pub(super) fn treat(&mut self, slot: Slot, more: f64) {
        let fate = &mut self.fate[slot as usize];
        let passes = fate.passes() + more;
        *fate = Fate::Treated { passes };
    }

    /// Takes a particle off the surface; `at` is where it went.
    pub(super) fn remove(&mut self, slot: Slot, at: Point2, fate: Fate) {
        self.unlink(slot, self.cell(self.position(slot)));
        self.x[slot as usize] = at.x;
        self.y[slot as usize] = at.y;
        self.fate[slot as usize] = fate;
        self.remaining -= 1;
    }

    /// Collects the slots in all cells that touch the oriented box `center ± half` along `axis`.
    ///
    /// Finds every particle in the box, and some near it.
    pub(super) fn collect_near(
        &self,
        center: Point2,
        axis: Vector2,
        half: Vector2,
        slots: &mut Vec<Slot>,
    ) {
        slots.clear();
        // Extent of the box along x and y, and for a given band of rows its extent along x.
        let side = Vector2::new(-axis.y, axis.x);
        let reach_y = axis.y.abs() * half.x + side.y.abs() * half.y;
        let row_of = |y: f64| self.clamped(y - self.origin.y, self.rows);
        for row in row_of(center.y - reach_y)..=row_of(center.y + reach_y) {
            // Cells at the rim also hold what lies beyond it.
            let band_min = if row == 0 {
                f64::NEG_INFINITY
            } else {
                self.origin.y + row as f64 * self.cell_size
            };
            let band_max = if row + 1 == self.rows {
                f64::INFINITY
            } else {
                self.origin.y + (row + 1) as f64 * self.cell_size
            };
            let Some((x_min, x_max)) = box_extent_in_band(center, axis, half, (band_min, band_max))
            else {
                continue;
            };
            let first = self.clamped(x_min - self.origin.x, self.columns);
            let last = self.clamped(x_max - self.origin.x, self.columns);
            for cell in row * self.columns + first..=row * self.columns + last {
                let mut slot = self.head[cell];
                while slot != NONE {
                    slots.push(slot);
                    slot = self.next[slot as usize];
                }
            }
        }
    }

    fn clamped(&self, offset: f64, cells: usize) -> usize {
        // Saturating float-to-int conversion: negative offsets become 0.
        ((offset * self.per_cell_size) as usize).min(cells - 1)
    }

    fn cell(&self, position: Point2) -> usize {
        self.clamped(position.y - self.origin.y, self.rows) * self.columns
            + self.clamped(position.x - self.origin.x, self.columns)
    }

    fn link(&mut self, slot: Slot, cell: usize) {
        let head = self.head[cell];
        self.next[slot as usize] = head;
        self.previous[slot as usize] = NONE;
        if head != NONE {
            self.previous[head as usize] = slot;
        }
        self.head[cell] = slot;
    }

    fn unlink(&mut self, slot: Slot, cell: usize) {
        let (previous, next) = (self.previous[slot as usize], self.next[slot as usize]);
        if previous == NONE {
            self.head[cell] = next;
        } else {
            self.next[previous as usize] = next;
        }
        if next != NONE {
            self.previous[next as usize] = previous;
        }
    }
}

/// Smallest and largest x of the part of an oriented box that lies in a band of y; `None` if none does.
fn box_extent_in_band(
    center: Point2,
    axis: Vector2,
    half: Vector2,
    (band_min, band_max): (f64, f64),
) -> Option<(f64, f64)> {
    let side = Vector2::new(-axis.y, axis.x);
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
        .map(|(u, v)| center + axis * (u * half.x) + side * (v * half.y));
    let mut extent: Option<(f64, f64)> = None;
    let mut include = |x: f64| {
        extent = Some(extent.map_or((x, x), |(low, high): (f64, f64)| (low.min(x), high.max(x))));
    };
    for i in 0..4 {
        let (a, b) = (corners[i], corners[(i + 1) % 4]);
        if (band_min..=band_max).contains(&a.y) {
            include(a.x);
        }
        for y in [band_min, band_max] {
            if (a.y < y) != (b.y < y) {
                include(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
            }
        }
    }
    extent
}
