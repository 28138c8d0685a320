//! Notices when episodes or runs come and go.

use crate::library::Library;
use crate::live::LiveFolder;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::watch;

/// How often it is looked.
const LOOK_AGAIN: Duration = Duration::from_millis(700);

/// Counts up with every change, while anybody listens.
pub fn changes(library: Arc<Library>, live: LiveFolder) -> watch::Receiver<u64> {
    let (sender, receiver) = watch::channel(0);
    tokio::spawn(async move {
        let mut before = None;
        loop {
            tokio::time::sleep(LOOK_AGAIN).await;
            // One receiver is kept for those who come.
            if sender.receiver_count() < 2 {
                continue;
            }
            let (library, live) = (Arc::clone(&library), live.clone());
            let seen = tokio::task::spawn_blocking(move || fingerprint(&library, &live)).await;
            let Ok(seen) = seen else { continue };
            if before.replace(seen) != Some(seen) {
                sender.send_modify(|count| *count += 1);
            }
        }
    });
    receiver
}

fn fingerprint(library: &Library, live: &LiveFolder) -> u64 {
    let mut hasher = DefaultHasher::new();
    // Episodes come and go by renaming folders in this one; to list 10^5 of them takes its time.
    let folder = std::fs::metadata(library.memory().folder());
    let changed = folder.and_then(|folder| folder.modified());
    changed.ok().hash(&mut hasher);
    for run in live.runs() {
        run.id.hash(&mut hasher);
        format!("{:?} {:?}", run.state, run.episode).hash(&mut hasher);
    }
    hasher.finish()
}
