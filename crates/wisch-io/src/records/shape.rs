//! The shape of a surface, and the contact of a tool with its bend. Units are SI and radians.

use serde::{Deserialize, Serialize};
use std::fmt;
use wisch::plan::BendContact;
use wisch::represent::{Cone, SurfaceShape, Task};

/// Radius from which a bend of a mesh counts as none [m]: under a tool of 10 cm, it is 0.06 mm deep.
const TOLD_RADIUS: f64 = 20.0;

/// The shape onto which the chart of a surface is rolled, so that it touches the xy plane of the surface frame at the origin.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum ShapeRecord {
    /// The chart is the surface.
    Plane,
    /// A circular cylinder.
    Cylinder {
        /// Radius \[m\], positive where it bulges towards the tool, negative where it is hollow.
        radius_m: f64,
        /// Angle of its axis from x \[rad\].
        axis_rad: f64,
    },
    /// A circular cone.
    Cone {
        /// Distance of the origin from the axis \[m\], positive where it bulges towards the tool, negative where it is
        /// hollow.
        radius_m: f64,
        /// Angle between axis and surface \[rad\].
        half_angle_rad: f64,
        /// Direction from x in which it widens \[rad\].
        axis_rad: f64,
    },
    /// The surface of a mesh, in its chart.
    Mesh {
        /// Area of the surface.
        area_m2: f64,
        /// Number of triangles of the chart.
        triangles: usize,
        /// Least radius of its bulges; `None` if it has none.
        #[serde(default)]
        bulge_radius_m: Option<f64>,
        /// Least radius of its hollows; `None` if it has none.
        #[serde(default)]
        hollow_radius_m: Option<f64>,
        /// Largest stretch of a triangle of the chart.
        stretch: f64,
        /// Digest of the mesh, in hexadecimal digits; `None` in files of earlier versions.
        #[serde(default, skip_serializing_if = "Option::is_none", with = "hexadecimal")]
        digest: Option<u128>,
    },
}

impl ShapeRecord {
    /// Returns the record of a curved surface; `None` for a plane.
    pub fn from_curved(shape: &SurfaceShape) -> Option<Self> {
        (!shape.is_plane()).then(|| shape.into())
    }

    /// Whether another record states the same shape. Records of earlier versions do not state the digest of a mesh.
    pub fn is_same_as(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Mesh { digest: None, .. }, _) | (_, Self::Mesh { digest: None, .. }) => {
                self.without_digest() == other.without_digest()
            }
            _ => self == other,
        }
    }

    fn without_digest(mut self) -> Self {
        if let Self::Mesh { digest, .. } = &mut self {
            *digest = None;
        }
        self
    }
}

impl From<&SurfaceShape> for ShapeRecord {
    fn from(shape: &SurfaceShape) -> Self {
        match shape {
            SurfaceShape::Plane => Self::Plane,
            &SurfaceShape::Cylinder { radius, axis } => Self::Cylinder {
                radius_m: radius,
                axis_rad: axis,
            },
            &SurfaceShape::Cone(Cone {
                radius,
                half_angle,
                axis,
            }) => Self::Cone {
                radius_m: radius,
                half_angle_rad: half_angle,
                axis_rad: axis,
            },
            SurfaceShape::Mesh(mesh) => {
                let radii = mesh.least_radii();
                let told = |radius: f64| (radius < TOLD_RADIUS).then_some(radius);
                Self::Mesh {
                    area_m2: mesh.sheet().area(),
                    triangles: mesh.sheet().triangle_count(),
                    bulge_radius_m: told(radii.bulge),
                    hollow_radius_m: told(radii.hollow),
                    stretch: mesh.sheet().stretch().most,
                    digest: Some(mesh.digest()),
                }
            }
        }
    }
}

impl fmt::Display for ShapeRecord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Plane => f.write_str("plane"),
            Self::Cylinder { radius_m, axis_rad } => write!(
                f,
                "cylinder of radius {radius_m} m with its axis at {axis_rad} rad"
            ),
            Self::Cone {
                radius_m,
                half_angle_rad,
                axis_rad,
            } => write!(
                f,
                "cone of radius {radius_m} m and half angle {half_angle_rad} rad that widens at {axis_rad} rad"
            ),
            Self::Mesh {
                area_m2,
                triangles,
                bulge_radius_m,
                hollow_radius_m,
                stretch,
                digest,
            } => {
                write!(f, "mesh of {area_m2:.3} m2 in {triangles} triangles")?;
                for (name, radius) in [("bulges", bulge_radius_m), ("hollows", hollow_radius_m)] {
                    if let Some(radius) = radius {
                        write!(f, ", {name} of at least {radius:.2} m radius")?;
                    }
                }
                write!(
                    f,
                    ", unrolled with a stretch of up to {:.1} %",
                    100.0 * stretch
                )?;
                match digest {
                    Some(digest) => write!(f, ", digest {digest:032x}"),
                    None => Ok(()),
                }
            }
        }
    }
}

/// Numbers of 128 bits as hexadecimal digits, because JSON readers round larger numbers than 2^53.
mod hexadecimal {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub fn serialize<S: Serializer>(number: &Option<u128>, to: S) -> Result<S::Ok, S::Error> {
        number.map(|number| format!("{number:032x}")).serialize(to)
    }

    pub fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<Option<u128>, D::Error> {
        let text = Option::<String>::deserialize(from)?;
        let number = |text: String| {
            u128::from_str_radix(&text, 16)
                .map_err(|_| D::Error::custom(format!("digest {text:?} is not hexadecimal")))
        };
        text.map(number).transpose()
    }
}

/// Contact of an upright tool with a surface that bends, at nominal force.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BendContactRecord {
    /// Least share of the footprint that touches, over all yaws.
    pub touched_share_least: f64,
    /// Largest share of the footprint that touches, over all yaws.
    pub touched_share_most: f64,
    /// Least pressure over the nominal one; 0 where the tool does not touch.
    pub pressure_least: f64,
    /// Largest pressure over the nominal one.
    pub pressure_most: f64,
    /// Length across the bend of the longest rectangular tool that would touch everywhere; `None` if any length would.
    pub fitting_length_m: Option<f64>,
    /// Compression at nominal force that is assumed.
    pub compression_m: f64,
}

impl BendContactRecord {
    /// Makes the record for the tool of a task; `None` on a plane, and for a tool that hovers.
    pub fn new(task: &Task) -> Option<Self> {
        BendContact::from_task(task).map(|contact| Self {
            touched_share_least: contact.touched_share[0],
            touched_share_most: contact.touched_share[1],
            pressure_least: contact.pressure[0],
            pressure_most: contact.pressure[1],
            fitting_length_m: Some(contact.fitting_length).filter(|length| length.is_finite()),
            compression_m: contact.compression,
        })
    }

    /// Returns the contact of the record.
    pub fn contact(&self) -> BendContact {
        BendContact {
            touched_share: [self.touched_share_least, self.touched_share_most],
            pressure: [self.pressure_least, self.pressure_most],
            fitting_length: self.fitting_length_m.unwrap_or(f64::INFINITY),
            compression: self.compression_m,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::BendContactRecord;

    #[test]
    fn the_contact_of_a_flat_mesh_is_read_as_it_was_written() {
        let record = BendContactRecord {
            touched_share_least: 1.0,
            touched_share_most: 1.0,
            pressure_least: 1.0,
            pressure_most: 1.0,
            fitting_length_m: None,
            compression_m: 0.005,
        };
        let text = serde_json::to_string(&record).unwrap();
        let read: BendContactRecord = serde_json::from_str(&text).unwrap();
        assert_eq!(read, record);
        assert_eq!(read.contact().fitting_length, f64::INFINITY);
    }
}
