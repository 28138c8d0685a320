//! Execution of tasks as in Ballista, with two exceptions: stages with a union are not measured, and joins with wrong
//! results are rejected.
//!
//! Unions: Ballista 55.0 gives the tasks of a union stage plans of different shapes. An empty part of a task is another
//! operator, without the measurements of the original. The scheduler rejects a task's report if its number of
//! measurements differs from that of the previous task, so that the statement would never end.
//!
//! Joins: some joins keep one side in memory, and finally return those of its rows that met no (or any) row of the
//! other side. The join must see the whole other side. Ballista 55.0 distributes the other side over tasks if the
//! join has no equation, and each task returns rows of its own. Unions have the same problem if a part needs all rows
//! at once, such as a sum without groups or a sorted part: each task would compute that part.

use ballista_core::JobId;
use ballista_core::execution_plans::ShuffleReaderExec;
use ballista_core::serde::protobuf::{
    RuntimeStatsReport, ShuffleWritePartition, TaskColumnStats, WindowStateReport,
};
use ballista_executor::execution_engine::{
    DefaultExecutionEngine, ExecutionEngine, QueryStageExecutor,
};
use datafusion::common::tree_node::TreeNode;
use datafusion::common::{JoinType, Result, not_impl_err};
use datafusion::execution::TaskContext;
use datafusion::physical_expr::Distribution;
use datafusion::physical_plan::ExecutionPlan;
use datafusion::physical_plan::coalesce_partitions::CoalescePartitionsExec;
use datafusion::physical_plan::empty::EmptyExec;
use datafusion::physical_plan::joins::{
    CrossJoinExec, HashJoinExec, NestedLoopJoinExec, PartitionMode,
};
use datafusion::physical_plan::metrics::MetricsSet;
use datafusion::physical_plan::placeholder_row::PlaceholderRowExec;
use datafusion::physical_plan::sorts::sort_preserving_merge::SortPreservingMergeExec;
use datafusion::physical_plan::union::UnionExec;
use datafusion::prelude::SessionConfig;
use std::fmt;
use std::sync::Arc;

/// Creates the engine that executes tasks.
#[derive(Default)]
pub(super) struct Engine {
    ballista: DefaultExecutionEngine,
}

impl ExecutionEngine for Engine {
    fn create_query_stage_exec(
        &self,
        job_id: JobId,
        stage_id: usize,
        task_id: usize,
        global_output_partition_ids: Vec<usize>,
        plan: Arc<dyn ExecutionPlan>,
        work_dir: &str,
        config: &SessionConfig,
    ) -> Result<Arc<dyn QueryStageExecutor>> {
        if plan.exists(|node| Ok(emits_build_side(node)))? {
            return not_impl_err!(
                "several tasks cannot compute an outer, semi or anti join without an equation; ask without a cluster"
            );
        }
        let has_union = plan.exists(|node| Ok(node.is::<UnionExec>()))?;
        if plan.exists(|node| Ok(node.is::<UnionExec>() && needs_all_rows(node)))? {
            return not_impl_err!(
                "several tasks cannot unite rows of several sources, or of UNION ALL, if a part of the union is a sum, or has an order or a limit; ask without a cluster"
            );
        }
        let stage = self.ballista.create_query_stage_exec(
            job_id,
            stage_id,
            task_id,
            global_output_partition_ids,
            plan,
            work_dir,
            config,
        )?;
        Ok(match has_union {
            true => Arc::new(Unmeasured(stage)),
            false => stage,
        })
    }
}

/// Whether a part of the plan needs all rows at once, so that every task would compute it, outside of joins.
fn needs_all_rows(node: &Arc<dyn ExecutionPlan>) -> bool {
    if let Some(reader) = node.downcast_ref::<ShuffleReaderExec>() {
        return reader.broadcast;
    }
    let sides = node.children().into_iter();
    if collects_build_side(node) {
        return sides.skip(1).any(needs_all_rows);
    }
    let required = node.input_distribution_requirements();
    node.is::<CoalescePartitionsExec>()
        || node.is::<SortPreservingMergeExec>()
        || (required.per_child_distributions())
            .any(|one| matches!(one, Distribution::SinglePartition))
        || sides.into_iter().any(needs_all_rows)
}

/// Whether a plan reads nothing, so that one task computes it.
fn is_constant(node: &Arc<dyn ExecutionPlan>) -> bool {
    let parts = node.children();
    node.is::<PlaceholderRowExec>()
        || node.is::<EmptyExec>()
        || (!parts.is_empty() && parts.into_iter().all(is_constant))
}

fn collects_build_side(node: &Arc<dyn ExecutionPlan>) -> bool {
    let hash_join = node.downcast_ref::<HashJoinExec>();
    node.is::<NestedLoopJoinExec>()
        || node.is::<CrossJoinExec>()
        || hash_join.is_some_and(|join| *join.partition_mode() == PartitionMode::CollectLeft)
}

/// Whether a join returns rows of the side in memory at the end, without seeing the whole other side.
fn emits_build_side(node: &Arc<dyn ExecutionPlan>) -> bool {
    let kind = match node.downcast_ref::<NestedLoopJoinExec>() {
        Some(join) => join.join_type(),
        None => match node.downcast_ref::<HashJoinExec>() {
            Some(join) if *join.partition_mode() == PartitionMode::CollectLeft => join.join_type(),
            _ => return false,
        },
    };
    let gives_out = matches!(
        kind,
        JoinType::Left
            | JoinType::Full
            | JoinType::LeftSemi
            | JoinType::LeftAnti
            | JoinType::LeftMark
    );
    let sees_all = |other: &&Arc<dyn ExecutionPlan>| needs_all_rows(other) || is_constant(other);
    gives_out && !node.children().get(1).is_some_and(sees_all)
}

/// Task of a stage that is not measured.
#[derive(Debug)]
struct Unmeasured(Arc<dyn QueryStageExecutor>);

impl fmt::Display for Unmeasured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

#[async_trait::async_trait]
impl QueryStageExecutor for Unmeasured {
    async fn execute_query_stage(
        &self,
        task_id: usize,
        context: Arc<TaskContext>,
    ) -> Result<Vec<ShuffleWritePartition>> {
        self.0.execute_query_stage(task_id, context).await
    }

    fn collect_plan_metrics(&self) -> Vec<MetricsSet> {
        Vec::new()
    }

    fn collect_runtime_stats_reports(&self) -> Vec<RuntimeStatsReport> {
        self.0.collect_runtime_stats_reports()
    }

    fn collect_window_state_reports(&self) -> Result<Vec<WindowStateReport>> {
        self.0.collect_window_state_reports()
    }

    fn collect_column_stats(&self) -> Vec<TaskColumnStats> {
        self.0.collect_column_stats()
    }
}
