//! The values that keys of a task file take: each range stands here once, for the reader and the schema.

use crate::particles::MaskSource;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Unexpected, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::borrow::Cow;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::fmt;
use wisch::geometry::Point2;
use wisch::represent::{HALF_ANGLE_RANGE, MAX_PARTICLES};

/// Defines a type for each range, whose values are checked against the limits when they are read.
macro_rules! ranges {
    ($number:ty, $visitor:ident; $($(#[$doc:meta])* $name:ident = $limits:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Serialize)]
        pub(super) struct $name(pub(super) $number);

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let (min, max) = $limits;
                deserializer.deserialize_any($visitor { min, max }).map(Self)
            }
        }

        impl JsonSchema for $name {
            fn inline_schema() -> bool {
                true
            }
            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }
            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                let (min, max): ($number, $number) = $limits;
                json_schema!({ "type": $visitor::TYPE, "minimum": min, "maximum": max })
            }
        }
    )*};
}

ranges! { f64, NumberWithin;
    /// Coordinates of positions [m].
    PositionM = (-100.0, 100.0);
    /// Sizes of surfaces and objects [m].
    SizeM = (1e-3, 100.0);
    /// Radii of cylinders and cones [m], negative for hollows; the smallest size is checked with the outline.
    RadiusM = (-1e4, 1e4);
    /// Half angles of cones [rad].
    HalfAngleRad = (HALF_ANGLE_RANGE[0], HALF_ANGLE_RANGE[1]);
    /// A full turn either way [rad].
    AngleRad = (-TAU, TAU);
    /// A component of a unit quaternion, with a margin for rounding.
    QuaternionPart = (-1.001, 1.001);
    /// From drawings in micrometres to drawings in kilometres.
    Scale = (1e-6, 1e3);
    /// Standard deviation of a heap [m]: from less than a crumb to the size of a hall.
    SigmaM = (1e-5, 10.0);
    /// Shares relative to each other.
    Weight = (1e-9, 1e9);
    /// Bandwidths [m]: between the size of grains and that of surfaces.
    BandwidthM = (1e-3, 10.0);
    /// Path lengths in contact [m]: from a touch to a hall.
    DistanceM = (1e-3, 1e4);
    /// Speeds of a tool in contact [m/s].
    ContactSpeed = (1e-3, 2.0);
    /// Speeds of a tool between strokes [m/s].
    FreeSpeed = (1e-2, 10.0);
    /// Tracking errors [m]: below the size of a tool.
    MarginM = (0.0, 0.1);
    /// Clear of the surface, within an arm's reach [m].
    LiftHeightM = (1e-3, 1.0);
    /// Distances between colours in RGB; black and white are 441.67 apart.
    ColorDistance = (0.0, 442.0);
    /// Coordinates in an image [px]; its true size is known once it is read.
    Pixel = (0.0, 1e6);
    /// Shares of runs with a false warning: below, no memory suffices; above, warnings say little.
    WarningRate = (1e-3, 0.2);
    /// Shares of a whole.
    Share = (0.0, 1.0);
    /// Positions of a hand at its tool, along one axis [m]: up to the end of a long stick.
    GripM = (-5.0, 5.0);
    /// Distances of a tool's face from the origin of a link [m].
    FlangeM = (-0.5, 2.0);
    /// Radii of a holder between a flange and a tool [m].
    HolderRadiusM = (1e-3, 0.5);
    /// Leans of a hand over its tool, from upright to flat [rad].
    LeanRad = (0.0, FRAC_PI_2);
    /// Tilts [rad]: beyond this a surface is another one, not one badly localised.
    TiltRad = (-0.3, 0.3);
    /// Shifts of a badly localised surface [m].
    ShiftM = (-0.2, 0.2);
    /// Coulomb coefficients, from ice to rubber.
    Friction = (0.0, 2.0);
    /// Times in executions of up to an hour [s].
    TimeS = (0.0, 3600.0);
    /// Durations of pushes [s].
    DurationS = (1e-3, 60.0);
    /// Forces of people's pushes, along one axis [N].
    PushForceN = (-200.0, 200.0);
    /// Speeds of hands [m/s].
    HandSpeed = (1e-3, 2.0);
    /// Standard deviations of measured forces [N].
    NoiseN = (0.0, 10.0);
    /// Biases of measured forces, along one axis [N].
    BiasN = (-20.0, 20.0);
    /// Means of ln X.
    LogForce = (-20.0, 20.0);
    /// Standard deviations of ln X.
    LogSpread = (1e-3, 20.0);
    LawSpread = (0.0, 10.0);
    /// Travel after which a grain draws its threshold anew [m].
    RedrawLengthM = (1e-4, 2.0);
    /// Compression depths of tools [m]; 0 is rigid.
    DepthM = (0.0, 0.1);
    /// Sides of a tool's footprint [m].
    FootprintM = (1e-3, 2.0);
    /// Dynamic viscosities [Pa s], from below that of hexane to above that of honey.
    ViscosityPaS = (1e-4, 1e3);
    /// Densities of liquids [kg/m³].
    DensityKgPerM3 = (100.0, 2e4);
    /// Layers of liquid that adhere [m].
    AdheringM = (0.0, 0.01);
    /// Volumes of liquid on a surface [m³], up to a hundred litres.
    VolumeM3 = (1e-12, 0.1);
    /// Diameters of grains [m].
    GrainM = (1e-7, 0.1);
    /// Forces with which arms press [N].
    PressForceN = (0.01, 200.0);
    /// Cartesian stiffness that a compliance controller at 1 kHz keeps stable [N/m].
    Stiffness = (1.0, 1e5);
    /// Aperiodic at 1; far beyond, the arm no longer moves.
    DampingRatio = (0.0, 10.0);
    /// Weights relative to the Cartesian task.
    PostureWeight = (0.0, 1e3);
    /// Stiffnesses over the believed one: beyond, it is another tool.
    Factor = (0.2, 5.0);
    /// Sizes over the believed one.
    SizeFactor = (0.5, 1.5);
    /// Offsets of a tool that has slipped in the hand [m].
    GraspM = (-0.05, 0.05);
    /// Rotations of a tool that has slipped in the hand [rad].
    GraspRad = (-0.5, 0.5);
    /// Masses of dirt that a simulated grain represents [kg].
    GrainMassKg = (0.0, 0.1);
    /// Standard deviations of joint encoders, down to perfect [rad or m].
    EncoderNoise = (0.0, 0.01);
    /// Backlash of worn gears, down to 0 [rad or m].
    Backlash = (0.0, 0.05);
    /// Delays of sensors [s].
    DelayS = (0.0, 0.5);
    /// Distances of joints from where a motion begins [rad or m].
    StartRad = (1e-3, 1.0);
    /// Drifts of force sensors along one axis [N/s].
    DriftN = (-1.0, 1.0);
    /// Coulomb friction in joints [Nm or N].
    JointFriction = (0.0, 20.0);
    /// Heights of waves in what counts as flat [m].
    WavinessM = (0.0, 0.005);
    /// Lengths of such waves [m].
    WaveLengthM = (0.02, 10.0);
    /// Grain diameters at which the detection probability is halved [m]; at 0 it does not depend on size.
    HalfSizeM = (0.0, 0.1);
    /// False detections per area [1/m²].
    FalseAlarms = (0.0, 1e4);
    /// Coefficients of Preston's law, from glass in water to sandpaper [1/Pa].
    PrestonPerPa = (1e-18, 1e-3);
    /// Coats, from a film to plaster [m].
    ThicknessM = (1e-7, 0.05);
    /// Dispensed volumes per metre of path [m³/m].
    VolumePerMetre = (1e-12, 0.01);
    /// Errors of detected positions [m].
    PositionErrorM = (0.0, 0.1);
    /// Scores of plans, from all dirt lost to all dirt at the goal [1].
    Score = (-3.0, 1.0);
}

ranges! { u64, IntegerWithin;
    /// Any seed.
    Seed = (0, u64::MAX);
    /// Numbers of plans to try: ten million take minutes to hours.
    Evaluations = (1, 10_000_000);
    /// Numbers of particles.
    ParticleCount = (1, MAX_PARTICLES as u64);
    /// Passes over a surface.
    Passes = (1, 100);
    /// Numbers of candidate plans.
    Variants = (1, 100);
    /// A channel of a colour.
    Channel = (0, 255);
    /// Numbers of particles that are simulated as rigid bodies.
    Bodies = (0, 2000);
    /// Strokes of a plan, counted from 1.
    StrokeNumber = (1, 100_000);
    /// Rounds, counted from 1.
    Rounds = (1, 100);
    /// The version of the file format.
    SchemaVersion = (super::SCHEMA, super::SCHEMA);
}

struct NumberWithin {
    min: f64,
    max: f64,
}

impl NumberWithin {
    const TYPE: &'static str = "number";
}

impl Visitor<'_> for NumberWithin {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number")
    }
    fn visit_f64<E: serde::de::Error>(self, number: f64) -> Result<f64, E> {
        // NaN lies in no range.
        if (self.min..=self.max).contains(&number) {
            return Ok(number);
        }
        let limits = format!("at least {} and at most {}", self.min, self.max);
        Err(E::invalid_value(
            Unexpected::Float(number),
            &limits.as_str(),
        ))
    }
    fn visit_u64<E: serde::de::Error>(self, number: u64) -> Result<f64, E> {
        self.visit_f64(number as f64)
    }
    fn visit_i128<E: serde::de::Error>(self, number: i128) -> Result<f64, E> {
        self.visit_f64(number as f64)
    }
}

struct IntegerWithin {
    min: u64,
    max: u64,
}

impl IntegerWithin {
    const TYPE: &'static str = "integer";
}

impl Visitor<'_> for IntegerWithin {
    type Value = u64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a whole number")
    }
    fn visit_i128<E: serde::de::Error>(self, number: i128) -> Result<u64, E> {
        let whole = u64::try_from(number).ok();
        whole
            .filter(|whole| (self.min..=self.max).contains(whole))
            .ok_or_else(|| {
                let limits = format!("at least {} and at most {}", self.min, self.max);
                E::invalid_value(Unexpected::Other("whole number"), &limits.as_str())
            })
    }
    fn visit_u64<E: serde::de::Error>(self, number: u64) -> Result<u64, E> {
        self.visit_i128(i128::from(number))
    }
}

/// Defines the names that the values of a domain type have in a task file, for the reader and the schema. `$key`: the kind of
/// such a name, and the key of a table that names its variant.
macro_rules! names {
    ($($(#[$about:meta])* $name:ident($key:literal, $case:literal) for $domain:ty {
        $($(#[$what:meta])* $variant:ident,)*
    })*) => {$(
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
        #[serde(rename = $key, rename_all = $case)]
        #[schemars(inline)]
        pub(super) enum $name {
            $($(#[$what])* $variant,)*
        }

        impl From<$name> for $domain {
            fn from(name: $name) -> Self {
                match name {
                    $($name::$variant => Self::$variant,)*
                }
            }
        }
    )*};
}
pub(super) use names;

/// A string that is not empty and has no control characters.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(super) struct Name(pub(super) String);

impl<'de> Deserialize<'de> for Name {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NotEmpty;
        impl Visitor<'_> for NotEmpty {
            type Value = Name;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a string")
            }
            fn visit_str<E: serde::de::Error>(self, name: &str) -> Result<Name, E> {
                if name.trim().is_empty() {
                    let expected = "a string that is not empty";
                    return Err(E::invalid_type(Unexpected::Str(name), &expected));
                }
                if name.contains(char::is_control) {
                    let expected = "a string without control characters";
                    return Err(E::invalid_type(Unexpected::Str(name), &expected));
                }
                Ok(Name(name.to_owned()))
            }
        }
        deserializer.deserialize_any(NotEmpty)
    }
}

impl JsonSchema for Name {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> Cow<'static, str> {
        "Name".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "string", "pattern": "\\S" })
    }
}

/// Converts coordinates to a point of the surface [m].
pub(super) fn point([x, y]: [PositionM; 2]) -> Point2 {
    Point2::new(x.0, y.0)
}

/// Returns an image of dirt with its parameters, by the keys of a table.
pub(super) fn mask(
    file: &Name,
    corners_px: &[[Pixel; 2]; 4],
    color: &[Channel; 3],
    tolerance: ColorDistance,
    count: ParticleCount,
) -> MaskSource {
    MaskSource {
        file: file.0.clone(),
        corners_px: corners_px.map(|corner| corner.map(|x| x.0).into()),
        color: color.map(|channel| channel.0 as u8),
        tolerance: tolerance.0,
        count: count.0 as usize,
    }
}
