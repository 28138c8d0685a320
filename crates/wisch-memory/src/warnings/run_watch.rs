//! The watch over a run, from the search of comparable episodes to the warnings.

use super::bands::BandError;
use super::basis::WarningBasis;
use super::watch::MemoryWatch;
use crate::MemoryError;
use wisch::run::{OnWarning, RunConfig, RunEvent, WarningWatch};

/// Returns a watch for [`Session::with_warnings`](wisch::run::Session::with_warnings), with the rate of false warnings of a
/// configuration.
///
/// `search` finds the comparable episodes, as [`find_basis`](super::find_basis) does; it is called before the first motion is
/// executed. `note` receives a sentence if there are no warnings, or if comparable episodes cannot be read. An empty memory
/// gives no note if the task only wants reports.
pub fn watch_run<'a>(
    search: impl FnOnce() -> Result<WarningBasis, MemoryError> + Send + Sync + 'a,
    config: &RunConfig,
    mut note: impl FnMut(&str) + Send + Sync + 'a,
) -> WarningWatch<'a> {
    let (rate, needs_memory) = (
        config.false_warning_rate,
        config.on_warning != OnWarning::Report,
    );
    let mut search = Some(search);
    let mut watch: Option<MemoryWatch> = None;
    WarningWatch::new(move |event| {
        if let RunEvent::Executing(planned) = event
            && let Some(search) = search.take()
        {
            let strategy = planned.plan.strategy.as_str();
            watch = begin_watch(search(), (strategy, rate), needs_memory, &mut note);
        }
        watch
            .as_mut()
            .map_or_else(Vec::new, |watch| watch.on_event(event))
    })
}

/// Begins the watch; without enough episodes, notes that.
fn begin_watch(
    basis: Result<WarningBasis, MemoryError>,
    (strategy, rate): (&str, f64),
    needs_memory: bool,
    note: &mut dyn FnMut(&str),
) -> Option<MemoryWatch> {
    let basis = match basis {
        Ok(basis) => basis,
        Err(error) => {
            note(&format!("no warnings while wiping: {error}"));
            return None;
        }
    };
    if basis.unreadable > 0 {
        note(&format!(
            "{} cannot be read and are left out of warnings",
            count_episodes(basis.unreadable)
        ));
    }
    match basis.fit_bands(strategy, rate) {
        Ok(bands) => return Some(MemoryWatch::new(bands)),
        Err(BandError::TooFew { found: 0, .. }) if !needs_memory => {}
        Err(BandError::TooFew { found, needed }) => note(&format!(
            "no warnings while wiping: {}, {needed} are needed",
            count_episodes(found)
        )),
        Err(error) => note(&format!("no warnings while wiping: {error}")),
    }
    None
}

fn count_episodes(count: usize) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} comparable episode{plural}")
}
