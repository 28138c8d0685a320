"""Opens a bag of wisch with two independent libraries, and compares what they read.

    cargo run --release --workspace --example demo_bag -- /tmp/demo.mcap
    python peers/bag.py /tmp/demo.mcap

With --write FILE it writes a small bag as another robot's recorder would (Zstandard, other topics, a stamp
that is not the time of recording); crates/wisch-telemetry/tests/data/foreign.mcap is that file.

It also reads the bag of a program that was killed (NAME.mcap.active) from the beginning, because such a bag has no index.
"""

import math
import sys
from collections import defaultdict
from pathlib import Path
from xml.etree import ElementTree

from mcap.exceptions import EndOfFile
from mcap.reader import NonSeekingReader, make_reader
from mcap_ros2.decoder import DecoderFactory
from mcap_ros2.writer import Writer
from rosbags.highlevel import AnyReader
from rosbags.typesys import Stores, get_typestore

EXPECTED_TYPES = {
    "/joint_states": "sensor_msgs/msg/JointState",
    "/tcp/commanded": "geometry_msgs/msg/PoseStamped",
    "/tcp/measured": "geometry_msgs/msg/PoseStamped",
    "/wrench/controller": "geometry_msgs/msg/WrenchStamped",
    "/wrench/external": "geometry_msgs/msg/WrenchStamped",
    "/tf": "tf2_msgs/msg/TFMessage",
    "/particles": "visualization_msgs/msg/Marker",
    "/phase": "std_msgs/msg/String",
    "/robot_description": "std_msgs/msg/String",
    "/tf_static": "tf2_msgs/msg/TFMessage",
    "/scene": "visualization_msgs/msg/MarkerArray",
    "/plan/strokes": "visualization_msgs/msg/MarkerArray",
    "/tool": "visualization_msgs/msg/Marker",
    "/force": "visualization_msgs/msg/Marker",
    "/wisch/dirt_before": "sensor_msgs/msg/PointCloud2",
    "/wisch/dirt_after": "sensor_msgs/msg/PointCloud2",
    "/wisch/hidden_before": "geometry_msgs/msg/PolygonStamped",
    "/wisch/hidden_after": "geometry_msgs/msg/PolygonStamped",
}
# Topics of which each sample has one message.
EVERY_SAMPLE = [topic for topic in EXPECTED_TYPES if topic.split("/")[1] in ("joint_states", "tcp", "wrench")]
TF_PERIOD_NS = 20_000_000
# Topics that a bag with the scene has once, at its start.
ONCE = ["/robot_description", "/tf_static", "/scene", "/plan/strokes", "/tool"]
SHOW_PERIOD_NS = 40_000_000
# visualization_msgs/Marker: how many points there may be, by type.
MARKER_POINTS = {0: lambda n: n == 2, 4: lambda n: n >= 2, 8: lambda n: n >= 1, 11: lambda n: n >= 3 and n % 3 == 0}
MARKER_DELETE = 2
FORCE_M_PER_N = 0.01


def plain(message):
    """A message as nested lists of plain values, the same for both libraries."""
    if isinstance(message, (str, bool, int, float)):
        return message
    if isinstance(message, (bytes, bytearray)):
        return list(message)
    if hasattr(message, "tolist"):
        return message.tolist()
    if isinstance(message, (list, tuple)):
        return [plain(value) for value in message]
    fields = getattr(message, "__slots__", None) or list(vars(message))
    # One of them also lists the constants, which are in capitals.
    names = [name for name in fields if not name.startswith("__") and not name.isupper()]
    return [plain(getattr(message, name)) for name in names]


def with_mcap(path, seeking):
    messages = defaultdict(list)
    with open(path, "rb") as stream:
        factories = [DecoderFactory()]
        reader = (
            make_reader(stream, decoder_factories=factories)
            if seeking
            else NonSeekingReader(stream, decoder_factories=factories)
        )
        try:
            for schema, channel, raw, message in reader.iter_decoded_messages(log_time_order=seeking):
                assert schema.name == EXPECTED_TYPES[channel.topic], (channel.topic, schema.name)
                messages[channel.topic].append((raw.log_time, message))
        except EndOfFile:
            assert not seeking, "a finished bag ends too early"
            print("  the bag ends without a footer, as that of a killed program does")
    return messages


def with_rosbags(path):
    messages = defaultdict(list)
    with AnyReader([Path(path)]) as reader:
        for connection, time, raw in reader.messages():
            messages[connection.topic].append((time, reader.deserialize(raw, connection.msgtype)))
    return messages


def check(messages):
    assert set(messages) <= set(EXPECTED_TYPES), set(messages)
    samples = len(messages["/joint_states"])
    for topic in EVERY_SAMPLE:
        assert len(messages[topic]) == samples, (topic, len(messages[topic]), samples)
    for topic, entries in messages.items():
        times = [time for time, _ in entries]
        assert times == sorted(times), f"{topic} goes back in time"
    for time, message in messages["/tcp/measured"]:
        stamp = message.header.stamp
        assert stamp.sec * 10**9 + stamp.nanosec == time
        assert message.header.frame_id == "world"
        q = message.pose.orientation
        assert math.isclose(math.hypot(q.x, q.y, q.z, q.w), 1.0, abs_tol=1e-9)
    poses = {time: message.pose for time, message in messages["/tcp/measured"]}
    previous = None
    links = []
    for time, message in messages["/tf"]:
        frames = [(t.header.frame_id, t.child_frame_id) for t in message.transforms]
        if ("world", "tool") not in frames:
            links.append((time, frames))
            continue
        assert frames == [("world", "tool"), ("world", "surface")], frames
        translation = message.transforms[0].transform.translation
        position = poses[time].position
        assert [translation.x, translation.y, translation.z] == [position.x, position.y, position.z]
        assert previous is None or time - previous >= TF_PERIOD_NS
        previous = time
    if "/scene" in messages:
        check_shown(messages, links)
    names = {tuple(message.name) for _, message in messages["/joint_states"]}
    assert len(names) == 1
    phases = [message.data for _, message in messages["/phase"]]
    assert all(a != b for a, b in zip(phases, phases[1:])), "a phase is reported twice"
    for _, marker in messages["/particles"]:
        assert marker.type == 8 and marker.header.frame_id == "world"
    pressed = max(abs(m.wrench.force.z) for _, m in messages["/wrench/external"])
    print(f"  {samples} samples, {sum(map(len, messages.values()))} messages, joints {names.pop()}")
    print(f"  phases {phases}, largest force along z {pressed:.2f} N")


def check_shown(messages, links):
    """What a bag shows beside what is measured."""
    for topic in ONCE:
        assert len(messages[topic]) == 1, (topic, len(messages[topic]))
    robot = ElementTree.fromstring(messages["/robot_description"][0][1].data)
    described = {(j.find("parent").get("link"), j.find("child").get("link")) for j in robot.iter("joint") if j.get("type")}
    standing = [(t.header.frame_id, t.child_frame_id) for t in messages["/tf_static"][0][1].transforms]
    moving = links[0][1]
    assert all(frames == moving for _, frames in links), "the moving links change"
    assert all(b - a >= SHOW_PERIOD_NS for (a, _), (b, _) in zip(links, links[1:]))
    named_pairs = [*standing, *moving]
    assert len({child for _, child in named_pairs}) == len(named_pairs), "a frame has two parents"
    named = {link.get("name") for link in robot.iter("link")} - {"world", "tool", "surface"}
    assert named <= {name for pair in named_pairs for name in pair}, named
    extra = {pair for pair in named_pairs if pair not in described}
    assert all("world" in pair or any(name.startswith("robot/") for name in pair) for pair in extra), extra
    markers = [marker for topic in ("/scene", "/plan/strokes") for marker in messages[topic][0][1].markers]
    names = [(marker.ns, marker.id) for marker in markers]
    assert len(set(names)) == len(names), names
    drawn = 0
    for _, marker in [*((0, m) for m in markers), *messages["/tool"], *messages["/force"], *messages["/particles"]]:
        if marker.action != MARKER_DELETE:
            # A scene may have no particle left.
            assert marker.ns == "particles" or MARKER_POINTS[marker.type](len(marker.points)), (marker.ns, marker.type)
            drawn += 1
    wrenches = {time: message.wrench.force for time, message in messages["/wrench/external"]}
    poses = {time: message.pose.position for time, message in messages["/tcp/measured"]}
    for time, arrow in messages["/force"]:
        if arrow.action == MARKER_DELETE:
            continue
        start, end = arrow.points
        for axis in "xyz":
            at = getattr(poses[time], axis)
            to = at + FORCE_M_PER_N * getattr(wrenches[time], axis)
            assert getattr(start, axis) == at and math.isclose(getattr(end, axis), to, abs_tol=1e-12)
    print(f"  {len(named_pairs)} frames of links, of which {len(moving)} move, and {drawn} markers")


def write_foreign(path):
    """Flange poses at 10 Hz and forces at 100 Hz for 2 s, and an image that has nothing to do with them."""
    types = get_typestore(Stores.ROS2_HUMBLE)
    names = ["geometry_msgs/msg/PoseStamped", "geometry_msgs/msg/WrenchStamped", "sensor_msgs/msg/Image"]
    with open(path, "wb") as stream:
        writer = Writer(stream, chunk_size=4096)
        pose, wrench, image = (
            writer.register_msgdef(name, types.generate_msgdef(name, ros_version=2)[0]) for name in names
        )
        for tick in range(201):
            log_ns = 1_700_000_000 * 10**9 + tick * 10_000_000
            stamp_ns = log_ns - 5_000_000
            header = {"stamp": {"sec": stamp_ns // 10**9, "nanosec": stamp_ns % 10**9}, "frame_id": "base"}

            def put(topic, schema, message):
                writer.write_message(topic, schema, {"header": header, **message}, log_ns, log_ns)

            x = tick * 0.001
            if tick % 10 == 0:
                position = {"x": x, "y": 0.0, "z": 0.5}
                orientation = {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}
                put("/arm/flange", pose, {"pose": {"position": position, "orientation": orientation}})
            force = {"x": 0.0, "y": x, "z": 5.0}
            put("/arm/ft", wrench, {"wrench": {"force": force, "torque": {"x": 0.0, "y": 0.0, "z": 0.0}}})
            if tick == 100:
                pixels = {"height": 2, "width": 3, "encoding": "mono8", "is_bigendian": 0, "step": 3}
                put("/camera", image, {**pixels, "data": [1, 2, 3, 4, 5, 6]})
        writer.finish()


def main():
    if sys.argv[1] == "--write":
        return write_foreign(sys.argv[2])
    path = sys.argv[1]
    active = path.endswith(".active")
    print(f"mcap {'without' if active else 'with'} an index")
    first = with_mcap(path, seeking=not active)
    check(first)
    if active:
        return
    print("rosbags")
    second = with_rosbags(path)
    check(second)
    compared = 0
    for topic, entries in first.items():
        assert len(entries) == len(second[topic]), topic
        for (time_a, a), (time_b, b) in zip(entries, second[topic]):
            assert time_a == time_b and plain(a) == plain(b), (topic, time_a, plain(a), plain(b))
            compared += 1
    print(f"both libraries read the same in {compared} messages")


if __name__ == "__main__":
    main()
