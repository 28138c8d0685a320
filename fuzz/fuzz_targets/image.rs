//! Photos of dirt: bytes that claim to be PNG or JPEG.
#![no_main]

use libfuzzer_sys::fuzz_target;
use wisch::geometry::{Point2, Polygon, Vector2};
use wisch::represent::{DirtArea, OccupiedArea};
use wisch_io::{MaskSource, mask_particles};

fuzz_target!(|bytes: &[u8]| {
    let outline = Polygon::rectangle(Vector2::new(0.4, 0.28));
    let occupied = OccupiedArea::default();
    let source = MaskSource {
        file: "fuzz.png".into(),
        corners_px: [(0.0, 2.0), (2.0, 2.0), (2.0, 0.0), (0.0, 0.0)]
            .map(|(x, y)| Point2::new(x, y)),
        color: [0, 0, 0],
        tolerance: 442.0,
        count: 10,
    };
    let area = DirtArea {
        outline: &outline,
        occupied: &occupied,
    };
    let _ = mask_particles(&source, bytes, area, 1);
});
