//! Writing of URDF: frames from Denavit–Hartenberg rows, capsules, and their inertias. `libm` rather
//! than the system's mathematics, so that every machine writes the same digits.

use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write as _;
use wisch_robot::geometry::Vector3;

type Matrix3 = nalgebra::Matrix3<f64>;

/// A pose as URDF writes it.
#[derive(Clone, Copy)]
pub struct Origin {
    pub xyz: [f64; 3],
    pub rpy: [f64; 3],
}

impl Origin {
    pub const IDENTITY: Self = Self {
        xyz: [0.0; 3],
        rpy: [0.0; 3],
    };

    pub const fn at(x: f64, y: f64, z: f64) -> Self {
        Self {
            xyz: [x, y, z],
            rpy: [0.0; 3],
        }
    }

    /// A frame from its translation [m] and the rows of its rotation.
    pub fn from_rows(rows: [[f64; 3]; 3], xyz: [f64; 3]) -> Self {
        let [[_, r01, _], [r10, r11, _], [r20, r21, r22]] = rows;
        let r00 = rows[0][0];
        let rpy = if r20.abs() > 1.0 - 1e-12 {
            // Roll and yaw turn about the same axis: all of it goes to yaw.
            [0.0, -r20.signum() * FRAC_PI_2, libm::atan2(-r01, r11)]
        } else {
            [
                libm::atan2(r21, r22),
                libm::asin(-r20),
                libm::atan2(r10, r00),
            ]
        };
        Self {
            xyz: xyz.map(tidy),
            rpy: rpy.map(tidy),
        }
    }

    /// Modified (Craig) Denavit–Hartenberg: Rx(α)·Tx(a)·Rz(θ)·Tz(d), lengths [m], angles [deg].
    pub fn craig(row: &Row) -> Self {
        let (sa, ca) = sin_cos_deg(row.alpha);
        let (st, ct) = sin_cos_deg(row.theta);
        Self::from_rows(
            [
                [ct, -st, 0.0],
                [ca * st, ca * ct, -sa],
                [sa * st, sa * ct, ca],
            ],
            [row.a, -sa * row.d, ca * row.d],
        )
    }

    /// What standard Denavit–Hartenberg has after the joint: Tz(d)·Tx(a)·Rx(α).
    pub fn after_joint(row: &Row) -> Self {
        let (sa, ca) = sin_cos_deg(row.alpha);
        Self::from_rows(
            [[1.0, 0.0, 0.0], [0.0, ca, -sa], [0.0, sa, ca]],
            [row.a, 0.0, row.d],
        )
    }
}

/// A row of a Denavit–Hartenberg table: d [m], θ0 [deg], a [m], α [deg].
#[derive(Clone, Copy)]
pub struct Row {
    pub d: f64,
    pub theta: f64,
    pub a: f64,
    pub alpha: f64,
}

pub const fn row(d: f64, theta: f64, a: f64, alpha: f64) -> Row {
    Row { d, theta, a, alpha }
}

/// Sine and cosine, exact at right angles.
fn sin_cos_deg(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        other => (libm::sin(other.to_radians()), libm::cos(other.to_radians())),
    }
}

/// No negative zero, and π rather than −π.
fn tidy(value: f64) -> f64 {
    if value == -PI { PI } else { value + 0.0 }
}

/// A capsule between two points of the link frame [m].
#[derive(Clone, Copy)]
pub struct Capsule {
    pub from: [f64; 3],
    pub to: [f64; 3],
    pub radius: f64,
}

pub const fn capsule(from: [f64; 3], to: [f64; 3], radius: f64) -> Capsule {
    Capsule { from, to, radius }
}

impl Capsule {
    fn length(&self) -> f64 {
        (Vector3::from(self.to) - Vector3::from(self.from)).norm()
    }

    /// The frame at its middle with z along it.
    fn origin(&self) -> Origin {
        let along = Vector3::from(self.to) - Vector3::from(self.from);
        let middle = (Vector3::from(self.to) + Vector3::from(self.from)) / 2.0;
        let across = libm::sqrt(along.x * along.x + along.y * along.y);
        Origin {
            xyz: [middle.x, middle.y, middle.z].map(tidy),
            rpy: [
                0.0,
                tidy(libm::atan2(across, along.z)),
                tidy(libm::atan2(along.y, along.x)),
            ],
        }
    }

    /// Inertia of a solid capsule of this mass [kg] about its centre, in the axes of the link [kg m²].
    pub fn inertia(&self, mass: f64) -> Matrix3 {
        let (r, l) = (self.radius, self.length());
        let share = l / (l + 4.0 / 3.0 * r);
        let (cylinder, ends) = (mass * share, mass * (1.0 - share));
        let along = cylinder * r * r / 2.0 + ends * 0.4 * r * r;
        let across = cylinder * (l * l / 12.0 + r * r / 4.0)
            + ends * (0.4 * r * r + l * l / 4.0 + 3.0 / 8.0 * l * r);
        let axis = if l > 0.0 {
            (Vector3::from(self.to) - Vector3::from(self.from)) / l
        } else {
            Vector3::z()
        };
        Matrix3::identity() * across + axis * axis.transpose() * (along - across)
    }
}

/// A body: mass [kg], centre of mass in the link frame [m], inertia about it [kg m²].
#[derive(Clone, Copy)]
pub struct Body {
    pub mass: f64,
    pub center: [f64; 3],
    pub inertia: Matrix3,
}

/// A link to write.
pub struct Link<'a> {
    pub name: &'a str,
    pub body: Option<Body>,
    pub capsules: &'a [Capsule],
}

/// How a joint to write moves.
pub enum Motion {
    Fixed,
    /// Revolute about z or prismatic along the axis, with limits: lower, upper, velocity,
    /// acceleration, effort.
    Limited {
        kind: &'static str,
        axis: [f64; 3],
        limits: [f64; 5],
    },
    /// Continuous about z: velocity, acceleration, effort.
    Continuous {
        limits: [f64; 3],
    },
}

/// Revolute about z; positions in degrees.
pub fn revolute_deg(
    lower: f64,
    upper: f64,
    velocity: f64,
    acceleration: f64,
    effort: f64,
) -> Motion {
    let limits = [
        lower.to_radians(),
        upper.to_radians(),
        velocity,
        acceleration,
        effort,
    ];
    revolute(limits)
}

/// Revolute about z: lower, upper, velocity, acceleration, effort.
pub fn revolute(limits: [f64; 5]) -> Motion {
    Motion::Limited {
        kind: "revolute",
        axis: [0.0, 0.0, 1.0],
        limits,
    }
}

/// The text of a URDF as it grows.
pub struct Writer {
    text: String,
}

impl Writer {
    pub fn new(name: &str, comment: &str) -> Self {
        let text = format!(
            "<?xml version=\"1.0\"?>\n<!--\n{comment}\nWritten by the example `robots` of the crate wisch: change the generator, not this file.\n-->\n<robot name=\"{name}\">\n"
        );
        Self { text }
    }

    pub fn finish(mut self) -> String {
        self.text += "</robot>\n";
        self.text
    }

    pub fn raw(&mut self, text: &str) {
        self.text += text;
    }

    pub fn link(&mut self, link: &Link) {
        if link.body.is_none() && link.capsules.is_empty() {
            self.line(format_args!("  <link name=\"{}\"/>", link.name));
            return;
        }
        self.line(format_args!("  <link name=\"{}\">", link.name));
        if let Some(Body {
            mass,
            center,
            inertia: i,
        }) = link.body
        {
            self.line(format_args!("    <inertial>"));
            self.origin(
                6,
                &Origin {
                    xyz: center,
                    rpy: [0.0; 3],
                },
            );
            self.line(format_args!("      <mass value=\"{mass}\"/>"));
            self.line(format_args!(
                "      <inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/>",
                i[(0, 0)],
                tidy(i[(0, 1)]),
                tidy(i[(0, 2)]),
                i[(1, 1)],
                tidy(i[(1, 2)]),
                i[(2, 2)]
            ));
            self.line(format_args!("    </inertial>"));
        }
        for capsule in link.capsules {
            self.capsule(capsule);
        }
        self.line(format_args!("  </link>"));
    }

    /// URDF has no capsule: a cylinder and two balls.
    fn capsule(&mut self, capsule: &Capsule) {
        let radius = capsule.radius;
        if capsule.length() == 0.0 {
            self.ball(capsule.from, radius);
            return;
        }
        self.shape(
            &capsule.origin(),
            format_args!(
                "<cylinder radius=\"{radius}\" length=\"{}\"/>",
                capsule.length()
            ),
        );
        self.ball(capsule.from, radius);
        self.ball(capsule.to, radius);
    }

    fn ball(&mut self, center: [f64; 3], radius: f64) {
        let [x, y, z] = center;
        self.shape(
            &Origin::at(x, y, z),
            format_args!("<sphere radius=\"{radius}\"/>"),
        );
    }

    fn shape(&mut self, origin: &Origin, geometry: std::fmt::Arguments) {
        self.line(format_args!("    <collision>"));
        self.origin(6, origin);
        self.line(format_args!("      <geometry>{geometry}</geometry>"));
        self.line(format_args!("    </collision>"));
    }

    pub fn joint(
        &mut self,
        name: &str,
        [parent, child]: [&str; 2],
        origin: &Origin,
        motion: &Motion,
    ) {
        let kind = match motion {
            Motion::Fixed => "fixed",
            Motion::Limited { kind, .. } => kind,
            Motion::Continuous { .. } => "continuous",
        };
        self.line(format_args!("  <joint name=\"{name}\" type=\"{kind}\">"));
        self.line(format_args!("    <parent link=\"{parent}\"/>"));
        self.line(format_args!("    <child link=\"{child}\"/>"));
        self.origin(4, origin);
        match motion {
            Motion::Fixed => {}
            Motion::Limited {
                axis: [x, y, z],
                limits: [lower, upper, velocity, acceleration, effort],
                ..
            } => {
                self.line(format_args!("    <axis xyz=\"{x} {y} {z}\"/>"));
                self.line(format_args!("    <limit lower=\"{lower}\" upper=\"{upper}\" velocity=\"{velocity}\" acceleration=\"{acceleration}\" effort=\"{effort}\"/>"));
            }
            Motion::Continuous {
                limits: [velocity, acceleration, effort],
            } => {
                self.line(format_args!("    <axis xyz=\"0 0 1\"/>"));
                self.line(format_args!("    <limit velocity=\"{velocity}\" acceleration=\"{acceleration}\" effort=\"{effort}\"/>"));
            }
        }
        self.line(format_args!("  </joint>"));
    }

    fn origin(&mut self, indent: usize, origin: &Origin) {
        let [x, y, z] = origin.xyz;
        let [roll, pitch, yaw] = origin.rpy;
        let pad = " ".repeat(indent);
        self.line(format_args!(
            "{pad}<origin xyz=\"{x} {y} {z}\" rpy=\"{roll} {pitch} {yaw}\"/>"
        ));
    }

    fn line(&mut self, line: std::fmt::Arguments) {
        writeln!(self.text, "{line}").expect("a String takes everything");
    }
}
