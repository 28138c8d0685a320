//! Connections: their number, and the time that a client may take for a request.
//!
//! A connection without an admitted request is closed in favour of a new one, so idle sockets do not block clients.

use axum::Router;
use axum::extract::Request;
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::{Service, service_fn};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::io;
use std::net::SocketAddr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use tokio::net::{TcpListener, TcpStream};
use tokio::task::{AbortHandle, JoinSet};

/// Limits of connections.
#[derive(Debug, Clone, Copy)]
pub struct ConnectionLimits {
    /// Largest number of open connections.
    pub count: usize,
    /// Longest time for the head of a request, and for a connection without a request.
    pub head: Duration,
}

/// Fewer connections than files that a process may open on any system: 256 on macOS.
pub const LIMITS: ConnectionLimits = ConnectionLimits {
    count: 128,
    head: Duration::from_secs(30),
};
/// Pause after the system has refused a connection, for example because too many files are open.
const ACCEPT_AGAIN: Duration = Duration::from_millis(100);

/// State of a connection that its requests share.
#[derive(Debug)]
pub struct Connection {
    /// Address of this machine that the client has reached.
    local: SocketAddr,
    is_admitted: AtomicBool,
}

impl Connection {
    /// Address of this machine that the client has reached.
    pub fn local(&self) -> SocketAddr {
        self.local
    }

    /// Records that a request with the token came over this connection.
    pub fn admit(&self) {
        self.is_admitted.store(true, Ordering::Relaxed);
    }
}

/// Answers requests until `until` is over. Returns the connections that are still open; dropping them closes them.
///
/// # Errors
/// If the listener is gone.
pub async fn answer(
    listener: TcpListener,
    router: Router,
    limits: ConnectionLimits,
    until: impl Future<Output = ()>,
) -> JoinSet<()> {
    let mut tasks = JoinSet::new();
    let mut open: Vec<(Arc<Connection>, AbortHandle)> = Vec::new();
    let mut until = std::pin::pin!(until);
    loop {
        let accepted = tokio::select! {
            () = &mut until => return tasks,
            Some(_) = tasks.join_next() => continue,
            accepted = listener.accept() => accepted,
        };
        let Ok((stream, _)) = accepted else {
            tokio::time::sleep(ACCEPT_AGAIN).await;
            continue;
        };
        let Ok(local) = stream.local_addr() else {
            continue;
        };
        open.retain(|(_, task)| !task.is_finished());
        if open.len() >= limits.count {
            let is_idle =
                |(one, _): &(Arc<Connection>, _)| !one.is_admitted.load(Ordering::Relaxed);
            let Some(oldest) = open.iter().position(is_idle) else {
                continue;
            };
            open.remove(oldest).1.abort();
        }
        let connection = Arc::new(Connection {
            local,
            is_admitted: AtomicBool::new(false),
        });
        let answering = answer_one(stream, router.clone(), limits, Arc::clone(&connection));
        open.push((connection, tasks.spawn(answering)));
    }
}

/// Answers the requests of one connection, one after the other.
async fn answer_one(
    stream: TcpStream,
    router: Router,
    limits: ConnectionLimits,
    connection: Arc<Connection>,
) {
    // Events are short and should be sent at once.
    let _ = stream.set_nodelay(true);
    let router = TowerToHyperService::new(router);
    let service = service_fn(move |mut request: Request<Incoming>| {
        request.extensions_mut().insert(Arc::clone(&connection));
        router.call(request)
    });
    let mut http = http1::Builder::new();
    http.timer(TokioTimer::new())
        .header_read_timeout(limits.head);
    // A connection that breaks off affects no other.
    let _ = http.serve_connection(TokioIo::new(stream), service).await;
}

/// Returns the addresses of this machine at which a listener on `bound` is reached from elsewhere.
///
/// # Errors
/// If the system does not list its addresses.
pub fn addresses_of_machine(bound: SocketAddr) -> io::Result<Vec<SocketAddr>> {
    if !bound.ip().is_unspecified() {
        return Ok(Vec::new());
    }
    let interfaces = if_addrs::get_if_addrs()?;
    let ips = interfaces
        .iter()
        .filter(|one| !one.is_loopback() && !one.is_link_local());
    let ips = ips
        .map(|one| one.ip())
        .filter(|ip| ip.is_ipv4() == bound.is_ipv4());
    let mut addresses: Vec<SocketAddr> = ips.map(|ip| SocketAddr::new(ip, bound.port())).collect();
    addresses.sort_unstable();
    addresses.dedup();
    Ok(addresses)
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::Extension;
    use axum::routing::get;
    use std::io::{Read, Write};
    use std::net::TcpStream as Client;

    /// Starts a server that admits every request, with these limits. Returns its address.
    async fn begin(limits: ConnectionLimits) -> SocketAddr {
        let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
        let address = listener.local_addr().unwrap();
        let admit = |Extension(connection): Extension<Arc<Connection>>| async move {
            connection.admit();
            connection.local().to_string()
        };
        let router = Router::new().route("/", get(admit));
        tokio::spawn(answer(listener, router, limits, std::future::pending()));
        address
    }

    fn connect(address: SocketAddr) -> Client {
        let client = Client::connect(address).unwrap();
        let patience = Some(Duration::from_secs(30));
        client.set_read_timeout(patience).unwrap();
        client
    }

    /// Sends a request and returns the answer's last line.
    fn ask(client: &mut Client, local: SocketAddr) {
        client
            .write_all(b"GET / HTTP/1.1\r\nHost: x\r\n\r\n")
            .unwrap();
        let mut answer = Vec::new();
        while !answer.ends_with(local.to_string().as_bytes()) {
            let mut byte = [0];
            client.read_exact(&mut byte).unwrap();
            answer.extend(byte);
        }
    }

    /// Whether the server has closed the connection; an error is a time-out.
    fn is_closed(client: &mut Client) -> bool {
        match client.read(&mut [0; 1024]) {
            Ok(read) => read == 0,
            Err(error) => error.kind() == io::ErrorKind::ConnectionReset,
        }
    }

    #[tokio::test(flavor = "multi_thread")]
    async fn an_unfinished_request_times_out() {
        let limits = ConnectionLimits {
            count: 8,
            head: Duration::from_millis(50),
        };
        let address = begin(limits).await;
        for sent in ["", "GET / HTT", "GET / HTTP/1.1\r\nHost: x\r\n"] {
            let mut client = connect(address);
            client.write_all(sent.as_bytes()).unwrap();
            assert!(is_closed(&mut client), "{sent:?}");
        }
    }

    #[tokio::test(flavor = "multi_thread")]
    async fn idle_connections_are_closed_before_used_ones() {
        let limits = ConnectionLimits {
            count: 4,
            head: Duration::from_secs(600),
        };
        let address = begin(limits).await;
        let mut used = connect(address);
        ask(&mut used, address);
        let mut idle: Vec<Client> = (0..20).map(|_| connect(address)).collect();
        let mut late = connect(address);
        ask(&mut late, address);
        for client in &mut idle[..17] {
            assert!(is_closed(client));
        }
        ask(&mut used, address);
    }

    #[test]
    fn a_specific_address_is_the_only_one() {
        let bound = "127.0.0.1:8080".parse().unwrap();
        assert_eq!(addresses_of_machine(bound).unwrap(), []);
        let any: SocketAddr = "0.0.0.0:8080".parse().unwrap();
        for address in addresses_of_machine(any).unwrap() {
            assert!(address.is_ipv4() && address.port() == 8080 && !address.ip().is_loopback());
        }
    }
}
