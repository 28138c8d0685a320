//! Finds the Prolog engine of `wisch ask`, and builds it in a checkout of the source.

use super::companion::Companion;
use crate::args::{EngineChoice, GlobalArgs};
use crate::failure::Failure;
use crate::terminal::remark;
use wisch_memory::ask::EngineCommand;

const ENGINE: Companion = Companion {
    name: "wisch-prolog",
    building: "building the Prolog engine; this happens once and takes about 4 minutes on two cores",
    is_workspace: false,
};

/// Finds the chosen engine. Without a choice, prefers Scryer Prolog, which is built if possible, to SWI-Prolog.
pub fn find(choice: Option<EngineChoice>, global: &GlobalArgs) -> Result<EngineCommand, Failure> {
    if choice == Some(EngineChoice::Swi) {
        return EngineCommand::find_swi().ok_or_else(|| {
            Failure::new("SWI-Prolog is not installed: swipl is not in PATH")
                .with_help("install SWI-Prolog, or leave out --engine")
        });
    }
    if let Some(engine) = EngineCommand::find_scryer() {
        return Ok(engine);
    }
    let (name, install) = (ENGINE.name, ENGINE.install());
    let built = ENGINE.build(global).map_err(|why| {
        Failure::new(format!("the Prolog engine {why}"))
            .with_help(format!("{install}; --engine swi uses SWI-Prolog instead"))
    })?;
    if let (true, Some(engine)) = (built, EngineCommand::find_scryer()) {
        return Ok(engine);
    }
    if choice.is_none()
        && let Some(engine) = EngineCommand::find_swi()
    {
        if !global.quiet {
            remark(&format!(
                "using SWI-Prolog, because {name} is not installed; {install}"
            ));
        }
        return Ok(engine);
    }
    Err(Failure::new(format!(
        "there is no Prolog engine: {name} is not installed"
    ))
    .with_help(install))
}
