//! The tests of the simulated world.

mod dirt;
mod execute;
mod guard;
mod live;
mod scenarios;
mod sight;
mod treated;
