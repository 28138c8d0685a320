//! Session whose statements a cluster answers.

use super::MESSAGE;
use super::address::Address;
use super::codec::TableCodec;
use crate::store::{FleetError, without_echo};
use async_trait::async_trait;
use ballista_core::extension::{SessionConfigExt, SessionStateExt};
use ballista_core::planner::BallistaQueryPlanner;
use datafusion::catalog::Session;
use datafusion::common::Result;
use datafusion::execution::SessionStateBuilder;
use datafusion::execution::context::QueryPlanner;
use datafusion::logical_expr::LogicalPlan;
use datafusion::physical_plan::ExecutionPlan;
use datafusion::physical_planner::{DefaultPhysicalPlanner, PhysicalPlanner};
use datafusion::prelude::SessionContext;
use datafusion_proto::protobuf::LogicalPlanNode;
use std::sync::Arc;

/// Returns a session with the same tables and views on the cluster.
pub(crate) fn on_cluster(here: &SessionContext, address: &Address) -> Result<SessionContext> {
    let local_config = here.copied_config();
    let optimizer = &local_config.options().optimizer;
    let built_at_once = optimizer.hash_join_single_partition_threshold;
    let built_rows_at_once = optimizer.hash_join_single_partition_threshold_rows;
    let mut config = here
        .copied_config()
        .upgrade_for_ballista()
        .with_ballista_broadcast_join_threshold_bytes(built_at_once)
        .with_ballista_broadcast_join_threshold_rows(built_rows_at_once)
        // The catalog exists already.
        .with_create_default_catalog_and_schema(false)
        .with_ballista_logical_extension_codec(Arc::new(TableCodec::default()))
        .with_ballista_grpc_client_max_message_size(MESSAGE as usize);
    // As on one machine: the small side of a join goes to all tasks, so that the large side is not redistributed.
    let optimizer = &mut config.options_mut().optimizer;
    optimizer.hash_join_single_partition_threshold = built_at_once;
    optimizer.hash_join_single_partition_threshold_rows = built_rows_at_once;
    let planner = Planner(BallistaQueryPlanner::with_extension(
        address.endpoint(),
        config.ballista_config(),
        config.ballista_logical_extension_codec(),
    ));
    let state = SessionStateBuilder::new_from_existing(here.state())
        .with_config(config.with_ballista_query_planner(Arc::new(planner)))
        .build();
    let state = state.upgrade_for_ballista(address.endpoint())?;
    Ok(SessionContext::new_with_state(state))
}

/// Sends plans to the scheduler, except those that only describe tables.
#[derive(Debug)]
struct Planner(BallistaQueryPlanner<LogicalPlanNode>);

#[async_trait]
impl QueryPlanner for Planner {
    async fn create_physical_plan(
        &self,
        plan: &LogicalPlan,
        session: &dyn Session,
    ) -> Result<Arc<dyn ExecutionPlan>> {
        match plan {
            LogicalPlan::DescribeTable(_) => {
                DefaultPhysicalPlanner::default()
                    .create_physical_plan(plan, session)
                    .await
            }
            _ => self.0.create_physical_plan(plan, session).await,
        }
    }
}

/// Returns the error of the cluster, with the scheduler's address.
pub(crate) fn cluster_error(address: &Address, error: FleetError) -> FleetError {
    match error {
        FleetError::Sql(error) => {
            let text = without_echo(&error.strip_backtrace());
            // DataFusion asks users to report its internal errors; that part is removed.
            let what = text.split("\nThis issue was likely").next();
            let mut what = what.unwrap_or_default().trim_end().to_owned();
            if what.ends_with("failed: Cancelled") {
                what += ", because an executor was lost or the scheduler's plan did not end; ask again, or without a cluster";
            }
            FleetError::Cluster {
                address: address.to_string(),
                what,
            }
        }
        other => other,
    }
}
