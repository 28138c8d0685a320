"""Crumbs: their positions at the start, and the fate of each."""

from dataclasses import dataclass

import numpy as np

from .settings import Unsupported

DENSITY = 400.0
"""Density of dry bread [kg/m³]."""
LEAST_MASS = 2e-5
"""Least mass of a crumb [kg]: at 1 kHz, a solver does not resolve a body much lighter than what presses on it."""

LYING, TAKEN_UP = 0, 1


@dataclass
class Crumbs:
    """All crumbs of a world, in the frame of the real surface."""

    places: np.ndarray
    """Centres of the crumbs (n, 3) [m]."""
    quaternions: np.ndarray
    """Orientations as quaternions (n, 4), w first."""
    radii: np.ndarray
    """Radii (n) [m]."""
    thresholds: np.ndarray
    """Share of the nominal pressure at which the foam takes up each crumb (n) [1]."""
    fates: np.ndarray
    """Fate of each crumb: LYING or TAKEN_UP (n)."""

    def __len__(self):
        return len(self.radii)

    @property
    def masses(self):
        """Returns the masses (n) [kg]."""
        return np.maximum(LEAST_MASS, DENSITY * 4.0 / 3.0 * np.pi * self.radii**3)

    def on_surface(self, outline):
        """Returns the mask (n) of the crumbs on the surface."""
        return (self.fates == LYING) & inside(outline, self.places[:, :2]) & (self.places[:, 2] > -0.5 * self.radii)

    def meeting(self, action, goal, radius, outline):
        """Returns the mask (n) of the crumbs that meet the goal. `goal` (2) and `radius` [m] are those of a collect."""
        if action == "absorb":
            return self.fates == TAKEN_UP
        if action == "collect":
            near = np.linalg.norm(self.places[:, :2] - goal, axis=1) <= radius
            return self.on_surface(outline) & near
        raise ValueError(f"{action}: this world does not know its goal")


def inside(outline, points):
    """Returns the mask (n) of the points (n, 2) in a polygon (k, 2), by the crossings of a ray."""
    x, y = points[:, 0], points[:, 1]
    odd = np.zeros(len(points), dtype=bool)
    for (x1, y1), (x2, y2) in zip(outline, np.roll(outline, -1, axis=0)):
        if y1 == y2:
            continue
        crosses = (y1 > y) != (y2 > y)
        odd ^= crosses & (x < x1 + (y - y1) * (x2 - x1) / (y2 - y1))
    return odd


def draw(settings, outline, believed):
    """Draws the crumbs of a world by the table `execution.dirt`, with separate random numbers. Their number is about that of the
    `believed` particles (n, 2); only the source "as_believed" puts them at the believed locations."""
    random = np.random.default_rng([settings.seed, 0x6372756D])
    if settings.dirt["source"] not in PLACES:
        known = ", ".join(PLACES)
        raise Unsupported(f"execution.dirt: source {settings.dirt['source']!r} is unknown in this world; known: {known}")
    listed = settings.dirt["source"] == "as_believed"
    about = len(believed)
    count = about if listed else settings.count or max(1, round(about * np.exp(0.2 * random.standard_normal())))
    low, high = outline.min(axis=0), outline.max(axis=0)
    place = PLACES[settings.dirt["source"]](settings.dirt, random, low, high)
    smallest, largest = settings.grains
    radii = random.uniform(smallest, largest, count) / 2.0
    places = np.zeros((count, 3))
    if listed:
        places = np.column_stack([believed, radii])
    for crumb in range(0 if listed else count):
        for _ in range(10_000):
            drawn = place()
            edge = 2.0 * radii[crumb]
            around = drawn + edge * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
            apart = np.linalg.norm(places[:crumb, :2] - drawn, axis=1) > radii[:crumb] + radii[crumb]
            if inside(outline, around).all() and apart.all():
                break
        else:
            raise ValueError(f"there is no room for {count} crumbs")
        places[crumb] = [*drawn, radii[crumb]]
    return Crumbs(
        places=places,
        quaternions=np.tile([1.0, 0.0, 0.0, 0.0], (count, 1)),
        radii=radii,
        thresholds=np.exp(settings.mu + settings.sigma * random.standard_normal(count)),
        fates=np.full(count, LYING),
    )


def _uniform(_, random, low, high):
    return lambda: random.uniform(low, high)


def _clusters(dirt, random, low, high):
    heaps = dirt.get("clusters") or [
        {"center_m": random.uniform(low, high), "sigma_m": random.uniform(0.015, 0.05)} for _ in range(random.integers(1, 7))
    ]
    weights = np.array([heap.get("weight", 1.0) for heap in heaps])

    def place():
        heap = heaps[random.choice(len(heaps), p=weights / weights.sum())]
        return random.normal(heap["center_m"], heap["sigma_m"])

    return place


def _stripe(dirt, random, low, high):
    center = np.array(dirt.get("center_m", random.uniform(low, high)))
    angle = dirt.get("direction_rad", random.uniform(0.0, np.pi))
    width = dirt.get("width_m", random.uniform(0.03, 0.08))
    along = np.array([np.cos(angle), np.sin(angle)])
    across = np.array([-along[1], along[0]])
    length = np.linalg.norm(high - low)
    return lambda: center + along * random.uniform(-length, length) + across * random.uniform(-width, width) / 2.0


PLACES = {"uniform": _uniform, "clusters": _clusters, "stripe": _stripe, "as_believed": _uniform}
