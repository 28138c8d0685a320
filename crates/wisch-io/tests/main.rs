//! The tests of what reaches outside: programs that execute motions.

mod driver;
mod process;
mod silence;
