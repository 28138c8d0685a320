//! The program `wisch-studio`, which `wisch studio` starts.

use std::process::ExitCode;
use std::time::Duration;
use wisch_studio::{Arguments, Studio, USAGE};

/// Longest wait at the end for work that cannot be interrupted, such as reading the memory.
const LAST_WORK: Duration = Duration::from_secs(2);

fn main() -> ExitCode {
    let arguments = match Arguments::parse(std::env::args_os().skip(1)) {
        Ok(Some(arguments)) => arguments,
        Ok(None) => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        Err(what) => return complain(&what),
    };
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .build();
    let worked = match runtime {
        Ok(runtime) => {
            let worked = runtime.block_on(work(&arguments));
            runtime.shutdown_timeout(LAST_WORK);
            worked
        }
        Err(error) => Err(error.to_string()),
    };
    match worked {
        Ok(()) => ExitCode::SUCCESS,
        Err(what) => complain(&what),
    }
}

async fn work(arguments: &Arguments) -> Result<(), String> {
    let end = listen_for_signals().map_err(|error| format!("signals: {error}"))?;
    let studio = Studio::begin(&arguments.config).await;
    let studio = studio.map_err(|error| error.to_string())?;
    if !arguments.config.host.is_loopback() {
        eprintln!(
            "warning: other machines can reach {}: everyone who knows an address below can start runs and read the \
             memory, and the connection is not encrypted. The first address is for this machine",
            arguments.config.host
        );
    }
    println!("{}", studio.url());
    for url in studio.urls_from_elsewhere() {
        println!("{url}");
    }
    if arguments.open
        && let Err(error) = studio.open_in_browser()
    {
        eprintln!("warning: the browser cannot be opened ({error}); open the address above");
    }
    studio.serve(end).await;
    Ok(())
}

/// Returns a future that completes at Ctrl-C, a termination signal or the end of the terminal. A second signal ends the
/// program at once. SIGHUP stays ignored if it was ignored when the program began, as by `nohup`; only Linux states that.
#[cfg(unix)]
fn listen_for_signals() -> std::io::Result<impl Future<Output = ()>> {
    use tokio::signal::unix::{SignalKind, signal};
    /// Exit code of a program that Ctrl-C ended.
    const EXIT_INTERRUPTED: i32 = 130;
    let mut interrupt = signal(SignalKind::interrupt())?;
    let mut terminate = signal(SignalKind::terminate())?;
    let mut hangup = if is_hangup_ignored() {
        None
    } else {
        Some(signal(SignalKind::hangup())?)
    };
    let (sender, receiver) = tokio::sync::oneshot::channel();
    tokio::spawn(async move {
        let ends = async {
            match &mut hangup {
                Some(hangup) => hangup.recv().await,
                None => std::future::pending().await,
            }
        };
        tokio::select! { _ = interrupt.recv() => {}, _ = terminate.recv() => {}, _ = ends => {} }
        let _ = sender.send(());
        tokio::select! { _ = interrupt.recv() => {}, _ = terminate.recv() => {} }
        std::process::exit(EXIT_INTERRUPTED);
    });
    Ok(async move {
        let _ = receiver.await;
    })
}

/// Whether the process ignores SIGHUP; `false` where the system does not state it.
#[cfg(unix)]
fn is_hangup_ignored() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status
        .lines()
        .find_map(|line| line.strip_prefix("SigIgn:"))
        .and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    // SIGHUP is signal 1, and bit 0 of the mask.
    mask.is_some_and(|mask| mask & 1 == 1)
}

#[cfg(not(unix))]
fn listen_for_signals() -> std::io::Result<impl Future<Output = ()>> {
    Ok(async {
        let _ = tokio::signal::ctrl_c().await;
    })
}

fn complain(what: &str) -> ExitCode {
    eprintln!("error: {what}");
    ExitCode::from(2)
}
