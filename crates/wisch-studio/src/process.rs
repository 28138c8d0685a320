//! Processes of this machine, by their ids.

/// Longest name of a process that Linux reports [bytes].
#[cfg(target_os = "linux")]
const LONGEST_NAME: usize = 15;

/// Whether the process exists.
#[cfg(unix)]
pub fn is_alive(pid: u32) -> bool {
    pid_of(pid).is_some_and(|pid| {
        // A process that may not be signalled exists all the same.
        !matches!(
            rustix::process::test_kill_process(pid),
            Err(rustix::io::Errno::SRCH)
        )
    })
}

/// Asks a process to terminate.
#[cfg(unix)]
pub fn terminate(pid: u32) -> std::io::Result<()> {
    let pid = pid_of(pid).ok_or(std::io::ErrorKind::InvalidInput)?;
    Ok(rustix::process::kill_process(
        pid,
        rustix::process::Signal::TERM,
    )?)
}

#[cfg(unix)]
fn pid_of(pid: u32) -> Option<rustix::process::Pid> {
    rustix::process::Pid::from_raw(i32::try_from(pid).ok()?)
}

#[cfg(not(unix))]
pub fn is_alive(_: u32) -> bool {
    // Unknown on this system: a run counts as live until it has written its end.
    true
}

#[cfg(not(unix))]
pub fn terminate(_: u32) -> std::io::Result<()> {
    Err(std::io::ErrorKind::Unsupported.into())
}

/// Whether the process runs the program with this name.
#[cfg(target_os = "linux")]
pub fn is_called(pid: u32, name: &str) -> bool {
    let Ok(known) = std::fs::read(format!("/proc/{pid}/comm")) else {
        return false;
    };
    let known = known.strip_suffix(b"\n").unwrap_or(&known);
    known == &name.as_bytes()[..name.len().min(LONGEST_NAME)]
}

/// Whether the process runs the program with this name.
#[cfg(all(unix, not(target_os = "linux")))]
pub fn is_called(pid: u32, name: &str) -> bool {
    let mut ps = std::process::Command::new("ps");
    ps.args(["-o", "comm=", "-p", &pid.to_string()]);
    let known = ps.output().map(|output| output.stdout).unwrap_or_default();
    let known = String::from_utf8_lossy(&known);
    known.trim().rsplit('/').next() == Some(name)
}

#[cfg(not(unix))]
pub fn is_called(_: u32, _: &str) -> bool {
    true
}
