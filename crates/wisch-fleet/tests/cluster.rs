//! A scheduler and its executors, which are processes on loopback, give the same answers as one machine.

use crate::memories::{memory, some};
use crate::processes::{Cluster, program, run_in_time, sort_lines};
use crate::queries::records;
use crate::s3_server::{KEY_ID, SECRET, Server};
use std::process::{Command, Output};
use std::time::Duration;
use wisch_fleet::ask::views;

/// Returns the answers of one machine and of the cluster.
fn ask_both(
    cluster: &Cluster,
    program: &dyn Fn() -> Command,
    sources: &[&str],
    sql: &str,
) -> [Vec<String>; 2] {
    let mut here = program();
    let here = run_in_time(here.args(["sql", sql, "--csv"]).args(sources), sql);
    let there = cluster.ask(program(), sources, sql);
    [sort_lines(&here, sql), sort_lines(&there, sql)]
}

/// Checks that both answers are equal, byte for byte.
fn assert_equal(cluster: &Cluster, program: &dyn Fn() -> Command, sources: &[&str], sql: &str) {
    let [here, there] = ask_both(cluster, program, sources, sql);
    assert_eq!(here, there, "{sql}");
}

/// Checks that both answers are equal up to rounding: sums of doubles depend on the order.
fn assert_close(cluster: &Cluster, sources: &[&str], sql: &str) {
    let [here, there] = ask_both(cluster, &program, sources, sql);
    let cells = |lines: &[String]| -> Vec<String> {
        let cells = lines.iter().flat_map(|line| line.split(','));
        cells.map(str::to_owned).collect()
    };
    let (here, there) = (cells(&here), cells(&there));
    assert_eq!(here.len(), there.len(), "{sql}");
    for (one, other) in here.iter().zip(&there) {
        match (one.parse::<f64>(), other.parse::<f64>()) {
            (Ok(a), Ok(b)) => assert!((a - b).abs() <= 1e-12 * a.abs(), "{sql}: {a} {b}"),
            _ => assert_eq!(one, other, "{sql}"),
        }
    }
}

/// Sources of every kind: a fleet, a memory that shares episodes with it, and a fleet without objects.
struct Sources {
    folder: tempfile::TempDir,
}

impl Sources {
    fn write() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let all = records();
        let here = memory(&folder.path().join("pushed"), &all[..220]);
        memory(&folder.path().join("memory"), &all[180..]);
        let fleet = folder.path().join("fleet");
        let output = run_in_time(program().arg("push").args([here.folder(), &fleet]), "push");
        assert!(output.status.success());
        Self { folder }
    }

    fn path(&self, name: &str) -> String {
        self.folder.path().join(name).display().to_string()
    }
}

/// Statements whose plan for a cluster differs from the plan for one machine.
const STATEMENTS: [&str; 19] = [
    "SELECT tool, surface, channel, state, runs, p_value, runs_to_limit FROM drift",
    "SELECT count(*) AS n FROM strokes",
    "SELECT tool, surface, count(*) AS n, min(performance) AS low, max(performance) AS high FROM rounds GROUP BY tool, surface",
    "SELECT e.task, r.round, count(*) AS n FROM episodes AS e JOIN rounds AS r ON e.episode = r.episode GROUP BY e.task, r.round",
    "SELECT day, count(DISTINCT episode) AS n FROM events GROUP BY day",
    "SELECT episode, performance FROM episodes ORDER BY performance DESC, episode LIMIT 7",
    "SELECT class, count(*) AS n FROM motions WHERE day = DATE '2026-01-01' GROUP BY class",
    "SELECT count(*) AS n FROM episodes WHERE episode NOT IN (SELECT episode FROM events WHERE class = 'HumanCollision')",
    "SELECT episode FROM episodes WHERE performance = (SELECT max(performance) FROM episodes)",
    "SELECT * FROM episodes WHERE performance > 2",
    "SELECT * FROM episodes WHERE false",
    "SELECT episode, row_number() OVER (PARTITION BY tool ORDER BY start_s, episode) AS nth FROM episodes",
    "SELECT tool FROM episodes UNION ALL SELECT tool FROM rounds",
    "WITH lows AS (SELECT tool FROM low_performance) SELECT tool, count(*) AS n FROM lows GROUP BY tool HAVING count(*) > 1",
    "SELECT 1 AS one, 'a' || 'b' AS two",
    "SELECT count(*) AS n FROM (SELECT unnest(range(0, 3)) AS k) AS c JOIN rounds AS r ON r.round + c.k > 2",
    "SELECT count(*) AS n FROM rounds AS a JOIN events AS b ON a.start_s < b.end_s AND a.round > b.round",
    "SELECT episode, performance - (SELECT max(performance) FROM rounds) AS below FROM episodes",
    "SELECT count(*) AS n FROM episodes AS a WHERE EXISTS (SELECT 1 FROM events AS b WHERE b.episode = a.episode AND b.start_s > a.start_s)",
];

/// Sums and means of doubles. They also differ between machines with different numbers of cores.
const SUMS: [&str; 2] = [
    "SELECT tool, sum(performance) AS s, avg(performance_high) AS m FROM rounds GROUP BY tool",
    "SELECT class, stddev(end_s - start_s) AS d FROM motions GROUP BY class",
];

/// Statements over several sources for which Ballista would return too many rows, or never end.
const REFUSED: [&str; 5] = [
    "SELECT a.episode, b.episode AS other FROM episodes AS a LEFT JOIN episodes AS b ON a.start_s > b.end_s + 9000 AND a.tool <> b.tool",
    "SELECT a.tool, count(*) AS n FROM episodes AS a LEFT JOIN episodes AS b ON a.start_s > b.end_s + 9000 AND a.tool <> b.tool GROUP BY a.tool",
    "SELECT episode, rank() OVER (ORDER BY performance DESC, episode) AS nth FROM episodes",
    "SELECT max(performance) AS p FROM episodes UNION ALL SELECT performance FROM rounds",
    "SELECT count(*) AS n FROM (SELECT * FROM episodes ORDER BY episode LIMIT 10) AS a LEFT ANTI JOIN motions AS b ON a.episode = b.episode AND b.place < 0",
];

#[test]
fn answers_equal_those_of_one_machine() {
    let sources = Sources::write();
    let folder = tempfile::tempdir().unwrap();
    let cluster = Cluster::begin(folder.path(), 2, program);
    let [fleet, memory, none] = ["fleet", "memory", "none"].map(|name| sources.path(name));
    let kinds: [&[&str]; 4] = [
        &["--fleet", &fleet],
        &["--memory", &memory],
        &["--fleet", &none],
        &["--fleet", &fleet, "--memory", &memory, "--fleet", &none],
    ];
    for sources in kinds {
        for view in views::all() {
            assert_equal(
                &cluster,
                &program,
                sources,
                &format!("SELECT * FROM {}", view.name),
            );
        }
        for sql in STATEMENTS {
            assert_equal(&cluster, &program, sources, sql);
        }
        for sql in SUMS {
            assert_close(&cluster, sources, sql);
        }
    }
    for sql in REFUSED {
        let message = read_error(&cluster.ask(program(), kinds[3], sql));
        assert!(message.contains("without a cluster"), "{sql}: {message}");
    }
}

#[test]
fn a_bucket_is_read_with_the_executors_own_credentials() {
    let folder = tempfile::tempdir().unwrap();
    let server = Server::start(&folder.path().join("s3"));
    let here = memory(&folder.path().join("here"), &some(40));
    let s3_program = || server.program(SECRET);
    let mut push = s3_program();
    push.arg("push").arg(here.folder()).arg("s3://fleet/robots");
    assert!(run_in_time(&mut push, "push").status.success());
    let sources = ["--fleet", "s3://fleet/robots"];
    // The scheduler reads nothing, so it needs no credentials.
    let mut cluster = Cluster::begin(folder.path(), 0, program);
    cluster.add(s3_program());
    for sql in STATEMENTS {
        assert_equal(&cluster, &s3_program, &sources, sql);
    }
    for view in views::all() {
        assert_equal(
            &cluster,
            &s3_program,
            &sources,
            &format!("SELECT * FROM {}", view.name),
        );
    }
    // No process gets credentials from another.
    cluster.executors.clear();
    cluster.add(server.program("another-secret"));
    let output = cluster.ask(
        s3_program(),
        &sources,
        "SELECT count(DISTINCT episode) FROM events",
    );
    let message = read_error(&output);
    assert!(
        message.contains("AWS_SECRET_ACCESS_KEY") && message.contains(&cluster.url),
        "{message}"
    );
    let errors = cluster.errors();
    for text in [&message, &errors] {
        for secret in [KEY_ID, SECRET, "another-secret"] {
            assert!(!text.contains(secret), "{text}");
        }
    }
}

/// Returns the error of a failed program, which is one line.
fn read_error(output: &Output) -> String {
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    let mut lines = message.trim_end().lines();
    // A note on shared episodes may precede it.
    let error = lines.find(|line| line.starts_with("error: "));
    assert_eq!(lines.next(), None, "{message}");
    error.expect("an error").to_owned()
}

#[test]
fn no_scheduler_and_no_executor_are_errors() {
    let folder = tempfile::tempdir().unwrap();
    let here = memory(&folder.path().join("here"), &some(3));
    let memory = here.folder().display().to_string();
    let ask = |url: &str| {
        let mut command = program();
        command.args(["sql", "SELECT count(*) FROM episodes", "--memory", &memory]);
        read_error(&run_in_time(command.args(["--cluster", url]), url))
    };
    for wrong in [
        "127.0.0.1:50050",
        "http://127.0.0.1:50050",
        "df://127.0.0.1",
    ] {
        let message = ask(wrong);
        assert!(
            message.contains("df://HOST:PORT") && message.contains(wrong),
            "{message}"
        );
    }
    // A port that was just free.
    let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let silent = format!("df://{}", listener.local_addr().unwrap());
    let message = ask(&silent);
    assert!(
        message.contains(&silent),
        "a listener that is no scheduler: {message}"
    );
    drop(listener);
    let message = ask(&silent);
    assert!(
        message.contains(&silent) && message.contains("no scheduler"),
        "{message}"
    );
    let cluster = Cluster::begin(folder.path(), 0, program);
    let message = ask(&cluster.url);
    assert!(
        message.contains(&cluster.url) && message.contains("no executor"),
        "{message}"
    );
}

/// A statement that takes long enough to kill a process meanwhile, with tasks for two executors.
const LONG: &str = "SELECT count(*) AS n FROM (SELECT unnest(range(0, 12)) AS k) AS c JOIN motions AS a ON a.round + c.k > 0 \
     JOIN motions AS b ON a.start_s < b.end_s + sin(a.start_s * b.start_s)";

#[test]
fn when_an_executor_dies_its_statement_fails_and_others_answer() {
    let sources = Sources::write();
    let folder = tempfile::tempdir().unwrap();
    let mut cluster = Cluster::begin(folder.path(), 2, program);
    let fleet = sources.path("fleet");
    let from: [&str; 2] = ["--fleet", &fleet];
    let found = std::thread::scope(|scope| {
        let asked = scope.spawn(|| cluster.ask(program(), &from, LONG));
        std::thread::sleep(Duration::from_millis(800));
        let victim = cluster.executors[0].child.id();
        let _ = Command::new("kill")
            .args(["-9", &victim.to_string()])
            .status();
        asked.join().unwrap()
    });
    // The killed executor may have had no task of the statement.
    if found.status.success() {
        let mut here = program();
        let here = run_in_time(here.args(["sql", LONG, "--csv"]).args(from), LONG);
        assert_eq!(sort_lines(&found, LONG), sort_lines(&here, LONG));
    } else {
        let message = read_error(&found);
        assert!(
            message.contains("executor") && message.contains(&cluster.url),
            "{message}"
        );
    }
    cluster.executors.remove(0);
    assert_equal(&cluster, &program, &from, STATEMENTS[1]);
    cluster.executors.clear();
    let message = read_error(&cluster.ask(program(), &from, STATEMENTS[1]));
    assert!(
        message.contains("executor") && message.contains(&cluster.url),
        "{message}"
    );
    cluster.scheduler.kill();
    let message = read_error(&cluster.ask(program(), &from, STATEMENTS[1]));
    assert!(message.contains("no scheduler"), "{message}");
}

#[test]
fn a_statement_fails_when_its_scheduler_dies() {
    let sources = Sources::write();
    let folder = tempfile::tempdir().unwrap();
    let cluster = Cluster::begin(folder.path(), 1, program);
    let fleet = sources.path("fleet");
    let found = std::thread::scope(|scope| {
        let asked = scope.spawn(|| cluster.ask(program(), &["--fleet", &fleet], LONG));
        std::thread::sleep(Duration::from_millis(800));
        let _ = Command::new("kill")
            .args(["-9", &cluster.scheduler.child.id().to_string()])
            .status();
        asked.join().unwrap()
    });
    let message = read_error(&found);
    assert!(message.contains(&cluster.url), "{message}");
}

#[test]
fn descriptions_of_tables_and_plans_come_from_the_client() {
    let sources = Sources::write();
    let folder = tempfile::tempdir().unwrap();
    let cluster = Cluster::begin(folder.path(), 1, program);
    let fleet = sources.path("fleet");
    let from: [&str; 2] = ["--fleet", &fleet];
    for sql in [
        "SHOW TABLES",
        "SELECT table_name, column_name, data_type FROM information_schema.columns WHERE table_name = 'low_performance'",
        "DESCRIBE rounds",
    ] {
        let output = cluster.ask(program(), &from, sql);
        assert!(sort_lines(&output, sql).len() > 3, "{sql}");
    }
    for sql in [
        "EXPLAIN SELECT count(*) FROM rounds",
        "EXPLAIN ANALYZE SELECT count(*) FROM rounds",
    ] {
        let output = cluster.ask(program(), &from, sql);
        assert!(sort_lines(&output, sql).len() > 1, "{sql}");
    }
    let mixed = "SELECT count(*) FROM episodes, information_schema.tables";
    let message = read_error(&cluster.ask(program(), &from, mixed));
    assert!(message.contains("information_schema"), "{message}");
}
