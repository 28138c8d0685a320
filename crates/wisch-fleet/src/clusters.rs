//! Commands of a cluster; without the feature, they explain how to get it.

#[cfg(feature = "cluster")]
pub use with::{check, executor, scheduler, session};
#[cfg(not(feature = "cluster"))]
pub use without::{check, executor, scheduler, session};

#[cfg(feature = "cluster")]
mod with {
    use crate::Outcome;
    use crate::args::{ExecutorArgs, SchedulerArgs};
    use std::io::{self, Write};
    use wisch_fleet::ask::{SqlLimits, SqlSession, SqlSource};
    use wisch_fleet::cluster::{self, Address, ExecutorOptions, SchedulerOptions};
    use wisch_fleet::store::FleetError;

    /// Checks that a URL can be a scheduler's address.
    pub fn check(url: &str) -> Result<(), FleetError> {
        Address::parse(url).map(|_| ())
    }

    /// Opens a session whose statements the cluster answers.
    pub async fn session(
        sources: &[SqlSource],
        url: &str,
        limits: SqlLimits,
    ) -> Result<SqlSession, FleetError> {
        SqlSession::on_cluster(sources, &Address::parse(url)?, limits).await
    }

    /// Runs a scheduler.
    pub async fn scheduler(args: &SchedulerArgs) -> Result<Outcome, FleetError> {
        let options = SchedulerOptions {
            bind: args.bind,
            host: args.host.clone(),
        };
        cluster::schedule(&options, |address| {
            print_line(&format!("scheduling at {address}"))
        })
        .await?;
        Ok(Outcome::Done)
    }

    /// Runs an executor.
    pub async fn executor(args: &ExecutorArgs) -> Result<Outcome, FleetError> {
        let scheduler = match args.scheduler.contains("://") {
            true => Address::parse(&args.scheduler)?,
            false => Address::parse(&format!("df://{}", args.scheduler))?,
        };
        let options = ExecutorOptions {
            scheduler: scheduler.clone(),
            bind: args.bind,
            host: args.host.clone(),
            slots: args.slots,
            work_dir: args.work_dir.clone(),
        };
        let begun =
            |slots| print_line(&format!("executing for {scheduler}, {slots} tasks at once"));
        cluster::execute(&options, begun).await?;
        Ok(Outcome::Done)
    }

    /// Prints a line at once, also to a pipe.
    fn print_line(text: &str) {
        let mut out = io::stdout();
        // The pipe may be closed.
        let _ = writeln!(out, "{text}").and_then(|()| out.flush());
    }
}

#[cfg(not(feature = "cluster"))]
mod without {
    use crate::Outcome;
    use crate::args::{ExecutorArgs, SchedulerArgs};
    use wisch_fleet::ask::{SqlLimits, SqlSession, SqlSource};
    use wisch_fleet::store::FleetError;

    fn missing<T>() -> Result<T, FleetError> {
        Err(FleetError::Asked(
            "this program was built without clusters: cargo install --path crates/wisch-fleet --locked --features cluster".to_owned(),
        ))
    }

    /// Fails, because this build has no clusters.
    pub fn check(_url: &str) -> Result<(), FleetError> {
        missing()
    }

    /// Fails, because this build has no clusters.
    pub async fn session(
        _sources: &[SqlSource],
        _url: &str,
        _limits: SqlLimits,
    ) -> Result<SqlSession, FleetError> {
        missing()
    }

    /// Fails, because this build has no clusters.
    pub async fn scheduler(_args: &SchedulerArgs) -> Result<Outcome, FleetError> {
        missing()
    }

    /// Fails, because this build has no clusters.
    pub async fn executor(_args: &ExecutorArgs) -> Result<Outcome, FleetError> {
        missing()
    }
}
