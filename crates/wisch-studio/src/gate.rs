//! Access control: requests need the token, an address of this machine, and this page as origin.
//!
//! The token keeps out other users of this machine and pages that guess. The `Host` header keeps out pages whose own
//! name resolves to this address (DNS rebinding). The `Origin` header keeps out other pages that know the token.

use crate::connections::Connection;
use crate::refusal::Refusal;
use axum::Extension;
use axum::body::{Body, to_bytes};
use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use std::net::{IpAddr, SocketAddr};
use std::sync::Arc;
use std::time::Duration;

/// Length of a token [bytes].
const TOKEN_BYTES: usize = 16;

/// Largest size of a request's body [bytes].
const LONGEST_BODY: usize = 1 << 16;
/// Longest time in which a client may send the body.
const BODY_TIME: Duration = Duration::from_secs(10);
/// Names of this machine, beside the address that a connection has reached.
const OWN_NAMES: [&str; 3] = ["127.0.0.1", "localhost", "[::1]"];

/// Access control of every request.
#[derive(Debug)]
pub struct Gate {
    token: String,
    port: u16,
}

impl Gate {
    /// Creates the access control of a server at this address, with a random token.
    pub fn new(address: SocketAddr) -> Result<Self, getrandom::Error> {
        let mut bytes = [0; TOKEN_BYTES];
        getrandom::fill(&mut bytes)?;
        Ok(Self {
            token: in_hex(&bytes),
            port: address.port(),
        })
    }

    /// Token, the first part of every path.
    pub fn token(&self) -> &str {
        &self.token
    }

    /// Returns the status with which a request is refused, if it is. `local` is the address of this machine that it
    /// reached.
    fn refusal(&self, path: &str, headers: &HeaderMap, local: IpAddr) -> Option<StatusCode> {
        let host = headers
            .get(header::HOST)
            .and_then(|host| host.to_str().ok());
        if !host.is_some_and(|host| self.is_here(host, local)) {
            return Some(StatusCode::MISDIRECTED_REQUEST);
        }
        if let Some(origin) = headers.get(header::ORIGIN) {
            let origin = origin.to_str().unwrap_or_default();
            let is_own = origin
                .strip_prefix("http://")
                .is_some_and(|from| self.is_here(from, local));
            if !is_own {
                return Some(StatusCode::FORBIDDEN);
            }
        }
        let first = path.strip_prefix('/').unwrap_or_default();
        let (token, _) = first.split_once('/').unwrap_or((first, ""));
        (!is_same(token.as_bytes(), self.token.as_bytes())).then_some(StatusCode::NOT_FOUND)
    }

    /// Whether a `Host` header is `local`, or a name of this machine. An IP address cannot be rebound by DNS, and the
    /// address that a connection has reached belongs to this machine.
    fn is_here(&self, host: &str, local: IpAddr) -> bool {
        let name = match host.strip_suffix(&format!(":{}", self.port)) {
            Some(name) => name,
            // Browsers omit the default port.
            None if self.port == 80 => host,
            None => return false,
        };
        let is_own = OWN_NAMES.iter().any(|own| own.eq_ignore_ascii_case(name));
        is_own || address(name) == Some(local.to_canonical())
    }
}

/// Returns the IP address of a host, if it is stated as an address.
fn address(host: &str) -> Option<IpAddr> {
    match host.strip_prefix('[') {
        Some(rest) => Some(IpAddr::V6(rest.strip_suffix(']')?.parse().ok()?)),
        None => Some(IpAddr::V4(host.parse().ok()?)),
    }
}

/// Admits or refuses a request, and sets security headers for browsers.
pub async fn pass(
    State(gate): State<Arc<Gate>>,
    Extension(connection): Extension<Arc<Connection>>,
    request: Request<Body>,
    next: Next,
) -> Response {
    let local = connection.local().ip();
    let mut response = match gate.refusal(request.uri().path(), request.headers(), local) {
        Some(status) => status.into_response(),
        None => {
            connection.admit();
            match receive(request).await {
                Ok(request) => next.run(request).await,
                Err(refusal) => refusal.into_response(),
            }
        }
    };
    let headers = response.headers_mut();
    for (name, value) in [
        (header::REFERRER_POLICY, "no-referrer"),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::CACHE_CONTROL, "no-store"),
        (header::X_FRAME_OPTIONS, "DENY"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    headers.insert(
        "cross-origin-resource-policy",
        HeaderValue::from_static("same-origin"),
    );
    headers.insert(
        "cross-origin-opener-policy",
        HeaderValue::from_static("same-origin"),
    );
    headers
        .entry(header::CONTENT_SECURITY_POLICY)
        .or_insert(HeaderValue::from_static(
            "default-src 'none'; frame-ancestors 'none'",
        ));
    response
}

/// Returns a request once its whole body has arrived.
///
/// # Errors
/// If the body is too large or takes too long.
async fn receive(request: Request<Body>) -> Result<Request<Body>, Refusal> {
    let (head, body) = request.into_parts();
    match tokio::time::timeout(BODY_TIME, to_bytes(body, LONGEST_BODY)).await {
        Ok(Ok(bytes)) => Ok(Request::from_parts(head, Body::from(bytes))),
        Ok(Err(error)) => {
            let why = format!(
                "the request cannot be read, or exceeds the limit of {LONGEST_BODY} bytes: {error}"
            );
            Err(Refusal::new(StatusCode::PAYLOAD_TOO_LARGE, why))
        }
        Err(_) => {
            let why = format!("the request was not sent within {} s", BODY_TIME.as_secs());
            Err(Refusal::new(StatusCode::REQUEST_TIMEOUT, why))
        }
    }
}

/// Returns the page's content security policy; `nonce` identifies its script, and is random for each answer.
pub fn page_policy(nonce: &str) -> String {
    format!(
        "default-src 'none'; script-src 'nonce-{nonce}'; style-src 'unsafe-inline'; connect-src 'self'; \
         img-src 'self' data: blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    )
}

/// Returns a random text of the length of a token.
pub fn nonce() -> Result<String, getrandom::Error> {
    let mut bytes = [0; TOKEN_BYTES];
    getrandom::fill(&mut bytes)?;
    Ok(in_hex(&bytes))
}

fn in_hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Whether two texts are equal; the time it takes does not reveal where they differ.
fn is_same(a: &[u8], b: &[u8]) -> bool {
    let differing = a.iter().zip(b).fold(0, |all, (a, b)| all | (a ^ b));
    a.len() == b.len() && std::hint::black_box(differing) == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refusal(path: &str, headers: &[(&'static str, &'static str)]) -> Option<u16> {
        let gate = Gate {
            token: "a0b1".to_owned(),
            port: 80,
        };
        let local = [192, 168, 1, 5].into();
        let headers = headers.iter().map(|(name, value)| {
            (
                header::HeaderName::from_static(name),
                HeaderValue::from_static(value),
            )
        });
        let refused = gate.refusal(path, &headers.collect(), local);
        refused.map(|status| status.as_u16())
    }

    #[test]
    fn only_the_whole_token_is_accepted() {
        let host = [("host", "localhost")];
        for path in ["/a0b1", "/a0b1/", "/a0b1/api/overview"] {
            assert_eq!(refusal(path, &host), None, "{path}");
        }
        for path in [
            "", "/", "/a0b", "/a0b10", "/a0b2/", "/A0B1/", "//a0b1/", "/x/a0b1",
        ] {
            assert_eq!(refusal(path, &host), Some(404), "{path}");
        }
    }

    #[test]
    fn the_default_port_may_be_omitted() {
        for host in ["127.0.0.1", "localhost:80", "[::1]"] {
            assert_eq!(refusal("/a0b1/", &[("host", host)]), None, "{host}");
        }
        for host in ["localhost:8080", "127.0.0.1:8"] {
            assert_eq!(refusal("/a0b1/", &[("host", host)]), Some(421), "{host}");
        }
        assert_eq!(refusal("/a0b1/", &[]), Some(421));
        let own = [("host", "localhost"), ("origin", "http://localhost")];
        assert_eq!(refusal("/a0b1/", &own), None);
        let foreign = [("host", "localhost"), ("origin", "http://localhost:81")];
        assert_eq!(refusal("/a0b1/", &foreign), Some(403));
    }

    #[test]
    fn the_reached_address_is_accepted_as_host() {
        for host in ["192.168.1.5", "192.168.1.5:80"] {
            assert_eq!(refusal("/a0b1/", &[("host", host)]), None, "{host}");
        }
        for host in [
            "192.168.1.6",
            "0.0.0.0",
            "[::ffff:192.168.1.6]",
            "5.evil.example",
        ] {
            assert_eq!(refusal("/a0b1/", &[("host", host)]), Some(421), "{host}");
        }
        let gate = Gate {
            token: String::new(),
            port: 80,
        };
        let v6 = "2001:db8::5".parse().unwrap();
        assert!(gate.is_here("[2001:db8:0::5]", v6) && !gate.is_here("2001:db8::5", v6));
        // A listener for both families gets IPv4 addresses in mapped form.
        assert!(gate.is_here("192.168.1.5:80", "::ffff:192.168.1.5".parse().unwrap()));
    }
}
