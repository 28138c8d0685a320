//! The folder of an evaluation: a line for each case as soon as it is evaluated, so that it goes on after it was killed,
//! and other machines take a part of it.

use super::super::words::counted;
use super::cannot;
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

/// What is evaluated, case by case.
pub struct Cases<'a, C, R> {
    /// What a case is called: a world, or a run.
    pub noun: &'static str,
    /// All cases, each with the number by which it falls to a part of them.
    pub all: &'a [(u64, C)],
    /// The case of what is in the folder.
    pub case_of: &'a dyn Fn(&R) -> C,
    /// Whether what is in the folder was evaluated in the same way as these are.
    pub is_same: &'a dyn Fn(&R) -> bool,
    /// What tells a case from others, such as `seed 17`.
    pub name: &'a dyn Fn(&C) -> String,
    /// Evaluates one.
    pub evaluate: &'a (dyn Fn(&C) -> Result<R, Failure> + Sync),
}

/// What there is of an evaluation.
pub struct Evaluated<R> {
    /// All that the folder holds, of other parts too, in the order of the cases.
    pub all: Vec<R>,
    /// How many cases could not be evaluated now.
    pub failed: usize,
}

impl<C: Ord + Clone + Sync, R: Serialize + DeserializeOwned + Send> Cases<'_, C, R> {
    /// Evaluates the cases of a part that the folder does not yet hold.
    ///
    /// # Errors
    /// A folder that cannot be written to, or holds another evaluation, or the same and is not to be gone on with.
    pub fn evaluated(
        &self,
        out: &Path,
        args: &JournalArgs,
        global: &GlobalArgs,
    ) -> Result<Evaluated<R>, Failure> {
        fs::create_dir_all(out).map_err(|error| cannot(out, "write there", &error))?;
        let mut known = self.known(out, args.resume)?;
        let shard = args.shard;
        let open: Vec<&C> = (self.all.iter())
            .filter(|(number, _)| number % shard.count == shard.index - 1)
            .map(|(_, case)| case)
            .filter(|case| !known.contains_key(case))
            .collect();
        let name = format!("{}s-{}-of-{}.jsonl", self.noun, shard.index, shard.count);
        let path = out.join(name);
        let file = begin_after_whole_lines(&path);
        let file = Mutex::new(file.map_err(|error| cannot(&path, "write there", &error))?);
        let evaluated = one_on_each_core(&open, self.noun, global, |case| {
            let result = (self.evaluate)(case)?;
            write_line(&file, &result).map_err(|error| cannot(&path, "write there", &error))?;
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

    /// What the folder holds, if it is of this evaluation.
    fn known(&self, out: &Path, resume: bool) -> Result<BTreeMap<C, R>, Failure> {
        let known: BTreeMap<C, R> = (read_all(out, self.noun)?.into_iter())
            .map(|result| ((self.case_of)(&result), result))
            .collect();
        let asked: std::collections::BTreeSet<&C> = self.all.iter().map(|(_, case)| case).collect();
        let mut others = (known.iter())
            .filter(|(case, result)| !asked.contains(case) || !(self.is_same)(result));
        if let Some((other, _)) = others.next() {
            return Err(Failure::new(format!(
                "{}: holds another evaluation, among others of {}",
                out.display(),
                (self.name)(other)
            ))
            .with_help(
                "choose another folder with --out: figures of several evaluations are not mixed",
            ));
        }
        if !known.is_empty() && !resume {
            return Err(Failure::new(format!(
                "{}: holds {} already",
                out.display(),
                counted(known.len(), self.noun)
            ))
            .with_help("--resume goes on there; a published figure is not drawn twice"));
        }
        Ok(known)
    }
}

/// Evaluates cases side by side, each on a single core, so that how long one takes does not depend on the others; the
/// results in the order of the cases.
pub fn one_on_each_core<C: Sync, R: Send>(
    cases: &[C],
    noun: &str,
    global: &GlobalArgs,
    evaluate: impl Fn(&C) -> Result<R, Failure> + Sync,
) -> Result<Vec<Result<R, Failure>>, Failure> {
    let progress = Progress::start(global);
    let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let all = counted(cases.len(), noun);
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

/// A file to be gone on with; what a killed evaluation left of a line is cut off.
fn begin_after_whole_lines(path: &Path) -> std::io::Result<File> {
    let file = OpenOptions::new().create(true).append(true).open(path)?;
    let text = fs::read(path)?;
    let whole = text.iter().rposition(|&byte| byte == b'\n');
    file.set_len(whole.map_or(0, |end| end as u64 + 1))?;
    Ok(file)
}

/// A line at once, so that a killed evaluation leaves whole lines but for the last.
fn write_line(file: &Mutex<File>, result: &impl Serialize) -> std::io::Result<()> {
    let mut line = serde_json::to_vec(result)?;
    line.push(b'\n');
    let mut file = file.lock().unwrap_or_else(PoisonError::into_inner);
    file.write_all(&line)?;
    file.flush()
}

/// All that the folder holds; a line that was not finished is passed over.
fn read_all<R: DeserializeOwned>(out: &Path, noun: &str) -> Result<Vec<R>, Failure> {
    let mut all = Vec::new();
    let entries = fs::read_dir(out).map_err(|error| cannot(out, "read it", &error))?;
    let paths: Result<Vec<PathBuf>, _> = entries.map(|entry| Ok(entry?.path())).collect();
    let mut paths = paths.map_err(|error| cannot(out, "read it", &error))?;
    paths.sort();
    for path in paths {
        let name = path.file_name().and_then(|name| name.to_str());
        let name = name.unwrap_or_default();
        if !(name.starts_with(&format!("{noun}s-")) && name.ends_with(".jsonl")) {
            continue;
        }
        let text = fs::read_to_string(&path).map_err(|error| cannot(&path, "read it", &error))?;
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
