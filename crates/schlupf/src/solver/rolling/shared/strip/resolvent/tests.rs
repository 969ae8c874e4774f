use approx::assert_relative_eq;

use super::*;

const H: f64 = 1e-6;

/// Changes of trial traction, bound, c and ln k_c.
type Changes = ([f64; 2], f64, [f64; 2], f64);

/// Derivatives against central differences.
fn assert_derivatives(resolvent: &Resolvent, at: impl Fn(Changes) -> Resolvent) {
    let difference = |plus: Changes, minus: Changes| {
        let [plus, minus] = [plus, minus].map(|change| at(change).traction);
        [0, 1].map(|c| (plus[c] - minus[c]) / (2.0 * H))
    };
    let along = |c: usize, h: f64| [0, 1].map(|k| if k == c { h } else { 0.0 });
    let none = [0.0; 2];
    for c in 0..2 {
        let tried = |h: f64| (along(c, h), 0.0, none, 0.0);
        let upstream = |h: f64| (none, 0.0, along(c, h), 0.0);
        let [by_trial, by_upstream] =
            [difference(tried(H), tried(-H)), difference(upstream(H), upstream(-H))];
        for r in 0..2 {
            assert_relative_eq!(resolvent.by_trial[r][c], by_trial[r], epsilon = 1e-6);
            assert_relative_eq!(resolvent.by_upstream[r][c], by_upstream[r], epsilon = 1e-6);
        }
    }
    let by_bound = difference((none, H, none, 0.0), (none, -H, none, 0.0));
    let by_stiffness = difference((none, 0.0, none, H), (none, 0.0, none, -H));
    for r in 0..2 {
        assert_relative_eq!(resolvent.by_bound[r], by_bound[r], epsilon = 1e-6);
        assert_relative_eq!(resolvent.by_stiffness[r], by_stiffness[r], epsilon = 1e-6);
    }
}

/// The law holds for the sliding that is found, from soft bristles to none.
#[test]
fn the_law_holds_in_a_cell() {
    let bound = 0.5;
    for (order, own, c) in
        [(1, 1.0, [0.3, -0.4]), (2, 1.5, [-0.9, 0.2]), (3, 1.8, [1.5, -1.6]), (3, 1.8, [0.0; 2])]
    {
        for compliance in [3.0, 0.1, 1e-3, 0.0] {
            for trial in [[0.3, -0.2], [0.3, -0.8], [-2.0, 1.0], [1e-3, 0.0]] {
                let at = |(tried, raised, changed, stiffened): Changes| {
                    let compliance = compliance * f64::exp(-stiffened);
                    let upstream = [0, 1].map(|k| c[k] + changed[k]);
                    let made = BristleState {
                        compliance,
                        own,
                        upstream,
                        order,
                        is_exact: true,
                        ..BristleState::default()
                    };
                    Resolvent::at([0, 1].map(|k| trial[k] + tried[k]), bound + raised, &made)
                };
                let resolvent = at(([0.0; 2], 0.0, [0.0; 2], 0.0));
                assert_derivatives(&resolvent, at);
                let p = resolvent.traction;
                assert!(length(p) <= bound * (1.0 + 1e-12));
                let slid = [0, 1].map(|k| trial[k] - p[k]);
                assert_relative_eq!(length(slid), resolvent.sliding, epsilon = 1e-12);
                let reduced = (own / length(c)).min(1.0);
                let relaxed = resolvent.sliding / compliance;
                let terms = [relaxed, relaxed.powi(2) / 2.0, relaxed.powi(3) / 6.0];
                let left = terms[..order].iter().sum::<f64>() / relaxed.exp_m1();
                let left = if relaxed < 100.0 { compliance * left } else { 0.0 };
                for k in 0..2 {
                    let kept = left * (own * p[k] / bound + reduced * c[k]);
                    let stretched = slid[k] - resolvent.sliding * p[k] / bound;
                    assert_relative_eq!(kept, stretched, epsilon = 1e-10);
                }
            }
        }
    }
}

/// A state of which Newton's method alone goes to and fro for ever between 1.1·10⁻⁵ and
/// 8.4·10⁻⁴, and many others: the law holds in all.
#[test]
fn the_sliding_is_found_from_anywhere() {
    let bound = 1.0;
    let check = |trial: [f64; 2], bristles: BristleState| {
        let resolvent = Resolvent::at(trial, bound, &bristles);
        let BristleState { compliance, own, upstream, .. } = bristles;
        let [left, _] = bristles.memory(resolvent.sliding);
        for k in 0..2 {
            let q = resolvent.traction[k] / bound;
            let kept = compliance * left * (own * q + upstream[k]);
            let stretched = trial[k] - resolvent.traction[k] - resolvent.sliding * q;
            assert_relative_eq!(kept, stretched, epsilon = 1e-11);
        }
    };
    let own = 11.0 / 6.0;
    let of = |compliance, upstream| BristleState {
        guess: 0.0,
        compliance,
        own,
        upstream,
        order: 3,
        is_exact: true,
    };
    check([0.785_664, -0.281_233], of(6.130_85e-5, [1.216_533, 0.205_007]));
    let mut seed = 1_u64;
    let mut random = || {
        seed = seed * 48_271 % 2_147_483_647;
        seed as f64 / 2_147_483_647.0
    };
    for _ in 0..20_000 {
        let (angle, turn) = (6.3 * random(), 6.3 * random());
        let (size, share) = (2.0 * random(), own * random());
        let upstream = [share * turn.cos(), share * turn.sin()];
        check([size * angle.cos(), size * angle.sin()], of(10_f64.powf(-7.0 * random()), upstream));
    }
}

/// From one node on a straight path p/(μ pₙ) relaxes to its direction exactly.
#[test]
fn straight_paths_are_exact() {
    let (bound, along, sliding) = (0.5, [0.6, -0.8], 0.7);
    for relaxed in [1e-4, 0.3, 1.0, 3.0, 30.0] {
        let at = |slid: f64| along.map(|n| -(-slid).exp_m1() * n);
        let before = at(2.0 * relaxed);
        let exact = at(3.0 * relaxed).map(|q| bound * q);
        let trial = [0, 1].map(|c| exact[c] + sliding * along[c]);
        let (compliance, upstream) = (sliding / relaxed, before.map(|q| -q));
        let bristles = BristleState {
            compliance,
            own: 1.0,
            upstream,
            order: 1,
            is_exact: true,
            ..BristleState::default()
        };
        let resolvent = Resolvent::at(trial, bound, &bristles);
        assert_relative_eq!(resolvent.sliding, sliding, max_relative = 1e-10);
        for (found, exact) in resolvent.traction.into_iter().zip(exact) {
            assert_relative_eq!(found, exact, max_relative = 1e-9);
        }
    }
}
