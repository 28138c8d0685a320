//! Push, pull and verification.

use crate::memories::{contents, memory, place, session, some};
use std::fs;
use wisch_fleet::moves::{Filter, PushOptions, pull, push, verify};
use wisch_fleet::store::FleetError;
use wisch_memory::Memory;

fn quiet() -> impl FnMut(usize, usize) {
    |_, _| {}
}

#[tokio::test]
async fn pushed_episodes_are_pulled_byte_for_byte() {
    let folder = tempfile::tempdir().unwrap();
    let memory = memory(&folder.path().join("here"), &some(30));
    let fleet = place(&folder.path().join("fleet"));
    let options = PushOptions::default();
    let pushed = push(&memory, &fleet, &options, &mut quiet()).await.unwrap();
    assert_eq!((pushed.episodes, pushed.there), (30, 0));
    let again = push(&memory, &fleet, &options, &mut quiet()).await.unwrap();
    assert_eq!((again.episodes, again.there, again.commits), (0, 30, 0));
    let there = Memory::create(&folder.path().join("there")).unwrap();
    let pulled = pull(&fleet, &there, &Filter::default(), &mut quiet())
        .await
        .unwrap();
    assert_eq!((pulled.episodes, pulled.of), (30, 30));
    assert_eq!(contents(&memory), contents(&there));
    // Synthetic episodes lack telemetry of most rounds, which is no fault of a copy.
    for id in there.episodes().unwrap() {
        assert!(there.episode(&id).unwrap().faults().is_empty(), "{id}");
    }
    let again = pull(&fleet, &there, &Filter::default(), &mut quiet())
        .await
        .unwrap();
    assert_eq!((again.episodes, again.there), (0, 30));
    assert_eq!(verify(&fleet, &mut quiet()).await.unwrap().faults, [""; 0]);
}

#[tokio::test]
async fn filters_select_episodes() {
    let folder = tempfile::tempdir().unwrap();
    let records = some(80);
    let memory = memory(&folder.path().join("here"), &records);
    let fleet = place(&folder.path().join("fleet"));
    push(&memory, &fleet, &PushOptions::default(), &mut quiet())
        .await
        .unwrap();
    let selected = async |filter: Filter| {
        let there = tempfile::tempdir().unwrap();
        let there = Memory::create(there.path()).unwrap();
        pull(&fleet, &there, &filter, &mut quiet())
            .await
            .unwrap()
            .episodes
    };
    let middle = records[40].interval[0];
    let since = Filter {
        since: Some(middle),
        ..Filter::default()
    };
    assert_eq!(selected(since).await, 40);
    let until = Filter {
        until: Some(middle - 1.0),
        ..Filter::default()
    };
    assert_eq!(selected(until).await, 40);
    let none = Filter {
        robots: vec!["arm".into()],
        ..Filter::default()
    };
    assert_eq!(selected(none).await, 0);
    let all = Filter {
        robots: vec!["humanoid".into()],
        ..Filter::default()
    };
    assert_eq!(selected(all).await, 80);
    let has = |record: &&wisch_memory::EpisodeRecord| {
        record
            .individuals
            .iter()
            .any(|one| one.class == "semco:HumanCollision")
    };
    let collided = Filter {
        classes: vec!["HumanCollision".into()],
        ..Filter::default()
    };
    assert_eq!(selected(collided).await, records.iter().filter(has).count());
    let one = Filter {
        episodes: vec![records[3].id.clone()],
        ..Filter::default()
    };
    assert_eq!(selected(one).await, 1);
    let bound = Filter {
        condition: Some("performance <= 0.8".into()),
        ..Filter::default()
    };
    assert!((1..80).contains(&selected(bound).await));
}

#[tokio::test]
async fn two_episodes_of_one_name_are_a_conflict() {
    let folder = tempfile::tempdir().unwrap();
    let records = some(3);
    let mut others = records.clone();
    others[1].task = "another".into();
    let one = memory(&folder.path().join("one"), &records);
    let other = memory(&folder.path().join("other"), &others);
    let fleet = place(&folder.path().join("fleet"));
    let options = PushOptions::default();
    push(&one, &fleet, &options, &mut quiet()).await.unwrap();
    let error = push(&other, &fleet, &options, &mut quiet())
        .await
        .unwrap_err();
    assert!(matches!(error, FleetError::Conflict { .. }), "{error}");
    let text = error.to_string();
    assert!(
        text.contains("other") && text.contains("fleet/episodes/"),
        "{text}"
    );
    let pulled = pull(&fleet, &other, &Filter::default(), &mut quiet())
        .await
        .unwrap();
    assert_eq!((pulled.episodes, pulled.there), (0, 2));
    let [why] = &pulled.left_out[..] else {
        panic!("{:?}", pulled.left_out)
    };
    assert!(
        why.contains(&records[1].id) && why.contains("different episodes with the same name"),
        "{why}"
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn simultaneous_pushes_add_each_episode_once() {
    let folder = tempfile::tempdir().unwrap();
    let records = some(60);
    let one = memory(&folder.path().join("one"), &records[..40]);
    let other = memory(&folder.path().join("other"), &records[20..]);
    let fleet = place(&folder.path().join("fleet"));
    let task = |memory: Memory| {
        let fleet = fleet.clone();
        tokio::spawn(
            async move { push(&memory, &fleet, &PushOptions::default(), &mut quiet()).await },
        )
    };
    let (one, other) = (task(one), task(other));
    let pushed = [one.await.unwrap().unwrap(), other.await.unwrap().unwrap()];
    assert_eq!(pushed[0].episodes + pushed[1].episodes, 60);
    let verified = verify(&fleet, &mut quiet()).await.unwrap();
    assert_eq!((verified.episodes, verified.faults), (60, vec![]));
    let rows = session(&fleet)
        .await
        .rows("SELECT count(*) AS n FROM rounds HAVING count(*) > 0")
        .await
        .unwrap();
    let rounds: usize = records.iter().map(|record| record.rounds.len()).sum();
    let found = datafusion::arrow::util::pretty::pretty_format_batches(&rows).unwrap();
    assert!(found.to_string().contains(&rounds.to_string()), "{found}");
}

#[tokio::test]
async fn a_damaged_archive_is_named_and_the_others_are_pulled() {
    let folder = tempfile::tempdir().unwrap();
    let records = some(3);
    let memory = memory(&folder.path().join("here"), &records);
    let fleet_folder = folder.path().join("fleet");
    let fleet = place(&fleet_folder);
    push(&memory, &fleet, &PushOptions::default(), &mut quiet())
        .await
        .unwrap();
    let archive = fleet_folder.join(format!("episodes/{}.tar.zst", records[1].id));
    let bytes = fs::read(&archive).unwrap();
    for damage in [Some(bytes.len() / 2), None] {
        match damage {
            Some(length) => fs::write(&archive, &bytes[..length]).unwrap(),
            None => fs::remove_file(&archive).unwrap(),
        }
        let there = folder.path().join(format!("there-{}", damage.is_some()));
        let there = Memory::create(&there).unwrap();
        let pulled = pull(&fleet, &there, &Filter::default(), &mut quiet())
            .await
            .unwrap();
        assert_eq!((pulled.selected, pulled.episodes), (3, 2));
        let [why] = &pulled.left_out[..] else {
            panic!("{:?}", pulled.left_out)
        };
        assert!(why.contains(&format!("episode {}", records[1].id)), "{why}");
        assert_eq!(
            there.episodes().unwrap(),
            [records[0].id.clone(), records[2].id.clone()],
            "no part of the damaged episode"
        );
        let faults = verify(&fleet, &mut quiet()).await.unwrap().faults;
        assert_eq!(faults.len(), 1, "{faults:?}");
    }
}

#[test]
fn credentials_in_a_url_are_refused_and_not_repeated() {
    let error = wisch_fleet::store::StorePlace::open("s3://key:secret@bucket/x").unwrap_err();
    let text = error.to_string();
    assert!(
        text.contains("AWS_ACCESS_KEY_ID") && !text.contains("secret@"),
        "{text}"
    );
    assert!(!text.contains("key:"), "{text}");
}
