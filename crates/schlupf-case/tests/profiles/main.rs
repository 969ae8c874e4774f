//! Profiles as they are measured: axes, order of points, units, formats and origins.

mod formats;
mod order;

use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::Arc;

use schlupf::unwatched;
use schlupf::wheel_rail::ProfileCurve;
use schlupf_case::{CaseFile, Overrides};

type Points = Vec<[f64; 2]>;

/// A case with a wheel from a file (or a name) on a rail from a file (or a name).
fn case(wheel: (&str, &[u8]), rail: (&str, &[u8]), fields: &str) -> Result<CaseFile, String> {
    let text = format!(
        "wheel.profile = {:?}\nrail.profile = {:?}\n{fields}\n\
         [normal]\nmodel = \"wheel-rail\"\nload = \"80 kN\"\n\
         [elasticity]\nmodel = \"half-space\"\n\
         [friction]\nmodel = \"constant\"\ncoefficient = 0.3\n",
        wheel.0, rail.0
    );
    let files = [wheel, rail].into_iter().filter(|(_, bytes)| !bytes.is_empty());
    let files: BTreeMap<String, Vec<u8>> =
        files.map(|(name, bytes)| (name.to_owned(), bytes.to_vec())).collect();
    CaseFile::from_str(&text, "case.toml", Arc::new(files), Overrides::NONE)
        .map_err(|errors| errors.to_string())
}

fn wheel(name: &str, bytes: impl AsRef<[u8]>) -> Result<CaseFile, String> {
    case((name, bytes.as_ref()), ("60E1", b""), "rail.cant = 0.025")
}

fn rail(name: &str, bytes: impl AsRef<[u8]>) -> Result<CaseFile, String> {
    case(("S1002", b""), (name, bytes.as_ref()), "")
}

fn curves(file: &CaseFile) -> [ProfileCurve; 2] {
    let pair = file.wheel().unwrap().pair();
    [pair.wheel(), pair.rail()].map(|of| of.uniform().unwrap().clone())
}

/// S1002 and 60E1 as they are built in, in mm, y outwards and z up.
fn built_in() -> [Points; 2] {
    let file = case(("S1002", b""), ("60E1", b""), "").unwrap();
    let [wheel, rail] = curves(&file);
    let in_millimetres = |points: &[[f64; 2]], [y, z]: [f64; 2]| {
        points.iter().map(|p| [1e3 * (p[0] - y), 1e3 * (p[1] - z)]).collect()
    };
    let origin = file.wheel().unwrap().pair().rail_origin();
    [in_millimetres(wheel.points(), [0.0; 2]), in_millimetres(rail.points(), origin)]
}

fn csv(points: &[[f64; 2]]) -> String {
    let mut text = "y [mm],z [mm]\n".to_owned();
    for [y, z] in points {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{y:.7},{z:.7}");
    }
    text
}

/// A text of points without a header.
fn bare(points: &[[f64; 2]], row: impl Fn([f64; 2]) -> String) -> String {
    points.iter().map(|point| row(*point) + "\n").collect()
}

/// Largest distance of points (in mm) from a curve.
fn off(curve: &ProfileCurve, points: &[[f64; 2]]) -> f64 {
    let on_curve: Points = (0..=4000)
        .map(|k| curve.at(curve.length() * f64::from(k) / 4000.0).place.map(|c| 1e3 * c))
        .collect();
    let to_segment = |[y, z]: [f64; 2], pair: &[[f64; 2]]| {
        let [along, up] = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
        let share = ((y - pair[0][0]) * along + (z - pair[0][1]) * up) / (along * along + up * up);
        let share = share.clamp(0.0, 1.0);
        (y - pair[0][0] - share * along).hypot(z - pair[0][1] - share * up)
    };
    let distance = |point: &[f64; 2]| {
        on_curve.windows(2).map(|pair| to_segment(*point, pair)).fold(f64::INFINITY, f64::min)
    };
    points.iter().map(distance).fold(0.0, f64::max)
}

fn codes(file: &CaseFile) -> Vec<&'static str> {
    file.notices().iter().map(|notice| notice.code).collect()
}

/// The message of a notice.
fn notice(file: &CaseFile, code: &str) -> String {
    let notices = file.notices();
    let found = notices.iter().find(|notice| notice.code == code);
    found.unwrap_or_else(|| panic!("no {code} in {notices:?}")).text.clone()
}

fn peak_pressure(file: &CaseFile) -> f64 {
    file.normal_contact(&unwatched).unwrap().summary.peak_pressure
}

/// The same points shuffled, always in the same way.
fn shuffled(points: &[[f64; 2]]) -> Points {
    let mut points = points.to_vec();
    let mut state = 12_345_u64;
    for k in (1..points.len()).rev() {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        points.swap(k, (state >> 33) as usize % (k + 1));
    }
    points
}

/// A line from one point to another one, without its ends, in steps of at most 1 mm.
fn line(from: [f64; 2], to: [f64; 2]) -> Points {
    let count = (to[0] - from[0]).hypot(to[1] - from[1]).ceil() as usize;
    let at = |k: usize| {
        let share = k as f64 / count as f64;
        [0, 1].map(|c| from[c] + share * (to[c] - from[c]))
    };
    (1..count).map(at).collect()
}

/// An outline that goes on through corners.
fn through(points: &[[f64; 2]], corners: &[[f64; 2]]) -> Points {
    let mut all = points.to_vec();
    for corner in corners {
        let last = all[all.len() - 1];
        all.extend(line(last, *corner));
        all.push(*corner);
    }
    all
}

fn reversed(points: &[[f64; 2]]) -> Points {
    points.iter().rev().copied().collect()
}

/// Wheels that a file may have, y outwards and z up, each with what of it runs.
fn wheels() -> Vec<(String, Points, Points)> {
    let [tread, _] = built_in();
    let (first, last) = (tread[0], tread[tread.len() - 1]);
    let mut all = vec![("running part".to_owned(), tread.clone(), tread.clone())];
    // Both faces, of several heights.
    for height in [5.0, 20.0, 60.0] {
        let front = through(&tread, &[[last[0], height]]);
        let faces = reversed(&through(&reversed(&front), &[[first[0], height]]));
        all.push((format!("faces {height}"), faces.clone(), tread.clone()));
        let closed = through(&faces, &[[first[0], height]]);
        all.push((format!("closed {height}"), closed.clone(), tread.clone()));
        // A loop that begins on the tread.
        let turned = [&closed[200..], &closed[..200]].concat();
        all.push((format!("closed {height}, from the tread"), turned, tread.clone()));
    }
    // The rim with its web and hub, closed.
    let section = through(
        &tread,
        &[
            [last[0], 65.0],
            [12.0, 70.0],
            [12.0, 330.0],
            [90.0, 340.0],
            [90.0, 370.0],
            [-90.0, 370.0],
            [-90.0, 340.0],
            [-12.0, 330.0],
            [-12.0, 70.0],
            [first[0], 65.0],
            first,
        ],
    );
    all.push(("whole section".to_owned(), section, tread.clone()));
    // Worn hollow by 3 mm.
    let hollow = |[y, z]: [f64; 2]| [y, z + 3.0 * (-((y + 5.0) / 20.0).powi(2)).exp()];
    let worn: Points = tread.iter().map(|point| hollow(*point)).collect();
    all.push(("hollow".to_owned(), worn.clone(), worn.clone()));
    for (lowest, highest) in
        [(-69.0, 20.0), (-69.0, 0.0), (-62.0, 40.0), (-55.0, 60.0), (-48.0, 40.0), (-42.0, 60.0)]
    {
        let cut = |points: &Points| -> Points {
            points.iter().filter(|[y, _]| (lowest..=highest).contains(y)).copied().collect()
        };
        all.push((format!("cut {lowest} to {highest}"), cut(&tread), cut(&tread)));
        all.push((format!("hollow, cut {lowest} to {highest}"), cut(&worn), cut(&worn)));
    }
    all
}

/// Rails that a file may have, y outwards and z up, each with what of it runs.
fn rails() -> Vec<(String, Points, Points)> {
    let [_, head] = built_in();
    let cut =
        |depth: f64| -> Points { head.iter().filter(|[_, z]| *z > -depth).copied().collect() };
    let mut all = Vec::new();
    for depth in [40.0, 20.0, 8.0] {
        all.push((format!("{depth} mm deep"), cut(depth), cut(depth)));
    }
    let first = head[0];
    all.push(("closed head".to_owned(), through(&head, &[first]), head.clone()));
    let web = through(&head, &[[8.0, -50.0], [8.0, -90.0]]);
    let web = reversed(&through(&reversed(&web), &[[-8.0, -50.0], [-8.0, -90.0]]));
    all.push(("head and web".to_owned(), web, head.clone()));
    let corners = [[8.0, -50.0], [8.0, -140.0], [75.0, -160.0], [75.0, -172.0]];
    let mirrored = corners.iter().rev().map(|[y, z]| [-y, *z]);
    let corners: Points = corners.iter().copied().chain(mirrored).chain([first]).collect();
    all.push(("whole section".to_owned(), through(&head, &corners), head.clone()));
    let inner: Points = head.iter().filter(|[y, _]| *y < 12.0).copied().collect();
    all.push(("inner side only".to_owned(), inner.clone(), inner));
    all
}

/// Every outline, in all four orientations and from either end, is read the right way round, with
/// all that runs on its curve.
#[test]
fn shapes_are_read_the_right_way_round() {
    for (is_wheel, shapes) in [(true, wheels()), (false, rails())] {
        for (name, outline, running) in shapes {
            for (y_sign, z_sign, is_reversed) in
                [(1.0, 1.0, false), (1.0, -1.0, true), (-1.0, 1.0, true), (-1.0, -1.0, false)]
            {
                if !is_wheel && y_sign < 0.0 && name != "inner side only" {
                    // A symmetrical head looks the same.
                    continue;
                }
                let mut points: Points =
                    outline.iter().map(|[y, z]| [y_sign * y, z_sign * z]).collect();
                if is_reversed {
                    points.reverse();
                }
                let text = csv(&points);
                let file = if is_wheel { wheel("a.csv", text) } else { rail("a.csv", text) };
                let file = file.unwrap_or_else(|error| panic!("{name}: {error}"));
                let [on_wheel, on_rail] = curves(&file);
                // Not the corners to the faces, where a spline swings.
                let running = &running[20..running.len() - 10];
                let found = if is_wheel {
                    off(&on_wheel, running)
                } else {
                    let [y, z] = file.wheel().unwrap().pair().rail_origin();
                    let placed: Points =
                        running.iter().map(|p| [p[0] + 1e3 * y, p[1] + 1e3 * z]).collect();
                    off(&on_rail, &placed)
                };
                assert!(found < 0.02, "{name} ({y_sign}, {z_sign}): {found} mm");
                let (y, z) = (y_sign < 0.0, z_sign < 0.0);
                let reading = &file.profiles()[usize::from(!is_wheel)];
                let axis = ["outwards", "inwards"][usize::from(y)];
                assert!(reading.y.starts_with(axis), "{name}: {}", reading.y);
                let axis = ["up (by its shape)", "down (by its shape)"][usize::from(z)];
                assert_eq!(reading.z, axis, "{name}");
            }
        }
    }
}

/// The largest pressure of S1002 on 60E1 is that of the built-in profile (891 MPa) with the whole
/// outline in Gensys's axes, in Miniprof's with the origin at the flange back, and as a loop.
#[test]
fn whole_outlines_press_as_their_running_parts() {
    let [tread, _] = built_in();
    let expected = peak_pressure(&wheel("S1002", "").unwrap());
    assert!((expected - 891e6).abs() < 1e6, "{expected}");
    let (first, last) = (tread[0], tread[tread.len() - 1]);
    let front = through(&tread, &[[last[0], 20.0]]);
    let faces = reversed(&through(&reversed(&front), &[[first[0], 20.0]]));
    let gensys = bare(&faces, |[y, z]| format!("{} {}", -y, -z));
    let miniprof = bare(&faces, |[y, z]| format!("{} {}", y + 70.0, -z));
    let looped = csv(&through(&faces, &[faces[0]]));
    for (name, text) in [
        ("a.wheel", format!("# nominal\n{gensys}")),
        ("a.whl", format!("ColumnDef=X,Y\n\n{miniprof}")),
        ("a.csv", looped),
    ] {
        let file = wheel(name, text).unwrap();
        assert_eq!(codes(&file), Vec::<&str>::new(), "{name}");
        let found = peak_pressure(&file);
        assert!((found / expected - 1.0).abs() < 3e-3, "{name}: {found}");
    }
}

/// Points in random order, two swapped and twenty repeated ones give the curve of the points in
/// order, and say where they were not.
#[test]
fn lost_order_is_found_again() {
    let [tread, _] = built_in();
    let expected = curves(&wheel("a.csv", csv(&tread)).unwrap())[0].clone();
    let mut swapped = tread.clone();
    swapped.swap(300, 301);
    let mut ends = tread.clone();
    ends.swap(0, 1);
    let repeated = [&tread[..200], &tread[180..]].concat();
    for (name, points, code, place) in [
        ("random", shuffled(&tread), "profile-order", "line"),
        ("swapped", swapped, "profile-order", "in 2 places, the first near line 302"),
        ("swapped at the end", ends, "profile-order", "in 1 place, the first near line 3"),
        (
            "repeated",
            repeated,
            "profile-order",
            "20 repeated rows are left out, the first in line 202",
        ),
    ] {
        let file = wheel("a.csv", csv(&points)).unwrap();
        let text = notice(&file, code);
        assert!(text.contains(place), "{name}: {text}");
        assert_eq!(curves(&file)[0].points(), expected.points(), "{name}");
    }
}

/// A rail with a rolled lip: its lower side, no more than 0.4 mm below the upper one, comes back
/// under the head. In mm.
fn lipped(lip: f64) -> Points {
    let top = |y: f64| -y * y / 600.0;
    let head = (-72..=72).map(|k| 0.5 * f64::from(k)).map(|y| [y, top(y)]);
    let outwards: Points = head.collect();
    let tip = [36.0 + lip, top(36.0) - 0.2 * lip];
    let under = [36.0 - lip, tip[1] - 0.3 * lip];
    let dense = |from: [f64; 2], to: [f64; 2]| -> Points {
        let count = f64::from(((to[0] - from[0]).abs() / 0.5).ceil() as i32);
        let at = |k: f64| [0, 1].map(|c| from[c] + k / count * (to[c] - from[c]));
        (1..=count as i32).map(|k| at(f64::from(k))).collect()
    };
    [outwards, dense([36.0, top(36.0)], tip), dense(tip, under)].concat()
}

/// Where an outline folds back on itself, its points are sorted only where their order is lost:
/// neighbours swapped elsewhere, at an end and in the lip, points swapped far apart, noise that
/// turns back, a block in random order, and a point that is appended at the end.
#[test]
fn lost_order_is_found_beside_a_fold() {
    for lip in [1.0, 2.5, 4.0] {
        let points = lipped(lip);
        let file = rail("a.csv", csv(&points)).unwrap();
        // The outline may end above the gauge depth.
        let told = codes(&file);
        assert!(told.iter().all(|code| *code == "gauge-depth-not-reached"), "{lip}: {told:?}");
        let expected = curves(&file)[1].clone();
        let swap = |j: usize, k: usize| {
            let mut points = points.clone();
            points.swap(j, k);
            points
        };
        let block = [&points[..40], &shuffled(&points[40..60]), &points[60..]].concat();
        for (name, points, place) in [
            ("neighbours", swap(40, 41), "in 2 places, the first near line 42"),
            ("the first points", swap(0, 1), "in 1 place, the first near line 3"),
            ("far apart", swap(20, 90), "near line 22"),
            ("a block", block, "near line 4"),
        ] {
            let file = rail("a.csv", csv(&points)).unwrap_or_else(|e| panic!("{lip} {name}: {e}"));
            let text = notice(&file, "profile-order");
            assert!(text.contains(place), "{lip}, {name}: {text}");
            assert_eq!(curves(&file)[1].points(), expected.points(), "{lip}, {name}");
        }
        // A spike, which is left out, and a point that is measured too far outwards.
        let mut noisy = points.clone();
        let [y, z] = points[50];
        noisy.splice(51..51, [[y + 0.02, z + 0.3], [y + 0.04, z]]);
        noisy[30] = [points[31][0] + 0.2, 0.6 * points[31][1] + 0.4 * points[32][1]];
        let file = rail("a.csv", csv(&noisy)).unwrap_or_else(|e| panic!("{lip} noise: {e}"));
        notice(&file, "profile-order");
        let [y, z] = file.wheel().unwrap().pair().rail_origin();
        let clean: Points =
            points[20..100].iter().map(|p| [p[0] + 1e3 * y, p[1] + 1e3 * z]).collect();
        let found = off(&curves(&file)[1], &clean);
        assert!(found < 0.02, "{lip}: {found} mm");
        // By hand, outwards from the last one; a small lip has no room for it.
        if lip > 1.0 {
            let last = points[points.len() - 1];
            let appended = [&noisy[..], &[[last[0] + 0.7, last[1] - 0.05]]].concat();
            let file = rail("a.csv", csv(&appended)).unwrap_or_else(|e| panic!("{lip}: {e}"));
            assert!(notice(&file, "profile-order").contains("turns back"), "{lip}");
        }
    }
}

/// Two passes of a measurement that overlap are told with their place, and the first one is taken;
/// lines that cross are refused with the place.
#[test]
fn overlaps_and_crossings_are_told() {
    let [tread, _] = built_in();
    let shifted: Points = tread[250..].iter().map(|[y, z]| [y + 0.1, z + 0.01]).collect();
    let file = wheel("a.csv", csv(&[&tread[..300], &shifted].concat())).unwrap();
    let text = notice(&file, "profile-overlap");
    let (from, to) = (tread[250][0], tread[299][0]);
    assert!(text.contains("two passes overlap from line"), "{text}");
    for y in [from, to] {
        assert!(text.contains(&format!("y = {}", y.trunc() as i64)), "{y}: {text}");
    }
    // The later pass lies 0.1 mm aside, but not where the first one is.
    assert!(off(&curves(&file)[0], &tread[..290]) < 2e-3);
    // A stroke across the tread.
    let stroke = line([0.0, -6.0], [0.0, 6.0]);
    let error = wheel("a.csv", csv(&[tread, stroke].concat())).map(|_| ()).unwrap_err();
    assert!(
        error.contains("wheel.profile: the points must form one line, but lines meet"),
        "{error}"
    );
    assert!(error.contains("at y = 0") || error.contains("at y = -0."), "{error}");
}

/// A hole of 12 mm under the contact is warned of with its place (largest pressure some per cent
/// off), and named by what was read; one beside it is named only.
#[test]
fn holes_under_a_contact_are_warned_of() {
    let [tread, _] = built_in();
    let without = |from: f64, to: f64| -> String {
        csv(&tread.iter().filter(|[y, _]| *y < from || *y > to).copied().collect::<Points>())
    };
    let whole = peak_pressure(&wheel("S1002", "").unwrap());
    for (from, is_under) in [(-8.0, true), (30.0, false)] {
        let file = wheel("a.csv", without(from, from + 12.0)).unwrap();
        let holes = &file.profiles()[0].holes;
        assert_eq!(holes.len(), 1, "{holes:?}");
        assert!((holes[0][1][0] - holes[0][0][0] - 12e-3).abs() < 0.9e-3, "{holes:?}");
        let case = file.pose(&unwatched).unwrap();
        let warnings = case.wheel.as_ref().unwrap().warnings();
        let text = warnings.iter().find(|warning| warning.code() == "hole-under-contact");
        assert_eq!(text.is_some(), is_under, "{warnings:?}");
        if let Some(text) = text {
            assert!(text.to_string().contains("no points between y = -8."), "{text}");
            let off = peak_pressure(&file) / whole - 1.0;
            assert!(off.abs() > 5e-3 && off.abs() < 0.2, "{off}");
        }
    }
}

/// Metres without a header are found out and told; what no profile can be is refused with what it
/// would be in another unit; swapped columns are told.
#[test]
fn units_and_swapped_columns_are_told() {
    let [tread, head] = built_in();
    let expected = curves(&wheel("a.csv", csv(&tread)).unwrap())[0].clone();
    let metres = bare(&tread, |[y, z]| format!("{:.9} {:.9}", 1e-3 * y, 1e-3 * z));
    let file = wheel("a.txt", metres.clone()).unwrap();
    let text = notice(&file, "profile-units");
    assert!(text.contains("taken for metres") && text.contains("129.5 mm wide"), "{text}");
    assert!((curves(&file)[0].length() - expected.length()).abs() < 1e-6);
    let wrong = format!("y [mm],z [mm]\n{}", metres.replace(' ', ","));
    let error = wheel("a.csv", wrong).map(|_| ()).unwrap_err();
    assert!(error.contains("wheel.profile must be at least 2 mm wide"), "{error}");
    let expected = "were its numbers 1000 times as large (m for mm), it would be 129.5 mm";
    assert!(error.contains(expected), "{error}");
    let inches = bare(&tread, |[y, z]| format!("{} {}", y / 25.4, z / 25.4));
    let text = notice(&wheel("a.txt", inches).unwrap(), "profile-units");
    assert!(text.contains("were its numbers inches in place of mm"), "{text}");
    for (points, is_wheel) in [(&tread, true), (&head, false)] {
        let text = bare(points, |[y, z]| format!("{z} {y}"));
        let error = if is_wheel { wheel("a.txt", text) } else { rail("a.txt", text) };
        let error = error.map(|_| ()).unwrap_err();
        assert!(error.contains("y and z seem to be swapped"), "{error}");
    }
}

fn utf_16(text: &str, is_little: bool, has_mark: bool) -> Vec<u8> {
    let mark = if has_mark { "\u{feff}" } else { "" };
    let bytes = |unit: u16| if is_little { unit.to_le_bytes() } else { unit.to_be_bytes() };
    format!("{mark}{text}").encode_utf16().flat_map(bytes).collect()
}

/// Texts as other programs and countries write them.
#[test]
fn texts_of_all_kinds_are_read() {
    let [tread, _] = built_in();
    let plain = csv(&tread);
    let expected = curves(&wheel("a.csv", plain.clone()).unwrap())[0].clone();
    let comma = |number: f64| format!("{number:.7}").replace('.', ",");
    let with =
        |header: &str, row: &dyn Fn([f64; 2]) -> String| format!("{header}\n{}", bare(&tread, row));
    let texts: Vec<(&str, Vec<u8>)> = vec![
        (
            "capitals",
            plain.replace("y [mm],z [mm]", "Y [mm], Z [MM]").replace("[MM]", "[mm]").into(),
        ),
        ("byte order mark", format!("\u{feff}{plain}").into()),
        ("UTF-16, little", utf_16(&plain, true, true)),
        ("UTF-16, big", utf_16(&plain, false, true)),
        ("UTF-16 without a mark", utf_16(&plain, true, false)),
        (
            "a third column",
            with("y [mm],weight,z [mm]", &|[y, z]| format!("{y:.7},1,{z:.7}")).into(),
        ),
        (
            "semicolons",
            with("y [mm];z [mm]", &|[y, z]| format!("{};{}", comma(y), comma(z))).into(),
        ),
        ("tabs", with("y [mm]\tz [mm]", &|[y, z]| format!("{}\t{}", comma(y), comma(z))).into()),
        ("semicolons, bare", bare(&tread, |[y, z]| format!("{};{}", comma(y), comma(z))).into()),
        (
            "decimal commas, bare",
            bare(&tread, |[y, z]| format!("{}  {}", comma(y), comma(z))).into(),
        ),
        ("empty last cells", with("y [mm],z [mm]", &|[y, z]| format!("{y:.7},{z:.7},")).into()),
        (
            "empty last cells, header too",
            with("y [mm],z [mm],,", &|[y, z]| format!("{y:.7},{z:.7},,")).into(),
        ),
        ("empty last cells, bare", bare(&tread, |[y, z]| format!("{y:.7};{z:.7};")).into()),
        ("space before the comma", bare(&tread, |[y, z]| format!("{y:.7} ,{z:.7}")).into()),
        ("Fortran", bare(&tread, |[y, z]| format!("{}D+01 {}d-1", y / 10.0, 10.0 * z)).into()),
        ("old line ends", plain.replace('\n', "\r").into()),
    ];
    for (name, bytes) in texts {
        let file = wheel("a.csv", bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!((curves(&file)[0].length() - expected.length()).abs() < 1e-8, "{name}");
        let has_commas =
            name.starts_with("decimal commas") || name.starts_with("semicolons") || name == "tabs";
        assert_eq!(file.profiles()[0].format.contains("decimal commas"), has_commas, "{name}");
    }
    for text in ["y [mm],z [mm]\n0,5,1,0\n", "0,5,1,0\n1,5,1,0\n"] {
        let error = wheel("a.csv", text).map(|_| ()).unwrap_err();
        assert!(error.contains("by semicolons if numbers have decimal commas"), "{error}");
    }
}
