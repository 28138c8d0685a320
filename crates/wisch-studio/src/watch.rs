//! Detects changes of episodes and runs.

use crate::library::Library;
use crate::live::LiveFolder;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::watch;

/// Interval of checks.
const CHECK_INTERVAL: Duration = Duration::from_millis(700);

/// Counter that increases with every change, while there are listeners.
pub fn changes(library: Arc<Library>, live: LiveFolder) -> watch::Receiver<u64> {
    let (sender, receiver) = watch::channel(0);
    tokio::spawn(async move {
        let mut before = None;
        loop {
            tokio::time::sleep(CHECK_INTERVAL).await;
            // One receiver is kept for new listeners.
            if sender.receiver_count() < 2 {
                continue;
            }
            let (library, live) = (Arc::clone(&library), live.clone());
            let current = tokio::task::spawn_blocking(move || fingerprint(&library, &live)).await;
            let Ok(current) = current else { continue };
            if before.replace(current) != Some(current) {
                sender.send_modify(|count| *count += 1);
            }
        }
    });
    receiver
}

fn fingerprint(library: &Library, live: &LiveFolder) -> u64 {
    let mut hasher = DefaultHasher::new();
    // Episodes appear and disappear by renames in this folder, so its time of change suffices; listing 10^5 of them
    // would take long.
    let folder = std::fs::metadata(library.memory().folder());
    let changed = folder.and_then(|folder| folder.modified());
    changed.ok().hash(&mut hasher);
    for run in live.runs() {
        run.id.hash(&mut hasher);
        format!("{:?} {:?}", run.state, run.episode).hash(&mut hasher);
    }
    hasher.finish()
}
