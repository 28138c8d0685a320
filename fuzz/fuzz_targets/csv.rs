//! Lists of particles.
#![no_main]

use libfuzzer_sys::fuzz_target;
use wisch::geometry::{Polygon, Vector2};
use wisch::represent::{DirtArea, OccupiedArea};
use wisch_io::{csv_particles, particles_from_csv, particles_to_csv};

fuzz_target!(|bytes: &[u8]| {
    let outline = Polygon::rectangle(Vector2::new(0.4, 0.28));
    let occupied = OccupiedArea::default();
    let area = DirtArea {
        outline: &outline,
        occupied: &occupied,
    };
    let _ = csv_particles("fuzz.csv", bytes, area);
    if let Ok(particles) = particles_from_csv("fuzz.csv", bytes) {
        let again = particles_from_csv("again.csv", particles_to_csv(&particles).as_bytes());
        assert_eq!(again.as_ref(), Ok(&particles));
    }
});
