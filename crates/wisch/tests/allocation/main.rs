//! What runs in a loop, or for every particle, allocates nothing once its scratch space has its size.
//!
//! The allocator counts for the whole process, so one test after the other is watched, apart from all others and from the
//! test harness, which allocates on a thread of its own while a test begins.

mod clearance;
mod control;
mod ik;
mod stroke;

use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use std::alloc::System;

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

fn main() {
    // Runners that ask for a list of tests find none.
    if std::env::args().any(|argument| argument == "--list") {
        return;
    }
    stroke::a_stroke_allocates_nothing();
    clearance::a_query_allocates_nothing();
    ik::solving_and_self_motion_allocate_nothing();
    control::a_period_of_control_allocates_nothing();
}
