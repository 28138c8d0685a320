//! Tree of frames, from the transforms of a log and the fixed joints of a robot.

use super::quantity::Quantity;
use super::ros2::NANOSECONDS_PER_SECOND;
use std::collections::{BTreeMap, BTreeSet};
use wisch::geometry::Pose;

/// Tree of frames: each frame's pose in its parent, over time.
#[derive(Debug, Clone, Default)]
pub(crate) struct Frames {
    /// Links to the parents, by child.
    links: BTreeMap<String, Link>,
}

/// A frame's poses in its parent.
#[derive(Debug, Clone)]
struct Link {
    parent: String,
    is_static: bool,
    /// Times [ns] and poses of the child in the parent.
    entries: Vec<(i64, Pose)>,
}

/// A path between two frames: up from each of them to a common frame.
#[derive(Debug, Clone, Default)]
pub(crate) struct Chain<'a> {
    from: Vec<&'a Link>,
    to: Vec<&'a Link>,
}

/// Returns a frame's name as tf compares names: older names begin with a slash.
fn plain(frame: &str) -> &str {
    frame.trim_start_matches('/')
}

/// Distance [m] and angle [rad] of two constant poses of a frame that count as the same.
const MOST_CHANGE: [f64; 2] = [1e-4, 1e-3];

impl Frames {
    /// Adds the pose of `child` in `parent` at a time [ns], or for all times.
    pub fn insert(&mut self, parent: &str, child: &str, time: i64, pose: Pose, is_static: bool) {
        let link = (self.links)
            .entry(plain(child).to_owned())
            .or_insert_with(|| Link {
                parent: plain(parent).to_owned(),
                is_static,
                entries: Vec::new(),
            });
        // If a frame gets two parents, the first one stays, so that the frames remain a tree.
        if link.parent == plain(parent) {
            link.is_static &= is_static;
            link.entries.push((time, pose));
        }
    }

    /// Adds all transforms of another tree; those that move are shifted by `shift` [ns]. If a frame has different
    /// parents in the two trees, its parent in this tree stays.
    pub fn absorb(&mut self, other: Self, shift: i64) {
        for (child, link) in other.links {
            for (time, pose) in link.entries {
                let time = if link.is_static {
                    time
                } else {
                    time.saturating_add(shift)
                };
                self.insert(&link.parent, &child, time, pose, link.is_static);
            }
        }
    }

    /// Sorts all transforms by time.
    pub fn sort(&mut self) {
        for link in self.links.values_mut() {
            link.entries.sort_by_key(|entry| entry.0);
        }
    }

    /// Returns a remark on each frame whose pose is constant, but is stated differently.
    pub fn remark_on_changes(&self) -> Vec<String> {
        let changed = |(child, link): (&String, &Link)| {
            let (_, last) = link.entries.last().filter(|_| link.is_static)?;
            let off = |pose: &Pose| {
                let distance = (pose.translation.vector - last.translation.vector).norm();
                [distance, pose.rotation.angle_to(&last.rotation)]
            };
            let [distance, angle] = (link.entries.iter())
                .map(|(_, pose)| off(pose))
                .fold([0.0_f64; 2], |most, off| {
                    [most[0].max(off[0]), most[1].max(off[1])]
                });
            (distance > MOST_CHANGE[0] || angle > MOST_CHANGE[1]).then(|| {
                format!(
                    "static transforms state several poses of {child:?} in {:?}, {:.1} mm and {:.2}° apart: the last one is used for the whole log",
                    link.parent,
                    1e3 * distance,
                    angle.to_degrees()
                )
            })
        };
        self.links.iter().filter_map(changed).collect()
    }

    /// Whether the tree holds the frame.
    pub fn knows(&self, frame: &str) -> bool {
        let frame = plain(frame);
        self.links.contains_key(frame) || self.links.values().any(|link| link.parent == frame)
    }

    /// Names of all frames.
    pub fn names(&self) -> BTreeSet<&str> {
        let pairs = self.links.iter();
        pairs
            .flat_map(|(child, link)| [child.as_str(), link.parent.as_str()])
            .collect()
    }

    /// The parent of a frame, if it has one.
    pub fn parent(&self, child: &str) -> Option<&str> {
        (self.links.get(plain(child))).map(|link| link.parent.as_str())
    }

    /// The frames above a frame, the nearest first.
    pub fn ancestors<'a>(&'a self, frame: &'a str) -> impl Iterator<Item = &'a str> {
        self.above(plain(frame))
            .into_iter()
            .map(|(_, link)| link.parent.as_str())
    }

    /// The outermost frame above a frame, or the frame itself.
    pub fn root_of<'a>(&'a self, frame: &'a str) -> &'a str {
        self.ancestors(frame).last().unwrap_or(plain(frame))
    }

    /// The frames that move in their parents; if none moves, those with repeated transforms.
    pub fn moving(&self) -> Vec<&str> {
        let repeated = self.links.iter().filter(|(_, link)| !link.is_static);
        let repeated: Vec<(&str, &Link)> = repeated
            .map(|(child, link)| (child.as_str(), link))
            .collect();
        let is_moved = |link: &Link| link.entries.windows(2).any(|pair| pair[0].1 != pair[1].1);
        let moving: Vec<&str> = (repeated.iter())
            .filter(|(_, link)| is_moved(link))
            .map(|(child, _)| *child)
            .collect();
        if moving.is_empty() {
            return repeated.into_iter().map(|(child, _)| child).collect();
        }
        moving
    }

    /// The outermost frame above a frame in which it never moves; `None` if the frame moves or has no parent.
    pub fn rigid_root<'a>(&'a self, frame: &'a str) -> Option<&'a str> {
        let above = self.above(plain(frame));
        let rigid = above.iter().take_while(|(_, link)| link.is_static);
        rigid.last().map(|(_, link)| link.parent.as_str())
    }

    /// Returns the path between two frames, if they are connected.
    pub fn between<'a>(&'a self, to: &'a str, from: &'a str) -> Option<Chain<'a>> {
        let (to, from) = (plain(to), plain(from));
        let ([up, down], names) = ([from, to].map(|frame| self.above(frame)), [from, to]);
        let place = |chain: &[(&str, &Link)], own: &str, name: &str| {
            if own == name {
                return Some(0);
            }
            let found = chain.iter().position(|(_, link)| link.parent == name);
            found.map(|index| index + 1)
        };
        // The lowest common frame: go up from one frame until the other is below it.
        let candidates =
            std::iter::once(from).chain(up.iter().map(|(_, link)| link.parent.as_str()));
        for (steps, name) in candidates.enumerate() {
            if let Some(others) = place(&down, names[1], name) {
                let links = |chain: &[(&'a str, &'a Link)], count: usize| {
                    chain[..count].iter().map(|(_, link)| *link).collect()
                };
                return Some(Chain {
                    from: links(&up, steps),
                    to: links(&down, others),
                });
            }
        }
        None
    }

    /// Returns the links above a frame, the nearest first; a cycle ends where it closes.
    fn above<'a>(&'a self, frame: &'a str) -> Vec<(&'a str, &'a Link)> {
        let mut seen = BTreeSet::from([frame]);
        let mut chain = Vec::new();
        let mut at = frame;
        while let Some(link) = self.links.get(at) {
            chain.push((at, link));
            if !seen.insert(&link.parent) {
                break;
            }
            at = &link.parent;
        }
        chain
    }
}

impl Chain<'_> {
    /// Number of transforms on the path.
    pub fn len(&self) -> usize {
        self.from.len() + self.to.len()
    }

    /// Times [ns] of the most frequent transform on the path; empty if nothing moves.
    pub fn busiest_times(&self) -> Vec<i64> {
        let moving = self
            .from
            .iter()
            .chain(&self.to)
            .filter(|link| !link.is_static);
        let busiest = moving.max_by_key(|link| link.entries.len());
        let times = busiest.into_iter().flat_map(|link| &link.entries);
        times.map(|entry| entry.0).collect()
    }

    /// Returns the pose of one frame in the other at a time [ns]. `None` if a transform on the path has a gap of more
    /// than `max_gap` [s] around that time.
    pub fn pose_at(&self, time: i64, max_gap: f64) -> Option<Pose> {
        let along = |links: &[&Link]| {
            links.iter().try_fold(Pose::identity(), |pose, link| {
                Some(link.at(time, max_gap)? * pose)
            })
        };
        // T(to, from) = T(common, to)⁻¹ T(common, from), where each factor is the product of the poses along its links.
        Some(along(&self.to)?.inverse() * along(&self.from)?)
    }
}

impl Link {
    fn at(&self, time: i64, max_gap: f64) -> Option<Pose> {
        if self.is_static {
            return self.entries.last().map(|entry| entry.1);
        }
        let near = |a: i64, b: i64| a.abs_diff(b) as f64 / NANOSECONDS_PER_SECOND as f64 <= max_gap;
        let after = self.entries.partition_point(|entry| entry.0 < time);
        let before = after.checked_sub(1).map(|index| &self.entries[index]);
        match (before, self.entries.get(after)) {
            (_, Some((end, pose))) if *end == time => Some(*pose),
            (Some((start, from)), Some((end, to))) => {
                // Linear interpolation of the position, spherical of the rotation.
                let share = time.abs_diff(*start) as f64 / end.abs_diff(*start) as f64;
                near(*start, *end).then(|| from.between(to, share))
            }
            (Some((end, pose)), None) | (None, Some((end, pose))) => {
                near(*end, time).then_some(*pose)
            }
            (None, None) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch::geometry::Vector3;

    fn close(a: Pose, b: Pose) {
        let difference = a.inverse() * b;
        assert!(
            difference.translation.vector.norm() < 1e-9 && difference.rotation.angle() < 1e-9,
            "{a} {b}"
        );
    }

    #[test]
    fn a_constant_pose_that_changes_is_remarked() {
        let mut frames = Frames::default();
        let raised = |height| Pose::translation(0.0, 0.0, height);
        frames.insert("world", "base", 0, raised(0.0), true);
        frames.insert("base", "flange", 0, raised(0.3), false);
        frames.insert("base", "flange", 9, raised(0.4), false);
        assert_eq!(frames.remark_on_changes(), [""; 0]);
        frames.insert("world", "base", 6, raised(0.02), true);
        assert_eq!(
            frames.remark_on_changes(),
            [
                "static transforms state several poses of \"base\" in \"world\", 20.0 mm and 0.00° apart: the last one is used for the whole log"
            ]
        );
    }

    #[test]
    fn frames_are_found_up_and_down_the_tree() {
        let pose = |x: f64, angle: f64| Pose::new(Vector3::new(x, 0.0, 0.0), Vector3::z() * angle);
        let mut frames = Frames::default();
        frames.insert("world", "base", 0, pose(1.0, 0.5), true);
        frames.insert("/base", "/flange", 20, pose(0.4, 0.2), false);
        frames.insert("base", "flange", 0, pose(0.2, 0.2), false);
        frames.insert("flange", "sensor", 0, pose(0.0, 1.0), true);
        frames.insert("flange", "tool", 0, pose(0.1, 0.0), true);
        frames.sort();
        let at = |to: &str, from: &str, time| frames.between(to, from)?.pose_at(time, 1.0);
        let sensor = pose(1.0, 0.5) * pose(0.3, 0.2) * pose(0.0, 1.0);
        close(at("world", "sensor", 10).unwrap(), sensor);
        close(at("sensor", "world", 10).unwrap(), sensor.inverse());
        close(
            at("tool", "sensor", 10).unwrap(),
            pose(-0.1, 0.0) * pose(0.0, 1.0),
        );
        close(at("tool", "tool", 10).unwrap(), Pose::identity());
        assert!(frames.between("world", "camera").is_none());
        assert_eq!(frames.rigid_root("sensor"), Some("flange"));
        assert_eq!(frames.rigid_root("flange"), None);
        // The transform is known at most a nanosecond before and after.
        let chain = frames.between("world", "tool").unwrap();
        assert!(chain.pose_at(21, 1e-9).is_some() && chain.pose_at(22, 1e-9).is_none());
        assert!(
            chain.pose_at(10, 1e-9).is_none(),
            "20 ns lie between its times"
        );
    }

    #[test]
    fn a_cycle_of_frames_ends() {
        let mut frames = Frames::default();
        frames.insert("a", "b", 0, Pose::identity(), true);
        frames.insert("b", "a", 0, Pose::identity(), true);
        assert!(frames.between("world", "b").is_none());
        assert!(frames.between("a", "b").is_some());
    }
}
