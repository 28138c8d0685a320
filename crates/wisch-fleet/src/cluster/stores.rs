//! Stores that executors open when a plan names them.

use crate::store::StorePlace;
use datafusion::common::{DataFusionError, Result};
use datafusion::execution::object_store::{DefaultObjectStoreRegistry, ObjectStoreRegistry};
use object_store::ObjectStore;
use std::sync::Arc;
use url::{Position, Url};

/// Stores by URL; each is opened once, with the credentials of this process.
#[derive(Debug, Default)]
pub(super) struct Stores {
    known: DefaultObjectStoreRegistry,
}

impl ObjectStoreRegistry for Stores {
    fn register_store(
        &self,
        url: &Url,
        store: Arc<dyn ObjectStore>,
    ) -> Option<Arc<dyn ObjectStore>> {
        self.known.register_store(url, store)
    }

    fn get_store(&self, url: &Url) -> Result<Arc<dyn ObjectStore>> {
        if let Ok(store) = self.known.get_store(url) {
            return Ok(store);
        }
        let place = StorePlace::open(&url[..Position::BeforePath])
            .map_err(|error| DataFusionError::External(Box::new(error)))?;
        self.known.register_store(url, place.store());
        Ok(place.store())
    }
}
