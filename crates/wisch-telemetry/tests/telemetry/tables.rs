//! Text tables of other programs.

use super::{in_folder, refused};
use std::fmt::Write;
use std::fs;
use wisch::geometry::{Pose, Vector3};
use wisch_telemetry::{Axes, AxesSource, Log, LogOptions, OrientationForm, read};

/// Number of samples at 25 Hz: a tool moves at 0.1 m/s along x at a height of 0.8 m, rotated by 0.5 rad about z, with a force
/// of 10 N.
pub(super) const COUNT: usize = 250;

pub(super) fn time(tick: usize) -> f64 {
    tick as f64 / 25.0
}

/// Returns a table with names and a line per sample. `line`: formats the time [s] and x [m] of a sample.
pub(super) fn table(names: &str, line: impl Fn(f64, f64) -> String) -> String {
    let mut text = format!("{names}\n");
    for tick in 0..COUNT {
        writeln!(text, "{}", line(time(tick), 0.1 * time(tick))).unwrap();
    }
    text
}

fn read_text(text: &str, options: &LogOptions) -> Log {
    let (folder, _) = in_folder();
    let path = folder.path().join("log.csv");
    fs::write(&path, text).unwrap();
    read(&path, options).unwrap()
}

fn refused_text(text: &str, options: &LogOptions) -> String {
    let (folder, _) = in_folder();
    let path = folder.path().join("log.csv");
    fs::write(&path, text).unwrap();
    refused(&path, options)
}

/// Checks the motion of [`table`], and the force on the tool in the axes of the log.
pub(super) fn assert_is_it(log: &Log, what: &str) {
    assert_eq!(log.samples.len(), COUNT, "{what}: {:?}", log.remarks);
    for (tick, sample) in log.samples.iter().enumerate() {
        assert!(
            (sample.time - time(tick)).abs() < 1e-6,
            "{what}: {}",
            sample.time
        );
        let at = Vector3::new(0.1 * time(tick), 0.0, 0.8);
        let position = sample.world_from_tool.translation.vector;
        assert!((position - at).norm() < 1e-6, "{what}: {position}");
        let turn = sample.world_from_tool.rotation.scaled_axis();
        assert!((turn - Vector3::z() * 0.5).norm() < 1e-5, "{what}: {turn}");
        assert!(
            (sample.force - Vector3::z() * 10.0).norm() < 1e-6,
            "{what}: {}",
            sample.force
        );
    }
}

pub(super) const NAMES: &str = "t,x,y,z,qx,qy,qz,qw,fx,fy,fz";

pub(super) fn plain(t: f64, x: f64) -> String {
    format!(
        "{t},{x},0,0.8,0,0,{},{},0,0,10",
        0.25_f64.sin(),
        0.25_f64.cos()
    )
}

#[test]
fn a_table_with_decimal_commas_and_points_is_refused() {
    // Times with points beside millimetres with separators of thousands.
    let base = table(NAMES, plain).replace(',', ";");
    let mixed = base.replacen(";0;0.8;", ";0;1,870;", 1);
    let (folder, _) = in_folder();
    let path = folder.path().join("mixed.csv");
    fs::write(&path, mixed).unwrap();
    let told = refused(&path, &LogOptions::default());
    assert!(
        told.contains("line 2") && told.contains("separators of thousands"),
        "{told}"
    );
}

#[test]
fn dialects_of_text_are_read() {
    let base = table(NAMES, plain);
    let semicolons = base.replace(',', ";").replace('.', ",");
    let list = table("t,x,y,z,qx,qy,qz,qw,joints,fx,fy,fz", |t, x| {
        plain(t, x).replacen(",0,0,10", ",\"[0.1, 0.2]\",0,0,10", 1)
    });
    let cases = [
        ("as ours", base.clone()),
        ("comment", format!("# recorded, by somebody\n\n{base}")),
        ("title", format!("Log of the arm\n{base}")),
        ("decimal commas", semicolons.clone()),
        ("decimal commas and tabs", semicolons.replace(';', "\t")),
        ("spaces", base.replace(',', "  ")),
        ("quoted list", list),
        (
            "quoted",
            format!(
                "\"{}\"\n{}",
                NAMES.replace(',', "\",\""),
                base.split_once('\n').unwrap().1
            ),
        ),
        (
            "upper case",
            format!(
                "{}\n{}",
                NAMES.to_uppercase(),
                base.split_once('\n').unwrap().1
            ),
        ),
        ("ends of lines", base.replace('\n', "\r\n")),
        ("names behind a hash", format!("# {base}")),
        ("cut off", format!("{base}9.99,1.0,0")),
    ];
    for (what, text) in cases {
        let log = read_text(&text, &LogOptions::default());
        assert_is_it(&log, what);
        let is_said = !log.remarks.is_empty();
        assert_eq!(
            is_said,
            what.contains("commas") || what == "cut off",
            "{what}: {:?}",
            log.remarks
        );
    }
}

#[test]
fn units_in_names_are_read_and_reported() {
    let in_units = |t: f64, x: f64| {
        let turn = format!("0,0,{},{}", 0.25_f64.sin(), 0.25_f64.cos());
        format!("{},{},0,800,{turn},0,0,0.01", 1e3 * t, 1e3 * x)
    };
    for names in [
        "t [ms],x [mm],y [mm],z [mm],qx,qy,qz,qw,fx [kN],fy [kN],fz [kN]",
        "time_ms,tcp_x_mm,tcp_y_mm,tcp_z_mm,qx,qy,qz,qw,fx (kN),fy (kN),fz (kN)",
        "Time (ms),Pos_X / mm,Pos_Y / mm,Pos_Z / mm,QX,QY,QZ,QW,Force X [kN],Force Y [kN],Force Z [kN]",
    ] {
        let log = read_text(&table(names, in_units), &LogOptions::default());
        assert_is_it(&log, names);
        let remarks = log.remarks.join("; ");
        assert!(
            remarks.contains("t in ms, x in mm, y in mm, z in mm, fx in kN"),
            "{remarks}"
        );
    }
    // Options take precedence.
    let options = LogOptions {
        time_unit: Some(1e-3),
        length_unit: Some(1e-3),
        force_unit: Some(1e3),
        ..LogOptions::default()
    };
    let text = table(
        "t [s],x [m],y [m],z [m],qx,qy,qz,qw,fx [N],fy [N],fz [N]",
        in_units,
    );
    assert_is_it(&read_text(&text, &options), "by options");
}

#[test]
fn tables_of_known_robots_are_read_without_options() {
    let by_index = |base: &str, count: usize| {
        let names: Vec<String> = (0..count).map(|k| format!("{base}{k}")).collect();
        names.join(",")
    };
    let ur = format!(
        "timestamp,{},{}",
        by_index("actual_TCP_pose_", 6),
        by_index("actual_TCP_force_", 6)
    );
    let log = read_text(
        &table(&ur, |t, x| {
            format!("{},{x},0,0.8,0,0,0.5,0,0,10,0,0,0", 5000.0 + t)
        }),
        &LogOptions::default(),
    );
    assert_is_it(&log, "UR");
    assert_eq!((log.axes, log.axes_source), (Axes::Log, AxesSource::Logged));

    let franka = |bracket: [&str; 2]| {
        let name = |base: &str, k: usize| format!("{base}{}{k}{}", bracket[0], bracket[1]);
        let pose: Vec<String> = (0..16).map(|k| name("O_T_EE", k)).collect();
        let desired: Vec<String> = (0..16).map(|k| name("O_T_EE_d", k)).collect();
        let force: Vec<String> = (0..6).map(|k| name("O_F_ext_hat_K", k)).collect();
        format!(
            "time,{},{},{}",
            pose.join(","),
            desired.join(","),
            force.join(",")
        )
    };
    let (sin, cos) = 0.5_f64.sin_cos();
    for bracket in [["[", "]"], ["_", ""], ["", ""]] {
        let nothing = ["0"; 16].join(",");
        let line = |t: f64, x: f64| {
            format!(
                "{t},{cos},{sin},0,0,{},{cos},0,0,0,0,1,0,{x},0,0.8,1,{nothing},0,0,-10,0,0,0",
                -sin
            )
        };
        let log = read_text(&table(&franka(bracket), line), &LogOptions::default());
        assert_is_it(&log, "libfranka");
        let remarks = log.remarks.join("; ");
        assert!(
            remarks.contains("(O_F_ext_hat_K) are read as those of the tool on its surroundings"),
            "{remarks}"
        );
    }

    // KUKA: millimetres and degrees.
    let kuka =
        |t: f64, x: f64| format!("{t},{},0,800,{},0,0,0,0,10", 1e3 * x, 0.5_f64.to_degrees());
    let log = read_text(
        &table("t,X,Y,Z,A,B,C,Fx,Fy,Fz", kuka),
        &LogOptions::default(),
    );
    assert_is_it(&log, "KUKA");
    let remarks = log.remarks.join("; ");
    assert!(
        remarks.contains("a to c are read as degrees") && remarks.contains("millimetres"),
        "{remarks}"
    );
}

#[test]
fn orientations_are_read_in_every_form() {
    let degrees = 0.5_f64.to_degrees();
    let form = |form: OrientationForm| LogOptions {
        orientation: Some(form),
        ..LogOptions::default()
    };
    let cases = [
        ("rx,ry,rz", "0,0,0.5".to_owned(), LogOptions::default()),
        (
            "roll,pitch,yaw",
            "0,0,0.5".to_owned(),
            LogOptions::default(),
        ),
        (
            "roll_deg,pitch_deg,yaw_deg",
            format!("0,0,{degrees}"),
            LogOptions::default(),
        ),
        (
            "roll,pitch,yaw",
            format!("0,0,{degrees}"),
            LogOptions::default(),
        ),
        (
            "rx,ry,rz",
            "0,0,0.5".to_owned(),
            form(OrientationForm::RollPitchYaw),
        ),
        (
            "a,b,c",
            format!("{degrees},0,0"),
            form(OrientationForm::Abc),
        ),
        (
            "a [rad],b [rad],c [rad]",
            "0.5,0,0".to_owned(),
            form(OrientationForm::Abc),
        ),
    ];
    for (names, turn, options) in cases {
        let names = format!("t,x,y,z,{names},fx,fy,fz");
        let text = table(&names, |t, x| format!("{t},{x},0,0.8,{turn},0,0,10"));
        assert_is_it(&read_text(&text, &options), &names);
    }
}

#[test]
fn times_in_other_units_and_a_rate_are_converted_to_seconds() {
    let line = |time: String, x: f64| plain(0.0, x).replacen('0', &time, 1);
    let start = 1_760_000_000_u64;
    let nanoseconds = table(NAMES, |t, x| {
        line(
            format!("{start}{:09}", (t * 1e9).round() as u64 % 1_000_000_000),
            x,
        )
        .replacen(&format!("{start}"), &format!("{}", start + t as u64), 1)
    });
    let log = read_text(&nanoseconds, &LogOptions::default());
    assert_is_it(&log, "nanoseconds");
    assert_eq!(log.start, 1_760_000_000_000_000_000);
    let milliseconds = table(NAMES, |t, x| line(format!("{}", (t * 1e3).round()), x));
    let log = read_text(&milliseconds, &LogOptions::default());
    assert_is_it(&log, "milliseconds");
    assert!(
        log.remarks[0].contains("read as milliseconds"),
        "{:?}",
        log.remarks
    );
    let dates = table(NAMES, |t, x| {
        line(format!("2025-10-09T08:53:{:06.3}Z", 20.0 + t), x)
    });
    let log = read_text(&dates, &LogOptions::default());
    assert_is_it(&log, "dates");
    assert_eq!(log.start, 1_760_000_000_000_000_000);

    let without = table(&NAMES[2..], |_, x| plain(0.0, x)[2..].to_owned());
    let message = refused_text(&without, &LogOptions::default());
    assert!(
        message.starts_with(": no column holds the time; the columns are: x, y, z"),
        "{message}"
    );
    let options = LogOptions {
        rate: Some(25.0),
        ..LogOptions::default()
    };
    assert_is_it(&read_text(&without, &options), "by rate");
}

#[test]
fn lines_out_of_order_are_sorted_and_empty_cells_are_interpolated() {
    let mut lines: Vec<String> = table(NAMES, plain).lines().map(str::to_owned).collect();
    lines.swap(20, 40);
    let log = read_text(&lines.join("\n"), &LogOptions::default());
    assert_is_it(&log, "swapped");
    assert!(
        log.remarks[0].contains("came up to 0.800 s late"),
        "{:?}",
        log.remarks
    );
    // Every other line lacks the force, as in a table that joins two rates.
    let tick = |t: f64| (t * 25.0).round() as usize;
    let joined = table(NAMES, |t, x| {
        match tick(t) % 2 == 1 && tick(t) + 1 < COUNT {
            true => plain(t, x).replace(",0,0,10", ",,,"),
            false => plain(t, x),
        }
    });
    assert_is_it(&read_text(&joined, &LogOptions::default()), "joined");
}

#[test]
fn ambiguous_tables_are_refused_with_the_line() {
    let good = table(NAMES, plain);
    let line = plain(20.0, 2.0);
    let cases = [
        (
            format!("# c\n\n{good}# d\n{},1\n", line),
            ": line 255: it has 12 values, but the table has 11 names",
        ),
        (
            format!("{good}{}", &line[..9]) + "\n",
            ": line 252: it has ",
        ),
        (
            format!("# c\n{NAMES},X\n{line},1\n").replacen("t,x,", "t,X,", 1),
            ": two columns may be \"x\": number 2 \"X\" and number 12 \"X\"",
        ),
        (
            table(
                "t,left_x,left_y,left_z,tcp_x,tcp_y,tcp_z,tool_x,tool_y,tool_z,qx,qy,qz,qw,fx,fy,fz",
                |t, x| format!("{t},{x},0,0,{x},0,0,{x},0,0,0,0,0,1,0,0,1"),
            ),
            ": 2 sets of columns may be the position: tcp_x, tcp_y, tcp_z; tool_x, tool_y, tool_z",
        ),
        (
            format!("{good}{}\n", line.replacen("0.8", "O.8", 1)),
            ": line 252, column \"z\": \"O.8\" is not a number",
        ),
    ];
    for (text, expected) in cases {
        let message = refused_text(&text, &LogOptions::default());
        assert!(message.starts_with(expected), "{message}");
    }
}

#[test]
fn units_and_frames_that_are_assumed_are_reported() {
    let open = read_text(&table(NAMES, plain), &LogOptions::default());
    assert_eq!(
        open.conventions,
        [
            "read as positions in metres and forces in newtons: the log states no unit",
            "poses are read in the frame \"world\" of the task, as the log names no frame; --world-from-log states another",
        ]
    );
    let stated = NAMES
        .replace(",x,", ",x_m,")
        .replace(",fx,fy,fz", ",fx_N,fy_N,fz_N");
    let stated = read_text(
        &table(&stated, plain),
        &LogOptions {
            world_from_log: Some(Pose::identity()),
            ..LogOptions::default()
        },
    );
    assert_eq!(stated.conventions, [] as [&str; 0]);
}

#[test]
fn times_that_do_not_advance_are_refused_and_repeated_lines_count_once() {
    let names = "t,x,y,z,qx,qy,qz,qw,fx,fy,fz";
    let line = |t: f64, x: f64| format!("{t},{x},0,0.8,0,0,0.2474,0.9689,0,0,10");
    let constant = table(names, |_, x| line(12.5, x));
    let found = refused_text(&constant, &LogOptions::default());
    assert!(
        found.contains(&format!("all {COUNT} samples have the same time, 12.5 s")),
        "{found}"
    );
    let with_rate = LogOptions {
        rate: Some(25.0),
        ..LogOptions::default()
    };
    assert_eq!(read_text(&constant, &with_rate).samples.len(), COUNT);
    let doubled = table(names, |t, x| format!("{}\n{}", line(t, x), line(t, x)));
    let log = read_text(&doubled, &LogOptions::default());
    assert_eq!((log.samples.len(), log.repeated), (COUNT, COUNT));
}

#[test]
fn times_since_1970_are_exact_to_the_nanosecond() {
    let start = 1_760_000_000_123_456_789_i64;
    let nanoseconds = |t: f64| start + (t * 1e9).round() as i64;
    let whole = |t: f64| nanoseconds(t).to_string();
    let decimal = |digits: usize, t: f64| {
        let mut text = whole(t);
        text.insert(digits, '.');
        text
    };
    let cases: [(&str, &dyn Fn(f64) -> String); 3] = [
        ("nanoseconds", &whole),
        ("milliseconds", &|t| decimal(13, t)),
        ("seconds", &|t| decimal(10, t)),
    ];
    for (what, write) in cases {
        let text = table(NAMES, |t, x| {
            plain(t, x).replacen(&t.to_string(), &write(t), 1)
        });
        let log = read_text(&text, &LogOptions::default());
        assert_is_it(&log, what);
        assert_eq!(log.start, start, "{what}");
        let exact =
            (log.samples.iter().enumerate()).all(|(tick, sample)| sample.time == time(tick));
        assert!(exact, "{what}");
    }
}

#[test]
fn seconds_and_nanoseconds_in_two_columns_are_one_time() {
    let start = 1_760_000_000_i64;
    let line = |t: f64, x: f64| {
        let (seconds, nanoseconds) = (t.floor() as i64, (t.fract() * 1e9).round() as i64);
        plain(t, x).replacen(
            &t.to_string(),
            &format!("{},{nanoseconds}", start + seconds),
            1,
        )
    };
    let heads = [
        "secs,nsecs",
        "/wrench/header/stamp/sec,/wrench/header/stamp/nanosec",
        "field.header.stamp.secs,field.header.stamp.nsecs",
        "header.stamp.sec,header.stamp.nanosec",
    ];
    for head in heads {
        let names = NAMES.replacen('t', head, 1);
        let log = read_text(&table(&names, line), &LogOptions::default());
        assert_is_it(&log, head);
        assert_eq!(log.start, start * 1_000_000_000, "{head}");
        let remark = log
            .remarks
            .iter()
            .any(|remark| remark.contains("sums of the columns"));
        assert!(remark, "{head}: {:?}", log.remarks);
    }
    let names = NAMES.replacen('t', "sec,nanosec", 1);
    for wrong in ["1000000000", "-1", "0.5", "x"] {
        let text = table(&names, |t, x| {
            plain(t, x).replacen(&t.to_string(), &format!("7,{wrong}"), 1)
        });
        let fault = refused_text(&text, &LogOptions::default());
        assert!(
            fault.contains("line 2, column \"nanosec\""),
            "{wrong}: {fault}"
        );
        assert!(fault.contains("from 0 to 999999999"), "{wrong}: {fault}");
    }
    // Microseconds, and units in brackets.
    let halves = |head: &str, nanoseconds: i64| {
        let names = NAMES.replacen('t', head, 1);
        let line = |t: f64, x: f64| {
            let part = (t.fract() * 1e9).round() as i64 / nanoseconds;
            let halves = format!("{},{part}", t.floor());
            plain(t, x).replacen(&t.to_string(), &halves, 1)
        };
        read_text(&table(&names, line), &LogOptions::default())
    };
    assert_is_it(&halves("tv_sec,tv_usec", 1000), "microseconds");
    assert_is_it(&halves("Time (sec),Time (nsec)", 1), "units in brackets");
    // Whole times beside the same in nanoseconds, and columns that are no times.
    let names = NAMES.replacen('t', "time_sec,time_nsec,timeout_sec,timeout_nsec", 1);
    let whole = |t: f64, x: f64| {
        let times = format!("{},{},5,0", t + 0.5, (t + 0.5) * 1e9);
        plain(t, x).replacen(&t.to_string(), &times, 1)
    };
    assert_is_it(
        &read_text(&table(&names, whole), &LogOptions::default()),
        "whole times",
    );
    // The stamps of the poses come before those of the forces.
    let both = "/wrench/stamp/sec,/wrench/stamp/nanosec,/pose/stamp/sec,/pose/stamp/nanosec";
    let names = NAMES.replacen('t', both, 1);
    let line = |t: f64, x: f64| {
        let times = format!("5,0,{},{}", t.floor(), (t.fract() * 1e9).round());
        plain(t, x).replacen(&t.to_string(), &times, 1)
    };
    assert_is_it(
        &read_text(&table(&names, line), &LogOptions::default()),
        "two stamps",
    );
    // Another column of times comes first.
    let names = NAMES.replacen('t', "t,sec,nanosec", 1);
    let log = read_text(
        &table(&names, |t, x| {
            plain(t, x).replacen(&t.to_string(), &format!("{t},7,x"), 1)
        }),
        &LogOptions::default(),
    );
    assert_is_it(&log, "t beside seconds and nanoseconds");
}

#[test]
fn shuffled_times_are_sorted_and_never_another_unit() {
    let mut lines: Vec<String> = table(NAMES, plain).lines().map(str::to_owned).collect();
    let names = lines.remove(0);
    // 97 has no factor in common with 250, so every line is taken once.
    let shuffled = (0..COUNT).map(|k| lines[k * 97 % COUNT].clone());
    let text = format!("{names}\n{}\n", shuffled.collect::<Vec<_>>().join("\n"));
    let wide = LogOptions {
        reorder_window: 10.0,
        ..LogOptions::default()
    };
    let log = read_text(&text, &wide);
    assert_is_it(&log, "shuffled");
    let remark = &log.remarks[0];
    assert!(remark.contains("late and were sorted by time"), "{remark}");
    let refused = refused_text(&text, &LogOptions::default());
    assert!(
        refused.contains("earlier than the latest earlier time"),
        "{refused}"
    );
}

#[test]
fn a_unit_of_some_columns_only_is_reported_and_words_for_nothing_are_empty() {
    let names = NAMES
        .replace(",x,y,z,", ",x,y,z [mm],")
        .replace(",fx,fy,fz", ",fx [gf],fy,fz");
    let log = read_text(&table(&names, plain), &LogOptions::default());
    let partly = "read as x, y in metres and fy, fz in newtons: the log states no unit for these columns, but one for other columns of the same quantity";
    assert!(
        log.remarks.iter().any(|remark| remark == partly),
        "{:?}",
        log.remarks
    );
    for word in ["None", "null", "NA", "n/a"] {
        let text = table(NAMES, |t, x| {
            if (t - 2.0).abs() < 1e-9 {
                plain(t, x).replace(",0,0,10", &format!(",{word},{word},{word}"))
            } else {
                plain(t, x)
            }
        });
        assert_is_it(&read_text(&text, &LogOptions::default()), word);
    }
}

#[test]
fn outliers_of_the_force_are_left_out_and_reported() {
    let spiked = |spikes: &[f64]| {
        table(NAMES, |t, x| {
            let is_spike = spikes.iter().any(|time| (time - t).abs() < 1e-9);
            let force = if is_spike { ",0,0,500" } else { ",0,0,10" };
            plain(t, x).replace(",0,0,10", force)
        })
    };
    let log = read_text(&spiked(&[2.0, 3.0, 8.0]), &LogOptions::default());
    assert_is_it(&log, "interpolated");
    assert_eq!(
        log.remarks,
        [
            "3 samples of the force are outliers, the first with 500.0 N at 2.000 s, where its neighbours have 10.0 N: left out, and the force is interpolated between its neighbours"
        ]
    );
    let narrow = LogOptions {
        max_gap: 0.05,
        ..LogOptions::default()
    };
    let log = read_text(&spiked(&[2.0]), &narrow);
    assert_eq!(log.samples.len(), COUNT);
    assert!(
        log.remarks[0].ends_with(
            "used as measured, because its neighbours are more than 0.05 s apart (--max-gap-s)"
        ),
        "{:?}",
        log.remarks
    );
}

/// Returns a table of poses and forces, with either left out where `has` says so at a time [s].
fn with_holes(has: impl Fn(f64) -> [bool; 2]) -> String {
    let noise = |t: f64| 0.3 * (1e4 * t).sin();
    table("t,x,y,z,qx,qy,qz,qw,fx,fy,fz", |t, x| {
        let [has_pose, has_force] = has(t);
        let pose = format!("{x},0,0.8,0,0,0,1");
        let press = if t.rem_euclid(4.0) < 2.0 { 0.0 } else { 10.0 };
        let force = format!("{},{},{}", noise(t), noise(t + 0.3), press + noise(t + 0.7));
        let pose = if has_pose { &pose } else { ",,,,,," };
        let force = if has_force { &force } else { ",," };
        format!("{t},{pose},{force}")
    })
}

#[test]
fn poses_before_and_after_the_forces_are_listed() {
    let options = LogOptions::default();
    let whole = read_text(&with_holes(|_| [true; 2]), &options);
    assert_eq!(whole.poses_alone, []);
    let shorter = read_text(&with_holes(|t| [true, t < 9.5]), &options);
    assert_eq!(shorter.poses_alone, [], "half a second is nothing");
    let kept: [fn(f64) -> bool; 2] = [|t| t < 4.0, |t| t > 4.0];
    for has_force in kept {
        let log = read_text(&with_holes(|t| [true, has_force(t)]), &options);
        assert_eq!(log.poses_alone.len() + log.samples.len(), COUNT);
        let first = log.samples[0].world_from_tool.translation.x;
        for (time, pose) in &log.poses_alone {
            assert!((pose.translation.x - first - 0.1 * time).abs() < 1e-6);
        }
    }
}

/// Two times may be farther apart than the nanoseconds of an integer.
#[test]
fn times_at_both_ends_of_their_range_are_read() {
    let options = LogOptions {
        time_unit: Some(1.0),
        ..LogOptions::default()
    };
    let row = |t: f64, has_force: bool| {
        let force = if has_force { "0,0,10" } else { ",," };
        format!("{t},0,0,0.8,0,0,0,1,{force}\n")
    };
    for has_early_force in [true, false] {
        let mut text = "t,x,y,z,qx,qy,qz,qw,fx,fy,fz\n".to_owned();
        for begin in [-8.9e9, 8.9e9] {
            for k in 0..40 {
                // Three rows of the same time each.
                let t = begin + f64::from(k / 3);
                text += &row(t, has_early_force || begin > 0.0);
            }
        }
        let log = read_text(&text, &options);
        assert!(!log.samples.is_empty());
    }
}

#[test]
fn forces_of_contact_beyond_the_poses_are_counted() {
    let options = LogOptions::default();
    let lost = |until: f64| {
        let log = read_text(&with_holes(|t| [t < until, true]), &options);
        log.unusable.missing_pose
    };
    assert_eq!(lost(11.0), 0);
    assert_eq!(lost(8.5), 0, "in the air");
    assert_eq!(lost(5.0), COUNT - 125);
}

#[test]
fn a_folder_that_lacks_a_part_of_its_bag_is_refused() {
    let (folder, path) = in_folder();
    super::write_shown(&path, 50.0);
    let name = path.file_name().unwrap().to_str().unwrap();
    let metadata = |other: &str| {
        let text = format!(
            "rosbag2_bagfile_information:\n  relative_file_paths:\n    - {name}\n    - {other}\n  message_count: 3\n"
        );
        fs::write(folder.path().join("metadata.yaml"), text).unwrap();
    };
    metadata(name);
    read(folder.path(), &LogOptions::default()).unwrap();
    metadata("wipe_1.mcap");
    let message = refused(folder.path(), &LogOptions::default());
    assert!(
        message.contains("names the part wipe_1.mcap, which is missing"),
        "{message}"
    );
}

/// Poses and forces have times of their own, as in a bag, and the writer repeats each force.
#[test]
fn held_forces_are_paired_between_or_at_their_measurements() {
    let log = |held: usize| {
        let mut text = "t,x,y,z,qx,qy,qz,qw,fx,fy,fz\n".to_owned();
        for k in 0..1000 {
            let t = 0.02 * k as f64;
            let from = (k / held * held) as f64;
            let force = [0.3, 0.7, 1.1].map(|phase| 5.0 + (from + phase).sin());
            writeln!(text, "{t:.3},{},0,0.8,0,0,0,1,,,", 0.1 * t).unwrap();
            writeln!(
                text,
                "{:.3},,,,,,,,{},{},{}",
                t + 0.01,
                force[0],
                force[1],
                force[2]
            )
            .unwrap();
        }
        read_text(&text, &LogOptions::default())
    };
    // Held for 0.2 s: the forces are interpolated at the times of the poses.
    let dense = log(10);
    assert!(dense.samples.len() > 950, "{}", dense.samples.len());
    assert!(dense.gaps.is_empty() && dense.remarks.iter().any(|one| one.contains("0.20 s later")));
    // Held for 1 s: a sample for each measurement.
    assert_eq!(log(50).samples.len(), 20);
}

/// The share counts forces as pairs, which have the times of the more frequent track.
#[test]
fn rare_forces_beyond_the_poses_count_like_frequent_ones() {
    let share = |every: usize| {
        let mut text = "t,x,y,z,qx,qy,qz,qw,fx,fy,fz\n".to_owned();
        for k in 0..2000_usize {
            let t = 0.005 * k as f64;
            let press = if t.rem_euclid(2.0) < 1.0 { 0.0 } else { 10.0 };
            let noise = 0.1 * (1e4 * t).sin();
            let pose = if t < 6.0 {
                format!("{},0,0.8,0,0,0,1", 0.1 * t)
            } else {
                ",,,,,,".to_owned()
            };
            let force = if k % every == 0 {
                format!("{noise},0,{}", press + noise)
            } else {
                ",,".to_owned()
            };
            writeln!(text, "{t:.4},{pose},{force}").unwrap();
        }
        let log = read_text(&text, &LogOptions::default());
        let lost = log.unusable.missing_pose as f64;
        lost / (lost + log.samples.len() as f64)
    };
    for every in [1, 2, 10] {
        assert!(
            (share(every) - 0.4).abs() < 0.02,
            "{every}: {}",
            share(every)
        );
    }
}
