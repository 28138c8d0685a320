//! Knowledge files.
#![no_main]

use libfuzzer_sys::fuzz_target;
use wisch::represent::KnowledgeBase;

fuzz_target!(|text: &str| {
    let _ = KnowledgeBase::from_toml(&[("fuzz.toml", text)]);
});
