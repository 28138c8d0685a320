//! Encoding of a plan's tables for the scheduler: files by name with their bounds, rows in memory as Arrow IPC.

use crate::ask::provider::{FleetTable, SerializedTable};
use ballista_core::serde::BallistaLogicalExtensionCodec;
use datafusion::arrow::datatypes::SchemaRef;
use datafusion::arrow::ipc::reader::StreamReader;
use datafusion::arrow::ipc::writer::StreamWriter;
use datafusion::catalog::TableProvider;
use datafusion::common::{DataFusionError, Result, TableReference};
use datafusion::datasource::MemTable;
use datafusion::datasource::file_format::FileFormatFactory;
use datafusion::execution::TaskContext;
use datafusion::logical_expr::{Extension, LogicalPlan};
use datafusion_proto::logical_plan::LogicalExtensionCodec;
use std::sync::Arc;

/// First byte of a table, which states its kind.
const FILES: u8 = b'F';
const ROWS: u8 = b'R';

/// Codec for the fleet's tables and all tables that Ballista knows.
#[derive(Debug, Default)]
pub(super) struct TableCodec {
    others: BallistaLogicalExtensionCodec,
}

fn broken(error: serde_json::Error) -> DataFusionError {
    DataFusionError::Plan(format!(
        "a table that was sent cannot be read ({error}): client, scheduler and executors must have the same version"
    ))
}

impl LogicalExtensionCodec for TableCodec {
    fn try_decode(
        &self,
        buf: &[u8],
        inputs: &[LogicalPlan],
        ctx: &TaskContext,
    ) -> Result<Extension> {
        self.others.try_decode(buf, inputs, ctx)
    }

    fn try_encode(&self, node: &Extension, buf: &mut Vec<u8>) -> Result<()> {
        self.others.try_encode(node, buf)
    }

    fn try_decode_table_provider(
        &self,
        buf: &[u8],
        table: &TableReference,
        schema: SchemaRef,
        ctx: &TaskContext,
    ) -> Result<Arc<dyn TableProvider>> {
        match buf.split_first() {
            Some((&FILES, rest)) => {
                let table: SerializedTable = serde_json::from_slice(rest).map_err(broken)?;
                Ok(Arc::new(FleetTable::deserialize(schema, table)?))
            }
            Some((&ROWS, rest)) => {
                let batches = StreamReader::try_new(rest, None)?.collect::<Result<_, _>>()?;
                Ok(Arc::new(MemTable::try_new(schema, vec![batches])?))
            }
            _ => (self.others).try_decode_table_provider(buf, table, schema, ctx),
        }
    }

    fn try_encode_table_provider(
        &self,
        table: &TableReference,
        provider: Arc<dyn TableProvider>,
        buf: &mut Vec<u8>,
    ) -> Result<()> {
        if let Some(files) = provider.downcast_ref::<FleetTable>() {
            buf.push(FILES);
            return serde_json::to_writer(buf, &files.serialized()?).map_err(broken);
        }
        if let Some(rows) = provider.downcast_ref::<MemTable>() {
            buf.push(ROWS);
            let mut writer = StreamWriter::try_new(buf, &rows.schema())?;
            for partition in &rows.batches {
                // No writer is left.
                let Ok(batches) = partition.try_read() else {
                    return Err(DataFusionError::Internal("rows in use".to_owned()));
                };
                for batch in batches.iter() {
                    writer.write(batch)?;
                }
            }
            return Ok(writer.finish()?);
        }
        self.others.try_encode_table_provider(table, provider, buf)
    }

    fn try_decode_file_format(
        &self,
        buf: &[u8],
        ctx: &TaskContext,
    ) -> Result<Arc<dyn FileFormatFactory>> {
        self.others.try_decode_file_format(buf, ctx)
    }

    fn try_encode_file_format(
        &self,
        buf: &mut Vec<u8>,
        node: Arc<dyn FileFormatFactory>,
    ) -> Result<()> {
        self.others.try_encode_file_format(buf, node)
    }
}
