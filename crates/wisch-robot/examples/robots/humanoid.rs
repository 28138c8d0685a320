//! The mobile humanoid of the paper (Rollin' Justin): published Denavit–Hartenberg tables, limits,
//! masses and centres of mass. Assumed, because nothing that could be checked is published: effort
//! limits, inertias (of solid capsules), the shapes of links that have no capsule, and bodies of
//! hands and head.

use super::urdf::{Body, Capsule, Link, Motion, Origin, Row, Writer, capsule, revolute_deg, row};

/// Joint velocity and acceleration limits of the paper's evaluation [rad/s, rad/s²].
const JOINT_RATES: [f64; 2] = [1.0, 10.0];
/// The base's [m/s, m/s²], and for yaw [rad/s, rad/s²].
const BASE_RATES: [f64; 2] = [0.5, 1.0];
/// How far the base may go from where the world's frame is [m].
const BASE_REACH: f64 = 100.0;
/// The base plate above the floor [m].
const PLATE_HEIGHT: f64 = 0.1;

const TORSO: [Row; 4] = [
    row(0.1055, 0.0, 0.0, 0.0),
    row(0.0, -90.0, 0.0, -90.0),
    row(0.0, 0.0, 0.3, 0.0),
    row(0.0, 0.0, 0.3, 0.0),
];

const RIGHT_ARM: [Row; 7] = [
    row(0.0, 0.0, 0.0, 0.0),
    row(0.0, 0.0, 0.0, 90.0),
    row(0.4, -90.0, 0.0, -90.0),
    row(0.0, 0.0, 0.0, 90.0),
    row(0.39, -180.0, 0.0, -90.0),
    row(0.0, 90.0, 0.0, 90.0),
    row(0.0, -90.0, 0.0, 90.0),
];

const LEFT_ARM: [Row; 7] = [
    row(0.0, 0.0, 0.0, 180.0),
    row(0.0, 0.0, 0.0, 90.0),
    row(-0.4, -90.0, 0.0, -90.0),
    row(0.0, 0.0, 0.0, 90.0),
    row(-0.39, 0.0, 0.0, -90.0),
    row(0.0, 90.0, 0.0, -90.0),
    row(0.0, -90.0, 0.0, -90.0),
];

const HEAD: [Row; 2] = [row(0.0, 0.0, 0.0, 0.0), row(0.0, 0.0, 0.0, -90.0)];

/// Lower and upper [deg], effort assumed [Nm]: Rollin' Justin's, not its successor's (±120, ±90, 0 to 135). The
/// fourth is passive: its limits are those of the coupling, 0 <= q2 + q3 <= 135 degrees.
const TORSO_LIMITS: [[f64; 3]; 4] = [
    [-100.0, 190.0, 400.0],
    [-70.0, 30.0, 800.0],
    [10.0, 134.0, 800.0],
    [-135.0, 0.0, 400.0],
];

const ARM_LIMITS: [[f64; 3]; 7] = [
    [-170.0, 170.0, 150.0],
    [-120.0, 120.0, 150.0],
    [-170.0, 170.0, 100.0],
    [-120.0, 120.0, 100.0],
    [-170.0, 170.0, 40.0],
    [-45.0, 80.0, 40.0],
    [-45.0, 135.0, 40.0],
];

const HEAD_LIMITS: [[f64; 3]; 2] = [[-45.0, 45.0, 20.0], [-25.0, 45.0, 20.0]];

/// Mass [kg] and centre of mass [mm, link frame].
const TORSO_BODIES: [(f64, [f64; 3]); 4] = [
    (4.651, [1.3, 15.4, 7.4]),
    (5.470, [218.6, -13.0, 6.2]),
    (2.925, [153.2, -22.7, 1.9]),
    (5.759, [53.7, 74.6, 0.7]),
];

/// Of the right arm; the left one's are its mirror image.
const ARM_BODIES: [(f64, [f64; 3]); 7] = [
    (2.637, [-0.4, 20.3, -45.9]),
    (2.326, [0.0, 114.1, 16.4]),
    (2.239, [0.0, 16.5, -113.3]),
    (2.204, [0.0, 113.7, 16.4]),
    (1.101, [0.1, 21.9, -105.6]),
    (1.641, [0.5, -7.8, -8.7]),
    (0.675, [29.1, 78.1, 19.6]),
];

const BASE_MASS: f64 = 145.0;
const HAND_MASS: f64 = 2.0;
const HEAD_MASS: f64 = 3.0;

/// In the frame of the torso's foot, which does not turn.
const BASE_CAPSULES: [Capsule; 6] = [
    capsule([-0.1, 0.0, -0.4], [0.1, 0.0, -0.4], 0.30),
    capsule([-0.1, 0.0, -0.2], [0.1, 0.0, -0.2], 0.30),
    capsule([0.3, 0.3, -0.4], [0.3, 0.3, -0.4], 0.14),
    capsule([0.3, -0.3, -0.4], [0.3, -0.3, -0.4], 0.14),
    capsule([-0.3, 0.3, -0.4], [-0.3, 0.3, -0.4], 0.14),
    capsule([-0.3, -0.3, -0.4], [-0.3, -0.3, -0.4], 0.14),
];
const SPINE: Capsule = capsule([0.0; 3], [0.3, 0.0, 0.0], 0.14);
const CHEST: [Capsule; 2] = [
    capsule([0.0, 0.05, -0.05], [0.0, 0.05, 0.05], 0.14),
    capsule([0.1, 0.1, -0.1], [0.1, 0.1, 0.1], 0.14),
];
const HAND: Capsule = capsule([0.0, 0.0, 0.08], [0.0, 0.0, 0.2], 0.12);
const SKULL: Capsule = capsule([0.03, -0.1, 0.0], [0.03, -0.15, 0.0], 0.15);
/// Assumed for the inertia of links without a capsule: balls of these radii [m].
const SHOULDER_RADIUS: f64 = 0.14;
const ELBOW_RADIUS: f64 = 0.12;
const WRIST_RADIUS: f64 = 0.06;

/// cos 30°, of the shoulders' inclination.
const C: f64 = 0.866_025_403_784_438_6;

const fn ball(radius: f64) -> Capsule {
    capsule([0.0; 3], [0.0; 3], radius)
}

fn body((mass, center_mm): (f64, [f64; 3]), shape: &Capsule) -> Option<Body> {
    Some(Body {
        mass,
        center: center_mm.map(|value| value / 1000.0 + 0.0),
        inertia: shape.inertia(mass),
    })
}

/// A body whose centre of mass is the middle of its capsule.
fn centered(mass: f64, shape: &Capsule) -> Option<Body> {
    let middle = |i: usize| 500.0 * (shape.from[i] + shape.to[i]);
    body((mass, [middle(0), middle(1), middle(2)]), shape)
}

fn turning([lower, upper, effort]: [f64; 3]) -> Motion {
    let [velocity, acceleration] = JOINT_RATES;
    revolute_deg(lower, upper, velocity, acceleration, effort)
}

/// The whole URDF.
pub fn humanoid() -> String {
    let mut urdf = Writer::new(
        "humanoid",
        "The mobile humanoid of the paper (Rollin' Justin): published kinematics, limits, masses and centres\n\
         of mass; capsules instead of meshes. Assumed: effort limits (150 Nm at the first joints of the\n\
         arms), inertias (solid capsules), bodies of hands and head.\n\
         Limits of torso and head are Rollin' Justin's. In doubt: its successor's are printed as torso_1 -120\n\
         to 120, torso_2 -90 to 90, torso_3 0 to 135 degrees, but postures measured on one reach torso_1 -131\n\
         to 199, so that what is printed need not be what the drives allow; and the coupling of torso_2 and\n\
         torso_3, 0 to 135 degrees, is published without saying of which of the two.",
    );
    base(&mut urdf);
    torso(&mut urdf);
    let right = Origin::from_rows(
        [[-C, 0.0, 0.5], [0.0, 1.0, 0.0], [-0.5, 0.0, -C]],
        [0.190, 0.088, -0.256],
    );
    let left = Origin::from_rows(
        [[C, 0.0, 0.5], [0.0, 1.0, 0.0], [-0.5, 0.0, C]],
        [0.190, 0.088, 0.256],
    );
    arm(&mut urdf, "right", &right, &RIGHT_ARM);
    arm(&mut urdf, "left", &left, &LEFT_ARM);
    head(&mut urdf);
    urdf.raw(
        "  <!-- Rods keep the chest upright. The limits of torso_4 hold for the sum, which couples torso_2\n       and torso_3. Readers that skip <wisch> see torso_4 as a joint of its own. -->\n  <wisch>\n    <mimic joint=\"torso_4\" offset=\"0\">\n      <term joint=\"torso_2\" multiplier=\"-1\"/>\n      <term joint=\"torso_3\" multiplier=\"-1\"/>\n    </mimic>\n  </wisch>\n",
    );
    urdf.finish()
}

/// A base that goes anywhere on the floor: x, y, yaw.
fn base(urdf: &mut Writer) {
    let slide = |axis| Motion::Limited {
        kind: "prismatic",
        axis,
        // Effort assumed [N].
        limits: [-BASE_REACH, BASE_REACH, BASE_RATES[0], BASE_RATES[1], 500.0],
    };
    // Effort assumed [Nm].
    let yaw = Motion::Continuous {
        limits: [BASE_RATES[0], BASE_RATES[1], 300.0],
    };
    for name in ["world", "base_x_link", "base_y_link"] {
        urdf.link(&Link {
            name,
            body: None,
            capsules: &[],
        });
    }
    urdf.link(&Link {
        name: "platform",
        body: None,
        capsules: &[],
    });
    urdf.link(&Link {
        name: "torso_foot",
        body: centered(BASE_MASS, &BASE_CAPSULES[0]),
        capsules: &BASE_CAPSULES,
    });
    let lifted = Origin::at(0.0, 0.0, PLATE_HEIGHT);
    urdf.joint(
        "base_x",
        ["world", "base_x_link"],
        &lifted,
        &slide([1.0, 0.0, 0.0]),
    );
    let same = Origin::IDENTITY;
    urdf.joint(
        "base_y",
        ["base_x_link", "base_y_link"],
        &same,
        &slide([0.0, 1.0, 0.0]),
    );
    urdf.joint("base_yaw", ["base_y_link", "platform"], &same, &yaw);
    let foot = Origin::at(0.0, 0.0, 0.5884);
    urdf.joint(
        "platform_torso",
        ["platform", "torso_foot"],
        &foot,
        &Motion::Fixed,
    );
}

fn torso(urdf: &mut Writer) {
    let shoulder = ball(SHOULDER_RADIUS);
    let shapes: [(&Capsule, &[Capsule]); 4] = [
        (&shoulder, &[]),
        (&SPINE, &[SPINE]),
        (&SPINE, &[SPINE]),
        (&CHEST[1], &CHEST),
    ];
    let mut parent = "torso_foot".to_owned();
    for (i, (solid, capsules)) in shapes.into_iter().enumerate() {
        let name = format!("torso_{}", i + 1);
        let child = format!("{name}_link");
        urdf.link(&Link {
            name: &child,
            body: body(TORSO_BODIES[i], solid),
            capsules,
        });
        urdf.joint(
            &name,
            [&parent, &child],
            &Origin::craig(&TORSO[i]),
            &turning(TORSO_LIMITS[i]),
        );
        parent = child;
    }
}

fn arm(urdf: &mut Writer, side: &str, chest_from_arm: &Origin, table: &[Row; 7]) {
    let is_left = side == "left";
    let mut parent = format!("{side}_arm_base");
    urdf.link(&Link {
        name: &parent,
        body: None,
        capsules: &[],
    });
    let attachment = format!("{side}_arm_attachment");
    urdf.joint(
        &attachment,
        ["torso_4_link", &parent],
        chest_from_arm,
        &Motion::Fixed,
    );
    let sign = if is_left { -1.0 } else { 1.0 };
    let segment = capsule([0.0, sign * 0.01, 0.0], [0.0, sign * 0.36, 0.0], 0.12);
    for i in 0..7 {
        let name = format!("{side}_arm_{}", i + 1);
        let child = format!("{name}_link");
        let (solid, capsules): (Capsule, &[Capsule]) = match i {
            1 | 3 => (segment, std::slice::from_ref(&segment)),
            0 | 2 => (ball(ELBOW_RADIUS), &[]),
            _ => (ball(WRIST_RADIUS), &[]),
        };
        let (mass, [x, y, z]) = ARM_BODIES[i];
        // The left arm's frames are the right one's mirrored and inverted, from the fifth on also
        // turned by half a turn about z.
        let center = match (is_left, i) {
            (false, _) => [x, y, z],
            (true, 0..4) => [-x, -y, -z],
            (true, _) => [x, y, -z],
        };
        urdf.link(&Link {
            name: &child,
            body: body((mass, center), &solid),
            capsules,
        });
        urdf.joint(
            &name,
            [&parent, &child],
            &Origin::craig(&table[i]),
            &turning(ARM_LIMITS[i]),
        );
        parent = child;
    }
    let tcp = format!("{side}_tcp");
    urdf.link(&Link {
        name: &tcp,
        body: centered(HAND_MASS, &HAND),
        capsules: &[HAND],
    });
    let wrist_from_tcp = Origin::from_rows(
        [[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]],
        [0.0, 0.118, 0.0],
    );
    urdf.joint(
        &format!("{side}_hand"),
        [&parent, &tcp],
        &wrist_from_tcp,
        &Motion::Fixed,
    );
}

fn head(urdf: &mut Writer) {
    let chest_from_neck = Origin::from_rows(
        [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        [0.235, 0.088, 0.0],
    );
    urdf.link(&Link {
        name: "neck",
        body: None,
        capsules: &[],
    });
    urdf.joint(
        "head_attachment",
        ["torso_4_link", "neck"],
        &chest_from_neck,
        &Motion::Fixed,
    );
    urdf.link(&Link {
        name: "head_1_link",
        body: None,
        capsules: &[],
    });
    urdf.joint(
        "head_1",
        ["neck", "head_1_link"],
        &Origin::craig(&HEAD[0]),
        &turning(HEAD_LIMITS[0]),
    );
    urdf.link(&Link {
        name: "head_2_link",
        body: centered(HEAD_MASS, &SKULL),
        capsules: &[SKULL],
    });
    urdf.joint(
        "head_2",
        ["head_1_link", "head_2_link"],
        &Origin::craig(&HEAD[1]),
        &turning(HEAD_LIMITS[1]),
    );
}
