//! Order of points: sections, passes over the same part, noise, and what cannot be a coordinate.

use super::*;

/// The head of the rail in its order, what runs of it on a case's curve, and its pressure.
fn expected() -> (Points, ProfileCurve, f64) {
    let [_, head] = built_in();
    let file = rail("a.csv", csv(&head)).unwrap();
    (head, curves(&file)[1].clone(), peak_pressure(&file))
}

/// Sections in another order than along the outline are joined where they meet: halves from the top
/// down, three sections, a section that runs the other way, and a wheel from the tread out.
#[test]
fn sections_are_joined() {
    let (head, curve, _) = expected();
    let top = head.len() / 2;
    let (third, two_thirds) = (170, 320);
    let down = [reversed(&head[..top]), head[top..].to_vec()].concat();
    let a_c_b = [&head[..third], &head[two_thirds..], &head[third..two_thirds]].concat();
    let turned =
        [&head[..third], &reversed(&head[third..two_thirds]), &head[two_thirds..]].concat();
    let last_first = [&head[two_thirds..], &head[..two_thirds]].concat();
    for (name, points) in
        [("halves", down), ("a, c, b", a_c_b), ("b turned", turned), ("c, a, b", last_first)]
    {
        let file = rail("a.csv", csv(&points)).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(notice(&file, "profile-order").contains("were sorted along it"), "{name}");
        let found = curves(&file)[1].clone();
        assert_eq!(found.points().len(), curve.points().len(), "{name}");
        assert!(found.points().iter().zip(curve.points()).all(|(p, q)| p == q), "{name}");
    }
    let [tread, _] = built_in();
    let outwards = [reversed(&tread[..300]), tread[300..].to_vec()].concat();
    let file = wheel("a.csv", csv(&outwards)).unwrap();
    let curve = curves(&wheel("a.csv", csv(&tread)).unwrap())[0].clone();
    assert_eq!(curves(&file)[0].points(), curve.points());
    // An outline with few points beside the head: a hole where the order is right is none of these.
    let corners = [[8.0, -50.0], [8.0, -140.0], [75.0, -160.0], [75.0, -172.0]];
    let mirrored = corners.iter().rev().map(|[y, z]| [-y, *z]);
    let section: Points = head.iter().copied().chain(corners).chain(mirrored).collect();
    let file = rail("a.csv", csv(&section)).unwrap();
    assert_eq!(codes(&file), Vec::<&str>::new());
    assert_eq!(curves(&file)[1].points().len(), section.len());
    let hole = [&tread[..300], &tread[340..]].concat();
    assert_eq!(codes(&wheel("a.csv", csv(&hole)).unwrap()), Vec::<&str>::new());
}

/// Of two passes over the same part the first one counts, wherever the second one lies: twice from
/// the same side and turned by 5 mrad, forth and back 0.1 mm apart, and an overlap of 40 points
/// 0.05 mm and 0.2 mm higher.
#[test]
fn second_passes_are_left_out() {
    let (head, curve, pressure) = expected();
    let moved = |points: &[[f64; 2]], turn: f64, up: f64| -> Points {
        points.iter().map(|[y, z]| [y - turn * z, z + turn * y + up]).collect()
    };
    for (name, later) in [
        ("twice", moved(&head, 0.0, 0.1)),
        ("turned", moved(&head, 5e-3, 0.0)),
        ("forth and back", reversed(&moved(&head, 0.0, 0.1))),
        ("back over a part", reversed(&moved(&head[120..400], 0.0, 0.1))),
    ] {
        let points = [head.clone(), later].concat();
        let file = rail("a.csv", csv(&points)).unwrap_or_else(|error| panic!("{name}: {error}"));
        notice(&file, "profile-overlap");
        let found = peak_pressure(&file);
        assert!((found / pressure - 1.0).abs() < 2e-3, "{name}: {found}");
        assert_eq!(curves(&file)[1].points().len(), curve.points().len(), "{name}");
    }
    for up in [0.05, 0.2] {
        let points = [head[..300].to_vec(), moved(&head[260..], 0.0, up)].concat();
        let file = rail("a.csv", csv(&points)).unwrap();
        assert_eq!(codes(&file), ["profile-overlap"], "{up}");
        let text = notice(&file, "profile-overlap");
        // 40 points, and the first one beyond.
        assert!(text.contains("the 41 points of the later one"), "{up}: {text}");
        let [y, z] = file.wheel().unwrap().pair().rail_origin();
        let first: Points =
            head[20..298].iter().map(|p| [p[0] + 1e3 * y, p[1] + 1e3 * z]).collect();
        // The rail's top is that of its highest point.
        assert!(off(&curves(&file)[1], &first) < 5e-3 + up, "{up}");
        assert_eq!(curves(&file)[1].points().len(), curve.points().len() - 1, "{up}");
    }
}

/// Noise on points in order, of which y grows throughout, is no lost order.
#[test]
fn noise_is_no_lost_order() {
    let mut state = 12_345_u64;
    let mut uniform = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state >> 33) as f64 / f64::from(1_u32 << 31) - 0.5
    };
    for deviation in [0.02, 0.05] {
        let points: Points = (-600..=600)
            .map(|k| 0.05 * f64::from(k))
            .map(|y| {
                // Nearly normal, with this standard deviation.
                let noise = deviation * (0..12).map(|_| uniform()).sum::<f64>();
                [y, -y * y / 600.0 + noise]
            })
            .collect();
        let file = rail("a.csv", csv(&points)).unwrap();
        // The top alone does not reach the gauge depth.
        assert_eq!(codes(&file), ["gauge-depth-not-reached"], "{deviation}");
        assert_eq!(file.profiles()[1].points, [1201, 1201], "{deviation}");
    }
}

/// A coordinate that no profile has is refused with its line and sign, whatever its size; where all
/// are too large, other units are named.
#[test]
fn coordinates_beyond_a_metre_are_refused_in_their_line() {
    let [tread, _] = built_in();
    for (value, shown) in [(1e6, "1e6 mm"), (-1e12, "-1e12 mm"), (1e300, "1e300 mm")] {
        for axis in [0, 1] {
            let mut points = tread.clone();
            points[100][axis] = value;
            let text = bare(&points, |[y, z]| format!("{y:e} {z:e}"));
            let error = wheel("a.txt", text).map(|_| ()).unwrap_err();
            let expected = format!("must be at most ±1 m, but is {shown} in line 101 of the file");
            assert!(error.contains(&expected), "{error}");
        }
    }
    for (unit, over) in [("um", 1e-3), ("cm", 10.0)] {
        let text = bare(&tread, |[y, z]| format!("{} {}", y / over, z / over));
        let told = match wheel("a.txt", text) {
            Ok(file) => notice(&file, "profile-units"),
            Err(error) => error,
        };
        let expected = format!("were its numbers {unit} in place of mm, it would be 129.5 mm wide");
        assert!(told.contains(&expected), "{told}");
    }
}
