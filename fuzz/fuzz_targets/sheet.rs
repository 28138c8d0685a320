//! Charts of small meshes: positions on a coarse grid, which makes coincident vertices, gaps and thin triangles likely.
#![no_main]

use libfuzzer_sys::fuzz_target;
use wisch::geometry::{Mesh, Point2, Point3, Sheet, SheetConfig, Vector3};

fuzz_target!(|bytes: &[u8]| {
    let Some((&count, rest)) = bytes.split_first() else {
        return;
    };
    let count = usize::from(count % 32) + 3;
    if rest.len() < 3 * count {
        return;
    }
    let (positions, indices) = rest.split_at(3 * count);
    let vertices = (positions.as_chunks::<3>().0.iter())
        .map(|p| Point3::from(p.map(|c| f64::from(c as i8) / 2048.0)))
        .collect();
    let triangles = (indices.as_chunks::<3>().0.iter())
        .map(|t| t.map(|i| u32::from(i) % count as u32))
        .collect();
    let Ok(mesh) = Mesh::new(vertices, triangles) else {
        return;
    };
    let mut config = SheetConfig::default();
    config.choice.towards = bytes.len().is_multiple_of(2).then(Vector3::z);
    let Ok(sheet) = Sheet::draft(&mesh, &config) else {
        return;
    };
    let _ = sheet.check();
    assert!(sheet.stretch().most >= 0.0 && sheet.area() > 0.0);
    if let Some(point) = sheet.lift(Point2::origin()) {
        assert!((point.normal.norm() - 1.0).abs() < 1e-9);
        let foot = sheet.chart(point.point);
        assert!(foot.height.is_finite() && foot.beyond.is_finite());
    }
});
