//! Executor: runs the tasks of its scheduler, reads stores with its own credentials, and keeps its results for others
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

/// Largest memory of all slots together [bytes].
const MEMORY: u64 = 4 << 30;
/// Lifetime of a statement's results if the scheduler does not delete them, and interval of the check [s].
const KEPT: u64 = 24 * 3600;
const TIDIED_AFTER: u64 = 600;
/// Time that an executor waits for its scheduler to start.
const TRIES: u32 = 30;

/// Settings of an executor.
#[derive(Debug, Clone)]
pub struct ExecutorOptions {
    /// Address of its scheduler.
    pub scheduler: Address,
    /// Address at which others fetch its results; port 0 for any free port.
    pub bind: SocketAddr,
    /// Name by which others reach it, if it differs from `bind`.
    pub host: Option<String>,
    /// Number of simultaneous tasks; `None` for one per core.
    pub slots: Option<usize>,
    /// Folder of its results; `None` for a temporary folder.
    pub work_dir: Option<PathBuf>,
}

/// Runs an executor until it is killed. Calls `begun` with the number of slots once it has registered.
///
/// # Errors
/// If there is no scheduler, the address is taken, or a file cannot be written.
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
    // If it listens on all addresses, the scheduler uses the address of its connection.
    let host = (options.host.clone()).or_else(|| (!ip.is_unspecified()).then(|| ip.to_string()));
    // Files never change, so one cache of their footers serves all statements.
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
        // No task is pushed to this executor.
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
    let announce = async {
        while !health.is_ready() {
            sleep(Duration::from_millis(20)).await;
        }
        begun(slots);
        std::future::pending::<()>().await;
    };
    tokio::select! {
        ended = running => ended.map_err(|error| failed(error.to_string())),
        () = announce => Ok(()),
    }
}

/// Waits for the scheduler to start.
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

/// Reserves the port.
fn free(bind: SocketAddr) -> Result<u16, FleetError> {
    let listener = TcpListener::bind(bind);
    let address = listener.and_then(|listener| listener.local_addr());
    let address = address.map_err(|error| FleetError::Cluster {
        address: Address::from(bind).to_string(),
        what: error.to_string(),
    })?;
    Ok(address.port())
}
