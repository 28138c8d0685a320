//! Programs that belong to this one and are compiled apart, as few need them: where they are found, and how a checkout of
//! the source builds them.

use crate::args::GlobalArgs;
use crate::failure::Failure;
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
    /// Whether it is a workspace of its own, with its own lock file, and no member of the program's.
    pub is_workspace: bool,
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

    /// Finds it, or builds it in a checkout.
    ///
    /// # Errors
    /// That it cannot be had, and what installs it.
    pub fn find_or_build(&self, global: &GlobalArgs) -> Result<PathBuf, Failure> {
        if let Some(program) = self.find() {
            return Ok(program);
        }
        let built = self.build(global);
        let built = built.map_err(|why| Failure::new(why).with_help(self.install()))?;
        let program = built.then(|| self.find()).flatten();
        program.ok_or_else(|| {
            Failure::new(format!("{} cannot be found", self.name)).with_help(self.install())
        })
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
        let manifest = match self.is_workspace {
            true => checkout.join("crates").join(self.name),
            false => checkout.to_path_buf(),
        };
        cargo
            .arg("--manifest-path")
            .arg(manifest.join("Cargo.toml"));
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
