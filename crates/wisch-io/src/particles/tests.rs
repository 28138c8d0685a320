use super::*;
use proptest::prelude::*;
use wisch::geometry::{Mesh, Point2, Polygon, Pose, Vector2};
use wisch::represent::{DirtArea, Fate, OccupiedArea, ParticleDistribution};

const BOARD: [f64; 2] = [0.40, 0.28];

fn board() -> Polygon {
    Polygon::rectangle(Vector2::from(BOARD))
}

/// A cup of radius 0.08 m in the middle of the board.
fn cup() -> OccupiedArea {
    let mesh = Mesh::cylinder(0.08, 0.1, 48).expect("sizes are positive");
    OccupiedArea::from_scene([&mesh.transform(&Pose::translation(0.0, 0.0, 0.05))])
}

fn bare() -> OccupiedArea {
    OccupiedArea::default()
}

fn on<'a>(outline: &'a Polygon, occupied: &'a OccupiedArea) -> DirtArea<'a> {
    DirtArea { outline, occupied }
}

fn listed(text: &str) -> Result<ParticleDistribution, ParticleSourceError> {
    let (board, bare) = (board(), bare());
    csv_particles("crumbs.csv", text.as_bytes(), on(&board, &bare))
}

#[test]
fn a_list_may_have_a_header_comments_and_spaces() {
    let points = [Point2::new(0.1, -0.05), Point2::new(-0.12, 0.0)];
    let expected = ParticleDistribution::new(&points).expect("finite");
    for text in [
        "0.1,-0.05\n-0.12,0\n",
        "x,y\n0.1,-0.05\n-0.12,0",
        "# seen\nx_m, y_m\r\n0.1, -0.05\r\n\r\n-0.12, 0.0\r\n",
        "\u{feff}x,y\n1e-1,-5e-2\n-0.12,0\n",
        "y,x\n-0.05,0.1\n0,-0.12\n",
        "X_mm,Y_mm\n100,-50\n-120,0\n",
        "x [mm],y [mm]\n100,-50\n-120,0\n",
        "x [m],y [m]\n0.1,-0.05\n-0.12,0\n",
    ] {
        assert_eq!(listed(text), Ok(expected.clone()), "{text:?}");
    }
}

#[test]
fn a_list_is_refused_with_its_line_and_value() {
    let estimate = "particle,x_m,y_m,fate,edge\n";
    for (text, expected) in [
        (
            "",
            "crumbs.csv: there is neither a row nor a header; write a place per line, x,y in metres. Only the list of an observation may be empty",
        ),
        (
            "x,y\n",
            "crumbs.csv: the list has no particles; at least 1 is required",
        ),
        (
            "x,y\n0,0\n0.1,left\n",
            "crumbs.csv:3: y = \"left\" is not a number",
        ),
        (
            "0,0\n0.3,0\n",
            "crumbs.csv:2: (0.3, 0) m is outside the surface's outline",
        ),
        (
            "0,0\n0,NaN\n",
            "crumbs.csv:2: y = NaN m is outside its limits: at least -100 and at most 100",
        ),
        ("0,0\n0,1e300\n", "crumbs.csv:2: y = 1"),
        (
            "0,0,0\n",
            "crumbs.csv:1: 3 columns, expected 2: x and y in metres, separated by a comma; other columns are not read",
        ),
        (
            "0;0\n",
            "crumbs.csv:1: 1 columns, expected 2: x and y in metres, separated by a comma; the numbers are separated by semicolons",
        ),
        (
            "0\t0\n",
            "crumbs.csv:1: 1 columns, expected 2: x and y in metres, separated by a comma; the numbers are separated by tabs",
        ),
        (
            "0,0,\n",
            "crumbs.csv:1: 3 columns, expected 2: x and y in metres, separated by a comma; the line ends in a comma",
        ),
        (
            &format!("{estimate}1,0,0,on_surface,\n"),
            "crumbs.csv:2: particle = \"1\", expected 0",
        ),
        (
            &format!("{estimate}0,0,0,gone,\n"),
            "crumbs.csv:2: fate = \"gone\", expected on_surface",
        ),
        (
            &format!("{estimate}0,0,0,absorbed,1\n"),
            "crumbs.csv:2: edge = \"1\" is given, but only",
        ),
        (
            &format!("{estimate}0,0,0,off_surface,\n"),
            "crumbs.csv:2: edge = \"\" is not the index",
        ),
        (
            &format!("{estimate}0,0,-1,off_surface,4\n"),
            "crumbs.csv:2: edge = 4, but the outline has 4",
        ),
    ] {
        let error = listed(text).expect_err(text).to_string();
        assert!(error.starts_with(expected), "{text:?}: {error}");
    }
}

#[test]
fn all_borders_belong_to_the_surface_and_holes_are_named() {
    for text in ["0.2,0\n", "-0.2,0\n", "0,0.14\n", "0,-0.14\n", "0.2,0.14\n"] {
        assert!(listed(text).is_ok(), "{text}");
    }
    assert!(listed("0.2001,0\n").is_err());
    let square = |at: f64, half: f64| {
        let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
        corners.map(|[x, y]| Point2::new(at + x, y)).to_vec()
    };
    let holes = vec![square(-0.1, 0.02), square(0.1, 0.02)];
    let outline = Polygon::new(board().outer().to_vec(), holes);
    let bare = bare();
    let read = |text: &str| csv_particles("crumbs.csv", text.as_bytes(), on(&outline, &bare));
    let error = read("0.1,0\n").unwrap_err().to_string();
    let expected = "crumbs.csv:1: (0.1, 0) m is in hole 2 of the surface";
    assert!(error.starts_with(expected), "{error}");
    assert!(read("0.12,0\n").is_ok() && read("0.08,0\n").is_ok());
    let error = read("0.3,0\n").unwrap_err().to_string();
    assert!(error.contains("outside the surface's outline"), "{error}");
}

#[test]
fn bytes_that_are_no_text_are_refused_with_their_line() {
    let (board, bare) = (board(), bare());
    let error = csv_particles("crumbs.csv", b"0,0\n\xff\xfe,0\n", on(&board, &bare)).unwrap_err();
    assert!(error.to_string().starts_with("crumbs.csv:2: "), "{error}");
}

fn fates() -> impl Strategy<Value = Fate> {
    prop_oneof![
        Just(Fate::OnSurface),
        Just(Fate::Absorbed),
        (0_u16..4).prop_map(|edge| Fate::OffSurface { edge }),
        (0.0..9.0).prop_map(|passes| Fate::Treated { passes }),
    ]
}

proptest! {
    #[test]
    fn an_estimate_comes_back_bit_by_bit(
        particles in prop::collection::vec((-0.19..0.19, -0.13..0.13, fates()), 1..50)
    ) {
        let particles: Vec<_> = particles.iter().map(|p| (Point2::new(p.0, p.1), p.2)).collect();
        let estimate = ParticleDistribution::with_fates(&particles).expect("finite");
        let text = particles_to_csv(&estimate);
        prop_assert_eq!(&particles_from_csv("e.csv", text.as_bytes()), &Ok(estimate.clone()));
        prop_assert_eq!(&listed(&text), &Ok(estimate));
    }

    #[test]
    fn no_bytes_make_a_source_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let (board, bare) = (board(), bare());
        let _ = csv_particles("x.csv", &bytes, on(&board, &bare));
        let _ = mask_particles(&photo(STRAIGHT, 1), &bytes, on(&board, &bare), 1);
    }
}

const CRUMB: [u8; 3] = [230, 200, 140];
/// The board seen from above at 1000 pixels per metre, with a margin of 20 pixels.
const STRAIGHT: [[f64; 2]; 4] = [[20.0, 300.0], [420.0, 300.0], [420.0, 20.0], [20.0, 20.0]];

fn photo(corners: [[f64; 2]; 4], count: usize) -> MaskSource {
    MaskSource {
        file: "photo.png".to_owned(),
        corners_px: corners.map(Point2::from),
        color: CRUMB,
        tolerance: 10.0,
        count,
    }
}

/// A PNG of 440 × 320 pixels, blue but for crumbs of 4 × 4 pixels whose first pixels are given.
fn png(crumbs: &[[u32; 2]]) -> Vec<u8> {
    let within = |first: u32, at: u32| (first..first + 4).contains(&at);
    let pixels = (0..320).flat_map(|row| (0..440).map(move |column| (column, row)));
    let colors = pixels.flat_map(|(column, row)| {
        let mut crumbs = crumbs.iter();
        if crumbs.any(|c| within(c[0], column) && within(c[1], row)) {
            [228, 203, 139]
        } else {
            [20, 40, 200]
        }
    });
    let samples: Vec<u8> = colors.collect();
    encoded(440, 320, (::png::ColorType::Rgb, 8), &samples)
}

/// A PNG of the samples as they are stored, with a palette if its kind needs one.
fn encoded(
    width: u32,
    height: u32,
    (kind, bits): (::png::ColorType, u8),
    samples: &[u8],
) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(kind);
    encoder.set_depth(::png::BitDepth::from_u8(bits).expect("PNG knows that depth"));
    if kind == ::png::ColorType::Indexed {
        encoder.set_palette([[20, 40, 200], [228, 203, 139]].concat());
    }
    let mut writer = encoder.write_header().expect("written to memory");
    writer.write_image_data(samples).expect("as many samples");
    writer.finish().expect("written to memory");
    bytes
}

#[test]
fn a_photo_from_above_gives_positions_by_the_rule_of_three() {
    let (board, bare) = (board(), bare());
    let bytes = png(&[[120, 80]]);
    let particles = mask_particles(&photo(STRAIGHT, 200), &bytes, on(&board, &bare), 1)
        .expect("there is a crumb");
    assert_eq!(particles.len(), 200);
    // Columns 120 to 124 lie 0.100 to 0.104 m from the left edge, rows 80 to 84 0.060 to 0.064 m
    // from the upper one.
    for p in particles.remaining() {
        assert!((-0.1 - 1e-9..=-0.096 + 1e-9).contains(&p.x), "{p}");
        assert!((0.076 - 1e-9..=0.08 + 1e-9).contains(&p.y), "{p}");
    }
    let middle = particles.remaining().map(|p| p.coords).sum::<Vector2>() / 200.0;
    // Uniform over 4 mm: 1.2 mm / √200 = 0.08 mm.
    assert!((middle - Vector2::new(-0.098, 0.078)).norm() < 5e-4);
}

#[test]
fn a_slanted_photo_is_set_right() {
    // A pinhole camera: points with a larger y are farther away.
    let pixel_of = |x: f64, y: f64| {
        let depth = 1.0 + 0.8 * y + 0.3 * x;
        [220.0 + 450.0 * x / depth, 160.0 - 420.0 * y / depth]
    };
    let [x, y] = BOARD.map(|size| size / 2.0);
    let corners = [(-x, -y), (x, -y), (x, y), (-x, y)].map(|(x, y)| pixel_of(x, y));
    let (board, bare) = (board(), bare());
    for (x, y) in [(0.1, 0.05), (-0.15, 0.1), (0.0, -0.12), (-0.05, -0.02)] {
        let [u, v] = pixel_of(x, y);
        // The crumb's middle is within half a pixel of the true one, its corners 3 further.
        let crumb = [(u - 2.0).round() as u32, (v - 2.0).round() as u32];
        let seen = mask_particles(&photo(corners, 100), &png(&[crumb]), on(&board, &bare), 1)
            .expect("there is a crumb");
        // At least 330 pixels per metre anywhere on the board, so 3.6 pixels are at most 11 mm.
        for p in seen.remaining() {
            assert!(
                (p - Point2::new(x, y)).norm() < 0.011,
                "{p} instead of ({x}, {y})"
            );
        }
        let middle = seen.remaining().map(|p| p.coords).sum::<Vector2>() / 100.0;
        assert!((middle - Vector2::new(x, y)).norm() < 0.003, "{middle}");
    }
}

#[test]
fn crumbs_seen_on_an_object_or_off_the_board_are_left_out() {
    let (board, cup) = (board(), cup());
    // On the cup in the middle, outside the board, and on the board.
    let bytes = png(&[[218, 158], [5, 5], [40, 40]]);
    let particles = mask_particles(&photo(STRAIGHT, 100), &bytes, on(&board, &cup), 1)
        .expect("one crumb is on the board");
    assert!(particles.remaining().all(|p| p.x < -0.17 && p.y > 0.11));
}

#[test]
fn photos_that_cannot_be_used_are_refused() {
    let (board, bare) = (board(), bare());
    let refused = |corners, bytes: &[u8]| {
        let result = mask_particles(&photo(corners, 5), bytes, on(&board, &bare), 1);
        result.expect_err("refused").to_string()
    };
    let bytes = png(&[[120, 80]]);
    let [a, b, c, d] = STRAIGHT;
    for (corners, bytes, expected) in [
        (
            STRAIGHT,
            &b"not an image"[..],
            "photo.png: not a readable PNG or JPEG",
        ),
        (
            STRAIGHT,
            &bytes[..bytes.len() / 2],
            "photo.png: not a readable PNG or JPEG",
        ),
        (
            STRAIGHT,
            &png(&[]),
            "photo.png: no pixel on the free surface is within 10 of the colour [230, 200, 140]",
        ),
        (
            [d, c, b, a],
            &bytes,
            "photo.png: corners_px are not counter-clockwise",
        ),
        (
            [a, b, [500.0, 20.0], d],
            &bytes,
            "photo.png: corners_px[2] = [500, 20] is outside the image of 440 x 320 pixels",
        ),
        (
            [a, [220.0, 160.0], c, d],
            &bytes,
            "photo.png: corners_px[1] is collinear",
        ),
    ] {
        let error = refused(corners, bytes);
        assert!(error.starts_with(expected), "{error}");
    }
}

/// Four pixels, dirt at the lower right, in every kind of PNG.
#[test]
fn every_kind_of_png_shows_the_same_dirt() {
    use ::png::ColorType::{Grayscale, GrayscaleAlpha, Indexed, Rgb, Rgba};
    let (board, bare) = (board(), bare());
    let source = MaskSource {
        corners_px: [[0.0, 2.0], [2.0, 2.0], [2.0, 0.0], [0.0, 0.0]].map(Point2::from),
        color: [255; 3],
        tolerance: 0.0,
        ..photo(STRAIGHT, 20)
    };
    // 0xff7f is nearest to white in eight bits, 0xff7e is not.
    let [almost, white] = [[0xff, 0x7e], [0xff, 0x7f]];
    let four = |dark: &[u8], dirt: &[u8]| [dark, dark, dark, dirt].concat();
    for (kind, bits, samples) in [
        (Grayscale, 1, vec![0b0000_0000, 0b0100_0000]),
        (Grayscale, 4, vec![0xee, 0xef]),
        (Grayscale, 8, four(&[254], &[255])),
        (Grayscale, 16, four(&almost, &white)),
        (GrayscaleAlpha, 8, four(&[254, 255], &[255, 0])),
        (Rgb, 8, four(&[255, 255, 254], &[255, 255, 255])),
        (
            Rgb,
            16,
            four(
                &[white, almost, white].concat(),
                &[white, white, white].concat(),
            ),
        ),
        (Rgba, 8, four(&[0, 255, 255, 255], &[255, 255, 255, 9])),
    ] {
        let bytes = encoded(2, 2, (kind, bits), &samples);
        let seen = mask_particles(&source, &bytes, on(&board, &bare), 1).expect("it is white");
        let dirty = |p: Point2| p.x >= 0.0 && p.y <= 0.0;
        assert!(seen.remaining().all(dirty), "{kind:?} of {bits} bits");
    }
    let by_palette = MaskSource {
        color: [228, 203, 139],
        ..source
    };
    let bytes = encoded(2, 2, (Indexed, 2), &[0b0000_0000, 0b0001_0000]);
    let seen = mask_particles(&by_palette, &bytes, on(&board, &bare), 1).expect("there is dirt");
    assert!(seen.remaining().all(|p| p.x >= 0.0 && p.y <= 0.0));
}

/// Interlaced and progressive files of 32 × 32 pixels, blue but for columns 16 to 23 of rows 8 to 15.
#[test]
fn interlaced_and_progressive_photos_are_read() {
    let (board, bare) = (board(), bare());
    let source = MaskSource {
        corners_px: [[0.0, 32.0], [32.0, 32.0], [32.0, 0.0], [0.0, 0.0]].map(Point2::from),
        color: [255; 3],
        // What JPEG may change, and far from blue.
        tolerance: 100.0,
        ..photo(STRAIGHT, 200)
    };
    for (name, bytes) in [
        (
            "png",
            &include_bytes!("../../tests/data/crumb-interlaced.png")[..],
        ),
        (
            "jpeg",
            &include_bytes!("../../tests/data/crumb-progressive.jpg")[..],
        ),
    ] {
        let seen = mask_particles(&source, bytes, on(&board, &bare), 1).expect("it is white");
        // 0.4 m and 0.28 m for 32 pixels.
        for p in seen.remaining() {
            assert!((-1e-9..=0.1 + 1e-9).contains(&p.x), "{name}: {p}");
            assert!((-1e-9..=0.07 + 1e-9).contains(&p.y), "{name}: {p}");
        }
    }
}

#[test]
fn a_png_of_too_many_pixels_is_refused_before_it_is_decoded() {
    let (board, bare) = (board(), bare());
    let mut bytes = encoded(2, 2, (::png::ColorType::Grayscale, 8), &[0; 4]);
    // Width and height, and the checksum of the chunk that states them.
    bytes[16..24].copy_from_slice(&[0, 1, 0, 0, 0, 1, 0, 0]);
    bytes[29..33].copy_from_slice(&0x49ef6f3f_u32.to_be_bytes());
    let refused = mask_particles(&photo(STRAIGHT, 5), &bytes, on(&board, &bare), 1);
    assert_eq!(
        refused.unwrap_err().to_string(),
        "photo.png: 65536 x 65536 pixels exceed the limit of 64000000"
    );
}

#[test]
fn a_later_photo_has_as_many_detections_as_its_dirt_covers_pixels() {
    let (board, bare) = (board(), bare());
    let source = photo(STRAIGHT, 90);
    let crumbs = [[100, 100], [200, 150], [300, 200]];
    let seen = |later: &[[u32; 2]]| {
        let area = on(&board, &bare);
        read_observed_image(&source, &png(&crumbs), "after.png", &png(later), area, 1)
            .expect("an observation")
            .detections
    };
    assert_eq!(seen(&crumbs).len(), 90);
    assert_eq!(seen(&crumbs[..1]).len(), 30);
    assert_eq!(seen(&[]), []);
    let broken = read_observed_image(
        &source,
        &png(&crumbs),
        "after.png",
        b"GIF",
        on(&board, &bare),
        1,
    );
    assert!(broken.unwrap_err().to_string().starts_with("after.png: "));
}

#[test]
fn a_list_of_what_is_seen_may_be_empty() {
    let seen = |text: &str| read_observed_list("after.csv", text.as_bytes());
    let places = seen("x,y\n0.1,-0.05\n").expect("a place").detections;
    assert_eq!(places, [Point2::new(0.1, -0.05)]);
    assert_eq!(seen("x,y\n").expect("nothing").detections, []);
    // A camera may place dirt at the edge beside the surface.
    assert_eq!(seen("x,y\n0.3,0\n").expect("a place").detections.len(), 1);
    assert!(seen("x,y\n300,0\n").is_err());
    for blank in ["", "\n\n", "# nothing\n"] {
        let error = seen(blank).unwrap_err().to_string();
        assert!(error.contains("neither a row nor a header"), "{error}");
    }
}
