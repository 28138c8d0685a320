//! Tests with other programs that execute motions.

mod driver;
mod misbehaviour;
mod process;
mod silence;
