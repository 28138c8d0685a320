//! `wisch film`, with a program that stands for the browser.

use crate::executor::has_python;
use crate::program::{folder_with, wisch};
use std::fs;
use std::path::Path;

/// Fetches the page, as a browser does, and sends what the script in it would send. `$END`: what it does at last.
const BROWSER: &str = r#"#!/usr/bin/env python3
import sys, urllib.error, urllib.request
url = open(sys.argv[-1]).read().split('"')[1]
page = urllib.request.urlopen(url).read().decode()
assert 'part.value = "2"' in page and "setSpeed(10)" in page and page.endswith("</script></body>\n</html>\n"), page[-3000:]
def post(what, body):
    return urllib.request.urlopen(urllib.request.Request(url.removesuffix("page") + what, data=body)).read()
try:
    urllib.request.urlopen(url.replace("/page", "0/page"))
    sys.exit("another path is answered")
except urllib.error.HTTPError as error:
    assert error.code == 404
post("progress", b"0.5")
$END
"#;

/// Writes a browser that ends in a way, and records the second round of a folder of results with it.
fn film(folder: &Path, end: &str) -> (i32, String, String) {
    use std::os::unix::fs::PermissionsExt;
    let browser = folder.join("browser");
    fs::write(&browser, BROWSER.replace("$END", end)).unwrap();
    fs::set_permissions(&browser, fs::Permissions::from_mode(0o755)).unwrap();
    let args = [
        "film",
        "out",
        "--round",
        "2",
        "--speed",
        "10",
        "--browser",
        "./browser",
        "--json",
    ];
    wisch(folder, &args)
}

#[test]
fn a_film_is_what_the_page_sends_and_faults_leave_no_file() {
    if !has_python() {
        return;
    }
    let folder = folder_with("arm-board.toml");
    let run = [
        "run",
        "task.toml",
        "--rounds",
        "1",
        "--out",
        "out",
        "--no-memory",
    ];
    let (code, _, err) = wisch(folder.path(), &run);
    assert!(code < 2, "{err}");
    let clip = folder.path().join("out.webm");
    for (end, fault) in [
        (
            r#"post("fault", b"there is no round 2: the run has 1")"#,
            "error: there is no round 2: the run has 1",
        ),
        ("sys.exit(3)", "ended before the recording was complete"),
        (r#"post("clip", b"")"#, "the clip is no WebM video"),
    ] {
        let (code, _, err) = film(folder.path(), end);
        assert_eq!(code, 2, "{err}");
        assert!(err.contains(fault), "{err}");
        assert!(!clip.exists(), "nothing is left of a film that failed");
    }
    let end = r#"post("said", "2.4 s at 10×, 0.3 MB. The clip is not of this speed.".encode())
post("clip", b"\x1aE\xdf\xa3" + bytes(range(252)) * 4000)"#;
    let (code, out, err) = film(folder.path(), end);
    assert_eq!(code, 0, "{err}");
    assert_eq!(err, "note: The clip is not of this speed.\n");
    let found: serde_json::Value = serde_json::from_str(&out).expect("one object");
    assert_eq!(found["bytes"], 1_008_004);
    let bytes = fs::read(&clip).unwrap();
    assert!(bytes.len() == 1_008_004 && bytes[4..256].iter().copied().eq(0..252));
}

#[test]
fn what_cannot_be_recorded_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("empty")).unwrap();
    for (args, expected) in [
        (
            &["film", "empty"][..],
            "empty: the folder has no recording.jsonl.gz",
        ),
        (&["film", "gone"], "there is no memory of episodes"),
        (
            &["film", "empty", "--speed", "3"],
            "the speed is 1, 2, 5 or 10",
        ),
        (&["film", "empty", "--size", "10x10"], "from 320 to 3840"),
    ] {
        let (code, _, err) = wisch(folder.path(), args);
        assert_eq!(code, 2, "{err}");
        assert!(err.contains(expected), "{args:?}: {err}");
    }
}
