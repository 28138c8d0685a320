//! Somebody or something is in the way of the tool.

use super::events::{Evidence, Level, Run, level};
use super::{Event, EventKind};

impl Evidence<'_> {
    /// Pushes: without the tool's own landing after one, and each as one.
    pub(super) fn collisions(&self) -> Vec<Event> {
        let runs = self.runs(|i| self.collision(i), |i| self.push_bridge(i));
        let mut pushes: Vec<Run> = Vec::new();
        for run in runs {
            match pushes.last_mut() {
                Some(before) if self.is_landing(before, &run) => {}
                Some(before) if self.gap(before, &run) <= self.config.events.push_gap_s => {
                    before.last = run.last;
                }
                _ => pushes.push(run),
            }
        }
        (pushes.iter())
            .map(|run| self.described(EventKind::Collision, run.first, run.last))
            .collect()
    }

    /// Time from the end of one run to the beginning of the next [s].
    fn gap(&self, before: &Run, next: &Run) -> f64 {
        self.span(next.first)[0] - self.span(before.last)[1]
    }

    /// Whether a run soon after a push is the tool that was let go of and comes down again: it presses on
    /// the surface, and nothing draws it along.
    fn is_landing(&self, before: &Run, next: &Run) -> bool {
        let (mut drawn, mut pressed) = (0.0, 0.0);
        for i in next.first..=next.last {
            let [start, end] = self.span(i);
            if self.shoved(i).max(self.handled(i)) == Level::Strong {
                drawn += end - start;
            } else if self.overloaded(i).max(self.off_plane(i)) == Level::Strong {
                pressed += end - start;
            }
        }
        self.gap(before, next) <= self.config.events.landing_s && pressed > drawn
    }

    pub(super) fn is_pushed(&self, i: usize) -> bool {
        self.collision(i) != Level::Below
    }

    fn collision(&self, i: usize) -> Level {
        self.off_plane(i)
            .max(self.shoved(i))
            .max(self.overloaded(i))
            .max(self.handled(i))
    }

    /// Off the plane with a force like that of contact (Fig. 18).
    fn off_plane(&self, i: usize) -> Level {
        if !self.has_plane {
            return Level::Below;
        }
        let events = &self.config.events;
        let share = self.path[i].normalized_force;
        let off = self.off[i];
        // A tool that moves looks off the plane by as much as its force lags.
        let lag = events.force_lag_s * self.climb(i);
        let far = events.collision_height_m + lag;
        level(
            off > lag && share >= events.collision_share[1],
            off > far && share >= events.collision_share[0],
        )
    }

    /// More force along the surface than friction takes.
    fn shoved(&self, i: usize) -> Level {
        let events = &self.config.events;
        let piece = &self.path[i];
        let press = (-piece.normal_force).max(0.0);
        let beyond = |friction: f64| piece.tangential_force - friction * press;
        let [begin, end] = events.tangential_margin_n;
        level(
            beyond(self.friction) > end,
            beyond(events.friction_limit) > begin,
        )
    }

    /// Much more normal force than asked for.
    fn overloaded(&self, i: usize) -> Level {
        let nominal = self.config.nominal_force();
        let noise = 2.0 * self.config.force_noise_n;
        let force = -self.path[i].normal_force - noise;
        let [begin, end] = self.config.events.overload;
        level(force > end * nominal, force > begin * nominal)
    }

    /// Above the surface, where nothing is but who holds the tool.
    fn is_free(&self, i: usize) -> bool {
        let events = &self.config.events;
        let lag = events.force_lag_s * self.climb(i);
        let least = if self.has_plane {
            events.near_height_m
        } else {
            self.config.search_height_m
        };
        self.path[i].height > least && self.off[i] > events.collision_height_m + lag
    }

    /// Any force in free motion, whatever its direction.
    fn handled(&self, i: usize) -> Level {
        if !self.is_free(i) {
            return Level::Below;
        }
        let piece = &self.path[i];
        let force = piece.normal_force.hypot(piece.tangential_force) - self.noise;
        let [begin, end] = self.config.events.free_force_n;
        level(force > end, force > begin)
    }

    /// How long a push may be interrupted at a piece [s].
    fn push_bridge(&self, i: usize) -> f64 {
        let events = &self.config.events;
        if self.is_free(i) {
            events.free_bridge_s
        } else {
            events.bridge_s
        }
    }
}
