//! Camera observations of the dirt, as messages.

use super::topic::{DIRT, FRAME_SURFACE, HIDDEN};
use crate::error::ReadFault;
use crate::ros2::messages::{
    FIELD_FLOAT32, FIELD_FLOAT64, OwnedHeader, Point32, PointCloud2, PointField, PolygonStamped,
    Time,
};
use mcap::Channel;
use wisch::geometry::{Point2, Polygon, Region};
use wisch::represent::{MAX_PARTICLES, Observation};

/// Time of an observation relative to its round.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ObservationTime {
    /// Before the round begins.
    Before,
    /// After its last sample.
    After,
}

/// Length of a point in a written cloud: x, y and z [bytes].
const POINT_STEP: u32 = 12;

/// Converts points of the surface to a point cloud.
pub(super) fn point_cloud(time: u64, places: &[Point2]) -> PointCloud2 {
    let field = |(index, name): (u32, &str)| PointField {
        name: name.to_owned(),
        offset: 4 * index,
        datatype: FIELD_FLOAT32,
        count: 1,
    };
    let width = u32::try_from(places.len()).unwrap_or(u32::MAX);
    let coordinates = places.iter().flat_map(|place| [place.x, place.y, 0.0]);
    PointCloud2 {
        header: in_surface(time),
        height: 1,
        width,
        fields: (0..).zip(["x", "y", "z"]).map(field).collect(),
        is_bigendian: false,
        point_step: POINT_STEP,
        row_step: POINT_STEP.saturating_mul(width),
        data: coordinates.flat_map(|x| (x as f32).to_le_bytes()).collect(),
        is_dense: true,
    }
}

/// Converts a polygon on the surface to a message.
pub(super) fn polygon_stamped(time: u64, corners: &[Point2]) -> PolygonStamped {
    let corner = |place: &Point2| Point32 {
        x: place.x as f32,
        y: place.y as f32,
        z: 0.0,
    };
    PolygonStamped {
        header: in_surface(time),
        points: corners.iter().map(corner).collect(),
    }
}

fn in_surface(time: u64) -> OwnedHeader {
    OwnedHeader {
        stamp: Time::from_nanoseconds(time),
        frame_id: FRAME_SURFACE.to_owned(),
    }
}

/// Collector of the observations in a bag.
#[derive(Debug, Default)]
pub(super) struct ObservationCollector {
    /// Detections before and after the round.
    seen: [Option<Vec<Point2>>; 2],
    hidden: [Vec<Polygon>; 2],
}

impl ObservationCollector {
    /// Reads a message, if its topic is one of an observation.
    pub(super) fn take(&mut self, channel: &Channel<'_>, data: &[u8]) -> Result<(), ReadFault> {
        let topic = channel.topic.as_str();
        let fault = |problem: String| ReadFault::Observation {
            topic: topic.to_owned(),
            problem,
        };
        if let Some(look) = DIRT.iter().position(|known| *known == topic) {
            expect_kind(channel, "PointCloud2").map_err(fault)?;
            let cloud: PointCloud2 =
                cdr::deserialize(data).map_err(|error| fault(error.to_string()))?;
            // Of several messages the last one counts, as of a camera that keeps publishing.
            self.seen[look] = Some(places(&cloud).map_err(fault)?);
            self.hidden[look].clear();
        } else if let Some(look) = HIDDEN.iter().position(|known| *known == topic) {
            expect_kind(channel, "PolygonStamped").map_err(fault)?;
            let polygon: PolygonStamped =
                cdr::deserialize(data).map_err(|error| fault(error.to_string()))?;
            expect_frame(&polygon.header.frame_id).map_err(fault)?;
            let corners = polygon.points.iter();
            let corners = corners.map(|p| Point2::new(p.x.into(), p.y.into()));
            let corners: Vec<Point2> = corners.collect();
            if let Some(corner) = corners.iter().find(|p| !is_finite(p)) {
                return Err(fault(format!("corner {corner} m is not finite")));
            }
            self.hidden[look].push(Polygon::new(corners, vec![]));
        }
        Ok(())
    }

    /// Returns the observations before and after the round.
    pub(super) fn finish(self) -> [Option<Observation>; 2] {
        let mut hidden = self.hidden.into_iter();
        self.seen.map(|seen| {
            let hidden = Region::new(hidden.next().unwrap_or_default());
            seen.map(|detections| Observation { detections, hidden })
        })
    }
}

/// Whether a topic is one of an observation.
pub(super) fn is_observation_topic(topic: &str) -> bool {
    DIRT.contains(&topic) || HIDDEN.contains(&topic)
}

fn expect_kind(channel: &Channel<'_>, kind: &str) -> Result<(), String> {
    let found = (channel.schema.as_ref()).map_or("", |schema| schema.name.as_str());
    if channel.message_encoding != "cdr" {
        let encoding = &channel.message_encoding;
        return Err(format!(
            "its message encoding is {encoding:?}, but only \"cdr\" is read"
        ));
    }
    if found.ends_with(kind) {
        Ok(())
    } else {
        Err(format!("its type is {found:?}, but only {kind} is read"))
    }
}

fn expect_frame(frame: &str) -> Result<(), String> {
    if frame == FRAME_SURFACE {
        return Ok(());
    }
    Err(format!(
        "its frame is {frame:?}, but only {FRAME_SURFACE:?}, the frame of the believed surface, is read"
    ))
}

/// Reads the points of a cloud [m].
fn places(cloud: &PointCloud2) -> Result<Vec<Point2>, String> {
    expect_frame(&cloud.header.frame_id)?;
    let count = u64::from(cloud.width) * u64::from(cloud.height);
    if count > MAX_PARTICLES as u64 {
        return Err(format!(
            "{count} points exceed the limit of {MAX_PARTICLES}"
        ));
    }
    let step = cloud.point_step as usize;
    let needed = count as usize * step;
    if cloud.data.len() < needed {
        let len = cloud.data.len();
        return Err(format!(
            "{count} points need {needed} bytes, but there are {len}"
        ));
    }
    let field = |name: &str| {
        let found = cloud.fields.iter().find(|field| field.name == name);
        let field = found.ok_or_else(|| format!("field {name:?} is missing"))?;
        let len = match field.datatype {
            FIELD_FLOAT32 => 4,
            FIELD_FLOAT64 => 8,
            other => {
                return Err(format!(
                    "field {name:?} is of type {other}, but only floats are read"
                ));
            }
        };
        let offset = field.offset as usize;
        if offset.saturating_add(len) > step {
            return Err(format!(
                "field {name:?} lies beyond the {step} bytes of a point"
            ));
        }
        Ok((offset, len))
    };
    let (x, y) = (field("x")?, field("y")?);
    let number = |point: &[u8], (offset, len): (usize, usize)| -> f64 {
        let mut bytes = [0; 8];
        bytes[..len].copy_from_slice(&point[offset..offset + len]);
        if cloud.is_bigendian {
            bytes[..len].reverse();
        }
        match len {
            4 => f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]).into(),
            _ => f64::from_le_bytes(bytes),
        }
    };
    let mut places = Vec::with_capacity(count as usize);
    if step == 0 {
        return Ok(places);
    }
    for point in cloud.data[..needed].chunks_exact(step) {
        let place = Point2::new(number(point, x), number(point, y));
        if is_finite(&place) {
            places.push(place);
        } else if cloud.is_dense {
            return Err(format!("point {place} m is not finite"));
        }
    }
    Ok(places)
}

fn is_finite(place: &Point2) -> bool {
    place.x.is_finite() && place.y.is_finite()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_written_cloud_is_read_back() {
        let written = [Point2::new(0.125, -0.5), Point2::new(0.0, 0.25)];
        let cloud = point_cloud(7, &written);
        assert_eq!(places(&cloud), Ok(written.to_vec()));
        assert_eq!(places(&point_cloud(7, &[])), Ok(vec![]));

        // Another layout: eight bytes per number, big-endian, y before x, with padding between them.
        let field = |name: &str, offset| PointField {
            name: name.to_owned(),
            offset,
            datatype: FIELD_FLOAT64,
            count: 1,
        };
        let rows = written.map(|p| [p.y, 9.0, p.x].map(f64::to_be_bytes).concat());
        let other = PointCloud2 {
            fields: vec![field("y", 0), field("x", 16)],
            is_bigendian: true,
            point_step: 24,
            data: rows.concat(),
            ..cloud
        };
        assert_eq!(places(&other), Ok(written.to_vec()));
    }

    #[test]
    fn an_inconsistent_cloud_is_refused() {
        let cloud = || point_cloud(7, &[Point2::new(0.125, -0.5)]);
        let refused = |cloud: PointCloud2| places(&cloud).unwrap_err();
        let mut other = cloud();
        other.header.frame_id = "camera".to_owned();
        assert!(refused(other).starts_with("its frame is \"camera\""));
        let mut short = cloud();
        short.data.pop();
        assert_eq!(refused(short), "1 points need 12 bytes, but there are 11");
        let mut many = cloud();
        (many.width, many.height) = (u32::MAX, u32::MAX);
        assert!(refused(many).contains("exceed the limit of"));
        let mut beyond = cloud();
        beyond.fields[1].offset = 9;
        assert_eq!(
            refused(beyond),
            "field \"y\" lies beyond the 12 bytes of a point"
        );
        let mut typed = cloud();
        typed.fields[0].datatype = 5;
        assert_eq!(
            refused(typed),
            "field \"x\" is of type 5, but only floats are read"
        );
        let mut nameless = cloud();
        nameless.fields.remove(0);
        assert_eq!(refused(nameless), "field \"x\" is missing");
        let mut infinite = cloud();
        infinite.data[..4].copy_from_slice(&f32::NAN.to_le_bytes());
        assert!(refused(infinite.clone()).ends_with("is not finite"));
        infinite.is_dense = false;
        assert_eq!(places(&infinite), Ok(vec![]));
        let nothing = PointCloud2 {
            point_step: 0,
            ..cloud()
        };
        assert!(places(&nothing).is_err());
    }
}
