//! A writer of bags in the style of other libraries.

use mcap::WriteOptions;
use mcap::records::MessageHeader;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use wisch_telemetry::Log;

/// A bag of another robot, written topic by topic.
pub struct Foreign {
    pub bag: mcap::Writer<std::io::BufWriter<fs::File>>,
}

#[derive(Serialize)]
pub struct Stamped<T> {
    stamp: [u32; 2],
    frame: &'static str,
    data: T,
}

pub const HEADER_PARTS: &str = "===\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n===\n\
                            MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";
pub const POSE_PARTS: &str = "===\nMSG: geometry_msgs/Pose\nPoint position\nQuaternion orientation\n===\n\
                          MSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n===\n\
                          MSG: geometry_msgs/Quaternion\nfloat64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n";
pub const WRENCH_PARTS: &str = "===\nMSG: geometry_msgs/Wrench\nVector3 force\nVector3 torque\n===\n\
                            MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n";

impl Foreign {
    pub fn create(path: &Path) -> Self {
        let file = std::io::BufWriter::new(fs::File::create(path).unwrap());
        let options = WriteOptions::new().profile("ros2").compression(None);
        Self {
            bag: options.create(file).unwrap(),
        }
    }

    pub fn topic(&mut self, name: &str, kind: &str, definition: &str) -> u16 {
        let schema = self
            .bag
            .add_schema(kind, "ros2msg", definition.as_bytes())
            .unwrap();
        self.bag
            .add_channel(schema, name, "cdr", &BTreeMap::new())
            .unwrap()
    }

    pub fn poses(&mut self, name: &str) -> u16 {
        let definition =
            format!("# where it is\nstd_msgs/Header header\nPose pose\n{HEADER_PARTS}{POSE_PARTS}");
        self.topic(name, "geometry_msgs/msg/PoseStamped", &definition)
    }

    pub fn wrenches(&mut self, name: &str) -> u16 {
        let definition =
            format!("std_msgs/Header header\nWrench wrench\n{HEADER_PARTS}{WRENCH_PARTS}");
        self.topic(name, "geometry_msgs/msg/WrenchStamped", &definition)
    }

    /// Writes a message; a stamp of 0 stands for none.
    pub fn put<T: Serialize>(
        &mut self,
        channel: u16,
        time_ms: u64,
        stamp_ms: u64,
        frame: &'static str,
        data: T,
    ) {
        let stamp = [
            (stamp_ms / 1000) as u32,
            (stamp_ms % 1000) as u32 * 1_000_000,
        ];
        let message = Stamped { stamp, frame, data };
        let data = cdr::serialize::<_, _, cdr::CdrLe>(&message, cdr::Infinite).unwrap();
        let log_time = time_ms * 1_000_000;
        let header = MessageHeader {
            channel_id: channel,
            sequence: 0,
            log_time,
            publish_time: log_time,
        };
        self.bag.write_to_known_channel(&header, &data).unwrap();
    }

    pub fn finish(mut self) {
        self.bag.finish().unwrap();
    }
}

/// A rotation by 90° about x: z of the log is y of the tool.
pub const QUARTER: [f64; 4] = [
    std::f64::consts::FRAC_1_SQRT_2,
    0.0,
    0.0,
    std::f64::consts::FRAC_1_SQRT_2,
];

/// A transform: stamp, frame, child frame, position and rotation of the child.
pub type Transform = ([u32; 2], &'static str, &'static str, [f64; 3], [f64; 4]);

pub const UPRIGHT: [f64; 4] = [0.0, 0.0, 0.0, 1.0];

impl Foreign {
    pub fn transforms(&mut self, name: &str) -> u16 {
        let definition = format!(
            "geometry_msgs/TransformStamped[] transforms\n===\nMSG: geometry_msgs/TransformStamped\n\
             std_msgs/Header header\nstring child_frame_id\nTransform transform\n===\n\
             MSG: geometry_msgs/Transform\nVector3 translation\nQuaternion rotation\n===\n\
             MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n===\n\
             MSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n{HEADER_PARTS}"
        );
        self.topic(name, "tf2_msgs/msg/TFMessage", &definition)
    }

    pub fn put_transforms(&mut self, channel: u16, time_ms: u64, transforms: &[Transform]) {
        let data = cdr::serialize::<_, _, cdr::CdrLe>(&transforms.to_vec(), cdr::Infinite).unwrap();
        let log_time = time_ms * 1_000_000;
        let header = MessageHeader {
            channel_id: channel,
            sequence: 0,
            log_time,
            publish_time: log_time,
        };
        self.bag.write_to_known_channel(&header, &data).unwrap();
    }
}

/// Checks samples of a tool that moves at 0.1 m/s along x with a force that grows by 1 N/s, whatever their start.
pub fn assert_ramp(log: &Log, count: usize) {
    assert_eq!(log.samples.len(), count, "{:?}", log.remarks);
    let start = log.samples[0].world_from_tool.translation.x / 0.1;
    for sample in &log.samples {
        let x = sample.world_from_tool.translation.x;
        assert!(
            (x - 0.1 * (sample.time + start)).abs() < 1e-6,
            "{x} at {}",
            sample.time
        );
        assert!(
            (sample.force.z - 10.0 * x).abs() < 1e-6,
            "{} at {x}",
            sample.force.z
        );
    }
}
