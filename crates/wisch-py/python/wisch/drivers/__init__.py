"""Executors for real arms: ``UrRtde`` (Universal Robots) and ``Franky`` (Franka Robotics).

Each needs a package of its own: ``pip install wisch[ur]`` or ``pip install wisch[franka]``. The package is imported when a
driver connects, so this module imports without it::

    import wisch.drivers
    import wisch.executor

    wisch.executor.serve(wisch.drivers.UrRtde("192.168.1.10", speed=0.25))

Neither driver has been run on a real arm. docs/arms.md says what a driver checks, docs/stops.md what it does not guarantee.
"""

from .franky import Franky
from .ur_rtde import UrRtde

__all__ = ["Franky", "UrRtde"]
