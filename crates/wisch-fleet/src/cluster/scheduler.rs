//! Scheduler: accepts plans, divides them into stages and distributes these to the registered executors.

use super::address::Address;
use super::codec::TableCodec;
use super::{MESSAGE, journal};
use crate::store::FleetError;
use ballista_core::config::TaskSchedulingPolicy;
use ballista_core::utils::{default_config_producer, default_session_builder};
use ballista_scheduler::cluster::memory::{InMemoryClusterState, InMemoryJobState};
use ballista_scheduler::cluster::{
    BallistaCluster, ClusterState, ClusterStateEvent, ClusterStateEventStream,
};
use ballista_scheduler::config::{SchedulerConfig, TaskDistributionPolicy};
use ballista_scheduler::scheduler_process::{create_scheduler, start_grpc_service_with_listener};
use ballista_scheduler::scheduler_server::{SchedulerServer, SessionBuilder};
use datafusion::common::{DataFusionError, Result};
use datafusion::execution::SessionState;
use datafusion::prelude::SessionConfig;
use datafusion_proto::protobuf::{LogicalPlanNode, PhysicalPlanNode};
use futures::{FutureExt, StreamExt};
use std::collections::HashSet;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::TcpListener;
use tokio::time::sleep;

/// Time of silence after which an executor counts as lost [s]; a busy one polls every 5 s.
const LOST_AFTER: u64 = 20;
/// Interval of the checks of running statements [s].
const LOOKED_AFTER: u64 = 2;

type Server = SchedulerServer<LogicalPlanNode, PhysicalPlanNode>;

/// Settings of a scheduler.
#[derive(Debug, Clone)]
pub struct SchedulerOptions {
    /// Address at which it listens; port 0 for any free port.
    pub bind: SocketAddr,
    /// Name by which executors reach it, if it differs from `bind`.
    pub host: Option<String>,
}

/// Runs a scheduler until it is killed. Calls `begun` with the address once it listens.
///
/// # Errors
/// If the address is taken, or the system refuses it.
pub async fn schedule(
    options: &SchedulerOptions,
    begun: impl FnOnce(&Address),
) -> Result<(), FleetError> {
    journal::begin();
    let failed = |what: String| FleetError::Cluster {
        address: Address::from(options.bind).to_string(),
        what,
    };
    let listener = TcpListener::bind(options.bind).await;
    let listener = listener.map_err(|error| failed(error.to_string()))?;
    let bound = listener.local_addr();
    let address = Address::from(bound.map_err(|error| failed(error.to_string()))?);
    let executors: Arc<dyn ClusterState> = Arc::new(InMemoryClusterState::default());
    let registered = Arc::clone(&executors);
    let sessions: SessionBuilder = Arc::new(move |config| session(&*registered, config));
    let config = SchedulerConfig {
        bind_host: address.host().to_owned(),
        bind_port: address.port(),
        external_host: options.host.clone().unwrap_or(address.host().to_owned()),
        // Executors poll for tasks, and state their free slots themselves. If the scheduler counted, it would lose the
        // slot of every failed statement.
        scheduling_policy: TaskSchedulingPolicy::PullStaged,
        task_distribution: TaskDistributionPolicy::RoundRobin,
        grpc_server_max_decoding_message_size: MESSAGE,
        grpc_server_max_encoding_message_size: MESSAGE,
        grpc_client_max_message_size: MESSAGE,
        executor_timeout_seconds: LOST_AFTER,
        expire_dead_executor_interval_seconds: LOOKED_AFTER,
        no_executors_grace_period_seconds: LOST_AFTER,
        override_logical_codec: Some(Arc::new(TableCodec::default())),
        override_session_builder: Some(Arc::clone(&sessions)),
        ..SchedulerConfig::default()
    };
    let jobs = InMemoryJobState::new(
        config.scheduler_id.clone(),
        sessions,
        Arc::new(default_config_producer),
    );
    let cluster = BallistaCluster::new(executors, Arc::new(jobs));
    let scheduler =
        create_scheduler::<LogicalPlanNode, PhysicalPlanNode>(cluster, Arc::new(config))
            .await
            .map_err(|error| failed(error.to_string()))?;
    let removals = scheduler.cluster_state_events().await;
    let removals = removals.map_err(|error| failed(error.to_string()))?;
    tokio::spawn(cancel_on_loss(scheduler.clone(), removals));
    tokio::spawn(cancel_stuck(scheduler.clone()));
    begun(&address);
    let served = start_grpc_service_with_listener(listener, scheduler).await;
    served.map_err(|error| failed(error.to_string()))
}

/// Cancels running statements when an executor is lost. Ballista 55.0 would restart them; with planning between stages
/// a restart never ends, and without it joins without an equation give wrong results.
async fn cancel_on_loss(scheduler: Server, mut events: ClusterStateEventStream) {
    while let Some(event) = events.next().await {
        if let ClusterStateEvent::RemovedExecutor { .. } = event {
            for job in scheduler.state.task_manager.get_running_job_cache().keys() {
                // Fails only if the scheduler itself ends.
                let _ = scheduler.cancel_job(job.clone()).await;
            }
        }
    }
}

/// Cancels statements without running or waiting tasks at two checks: their planning is stuck and would never end.
async fn cancel_stuck(scheduler: Server) {
    let mut idle = HashSet::new();
    loop {
        sleep(Duration::from_secs(LOOKED_AFTER)).await;
        let mut now = HashSet::new();
        for (job, running) in &*scheduler.state.task_manager.get_running_job_cache() {
            let graph = running.execution_graph.read().await;
            if graph.running_tasks().is_empty() && graph.available_tasks() == 0 {
                now.insert(job.clone());
            }
        }
        for job in now.intersection(&idle) {
            // Fails only if the scheduler itself ends.
            let _ = scheduler.cancel_job(job.clone()).await;
        }
        idle = now;
    }
}

/// Returns the state for planning a statement, with as many partitions as there are slots.
fn session(executors: &dyn ClusterState, config: SessionConfig) -> Result<SessionState> {
    // Results in memory are available at once.
    let registered = executors.registered_executor_metadata().now_or_never();
    let slots = registered.iter().flatten();
    let slots: u32 = slots.map(|executor| executor.specification.vcores).sum();
    if slots == 0 {
        return Err(DataFusionError::Configuration(
            "no executor has registered with the scheduler; start one with wisch-fleet executor --scheduler HOST:PORT".to_owned(),
        ));
    }
    default_session_builder(config.with_target_partitions(slots as usize))
}
