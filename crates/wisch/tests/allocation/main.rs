//! Functions that run in a loop, or for every particle, allocate nothing once their scratch space
//! has its size.
//!
//! The allocator counts for the whole process. Therefore, the tests run one after another in a
//! separate program, without the test harness, which allocates on another thread while a test
//! begins.

mod clearance;
mod control;
mod ik;
mod stroke;

use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use std::alloc::System;

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

fn main() {
    // The list of tests for test runners is empty.
    if std::env::args().any(|argument| argument == "--list") {
        return;
    }
    stroke::a_stroke_allocates_nothing();
    clearance::a_query_allocates_nothing();
    ik::solving_and_self_motion_allocate_nothing();
    control::a_period_of_control_allocates_nothing();
}
