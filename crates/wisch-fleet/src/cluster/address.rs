//! Address of a scheduler.

use crate::store::FleetError;
use std::fmt;
use std::net::SocketAddr;
use std::time::Duration;
use tokio::net::TcpStream;
use tokio::time::timeout;
use url::Url;

/// Time after which a scheduler without an answer counts as missing.
const PATIENCE: Duration = Duration::from_secs(10);

/// The address of a scheduler, `df://HOST:PORT`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Address {
    /// Host name; an IPv6 address is in brackets.
    host: String,
    port: u16,
}

impl Address {
    /// Parses a URL.
    ///
    /// # Errors
    /// If it is not of the form `df://HOST:PORT`.
    pub fn parse(url: &str) -> Result<Self, FleetError> {
        let wrong = |shown: &str| FleetError::Url {
            url: shown.to_owned(),
            what: "a scheduler's address is df://HOST:PORT".to_owned(),
        };
        if url.contains('@') {
            // The URL may hold a password, so it is not printed.
            return Err(wrong("…@…"));
        }
        let parsed = Url::parse(url).map_err(|_| wrong(url))?;
        let is_bare = matches!(parsed.path(), "" | "/")
            && parsed.query().is_none()
            && parsed.fragment().is_none();
        match (parsed.scheme(), parsed.host_str(), parsed.port()) {
            ("df", Some(host), Some(port)) if is_bare && !host.is_empty() => Ok(Self {
                host: host.to_owned(),
                port,
            }),
            _ => Err(wrong(url)),
        }
    }

    /// Endpoint for gRPC.
    pub(super) fn endpoint(&self) -> String {
        format!("http://{}:{}", self.host, self.port)
    }

    pub(super) fn host(&self) -> &str {
        &self.host
    }

    pub(super) fn port(&self) -> u16 {
        self.port
    }

    /// Checks that a program listens at the address.
    ///
    /// # Errors
    /// If none does.
    pub(crate) async fn reach(&self) -> Result<(), FleetError> {
        let connected = timeout(PATIENCE, TcpStream::connect((self.bare_host(), self.port))).await;
        let why = match connected {
            Ok(Ok(_)) => return Ok(()),
            Ok(Err(error)) => error.to_string(),
            Err(_) => format!("no answer in {} s", PATIENCE.as_secs()),
        };
        Err(FleetError::Cluster {
            address: self.to_string(),
            what: format!("no scheduler can be reached: {why}"),
        })
    }

    fn bare_host(&self) -> &str {
        self.host.trim_start_matches('[').trim_end_matches(']')
    }
}

impl From<SocketAddr> for Address {
    fn from(address: SocketAddr) -> Self {
        let host = match address {
            SocketAddr::V4(address) => address.ip().to_string(),
            SocketAddr::V6(address) => format!("[{}]", address.ip()),
        };
        Self {
            host,
            port: address.port(),
        }
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "df://{}:{}", self.host, self.port)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_host_and_a_port_are_an_address() {
        for right in [
            "df://127.0.0.1:50050",
            "df://scheduler.local:1",
            "df://[::1]:50050",
        ] {
            assert_eq!(Address::parse(right).unwrap().to_string(), right);
        }
        for wrong in [
            "127.0.0.1:50050",
            "http://127.0.0.1:50050",
            "df://127.0.0.1",
            "df://127.0.0.1:50050/a",
            "df://127.0.0.1:99999",
            "df://:50050",
            "df:",
            "",
        ] {
            let error = Address::parse(wrong).unwrap_err().to_string();
            assert!(error.contains("df://HOST:PORT"), "{wrong}: {error}");
        }
        let error = Address::parse("df://me:secret@127.0.0.1:50050").unwrap_err();
        assert!(!error.to_string().contains("secret"), "{error}");
    }
}
