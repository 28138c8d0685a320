//! A table of a fleet for DataFusion: the files in the log, except those that a filter excludes.

use crate::store::{FileEntry, StorePlace};
use crate::tables::Table;
use crate::tables::file::VERSION;
use async_trait::async_trait;
use datafusion::arrow::datatypes::{DataType, Field, Schema, SchemaRef};
use datafusion::catalog::{Session, TableProvider};
use datafusion::common::pruning::PrunableStatistics;
use datafusion::common::stats::Precision;
use datafusion::common::{
    ColumnStatistics, DataFusionError, Result, ScalarValue, Statistics, ToDFSchema,
};
use datafusion::config::TableParquetOptions;
use datafusion::datasource::listing::PartitionedFile;
use datafusion::datasource::physical_plan::parquet::CachedParquetFileReaderFactory;
use datafusion::datasource::physical_plan::{FileGroup, FileScanConfigBuilder, ParquetSource};
use datafusion::datasource::source::DataSourceExec;
use datafusion::execution::object_store::ObjectStoreUrl;
use datafusion::logical_expr::utils::conjunction;
use datafusion::logical_expr::{Expr, TableProviderFilterPushDown, TableType};
use datafusion::physical_optimizer::pruning::PruningPredicateBuilder;
use datafusion::physical_plan::ExecutionPlan;
use datafusion::physical_plan::empty::EmptyExec;
use object_store::ObjectMeta;
use object_store::path::Path;
#[cfg(feature = "cluster")]
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Size of a file's end that is read at once [bytes]: most footers are shorter.
const FOOTER: usize = 64 << 10;

/// A table.
#[derive(Debug)]
pub(crate) struct FleetTable {
    schema: SchemaRef,
    store: ObjectStoreUrl,
    /// URL of the store, if other processes can open it.
    #[cfg(feature = "cluster")]
    root: Option<String>,
    files: Vec<(Path, FileEntry)>,
}

/// A table in the form that is sent to other processes, which read the same files.
#[cfg(feature = "cluster")]
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct SerializedTable {
    root: String,
    files: Vec<(String, FileEntry)>,
}

/// Columns held as views in memory: texts of up to twelve bytes need no pointer.
pub(super) fn schema_in_memory(table: &Table) -> SchemaRef {
    let schema = table.schema();
    let fields = schema.fields().iter().map(|field| match field.data_type() {
        DataType::Utf8 => Field::new(field.name(), DataType::Utf8View, true),
        _ => field.as_ref().clone(),
    });
    Arc::new(Schema::new(fields.collect::<Vec<_>>()))
}

impl FleetTable {
    /// Returns the table of these files.
    ///
    /// # Errors
    /// If a newer program wrote a file.
    pub(super) fn new<'a>(
        schema: SchemaRef,
        place: &StorePlace,
        store: ObjectStoreUrl,
        files: impl Iterator<Item = &'a FileEntry>,
    ) -> Result<Self> {
        let files = files.map(|file| {
            if file.schema[0] > VERSION[0] {
                let [major, minor] = file.schema;
                return Err(DataFusionError::Plan(format!(
                    "{}: version {major}.{minor} is not supported; this program reads versions up to {}.x",
                    place.shown(&file.path),
                    VERSION[0]
                )));
            }
            Ok((place.path(&file.path), file.clone()))
        });
        Ok(Self {
            schema,
            store,
            #[cfg(feature = "cluster")]
            root: place.root(),
            files: files.collect::<Result<_>>()?,
        })
    }

    /// Returns the form that is sent to other processes.
    ///
    /// # Errors
    /// If no other process can read its files.
    #[cfg(feature = "cluster")]
    pub(crate) fn serialized(&self) -> Result<SerializedTable> {
        let root = self.root.clone().ok_or_else(|| {
            DataFusionError::Plan(
                "a store in the memory of one process cannot be read by other processes".to_owned(),
            )
        })?;
        let files = self.files.iter();
        let files = files.map(|(path, file)| (path.to_string(), file.clone()));
        Ok(SerializedTable {
            root,
            files: files.collect(),
        })
    }

    /// Returns the table of a sent form.
    ///
    /// # Errors
    /// If its store has no URL.
    #[cfg(feature = "cluster")]
    pub(crate) fn deserialize(schema: SchemaRef, table: SerializedTable) -> Result<Self> {
        let files = table.files.into_iter();
        Ok(Self {
            schema,
            store: ObjectStoreUrl::parse(&table.root)?,
            root: Some(table.root),
            files: files.map(|(path, file)| (Path::from(path), file)).collect(),
        })
    }

    /// Bounds of the values in a file, from the log, by which filters exclude it.
    fn bounds(&self, file: &FileEntry) -> Result<Statistics> {
        let text = |value: &String| ScalarValue::Utf8View(Some(value.clone()));
        let day = |value: &String| text(value).cast_to(&DataType::Date32);
        let [from, to] = file.times.map(|time| ScalarValue::Float64(Some(time)));
        let mut statistics = Statistics::new_unknown(&self.schema);
        statistics.num_rows = Precision::Exact(usize::try_from(file.rows).unwrap_or(usize::MAX));
        for (column, field) in (statistics.column_statistics.iter_mut()).zip(self.schema.fields()) {
            let [least, greatest] = match field.name().as_str() {
                "robot" => file.robots.each_ref().map(text),
                "day" => [day(&file.days[0])?, day(&file.days[1])?],
                "start_s" | "end_s" | "time_s" => [from.clone(), to.clone()],
                _ => continue,
            };
            *column = ColumnStatistics {
                min_value: Precision::Exact(least),
                max_value: Precision::Exact(greatest),
                ..ColumnStatistics::new_unknown()
            };
        }
        Ok(statistics)
    }

    /// Returns the files that may hold rows for which all conditions hold.
    fn require(&self, state: &dyn Session, filters: &[Expr]) -> Result<Vec<&(Path, FileEntry)>> {
        let filter = conjunction(filters.to_vec()).filter(|_| !self.files.is_empty());
        let Some(filter) = filter else {
            return Ok(self.files.iter().collect());
        };
        let schema = Arc::clone(&self.schema).to_dfschema()?;
        let filter = state.create_physical_expr(filter, &schema)?;
        // A condition that cannot be evaluated excludes no file.
        let Ok(predicate) = PruningPredicateBuilder::new()
            .with_file_schema(Arc::clone(&self.schema))
            .try_build(filter)
        else {
            return Ok(self.files.iter().collect());
        };
        let bounds = self
            .files
            .iter()
            .map(|(_, file)| self.bounds(file).map(Arc::new));
        let bounds = bounds.collect::<Result<Vec<_>>>()?;
        let keep = predicate.prune(&PrunableStatistics::new(bounds, Arc::clone(&self.schema)))?;
        let kept = self.files.iter().zip(keep).filter(|(_, keep)| *keep);
        Ok(kept.map(|(file, _)| file).collect())
    }
}

#[async_trait]
impl TableProvider for FleetTable {
    fn schema(&self) -> SchemaRef {
        Arc::clone(&self.schema)
    }

    fn table_type(&self) -> TableType {
        TableType::Base
    }

    fn supports_filters_pushdown(
        &self,
        filters: &[&Expr],
    ) -> Result<Vec<TableProviderFilterPushDown>> {
        Ok(vec![TableProviderFilterPushDown::Inexact; filters.len()])
    }

    async fn scan(
        &self,
        state: &dyn Session,
        projection: Option<&Vec<usize>>,
        filters: &[Expr],
        limit: Option<usize>,
    ) -> Result<Arc<dyn ExecutionPlan>> {
        let files = self.require(state, filters)?;
        if files.is_empty() {
            let schema = datafusion::common::project_schema(&self.schema, projection)?;
            return Ok(Arc::new(EmptyExec::new(schema)));
        }
        let rows: u64 = files.iter().map(|(_, file)| file.rows).sum();
        let bytes: u64 = files.iter().map(|(_, file)| file.bytes).sum();
        let mut statistics = Statistics::new_unknown(&self.schema);
        let rows = usize::try_from(rows).unwrap_or(usize::MAX);
        statistics.num_rows = match filters {
            [] => Precision::Exact(rows),
            _ => Precision::Inexact(rows),
        };
        statistics.total_byte_size =
            Precision::Inexact(usize::try_from(bytes).unwrap_or(usize::MAX));
        let options = TableParquetOptions {
            global: state.config_options().execution.parquet.clone(),
            ..TableParquetOptions::default()
        };
        let mut source = ParquetSource::new(Arc::clone(&self.schema))
            .with_table_parquet_options(options)
            .with_metadata_size_hint(FOOTER);
        // Footers are read once per session, because files never change. A scheduler only plans, and has no store.
        let runtime = state.runtime_env();
        if let Ok(store) = runtime.object_store(&self.store) {
            let cache = runtime.cache_manager.get_file_metadata_cache();
            let footers = CachedParquetFileReaderFactory::new(store, cache);
            source = source.with_parquet_file_reader_factory(Arc::new(footers));
        }
        if let Some(filter) = conjunction(filters.to_vec()) {
            let schema = Arc::clone(&self.schema).to_dfschema()?;
            source = source.with_predicate(state.create_physical_expr(filter, &schema)?);
        }
        // Files are distributed by length, so that threads finish together.
        let mut groups = vec![(0, Vec::new()); state.config().target_partitions().max(1)];
        for (path, file) in files {
            let (length, group) = (groups.iter_mut())
                .min_by_key(|(length, _)| *length)
                .expect("there is a group at least");
            *length += file.bytes;
            group.push(PartitionedFile::new_from_meta(ObjectMeta {
                location: path.clone(),
                last_modified: Default::default(),
                size: file.bytes,
                e_tag: None,
                version: None,
            }));
        }
        let groups = groups.into_iter().filter(|(_, group)| !group.is_empty());
        let groups = groups.map(|(_, group)| FileGroup::new(group)).collect();
        let config = FileScanConfigBuilder::new(self.store.clone(), Arc::new(source))
            .with_file_groups(groups)
            .with_statistics(statistics)
            .with_projection_indices(projection.cloned())?
            .with_limit(limit)
            .build();
        Ok(DataSourceExec::from_data_source(config))
    }
}
