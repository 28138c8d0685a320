//! Task files that are refused, and the locations that their errors state.

use super::*;
use wisch::geometry::Mesh;

#[test]
fn a_fault_is_refused_with_its_place() {
    let count = "count = 10";
    let size = "size_m = [0.5, 0.4]";
    let frame = "frame = \"surface\"";
    let source = "source = \"uniform\"\ncount = 10";
    for (piece, by, expected) in [
        (count, "count = ", "14:"),
        (
            count,
            "coun = 10",
            "14:1: particles: unknown key \"coun\"; nearest: count",
        ),
        (count, "", "12:1: particles: key \"count\" is missing"),
        (
            count,
            "count = 0",
            "14:9: particles.count = 0 is outside its limits: at least 1 and at most 5000000",
        ),
        (
            count,
            "count = 20000001",
            "14:9: particles.count = 20000001 is outside",
        ),
        (
            count,
            "count = 1.5",
            "14:9: particles.count: expected a whole number, found 1.5",
        ),
        (
            count,
            "count = true",
            "14:9: particles.count: expected a whole number, found a boolean",
        ),
        (
            count,
            "count = 10\nfile = \"a.csv\"",
            "15:1: particles: unknown key \"file\"",
        ),
        (
            source,
            "source = \"unifrom\"",
            "13:10: unknown source \"unifrom\"; nearest: uniform",
        ),
        (
            source,
            "source = \"csv\"",
            "12:1: particles: key \"file\" is missing",
        ),
        (
            source,
            "source = \"clusters\"\ncount = 9\nclusters = []",
            "15:12: particles.clusters: 0 clusters",
        ),
        (
            source,
            "source = \"clusters\"\ncount = 9\nclusters = [{ center_m = [0, 0], sigma_m = 0 }]",
            "15:44: particles.clusters[0].sigma_m = 0 is outside",
        ),
        (
            source,
            "source = \"image\"\nfile = \"a.png\"\ncorners_px = [[0, 0]]\ncolor = [1, 2, 3]\ntolerance = 1\ncount = 1",
            "15:14: particles.corners_px: expected an array of length 4, found an array of length 1",
        ),
        (
            source,
            "source = \"image\"\nfile = \"a.png\"\ncorners_px = [[0, 0], [1, 0], [1, 1], [0, 1]]\ncolor = [1, 2, 300]\ntolerance = 1\ncount = 1",
            "16:16: particles.color[2] = 300 is outside its limits: at least 0 and at most 255",
        ),
        (
            "schema = 1",
            "schema = 2",
            "1:10: schema 2 is not supported; this version reads schema 1",
        ),
        ("schema = 1", "", "1:1: key \"schema\" is missing"),
        ("name = \"small\"", "", "1:1: key \"name\" is missing"),
        (
            "name = \"small\"",
            "name = \" \"",
            "2:8: name: expected a string that is not empty",
        ),
        (
            "name = \"small\"",
            "name = \"sm\\u0007ll\"",
            "2:8: name: expected a string without control characters, found the string",
        ),
        (
            "name = \"small\"",
            "name = \"small\"\nseed = -1",
            "3:8: seed = -1 is outside its limits: at least 0",
        ),
        (
            "name = \"small\"",
            "name = \"small\"\ntarget_performance = 95",
            "3:22: target_performance = 95 is outside its limits: at least 0 and at most 1",
        ),
        (
            "action = \"skim\"",
            "action = \"skin\"",
            "3:10: unknown action \"skin\"; nearest: skim",
        ),
        (
            "action = \"skim\"",
            "action = \"skim\"\ngoal = \"(x)\"",
            "4:8: exactly one of action, goal is required, but action and goal are given",
        ),
        (
            "action = \"skim\"",
            "",
            "1:1: exactly one of action, goal is required, but none is given",
        ),
        (
            "[tool]\nname = \"sponge\"",
            "",
            "3:10: tool: key \"name\" is missing",
        ),
        (
            "name = \"breadcrumbs\"",
            "",
            "3:10: medium: key \"name\" is missing",
        ),
        (
            "name = \"sponge\"",
            "name = \"sponge\"\nstart_m = [0, inf]",
            "6:15: tool.start_m[1] = inf is outside",
        ),
        (
            "name = \"table\"\n",
            "",
            "8:1: surface: key \"name\" is missing",
        ),
        (
            size,
            "size_m = [0.5, nan]",
            "10:16: surface.size_m[1] = NaN is outside its limits: at least 0.001 and at most 100",
        ),
        (
            size,
            "size_m = [0, 0.4]",
            "10:11: surface.size_m[0] = 0 is outside",
        ),
        (
            size,
            "size_m = 0.5",
            "10:10: surface.size_m: expected an array of length 2, found 0.5",
        ),
        (
            size,
            "",
            "8:1: surface: exactly one of size_m, outline_m, mesh is required, but none is given",
        ),
        (
            size,
            "outline_m = [[0, 0], [1, 0]]",
            "10:13: surface.outline_m: 2 points are outside the limits of a ring",
        ),
        (
            size,
            "outline_m = [[0, 0], [1, 1], [1, 0], [0, 1]]",
            "10:13: surface.outline_m: the ring crosses itself: edge 0 meets edge 2",
        ),
        (
            size,
            "outline_m = [[0, 0], [1, 0], [2, 0]]",
            "10:13: surface.outline_m: the ring crosses itself",
        ),
        (
            size,
            "outline_m = [[0, 0], [1e-9, 0], [0, 1]]",
            "10:13: surface.outline_m: its area of",
        ),
        (
            size,
            "outline_m = [[0, 0], [0, 0], [1, 0], [0, 1]]",
            "10:13: surface.outline_m: points 0 and 1 are equal",
        ),
        (
            size,
            "outline_m = [[0, 0], [1, 0], [0, 1]]",
            "11:15: surface.skim_edges[0]: names of edges need size_m",
        ),
        (
            size,
            "size_m = [0.5, 0.4]\nholes_m = [[[1, 1], [2, 1], [1, 2]]]",
            "11:12: surface.holes_m[0]: the hole is outside the outline",
        ),
        (
            size,
            "size_m = [0.5, 0.4]\nholes_m = [[[0, 0], [1, 0], [0, 0.1]]]",
            "11:12: surface.holes_m[0]: the hole crosses or touches the outline",
        ),
        (
            "[\"y_min\"]",
            "[\"y_mim\"]",
            "11:15: unknown edge \"y_mim\"; nearest: y_min",
        ),
        (
            "[\"y_min\"]",
            "[4]",
            "11:15: surface.skim_edges[0] = 4 is outside its limits: at least 0 and at most 3",
        ),
        (
            "[\"y_min\"]",
            "[0, \"y_min\"]",
            "11:18: surface.skim_edges[1]: the edge is given twice",
        ),
        (
            "name = \"table\"",
            "name = \"table\"\ncarried_by = \"cap\"",
            "10:14: unknown scene object \"cap\"; nearest: cup",
        ),
        (
            "radius_m = 0.04",
            "radius_m = -1",
            "17:25: scene[0].cylinder.radius_m = -1 is outside",
        ),
        (
            "radius_m = 0.04, ",
            "",
            "17:12: scene[0].cylinder: key \"radius_m\" is missing",
        ),
        (
            frame,
            "box_m = [1, 1, 1]",
            "17:12: scene[0]: exactly one of box_m, cylinder, sphere, capsule, mesh is required, but box_m and cylinder are given",
        ),
        (
            frame,
            "frame = \"surfaces\"",
            "18:9: unknown frame \"surfaces\"; nearest: surface",
        ),
        (
            frame,
            "role = \"obstacles\"",
            "18:8: unknown role \"obstacles\"; nearest: obstacle",
        ),
        (
            frame,
            "quaternion_xyzw = [0, 0, 0.5, 0.5]",
            "18:19: scene[0].quaternion_xyzw: its norm is 0.7071067811865476, but must be within 0.001 of 1",
        ),
        (
            frame,
            "rpy_rad = [0, 0, 0]\nquaternion_xyzw = [0, 0, 0, 1]",
            "15:1: scene[0]: rpy_rad and quaternion_xyzw exclude each other",
        ),
        (
            frame,
            "rpy_rad = [0, 0, 90]",
            "18:18: scene[0].rpy_rad[2] = 90 is outside",
        ),
        (
            "position_m = [0.1, 0.1, 0.05]",
            "position_m = [0.1, 0.1]",
            "19:14: scene[0].position_m: expected an array of length 3, found an array of length 2",
        ),
        (
            "position_m = [0.1, 0.1, 0.05]",
            "[[scene]]\nname = \"cup\"\nbox_m = [1, 1, 1]",
            "20:8: scene[1].name: \"cup\" is already defined at small.toml:16:8",
        ),
        (
            "position_m = [0.1, 0.1, 0.05]",
            "[plan]\nlift_height_m = 5",
            "20:17: plan.lift_height_m = 5 is outside its limits: at least 0.001 and at most 1",
        ),
        (
            "position_m = [0.1, 0.1, 0.05]",
            "[execution]\npush = [{ start_s = 1, start_share = 0.5, duration_s = 1, force_n = [0, 0, 9] }]",
            "20:9: execution.push[0]: exactly one of start_s, start_share, start_stroke is required, but start_s and start_share are given",
        ),
        (
            "position_m = [0.1, 0.1, 0.05]",
            "[execution]\nfriction_change = [{ friction = 0.5 }]",
            "20:20: execution.friction_change[0]: exactly one of start_s, start_share, start_stroke is required, but none is given",
        ),
        (
            "position_m = [0.1, 0.1, 0.05]",
            "[execution]\npush = [{ start_stroke = 0, duration_s = 1, force_n = [0, 0, 9] }]",
            "20:26: execution.push[0].start_stroke = 0 is outside its limits: at least 1",
        ),
    ] {
        let error = parsed(&small_with(&[(piece, by)]))
            .expect_err(by)
            .to_string();
        let expected = format!("small.toml:{expected}");
        assert!(
            error.starts_with(&expected),
            "{by:?}:\n  {error}\n  {expected}"
        );
    }
}

#[test]
fn what_the_knowledge_or_a_file_lacks_is_refused_with_its_place() {
    let mesh = |name: &str, scale: &str| {
        let mesh = format!("mesh = {{ file = \"{name}\"{scale} }}");
        small_with(&[("cylinder = { radius_m = 0.04, height_m = 0.1 }", &mesh)])
    };
    let source = |source: &str| small_with(&[("source = \"uniform\"\ncount = 10", source)]);
    let long = Mesh::cuboid(Vector3::new(300.0, 20.0, 20.0))
        .unwrap()
        .to_binary_stl();
    let assets: [(&str, &[u8]); 5] = [
        ("long.stl", &long),
        ("broken.stl", b"solid x\nfacet"),
        ("empty.csv", b"x,y\n"),
        ("off.csv", b"x,y\n0,0\n9,0\n"),
        ("text.png", b"text"),
    ];
    for (text, expected) in [
        (
            small_with(&[("\"sponge\"", "\"spong\"")]),
            "5:8: unknown tool \"spong\"; nearest: sponge",
        ),
        (
            small_with(&[("\"breadcrumbs\"", "\"breadcrumb\"")]),
            "7:8: unknown medium \"breadcrumb\"; nearest: breadcrumbs",
        ),
        (
            small_with(&[("\"table\"", "\"tabel\"")]),
            "9:8: unknown surface \"tabel\"; nearest: table",
        ),
        (
            small_with(&[("skim_edges = [\"y_min\"]", "")]),
            "9:8: surface: key \"skim_edges\" is missing",
        ),
        (
            mesh("long.stl", ""),
            "17:17: mesh \"long.stl\" is 300 m long, expected 0.001 m to 20 m: it is probably in millimetres: multiply by 0.001; use scale = 0.001",
        ),
        (
            mesh("none.stl", ""),
            "17:17: file \"none.stl\": no such file",
        ),
        (
            mesh("long.step", ""),
            "17:17: file \"long.step\": the name of a mesh file must end in .stl, .obj, .dae, .ply or .asc",
        ),
        (mesh("broken.stl", ""), "17:17: mesh \"broken.stl\": "),
        (
            source("source = \"csv\"\nfile = \"empty.csv\""),
            "12:1: particles: empty.csv: the list has no particles",
        ),
        (
            source("source = \"csv\"\nfile = \"off.csv\""),
            "12:1: particles: off.csv:3: (9, 0) m is outside the surface's outline",
        ),
        (
            source("source = \"csv\"\nfile = \"none.csv\""),
            "12:1: file \"none.csv\": no such file",
        ),
        (
            source(
                "source = \"image\"\nfile = \"text.png\"\ncorners_px = [[0, 1], [1, 1], [1, 0], [0, 0]]\ncolor = [1, 2, 3]\ntolerance = 1\ncount = 1",
            ),
            "12:1: particles: text.png: not a readable PNG or JPEG",
        ),
    ] {
        let file = parsed(&text).unwrap_or_else(|error| panic!("{error}"));
        let Intent::Action {
            action,
            tool,
            medium,
        } = &file.intent
        else {
            panic!("an action is named");
        };
        let error = resolved_as(&file, *action, tool, medium, &assets).expect_err(expected);
        let expected = format!("small.toml:{expected}");
        assert!(
            error.to_string().starts_with(&expected),
            "\n  {error}\n  {expected}"
        );
    }
    let in_metres = parsed(&mesh("long.stl", ", scale = 0.001")).unwrap();
    let task = resolved_as(&in_metres, Action::Skim, "sponge", "breadcrumbs", &assets).unwrap();
    assert!((task.scene[0].mesh.extent() - 0.3).abs() < 1e-9);
    let error = resolved_as(
        &in_metres,
        Action::Absorb,
        "sponge",
        "glass_chippings",
        &assets,
    );
    let error = error.expect_err("foam does not take up glass").to_string();
    assert!(
        error.contains(
            "sponge cannot absorb glass_chippings on table according to the knowledge base, only collect and skim"
        ),
        "{error}"
    );
}

#[test]
fn a_mesh_is_a_surface_with_its_border_as_outline() {
    let with = |keys: &str| {
        small_with(&[
            ("action = \"skim\"", "action = \"absorb\""),
            ("size_m = [0.5, 0.4]\nskim_edges = [\"y_min\"]", keys),
        ])
    };
    let block = Mesh::cuboid(Vector3::new(0.5, 0.4, 0.1)).unwrap();
    let assets: [(&str, &[u8]); 2] = [
        ("block.stl", &block.to_binary_stl()),
        ("broken.ply", b"ply\nformat"),
    ];
    let upwards = "mesh = { file = \"block.stl\", towards = [0, 0, 1] }";
    let task = |text: &str| {
        let file = parsed(text)?;
        resolved_as(&file, Action::Absorb, "sponge", "breadcrumbs", &assets)
    };
    // The upper face is 5 cm above the origin of the file.
    let found = task(&with(&format!("{upwards}\nposition_m = [1, 2, 3]"))).unwrap();
    let middle = found
        .surface
        .world_from_place(wisch::geometry::Point2::origin(), 0.0);
    assert!(
        (middle.translation.vector - Vector3::new(1.0, 2.0, 3.05)).norm() < 1e-6,
        "{middle}"
    );
    assert!((found.surface.outline.area() - 0.2).abs() < 1e-4);
    assert_eq!(found.surface.outline.outer().len(), 4);
    for (keys, expected) in [
        (
            "mesh = { file = \"block.stl\" }".to_owned(),
            "10:17: file \"block.stl\": not usable as a surface: this mesh is closed",
        ),
        (
            upwards.replace(" }", ", patch = 2 }"),
            "10:59: surface.mesh.patch: there is no patch 2: the mesh has 1 patch",
        ),
        (
            upwards.replace(" }", ", patch = \"all\" }"),
            "10:59: surface.mesh.patch: only wisch run, follow, predict and plan take \"all\"; choose the number of a patch, of which the mesh has 1",
        ),
        (
            upwards.replace(" }", ", patch = 0 }"),
            "10:59: surface.mesh.patch: 0 is outside 1 to 64",
        ),
        (
            upwards.replace(" }", ", patch = \"every\" }"),
            "10:59: unknown patch \"every\"; known: all",
        ),
        (
            "mesh = { file = \"none.ply\" }".to_owned(),
            "10:17: file \"none.ply\": no such file",
        ),
        (
            "mesh = { file = \"broken.ply\" }".to_owned(),
            "10:17: mesh \"broken.ply\": ",
        ),
        (
            "mesh = { file = \"block.stl\", side = 1 }".to_owned(),
            "10:30: surface.mesh: unknown key \"side\"",
        ),
        (
            format!("{upwards}\nsize_m = [0.5, 0.4]"),
            "10:8: surface: exactly one of size_m, outline_m, mesh is required, but",
        ),
        (
            format!("{upwards}\nskim_edges = [\"y_min\"]"),
            "11:15: surface.skim_edges[0]: a mesh cannot be skimmed",
        ),
        (
            format!("{upwards}\nshape = \"cylinder\"\nradius_m = 1.0"),
            "10:8: surface.mesh: has its own shape",
        ),
        (
            "mesh = { file = \"block.stl\", towards = [0, 0, 0] }".to_owned(),
            "10:17: file \"block.stl\": not usable as a surface: length of the direction",
        ),
        (
            "mesh = { file = \"block.stl\", scale = 1000 }".to_owned(),
            "10:17: mesh \"block.stl\" is 500 m long",
        ),
    ] {
        let error = task(&with(&keys)).expect_err(expected).to_string();
        assert!(
            error.starts_with(&format!("small.toml:{expected}")),
            "\n  {error}\n  {expected}"
        );
    }
    let mesh = parsed(&with(upwards)).unwrap();
    let error = resolved_as(&mesh, Action::Skim, "sponge", "breadcrumbs", &assets).unwrap_err();
    let error = error.to_string();
    assert!(
        error.starts_with("small.toml:10:17: surface.mesh: a mesh cannot be skimmed"),
        "{error}"
    );
}
