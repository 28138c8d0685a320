//! Where the dirt may lie after a log: the contact motions replayed many times, each time with another sample of
//! what is not known exactly.

mod activation;
mod density;
mod ensemble;
mod parameter_sampling;
mod push_hypotheses;
mod replay;

pub use density::DensityMap;
pub use ensemble::{Belief, Estimate};
pub(super) use push_hypotheses::ContactEvidence;
pub(super) use replay::Replay;
