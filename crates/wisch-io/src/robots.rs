//! Shipped robots, and robots of the user.

use crate::assets::{self, read_text};
use crate::digest::InputDigest;
use crate::error::Error;
use crate::task_file::RobotDescription;
use include_dir::{Dir, include_dir};
use std::path::{Path, PathBuf};
use wisch::follow::{PlanningGroup, StartAssumption};
use wisch::robot::{
    ASSUMED_BASE_LIMITS, ASSUMED_DENSITY, ASSUMED_SLIDE_RATES, ASSUMED_TURN_RATES, Appearance,
    CapabilityMap, Diagnostic, DiagnosticKind, Joint, JointKind, LinkId, MapError, RobotHash,
    RobotModel, Severity, Srdf, Subject, VirtualJoint, urdf_on_base,
};
use wisch::run::RobotSetup;
use wisch::source_location::UnknownName;

/// The robots folder at the time of the build.
static BUILT_IN: Dir = include_dir!("$WISCH_SHIPPED/robots");

/// Most warnings about a robot's URDF, and about its SRDF, that are listed one by one.
const MOST_WARNINGS: usize = 10;

/// Extension of a capability map's file, beside its URDF.
pub const MAP_EXTENSION: &str = "reach";

/// A robot with its SRDF, capability map and files.
pub struct Robot {
    /// The model.
    pub model: RobotModel,
    /// SRDF: groups, states and pairs that may touch.
    pub srdf: Option<Srdf>,
    /// Capability map of the wiping group, if there is one.
    pub map: Option<CapabilityMap>,
    /// The files from which it was read.
    pub files: RobotFiles,
    /// Links whose masses are assumed.
    massless: Vec<LinkId>,
    /// Path of its URDF, and its packages; `None` for a shipped robot.
    source: Option<(PathBuf, Packages)>,
}

/// Names of ROS packages with their folders.
type Packages = Vec<(String, PathBuf)>;

/// The contents of a robot's files, from which it can be read again later.
#[derive(Debug, Clone, Default)]
pub struct RobotFiles {
    /// The URDF, with the joint of a mobile base that the SRDF declares.
    pub urdf: String,
    /// The SRDF, if it exists.
    pub srdf: Option<String>,
    /// The collision meshes, under the names that the URDF gives them.
    pub meshes: Vec<(String, Vec<u8>)>,
    /// The capability map's file, if there is one.
    pub map: Option<Vec<u8>>,
}

impl RobotFiles {
    /// Adds all files to a digest.
    pub fn add_to(&self, inputs: &mut InputDigest) {
        inputs.add("urdf", &self.urdf);
        inputs.add("srdf", self.srdf.as_deref().unwrap_or_default());
        for (name, mesh) in &self.meshes {
            inputs.add(name, mesh);
        }
        inputs.add("map", self.map.as_deref().unwrap_or_default());
    }
}

impl Robot {
    /// Returns the robot in the form for a session.
    pub const fn robot_setup(&self) -> RobotSetup<'_> {
        RobotSetup {
            robot: &self.model,
            srdf: self.srdf.as_ref(),
            map: self.map.as_ref(),
        }
    }

    /// Path of the URDF from which it was read; `None` for a shipped robot.
    pub fn urdf_file(&self) -> Option<&Path> {
        self.source.as_ref().map(|(path, _)| path.as_path())
    }

    /// Returns warnings about the robot and its SRDF, one sentence each, as [`robot_warnings`] does.
    pub fn warnings(&self) -> Vec<String> {
        let passed_over = self.srdf.iter().flat_map(|srdf| &srdf.passed_over);
        let of_srdf = passed_over.filter(|found| found.severity == Severity::Warning);
        let mut warnings = robot_warnings(&self.model);
        warnings.extend(list_warnings(&self.model, of_srdf));
        warnings
    }

    /// Returns remarks on the robot, one sentence each: [`Self::warnings`] and assumptions.
    ///
    /// ```
    /// # let urdf = concat!(env!("CARGO_MANIFEST_DIR"), "/../../robots/arm7.urdf");
    /// assert!(wisch_io::Robot::load(urdf)?.remarks().is_empty());
    /// # Ok::<(), wisch_io::Error>(())
    /// ```
    pub fn remarks(&self) -> Vec<String> {
        let mut remarks = self.warnings();
        if self.files.map.is_some() && self.map.is_none() {
            remarks.push(format!(
                "robot {:?}: the capability map beside its URDF reaches nothing, so it is not used",
                self.model.name()
            ));
        }
        let model = &self.model;
        let rates = [
            (JointKind::Revolute, "rad", ASSUMED_TURN_RATES),
            (JointKind::Prismatic, "m", ASSUMED_SLIDE_RATES),
        ];
        for (kind, unit, [velocity, acceleration]) in rates {
            for (what, unit, assumed) in [
                ("velocity", format!("{unit}/s"), velocity),
                ("acceleration", format!("{unit}/s2"), acceleration),
            ] {
                let joints: Vec<&str> = (0..model.dof())
                    .map(|i| model.variable(i))
                    .filter(|joint| joint.kind == kind)
                    .filter(|joint| match what {
                        "velocity" => joint.limits.velocity.is_none(),
                        _ => joint.limits.acceleration.is_none(),
                    })
                    .map(|joint| joint.name.as_str())
                    .collect();
                if !joints.is_empty() {
                    remarks.push(format!(
                        "robot {:?}: its URDF has no {what} limit for {}: {assumed} {unit} is assumed",
                        model.name(),
                        joints.join(", ")
                    ));
                }
            }
        }
        let is_unlimited = |joint: &&Joint| joint.limits.effort.is_none();
        let unlimited: Vec<&str> = (0..model.dof())
            .map(|i| model.variable(i))
            .filter(is_unlimited)
            .map(|joint| joint.name.as_str())
            .collect();
        if !unlimited.is_empty() {
            remarks.push(format!(
                "robot {:?}: its URDF has no effort limit for {}: wisch does not check their efforts",
                model.name(),
                unlimited.join(", ")
            ));
        }
        if !self.massless.is_empty() {
            let names: Vec<&str> = (self.massless.iter())
                .map(|link| model.links()[link.index()].name.as_str())
                .collect();
            remarks.push(format!(
                "robot {:?}: its URDF has no masses for {}: {ASSUMED_DENSITY} kg/m3 in the box around their shapes is assumed",
                model.name(),
                names.join(", ")
            ));
        }
        let bases = self.srdf.iter().flat_map(|srdf| &srdf.virtual_joints);
        let drives = |base: &&VirtualJoint| model.joint(&format!("{}/x", base.name)).is_ok();
        for base in bases.filter(drives) {
            let [velocity, acceleration, _] = ASSUMED_BASE_LIMITS;
            remarks.push(format!(
                "robot {:?}: the virtual joint {:?} of the SRDF makes its base mobile: {velocity} m/s and rad/s, {acceleration} m/s2 and rad/s2 are assumed",
                model.name(),
                base.name
            ));
        }
        let counterbalanced = self.srdf.iter().flat_map(|srdf| &srdf.counterbalanced);
        let counterbalanced: Vec<&str> = counterbalanced
            .map(|joint| model.joints()[joint.index()].name.as_str())
            .collect();
        if !counterbalanced.is_empty() {
            remarks.push(format!(
                "robot {:?}: its SRDF says that springs or weights carry {}: efforts of these joints are not checked",
                model.name(),
                counterbalanced.join(", ")
            ));
        }
        remarks.extend(describe_assumed_chain(model, self.srdf.as_ref()));
        if let Some(StartAssumption { lacks, begins }) =
            StartAssumption::find(model, self.srdf.as_ref())
        {
            remarks.push(format!(
                "robot {:?}: {lacks}: motions begin {begins}",
                model.name()
            ));
        }
        remarks
    }

    /// Reads the robot's visual geometry from its present files.
    ///
    /// # Errors
    /// If the URDF has become invalid since the robot was read.
    pub fn appearance(&self) -> Result<Appearance, Error> {
        let urdf = &self.files.urdf;
        match &self.source {
            None => {
                let name = format!("built-in {}", self.model.name());
                Appearance::from_urdf(&name, urdf, &self.model, &mut no_meshes).map_err(Error::from)
            }
            Some((path, packages)) => {
                let name = path.display().to_string();
                let mut meshes = robot_meshes(path, packages);
                Appearance::from_urdf(&name, urdf, &self.model, &mut meshes).map_err(|error| {
                    Error::Urdf {
                        file: name.clone(),
                        error: Box::new(error),
                    }
                })
            }
        }
    }

    /// Reads a shipped robot by its name, or a URDF by its path with the SRDF and capability map beside it.
    ///
    /// ```
    /// # let urdf = concat!(env!("CARGO_MANIFEST_DIR"), "/../../robots/arm7.urdf");
    /// let robot = wisch_io::Robot::load(urdf)?;
    /// assert_eq!(robot.model.dof(), wisch_io::Robot::load("arm7")?.model.dof());
    /// # Ok::<(), wisch_io::Error>(())
    /// ```
    ///
    /// # Errors
    /// If the name is unknown, or a file cannot be read or is invalid.
    pub fn load(robot: &str) -> Result<Self, Error> {
        Self::read(&Self::description(robot), Path::new(""), None, &[])
    }

    /// Reads a robot. `task_file`: file to whose folder paths of the description are relative.
    /// `map_file`: the user's capability map. `packages`: names of ROS packages with their folders.
    ///
    /// # Errors
    /// If the name is unknown, or a file cannot be read or is invalid.
    pub fn read(
        description: &RobotDescription,
        task_file: &Path,
        map_file: Option<&Path>,
        packages: &[(String, PathBuf)],
    ) -> Result<Self, Error> {
        let mut robot = Self::read_without_map(description, task_file, packages)?;
        let found = match (map_file, description) {
            (Some(path), _) => Some((path.display().to_string(), assets::read(path)?)),
            (None, RobotDescription::Named(name)) => {
                let file = BUILT_IN.get_file(format!("{name}.{MAP_EXTENSION}"));
                file.map(|file| (format!("built-in {name}"), file.contents().to_vec()))
            }
            (None, RobotDescription::Files { urdf, .. }) => {
                let path = folder(task_file).join(urdf).with_extension(MAP_EXTENSION);
                let name = path.display().to_string();
                let is_there = path.is_file();
                is_there
                    .then(|| assets::read(&path))
                    .transpose()?
                    .map(|bytes| (name, bytes))
            }
        };
        if let Some((name, bytes)) = found {
            let hash = RobotHash::from_robot(&robot.model);
            robot.map = match CapabilityMap::from_bytes(&name, &bytes, hash) {
                // A map that the user did not name is optional.
                Err(MapError::ReachesNothing { .. }) if map_file.is_none() => None,
                map => Some(map?),
            };
            robot.files.map = Some(bytes);
        }
        Ok(robot)
    }

    /// Reads a robot without a capability map; the parameters are those of [`Self::read`].
    ///
    /// # Errors
    /// If the name is unknown, or a file cannot be read or is invalid.
    pub fn read_without_map(
        description: &RobotDescription,
        task_file: &Path,
        packages: &[(String, PathBuf)],
    ) -> Result<Self, Error> {
        match description {
            RobotDescription::Named(name) => built_in(name),
            RobotDescription::Files {
                urdf,
                srdf,
                packages: of_task,
            } => {
                let folder = folder(task_file);
                let srdf = srdf.as_ref().map(|srdf| folder.join(srdf));
                let of_task = of_task
                    .iter()
                    .map(|(name, at)| (name.clone(), folder.join(at)));
                let packages: Packages = packages.iter().cloned().chain(of_task).collect();
                files(&folder.join(urdf), srdf.as_deref(), &packages)
            }
        }
    }

    /// Interprets a word of the command line as the name of a shipped robot, or as the path of a URDF.
    pub fn description(text: &str) -> RobotDescription {
        if shipped_robots().any(|name| name == text) || !text.contains(['.', '/', '\\']) {
            return RobotDescription::Named(text.to_owned());
        }
        // Paths on the command line are relative to the working directory, not to the task file.
        let path = std::path::absolute(text).unwrap_or_else(|_| PathBuf::from(text));
        RobotDescription::Files {
            urdf: path.display().to_string(),
            srdf: None,
            packages: Vec::new(),
        }
    }
}

/// Returns the names of the shipped robots.
pub fn shipped_robots() -> impl Iterator<Item = &'static str> {
    BUILT_IN.files().filter_map(|file| {
        let path = file.path();
        let is_urdf = path.extension().is_some_and(|e| e == "urdf");
        path.file_stem().filter(|_| is_urdf)?.to_str()
    })
}

/// Returns warnings about a robot, one sentence each: what was not read as written, was left out,
/// or probably has a wrong unit. One sentence covers all meshes of collision shapes that cannot be
/// read.
///
/// ```
/// # let urdf = concat!(env!("CARGO_MANIFEST_DIR"), "/../../robots/arm7.urdf");
/// assert!(wisch_io::robot_warnings(&wisch_io::Robot::load(urdf)?.model).is_empty());
/// # Ok::<(), wisch_io::Error>(())
/// ```
pub fn robot_warnings(robot: &RobotModel) -> Vec<String> {
    let is_told = |found: &&Diagnostic| match found.kind {
        DiagnosticKind::Units | DiagnosticKind::MeshScale => true,
        DiagnosticKind::JointType
        | DiagnosticKind::CollisionMissing
        | DiagnosticKind::Limit
        | DiagnosticKind::Mimic
        | DiagnosticKind::UnknownName
        | DiagnosticKind::Syntax => found.severity == Severity::Warning,
        _ => false,
    };
    let mut warnings = list_warnings(robot, robot.diagnostics().iter().filter(is_told));
    warnings.extend(describe_unread_meshes(robot));
    warnings
}

/// Returns the findings as text, up to a number.
fn list_warnings<'a>(
    robot: &RobotModel,
    found: impl Iterator<Item = &'a Diagnostic>,
) -> Vec<String> {
    let mut all: Vec<String> = found.map(Diagnostic::to_string).collect();
    if let more @ 1.. = all.len().saturating_sub(MOST_WARNINGS) {
        all.truncate(MOST_WARNINGS);
        all.push(format!(
            "robot {:?}: {more} more warnings, which wisch robot check lists",
            robot.name()
        ));
    }
    all
}

/// Returns the remark on the chain that wipes although the robot has no group; `None` if it has one.
fn describe_assumed_chain(robot: &RobotModel, srdf: Option<&Srdf>) -> Option<String> {
    let lacks = match srdf {
        None => "it has no SRDF, and so no group",
        Some(srdf) if srdf.groups.is_empty() => "its SRDF has no group that is a chain",
        Some(_) => return None,
    };
    let group = PlanningGroup::choose(robot, srdf, None).ok()?;
    let [base, tip] = [group.base, group.tip].map(|link| &robot.links()[link.index()].name);
    Some(format!(
        "robot {:?}: {lacks}: it wipes with the chain from {base:?} to {tip:?}",
        robot.name()
    ))
}

/// Describes the meshes of collision shapes that cannot be read.
fn describe_unread_meshes(robot: &RobotModel) -> Option<String> {
    let is_unread = |found: &&Diagnostic| found.kind == DiagnosticKind::Mesh;
    let first = robot.diagnostics().iter().find(is_unread)?;
    let unread = robot.diagnostics().iter().filter(is_unread);
    let mut links: Vec<&str> = unread
        .filter_map(|found| match &found.subject {
            Subject::Link(link) => Some(link.as_str()),
            _ => None,
        })
        .collect();
    links.dedup();
    Some(format!(
        "robot {:?}: collision meshes of {} cannot be read, and are not checked for collisions: {}",
        robot.name(),
        links.join(", "),
        first.value
    ))
}

fn built_in(name: &str) -> Result<Robot, Error> {
    let text = |extension: &str| {
        let file = BUILT_IN.get_file(format!("{name}.{extension}"))?;
        let text = file.contents_utf8()?.to_owned();
        Some((format!("built-in {name}.{extension}"), text))
    };
    let (urdf_name, urdf) = text("urdf")
        .ok_or_else(|| Error::UnknownRobot(UnknownName::new("robot", name, shipped_robots())))?;
    let srdf = text("srdf");
    let urdf = on_base(urdf, srdf.as_ref());
    let model = RobotModel::from_urdf(&urdf_name, &urdf, &mut no_meshes)?;
    robot(model, urdf, srdf, Vec::new(), None)
}

fn no_meshes(file: &str) -> Result<Vec<u8>, String> {
    Err(format!("{file}: built-in robots have no meshes"))
}

fn files(urdf: &Path, srdf: Option<&Path>, packages: &[(String, PathBuf)]) -> Result<Robot, Error> {
    let beside_urdf = urdf.with_extension("srdf");
    let srdf = match srdf {
        Some(path) => Some(path),
        None => beside_urdf.is_file().then_some(beside_urdf.as_path()),
    };
    let srdf = srdf.map(|path| Ok::<_, Error>((path.display().to_string(), read_text(path)?)));
    let srdf = srdf.transpose()?;
    let text = on_base(read_text(urdf)?, srdf.as_ref());
    let name = urdf.display().to_string();
    let mut read = robot_meshes(urdf, packages);
    let mut found = Vec::new();
    let mut keep = |file: &str| {
        let bytes = read(file)?;
        found.push((file.to_owned(), bytes.clone()));
        Ok(bytes)
    };
    let model = RobotModel::from_urdf(&name, &text, &mut keep).map_err(|error| Error::Urdf {
        file: name,
        error: Box::new(error),
    })?;
    let source = Some((urdf.to_owned(), packages.to_vec()));
    robot(model, text, srdf, found, source)
}

/// Returns a URDF with the joint of a mobile base that its SRDF declares. `srdf`: name and text.
fn on_base(urdf: String, srdf: Option<&(String, String)>) -> String {
    match srdf {
        Some((_, srdf)) => urdf_on_base(&urdf, srdf),
        None => urdf,
    }
}

/// Makes a robot without a map. `srdf`: name and text of its SRDF.
fn robot(
    mut model: RobotModel,
    urdf: String,
    srdf: Option<(String, String)>,
    meshes: Vec<(String, Vec<u8>)>,
    source: Option<(PathBuf, Packages)>,
) -> Result<Robot, Error> {
    let massless = model.assume_masses();
    let parsed = (srdf.as_ref()).map(|(name, text)| Srdf::parse(name, text, &model));
    Ok(Robot {
        srdf: parsed.transpose()?,
        model,
        map: None,
        files: RobotFiles {
            urdf,
            srdf: srdf.map(|(_, text)| text),
            meshes,
            map: None,
        },
        massless,
        source,
    })
}

fn folder(task_file: &Path) -> &Path {
    task_file.parent().unwrap_or(Path::new(""))
}

/// Returns a reader for the files of a URDF; paths are relative to its folder, and `packages` resolves package URLs.
pub fn robot_meshes(
    urdf: &Path,
    packages: &[(String, PathBuf)],
) -> impl FnMut(&str) -> Result<Vec<u8>, String> {
    let beside = urdf.parent().map(Path::to_path_buf).unwrap_or_default();
    let place = urdf.to_owned();
    move |path| {
        let Some(in_package) = path.strip_prefix("package://") else {
            let path = path.strip_prefix("file://").unwrap_or(path);
            return read_mesh(&beside.join(path), "there is no such file");
        };
        // "package:///name/…" is written, too.
        let in_package = in_package.trim_start_matches('/');
        let (name, rest) = in_package.split_once('/').unwrap_or((in_package, ""));
        let known = packages.iter().find(|(known, _)| known == name);
        let folder = known
            .map(|(_, folder)| folder.clone())
            .or_else(|| find_package(name, rest, &place))
            .ok_or_else(|| format!("the package {name} is unknown; add --package {name}=DIR"))?;
        let is_missing = format!("the folder {} has no such file", folder.display());
        read_mesh(&folder.join(rest), &is_missing)
    }
}

/// Reads a mesh. The path of a missing file is not part of the error, so that errors about several meshes are alike.
fn read_mesh(path: &Path, is_missing: &str) -> Result<Vec<u8>, String> {
    assets::read(path).map_err(|error| match error {
        Error::NoSuchFile { nearest, .. } => {
            match nearest.filter(|name| is_in_other_case(name, path)) {
                None => is_missing.to_owned(),
                Some(nearest) => format!("{is_missing}; did you mean {nearest}?"),
            }
        }
        error => error.to_string(),
    })
}

/// Whether a file name is that of a path in upper or lower case. Meshes of other links have similar names, too.
fn is_in_other_case(name: &str, path: &Path) -> bool {
    let own = path.file_name().and_then(|own| own.to_str());
    own.is_some_and(|own| own.eq_ignore_ascii_case(name))
}

/// Finds the folder of a ROS package: in `ROS_PACKAGE_PATH`, in `AMENT_PREFIX_PATH`, or among the folders above a URDF and
/// beside these. A folder above the URDF in which the file is found counts under any name, as a copy of a package may be
/// renamed.
fn find_package(name: &str, file: &str, urdf: &Path) -> Option<PathBuf> {
    if name.is_empty() || [".", ".."].contains(&name) {
        return None;
    }
    let paths = |variable: &str| -> Vec<PathBuf> {
        let value = std::env::var_os(variable).unwrap_or_default();
        // An unset variable has one empty path, which would be the working directory.
        std::env::split_paths(&value)
            .filter(|path| !path.as_os_str().is_empty())
            .collect()
    };
    let is_named = |folder: &Path| folder.file_name().is_some_and(|own| own == name);
    let is_package = |folder: &PathBuf| folder.join("package.xml").is_file();
    let holds_file = |folder: &Path| !file.is_empty() && folder.join(file).is_file();
    let ros = paths("ROS_PACKAGE_PATH").into_iter().flat_map(|folder| {
        let inside = folder.join(name);
        [Some(folder).filter(|folder| is_named(folder)), Some(inside)]
    });
    let ament = paths("AMENT_PREFIX_PATH").into_iter();
    let declared = ros
        .flatten()
        .chain(ament.map(|prefix| prefix.join("share").join(name)));
    let whole = std::path::absolute(urdf).ok()?;
    let above = whole.ancestors().skip(1).map(Path::to_path_buf);
    let mut near = above.flat_map(|folder| {
        let beside = Some(folder.join(name));
        let beside = beside.filter(|beside| is_package(beside) || holds_file(beside));
        [Some(folder).filter(|folder| is_named(folder)), beside]
    });
    declared
        .into_iter()
        .find(|folder| folder.is_dir())
        .or_else(|| near.find_map(|folder| folder.filter(|folder| folder.is_dir())))
        .or_else(|| {
            let mut above = whole.ancestors().skip(1);
            above
                .find(|folder| holds_file(folder))
                .map(Path::to_path_buf)
        })
}
