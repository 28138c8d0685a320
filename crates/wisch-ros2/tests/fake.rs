//! A fake robot in another process, and a session that its executor serves.

use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::atomic::{AtomicBool, AtomicU16, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use wisch::follow::Workcell;
use wisch::interpret::WrenchQuality;
use wisch::represent::{Observation, Task};
use wisch::run::{
    Ending, Execution, Executor, ExecutorError, MotionOrder, Pause, RobotState, SampleSink, Stage,
};
use wisch_io::{LoadOptions, LoadedTask, PauseSwitch, ProcessExecutor, ProcessOptions, load_task};

pub const PROGRAM: &str = env!("CARGO_BIN_EXE_wisch-ros2");
/// Limits of age in these tests [ms]: a loaded computer delays messages.
pub const STATE_AGE_MS: f64 = 200.0;
/// Longest wait for something that takes a moment.
const PATIENCE: Duration = Duration::from_secs(60);

static IS_BUSY: AtomicBool = AtomicBool::new(false);
static DOMAIN: AtomicU16 = AtomicU16::new(0);

/// A line of the fake robot, with its time [s].
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    pub time: f64,
    pub text: String,
}

/// A shipped scenario with changed values.
pub struct Scenario {
    pub name: &'static str,
    pub settings: &'static [(&'static str, &'static str)],
}

/// Crumbs are collected on a small board, with touch alone.
pub const ARM_BOARD: Scenario = Scenario {
    name: "arm-board",
    settings: &[("perception.senses", "[\"touch\"]")],
};

/// A board is wiped by the arm instead of the humanoid.
pub const CHOPPING_BOARD: Scenario = Scenario {
    name: "chopping-board",
    settings: &[
        ("perception.senses", "[\"touch\"]"),
        ("robot.name", "\"arm7\""),
        ("robot.position_m", "[0, -0.45, 0.75]"),
        ("robot.rpy_rad", "[0, 0, 1.5707963267948966]"),
    ],
};

/// Five scenarios for the arm: crumbs are collected twice, dust is wiped off, sand is absorbed, and a plate is polished.
pub const FIVE: [Scenario; 5] = [
    ARM_BOARD,
    CHOPPING_BOARD,
    Scenario {
        name: "dusting",
        settings: &[
            ("perception.senses", "[\"touch\"]"),
            ("robot.name", "\"arm7\""),
            ("robot.position_m", "[0, -0.45, 0.70]"),
            ("robot.rpy_rad", "[0, 0, 1.5707963267948966]"),
            ("surface.size_m", "[0.36, 0.24]"),
            ("tool.start_m", "[0, -0.2]"),
            ("particles.count", "60"),
        ],
    },
    Scenario {
        name: "vacuum-panel",
        settings: &[
            ("perception.senses", "[\"touch\"]"),
            ("robot.name", "\"arm7\""),
            ("robot.position_m", "[0, -0.45, 0.78]"),
            ("robot.rpy_rad", "[0, 0, 1.5707963267948966]"),
            ("surface.size_m", "[0.36, 0.24]"),
            ("tool.start_m", "[0, -0.2]"),
            ("particles.count", "60"),
        ],
    },
    Scenario {
        name: "polish-plate",
        settings: &[
            ("perception.senses", "[\"touch\"]"),
            ("robot.name", "\"arm7\""),
            ("robot.position_m", "[0, -0.45, 0.78]"),
            ("robot.rpy_rad", "[0, 0, 1.5707963267948966]"),
            ("surface.size_m", "[0.3, 0.2]"),
            ("particles.count", "600"),
        ],
    },
];

/// The right to run a fake robot: one at a time, from any thread.
struct Turn;

impl Turn {
    fn take() -> Self {
        while IS_BUSY.swap(true, Ordering::SeqCst) {
            std::thread::sleep(Duration::from_millis(20));
        }
        Self
    }
}

impl Drop for Turn {
    fn drop(&mut self) {
        IS_BUSY.store(false, Ordering::SeqCst);
    }
}

/// A running fake robot with its robot file, which is commissioned.
pub struct FakeRobot {
    pub robot_file: PathBuf,
    child: Child,
    commands: ChildStdin,
    events: Arc<Mutex<Vec<Event>>>,
    folder: Option<tempfile::TempDir>,
    turn: Option<Turn>,
}

/// The text of a robot file for the fake `arm7`.
pub fn robot_file(domain: u16) -> String {
    format!(
        "schema = 1\nurdf = \"arm7\"\n\
         [link]\ndomain = {domain}\ninterfaces = [\"127.0.0.1\"]\n\
         [motion]\naction = \"/jtc/follow_joint_trajectory\"\ncontrollers = [\"jtc\", \"force_mode_controller\"]\n\
         progress = \"/jtc/controller_state\"\nscaling = \"/speed_scaling\"\n\
         [force]\nkind = \"ur_force_mode\"\ntopic = \"/ft_data\"\ntare = \"/zero_ftsensor\"\n\
         [limits]\nstate_age_ms = {STATE_AGE_MS}\nwrench_age_ms = {STATE_AGE_MS}\ntool_speed_m_s = 1.5\nlag_m = 0.08\n\
         [stop]\nsafety = \"/safety_mode\"\nprogram = \"/program_running\"\n"
    )
}

impl FakeRobot {
    /// Starts a fake robot for the scenario arm-board. `change`: changes its robot file.
    pub fn start(change: impl FnOnce(String) -> String) -> Self {
        Self::start_for(&ARM_BOARD, change)
    }

    /// Starts a fake robot for a scenario.
    pub fn start_for(scenario: &Scenario, change: impl FnOnce(String) -> String) -> Self {
        let turn = Turn::take();
        let folder = tempfile::tempdir().unwrap();
        let robot = folder.path().join("robot.toml");
        let number = DOMAIN.fetch_add(1, Ordering::SeqCst);
        let domain = 100 + (std::process::id() as u16 % 11) * 9 + number % 9;
        std::fs::write(&robot, change(robot_file(domain))).unwrap();
        let fake = Self::spawn(scenario, robot, Some(folder), Some(turn));
        fake.wait_for("ready", 0);
        fake
    }

    /// Starts another robot that sends its joint states on the topic of this one, and has services and an action of its own.
    /// It is silent at first.
    pub fn start_second(&self) -> Self {
        let file = std::fs::read_to_string(&self.robot_file).unwrap();
        let file = file
            .replace("ur_force_mode", "none")
            .replace("\"/", "\"/second/")
            .replace("[motion]", "[motion]\njoint_states = \"/joint_states\"");
        let path = self.robot_file.with_file_name("second.toml");
        let manager = "[motion]\ncontroller_manager = \"/second/controller_manager\"";
        std::fs::write(&path, file.replace("[motion]", manager)).unwrap();
        let mut second = Self::spawn(&ARM_BOARD, path, None, None);
        second.command("silence joints");
        second.wait_for("ready", 0);
        second
    }

    fn spawn(
        scenario: &Scenario,
        robot: PathBuf,
        folder: Option<tempfile::TempDir>,
        turn: Option<Turn>,
    ) -> Self {
        let settings = scenario.settings.iter();
        let settings =
            settings.flat_map(|(key, value)| ["--set".to_owned(), format!("{key}={value}")]);
        let mut child = Command::new(PROGRAM)
            .args(["fake", scenario.name, "--as"])
            .arg(&robot)
            .args(settings)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let events = Arc::new(Mutex::new(Vec::new()));
        let lines = BufReader::new(child.stdout.take().unwrap()).lines();
        let into = Arc::clone(&events);
        std::thread::spawn(move || {
            for line in lines.map_while(Result::ok) {
                if let Some((time, text)) = line.split_once(' ')
                    && let Ok(time) = time.parse()
                {
                    let text = text.to_owned();
                    into.lock().unwrap().push(Event { time, text });
                }
            }
        });
        let commands = child.stdin.take().unwrap();
        Self {
            robot_file: robot,
            child,
            commands,
            events,
            folder,
            turn,
        }
    }

    /// Ends this robot of the scenario arm-board, and starts another with its commissioned robot file, in the ready posture.
    pub fn restart(mut self) -> Self {
        self.kill();
        let (folder, turn) = (self.folder.take(), self.turn.take());
        let fake = Self::spawn(&ARM_BOARD, self.robot_file.clone(), folder, turn);
        fake.wait_for("ready", 0);
        fake
    }

    /// Starts a fake robot for the scenario arm-board, and commissions it with pushes.
    pub fn commissioned(change: impl FnOnce(String) -> String) -> Self {
        Self::commissioned_for(&ARM_BOARD, change)
    }

    /// Starts a fake robot for a scenario, and commissions it with pushes.
    pub fn commissioned_for(scenario: &Scenario, change: impl FnOnce(String) -> String) -> Self {
        let mut fake = Self::start_for(scenario, change);
        let (status, text) = fake.push_test([0.0, 0.0, -20.0]);
        assert!(status, "{text}");
        fake
    }

    /// Runs the push test; `down` is the force of the first push in the axes of the world [N].
    pub fn push_test(&mut self, down: [f64; 3]) -> (bool, String) {
        let child = Command::new(PROGRAM)
            .arg("push-test")
            .arg(&self.robot_file)
            .arg("--yes")
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        self.wait_for("tare", 0);
        std::thread::sleep(Duration::from_millis(2800));
        let [x, y, z] = down;
        self.command(&format!("push {x} {y} {z} 2"));
        std::thread::sleep(Duration::from_millis(3000));
        // The robot of arm-board is turned by a quarter: its x axis is the y axis of the world.
        self.command("push 0 20 0 2");
        let output = child.wait_with_output().unwrap();
        let text = [output.stdout, output.stderr].concat();
        (
            output.status.success(),
            String::from_utf8_lossy(&text).into_owned(),
        )
    }

    pub fn command(&mut self, line: &str) {
        writeln!(self.commands, "{line}").unwrap();
    }

    pub fn events(&self) -> Vec<Event> {
        self.events.lock().unwrap().clone()
    }

    /// Waits for an event that begins with a text, and returns it. `after`: number of earlier events that are skipped.
    pub fn wait_for(&self, text: &str, after: usize) -> Event {
        let begin = Instant::now();
        loop {
            let events = self.events();
            let found = events
                .iter()
                .skip(after)
                .find(|event| event.text.starts_with(text));
            if let Some(event) = found {
                return event.clone();
            }
            assert!(begin.elapsed() < PATIENCE, "no {text:?} in {events:#?}");
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// Ends the process without notice.
    pub fn kill(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }

    /// Starts the executor.
    pub fn executor(&self) -> Result<Recorded, ExecutorError> {
        start_executor(&self.robot_file, &[])
    }
}

impl Drop for FakeRobot {
    fn drop(&mut self) {
        self.kill();
    }
}

/// Starts the executor for a robot file, with further options.
pub fn start_executor(robot_file: &Path, options: &[&str]) -> Result<Recorded, ExecutorError> {
    let mut words = vec!["execute".to_owned(), robot_file.display().to_string()];
    words.extend(options.iter().map(|option| (*option).to_owned()));
    let stop = Arc::new(AtomicBool::new(false));
    let pause = Arc::new(PauseSwitch::default());
    let settings = ProcessOptions {
        stop: Arc::clone(&stop),
        pause: Arc::clone(&pause),
        ..ProcessOptions::default()
    };
    let process = ProcessExecutor::start_with(PROGRAM, &words, settings)?;
    Ok(Recorded {
        process,
        stop,
        pause,
        pauses: Vec::new(),
        endings: Vec::new(),
        error: None,
        qualities: Vec::new(),
    })
}

/// An executor whose endings are kept.
pub struct Recorded {
    process: ProcessExecutor,
    /// Stops the motion when it is set.
    pub stop: Arc<AtomicBool>,
    /// Pauses the motion and lets it continue.
    pub pause: Arc<PauseSwitch>,
    pub pauses: Vec<Pause>,
    pub endings: Vec<Ending>,
    pub error: Option<String>,
    /// Quality of the force of each sample.
    pub qualities: Vec<WrenchQuality>,
}

impl Executor for Recorded {
    fn prepare(&mut self, cell: &Workcell) -> Result<(), ExecutorError> {
        let prepared = self.process.prepare(cell);
        if let Err(error) = &prepared {
            self.error = Some(error.to_string());
        }
        prepared
    }

    fn finish(&mut self) -> Result<(), ExecutorError> {
        self.process.finish()
    }

    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        let qualities = &mut self.qualities;
        let execution = self.process.execute(order, &mut |sample| {
            qualities.push(sample.status.wrench);
            sink(sample)
        });
        match &execution {
            Ok(execution) => {
                self.pauses.extend(execution.pauses.iter().cloned());
                self.endings.push(execution.ending.clone());
            }
            Err(error) => self.error = Some(error.to_string()),
        }
        execution
    }

    fn state(&mut self) -> Result<Option<RobotState>, ExecutorError> {
        let state = self.process.state();
        if let Err(error) = &state {
            self.error = Some(error.to_string());
        }
        state
    }

    fn observe(&mut self, task: &Task) -> Result<Option<Observation>, ExecutorError> {
        self.process.observe(task)
    }
}

/// The task of a scenario.
pub fn task(scenario: &Scenario) -> LoadedTask {
    let settings = scenario.settings.iter();
    let options = LoadOptions {
        settings: settings
            .map(|(key, value)| ((*key).to_owned(), (*value).to_owned()))
            .collect(),
        ..LoadOptions::default()
    };
    load_task(scenario.name.as_ref(), &options).unwrap()
}

/// Executes the first round of arm-board. Returns how it ended, or the executor's error.
pub fn execute_round(executor: &mut Recorded) -> Result<Ending, String> {
    let loaded = task(&ARM_BOARD);
    let robot = loaded.robot().unwrap().unwrap();
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let run = session.run_until(Stage::Executed, executor, &mut |_| {
        std::ops::ControlFlow::Continue(())
    });
    match (executor.endings.pop(), executor.error.take(), run) {
        (_, Some(error), _) => Err(error),
        (Some(ending), ..) => Ok(ending),
        (None, None, run) => Err(format!("{run:?}")),
    }
}
