//! Where `wisch ask` finds its Prolog engine; in a checkout of the source it builds it.

use crate::args::{EngineChoice, GlobalArgs};
use crate::failure::Failure;
use crate::terminal::remark;
use std::path::Path;
use std::process::{Command, Stdio};
use wisch_memory::ask::EngineCommand;

/// The package and program of the engine.
const ENGINE: &str = "wisch-prolog";
/// What installs the engine.
const INSTALL: &str =
    "cargo install --path crates/wisch-prolog --locked, in wisch's source, installs it";

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
    if let Some(engine) = build(global)? {
        return Ok(engine);
    }
    if choice.is_none()
        && let Some(engine) = EngineCommand::swi()
    {
        if !global.quiet {
            remark(&format!(
                "SWI-Prolog answers, for {ENGINE} cannot be found; {INSTALL}"
            ));
        }
        return Ok(engine);
    }
    Err(Failure::new(format!(
        "there is no Prolog engine: {ENGINE} cannot be found"
    ))
    .with_help(INSTALL))
}

/// Builds the engine beside this program, if it lies in the target folder of a checkout, as after `cargo run`.
fn build(global: &GlobalArgs) -> Result<Option<EngineCommand>, Failure> {
    let program = std::env::current_exe().unwrap_or_default();
    let Some((folder, target, checkout)) = checkout(&program) else {
        return Ok(None);
    };
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["build", "--locked", "--package", ENGINE]);
    cargo
        .arg("--manifest-path")
        .arg(checkout.join("Cargo.toml"));
    cargo.arg("--target-dir").arg(target);
    if folder.ends_with("release") {
        cargo.arg("--release");
    }
    if global.quiet {
        cargo.arg("--quiet");
    } else {
        remark("building the Prolog engine, once: some minutes (4 on two cores)");
    }
    let ended = cargo.stdin(Stdio::null()).stdout(Stdio::null()).status();
    let why = match ended {
        Ok(status) if status.success() => return Ok(EngineCommand::scryer()),
        Ok(status) => status.to_string(),
        Err(error) => error.to_string(),
    };
    Err(Failure::new(format!(
        "the Prolog engine {ENGINE} cannot be built: cargo: {why}"
    ))
    .with_help(format!("{INSTALL}; --engine swi asks SWI-Prolog instead")))
}

/// The folder of the profile, the target folder and the checkout in which a program lies.
fn checkout(program: &Path) -> Option<(&Path, &Path, &Path)> {
    let folder = program.parent()?;
    let target = folder.parent()?;
    let checkout = target.parent()?;
    let is_built_here = ["release", "debug"]
        .iter()
        .any(|name| folder.ends_with(name))
        && target.ends_with("target")
        && checkout
            .join("crates")
            .join(ENGINE)
            .join("Cargo.toml")
            .is_file();
    is_built_here.then_some((folder, target, checkout))
}
