//! Pictures and pages of robotic wiping: predicted effects of plans, robot motions, and interpreted rounds.
//!
//! | drawn | from | by |
//! |---|---|---|
//! | a run, live or finished, for the page of `wisch-web` | run events | [`RecordingWriter`] |
//! | figures for papers, in SVG | [`ReportInput`] | [`pictures`] |
//! | the effect over the distance in contact | a running prediction | [`EffectFrames`], part of [`ReportInput`] |
//! | a robot in motion: joints, base placements | [`ShownMotion`] of a followed plan, or any [`MotionInput`] | part of [`ReportInput`], or [`joint_plots`], [`placements_plan`] |
//! | a log of wiping as one page | [`LogPageInput`] | [`log_page`] |
//! | rounds: force, path, probability of an effect, remaining dirt | [`RoundsInput`] | part of [`ReportInput`] |
//! | an episode without a recording, for the same page | its telemetry and events | [`RecordingWriter::record_log`] |
//! | a tool's footprint | [`wisch::represent::Tool`] | [`footprint_drawing`] |
//! | an unrolled surface | [`SheetInput`] | [`sheet_drawing`] |
//! | a surface in patches | [`PatchesInput`] | [`patches_drawing`] |
//! | a command over all patches | [`PatchesPageInput`] | [`patches_page`] |
//! | the steps of a goal of several parts | [`StepRow`] | [`steps_page`] |
//! | the calibration of estimates | [`CalibrationCurve`]s | [`calibration_drawing`] |
//! | tasks by several strategies, compared with the paper's figures | [`Table1Input`] | [`table1_page`] |
//! | any of these SVG pictures as PNG, with the feature `png` | the text of the SVG | `rasterize` |
//!
//! Everything is drawn in memory with embedded fonts. The crate reads no files, and its pages load nothing from the network.
//!
//! ```
//! use wisch::geometry::{Mesh, Polygon, Region, Vector2, Vector3};
//! use wisch::represent::{AngleRange, Tool};
//!
//! let size = Vector2::new(0.07, 0.11);
//! let sponge = Tool {
//!     name: "sponge".to_owned(),
//!     mesh: Mesh::cuboid(Vector3::new(size.x, size.y, 0.05))?,
//!     footprint: Region::new(vec![Polygon::rectangle(size)]),
//!     area_of_effect: size,
//!     rotation_about_normal: AngleRange::FULL,
//!     tilt: None,
//!     mount: None,
//!     second_grip: None,
//! };
//! let svg = wisch_report::footprint_drawing(&sponge);
//! assert!(svg.starts_with("<svg"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod calibration;
mod draw;
mod footprint;
mod input;
mod log_page;
mod motion;
mod page;
mod patches;
mod pictures;
mod prediction;
mod recording;
mod rounds;
mod scene;
mod sheet;
mod table1;
#[cfg(test)]
mod tests;

pub use calibration::{CalibrationCurve, CalibrationLevel, calibration_drawing};
#[cfg(any(test, feature = "png"))]
pub use draw::{PictureError, rasterize};
pub use footprint::footprint_drawing;
pub use input::ReportInput;
pub use log_page::{LogPageInput, log_page};
pub use motion::{
    BasePose, CandidateBase, MotionInput, ShownContact, ShownMotion, ShownPhase, joint_plots,
    placements_plan,
};
pub use patches::{
    PatchFound, PatchRow, PatchesInput, PatchesPageInput, StepRow, patches_drawing, patches_page,
    steps_page,
};
pub use pictures::pictures;
pub use prediction::frames::{EffectFrames, Frame};
pub use recording::{
    CommandOptions, LoggedEpisode, LoggedOccurrence, LoggedRobot, LoggedRound, LoggedTask,
    RECORDING_SCHEMA, RecordingHead, RecordingWriter, RoundTruth, RunFact, RunOutcome,
    UnexecutedPlan,
};
pub use rounds::{RoundView, RoundsInput};
pub use sheet::{SheetInput, sheet_drawing};
pub use table1::{
    ActionRows, ComparedFigure, StrategyColumn, SurfaceColumns, Table1Input, WipedSurface,
    table1_page,
};
