//! Knowledge files.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let _ = wisch_io::parse_knowledge(&[("fuzz.toml", text)]);
});
