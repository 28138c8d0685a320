//! Programs that belong to this one and are compiled apart, as few need them: where they are found, and how a checkout of
//! the source builds them.

use crate::args::GlobalArgs;
use crate::terminal::remark;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A program of this source.
#[derive(Debug, Clone, Copy)]
pub struct Companion {
    /// Its package and name.
    pub name: &'static str,
    /// What is said while it is built.
    pub building: &'static str,
    /// Which build it belongs to.
    pub workspace: Workspace,
}

/// Which build a program belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Workspace {
    /// That of this program.
    Shared,
    /// One of its own, with its own lock file.
    Own,
}

impl Companion {
    /// Beside this program, in the folder above (as of cargo's examples), or in `PATH`.
    pub fn find(&self) -> Option<PathBuf> {
        let program = std::env::current_exe().unwrap_or_default();
        let beside = program.ancestors().skip(1).take(2).map(Path::to_path_buf);
        let path = std::env::var_os("PATH").unwrap_or_default();
        let name = format!("{}{}", self.name, std::env::consts::EXE_SUFFIX);
        beside
            .chain(std::env::split_paths(&path))
            .map(|folder| folder.join(&name))
            .find(|program| program.is_file())
    }

    /// Builds it beside this program, if that lies in the target folder of a checkout, as after `cargo run`: whether it did.
    ///
    /// # Errors
    /// Why it cannot be built.
    pub fn build(&self, global: &GlobalArgs) -> Result<bool, String> {
        let program = std::env::current_exe().unwrap_or_default();
        let Some((folder, target, checkout)) = self.checkout(&program) else {
            return Ok(false);
        };
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.args(["build", "--locked", "--package", self.name]);
        let workspace = match self.workspace {
            Workspace::Shared => checkout.to_path_buf(),
            Workspace::Own => checkout.join("crates").join(self.name),
        };
        cargo
            .arg("--manifest-path")
            .arg(workspace.join("Cargo.toml"));
        cargo.arg("--target-dir").arg(target);
        if folder.ends_with("release") {
            cargo.arg("--release");
        }
        if global.quiet {
            cargo.arg("--quiet");
        } else {
            remark(self.building);
        }
        let ended = cargo.stdin(Stdio::null()).stdout(Stdio::null()).status();
        match ended {
            Ok(status) if status.success() => Ok(true),
            Ok(status) => Err(format!("{} cannot be built: cargo: {status}", self.name)),
            Err(error) => Err(format!("{} cannot be built: cargo: {error}", self.name)),
        }
    }

    /// What installs it.
    pub fn install(&self) -> String {
        format!(
            "cargo install --path crates/{} --locked, in wisch's source, installs it",
            self.name
        )
    }

    /// The folder of the profile, the target folder and the checkout in which a program lies.
    fn checkout<'a>(&self, program: &'a Path) -> Option<(&'a Path, &'a Path, &'a Path)> {
        let folder = program.parent()?;
        let target = folder.parent()?;
        let checkout = target.parent()?;
        let is_built_here = ["release", "debug"]
            .iter()
            .any(|name| folder.ends_with(name))
            && target.ends_with("target")
            && checkout
                .join("crates")
                .join(self.name)
                .join("Cargo.toml")
                .is_file();
        is_built_here.then_some((folder, target, checkout))
    }
}
