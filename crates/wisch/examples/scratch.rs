#![allow(missing_docs)]
use std::path::Path;
use wisch::follow::*;
use wisch::plan::*;
use wisch::represent::*;
use wisch::robot::*;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let urdf = std::fs::read_to_string("robots/humanoid.urdf").unwrap();
    let r = RobotModel::from_urdf("h", &urdf, &mut |_| Err(String::new())).unwrap();
    let s = Srdf::parse(
        "humanoid.srdf",
        &std::fs::read_to_string("robots/humanoid.srdf").unwrap(),
        &r,
    )
    .unwrap();
    let texts: Vec<(String, String)> = ["tools", "media", "surfaces", "interactions"]
        .iter()
        .map(|n| {
            (
                n.to_string(),
                std::fs::read_to_string(format!("knowledge/{n}.toml")).unwrap(),
            )
        })
        .collect();
    let files: Vec<(&str, &str)> = texts
        .iter()
        .map(|(a, b)| (a.as_str(), b.as_str()))
        .collect();
    let kb = KnowledgeBase::from_toml(&files).unwrap();
    let name = format!("scenarios/{}.toml", a[1]);
    let f = TaskFile::parse(&name, &std::fs::read_to_string(&name).unwrap(), &[]).unwrap();
    let Intent::Action { tool, medium, .. } = f.intent() else {
        panic!()
    };
    let read = |d: &'static str| {
        move |p: &str| std::fs::read(Path::new(d).join(p)).map_err(|e| e.to_string())
    };
    let action: Action = Action::ALL
        .into_iter()
        .find(|x| x.as_str() == a[2])
        .unwrap();
    let task = f
        .resolve(
            action,
            tool,
            medium,
            a[3].parse().unwrap(),
            &kb,
            &mut read("scenarios"),
            &mut read("knowledge"),
        )
        .unwrap();
    let plan = plan(
        &task,
        &PlanConfig {
            strategy: CoverageStrategy::Kde,
            seed: task.seed,
            bandwidth: f.bandwidth_m(),
            lift_height: f.lift_height_m(),
        },
    )
    .unwrap();
    let cell = Workcell::new(
        r,
        Some(&s),
        &task,
        &WorkcellConfig {
            world_from_robot: f.robot().unwrap().world_from_robot,
            ..Default::default()
        },
    )
    .unwrap();
    let t = std::time::Instant::now();
    let map = std::fs::read("robots/humanoid.reach")
        .ok()
        .map(|b| CapabilityMap::from_bytes("m", &b, RobotHash::of(cell.robot())).unwrap());
    let fo = follow(
        &task,
        &plan,
        &cell,
        map.as_ref(),
        &FollowConfig::default(),
        &mut |_| (),
    )
    .unwrap();
    println!(
        "time {:?} planned {:.3} followed {:.3}",
        t.elapsed(),
        predict(&task, &plan, |_| ()).performance.ratio(),
        predict(
            &task,
            &Plan {
                strokes: fo.strokes.clone(),
                ..plan.clone()
            },
            |_| ()
        )
        .performance
        .ratio()
    );
    for p in &fo.placements {
        println!("place {:?}", p);
    }
    for s in &plan.strokes {
        println!("plan {:?}", s.nodes);
    }
    for s in &fo.strokes {
        println!(
            "done {:?} {}",
            s.nodes,
            s.poses
                .iter()
                .map(|p| format!(
                    "{:.2},{:.2}@{:.0}",
                    p.position.x,
                    p.position.y,
                    p.heading.to_degrees()
                ))
                .collect::<Vec<_>>()
                .join(" ")
        );
    }
    let show = |pl: &Plan| {
        for k in 1..=pl.strokes.len() {
            let pr = predict(
                &task,
                &Plan {
                    strokes: pl.strokes[..k].to_vec(),
                    ..pl.clone()
                },
                |_| (),
            );
            print!(
                "{:.2}/{} ",
                pr.performance.ratio(),
                pr.particles.tally().off_surface
            );
        }
    };
    show(&plan);
    println!();
    show(&Plan {
        strokes: fo.strokes.clone(),
        ..plan.clone()
    });
    println!();
    for s in &plan.strokes {
        println!(
            "plan {:?} {}",
            s.nodes,
            s.poses
                .iter()
                .map(|p| format!(
                    "{:.2},{:.2}@{:.0}",
                    p.position.x,
                    p.position.y,
                    p.heading.to_degrees()
                ))
                .collect::<Vec<_>>()
                .join(" ")
        );
    }
    for m in &fo.motions {
        println!("{} {:.2}..{:.2}", m.phase.as_str(), m.start, m.end());
    }
    for n in &fo.abandoned {
        println!(
            "abandoned {} {:?}",
            n.node,
            n.attempts
                .iter()
                .map(|a| format!("{:.2}/{:.2}: {}", a.rotation, a.progress, a.obstruction))
                .collect::<Vec<_>>()
        );
    }
}
