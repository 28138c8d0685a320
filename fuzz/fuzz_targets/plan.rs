//! Records of plans.
#![no_main]

use libfuzzer_sys::fuzz_target;
use wisch_io::PlanRecord;

fuzz_target!(|text: &str| {
    let _ = PlanRecord::parse(text);
});
