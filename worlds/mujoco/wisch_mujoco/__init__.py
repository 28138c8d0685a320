"""A MuJoCo world for wisch: a robot from its URDF, a tool that is a bed of springs, and crumbs that contact pushes."""

try:
    import mujoco  # noqa: F401
except ImportError as error:
    raise SystemExit(f"MuJoCo is needed ({error}): pip install -r worlds/mujoco/requirements.txt") from error
try:
    import wisch  # noqa: F401
except ImportError as error:
    raise SystemExit(f"the wheel of wisch is needed ({error}): pip install ./crates/wisch-py") from error

from .settings import Push, Settings, Unsupported
from .world import World

__all__ = ["Push", "Settings", "Unsupported", "World"]
