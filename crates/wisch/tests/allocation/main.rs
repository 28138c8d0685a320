//! What runs in a loop, or for every particle, allocates nothing once its scratch space has its size.
//!
//! The allocator counts for the whole process, so one test after the other is watched, and apart from all others.

mod clearance;
mod control;
mod ik;
mod stroke;

use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use std::alloc::System;

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

#[test]
fn loops_allocate_nothing() {
    stroke::a_stroke_allocates_nothing();
    clearance::a_query_allocates_nothing();
    ik::solving_and_self_motion_allocate_nothing();
    control::a_period_of_control_allocates_nothing();
}
