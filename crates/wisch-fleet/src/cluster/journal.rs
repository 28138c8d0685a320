//! Messages of scheduler and executors: warnings and errors on standard error, without credentials.

use log::{LevelFilter, Log, Metadata, Record};
use std::sync::{Mutex, OnceLock, PoisonError};

struct Journal {
    /// Secrets that no message may contain.
    secrets: Vec<String>,
    /// The last message: an executor whose scheduler is away repeats its message twenty times a second.
    last: Mutex<String>,
}

static JOURNAL: OnceLock<Journal> = OnceLock::new();

/// Starts to print messages.
pub(super) fn begin() {
    let journal = JOURNAL.get_or_init(|| Journal {
        secrets: crate::store::secrets(),
        last: Mutex::default(),
    });
    // An enclosing program may have installed another logger.
    if log::set_logger(journal).is_ok() {
        log::set_max_level(LevelFilter::Warn);
    }
}

impl Log for Journal {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        metadata.level() <= LevelFilter::Warn
    }

    fn log(&self, record: &Record<'_>) {
        if self.enabled(record.metadata()) {
            let text = without(&record.args().to_string(), &self.secrets);
            let text = format!("{}: {text}", record.level().as_str().to_lowercase());
            let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
            if *last != text {
                eprintln!("{text}");
                *last = text;
            }
        }
    }

    fn flush(&self) {}
}

fn without(text: &str, secrets: &[String]) -> String {
    let mut text = text.to_owned();
    for secret in secrets {
        text = text.replace(secret.as_str(), "…");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn secrets_are_not_printed() {
        let secrets = ["KEY".to_owned(), "SECRET".to_owned()];
        assert_eq!(without("a KEY, a SECRET", &secrets), "a …, a …");
    }
}
