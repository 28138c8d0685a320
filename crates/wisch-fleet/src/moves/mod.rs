//! Transfer of episodes into and out of a fleet, and maintenance of a fleet.

pub mod batch;
mod forget;
mod known;
mod local;
mod pull;
mod push;
mod upkeep;
mod verify;

pub use forget::{Forgotten, forget};
pub use local::{Local, Part, open_local};
pub use pull::{Filter, Pulled, pull};
pub use push::{PushOptions, Pushed, push};
pub use upkeep::{Compacted, Retained, compact, purge, retain};
pub use verify::{Verified, verify};
