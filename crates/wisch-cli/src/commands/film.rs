//! `wisch film`: records the scene of a run as a video, by the page of its report in a browser without a window.

use super::report::recording_page;
use crate::args::{FilmArgs, GlobalArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, print_json, remark};
use std::collections::hash_map::RandomState;
use std::hash::{BuildHasher, Hasher};
use std::io::{self, ErrorKind, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use wisch_io::OutputFile;

/// Names of browsers that can record, in the order in which they are sought.
const BROWSERS: [&str; 6] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "chrome",
    "microsoft-edge",
];
/// Longest time without progress.
const PATIENCE: Duration = Duration::from_secs(90);
/// Longest time for a request.
const REQUEST: Duration = Duration::from_secs(5);
const PERIOD: Duration = Duration::from_millis(20);
/// The first bytes of a WebM file.
const WEBM: [u8; 4] = [0x1a, 0x45, 0xdf, 0xa3];
/// Largest head of a request, and largest clip [bytes].
const MAX_HEAD: usize = 1 << 16;
const MAX_CLIP: usize = 1 << 30;
/// A shell script that starts a browser and ends with it. When standard input closes, however this program ends, the script
/// ends the browser and all processes of the browser. `$0` is the folder of the browser's profile, which the script removes.
const KEEPER: &str = r#"exec 3<&0
"$@" 3<&- </dev/null >/dev/null 2>&1 & browser=$!
(trap '' TERM; cat <&3 >/dev/null; kill $browser; sleep 3; rm -rf "$0"; kill -KILL 0) >/dev/null 2>&1 &
wait $browser; code=$?
trap '' TERM; kill -TERM 0 2>/dev/null
rm -rf "$0" 2>/dev/null || { sleep 1; rm -rf "$0"; }
exit $code"#;

/// A script by which the page records the clip and sends it, in place of a person.
const SCRIPT: &str = r#"<script>
(async () => {
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  const post = (what, body) => fetch(what, { method: "POST", body });
  try {
    for (const until = performance.now() + 60e3; !(window.wisch?.view?.stage?.drawn > 0);) {
      if (performance.now() > until) throw new Error("the page draws no scene within 60 s: this browser may lack WebGL");
      await wait(200);
    }
    const film = document.querySelector(".w-film");
    if (!film) throw new Error("the page has no scene that can be recorded");
    const [part, said] = [film.querySelector("select"), film.querySelector("p")];
    part.value = "ROUND";
    if (part.value !== "ROUND") throw new Error(`there is no round ROUND: the run has ${part.length - 1}`);
    window.wisch.view.clock.setSpeed(SPEED);
    const start = film.querySelector("button");
    if (start.disabled) throw new Error(said.innerText || said.textContent);
    start.click();
    const [link, progress] = [film.querySelector("a"), film.querySelector("progress")];
    while (link.hidden) {
      if (progress.hidden) throw new Error(said.textContent);
      await post("progress", String(progress.value));
      await wait(500);
    }
    await post("said", said.textContent);
    await post("clip", await (await fetch(link.href)).blob());
  } catch (error) {
    await post("fault", String(error?.message ?? error));
  }
})();
</script>"#;

/// Records a run.
pub fn film(args: &FilmArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let (page, name) = recording_page(&args.what, &args.memory.memory)?;
    let out = (args.out.clone()).unwrap_or_else(|| PathBuf::from(format!("{name}.webm")));
    if out
        .extension()
        .is_none_or(|extension| !extension.eq_ignore_ascii_case("webm"))
    {
        return Err(
            Failure::new(format!("{}: the clip is WebM video", out.display()))
                .with_help("choose a file name that ends in .webm"),
        );
    }
    let browser = find_browser(args.browser.as_deref())?;
    // The file comes before the recording, so that a missing permission is reported at once.
    let file = OutputFile::begin(&out)?;
    let progress = Progress::start(global);
    progress.say("starting the browser");
    let script = SCRIPT
        .replace("ROUND", &args.round.unwrap_or(0).to_string())
        .replace("SPEED", &args.speed.to_string());
    let page = page.replace("</body>", &format!("{script}</body>"));
    let mut set = FilmSet::open(&browser, args.size)?;
    let Clip { video, said } = set.record(&page, &progress)?;
    drop(progress);
    file.finish(&video)?;
    drop(set);
    if let Some((_, doubt)) = said.split_once(" MB. ") {
        remark(doubt);
    }
    let shown = out.display().to_string();
    if args.json {
        print_json(&serde_json::json!({ "out": shown, "bytes": video.len(), "recorded": said }))?;
    } else if !global.quiet {
        print(&format!("{shown}: {said}\n"))?;
    }
    Ok(Outcome::Done)
}

/// Finds the browser: that of the option, else the first in `PATH`.
fn find_browser(given: Option<&Path>) -> Result<PathBuf, Failure> {
    if let Some(given) = given {
        if given.is_file() {
            return Ok(given.to_path_buf());
        }
        return Err(Failure::new(format!(
            "--browser {}: there is no such program",
            given.display()
        )));
    }
    let path = std::env::var_os("PATH").unwrap_or_default();
    let mut places = BROWSERS
        .iter()
        .flat_map(|name| std::env::split_paths(&path).map(move |folder| folder.join(name)));
    places.find(|place| place.is_file()).ok_or_else(|| {
        Failure::new("a film needs Chromium, Chrome or Edge, and none is in PATH").with_help(
            "name the program with --browser, or record with the button Film of the page that wisch report writes",
        )
    })
}

/// A recorded clip.
struct Clip {
    /// WebM video.
    video: Vec<u8>,
    /// The page's description of the clip: duration, speed, size, and a doubt if there is one.
    said: String,
}

/// A browser that shows a page, and the server from which it gets the page.
struct FilmSet {
    browser: Child,
    name: String,
    listener: TcpListener,
    /// Path that only the browser knows.
    secret: String,
}

impl FilmSet {
    /// Starts a browser without a window. `size`: width and height of the page [pixels].
    fn open(browser: &Path, [width, height]: [u32; 2]) -> Result<Self, Failure> {
        let cannot = |error: io::Error| Failure::new(format!("{}: {error}", browser.display()));
        let listener = TcpListener::bind("127.0.0.1:0").map_err(cannot)?;
        listener.set_nonblocking(true).map_err(cannot)?;
        let port = listener.local_addr().map_err(cannot)?.port();
        let hash = || RandomState::new().build_hasher().finish();
        let secret = format!("{:016x}{:016x}", hash(), hash());
        let profile = tempfile::Builder::new().prefix("wisch-film-").tempdir();
        let profile = profile.map_err(|error| {
            Failure::new(format!("the folder for the browser's profile: {error}"))
        })?;
        // Only this user can read the folder, while everybody can read the arguments of a program.
        let start = profile.path().join("start.html");
        let go =
            format!("<script>location.replace(\"http://127.0.0.1:{port}/{secret}/page\")</script>");
        std::fs::write(&start, go).map_err(cannot)?;
        let profile = profile.keep();
        let mut command = Command::new("sh");
        command.args(["-c", KEEPER]).arg(&profile).arg(browser);
        command.args([
            "--headless=new",
            "--disable-gpu",
            "--use-gl=angle",
            "--use-angle=swiftshader",
            "--enable-unsafe-swiftshader",
            "--no-first-run",
            "--no-default-browser-check",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
            "--hide-scrollbars",
            // Containers and users without namespaces lack the sandbox; the page is this program's own and loads nothing.
            "--no-sandbox",
        ]);
        command
            .arg(format!("--window-size={width},{height}"))
            .arg(format!("--user-data-dir={}", profile.display()))
            .arg(&start)
            .env("TMPDIR", &profile);
        // A shell reports the end of the browser.
        command.stdin(Stdio::piped()).stderr(Stdio::null());
        // Ctrl-C in a terminal reaches this program alone, which then closes the input.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        Ok(Self {
            browser: command.spawn().map_err(cannot)?,
            name: browser.display().to_string(),
            listener,
            secret,
        })
    }

    /// Serves the page, and returns the clip that it sends.
    fn record(&mut self, page: &str, progress: &Progress) -> Result<Clip, Failure> {
        let mut said = String::new();
        let (mut heard, mut recorded) = (Instant::now(), 0.0);
        loop {
            let stream = match self.listener.accept() {
                Ok((stream, _)) => stream,
                Err(error) if error.kind() == ErrorKind::WouldBlock => {
                    if let Ok(Some(status)) = self.browser.try_wait() {
                        return Err(self.fault(&format!(
                            "ended before the recording was complete ({status})"
                        )));
                    }
                    if heard.elapsed() > PATIENCE {
                        let silence = PATIENCE.as_secs();
                        return Err(
                            self.fault(&format!("the recording made no progress for {silence} s"))
                        );
                    }
                    std::thread::sleep(PERIOD);
                    continue;
                }
                Err(error) => return Err(self.fault(&error.to_string())),
            };
            // What cannot be read is another program's request, or a broken one.
            let Ok(Some((what, body))) = self.answer(stream, page) else {
                continue;
            };
            let text = || String::from_utf8_lossy(&body).into_owned();
            match what.as_str() {
                "progress" => {
                    let share: f64 = text().parse().unwrap_or(0.0);
                    if share > recorded {
                        (recorded, heard) = (share, Instant::now());
                    }
                    progress.say(format!("recording: {:.0} %", 100.0 * share));
                }
                "said" => said = text(),
                "fault" if text().starts_with("there is no round") => {
                    return Err(Failure::new(text())
                        .with_help("name another round with --round, or leave it out"));
                }
                "fault" => return Err(self.fault(&text())),
                "clip" if body.starts_with(&WEBM) => return Ok(Clip { video: body, said }),
                "clip" => return Err(self.fault("the clip is no WebM video")),
                _ => {}
            }
        }
    }

    fn fault(&self, what: &str) -> Failure {
        Failure::new(format!("{}: {what}", self.name)).with_help(
            "record with the button Film of the page that wisch report writes, or name another browser with --browser",
        )
    }

    /// Answers a request; returns what the page has sent, and its contents.
    fn answer(&self, mut stream: TcpStream, page: &str) -> io::Result<Option<(String, Vec<u8>)>> {
        stream.set_nonblocking(false)?;
        stream.set_read_timeout(Some(REQUEST))?;
        stream.set_write_timeout(Some(REQUEST))?;
        let (head, mut body) = read_head(&mut stream)?;
        let mut lines = head.lines();
        let mut words = lines.next().unwrap_or_default().split(' ');
        let (method, path) = (words.next(), words.next().unwrap_or_default());
        let what = path
            .strip_prefix('/')
            .and_then(|rest| rest.strip_prefix(&self.secret))
            .and_then(|rest| rest.strip_prefix('/'));
        let (status, content, sent) = match (method, what) {
            (Some("GET"), Some("page")) => ("200 OK", page, None),
            (Some("POST"), Some(what)) => {
                let length = lines.find_map(|line| {
                    let (name, value) = line.split_once(':')?;
                    name.eq_ignore_ascii_case("content-length")
                        .then(|| value.trim().parse::<usize>().ok())?
                });
                let length = length.filter(|length| *length <= MAX_CLIP);
                let length = length.ok_or(ErrorKind::InvalidData)?;
                let rest = length.saturating_sub(body.len()) as u64;
                Read::by_ref(&mut stream)
                    .take(rest)
                    .read_to_end(&mut body)?;
                if body.len() != length {
                    return Err(ErrorKind::UnexpectedEof.into());
                }
                ("200 OK", "", Some((what.to_owned(), body)))
            }
            _ => ("404 Not Found", "", None),
        };
        let length = content.len();
        write!(
            stream,
            "HTTP/1.1 {status}\r\nContent-Type: text/html; charset=utf-8\r\nContent-Length: {length}\r\nConnection: close\r\n\r\n{content}"
        )?;
        Ok(sent)
    }
}

impl Drop for FilmSet {
    fn drop(&mut self) {
        // The end of its input lets the keeper end the browser and remove its profile.
        drop(self.browser.stdin.take());
        let _ = self.browser.wait();
    }
}

/// Reads the head of a request; returns it, and what was read beyond it.
fn read_head(stream: &mut TcpStream) -> io::Result<(String, Vec<u8>)> {
    let mut bytes = Vec::new();
    let mut piece = [0; 4096];
    loop {
        if let Some(end) = bytes.windows(4).position(|four| four == b"\r\n\r\n") {
            let body = bytes.split_off(end + 4);
            let head = String::from_utf8(bytes).map_err(|_| ErrorKind::InvalidData)?;
            return Ok((head, body));
        }
        match stream.read(&mut piece)? {
            0 => return Err(ErrorKind::UnexpectedEof.into()),
            _ if bytes.len() > MAX_HEAD => return Err(ErrorKind::InvalidData.into()),
            count => bytes.extend_from_slice(&piece[..count]),
        }
    }
}
