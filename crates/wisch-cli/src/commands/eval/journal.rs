//! The folder of an evaluation. It gets a line for each case as soon as the case is evaluated, so that a killed
//! evaluation can be resumed and several machines can share one.

use super::super::words::format_count;
use super::file_failure;
use crate::args::{GlobalArgs, JournalArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::remark;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// The cases of an evaluation, and the functions that evaluate and compare them.
pub struct Cases<'a, C, R> {
    /// Noun for a case: "world" or "run".
    pub noun: &'static str,
    /// All cases, each with a number whose remainder assigns it to a part.
    pub all: &'a [(u64, C)],
    /// Returns the case of a result.
    pub case_of: &'a dyn Fn(&R) -> C,
    /// Whether a result of the folder has the same setup as this evaluation.
    pub is_same: &'a dyn Fn(&R) -> bool,
    /// Names a case, such as `seed 17`.
    pub name: &'a dyn Fn(&C) -> String,
    /// Evaluates a case.
    pub evaluate: &'a (dyn Fn(&C) -> Result<R, Failure> + Sync),
}

/// The results of an evaluation so far.
pub struct Evaluated<R> {
    /// All results in the folder, also of other parts, in the order of the cases.
    pub all: Vec<R>,
    /// Number of cases that failed in this call.
    pub failed: usize,
}

impl<C: Ord + Clone + Sync, R: Serialize + DeserializeOwned + Send> Cases<'_, C, R> {
    /// Evaluates the cases of a part that are not yet in the folder.
    ///
    /// # Errors
    /// If the folder cannot be written, holds another evaluation, or holds this evaluation but `--resume` is missing.
    pub fn evaluate_part(
        &self,
        out: &Path,
        args: &JournalArgs,
        global: &GlobalArgs,
    ) -> Result<Evaluated<R>, Failure> {
        fs::create_dir_all(out).map_err(|error| file_failure(out, "write the folder", &error))?;
        let mut known = self.read_known(out, args.resume)?;
        let shard = args.shard;
        let open: Vec<&C> = (self.all.iter())
            .filter(|(number, _)| number % shard.count == shard.index - 1)
            .map(|(_, case)| case)
            .filter(|case| !known.contains_key(case))
            .collect();
        let name = format!("{}s-{shard}.jsonl", self.noun);
        let path = out.join(name);
        let file = begin_after_whole_lines(&path);
        let file = Mutex::new(file.map_err(|error| file_failure(&path, "write the file", &error))?);
        let evaluated = one_on_each_core(&open, self.noun, global, |case| {
            let result = (self.evaluate)(case)?;
            write_line(&file, &result)
                .map_err(|error| file_failure(&path, "write the file", &error))?;
            Ok(result)
        })?;
        let mut failed = 0;
        for result in evaluated {
            match result {
                Ok(result) => {
                    known.insert((self.case_of)(&result), result);
                }
                Err(failure) => {
                    failed += 1;
                    remark(&failure.to_string());
                }
            }
        }
        let all = self.all.iter().filter_map(|(_, case)| known.remove(case));
        Ok(Evaluated {
            all: all.collect(),
            failed,
        })
    }

    /// Reads the results in the folder, which must belong to this evaluation.
    fn read_known(&self, out: &Path, resume: bool) -> Result<BTreeMap<C, R>, Failure> {
        let known: BTreeMap<C, R> = (read_all(out, self.noun)?.into_iter())
            .map(|result| ((self.case_of)(&result), result))
            .collect();
        let asked: std::collections::BTreeSet<&C> = self.all.iter().map(|(_, case)| case).collect();
        let mut others = (known.iter())
            .filter(|(case, result)| !asked.contains(case) || !(self.is_same)(result));
        if let Some((other, _)) = others.next() {
            return Err(Failure::new(format!(
                "{}: the folder holds another evaluation, for example of {}",
                out.display(),
                (self.name)(other)
            ))
            .with_help(
                "choose another folder with --out; results of different evaluations are not mixed",
            ));
        }
        if !known.is_empty() && !resume {
            return Err(Failure::new(format!(
                "{}: the folder already holds {}",
                out.display(),
                format_count(known.len(), self.noun)
            ))
            .with_help("continue with --resume, or choose another folder with --out"));
        }
        Ok(known)
    }
}

/// Evaluates cases in parallel, each on a single core, so that computation times are comparable. Returns the results in
/// the order of the cases.
pub fn one_on_each_core<C: Sync, R: Send>(
    cases: &[C],
    noun: &str,
    global: &GlobalArgs,
    evaluate: impl Fn(&C) -> Result<R, Failure> + Sync,
) -> Result<Vec<Result<R, Failure>>, Failure> {
    let progress = Progress::start(global);
    let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let all = format_count(cases.len(), noun);
    progress.say(format!("0 of {all}"));
    let results = Mutex::new(BTreeMap::new());
    let work = || loop {
        let number = next.fetch_add(1, Ordering::Relaxed);
        let Some(case) = cases.get(number) else {
            return;
        };
        let result = evaluate(case);
        let mut results = results.lock().unwrap_or_else(PoisonError::into_inner);
        results.insert(number, result);
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        progress.say(format!("{done} of {all}"));
    };
    let cores = rayon::current_num_threads().min(cases.len());
    let pools = (0..cores).map(|_| rayon::ThreadPoolBuilder::new().num_threads(1).build());
    let pools: Vec<rayon::ThreadPool> = pools.collect::<Result<_, _>>().map_err(Failure::new)?;
    std::thread::scope(|scope| {
        for pool in &pools {
            scope.spawn(|| pool.install(work));
        }
    });
    let results = results.into_inner().unwrap_or_else(PoisonError::into_inner);
    Ok(results.into_values().collect())
}

/// Opens a file to append to, and cuts off an incomplete last line of a killed evaluation.
fn begin_after_whole_lines(path: &Path) -> std::io::Result<File> {
    let file = OpenOptions::new().create(true).append(true).open(path)?;
    let text = fs::read(path)?;
    let whole = text.iter().rposition(|&byte| byte == b'\n');
    file.set_len(whole.map_or(0, |end| end as u64 + 1))?;
    Ok(file)
}

/// Writes a result as one line and flushes it, so that a killed evaluation leaves at most one incomplete line.
fn write_line(file: &Mutex<File>, result: &impl Serialize) -> std::io::Result<()> {
    let mut line = serde_json::to_vec(result)?;
    line.push(b'\n');
    let mut file = file.lock().unwrap_or_else(PoisonError::into_inner);
    file.write_all(&line)?;
    file.flush()
}

/// Reads all results in the folder and skips incomplete last lines.
fn read_all<R: DeserializeOwned>(out: &Path, noun: &str) -> Result<Vec<R>, Failure> {
    let mut all = Vec::new();
    let entries =
        fs::read_dir(out).map_err(|error| file_failure(out, "read the folder", &error))?;
    let paths: Result<Vec<PathBuf>, _> = entries.map(|entry| Ok(entry?.path())).collect();
    let mut paths = paths.map_err(|error| file_failure(out, "read the folder", &error))?;
    paths.sort();
    for path in paths {
        let name = path.file_name().and_then(|name| name.to_str());
        let name = name.unwrap_or_default();
        if !(name.starts_with(&format!("{noun}s-")) && name.ends_with(".jsonl")) {
            continue;
        }
        let text = fs::read_to_string(&path)
            .map_err(|error| file_failure(&path, "read the file", &error))?;
        let mut lines = text.split_inclusive('\n').enumerate().peekable();
        while let Some((number, line)) = lines.next() {
            match serde_json::from_str::<R>(line) {
                Ok(result) => all.push(result),
                Err(_) if lines.peek().is_none() && !line.ends_with('\n') => {}
                Err(error) => {
                    let (path, line) = (path.display(), number + 1);
                    return Err(Failure::new(format!("{path}:{line}: {error}")));
                }
            }
        }
    }
    Ok(all)
}
