//! An executor: runs the tasks that its scheduler hands out, reads stores with its own credentials, and keeps what it has made for others
//! to fetch.

use super::address::Address;
use super::codec::TableCodec;
use super::engine::Engine;
use super::stores::Stores;
use super::{MESSAGE, journal};
use crate::store::FleetError;
use ballista_core::config::TaskSchedulingPolicy;
use ballista_executor::executor_process::{ExecutorProcessConfig, start_executor_process};
use ballista_executor::health::ExecutorHealth;
use datafusion::execution::runtime_env::RuntimeEnvBuilder;
use std::net::{SocketAddr, TcpListener};
use std::path::PathBuf;
use std::sync::Arc;
use std::thread;
use std::time::Duration;
use tokio::time::sleep;

/// What all its slots together may take of the memory [bytes].
const MEMORY: u64 = 4 << 30;
/// What was made for a statement is deleted after this, if the scheduler has not said so before, and looked for this often [s].
const KEPT: u64 = 24 * 3600;
const TIDIED_AFTER: u64 = 600;
/// A scheduler may start a little later than its executors.
const TRIES: u32 = 30;

/// How an executor runs.
#[derive(Debug, Clone)]
pub struct ExecutorOptions {
    /// Its scheduler.
    pub scheduler: Address,
    /// Where others fetch what it has made; port 0 is any that is free.
    pub bind: SocketAddr,
    /// How others reach it, if not as `bind` says.
    pub host: Option<String>,
    /// How many tasks it runs at once; `None` is one for each core.
    pub slots: Option<usize>,
    /// Where it keeps what it has made; `None` is a folder that is gone afterwards.
    pub work_dir: Option<PathBuf>,
}

/// Executes until it is killed; `begun` is told the number of its slots when it has registered.
///
/// # Errors
/// No scheduler, an address that is taken, or what the system says.
pub async fn execute(
    options: &ExecutorOptions,
    begun: impl FnOnce(usize),
) -> Result<(), FleetError> {
    journal::begin();
    reach(&options.scheduler).await?;
    let failed = |what: String| FleetError::Cluster {
        address: options.scheduler.to_string(),
        what,
    };
    let at = |path: PathBuf| move |error| FleetError::File { path, error };
    let temporary = tempfile::tempdir().map_err(at(std::env::temp_dir()))?;
    let work_dir = match &options.work_dir {
        Some(folder) => folder.clone(),
        None => temporary.path().to_path_buf(),
    };
    std::fs::create_dir_all(&work_dir).map_err(at(work_dir.clone()))?;
    let port = free(options.bind)?;
    let slots = (options.slots)
        .unwrap_or_else(|| thread::available_parallelism().map_or(1, usize::from))
        .max(1);
    let ip = options.bind.ip();
    // Where it listens on all addresses, the scheduler knows the one that it came from.
    let host = (options.host.clone()).or_else(|| (!ip.is_unspecified()).then(|| ip.to_string()));
    // Files never change: one cache of their footers for all statements.
    let runtime = RuntimeEnvBuilder::new()
        .with_object_store_registry(Arc::new(Stores::default()))
        .with_temp_file_path(&work_dir)
        .build_arc()?;
    let health = ExecutorHealth::new();
    let config = ExecutorProcessConfig {
        bind_host: match options.bind {
            SocketAddr::V4(_) => ip.to_string(),
            SocketAddr::V6(_) => format!("[{ip}]"),
        },
        external_host: host,
        port,
        // Nobody sends tasks here.
        grpc_port: port,
        scheduler_host: options.scheduler.host().to_owned(),
        scheduler_port: options.scheduler.port(),
        vcores: slots,
        task_scheduling_policy: TaskSchedulingPolicy::PullStaged,
        work_dir: Some(work_dir.display().to_string()),
        job_data_ttl_seconds: KEPT,
        job_data_clean_up_interval_seconds: TIDIED_AFTER,
        grpc_max_decoding_message_size: MESSAGE,
        grpc_max_encoding_message_size: MESSAGE,
        memory_pool_size: Some(MEMORY),
        override_runtime_producer: Some(Arc::new(move |_| Ok(Arc::clone(&runtime)))),
        override_execution_engine: Some(Arc::new(Engine::default())),
        override_logical_codec: Some(Arc::new(TableCodec::default())),
        health: health.clone(),
        ..ExecutorProcessConfig::default()
    };
    let running = start_executor_process(Arc::new(config));
    let told = async {
        while !health.is_ready() {
            sleep(Duration::from_millis(20)).await;
        }
        begun(slots);
        std::future::pending::<()>().await;
    };
    tokio::select! {
        ended = running => ended.map_err(|error| failed(error.to_string())),
        () = told => Ok(()),
    }
}

/// Waits a while for the scheduler.
async fn reach(scheduler: &Address) -> Result<(), FleetError> {
    let mut tries = 1;
    loop {
        match scheduler.reach().await {
            Err(_) if tries < TRIES => tries += 1,
            other => return other,
        }
        sleep(Duration::from_secs(1)).await;
    }
}

/// The port, which nobody else has.
fn free(bind: SocketAddr) -> Result<u16, FleetError> {
    let listener = TcpListener::bind(bind);
    let address = listener.and_then(|listener| listener.local_addr());
    let address = address.map_err(|error| FleetError::Cluster {
        address: Address::from(bind).to_string(),
        what: error.to_string(),
    })?;
    Ok(address.port())
}
