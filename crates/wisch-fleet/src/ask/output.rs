//! Answers as text or files.

use crate::store::FleetError;
use datafusion::arrow::array::RecordBatch;
use datafusion::arrow::csv;
use datafusion::arrow::datatypes::SchemaRef;
use datafusion::arrow::json::LineDelimitedWriter;
use datafusion::arrow::util::pretty::pretty_format_batches;
use datafusion::dataframe::DataFrame;
use datafusion::error::DataFusionError;
use futures::StreamExt;
use parquet::arrow::ArrowWriter;
use std::fs::File;
use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;

/// Largest answer in the form of a table [bytes], which must be in memory as a whole.
const LARGEST_TABLE: usize = 256 << 20;

/// Form of an answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Form {
    /// A table for people.
    Table,
    /// Comma-separated, with a first line of names.
    Csv,
    /// JSON, one object per line.
    Json,
    /// A Parquet file of this name.
    Parquet(PathBuf),
}

/// Writes an answer as it arrives; a table for people is written at the end. Returns the number of rows.
///
/// # Errors
/// The error of the statement, an answer that is too large for a table, or a failed write.
pub async fn write(
    answer: DataFrame,
    form: &Form,
    out: &mut (impl Write + Send),
) -> Result<usize, FleetError> {
    let schema: SchemaRef = Arc::new(answer.schema().as_arrow().clone());
    let mut rows = 0;
    match form {
        Form::Table => {
            let batches = collect(answer).await?;
            rows = batches.iter().map(RecordBatch::num_rows).sum();
            let none = [RecordBatch::new_empty(schema)];
            let shown = if batches.is_empty() {
                &none[..]
            } else {
                &batches
            };
            let table = pretty_format_batches(shown).map_err(DataFusionError::from)?;
            let noun = if rows == 1 { "row" } else { "rows" };
            writeln!(out, "{table}\n{rows} {noun}").map_err(printed)?;
        }
        Form::Csv => {
            let mut writer = csv::WriterBuilder::new().with_header(true).build(out);
            writer
                .write(&RecordBatch::new_empty(schema))
                .map_err(DataFusionError::from)?;
            let mut batches = answer.execute_stream().await?;
            while let Some(batch) = batches.next().await {
                let batch = batch?;
                rows += batch.num_rows();
                writer.write(&batch).map_err(DataFusionError::from)?;
            }
        }
        Form::Json => {
            let mut writer = LineDelimitedWriter::new(out);
            let mut batches = answer.execute_stream().await?;
            while let Some(batch) = batches.next().await {
                let batch = batch?;
                rows += batch.num_rows();
                writer.write(&batch).map_err(DataFusionError::from)?;
            }
            writer.finish().map_err(DataFusionError::from)?;
        }
        Form::Parquet(path) => {
            let failed = |error| FleetError::File {
                path: path.clone(),
                error,
            };
            let file = File::create(path).map_err(failed)?;
            let writer = ArrowWriter::try_new(file, schema, None);
            let mut writer = writer.map_err(DataFusionError::from)?;
            let mut batches = answer.execute_stream().await?;
            while let Some(batch) = batches.next().await {
                let batch = batch?;
                rows += batch.num_rows();
                writer.write(&batch).map_err(DataFusionError::from)?;
            }
            writer.close().map_err(DataFusionError::from)?;
        }
    }
    Ok(rows)
}

/// Returns all rows of an answer in the form of a table.
async fn collect(answer: DataFrame) -> Result<Vec<RecordBatch>, FleetError> {
    let mut stream = answer.execute_stream().await?;
    let (mut batches, mut bytes) = (Vec::new(), 0);
    while let Some(batch) = stream.next().await {
        let batch = batch?;
        bytes += batch.get_array_memory_size();
        if bytes > LARGEST_TABLE {
            let limit = LARGEST_TABLE >> 20;
            return Err(FleetError::Asked(format!(
                "the answer has more than {limit} MB, too much for a table: --csv, --json and --parquet write it as it \
                 arrives"
            )));
        }
        batches.push(batch);
    }
    Ok(batches)
}

fn printed(error: std::io::Error) -> FleetError {
    FleetError::File {
        path: PathBuf::from("standard output"),
        error,
    }
}
