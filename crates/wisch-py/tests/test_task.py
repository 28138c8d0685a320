"""Tasks from files and from objects, and errors of wrong ones."""

import pickle

import numpy as np
import pytest

import wisch

PLACES = np.array([[0.1, 0.0], [0.0, 0.05], [-0.1, -0.05]])


def build(**more):
    keys = dict(
        action="absorb",
        tool="sponge",
        medium="breadcrumbs",
        surface={"name": "chopping_board", "size_m": [0.4, 0.28], "position_m": [0.0, 0.0, 0.75]},
        particles=PLACES,
    )
    return wisch.build_task(**{**keys, **more})


def test_a_shipped_task_has_the_values_of_its_file(task):
    assert (task.name, task.action, task.tool) == ("arm-board", "collect", "sponge")
    assert task.particles.shape == (60, 2)
    np.testing.assert_array_equal(task.world_from_surface, [0, 0, 0.77, 0, 0, 0, 1])
    np.testing.assert_allclose(task.surface_reaction, [0, 0, task.press_force_n])
    assert [part["name"] for part in task.scene] == ["board", "tabletop"]
    assert task.scene[0]["role"] == "carrier"
    assert np.ptp(task.scene[0]["vertices"], axis=0) == pytest.approx([0.32, 0.24, 0.02])


def test_given_values_override_the_file():
    task = wisch.load_task(
        "arm-board",
        set={"particles.count": np.int64(7), "tool.name": "brush", "surface.size_m": (0.3, 0.2), "execution": {"friction": 0.3}},
        seed=5,
        strategy="grid",
    )
    assert (len(task.particles), task.tool, task.seed, task.strategy) == (7, "brush", 5, "grid")
    assert np.ptp(task.surface_outline, axis=0) == pytest.approx([0.3, 0.2])


def test_a_task_from_objects_equals_the_task_from_a_file_with_the_same_keys(tmp_path):
    made = build(scene=[{"name": "cup", "box_m": [0.05, 0.05, 0.1], "frame": "surface", "position_m": np.array([-0.1, 0.1, 0.05])}])
    np.testing.assert_array_equal(made.particles, PLACES)
    lists = "\n".join(f"{x},{y}" for x, y in PLACES.tolist())
    (tmp_path / "crumbs.csv").write_text(f"x,y\n{lists}\n")
    file = tmp_path / "task.toml"
    file.write_text(made.toml.replace("particles given as an array.csv", "crumbs.csv"))
    read = wisch.load_task(file)
    np.testing.assert_array_equal(read.particles, made.particles)
    assert read.session().plan().to_json() == made.session().plan().to_json()


def test_other_particles_make_another_task_and_do_not_change_the_first(task):
    other = task.with_particles(PLACES, strategy="grid")
    np.testing.assert_array_equal(other.particles, PLACES)
    assert (other.strategy, task.strategy, len(task.particles)) == ("grid", "kde", 60)


@pytest.mark.parametrize(
    ("make", "message", "value", "limit"),
    [
        (lambda: wisch.load_task("arm-board", set={"particles.count": 0}), "particles.count = 0", "0", "at least 1"),
        (lambda: build(tool="spunge"), "nearest: sponge", "spunge", "sponge"),
        (lambda: build(colour=3), 'unknown key "colour"', "colour", "schema"),
        (lambda: build(strategy="greedy"), "greedy", "greedy", "kde"),
        (lambda: build(particles=np.zeros((3, 3))), "particles", "an array of shape (3, 3)", "(rows, 2)"),
        (lambda: wisch.load_task("arm-board", action="wipe"), "wipe", None, None),
        (lambda: build(surface={"name": "chopping_board", "size_m": [0.4, float("nan")]}), "surface.size_m[1] = NaN is outside its limits", "NaN", "at least 0.001"),
    ],
)
def test_a_wrong_task_is_refused_with_place_value_and_limit(make, message, value, limit):
    with pytest.raises(wisch.WischError) as caught:
        make()
    error = caught.value
    assert message in str(error)
    if value is not None:
        assert error.value == value and limit in error.limit
    assert isinstance(error, ValueError)


def test_a_pickled_error_keeps_its_place_and_help(tmp_path):
    file = tmp_path / "task.toml"
    file.write_text("schema = 1\nname = 3\n")
    with pytest.raises(wisch.WischError) as caught:
        wisch.load_task(file)
    error = pickle.loads(pickle.dumps(caught.value))
    assert (error.file, error.place, str(error)) == (str(file), (2, 8), str(caught.value))
    with pytest.raises(wisch.WischError, match="arm-board") as caught:
        wisch.load_task("arm-bord")
    assert caught.value.help == "did you mean arm-board?"


def test_an_invalid_particle_is_named():
    places = PLACES.copy()
    places[1, 0] = np.nan
    with pytest.raises(wisch.WischError, match=r"particle 1: position \(NaN, 0.05\)"):
        build(particles=places)


def bulge(size=(0.3, 0.2), radius=1.0, cells=24):
    """Vertices and faces of a piece of a cylinder along y."""
    x, y = np.meshgrid(np.linspace(-size[0] / 2, size[0] / 2, cells + 1), np.linspace(-size[1] / 2, size[1] / 2, cells + 1))
    vertices = np.column_stack([x.ravel(), y.ravel(), np.sqrt(radius**2 - x.ravel() ** 2) - radius])
    corner = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    lower = np.column_stack([corner, corner + 1, corner + cells + 2])
    upper = np.column_stack([corner, corner + cells + 2, corner + cells + 1])
    return vertices, np.vstack([lower, upper])


class Trimesh:
    """What wisch uses of a mesh of the package trimesh."""

    def __init__(self, vertices, faces):
        self.vertices, self.faces = vertices, faces


def test_a_surface_may_be_a_mesh_in_memory(tmp_path):
    vertices, faces = bulge()
    places = [[0.1, 0.02], [0.0, 0.05], [-0.1, -0.05]]
    curved = {"name": "chopping_board", "position_m": [0.0, 0.0, 0.75]}
    made = build(surface={**curved, "mesh": (vertices, faces)}, particles=places)
    also = build(surface={**curved, "mesh": {"file": Trimesh(vertices, faces), "towards": [0, 0, 1]}}, particles=places)
    assert made.session().plan().to_json().count("mesh") >= 1
    assert also.session().plan().strokes[0] == pytest.approx(made.session().plan().strokes[0])
    # Another task of it has the same mesh.
    other = made.with_particles(PLACES, strategy="grid")
    np.testing.assert_allclose(other.surface_outline, made.surface_outline)
    size = np.ptp(made.surface_outline, axis=0)
    assert size == pytest.approx([0.3008, 0.2], abs=2e-3)


@pytest.mark.parametrize(
    "mesh, words",
    [
        ((np.zeros((3, 2)), [[0, 1, 2]]), "shape"),
        ((np.eye(3), [[0, 1, 3]]), "indices of 3 vertices"),
        ((np.eye(3), [[0, 1, -1]]), "indices of 3 vertices"),
        ((np.full((3, 3), np.nan), [[0, 1, 2]]), "mesh"),
    ],
)
def test_a_wrong_mesh_in_memory_is_refused(mesh, words):
    with pytest.raises((wisch.WischError, TypeError, ValueError), match=words):
        build(surface={"name": "chopping_board", "mesh": mesh})
