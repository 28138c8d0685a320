//! An S3 server on loopback. `s3s-fs` checks whether an object exists and then writes it, so that two writers may both
//! succeed. This server handles one PUT at a time, so that creation is atomic as in S3.

use hyper_util::rt::{TokioExecutor, TokioIo};
use hyper_util::server::conn::auto::Builder;
use s3s::auth::SimpleAuth;
use s3s::service::S3ServiceBuilder;
use std::path::Path;
use std::process::Command;
use std::sync::Arc;
use tokio::net::TcpListener;
use tokio::runtime::Runtime;
use tokio::sync::Mutex;

pub const KEY_ID: &str = "fleet-test-key";
pub const SECRET: &str = "fleet-test-secret";

/// A server, which runs until it is dropped.
pub struct Server {
    port: u16,
    _runtime: Runtime,
}

impl Server {
    /// Starts a server of the buckets in a folder.
    pub fn start(folder: &Path) -> Self {
        std::fs::create_dir_all(folder.join("fleet")).unwrap();
        let mut builder = S3ServiceBuilder::new(s3s_fs::FileSystem::new(folder).unwrap());
        builder.set_auth(SimpleAuth::from_single(KEY_ID, SECRET));
        let service = builder.build();
        let runtime = Runtime::new().unwrap();
        let listener = runtime.block_on(TcpListener::bind("127.0.0.1:0")).unwrap();
        let port = listener.local_addr().unwrap().port();
        let puts = Arc::new(Mutex::new(()));
        runtime.spawn(async move {
            loop {
                let (socket, _) = listener.accept().await.unwrap();
                let (service, puts) = (service.clone(), Arc::clone(&puts));
                tokio::spawn(async move {
                    let one = hyper::service::service_fn(
                        move |request: hyper::Request<hyper::body::Incoming>| {
                            let (service, puts) = (service.clone(), Arc::clone(&puts));
                            async move {
                                let is_put = request.method() == hyper::Method::PUT;
                                let _alone = if is_put {
                                    Some(puts.lock().await)
                                } else {
                                    None
                                };
                                hyper::service::Service::call(&service, request).await
                            }
                        },
                    );
                    let builder = Builder::new(TokioExecutor::new());
                    // A client may be killed during a request.
                    let _ = builder.serve_connection(TokioIo::new(socket), one).await;
                });
            }
        });
        Self {
            port,
            _runtime: runtime,
        }
    }

    /// Returns the program with the environment for this server.
    pub fn program(&self, secret: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_wisch-fleet"));
        command
            .env("AWS_ACCESS_KEY_ID", KEY_ID)
            .env("AWS_SECRET_ACCESS_KEY", secret)
            .env("AWS_ENDPOINT", format!("http://127.0.0.1:{}", self.port))
            .env("AWS_ALLOW_HTTP", "true")
            .env("AWS_REGION", "us-east-1");
        command
    }
}
