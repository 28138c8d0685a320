//! Task files, as typed and as meant: what parses is also resolved, with no file at hand.
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
