# Frequent commands. `just` lists them; without just, type the lines below.

# List the recipes.
default:
    @just --list

# Run a task file: plan, follow, execute, interpret, recover, report.
run task="scenarios/chopping-board.toml" *options:
    cargo run --release --locked -- run {{task}} {{options}}

# All tests, or some: `just test --workspace --test main plan::`.
test *options="--workspace":
    cargo test --locked {{options}}

# The slow tests: statistics over many worlds and episodes, and random kills. They are no part of the tests of a commit.
slow *options:
    cargo test --workspace --locked -- --ignored {{options}}

# Format and lints.
lint:
    cargo fmt --all --check
    cargo clippy --workspace --all-targets --locked -- -D warnings

# The documentation, with warnings as errors, as in continuous integration.
doc *options:
    RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps --locked {{options}}

# Build the Python wheel, install it into a bare environment, run its tests.
python *options:
    crates/wisch-py/check {{options}}

# Format, lints and all tests of wisch-ros2, among them a fake robot in real time.
ros2 *options:
    crates/wisch-ros2/check {{options}}

# Format, lints and all tests of wisch-fleet, among them a real S3 server and pushes that are killed.
fleet *options:
    crates/wisch-fleet/check {{options}}

# Package every crate that may be published, and build each from its package alone.
package *options:
    .ci/package {{options}}

# All checks of a commit.
ci:
    .ci/run

# All benchmarks, or one: `just bench --bench effect`.
bench *options:
    cargo bench --workspace --locked {{options}}

# Check, test and build the page of reports and of the studio, in a real browser too (needs Node and Chromium).
web:
    cd crates/wisch-web/web && npm ci && npm run check && npm test && npm run test:browser
    crates/wisch-studio/check/run

# Open bags of wisch as Rerun and Foxglove do (needs what docs/viewers/requirements.txt lists).
viewers *options:
    python3 -m pytest docs/viewers {{options}}

# One table with the times of wisch and its peers for the same computations (needs what peers/requirements.txt lists).
bench-peers:
    python3 peers/table.py

# Measure published figures again: `just evidence NAME…`, `all`, `stale`, `--check`; the pages are written too.
evidence *options="stale":
    .ci/evidence {{options}}

# How long each stage takes, and how that grows with the dirt: a table and a plot.
growth plot="out/growth.svg":
    cargo run --release --locked --package wisch-eval --example growth -- {{plot}}

# Feed a reader of files with broken input (needs a nightly Rust and cargo-fuzz).
fuzz target="task" seconds="60":
    cargo +nightly fuzz run {{target}} -- -max_total_time={{seconds}}

# Build a revision and the working tree, run the shipped scenarios with the seeds 1 to 3, and name every file that differs.
compare rev *options:
    peers/compare_builds.py {{rev}} {{options}}
