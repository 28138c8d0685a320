//! Who is let in: requests with the token, to this address, from this page.
//!
//! The token keeps out other users of this machine and pages that guess; the `Host` header those that point a name of
//! their own at this address (DNS rebinding); the `Origin` header other pages that know the token.

use axum::body::Body;
use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use std::net::{IpAddr, SocketAddr};
use std::sync::Arc;

/// Length of a token [bytes].
const TOKEN_BYTES: usize = 16;

/// What is checked of every request.
#[derive(Debug)]
pub struct Gate {
    token: String,
    /// What the `Host` header may be.
    hosts: Vec<String>,
}

impl Gate {
    /// For a server that listens here, with a token that nobody can guess.
    pub fn new(address: SocketAddr) -> Result<Self, getrandom::Error> {
        let mut bytes = [0; TOKEN_BYTES];
        getrandom::fill(&mut bytes)?;
        Ok(Self {
            token: in_hex(&bytes),
            hosts: hosts(address),
        })
    }

    /// What stands in the path before everything.
    pub fn token(&self) -> &str {
        &self.token
    }

    /// Why a request is not let in, if it is not.
    fn refusal(&self, path: &str, headers: &HeaderMap) -> Option<StatusCode> {
        let host = headers
            .get(header::HOST)
            .and_then(|host| host.to_str().ok());
        if !host.is_some_and(|host| self.is_here(host)) {
            return Some(StatusCode::MISDIRECTED_REQUEST);
        }
        if let Some(origin) = headers.get(header::ORIGIN) {
            let origin = origin.to_str().unwrap_or_default();
            let is_own = origin
                .strip_prefix("http://")
                .is_some_and(|from| self.is_here(from));
            if !is_own {
                return Some(StatusCode::FORBIDDEN);
            }
        }
        let first = path.strip_prefix('/').unwrap_or_default();
        let (token, _) = first.split_once('/').unwrap_or((first, ""));
        (!is_same(token.as_bytes(), self.token.as_bytes())).then_some(StatusCode::NOT_FOUND)
    }

    fn is_here(&self, host: &str) -> bool {
        (self.hosts.iter()).any(|known| known.eq_ignore_ascii_case(host))
    }
}

/// Lets a request in or not, and says to browsers what the answer may be used for.
pub async fn pass(State(gate): State<Arc<Gate>>, request: Request<Body>, next: Next) -> Response {
    let refused = gate.refusal(request.uri().path(), request.headers());
    let mut response = match refused {
        Some(status) => status.into_response(),
        None => next.run(request).await,
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

/// What the page may do; its script is known by a number that is drawn for each answer.
pub fn page_policy(nonce: &str) -> String {
    format!(
        "default-src 'none'; script-src 'nonce-{nonce}'; style-src 'unsafe-inline'; connect-src 'self'; \
         img-src 'self' data: blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    )
}

/// A random text of the length of a token.
pub fn nonce() -> Result<String, getrandom::Error> {
    let mut bytes = [0; TOKEN_BYTES];
    getrandom::fill(&mut bytes)?;
    Ok(in_hex(&bytes))
}

fn in_hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Whether two texts are the same; how long it takes says nothing of where they differ.
fn is_same(a: &[u8], b: &[u8]) -> bool {
    let differing = a.iter().zip(b).fold(0, |all, (a, b)| all | (a ^ b));
    a.len() == b.len() && std::hint::black_box(differing) == 0
}

/// The `Host` headers of requests that are meant for this address.
fn hosts(address: SocketAddr) -> Vec<String> {
    let names = ["127.0.0.1", "localhost", "[::1]"].map(str::to_owned);
    let own = match address.ip() {
        IpAddr::V4(ip) => ip.to_string(),
        IpAddr::V6(ip) => format!("[{ip}]"),
    };
    let port = address.port();
    let names = names.into_iter().chain([own]);
    names
        .flat_map(|name| {
            // Browsers leave the usual port out.
            let short = (port == 80).then(|| name.clone());
            short.into_iter().chain([format!("{name}:{port}")])
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refusal(path: &str, headers: &[(&'static str, &'static str)]) -> Option<u16> {
        let gate = Gate {
            token: "a0b1".to_owned(),
            hosts: hosts("127.0.0.1:80".parse().unwrap()),
        };
        let headers = headers.iter().map(|(name, value)| {
            (
                header::HeaderName::from_static(name),
                HeaderValue::from_static(value),
            )
        });
        let refused = gate.refusal(path, &headers.collect());
        refused.map(|status| status.as_u16())
    }

    #[test]
    fn only_the_whole_token_opens() {
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
    fn the_usual_port_is_left_out() {
        for host in ["127.0.0.1", "localhost:80", "[::1]"] {
            assert_eq!(refusal("/a0b1/", &[("host", host)]), None, "{host}");
        }
        assert_eq!(refusal("/a0b1/", &[]), Some(421));
        let own = [("host", "localhost"), ("origin", "http://localhost")];
        assert_eq!(refusal("/a0b1/", &own), None);
        let foreign = [("host", "localhost"), ("origin", "http://localhost:81")];
        assert_eq!(refusal("/a0b1/", &foreign), Some(403));
    }
}
