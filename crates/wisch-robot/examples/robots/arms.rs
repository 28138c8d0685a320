//! Two fixed arms with published Denavit–Hartenberg numbers and limits. Capsules are ours; inertias
//! are those of the capsules, and centres of mass are their middles.

use super::urdf::{Body, Capsule, Link, Motion, Origin, Row, Writer, capsule, revolute, row};
use std::f64::consts::{PI, TAU};

/// Modified Denavit–Hartenberg table of a Franka Emika Panda, and the flange (d = 0.107 m).
const PANDA: [Row; 7] = [
    row(0.333, 0.0, 0.0, 0.0),
    row(0.0, 0.0, 0.0, -90.0),
    row(0.316, 0.0, 0.0, 90.0),
    row(0.0, 0.0, 0.0825, 90.0),
    row(0.384, 0.0, -0.0825, -90.0),
    row(0.0, 0.0, 0.0, 90.0),
    row(0.0, 0.0, 0.088, 90.0),
];
const PANDA_FLANGE: f64 = 0.107;

/// Lower, upper [rad], velocity [rad/s], acceleration [rad/s²], effort [Nm], as published.
const PANDA_LIMITS: [[f64; 5]; 7] = [
    [-2.8973, 2.8973, 2.175, 15.0, 87.0],
    [-1.7628, 1.7628, 2.175, 7.5, 87.0],
    [-2.8973, 2.8973, 2.175, 10.0, 87.0],
    [-3.0718, -0.0698, 2.175, 12.5, 87.0],
    [-2.8973, 2.8973, 2.61, 15.0, 12.0],
    [-0.0175, 3.7525, 2.61, 20.0, 12.0],
    [-2.8973, 2.8973, 2.61, 20.0, 12.0],
];

/// Mass, assumed from the arm's total of about 18 kg, and capsule by link, the base first.
const PANDA_LINKS: [(f64, Capsule); 8] = [
    (2.9, capsule([-0.06, 0.0, 0.06], [0.0, 0.0, 0.06], 0.09)),
    (2.7, capsule([0.0, 0.0, -0.19], [0.0, 0.0, -0.04], 0.08)),
    (2.7, capsule([0.0, -0.12, 0.0], [0.0, 0.0, 0.0], 0.08)),
    (2.4, capsule([0.0, 0.0, -0.12], [0.08, 0.0, 0.0], 0.07)),
    (2.4, capsule([-0.08, 0.09, 0.0], [0.0, 0.0, 0.0], 0.07)),
    (2.6, capsule([0.0, 0.04, -0.22], [0.0, 0.04, 0.0], 0.065)),
    (1.6, capsule([0.0, 0.0, 0.0], [0.085, 0.0, 0.0], 0.06)),
    (0.7, capsule([0.0, 0.0, 0.03], [0.0, 0.0, 0.08], 0.05)),
];

/// Standard Denavit–Hartenberg table of a Universal Robots UR5.
const UR5: [Row; 6] = [
    row(0.089159, 0.0, 0.0, 90.0),
    row(0.0, 0.0, -0.425, 0.0),
    row(0.0, 0.0, -0.39225, 0.0),
    row(0.10915, 0.0, 0.0, 90.0),
    row(0.09465, 0.0, 0.0, -90.0),
    row(0.0823, 0.0, 0.0, 0.0),
];

/// Efforts as published [Nm].
const UR5_EFFORT: [f64; 6] = [150.0, 150.0, 150.0, 28.0, 28.0, 28.0];
/// Assumed [rad/s²].
const UR5_ACCELERATION: f64 = 10.0;

/// Mass as published [kg; the base's is 4.0] and capsule by link, the base first. Link i turns about
/// z at the origin of frame i − 1.
const UR5_LINKS: [(f64, Capsule); 7] = [
    (4.0, capsule([0.0, 0.0, 0.03], [0.0, 0.0, 0.06], 0.075)),
    (3.7, capsule([0.0, 0.0, 0.05], [0.0, -0.06, 0.089], 0.065)),
    (8.393, capsule([0.0, 0.0, 0.13], [-0.425, 0.0, 0.13], 0.06)),
    (
        2.275,
        capsule([0.0, 0.0, 0.015], [-0.39225, 0.0, 0.015], 0.05),
    ),
    (1.219, capsule([0.0, 0.0, 0.05], [0.0, 0.0, 0.109], 0.045)),
    (1.219, capsule([0.0, 0.0, 0.04], [0.0, 0.0, 0.0946], 0.045)),
    (0.1879, capsule([0.0, 0.0, 0.045], [0.0, 0.0, 0.06], 0.045)),
];

fn arm(urdf: &mut Writer, name: &str, mass: f64, capsule: &Capsule) {
    let middle = |i: usize| (capsule.from[i] + capsule.to[i]) / 2.0 + 0.0;
    urdf.link(&Link {
        name,
        body: Some(Body {
            mass,
            center: [middle(0), middle(1), middle(2)],
            inertia: capsule.inertia(mass),
        }),
        capsules: std::slice::from_ref(capsule),
    });
}

fn tcp(urdf: &mut Writer, parent: &str, parent_from_tcp: &Origin) {
    urdf.link(&Link {
        name: "tcp",
        body: None,
        capsules: &[],
    });
    urdf.joint("flange", [parent, "tcp"], parent_from_tcp, &Motion::Fixed);
}

/// An arm of seven joints with the kinematics of a Franka Emika Panda.
pub fn arm7() -> String {
    let mut urdf = Writer::new(
        "arm7",
        "An arm of seven joints with the published kinematics and limits of a Franka Emika Panda.\n\
         Ours: capsules, masses, and the inertias of the capsules.",
    );
    let (mass, capsule) = &PANDA_LINKS[0];
    arm(&mut urdf, "link_0", *mass, capsule);
    for (i, (mass, capsule)) in PANDA_LINKS.iter().enumerate().skip(1) {
        let (parent, child) = (format!("link_{}", i - 1), format!("link_{i}"));
        arm(&mut urdf, &child, *mass, capsule);
        let origin = Origin::craig(&PANDA[i - 1]);
        let motion = revolute(PANDA_LIMITS[i - 1]);
        urdf.joint(&format!("joint_{i}"), [&parent, &child], &origin, &motion);
    }
    tcp(&mut urdf, "link_7", &Origin::at(0.0, 0.0, PANDA_FLANGE));
    urdf.finish()
}

/// An arm of six joints with the kinematics of a Universal Robots UR5.
pub fn arm6() -> String {
    let mut urdf = Writer::new(
        "arm6",
        "An arm of six joints with the published kinematics, limits and masses of a Universal Robots UR5.\n\
         Ours: capsules, their inertias, and acceleration limits.",
    );
    let (mass, capsule) = &UR5_LINKS[0];
    arm(&mut urdf, "link_0", *mass, capsule);
    let mut origin = Origin::IDENTITY;
    for (i, (mass, capsule)) in UR5_LINKS.iter().enumerate().skip(1) {
        let (parent, child) = (format!("link_{}", i - 1), format!("link_{i}"));
        arm(&mut urdf, &child, *mass, capsule);
        let effort = UR5_EFFORT[i - 1];
        let motion = revolute([-TAU, TAU, PI, UR5_ACCELERATION, effort]);
        urdf.joint(&format!("joint_{i}"), [&parent, &child], &origin, &motion);
        origin = Origin::after_joint(&UR5[i - 1]);
    }
    tcp(&mut urdf, "link_6", &origin);
    urdf.finish()
}
