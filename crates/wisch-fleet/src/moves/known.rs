//! Episodes of a fleet, from the files of the relevant days.

use super::batch::day_text;
use crate::store::{FileEntry, FleetError, Snapshot, StorePlace};
use datafusion::arrow::array::{Array, AsArray};
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::DataType;
use datafusion::error::DataFusionError;
use parquet::arrow::ProjectionMask;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use std::collections::HashMap;

/// Episodes by name, with their identities.
#[derive(Debug, Default)]
pub(super) struct Known(HashMap<String, String>);

impl Known {
    pub(super) fn new() -> Self {
        Self::default()
    }

    /// Identity of the episode with this name, if the fleet has it.
    pub(super) fn identity(&self, id: &str) -> Option<&str> {
        self.0.get(id).map(String::as_str)
    }

    /// Names of the episodes.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// Reads the episodes of these days, first and last, or of all days.
    ///
    /// # Errors
    /// If the store or a file cannot be read.
    pub(super) async fn read(
        &mut self,
        place: &StorePlace,
        snapshot: &Snapshot,
        days: Option<[i32; 2]>,
    ) -> Result<(), FleetError> {
        let days = days.map(|days| days.map(day_text));
        let is_asked = |file: &&FileEntry| match &days {
            Some([first, last]) => file.days[0] <= *last && file.days[1] >= *first,
            None => true,
        };
        for file in snapshot.files_of("episodes").filter(is_asked) {
            let bytes = place.get(&file.path).await?;
            if bytes.len() as u64 != file.bytes {
                let (now, then) = (bytes.len(), file.bytes);
                return Err(FleetError::Damaged {
                    object: place.shown(&file.path),
                    what: format!("it is {now} bytes long, but {then} were written"),
                });
            }
            let damaged = |what: String| FleetError::Damaged {
                object: place.shown(&file.path),
                what,
            };
            let reader = ParquetRecordBatchReaderBuilder::try_new(bytes)
                .map_err(|error| damaged(error.to_string()))?;
            let wanted = ["episode", "identity"];
            let mask = ProjectionMask::columns(reader.parquet_schema(), wanted);
            let batches = reader.with_projection(mask).build();
            for batch in batches.map_err(|error| damaged(error.to_string()))? {
                let batch = batch.map_err(|error| damaged(error.to_string()))?;
                let texts = wanted.map(|name| {
                    let column = batch.column_by_name(name);
                    column
                        .map(|column| cast(column, &DataType::Utf8))
                        .transpose()
                });
                let [ids, identities] = texts.map(|text| text.map_err(DataFusionError::from));
                let (Some(ids), identities) = (ids?, identities?) else {
                    return Err(damaged("it has no column \"episode\"".to_owned()));
                };
                let ids = ids.as_string::<i32>();
                for row in 0..ids.len() {
                    let identity = identities
                        .as_ref()
                        .map(|all| all.as_string::<i32>().value(row));
                    let identity = identity.unwrap_or_default().to_owned();
                    self.0.insert(ids.value(row).to_owned(), identity);
                }
            }
        }
        Ok(())
    }
}
