"""Other ways to wipe, for comparison: zigzags, and the tour of an oracle."""

import numpy as np


def zigzag(middle, sizes, spacing, along):
    """Returns lanes `spacing` apart over a rectangle, back and forth along axis `along` (0 is x, 1 is y): (n, 2)."""
    across = 1 - along
    lanes = max(1, int(np.ceil(sizes[across] / spacing - 1e-9)) + 1) if sizes[across] > 1e-9 else 1
    offsets = np.linspace(-sizes[across] / 2, sizes[across] / 2, lanes) if lanes > 1 else np.zeros(1)
    points = []
    for lane, offset in enumerate(offsets):
        for end in (-1, 1) if lane % 2 == 0 else (1, -1):
            point = np.zeros(2)
            point[across], point[along] = offset, end * sizes[along] / 2
            points.append(middle + point)
    return np.array(points)


def zigzag_area(world, follower, spacing=0.03):
    """Wipes the whole area in which markers may lie, without observation."""
    middle, sizes = world.dirt_area()
    yaw = np.pi / 2
    path = zigzag(middle, sizes, spacing, along=1)
    follower.follow([[*point, yaw] for point in path])


def zigzag_box(world, follower, spacing=0.09):
    """Wipes the bounding box of the observed markers, in lanes with the tool's broad side across the motion."""
    markers = world.visible_markers()
    low, high = markers.min(axis=0), markers.max(axis=0)
    along = int(np.argmax(high - low))
    yaw = np.pi / 2 if along == 0 else 0.0
    # Lanes at most `spacing` apart; the outer ones cover the border with the tool's width.
    sizes = high - low
    width = world.tool().width
    inner = sizes.copy()
    inner[1 - along] = max(0.0, sizes[1 - along] - width + 0.02)
    follower.follow([[*point, yaw] for point in zigzag((low + high) / 2, inner, spacing, along)])


def oracle_tour(world, follower):
    """Moves to the nearest marker that is left, which the oracle knows at all times; the yaw is constant."""
    yaw = np.pi / 2
    while not world.done:
        markers = world.visible_markers()
        if len(markers) == 0:
            return
        position = world.position()[:2]
        target = markers[np.argmin(np.linalg.norm(markers - position, axis=1))]
        follower.follow([[*target, yaw]], until=lambda: not is_there(world, target))


def is_there(world, place):
    """Whether the marker at a location is left."""
    markers = world.visible_markers()
    return len(markers) > 0 and np.linalg.norm(markers - place, axis=1).min() < 1e-6
