//! Companion programs, which are installed separately because few users need them: finds them, and builds them in a
//! checkout of the source.

use crate::args::GlobalArgs;
use crate::failure::Failure;
use crate::terminal::remark;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A companion program.
#[derive(Debug, Clone, Copy)]
pub struct Companion {
    /// Name of its package and program.
    pub name: &'static str,
    /// The note that is shown while it is built.
    pub building: &'static str,
    /// Whether its package is a separate Cargo workspace with its own lock file.
    pub is_workspace: bool,
}

impl Companion {
    /// Finds it beside this program, in the parent folder (for cargo's examples), or in `PATH`.
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
    /// If it is neither found nor built; the advice names the command that installs it.
    pub fn find_or_build(&self, global: &GlobalArgs) -> Result<PathBuf, Failure> {
        if let Some(program) = self.find() {
            return Ok(program);
        }
        let built = self.build(global);
        let built = built.map_err(|why| Failure::new(why).with_help(self.install()))?;
        let program = built.then(|| self.find()).flatten();
        program.ok_or_else(|| {
            Failure::new(format!("{} is not installed", self.name)).with_help(self.install())
        })
    }

    /// Builds it beside this program if this program is in the target folder of a checkout, as after `cargo run`.
    /// Returns whether it was built.
    ///
    /// # Errors
    /// If cargo fails.
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

    /// Returns advice with the command that installs it.
    pub fn install(&self) -> String {
        format!(
            "install it from wisch's source: cargo install --path crates/{} --locked",
            self.name
        )
    }

    /// Returns the profile folder, the target folder and the checkout that contain a program.
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
