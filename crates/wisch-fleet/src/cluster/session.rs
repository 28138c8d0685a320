//! A session whose statements are answered by a cluster.

use super::MESSAGE;
use super::address::Address;
use super::codec::TableCodec;
use crate::store::{FleetError, without_echo};
use ballista_core::extension::{SessionConfigExt, SessionStateExt};
use datafusion::execution::SessionStateBuilder;
use datafusion::prelude::SessionContext;
use std::sync::Arc;

/// The same tables and views, asked there.
pub(crate) fn on_cluster(
    here: &SessionContext,
    address: &Address,
) -> Result<SessionContext, FleetError> {
    let config = here
        .copied_config()
        .upgrade_for_ballista()
        // The catalog is there already.
        .with_create_default_catalog_and_schema(false)
        .with_ballista_logical_extension_codec(Arc::new(TableCodec::default()))
        .with_ballista_grpc_client_max_message_size(MESSAGE as usize);
    let state = SessionStateBuilder::new_from_existing(here.state())
        .with_config(config)
        .build();
    let state = state.upgrade_for_ballista(address.endpoint())?;
    Ok(SessionContext::new_with_state(state))
}

/// What went wrong there, and where that is.
pub(crate) fn told(address: &Address, error: FleetError) -> FleetError {
    match error {
        FleetError::Sql(error) => FleetError::Cluster {
            address: address.to_string(),
            what: without_echo(&error.strip_backtrace()),
        },
        other => other,
    }
}
