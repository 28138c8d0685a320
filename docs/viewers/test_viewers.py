"""Tests what Rerun and Foxglove show of a bag.

    python -m pytest docs/viewers

The bag is that of the example demo_bag, or the one that WISCH_BAG names.
"""

import json
import os
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import rerun_bag
from mcap.reader import make_reader
from rerun.chunk import RrdReader
from rerun.urdf import UrdfTree

HERE = Path(__file__).parent
NS_PER_S = 1e9


@pytest.fixture(scope="session")
def bag(tmp_path_factory):
    if given := os.environ.get("WISCH_BAG"):
        return Path(given)
    path = tmp_path_factory.mktemp("bag") / "demo.mcap"
    command = ["cargo", "run", "-q", "-p", "wisch-telemetry", "--example", "demo_bag", "--", str(path)]
    subprocess.run(command, cwd=HERE.parents[1], check=True)
    return path


@pytest.fixture(scope="session")
def topics(bag):
    """The messages of each topic with their times; of topics with a message for each sample, the first 100."""
    topics = {}
    for topic, time, message in rerun_bag.messages(bag, None):
        entries = topics.setdefault(topic, [])
        if len(entries) < 100 or topic in ("/tf", "/force", "/particles"):
            entries.append((time, message))
    return topics


@pytest.fixture(scope="session")
def duration_s(bag):
    with open(bag, "rb") as stream:
        statistics = make_reader(stream).get_summary().statistics
    return (statistics.message_end_time - statistics.message_start_time) / NS_PER_S


@pytest.fixture(scope="session")
def saved(bag, tmp_path_factory):
    """The file that the script saves, read back."""
    path = tmp_path_factory.mktemp("rerun") / "bag.rrd"
    subprocess.run([sys.executable, str(HERE / "rerun_bag.py"), str(bag), "--save", str(path)], check=True)
    return RrdReader(path)


@pytest.fixture(scope="session")
def recording(saved):
    return saved.stream().collect()


def rows(recording, entity, column, index=rerun_bag.TIMELINE):
    """Returns times [s] and values of a column, without empty cells."""
    table = recording.reader(index, contents=entity).to_arrow_table()
    name = f"{entity}:{column}"
    assert name in table.column_names, f"{name} is not among {table.column_names}"
    values = table.column(name).to_pylist()
    if index is None:
        return [], [value for value in values if value]
    times = table.column(index).to_numpy().astype("timedelta64[ns]").astype(np.int64) / NS_PER_S
    said = [(time, value) for time, value in zip(times, values) if value]
    return [time for time, _ in said], [value for _, value in said]


def in_frame(marker):
    """Returns a marker's points in the frame of its header, rotated by the quaternion itself and not by a matrix."""
    q = marker.pose.orientation
    axis = np.array([q.x, q.y, q.z])
    points = np.array([[p.x, p.y, p.z] for p in marker.points])
    turned = points + 2 * np.cross(axis, q.w * points + np.cross(axis, points))
    return turned + [marker.pose.position.x, marker.pose.position.y, marker.pose.position.z]


def test_a_marker_that_is_turned_is_drawn_turned():
    def vector(*values):
        return SimpleNamespace(**dict(zip("xyzw", values)))

    q = np.array([0.1, -0.5, 0.3, 0.7])
    pose = SimpleNamespace(position=vector(1.0, 2.0, 3.0), orientation=vector(*(q / np.linalg.norm(q))))
    marker = SimpleNamespace(pose=pose, points=[vector(0.3, 0.0, 0.0), vector(0.0, 0.2, -0.1)])
    assert np.allclose(rerun_bag.points_in_frame(marker), in_frame(marker))


def test_scene_stands_there_from_the_beginning(recording, topics):
    markers = topics["/scene"][0][1].markers
    meshes = [m for m in markers if m.type == rerun_bag.TRIANGLE_LIST]
    assert meshes and {m.ns for m in markers} >= {"surface", "outline"}
    for marker in markers:
        entity = f"/scene/{marker.ns}/{marker.id}"
        column = "Mesh3D:vertex_positions" if marker in meshes else "LineStrips3D:strips"
        times, values = rows(recording, entity, column)
        assert times == [0.0], entity
        drawn = np.array(values[0] if marker in meshes else values[0][0])
        assert np.allclose(drawn, in_frame(marker), atol=1e-6), entity
        assert rows(recording, entity, "CoordinateFrame:frame")[1] == [[marker.header.frame_id]]


def test_strokes_are_lines_and_touches_points(recording, topics):
    strokes = topics["/plan/strokes"][0][1].markers
    assert strokes
    for marker in strokes:
        line = marker.type == rerun_bag.LINE_STRIP
        assert line == (len(marker.points) > 1)
        column = "LineStrips3D:strips" if line else "Points3D:positions"
        assert rows(recording, f"/plan/strokes/{marker.ns}/{marker.id}", column)[0] == [0.0]


def test_tool_moves_with_its_frame_and_particles_are_there(recording, topics):
    assert rows(recording, "/tool", "Mesh3D:vertex_positions")[0] == [0.0]
    assert rows(recording, "/tool", "CoordinateFrame:frame")[1] == [["tool"]]
    times, values = rows(recording, "/particles", "Points3D:positions")
    assert [len(v) for v in values] == [len(m.points) for _, m in topics["/particles"] if m.points]


def test_force_is_an_arrow_over_time(recording, topics, duration_s):
    drawn = [(time / NS_PER_S, m) for time, m in topics["/force"] if m.action != rerun_bag.DELETE]
    times, vectors = rows(recording, "/force", "Arrows3D:vectors")
    assert np.allclose(times, [time for time, _ in drawn]) and len(times) > 10
    assert np.all(np.diff(times) > 0.039) and times[-1] < duration_s
    longest = max(np.linalg.norm(vector[0]) for vector in vectors)
    assert 0.01 < longest < 1.0, longest


def test_links_of_the_robot_move(recording, topics, bag, tmp_path, duration_s):
    urdf = tmp_path / "robot.urdf"
    urdf.write_text(topics["/robot_description"][0][1].data)
    tree = UrdfTree.from_file_path(urdf)
    moved = {child for joint in tree.joints() if (child := joint.child_link) and joint.joint_type != "fixed"}
    fixed = {joint.child_link for joint in tree.joints() if joint.joint_type == "fixed"}
    by_frame = {}
    for time, message in topics["/tf"]:
        for transform in message.transforms:
            by_frame.setdefault(transform.child_frame_id, []).append(time / NS_PER_S)
    assert set(by_frame) == moved | {"tool", "surface"}
    standing = {t.child_frame_id for t in topics["/tf_static"][0][1].transforms}
    assert fixed <= standing and not standing & set(by_frame)
    for frame in moved:
        assert abs(len(by_frame[frame]) / duration_s - 25.0) < 1.0, frame
    # Several frames move at the same time, and the dataframe has one row for each time: count in the chunks.
    placed = {}
    for chunk in recording.stream().filter(content="/tf").to_chunks():
        table = chunk.to_record_batch()
        if "Transform3D:child_frame" in table.schema.names:
            for (frame,) in table.column("Transform3D:child_frame").to_pylist():
                placed[frame] = placed.get(frame, 0) + 1
    assert placed == {frame: len(times) for frame, times in by_frame.items()}
    # Rerun has read the description: shapes are there where the blueprint shows them, in frames that the bag names.
    known_frames = standing | set(by_frame) | {"world"}
    shown = [entity for entity, visible in rerun_bag.shapes_of_robot(bag).items() if visible]
    chunks = [chunk for chunk in recording.stream().to_chunks() if chunk.entity_path.startswith(f"{shown[0]}/")]
    frames = set()
    for chunk in chunks:
        table = chunk.to_record_batch()
        if "CoordinateFrame:frame" in table.schema.names:
            frames |= {frame for (frame,) in table.column("CoordinateFrame:frame").to_pylist()}
    assert frames and frames <= known_frames, frames - known_frames


def test_the_blueprint_shows_the_robot_by_its_visual_shapes_or_else_by_those_for_collisions(saved, topics):
    (blueprint,) = saved.blueprints()
    visible = {}
    for chunk in saved.stream(store=blueprint).to_chunks():
        table = chunk.to_record_batch()
        if "EntityBehavior:visible" in table.schema.names:
            kind = "visual" if "visual_geometries" in chunk.entity_path else "collision"
            visible[kind] = table.column("EntityBehavior:visible").to_pylist() == [[True]]
    has_visual = "<visual>" in topics["/robot_description"][0][1].data
    assert visible == {"visual": has_visual, "collision": not has_visual}


def test_a_deleted_marker_keeps_its_frame_and_the_robot_is_solid(saved, topics):
    cleared, framed, solid = [], [], set()
    for chunk in saved.stream().to_chunks():
        table = chunk.to_record_batch()
        for name in table.schema.names:
            if chunk.entity_path == "/force" and name in ("Clear:is_recursive", "CoordinateFrame:frame"):
                (cleared if name.startswith("Clear") else framed).extend(table.column(rerun_bag.TIMELINE).to_pylist())
            if name.endswith(":fill_mode") and "/visual_geometries/" in chunk.entity_path:
                solid.add(chunk.entity_path)
    assert cleared and set(cleared) <= set(framed)
    robot = topics["/robot_description"][0][1].data
    assert bool(solid) == ("<visual>" in robot and "<mesh" not in robot)


def test_curves_are_as_long_as_the_bag(recording, duration_s):
    for entity in ["/curves/force_n/measured_z", "/curves/height_mm/measured"]:
        times, _ = rows(recording, entity, "Scalars:scalars")
        assert times[-1] > 0.95 * duration_s and len(times) > 10 * duration_s


def paths_of(layout):
    """Every path of the layout that leads into a message."""
    for config in layout["configById"].values():
        yield from (path["value"] for path in config.get("paths", []))


def test_the_layout_asks_for_what_is_in_the_bag(topics):
    layout = json.loads((HERE / "foxglove-layout.json").read_text())
    scene = layout["configById"]["3D!scene"]
    shown = {topic for topic, settings in scene["topics"].items() if settings["visible"]}
    shown |= {layer["topic"] for layer in scene["layers"].values() if "topic" in layer}
    assert shown == {*rerun_bag.MARKER_TOPICS, "/robot_description"}
    assert shown <= set(topics), shown - set(topics)
    for path in paths_of(layout):
        topic, *fields = path.split(".")
        assert topic in topics, topic
        value = topics[topic][0][1]
        for field in fields:
            value = getattr(value, field)
        assert isinstance(value, (float, str)), path
    frames = {t.child_frame_id for _, m in topics["/tf"] for t in m.transforms} | {"world"}
    wanted = {scene["followTf"], scene["fixedFrame"], scene["layers"]["grid"]["frameId"]}
    wanted |= {name.removeprefix("frame:") for name in scene["transforms"]}
    assert wanted <= frames, wanted - frames


def test_the_layout_places_each_panel_once():
    layout = json.loads((HERE / "foxglove-layout.json").read_text())

    def leaves(node):
        return [node] if isinstance(node, str) else leaves(node["first"]) + leaves(node["second"])

    assert sorted(leaves(layout["layout"])) == sorted(layout["configById"])
