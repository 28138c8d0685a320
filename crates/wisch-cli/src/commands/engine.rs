//! Where `wisch ask` finds its Prolog engine; in a checkout of the source it builds it.

use super::companion::{Companion, Workspace};
use crate::args::{EngineChoice, GlobalArgs};
use crate::failure::Failure;
use crate::terminal::remark;
use wisch_memory::ask::EngineCommand;

const ENGINE: Companion = Companion {
    name: "wisch-prolog",
    building: "building the Prolog engine, once: some minutes (4 on two cores)",
    workspace: Workspace::Shared,
};

/// The engine of this choice; without one, Scryer Prolog if it can be had, else SWI-Prolog if it is installed.
pub fn find(choice: Option<EngineChoice>, global: &GlobalArgs) -> Result<EngineCommand, Failure> {
    if choice == Some(EngineChoice::Swi) {
        return EngineCommand::swi().ok_or_else(|| {
            Failure::new("there is no SWI-Prolog: swipl cannot be found")
                .with_help("install it, so that swipl is in PATH, or leave out --engine")
        });
    }
    if let Some(engine) = EngineCommand::scryer() {
        return Ok(engine);
    }
    let (name, install) = (ENGINE.name, ENGINE.install());
    let built = ENGINE.build(global).map_err(|why| {
        Failure::new(format!("the Prolog engine {why}"))
            .with_help(format!("{install}; --engine swi asks SWI-Prolog instead"))
    })?;
    if let (true, Some(engine)) = (built, EngineCommand::scryer()) {
        return Ok(engine);
    }
    if choice.is_none()
        && let Some(engine) = EngineCommand::swi()
    {
        if !global.quiet {
            remark(&format!(
                "SWI-Prolog answers, for {name} cannot be found; {install}"
            ));
        }
        return Ok(engine);
    }
    Err(
        Failure::new(format!("there is no Prolog engine: {name} cannot be found"))
            .with_help(install),
    )
}
