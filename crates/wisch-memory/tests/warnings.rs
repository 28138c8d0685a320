//! Warnings while wiping: planted faults are warned of, and runs without a change rarely are.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::thread;
use std::time::Instant;
use wisch::run::{AlikeEpisode, WarningChannel};
use wisch_memory::warnings::{
    BandError, ConformalBands, EpisodeProfile, PhaseWindow, ProfileBuilder, RunScore, StrokeSample,
};

/// Rate of false warnings.
const RATE: f64 = 0.02;
/// Period of the samples [s].
const PERIOD: f64 = 0.01;
/// Press force [N], stiffness of the controller [N/m], and nominal stiffness of the sponge [N/m].
const PRESS: f64 = 10.0;
const CONTROLLER: f64 = 500.0;
const SPONGE: f64 = 2000.0;

/// The faults that are planted in a run.
#[derive(Debug, Clone, Copy, Default)]
struct Fault {
    /// Height of the true surface over the believed one [m].
    shift: f64,
    /// Bias of the measured force [N].
    bias: f64,
    /// Lost share of the stiffness of the sponge [1].
    worn: f64,
    /// Tracking error over the usual one, less 1.
    friction: f64,
    /// Whether a person pushes once.
    push: bool,
}

/// A standard normal number (Box and Muller 1958).
fn normal(random: &mut ChaCha8Rng) -> f64 {
    let [radius, angle] = [0, 1].map(|_| random.random_range(f64::EPSILON..1.0));
    (-2.0 * radius.ln()).sqrt() * (std::f64::consts::TAU * angle).cos()
}

/// Windows of a run of 6 to 10 strokes by a compliant arm with a sponge, with the stroke of each window.
///
/// Between runs scatter the localisation (0.3 mm and 1 mrad), the stiffness (3 %) and the tracking (10 %); within them the
/// force by 0.15 N from sample to sample, by 0.2 N slowly, and the height by 0.05 mm.
fn wipe(seed: u64, fault: Fault) -> (Vec<PhaseWindow>, Option<usize>) {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let offset = fault.shift + 3e-4 * normal(&mut random);
    let tilt = 1e-3 * normal(&mut random);
    let sponge = SPONGE * (1.0 - fault.worn) * (0.03 * normal(&mut random)).exp();
    let tracking = 1e-3 * (0.1 * normal(&mut random)).exp() * (1.0 + fault.friction);
    let strokes = random.random_range(6..=10);
    let pushed = random.random_range(0..strokes);
    let (mut windows, mut builder) = (Vec::new(), ProfileBuilder::default());
    let (mut slow, mut time) = (0.0, 0.0);
    let mut push_window = None;
    for stroke in 0..strokes {
        let duration = random.random_range(0.5..1.6);
        let [from, to] = [0, 1].map(|_| random.random_range(-0.2..0.2));
        let push_at = random.random_range(0.0..0.6) * duration;
        for sample in 0..(duration / PERIOD) as usize {
            let elapsed = PERIOD * sample as f64;
            slow = 0.95 * slow + 0.31 * 0.2 * normal(&mut random);
            let place = from + (to - from) * elapsed / duration;
            // The controller commands a depth at which the nominal sponge presses with the press force.
            let commanded = -PRESS / SPONGE - PRESS / CONTROLLER;
            let surface = offset + tilt * place;
            let is_pushed =
                fault.push && stroke == pushed && (push_at..push_at + 0.3).contains(&elapsed);
            let push = if is_pushed { 15.0 } else { 0.0 };
            if is_pushed && push_window.is_none() {
                push_window = Some(windows.len());
            }
            let height = (sponge * surface + CONTROLLER * commanded + push) / (sponge + CONTROLLER);
            let force = (sponge * (surface - height)).max(0.0) + push;
            // The tool lands with more force than it wipes with.
            let landing = 1.5 * (-elapsed / 0.05).exp();
            let force = force + landing + fault.bias + slow + 0.15 * normal(&mut random);
            let sample = StrokeSample {
                force,
                height: height + 5e-5 * normal(&mut random),
                tracking_error: tracking * (1.0 + 0.3 * normal(&mut random)).abs(),
                is_contact: force >= 0.5,
            };
            windows.extend(builder.push((stroke, duration), time + elapsed, &sample));
        }
        time += duration + 1.0;
        builder.leave_stroke();
    }
    (windows, push_window)
}

fn episode(number: u64, fault: Fault) -> EpisodeProfile {
    EpisodeProfile {
        episode: AlikeEpisode {
            id: format!("run{number:06}"),
            verdict: Some("goal met".to_owned()),
            performance: Some(0.97),
        },
        windows: wipe(number, fault).0,
    }
}

/// A memory without faults. The seeds of different memories differ in the millions.
fn quiet_memory(seed: u64, count: usize) -> Vec<EpisodeProfile> {
    let numbers = (0..count as u64).map(|number| 1_000_000 * seed + number);
    numbers
        .map(|number| episode(number, Fault::default()))
        .collect()
}

/// The window of the first warning of a run, with its channel and p-value.
fn first_warning(
    bands: &ConformalBands,
    windows: &[PhaseWindow],
) -> Option<(usize, WarningChannel, f64)> {
    let mut run = RunScore::default();
    windows.iter().enumerate().find_map(|(place, window)| {
        let beyond = bands.compare(&mut run, window);
        let deviation = beyond.first()?;
        let [low, high] = deviation.band;
        assert!(deviation.value < low || deviation.value > high);
        Some((place, deviation.channel, bands.p_value(&run)))
    })
}

#[test]
fn a_memory_that_is_too_small_gives_no_bands() {
    let memory = quiet_memory(1, 48);
    assert_eq!(ConformalBands::least_episodes(RATE), 49);
    let found = ConformalBands::fit(&memory, RATE);
    let too_few = BandError::TooFew {
        found: 48,
        needed: 49,
    };
    assert_eq!(found, Err(too_few));
    assert!(ConformalBands::fit(&memory, 0.05).is_ok());
    for rate in [0.0, 1.0, f64::NAN] {
        let wrong = ConformalBands::fit(&memory, rate);
        assert!(matches!(wrong, Err(BandError::Rate { .. })), "{rate}");
    }
}

#[test]
fn faults_are_warned_of_by_their_channel() {
    let bands = ConformalBands::fit(&quiet_memory(2, 60), RATE).expect("bands");
    assert_eq!(first_warning(&bands, &wipe(7, Fault::default()).0), None);
    let higher = Fault {
        shift: 5e-3,
        ..Fault::default()
    };
    let (at, channel, p) = first_warning(&bands, &wipe(7, higher).0).expect("a warning");
    assert!(at <= 2 && p <= RATE, "{at}, {p}");
    assert!(matches!(
        channel,
        WarningChannel::Force | WarningChannel::Height
    ));
    let rubs = Fault {
        friction: 1.0,
        ..Fault::default()
    };
    let (_, channel, _) = first_warning(&bands, &wipe(7, rubs).0).expect("a warning");
    assert_eq!(channel, WarningChannel::TrackingError);
    let pushed = Fault {
        push: true,
        ..Fault::default()
    };
    let (windows, push) = wipe(7, pushed);
    let (at, ..) = first_warning(&bands, &windows).expect("a warning");
    let push = push.expect("it is pushed");
    assert!((push..push + 3).contains(&at), "{at} for {push}");
}

/// Episodes without any scatter must not make a rounding error a warning.
#[test]
fn a_deviation_below_the_resolution_is_not_warned_of() {
    let window = |force: f64| PhaseWindow {
        phase: 0.5,
        values: [force, -5e-3, 1.0, 1e-3],
    };
    let same = |number: u64, force| EpisodeProfile {
        windows: vec![window(force); 20],
        ..episode(number, Fault::default())
    };
    let memory: Vec<EpisodeProfile> = (0..60).map(|number| same(number, 10.0)).collect();
    let bands = ConformalBands::fit(&memory, RATE).expect("bands");
    assert_eq!(first_warning(&bands, &vec![window(10.04); 40]), None);
    for force in [9.8, 10.2] {
        assert!(first_warning(&bands, &vec![window(force); 40]).is_some());
    }
}

#[test]
fn the_p_value_never_grows_and_the_most_alike_episode_has_the_same_fault() {
    let mut memory = quiet_memory(3, 80);
    let biased = |bias| Fault {
        bias,
        ..Fault::default()
    };
    memory.push(episode(77, biased(2.0)));
    let bands = ConformalBands::fit(&memory, RATE).expect("bands");
    let (windows, _) = wipe(78, biased(2.0));
    let (mut run, mut last) = (RunScore::default(), 1.0);
    for window in &windows {
        bands.compare(&mut run, window);
        let p = bands.p_value(&run);
        assert!(p <= last && p >= 1.0 / 82.0);
        last = p;
    }
    assert_eq!(bands.alike(&run)[0].id, "run000077");
}

#[test]
fn windows_are_means_at_any_rate_and_end_with_their_stroke() {
    for period in [1e-3, 1e-2, 0.05] {
        let mut builder = ProfileBuilder::default();
        let sample = |time: f64| StrokeSample {
            force: 10.0 * time,
            height: -1e-3,
            tracking_error: 0.0,
            is_contact: time >= 0.5,
        };
        let times = (0..(1.0 / period) as usize).map(|k| period * k as f64);
        let windows: Vec<PhaseWindow> = times
            .filter_map(|time| builder.push((0, 1.0), 5.0 + time, &sample(time)))
            .collect();
        assert_eq!(windows.len(), 9, "{period}");
        for (number, window) in windows.iter().enumerate() {
            let middle = 0.1 * number as f64 + 0.05;
            assert!((window.phase - middle).abs() < 1e-9);
            assert!((window.values[0] - 10.0 * (middle - 0.5 * period)).abs() < 1e-6);
        }
        let share = windows[8].values[2];
        assert!((share - 4.0 / 9.0).abs() < 0.06, "{share}");
        // No window extends over two strokes.
        assert_eq!(builder.push((1, 1.0), 6.05, &sample(0.0)), None);
    }
}

/// A planted fault, as a function of the number of runs since it began, counted from 1; and the run
/// at whose end the interpretation of a round shows it. The surface is relocalised from 3 mm; or
/// the press force differs by half of the commanded force or more; or half of the stiffness is
/// lost; or the tracking error exceeds the tolerated 3 mm.
type Plant = (&'static str, fn(usize) -> Fault, usize);

const FAULTS: [Plant; 5] = [
    (
        "surface shifted by 5 mm",
        |_| Fault {
            shift: 5e-3,
            ..Fault::default()
        },
        1,
    ),
    (
        "force bias +0.1 N a run",
        |run| Fault {
            bias: 0.1 * run as f64,
            ..Fault::default()
        },
        50,
    ),
    (
        "sponge -2 % a run",
        |run| Fault {
            worn: 1.0 - 0.98_f64.powf(run as f64),
            ..Fault::default()
        },
        35,
    ),
    (
        "tracking error +10 % a run",
        |run| Fault {
            friction: 0.1 * run as f64,
            ..Fault::default()
        },
        20,
    ),
    (
        "push of 15 N for 0.3 s",
        |_| Fault {
            push: true,
            ..Fault::default()
        },
        1,
    ),
];

/// The seeds of the published numbers, from 10,000; constants were chosen on seeds from 1000 to 4999, which
/// `WISCH_FIRST_SEED` selects.
fn published_seeds() -> std::ops::Range<u64> {
    let first = std::env::var("WISCH_FIRST_SEED").ok();
    let first = first.and_then(|seed| seed.parse().ok()).unwrap_or(10_000);
    first..first + 400
}

/// Applies a function to all seeds on two threads, and returns the results in their order.
fn on_seeds<T: Send>(
    seeds: std::ops::Range<u64>,
    of: impl Fn(u64) -> T + Sync + Send + Copy,
) -> Vec<T> {
    let middle = u64::midpoint(seeds.start, seeds.end);
    thread::scope(|scope| {
        let first = scope.spawn(move || (seeds.start..middle).map(of).collect::<Vec<T>>());
        let second: Vec<T> = (middle..seeds.end).map(of).collect();
        let mut all = first.join().expect("no panic");
        all.extend(second);
        all
    })
}

/// False warnings over 400 memories, each with a run without a change; the 99.9 % quantile of the binomial distribution is
/// the limit. Then warnings of 80 memories for each fault: the faulty runs become part of the memory.
#[test]
#[ignore = "slow: statistics over 800 memories"]
fn planted_faults_are_warned_of_and_runs_without_a_change_rarely() {
    const RATES: [(f64, usize); 3] = [(0.02, 19), (0.05, 36), (0.2, 107)];
    const COUNTS: [usize; 3] = [49, 99, 199];
    let first = published_seeds().start;
    let all_warned = on_seeds(published_seeds(), |seed| {
        let memory = quiet_memory(seed, COUNTS[2]);
        let (windows, _) = wipe(1_000_000 * seed + 900_000, Fault::default());
        COUNTS.map(|count| {
            RATES.map(|(rate, _)| {
                let bands = ConformalBands::fit(&memory[..count], rate).expect("bands");
                first_warning(&bands, &windows).is_some()
            })
        })
    });
    for (place, count) in COUNTS.into_iter().enumerate() {
        for (number, (rate, most)) in RATES.into_iter().enumerate() {
            let warned = (all_warned.iter())
                .filter(|warned| warned[place][number])
                .count();
            println!("no change, {count} episodes, rate {rate}: {warned} of 400 runs warned of");
            assert!(warned <= most, "{count} episodes, rate {rate}: {warned}");
        }
    }
    // As find_basis does, the memory leaves warned runs among its ten newest out, and has 200 at most.
    let rates = on_seeds(first..first + 4, |seed| {
        let quiet = quiet_memory(seed, 59).into_iter();
        let mut memory: Vec<(EpisodeProfile, bool)> =
            quiet.map(|profile| (profile, false)).collect();
        let mut warned = 0;
        for run in 0..400 {
            let newest = memory.len() - 10;
            let kept = memory.iter().enumerate().rev();
            let kept = kept.filter(|(place, (_, has_warned))| *place < newest || !has_warned);
            let basis: Vec<EpisodeProfile> = (kept.take(200))
                .map(|(_, (profile, _))| profile.clone())
                .collect();
            let number = 1_000_000 * seed + 900_000 + run;
            let profile = episode(number, Fault::default());
            let bands = ConformalBands::fit(&basis, RATE).expect("bands");
            let is_warned = first_warning(&bands, &profile.windows).is_some();
            warned += usize::from(is_warned);
            memory.push((profile, is_warned));
        }
        warned
    });
    println!("no change, 400 runs of one memory in a row: {rates:?} runs warned of");
    // 2 % of 1600, and three standard deviations.
    assert!(rates.iter().sum::<usize>() <= 48, "{rates:?}");
    let mut in_time = 0;
    for (number, (name, plant, shown)) in FAULTS.into_iter().enumerate() {
        let begin = first + 80 * number as u64;
        let took = on_seeds(begin..begin + 80, |seed| {
            let mut memory = quiet_memory(seed, 99);
            (1..=shown).find_map(|run| {
                let bands = ConformalBands::fit(&memory, RATE).expect("bands");
                let number = 1_000_000 * seed + 900_000 + run as u64;
                let windows = wipe(number, plant(run)).0;
                if let Some((at, ..)) = first_warning(&bands, &windows) {
                    return Some((run, at + 1));
                }
                memory.push(episode(number, plant(run)));
                None
            })
        });
        let mut took: Vec<(usize, usize)> = took.into_iter().flatten().collect();
        took.sort_unstable();
        in_time += took.len();
        let found = took.len();
        println!(
            "{name}: {found} of 80 warned of before an estimate shows it (run {shown}), in run {:?} in the median, run {:?} at most",
            took.get(found / 2).map(|took| took.0),
            took.last().map(|took| took.0),
        );
    }
    println!("{in_time} of 400 planted faults are warned of in time");
    assert!(in_time >= 380, "{in_time}");
}

/// Run in a release build: `cargo test --release --test main warnings:: -- --ignored --nocapture`.
#[test]
#[ignore = "slow: measures times"]
fn a_window_costs_less_than_a_millisecond() {
    let bands = ConformalBands::fit(&quiet_memory(4, 200), RATE).expect("bands");
    let start = Instant::now();
    let mut windows = 0;
    for seed in 0..100 {
        let mut run = RunScore::default();
        for window in &wipe(seed, Fault::default()).0 {
            let _ = (bands.compare(&mut run, window), bands.alike(&run));
            windows += 1;
        }
    }
    let each = start.elapsed().as_secs_f64() / f64::from(windows);
    println!(
        "{:.1} us for a window, its samples and a warning",
        1e6 * each
    );
    assert!(each < 1e-3, "{each} s");
}
