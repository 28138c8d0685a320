//! The tests of the simulated world.

mod execute;
mod scenarios;
