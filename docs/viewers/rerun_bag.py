"""Opens a bag of wisch in Rerun: the robot and the scene in 3D, force and height over time, the phase.

    python docs/viewers/rerun_bag.py out/chopping-board/telemetry/round-1.mcap
    python docs/viewers/rerun_bag.py round-1.mcap --save round-1.rrd

Rerun itself reads most of a bag: the URDF of /robot_description, frames, joints, poses, point clouds. It shows markers and
wrenches as text only; this script converts them. Times are seconds since the start of the round.
"""

import argparse
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import rerun as rr
import rerun.blueprint as rrb
from mcap.exceptions import EndOfFile
from mcap.reader import NonSeekingReader
from mcap_ros2.decoder import DecoderFactory
from rerun.chunk import McapReader

# Rerun's name for the time at which a message was logged.
TIMELINE = "message_log_time"
# Topics whose messages hold markers, which are converted.
MARKER_TOPICS = ("/scene", "/plan/strokes", "/tool", "/particles", "/force")
WRENCHES = {"/wrench/external": "measured", "/wrench/controller": "controller"}
POSES = {"/tcp/measured": "measured", "/tcp/commanded": "commanded"}
# visualization_msgs/Marker, type and action.
ARROW, LINE_STRIP, POINTS, TRIANGLE_LIST = 0, 4, 8, 11
DELETE = 2


def messages(path, topics):
    """Returns the messages of topics in the order of the file; of the bag of a killed program, up to its end."""
    with open(path, "rb") as stream:
        reader = NonSeekingReader(stream, decoder_factories=[DecoderFactory()])
        try:
            for _, channel, raw, message in reader.iter_decoded_messages(topics=topics, log_time_order=False):
                yield channel.topic, raw.log_time, message
        except EndOfFile:
            return


def xyz(vector):
    return [vector.x, vector.y, vector.z]


def rotation(q):
    """Returns the rotation matrix of a quaternion."""
    x, y, z, w = q.x, q.y, q.z, q.w
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ])


def points_in_frame(marker):
    """Returns a marker's points in the frame of its header [m]."""
    points = np.array([xyz(point) for point in marker.points]).reshape(-1, 3)
    return points @ rotation(marker.pose.orientation).T + xyz(marker.pose.position)


def archetype(marker):
    """Returns the shape that Rerun draws for a marker."""
    color = marker.color
    rgba = [round(255 * share) for share in (color.r, color.g, color.b, color.a)]
    points = points_in_frame(marker)
    if marker.type == TRIANGLE_LIST:
        corners = points.reshape(-1, 3, 3)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
        return rr.Mesh3D(
            vertex_positions=points,
            triangle_indices=np.arange(len(points)).reshape(-1, 3),
            vertex_normals=np.repeat(normals, 3, axis=0),
            albedo_factor=rgba,
        )
    if marker.type == LINE_STRIP:
        return rr.LineStrips3D([points], radii=marker.scale.x / 2, colors=[rgba])
    if marker.type == POINTS:
        return rr.Points3D(points, radii=marker.scale.x / 2, colors=[rgba])
    if marker.type == ARROW:
        return rr.Arrows3D(origins=points[:1], vectors=points[1:] - points[:1], radii=marker.scale.x / 2, colors=[rgba])
    raise ValueError(f"markers of type {marker.type} are not drawn")


def log_markers(path, recording):
    frames = {}
    for topic, time, message in messages(path, MARKER_TOPICS):
        recording.set_time(TIMELINE, duration=np.timedelta64(time, "ns"))
        many = hasattr(message, "markers")
        for marker in message.markers if many else [message]:
            entity = f"{topic}/{marker.ns}/{marker.id}" if many else topic
            if marker.action == DELETE:
                recording.log(entity, rr.Clear(recursive=False))
                # The entity keeps its frame: Rerun reports an entity without one as an error.
                if entity in frames:
                    recording.log(entity, rr.CoordinateFrame(frames[entity]))
                continue
            if entity not in frames:
                frames[entity] = marker.header.frame_id
                recording.log(entity, rr.CoordinateFrame(frames[entity]))
            recording.log(entity, archetype(marker))


def log_curves(path, recording):
    """Returns the force and the tool's height above the surface, for each sample."""
    times, values = {}, {}
    world_from_surface = None
    for topic, time, message in messages(path, [*WRENCHES, *POSES, "/tf"]):
        if topic == "/tf":
            found = [t.transform for t in message.transforms if t.child_frame_id == "surface"]
            if found and world_from_surface is None:
                world_from_surface = found[0]
            continue
        vector = message.wrench.force if topic in WRENCHES else message.pose.position
        times.setdefault(topic, []).append(time)
        values.setdefault(topic, []).append(xyz(vector))
    curves = {}
    for topic, name in WRENCHES.items():
        for axis, label in enumerate("xyz"):
            curves[f"/curves/force_n/{name}_{label}"] = topic, np.array(values[topic])[:, axis]
    origin = np.array(xyz(world_from_surface.translation))
    normal = rotation(world_from_surface.rotation)[:, 2]
    for topic, name in POSES.items():
        curves[f"/curves/height_mm/{name}"] = topic, 1e3 * (np.array(values[topic]) - origin) @ normal
    for entity, (topic, curve) in curves.items():
        stamps = np.array(times[topic]).astype("timedelta64[ns]")
        index = rr.TimeColumn(TIMELINE, duration=stamps)
        rr.send_columns(entity, [index], rr.Scalars.columns(scalars=curve), recording=recording)


def shapes_of_robot(path):
    """Returns the entities of the robot's shapes, and whether they are shown: collision shapes only without visual ones."""
    for _, _, message in messages(path, ["/robot_description"]):
        robot = ElementTree.fromstring(message.data)
        kind = "visual" if robot.find("link/visual") is not None else "collision"
        return {f"/{robot.get('name')}/{other}_geometries": other == kind for other in ("visual", "collision")}
    return {}


def make_solid(path, recording):
    """Makes the robot's boxes, cylinders and spheres solid; Rerun draws them translucent."""
    solid = {"box": rr.Boxes3D, "cylinder": rr.Cylinders3D, "sphere": rr.Ellipsoids3D}
    for _, _, message in messages(path, ["/robot_description"]):
        robot = ElementTree.fromstring(message.data)
        for link in robot.iter("link"):
            for i, visual in enumerate(link.findall("visual")):
                opacity = visual.find("material/color")
                if opacity is not None and float(opacity.get("rgba").split()[3]) < 1.0:
                    continue
                for kind, shape in solid.items():
                    if visual.find(f"geometry/{kind}") is not None:
                        entity = f"/{robot.get('name')}/visual_geometries/{link.get('name')}/visual_{i}"
                        recording.log(entity, shape.from_fields(fill_mode=rr.components.FillMode.Solid), static=True)


def blueprint(path):
    shapes = {entity: rrb.EntityBehavior(visible=shown) for entity, shown in shapes_of_robot(path).items()}
    return rrb.Blueprint(
        rrb.Horizontal(
            rrb.Spatial3DView(
                name="scene",
                origin="/",
                contents=["+ /**", "- /curves/**", "- /tcp/**"],
                overrides=shapes,
                spatial_information=rrb.SpatialInformation(target_frame="world"),
            ),
            rrb.Vertical(
                rrb.TimeSeriesView(name="force [N]", origin="/curves/force_n"),
                rrb.TimeSeriesView(name="height above the surface [mm]", origin="/curves/height_mm"),
                rrb.TimeSeriesView(name="joints", origin="/joint_states/position"),
                rrb.TextDocumentView(name="phase", origin="/phase"),
                row_shares=[3, 2, 2, 1],
            ),
            column_shares=[3, 2],
        ),
        rrb.TimePanel(timeline=TIMELINE),
    )


def convert(path, recording):
    converted = [f"^{topic}$" for topic in MARKER_TOPICS]
    reader = McapReader(
        path,
        timeline_type="duration_ns",
        exclude_topic_regex=converted,
        recover=Path(path).suffix == ".active",
    )
    rr.send_chunks(reader.stream(), recording=recording)
    make_solid(path, recording)
    log_markers(path, recording)
    log_curves(path, recording)


def main():
    parser = argparse.ArgumentParser(description="Opens a bag of wisch in Rerun.")
    parser.add_argument("bag", help="such as out/NAME/telemetry/round-1.mcap")
    parser.add_argument("--save", metavar="FILE", help="write a recording (.rrd) instead of opening the viewer")
    args = parser.parse_args()
    recording = rr.RecordingStream("wisch")
    if args.save:
        recording.save(args.save, default_blueprint=blueprint(args.bag))
    else:
        recording.spawn(default_blueprint=blueprint(args.bag))
    convert(args.bag, recording)
    recording.flush()


if __name__ == "__main__":
    main()
