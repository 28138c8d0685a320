//! Stretch, distances, bends and feet of charts, against closed forms.

use super::shapes::{cap, cylinder, door, grid, saddle, wavy};
use nalgebra::Matrix2;
use wisch_robot::geometry::{Atlas, Mesh, Point2, Point3, Sheet, SheetConfig, SheetError, Vector3};

fn draft(mesh: &Mesh) -> Sheet {
    Sheet::draft(mesh, &SheetConfig::default()).unwrap()
}

#[test]
fn developable_surfaces_unroll_without_stretch() {
    let cone = grid([60, 40], [1.6, 0.4], |angle, along| {
        // Half angle 0.3 rad; the apex is 0.6 m below the middle.
        let (slant, turn) = (0.6 + along, angle / 0.3f64.sin());
        let across = slant * 0.3f64.sin();
        Point3::new(
            across * turn.sin(),
            slant * 0.3f64.cos(),
            across * turn.cos(),
        )
    });
    for (name, mesh) in [
        ("bulging", cylinder([60, 40], [0.6, 0.4], 0.5)),
        ("hollow", cylinder([60, 40], [0.6, 0.4], -0.3)),
        ("nearly closed", cylinder([150, 20], [2.2, 0.3], 0.5)),
        ("cone", cone),
    ] {
        let sheet = draft(&mesh);
        let stretch = sheet.stretch();
        // The quadrics of the smoothing are exact on a cylinder, and not on a cone where it is narrow.
        let limit = match name {
            "bulging" => 1e-6,
            "cone" => 1e-3,
            _ => 1e-4,
        };
        assert!(stretch.most <= limit, "{name}: {stretch:?}");
        assert_eq!(sheet.check(), Ok(()), "{name}");
    }
}

#[test]
fn no_chart_of_a_cap_beats_the_least_stretch_and_this_one_is_near() {
    for angle in [0.3, 0.5, 1.047] {
        // 20 edges from the pole to the border.
        let config = SheetConfig {
            tool_radius: 0.2 * 0.4 * angle,
            ..SheetConfig::default()
        };
        let sheet = Sheet::draft(&cap(40, 0.4, angle), &config).unwrap();
        let stretch = sheet.stretch();
        let least = angle * angle / 12.0;
        // The azimuthal equidistant projection, scaled evenly to both sides.
        let yardstick = (angle / angle.sin()).sqrt() - 1.0;
        assert_eq!(stretch.folded, 0);
        assert!(
            stretch.most >= least,
            "{angle}: {stretch:?}, at least {least}"
        );
        assert!(
            stretch.most <= 1.6 * yardstick,
            "{angle}: {stretch:?}, {yardstick}"
        );
    }
}

/// Returns the relative errors of chart distances between vertices, sorted.
fn distance_errors(sheet: &Sheet, exact: impl Fn(Point3, Point3) -> f64) -> Vec<f64> {
    let vertices: Vec<_> = sheet.vertices().collect();
    let mut errors = Vec::new();
    for one in vertices.iter().step_by(97) {
        for other in vertices.iter().step_by(31) {
            let expected = exact(one.point, other.point);
            if expected > 0.05 {
                errors.push(((one.place - other.place).norm() / expected - 1.0).abs());
            }
        }
    }
    errors.sort_by(f64::total_cmp);
    errors
}

#[test]
fn distances_in_charts_are_those_on_the_surface() {
    let sheet = draft(&cylinder([60, 40], [0.6, 0.4], 0.5));
    let errors = distance_errors(&sheet, |a, b| {
        let angle = |p: Point3| p.x.atan2(p.z + 0.5);
        (0.5 * (angle(a) - angle(b))).hypot(a.y - b.y)
    });
    // A chord of 15 mm is shorter than its arc by 4e-5.
    assert!(
        errors[errors.len() - 1] < 4e-5,
        "{}",
        errors[errors.len() - 1]
    );
    // A wok's patch: a cap of 28° inside a sphere of 0.25 m.
    let sheet = draft(&cap(30, -0.25, 28f64.to_radians()));
    let errors = distance_errors(&sheet, |a, b| {
        let centre = Point3::new(0.0, 0.0, 0.25);
        0.25 * (a - centre).angle(&(b - centre))
    });
    let (median, p95) = (errors[errors.len() / 2], errors[errors.len() * 19 / 20]);
    assert!(median <= 0.01 && p95 <= 0.025, "{median} {p95}");
}

/// Returns the largest difference of the bend from the expected one inside, relative to its largest entry.
fn bend_error(sheet: &Sheet, expected: impl Fn(Point3) -> Matrix2<f64>, reach: f64) -> f64 {
    let inside = sheet.vertices().filter(|v| v.place.coords.norm() < reach);
    inside
        .map(|v| {
            let expected = expected(v.point);
            (v.bend - expected).amax() / expected.amax()
        })
        .fold(0.0, f64::max)
}

#[test]
fn bends_are_those_of_cylinder_sphere_and_saddle() {
    let diagonal = |x, y| Matrix2::new(x, 0.0, 0.0, y);
    let sheet = draft(&cylinder([60, 40], [0.6, 0.4], 0.5));
    assert!(bend_error(&sheet, |_| diagonal(2.0, 0.0), 0.12) < 0.01);
    for radius in [0.5, -0.3] {
        let sheet = draft(&cap(40, radius, 0.5));
        let error = bend_error(
            &sheet,
            |_| diagonal(1.0 / radius, 1.0 / radius),
            0.6 * 0.5 * radius.abs(),
        );
        assert!(error < 0.01, "{radius}: {error}");
    }
    // At its middle, the saddle has (1/R, −1/R) with the sign of a bulge across y.
    let sheet = draft(&saddle([80, 60]));
    let middle = sheet.lift(Point2::origin()).unwrap();
    assert!(
        (middle.bend - diagonal(-2.0, 2.0)).amax() < 0.02,
        "{}",
        middle.bend
    );
}

#[test]
fn the_foot_of_a_lifted_place_is_the_place() {
    for mesh in [
        cylinder([60, 40], [0.6, 0.4], 0.5),
        cap(30, -0.25, 0.5),
        door([60, 50]),
        wavy([50, 40]),
    ] {
        let sheet = draft(&mesh);
        let bounds = sheet
            .outline()
            .outer()
            .iter()
            .fold(0.0, |most: f64, p| most.max(p.coords.amax()));
        let mut count = 0;
        for i in -20..=20 {
            for j in -20..=20 {
                let place = Point2::new(f64::from(i), f64::from(j)) * (bounds / 20.0)
                    + nalgebra::Vector2::new(1e-4, 2e-4);
                let Some(point) = sheet.lift(place) else {
                    assert!(!sheet.outline().contains(place), "{place}");
                    continue;
                };
                count += 1;
                for height in [0.0, 0.02, -0.01] {
                    let foot = sheet.chart(point.point + point.normal * height);
                    assert!(
                        (foot.place - place).norm() < 1e-6,
                        "{place} {height} {foot:?}"
                    );
                    assert!(
                        (foot.height - height).abs() < 1e-6,
                        "{place} {height} {foot:?}"
                    );
                    assert!((foot.normal - point.normal).norm() < 1e-5 && foot.beyond < 1e-6);
                }
                assert!(point.x_axis.dot(&point.normal).abs() < 1e-9);
            }
        }
        assert!(count > 300, "{count}");
    }
}

#[test]
fn points_beyond_the_border_have_their_foot_on_it() {
    let sheet = draft(&grid([20, 20], [0.4, 0.4], |x, y| Point3::new(x, y, 0.1)));
    let foot = sheet.chart(Point3::new(0.3, 0.05, 0.12));
    assert!(
        (foot.place - Point2::new(0.2, 0.05)).norm() < 1e-9,
        "{foot:?}"
    );
    assert!((foot.height - 0.02).abs() < 1e-9 && (foot.beyond - 0.1).abs() < 1e-9);
    assert_eq!(sheet.lift(Point2::new(0.21, 0.0)), None);
}

#[test]
fn normals_are_those_of_the_mesh() {
    let radius = 0.5;
    let sheet = draft(&cap(40, radius, 0.5));
    let centre = Point3::new(0.0, 0.0, -radius);
    for vertex in sheet.vertices() {
        let off = vertex.normal.angle(&(vertex.point - centre));
        assert!(off < 1f64.to_radians(), "{off} at {}", vertex.point);
    }
}

#[test]
fn surfaces_that_need_several_charts_are_refused_in_words() {
    let refuse = |mesh: &Mesh| {
        Sheet::from_mesh(mesh, &SheetConfig::default())
            .err()
            .map(|error| error.to_string())
    };
    let wok = refuse(&cap(40, -0.25, 60f64.to_radians())).unwrap();
    assert!(
        wok.starts_with("unrolling stretches the surface by up to 15."),
        "{wok}"
    );
    assert!(wok.ends_with("the limit is 1 % of its area"), "{wok}");
    let ball = refuse(&Mesh::sphere(0.2, 40).unwrap()).unwrap();
    assert!(
        ball.starts_with("this mesh is closed: 1520 triangles without a border"),
        "{ball}"
    );
    // A tube covers itself or folds, as its projection does.
    let tube = Mesh::cylinder(0.2, 0.5, 60).unwrap();
    let walls: Vec<[u32; 3]> = (tube.triangles().iter().copied())
        .filter(|t| !t.contains(&0) && !t.contains(&(tube.vertices().len() as u32 - 1)))
        .collect();
    let tube = refuse(&Mesh::new(tube.vertices().to_vec(), walls).unwrap()).unwrap();
    assert!(tube.starts_with("unroll"), "{tube}");
    assert_eq!(refuse(&door([60, 50])), None);
    // A strip wound by more than a full turn is developable, but a chart of it covers itself only if it is flat.
    let spiral = grid([200, 4], [10.0, 0.1], |s, y| {
        let angle = s / 1.2;
        Point3::new(
            (1.2 + y) * angle.cos(),
            (1.2 + y) * angle.sin(),
            0.02 * angle,
        )
    });
    let spiral = refuse(&spiral).unwrap();
    assert!(
        spiral.starts_with("unrolled, the surface covers itself"),
        "{spiral}"
    );
}

#[test]
fn a_side_of_a_closed_body_is_taken_towards_the_tool() {
    let slab = Mesh::cuboid(Vector3::new(0.5, 0.3, 0.02)).unwrap();
    for (towards, z) in [(Vector3::z(), 0.01), (-Vector3::z(), -0.01)] {
        let mut config = SheetConfig::default();
        config.choice.towards = Some(towards);
        let sheet = Sheet::from_mesh(&slab, &config).unwrap();
        assert!((sheet.area() - 0.15).abs() < 1e-9);
        let middle = sheet.lift(Point2::origin()).unwrap();
        assert!((middle.normal - towards).norm() < 1e-9 && (middle.point.z - z).abs() < 1e-9);
    }
    let mut config = SheetConfig::default();
    config.choice.towards = Some(Vector3::new(1.0, 1.0, 1.0));
    config.choice.largest_lean = Some(0.1);
    assert_eq!(
        Sheet::from_mesh(&slab, &config).err(),
        Some(SheetError::NoSide { lean: 0.1 })
    );
}

#[test]
fn settings_out_of_range_are_refused() {
    let mesh = grid([4, 4], [0.4, 0.4], |x, y| Point3::new(x, y, 0.0));
    for (radius, limit) in [
        (f64::NAN, 0.03),
        (0.0, 0.03),
        (5.0, 0.03),
        (0.06, 0.0),
        (0.06, f64::INFINITY),
    ] {
        let config = SheetConfig {
            tool_radius: radius,
            stretch_limit: limit,
            ..SheetConfig::default()
        };
        let error = Sheet::draft(&mesh, &config).err().unwrap();
        assert!(matches!(error, SheetError::Setting { .. }), "{error}");
    }
    // 4 m of 1 mm triangles.
    let large = grid([4, 4], [4.0, 4.0], |x, y| Point3::new(x, y, 0.0));
    let config = SheetConfig {
        tool_radius: 0.01,
        ..SheetConfig::default()
    };
    let error = Sheet::draft(&large, &config).err().unwrap();
    assert!(matches!(error, SheetError::TooLarge { .. }), "{error}");
}

#[test]
fn several_charts_cover_what_one_does_not() {
    let parts = |mesh: &Mesh, most: usize, limit: f64| {
        let config = SheetConfig {
            stretch_limit: limit,
            ..SheetConfig::default()
        };
        Atlas::from_mesh(mesh, &config, most).map(|atlas| atlas.charts().to_vec())
    };
    let area = |sheets: &[Sheet]| sheets.iter().map(Sheet::area).sum::<f64>();
    let wok = cap(40, -0.25, 60f64.to_radians());
    let sheets = parts(&wok, 8, 0.03).unwrap();
    // A cap of the sphere has the area 2πR²(1 − cos θ).
    let expected = std::f64::consts::PI * 0.25 * 0.25;
    assert!(
        (area(&sheets) / expected - 1.0).abs() < 3e-3,
        "{}",
        area(&sheets)
    );
    for sheet in &sheets {
        assert_eq!(sheet.check(), Ok(()));
        let middle = sheet.lift(Point2::origin()).unwrap();
        let centre = Point3::new(0.0, 0.0, 0.25);
        assert!(middle.normal.angle(&(centre - middle.point)) < 0.01);
    }
    assert_eq!(parts(&saddle([80, 60]), 8, 0.03).unwrap().len(), 2);
    assert_eq!(parts(&door([60, 50]), 8, 0.03).unwrap().len(), 1);
    assert_eq!(parts(&wok, 1, 0.2).unwrap().len(), 1);
    let error = parts(&wok, 2, 0.03).err().unwrap();
    assert!(matches!(error, SheetError::Stretched { .. }), "{error}");
}

#[test]
fn rough_terrain_is_divided_or_refused() {
    // Heights of a fixed noise at the scale of the tool.
    let terrain = |amplitude: f64| {
        grid([100, 100], [1.0, 1.0], |x, y| {
            let waves = (1..=12).map(|i| {
                let (turn, phase) = (2.4 * f64::from(i), 1.7 * f64::from(i * i));
                (40.0 * (x * turn.cos() + y * turn.sin()) + phase).sin()
            });
            Point3::new(x, y, amplitude * waves.sum::<f64>())
        })
    };
    let divide = |amplitude, most| {
        let mesh = terrain(amplitude);
        Atlas::from_mesh(&mesh, &SheetConfig::default(), most).map(|atlas| atlas.charts().len())
    };
    assert_eq!(divide(1e-4, 64), Ok(1));
    let error = divide(0.02, 64).unwrap_err();
    let is_refused = matches!(
        error,
        SheetError::Stretched { .. } | SheetError::Folded { .. }
    );
    assert!(is_refused, "{error}");
}

#[test]
fn patches_reach_beyond_their_seams_and_cover_the_mesh_once() {
    let wok = cap(40, -0.25, 60f64.to_radians());
    let atlas = Atlas::from_mesh(&wok, &SheetConfig::default(), 8).unwrap();
    let area = |mesh: &Mesh| {
        let corners = |t: &[u32; 3]| t.map(|i| mesh.vertices()[i as usize]);
        let doubled = mesh.triangles().iter().map(|t| {
            let [a, b, c] = corners(t);
            (b - a).cross(&(c - a)).norm()
        });
        0.5 * doubled.sum::<f64>()
    };
    let centre = Point3::new(0.0, 0.0, 0.25);
    for index in 0..atlas.charts().len() {
        let own = area(&atlas.patch_mesh(index));
        let whole = own + area(&atlas.rest_mesh(index).unwrap());
        let expected = std::f64::consts::PI * 0.25 * 0.25;
        assert!((whole / expected - 1.0).abs() < 5e-3, "{whole}");
        let sheet = atlas.patch(index, 0.06);
        // Outline and area end at the seams, and at the rim of the wok.
        assert!((sheet.area() / own - 1.0).abs() < 5e-3);
        let mut beyond = 0;
        for edge in sheet.outline().edges() {
            let along = (edge.end - edge.start).normalize();
            let place = edge.start + nalgebra::Vector2::new(along.y, -along.x) * 0.03;
            let Some(point) = sheet
                .lift(place)
                .filter(|_| !sheet.outline().contains(place))
            else {
                continue;
            };
            // A tangent plane is off by 1.8 mm there.
            let off = ((point.point - centre).norm() - 0.25).abs();
            assert!(off < 5e-4, "{index}: {off} at {place}");
            beyond += 1;
        }
        assert!(beyond > 10, "{index}: {beyond}");
    }
    // Neighbours meet at seams, which together are the borders of the patches without the rim.
    let borders: f64 = (atlas.charts().iter())
        .flat_map(|chart| chart.outline().edges())
        .map(|edge| (edge.end - edge.start).norm())
        .sum();
    let rim = std::f64::consts::TAU * 0.25 * 60f64.to_radians().sin();
    let seams: f64 = atlas.seams().iter().map(|seam| seam.length).sum();
    assert!(
        (2.0 * seams + rim - borders).abs() < 0.03 * borders,
        "{seams} {borders}"
    );
    for seam in atlas.seams() {
        assert!(seam.patches[0] < seam.patches[1] && seam.length > 0.0);
    }
}
