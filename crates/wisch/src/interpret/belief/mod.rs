//! Belief about the dirt after a log: an ensemble of possible worlds, in each of which the contact motions are
//! replayed.

mod activation;
mod density;
mod ensemble;
mod exposure;
mod observed_frame;
mod parameter_sampling;
mod performance;
mod prior;
mod push_hypotheses;
mod replay;
mod sight;

pub use density::DensityMap;
pub use ensemble::Belief;
pub use exposure::{Exposure, ParticleTouch};
pub use performance::{Estimate, PerformanceDistribution};
pub use prior::{COUNT_SPREAD, DirtPrior};
pub(super) use push_hypotheses::ContactEvidence;
pub(super) use replay::Replay;
pub use sight::ObservationUpdate;
