//! Access control.

use crate::client::send;
use crate::place::Place;
use std::io::{ErrorKind, Read};
use std::net::{Ipv4Addr, TcpStream};
use std::time::Duration;

#[test]
fn requests_without_the_token_get_nothing() {
    let place = Place::new();
    let token = place.base.trim_matches('/');
    assert_eq!(token.len(), 32);
    let other: String = token
        .chars()
        .map(|c| if c == '0' { '1' } else { '0' })
        .collect();
    let near = format!(
        "{}{}",
        &token[..31],
        if token.ends_with('0') { '1' } else { '0' }
    );
    for path in [
        "/".to_owned(),
        "/api/overview".to_owned(),
        format!("/{other}/"),
        format!("/{near}/api/overview"),
        format!("/{}/", &token[..31]),
        format!("/{token}0/"),
        format!("//{token}/"),
        format!("/x/../{token}/"),
    ] {
        let answer = send(&place.address, "GET", &path, &[], "");
        assert_eq!(answer.status, 404, "{path}");
        assert_eq!(answer.body, b"", "{path}");
    }
    assert_eq!(place.get("").status, 200);
}

#[test]
fn tokens_differ() {
    assert_ne!(Place::new().base, Place::new().base);
}

#[test]
fn a_foreign_host_name_is_refused() {
    let place = Place::new();
    let port = place.address.rsplit(':').next().unwrap();
    for (host, status) in [
        (format!("evil.example:{port}"), 421),
        (format!("127.0.0.1.evil.example:{port}"), 421),
        ("127.0.0.1".to_owned(), 421),
        ("127.0.0.1:1".to_owned(), 421),
        (String::new(), 421),
        (format!("127.0.0.1:{port}"), 200),
        (format!("localhost:{port}"), 200),
        (format!("LOCALHOST:{port}"), 200),
        (format!("[::1]:{port}"), 200),
    ] {
        let answer = place.get_with("api/overview", &[("Host", &host)]);
        assert_eq!(answer.status, status, "{host:?}");
    }
}

/// On Linux, all addresses from 127.0.0.1 to 127.255.255.254 are local.
#[cfg(target_os = "linux")]
#[test]
fn a_studio_at_all_addresses_answers_at_each_of_them() {
    let place = Place::at(Ipv4Addr::UNSPECIFIED.into());
    assert!(place.address.starts_with("127.0.0.1:"), "{}", place.address);
    let port = place.address.rsplit(':').next().unwrap();
    let path = format!("{}api/overview", place.base);
    let here = format!("127.0.0.2:{port}");
    for (host, status) in [
        (here.clone(), 200),
        (format!("localhost:{port}"), 200),
        (format!("127.0.0.3:{port}"), 421),
        (format!("0.0.0.0:{port}"), 421),
        (format!("evil.example:{port}"), 421),
    ] {
        let answer = send(&here, "GET", &path, &[("Host", &host)], "");
        assert_eq!(answer.status, status, "{host}");
    }
    let own = format!("http://{here}");
    let foreign = format!("http://127.0.0.3:{port}");
    for (origin, status) in [(own, 200), (foreign, 403)] {
        let answer = send(&here, "GET", &path, &[("Origin", &origin)], "");
        assert_eq!(answer.status, status, "{origin}");
    }
}

#[test]
fn idle_connections_block_no_client() {
    let place = Place::new();
    let idle: Vec<TcpStream> = (0..200)
        .map(|_| TcpStream::connect(&place.address).unwrap())
        .collect();
    assert_eq!(place.get("api/overview").status, 200);
    // The first connections were closed.
    for mut one in &idle[..64] {
        one.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        let read = one.read(&mut [0]);
        assert!(
            matches!(read, Ok(0))
                || read.is_err_and(|error| error.kind() == ErrorKind::ConnectionReset)
        );
    }
}

#[test]
fn requests_from_other_pages_are_refused() {
    let place = Place::new();
    let own = format!("http://{}", place.address);
    let secure = format!("https://{}", place.address);
    for (origin, status) in [
        ("https://evil.example", 403),
        ("http://127.0.0.1:1", 403),
        ("null", 403),
        (secure.as_str(), 403),
        (own.as_str(), 200),
    ] {
        let answer = place.get_with("api/overview", &[("Origin", origin)]);
        assert_eq!(answer.status, status, "{origin}");
        assert!(!answer.headers.contains_key("access-control-allow-origin"));
    }
}

#[test]
fn responses_carry_security_headers() {
    let place = Place::new();
    for path in ["", "api/overview", "nothing"] {
        let headers = place.get(path).headers;
        for (name, value) in [
            ("referrer-policy", "no-referrer"),
            ("x-content-type-options", "nosniff"),
            ("cache-control", "no-store"),
            ("cross-origin-resource-policy", "same-origin"),
        ] {
            assert_eq!(headers[name], value, "{path}");
        }
        let policy = &headers["content-security-policy"];
        assert!(policy.contains("default-src 'none'"), "{path}: {policy}");
        assert!(
            policy.contains("frame-ancestors 'none'"),
            "{path}: {policy}"
        );
    }
}

#[test]
fn only_the_pages_script_may_run() {
    let place = Place::new();
    let page = place.get("");
    let policy = &page.headers["content-security-policy"];
    let (_, rest) = policy.split_once("'nonce-").unwrap();
    let (nonce, _) = rest.split_once('\'').unwrap();
    let text = page.text();
    assert_eq!(
        text.matches(&format!("<script nonce=\"{nonce}\">")).count(),
        1
    );
    assert!(!policy.contains("unsafe-eval") && !policy.contains("script-src 'unsafe-inline'"));
    assert_ne!(policy, &place.get("").headers["content-security-policy"]);
}
