//! The tests of the Prolog engine.

mod ask;
