//! Session of statements: the tables of all sources, and the views.

use super::limits::{SqlLimits, check};
use super::provider::{FleetTable, schema_in_memory};
use super::views;
#[cfg(feature = "cluster")]
use crate::cluster::{Address, on_cluster};
use crate::store::{FleetError, Snapshot, StorePlace};
use crate::tables::drift::{FIRST_ROUNDS, assess};
use crate::tables::{DRIFT, TABLES, Table};
use datafusion::arrow::array::{RecordBatch, StringArray};
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::{DataType, Field, Schema, SchemaRef};
use datafusion::common::{DataFusionError, TableReference};
use datafusion::dataframe::DataFrame;
use datafusion::datasource::MemTable;
use datafusion::execution::object_store::ObjectStoreUrl;
use datafusion::execution::runtime_env::RuntimeEnvBuilder;
use datafusion::prelude::{JoinType, SQLOptions, SessionConfig, SessionContext};
use std::path::Path;
use std::sync::Arc;
use std::thread;
use tempfile::TempDir;
use tokio::sync::OnceCell;

/// A side of a join estimated below this size is kept in one piece [bytes, rows].
const BUILT_AT_ONCE: usize = 512 << 20;
const BUILT_ROWS_AT_ONCE: usize = 10_000_000;

/// A source of episodes.
#[derive(Debug, Clone)]
pub struct SqlSource {
    /// Place of the store.
    pub place: StorePlace,
    /// State of its log.
    pub snapshot: Snapshot,
}

impl SqlSource {
    /// Opens a fleet in its present state.
    ///
    /// # Errors
    /// If the store or its log cannot be read.
    pub async fn open(place: StorePlace) -> Result<Self, FleetError> {
        let snapshot = Snapshot::read(&place).await?;
        Ok(Self { place, snapshot })
    }
}

/// Tables and views that statements can use.
pub struct SqlSession {
    context: SessionContext,
    texts: Texts,
    limits: SqlLimits,
    /// Folder for data that exceed the memory.
    spill: TempDir,
    /// Number of episodes in more than one source; the first source is used.
    shared: usize,
    /// Whether the table `drift` has its rows.
    drift: OnceCell<()>,
    #[cfg(feature = "cluster")]
    cluster: Option<Address>,
}

/// Representation of texts in memory.
#[derive(Debug, Clone, Copy)]
enum Texts {
    /// Views: texts of up to twelve bytes need no pointer, which is fast.
    Views,
    /// Plain arrays: sent views would carry all the buffers that they refer to.
    #[cfg(feature = "cluster")]
    Plain,
}

impl Texts {
    fn schema(self, table: &Table) -> SchemaRef {
        match self {
            Self::Views => schema_in_memory(table),
            #[cfg(feature = "cluster")]
            Self::Plain => table.schema(),
        }
    }
}

impl SqlSession {
    /// Opens a session over all sources. An episode in several sources is taken from the first.
    ///
    /// # Errors
    /// If a source cannot be read.
    pub async fn new(sources: &[SqlSource]) -> Result<Self, FleetError> {
        Self::with_limits(sources, SqlLimits::default()).await
    }

    /// Opens a session with other limits than the default.
    ///
    /// # Errors
    /// If a source cannot be read.
    pub async fn with_limits(sources: &[SqlSource], limits: SqlLimits) -> Result<Self, FleetError> {
        Self::over(sources, Texts::Views, limits).await
    }

    /// Opens a session whose statements a cluster answers.
    ///
    /// # Errors
    /// If a source cannot be read, or there is no scheduler.
    #[cfg(feature = "cluster")]
    pub async fn on_cluster(
        sources: &[SqlSource],
        cluster: &Address,
        limits: SqlLimits,
    ) -> Result<Self, FleetError> {
        cluster.reach().await?;
        let mut session = Self::over(sources, Texts::Plain, limits).await?;
        session.context = on_cluster(&session.context, cluster)?;
        session.cluster = Some(cluster.clone());
        Ok(session)
    }

    async fn over(
        sources: &[SqlSource],
        texts: Texts,
        limits: SqlLimits,
    ) -> Result<Self, FleetError> {
        let mut config = SessionConfig::new()
            .with_information_schema(true)
            .with_target_partitions(thread::available_parallelism().map_or(1, usize::from));
        let options = config.options_mut();
        // Filters keep most rows of these tables, so decoding whole columns is faster than row by row.
        options.execution.parquet.pushdown_filters = false;
        // There are few collisions compared to the strokes that they are joined with, so the strokes should not be
        // redistributed.
        options.optimizer.hash_join_single_partition_threshold = BUILT_AT_ONCE;
        options.optimizer.hash_join_single_partition_threshold_rows = BUILT_ROWS_AT_ONCE;
        let spill = TempDir::with_prefix("wisch-fleet-").map_err(|error| FleetError::File {
            path: std::env::temp_dir(),
            error,
        })?;
        let runtime = RuntimeEnvBuilder::new()
            .with_memory_limit(limits.pool(), 1.0)
            .with_temp_file_path(spill.path())
            .build_arc()?;
        let context = SessionContext::new_with_config_rt(config, runtime);
        let mut session = Self {
            context,
            texts,
            limits,
            spill,
            shared: 0,
            drift: OnceCell::new(),
            #[cfg(feature = "cluster")]
            cluster: None,
        };
        for (number, source) in sources.iter().enumerate() {
            session.add(number, source)?;
        }
        session.unite(sources.len()).await?;
        session.set_drift(Vec::new())?;
        for view in views::all() {
            session.context.sql(view.statement).await?;
        }
        Ok(session)
    }

    fn add(&self, number: usize, source: &SqlSource) -> Result<(), FleetError> {
        let store = ObjectStoreUrl::parse(format!("fleet{number}://"))?;
        let base = url::Url::parse(store.as_str()).map_err(|error| FleetError::Url {
            url: store.to_string(),
            what: error.to_string(),
        })?;
        self.context
            .register_object_store(&base, source.place.store());
        for table in &TABLES {
            let files = source.snapshot.files_of(table.name);
            let schema = self.texts.schema(table);
            let table_of = FleetTable::new(schema, &source.place, store.clone(), files)?;
            self.context
                .register_table(name_in(table.name, number), Arc::new(table_of))?;
        }
        Ok(())
    }

    /// Unites the tables of all sources.
    async fn unite(&mut self, sources: usize) -> Result<(), FleetError> {
        let mut seen: Vec<RecordBatch> = Vec::new();
        let mut doubled: Vec<Option<DataFrame>> = vec![None];
        for number in 1..sources {
            // Episodes of this source that an earlier source holds.
            seen.extend(self.episodes_of(number - 1).await?);
            let earlier = self.context.read_batches(seen.clone())?;
            let here = self.context.table(name_in("episodes", number)).await?;
            let here = here.select_columns(&["episode"])?;
            let both = here.join(earlier, JoinType::LeftSemi, &["episode"], &["id"], None)?;
            let both = both.collect().await?;
            let count: usize = both.iter().map(RecordBatch::num_rows).sum();
            self.shared += count;
            doubled.push(match count {
                0 => None,
                _ => Some(self.context.read_batches(with_name(&both, "id")?)?),
            });
        }
        for table in &TABLES {
            let mut all: Option<DataFrame> = None;
            for (number, doubled) in doubled.iter().enumerate().take(sources) {
                let mut rows = self.context.table(name_in(table.name, number)).await?;
                if let Some(doubled) = doubled {
                    rows = rows.join(
                        doubled.clone(),
                        JoinType::LeftAnti,
                        &["episode"],
                        &["id"],
                        None,
                    )?;
                }
                all = Some(match all {
                    Some(all) => all.union(rows)?,
                    None => rows,
                });
            }
            let united = match all {
                Some(all) => all.into_view(),
                None => Arc::new(MemTable::try_new(self.texts.schema(table), vec![vec![]])?),
            };
            let name = TableReference::bare(table.name);
            match sources {
                // The table of a single source is used directly.
                1 => {
                    let only = self.context.table_provider(name_in(table.name, 0)).await?;
                    self.context.register_table(name, only)?
                }
                _ => self.context.register_table(name, united)?,
            };
        }
        Ok(())
    }

    async fn episodes_of(&self, number: usize) -> Result<Vec<RecordBatch>, FleetError> {
        let rows = self.context.table(name_in("episodes", number)).await?;
        let rows = rows.select_columns(&["episode"])?.collect().await?;
        with_name(&rows, "id")
    }

    /// Sets the rows of the table `drift`.
    fn set_drift(&self, rows: Vec<RecordBatch>) -> Result<(), FleetError> {
        let schema = self.texts.schema(&DRIFT);
        let cast = |batch: &RecordBatch| {
            let columns = batch.columns().iter().zip(schema.fields());
            let columns = columns.map(|(column, field)| cast(column, field.data_type()));
            RecordBatch::try_new(Arc::clone(&schema), columns.collect::<Result<_, _>>()?)
        };
        let rows: Result<Vec<RecordBatch>, _> = rows.iter().map(cast).collect();
        let rows = rows.map_err(DataFusionError::from)?;
        let table = MemTable::try_new(Arc::clone(&schema), vec![rows])?;
        self.context.deregister_table(DRIFT.name)?;
        self.context.register_table(DRIFT.name, Arc::new(table))?;
        Ok(())
    }

    /// Assesses the first rounds of all sources. They do not change during the session.
    async fn fill_drift(&self) -> Result<(), FleetError> {
        let first_rounds = self.context.sql(FIRST_ROUNDS).await?.collect().await?;
        self.set_drift(vec![assess(&first_rounds)?])
    }

    /// Whether a statement names the table `drift`. A statement that cannot be parsed does not.
    fn names_drift(&self, sql: &str) -> bool {
        let state = self.context.state();
        let dialect = state.config_options().sql_parser.dialect;
        let Ok(statement) = state.sql_to_statement(sql, &dialect) else {
            return false;
        };
        let tables = state.resolve_table_references(&statement);
        tables.is_ok_and(|tables| tables.iter().any(|table| table.table() == DRIFT.name))
    }

    /// Number of episodes in more than one source.
    pub fn shared(&self) -> usize {
        self.shared
    }

    /// Folder in which statements put data that exceed the memory.
    pub fn spill(&self) -> &Path {
        self.spill.path()
    }

    /// Adds the scheduler's address to an error of a statement.
    pub fn cluster_error(&self, error: FleetError) -> FleetError {
        #[cfg(feature = "cluster")]
        if let Some(cluster) = &self.cluster {
            return crate::cluster::cluster_error(cluster, error);
        }
        error
    }

    /// Plans a statement that only reads.
    ///
    /// # Errors
    /// If the statement is invalid, too deep, or would change something.
    pub async fn plan(&self, sql: &str) -> Result<DataFrame, FleetError> {
        check(sql)?;
        if self.names_drift(sql) {
            self.drift.get_or_try_init(|| self.fill_drift()).await?;
        }
        let reads = SQLOptions::new()
            .with_allow_ddl(false)
            .with_allow_dml(false)
            .with_allow_statements(false);
        Ok(self.context.sql_with_options(sql, reads).await?)
    }

    /// Returns the rows of an answer.
    ///
    /// # Errors
    /// As [`Self::plan`], and errors during the execution.
    pub async fn rows(&self, sql: &str) -> Result<Vec<RecordBatch>, FleetError> {
        let rows = async { Ok(self.plan(sql).await?.collect().await?) };
        self.limits.within(rows).await
    }
}

/// Returns the name of a source's table.
fn name_in(table: &str, source: usize) -> TableReference {
    TableReference::bare(format!("{table}_{source}"))
}

/// Returns batches with their first column renamed.
fn with_name(batches: &[RecordBatch], name: &str) -> Result<Vec<RecordBatch>, FleetError> {
    let renamed = batches.iter().map(|batch| {
        let texts = cast(batch.column(0), &DataType::Utf8)?;
        let schema = Schema::new(vec![Field::new(name, DataType::Utf8, true)]);
        Ok(RecordBatch::try_new(Arc::new(schema), vec![texts])?)
    });
    let renamed: Result<Vec<RecordBatch>, DataFusionError> = renamed.collect();
    let mut renamed = renamed?;
    if renamed.is_empty() {
        let schema = Schema::new(vec![Field::new(name, DataType::Utf8, true)]);
        let none = Arc::new(StringArray::new_null(0));
        renamed.push(
            RecordBatch::try_new(Arc::new(schema), vec![none]).map_err(DataFusionError::from)?,
        );
    }
    Ok(renamed)
}
