//! The tests of the simulated world.

mod execute;
