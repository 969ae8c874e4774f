//! What the formats of profiles say: commas, Miniprof, Simpack, and what is guessed.

use super::*;

/// What a comma means is decided once for a file, so that no row is read in another way than its
/// neighbours: where some rows are whole numbers, and in every format.
#[test]
fn a_comma_means_the_same_in_all_rows() {
    let [tread, head] = built_in();
    // To 0.1 mm, whole numbers without decimals: `-35 ,2` beside `-36 ,2.1`.
    let coarse: Points = head
        .iter()
        .filter(|[_, z]| *z > -20.0)
        .map(|point| point.map(|c| (10.0 * c).round() / 10.0))
        .collect();
    let expected = curves(&rail("a.csv", csv(&coarse)).unwrap())[1].clone();
    let comma = |number: f64| format!("{number}").replace('.', ",");
    for (name, text) in [
        ("before", bare(&coarse, |[y, z]| format!("{y} ,{z}"))),
        ("after", bare(&coarse, |[y, z]| format!("{y}, {z}"))),
        ("between", bare(&coarse, |[y, z]| format!("{y},{z}"))),
        ("decimal", bare(&coarse, |[y, z]| format!("{} {}", comma(y), comma(z)))),
        ("decimal, semicolons", bare(&coarse, |[y, z]| format!("{}; {}", comma(y), comma(z)))),
    ] {
        let file = rail("a.txt", text).unwrap_or_else(|error| panic!("{name}: {error}"));
        let same = curves(&file)[1]
            .points()
            .iter()
            .zip(expected.points())
            .all(|(p, q)| (p[0] - q[0]).hypot(p[1] - q[1]) < 1e-12);
        assert!(same && curves(&file)[1].points().len() == expected.points().len(), "{name}");
    }
    let comma = |number: f64| format!("{number:.7}").replace('.', ",");
    let miniprof = |row: &dyn Fn([f64; 2]) -> String| {
        format!("XOffset=0,0\nColumnDef=X,Y,A\n\n{}", bare(&tread, |[y, z]| row([y + 70.0, -z])))
    };
    let simpack = |row: &dyn Fn([f64; 2]) -> String| {
        let rows = bare(&tread, |[y, z]| row([y, -z]));
        format!("spline.begin\nunits.len.f = 1000,0\npoint.begin\n{rows}point.end\nspline.end\n")
    };
    let decimal = |[y, z]: [f64; 2]| format!("  {}   {}  1", comma(y), comma(z));
    let separated = |[y, z]: [f64; 2]| format!("{y:.7},{z:.7},1");
    for (name, ending, text, has_decimal_commas) in [
        ("Miniprof, decimal", "a.whl", miniprof(&decimal), true),
        ("Miniprof, separated", "a.whl", miniprof(&separated), false),
        ("Simpack, decimal", "a.prw", simpack(&decimal), true),
        ("Simpack, separated", "a.prw", simpack(&separated).replace("1000,0", "1000"), false),
    ] {
        let file = wheel(ending, text).unwrap_or_else(|error| panic!("{name}: {error}"));
        let shift = if ending == "a.whl" { 70.0 } else { 0.0 };
        let placed: Points = tread.iter().map(|[y, z]| [y + shift, *z]).collect();
        assert!(off(&curves(&file)[0], &placed) < 1e-3, "{name}");
        let format = &file.profiles()[0].format;
        assert_eq!(format.contains("decimal commas"), has_decimal_commas, "{name}: {format}");
    }
    // One row with a decimal comma among rows separated by commas.
    let mixed = simpack(&separated).replacen("point.begin\n", "point.begin\n-70,5 12\n", 1);
    let error = wheel("a.prw", mixed).map(|_| ()).unwrap_err();
    assert!(error.contains("\"70,5 12\"") || error.contains("5 12"), "{error}");
}

/// Files of Miniprof: its axes and the origin of its wheels, comments, keys without values, heads
/// of old devices, and several profiles.
#[test]
fn files_of_miniprof_are_read() {
    let [tread, head] = built_in();
    let rows = bare(&tread, |[y, z]| format!("{:.7} {:.7} 0.0 0.0", y + 70.0, -z));
    let old =
        "MINIPROF 101 148 1994 3 24\nwheel.prd\nStock.......:\n32.58 37.11 14.71  (Sd/Sh/qR)\n";
    let commented = rows.replacen('\n', "\n\" 5.0 5.0\n", 3);
    let keys = "Filename=low.trc\nXOffset=\n\"ColumnDef=N,X,Y\"\nStock=%Talent\nMPD1=A -47 -60 6\n";
    for (name, text) in [
        ("new", format!("ProgramName=x\nXoffset=0.0000\nColumnDef=X,Y,A,C\n\n{rows}")),
        ("keys and comments", format!("{keys}\n{commented}")),
        ("no empty line", format!("{keys}{rows}")),
        ("old", format!("{old}\n{rows}")),
        ("old with comments", format!("#MINIWHEELPROF\nx.whl\nMINIPROF 2020\n\" 32.5\n\n{rows}")),
        ("a remark", format!("{keys}\n{}", rows.replacen(" 0.0\n", " 0.0  added by hand\n", 1))),
        ("parts", format!("[FileInfo]\nDate=1\n\n[Profile1Info]\nA=1\n[Profile1Points]\n{rows}")),
    ] {
        let file = wheel("a.whl", text).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(codes(&file), Vec::<&str>::new(), "{name}");
        // The flange back is at the origin: the tread lies where that of S1002 does.
        let pair = file.wheel().unwrap().pair();
        assert!((pair.wheel_offset() - 0.68).abs() < 1e-9, "{name}: {}", pair.wheel_offset());
        let moved: Points = tread.iter().map(|[y, z]| [y + 70.0, *z]).collect();
        assert!(off(pair.wheel().uniform().unwrap(), &moved) < 1e-3, "{name}");
    }
    let twice = format!("ColumnDef=X,Y\n\n{rows}\nColumnDef=X,Y\n\n{rows}");
    let error = wheel("a.whl", twice).map(|_| ()).unwrap_err();
    assert!(error.contains("a file must have one profile, but another one begins here"), "{error}");
    let parts = format!("[Profile1Points]\n{rows}[Profile2Points]\n{rows}");
    let error = wheel("a.mpt", parts).map(|_| ()).unwrap_err();
    assert!(error.contains("after that of line 1"), "{error}");
    // A rail's X points inwards; the worn gauge face tells nothing here.
    let worn: Points =
        head.iter().map(|[y, z]| [if *y < -30.0 { 0.5 * (y - 30.0) } else { *y }, *z]).collect();
    let rail_rows = bare(&worn, |[y, z]| format!("{:.7} {:.7}", -y, z));
    let file = rail("a.ban", format!("ColumnDef=X,Y\n\n{rail_rows}")).unwrap();
    assert_eq!(file.profiles()[1].y, "inwards (by its format)");
}

/// A wheel whose origin lies at its flange back in a format where it does not usually: it is moved,
/// and told; a position that is given stands.
#[test]
fn the_flange_tells_where_its_back_is() {
    let [tread, _] = built_in();
    let moved: Points = tread.iter().map(|[y, z]| [y + 70.0, *z]).collect();
    let file = wheel("a.csv", csv(&moved)).unwrap();
    let text = notice(&file, "flange-back");
    assert!(text.contains("taken to be at 0 mm, not at -70 mm as usual"), "{text}");
    assert!((file.wheel().unwrap().pair().wheel_offset() - 0.68).abs() < 1e-9);
    let given = "wheel.flange_back_position = \"-70 mm\"";
    let file = case(("a.csv", csv(&moved).as_bytes()), ("60E1", b""), given).unwrap();
    assert!((file.wheel().unwrap().pair().wheel_offset() - 0.75).abs() < 1e-9);
}

/// Files of Simpack: comments, the type of the body, the least distance of points, and a smoothing
/// that is not applied.
#[test]
fn files_of_simpack_are_read() {
    let [tread, head] = built_in();
    let simpack = |head: &str, points: &[[f64; 2]]| {
        let rows = bare(points, |[y, z]| format!(" {y:.7} {:.7}", -z));
        format!(
            "header.begin\n type = 0 % rail\nheader.end\nspline.begin\n{head}\npoint.begin\n\
             % -40.0 30.0\n{rows}point.end\nspline.end\n"
        )
    };
    let plain = rail("a.prr", simpack("", &head)).unwrap();
    assert_eq!(codes(&plain), Vec::<&str>::new());
    assert_eq!(plain.profiles()[1].points[0], head.len());
    let error = wheel("a.prr", simpack("", &head)).map(|_| ()).unwrap_err();
    assert!(
        error.contains("must be that of a wheel, but its type is 0, that of a rail"),
        "{error}"
    );
    let file = rail("a.prr", simpack("approx.smooth = 2.5", &head)).unwrap();
    let text = notice(&file, "profile-setting");
    assert!(text.contains("approx.smooth = 2.5"), "{text}");
    let file = rail("a.prr", simpack("point.dist.min = 1.0", &head)).unwrap();
    assert!(file.profiles()[1].spacing[0] > 0.99e-3, "{:?}", file.profiles()[1]);
    let mirrored: Points = tread.iter().map(|[y, z]| [-y, *z]).collect();
    let inwards = simpack("", &mirrored).replace("type = 0 % rail", "type = 1");
    let text = notice(&wheel("a.prw", inwards).unwrap(), "profile-axes");
    assert!(text.contains("by its shape y points inwards, which is taken"), "{text}");
}

/// A cone shows neither where its flange is nor where z points: what is taken is told, and nothing
/// once it is given; what is given against the shape is told, too.
#[test]
fn guesses_are_told() {
    let cone = csv(&(-30..=30).map(|y| [f64::from(y), 0.0]).collect::<Points>());
    let file = wheel("a.csv", cone.clone()).unwrap();
    assert_eq!(codes(&file), ["profile-axes", "profile-axes"]);
    assert!(notice(&file, "profile-axes").contains("hardly shows where z points; up is taken"));
    let fields = "wheel.profile_z = \"up\"\nwheel.profile_y = \"outwards\"";
    let file = case(("a.csv", cone.as_bytes()), ("60E1", b""), fields).unwrap();
    assert_eq!(codes(&file), Vec::<&str>::new());
    // With a guard rail behind a groove both sides look as if they ran: the format decides.
    let [tread, head] = built_in();
    let groove = [[38.0, -42.0], [75.0, -42.0], [78.0, -2.0], [120.0, 0.0]];
    let guarded = through(&head, &groove);
    let file = rail("a.csv", csv(&guarded)).unwrap();
    assert_eq!(file.profiles()[1].z, "up (a guess)");
    assert!(notice(&file, "profile-axes").contains("rail.profile_z decides"));
    let file = rail("a.rail", bare(&guarded, |[y, z]| format!("{} {}", -y, -z))).unwrap();
    assert_eq!(file.profiles()[1].z, "down (by its format)");
    let down = "wheel.profile_z = \"down\"";
    let file = case(("a.csv", csv(&tread).as_bytes()), ("60E1", b""), down).unwrap();
    let text = notice(&file, "profile-axes");
    assert!(text.contains("z is said to point down, but by its shape it points up"), "{text}");
}

/// A rail is not taken for a wheel, nor the reverse, where the name of the file or its device says
/// which it is.
#[test]
fn the_other_body_is_refused() {
    let [tread, head] = built_in();
    let rows = |points: &[[f64; 2]]| bare(points, |[y, z]| format!("{y:.7} {z:.7}"));
    let keys = format!("ColumnDef=X,Y\n\n{}", rows(&tread));
    let spline = format!("spline.begin\npoint.begin\n{}point.end\nspline.end\n", rows(&tread));
    for (name, text, says) in [
        ("a.whl", keys, "its name ends in .whl, that of a wheel"),
        ("a.prw", spline, "its name ends in .prw, that of a wheel"),
        ("a.wheel", rows(&tread), "its name ends in .wheel, that of a wheel"),
        ("a.txt", format!("MINIWHEELPROF\n\n{}", rows(&tread)), "its device is MINIWHEELPROF"),
    ] {
        let error = rail(name, text).map(|_| ()).unwrap_err();
        assert!(error.contains("must be that of a rail, but"), "{name}: {error}");
        assert!(error.contains(says), "{name}: {error}");
    }
    for (name, text) in [
        ("a.ban", format!("ColumnDef=X,Y\n\n{}", rows(&head))),
        ("a.rail", rows(&head)),
        ("a.txt", format!("#MINIRAILPROF\n\n{}", rows(&head))),
    ] {
        let error = wheel(name, text).map(|_| ()).unwrap_err();
        assert!(error.contains("must be that of a wheel, but"), "{name}: {error}");
    }
}

/// The head of an old file of Miniprof ends where rows of numbers begin, with and without empty
/// lines in it and before the rows, whatever numbers it has.
#[test]
fn heads_without_keys_end_where_rows_begin() {
    let [tread, _] = built_in();
    let rows = bare(&tread, |[y, z]| format!("{:.7} {:.7}", y + 70.0, -z));
    let first = "MINIPROF 101 148 1994 3 24\nwheel.prd\n";
    let flange = "32.58 37.11 14.71 (Sd/Sh/qR)\n1 2\n";
    for head in [
        format!("{first}{flange}\n"),
        format!("{first}\n{flange}\n"),
        format!("{first}{flange}"),
        format!("{first}\n{flange}Stock: 1\n"),
    ] {
        let file = wheel("a.whl", format!("{head}{rows}"));
        // Nothing tells numbers alone in the line before the rows from a row.
        let extra = usize::from(head.ends_with("1 2\n"));
        let points = file.unwrap().profiles()[0].points[0];
        assert_eq!(points, tread.len() + extra, "{head:?}");
    }
    let error = wheel("a.whl", format!("{first}{flange}")).map(|_| ()).unwrap_err();
    assert!(error.contains("a head without keys ends with the first 8 rows"), "{error}");
}

/// Half a section of a rail, which is higher than wide, is read as it is; a header confirms that.
#[test]
fn half_a_section_is_not_taken_for_swapped() {
    let [_, head] = built_in();
    let outer: Points = head.iter().filter(|[y, _]| *y >= 0.0).copied().collect();
    let corners = [[8.0, -50.0], [8.0, -140.0], [75.0, -160.0], [75.0, -172.0], [0.0, -172.0]];
    let half = through(&outer, &corners);
    let file = rail("a.txt", bare(&half, |[y, z]| format!("{y} {z}"))).unwrap();
    let text = notice(&file, "profile-axes");
    assert!(text.contains("a header `y [mm],z [mm]` confirms"), "{text}");
    assert_eq!(codes(&rail("a.csv", csv(&half)).unwrap()), Vec::<&str>::new());
    let swapped = rail("a.txt", bare(&half, |[y, z]| format!("{z} {y}")));
    assert!(swapped.is_err() || swapped.is_ok_and(|file| !codes(&file).is_empty()));
}

/// Files without a convention have none in what is said of them, and headers are told what to be.
#[test]
fn what_is_no_convention_is_a_default() {
    let [_, head] = built_in();
    let file = rail("a.txt", bare(&head, |[y, z]| format!("{y} {z}"))).unwrap();
    assert_eq!(file.profiles()[1].y, "outwards (by default)");
    // Where the side that alone reaches down is at the largest y, that is the inner one.
    let inner: Points = head.iter().filter(|[y, _]| *y < 12.0).map(|[y, z]| [-y, *z]).collect();
    let file = rail("a.txt", bare(&inner, |[y, z]| format!("{y} {z}"))).unwrap();
    assert_eq!(file.profiles()[1].y, "inwards (by its shape)");
    assert_eq!(codes(&file), Vec::<&str>::new());
    for (text, expected) in [
        ("y [mm],z [mm]\n", "must have rows of points, but has none"),
        ("x [mm],y [mm]\n0,0\n", "if x is lateral and y vertical, name them `y [m],z [m]`"),
        ("Rail 60E1 profile\n0 0\n", "must be a comment, which begins with #"),
    ] {
        let error = rail("a.csv", text).map(|_| ()).unwrap_err();
        assert!(error.contains(expected), "{error}");
    }
}
