//! The tests of what reaches outside: programs that execute motions.

mod driver;
mod misbehaviour;
mod process;
mod silence;
