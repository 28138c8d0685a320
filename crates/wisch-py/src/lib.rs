//! wisch for Python: classes and functions of the module `wisch._wisch`, which `python/wisch` re-exports.
//!
//! Poses are x, y, z [m] and a unit quaternion x, y, z, w; a tool's pose on the surface is x, y [m] and yaw [rad] in
//! the frame of the surface. Arrays are NumPy's, of 64-bit floats, and own the computed data: nothing is copied.

mod arrays;
mod control;
mod effect;
mod environment;
mod error;
mod executor;
mod interpret;
mod memory;
mod motion;
mod mutex;
mod pictures;
mod plan;
mod program;
mod robot;
mod round;
mod session;
mod task;
mod task_text;
mod telemetry;
mod warnings;
mod watchdog;

use pyo3::prelude::*;

#[pymodule]
mod _wisch {
    #[pymodule_export]
    use crate::control::PyImpedanceController;
    #[pymodule_export]
    use crate::effect::PyEffectField;
    #[pymodule_export]
    use crate::environment::PyWipingWorlds;
    #[pymodule_export]
    use crate::executor::PySink;
    #[pymodule_export]
    use crate::interpret::PyInterpretation;
    #[pymodule_export]
    use crate::memory::PyMemory;
    #[pymodule_export]
    use crate::motion::PyMotion;
    #[pymodule_export]
    use crate::plan::{PyPlan, PyPrediction};
    #[pymodule_export]
    use crate::program::run_program;
    #[pymodule_export]
    use crate::robot::PyRobot;
    #[pymodule_export]
    use crate::round::{PyAudit, PyRound};
    #[pymodule_export]
    use crate::session::PySession;
    #[pymodule_export]
    use crate::task::{PyTask, load_task, task_of_keys};
    #[pymodule_export]
    use crate::telemetry::{PyTelemetry, read_log};
}
