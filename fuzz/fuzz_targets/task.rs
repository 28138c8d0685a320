//! Task files: a file that parses is also resolved, without other files.
#![no_main]

use libfuzzer_sys::fuzz_target;
use wisch::represent::{Action, KnowledgeBase};
use wisch_io::TaskFile;

fuzz_target!(|text: &str| {
    if let Ok(file) = TaskFile::parse("fuzz.toml", text, &[]) {
        let knowledge = KnowledgeBase::default();
        let nothing = |_: &str| Err("no files here".to_owned());
        let _ = file.resolve(
            Action::Absorb,
            "sponge",
            "breadcrumbs",
            file.run.plan.seed,
            &knowledge,
            &mut nothing.clone(),
            &mut nothing.clone(),
        );
    }
});
