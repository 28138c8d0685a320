//! The scheduler: takes plans, cuts them into stages and hands these out to the executors that have registered.

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

/// An executor that has been silent for so long is lost [s]; one that is busy asks every 5 s.
const LOST_AFTER: u64 = 20;
/// How often what goes on is looked at [s].
const LOOKED_AFTER: u64 = 2;

type Server = SchedulerServer<LogicalPlanNode, PhysicalPlanNode>;

/// How a scheduler runs.
#[derive(Debug, Clone)]
pub struct SchedulerOptions {
    /// Where it listens; port 0 is any that is free.
    pub bind: SocketAddr,
    /// How executors reach it, if not as `bind` says.
    pub host: Option<String>,
}

/// Schedules until it is killed; `begun` is told the address when it listens.
///
/// # Errors
/// An address that is taken, or what the system says.
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
        // Executors ask for tasks, and say themselves how many slots are free: where the scheduler counts, a slot whose statement has
        // failed is lost.
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
    tokio::spawn(give_up(scheduler.clone(), removals));
    tokio::spawn(give_up_idle(scheduler.clone()));
    begun(&address);
    let served = start_grpc_service_with_listener(listener, scheduler).await;
    served.map_err(|error| failed(error.to_string()))
}

/// Ends what runs whenever an executor is lost. Ballista 55.0 would begin anew, but where it plans between stages it does not come to an
/// end then; where it does not, joins without an equation come out wrong.
async fn give_up(scheduler: Server, mut events: ClusterStateEventStream) {
    while let Some(event) = events.next().await {
        if let ClusterStateEvent::RemovedExecutor { .. } = event {
            for job in scheduler.state.task_manager.get_running_job_cache().keys() {
                // It fails where the scheduler itself ends.
                let _ = scheduler.cancel_job(job.clone()).await;
            }
        }
    }
}

/// Ends what has tasks neither running nor waiting at two looks: its planning has lost its way, and nothing would ever come of it.
async fn give_up_idle(scheduler: Server) {
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
            // It fails where the scheduler itself ends.
            let _ = scheduler.cancel_job(job.clone()).await;
        }
        idle = now;
    }
}

/// What a statement is planned in: as many pieces as there are slots.
fn session(executors: &dyn ClusterState, config: SessionConfig) -> Result<SessionState> {
    // What is in memory is there at once.
    let registered = executors.registered_executor_metadata().now_or_never();
    let slots = registered.iter().flatten();
    let slots: u32 = slots.map(|executor| executor.specification.vcores).sum();
    if slots == 0 {
        return Err(DataFusionError::Configuration(
            "no executor has registered with the scheduler: start one with wisch-fleet executor --scheduler HOST:PORT".to_owned(),
        ));
    }
    default_session_builder(config.with_target_partitions(slots as usize))
}
