//! Calls of services that never wait longer than a limit.

use crate::link::{Link, LinkError, service_qos};
use crate::robot_file::MappingChoice;
use futures::FutureExt;
use futures::channel::oneshot;
use futures::executor::block_on;
use futures::future::{Either, select};
use ros2_client::{Client, Message, Name, RmwRequestId, ServiceTypeName};
use std::pin::pin;
use std::time::{Duration, Instant};

/// Period at which an answer is polled.
const POLL: Duration = Duration::from_millis(2);
/// Period at which a match is awaited anew.
const MATCH_PERIOD: Duration = Duration::from_millis(200);

/// A client of one service.
pub(crate) struct Service<Q: Message, A: Message> {
    name: String,
    client: Client<Q, A>,
}

impl<Q: Message + Clone + 'static, A: Message + 'static> Service<Q, A> {
    /// Connects to a service, for which it waits until `deadline`.
    ///
    /// # Errors
    /// If no server is found or its mapping is unknown.
    pub fn connect(
        link: &mut Link,
        name: &str,
        [package, kind]: [&str; 2],
        choice: MappingChoice,
        deadline: Instant,
    ) -> Result<Self, LinkError> {
        let mapping = link.mapping(name, choice, deadline)?;
        let failed = |error: String| LinkError(format!("service {name}: {error}"));
        let full = Name::parse(name).map_err(|error| failed(error.to_string()))?;
        let client = link.node_mut().create_client::<Q, A>(
            mapping,
            &full,
            &ServiceTypeName::new(package, kind),
            service_qos(),
            service_qos(),
        );
        let client = client.map_err(|error| failed(error.to_string()))?;
        let is_matched = wait_for_match(deadline, || client.wait_for_service(link.node()));
        if !is_matched {
            return Err(failed(format!(
                "found, but it does not match type {package}/srv/{kind}"
            )));
        }
        Ok(Self {
            name: name.to_owned(),
            client,
        })
    }

    pub fn name(&self) -> &str {
        &self.name
    }

    /// Sends a request; the answer is polled with [`Self::answer`].
    ///
    /// # Errors
    /// If it cannot be sent.
    pub fn send(&self, request: Q) -> Result<RmwRequestId, LinkError> {
        let sent = self.client.send_request(request);
        sent.map_err(|error| LinkError(format!("service {}: {error}", self.name)))
    }

    /// The answer to a request, if it has arrived.
    pub fn answer(&self, request: RmwRequestId) -> Option<A> {
        loop {
            match self.client.receive_response() {
                Ok(Some((id, answer))) if id == request => return Some(answer),
                Ok(Some(_)) => {}
                Ok(None) | Err(_) => return None,
            }
        }
    }

    /// Calls the service and waits for its answer.
    ///
    /// # Errors
    /// If no answer arrives within `limit`.
    pub fn call(&self, request: Q, limit: Duration) -> Result<A, LinkError> {
        let id = self.send(request)?;
        let deadline = Instant::now() + limit;
        loop {
            if let Some(answer) = self.answer(id) {
                return Ok(answer);
            }
            if Instant::now() >= deadline {
                let seconds = (100.0 * limit.as_secs_f64()).round() / 100.0;
                return Err(LinkError(format!(
                    "service {} has not answered for {seconds} s",
                    self.name
                )));
            }
            std::thread::sleep(POLL);
        }
    }
}

/// Waits until a match that `wait` waits for, at most until `deadline`. Returns whether it was found.
///
/// The library may lose the event of a match while many arrive, so that a single wait would not end.
pub(crate) fn wait_for_match<F: Future<Output = ()>>(
    deadline: Instant,
    wait: impl Fn() -> F,
) -> bool {
    loop {
        if within(MATCH_PERIOD, wait()).is_some() {
            return true;
        }
        if Instant::now() >= deadline {
            return false;
        }
    }
}

/// Waits for a future, at most for a time; `None` if it has not completed then.
fn within<T>(limit: Duration, future: impl Future<Output = T>) -> Option<T> {
    let (ring, alarm) = oneshot::channel::<()>();
    std::thread::spawn(move || {
        std::thread::sleep(limit);
        let _ = ring.send(());
    });
    block_on(async {
        match select(pin!(future.fuse()), alarm).await {
            Either::Left((value, _)) => Some(value),
            Either::Right(_) => None,
        }
    })
}
